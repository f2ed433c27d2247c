"""Config of the task: frozen, validated, printable, and saved with every run.

The fields of the sections `command`, `reward`, `termination`, `randomization` and `terrain` are the parameters of the
task's terms, so they depend on the task's definition (`quadruped_env.task.task_definition`). The other sections are
dataclasses.
"""

import dataclasses
import functools
import typing
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Final, Literal, Self

import mujoco
import numpy as np

from quadruped_env.control.clock import FIELD as CLOCK
from quadruped_env.control.clock import UNITS as CLOCK_UNITS
from quadruped_env.control.clock import CommandedFrequency, Frequency, frequency_of
from quadruped_env.control.control_config import (
    COMMAND_RATE,
    COMMAND_RATE_UNITS,
    ActionConfig,
    Command,
    ControlConfig,
    check,
    check_history,
    check_rates,
    clock_frequency,
    command_rate,
    commands_for,
)
from quadruped_env.control.task_file import TASK_FILE, needs_file, recorded_file, recorded_terms
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.motors import MOTOR_PRESETS, MotorConfig
from quadruped_env.robot.robot import Robot, check_same_robot
from quadruped_env.robot.units import scale_of, scaled, scaled_values
from quadruped_env.simulation import build_model
from quadruped_env.simulation.terrain import Terrain
from quadruped_env.task.config_sections import (
    Entry,
    Schema,
    Section,
    amplitude_entry,
    number,
    pair,
    parameter_entry,
    range_entry,
    section_entry,
    units_of,
)
from quadruped_env.task.randomization.model_fields import ModelField
from quadruped_env.task.randomization.randomization import ends_of, is_active
from quadruped_env.task.randomization.randomization_presets import PRESET, preset_values, with_preset
from quadruped_env.task.task_definition import BUILT_IN, TaskDefinition
from quadruped_env.task.terrain_section import Choice, ground_of, terrain_schema, values_of
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.plain import Plain, PlainFields, plain
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile

ROBOT: Final = "robot"
"""Field of a config's plain values that names the robot, if it is not the built-in one."""

_POSITIVE_SECONDS: Final = Parameter.positive("s")
_OF_THE_DEFINITION: Final[Plain] = None
"""Default of the fields whose defaults depend on the task's definition."""


@functools.cache
def _schemas(definition: TaskDefinition) -> dict[str, Schema]:
    """Fields of the sections that depend on the task's definition."""
    robot = definition.robot
    seconds = scale_of("s", robot)
    commands = commands_for(robot, definition.commands)
    command: dict[str, Entry] = {entry.name: Entry(entry.range, pair, entry.unit) for entry in commands} | {
        "standing_fraction": parameter_entry(Parameter(low=0.0), 0.1),
        "straight_fraction": parameter_entry(Parameter(low=0.0), 0.25),
        "turning_fraction": parameter_entry(Parameter(low=0.0), 0.15),
        "resample_interval": range_entry(scaled((1.0, 5.0), seconds), _POSITIVE_SECONDS),
    }
    for name, unit, rate in zip(COMMAND_RATE, COMMAND_RATE_UNITS, command_rate(robot), strict=True):
        command[name] = parameter_entry(Parameter.positive(unit), rate)
    units = {name: term.unit for term in definition.rewards for name in term.names}
    weights = {
        name: Entry(default, number, "1" if units[name] == "1" else f"1/({units[name]})")
        for name, default in definition.weights.items()
    }
    reward: dict[str, Entry] = {
        "weights": section_entry("reward.weights", weights),
        "velocity_time_constant": parameter_entry(_POSITIVE_SECONDS, scaled(0.4, seconds)),
        "contact_threshold": parameter_entry(Parameter("N", 0.0), scaled(1.0, scale_of("N", robot))),
    }
    termination: dict[str, Entry] = {}
    for section, terms in ((reward, definition.rewards), (termination, definition.terminations)):
        for term in terms:
            for name, (parameter, default) in term.parameters.items():
                entry = parameter_entry(parameter, scaled(default, definition.scale(term, parameter.unit)))
                if name in section and (section[name].default, section[name].unit) != (entry.default, entry.unit):
                    raise QuadrupedError(
                        f"config: two terms have a parameter {name!r} with different defaults or units; rename one"
                    )
                section.setdefault(name, entry)
    randomization: dict[str, Entry] = {}
    for entry_ in definition.randomizations:
        factor = definition.scale(entry_, entry_.unit)
        setting, valid = scaled(entry_.default, factor), entry_.valid
        if valid.unit != "s":  # a limit of the simulation
            valid = valid.scaled(max(factor, 1.0))  # for a small robot, too, what is possible is checked later
        randomization[entry_.name] = (
            amplitude_entry(setting, entry_.unit, valid)
            if isinstance(setting, (int, float))
            else range_entry(setting, replace(valid, unit=entry_.unit), optional=True)
        )
        for times in (entry_.interval, entry_.duration):
            if times is None:
                continue
            default = scaled(times[1], definition.scale(entry_, "s"))
            if times[0] in randomization and randomization[times[0]].default != default:
                raise QuadrupedError(
                    f"config: two randomizations have a field {times[0]!r} with different defaults; rename one"
                )
            randomization.setdefault(times[0], range_entry(default, _POSITIVE_SECONDS))
    randomization["observation_noise"] = parameter_entry(Parameter(low=0.0), 0.0)
    amplitudes: dict[str, Entry] = {
        entry.name: parameter_entry(
            Parameter(entry.unit, 0.0), scaled(entry.noise, definition.scale(entry, entry.unit))
        )
        for entry in definition.observations
    }
    randomization["noise_amplitude"] = section_entry("randomization.noise_amplitude", amplitudes)
    return {"command": command, "reward": reward, "termination": termination, "randomization": randomization}


