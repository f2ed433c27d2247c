"""The verdict: a comparison summarized in words."""

import math
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from quadruped_env.evaluation.comparison import ERRORS, MOTIONS, Command, Comparison, error_of, rank, words
from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.learning_gain import WALKING_FALL_RATE, LearningGain
from quadruped_env.evaluation.metrics import METRICS
from quadruped_env.evaluation.suite.findings import suite_findings
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of

STABLE_FALL_RATE: Final = 0.05
"""Maximum fraction of falls of a robot that walks reliably."""
WALKING_SHARE: Final = 0.5
"""Minimum fraction of the commanded forward velocity for which the verdict says that the robot walks."""
CREEPING_SHARE: Final = 0.2
"""Minimum fraction of the commanded forward velocity for which the robot moves forward at all."""
_TOLERANCES: Final = {"forward_velocity_error": (0.05, 0.1), "yaw_rate_error": (0.1, 0.2)}
"""Maximum errors of a policy that follows its commands closely, and roughly, for the built-in robot, m/s and rad/s."""
_STILL: Final = 0.03
"""Maximum error of a robot that stands still, for the built-in robot, m/s or rad/s."""


def tolerances(metric: str, robot: Robot) -> tuple[float, float]:
    """Maximum errors of a policy of a robot that follows its commands closely, and roughly."""
    size = scale_of(METRICS[metric].unit, robot)
    close, rough = (size * value for value in _TOLERANCES[metric])
    return close, rough


@dataclass(frozen=True)
class Verdict:
    """Verdict on the policy of a comparison."""

    level: str
    """`good`, `fair` or `poor`"""
    headline: str
    findings: tuple[tuple[str, str], ...]
    """Pairs of topic and sentence"""

    def text(self) -> str:
        """The verdict as plain text."""
        findings = (
            textwrap.fill(f"{topic}: {words}", 100, initial_indent="  ", subsequent_indent="    ")
            for topic, words in self.findings
        )
        return "\n".join([textwrap.fill(self.headline, 100), *findings])


def verdict(
    comparison: Comparison, suite: Mapping[str, Any] | None = None, gain: LearningGain | None = None
) -> Verdict:
    """Judge the policy of a comparison; motions without a command are left out.

    Args:
        comparison: the policy and the scripted controllers.
        suite: results of the policy in the suite, if it was run.
        gain: the policy against the zero action, if that was measured. Without a significant gain it is not `good`.
    """
    findings = [("Falls", _falls(comparison))]
    if gain is not None:
        findings.append(("Learning", f"in its own task, it {gain.verdict()}."))
    for topic, sentence in (
        ("Forwards", _forwards),
        ("Standing", _standing),
        ("Backwards", _backwards),
        ("Turning", _turning),
    ):
        if comparison.conditions(topic.lower()):
            findings.append((topic, sentence(comparison)))
    findings.append(("Effort", _effort(comparison)))
    findings += [
        (topic, _against(comparison, other))
        for other, topic in (("tuned", "Searched gait"), ("article", "Article's gait"))
    ]
    findings += () if suite is None else suite_findings(suite)
    level, headline = _headline(comparison, gain)
    return Verdict(level, headline, tuple(findings))


def reached_share(comparison: Comparison, controller: str, motion: str) -> float:
    """Mean achieved over mean commanded velocity (the yaw rate for turning); NaN if the commands are 0."""
    rows = comparison.conditions(motion)
    column, metric = (1, "yaw_rate") if motion == "turning" else (0, "forward_velocity")
    command = np.array(comparison.commands)[rows, column]
    achieved = comparison.values[controller][metric][rows] * np.sign(command)[:, None]
    finite = np.isfinite(achieved)
    wanted = float((np.abs(command)[:, None] * finite).sum())
    return float(np.where(finite, achieved, 0.0).sum()) / wanted if wanted else math.nan


