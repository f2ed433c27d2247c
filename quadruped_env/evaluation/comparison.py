"""Comparison of a policy with the scripted gaits and with its zero action, on the same commands and starts."""

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import (
    MOTIONS,
    Command,
    commands_for,
    evaluation_task,
    full_command,
    motion_of,
)
from quadruped_env.evaluation.confidence import Estimate, bootstrap_mean, proportion
from quadruped_env.evaluation.measures import METRICS, START_UP, WINDOW, measure, metrics_of
from quadruped_env.evaluation.rollout import DEFAULT_SECONDS, FIRST_SEED, Rollout, roll_out
from quadruped_env.gait import CommandedGait, SinusoidalGait
from quadruped_env.policies import (
    Agent,
    Controller,
    GaitController,
    Policy,
    PolicyController,
    ZeroController,
    as_policy,
)
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import Terrain
from quadruped_env.task import TaskConfig
from quadruped_env.utils.progress import Progress, part_of

Motion = str | Sequence[int] | None
"""One of `MOTIONS`, indices of commands, or None for all commands."""

NUM_SEEDS: Final = 8
MAX_SECONDS: Final = 600.0
"""Maximum length of an episode, s: all episodes are kept in memory."""

_EQUAL: Final = 0.005
"""Difference below which two errors count as equal, for the built-in robot, m/s or rad/s."""

CONTROLLERS: Final = {
    "policy": "Trained policy",
    "tuned": "Searched gait",
    "article": "Article's gait",
    "zero": "Zero action",
}
"""Name -> label, in the order of tables. The zero action belongs to the first policy: its gait alone, or the stance."""


def error_of(motion: str) -> str:
    """Return the name of the error metric of a motion."""
    return f"{MOTIONS[motion]}_error"


def equal_up_to(metric: str, robot: Robot) -> float:
    """Return the difference below which two errors count as equal."""
    return _EQUAL * scale_of(METRICS[metric].unit, robot)


