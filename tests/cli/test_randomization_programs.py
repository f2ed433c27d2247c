"""`--randomization` in the programs: training, evaluation and comparison."""

import argparse

import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.cli import train
from quadruped_env.cli.main import make_parser
from quadruped_env.evaluation.comparison import compare
from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import PRESETS, RandomizationConfig, TaskConfig, preset_values
from quadruped_env.training import train as training
from quadruped_env.training.recipes import with_recipe


@pytest.mark.parametrize("program", ["train", "evaluate", "compare"])
def test_program_takes_the_presets_and_refuses_another_one(program, capsys):
    arguments, parser = [program, *(["flat", "other"] if program == "compare" else [])], make_parser(only=program)
    assert parser.parse_args(arguments).randomization is None
    for preset in PRESETS:
        assert parser.parse_args([*arguments, "--randomization", preset]).randomization == preset
    with pytest.raises(SystemExit):
        parser.parse_args([*arguments, "--randomization", "extreme"])
    message = capsys.readouterr().err
    assert "--randomization" in message
    assert all(name in message for name in ("'extreme'", *PRESETS))


@pytest.fixture
def asked(monkeypatch):
    """Settings of the trainings that the program would run."""

    trainings = []

    def stop(config, *arguments, **others):
        trainings.append(config)
        raise QuadrupedError("stopped")

    monkeypatch.setattr(training, "train", stop)
    return trainings


def run(*arguments):
    parser = argparse.ArgumentParser()
    train.add_arguments(parser)
    with pytest.raises(QuadrupedError, match="stopped"):
        train.run(parser.parse_args(arguments), argparse.Namespace(program="train", line="train"))


def test_training_gets_the_plain_values_of_a_preset(asked, tmp_path):
    run("--randomization", "hard", "-o", str(tmp_path))
    recipe = with_recipe({}, MINI_QUADRUPED).task
    assert asked[0].task == {**recipe, "randomization": preset_values("hard")}
    assert TaskConfig.from_dict(asked[0].task).randomization == RandomizationConfig(preset="hard")


def test_values_of_task_change_those_of_the_preset(asked, tmp_path):
    change = '{"randomization": {"payload": null}, "decimation": 5}'
    run("--randomization", "hard", "--task", change, "-o", str(tmp_path))
    config = TaskConfig.from_dict(asked[0].task)
    assert config.randomization == RandomizationConfig(preset="hard", payload=None)
    assert config.decimation == 5


def test_training_with_a_robot_of_a_file_gets_the_values_for_that_robot(asked, tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.robot import QuadrupedDesign\nROBOT = QuadrupedDesign(name='heavy', base_mass=6.2)\n"
    )
    run("--randomization", "hard", "--task", str(file), "-o", str(tmp_path))
    built_in = preset_values("hard")["payload"]
    np.testing.assert_allclose(asked[0].task["randomization"]["payload"], 2.0 * np.array(built_in))


def test_comparison_runs_all_controllers_with_the_preset():
    policy = load_policy("flat")
    plain, hard = (compare(policy, 1, 2.0, [(0.4, 0.0)], randomization=name) for name in ("none", "hard"))
    assert hard.config.randomization == RandomizationConfig(preset="hard")
    assert plain.config.randomization == RandomizationConfig()
    for name, rollout in hard.rollouts.items():
        assert (rollout.base_position != plain.rollouts[name].base_position).any(), name
    with pytest.raises(QuadrupedError, match="there is no preset 'extreme'"):
        compare(policy, 1, 2.0, [(0.4, 0.0)], randomization="extreme")
