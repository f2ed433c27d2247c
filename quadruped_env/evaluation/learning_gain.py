"""Gain of a policy over doing nothing: both in the policy's own task, episode by episode."""

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import (
    ERRORS,
    NUM_SEEDS,
    Command,
    Comparison,
    commands_for,
    evaluation_task,
    motion_of,
    rank,
    run,
    words,
)
from quadruped_env.evaluation.confidence import Estimate, mean_interval, number, proportion, standard_error
from quadruped_env.evaluation.metrics import METRICS, START_UP, WINDOW
from quadruped_env.evaluation.rollout import DEFAULT_SECONDS, FIRST_SEED, in_mujoco
from quadruped_env.policies import Agent, Controller, Policy, PolicyController, ZeroController, as_policy
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.task import Task, TaskConfig
from quadruped_env.task.quantities import electrical_power, mean_over_steps
from quadruped_env.utils.progress import Progress, part_of
from quadruped_env.utils.text_table import text_table

EPISODES: Final = 128
TOLERANCE: Final = (0.05, 0.1)
"""Maximum errors of the mean velocities under a command that is met, for the built-in robot: forward velocity, m/s, and
yaw rate, rad/s."""
MOTION_SEEDS: Final = 4
"""Episodes under each command of the table of motions."""
WALKING_FALL_RATE: Final = 0.5
"""Maximum share of falls of a robot that walks; beyond it no return makes a policy better that falls more often."""
NO_GAIN: Final = "no significant gain over the zero action"
GAIN_HEADER: Final = ("", "policy: error", "falls", "power", "zero action: error", "falls", "power", "policy")
"""Titles of the columns of `gain_rows`."""
TABLE_NOTE: Final = (
    "Errors are in m/s forwards and backwards, in rad/s on turns, and both on curves and standing. Motions are "
    "undisturbed, on the task's ground."
)
_PARTS: Final = ("mean", "low", "high")

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Performance:
    """Results of one controller in a task. Intervals are of 95 %; those of means over robots are Student's t."""

    return_per_second: Estimate
    """Reward per second"""
    commands_met: Estimate
    """Share of the commands that were met, with Wilson's interval; see `commands_met`"""
    falls: Estimate
    """Share of the robots that fell within the time of one episode, with Wilson's interval"""
    electrical_power: Estimate
    """Mechanical power and heat of the motors, W"""
    own_action: float
    """Root mean square of the action over time, robots and joints, times the action's scale, rad"""


@dataclass(frozen=True)
class LearningGain:
    """A policy and the zero action in the policy's own task, from the same starts."""

    episodes: int
    seconds: float
    """Length of an episode, s"""
    tolerance: tuple[float, float]
    """`TOLERANCE` in the units of the policy's robot, m/s and rad/s"""
    policy: Performance
    zero: Performance
    difference: Estimate
    """Return per second of the policy minus that of the zero action; the interval is that of the paired t test"""
    standard_errors: float
    """Difference divided by its standard error; NaN if all pairs of episodes have the same difference"""
    motions: tuple["MotionGain", ...] = ()
    """Both under one command each, undisturbed"""

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
        """The result as a predicate of the policy; if it falls more often than the zero action, this comes first."""
        mean, low, high = self.difference.mean, self.difference.low, self.difference.high
        errors = f" ({abs(self.standard_errors):.1f} standard errors)" if math.isfinite(self.standard_errors) else ""
        falls = ""
        if self.falls_more:
            ours, zeros = (100.0 * one.falls.mean for one in (self.policy, self.zero))
            falls = f"falls in {ours:.0f} % of its episodes, the zero action in {zeros:.0f} %; it "
        if self.is_better:
            return f"{falls}is better than the zero action by {mean:.2f} return/s{errors}"
        if high < 0.0:
            return f"{falls}is worse than the zero action by {-mean:.2f} return/s{errors}"
        if low > 0.0:
            return f"{falls}collects {mean:.2f} return/s more{errors}, which does not make up for the falls"
        return f"{falls}has {NO_GAIN}: {mean:+z.2f} return/s (95 % interval {low:+z.2f} to {high:+z.2f})"

    def table(self) -> str:
        """The results of both as a plain-text table."""
        return text_table([GAIN_HEADER, *gain_rows(self.to_dict())]) + f"\n{reward_in_words(self.to_dict())}"

    def to_dict(self) -> dict[str, Any]:
        """The result as JSON-serializable values; NaN becomes None."""
        return {
            "verdict": self.verdict(),
            "episodes": self.episodes,
            "seconds": self.seconds,
            "difference": self.difference.to_dict(),
            "standard_errors": self.standard_errors if math.isfinite(self.standard_errors) else None,
            "policy": _plain(self.policy),
            "zero": _plain(self.zero),
            "motions": [
                {"motion": gain.label, "result": gain.result, "policy": _means(gain.policy), "zero": _means(gain.zero)}
                for gain in self.motions
            ],
        }


