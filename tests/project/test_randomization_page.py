"""The tables of docs/randomization.md are those of the code."""

import re

import pytest
from paths import ROOT

from quadruped_env.envs.specification import markdown_table
from quadruped_env.task import BUILT_IN, PRESETS, RandomizationConfig
from quadruped_env.task.randomization.built_in_randomizations import RANDOMIZATIONS
from quadruped_env.task.randomization.randomization import is_active

PAGE = (ROOT / "docs" / "randomization.md").read_text()


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


def randomization_sources():
    """Lines of a Markdown table of what the ranges of the presets rest on."""
    return markdown_table(
        ("field", "source of the ranges"), ((f"`{entry.name}`", entry.source) for entry in RANDOMIZATIONS)
    )


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


@pytest.mark.parametrize("table", [randomization_table, randomization_sources, noise_table])
def test_table_of_the_page_is_that_of_the_code(table):
    lines = "\n".join(table())
    assert lines in PAGE, f"docs/randomization.md: replace its table by this one:\n\n{lines}\n"


def test_every_field_of_the_section_is_on_the_page():
    fields = set(RandomizationConfig())
    assert fields == {name for name in re.findall(r"`(\w+)`", PAGE) if name in fields}


@pytest.mark.parametrize("entry", BUILT_IN.randomizations, ids=lambda entry: entry.name)
def test_every_randomization_says_what_it_draws_and_what_its_ranges_rest_on(entry):
    assert entry.description
    assert entry.source
    assert "|" not in entry.description + entry.source


def test_every_preset_names_fields_of_the_section():
    for name in PRESETS:
        assert set(PRESETS[name]) <= set(RandomizationConfig())
