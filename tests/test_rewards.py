"""The reward: every term against hand-computed values, and alike for any batch."""

import dataclasses
import math

import numpy as np
import pytest
from tasks import (
    NEVER_FALLS,
    column,
    convert,
    make_task,
    random_memory,
    random_state,
)

from quadruped_env.robot import FOOT_RADIUS
from quadruped_env.task import (
    RewardConfig,
    rewards,
    terminations,
)

# --- rewards, by hand ---


def test_tracking_kernel_is_one_on_target_and_1_over_e_an_std_away():
    value = rewards.tracking_kernel(np.array([0.3, 0.45, 0.15, 0.6]), np.array([0.3] * 4), 0.15)
    np.testing.assert_allclose(value, [1.0, math.exp(-1), math.exp(-1), math.exp(-4)], rtol=1e-12)


def progress(velocity, command, overshoot):
    """Progress at forward velocities under one command."""
    scale, whole = rewards.progress_scale(np.array([[command, 0.0]]))
    return rewards.progress(np.asarray(velocity) * scale[0, 0], whole[0, 0], overshoot)


@pytest.mark.parametrize(
    ("velocity", "command", "expected"),
    [
        (0.4, 0.4, 1.0),  # reached
        (0.2, 0.4, 0.5),  # half way
        (0.0, 0.4, 0.0),
        (-0.2, 0.4, -0.5),  # the wrong way
        (-9.0, 0.4, -1.0),  # never below -1
        (-0.4, -0.4, 1.0),  # backwards alike
        (-0.2, -0.4, 0.5),
        (0.0, 0.0, 0.0),  # none commanded, none paid
    ],
)
@pytest.mark.parametrize("overshoot", [1.0, 2.0])
def test_progress_is_the_share_of_the_command_that_is_reached(velocity, command, expected, overshoot):
    assert progress(velocity, command, overshoot) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_progress_beyond_the_command_stays_or_falls_as_it_rose(direction):
    velocity, command = direction * np.array([0.4, 0.5, 0.6, 0.8, 5.0]), direction * 0.4
    np.testing.assert_allclose(progress(velocity, command, 1.0), 1.0)
    np.testing.assert_allclose(progress(velocity, command, 2.0), [1.0, 0.75, 0.5, 0.0, -1.0], atol=1e-12)


def test_progress_pays_small_commands_in_proportion():
    assert progress(0.05, 0.05, 2.0) == pytest.approx(0.5)
    assert progress(0.01, 0.01, 2.0) == pytest.approx(0.1)
    # A yaw rate is small under 0.2 rad/s.
    scale, whole = rewards.progress_scale(np.array([[0.0, 0.05]]))
    np.testing.assert_allclose((scale, whole), ([[0.0, 5.0]], [[0.0, 0.25]]))


def test_gait_clock_agrees_when_the_swinging_feet_are_up():
    sine = np.array([[1.0, -1.0, -1.0, 1.0]] * 4)
    lift = np.array([[1, -1, -1, 1], [-1, 1, 1, -1], [0] * 4, [1, -1, -1, 1]])
    moving = np.array([1.0, 1.0, 1.0, 0.0])
    np.testing.assert_allclose(rewards.gait_clock(lift, sine, moving), [1.0, -1.0, 0.0, 0.0])
    assert rewards.gait_clock(np.array([[1.0, 1.0, -1.0, -1.0]]), np.array([[0.5, -0.25, 1.0, 0.0]]), 1.0) == (
        pytest.approx((0.5 - 0.25 - 1.0) / 4)
    )


def test_foot_lift_goes_from_the_ground_to_a_full_lift_and_pays_the_first_of_it_most():
    height = FOOT_RADIUS + np.array([[-0.001, 0.0, 0.005, 0.02], [0.01, 0.015, 0.021, 1.0]])
    expected = [[-1.205, -1, -0.125, 1], [0.5, 0.875, 1, 1]]
    np.testing.assert_allclose(rewards.foot_lift(height, 0.02), expected, atol=1e-12)


def test_sum_of_squares():
    np.testing.assert_array_equal(rewards.sum_of_squares(np.array([[3.0, -4.0], [0.0, 0.5]])), [25.0, 0.25])


def test_base_height_error_forgives_standing_taller():
    error = rewards.base_height_error(np.array([0.15, 0.175, 0.3]), 0.175)
    np.testing.assert_allclose(error, [0.025**2, 0.0, 0.0], rtol=1e-12)


