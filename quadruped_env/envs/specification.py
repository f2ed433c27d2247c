"""Tables in the environment's docstring, generated from the terms that they describe."""

from collections.abc import Iterable
from typing import Any, TypeVar

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import Terrain, Tiles
from quadruped_env.task import BUILT_IN, TerrainConfig

Class = TypeVar("Class", bound=type)


def with_tables(cls: Class) -> Class:
    """Replace `{observations}`, `{rewards}`, `{terminations}` and `{terrains}` in a docstring by tables in Markdown."""
    layout = ObservationLayout(MINI_QUADRUPED)
    observations = (
        (
            f"{columns.start}-{columns.stop - 1}",
            f"`{field.name}`",
            field.description.removesuffix("."),
            field.unit,
            f"{layout.scale[columns][0]:g}",
            f"+-{layout.high[columns][0]:g}",
        )
        for field, columns in zip(layout.fields, layout.slices.values(), strict=True)
    )
    rewards = (
        (f"`{name}`", term.described(name).removesuffix("."), term.unit, f"{weight:g}")
        for term in BUILT_IN.paid
        for name, weight in term.weights.items()
    )
    terrains = (
        (f"`{terrain.name}`", terrain.description.removesuffix("."), ", ".join(_terrain_fields(terrain)))
        for terrain in BUILT_IN.terrains
    )
    tables = {
        "observations": markdown_table(("columns", "name", "reading", "unit", "scale", "bounds"), observations),
        "rewards": markdown_table(("term", "value", "unit", "weight, 1/s"), rewards),
        "terminations": [f"* {term.description.removesuffix('.')}" for term in BUILT_IN.terminations],
        "terrains": markdown_table(("terrain", "ground", 'fields of `config["terrain"]`'), terrains),
    }
    if cls.__doc__ is not None:  # None with python -OO
        for name, lines in tables.items():
            cls.__doc__ = cls.__doc__.replace(f"{{{name}}}", "\n    ".join(lines))
    return cls


def _terrain_fields(terrain: Terrain) -> list[str]:
    """Fields of a terrain in the config, with their defaults."""
    if isinstance(terrain, Tiles):
        section = TerrainConfig(name=terrain.name)
        return [f"`{name}`" if name == "kinds" else f"`{name}` = {section[name]}" for name in section if name != "name"]
    level = ["`level`"] if terrain.hardest is not None else []
    return ["`seed` = 0", *level, *(f"`{name}` = {x:.3g} {p.unit}" for name, (p, x) in terrain.parameters.items())]


def markdown_table(header: tuple[str, ...], rows: Iterable[tuple[Any, ...]]) -> list[str]:
    """Lines of a Markdown table."""
    first, *others = [f"| {' | '.join(row)} |" for row in (header, *rows)]
    return [first, f"|{'---|' * len(header)}", *others]