def _schema(name: str, choice: Choice, definition: TaskDefinition) -> Schema:
    """Fields of a section."""
    return terrain_schema(choice, definition) if name == "terrain" else _schemas(definition)[name]


def _terrain_names(section: Plain) -> list[Plain]:
    """The terrains that a section of plain values names, itself or as kinds of its tiles."""
    values = section if isinstance(section, Mapping) else {}
    kinds = values.get("kinds")
    return [values.get("name"), *(kinds if isinstance(kinds, (list, tuple)) else ())]


def _terrains_of_file(recorded: Plain, section: Plain, definition: TaskDefinition) -> list[Terrain]:
    """The terrains that a section names and that are from a user's file, as they must be if one is recorded."""
    names = _terrain_names(section)
    found = [entry for entry in definition.terrains if entry.name in names and entry.file is not None]
    file = recorded_file(recorded, TERRAIN_FILE)
    if file is not None and not found:
        raise needs_file(f"this task has the terrain {short(names[0])}", file)
    return found


def _defaults(definition: TaskDefinition) -> dict[str, Plain]:
    """Default of every field of the sections that depend on the task's terms, by its path (see `flat`)."""
    schemas = _schemas(definition).items()
    return flat({section: {name: entry.default for name, entry in schema.items()} for section, schema in schemas})


def known_values(values: Mapping[str, Plain], definition: TaskDefinition) -> dict[str, Plain]:
    """Plain values of a config without the user's file that they name, and without terms that a definition lacks.

    So a run's numbers count with any version of its file, or without the file.

    Raises:
        QuadrupedError: if the values name a terrain of the file, and the definition lacks it.
    """
    file, present = recorded_file(values.get(TASK_FILE)), definition.file
    if file is None or (present is not None and present.sha256 == file.sha256):
        return {name: value for name, value in values.items() if name != TASK_FILE}
    terrains = [entry.name for entry in definition.terrains]
    for name in _terrain_names(values.get("terrain")):
        if name in recorded_terms(values[TASK_FILE]).get("terrains", []) and name not in terrains:
            raise needs_file(f"this task has the terrain {short(name)}", file)
    known, schemas = _defaults(definition), _schemas(definition)

    def kept(section: Mapping[str, Plain], path: str) -> dict[str, Plain]:
        return {
            name: kept(value, f"{path}.{name}") if isinstance(value, Mapping) else value
            for name, value in section.items()
            if isinstance(value, Mapping) or f"{path}.{name}" in known
        }

    return {
        name: kept(value, name) if name in schemas and isinstance(value, Mapping) else value
        for name, value in values.items()
        if name != TASK_FILE
    }


def flat(values: Mapping[str, Plain], path: str = "") -> dict[str, Plain]:
    """Nested values by their path, such as `reward.weights.upright`."""
    found: dict[str, Plain] = {}
    for name, value in values.items():
        found |= flat(value, f"{path}{name}.") if isinstance(value, Mapping) else {f"{path}{name}": value}
    return found


def _sections(definition: TaskDefinition) -> tuple[str, ...]:
    """Names of the sections that depend on the task's definition."""
    return (*_schemas(definition), "terrain")


def _known(values: dict[str, Plain], schema: Schema) -> dict[str, Plain]:
    """The values of a section that another schema has, too."""
    return {name: value for name, value in values.items() if name in schema}


