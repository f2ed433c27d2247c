"""Gain of a policy over its zero action: in the policy's own task, and under the commands of an evaluation."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import NUM_SEEDS, Comparison, Motion, error_of, rank, run
from quadruped_env.evaluation.conditions import (
    MOTIONS,
    commands_for,
    evaluation_task,
    motion_of,
    without_curriculum,
    words,
)
from quadruped_env.evaluation.confidence import Estimate, bootstrap_mean, number, proportion
from quadruped_env.evaluation.measures import CLOSE, METRICS, START_UP, WINDOW, own_commands_met, tolerances
from quadruped_env.evaluation.rollout import DEFAULT_SECONDS, FIRST_SEED, Rollout, roll_out
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.steady import run_command_map
from quadruped_env.evaluation.suite.suite_definition import for_robot, full_suite, with_velocities
from quadruped_env.evaluation.term_gain import TERM_HEADER, TermGain, term_gains, term_rows
from quadruped_env.policies import Agent, Controller, Policy, PolicyController, ZeroController, as_policy
from quadruped_env.utils.progress import Progress, part_of
from quadruped_env.utils.text_table import text_table

EPISODES: Final = 128
MOTION_SEEDS: Final = 4
"""Episodes under each command of the table of motions."""
WALKING_FALL_RATE: Final = 0.5
"""Maximum share of falls of a robot that walks; beyond it no return makes a policy better that falls more often."""
NO_GAIN: Final = "no significant gain over the zero action"
GAIN_HEADER: Final = ("", "policy", "falls", "power", "zero action", "falls", "power", "policy")
"""Titles of the columns of `gain_rows`."""
_SHAPE: Final = ("base_height", "apex", "landing_speed")
"""Measures of how the robot walks forwards, below the rows of the motions."""


@dataclass(frozen=True)
class Performance:
    """Results of one controller in a task, with 95 % intervals."""

    return_per_second: Estimate
    """Reward per second"""
    own_commands_met: Estimate
    """Share of the task's own commands that were met; see `measures.own_commands_met`"""
    falls: Estimate
    """Share of the robots that fell within the time of one episode"""
    electrical_power: Estimate
    """Mechanical power and heat of the motors, W"""


@dataclass(frozen=True)
class LearningGain:
    """A policy and the zero action in the policy's own task, from the same starts."""

    episodes: int
    seconds: float
    """Length of an episode, s"""
    tolerance: tuple[float, ...]
    """Maximum errors under a command that is met, in the units of the policy's robot, m/s and rad/s (V,)"""
    policy: Performance
    zero: Performance
    difference: Estimate
    """Difference of the return per second, policy minus zero action, over pairs of episodes"""
    comparison: Comparison | None = None
    """The policy (`policy`) and the zero action (`zero`), undisturbed; None: not measured"""
    commands: Mapping[str, Mapping[str, Any]] | None = None
    """`policy` and `zero` under the suite's commands: shares that are `met`, and `falls`; None: not measured"""
    fastest: Comparison | None = None
    """The same under the largest commands of the policy's task: straight ahead, and turning in place"""
    terms: tuple[TermGain, ...] = ()
    """Reward terms that the user defined or changed"""

    @property
    def is_better(self) -> bool:
        """True if the policy's return is significantly higher: the whole interval of the difference is above 0.

        Not for a policy that falls more often than the zero action, and in over `WALKING_FALL_RATE` of its episodes.
        """
        return self.difference.low > 0.0 and not (self.falls_more and self.policy.falls.mean > WALKING_FALL_RATE)

    @property
    def falls_more(self) -> bool:
        """True if the policy falls more often: the intervals of the two shares do not overlap."""
        return self.policy.falls.low > self.zero.falls.high

    @property
    def lack(self) -> str:
        """Predicate of a policy that is not better, without numbers."""
        if self.falls_more:
            return "falls more often than the zero action"
        return "is worse than the zero action" if self.difference.high < 0.0 else f"has {NO_GAIN}"

    def verdict(self) -> str:
        """Return the result as a predicate of the policy, with the difference and its interval."""
        found, words = self.difference, self.lack
        if self.is_better:
            words = f"is better than the zero action{', but falls more often' if self.falls_more else ''}"
        return f"{words}: {found.mean:+z.2f} return/s (95 % interval {found.low:+z.2f} to {found.high:+z.2f})"

    def table(self) -> str:
        """Return the results of both as a plain-text table."""
        document = self.to_dict()
        condition = "" if self.comparison is None else f"motions: {self.comparison.condition}\n"
        terms = f"\n\n{text_table([TERM_HEADER, *term_rows(document)])}" if self.terms else ""
        return text_table([GAIN_HEADER, *gain_rows(document)]) + f"\n{condition}{reward_in_words(document)}{terms}"

    def to_dict(self) -> dict[str, Any]:
        """Return the result as JSON-serializable values; NaN becomes None."""
        return {
            "verdict": self.verdict(),
            "episodes": self.episodes,
            "seconds": self.seconds,
            "difference": self.difference.to_dict(),
            "policy": {name: value.to_dict() for name, value in vars(self.policy).items()},
            "zero": {name: value.to_dict() for name, value in vars(self.zero).items()},
            "condition": None if self.comparison is None else self.comparison.condition,
            "commands": self.commands,
            "motions": [] if self.comparison is None else _motions(self.comparison),
            "measures": [] if self.comparison is None else _measures(self.comparison, self.fastest),
            "terms": [term.to_dict() for term in self.terms],
        }


