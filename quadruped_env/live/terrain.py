"""Uneven terrain for the simulated robot."""

from dataclasses import dataclass
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation.model import scene

TERRAINS: Final = ("flat", "rough", "hills")

SIZE: Final = 40.0
"""Side length of the terrain around the start, m; the ground is flat beyond it."""
CELL: Final = 0.05
"""Grid spacing of the height field, m."""
_SHAPES: Final = {"rough": (0.01, 0.2), "hills": (0.08, 2.5)}
"""Terrain -> maximum height and distance of its random points, m. Policies trained on flat ground can walk on them."""
_START: Final = (0.4, 1.2)
"""Distances from the start up to which the ground is flat, and from which it has full height, m."""
_EDGE: Final = 1.0
"""Width of the transition to the flat ground around the terrain, m."""
_STANDING: Final = 0.25
"""Maximum horizontal distance from a robot's centre to the ground under its feet, m."""


@dataclass(frozen=True)
class Terrain:
    """A height field."""

    name: str
    heights: NDArray[np.float64]
    """Heights above the flat ground (P, P), rows along y and columns along x, m; empty if flat."""

    @classmethod
    def make(cls, name: str, seed: int) -> "Terrain":
        """Create a terrain of `TERRAINS`; the same seed gives the same heights.

        Raises:
            QuadrupedError: if there is no such terrain.
        """
        if name not in TERRAINS:
            raise QuadrupedError(f"--terrain: {name!r} is unknown; there are {', '.join(TERRAINS)}")
        if name == "flat":
            return cls(name, np.empty((0, 0)))
        height, distance = _SHAPES[name]
        points = round(SIZE / CELL) + 1
        x = np.linspace(-SIZE / 2, SIZE / 2, points)
        knots = np.random.default_rng(seed).random((round(SIZE / distance) + 2,) * 2)
        heights = height * _smooth(knots, (x + SIZE / 2) / distance)
        from_start = np.hypot(x[:, None], x[None, :])
        to_edge = SIZE / 2 - np.maximum(abs(x[:, None]), abs(x[None, :]))
        near, full = _START
        heights *= _step((from_start - near) / (full - near)) * _step(to_edge / _EDGE)
        return cls(name, heights)

    def model(self, robot: Robot, timestep: float) -> mujoco.MjModel:
        """Compile a model of a robot on this terrain.

        Args:
            robot: the robot.
            timestep: physics timestep, s.
        """
        spec = scene(robot)
        spec.option.timestep = timestep
        top = self.heights.max(initial=0.0)
        if top > 0.0:
            rows, columns = self.heights.shape
            spec.add_hfield(
                name="terrain",
                nrow=rows,
                ncol=columns,
                size=[SIZE / 2, SIZE / 2, top, 0.1],
                userdata=(self.heights / top).ravel().tolist(),
            )
            ground = spec.geom("ground")
            spec.worldbody.add_geom(
                name="terrain",
                type=mujoco.mjtGeom.mjGEOM_HFIELD,
                hfieldname="terrain",
                material=ground.material,
                contype=ground.contype,
                conaffinity=ground.conaffinity,
                condim=ground.condim,
                friction=ground.friction,
            )
        return spec.compile()

    def under(self, place: NDArray[np.float64], radius: float = _STANDING) -> float:
        """Maximum ground height within `radius` of a position (2,), m; by default under a robot there."""
        if not self.heights.size:
            return 0.0
        low, high = (
            np.clip(np.round((place + side + SIZE / 2) / CELL).astype(int), 0, len(self.heights) - 1)
            for side in (-radius, radius)
        )
        return float(self.heights[low[1] : high[1] + 1, low[0] : high[0] + 1].max())


def _step(x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Smoothstep function: from 0 to 1 while x goes from 0 to 1."""
    x = np.clip(x, 0.0, 1.0)
    return x * x * (3.0 - 2.0 * x)


def _smooth(knots: NDArray[np.float64], at: NDArray[np.float64]) -> NDArray[np.float64]:
    """Knots (K, K) interpolated smoothly on the grid of coordinates `at` (P,), in units of the knot spacing: (P, P)."""
    index = np.minimum(at.astype(int), len(knots) - 2)
    share = _step(at - index)
    along = knots[index] * (1.0 - share[:, None]) + knots[index + 1] * share[:, None]
    return along[:, index] * (1.0 - share) + along[:, index + 1] * share
