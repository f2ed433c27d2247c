"""Commands and measurements of a robot, on one clock."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env._python import program_command
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import JOINT_NAMES
from quadruped_env.timestamps import NS_PER_SECOND
from quadruped_env.trajectory import JointTrajectory

SIGNALS: Final = ("position", "velocity", "effort")
UNITS: Final = {"position": "rad", "velocity": "rad/s", "effort": "N m"}
MIN_SECONDS: Final = 2.0
MAX_SECONDS: Final = 300.0
"""A fit takes about as many minutes as a recording has tens of seconds, and gains little from more than one minute."""
_MOVES: Final = 0.05
"""rad; a command that changes by less says nothing about a joint"""
_FOLLOWS: Final = 0.4
"""Share of the commanded range that a joint in order moves through"""


@dataclass(frozen=True)
class Recorded:
    """Commands and measurements, ready for the simulator."""

    control: NDArray[np.float64]
    """Joint targets (K, 8) in rad, one a physics step: the mean over the step of what was last commanded"""
    times: NDArray[np.float64]
    """s from the first physics step, of the measurements (T,)"""
    measured: NDArray[np.float64]
    """Positions, velocities and efforts (T, 24), NaN where there is none or where it does not count"""
    start: tuple[NDArray[np.float64], NDArray[np.float64]]
    """Positions in rad and velocities in rad/s that the joints (8,) start with"""
    timestep: float
    """s, of the physics"""
    train: NDArray[np.bool_]
    """Which measurements are for the fit (T,); the others are held out"""

    @property
    def signals(self) -> tuple[str, ...]:
        """Which of `SIGNALS` were measured."""
        return tuple(name for name in SIGNALS if np.isfinite(self.measured[:, columns(name)]).any())


def find_commands(measured: Path) -> Path:
    """The file of joint targets next to the measurements, under the name that `mini-quadruped baseline` gives it.

    Raises:
        QuadrupedError: if there is none.
    """
    path = measured.with_name(f"{measured.stem}-commands.csv")
    if not path.is_file():
        raise QuadrupedError(
            f"{measured}: no joint targets: there is no {path.name} next to it; name the file (--commands), or the "
            f"topic in the bag (--commands-topic)"
        )
    return path


def columns(signal: str) -> slice:
    """The columns of a signal in an array (T, 24)."""
    start = SIGNALS.index(signal) * len(JOINT_NAMES)
    return slice(start, start + len(JOINT_NAMES))


def align(
    measured: JointTrajectory,
    commands: JointTrajectory,
    train_share: float,
    timestep: float,
    without: Sequence[str] = (),
) -> Recorded:
    """Bring commands and measurements, both in the order of `JOINT_NAMES`, onto the clock of the physics.

    Args:
        measured: what the joints did.
        commands: what they were told.
        train_share: share of the time that is for the fit.
        timestep: s, of the physics.
        without: joints whose measurements do not count.

    Raises:
        QuadrupedError: if they do not overlap for `MIN_SECONDS`, or for more than `MAX_SECONDS`, the commands stand
            still, or no joint counts.
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
    values = np.full((len(times), len(SIGNALS) * len(JOINT_NAMES)), np.nan)
    for name, array in zip(SIGNALS, (measured.positions, measured.velocities, measured.efforts), strict=True):
        if array is not None:
            values[:, columns(name)] = array[rows]
    edges = np.arange(steps + 1, dtype=np.float64) * timestep
    start = values[0, columns("position")].copy(), np.nan_to_num(values[0, columns("velocity")])
    for name in without:
        if name not in JOINT_NAMES:
            raise QuadrupedError(f"identify: no joint {name!r} to leave out; valid names are {', '.join(JOINT_NAMES)}")
        values[:, JOINT_NAMES.index(name) :: len(JOINT_NAMES)] = np.nan
    if not np.isfinite(values).any():
        raise QuadrupedError("identify: no joint is left; leave out fewer")
    control = held((commands.stamps - stamps[0]) / NS_PER_SECOND, commands.positions, edges)
    return Recorded(control, times, values, start, timestep, times <= train_share * times[-1])


def remarks(recorded: Recorded, measured: JointTrajectory, commands: JointTrajectory) -> tuple[str, ...]:
    """What the reader should know about a recording, in sentences."""
    found = [*measured.source.notes, *(note for note in commands.source.notes if note not in measured.source.notes)]
    for part, what in ((measured, "measurements"), (commands, "commands")):
        gaps = part.gaps()
        if gaps:
            longest = max(gaps, key=lambda gap: gap.seconds)
            found.append(
                f"{len(gaps)} gaps in the {what}, the longest of {longest.seconds:.3g} s at {longest.start:.2f} s."
            )
    asked = np.ptp(recorded.control, axis=0)
    moved = np.ptp(recorded.measured[:, columns("position")], axis=0)
    for name, want, did in zip(JOINT_NAMES, asked, moved, strict=True):
        if want > _MOVES and did < _FOLLOWS * want:
            found.append(
                f"{name} moved {did:.3f} rad where {want:.3f} rad were commanded: if its motor is broken or blocked, "
                f"leave it out (--without {name})."
            )
    return tuple(found)


def held(times: NDArray[np.float64], values: NDArray[np.float64], edges: NDArray[Any]) -> NDArray[np.float64]:
    """Means (K, J) between edges (K + 1,) of values (T, J) that hold from their time (T,) to the next."""
    # The integral of a staircase is linear between its corners.
    corners = np.concatenate([[min(times[0], edges[0]) - 1.0], times, [max(times[-1], edges[-1]) + 1.0]])
    heights = np.concatenate([values[:1], values])
    integral = np.concatenate([np.zeros((1, values.shape[1])), np.cumsum(np.diff(corners)[:, None] * heights, axis=0)])
    at_edges = np.stack([np.interp(edges, corners, column) for column in integral.T], axis=1)
    return np.diff(at_edges, axis=0) / np.diff(edges)[:, None]


def _span(trajectory: JointTrajectory) -> str:
    return f"{trajectory.stamps[0] / NS_PER_SECOND:.3f} to {trajectory.stamps[-1] / NS_PER_SECOND:.3f} s"
