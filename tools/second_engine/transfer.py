"""A policy on the same episodes in two engines, and what it loses in the second one."""

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.control.velocity_command import out_of_range
from quadruped_env.errors import QuadrupedError, QuadrupedWarning, short
from quadruped_env.evaluation.conditions import (
    SIDEWAYS,
    Command,
    commands_for,
    evaluation_task,
    full_command,
    motion_of,
)
from quadruped_env.evaluation.confidence import bootstrap_mean, number
from quadruped_env.evaluation.measures import METRICS, START_UP, counted_samples, masked_mean, measure
from quadruped_env.evaluation.rollout import FIRST_SEED, Rollout, roll_out
from quadruped_env.policies import Controller, GaitController, Policy, PolicyController, ZeroController
from quadruped_env.robot import Robot
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.progress import Progress, part_of
from quadruped_env.utils.text_table import text_table
from second_engine.engines import Drake, MuJoCo

Engine = MuJoCo | Drake

COMMANDS: Final[tuple[Command, ...]] = (
    (0.1, 0.0),
    (0.2, 0.0),
    (0.3, 0.0),
    (0.5, 0.0),
    (-0.2, 0.0),
    (0.0, 0.5),
    (0.3, 0.5),
    (0.0, 0.0),
)
"""Forward velocity in m/s and yaw rate in rad/s of the default episodes, for the built-in robot; robots that move
sideways also get the first of `SIDEWAYS`."""
NUM_SEEDS: Final = 3
SECONDS: Final = 10.0
MAX_SECONDS: Final = 120.0
"""Maximum length of an episode, s: Drake simulates one robot after the other."""

_LABELS: Final = {"policy": "Trained policy", "tuned": "Scripted gait", "zero": "Standing still"}
TARGETS: Final = {"forward_velocity": 0.05, "yaw_rate": 0.2, "lateral_velocity": 0.05}
"""Velocity -> maximum loss of a policy that carries over, as a share of the velocity here; in the order of commands."""


