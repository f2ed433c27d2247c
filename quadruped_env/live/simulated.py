"""The simulated robot with what surrounds it on a real one: motors that obey commands, and a watchdog."""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.live.terrain import Terrain
from quadruped_env.robot import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, STANCE_HEIGHT
from quadruped_env.rotations import from_yaw
from quadruped_env.simulation import SingleSimulation

TIMESTEP: Final = 0.005
"""s of a physics step"""
WATCHDOG: Final = 1.0
"""s without a command after which motors that were commanded go limp"""
_ROW: Final = np.zeros(1, dtype=np.intp)


class SimulatedRobot:
    """One robot on its ground, standing at first.

    Args:
        seed: of where it faces, and of the ground.
        terrain: one of `TERRAINS`.

    Raises:
        QuadrupedError: if there is no such terrain.
    """

    def __init__(self, seed: int = 0, terrain: str = "flat") -> None:
        self._terrain = Terrain.make(terrain, seed)
        self._simulation = SingleSimulation(self._terrain.model(TIMESTEP))
        self.state = self._simulation.readings
        self._generator = np.random.default_rng(seed)
        self._target = STANCE.copy()
        self.limp = False
        """Whether the motors pull no more: like motors whose windings are shorted, they only brake"""
        self._commanded_for: float | None = None
        """s since the last command; None before the first"""
        self.reset()

    def reset(self) -> None:
        """Put the robot on its feet, at the origin."""
        heading = from_yaw(self._generator.uniform(-math.pi, math.pi))
        self.put(np.concatenate([[0.0, 0.0, STANCE_HEIGHT], heading, STANCE]))

    def put(self, qpos: NDArray[np.float64]) -> None:
        """Put the robot somewhere, still, its motors on as if it had just begun.

        Args:
            qpos: position in m and quaternion wxyz of the base, and joint positions in rad, (15,).
        """
        self._simulation.reset(_ROW, qpos[None], np.zeros((1, 14)))
        self._target = qpos[7:].copy()
        self._commanded_for = None
        self.limp = False

    def command(self, target: Target) -> None:
        """Obey a command from the next physics step on; targets beyond the joints' range are brought into it."""
        self._commanded_for = 0.0
        if target is LIMP:
            self.limp = True
            return
        self._target = np.clip(target, JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
        self.limp = False

    def pick_up(self) -> None:
        """Put the robot on its feet where it is, motors on, as a person would."""
        place = self.state.base_position[0, :2]
        height = STANCE_HEIGHT + self._terrain.under(place)
        self.put(np.concatenate([place, [height], self._facing(), STANCE]))

    def _facing(self) -> NDArray[np.float64]:
        """Quaternion wxyz (4,) of the base's yaw alone."""
        w, x, y, z = self.state.orientation[0]
        yaw = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
        return np.array([math.cos(0.5 * yaw), 0.0, 0.0, math.sin(0.5 * yaw)])

    def push(self, velocity: NDArray[np.float64]) -> None:
        """Add a velocity (3,) in m/s to the base's, in the world's axes."""
        self._simulation.push(_ROW, velocity[None])

    def step(self) -> bool:
        """Advance by one physics step; whether the watchdog let the robot go limp in it."""
        watchdog_tripped = False
        if self._commanded_for is not None:
            self._commanded_for += TIMESTEP
            watchdog_tripped = not self.limp and self._commanded_for > WATCHDOG
            if watchdog_tripped:
                self.limp = True
        # A servo whose target is where it is has nothing to pull at, and what is left of it is its brake.
        target = self.state.joint_position if self.limp else self._target[None]
        self._simulation.step(target, 1)
        return watchdog_tripped

    @property
    def diverged(self) -> bool:
        """Whether MuJoCo gave up."""
        return bool(self._simulation.diverged()[0])

    @property
    def fallen(self) -> bool:
        """Whether the robot leans further than it could recover from."""
        return bool(self.state.up_b[0, 2] < np.cos(1.0))