def test_mechanical_power_counts_driving_and_not_braking():
    power = rewards.mechanical_power(np.array([[2.0, -3.0, 1.0], [1.0, 1.0, 1.0]]), np.array([[3.0, -1.0, -5.0]] * 2))
    np.testing.assert_array_equal(power, [9.0, 3.0])


def test_foot_slip_is_the_sliding_of_the_lowest_point_of_feet_in_contact():
    velocity, spin = np.zeros((4, 4, 3)), np.zeros((4, 4, 3))
    contact = np.array([[1.0, 1.0, 0.0, 0.0]] * 4)
    velocity[0, 0] = (0.3, 0.4, 9.0)  # slides; its vertical motion is no slip
    velocity[1, 2] = (5.0, 0.0, 0.0)  # in the air
    velocity[2, 0, 0], spin[2, 0, 1] = 0.2, 0.2 / FOOT_RADIUS  # rolls forwards
    velocity[3, 1, 1], spin[3, 1, 0] = 0.2, -0.2 / FOOT_RADIUS  # rolls sideways
    np.testing.assert_allclose(rewards.foot_slip(contact, velocity, spin), [0.25, 0.0, 0.0, 0.0], atol=1e-12)


def test_joint_speed_excess_begins_a_margin_below_the_motors_top_speed():
    velocity = np.array([[4.0, -4.0, 0.0], [5.0, -4.5, 1.0], [6.0, 0.0, 0.0]])
    np.testing.assert_allclose(rewards.joint_speed_excess(velocity, 1.0), [0.0, 1.25, 4.0], atol=1e-12)


def test_every_term_reads_what_its_name_says():
    config = RewardConfig(base_height=0.2, foot_lift=0.02, forward_velocity_std=0.1, yaw_rate_std=0.2)
    state = dataclasses.replace(
        convert(random_state(np.random.default_rng(0), 1), np.zeros_like),
        up_b=np.array([[0.3, 0.4, 0.8]]),
        base_position=np.array([[5.0, 6.0, 0.1]]),
        linear_velocity_b=np.array([[0.1, 0.2, 0.3]]),
        angular_velocity_b=np.array([[1.0, 2.0, 0.25]]),
        joint_torque=np.full((1, 8), 2.0),
        joint_velocity=np.full((1, 8), 4.5),
        foot_force=np.array([[config.contact_threshold + 1.0, config.contact_threshold, 0.0, 0.0]]),
        foot_velocity=np.full((1, 4, 3), 0.1),
        foot_position=np.full((1, 4, 3), FOOT_RADIUS + 0.01),
    )
    # Velocity steady, so that the smoothed one is the same.
    memory = rewards.Memory(
        action=np.full((1, 8), 0.5),
        last_action=np.full((1, 8), 0.25),
        joint_offset=np.full((1, 8), 0.1),
        command=np.array([[0.2, 0.5]]),
        progress_scale=np.array([[5.0, 2.0]]),
        progress_whole=np.ones((1, 2)),
        velocity=np.array([[0.1, 0.25]]),
        smooth_velocity=np.array([[0.1, 0.25]]),
        moving=np.array([0.75]),
        clock_sine=np.array([[1.0, -1.0, 1.0, 1.0]]),
        fallen=np.array([1.0]),
    )
    expected = {
        "track_forward_velocity": math.exp(-1.0),
        "track_yaw_rate": math.exp(-(1.25**2)),
        "forward_progress": 0.5,
        "turn_progress": 0.5,
        "gait_clock": 0.75 * 0.5 * 2 / 4,  # feet half lifted
        "upright": 0.25,
        "base_height": 0.01,
        "vertical_velocity": 0.09,
        "roll_pitch_rate": 5.0,
        "lateral_velocity": 0.04,
        "action_rate": 8 * 0.0625,
        "mechanical_power": 8 * 9.0,
        "foot_slip": 0.02,  # one foot presses harder than the threshold
        "stand_still": 8 * 0.01 * 0.25,
        "joint_speed": 8 * (config.joint_speed_margin - 0.5) ** 2,
        "fall": 1.0,
    }
    terms = rewards.reward_terms(state, memory, config)
    assert set(terms) == set(expected)
    for name, value in expected.items():
        assert terms[name] == pytest.approx(np.array([value]), abs=1e-12), name


# --- rewards, for any batch ---


def test_every_weight_is_a_term_and_every_term_has_a_weight():
    rng = np.random.default_rng(0)
    terms = rewards.reward_terms(random_state(rng, 2), random_memory(rng, 2), RewardConfig())
    assert tuple(terms) == tuple(RewardConfig().weights) == make_task(1).term_names