@dataclass(frozen=True)
class Transfer:
    """Results of controllers on commands and seeds in two engines: the one here and the second one, in this order."""

    commands: dict[str, tuple[Command, ...]]
    """Controller -> its K commands"""
    seeds: tuple[int, ...]
    seconds: float
    engines: tuple[dict[str, Any], dict[str, Any]]
    """Name, version, time step and contact model of each engine"""
    values: dict[str, tuple[dict[str, Floats], dict[str, Floats]]]
    """Controller -> engine -> quantity -> (K, S): the mean of each velocity in m/s or rad/s and of `base_height` in m,
    after the start-up and before a fall; `fallen` is 1 for a fall, else 0"""

    @property
    def targets(self) -> dict[str, float]:
        """Those of `TARGETS` whose velocities are commanded."""
        command = next(iter(self.commands.values()))[0]
        return {name: limit for (name, limit), _ in zip(TARGETS.items(), command, strict=False)}

    def means(self, controller: str, quantity: str, command: int) -> tuple[float, float]:
        """Mean over the seeds in both engines for one of the controller's commands (its index); NaN without data."""
        here, there = (bootstrap_mean(engine[quantity][command]).mean for engine in self.values[controller])
        return here, there

    def loss(self, controller: str, velocity: str, command: int) -> float:
        """Share of a velocity here that the second engine does not reach; negative if it is faster there.

        1 if every robot falls there during the start-up. NaN if the command (its index) does not ask for the velocity,
        or the robot does not follow it here.
        """
        wanted = self.commands[controller][command][tuple(TARGETS).index(velocity)]
        here, there = self.means(controller, velocity, command)
        if not here * wanted > 0.0:
            return math.nan
        return 1.0 if math.isnan(there) else 1.0 - there / here

    def largest_loss(self, controller: str, velocity: str) -> tuple[float, Command] | None:
        """Return the largest loss of a velocity, and its command; None if no command asks for the velocity."""
        commands = self.commands[controller]
        losses = [(self.loss(controller, velocity, i), command) for i, command in enumerate(commands)]
        return max((entry for entry in losses if not math.isnan(entry[0])), default=None)

    def falls(self, controller: str) -> tuple[int, int]:
        """Return the number of falls in both engines."""
        here, there = (int(engine["fallen"].sum()) for engine in self.values[controller])
        return here, there

    def not_followed(self, controller: str) -> list[Command]:
        """Commands that ask for a velocity that the robot does not follow here, so that it has no loss."""
        return [
            command
            for i, command in enumerate(self.commands[controller])
            for name, wanted in zip(TARGETS, command, strict=False)
            if wanted and math.isnan(self.loss(controller, name, i))
        ]

    def carries_over(self) -> bool | None:
        """Return True if the policy loses no more than `TARGETS`, and falls no more often in the second engine.

        None if that is so, but it does not follow some command here.
        """
        largest = [(self.largest_loss("policy", name), limit) for name, limit in self.targets.items()]
        here, there = self.falls("policy")
        if there > here or any(found is not None and found[0] > limit for found, limit in largest):
            return False
        return None if self.not_followed("policy") else True

    def tables(self) -> list[str]:
        """Return results of each controller as text: the mean of each quantity in both engines, and what is lost."""
        here, there = (str(engine["name"]) for engine in self.engines)
        units = [METRICS[velocity].unit for velocity in self.targets]
        velocities = (title for unit in units for title in (f"{unit} {here}", there, "loss"))
        header = (", ".join(units), *velocities, f"height mm {here}", there, f"falls {here}", there)
        found = []
        for controller, commands in self.commands.items():
            rows = []
            for i, command in enumerate(commands):
                cells = [", ".join(f"{v:g}" for v in command)]
                for velocity in self.targets:
                    cells += [_shown(value, 3) for value in self.means(controller, velocity, i)]
                    cells.append(_percent(self.loss(controller, velocity, i)))
                cells += [_shown(1000.0 * value, 0) for value in self.means(controller, "base_height", i)]
                cells += [f"{int(engine['fallen'][i].sum())}" for engine in self.values[controller]]
                rows.append(tuple(cells))
            found.append(f"{_LABELS[controller]}\n{text_table([header, *rows], left=0)}")
        return found

    def verdict(self) -> tuple[str, ...]:
        """Return the targets, one sentence each, for the policy; the first is the conclusion."""
        here, there = (str(engine["name"]) for engine in self.engines)
        carries_over = self.carries_over()
        sentences = [f"The policy {'carries' if carries_over else 'does not carry'} over to {there}."]
        if carries_over is None:
            sentences = [
                f"Whether the policy carries over to {there} is open: in {here} it does not follow the command of "
                f"{_in_words(self.not_followed('policy')[0])}."
            ]
        for velocity, target in self.targets.items():
            found = self.largest_loss("policy", velocity)
            if found is not None:
                loss, command = found
                judged = "reached" if loss <= target else "missed"
                sentences.append(
                    f"Largest loss of {velocity.replace('_', ' ')} against {here}: {_percent(loss)}, "
                    f"at {_in_words(command)}; target {_percent(target)}: {judged}."
                )
        episodes = self.values["policy"][0]["fallen"].size
        first, second = self.falls("policy")
        return *sentences, f"Falls in {episodes} episodes: {first} in {here}, {second} in {there}."

    def to_dict(self) -> dict[str, Any]:
        """Return the results of the policy as plain values, for the suite's results.

        `largest_change` is how much a commanded velocity changes at most, straight ahead and on turns, relative to the
        velocity here; None without a command.
        """
        changes: dict[str, list[float]] = {"straight": [], "turning": []}
        commands: list[dict[str, Any]] = []
        for i, command in enumerate(self.commands["policy"]):
            means = [self.means("policy", name, i) for name in self.targets]
            falls = [int(engine["fallen"][i].sum()) for engine in self.values["policy"]]
            sides = {side: [number(mean[j]) for mean in means] for j, side in enumerate(("here", "there"))}
            commands.append({"command": list(command), **sides, "falls_here": falls[0], "falls_there": falls[1]})
            losses = [self.loss("policy", name, i) for name in self.targets]
            changes["turning" if command[1] else "straight"] += [-loss for loss in losses if not math.isnan(loss)]
        return {
            "engines": list(self.engines),
            "seeds": list(self.seeds),
            "seconds": self.seconds,
            "commands": commands,
            "largest_change": {way: max(found, key=abs, default=None) for way, found in changes.items()},
        }

    def conditions(self) -> tuple[str, ...]:
        """Engine and settings in words, one sentence per engine."""
        return tuple(
            f"{engine['name']} {engine['version']}: "
            + ", ".join(
                f"{name.replace('_', ' ')} {f'{value:g}' if isinstance(value, float) else value}"
                for name, value in engine.items()
                if name not in ("name", "version")
            )
            + "."
            for engine in self.engines
        )


def _in_words(command: Command) -> str:
    return " and ".join(f"{v:g} {METRICS[name].unit}" for name, v in zip(TARGETS, command, strict=False))


