"""Config of the task: frozen, validated, printable, and saved with every run.

The fields of the sections `command`, `reward`, `termination`, `randomization` and `terrain` are the parameters of the
task's terms, so they depend on the task's definition (`quadruped_env.task.sections`).
"""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, Self

import mujoco

from quadruped_env.control.control_config import ClockFrequency, Command, ControlConfig, LoopConfig, clock_frequency
from quadruped_env.control.task_file import TASK_FILE, needs_file, recorded_file, recorded_terms
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.motors import MOTOR_PRESETS, MotorConfig
from quadruped_env.robot.robot import Robot, check_same_robot
from quadruped_env.simulation import build_model
from quadruped_env.simulation.terrain import Terrain
from quadruped_env.task.command_sampling import CommandSection
from quadruped_env.task.randomization.model_fields import longest_delay
from quadruped_env.task.randomization.randomization import RandomizationSection
from quadruped_env.task.randomization.randomization_presets import PRESET, preset_values
from quadruped_env.task.sections import SECTIONS, section_of, section_type
from quadruped_env.task.task_definition import BUILT_IN, TaskDefinition
from quadruped_env.task.terms import RewardSection, TerminationSection
from quadruped_env.task.terrain_section import TerrainSection, values_of
from quadruped_env.utils.fields import Section, check_names, hints_of, known, one_of, with_values
from quadruped_env.utils.plain import Plain, plain
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile

ROBOT: Final = "robot"
"""Field of a config's plain values that names the robot, if it is not the built-in one."""
_OF_THE_DEFINITION: Final[Plain] = None
"""Default of the fields whose defaults depend on the task's definition."""


