"""The tables of randomization in docs/environment.md equal the code's."""

import re

from paths import ROOT

from quadruped_env.envs.specification import markdown_table
from quadruped_env.task import BUILT_IN, PRESETS, RandomizationConfig
from quadruped_env.task.randomization.built_in_randomizations import RANDOMIZATIONS
from quadruped_env.task.randomization.randomization import is_active

PAGE = (ROOT / "docs" / "environment.md").read_text()


def randomization_table():
    """Lines of a Markdown table of the built-in randomizations with their laws and the ranges of the presets."""
    sections = [RandomizationConfig(preset=name) for name in PRESETS]
    rows = []
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
    return markdown_table(("field", "what is drawn", "law", "values", "unit", *(f"`{name}`" for name in PRESETS)), rows)


def noise_table():
    """Lines of a Markdown table of the noise of the built-in observations."""
    return markdown_table(
        ("field of `noise_amplitude`", "default", "unit"),
        ((f"`{entry.name}`", f"{entry.noise:g}", entry.unit) for entry in BUILT_IN.observations),
    )


def _setting(value):
    """A range as the pages write it."""
    if not is_active(value):
        return "off"
    if not isinstance(value, tuple):
        return f"+-{value:.4g}"
    low, high = value
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def test_tables_of_the_page_are_those_of_the_code():
    for table in (randomization_table, noise_table):
        lines = "\n".join(table())
        assert lines in PAGE, f"docs/environment.md: replace its table by this one:\n\n{lines}\n"


def test_every_field_of_the_section_is_on_the_page():
    fields = set(RandomizationConfig())
    assert fields == {name for name in re.findall(r"`(\w+)`", PAGE) if name in fields}


def test_every_randomization_says_what_it_draws_and_what_its_ranges_rest_on():
    for entry in BUILT_IN.randomizations:
        assert entry.description, entry.name
        assert entry.source, entry.name
        assert "|" not in entry.description + entry.source, entry.name
