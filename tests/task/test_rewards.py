"""The reward: every term against hand-computed values, and identical for any batch."""

import dataclasses

import numpy as np
import pytest
from tasks import Terms, make_task, random_readings

from quadruped_env.robot.motors import JointMotor, MotorConfig
from quadruped_env.robot.readings import Readings
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.task import (
    RandomizationConfig,
    RewardConfig,
    Task,
    TaskConfig,
    TerrainConfig,
    load_task_file,
    quantities,
)

# --- rewards, by hand ---


def of_velocity(velocity, command, config=None):
    """Values of the terms at average forward velocities and yaw rates (N, 2) under one command."""
    velocity = np.atleast_2d(np.asarray(velocity, dtype=np.float64))
    terms = Terms(random_readings(np.random.default_rng(0), len(velocity)), config)
    terms.set_command(np.tile(np.asarray(command, dtype=np.float64), (len(velocity), 1)))
    terms.context.smooth_velocity[:] = velocity
    terms.context.tracking_error[:] = velocity - command
    return terms.values()


def progress(velocity, command):
    """Progress at forward velocities (N,) under one command."""
    velocity = np.atleast_1d(velocity)
    return of_velocity(np.stack([velocity, np.zeros_like(velocity)], axis=1), (command, 0.0))["forward_progress"]


@pytest.mark.parametrize(
    ("velocity", "command", "expected"),
    [
        (0.4, 0.4, 1.0),  # reached
        (0.2, 0.4, 0.5),  # half way
        (0.0, 0.4, 0.0),
        (-0.2, 0.4, -0.5),  # the wrong way
        (-9.0, 0.4, -1.0),  # never below -1
        (-0.4, -0.4, 1.0),  # backwards too
        (-0.2, -0.4, 0.5),
        (0.0, 0.0, 0.0),  # no command, no reward
    ],
)
def test_progress_is_the_share_of_the_command_that_is_reached(velocity, command, expected):
    assert progress(velocity, command) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_progress_beyond_the_command_falls_as_it_rose(direction):
    velocity, command = direction * np.array([0.4, 0.5, 0.6, 0.8, 5.0]), direction * 0.4
    np.testing.assert_allclose(progress(velocity, command), [1.0, 0.75, 0.5, 0.0, -1.0], atol=1e-12)


def test_progress_pays_small_commands_in_proportion():
    assert progress(0.05, 0.05) == pytest.approx(0.5)
    assert progress(0.01, 0.01) == pytest.approx(0.1)
    # A yaw rate is small under 0.2 rad/s.
    turning = of_velocity([[0.3, 0.025], [0.3, 0.05], [0.3, 0.1]], (0.0, 0.05))
    np.testing.assert_allclose(turning["turn_progress"], [0.125, 0.25, 0.0], atol=1e-12)
    np.testing.assert_array_equal(turning["forward_progress"], 0.0)


def test_foot_lift_rises_from_the_ground_to_a_full_lift_and_falls_beyond():
    height = np.array([[-0.001, 0.0, 0.005, 0.02], [0.01, 0.015, 0.03, 0.04], [0.025, 0.035, 0.041, 1.0]])
    expected = [[-1, -1, -0.125, 1], [0.5, 0.875, 0.5, -1], [0.875, -0.125, -1, -1]]
    np.testing.assert_allclose(quantities.foot_lift(height, 0.02), expected, atol=1e-12)


def test_feet_are_to_rise_above_the_step_on_their_way():
    task = make_task(2, terrain=TerrainConfig(name="steps", height=0.03))
    context, ground = task.context, task.simulation.height_field
    place, velocity = np.zeros((2, 4, 3)), np.zeros((2, 4, 3))
    along = np.linspace(-1.0, 1.0, 201)
    heights = ground.at(np.stack([along, np.zeros_like(along), np.zeros_like(along)], axis=-1))
    edge = int(np.flatnonzero(heights > 0.029)[0])  # the first full height, from below
    x = along[edge] - 0.1
    low = float(ground.at(np.array([x, 0.0, 0.0])))
    place[..., 0], place[..., 2] = x, low + task.config.robot.foot_radius
    # Towards the step at 1 m/s, away from it, along it, and still.
    velocity[0, :, :2] = [[1.0, 0.0], [-1e-3, 0.0], [0.0, 1e-3], [0.0, 0.0]]
    context.readings = dataclasses.replace(context.readings, foot_position=place, foot_velocity=velocity)
    np.testing.assert_allclose(context.rise_ahead()[0], [heights[edge] - low, 0.0, 0.0, 0.0], atol=2e-4)


@pytest.mark.parametrize(("rise", "lift"), [(0.0, 0.012), (0.03, 0.042), (0.2, 0.06)])
def test_lift_that_is_asked_for_follows_the_ground_up_to_the_highest(rise, lift):
    readings = random_readings(np.random.default_rng(0), 2)
    readings.foot_position[..., 2] = np.array([lift, 0.0, 0.0, lift]) + 0.02  # and the radius of the foot
    terms = Terms(readings)
    terms.set_command(np.full((2, 2), 0.3))
    terms.control.phase[:] = 0.3, 1.9
    terms.context.rise_ahead = lambda: np.full((2, 4), rise)
    # One pair of feet is at the full lift, the other on the ground, as the clock has it.
    np.testing.assert_allclose(terms.values()["gait_clock"], np.sin([0.3, 1.9]), atol=1e-12)


