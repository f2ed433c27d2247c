"""The observation: layout, readings, noise."""

import math

import numpy as np
import pytest
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE
from tasks import (
    FRAME_WIDTH,
    LAYOUT,
    NEVER_FALLS,
    NOISE,
    OBSERVATION_WIDTH,
    STILL_START,
    column,
    make_env,
    make_task,
)

from quadruped_env import JOINT_NAMES
from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import RandomizationConfig

# --- observations ---


def test_the_layout_is_bounded_and_adds_up():
    names = [field.name for field in LAYOUT.fields]
    assert len(set(names)) == len(names)
    assert sum(field.width(MINI_QUADRUPED) for field in LAYOUT.fields) == FRAME_WIDTH == len(LAYOUT.scale)
    assert np.isfinite(LAYOUT.high).all()
    np.testing.assert_array_equal(LAYOUT.low, -LAYOUT.high)
    assert (LAYOUT.high > 0).all()
    assert (LAYOUT.scale > 0).all()
    assert [LAYOUT.slices[name].start for name in names] == [0, 3, 6, 14, 22, 30, 32]
    observation = make_task(4).observe()
    assert observation.shape == (4, OBSERVATION_WIDTH)
    assert observation.dtype == np.float32


def test_an_observation_is_the_readings_offset_scaled_and_clipped():
    task = make_task(64, termination=NEVER_FALLS)
    rng = np.random.default_rng(0)
    for _ in range(20):
        action = rng.choice([-1.0, -0.5, 1.0], (64, 8))
        observation = task.step(action).observation
        state = task.simulation.readings
        clock = np.stack([np.sin(task.control.phase), np.cos(task.control.phase)], axis=1)
        clock[(abs(task.command) <= moving_threshold(MINI_QUADRUPED)).all(axis=1)] = 0.0
        readings = {
            "projected_gravity": -state.up_b,
            "angular_velocity": state.angular_velocity_b,
            "joint_position": state.joint_position - STANCE,
            "joint_velocity": state.joint_velocity,
            "last_action": action,
            "command": task.command,
            "gait_clock": clock,
        }
        assert list(readings) == [field.name for field in LAYOUT.fields]
        for field in LAYOUT.fields:
            wanted = readings[field.name] * column(field.name, LAYOUT.scale)
            wanted = np.clip(wanted, column(field.name, LAYOUT.low), column(field.name, LAYOUT.high)).astype(np.float32)
            np.testing.assert_array_equal(column(field.name, observation), wanted, err_msg=field.name)


@pytest.mark.parametrize(("raw", "bound"), [(1e6, LAYOUT.high), (-1e6, LAYOUT.low)])
def test_observation_out_of_bounds_is_clipped(raw, bound):
    task = make_task(2)  # after a reset its first observation stands for the past
    noise = np.full((2, FRAME_WIDTH), raw)
    observation = task.control.observe(task.simulation.readings, noise)
    np.testing.assert_array_equal(observation, [np.tile(bound.astype(np.float32), 3)] * 2)


@pytest.mark.parametrize(("roll", "pitch"), [(0.0, 0.0), (0.3, 0.0), (0.0, 0.3), (-0.5, 0.7), (math.pi, 0.0)])
@pytest.mark.parametrize("yaw", [0.0, 2.0])
def test_projected_gravity_is_the_closed_form_of_a_tilted_robot(roll, pitch, yaw):
    env = make_env(termination=NEVER_FALLS)
    half = np.array([roll, pitch, yaw]) / 2
    (sr, sp, sy), (cr, cp, cy) = np.sin(half), np.cos(half)
    quaternion = [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]
    qpos = np.concatenate([[0.0, 0.0, 1.0], quaternion, STANCE])
    env.task.simulation.reset(np.array([0]), qpos[None], np.zeros((1, 14)))
    gravity = column("projected_gravity", env.task.observe())[0]
    expected = [math.sin(pitch), -math.sin(roll) * math.cos(pitch), -math.cos(roll) * math.cos(pitch)]
    np.testing.assert_allclose(gravity, expected, atol=1e-6)


