"""Refusal of recordings that would spoil a fit: implausible ones, and joints that do not follow their commands."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.identification.dataset import Recorded
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.trajectory.plausibility import Finding, findings

_MAX_DELAY: Final = 0.25
"""Longest time by which a servo follows its command, s."""
_SEARCH: Final = 1.0
"""Offset between two clocks that is looked for, s."""
_MIN_RANGE: Final = 0.05
"""Range of a command from which on its joint is checked, rad."""
_MIN_SHARE: Final = 0.02
"""Share of the commanded range below which a joint did not move."""
_MAX_OFFSET: Final = 0.5
"""Mean distance of a working servo from its command, which none exceeds, rad."""
_MIN_GAIN: Final = 0.5
_MAX_GAIN: Final = 3.0
"""Motion over commanded motion: below the one a servo may hang far from its command, and none reaches the other."""


def check(recorded: Recorded, measured: JointTrajectory, commands: JointTrajectory, without: Sequence[str]) -> None:
    """Raise a QuadrupedError if the recordings would spoil a fit; the message says why and what repairs it.

    Args:
        recorded: both, aligned.
        measured: measured joint states, in the order of the robot's joints.
        commands: joint targets, in the same order.
        without: joints that are left out.
    """
    problems = [
        *_implausible(measured, commands, without, commands_too=False),
        *_implausible(commands, measured, without, commands_too=True),
        *_inconsistent(recorded, without),
    ]
    if problems:
        more = f" (and {len(problems) - 1} more such problems)" if len(problems) > 1 else ""
        raise QuadrupedError(f"{measured.source.name}: would spoil the fit{more}: {problems[0]}")


def _implausible(one: JointTrajectory, other: JointTrajectory, without: Sequence[str], commands_too: bool) -> list[str]:
    """Findings in the time that a recording has in common with another."""
    inside = np.flatnonzero((one.stamps >= other.stamps[0]) & (one.stamps <= other.stamps[-1]))
    source = one.source
    numbers = np.arange(len(one)) + source.first_row if source.rows is None else source.rows
    rows = replace(one.to_rows(), numbers=numbers).take(inside)
    found = findings(rows, source.row_name)

    def counts(finding: Finding) -> bool:
        left = set(finding.joints) - set(without)
        return finding.spoils and bool(left) and (not commands_too or finding.kind in {"timestamps", "wrap"})

    place = f"commands {source.name}: " if commands_too else ""
    return [place + finding.text for finding in found if counts(finding)]


def _inconsistent(recorded: Recorded, without: Sequence[str]) -> list[str]:
    """Contradictions between measurements and commands, in sentences."""
    names, step = recorded.robot.joint_names, recorded.timestep
    times = np.arange(len(recorded.control)) * step
    inside = times <= recorded.times[-1]
    command = recorded.control[inside]
    part = recorded.measured[:, recorded.columns("position")]
    position = np.stack([np.interp(times[inside], recorded.times, column) for column in part.T], axis=1)
    kept = [i for i, name in enumerate(names) if name not in without and np.ptp(command[:, i]) > _MIN_RANGE]
    if not kept:
        return []
    problems = []
    moved = [i for i in kept if np.ptp(position[:, i]) > _MIN_SHARE * np.ptp(command[:, i])]
    for i in (i for i in kept if i not in moved):
        problems.append(
            f"{names[i]} does not move (by {np.ptp(position[:, i]):.3g} rad where {np.ptp(command[:, i]):.3g} rad are "
            f"commanded); leave it out (--without {names[i]})"
        )
    if not moved:
        return problems
    shift, best, usual = _clock_offset(command[:, moved], position[:, moved], step)
    if best > 0.8 and usual < 0.7 * best:
        when = "after" if shift > 0.0 else "before"
        return [
            *problems,
            f"the measurements come {abs(shift):.2g} s {when} the commands, so the two have different clocks; record "
            f"both on one, or shift the timestamps of one",
        ]
    delays = range(0, max(round(_MAX_DELAY / step), 1), max(round(0.005 / step), 1))
    early = [delay for delay in delays if delay * step <= 0.1]
    own = np.array([_correlations(command, position, delay, names) for delay in delays])
    for i in moved:
        best_own, worst = own[:, i, i].max(), own[: len(early), i, i].min()
        others = own[: len(early), i].max(axis=0)
        others[[j for j in range(len(names)) if j == i or j not in kept]] = -1.0
        follows = int(others.argmax())
        contradictions = []
        if best_own < 0.5 and worst < -0.7:
            contradictions.append(
                f"moves against its command (correlation {worst:.2f}): its sign is wrong (sign = -1 in a map)"
            )
        if best_own < 0.5 and others[follows] > 0.9:
            contradictions.append(
                f"follows the command of {names[follows]} (correlation {others[follows]:.2f}): joints are swapped "
                f"(source or columns in a map)"
            )
        if contradictions:
            problems.append(f"{names[i]} {', or it '.join(contradictions)}")
        if best_own < 0.8:
            continue
        delay = list(delays)[int(own[:, i, i].argmax())]
        target, reached = command[: len(command) - delay, i], position[delay:, i]
        gain = float(np.std(reached) / np.std(target))
        offset = float(np.mean(reached) - np.mean(target))
        if gain > _MAX_GAIN:
            problems.append(
                f"{names[i]} moves {gain:.3g} times as far as it is commanded: the two have different units or scales "
                f"(--degrees, or unit and scale in a map)"
            )
        elif gain > _MIN_GAIN and abs(offset) > _MAX_OFFSET:
            problems.append(
                f"{names[i]} is {offset:+.3g} rad from its command on average: the two have different zeros or signs "
                f"(offset and sign in a map)"
            )
    return problems + _effort_sign(recorded, command, position, moved)


def _effort_sign(
    recorded: Recorded, command: NDArray[np.float64], position: NDArray[np.float64], joints: list[int]
) -> list[str]:
    """The sign of the efforts: a servo pulls towards its command."""
    effort = recorded.measured[:, recorded.columns("effort")]
    rows = np.minimum(np.rint(recorded.times / recorded.timestep).astype(np.int64), len(command) - 1)
    error = (command - position)[rows]
    problems = []
    for i in joints:
        known = np.isfinite(effort[:, i])
        if known.sum() < 20 or not np.ptp(effort[known, i]):
            continue
        correlation = np.corrcoef(error[known, i], effort[known, i])[0, 1]
        if correlation < -0.4:
            problems.append(
                f"the effort of {recorded.robot.joint_names[i]} pulls away from its command (correlation "
                f"{correlation:.2f}): its sign is wrong (effort_scale = -1 in a map), or leave the efforts out "
                f"(--ignore effort)"
            )
    return problems


def _correlations(
    command: NDArray[np.float64], position: NDArray[np.float64], delay: int, names: Sequence[str]
) -> NDArray[np.float64]:
    """Correlation of each joint's position with each joint's command some steps earlier (J, J)."""
    target, reached = command[: len(command) - delay], position[delay:]
    with np.errstate(all="ignore"):
        return np.nan_to_num(np.corrcoef(reached.T, target.T)[: len(names), len(names) :], nan=0.0)


def _clock_offset(
    command: NDArray[np.float64], position: NDArray[np.float64], step: float
) -> tuple[float, float, float]:
    """Time in s by which all positions together follow their commands best, its correlation, and that of servos."""
    target, reached = command - command.mean(axis=0), position - position.mean(axis=0)
    target, reached = target / target.std(axis=0), reached / reached.std(axis=0)
    count = len(target)
    most = min(round(_SEARCH / step), count // 3)
    shifts = np.arange(-most, most + 1, max(round(0.01 / step), 1))
    found = np.empty(len(shifts))
    for i, k in enumerate(shifts.tolist()):
        early, late = max(-k, 0), max(k, 0)
        found[i] = np.mean(target[early : count - late] * reached[late : count - early])
    servo = (shifts * step >= -0.01) & (shifts * step <= _MAX_DELAY)
    best = int(found.argmax())
    return float(shifts[best] * step), float(found[best]), float(found[servo].max())