@dataclass(frozen=True)
class Comparison:
    """Rollouts and metrics of every controller on K commands with S seeds each."""

    commands: tuple[Command, ...]
    seeds: tuple[int, ...]
    seconds: float
    config: TaskConfig
    """Task of the episodes; the action mode is each controller's own"""
    rollouts: dict[str, Rollout]
    """Controller -> K * S episodes, grouped by command"""
    values: dict[str, dict[str, NDArray[np.float64]]]
    """Controller -> metric -> (K, S)"""
    condition: str = "undisturbed, on the task's own ground"
    """Randomization and ground of the episodes in words, which every table names"""

    @property
    def robot(self) -> Robot:
        """Robot of the episodes."""
        return self.config.robot

    def conditions(self, motion: Motion) -> list[int]:
        """Return the indices of the commands that ask for one of `MOTIONS`; None: of all commands; indices: these."""
        if motion is not None and not isinstance(motion, str):
            return list(motion)
        return [i for i, command in enumerate(self.commands) if motion in (None, motion_of(command, self.robot))]

    @property
    def motions(self) -> list[str]:
        """The `MOTIONS` that a command asks for."""
        return [motion for motion in MOTIONS if self.conditions(motion)]

    def estimate(self, controller: str, metric: str, motion: Motion = None) -> Estimate:
        """Return the mean of a metric over a motion's commands and the seeds, with its confidence interval.

        A single seed gives no interval, but for falls: the commands are not random.
        """
        return self._estimate(metric, self.values[controller][metric][self.conditions(motion)])

    def difference(self, metric: str, controller: str, other: str, motion: Motion = None) -> Estimate:
        """Return the mean of `controller` minus `other` over pairs of episodes with the same command and start."""
        rows = self.conditions(motion)
        return self._estimate("", self.values[controller][metric][rows] - self.values[other][metric][rows])

    def falls_more(self, controller: str, other: str, motion: Motion = None) -> bool:
        """Return True if a controller falls more often than another one: their confidence intervals do not overlap."""
        own, others = (self.estimate(name, "fall_rate", motion) for name in (controller, other))
        return own.low > others.high

    def _estimate(self, metric: str, values: NDArray[np.float64]) -> Estimate:
        if metric == "fall_rate":
            return proportion(values)
        found = bootstrap_mean(values)
        return found if len(self.seeds) > 1 else dataclasses.replace(found, low=math.nan, high=math.nan)

    def rows(self, command: int) -> NDArray[np.intp]:
        """Return the indices, in the rollouts, of the episodes of one command (its index)."""
        return np.arange(len(self.seeds)) + command * len(self.seeds)

    def episode(self, command: int, controller: str = "policy") -> int:
        """Return the index of the episode that represents a command (index): the first without a fall, or longest."""
        block = self.rows(command)
        return int(block[self.rollouts[controller].valid[:, block].sum(axis=0).argmax()])

    def seen_as(self, controller: str) -> Self:
        """Return the same comparison with this controller as `policy`, next to the scripted controllers only."""
        names = {"policy": controller, **{name: name for name in CONTROLLERS if name != "policy"}}
        return dataclasses.replace(
            self,
            rollouts={name: self.rollouts[source] for name, source in names.items()},
            values={name: self.values[source] for name, source in names.items()},
        )

    def to_dict(self) -> dict[str, Any]:
        """Return all numbers as JSON-serializable values; NaN becomes None."""
        metrics, velocities = metrics_of(self.robot), [entry.name for entry in velocity_commands(self.robot)]
        return {
            "metrics": {
                name: {"unit": metric.unit or "1", "meaning": metric.meaning, "limit": metric.limit_of(self.robot)}
                for name, metric in metrics.items()
            },
            "commands": [
                {**dict(zip(velocities, command, strict=True)), "motion": motion_of(command, self.robot)}
                for command in self.commands
            ],
            "condition": self.condition,
            "seeds": list(self.seeds),
            "seconds": self.seconds,
            "controllers": {
                controller: {
                    "all": {m: self.estimate(controller, m).to_dict() for m in metrics},
                    "by_motion": {
                        motion: {m: self.estimate(controller, m, motion).to_dict() for m in metrics}
                        for motion in self.motions
                    },
                    "by_command": [
                        {m: self.estimate(controller, m, [i]).to_dict() for m in metrics}
                        for i in range(len(self.commands))
                    ],
                }
                for controller in self.values
            },
        }


def rank(comparison: Comparison, metric: str, controller: str, other: str, motion: Motion = None) -> str:
    """Return the rank of a controller against another one: `more accurate`, `less accurate` or `equally accurate`.

    Judged by the paired differences of an error: their interval must not include zero, and their mean must exceed
    `equal_up_to`. `not comparable` without an interval: no pair of episodes has two values, or there is one seed.
    """
    difference = comparison.difference(metric, controller, other, motion)
    if math.isnan(difference.low):
        return "not comparable"
    if not abs(difference.mean) > equal_up_to(metric, comparison.robot) or difference.low <= 0.0 <= difference.high:
        return "equally accurate"
    return "more accurate" if difference.mean < 0.0 else "less accurate"


