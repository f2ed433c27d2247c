"""Joint targets and measurements of a robot, aligned on one clock."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import Robot
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.interpreter import program_command

SIGNALS: Final = ("position", "velocity", "effort")
UNITS: Final = {"position": "rad", "velocity": "rad/s", "effort": "N m"}
MIN_SECONDS: Final = 2.0
MAX_SECONDS: Final = 300.0
"""Maximum duration of a recording, s. A fit takes about 1 minute per 10 s, and gains little beyond 60 s."""
_MIN_COMMAND_RANGE: Final = 0.05
"""Minimum range of a joint's target for which its motion is checked, rad."""
_MIN_MOTION_SHARE: Final = 0.4
"""Minimum fraction of the commanded range that a working joint moves through."""


@dataclass(frozen=True)
class Recorded:
    """Joint targets and measurements of a robot, prepared for the simulator.

    Signals are arrays (T, S) with one column per joint for each of `SIGNALS`, S = 3 J.
    """

    robot: Robot
    control: Floats
    """Joint targets, one per physics step: the mean of the last command over the step, rad (K, J)"""
    times: Floats
    """Times of the measurements from the first physics step, s (T,)"""
    measured: Floats
    """Positions, velocities and efforts (T, S); NaN where not recorded or excluded"""
    start: tuple[Floats, Floats]
    """Initial joint positions in rad and velocities in rad/s, each (J,)"""
    timestep: float
    """Physics time step, s"""
    train: Bools
    """True for measurements used in the fit, False for held-out ones (T,)"""

    @property
    def signals(self) -> tuple[str, ...]:
        """Measured signals, a subset of `SIGNALS`."""
        return tuple(name for name in SIGNALS if np.isfinite(self.measured[:, self.columns(name)]).any())

    def columns(self, signal: str) -> slice:
        """Return columns of a signal in an array (T, S)."""
        return columns(signal, self.robot.num_joints)


def whole(trajectory: JointTrajectory, robot: Robot, without: Sequence[str], rest: Floats) -> JointTrajectory:
    """Return a trajectory in the order of a robot's joints; those that are left out may be missing, and are at rest.

    Args:
        trajectory: measurements or joint targets.
        robot: robot that was recorded.
        without: joints that are left out.
        rest: position of each joint of the robot where it is missing, rad (J,).

    Raises:
        QuadrupedError: if another joint is missing.
    """
    try:
        trajectory.select([name for name in robot.joint_names if name not in without] or trajectory.names)
    except QuadrupedError as error:
        raise QuadrupedError(f"{error}; joints that were not recorded can be left out (--without)") from error
    missing = [i for i, name in enumerate(robot.joint_names) if name not in trajectory.names]
    shape = len(trajectory), len(missing)
    filled = {
        "positions": rest[missing],
        "velocities": np.zeros(len(missing)),
        "efforts": np.full(len(missing), np.nan),
    }
    arrays = {
        name: np.concatenate([array, np.broadcast_to(filled[name], shape)], axis=1)
        for name in filled
        if (array := getattr(trajectory, name)) is not None
    }
    names = (*trajectory.names, *(robot.joint_names[i] for i in missing))
    return JointTrajectory(trajectory.stamps, names, **arrays, source=trajectory.source).in_joint_order(robot)


def columns(signal: str, num_joints: int) -> slice:
    """Return columns of a signal in an array (T, 3 J) of all signals of J joints."""
    start = SIGNALS.index(signal) * num_joints
    return slice(start, start + num_joints)


