"""Tables in the environment's docstring, generated from the terms that they describe."""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import Terrain, Tiles
from quadruped_env.task import BUILT_IN, PRESETS, RandomizationConfig, TerrainConfig
from quadruped_env.task.randomization.built_in_randomizations import RANDOMIZATIONS
from quadruped_env.task.randomization.randomization import is_active

Class = TypeVar("Class", bound=type)


def with_tables(indent: int = 4) -> Callable[[Class], Class]:
    """Decorator that inserts the tables in place of `{observations}`, `{rewards}`, `{terminations}` and `{terrains}`.

    Args:
        indent: number of spaces before each line.
    """
    tables = {
        "observations": observation_table(),
        "rewards": reward_table(),
        "terminations": termination_list(),
        "terrains": terrain_table(),
    }

    def decorate(cls: Class) -> Class:
        if cls.__doc__ is not None:  # None with python -OO
            for name, lines in tables.items():
                cls.__doc__ = cls.__doc__.replace(f"{{{name}}}", f"\n{' ' * indent}".join(lines))
        return cls

    return decorate


def observation_table() -> list[str]:
    """Lines of a Markdown table of the built-in observations."""
    layout = ObservationLayout(MINI_QUADRUPED)
    return _table(
        ("columns", "name", "reading", "unit", "scale", "bounds"),
        (
            (
                f"{columns.start}-{columns.stop - 1}",
                f"`{field.name}`",
                _sentence(field.description),
                field.unit,
                f"{layout.scale[columns][0]:g}",
                f"+-{layout.high[columns][0]:g}",
            )
            for field, columns in zip(layout.fields, layout.slices.values(), strict=True)
        ),
    )


def reward_table() -> list[str]:
    """Lines of a Markdown table of the built-in reward terms."""
    return _table(
        ("term", "value", "unit", "weight, 1/s"),
        (
            (f"`{name}`", _sentence(term.described(name)), term.unit, f"{weight:g}")
            for term in BUILT_IN.rewards
            for name, weight in term.weights.items()
        ),
    )


def termination_list() -> list[str]:
    """Lines of a Markdown list of the built-in terminations."""
    return [f"* {_sentence(term.description)}" for term in BUILT_IN.terminations]


def terrain_table() -> list[str]:
    """Lines of a Markdown table of the built-in terrains."""
    return _table(
        ("terrain", "ground", 'fields of `config["terrain"]`'),
        (
            (
                f"`{terrain.name}`",
                _sentence(terrain.description),
                ", ".join(_terrain_fields(terrain)),
            )
            for terrain in BUILT_IN.terrains
        ),
    )


def _terrain_fields(terrain: Terrain) -> list[str]:
    """Fields of a terrain in the config, with their defaults."""
    if isinstance(terrain, Tiles):
        section = TerrainConfig(name=terrain.name)
        return [f"`{name}`" if name == "kinds" else f"`{name}` = {section[name]}" for name in section if name != "name"]
    level = ["`level`"] if terrain.hardest is not None else []
    return ["`seed` = 0", *level, *(f"`{name}` = {x:.3g} {p.unit}" for name, (p, x) in terrain.parameters.items())]


def randomization_table() -> list[str]:
    """Lines of a Markdown table of the built-in randomizations with their laws and the ranges of the presets."""
    sections = [RandomizationConfig(preset=name) for name in PRESETS]
    rows: list[tuple[str, ...]] = []
    for entry in RANDOMIZATIONS:
        values = str(entry.width) if isinstance(entry.width, int) else f"one per {entry.width.removesuffix('s')}"
        settings = (_setting(section[entry.name]) for section in sections)
        rows.append((f"`{entry.name}`", entry.description, entry.law.replace("_", "-"), values, entry.unit, *settings))
        for times, meaning in ((entry.interval, "time from one to the next"), (entry.duration, "duration")):
            name = f"`{times[0]}`" if times is not None else ""
            if times is not None and name not in [row[0] for row in rows]:
                settings = (_setting(section[times[0]]) for section in sections)
                rows.append((name, f"{meaning}", "uniform", "1", "s", *settings))
    noise = (_setting((section.observation_noise,) * 2) for section in sections)
    rows.append(("`observation_noise`", "factor on the noise of every field of the observation", "", "", "1", *noise))
    return _table(("field", "what is drawn", "law", "values", "unit", *(f"`{name}`" for name in PRESETS)), rows)


def randomization_sources() -> list[str]:
    """Lines of a Markdown table of what the ranges of the presets rest on."""
    return _table(("field", "source of the ranges"), ((f"`{entry.name}`", entry.source) for entry in RANDOMIZATIONS))


def noise_table() -> list[str]:
    """Lines of a Markdown table of the noise of the built-in observations."""
    return _table(
        ("field of `noise_amplitude`", "default", "unit"),
        ((f"`{entry.name}`", f"{entry.noise:g}", entry.unit) for entry in BUILT_IN.observations),
    )


def _setting(value: Any) -> str:
    """A range as the pages write it."""
    if not is_active(value):
        return "off"
    if not isinstance(value, tuple):
        return f"+-{value:.4g}"
    low, high = value
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def _table(header: tuple[str, ...], rows: Iterable[tuple[Any, ...]]) -> list[str]:
    first, *others = [f"| {' | '.join(row)} |" for row in (header, *rows)]
    return [first, f"|{'---|' * len(header)}", *others]


def _sentence(text: str) -> str:
    return text.removesuffix(".")
