"""Errors of the sensors: what the policy observes, recomputed from the true state, which rewards and info keep."""

import dataclasses

import gymnasium
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from settings import settings
from tasks import LAYOUT, make_task

from quadruped_env.envs import ENV_ID
from quadruped_env.robot.readings import Readings
from quadruped_env.task import RandomizationConfig
from quadruped_env.task.randomization.sensor_errors import MEASURED as DISTURBED

STANCE = np.array([0.6, -0.72] * 4)
SENSORS = {"imu_mounting": 0.2, "observation_latency": [0.0, 0.05]}
"""Errors that do not change the motion, whatever the actions."""


def vector(num_envs=4, **ranges):
    config = settings(never_ends=True, resample=(1e3, 1e3), randomization=ranges)
    return gymnasium.make_vec(ENV_ID, num_envs=num_envs, config=config)


def rollout(env, actions, seed=3):
    """Observations (T + 1, N, width), and the results of the steps."""
    observations, results = [env.reset(seed=seed)[0]], []
    for action in actions:
        observation, *rest = env.step(action)
        observations.append(observation)
        results.append(rest)
    return np.array(observations).astype(np.float64), results


def actions_for(num_envs=4, steps=30, scale=0.5):
    return np.random.default_rng(0).uniform(-scale, scale, (steps, num_envs, 8)).astype(np.float32)


def part(name, observations):
    """Columns of a field of the observation, in the unit of its reading."""
    columns = LAYOUT.slices[name]
    return observations[..., columns] / LAYOUT.scale[columns]


MEASURED = ("projected_gravity", "angular_velocity", "joint_position", "joint_velocity")
INTERNAL = ("last_action", "command", "gait_clock")


def test_rewards_ends_and_info_are_those_of_the_true_state():
    actions = actions_for()
    seen, disturbed = rollout(vector(**SENSORS, observation_noise=2.0), actions)
    true, quiet = rollout(vector(), actions)
    for one, other in zip(disturbed, quiet, strict=True):
        for value, wanted in zip(one[:3], other[:3], strict=True):
            np.testing.assert_array_equal(value, wanted)
        for name, value in one[3].items():
            np.testing.assert_array_equal(value, other[3][name])
    for name in MEASURED:
        assert (part(name, seen) != part(name, true)).any(axis=(0, 1)).all(), name
    for name in INTERNAL:
        np.testing.assert_array_equal(part(name, seen), part(name, true))


# --- latency ---


@pytest.mark.parametrize("steps", [1, 2, 3])
def test_latency_of_whole_control_steps_is_a_shift_of_the_readings(steps):
    actions = actions_for()
    late, _ = rollout(vector(observation_latency=[0.02 * steps] * 2), actions)
    now, _ = rollout(vector(), actions)
    # Before the episode the robot rested in its initial state.
    before = np.concatenate([np.repeat(now[:1], steps, axis=0), now[:-steps]])
    for name in MEASURED:
        np.testing.assert_array_equal(part(name, late), part(name, before))
    for name in INTERNAL:
        np.testing.assert_array_equal(part(name, late), part(name, now))


@pytest.mark.parametrize("seconds", [0.005, 0.027, 0.0395])
def test_latency_between_control_steps_is_interpolated(seconds):
    actions = actions_for()
    late, _ = rollout(vector(observation_latency=[seconds, seconds]), actions)
    now, _ = rollout(vector(), actions)
    whole, share = divmod(seconds / 0.02, 1.0)
    padded = np.concatenate([np.repeat(now[:1], 3, axis=0), now])
    newer, older = (padded[3 - int(whole) - k : len(padded) - int(whole) - k] for k in (0, 1))
    for name in ("joint_position", "joint_velocity", "angular_velocity"):
        expected = (1.0 - share) * part(name, newer) + share * part(name, older)
        np.testing.assert_allclose(part(name, late), expected, atol=2e-5)
    gravity = (1.0 - share) * part("projected_gravity", newer) + share * part("projected_gravity", older)
    gravity /= np.linalg.norm(gravity, axis=-1, keepdims=True)
    np.testing.assert_allclose(part("projected_gravity", late), gravity, atol=1e-6)


def test_a_new_episode_observes_nothing_of_the_last_one():
    env = vector(observation_latency=[0.06, 0.06])
    first = env.reset(seed=5)[0]
    for action in actions_for(steps=7):
        env.step(action)
    np.testing.assert_array_equal(env.reset(seed=5)[0], first)


def test_observing_again_at_the_same_step_gives_the_same():
    task = make_task(randomization=RandomizationConfig(preset="hard"))
    for _ in range(5):
        task.step(np.zeros((3, 8)))
        np.testing.assert_array_equal(task.observe(), task.observe())


# --- encoders ---


def offset_of(observations, infos):
    return part("joint_position", observations[1:]) + STANCE - np.array([info["joint_position"] for info in infos])


def test_encoder_offset_shifts_readings_by_the_same_amount_all_episode_long():
    observations, results = rollout(vector(encoder_offset=0.05), actions_for())
    offsets = offset_of(observations, [info for *_, info in results])
    np.testing.assert_allclose(offsets, offsets[:1].repeat(len(offsets), axis=0), atol=1e-6)
    assert abs(offsets).max() <= 0.05 + 1e-6
    assert len(np.unique(offsets[0].round(7))) == 32, "each joint on its own"


