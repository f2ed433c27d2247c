"""Levels and tiles in programs: `--level`, the live nodes, and training."""

import argparse
import json
from types import SimpleNamespace

import pytest

from quadruped_env.cli.common_options import add_evaluation_options, add_suite, evaluation_options, named_terrain
from quadruped_env.cli.main import main
from quadruped_env.evaluation.baseline import run_baseline
from quadruped_env.evaluation.comparison import compare
from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.node_options import chosen_terrain
from quadruped_env.policies import load_policy
from quadruped_env.simulation import find_terrain
from quadruped_env.task import TaskConfig


def parsed(arguments):
    parser = argparse.ArgumentParser()
    add_evaluation_options(parser, "")
    add_suite(parser, "")
    return parser.parse_args(arguments)


def test_level_option_gives_the_terrain_at_this_level_and_is_typed_again():
    chosen = parsed(["--terrain", "stairs", "--level", "4"])
    assert named_terrain(chosen) == find_terrain("stairs").variant(level=4)
    assert evaluation_options(chosen) == "--terrain stairs --level 4 --seeds 8 --seconds 20"
    hard = parsed(["--terrain", "stairs", "--randomization", "hard"])
    assert named_terrain(hard) == "stairs"
    assert evaluation_options(hard) == "--terrain stairs --randomization hard --seeds 8 --seconds 20"
    assert named_terrain(parsed([])) is None
    assert evaluation_options(parsed([])) == "--seeds 8 --seconds 20"


def test_comparison_and_baseline_on_a_level_run_on_its_ground():
    stairs = find_terrain("stairs").variant(level=2)
    comparison = compare(load_policy("flat"), 1, 2.0, [(0.4, 0.0)], terrain=stairs)
    assert {rollout.terrain for rollout in comparison.rollouts.values()} == {stairs}
    assert comparison.config.terrain.to_dict() == {"name": "stairs", "seed": 0, "level": 2, "height": 0.011, "run": 0.2}
    assert run_baseline(seconds=1.0, episodes=1, terrain=stairs).recording.terrain == stairs


@pytest.mark.parametrize("program", [["evaluate", "flat"], ["baseline"], ["view", "flat"], ["train"]])
def test_program_with_an_invalid_level_or_terrain_says_what_is_valid(program, capsys, tmp_path):
    for arguments, message in (
        (["--level", "4"], "--level: found 4 without --terrain; name the terrain, too"),
        (["--terrain", "stairs", "--level", "11"], "level must be a whole number from 1 to 10; found 11"),
        (["--terrain", "hills", "--level", "2"], "has no levels; leave it out"),
        (["--terrain", "swamp"], "terrain: 'swamp' is unknown; there are flat, rough, hills"),
    ):
        assert main([*program, *arguments, "-o", str(tmp_path / "out")]) == 2
        assert message in capsys.readouterr().err


def test_live_nodes_take_a_level(tmp_path, capsys):
    for typed in (["sim"], ["view"], ["walk"]):
        arguments = make_parser(only=typed[0]).parse_args([*typed, "--terrain", "slope", "--level", "6", "--seed", "3"])
        assert chosen_terrain(arguments) == find_terrain("slope").variant(3, level=6)
    assert main(["live", "walk", "--terrain", "slope", "--level", "12"]) == 2
    assert "terrain slope: level must be a whole number from 1 to 10; found 12" in capsys.readouterr().err


def test_training_on_tiles_records_kinds_levels_and_curriculum(tmp_path, monkeypatch):
    pytest.importorskip("stable_baselines3")
    gain = SimpleNamespace(table=str, verdict=str, episodes=2, seconds=20.0, is_better=True)
    monkeypatch.setattr("quadruped_env.cli.train.measure_learning", lambda *arguments: gain)
    budget = ["--timesteps", "64", "--num-envs", "8", "--n-steps", "8", "--batch-size", "32", "--hidden", "8"]
    shape = '{"terrain": {"name": "tiles", "kinds": ["stairs", "gaps"], "levels": 3, "curriculum": true}}'
    runs = tmp_path / "runs"
    assert main(["train", *budget, "--task", shape, "-o", str(runs)]) == 0
    terrain = json.loads((runs / "latest" / "config.json").read_text())["task"]["terrain"]
    assert (terrain["kinds"], terrain["levels"], terrain["curriculum"]) == (["stairs", "gaps"], 3, True)
    trained = load_policy(runs / "latest").config
    assert trained.terrain.to_dict() == TaskConfig.from_dict({"terrain": terrain}).terrain.to_dict()
    assert main(["train", "--resume", str(runs / "latest"), "--timesteps", "64", "-o", str(runs)]) == 0
    assert load_policy(runs / "latest").config == trained
    level = ["--terrain", "stairs", "--level", "4"]
    assert main(["train", *budget, *level, "-o", str(runs)]) == 0
    assert load_policy(runs / "latest").config.terrain.height == pytest.approx(0.022)