@dataclass(frozen=True)
class MotionGain:
    """A policy and the zero action under one velocity command, and its mirror image."""

    label: str
    """Motion and command, such as `forwards 0.3 m/s`"""
    policy: dict[str, Estimate]
    """Metric -> result of the policy: `fall_rate`, `electrical_power`, and the errors of the commanded velocities"""
    zero: dict[str, Estimate]
    """The same of the zero action"""
    result: str
    """`falls more`, `falls less`, `more accurate`, `less accurate`, `equal`, `mixed` or `not comparable`"""


def _plain(performance: Performance) -> dict[str, Any]:
    values = {field.name: getattr(performance, field.name) for field in dataclasses.fields(performance)}
    return {name: value.to_dict() if isinstance(value, Estimate) else value for name, value in values.items()}


def _means(estimates: Mapping[str, Estimate]) -> dict[str, float | None]:
    return {name: number(estimate.mean) for name, estimate in estimates.items()}


def gain_rows(document: Mapping[str, Any]) -> list[tuple[str, ...]]:
    """Rows of a table of `LearningGain.to_dict` with the header `GAIN_HEADER`: each motion, and the task's commands."""
    rows = [
        (gain["motion"], *_motion_cells(gain["policy"]), *_motion_cells(gain["zero"]), gain["result"])
        for gain in document.get("motions", ())
    ]
    own = [
        (
            f"{100.0 * one['commands_met']['mean']:.0f} % met" if one["commands_met"]["count"] else "-",
            f"{100.0 * one['falls']['mean']:.1f} %",
            f"{one['electrical_power']['mean']:.1f} W",
        )
        for one in (document["policy"], document["zero"])
    ]
    return [*rows, ("random commands", *own[0], *own[1], "")]


def _motion_cells(values: Mapping[str, Any]) -> tuple[str, str, str]:
    """Errors, falls and power of one controller under one command."""

    def cell(name: str) -> str:
        mean = values[name]
        return METRICS[name].show(math.nan if mean is None else mean)

    power = cell("electrical_power")
    return (
        ", ".join(cell(name) for name in values if name.endswith("error")),
        cell("fall_rate"),
        power if power == "-" else f"{power} W",
    )


def reward_in_words(document: Mapping[str, Any]) -> str:
    """Rewards of `LearningGain.to_dict`, with their 95 % intervals."""

    def shown(estimate: Mapping[str, Any], form: str = "{:z.2f}") -> str:
        mean, low, high = (None if estimate[part] is None else form.format(estimate[part]) for part in _PARTS)
        return str(mean) if low is None else f"{mean} [{low}, {high}]"

    ours, zeros = document["policy"], document["zero"]
    return (
        f"reward per second {shown(ours['return_per_second'])}, zero action {shown(zeros['return_per_second'])}, "
        f"difference {shown(document['difference'], '{:+z.2f}')}; own action {ours['own_action']:.3f} rad"
    )