def compare(
    policies: Policy | Agent | Mapping[str, Policy | Agent],
    num_seeds: int = NUM_SEEDS,
    seconds: float = DEFAULT_SECONDS,
    commands: Sequence[Command] | None = None,
    progress: Progress | None = None,
    terrain: str | Terrain | None = None,
    randomization: str = "none",
) -> Comparison:
    """Run policies, the searched gait, the tutorial's gait (`article`) and the zero action on the same episodes.

    Each policy runs the task that it was trained for, with a preset instead of its randomization, a user's own
    included: by default, only the start of an episode is random. The scripted controllers run the first policy's task,
    the searched gait with a clock of its own frequency. Commands may lie outside the training ranges.

    Args:
        policies: one policy, which is called `policy`, or several by name: trained ones, or objects with the two
            methods of `Agent`.
        num_seeds: episodes per command.
        seconds: length of an episode, s.
        commands: forward velocity in m/s, yaw rate in rad/s, and for robots that move sideways lateral velocity in m/s;
            None: `COMMANDS`, and `SIDEWAYS` for such robots, in the units of the robot.
        progress: called with the fraction done.
        terrain: a terrain, or the name of one; None: the tasks' own.
        randomization: a preset, which replaces the tasks' own randomization: `none`, `moderate` or `hard`.

    Raises:
        QuadrupedError: if there is no seed or no such terrain or preset, the episodes are too short to measure, a
            policy has the name of a scripted controller, or two policies are for different robots.
    """
    named = policies if isinstance(policies, Mapping) else {"policy": policies}
    known = {name: as_policy(policy, name) for name, policy in named.items()}
    taken = sorted(set(known) & (set(CONTROLLERS) - {"policy"}))
    if taken:
        raise QuadrupedError(f"{taken[0]!r} is the name of a scripted controller; rename the policy's directory")
    if num_seeds < 1:
        raise QuadrupedError(f"seeds: expected 1 or more; found {num_seeds}")
    if not START_UP + WINDOW <= seconds <= MAX_SECONDS:
        raise QuadrupedError(
            f"seconds: expected {START_UP + WINDOW:g} to {MAX_SECONDS:g}; found {seconds:g}. The first {START_UP:g} s "
            f"of an episode do not count, and velocities are means over {WINDOW:g} s"
        )
    if commands is None:
        commands = commands_for(next(iter(known.values())).config.robot)
    configs = {
        name: evaluation_task(
            policy.config if terrain is None else policy.config.on_terrain(terrain), commands, randomization
        )
        for name, policy in known.items()
    }
    config = next(iter(configs.values()))
    for name, policy in known.items():
        if policy.config.robot != config.robot:
            raise QuadrupedError(
                f"{name}: is a policy for {policy.config.robot!r}, the first one for {config.robot!r}; compare "
                f"policies for one robot with each other, and evaluate those for other robots by themselves"
            )
    tuned = CommandedGait.preset("tuned", config.robot)
    # With a clock of its own frequency the searched gait is in phase, so that the reward's terms of the clock judge it.
    configs["tuned"] = dataclasses.replace(config, clock_frequency=tuned.angular_frequency / math.tau)
    controllers: tuple[Controller, ...] = (
        *(PolicyController(policy, name) for name, policy in known.items()),
        GaitController(tuned),
        GaitController(SinusoidalGait.preset("article", config.robot), "article"),
        ZeroController(config.action.mode),
    )
    by_name = {controller.name: controller for controller in controllers}
    law = "undisturbed" if randomization == "none" else f"with the randomization {randomization}"
    ground = "the task's own ground" if terrain is None else f"the terrain {config.terrain['name']}"
    found = run(by_name, configs, config, commands, num_seeds, seconds, progress)
    return dataclasses.replace(found, condition=f"{law}, on {ground}")


def run(
    controllers: Mapping[str, Controller],
    configs: Mapping[str, TaskConfig],
    config: TaskConfig,
    commands: Sequence[Command],
    num_seeds: int,
    seconds: float,
    progress: Progress | None = None,
) -> Comparison:
    """Run controllers on the same commands and starts, each in its task of `configs`, or else in `config`."""
    seeds, commands = range(FIRST_SEED, FIRST_SEED + num_seeds), [full_command(one, config.robot) for one in commands]
    rollouts, values = {}, {}
    for i, (name, controller) in enumerate(controllers.items()):
        part = part_of(progress, i / len(controllers), (i + 1) / len(controllers))
        rollout = roll_out(controller, commands, seeds, seconds, configs.get(name, config), part, physics=True)
        values[name] = {m: v.reshape(len(commands), num_seeds) for m, v in measure(rollout).items()}
        rollouts[name] = dataclasses.replace(rollout, physics=None)
    return Comparison(tuple(commands), tuple(seeds), rollout.seconds, config, rollouts, values)