def test_numpy_and_torch_give_the_same_terms_and_terminations():
    import torch

    rng = np.random.default_rng(1)
    state, memory = random_state(rng, 200), random_memory(rng, 200)
    torch_state, torch_memory = convert(state, torch.from_numpy), convert(memory, torch.from_numpy)
    config = RewardConfig()
    expected = rewards.reward_terms(state, memory, config)
    terms = rewards.reward_terms(torch_state, torch_memory, config)
    assert tuple(terms) == tuple(expected)
    for name, value in terms.items():
        assert isinstance(value, torch.Tensor), name
        assert value.dtype == torch.float64, name
        np.testing.assert_allclose(value.numpy(), expected[name], rtol=1e-12, atol=1e-12, err_msg=name)
    for function, reading in ((terminations.tilted, "up_b"), (terminations.trunk_contact, "trunk_force")):
        ended = function(getattr(state, reading), 1.0)
        assert 0 < ended.sum() < 200
        np.testing.assert_array_equal(function(getattr(torch_state, reading), 1.0).numpy(), ended)


@pytest.mark.parametrize("rows", [1, 2, 3, 7, 64])
def test_a_rows_terms_do_not_depend_on_the_rows_beside_it(rows):
    rng = np.random.default_rng(2)
    state, memory = random_state(rng, 256), random_memory(rng, 256)
    chosen = rng.permutation(256)[:rows]
    config = RewardConfig()
    everywhere = rewards.reward_terms(state, memory, config)
    here = rewards.reward_terms(convert(state, lambda x: x[chosen]), convert(memory, lambda x: x[chosen]), config)
    for name, value in here.items():
        assert value.shape == (rows,), name
        np.testing.assert_array_equal(value, everywhere[name][chosen], err_msg=name)


def test_weights_are_per_second_and_scale_their_terms():
    names = list(RewardConfig().weights)
    factors = np.arange(1.0, len(names) + 1.0)
    ones = make_task(reward=RewardConfig(weights=dict.fromkeys(names, 1.0)))
    weighted = make_task(reward=RewardConfig(weights=dict(zip(names, factors.tolist(), strict=True))))
    rng = np.random.default_rng(0)
    for _ in range(20):
        action = rng.uniform(-1, 1, (3, 8))
        unit, transition = ones.step(action), weighted.step(action)
        np.testing.assert_allclose(transition.terms, unit.terms * factors, rtol=1e-12)
        np.testing.assert_allclose(transition.reward, transition.terms.sum(axis=1), rtol=1e-12)
        height = column("projected_gravity", transition.observation)  # the observation is of the same state
        tilt = (height[:, :2].astype(float) ** 2).sum(axis=1)
        upright = unit.terms[:, names.index("upright")]
        np.testing.assert_allclose(upright, tilt * ones.config.control_timestep, rtol=1e-5, atol=1e-9)


def test_the_velocity_that_is_tracked_is_a_first_order_average():
    task = make_task(termination=NEVER_FALLS)
    share = 1.0 - math.exp(-task.config.control_timestep / task.config.reward.velocity_time_constant)
    average = np.zeros((3, 2))
    rng = np.random.default_rng(0)
    for _ in range(30):
        task.step(rng.uniform(-1, 1, (3, 8)))
        state = task.simulation.readings
        average += share * (np.stack([state.linear_velocity_b[:, 0], state.angular_velocity_b[:, 2]], axis=1) - average)
        np.testing.assert_allclose(task.smooth_velocity, average, rtol=1e-12)
    task.reset(np.array([1]))
    np.testing.assert_array_equal((task.smooth_velocity == 0.0).all(axis=1), [False, True, False])


def test_action_rate_compares_with_the_last_action_and_zero_after_a_reset():
    names = list(RewardConfig().weights)
    task = make_task(2, reward=RewardConfig(weights=dict.fromkeys(names, 1.0)), termination=NEVER_FALLS)
    dt = task.config.control_timestep

    def rate(action):
        return task.step(np.full((2, 8), action)).terms[:, names.index("action_rate")] / dt

    np.testing.assert_allclose(rate(0.5), [2.0, 2.0])
    np.testing.assert_allclose(rate(0.25), [0.5, 0.5])
    task.reset(np.array([1]))
    np.testing.assert_allclose(rate(0.25), [0.0, 0.5], atol=1e-12)