def _motions(comparison: Comparison) -> list[dict[str, Any]]:
    """Return the results of policy and zero action for each motion, metric -> mean, and their comparison."""
    found = []
    for motion in comparison.motions:
        metrics = error_of(motion), "fall_rate", "electrical_power"
        policy, zero = (
            {metric: number(comparison.estimate(name, metric, motion).mean) for metric in metrics}
            for name in ("policy", "zero")
        )
        result = rank(comparison, error_of(motion), "policy", "zero", motion)
        if comparison.falls_more("policy", "zero", motion):
            result = "falls more"
        elif comparison.falls_more("zero", "policy", motion):
            result = "falls less"
        found.append({"motion": motion, "result": result, "policy": policy, "zero": zero})
    return found


def _measures(comparison: Comparison, fastest: Comparison | None) -> list[dict[str, Any]]:
    """Return the measures `_SHAPE` of policy and zero action forwards, and the velocities that the fastest reach."""
    asked: list[tuple[Comparison, str, Motion, str]] = []
    asked += [(comparison, name, "forwards", METRICS[name].label.lower()) for name in _SHAPE]
    if fastest is not None:
        motions = [motion_of(command, fastest.robot) for command in fastest.commands]
        top = zip(motions, fastest.commands, strict=True)
        asked += [(fastest, MOTIONS[motion], [i], f"at {words(one)}") for i, (motion, one) in enumerate(top)]
    found = []
    for source, metric, motion, name in asked:
        if source.conditions(motion) and metric in source.values["policy"]:
            policy, zero = (number(source.estimate(one, metric, motion).mean) for one in ("policy", "zero"))
            difference = source.difference(metric, "policy", "zero", motion).to_dict()
            found.append({"name": name, "metric": metric, "policy": policy, "zero": zero, "difference": difference})
    return found


def _shown(value: float | None, metric: str, sign: str = "") -> str:
    """Return a value of a metric with its unit; a length in mm."""
    scale, unit, digits = (1e3, "mm", 0) if METRICS[metric].unit == "m" else (1.0, METRICS[metric].unit, 2)
    return "-" if value is None else f"{scale * value:{sign}z.{digits}f} {unit}"


