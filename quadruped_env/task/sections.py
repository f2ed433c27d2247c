"""Sections of a config whose fields depend on the task's definition: those that its terms and its terrain add."""

import functools
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Annotated, Any, Final

from quadruped_env.control.control_config import commands_for
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled, scaled_values
from quadruped_env.task.command_sampling import SIDEWAYS, CommandSection
from quadruped_env.task.randomization.randomization import NoiseAmplitude, RandomizationSection
from quadruped_env.task.randomization.randomization_presets import with_preset
from quadruped_env.task.task_definition import BUILT_IN, TaskDefinition
from quadruped_env.task.terms import RewardSection, RewardTerm, Termination, TerminationSection, Weights
from quadruped_env.task.terrain_section import TerrainSection, terrain_type
from quadruped_env.utils.fields import (
    Amplitude,
    Range,
    Section,
    SectionKind,
    extended,
    hints_of,
    unit_of,
    units_of,
    with_values,
)
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.plain import Plain, plain

SECTIONS: Final[Mapping[str, type[Section]]] = {
    "command": CommandSection,
    "reward": RewardSection,
    "termination": TerminationSection,
    "randomization": RandomizationSection,
    "terrain": TerrainSection,
}
"""The sections by name, without the fields that a definition adds."""

Own = tuple[str, Any, Plain]
"""Name, annotation and default of a field."""


def section_of(base: type[SectionKind], definition: TaskDefinition, values: Plain) -> SectionKind:
    """Return one of the `SECTIONS` with nested plain values; missing fields have their defaults.

    Raises:
        QuadrupedError: if a field is unknown or a value is not valid; the message names the field.
    """
    if issubclass(base, RandomizationSection):
        values = with_preset(values, definition.robot)
    return with_values(section_type(base, definition, values)(), values, base.path)


def section_type(base: type[SectionKind], definition: TaskDefinition, values: Plain) -> type[SectionKind]:
    """Return the dataclass of a section; for `terrain` it depends on the terrain and the level that the values name."""
    found: Any = terrain_type(definition, values) if issubclass(base, TerrainSection) else _types(definition)[base]
    return found


def values_for(values: Mapping[str, Plain], robot: Robot) -> dict[str, Plain]:
    """Return the nested values of a config for the built-in robot and its terms, as plain values for another robot.

    Numbers follow its size by their units; a preset is replaced by its values.

    Raises:
        QuadrupedError: if a section has an unknown field or names an unknown preset.
    """
    values = {**values}
    if "randomization" in values:
        values["randomization"] = with_preset(values["randomization"], BUILT_IN.robot)
    units: dict[str, Any] = {"clock_frequency": "Hz"}
    units |= {
        name: units_of(section_type(base, BUILT_IN, values[name])) for name, base in SECTIONS.items() if name in values
    }
    if "randomization" in units:
        units["randomization"] |= {entry.name: entry.scale(robot) for entry in BUILT_IN.randomizations}
    if "reward" in units:
        scale = BUILT_IN.with_robot(robot).weight_scale
        units["reward"]["weights"] |= {name: scale(term) for term in BUILT_IN.rewards for name in term.weights}
    return plain(scaled_values(values, units, robot))


@functools.cache
def _types(definition: TaskDefinition) -> dict[type[Section], type[Section]]:
    """Return the dataclass of every section but `terrain`."""
    robot = definition.robot
    command: list[Own] = [
        (entry.name, Annotated[Range, Parameter(entry.unit)], entry.range)
        for entry in commands_for(robot, definition.commands)
    ]
    if robot.moves_sideways:
        command += [(name, hint, scaled(default, scale_of(unit_of(hint), robot))) for name, hint, default in SIDEWAYS]
    units = {name: term.unit for term in definition.paid for name in term.names}
    weights = [
        (name, Annotated[float, Parameter("1" if units[name] == "1" else f"1/({units[name]})")], default)
        for name, default in definition.weights.items()
    ]
    noise = [
        (entry.name, Annotated[float, Parameter(entry.unit, 0.0)], _scaled(entry.noise, entry, entry.unit, definition))
        for entry in definition.observations
    ]
    own: dict[type[Section], list[Own]] = {
        CommandSection: command,
        RewardSection: [_nested(Weights, weights), *_parameters(definition.paid, definition)],
        TerminationSection: [*_parameters(definition.terminations, definition)],
        RandomizationSection: [*_settings(definition), _nested(NoiseAmplitude, noise)],
    }
    return {base: _type(base, fields, definition) for base, fields in own.items()}


def _type(base: type[Section], own: Iterable[Own], definition: TaskDefinition) -> type[Section]:
    """Return a section with the fields of terms, and with the defaults of its own ones for the robot."""
    fields: dict[str, tuple[Any, Plain]] = {}
    for name, hint in hints_of(base).items():
        default = getattr(base, name, None)
        if default is not None:
            fields[name] = hint, scaled(default, scale_of(unit_of(hint), definition.robot))
    for name, hint, default in own:
        there, present = fields.get(name, (hint, default))
        if base is not CommandSection and (unit_of(there), present) != (unit_of(hint), default):
            raise QuadrupedError(
                f"{base.path}: two terms have a field {name!r} with different defaults or units; rename one"
            )
        fields[name] = hint, default
    return extended(base, fields, functools.partial(section_of, base, definition))


def _nested(base: type[Section], own: Iterable[Own]) -> Own:
    """Return a section within a section, as its field."""
    section = extended(base, {name: (hint, default) for name, hint, default in own})
    return base.path.rpartition(".")[2], section, section()


def _parameters(terms: Iterable[RewardTerm | Termination], definition: TaskDefinition) -> Iterator[Own]:
    for term in terms:
        for name, (parameter, default) in term.parameters.items():
            yield name, Annotated[float, parameter], _scaled(default, term, parameter.unit, definition)


def _settings(definition: TaskDefinition) -> Iterator[Own]:
    """Return the range, interval and duration of every randomization."""
    for entry in definition.randomizations:
        factor, valid = definition.scale(entry, entry.unit), entry.valid
        if valid.unit != "s":  # a limit of the simulation
            valid = valid.scaled(max(factor, 1.0))  # for a small robot, too, what is possible is checked later
        kind = Amplitude if isinstance(entry.default, float) else Range | None
        yield entry.name, Annotated[kind, replace(valid, unit=entry.unit)], scaled(entry.default, factor)
        for times in (entry.interval, entry.duration):
            if times is not None:
                yield times[0], Annotated[Range, Parameter.positive("s")], _scaled(times[1], entry, "s", definition)


def _scaled(value: Plain, term: object, unit: str, definition: TaskDefinition) -> Plain:
    return scaled(value, definition.scale(term, unit))
