"""The verdict on a policy: thresholds, one headline, and the worst episodes."""

import math
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.evaluation.comparison import Comparison, error_of, rank
from quadruped_env.evaluation.conditions import MOTIONS, Command, words
from quadruped_env.evaluation.learning_gain import WALKING_FALL_RATE, LearningGain
from quadruped_env.evaluation.measures import METRICS, ROUGH, errors_of
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of

STABLE_FALL_RATE: Final = 0.05
"""Maximum fraction of falls of a robot that walks reliably."""
WALKING_SHARE: Final = 0.5
"""Minimum fraction of the commanded velocity at which the robot walks."""
CREEPING_SHARE: Final = 0.2
"""Minimum fraction of the commanded forward velocity at which the robot moves forward at all."""
_STILL: Final = 0.03
"""Maximum error of a robot that stands still, for the built-in robot, m/s or rad/s."""

WORST_SHOWN: Final = 3
"""Number of worst episodes."""


def tolerance(metric: str, robot: Robot) -> float:
    """Return the maximum error of a policy that follows its commands."""
    unit = METRICS[metric].unit
    return scale_of(unit, robot) * ROUGH[unit]


@dataclass(frozen=True)
class Verdict:
    """Verdict on the policy of a comparison."""

    level: str
    """`good`, `fair` or `poor`"""
    headline: str

    def text(self) -> str:
        """Return the headline in lines of plain text."""
        return textwrap.fill(self.headline, 100)


def verdict(comparison: Comparison, gain: LearningGain | None = None) -> Verdict:
    """Judge the policy of a comparison; motions without a command are left out.

    Args:
        comparison: the policy and the scripted controllers.
        gain: the policy against the zero action, if that was measured. Without a significant gain it is not `good`.
    """
    if math.isnan(comparison.estimate("policy", "forward_velocity_error").mean):
        return Verdict("poor", "No: it always falls before its velocity can be measured.")
    fall_rate = comparison.estimate("policy", "fall_rate").mean
    falls = f"falls in {_percent(fall_rate)} of the episodes"
    unstable = fall_rate > STABLE_FALL_RATE
    if not comparison.conditions("forwards"):
        untested = "No command walks forwards, so walking was not tested"
        return Verdict("poor", f"{untested}; it {falls}.") if unstable else Verdict("fair", f"{untested}.")
    if fall_rate > WALKING_FALL_RATE:
        return Verdict("poor", f"No: it {falls}.")
    share = reached_share(comparison, "policy", "forwards")
    if not share >= CREEPING_SHARE:
        return Verdict("poor", f"No: it {falls}, and does not walk." if unstable else "No, it does not walk.")
    if share < WALKING_SHARE:
        reached = f"reaches {_percent(share)} of the commanded forward velocity"
        return Verdict("poor", f"Hardly: it {falls}, and {reached}." if unstable else f"Hardly: it {reached}.")
    ranks = {motion: _rank(comparison, "tuned", motion) for motion in comparison.motions}
    flaws = [falls] if unstable else []
    flaws += [] if gain is None or gain.is_better else [gain.lack]
    flaws += _flaws(comparison)
    behind = [motion for motion, found in ranks.items() if found == "less accurate"]
    if behind:
        flaws.append(f"is less accurate than the scripted gait {listed(behind)}")
    if flaws:
        walks = "Not reliably: it walks" if unstable else "Yes, it walks"
        return Verdict("fair", f"{walks}, but it {listed(flaws)}.")
    standing = f"it {falls}" if fall_rate else "it does not fall"
    against = "" if "not comparable" in ranks.values() else " at least as well as the scripted gait"
    return Verdict("good", f"Yes, it walks: {standing}, and follows its commands{against}.")


def _rank(comparison: Comparison, other: str, motion: str) -> str:
    """Return whether the policy follows a motion's commands more or less accurately than another controller."""
    return rank(comparison, error_of(motion), "policy", other, motion)


