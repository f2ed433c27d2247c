"""Gain of a policy over doing nothing: both in the policy's own task, episode by episode."""

import dataclasses
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.confidence import Estimate, mean_interval, proportion, standard_error
from quadruped_env.evaluation.metrics import START_UP, WINDOW
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
NOT_BETTER: Final = "not better than doing nothing beyond doubt"

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

    @property
    def is_better(self) -> bool:
        """True if the policy's return is higher beyond doubt: the whole interval of the difference is above 0."""
        return self.difference.low > 0.0

    def verdict(self) -> str:
        """The result in a few words."""
        mean, low, high = self.difference.mean, self.difference.low, self.difference.high
        if self.is_better:
            errors = f" ({self.standard_errors:.1f} standard errors)" if math.isfinite(self.standard_errors) else ""
            return f"better than doing nothing by {mean:.2f} return/s{errors}"
        return f"{NOT_BETTER}: {mean:+z.2f} return/s (95 % interval {low:+z.2f} to {high:+z.2f})"

    def table(self) -> str:
        """The results of both as a plain-text table."""
        return text_table([("", "policy", "zero action"), *gain_rows(self.to_dict())], left=3)

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
        }


def _plain(performance: Performance) -> dict[str, Any]:
    values = {field.name: getattr(performance, field.name) for field in dataclasses.fields(performance)}
    return {name: value.to_dict() if isinstance(value, Estimate) else value for name, value in values.items()}


def gain_rows(document: Mapping[str, Any]) -> list[tuple[str, ...]]:
    """Rows of a table of `LearningGain.to_dict`: quantity, value of the policy, value of the zero action."""
    shown = {
        "reward per second": ("return_per_second", 1.0, "{:z.2f}", ""),
        "commands met": ("commands_met", 100.0, "{:.0f}", " %"),
        "episodes with a fall": ("falls", 100.0, "{:.1f}", " %"),
        "electrical power": ("electrical_power", 1.0, "{:.1f}", " W"),
    }

    def cell(performance: Mapping[str, Any], name: str, factor: float, form: str, unit: str) -> str:
        values = [performance[name][part] for part in ("mean", "low", "high")]
        if values[0] is None:
            return "-"
        mean, *ends = (None if value is None else form.format(factor * value) for value in values)
        return f"{mean}{unit}" if None in ends else f"{mean}{unit} [{ends[0]}, {ends[1]}]"

    both = document["policy"], document["zero"]
    first, *others = [(label, *(cell(one, *how) for one in both)) for label, how in shown.items()]
    return [
        first,
        ("gain in reward per second", cell(document, "difference", 1.0, "{:+z.2f}", ""), ""),
        *others,
        ("own action, RMS", *(f"{one['own_action']:.3f} rad" for one in both)),
    ]


def learning_gain(
    policy: Policy | Agent,
    episodes: int = EPISODES,
    seconds: float = DEFAULT_SECONDS,
    progress: Progress | None = None,
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
        _run(controller, config, episodes, seconds, part_of(progress, 0.5 * i, 0.5 * (i + 1)))
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
    )


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