def gain_rows(document: Mapping[str, Any]) -> list[tuple[str, ...]]:
    """Return the rows of `LearningGain.to_dict` below the header `GAIN_HEADER`: each motion, and the own task."""
    rows = [
        (gain["motion"], *_motion_cells(gain["policy"]), *_motion_cells(gain["zero"]), gain["result"])
        for gain in document.get("motions", ())
    ]
    for one in (one for one in document.get("measures", ()) if one["metric"] in METRICS):
        policy, zero = (_shown(one[name], one["metric"]) for name in ("policy", "zero"))
        gain, low, high = (one["difference"][part] for part in ("mean", "low", "high"))
        same = policy == zero or low is None or low <= 0.0 <= high
        rows.append((one["name"], policy, "", "", zero, "", "", "" if same else _shown(gain, one["metric"], "+")))
    if commands := document.get("commands"):
        both = (
            (
                f"{100.0 * commands[one]['met']['mean']:.0f} % met",
                f"{100.0 * commands[one]['falls']['mean']:.1f} %",
                "-",
            )
            for one in ("policy", "zero")
        )
        rows.append(("random commands", *next(both), *next(both), ""))
    own = [
        (
            f"{100.0 * met['mean']:.0f} % of own" if met["count"] else "-",
            f"{100.0 * one['falls']['mean']:.1f} %",
            f"{one['electrical_power']['mean']:.1f} W",
        )
        for one in (document["policy"], document["zero"])
        # Before there were the commands of the suite, it had their name.
        for met in [one.get("own_commands_met") or one["commands_met"]]
    ]
    return [*rows, ("own task", *own[0], *own[1], "")]


def table_note(document: Mapping[str, Any]) -> str:
    """Return what the rows of `gain_rows` show."""
    sideways = any(gain["motion"] == "sideways" for gain in document.get("motions", ()))
    errors = (
        ", on turns of the yaw rate, or sideways of the lateral velocity"
        if sideways
        else ", or on turns of the yaw rate"
    )
    shape = (
        "Height, rise and landing speed are those of walking forwards, and the rows below them the velocities that are "
        "reached under the largest commands of its task; their last column shows a change beyond chance. "
    )
    return (
        f"The rows of motions have the error of the forward velocity{errors}. "
        f"{shape if document.get('measures') else ''}Random commands are met as in the suite mq-eval: drawn evenly, "
        f"10 s each, undisturbed. The last row is in the policy's own task: the share of its own commands that are "
        f"met, with its randomization and terrain."
    )


def _motion_cells(values: Mapping[str, float | None]) -> tuple[str, str, str]:
    """Return the error, falls and power of one controller for one motion."""

    def cell(name: str) -> str:
        value, unit = values[name], METRICS[name].unit
        return "-" if value is None else f"{METRICS[name].show(value)} {unit}".rstrip()

    errors = ", ".join(cell(name) for name in values if name.endswith("error"))
    return errors, cell("fall_rate"), cell("electrical_power")


def reward_in_words(document: Mapping[str, Any]) -> str:
    """Return the rewards of `LearningGain.to_dict` in the policy's own task, with their 95 % intervals."""

    def shown(estimate: Mapping[str, Any], form: str = "{:z.2f}") -> str:
        mean, low, high = (form.format(estimate[part] or 0.0) for part in ("mean", "low", "high"))
        return mean if estimate["low"] is None else f"{mean} [{low}, {high}]"

    return (
        f"own task: reward per second {shown(document['policy']['return_per_second'])}, zero action "
        f"{shown(document['zero']['return_per_second'])}, difference {shown(document['difference'], '{:+z.2f}')}"
    )