@dataclass(frozen=True)
class TaskConfig(LoopConfig):
    """Complete config of a task."""

    clock_frequency: ClockFrequency = _OF_THE_DEFINITION
    """See `LoopConfig`. Default: 3.4 Hz for the built-in robot, and in its units for others."""
    command: CommandSection = _OF_THE_DEFINITION
    reward: RewardSection = _OF_THE_DEFINITION
    termination: TerminationSection = _OF_THE_DEFINITION
    randomization: RandomizationSection = _OF_THE_DEFINITION
    motor: MotorConfig = _OF_THE_DEFINITION
    """Motors of the robot, as `mini-quadruped identify` writes them, or the name of one of `MOTOR_PRESETS` in plain
    values. Default: the motors of the definition's robot."""
    terrain: TerrainSection = _OF_THE_DEFINITION
    """Name, seed and parameters of the ground."""
    definition: TaskDefinition = field(default=BUILT_IN, repr=False)
    """Robot and terms of the task; `load_task_file` adds what a user's file defines."""

    def __post_init__(self) -> None:
        definition = self.definition
        object.__setattr__(self, "motor", _motor(self.motor, definition.robot))
        if self.clock_frequency is None:
            object.__setattr__(self, "clock_frequency", clock_frequency(definition.robot))
        for name, base in SECTIONS.items():
            section = getattr(self, name)
            kind = section_type(base, definition, section)
            if isinstance(section, kind):
                continue
            # A section of the built-in task, in a task with other terms or another robot: its numbers stay.
            values = known(section, kind) if isinstance(section, Section) else section
            object.__setattr__(self, name, section_of(base, definition, {} if values is None else values))
        super().__post_init__()

    @property
    def file(self) -> TaskFile | None:
        """The user's file of the terms or the robot, or else of the terrain; None for what is built in."""
        return self.definition.file or self.ground.file

    @property
    def robot(self) -> Robot:
        """Robot of the task."""
        return self.definition.robot

    def with_definition(self, definition: TaskDefinition) -> Self:
        """Return a copy with other terms or another robot, with that robot's motors and defaults."""
        motor = _OF_THE_DEFINITION if self.motor == self.robot.motors else self.motor
        clock = _OF_THE_DEFINITION if self.clock_frequency == clock_frequency(self.robot) else self.clock_frequency
        sections: dict[str, Plain] = {}
        for name, base in SECTIONS.items():
            section: Section = getattr(self, name)
            changes = known(section.changes(), section_type(base, definition, section))
            sections[name] = section_of(base, definition, changes)
        return dataclasses.replace(self, motor=motor, clock_frequency=clock, definition=definition, **sections)

    def for_robot(self, robot: Robot) -> Self:
        """Return a copy for another robot; see `with_definition`."""
        return self.with_definition(self.definition.with_robot(robot))

    @property
    def ground(self) -> Terrain:
        """The terrain with its seed and parameters, for `build_model`."""
        return self.terrain.ground

    def on_terrain(self, terrain: str | Terrain, seed: int | None = None) -> Self:
        """Return a copy on another terrain; the terrain that the config already has keeps its level and parameters.

        Args:
            terrain: name of a terrain of the task's definition, or any terrain; it may be a variant.
            seed: seed of the terrain; None keeps the config's.

        Raises:
            QuadrupedError: if there is no such terrain; the message names those that there are.
        """
        definition, changes = self.definition, {} if seed is None else {"seed": seed}
        if isinstance(terrain, Terrain):
            definition = definition.with_terrain(terrain)
            if seed is None and terrain.seed:
                changes["seed"] = terrain.seed
            changes |= values_of(terrain)
        name = terrain.name if isinstance(terrain, Terrain) else terrain
        kept = self.terrain.changes() if name == self.terrain.name else {}
        if "level" in changes:  # which replaces the parameters that it has
            kept = {}
        values = {"seed": self.terrain.seed, **kept, "name": name, **changes}
        return dataclasses.replace(self, definition=definition, terrain=section_of(TerrainSection, definition, values))

    def without_randomization(self) -> Self:
        """Return a copy of the config without randomizations, a user's own included, and without observation noise."""
        off = dict.fromkeys(entry.name for entry in self.definition.randomizations)
        return self._with_randomization({**off, "observation_noise": 0.0})

    def randomized(self, preset: str) -> Self:
        """Return a copy whose randomization is a preset: `none`, `moderate` or `hard`.

        A user's own randomizations are off, and so is one that replaces a built-in one.

        Raises:
            QuadrupedError: if there is no such preset.
        """
        own = (entry.name for entry in self.definition.randomizations if entry not in BUILT_IN.randomizations)
        return self._with_randomization({**preset_values(preset, self.robot), **dict.fromkeys(own)})

    def _with_randomization(self, values: Mapping[str, Plain]) -> Self:
        return dataclasses.replace(self, randomization=section_of(RandomizationSection, self.definition, values))

    @property
    def max_delay(self) -> float:
        """Longest delay from joint target to motor that the config allows, s."""
        return longest_delay(self.motor.delay, self.randomization.active(self.definition.randomizations))

    def compiled_model(self) -> mujoco.MjModel:
        """Return the compiled model of the task's robot on its terrain; every call returns a new copy."""
        return build_model(self.physics_timestep, self.motor, self.ground, self.robot, max_delay=self.max_delay)

    @property
    def control(self) -> ControlConfig:
        """Part of the config that training and a real robot share."""
        return ControlConfig.of(self, self.command, self.robot, self.definition.commands)

    @property
    def commands(self) -> tuple[Command, ...]:
        """Components of the command, the velocities first."""
        return self.control.commands

    def to_dict(self) -> dict[str, Plain]:
        """Return nested plain values for `from_dict` and JSON, with the name and SHA-256 of files and robots."""
        values, definition = super().to_dict(), self.definition
        del values["definition"]
        if definition.file is not None:
            values[TASK_FILE] = {**definition.file.to_dict(), "terms": definition.own_terms()}
        terrain_file = self.ground.file
        if terrain_file is not None and terrain_file != definition.file:
            values[TERRAIN_FILE] = terrain_file.to_dict()
        if definition.robot != BUILT_IN.robot:
            values[ROBOT] = definition.robot.identity
        return values

    @classmethod
    def from_dict(cls, values: dict[str, Plain], definition: TaskDefinition = BUILT_IN) -> Self:
        """Create a config from nested values, which may be NumPy's; missing fields have their defaults.

        Args:
            values: nested values in the form of `to_dict`.
            definition: terms of the task, if some of them come from a user's file (`load_task_file`).

        Raises:
            QuadrupedError: if a field is unknown or a value has the wrong type (the message names the field and what
                is valid), or if the values name a file of terms or of the terrain and the definition has none, or they
                name another robot than the definition's.
        """
        values = plain(values)
        if not isinstance(values, dict):
            raise QuadrupedError(f"config: expected a mapping of fields; found {short(values)}")
        file = recorded_file(values.get(TASK_FILE))
        if file is not None and definition.file is None:
            raise needs_file("this task has terms", file)
        values = known_values(values, definition)
        terrain_file = values.pop(TERRAIN_FILE, None)
        check_same_robot(values.pop(ROBOT, None), definition.robot)
        if terrain_file is not None:
            terrains = _terrains_of_file(terrain_file, values.get("terrain"), definition)
            # The file gave the config its terrains and nothing else.
            definition = definition if file is not None else BUILT_IN.with_robot(definition.robot)
            for terrain in terrains:
                definition = definition.with_terrain(terrain)
        check_names(values, [name for name in hints_of(cls) if name != "definition"], "config")
        return cls(**values, definition=definition)


