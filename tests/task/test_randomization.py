"""Randomization: quantities that differ from episode to episode."""

import math

import numpy as np
import pytest
import scipy.stats
from built_in import FOOT_RADIUS, STANCE
from tasks import STILL_START, make_task

from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.task import (
    ModelField,
    Parameter,
    Randomization,
    RandomizationConfig,
    TaskConfig,
    load_task_file,
)
from quadruped_env.task.randomization.randomization import Active, Event


def test_without_randomization_every_start_is_the_stance_on_the_ground():
    task = make_task(3, randomization=STILL_START)
    state = task.simulation.readings
    np.testing.assert_allclose(state.joint_position, np.tile(STANCE, (3, 1)), atol=1e-12)
    np.testing.assert_allclose(state.linear_velocity_b, 0.0, atol=1e-12)
    np.testing.assert_allclose(state.up_b, [[0, 0, 1]] * 3, atol=1e-12)
    np.testing.assert_allclose(state.foot_position[..., 2], FOOT_RADIUS, atol=1e-6)


MODELS = RandomizationConfig(friction=(0.3, 0.9), payload=(-0.2, 1.0))


def test_reset_of_some_envs_leaves_the_models_of_the_others():
    task = make_task(4, randomization=MODELS)
    friction, mass = (task.simulation.model_field(name) for name in ("geom_friction", "body_mass"))
    before = friction.copy(), mass.copy()
    task.reset(np.array([1, 3]))
    for values, old in zip((friction, mass), before, strict=True):
        np.testing.assert_array_equal(values[[0, 2]], old[[0, 2]])
        assert (values[[1, 3]] != old[[1, 3]]).any(axis=tuple(range(1, values.ndim))).all()


# --- laws and what a user writes ---


def drawn(law, setting, n=200_000):
    """Values of a randomization with a law, from independent uniform numbers."""
    randomization = Randomization("x", lambda event, values: None, (1.0, 2.0), law=law)
    uniform = np.random.default_rng(0).random((n, randomization.columns(MINI_QUADRUPED)))
    return randomization.values(uniform, setting)[:, 0]


def test_a_log_uniform_value_is_uniform_in_its_logarithm():
    share = np.log(drawn("log_uniform", (0.1, 10.0)) / 0.1) / math.log(100.0)
    assert scipy.stats.kstest(share, "uniform").pvalue > 1e-3


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (
            {"law": "lognormal"},
            r"randomization x: law must be one of uniform, log_uniform, direction; found 'lognormal'",
        ),
        ({"width": 0}, r"randomization x: width must be 1 or more; found 0"),
        ({"default": (2.0, 1.0)}, r"randomization x: default must be .*low <= high.*found \(2.0, 1.0\)"),
        ({"default": (0.0, math.nan)}, r"randomization x: default: expected a number from .*found nan"),
        ({"default": -0.5}, r"randomization x: default must be 0 or more.*found -0.5"),
        ({"default": "much"}, r"randomization x: default: expected a number; found 'much'"),
        ({"default": (0.0, 1.0), "law": "log_uniform"}, r"randomization x: default must be positive"),
        ({"default": 0.5, "law": "log_uniform"}, r"randomization x: default: expected a pair \(low, high\); found 0.5"),
        ({"default": (-2.0, 0.0), "valid": Parameter("kg", -1.0)}, r"at least -1 \(kg\); found \(-2.0, 0.0\)"),
    ],
)
def test_a_randomization_that_cannot_be_drawn_is_refused_where_it_is_made(values, message):
    with pytest.raises(QuadrupedError, match=message):
        Randomization("x", lambda event, values: None, **{"default": None, **values})


def test_a_log_uniform_range_in_the_config_must_be_positive(tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.task import ModelField, Randomization\n"
        "mass = Randomization('mass', ModelField('body_mass'), (0.5, 2.0), law='log_uniform')\n"
    )
    with pytest.raises(QuadrupedError, match=r"randomization.mass must be positive, 1e-09 or more; found \(0.0, 2.0\)"):
        TaskConfig.from_dict({"randomization": {"mass": [0.0, 2.0]}}, load_task_file(file))


@pytest.mark.parametrize(
    ("field", "width", "message"),
    [
        (ModelField("body_mas"), 1, r"randomization x: ModelField must be an array .*found 'body_mas'"),
        (ModelField("body_mass", ["trunk"]), 1, r"randomization x: ModelField\('body_mass'\): .*trunk"),
        (ModelField("body_mass", ["LF_leg", "RF_leg"]), 3, r"randomization x: .*width must be 1, .* or 2; found 3"),
        (ModelField("body_mass"), "feet", r"randomization x: .*width must be 1, .* or 10; found 4"),
    ],
)
def test_a_model_field_that_does_not_fit_is_refused_before_the_first_reset(field, width, message):
    randomization = Randomization("x", field, (0.5, 1.0), width=width)
    with pytest.raises(QuadrupedError, match=message):
        Active.of(randomization, (0.5, 1.0), SingleSimulation(build_model()))


def test_an_unknown_mode_of_a_model_field_is_refused():
    with pytest.raises(QuadrupedError, match=r"mode must be one of set, scale, divide, add; found 'multiply'"):
        ModelField("body_mass", mode="multiply")


@pytest.mark.parametrize(("mode", "expected"), [("set", 0.7), ("add", 1.2), ("scale", 0.35)])
def test_a_model_field_is_set_scaled_or_added_to(mode, expected):
    model = build_model()
    model.geom_friction[:, 0] = 0.5
    simulation = BatchSimulation(model, 4, 1)
    randomization = Randomization("x", ModelField("geom_friction", column=0, mode=mode), (0.1, 1.0))
    event = Event(simulation, MINI_QUADRUPED, np.array([1, 3]), *[np.zeros((2, 0))] * 3)
    Active.of(randomization, (0.1, 1.0), simulation).apply(event, np.full((2, 1), 0.7))
    friction = simulation.model_field("geom_friction")
    np.testing.assert_allclose(friction[[1, 3], :, 0], expected)
    np.testing.assert_allclose(friction[[0, 2], :, 0], 0.5)


@pytest.mark.parametrize("mode", ["scale", "add"])
def test_the_masses_of_all_bodies_are_randomized_though_the_world_has_none(mode):
    model = build_model()
    simulation = BatchSimulation(model, 2, 1)
    randomization = Randomization("x", ModelField("body_mass", mode=mode), (0.1, 1.0))
    event = Event(simulation, MINI_QUADRUPED, np.arange(2), *[np.zeros((2, 0))] * 3)
    Active.of(randomization, (0.1, 1.0), simulation).apply(event, np.array([[0.7], [0.9]]))
    mass, inertia = simulation.model_field("body_mass"), simulation.model_field("body_inertia")
    np.testing.assert_array_equal(inertia[:, 0], 0.0)
    share = mass[:, 1:] / model.body_mass[1:]
    np.testing.assert_allclose(inertia[:, 1:], share[..., None] * model.body_inertia[1:], rtol=1e-12)


def test_a_name_in_the_episode_memory_is_given_once():
    memory = EpisodeMemory(2)
    memory.zeros("height")
    with pytest.raises(QuadrupedError, match=r"'height' is taken; choose another than height"):
        memory.zeros("height")
