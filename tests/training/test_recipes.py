"""Recipes: what they set, what options change, and what a run keeps of them."""

import dataclasses
import json

import pytest
from trainings import SMALL, learn

from quadruped_env.cli.main import make_parser
from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import RandomizationConfig, TaskConfig, load_task_file, preset_values
from quadruped_env.training import TrainConfig, recipes
from quadruped_env.training.algorithms import ALGORITHMS
from quadruped_env.training.recipes import RECIPES, Recipe
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE


def task_of(config):
    return TaskConfig.from_dict(config.task)


def test_flat_is_the_default(asked):
    assert asked() == asked("--recipe", "flat")
    assert dataclasses.replace(asked(), task={}) == TrainConfig()
    from_scratch = asked("--action-mode", "position")
    assert dataclasses.replace(from_scratch, action_mode="residual") == asked(), "the same settings in both modes"


@pytest.mark.parametrize("name", RECIPES)
def test_recipes_give_valid_trainings_and_tasks(asked, name):
    config = asked("--recipe", name)
    assert config.recipe == name
    task = task_of(config)
    for field, value in {**RECIPES[name].training, **RECIPES[name].ppo}.items():
        assert getattr(config, field) == value
    assert json.dumps(config.task), "plain values"
    task.compiled_model()


def test_recipes_are_what_their_names_say(asked):
    flat, walker = (task_of(asked("--recipe", name)) for name in ("flat", "walker"))
    default = TaskConfig()
    assert dataclasses.replace(flat, randomization=default.randomization) == default, "and nothing else"
    assert flat.randomization == RandomizationConfig(preset="moderate")
    assert (asked("--recipe", "flat").action_mode, asked("--recipe", "walker").action_mode) == ("residual", "position")
    assert (walker.terrain.name, walker.terrain.curriculum) == ("tiles", True)
    assert {*walker.terrain.kinds} == {*TaskConfig.from_dict({"terrain": {"name": "tiles"}}).terrain.kinds}
    # What robots have: each range holds that of `moderate`.
    for name, setting in RandomizationConfig(preset="moderate").items():
        if isinstance(setting, tuple) and "interval" not in name and "duration" not in name:
            low, high = walker.randomization[name]
            assert low <= setting[0], name
            assert setting[1] <= high, name
    assert walker.max_delay == 0.08
    assert walker.control_timestep * walker.observation_history * walker.clock_frequency == pytest.approx(0.5, abs=0.03)


def test_settings_of_ppo_are_not_those_of_another_algorithm(asked):
    ppo, sac = asked("--recipe", "walker"), asked("--recipe", "walker", "--algo", "sac")
    assert (ppo.timesteps, ppo.asymmetric_critic) == (sac.timesteps, sac.asymmetric_critic)
    for name, value in RECIPES["walker"].ppo.items():
        assert getattr(ppo, name) == value
        assert getattr(sac, name) == {**vars(TrainConfig()), **ALGORITHMS["sac"].defaults}[name]


def test_options_change_the_recipe(asked):
    change = '{"randomization": {"payload": null}, "decimation": 5}'
    config = asked("--recipe", "walker", "--timesteps", "99", "--no-asymmetric-critic", "--task", change)
    assert (config.timesteps, config.asymmetric_critic) == (99, False)
    task = task_of(config)
    expected = task_of(asked("--recipe", "walker")).randomization
    assert expected.payload is not None
    assert task.randomization == expected.replace(payload=None)
    assert task.decimation == 5
    again = asked("--task", change, "--task", '{"decimation": 6}')
    assert again.task["decimation"] == 6, "later changes take precedence"


@pytest.mark.parametrize(
    ("options", "randomization", "terrain"),
    [
        (("--randomization", "none"), RandomizationConfig(), "tiles"),
        (("--randomization", "hard"), RandomizationConfig(preset="hard"), "tiles"),
        (
            ("--randomization", "hard", "--task", '{"randomization": {"payload": null}}'),
            RandomizationConfig(preset="hard", payload=None),
            "tiles",
        ),
        (("--task", '{"randomization": "hard"}'), RandomizationConfig(preset="hard"), "tiles"),
        (("--task", '{"randomization": {"preset": "none"}}'), RandomizationConfig(), "tiles"),
        (("--terrain", "stairs", "--level", "2"), None, "stairs"),
        (("--task", '{"terrain": {"name": "steps"}}'), None, "steps"),
        (("--task", '{"terrain": {"levels": 3}}'), None, "tiles"),
    ],
)
def test_preset_or_terrain_replaces_that_of_the_recipe(asked, options, randomization, terrain):
    task = task_of(asked("--recipe", "walker", *options))
    assert task.randomization == (randomization or task_of(asked("--recipe", "walker")).randomization)
    assert task.terrain.name == terrain
    if "levels" in str(options):
        assert (task.terrain.levels, task.terrain.curriculum) == (3, True)


def test_recipe_for_another_robot_has_that_robots_values(asked, tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.robot import QuadrupedDesign\nROBOT = QuadrupedDesign(name='heavy', base_mass=6.2)\n"
    )
    for options in (("--recipe", "walker"), ("--randomization", "hard")):
        config, plain = asked(*options, "--task", str(file)), asked(*options)
        heavy, built_in = (one.task["randomization"]["payload"] for one in (config, plain))
        assert heavy == pytest.approx([2.0 * end for end in built_in])


def test_recipe_for_another_robot_asks_for_steps_of_its_size(asked, tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.robot import QuadrupedDesign\nROBOT = QuadrupedDesign(name='long', leg_length=0.25)\n"
    )
    config = asked("--recipe", "walker", "--task", str(file))
    scale = load_task_file(file).robot.stance_height / MINI_QUADRUPED.stance_height
    assert scale > 1.3
    assert config.task["reward"]["foot_lift"] == pytest.approx(scale * 0.015, rel=1e-5)


def test_help_lists_the_recipes_with_their_descriptions():
    program = make_parser(only="train")._subparsers._group_actions[0].choices["train"]
    (text,) = (action.help for action in program._actions if action.dest == "recipe")
    for name, entry in RECIPES.items():
        assert f"{name}: {entry.description}" in text
    assert text.endswith("(default: flat)")


def test_run_keeps_the_recipes_values_whatever_becomes_of_it(tmp_path, monkeypatch):
    """A recipe that is changed later does not change a run, and the card says which one it was."""
    task = {"randomization": preset_values("moderate"), "decimation": 5}
    run = learn(tmp_path, TrainConfig(recipe="walker", timesteps=64, task=task, checkpoint_seconds=1e6, **SMALL))
    document = json.loads((run / CONFIG_FILE).read_text())
    assert document["training"]["recipe"] == "walker"
    policy = load_policy(run)
    assert policy.card["recipe"] == "walker"
    monkeypatch.setattr(recipes, "RECIPES", {"walker": Recipe("other", task={"decimation": 2}), "flat": Recipe("flat")})
    parent = Parent.load(run)
    again = parent.resumed({})
    assert TaskConfig.from_dict(again.task).randomization == RandomizationConfig(preset="moderate")
    assert again.task["decimation"] == 5
