"""Definition of a task: lists of terms, built-in or from a user's file."""

import dataclasses
import functools
import os
from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import ClassVar, Final, Self

from quadruped_env.control.control_config import Command
from quadruped_env.control.observations import ObservationField
from quadruped_env.control.task_file import Terms, execute, merged, names_of
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import motor_heat, scale_of, scaled
from quadruped_env.simulation.built_in_terrains import TERRAINS
from quadruped_env.simulation.terrain import Terrain, Tiles
from quadruped_env.task.privileged import PRIVILEGED, PrivilegedReading
from quadruped_env.task.randomization.built_in_randomizations import RANDOMIZATIONS
from quadruped_env.task.randomization.randomization import Randomization
from quadruped_env.task.rewards import REWARDS, electrical_power, lateral
from quadruped_env.task.terminations import TERMINATIONS
from quadruped_env.task.terms import RewardTerm, Termination
from quadruped_env.utils.provenance import TaskFile


@dataclass(frozen=True, eq=False)
class TaskDefinition(Terms):
    """Robot, and ordered lists of terms: rewards, observations, terminations, randomizations, commands, terrains.

    Two definitions are equal if they have the same robot, come from files with the same content, and were given the
    same terrains.
    """

    kinds: ClassVar[Mapping[str, type]] = {
        "rewards": RewardTerm,
        "observations": ObservationField,
        "privileged": PrivilegedReading,
        "terminations": Termination,
        "randomizations": Randomization,
        "commands": Command,
        "terrains": Terrain,
    }

    rewards: tuple[RewardTerm, ...] = (*REWARDS, lateral)
    privileged: tuple[PrivilegedReading, ...] = PRIVILEGED
    terminations: tuple[Termination, ...] = TERMINATIONS
    randomizations: tuple[Randomization, ...] = RANDOMIZATIONS
    terrains: tuple[Terrain, ...] = TERRAINS
    added_terrains: tuple[Terrain, ...] = ()
    """Terrains that are neither built in nor defined by the file."""

    @property
    def paid(self) -> tuple[RewardTerm, ...]:
        """The `rewards` that the robot can earn: without `lateral` if it does not move sideways."""
        return tuple(term for term in self.rewards if self.robot.moves_sideways or term is not lateral)

    @property
    def weights(self) -> dict[str, float]:
        """Default weight of every reward term, per second, in the order in which they are added."""
        return {
            name: scaled(weight, self.weight_scale(term)) for term in self.paid for name, weight in term.weights.items()
        }

    def weight_scale(self, term: RewardTerm) -> float:
        """Return the factor on the weights of a reward term, which are the built-in robot's if the term is built in."""
        heat = motor_heat(self.robot) if term is electrical_power else 1.0
        return 1.0 / (heat * self.scale(term, term.unit))

    def scale(self, term: object, unit: str) -> float:
        """Return the factor on the numbers of a term in a unit, which are the built-in robot's if the term is built in.

        Those of a user's file are as the user gave them: 1.
        """
        built_in = any(term is entry for kind in self.kinds for entry in getattr(BUILT_IN, kind))
        return scale_of(unit, self.robot) if built_in else 1.0

    def own_terms(self) -> dict[str, list[str]]:
        """Return the names of what the user's file defines or leaves out, by kind, as in the lists above."""
        own = {
            kind: [
                name
                for term in getattr(self, kind)
                if not any(term is other for other in getattr(BUILT_IN, kind)) and term not in self.added_terrains
                for name in names_of(term)
            ]
            for kind in self.kinds
        }
        here = {entry.name for entry in self.observations}
        own["observations"] += [entry.name for entry in BUILT_IN.observations if entry.name not in here]
        return own

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TaskDefinition) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    @property
    def _identity(self) -> tuple[object, ...]:
        return None if self.file is None else self.file.sha256, self.robot, self.added_terrains

    def __reduce__(self) -> tuple[object, ...]:
        # Functions of a user's file do not support pickling: unpickling loads the file again.
        return _again, (self.path, self.file, self.robot, self.added_terrains)

    def __deepcopy__(self, memo: dict[int, object]) -> Self:
        return self

    def with_robot(self, robot: Robot) -> Self:
        """Return a copy for another robot."""
        return dataclasses.replace(self, robot=robot)

    def with_terrain(self, terrain: Terrain) -> Self:
        """Return a copy with one more terrain, or another of the same name, without its seed, level and parameters.

        Tiles add their kinds.
        """
        if isinstance(terrain, Tiles):
            return functools.reduce(type(self).with_terrain, terrain.kinds, self)
        plain = terrain.variant()
        if plain in self.terrains:
            return self
        terrains = merged(self.terrains, [plain])
        return dataclasses.replace(self, terrains=terrains, added_terrains=(*self.added_terrains, plain))

    def extended(self, file: TaskFile, module: ModuleType) -> Self:
        """See `Terms`; terrains name the file."""
        found, own = super().extended(file, module), set(map(id, self.terrains))
        terrains = [entry if id(entry) in own else dataclasses.replace(entry, file=file) for entry in found.terrains]
        return dataclasses.replace(found, terrains=tuple(terrains))


BUILT_IN: Final = TaskDefinition()


def load_task_file(path: str | os.PathLike[str], expected: TaskFile | None = None) -> TaskDefinition:
    """Return the built-in task, extended by the terms and the robot that a Python file defines at its top level.

    A built-in observation whose name the file sets to None is left out.

    The file's code is executed, so load only files that you trust.

    Raises:
        QuadrupedError: if the file cannot be read, differs from the expected one, which is verified before anything is
            executed, raises an error, defines more than one robot, or defines nothing of a task.
    """
    return _defined(*execute(path, expected))


@functools.cache
def _defined(file: TaskFile, module: ModuleType) -> TaskDefinition:
    """Return the built-in task, extended by what an executed file defines."""
    definition = BUILT_IN.extended(file, module)
    if definition.robot is BUILT_IN.robot and not any(definition.own_terms().values()):
        raise QuadrupedError(
            f"{definition.path}: defines no term and no robot; use @reward, @reward_group, @observation, @privileged, "
            f"@termination or @terrain, or make a Randomization, Command or QuadrupedDesign, at the top level of the "
            f"file (docs/make-it-yours.md)"
        )
    return definition


def _again(
    path: str | None, file: TaskFile | None, robot: Robot, added_terrains: tuple[Terrain, ...]
) -> TaskDefinition:
    """Return the definition from the arguments that were pickled."""
    definition = BUILT_IN if path is None or file is None else load_task_file(path, file)
    for terrain in added_terrains:
        definition = definition.with_terrain(terrain)
    return definition if definition.robot == robot else definition.with_robot(robot)