def gain_beside(
    policy: Policy,
    num_seeds: int,
    seconds: float,
    progress: Progress | None = None,
    comparison: Comparison | None = None,
    progress_file: Path | None = None,
) -> LearningGain:
    """Return the gain in the policy's own task, with as many episodes as an evaluation of `num_seeds` per command has.

    Episodes are at most `DEFAULT_SECONDS` long. `comparison` is the evaluation; None: motions are left out.
    """
    episodes = max(2, min(EPISODES, EPISODES // NUM_SEEDS * num_seeds))
    return learning_gain(policy, episodes, min(DEFAULT_SECONDS, seconds), progress, 0, comparison, progress_file)


def learning_gain(
    policy: Policy | Agent,
    episodes: int = EPISODES,
    seconds: float = DEFAULT_SECONDS,
    progress: Progress | None = None,
    motion_seeds: int = MOTION_SEEDS,
    comparison: Comparison | None = None,
    progress_file: Path | None = None,
) -> LearningGain:
    """Run a policy and the zero action in the policy's own task: its commands, randomization and terrain.

    Both have the same seeds, which no training may use, so differences are paired. A robot that falls begins a new
    episode, as in training, so that the return counts the same time for each robot. On tiles there is no curriculum:
    a seed gives the tile.

    Args:
        policy: trained policy, or an object with the two methods of `Agent`.
        episodes: number of robots, which run at the same time.
        seconds: length of an episode, s.
        progress: called with the fraction done.
        motion_seeds: episodes under each command of `comparison.COMMANDS`, undisturbed; 0: none.
        comparison: results of the policy, as `policy`, and of its zero action, as `zero`; None: run them.
        progress_file: progress.csv of the training, which has the first values of the terms; None: not known.

    Raises:
        QuadrupedError: if there are fewer than two episodes, or they are too short for a command to be met.
    """
    if episodes < 2:
        raise QuadrupedError(f"episodes: expected 2 or more; found {episodes}")
    if not seconds >= START_UP + WINDOW:
        raise QuadrupedError(f"seconds: expected {START_UP + WINDOW:g} or more; found {seconds:g}")
    policy = as_policy(policy)
    config, seeds = without_curriculum(policy.config), range(FIRST_SEED, FIRST_SEED + episodes)
    controllers: dict[str, Controller] = {
        "policy": PolicyController(policy),
        "zero": ZeroController(policy.action_mode),
    }
    ours, zeros = (
        roll_out(controller, None, seeds, seconds, config, part_of(progress, 0.3 * i, 0.3 * (i + 1)), restart=True)
        for i, controller in enumerate(controllers.values())
    )
    if motion_seeds and comparison is None:
        commands = commands_for(config.robot)
        task = evaluation_task(policy.config, commands, "none")
        comparison = run(controllers, {}, task, commands, motion_seeds, seconds, part_of(progress, 0.6, 0.9))
    fastest = None
    if comparison is not None:
        forward, yaw_rate = (config.command[entry.name][1] for entry in velocity_commands(config.robot)[:2])
        top, count = ((forward, 0.0), (0.0, yaw_rate)), len(comparison.seeds)
        fastest = run(controllers, {}, comparison.config, top, count, seconds, part_of(progress, 0.9, 1.0))
    return LearningGain(
        episodes,
        seconds,
        tolerances(CLOSE, config.robot),
        _performance(ours),
        _performance(zeros),
        bootstrap_mean(_return_per_second(ours) - _return_per_second(zeros)),
        comparison,
        None if comparison is None else commands_met(policy, episodes // 2),
        fastest,
        term_gains(policy, ours, zeros, progress_file),
    )


def commands_met(policy: Policy, count: int) -> dict[str, dict[str, Any]] | None:
    """Return the shares of the first commands of the suite that a policy and its zero action meet, and their falls.

    One undisturbed episode per command, by the suite's law. None for a task that the suite cannot run.
    """
    part = for_robot(with_velocities(full_suite(), policy.config.robot), policy.config.robot).commands
    standing = max(1, count // 32)
    part = replace(part, num_seeds=1, points=max(1, count - standing), standing=standing, axes={})
    candidate = Candidate.of_policy(policy, "policy")
    try:
        found = [run_command_map(part, one) for one in (candidate, candidate.zero_action())]
    except QuadrupedError:
        return None
    return {
        name: {field: result[field] for field in ("met", "falls")}
        for name, result in zip(("policy", "zero"), found, strict=True)
    }


def _return_per_second(rollout: Rollout) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return the reward per second of each robot (N,)."""
    return np.asarray(rollout.reward_terms.sum(axis=(0, 2), dtype=np.float64) / rollout.seconds)


def _performance(rollout: Rollout) -> Performance:
    return Performance(
        return_per_second=bootstrap_mean(_return_per_second(rollout)),
        own_commands_met=proportion(own_commands_met(rollout, tolerances(CLOSE, rollout.robot))),
        falls=proportion(rollout.fallen),
        electrical_power=bootstrap_mean(rollout.electrical_power.mean(axis=0, dtype=np.float64)),
    )