def _headline(comparison: Comparison, gain: LearningGain | None) -> tuple[str, str]:
    has = comparison.conditions
    if math.isnan(comparison.estimate("policy", "forward_velocity_error").mean):
        return "poor", "No: it always falls before its velocity can be measured."
    fall_rate = comparison.estimate("policy", "fall_rate").mean
    falls = f"falls in {_percent(fall_rate)} of the episodes"
    unstable = fall_rate > STABLE_FALL_RATE
    if not has("forwards"):
        untested = "No command walks forwards, so walking was not tested"
        return ("poor", f"{untested}; it {falls}.") if unstable else ("fair", f"{untested}.")
    if fall_rate > WALKING_FALL_RATE:
        return "poor", f"No: it {falls}."
    share = reached_share(comparison, "policy", "forwards")
    if not share >= CREEPING_SHARE:
        return "poor", f"No: it {falls}, and does not walk." if unstable else "No, it does not walk."
    if share < WALKING_SHARE:
        reached = f"reaches {_percent(share)} of the commanded forward velocity"
        return "poor", f"Hardly: it {falls}, and {reached}." if unstable else f"Hardly: it {reached}."
    ranks = {motion: _rank(comparison, "tuned", motion) for motion in MOTIONS if has(motion)}
    lack = [] if gain is None or gain.is_better else [gain.lack]
    flaws = [*([falls] if unstable else []), *lack, *_flaws(comparison, ranks)]
    if flaws:
        walks = "Not reliably: it walks" if unstable else "Yes, it walks"
        return "fair", f"{walks}, but it {listed(flaws)}."
    standing = f"it {falls}" if fall_rate else "it does not fall"
    against = "" if "not comparable" in ranks.values() else " at least as well as the searched gait"
    return "good", f"Yes, it walks: {standing}, and follows its commands{against}."


def _flaws(comparison: Comparison, ranks: Mapping[str, str]) -> list[str]:
    """Flaws of a policy that walks, apart from its falls; `ranks` are those against the searched gait, by motion."""
    has = comparison.conditions
    flaws = []
    if math.isnan(comparison.estimate("policy", "forward_velocity_error", "forwards").mean):
        flaws.append("falls too early to measure its forward velocity error")
    missed = {motion: _by_closeness(comparison, motion).get(_NOT, []) for motion in ("forwards", "turning")}
    if any(missed.values()):
        flaws.append(f"does not follow {_in_words([*missed['forwards'], *missed['turning']])}")
    if has("standing") and not _stands(comparison):
        flaws.append("does not stand still")
    if has("backwards") and not reached_share(comparison, "policy", "backwards") >= WALKING_SHARE:
        flaws.append("does not walk backwards")
    if has("turning") and math.isnan(comparison.estimate("policy", "yaw_rate_error", "turning").mean):
        flaws.append("falls too early in turns to measure its yaw rate")
    elif missed["turning"]:
        flaws.append(f"turns at {_percent(reached_share(comparison, 'policy', 'turning'))} of the commanded rate")
    behind = [motion for motion, rank in ranks.items() if rank == "less accurate"]
    if behind:
        flaws.append(f"is less accurate than the searched gait {listed(behind)}")
    return flaws


def _falls(comparison: Comparison) -> str:
    estimate = comparison.estimate("policy", "fall_rate")
    episodes = f"{estimate.count} episodes of {comparison.seconds:g} s"
    fallen = comparison.values["policy"]["fall_rate"]
    if not fallen.any():
        return f"none in {episodes} (95 % confident: under {_percent(estimate.high, 1)})."
    counts = sorted(zip(fallen.sum(axis=1), comparison.commands, strict=True), key=lambda pair: -pair[0])
    where = listed(
        [f"{count:.0f} of {len(comparison.seeds)} at {words(command)}" for count, command in counts if count]
    )
    interval = f"{_percent(estimate.low, 1)} to {_percent(estimate.high, 1)}"
    return f"{int(fallen.sum())} in {episodes}, {_percent(estimate.mean, 1)} (95 % interval {interval}): {where}."


