"""Fields of the config's section `terrain`, which depend on the terrain that it names, its level and the robot."""

import functools
from collections.abc import Mapping, Sequence
from typing import Final, NamedTuple, Self

from quadruped_env.control.control_config import check
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.simulation.built_in_terrains import find_terrain, terrain_scale
from quadruped_env.simulation.terrain import FIELDS, LEVELS, Terrain, Tiles
from quadruped_env.task.config_sections import Entry, Schema, Section, number, parameter_entry, seed_entry
from quadruped_env.task.task_definition import TaskDefinition
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.plain import Plain

DEFAULT_TERRAIN: Final = "flat"
_SHARE: Final = Parameter(low=0.0, exclusive=True)


class Choice(NamedTuple):
    """The fields that determine which other fields the section has, and their defaults."""

    name: Plain = DEFAULT_TERRAIN
    level: Plain = None

    @classmethod
    def of(cls, values: Plain) -> Self:
        """The choice in values of the section, which may be invalid."""
        if not isinstance(values, Mapping):
            return cls()
        return cls(values.get("name", DEFAULT_TERRAIN), values.get("level"))


def terrain_schema(choice: Choice, definition: TaskDefinition) -> Schema:
    """Fields of the section for a choice.

    Raises:
        QuadrupedError: if there is no such terrain or level; the message names those that there are.
    """
    terrain = find_terrain(choice.name, definition.terrains)
    if isinstance(terrain, Tiles):
        return _tiles_schema(terrain, definition)
    if choice.level is not None:
        if terrain.hardest is None:
            raise QuadrupedError(
                f"config.terrain.level: {terrain.name!r} has no levels; leave it out, or name one of "
                f"{', '.join(with_levels(definition.terrains))}"
            )
        _level(choice.level, "config.terrain.level")
    return _shape_schema(terrain, choice.level, terrain_scale(terrain, definition.robot))


def with_levels(terrains: Sequence[Terrain]) -> list[str]:
    """Names of the terrains that have levels."""
    return [terrain.name for terrain in terrains if terrain.hardest is not None]


def ground_of(section: Section, definition: TaskDefinition) -> Terrain:
    """The terrain that a section describes, with its seed, level and parameters."""
    terrain, robot = find_terrain(section["name"], definition.terrains), definition.robot
    scale = terrain_scale(terrain, robot)
    if isinstance(terrain, Tiles):
        found = [find_terrain(kind, definition.terrains) for kind in section["kinds"]]
        kinds = [kind.variant(scale=terrain_scale(kind, robot)) for kind in found]
        return terrain.of(kinds, section["levels"], section["seed"], scale)
    parameters = {name: value for name, value in section.items() if name not in FIELDS}
    return terrain.variant(section["seed"], section.get("level"), scale, **parameters)


def values_of(terrain: Terrain) -> dict[str, Plain]:
    """Values of the section that describe a terrain, without its seed."""
    if isinstance(terrain, Tiles):
        return {"name": terrain.name, "kinds": [kind.name for kind in terrain.kinds], "levels": terrain.levels}
    return {"name": terrain.name, **({} if terrain.level is None else {"level": terrain.level}), **dict(terrain.values)}


@functools.cache
def _shape_schema(terrain: Terrain, level: int | None, scale: float) -> Schema:
    own: dict[str, Entry] = {"name": _name_entry(terrain), "seed": seed_entry(terrain.seed)}
    if terrain.hardest is not None:
        own["level"] = Entry(None, _level)
    defaults = terrain.defaults(level, scale)
    return own | {name: parameter_entry(terrain.parameter(name, scale), value) for name, value in defaults.items()}


@functools.cache
def _tiles_schema(tiles: Tiles, definition: TaskDefinition) -> Schema:
    valid = with_levels(definition.terrains)

    def kinds(value: Plain, path: str) -> tuple[str, ...]:
        if not isinstance(value, (list, tuple)) or not value:
            raise QuadrupedError(
                f"{path}: expected a list of one or more terrains with levels; found {short(value)}; valid are "
                f"{', '.join(valid)}"
            )
        for kind in value:
            if kind not in valid:
                raise QuadrupedError(
                    f"{path}: {short(kind)} is not a terrain with levels; valid are {', '.join(valid)}"
                )
        return tuple(value)

    def switch(value: Plain, path: str) -> bool:
        if not isinstance(value, bool):
            raise QuadrupedError(f"{path}: expected true or false; found {short(value)}")
        return value

    return {
        "name": _name_entry(tiles),
        "seed": seed_entry(tiles.seed),
        "kinds": Entry(tuple(kind.name for kind in tiles.kinds), kinds),
        "levels": Entry(tiles.levels, _level),
        "curriculum": Entry(False, switch),
        "start_levels": Entry(5, _level),
        "promote_share": parameter_entry(_SHARE, 0.8),
        "demote_share": parameter_entry(_SHARE, 0.5),
    }


def _name_entry(terrain: Terrain) -> Entry:
    def name(value: Plain, path: str) -> str:
        if value != terrain.name:
            raise QuadrupedError(
                f"{path}: this section is for {terrain.name!r}; found {short(value)}; make a new section, or use "
                f"TaskConfig.on_terrain"
            )
        return terrain.name

    return Entry(DEFAULT_TERRAIN, name)


def _level(value: Plain, path: str) -> int | None:
    """Convert a level; None is valid only where it is the default."""
    if value is None and path.endswith(".level"):
        return None
    level = int(number(value, path, whole=True))
    check(1 <= level <= LEVELS, path.removeprefix("config."), level, f"a whole number from 1 to {LEVELS}")
    return level