def _section(name: str, values: Plain, definition: TaskDefinition) -> Section:
    return _remade(name, definition, Choice.of(values).name, values)


def _remade(name: str, definition: TaskDefinition, terrain: Plain, values: Plain) -> Section:
    """A section of the config; that of a terrain stays one of this terrain when it is changed."""
    schema = _schema(name, Choice.of(values)._replace(name=terrain), definition)
    if name == "randomization":
        values = with_preset(values, definition.robot)
    section = Section(name, schema, values, functools.partial(_remade, name, definition, terrain))
    if name == "command":
        shares = section.standing_fraction + section.straight_fraction + section.turning_fraction
        check(shares <= 1, "command.standing_fraction + straight_fraction + turning_fraction", shares, "at most 1")
    elif "promote_share" in section:  # else a robot could be promoted and demoted at once
        demote, promote = section.demote_share, section.promote_share
        check(demote <= promote, "terrain.demote_share", demote, f"at most promote_share ({promote:g})")
    return section


def values_for(values: Mapping[str, Plain], robot: Robot) -> dict[str, Plain]:
    """Nested values of a config for the built-in robot and its terms, as plain values for another robot.

    Numbers follow its size by their units; a preset is replaced by its values.

    Raises:
        QuadrupedError: if a section has an unknown field or names an unknown preset.
    """
    values = {**values}
    if "randomization" in values:
        values["randomization"] = with_preset(values["randomization"], BUILT_IN.robot)
    units: dict[str, Plain] = {CLOCK: CLOCK_UNITS if isinstance(values.get(CLOCK), Mapping) else "Hz"}
    for name in set(values) & set(_sections(BUILT_IN)):
        units[name] = units_of(_schema(name, Choice.of(values[name]), BUILT_IN))
    return plain(scaled_values(values, units, robot))


def CommandConfig(**values: Plain) -> Section:  # noqa: N802  named like the class of a section
    """Distribution of the velocity commands, with the built-in task's fields."""
    return _section("command", values, BUILT_IN)


def RewardConfig(**values: Plain) -> Section:  # noqa: N802
    """Weights (per second) and parameters of the reward terms, with the built-in task's fields."""
    return _section("reward", values, BUILT_IN)


def TerminationConfig(**values: Plain) -> Section:  # noqa: N802
    """Parameters of the terminations, with the built-in task's fields."""
    return _section("termination", values, BUILT_IN)


def RandomizationConfig(**values: Plain) -> Section:  # noqa: N802
    """Randomization of episodes, with the built-in task's fields; `preset="hard"` starts from a preset."""
    return _section("randomization", values, BUILT_IN)


def TerrainConfig(**values: Plain) -> Section:  # noqa: N802
    """A built-in terrain with its seed and parameters."""
    return _section("terrain", values, BUILT_IN)