def _forwards(comparison: Comparison) -> str:
    rows, metric = comparison.conditions("forwards"), "forward_velocity_error"
    known = [i for i in rows if not math.isnan(comparison.estimate("policy", metric, [i]).mean)]
    if not known:
        return "it falls too early to tell."
    worst = max(known, key=lambda i: comparison.estimate("policy", metric, [i]).mean)
    error = _with_interval(comparison.estimate("policy", metric, [worst]), metric)
    distance, speed = (comparison.estimate("policy", name, [worst]).mean for name in ("distance", "forward_velocity"))
    return (
        f"{_follows(comparison, 'forwards')}. The largest error is {error}, at {words(comparison.commands[worst])}: it "
        f"reaches {speed:.2f} m/s and travels {distance:.1f} m in {comparison.seconds:g} s."
    )


def _standing(comparison: Comparison) -> str:
    forward = comparison.estimate("policy", "forward_velocity_error", "standing").mean
    turning = comparison.estimate("policy", "yaw_rate_error", "standing").mean
    if math.isnan(forward):
        return "it falls too early to tell."
    state = "it stands still" if _stands(comparison) else "it does not stand still"
    return f"{state}: it moves at {forward:.3f} m/s and turns at {turning:.3f} rad/s."


def _stands(comparison: Comparison) -> bool:
    limits = {metric: _STILL * scale_of(METRICS[metric].unit, comparison.robot) for metric in ERRORS}
    return all(comparison.estimate("policy", m, "standing").mean < limit for m, limit in limits.items())


def _backwards(comparison: Comparison) -> str:
    speeds = [comparison.commands[i][0] for i in comparison.conditions("backwards")]
    speed = comparison.estimate("policy", "forward_velocity", "backwards").mean
    if math.isnan(speed):
        return "it falls too early to tell."
    share = reached_share(comparison, "policy", "backwards")
    can = _follows(comparison, "backwards") if share >= WALKING_SHARE else "it does not walk backwards"
    return f"{can}: {speed:.2f} m/s of the commanded {sum(speeds) / len(speeds):.2f} m/s."


def _turning(comparison: Comparison) -> str:
    if math.isnan(comparison.estimate("policy", "yaw_rate_error", "turning").mean):
        return "it falls too early to tell."
    share = reached_share(comparison, "policy", "turning")
    tuned = reached_share(comparison, "tuned", "turning")
    against = "" if math.isnan(tuned) else f", the searched gait {_percent(tuned)}"
    return f"{_follows(comparison, 'turning')}; it reaches {_percent(share)} of the commanded yaw rate{against}."


_CLOSE, _ROUGH, _NOT, _UNKNOWN = "closely follows", "roughly follows", "does not follow", "falls too early to tell at"


def _by_closeness(comparison: Comparison, motion: str) -> dict[str, list[Command]]:
    """The commands of a motion by how closely the policy follows both of their velocities."""
    found: dict[str, list[Command]] = {word: [] for word in (_CLOSE, _ROUGH, _NOT, _UNKNOWN)}
    for row in comparison.conditions(motion):
        errors = [comparison.estimate("policy", metric, [row]).mean for metric in ERRORS]
        close, rough = zip(*(tolerances(metric, comparison.robot) for metric in ERRORS), strict=True)
        limits = ((_CLOSE, close), (_ROUGH, rough), (_NOT, (math.inf, math.inf)))
        word = next((word for word, limit in limits if np.less_equal(errors, limit).all()), _UNKNOWN)
        found[word].append(comparison.commands[row])
    return {word: commands for word, commands in found.items() if commands}


def _follows(comparison: Comparison, motion: str) -> str:
    """The commands of a motion that the policy follows closely, roughly or not at all."""
    found = _by_closeness(comparison, motion)
    return "it " + "; it ".join(f"{word} {_in_words(commands)}" for word, commands in found.items())