def gain_beside(policy: Policy, num_seeds: int, seconds: float, progress: Progress | None = None) -> LearningGain:
    """The gain in the policy's own task, with as many episodes as an evaluation of `num_seeds` per command has.

    Terrain and randomization are the policy's own, whatever those of the evaluation are. Episodes are at most
    `DEFAULT_SECONDS` long.
    """
    episodes = max(2, min(EPISODES, EPISODES // NUM_SEEDS * num_seeds))
    return learning_gain(policy, episodes, min(DEFAULT_SECONDS, seconds), progress, num_seeds)


def learning_gain(
    policy: Policy | Agent,
    episodes: int = EPISODES,
    seconds: float = DEFAULT_SECONDS,
    progress: Progress | None = None,
    motion_seeds: int = MOTION_SEEDS,
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

    Raises:
        QuadrupedError: if there are fewer than two episodes, or they are too short for a command to be met.
    """
    if episodes < 2:
        raise QuadrupedError(f"episodes: expected 2 or more; found {episodes}")
    if not seconds >= START_UP + WINDOW:
        raise QuadrupedError(f"seconds: expected {START_UP + WINDOW:g} or more; found {seconds:g}")
    policy = as_policy(policy)
    config = without_curriculum(policy.config)
    controllers: tuple[Controller, ...] = PolicyController(policy), ZeroController(policy.action_mode)
    ours, zeros = (
        _run(controller, config, episodes, seconds, part_of(progress, 0.3 * i, 0.3 * (i + 1)))
        for i, controller in enumerate(controllers)
    )
    difference = ours[0] - zeros[0]
    error = standard_error(difference)
    return LearningGain(
        episodes,
        seconds,
        _tolerance(config.robot),
        ours[1],
        zeros[1],
        mean_interval(difference),
        float(difference.mean()) / error if error else math.nan,
        _motions(policy, motion_seeds, seconds, part_of(progress, 0.6, 1.0)) if motion_seeds else (),
    )


def _motions(policy: Policy, num_seeds: int, seconds: float, progress: Progress | None) -> tuple[MotionGain, ...]:
    """A policy and the zero action under each command, left and right turns together."""
    commands = commands_for(policy.config.robot)
    config = evaluation_task(policy.config, commands, "none")
    controllers: dict[str, Controller] = {
        "policy": PolicyController(policy),
        "zero": ZeroController(policy.action_mode),
    }
    comparison = run(controllers, {}, config, commands, num_seeds, seconds, progress)
    mirrored: dict[Command, list[int]] = {}
    for i, (forward, yaw_rate) in enumerate(commands):
        mirrored.setdefault((forward, abs(yaw_rate)), []).append(i)
    return tuple(_motion(comparison, command, rows) for command, rows in mirrored.items())


def _motion(comparison: Comparison, command: Command, rows: list[int]) -> MotionGain:
    forward, yaw_rate = command
    motion = "curve" if forward and yaw_rate else motion_of(command, comparison.robot)
    errors = [m for m, asked in zip(ERRORS, command, strict=True) if asked or motion == "standing"]
    ours, zeros = (
        {m: comparison.estimate(name, m, rows) for m in (*errors, "fall_rate", "electrical_power")}
        for name in ("policy", "zero")
    )
    label = motion if motion == "standing" else f"{motion} {words((abs(forward), yaw_rate)).replace(' and', ',')}"
    return MotionGain(label, ours, zeros, _result(comparison, errors, rows))


def _result(comparison: Comparison, errors: Sequence[str], rows: list[int]) -> str:
    """Result of the policy under some commands against the zero action: falls count first, then errors."""
    if comparison.falls_more("policy", "zero", rows):
        return "falls more"
    if comparison.falls_more("zero", "policy", rows):
        return "falls less"
    ranks = {rank(comparison, metric, "policy", "zero", rows) for metric in errors} - {"equally accurate"}
    return "equal" if not ranks else ranks.pop() if len(ranks) == 1 else "mixed"


def _tolerance(robot: Robot) -> tuple[float, float]:
    return scaled(TOLERANCE[0], scale_of("m/s", robot), 3), scaled(TOLERANCE[1], scale_of("rad/s", robot), 3)


def without_curriculum(config: TaskConfig) -> TaskConfig:
    """A task in which every episode starts on the tile that its seed gives."""
    if "curriculum" not in config.terrain:
        return config
    return dataclasses.replace(config, terrain=config.terrain.replace(curriculum=False))


def _run(
    controller: Controller, config: TaskConfig, robots: int, seconds: float, progress: Progress | None
) -> tuple[Floats, Performance]:
    """Return per second of each robot (N,), and the results of all."""
    task = Task(in_mujoco(config, robots), config)
    task.reset(np.arange(robots), seeds=list(range(FIRST_SEED, FIRST_SEED + robots)))
    observation = task.observe()
    steps, dt = round(seconds / config.control_timestep), config.control_timestep
    coefficient = config.motor.joule_coefficients(config.robot.joint_kinds)
    velocity, command = np.zeros((steps, robots, 2)), np.zeros((steps, robots, 2))
    fallen = np.zeros((steps, robots), np.bool_)
    rewards, power, squares = np.zeros(robots), np.zeros(robots), 0.0
    for step in range(steps):
        command[step] = task.command
        transition = task.act(controller, observation)
        readings, substeps = task.simulation.readings, task.context.substeps
        velocity[step, :, 0], velocity[step, :, 1] = readings.linear_velocity_b[:, 0], readings.angular_velocity_b[:, 2]
        fallen[step] = transition.terminated
        rewards += transition.reward
        power += mean_over_steps(electrical_power(substeps.joint_torque, substeps.joint_velocity, coefficient))
        squares += float((task.control.action**2).mean())
        observation = transition.observation
        if transition.terminated.any():
            task.reset(np.flatnonzero(transition.terminated))
            observation = task.observe()
        if progress is not None:
            progress((step + 1) / steps)
    per_second = rewards / (steps * dt)
    return per_second, Performance(
        return_per_second=mean_interval(per_second),
        commands_met=proportion(commands_met(velocity, command, fallen, dt, _tolerance(config.robot))),
        falls=proportion(fallen.any(axis=0)),
        electrical_power=mean_interval(power / steps),
        own_action=config.control.action.scale * math.sqrt(squares / steps),
    )


def commands_met(
    velocity: Floats, command: Floats, fallen: Mask, dt: float, tolerance: tuple[float, float] = TOLERANCE
) -> Mask:
    """True for each command that was met, robot by robot, (S,).

    A command holds until it changes, the robot falls or the time is over. It is met if the mean velocities from
    `START_UP` after its beginning to its end are within `tolerance` of it. A command under which the robot falls is not
    met. Other commands that hold for less than `START_UP` + `WINDOW` are left out, and so are those through which a
    command passes as it approaches the requested one.

    Args:
        velocity: forward velocity, m/s, and yaw rate, rad/s, (T, N, 2).
        command: command that was in force, the same units (T, N, 2).
        fallen: True where the robot fell; its next sample is of a new episode, (T, N).
        dt: time between samples, s.
        tolerance: maximum errors of the means, m/s and rad/s.
    """
    allowance, shortest = round(START_UP / dt), round((START_UP + WINDOW) / dt)
    begins = np.ones(fallen.shape, np.bool_)
    begins[1:] = (command[1:] != command[:-1]).any(axis=-1) | fallen[:-1]
    met = []
    for robot in range(fallen.shape[1]):
        starts = np.flatnonzero(begins[:, robot])
        for start, stop in zip(starts, [*starts[1:], len(fallen)], strict=True):
            if fallen[stop - 1, robot]:
                met.append(False)
            elif stop - start >= shortest:
                mean = velocity[start + allowance : stop, robot].mean(axis=0)
                met.append(bool((np.abs(mean - command[start, robot]) <= tolerance).all()))
    return np.array(met, np.bool_)
