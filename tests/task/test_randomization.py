"""Randomization: quantities that differ from episode to episode."""

import math

import numpy as np
import pytest
import scipy.stats
from built_in import FOOT_RADIUS, STANCE
from tasks import NEVER_FALLS, ONE_COMMAND, STILL_START, make_env, make_task

from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.task import (
    ModelField,
    Parameter,
    Randomization,
    RandomizationConfig,
    Task,
    TaskConfig,
    load_task_file,
)
from quadruped_env.task.randomization.randomization import Active, Event


def test_starts_are_drawn_in_their_ranges():
    config = RandomizationConfig(
        start_joint_position=0.2,
        start_joint_velocity=0.7,
        start_base_velocity=0.3,
        start_base_rotation=0.4,
        start_tilt=0.15,
    )
    simulation = BatchSimulation(build_model(), 5000, 1)
    starts = []
    simulation.reset = lambda env_ids, qpos, qvel: starts.append((qpos, qvel))
    Task(simulation, TaskConfig(randomization=config)).reset(np.arange(5000), range(5000))
    ((qpos, qvel),) = starts
    for values, bound in ((qpos[:, 7:] - STANCE, 0.2), (qvel[:, 6:], 0.7), (qvel[:, :3], 0.3), (qvel[:, 3:6], 0.4)):
        assert (abs(values) <= bound + 1e-12).all()
        assert (abs(values).max(axis=0) > 0.99 * bound).all()
        np.testing.assert_allclose(values.mean(axis=0), 0.0, atol=0.05 * bound)
    np.testing.assert_allclose(np.linalg.norm(qpos[:, 3:7], axis=1), 1.0)
    up = 1 - 2 * (qpos[:, 4] ** 2 + qpos[:, 5] ** 2)
    tilt = np.arccos(np.clip(up, -1, 1))
    assert 0.15 < tilt.max() <= math.sqrt(2) * 0.15 + 1e-9
    yaw = 2 * np.arctan2(qpos[:, 6], qpos[:, 3])
    assert np.ptp(yaw) > 6.0, "every heading"
    # No draw decides two quantities.
    correlation = np.corrcoef(np.concatenate([qpos[:, 7:], qvel], axis=1).T) - np.eye(22)
    assert abs(correlation).max() < 0.08


def test_without_randomization_every_start_is_the_stance_on_the_ground():
    task = make_task(3, randomization=STILL_START)
    state = task.simulation.readings
    np.testing.assert_allclose(state.joint_position, np.tile(STANCE, (3, 1)), atol=1e-12)
    np.testing.assert_allclose(state.linear_velocity_b, 0.0, atol=1e-12)
    np.testing.assert_allclose(state.up_b, [[0, 0, 1]] * 3, atol=1e-12)
    np.testing.assert_allclose(state.foot_position[..., 2], FOOT_RADIUS, atol=1e-6)


MODELS = RandomizationConfig(friction=(0.3, 0.9), payload=(-0.2, 1.0))


@pytest.mark.parametrize("rows", [1, 4], ids=["single", "batch"])
def test_friction_and_payload_are_in_the_model_of_the_env(rows):
    plain = build_model()
    base = plain.body("base_link").id
    model = build_model()
    simulation = SingleSimulation(model) if rows == 1 else BatchSimulation(model, rows, 1)
    task = Task(simulation, TaskConfig(randomization=MODELS))
    everything = np.arange(rows)
    frictions, payloads = [], []
    for episode in range(12):
        task.reset(everything, [100 * episode + row for row in range(rows)])
        friction, mass = simulation.model_field("geom_friction"), simulation.model_field("body_mass")
        inertia = simulation.model_field("body_inertia")
        for row in everything:
            assert len(np.unique(friction[row, :, 0])) == 1, "both sides of every contact"
            np.testing.assert_array_equal(friction[row, :, 1:], plain.geom_friction[:, 1:])
            frictions.append(friction[row, 0, 0])
            payloads.append(mass[row, base] - plain.body_mass[base])
            others = np.delete(np.arange(plain.nbody), base)
            np.testing.assert_array_equal(mass[row, others], plain.body_mass[others])
            np.testing.assert_array_equal(inertia[row, others], plain.body_inertia[others])
            share = mass[row, base] / plain.body_mass[base]
            np.testing.assert_allclose(inertia[row, base], plain.body_inertia[base] * share, rtol=1e-12)
        if rows == 1:
            # What MuJoCo derives from the mass follows.
            np.testing.assert_allclose(model.body_subtreemass[base], model.body_mass[base:].sum(), rtol=1e-12)
    assert 0.3 <= min(frictions) < max(frictions) <= 0.9
    assert -0.2 <= min(payloads) < max(payloads) <= 1.0
    assert len(set(frictions)) == len(set(payloads)) == 12 * rows


