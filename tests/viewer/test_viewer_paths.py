"""Paths in the names of sources: without the directories of the machine."""

from pathlib import Path

import pytest

from quadruped_env import SinusoidalGait
from quadruped_env.evaluation.recorded_episode import publish
from quadruped_env.policies import find_controllers, load_policy
from quadruped_env.utils.files import shown_path


@pytest.mark.parametrize(
    ("path", "shown"),
    [
        ("runs/a", "runs/a"),
        ("../runs/a", "../runs/a"),
        ("{cwd}/runs/a", "runs/a"),
        ("/home/me/project/runs/a", "runs/a"),
        ("/volume/a.csv", "a.csv"),
        ("/a.csv", "a.csv"),
    ],
)
def test_shown_path_has_no_directory_of_the_machine(path, shown):
    assert shown_path(Path(path.format(cwd=Path.cwd()))) == shown


def test_sources_have_no_directory_in_their_names_and_different_ones_different_names(tmp_path):
    asked = []
    for directory in ("one", "two"):
        load_policy("flat").save(tmp_path / directory / "runs" / "best")
        publish(SinusoidalGait.preset("trot"), 1.0, 50.0).save(tmp_path / directory / "walk.csv")
        asked += [str(tmp_path / directory / "runs" / "best"), str(tmp_path / directory / "walk.csv")]
    _, chosen = find_controllers([*asked, asked[0]], runs=tmp_path / "none")
    assert chosen == (
        "run runs/best",
        "recording walk.csv",
        "run runs/best (2)",
        "recording walk.csv (2)",
        "run runs/best",
    )