def align(
    robot: Robot,
    measured: JointTrajectory,
    commands: JointTrajectory,
    train_share: float,
    timestep: float,
    without: Sequence[str] = (),
) -> Recorded:
    """Align joint targets and measurements, both in the order of a robot's joints, on the clock of the physics.

    Args:
        robot: robot that was recorded.
        measured: measured joint states.
        commands: joint targets.
        train_share: fraction of the time used for the fit.
        timestep: physics time step, s.
        without: joints whose measurements are excluded.

    Raises:
        QuadrupedError: if they overlap for less than `MIN_SECONDS` or more than `MAX_SECONDS`, the commands are
            constant, or all joints are excluded.
    """
    first = max(int(measured.stamps[0]), int(commands.stamps[0]))
    last = min(int(measured.stamps[-1]), int(commands.stamps[-1]))
    rows = (measured.stamps >= first) & (measured.stamps <= last)
    if last - first < MIN_SECONDS * NS_PER_SECOND or np.count_nonzero(rows) < 10 * MIN_SECONDS:
        raise QuadrupedError(
            f"{measured.source.name} and {commands.source.name}: {np.count_nonzero(rows)} measurements over "
            f"{max(last - first, 0) / NS_PER_SECOND:g} s in common (measured {_span(measured)}, commands "
            f"{_span(commands)}); at least {MIN_SECONDS:g} s and {10 * MIN_SECONDS:g} measurements are needed, on one "
            f"clock"
        )
    if last - first > MAX_SECONDS * NS_PER_SECOND:
        raise QuadrupedError(
            f"{measured.source.name}: {(last - first) / 1e9:g} s in common with its commands, over {MAX_SECONDS:g} s; "
            f"cut out a minute in which the joints move ({program_command('convert')} ... --start S --stop S)"
        )
    if not np.ptp(commands.positions, axis=0).any():
        raise QuadrupedError(f"{commands.source.name}: no command changes; record the robot while it moves")
    stamps = measured.stamps[rows]
    times = (stamps - stamps[0]) / NS_PER_SECOND
    steps = int(np.ceil(times[-1] / timestep - 1e-6)) + 1
    joints = robot.num_joints
    values = np.full((len(times), len(SIGNALS) * joints), np.nan)
    for name, array in zip(SIGNALS, (measured.positions, measured.velocities, measured.efforts), strict=True):
        if array is not None:
            values[:, columns(name, joints)] = array[rows]
    edges = np.arange(steps + 1, dtype=np.float64) * timestep
    start = values[0, columns("position", joints)].copy(), np.nan_to_num(values[0, columns("velocity", joints)])
    for name in without:
        if name not in robot.joint_names:
            raise QuadrupedError(
                f"identify: no joint {name!r} to leave out; valid names are {', '.join(robot.joint_names)}"
            )
        values[:, robot.joint_names.index(name) :: joints] = np.nan
    if not np.isfinite(values).any():
        raise QuadrupedError("identify: no joint is left; leave out fewer")
    control = held((commands.stamps - stamps[0]) / NS_PER_SECOND, commands.positions, edges)
    return Recorded(robot, control, times, values, start, timestep, times <= train_share * times[-1])


def remarks(recorded: Recorded, measured: JointTrajectory, commands: JointTrajectory) -> tuple[str, ...]:
    """Return remarks on the quality of a recording, in sentences."""
    found = [*measured.source.notes, *(note for note in commands.source.notes if note not in measured.source.notes)]
    gaps = (measured.gaps_in_words("the measurements"), commands.gaps_in_words("the commands"))
    found += [f"{one}." for one in gaps if one]
    commanded = np.ptp(recorded.control, axis=0)
    moved = np.ptp(recorded.measured[:, recorded.columns("position")], axis=0)
    for name, target, motion in zip(recorded.robot.joint_names, commanded, moved, strict=True):
        if target > _MIN_COMMAND_RANGE and motion < _MIN_MOTION_SHARE * target:
            found.append(
                f"{name} moved {motion:.3f} rad where {target:.3f} rad were commanded: if its motor is broken or "
                f"blocked, leave it out (--without {name})."
            )
    return tuple(found)


def held(times: Floats, values: Floats, edges: NDArray[Any]) -> Floats:
    """Return the means (K, J) between edges (K + 1,) of values (T, J) with zero-order hold at times (T,)."""
    # The integral of a piecewise constant function is piecewise linear.
    corners = np.concatenate([[min(times[0], edges[0]) - 1.0], times, [max(times[-1], edges[-1]) + 1.0]])
    heights = np.concatenate([values[:1], values])
    integral = np.concatenate([np.zeros((1, values.shape[1])), np.cumsum(np.diff(corners)[:, None] * heights, axis=0)])
    at_edges = np.stack([np.interp(edges, corners, column) for column in integral.T], axis=1)
    return np.diff(at_edges, axis=0) / np.diff(edges)[:, None]


def _span(trajectory: JointTrajectory) -> str:
    return f"{trajectory.stamps[0] / NS_PER_SECOND:.3f} to {trajectory.stamps[-1] / NS_PER_SECOND:.3f} s"
