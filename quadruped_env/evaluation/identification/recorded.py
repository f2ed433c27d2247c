"""Commands and measurements of a robot, on one clock."""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import JOINT_NAMES
from quadruped_env.trajectory import JointTrajectory

SIGNALS: Final = ("position", "velocity", "effort")
UNITS: Final = {"position": "rad", "velocity": "rad/s", "effort": "N m"}
MIN_SECONDS: Final = 2.0


@dataclass(frozen=True)
class Recorded:
    """Commands and measurements, ready for the simulator."""

    control: NDArray[np.float64]
    """Joint targets (K, 8) in rad, one a physics step: the mean over the step of what was last commanded"""
    times: NDArray[np.float64]
    """s from the first physics step, of the measurements (T,)"""
    measured: NDArray[np.float64]
    """Positions, velocities and efforts (T, 24), NaN where there is none"""
    timestep: float
    """s, of the physics"""
    train: NDArray[np.bool_]
    """Which measurements are for the fit (T,); the others are held out"""

    @property
    def signals(self) -> tuple[str, ...]:
        """Which of `SIGNALS` were measured."""
        return tuple(name for name in SIGNALS if np.isfinite(self.measured[:, columns(name)]).any())


def columns(signal: str) -> slice:
    """The columns of a signal in an array (T, 24)."""
    start = SIGNALS.index(signal) * len(JOINT_NAMES)
    return slice(start, start + len(JOINT_NAMES))


def align(measured: JointTrajectory, commands: JointTrajectory, train_share: float, timestep: float) -> Recorded:
    """Bring commands and measurements, both in the order of `JOINT_NAMES`, onto the clock of the physics.

    Raises:
        QuadrupedError: if they do not overlap for `MIN_SECONDS`, or the commands stand still.
    """
    first = max(int(measured.stamps[0]), int(commands.stamps[0]))
    last = min(int(measured.stamps[-1]), int(commands.stamps[-1]))
    rows = (measured.stamps >= first) & (measured.stamps <= last)
    if last - first < MIN_SECONDS * 1e9 or np.count_nonzero(rows) < 10 * MIN_SECONDS:
        raise QuadrupedError(
            f"{measured.source.name} and {commands.source.name}: {np.count_nonzero(rows)} measurements over "
            f"{max(last - first, 0) / 1e9:g} s in common (measured {_span(measured)}, commands {_span(commands)}); "
            f"at least {MIN_SECONDS:g} s and {10 * MIN_SECONDS:g} measurements are needed, on one clock"
        )
    if not np.ptp(commands.positions, axis=0).any():
        raise QuadrupedError(f"{commands.source.name}: no command changes; record the robot while it moves")
    stamps = measured.stamps[rows]
    times = (stamps - stamps[0]) / 1e9
    steps = int(np.ceil(times[-1] / timestep - 1e-6)) + 1
    values = np.full((len(times), len(SIGNALS) * len(JOINT_NAMES)), np.nan)
    for name, array in zip(SIGNALS, (measured.positions, measured.velocities, measured.efforts), strict=True):
        if array is not None:
            values[:, columns(name)] = array[rows]
    edges = np.arange(steps + 1, dtype=np.float64) * timestep
    control = held((commands.stamps - stamps[0]) / 1e9, commands.positions, edges)
    return Recorded(control, times, values, timestep, times <= train_share * times[-1])


def held(times: NDArray[np.float64], values: NDArray[np.float64], edges: NDArray[Any]) -> NDArray[np.float64]:
    """Means (K, J) between edges (K + 1,) of values (T, J) that hold from their time (T,) to the next."""
    # The integral of a staircase is linear between its corners.
    corners = np.concatenate([[min(times[0], edges[0]) - 1.0], times, [max(times[-1], edges[-1]) + 1.0]])
    heights = np.concatenate([values[:1], values])
    integral = np.concatenate([np.zeros((1, values.shape[1])), np.cumsum(np.diff(corners)[:, None] * heights, axis=0)])
    at_edges = np.stack([np.interp(edges, corners, column) for column in integral.T], axis=1)
    return np.diff(at_edges, axis=0) / np.diff(edges)[:, None]


def _span(trajectory: JointTrajectory) -> str:
    return f"{trajectory.stamps[0] / 1e9:.3f} to {trajectory.stamps[-1] / 1e9:.3f} s"
