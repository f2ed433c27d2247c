"""The tables of docs/randomization.md are those of the code."""

import re

import pytest
from paths import ROOT

from quadruped_env.envs.specification import noise_table, randomization_sources, randomization_table
from quadruped_env.task import BUILT_IN, PRESETS, RandomizationConfig

PAGE = (ROOT / "docs" / "randomization.md").read_text()


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
