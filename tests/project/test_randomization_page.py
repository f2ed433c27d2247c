"""The tables of docs/randomization.md are those of the code."""

import re

from paths import ROOT

from quadruped_env.envs.specification import noise_table, randomization_sources, randomization_table
from quadruped_env.task import BUILT_IN, RandomizationConfig

PAGE = (ROOT / "docs" / "randomization.md").read_text()


def test_tables_of_the_page_are_those_of_the_code():
    for table in (randomization_table, randomization_sources, noise_table):
        lines = "\n".join(table())
        assert lines in PAGE, f"docs/randomization.md: replace its table by this one:\n\n{lines}\n"


def test_every_field_of_the_section_is_on_the_page():
    fields = set(RandomizationConfig())
    assert fields == {name for name in re.findall(r"`(\w+)`", PAGE) if name in fields}


def test_every_randomization_says_what_it_draws_and_what_its_ranges_rest_on():
    for entry in BUILT_IN.randomizations:
        assert entry.description, entry.name
        assert entry.source, entry.name
        assert "|" not in entry.description + entry.source, entry.name