def test_reset_of_some_envs_leaves_the_models_of_the_others():
    task = make_task(4, randomization=MODELS)
    friction, mass = (task.simulation.model_field(name) for name in ("geom_friction", "body_mass"))
    before = friction.copy(), mass.copy()
    task.reset(np.array([1, 3]))
    for values, old in zip((friction, mass), before, strict=True):
        np.testing.assert_array_equal(values[[0, 2]], old[[0, 2]])
        assert (values[[1, 3]] != old[[1, 3]]).any(axis=tuple(range(1, values.ndim))).all()


def test_a_payload_presses_on_the_ground():
    heavy = make_task(2, randomization=STILL_START.replace(payload=(1.0, 1.0)), termination=NEVER_FALLS)
    plain = make_task(2, randomization=STILL_START, termination=NEVER_FALLS)
    for _ in range(60):
        heavy.step(np.zeros((2, 8))), plain.step(np.zeros((2, 8)))
    weight = [task.simulation.readings.foot_force.sum(axis=1) for task in (heavy, plain)]
    np.testing.assert_allclose(weight[0] - weight[1], 9.81, rtol=0.05)


def test_pushes_add_six_components_at_their_intervals():
    interval, size, turn = 0.2, 0.5, 0.9
    pushed = make_env(
        command=ONE_COMMAND,
        randomization=STILL_START.replace(push_velocity=size, push_rotation=turn, push_interval=(interval, interval)),
        termination=NEVER_FALLS,
    )
    still = make_env(command=ONE_COMMAND, randomization=STILL_START)
    every = round(interval / pushed.dt)
    velocities = []
    for step in range(1, 10 * every + 1):
        if step % every == 0:
            still.set_state(pushed.get_state())
        pushed.step(np.zeros(8))
        if step % every == 0:
            still.step(np.zeros(8))
            velocities.append(pushed.data.qvel[:6] - still.data.qvel[:6])
            np.testing.assert_array_equal(pushed.data.qvel[6:], still.data.qvel[6:])
            np.testing.assert_array_equal(pushed.data.qpos, still.data.qpos)
        elif step < every:
            still.step(np.zeros(8))
            np.testing.assert_array_equal(pushed.data.qvel, still.data.qvel)
    velocities = np.array(velocities)
    assert len(np.unique(velocities)) == 60
    share = abs(velocities) / np.repeat([size, turn], 3)
    assert (share <= 1.0).all()
    assert (share.max(axis=0) > 0.5).all()


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
        (ModelField("body_mas"), 1, r"randomization x: ModelField: 'body_mas' is not an array of MuJoCo's model"),
        (ModelField("body_mass", ["trunk"]), 1, r"randomization x: ModelField\('body_mass'\): .*trunk"),
        (ModelField("body_mass", ["LF_leg", "RF_leg"]), 3, r"randomization x: .*3 values for 2 elements.*1, .* or 2"),
        (ModelField("body_mass"), "feet", r"randomization x: .*4 values for 10 elements"),
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