def test_clock_of_the_feet_lags_by_the_latency_of_the_actions():
    task = make_task(3, randomization=RandomizationConfig(action_latency=(0.04, 0.04)))
    late = task.context.leg_clock.copy()
    turn = 2.0 * np.pi * task.config.clock_frequency * 0.04
    np.testing.assert_allclose(late, np.sin(task.control.phase[:, None] + np.array([0, 1, 1, 0]) * np.pi - turn))
    task.set_state(0, task.get_state(0))
    np.testing.assert_array_equal(task.context.leg_clock, late, err_msg="the lag is part of the state")


# --- rewards, for any batch ---


def test_every_weight_is_a_term_and_every_term_has_a_weight():
    terms = Terms(random_readings(np.random.default_rng(0), 2))
    assert tuple(terms.values()) == tuple(RewardConfig().weights) == make_task(1).term_names


@pytest.mark.parametrize("num_envs", [1, 2, 3, 7, 64])
def test_terms_of_an_env_do_not_depend_on_the_other_envs(num_envs):
    rng = np.random.default_rng(2)
    readings = random_readings(rng, 256)
    everywhere = Terms(readings).randomize(rng)
    chosen = rng.permutation(256)[:num_envs]
    fields = {field.name: getattr(readings, field.name)[chosen] for field in dataclasses.fields(Readings)}
    here = Terms(Readings(**fields))
    here.set_command(everywhere.control.command[chosen])
    for name in ("action", "previous_action", "phase"):
        getattr(here.control, name)[:] = getattr(everywhere.control, name)[chosen]
    for name in ("velocity", "smooth_velocity", "tracking_error", "fallen", "_airborne"):
        getattr(here.context, name)[:] = getattr(everywhere.context, name)[chosen]
    expected = everywhere.values()
    for name, value in here.values().items():
        assert value.shape == (num_envs,), name
        np.testing.assert_array_equal(value, expected[name][chosen], err_msg=name)


UNPAID = """
from quadruped_env.task import reward, reward_group

calls = []

@reward(weight=0.0)
def counting(context):
    "Counts its calls."
    calls.append("counting")
    return 0.0 * context.fallen + 1.0

@reward_group(one=0.0, other=0.0)
def pair(context):
    "Two terms that are not computed one at a time."
    calls.append("pair")
    return 0.0 * context.velocity + 1.0
"""


def test_term_with_the_weight_0_is_not_computed_and_counts_as_0(tmp_path):
    (tmp_path / "unpaid.py").write_text(UNPAID)
    definition = load_task_file(tmp_path / "unpaid.py")
    calls = next(term for term in definition.rewards if "counting" in term.names).function.__globals__["calls"]
    task, usual = make_task(definition=definition), make_task()
    calls.clear()  # creating a task calls every term once, to check it
    action = np.full((3, 8), 0.3)
    transition, expected = task.step(action), usual.step(action)
    assert not calls
    assert task.term_names[-3:] == ("counting", "one", "other")
    np.testing.assert_array_equal(transition.terms[:, :-3], expected.terms)
    np.testing.assert_array_equal(transition.terms[:, -3:], 0.0)
    np.testing.assert_array_equal(transition.reward, expected.reward)
    config = TaskConfig.from_dict({"reward": {"weights": {"other": 2.0}}}, definition)
    paid = make_task(definition=definition, reward=config.reward)
    calls.clear()
    np.testing.assert_allclose(paid.step(action).terms[:, -3:], [[0.0, 0.0, 2.0 * paid.config.control_timestep]] * 3)
    assert set(calls) == {"pair"}


def test_electrical_power_is_that_of_the_configs_motors():
    # K = 24 / 8 = 3 N m/A and R = 3 * 24 / 5 = 14.4 Ohm at the hips, so the heat is 1.6 W/(N m)^2; 0.5 at the knees.
    motors = MotorConfig(hip=JointMotor(stall_torque=5.0, no_load_speed=8.0))
    names = list(RewardConfig().weights)
    weights = dict.fromkeys(names, 0.0) | {"electrical_power": -0.01}
    config = TaskConfig(reward=RewardConfig(weights=weights), motor=motors)
    task = Task(BatchSimulation(build_model(config.physics_timestep, motors), 3, 1), config)
    task.reset(np.arange(3), [0, 1, 2])
    for _ in range(10):
        transition = task.step(np.random.default_rng(0).uniform(-1, 1, (3, 8)))
        substeps = task.simulation.substeps
        torque, speed = substeps.joint_torque, substeps.joint_velocity
        power = np.maximum(torque * speed, 0.0).sum(axis=2) + (torque**2 * np.tile([1.6, 0.5], 4)).sum(axis=2)
        expected = power.mean(axis=0)
        np.testing.assert_allclose(transition.reward, -0.01 * 0.02 * expected, rtol=1e-12)