def test_joints_are_observed_and_driven_in_the_order_of_their_names():
    env = make_env(randomization=STILL_START)
    model, data = env.model, env.data
    for i, name in enumerate(JOINT_NAMES):
        qpos, qvel = data.qpos.copy(), np.zeros(14)
        qpos[7:] = STANCE
        qpos[model.joint(name).qposadr[0]] += 0.25
        qvel[model.joint(name).dofadr[0]] = 1.0
        env.task.simulation.reset(np.array([0]), qpos[None], qvel[None])
        observation = env.task.observe()[0]
        unit = np.eye(8)[i]
        np.testing.assert_allclose(column("joint_position", observation), 0.25 * unit, atol=1e-6)
        velocity_scale = column("joint_velocity", LAYOUT.scale)
        np.testing.assert_allclose(column("joint_velocity", observation), velocity_scale * unit, atol=1e-6)
        env.step(unit)
        expected = STANCE + env.task.config.action.position_scale * unit
        np.testing.assert_allclose(
            data.ctrl, np.clip(expected, JOINT_POSITION_LOW, JOINT_POSITION_HIGH), atol=1e-12, err_msg=name
        )
        assert model.actuator(i).name == name


def test_clock_runs_at_its_frequency_and_stops_at_a_zero_command():
    task = make_task(3, fixed_command=(0.3, 0.0), clock_frequency=1.7, termination=NEVER_FALLS)
    np.testing.assert_array_equal(task.control.phase, np.clip(task.control.phase, 0, math.tau))
    assert len(np.unique(task.control.phase)) == 3, "each env starts at a phase of its own"
    start = task.control.phase.copy()
    for step in range(1, 60):
        clock = column("gait_clock", task.step(np.zeros((3, 8))).observation)
        phase = start + math.tau * 1.7 * task.config.control_timestep * step
        np.testing.assert_allclose(clock, np.stack([np.sin(phase), np.cos(phase)], axis=1), atol=1e-6)
        assert (task.control.phase >= 0).all()
        assert (task.control.phase < math.tau).all()
    task.reset(np.arange(3), command=(0.0, 0.0))
    np.testing.assert_array_equal(column("gait_clock", task.observe()), 0.0)
    task.reset(np.arange(3), command=(0.02, -0.02))
    np.testing.assert_array_equal(column("gait_clock", task.observe()), 0.0, err_msg="0.02 m/s and rad/s are standing")
    task.reset(np.arange(3), command=(0.0, 0.5))
    np.testing.assert_allclose((column("gait_clock", task.observe()) ** 2).sum(axis=1), 1.0, rtol=1e-6)


# --- observation noise ---


def test_observation_noise_stays_within_each_fields_amplitude():
    quiet = make_task(32, randomization=RandomizationConfig(observation_noise=0.0), observation_history=1)
    noisy = make_task(32, randomization=RandomizationConfig(observation_noise=1.0), observation_history=1)
    np.testing.assert_array_equal(noisy.simulation.readings.joint_position, quiet.simulation.readings.joint_position)
    differences = []
    for _ in range(20):
        action = np.zeros((32, 8))
        difference = noisy.step(action).observation.astype(float) - quiet.step(action).observation
        assert (abs(difference) <= NOISE * LAYOUT.scale + 1e-6).all()
        differences.append(difference)
    differences = np.array(differences)
    noiseless = NOISE == 0
    np.testing.assert_array_equal(differences[..., noiseless], 0.0)
    inside = (abs(quiet.observe()) < LAYOUT.high - 0.5).all(axis=0) & ~noiseless
    spread = differences[..., inside].std(axis=(0, 1))
    np.testing.assert_allclose(spread, (NOISE * LAYOUT.scale)[inside] / math.sqrt(3), rtol=0.15)


def test_observing_twice_gives_the_same_noise():
    task = make_task(randomization=RandomizationConfig(observation_noise=1.0))
    np.testing.assert_array_equal(task.observe(), task.observe())