def _motor(values: Plain, robot: Robot) -> MotorConfig:
    """Return the motors whose missing fields are a robot's, or the named preset's."""
    base = robot.motors
    if values is None or isinstance(values, MotorConfig):
        return base if values is None else values
    if isinstance(values, str):
        values = {PRESET: values}
    if isinstance(values, dict) and PRESET in values:
        base = MOTOR_PRESETS[one_of(values[PRESET], MOTOR_PRESETS, "config.motor.preset")]
        values = {field: value for field, value in values.items() if field != PRESET}
    motors = with_values(base, values, "config.motor")
    if motors.abduction is not None and "abduction" not in robot.joint_kinds:
        kinds = ", ".join(robot.joints_by_kind)
        raise QuadrupedError(f"config.motor.abduction: {robot.name!r} has joints of the kinds {kinds}; remove it")
    return motors


def _terrain_names(section: Plain) -> list[Plain]:
    """Return the terrains that a section of plain values names, itself or as kinds of its tiles."""
    values = section if isinstance(section, Mapping) else {}
    kinds = values.get("kinds")
    return [values.get("name"), *(kinds if isinstance(kinds, (list, tuple)) else ())]


def _terrains_of_file(recorded: Plain, section: Plain, definition: TaskDefinition) -> list[Terrain]:
    """Return the terrains that a section names and that are from a user's file, as they must be if one is recorded."""
    names = _terrain_names(section)
    found = [entry for entry in definition.terrains if entry.name in names and entry.file is not None]
    file = recorded_file(recorded, TERRAIN_FILE)
    if file is not None and not found:
        raise needs_file(f"this task has the terrain {short(names[0])}", file)
    return found


def known_values(values: Mapping[str, Plain], definition: TaskDefinition) -> dict[str, Plain]:
    """Return plain values of a config without the user's file and without the terms that a definition lacks.

    So a run's numbers count with any version of its file, or without the file.

    Raises:
        QuadrupedError: if the values name a terrain of the file, and the definition lacks it.
    """
    file, present = recorded_file(values.get(TASK_FILE)), definition.file
    kept = {name: value for name, value in values.items() if name != TASK_FILE}
    if file is None or (present is not None and present.sha256 == file.sha256):
        return kept
    terrains = [entry.name for entry in definition.terrains]
    for name in _terrain_names(values.get("terrain")):
        if name in recorded_terms(values[TASK_FILE]).get("terrains", []) and name not in terrains:
            raise needs_file(f"this task has the terrain {short(name)}", file)
    for name, base in SECTIONS.items():
        if name != "terrain" and isinstance(section := kept.get(name), Mapping):
            kept[name] = known(section, section_type(base, definition, section))
    return kept


def flat(values: Mapping[str, Plain], path: str = "") -> dict[str, Plain]:
    """Return the nested values by their path, such as `reward.weights.upright`."""
    found: dict[str, Plain] = {}
    for name, value in values.items():
        found |= flat(value, f"{path}{name}.") if isinstance(value, Mapping) else {f"{path}{name}": value}
    return found


def CommandConfig(**values: Plain) -> CommandSection:  # noqa: N802  named like the class of a section
    """Return the distribution of the velocity commands, with the built-in task's fields."""
    return section_of(CommandSection, BUILT_IN, values)


def RewardConfig(**values: Plain) -> RewardSection:  # noqa: N802
    """Return the weights (per second) and parameters of the reward terms, with the built-in task's fields."""
    return section_of(RewardSection, BUILT_IN, values)


def TerminationConfig(**values: Plain) -> TerminationSection:  # noqa: N802
    """Return the parameters of the terminations, with the built-in task's fields."""
    return section_of(TerminationSection, BUILT_IN, values)


def RandomizationConfig(**values: Plain) -> RandomizationSection:  # noqa: N802
    """Return the randomization of episodes, with the built-in task's fields; `preset="hard"` starts from a preset."""
    return section_of(RandomizationSection, BUILT_IN, values)


def TerrainConfig(**values: Plain) -> TerrainSection:  # noqa: N802
    """Return a built-in terrain with its seed and parameters."""
    return section_of(TerrainSection, BUILT_IN, values)
