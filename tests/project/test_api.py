"""The programs as functions of the package: `train`, `evaluate`, `compare` and `page`."""

import json

import pytest

import quadruped_env
from quadruped_env import QuadrupedError, compare, evaluate, load_policy, page, train
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.training.recipes import with_recipe

SMALL = {"num_envs": 2, "n_steps": 8, "batch_size": 16, "timesteps": 32}


def test_names_are_functions():
    assert all(callable(getattr(quadruped_env, function.__name__)) for function in (compare, evaluate, page, train))


@pytest.mark.parametrize("recipe", ["flat", "walker"])
def test_training_has_the_settings_of_the_recipe_as_on_the_command_line(recipe, tmp_path):
    run = train(tmp_path, recipe=recipe, **SMALL)
    config = json.loads((run / "config.json").read_text(encoding="utf-8"))
    expected = with_recipe({"recipe": recipe, **SMALL}, MINI_QUADRUPED)
    assert config["training"]["task"] == json.loads(json.dumps(expected.task))
    assert config["training"]["action_mode"] == expected.action_mode
    assert config["command"].startswith(f"quadruped_env.train(recipe={recipe!r}, num_envs=2")
    assert json.loads(json.dumps(load_policy(run).config.to_dict())) == config["task"]
    with pytest.raises(QuadrupedError, match=r"training: unknown field 'timestep'.*did you mean timesteps"):
        train(tmp_path, timestep=1)


@pytest.mark.slow
def test_evaluation_writes_and_shows_what_it_measured(tmp_path, capsys):
    found = evaluate("flat", tmp_path / "out", seeds=2, seconds=2.0, with_video=False)
    numbers = json.loads(found.numbers.read_text(encoding="utf-8"))
    assert numbers == json.loads(json.dumps(found.document))
    assert numbers["seeds"] == list(found.comparison.seeds)
    text = str(found)
    assert "Forwards: velocity error (m/s)" in text
    assert found.gain.table() in text
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"metrics.json", "report.html", "walk.html"}
    assert "report.html" in capsys.readouterr().out


def test_page_of_a_shipped_policy(tmp_path):
    assert page("flat", tmp_path / "mine.html").stat().st_size > 1_000_000