def _in_words(commands: Sequence[Command]) -> str:
    """Commands in words, left and right turns together."""
    mirrored: dict[Command, set[float]] = {}
    for forward, yaw_rate in commands:
        mirrored.setdefault((forward, abs(yaw_rate)), set()).add(yaw_rate)
    straight = [forward for forward, yaw_rate in mirrored if not yaw_rate]
    parts = [f"{listed([f'{forward:g}' for forward in straight])} m/s"] if straight else []
    for (forward, yaw_rate), signs in mirrored.items():
        if yaw_rate:
            sign = "\N{PLUS-MINUS SIGN}" if len(signs) == 2 else "-" if signs == {-yaw_rate} else ""
            parts.append(f"{f'{forward:g} m/s with ' * bool(forward)}{sign}{yaw_rate:g} rad/s")
    return listed(parts)


def _rank(comparison: Comparison, other: str, motion: str) -> str:
    return rank(comparison, error_of(motion), "policy", other, motion)


def _against(comparison: Comparison, other: str) -> str:
    motions: dict[str, list[str]] = {
        rank: [] for rank in ("more accurate", "equally accurate", "less accurate", "not comparable")
    }
    for motion in MOTIONS:
        if comparison.conditions(motion):
            metric = error_of(motion)
            show = METRICS[metric].show
            ours, theirs = (comparison.estimate(name, metric, motion).mean for name in ("policy", other))
            motions[_rank(comparison, other, motion)].append(
                f"{motion} ({show(ours)} against {show(theirs)} {METRICS[metric].unit})"
            )
    ranks = [f"{rank} {listed(where)}" for rank, where in motions.items() if where]
    if len(comparison.seeds) == 1:
        ranks = ["not ranked: a single start of each command gives no interval"]
    more = ""
    if comparison.falls_more("policy", other):
        own, others = (_percent(comparison.estimate(name, "fall_rate").mean) for name in ("policy", other))
        more = f"falls more often ({own} against {others}), and "
    return f"compared with it, the policy {more}is {'; '.join(ranks)}."


def _effort(comparison: Comparison) -> str:
    motion = "forwards" if comparison.conditions("forwards") else None
    peaks = []
    for name in ("peak_torque", "peak_joint_speed"):
        values = comparison.values["policy"][name]
        if np.isfinite(values).any():
            limit = METRICS[name].limit_of(comparison.robot)
            assert limit is not None
            highest, unit = round(float(np.nanmax(values)), 1), METRICS[name].unit
            where = "beyond" if highest > limit else "at" if highest == limit else "within"
            peaks.append(f"{highest:.1f} {unit} ({where} the limit of {limit:g} {unit})")
    if not peaks:
        return "it falls too early to tell."
    words = f"peaks of {listed(peaks)} in any joint"
    costs = []
    for kind in ("electrical", "mechanical"):
        name = f"{kind}_cost_of_transport"
        cost, tuned = (comparison.estimate(who, name, motion).mean for who in ("policy", "tuned"))
        against = "" if math.isnan(tuned) else f" (searched gait {tuned:.2f})"
        if not math.isnan(cost):
            costs.append(f"{kind} cost of transport {cost:.2f}{against}; ")
    return f"{''.join(costs)}{words}."


def _percent(share: float, digits: int = 0) -> str:
    return f"{100.0 * share:.{digits}f} %"


def listed(items: list[str]) -> str:
    """Items joined with commas and "and"."""
    return items[0] if len(items) == 1 else f"{', '.join(items[:-1])} and {items[-1]}"


def _with_interval(estimate: Estimate, metric: str) -> str:
    show = METRICS[metric].show
    interval = "" if math.isnan(estimate.low) else f" [{show(estimate.low)}, {show(estimate.high)}]"
    return f"{show(estimate.mean)} {METRICS[metric].unit}{interval}"
