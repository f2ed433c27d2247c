"""Settings of a training: defaults, and the values that are refused."""

import math
from typing import get_args

import pytest
from settings import TRAINING

from quadruped_env import QuadrupedError
from quadruped_env.policies.activations import ACTIVATIONS
from quadruped_env.training.algorithms import ALGORITHMS
from quadruped_env.training.recipes import RECIPES
from quadruped_env.training.train_config import TrainConfig

SMALLEST = 1e-9
LIMITS = {
    # Field: values at the ends of its range, values outside it
    "timesteps": ((1, 10**12), (0, -1, 10**12 + 1, 1.5)),
    "num_envs": ((64, 10**6), (0, 10**6 + 1)),
    "n_steps": ((4, 10**6), (0, 10**6 + 1)),
    "n_epochs": ((1, 1000), (0, 1001)),
    "seed": ((0, 2**32 - 1), (-1, 2**32)),
    "seconds": ((None, SMALLEST), (0.0, -1.0)),
    "checkpoint_seconds": ((SMALLEST,), (0.0, -1.0)),
    "batch_size": ((2, 256 * 24), (0, 1, 256 * 24 + 1)),
    "learning_rate": ((SMALLEST, 1.0), (0.0, -1.0, 1.001, math.inf, math.nan)),
    "desired_kl": ((None, SMALLEST), (0.0, -1.0)),
    "gamma": ((SMALLEST, 1.0), (0.0, 1.001)),
    "gae_lambda": ((0.0, 1.0), (-0.001, 1.001)),
    "clip_range": ((SMALLEST, 10.0), (0.0, 10.1)),
    "ent_coef": ((0.0, 1000.0), (-0.001, 1001.0)),
    "max_grad_norm": ((SMALLEST, 1e6), (0.0, math.inf)),
    "buffer_size": ((1,), (0,)),
    "learning_starts": ((0,), (-1,)),
    "gradient_steps": ((1,), (0,)),
    "tau": ((SMALLEST, 1.0), (0.0, 1.001)),
    "action_noise": ((0.0, 10.0), (-0.001, 10.1)),
    "hidden": (((), (2,), (2, 2)), ((0,), (8, 0), (3,), (2**15,), (2,) * 17)),
    "log_std_init": ((-20.0, 2.0), (math.nan, 2.1)),
    "final_log_std": ((-20.0, 2.0), (math.nan, -21.0)),
    "name": (("a", "..."), ("", ".", "..", "a/b", "a\0")),
}


def test_defaults():
    config = TrainConfig()
    assert {name: getattr(config, name) for name in TRAINING} == TRAINING
    assert (config.recipe, config.algo, config.action_mode, config.seed) == ("flat", "ppo", "residual", 0)
    assert (config.checkpoint_seconds, config.seconds, config.symmetric) == (10.0, None, True)
    assert (config.asymmetric_critic, config.activation, config.task) == (True, "elu", {})
    assert (config.buffer_size, config.learning_starts, config.gradient_steps) == (500_000, 10_000, 16)
    assert (config.tau, config.action_noise) == (0.005, 0.1)


@pytest.mark.parametrize("name", LIMITS)
def test_a_value_is_taken_up_to_its_limits_and_refused_beyond(name):
    valid, refused = LIMITS[name]
    for value in valid:
        assert getattr(TrainConfig(**{"batch_size": 64, name: value}), name) == value
    for value in refused:
        with pytest.raises(QuadrupedError, match=rf"^training\.{name}\b"):
            TrainConfig(**{"batch_size": 64, name: value})


@pytest.mark.parametrize("name", TrainConfig.__dataclass_fields__)
def test_a_value_of_another_type_or_of_any_size_is_refused(name):
    for value in (1e300, -1e300, 10**400, math.nan, object(), [1e300], {"a": 1} if name != "task" else 1):
        with pytest.raises(QuadrupedError, match=rf"^training\.{name}\b.*(must be|expected) .*; found "):
            TrainConfig(**{name: value})


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"action_mode": "torque"}, r"^training.action_mode must be one of position, residual; found 'torque'$"),
        ({"seed": -1}, r"^training.seed must be a whole number from 0 to 4294967295; found -1"),
        ({"gamma": 1.5}, r"^training.gamma must be in \(0, 1\]; found 1.5"),
        ({"seconds": "x"}, r"^training.seconds: expected a number; found 'x'"),
        ({"hidden": (64, 63)}, r"^training.hidden: expected even widths, .* found \(64, 63\); .*symmetric to false"),
        ({"num_envs": 2, "n_steps": 4, "batch_size": 9}, r"^training.batch_size: 9 is more than the 8 samples.*lower"),
        ({"seed": 999_745}, r"^training.seed: found 999745 to 1000000; 1000000 to 1999999 are reserved for evaluation"),
        ({"name": "a/b"}, r"^training.name must be a part of a directory's name; found 'a/b'"),
    ],
)
def test_error_names_the_field_the_values_that_are_valid_and_the_value(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TrainConfig(**values)


def test_choices_are_those_that_there_are():
    for name, known in {"recipe": RECIPES, "algo": ALGORITHMS, "activation": ACTIVATIONS}.items():
        assert set(get_args(TrainConfig.__dataclass_fields__[name].type)) == set(known)
