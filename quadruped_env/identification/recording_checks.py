"""Refusal of recordings that would spoil a fit: implausible ones, and joints that contradict their commands."""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.identification.dataset import Recorded
from quadruped_env.identification.fit import MotorFit
from quadruped_env.identification.fitted_parameters import QUANTITIES
from quadruped_env.robot import MotorConfig
from quadruped_env.robot.motors import SERVO_ERRORS
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.trajectory.plausibility import findings
from quadruped_env.utils.arrays import Floats

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
_MOTOR_DELAY: Final = 0.05
"""Longest time by which a motor's torque follows its command, s: later, the command of a trot's next step is near."""
_ECHO_TOLERANCE: Final = 2e-4
"""Difference up to which a position is a target, rad: one may be rounded to four decimals, or to 0.01 degrees."""
_ECHO_SHARE: Final = 0.9
"""Share of a moving joint's positions that must be targets of one age: a message more or less late changes a few."""
_ECHO_ROWS: Final = (10, 2000)
"""Minimum and maximum number of changed positions of a joint that are looked at."""
_MAX_ECHO_AGE: Final = 0.5
"""Maximum age of a target that a driver repeats, s."""
_NO_FEEDBACK: Final = "docs/robots.md#servos-without-feedback"


def check(recorded: Recorded, measured: JointTrajectory, commands: JointTrajectory, without: Sequence[str]) -> None:
    """Raise a QuadrupedError if the recordings would spoil a fit; the message says why and what repairs it.

    Args:
        recorded: both, aligned.
        measured: measured joint states, in the order of the robot's joints.
        commands: joint targets, in the same order.
        without: joints that are left out.
    """
    problems = _read_twice(measured, commands) or [
        *_echoes(measured, commands, without),
        *_implausible(measured, commands, without, commands_too=False),
        *_implausible(commands, measured, without, commands_too=True),
        *_inconsistent(recorded, without),
    ]
    if problems:
        more = f" (and {len(problems) - 1} more such problems)" if len(problems) > 1 else ""
        raise QuadrupedError(f"{measured.source.name}: would spoil the fit{more}: {problems[0]}")


def check_stand(recorded: Recorded, start: MotorConfig) -> None:
    """Raise a QuadrupedError if the simulator explains a recording better with the robot on the ground than on a stand.

    Forces of the ground would be taken for friction, inertia and strength.
    """
    stand, ground = (MotorFit(recorded, start, (), on_ground=on_ground).mismatch() for on_ground in (False, True))
    if ground < stand:
        raise QuadrupedError(
            f"the robot seems to stand on the ground, whose forces would be taken for friction, inertia and strength: "
            f"before the fit, the simulator explains the motion better there (error {ground:.2f} of the motion) than "
            f"on a stand ({stand:.2f}); record it on a stand with its feet in the air, or if it was, start from the "
            f"motors' data sheet (--start)"
        )


def _read_twice(measured: JointTrajectory, commands: JointTrajectory) -> list[str]:
    """Return the problem with targets that are the measurements: the same columns of the same file, as a rule."""
    pairs = (measured.stamps, commands.stamps), (measured.positions, commands.positions)
    if not all(np.array_equal(*pair) for pair in pairs):
        return []
    return [
        f"all positions are the joint targets of {commands.source.name}, number for number at the same times: the same "
        f"columns were read twice; name the targets' columns (--commands-columns; in a bag, --commands-topic). If the "
        f"log itself holds both, it repeats its targets as positions ({_NO_FEEDBACK})"
    ]


