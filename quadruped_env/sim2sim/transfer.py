"""A policy on the same episodes in two engines, and what it loses in the second one."""

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final, Self, TypedDict

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.velocity_command import out_of_range
from quadruped_env.errors import QuadrupedError, QuadrupedWarning, short
from quadruped_env.evaluation.comparison import Command, commands_for, evaluation_task, motion_of
from quadruped_env.evaluation.confidence import bootstrap_mean, number
from quadruped_env.evaluation.measures import START_UP, counted_samples, masked_mean, measure
from quadruped_env.evaluation.rollout import FIRST_SEED, Rollout, roll_out
from quadruped_env.policies import CommandedGaitController, Controller, Policy, PolicyController, ZeroController
from quadruped_env.sim2sim.engines import Drake, MuJoCo
from quadruped_env.utils.progress import Progress, part_of

Floats = NDArray[np.float64]
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
"""Forward velocity in m/s and yaw rate in rad/s of the default episodes, for the built-in robot."""
NUM_SEEDS: Final = 3
SECONDS: Final = 10.0
MAX_SECONDS: Final = 120.0
"""Maximum length of an episode, s: Drake simulates one robot after the other."""

CONTROLLERS: Final = ("policy", "tuned", "zero")
"""Names of the controllers: the policy, the searched gait and the robot that holds its stance."""
QUANTITIES: Final = ("forward_velocity", "yaw_rate", "base_height", "fallen")
"""Quantities of an episode: means in m/s, rad/s and m after the start-up and before a fall; 1 for a fall, else 0."""
TARGETS: Final = {"forward_velocity": 0.05, "yaw_rate": 0.2}
"""Velocity -> maximum loss of a policy that carries over, as a share of the velocity here."""


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
    """Controller -> engine -> quantity -> (K, S)"""

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
        """The largest loss of a velocity, and its command; None if no command asks for the velocity."""
        commands = self.commands[controller]
        losses = [(self.loss(controller, velocity, i), command) for i, command in enumerate(commands)]
        return max((entry for entry in losses if not math.isnan(entry[0])), default=None)

    def falls(self, controller: str) -> tuple[int, int]:
        """Number of falls in both engines."""
        here, there = (int(engine["fallen"].sum()) for engine in self.values[controller])
        return here, there

    def not_followed(self, controller: str) -> list[Command]:
        """Commands that ask for a velocity that the robot does not follow here, so that it has no loss."""
        return [
            command
            for i, command in enumerate(self.commands[controller])
            for name, wanted in zip(TARGETS, command, strict=True)
            if wanted and math.isnan(self.loss(controller, name, i))
        ]

    def carries_over(self) -> bool | None:
        """True if the policy loses no more than `TARGETS`, and falls no more often in the second engine.

        None if that is so, but it does not follow some command here.
        """
        largest = [(self.largest_loss("policy", name), limit) for name, limit in TARGETS.items()]
        here, there = self.falls("policy")
        if there > here or any(found is not None and found[0] > limit for found, limit in largest):
            return False
        return None if self.not_followed("policy") else True

    def to_dict(self) -> dict[str, Any]:
        """All numbers as JSON-serializable values; NaN becomes None."""
        return {
            "seeds": list(self.seeds),
            "seconds": self.seconds,
            "engines": list(self.engines),
            "targets": TARGETS,
            "carries_over": self.carries_over(),
            "controllers": {
                controller: {
                    "commands": [list(command) for command in self.commands[controller]],
                    "engines": [
                        {
                            name: [[number(value) for value in row] for row in engine[name].tolist()]
                            for name in QUANTITIES
                        }
                        for engine in engines
                    ],
                }
                for controller, engines in self.values.items()
            },
        }

    @classmethod
    def from_dict(cls, document: "StoredTransfer") -> Self:
        """Results from the values of `to_dict`.

        Raises:
            QuadrupedError: if numbers or names do not fit together; the message names the field.
        """
        engines, seeds = document["engines"], document["seeds"]
        if [engine.keys() & {"name", "version"} for engine in engines] != [{"name", "version"}] * 2:
            raise QuadrupedError(f"engines: expected two with a name and a version; found {short(engines)}")
        if "policy" not in document["controllers"] or not document["controllers"].keys() <= set(CONTROLLERS):
            found = short(list(document["controllers"]))
            raise QuadrupedError(f"controllers: expected policy, and no others than {CONTROLLERS}; found {found}")
        commands, values = {}, {}
        for controller, part in document["controllers"].items():
            pairs, shape = part["commands"], (len(part["commands"]), len(seeds))
            tables: list[Any] = [table for engine in part["engines"] for table in engine.values()]
            if 0 in shape or any(len(pair) != 2 for pair in pairs) or len(part["engines"]) != 2:
                raise QuadrupedError(f"controllers.{controller}: expected pairs as commands, seeds, and two engines")
            if any([len(row) for row in table] != [shape[1]] * shape[0] for table in tables):
                raise QuadrupedError(f"controllers.{controller}.engines: expected {shape[0]} by {shape[1]} values each")
            commands[controller] = tuple((float(v), float(w)) for v, w in pairs)
            first, second = (
                {name: np.array(table, dtype=np.float64) for name, table in engine.items()}
                for engine in part["engines"]
            )
            values[controller] = first, second
        here, there = ({**engine, "name": str(engine["name"]), "version": str(engine["version"])} for engine in engines)
        return cls(commands, tuple(seeds), float(document["seconds"]), (here, there), values)