def test_encoder_offset_shifts_targets_and_readings_together():
    """A robot whose encoders show e too much is, at a target T, one with true encoders at the target T - e."""
    offset, scale = 0.03, 0.6
    actions = actions_for(scale=0.4)
    common = {"start_joint_position": 0.0}
    shifted, results = rollout(vector(encoder_offset=[offset, offset], **common), actions)
    true, expected = rollout(vector(**common), actions - offset / scale)
    for one, other in zip(results[:10], expected[:10], strict=True):
        np.testing.assert_allclose(one[3]["joint_position"], other[3]["joint_position"], atol=1e-6)
        np.testing.assert_allclose(one[3]["joint_torque"], other[3]["joint_torque"], atol=1e-4)
    np.testing.assert_allclose(
        part("joint_position", shifted)[:10], part("joint_position", true)[:10] + offset, atol=1e-6
    )


@pytest.mark.parametrize("offset", [0.1, -0.1])
def test_target_is_limited_to_the_range_that_the_encoder_shows(offset):
    env = gymnasium.make(
        ENV_ID, config=settings(never_ends=True, randomization={"encoder_offset": [offset, offset]})
    ).unwrapped
    env.reset(seed=0)
    low, high = np.array([-1.5, -2.0] * 4), np.array([1.5, 0.0] * 4)
    np.testing.assert_allclose(env.model.actuator_ctrlrange, np.stack([low, high], axis=1) - offset)
    np.testing.assert_allclose(env.model.jnt_range[1:], np.stack([low, high], axis=1), err_msg="the stops stay")
    env.step(np.ones(8))
    limit = np.minimum(STANCE + 0.6, high) - offset
    np.testing.assert_allclose(env.data.ctrl, limit, atol=1e-7)
    env.reset()
    np.testing.assert_allclose(env.model.actuator_ctrlrange, np.stack([low, high], axis=1) - offset)


# --- IMU ---


def test_imu_turns_gravity_and_rates_by_the_same_rotation_all_episode_long():
    actions = actions_for()
    seen, _ = rollout(vector(imu_mounting=0.1), actions)
    true, _ = rollout(vector(), actions)
    for env in range(4):
        vectors = [
            np.concatenate([part(name, values)[:, env] for name in ("projected_gravity", "angular_velocity")])
            for values in (true, seen)
        ]
        turn, distance = Rotation.align_vectors(*vectors)
        assert distance < 1e-4
        angles = turn.as_euler("xyz")
        assert (abs(angles) <= 0.1 + 1e-6).all()
        assert 1e-3 < turn.magnitude() < 0.2
    for name in ("joint_position", "joint_velocity", *INTERNAL):
        np.testing.assert_array_equal(part(name, seen), part(name, true))


def test_imu_axes_are_turned_by_roll_pitch_and_yaw():
    task = make_task(1, randomization=RandomizationConfig(imu_mounting=[0.1, 0.1]))
    mounting = Rotation.from_euler("xyz", [0.1, 0.1, 0.1])
    sensors = task._randomizer.sensors
    readings = sensors.read(task.control.steps)
    for name in ("up_b", "angular_velocity_b", "linear_acceleration_b"):
        true = getattr(task.simulation.readings, name).copy()
        np.testing.assert_allclose(getattr(readings, name), mounting.inv().apply(true), atol=1e-12)
    base = Rotation.from_quat(task.simulation.readings.orientation.copy(), scalar_first=True)
    seen = Rotation.from_quat(readings.orientation, scalar_first=True)
    np.testing.assert_allclose((seen * (base * mounting).inv()).magnitude(), 0.0, atol=1e-7)


def test_readings_that_only_a_simulator_knows_have_no_errors():
    task = make_task(3, randomization=RandomizationConfig(preset="hard", observation_latency=[0.04, 0.04]))
    for _ in range(3):
        task.step(np.full((3, 8), 0.3))
    readings, true = task._randomizer.sensors.read(task.control.steps), task.simulation.readings
    for entry in dataclasses.fields(Readings):
        same = np.array_equal(getattr(readings, entry.name), getattr(true, entry.name))
        assert same == (entry.name not in DISTURBED), entry.name


# --- noise ---


def test_noise_of_each_field_has_its_own_amplitude():
    amplitudes = {"projected_gravity": 0.0, "joint_position": 0.05, "joint_velocity": 1.0}
    noisy = make_task(64, randomization=RandomizationConfig(observation_noise=1.0, noise_amplitude=amplitudes))
    quiet = make_task(64)
    differences = []
    for _ in range(10):
        action = np.zeros((64, 8))
        one, other = (task.step(action).observation.astype(np.float64) for task in (noisy, quiet))
        differences.append(one - other)
    differences = np.array(differences)
    for name, amplitude in {**amplitudes, "angular_velocity": 0.1, "last_action": 0.0}.items():
        values = part(name, differences)
        assert abs(values).max() <= amplitude + 1e-5, name
        if amplitude:
            assert abs(values).max() > 0.95 * amplitude, name
            assert values.std() == pytest.approx(amplitude / np.sqrt(3.0), rel=0.05)


def test_global_factor_scales_the_noise_of_every_field():
    amplitudes = {"joint_position": 0.02}
    one, two, quiet = (
        make_task(8, randomization=RandomizationConfig(observation_noise=factor, noise_amplitude=amplitudes))
        for factor in (1.0, 2.0, 0.0)
    )
    base = quiet.observe().astype(np.float64)
    for name in ("joint_position", "joint_velocity"):
        single, double = (part(name, task.observe() - base) for task in (one, two))
        np.testing.assert_allclose(double, 2.0 * single, atol=1e-5)
        assert abs(single).max() > 0.0


# --- real robots ---