@dataclass(frozen=True)
class TaskConfig(PlainFields):
    """Complete config of a task."""

    decimation: int = 4
    """Physics steps per control step."""
    physics_timestep: float = 0.005
    """Physics time step, s."""
    clock_frequency: Frequency = _OF_THE_DEFINITION
    """Frequency of the gait clock and, in residual mode, of the scripted gait, Hz; or a `CommandedFrequency`. Default:
    3.4 Hz for the built-in robot, and in its units for others."""
    observation_history: int = 3
    """Number of control steps whose observations are stacked into one, the latest first; 1: only the present one."""
    action: ActionConfig = field(default_factory=ActionConfig)
    command: Section = _OF_THE_DEFINITION
    reward: Section = _OF_THE_DEFINITION
    termination: Section = _OF_THE_DEFINITION
    randomization: Section = _OF_THE_DEFINITION
    motor: MotorConfig = _OF_THE_DEFINITION
    """Motors of the robot, those of `mini-quadruped identify`, or the name of one of `MOTOR_PRESETS` in plain values.
    Default: those of the definition's robot."""
    terrain: Section = _OF_THE_DEFINITION
    """Name, seed and parameters of the ground."""
    definition: TaskDefinition = field(default=BUILT_IN, repr=False)
    """Robot and terms of the task; `load_task_file` adds those of a user's file."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.motor is None:
            object.__setattr__(self, "motor", self.robot.motors)
        if self.clock_frequency is None:
            object.__setattr__(self, "clock_frequency", clock_frequency(self.robot))
        check_rates(self.decimation, self.physics_timestep)
        object.__setattr__(self, "clock_frequency", frequency_of(self.clock_frequency))
        check_history(self.observation_history)
        for name in _sections(self.definition):
            section = getattr(self, name)
            schema = _schema(name, Choice.of(section), self.definition)
            if section is None or section.schema is not schema:
                # A section of the built-in task, in a task with other terms or another robot: its numbers stay.
                values = {} if section is None else _known(section.to_dict(), schema)
                object.__setattr__(self, name, _section(name, values, self.definition))

    @property
    def file(self) -> TaskFile | None:
        """The user's file of the terms or the robot, or else of the terrain; None for what is built in."""
        return self.definition.file or self.ground.file

    @property
    def robot(self) -> Robot:
        """Robot of the task."""
        return self.definition.robot

    def with_definition(self, definition: TaskDefinition) -> Self:
        """A copy with other terms or another robot, whose motors and defaults replace those of the old one."""
        motor = _OF_THE_DEFINITION if self.motor == self.robot.motors else self.motor
        clock = _OF_THE_DEFINITION if self.clock_frequency == clock_frequency(self.robot) else self.clock_frequency
        sections: dict[str, Plain] = {}
        for name in _sections(definition):
            section = getattr(self, name)
            changes = _known(section.changes(), _schema(name, Choice.of(section), definition))
            sections[name] = _section(name, changes, definition)
        return dataclasses.replace(self, motor=motor, clock_frequency=clock, definition=definition, **sections)

    def for_robot(self, robot: Robot) -> Self:
        """A copy for another robot; see `with_definition`."""
        return self.with_definition(self.definition.with_robot(robot))

    @property
    def control_timestep(self) -> float:
        """Time between actions, s."""
        return self.physics_timestep * self.decimation

    @property
    def ground(self) -> Terrain:
        """The terrain with its seed and parameters, for `build_model`."""
        return ground_of(self.terrain, self.definition)

    def on_terrain(self, terrain: str | Terrain, seed: int | None = None) -> Self:
        """A copy of the config on another terrain; the terrain that it already has keeps its level and parameters.

        Args:
            terrain: name of a terrain of the task's definition, or any terrain; it may be a variant.
            seed: seed of the terrain; None keeps that of the config.

        Raises:
            QuadrupedError: if there is no such terrain; the message names those that there are.
        """
        if isinstance(terrain, Terrain):
            with_it = dataclasses.replace(self, definition=self.definition.with_terrain(terrain))
            on_it = with_it.on_terrain(terrain.name, seed if seed is not None else terrain.seed or None)
            values = values_of(terrain)
            if "level" in values:  # which replaces the parameters that it has
                section = _section("terrain", {"seed": on_it.terrain["seed"], **values}, on_it.definition)
            else:
                section = on_it.terrain.replace(**values)
            return dataclasses.replace(on_it, terrain=section)
        name = terrain
        kept = self.terrain.changes() if name == self.terrain["name"] else {"seed": self.terrain["seed"]}
        values = {**kept, "name": name, **({} if seed is None else {"seed": seed})}
        return dataclasses.replace(self, terrain=_section("terrain", values, self.definition))

    def without_randomization(self) -> Self:
        """A copy of the config without randomizations, a user's own included, and without observation noise."""
        off = dict.fromkeys(entry.name for entry in self.definition.randomizations)
        return self._with_randomization({**off, "observation_noise": 0.0})

    def randomized(self, preset: str) -> Self:
        """A copy with a preset in place of the config's randomization: `none`, `moderate` or `hard`.

        A user's own randomizations are off, and so is one that replaces a built-in one.

        Raises:
            QuadrupedError: if there is no such preset.
        """
        own = (entry.name for entry in self.definition.randomizations if entry not in BUILT_IN.randomizations)
        return self._with_randomization({**preset_values(preset, self.robot), **dict.fromkeys(own)})

    def _with_randomization(self, values: Mapping[str, Plain]) -> Self:
        return dataclasses.replace(self, randomization=_section("randomization", values, self.definition))

    @property
    def max_delay(self) -> float:
        """Longest delay from joint target to motor that the config allows, s."""
        delays = [self.motor.delay]
        for entry in self.definition.randomizations:
            setting = self.randomization[entry.name]
            for part in entry.apply if isinstance(entry.apply, tuple) else (entry.apply,):
                if isinstance(part, ModelField) and part.field == "actuator_delay" and is_active(setting):
                    delays += [float(part.changed(np.array(delays[-1]), end)) for end in ends_of(setting)]
        return max(delays)

    def compiled_model(self) -> mujoco.MjModel:
        """Compiled model of the task's robot on its terrain; every call returns a new copy."""
        return build_model(self.physics_timestep, self.motor, self.ground, self.robot, max_delay=self.max_delay)

    @property
    def control(self) -> ControlConfig:
        """Part of the config that training and a real robot share."""
        return ControlConfig(
            timestep=self.control_timestep,
            clock_frequency=self.clock_frequency,
            observation_history=self.observation_history,
            action=self.action,
            command_rate=tuple(self.command[name] for name in COMMAND_RATE),
            commands=self.commands,
        )

    @property
    def commands(self) -> tuple[Command, ...]:
        """Components of the command, the velocities first."""
        return tuple(dataclasses.replace(entry, range=self.command[entry.name]) for entry in self.definition.commands)

    def to_dict(self) -> dict[str, Plain]:
        """Nested plain values for `from_dict` and JSON; user's files and robots are given by name and SHA-256."""
        values: dict[str, Plain] = {}
        for entry in dataclasses.fields(self):
            value = getattr(self, entry.name)
            if isinstance(value, Section):
                values[entry.name] = value.to_dict()
            elif isinstance(value, TaskDefinition):
                if value.file is not None:
                    values[TASK_FILE] = {**value.file.to_dict(), "terms": value.own_terms()}
                terrain_file = self.ground.file
                if terrain_file is not None and terrain_file != value.file:
                    values[TERRAIN_FILE] = terrain_file.to_dict()
                if value.robot != BUILT_IN.robot:
                    values[ROBOT] = value.robot.identity
            elif dataclasses.is_dataclass(value) and not isinstance(value, type):
                values[entry.name] = dataclasses.asdict(value)
            else:
                values[entry.name] = value
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
        if isinstance(values, dict):
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
        return _build(cls, values, "config", definition)