class StoredEngine(TypedDict):
    """Quantity -> (K, S) of a controller in an engine; None where there was no data."""

    forward_velocity: list[list[float | None]]
    yaw_rate: list[list[float | None]]
    base_height: list[list[float | None]]
    fallen: list[list[float]]


class StoredController(TypedDict):
    """A controller's commands, and its results in both engines."""

    commands: list[list[float]]
    engines: list[StoredEngine]


class StoredTransfer(TypedDict):
    """`Transfer.to_dict`, as a file holds it."""

    seeds: list[int]
    seconds: float
    engines: list[dict[str, str | bool | float | None]]
    controllers: dict[str, StoredController]


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
        commands: forward velocity in m/s and yaw rate in rad/s; they may lie outside the training ranges. None:
            `COMMANDS`, in the units of the robot.
        num_seeds: episodes per command.
        seconds: length of an episode, s.
        here: the engine to compare with. None: MuJoCo, with the task's contact model.
        there: the second engine. None: Drake.
        progress: called with the fraction done.

    Raises:
        MissingExtraError: if Drake is needed and not installed.
        QuadrupedError: if there is no command or seed, a command is not finite, the episodes are too short or too long,
            or Drake cannot simulate the robot.
    """
    if commands is None:
        commands = commands_for(policy.config.robot, COMMANDS)
    checked = _checked(commands, num_seeds, seconds)
    for command in checked:
        if outside := out_of_range(command, policy.config.commands):
            warnings.warn(f"--command: {outside}, for which the policy was not trained", QuadrupedWarning, stacklevel=2)
    engines = here or MuJoCo(), there or Drake()
    config = evaluation_task(policy.config.on_terrain("flat"), checked, "none")
    settings = [{"name": engine.name, **engine.settings(config)} for engine in engines]
    standing = [command for command in checked if motion_of(command, policy.config.robot) == "standing"]
    runs: list[tuple[Controller, Sequence[Command]]] = [
        (PolicyController(policy), checked),
        (CommandedGaitController(), checked),
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


def _checked(commands: Sequence[Command], num_seeds: int, seconds: float) -> list[Command]:
    """The commands as pairs of numbers."""
    values = np.asarray(commands, dtype=np.float64)
    if values.ndim != 2 or values.shape[1] != 2 or not len(values) or not np.isfinite(values).all():
        raise QuadrupedError(
            f"command: expected one or more pairs of finite numbers, forward velocity in m/s and yaw rate in rad/s; "
            f"found {short(list(commands))}"
        )
    if num_seeds < 1:
        raise QuadrupedError(f"seeds: expected 1 or more; found {num_seeds}")
    if not START_UP < seconds <= MAX_SECONDS:
        raise QuadrupedError(
            f"seconds: expected more than {START_UP:g}, which do not count, and at most {MAX_SECONDS:g}; found "
            f"{seconds:g}"
        )
    return [(float(forward), float(yaw_rate)) for forward, yaw_rate in values]


def _measured(rollout: Rollout, num_seeds: int) -> dict[str, Floats]:
    """The quantities of a rollout: name -> (K, S)."""
    metrics = measure(rollout)
    values: dict[str, Floats] = {
        "forward_velocity": metrics["forward_velocity"],
        "yaw_rate": metrics["yaw_rate"],
        "base_height": masked_mean(rollout.base_position[..., 2], counted_samples(rollout)),
        "fallen": rollout.fallen.astype(np.float64),
    }
    return {name: np.reshape(values[name], (-1, num_seeds)) for name in QUANTITIES}