def _shown(value: float, digits: int) -> str:
    return f"{value:z.{digits}f}" if math.isfinite(value) else "-"


def _percent(share: float) -> str:
    return f"{100.0 * share:z.1f} %" if math.isfinite(share) else "-"


def run_transfer(
    policy: Policy,
    commands: Sequence[Command] | None = None,
    num_seeds: int = NUM_SEEDS,
    seconds: float = SECONDS,
    here: Engine | None = None,
    there: Engine | None = None,
    progress: Progress | None = None,
) -> Transfer:
    """Run a policy and the searched gait on every command, and the stance on those that stand, in two engines.

    The task is the policy's own, on level ground; of its randomization only the start of an episode remains. A seed
    gives the same start in both engines.

    Args:
        policy: the trained policy.
        commands: forward velocity in m/s, yaw rate in rad/s, and for robots that move sideways lateral velocity in m/s;
            they may lie outside the training ranges. None: `COMMANDS`, in the units of the robot.
        num_seeds: episodes per command.
        seconds: length of an episode, s.
        here: the engine to compare with. None: MuJoCo, with the task's contact model.
        there: the second engine. None: Drake.
        progress: called with the fraction done.

    Raises:
        QuadrupedError: if there is no command or seed, a command is not finite, the episodes are too short or too long,
            Drake is needed and not installed, or it cannot simulate the robot.
    """
    if commands is None:
        robot = policy.config.robot
        commands = commands_for(robot, (*COMMANDS, *SIDEWAYS[:1]) if robot.moves_sideways else COMMANDS)
    checked = _checked(commands, num_seeds, seconds, policy.config.robot)
    for command in checked:
        if outside := out_of_range(command, policy.config.commands):
            warnings.warn(f"--command: {outside}, for which the policy was not trained", QuadrupedWarning, stacklevel=2)
    engines = here or MuJoCo(), there or Drake()
    config = evaluation_task(policy.config.on_terrain("flat"), checked, "none")
    settings = [{"name": engine.name, **engine.settings(config)} for engine in engines]
    standing = [command for command in checked if motion_of(command, policy.config.robot) == "standing"]
    runs: list[tuple[Controller, Sequence[Command]]] = [
        (PolicyController(policy), checked),
        (GaitController(), checked),
        (ZeroController(), standing),
    ]
    runs = [(controller, chosen) for controller, chosen in runs if chosen]
    seeds = range(FIRST_SEED, FIRST_SEED + num_seeds)
    total, done = sum(len(chosen) for _, chosen in runs), 0
    values = {}
    for controller, chosen in runs:
        first, second = (
            _measured(roll_out(controller, chosen, seeds, seconds, config, part, engine=engine), len(seeds))
            for engine, part in zip(
                engines, (None, part_of(progress, done / total, (done + len(chosen)) / total)), strict=True
            )
        )
        values[controller.name] = first, second
        done += len(chosen)
    return Transfer(
        {controller.name: tuple(chosen) for controller, chosen in runs},
        tuple(seeds),
        seconds,
        (settings[0], settings[1]),
        values,
    )


def _checked(commands: Sequence[Command], num_seeds: int, seconds: float, robot: Robot) -> list[Command]:
    """Return the commands with a number for each velocity of the robot."""
    names = ", ".join(f"{entry.name} in {entry.unit}" for entry in velocity_commands(robot))
    full, count = [full_command(command, robot) for command in commands], len(full_command((), robot))
    if not full or any(len(command) != count or not np.isfinite(command).all() for command in full):
        raise QuadrupedError(
            f"command: expected one or more commands of finite numbers, {names}; found {short(list(commands))}"
        )
    if num_seeds < 1:
        raise QuadrupedError(f"seeds: expected 1 or more; found {num_seeds}")
    if not START_UP < seconds <= MAX_SECONDS:
        raise QuadrupedError(
            f"seconds: expected more than {START_UP:g}, which do not count, and at most {MAX_SECONDS:g}; found "
            f"{seconds:g}"
        )
    return [tuple(map(float, command)) for command in full]


def _measured(rollout: Rollout, num_seeds: int) -> dict[str, Floats]:
    """Return the quantities of a rollout: name -> (K, S)."""
    metrics = measure(rollout)
    values: dict[str, Floats] = {
        **{name: metrics[name] for name in TARGETS if name in metrics},
        "base_height": masked_mean(rollout.base_position[..., 2], counted_samples(rollout)),
        "fallen": rollout.fallen.astype(np.float64),
    }
    return {name: np.reshape(value, (-1, num_seeds)) for name, value in values.items()}