def _flaws(comparison: Comparison) -> list[str]:
    """Return predicates about the commands that the policy does not follow, motion by motion."""
    robot, metrics, flaws = comparison.robot, errors_of(comparison.robot), []
    unknown: list[str] = []
    missed: list[str] = []
    for motion in comparison.motions:
        if any(math.isnan(comparison.estimate("policy", metric, motion).mean) for metric in metrics):
            unknown.append(motion)
            continue
        walks = motion in ("forwards", "standing", "turning")
        if not walks:
            walks = reached_share(comparison, "policy", motion) >= WALKING_SHARE
            flaws += [] if walks else [f"does not walk {motion}"]
        if not walks or motion == "backwards":
            continue
        for row in comparison.conditions(motion):
            errors = {metric: comparison.estimate("policy", metric, [row]).mean for metric in metrics}
            if motion == "standing":
                still = all(error < _STILL * scale_of(METRICS[m].unit, robot) for m, error in errors.items())
                flaws += [] if still else ["does not stand still"]
            elif any(error > tolerance(metric, robot) for metric, error in errors.items()):
                missed.append(words(comparison.commands[row]))
    if unknown:
        flaws.append(f"falls too early to be measured {listed(unknown)}")
    if missed:
        flaws.append(f"does not follow {listed(missed)}")
    return flaws


def reached_share(comparison: Comparison, controller: str, motion: str) -> float:
    """Divide the mean achieved by the mean commanded velocity, the one in `MOTIONS`; NaN if the commands are 0."""
    rows, metric = comparison.conditions(motion), MOTIONS[motion]
    column = [entry.name for entry in velocity_commands(comparison.robot)].index(metric)
    command = np.array(comparison.commands)[rows, column]
    achieved = comparison.values[controller][metric][rows] * np.sign(command)[:, None]
    finite = np.isfinite(achieved)
    wanted = float((np.abs(command)[:, None] * finite).sum())
    return float(np.where(finite, achieved, 0.0).sum()) / wanted if wanted else math.nan


def _percent(share: float) -> str:
    return f"{100.0 * share:.0f} %"


def listed(items: Sequence[str]) -> str:
    """Join items with commas and "and"."""
    return items[0] if len(items) == 1 else f"{', '.join(items[:-1])} and {items[-1]}"


@dataclass(frozen=True)
class Failure:
    """A bad episode."""

    row: int
    """Index of the episode in the comparison's rollouts"""
    command: Command
    seed: int
    fell_at: float | None
    """Time of the fall, s; None without a fall"""
    badness: float
    """Largest of the velocity errors, relative to its tolerance; infinite for a fall"""
    story: str
    """Time of the fall, or velocity errors, in words"""


def worst_episodes(comparison: Comparison) -> list[Failure]:
    """Return the worst episodes of the policy: falls first, the earliest first, then the largest velocity errors.

    One per command, because episodes of one command mostly fail in the same way.
    """
    rollout = comparison.rollouts["policy"]
    alive = rollout.valid.sum(axis=0)
    worst = []
    for i, command in enumerate(comparison.commands):
        rows = comparison.rows(i)
        errors = {metric: comparison.values["policy"][metric][i] for metric in errors_of(comparison.robot)}
        relative = [error / tolerance(metric, comparison.robot) for metric, error in errors.items()]
        badness = np.where(rollout.fallen[rows], np.inf, np.nan_to_num(np.max(relative, axis=0)))
        j = int(np.lexsort((alive[rows], -badness))[0])
        row, fell_at, story = int(rows[j]), None, "It did not fall. Errors: "
        if rollout.fallen[row]:
            fell_at = float(alive[row] + 1) * rollout.timestep
            story = f"It fell at {fell_at:.1f} s. Errors before: "
        story += listed([f"{METRICS[m].show(error[j])} {METRICS[m].unit}" for m, error in errors.items()]) + "."
        worst.append(Failure(row, command, comparison.seeds[j], fell_at, float(badness[j]), story))
    return sorted(worst, key=lambda failure: (-failure.badness, alive[failure.row]))[:WORST_SHOWN]