def _echoes(measured: JointTrajectory, commands: JointTrajectory, without: Sequence[str]) -> list[str]:
    """Return the problem with servos without feedback, whose driver repeats the target as the position, maybe later."""
    ages = {}
    for name, positions, targets in zip(measured.names, measured.positions.T, commands.positions.T, strict=True):
        age = _age_of_echo(measured.stamps, positions, commands.stamps, targets)
        if age is not None and name not in without:
            ages[name] = age
    if not ages:
        return []
    late = " to ".join(dict.fromkeys(f"{end(ages.values()):.2g}" for end in (min, max)))
    return [
        f"the positions of {', '.join(ages)} are their targets, {late} s later: their servos report no position. "
        f"Nothing here shows how the motors move these joints, so {', '.join((*QUANTITIES, *SERVO_ERRORS))} cannot be "
        f"identified; measure the positions, leave the joints out (--without), or take their motors from a data sheet "
        f"({_NO_FEEDBACK})"
    ]


def _age_of_echo(
    stamps: NDArray[np.int64],
    positions: Floats,
    command_stamps: NDArray[np.int64],
    targets: Floats,
) -> float | None:
    """Return the age in s of the targets that a joint's positions (T,) repeat; None if they are no targets."""
    common = (stamps >= command_stamps[0]) & (stamps <= command_stamps[-1])
    rows = np.flatnonzero(common[1:] & (np.abs(np.diff(positions)) > _ECHO_TOLERANCE))[: _ECHO_ROWS[1]] + 1
    if len(rows) < _ECHO_ROWS[0]:
        return None
    step = max(int(np.median(np.diff(command_stamps))) // 4, NS_PER_SECOND // 1000)
    for age in range(0, int(_MAX_ECHO_AGE * NS_PER_SECOND) + 1, step):
        held = np.searchsorted(command_stamps, stamps[rows] - age, side="right") - 1
        if np.mean(np.abs(targets[held.clip(0)] - positions[rows]) <= _ECHO_TOLERANCE) >= _ECHO_SHARE:
            return age / NS_PER_SECOND
    return None


def _implausible(one: JointTrajectory, other: JointTrajectory, without: Sequence[str], commands_too: bool) -> list[str]:
    """Return findings in the time that a recording has in common with another."""
    source = one.source
    inside = np.flatnonzero((one.stamps >= other.stamps[0]) & (one.stamps <= other.stamps[-1]))
    place = f"commands {source.name}: " if commands_too else ""
    return [
        place + found.text
        for found in findings(one.to_rows().take(inside), source.row_name)
        if set(found.joints) - set(without)
        if not commands_too or found.kind in {"timestamps", "wrap"}
    ]


def _inconsistent(recorded: Recorded, without: Sequence[str]) -> list[str]:
    """Return contradictions between measurements and commands, in sentences."""
    names, step = recorded.robot.joint_names, recorded.timestep
    times = np.arange(len(recorded.control)) * step
    times = times[times <= recorded.times[-1]]
    command = recorded.control[: len(times)]
    position, effort = (
        np.stack([np.interp(times, recorded.times, column) for column in recorded.measured[:, columns].T], axis=1)
        for columns in (recorded.columns("position"), recorded.columns("effort"))
    )
    kept = [i for i, name in enumerate(names) if name not in without and np.ptp(command[:, i]) > _MIN_RANGE]
    moved = [i for i in kept if np.ptp(position[:, i]) > _MIN_SHARE * np.ptp(command[:, i])]
    problems = [
        f"{names[i]} does not move (by {np.ptp(position[:, i]):.3g} rad where {np.ptp(command[:, i]):.3g} rad are "
        f"commanded): it is blocked, or its servo reports no position ({_NO_FEEDBACK}); leave it out "
        f"(--without {names[i]})"
        for i in kept
        if i not in moved
    ]
    if not moved:
        return problems
    shift, best, usual = _clock_offset(command[:, moved], position[:, moved], step)
    if best > 0.8 and usual < 0.7 * best:
        problems.append(
            f"the measurements come {abs(shift):.2g} s {'after' if shift > 0.0 else 'before'} the commands, so the two "
            f"have different clocks; record both on one, or shift the timestamps of one"
        )
        return problems
    delays = list(range(0, max(round(_MAX_DELAY / step), 1), max(round(0.005 / step), 1)))
    early = sum(delay * step <= 0.1 for delay in delays)
    correlations = np.array([_correlations(command, position, delay) for delay in delays])
    for i in moved:
        own, others = correlations[:, i, i], correlations[:early, i].max(axis=0)
        others[[j for j in range(len(names)) if j == i or j not in kept]] = -1.0
        follows = int(others.argmax())
        delay = delays[int(own.argmax())]
        target, reached = command[: len(command) - delay, i], position[delay:, i]
        gain, offset = float(np.std(reached) / np.std(target)), float(np.mean(reached) - np.mean(target))
        reasons = []
        if own.max() < 0.5 and own[:early].min() < -0.7:
            reasons.append("moves against its command: its sign is wrong (sign = -1 in a map)")
        if own.max() < 0.5 and others[follows] > 0.9:
            reasons.append(f"follows the command of {names[follows]}: joints are swapped (source or columns in a map)")
        if reasons:
            problems.append(f"{names[i]} {', or it '.join(reasons)}")
        if own.max() >= 0.8 and gain > _MAX_GAIN:
            problems.append(
                f"{names[i]} moves {gain:.3g} times as far as it is commanded: the two have different units or scales "
                f"(--unit deg, or unit and scale in a map)"
            )
        elif own.max() >= 0.8 and gain > _MIN_GAIN and abs(offset) > _MAX_OFFSET:
            problems.append(
                f"{names[i]} is {offset:+.3g} rad from its command on average: the two have different zeros or signs "
                f"(offset and sign in a map)"
            )
        if _pulls_away(command[:, i], position[:, i], effort[:, i], step):
            problems.append(
                f"the effort of {names[i]} pulls away from its command: its sign is wrong (effort_scale = -1 in a "
                f"map), or leave the efforts out (--ignore effort)"
            )
    return problems


def _pulls_away(command: Floats, position: Floats, effort: Floats, step: float) -> bool:
    """Return True if a motor's torque pulls its joint away from its command, at time steps in s.

    The torque is kp times the distance from an earlier command, less kd times the velocity. On the ground, where the
    feet carry the joints along, it is often the damping that decides, so the distance has to tell the sign at the same
    velocity (partial correlation), too.
    """
    if _correlation(command - position, effort) > -0.4:
        return False
    velocity, found = np.gradient(position, step), []
    for delay in range(round(_MOTOR_DELAY / step) + 1):
        distance, torque, speed = command[: len(command) - delay] - position[delay:], effort[delay:], velocity[delay:]
        pairs = (distance, torque), (distance, speed), (torque, speed)
        direct, *by_speed = (_correlation(*pair) for pair in pairs)
        left = 1.0 - np.square(by_speed)
        found.append(float((direct - np.prod(by_speed)) / max(np.sqrt(left.prod()), 1e-6)))
    low, high = min(found), max(found)
    return low < -0.4 and low + high < -0.1


def _correlation(one: Floats, other: Floats) -> float:
    """Return the correlation where both are known; 0 if one does not change."""
    known = np.isfinite(one) & np.isfinite(other)
    if known.sum() < 20 or not np.ptp(one[known]) or not np.ptp(other[known]):
        return 0.0
    return float(np.corrcoef(one[known], other[known])[0, 1])


def _correlations(command: Floats, position: Floats, delay: int) -> Floats:
    """Return the correlation of each joint's position with each joint's command some steps earlier (J, J)."""
    target, reached = command[: len(command) - delay], position[delay:]
    with np.errstate(all="ignore"):
        return np.nan_to_num(np.corrcoef(reached.T, target.T)[: len(command.T), len(command.T) :], nan=0.0)


def _clock_offset(command: Floats, position: Floats, step: float) -> tuple[float, float, float]:
    """Return the delay, s, at which positions follow their commands best, its correlation, and a servo's best one."""
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
