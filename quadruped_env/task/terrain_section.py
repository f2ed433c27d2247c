"""Section `terrain` of the config, whose fields depend on the terrain that it names, its level and the robot."""

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Final, Self

from quadruped_env.errors import QuadrupedError
from quadruped_env.simulation.built_in_terrains import find_terrain, terrain_scale
from quadruped_env.simulation.terrain import FIELDS, LEVELS, Level, Terrain, Tiles
from quadruped_env.task.task_definition import TaskDefinition
from quadruped_env.utils.fields import Section, check, converted, extended, one_of, with_values
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.plain import Plain

DEFAULT_TERRAIN: Final = "flat"
Seed = Annotated[int, Parameter(low=0, high=2**32 - 1)]
Share = Annotated[float, Parameter(low=0.0, exclusive=True)]


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class TerrainSection(Section, path="config.terrain"):
    """Name, seed and parameters of the ground; each parameter of the terrain is a field of its name, too."""

    name: str = DEFAULT_TERRAIN
    seed: Seed = 0

    definition: ClassVar[TaskDefinition]
    """Definition that has the terrain."""

    def changes(self) -> dict[str, Plain]:
        """See `Section`; a terrain other than the default one is a change."""
        own = super().changes()
        return own if self.name == DEFAULT_TERRAIN else {"name": self.name, **own}

    def replace(self, **changes: Plain) -> Self:
        """See `Section`; another level sets the parameters that were not changed."""
        section: Any = terrain_section_of(self.definition, {**self.changes(), **changes})
        return section

    @property
    def ground(self) -> Terrain:
        """The terrain with its seed, level and parameters."""
        terrain, robot = find_terrain(self.name, self.definition.terrains), self.definition.robot
        parameters = {name: value for name, value in self.items() if name not in FIELDS}
        return terrain.variant(self.seed, self.get("level"), terrain_scale(terrain, robot), **parameters)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class TilesSection(TerrainSection):
    """Tiles of several kinds of terrain and levels, with or without a curriculum."""

    kinds: tuple[str, ...]
    """Name of the terrain of each line of tiles."""
    levels: Level
    """Number of levels."""
    curriculum: bool = False
    """True if the level of an env follows from what its robot has reached."""
    start_levels: Level = 5
    """Highest level at which an env begins with the curriculum."""
    promote_share: Share = 0.8
    """Share of the commanded distance with which an env is promoted to the next level."""
    demote_share: Share = 0.5
    """Share of the commanded distance below which an env is demoted."""

    def __post_init__(self) -> None:
        super().__post_init__()
        # Else a robot could be promoted and demoted at once.
        rule = f"at most promote_share ({self.promote_share:g})"
        check(self.demote_share <= self.promote_share, f"{self.path}.demote_share", self.demote_share, rule)

    @property
    def ground(self) -> Tiles:
        """See `TerrainSection`."""
        terrains, robot = self.definition.terrains, self.definition.robot
        tiles = find_terrain(self.name, terrains)
        assert isinstance(tiles, Tiles)
        found = [find_terrain(kind, terrains) for kind in self.kinds]
        kinds = [kind.variant(scale=terrain_scale(kind, robot)) for kind in found]
        return tiles.of(kinds, self.levels, self.seed, terrain_scale(tiles, robot))


def terrain_section_of(definition: TaskDefinition, values: Plain) -> TerrainSection:
    """Return the section with plain values; missing fields have their defaults.

    Raises:
        QuadrupedError: if a field is unknown or a value is not valid; the message names the field.
    """
    return with_values(terrain_type(definition, values)(), values, "config.terrain")


def terrain_type(definition: TaskDefinition, values: Plain) -> type[TerrainSection]:
    """Return the dataclass of the section for the terrain and the level that its values name.

    Raises:
        QuadrupedError: if there is no such terrain or level; the message names those that there are.
    """
    values = values if isinstance(values, Mapping) else {}
    terrain, level = find_terrain(values.get("name", DEFAULT_TERRAIN), definition.terrains), values.get("level")
    if level is not None and not isinstance(terrain, Tiles):
        if terrain.hardest is None:
            raise QuadrupedError(
                f"config.terrain.level: {terrain.name!r} has no levels; leave it out, or name one of "
                f"{', '.join(with_levels(definition.terrains))}"
            )
        level = converted(level, Level, "config.terrain.level")
    return _type(terrain, level, definition)


def with_levels(terrains: Sequence[Terrain]) -> list[str]:
    """Return the names of the terrains that have levels."""
    return [terrain.name for terrain in terrains if terrain.hardest is not None]


def values_of(terrain: Terrain) -> dict[str, Plain]:
    """Return the values of the section that describe a terrain, without its seed."""
    if isinstance(terrain, Tiles):
        return {"name": terrain.name, "kinds": [kind.name for kind in terrain.kinds], "levels": terrain.levels}
    return {"name": terrain.name, **({} if terrain.level is None else {"level": terrain.level}), **dict(terrain.values)}


@functools.cache
def _type(terrain: Terrain, level: int | None, definition: TaskDefinition) -> type[TerrainSection]:
    base: type[TerrainSection] = TerrainSection
    own: dict[str, tuple[Any, Plain]] = {"name": (str, terrain.name), "seed": (Seed, terrain.seed)}
    if isinstance(terrain, Tiles):
        base, valid = TilesSection, with_levels(definition.terrains)
        kinds = Annotated[tuple[str, ...], functools.partial(_kinds, valid)]
        own |= {"kinds": (kinds, tuple(kind.name for kind in terrain.kinds)), "levels": (Level, terrain.levels)}
    else:
        if terrain.hardest is not None:
            own["level"] = (Annotated[int | None, Parameter(low=1, high=LEVELS)], None)
        scale = terrain_scale(terrain, definition.robot)
        for name, value in terrain.defaults(level, scale).items():
            own[name] = (Annotated[float, terrain.parameter(name, scale)], value)
    section = extended(base, own, functools.partial(terrain_section_of, definition))
    section.definition = definition
    return section


def _kinds(valid: Sequence[str], value: Plain, path: str) -> tuple[str, ...]:
    listed = isinstance(value, (list, tuple)) and len(value) > 0
    check(listed, path, value, f"a list of one or more terrains with levels: {', '.join(valid)}")
    return tuple(one_of(kind, valid, path) for kind in value)