_type_hints = functools.cache(typing.get_type_hints)


def _build(kind: type, values: Plain, path: str, definition: TaskDefinition) -> Plain:
    """An instance of a config dataclass from nested plain values; `path` names it in errors."""
    if not isinstance(values, dict):
        raise QuadrupedError(f"{path}: expected a mapping of fields; found {short(values)}")
    hints = {name: hint for name, hint in _type_hints(kind).items() if hint is not TaskDefinition}
    unknown = sorted(str(name) for name in set(values) - set(hints))
    if unknown:
        raise QuadrupedError(f"{path}: unknown field {short(unknown[0])}; valid fields are {', '.join(hints)}")
    fields: dict[str, Plain] = {}
    for name, hint in hints.items():
        if hint is Section:
            fields[name] = _section(name, values.get(name, {}), definition)
        elif hint is MotorConfig:
            fields[name] = _motor(values.get(name, {}), f"{path}.{name}", definition)
        elif name in values:
            fields[name] = _convert(hint, values[name], f"{path}.{name}", definition)
    return kind(**fields, definition=definition) if kind is TaskConfig else kind(**fields)


def _motor(values: Plain, path: str, definition: TaskDefinition) -> MotorConfig:
    """Motors whose missing fields are those of the robot, or of the preset that the values name."""
    base = definition.robot.motors
    if isinstance(values, str):
        values = {PRESET: values}
    if isinstance(values, dict) and PRESET in values:
        name = values[PRESET]
        if not isinstance(name, str) or name not in MOTOR_PRESETS:
            raise QuadrupedError(
                f"{path}: there is no preset {short(name)}; valid names are {', '.join(MOTOR_PRESETS)}"
            )
        base = MOTOR_PRESETS[name]
        values = {field: value for field, value in values.items() if field != PRESET}
    default = dataclasses.asdict(base)
    if isinstance(values, dict):
        values = {**default, **values}
        for kind, motor in values.items():
            if isinstance(motor, dict) and isinstance(default.get(kind), dict):
                values[kind] = {**default[kind], **motor}
    motors: MotorConfig = _build(MotorConfig, values, path, definition)
    return motors


def _convert(hint: object, value: Plain, path: str, definition: TaskDefinition) -> Plain:
    if dataclasses.is_dataclass(hint):
        assert isinstance(hint, type)
        return _build(hint, value, path, definition)
    if hint == Frequency:
        if isinstance(value, Mapping):
            arm = scaled(CommandedFrequency.turn_arm, scale_of(CLOCK_UNITS["turn_arm"], definition.robot))
            value = {"turn_arm": arm, **value}
        return frequency_of(value)
    if typing.get_origin(hint) is Literal:
        return value
    return number(value, path, whole=hint is int)
