"""`--randomization` in the programs: training, evaluation and comparison."""

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import make_parser
from quadruped_env.evaluation.comparison import compare
from quadruped_env.policies import load_policy
from quadruped_env.task import PRESETS, RandomizationConfig


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


def test_comparison_runs_all_controllers_with_the_preset():
    policy = load_policy("flat")
    plain, hard = (compare(policy, 1, 2.0, [(0.4, 0.0)], randomization=name) for name in ("none", "hard"))
    assert hard.config.randomization == RandomizationConfig(preset="hard")
    assert plain.config.randomization == RandomizationConfig()
    for name, rollout in hard.rollouts.items():
        assert (rollout.base_position != plain.rollouts[name].base_position).any(), name
    with pytest.raises(QuadrupedError, match=r"config.randomization must be one of .*'extreme'"):
        compare(policy, 1, 2.0, [(0.4, 0.0)], randomization="extreme")
