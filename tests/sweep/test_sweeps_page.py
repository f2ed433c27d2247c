"""The page on sweeps: its space can be read, its files are those of a sweep."""

import re

from pages import FENCED
from paths import ROOT

from quadruped_env.sweep.search_space import parse_dimension, read_space
from quadruped_env.sweep.sweep_records import ERROR_FILE, RESULT_FILE, SWEEP_FILE, TRIAL_FILE
from quadruped_env.sweep.sweep_results import RESULTS_CSV, RESULTS_JSON
from quadruped_env.task import TaskConfig

PAGE = (ROOT / "docs" / "scaling.md").read_text()
TASK = TaskConfig().to_dict()


def blocks(language):
    return [block for found, block in FENCED.findall(PAGE) if found == language]


def test_space_of_the_page_can_be_read(tmp_path):
    (text,) = blocks("toml")
    path = tmp_path / "space.toml"
    path.write_text(text)
    assert [dimension.field for dimension in read_space(path, TASK)] == [
        "learning_rate",
        "hidden",
        "task.reward.weights.foot_slip",
    ]


def test_fields_of_the_table_can_vary():
    lines = re.findall(r"^\| `(\S+=\S+)` \|", PAGE, re.MULTILINE)
    assert len(lines) == 6
    for text in lines:
        parse_dimension(text, TASK)


def test_page_names_the_files_of_a_sweep():
    for name in (SWEEP_FILE, TRIAL_FILE, RESULT_FILE, ERROR_FILE, RESULTS_CSV, RESULTS_JSON, "report.html"):
        assert name in PAGE
