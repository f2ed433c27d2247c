"""The task: its rewards, terminations, observations, commands, actions and randomization, and its config."""

import dataclasses
import json
import math

import gymnasium
import numpy as np
import pytest

from quadruped_env import JOINT_NAMES, CommandedGait, QuadrupedError
from quadruped_env.envs import ENV_ID
from quadruped_env.robot import FOOT_RADIUS, JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, load_model
from quadruped_env.simulation import BatchSimulation, SingleSimulation, State
from quadruped_env.task import (
    ACTION_WIDTH,
    OBSERVATION_LAYOUT,
    OBSERVATION_WIDTH,
    ActionConfig,
    CommandConfig,
    RandomizationConfig,
    RewardConfig,
    Task,
    TaskConfig,
    TerminationConfig,
    commands,
    randomization,
    rewards,
    terminations,
)
from quadruped_env.task.observations import (
    OBSERVATION_HIGH,
    OBSERVATION_LOW,
    OBSERVATION_NOISE,
    OBSERVATION_SCALE,
    scale_observation,
)

NEVER_FALLS = TerminationConfig(max_tilt=math.pi, max_trunk_force=1e9)
# Long enough that nothing is drawn anew within a test.
ONE_COMMAND = CommandConfig(resample_interval=(1e3, 1e3))
STILL_START = RandomizationConfig(
    start_joint_position=0.0, start_joint_velocity=0.0, start_base_velocity=0.0, start_tilt=0.0
)


def make_task(rows=3, max_episode_steps=None, fixed_command=None, **config):
    """A task on the batch, reset in every row."""
    task_config = TaskConfig(**config)
    simulation = BatchSimulation(load_model(task_config.physics_timestep), rows, 1)
    task = Task(simulation, task_config, max_episode_steps)
    task.reset(np.arange(rows), list(range(rows)), fixed_command)
    return task


def make_env(fixed_command=None, **config):
    """The single environment, whose MuJoCo data is open, reset."""
    env = gymnasium.make(ENV_ID, config=TaskConfig(**config), disable_env_checker=True).unwrapped
    env.reset(seed=0, options=None if fixed_command is None else {"command": fixed_command})
    return env


def column(name, observation):
    """The columns of one field of the layout."""
    start = 0
    for field in OBSERVATION_LAYOUT:
        if field.name == name:
            return observation[..., start : start + field.width]
        start += field.width
    raise AssertionError(name)


def random_state(rng, rows):
    widths = {
        "orientation": (4,),
        "foot_force": (4,),
        "trunk_force": (5,),
        "foot_position": (4, 3),
        "foot_velocity": (4, 3),
        "foot_angular_velocity": (4, 3),
    }
    values = {}
    for field in dataclasses.fields(State):
        width = (8,) if field.name.startswith("joint") else widths.get(field.name, (3,))
        values[field.name] = rng.standard_normal((rows, *width))
    # Around their thresholds.
    values["foot_force"] = rng.uniform(0.0, 2.0, (rows, 4))
    values["trunk_force"] = rng.uniform(0.0, 1.2, (rows, 5))
    values["foot_position"][..., 2] = rng.uniform(0.0, 0.06, (rows, 4))
    values["base_position"][:, 2] = rng.uniform(0.1, 0.2, rows)
    values["joint_position"] = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH, (rows, 8))
    values["up_b"] /= np.linalg.norm(values["up_b"], axis=1, keepdims=True)
    return State(**values)


def random_memory(rng, rows):
    command = rng.uniform(-0.5, 0.5, (rows, 2))
    command[::5] = 0.0
    scale, whole = rewards.progress_scale(command)
    return rewards.Memory(
        action=rng.uniform(-1, 1, (rows, 8)),
        last_action=rng.uniform(-1, 1, (rows, 8)),
        joint_offset=rng.standard_normal((rows, 8)),
        command=command,
        progress_scale=scale,
        progress_whole=whole,
        velocity=rng.standard_normal((rows, 2)) * 0.3,
        smooth_velocity=rng.standard_normal((rows, 2)) * 0.3,
        moving=(command != 0).any(axis=1) * 1.0,
        clock_sine=np.sin(rng.uniform(0, math.tau, (rows, 4))),
        fallen=(rng.random(rows) < 0.3) * 1.0,
    )


def convert(batch, function):
    """A State or Memory with a function applied to every array."""
    return type(batch)(**{f.name: function(getattr(batch, f.name)) for f in dataclasses.fields(batch)})


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
@pytest.mark.parametrize("overshoot", [0.0, 1.0])
def test_progress_is_the_share_of_the_command_that_is_reached(velocity, command, expected, overshoot):
    assert progress(velocity, command, overshoot) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_progress_beyond_the_command_stays_or_falls_as_it_rose(direction):
    velocity, command = direction * np.array([0.4, 0.5, 0.6, 0.8, 5.0]), direction * 0.4
    np.testing.assert_allclose(progress(velocity, command, 0.0), 1.0)
    np.testing.assert_allclose(progress(velocity, command, 1.0), [1.0, 0.75, 0.5, 0.0, -1.0], atol=1e-12)


def test_progress_pays_small_commands_in_proportion():
    assert progress(0.05, 0.05, 1.0) == pytest.approx(0.5)
    assert progress(0.01, 0.01, 1.0) == pytest.approx(0.1)
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


def test_foot_lift_goes_from_the_ground_to_a_full_lift():
    height = FOOT_RADIUS + np.array([[-0.001, 0.0, 0.005, 0.02], [0.01, 0.015, 0.021, 1.0]])
    np.testing.assert_allclose(rewards.foot_lift(height, 0.02), [[-1, -1, -0.5, 1], [0, 0.5, 1, 1]], atol=1e-12)


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


def test_joint_limit_excess_begins_a_margin_before_either_limit():
    middle = (JOINT_POSITION_LOW + JOINT_POSITION_HIGH) / 2
    positions = np.tile(middle, (4, 1))
    positions[1, 0] = JOINT_POSITION_HIGH[0] - 0.04
    positions[2, 3] = JOINT_POSITION_LOW[3] + 0.03
    positions[3] = JOINT_POSITION_HIGH + 0.1
    np.testing.assert_allclose(rewards.joint_limit_excess(positions, 0.1), [0.0, 0.06, 0.07, 8 * 0.2], atol=1e-12)


def test_every_term_reads_what_its_name_says():
    config = RewardConfig(base_height=0.2, foot_lift=0.02, forward_velocity_std=0.1, yaw_rate_std=0.2)
    state = dataclasses.replace(
        convert(random_state(np.random.default_rng(0), 1), np.zeros_like),
        up_b=np.array([[0.3, 0.4, 0.8]]),
        base_position=np.array([[5.0, 6.0, 0.1]]),
        linear_velocity_b=np.array([[0.1, 0.2, 0.3]]),
        angular_velocity_b=np.array([[1.0, 2.0, 0.25]]),
        joint_torque=np.full((1, 8), 2.0),
        joint_velocity=np.full((1, 8), 0.5),
        joint_position=(JOINT_POSITION_LOW + 0.025)[None],
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
        "gait_clock": 0.0,  # feet half lifted
        "upright": 0.25,
        "base_height": 0.01,
        "vertical_velocity": 0.09,
        "roll_pitch_rate": 5.0,
        "lateral_velocity": 0.04,
        "action_rate": 8 * 0.0625,
        "mechanical_power": 8.0,
        "foot_slip": 0.02,  # one foot presses harder than the threshold
        "stand_still": 8 * 0.01 * 0.25,
        "joint_limits": 8 * (config.joint_limit_margin - 0.025),
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
        state = task.simulation.state
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


# --- terminations ---


def test_tilted_is_an_angle_between_the_up_axes():
    angles = np.array([0.0, 0.5, 0.999, 1.001, 2.0, math.pi])
    up = np.stack([np.sin(angles), np.zeros(6), np.cos(angles)], axis=1)
    np.testing.assert_array_equal(terminations.tilted(up, 1.0), angles > 1.0)


def test_trunk_contact_is_more_than_a_force_on_any_part():
    force = np.zeros((4, 5))
    force[1, 0], force[2, 4], force[3] = 1.5, 1.0, 0.5
    np.testing.assert_array_equal(terminations.trunk_contact(force, 1.0), [False, True, False, False])


def test_a_robot_that_lies_on_its_belly_has_fallen():
    env = make_env(randomization=STILL_START)
    assert not env.step(np.zeros(8))[2]
    env.data.qpos[2] = 0.038  # half of the trunk's height is 0.04
    env.data.qpos[7:] = [1.5, 0.0] * 4  # legs stretched
    env.data.qvel[:] = 0.0
    *_, terminated, truncated, info = env.step(np.zeros(8))
    assert terminated
    assert not truncated
    assert info["reward_fall"] == env.task.config.reward.weights["fall"] * env.dt
    assert not info["diverged"]


def test_a_robot_that_tips_over_has_fallen():
    env = make_env(randomization=STILL_START, termination=TerminationConfig(max_tilt=0.5, max_trunk_force=1e9))
    for angle, fallen in ((0.4, False), (0.6, True)):
        env.reset(seed=0)
        env.data.qpos[2] = 1.0
        env.data.qpos[3:7] = [math.cos(angle / 2), math.sin(angle / 2), 0.0, 0.0]
        *_, terminated, _, info = env.step(np.zeros(8))
        assert terminated is fallen
        assert (info["reward_fall"] != 0.0) is fallen


def test_an_episode_is_truncated_when_its_steps_are_used_up():
    task = make_task(2, max_episode_steps=5, termination=NEVER_FALLS)
    ends = []
    for step in range(8):
        if step == 3:
            task.reset(np.array([1]))
        transition = task.step(np.zeros((2, 8)))
        ends.append(transition.truncated.tolist())
        assert not transition.terminated.any()
    assert [end[0] for end in ends] == [False] * 4 + [True] * 4, "out of time until it is reset"
    assert [end[1] for end in ends] == [False] * 7 + [True]


# --- observations ---


def test_the_layout_is_bounded_and_adds_up():
    assert sum(field.width for field in OBSERVATION_LAYOUT) == OBSERVATION_WIDTH
    names = [field.name for field in OBSERVATION_LAYOUT]
    assert len(set(names)) == len(names)
    for field in OBSERVATION_LAYOUT:
        assert -math.inf < field.low < field.high < math.inf, field.name
        assert field.scale > 0, field.name
        assert field.noise >= 0, field.name
        assert field.offset is None or len(field.offset) == field.width, field.name
    observation = make_task(4).observe()
    assert observation.shape == (4, OBSERVATION_WIDTH)
    assert observation.dtype == np.float32


def test_an_observation_is_the_readings_offset_scaled_and_clipped():
    task = make_task(64, termination=NEVER_FALLS)
    rng = np.random.default_rng(0)
    for _ in range(20):
        action = rng.choice([-1.0, -0.5, 1.0], (64, 8))
        observation = task.step(action).observation
        state = task.simulation.state
        clock = np.stack([np.sin(task.phase), np.cos(task.phase)], axis=1)
        clock[(task.command == 0).all(axis=1)] = 0.0
        readings = {
            "projected_gravity": -state.up_b,
            "angular_velocity": state.angular_velocity_b,
            "joint_position": state.joint_position,
            "joint_velocity": state.joint_velocity,
            "last_action": action,
            "command": task.command,
            "gait_clock": clock,
        }
        assert list(readings) == [field.name for field in OBSERVATION_LAYOUT]
        for field in OBSERVATION_LAYOUT:
            offset = 0.0 if field.offset is None else np.array(field.offset)
            wanted = (readings[field.name] - offset) * field.scale
            wanted = np.clip(wanted, field.low, field.high).astype(np.float32)
            np.testing.assert_array_equal(column(field.name, observation), wanted, err_msg=field.name)
    for raw, bound in ((1e6, OBSERVATION_HIGH), (-1e6, OBSERVATION_LOW)):
        np.testing.assert_array_equal(
            scale_observation(np.full((2, OBSERVATION_WIDTH), raw)), [bound.astype(np.float32)] * 2
        )


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
    # The closed form in which the start's attitude is drawn is the same.
    angles = (np.array([angle]) for angle in (roll, pitch, yaw))
    np.testing.assert_allclose(randomization._quaternion(*angles)[0], quaternion, atol=1e-12)


def test_no_column_is_stuck():
    task = make_task(16, termination=NEVER_FALLS)
    rng = np.random.default_rng(0)
    observations = np.array([task.step(rng.uniform(-1, 1, (16, 8))).observation for _ in range(60)])
    assert (observations.std(axis=(0, 1)) > 1e-3).all()
    # Within one row as well, but for the command, which stays for seconds.
    moving = observations.std(axis=0) > 1e-5
    np.testing.assert_array_equal(column("projected_gravity", moving), True)
    np.testing.assert_array_equal(column("joint_position", moving), True)


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
        velocity_scale = next(field.scale for field in OBSERVATION_LAYOUT if field.name == "joint_velocity")
        np.testing.assert_allclose(column("joint_velocity", observation), velocity_scale * unit, atol=1e-6)
        env.step(unit)
        expected = STANCE + env.task.config.action.position_scale * unit
        np.testing.assert_allclose(
            data.ctrl, np.clip(expected, JOINT_POSITION_LOW, JOINT_POSITION_HIGH), atol=1e-12, err_msg=name
        )
        assert model.actuator(i).name == name


def test_the_clock_turns_at_its_frequency_and_stops_at_a_zero_command():
    task = make_task(3, fixed_command=(0.3, 0.0), clock_frequency=1.7, termination=NEVER_FALLS)
    np.testing.assert_array_equal(task.phase, np.clip(task.phase, 0, math.tau))
    assert len(np.unique(task.phase)) == 3, "each row starts at a phase of its own"
    start = task.phase.copy()
    for step in range(1, 60):
        clock = column("gait_clock", task.step(np.zeros((3, 8))).observation)
        phase = start + math.tau * 1.7 * task.config.control_timestep * step
        np.testing.assert_allclose(clock, np.stack([np.sin(phase), np.cos(phase)], axis=1), atol=1e-6)
        assert (task.phase >= 0).all()
        assert (task.phase < math.tau).all()
    task.reset(np.arange(3), command=(0.0, 0.0))
    np.testing.assert_array_equal(column("gait_clock", task.observe()), 0.0)
    task.reset(np.arange(3), command=(0.0, 0.5))
    np.testing.assert_allclose((column("gait_clock", task.observe()) ** 2).sum(axis=1), 1.0, rtol=1e-6)


# --- observation noise ---


def test_observation_noise_stays_within_each_fields_amplitude():
    quiet = make_task(32, randomization=RandomizationConfig(observation_noise=0.0))
    noisy = make_task(32, randomization=RandomizationConfig(observation_noise=1.0))
    np.testing.assert_array_equal(noisy.simulation.state.joint_position, quiet.simulation.state.joint_position)
    differences = []
    for _ in range(20):
        action = np.zeros((32, 8))
        difference = noisy.step(action).observation.astype(float) - quiet.step(action).observation
        assert (abs(difference) <= OBSERVATION_NOISE * OBSERVATION_SCALE + 1e-6).all()
        differences.append(difference)
    differences = np.array(differences)
    noiseless = OBSERVATION_NOISE == 0
    np.testing.assert_array_equal(differences[..., noiseless], 0.0)
    inside = (abs(quiet.observe()) < OBSERVATION_HIGH - 0.5).all(axis=0) & ~noiseless
    spread = differences[..., inside].std(axis=(0, 1))
    np.testing.assert_allclose(spread, (OBSERVATION_NOISE * OBSERVATION_SCALE)[inside] / math.sqrt(3), rtol=0.15)


def test_observing_twice_gives_the_same_noise():
    task = make_task(randomization=RandomizationConfig(observation_noise=1.0))
    np.testing.assert_array_equal(task.observe(), task.observe())


def test_counter_noise_is_uniform_and_white():
    key = np.random.default_rng(0).integers(0, 2**53, 200).astype(np.uint64)
    noise = np.array([randomization.counter_noise(key, np.full(200, step), 34) for step in range(50)])
    assert noise.shape == (50, 200, 34)
    assert noise.min() >= -1.0
    assert noise.max() < 1.0
    count = noise.size
    assert abs(noise.mean()) < 4 * math.sqrt(1 / 3 / count)
    assert noise.var() == pytest.approx(1 / 3, rel=0.01)
    assert len(np.unique(noise)) == count, "no number twice"
    for axis in range(3):
        shifted = np.roll(noise, 1, axis=axis)
        assert abs((noise * shifted).mean()) < 4 / 3 / math.sqrt(count), f"correlated along axis {axis}"
    histogram = np.histogram(noise, bins=20, range=(-1, 1))[0]
    assert (abs(histogram - count / 20) < 5 * math.sqrt(count / 20)).all()


def test_counter_noise_depends_on_key_and_step_alone():
    key, step = np.array([7, 8, 9], dtype=np.uint64), np.array([0, 5, 1000])
    noise = randomization.counter_noise(key, step, 34)
    for row in range(3):
        np.testing.assert_array_equal(randomization.counter_noise(key[[row]], step[[row]], 34)[0], noise[row])
    # A step's numbers are not those of the step before, shifted.
    after = randomization.counter_noise(key, step + 1, 34)
    assert not np.isin(after, noise).any()


# --- commands ---


def test_commands_are_sampled_in_their_ranges_and_shares():
    config = CommandConfig(
        forward_velocity=(-0.2, 0.7), yaw_rate=(-1.0, 0.5), standing_fraction=0.15, straight_fraction=0.3
    )
    n = 40_000
    command, interval = commands.sample_command(np.random.default_rng(0).random((n, commands.DRAWS)), config)
    assert command.shape == (n, 2)
    standing = (command == 0).all(axis=1)
    straight = (command[:, 1] == 0) & ~standing
    error = 4 * math.sqrt(0.25 / n)
    assert standing.mean() == pytest.approx(0.15, abs=error)
    assert straight.mean() == pytest.approx(0.3, abs=error)
    for values, (low, high) in ((command[~standing, 0], (-0.2, 0.7)), (command[command[:, 1] != 0, 1], (-1.0, 0.5))):
        assert low <= values.min() < low + 0.01
        assert high - 0.01 < values.max() <= high
        assert values.mean() == pytest.approx((low + high) / 2, abs=0.02)
    low, high = config.resample_interval
    assert low <= interval.min()
    assert interval.max() <= high
    assert interval.mean() == pytest.approx((low + high) / 2, rel=0.02)


def test_commands_change_when_their_interval_is_over():
    config = CommandConfig(resample_interval=(0.1, 0.1), standing_fraction=0.0)
    task = make_task(4, command=config, termination=NEVER_FALLS)
    steps = round(0.1 / task.config.control_timestep)
    trace = [task.command.copy()]
    for _ in range(4 * steps):
        task.step(np.zeros((4, 8)))
        trace.append(task.command.copy())
    changed = (np.diff(np.array(trace), axis=0) != 0).any(axis=2)
    np.testing.assert_array_equal(np.flatnonzero(changed.any(axis=1)) + 1, steps * np.arange(1, 5))
    assert changed[steps - 1 :: steps].all()


def test_a_fixed_command_is_not_replaced():
    task = make_task(fixed_command=(0.25, 0.125), command=CommandConfig(resample_interval=(0.02, 0.02)))
    task.reset(np.array([1]))
    for _ in range(10):
        task.step(np.zeros((3, 8)))
        np.testing.assert_array_equal(task.command[[0, 2]], [[0.25, 0.125]] * 2)
    assert (task.command[1] != [0.25, 0.125]).any()


@pytest.mark.parametrize("command", [(9.0, 0.0), (0.0, math.nan), (0.1,), None, "x"])
def test_a_bad_command_is_refused_by_name(command):
    with pytest.raises(QuadrupedError, match=r"options\['command'\]"):
        commands.check_command(command, CommandConfig())


# --- actions ---


def test_a_zero_action_in_position_mode_is_the_stance():
    env = make_env()
    env.step(np.zeros(8))
    np.testing.assert_array_equal(env.data.ctrl, STANCE)


def test_an_action_scales_around_the_stance_and_is_clipped_to_one():
    env = make_env(action=ActionConfig(position_scale=0.2))
    env.step(np.array([0.5, -0.5, 1.0, -1.0, 7.0, -7.0, 0.0, 0.25]))
    unit = np.array([0.5, -0.5, 1.0, -1.0, 1.0, -1.0, 0.0, 0.25])
    np.testing.assert_allclose(env.data.ctrl, STANCE + 0.2 * unit, rtol=1e-12)


@pytest.mark.parametrize("command", [(0.0, 0.0), (0.3, 0.0), (-0.2, 0.3), (0.1, -0.5)])
def test_a_zero_action_in_residual_mode_is_exactly_the_tuned_gait(command):
    env = make_env(fixed_command=command, action=ActionConfig(mode="residual"), termination=NEVER_FALLS)
    gait = CommandedGait.tuned()
    targets = []
    for _ in range(40):
        env.step(np.zeros(8))
        expected = gait.positions(env.task.phase, env.task.command)[0]
        np.testing.assert_array_equal(env.data.ctrl, np.clip(expected, JOINT_POSITION_LOW, JOINT_POSITION_HIGH))
        targets.append(expected)
    swing = np.ptp(targets, axis=0)
    assert (swing == 0.0).all() if command == (0.0, 0.0) else swing.max() > 0.05


def test_the_gait_in_residual_mode_follows_a_command_that_changes():
    env = make_env(action=ActionConfig(mode="residual"), command=CommandConfig(resample_interval=(0.04, 0.08)))
    gait = CommandedGait.tuned()
    seen = set()
    for _ in range(40):
        before = env.task.command.copy()
        env.step(np.zeros(8))
        expected = gait.positions(env.task.phase, before)[0]
        np.testing.assert_array_equal(env.data.ctrl, np.clip(expected, JOINT_POSITION_LOW, JOINT_POSITION_HIGH))
        seen.add(tuple(before[0]))
    assert len(seen) > 5


@pytest.mark.parametrize("mode", ["position", "residual"])
def test_joint_targets_never_leave_the_limits(mode):
    env = make_env(action=ActionConfig(mode=mode, position_scale=3.0, residual_scale=3.0), termination=NEVER_FALLS)
    rng = np.random.default_rng(0)
    at_limit = 0
    for _ in range(50):
        env.step(rng.uniform(-1, 1, 8))
        assert (env.data.ctrl >= JOINT_POSITION_LOW).all()
        assert (env.data.ctrl <= JOINT_POSITION_HIGH).all()
        at_limit += (env.data.ctrl == JOINT_POSITION_LOW).sum() + (env.data.ctrl == JOINT_POSITION_HIGH).sum()
    assert at_limit > 20


def test_a_joint_target_goes_to_the_motors_as_it_is_and_counts_as_no_action():
    env = make_env(termination=NEVER_FALLS)
    env.step(np.full(8, 0.5))
    target = STANCE + 0.1
    transition = env.task.step_joint_target(target[None])
    np.testing.assert_array_equal(env.data.ctrl, target)
    np.testing.assert_array_equal(column("last_action", transition.observation), 0.0)
    env.task.step_joint_target(np.full((1, 8), 9.0))
    np.testing.assert_array_equal(env.data.ctrl, JOINT_POSITION_HIGH)
    with pytest.raises(QuadrupedError, match=r"joint target: expected shape \(1, 8\).*found \(8,\)"):
        env.task.step_joint_target(target)


# --- randomization ---


def test_starts_are_drawn_in_their_ranges():
    config = RandomizationConfig(
        start_joint_position=0.2, start_joint_velocity=0.7, start_base_velocity=0.3, start_tilt=0.15
    )
    draws = np.random.default_rng(0).random((5000, randomization.START_DRAWS))
    qpos, qvel = randomization.start_states(draws, config)
    for values, bound in (
        (qpos[:, 7:] - STANCE, 0.2),
        (qvel[:, 6:], 0.7),
        (qvel[:, :6], 0.3),
    ):
        assert (abs(values) <= bound + 1e-12).all()
        assert (abs(values).max(axis=0) > 0.99 * bound).all()
        np.testing.assert_allclose(values.mean(axis=0), 0.0, atol=0.05 * bound)
    np.testing.assert_allclose(np.linalg.norm(qpos[:, 3:7], axis=1), 1.0)
    up = 1 - 2 * (qpos[:, 4] ** 2 + qpos[:, 5] ** 2)
    tilt = np.arccos(np.clip(up, -1, 1))
    assert 0.15 < tilt.max() <= math.sqrt(2) * 0.15 + 1e-9
    yaw = 2 * np.arctan2(qpos[:, 6], qpos[:, 3])
    assert np.ptp(yaw) > 6.0, "every heading"
    # No draw decides two things.
    correlation = np.corrcoef(np.concatenate([qpos[:, 7:], qvel], axis=1).T) - np.eye(22)
    assert abs(correlation).max() < 0.08


def test_without_randomization_every_start_is_the_stance_on_the_ground():
    task = make_task(3, randomization=STILL_START)
    state = task.simulation.state
    np.testing.assert_allclose(state.joint_position, np.tile(STANCE, (3, 1)), atol=1e-12)
    np.testing.assert_allclose(state.linear_velocity_b, 0.0, atol=1e-12)
    np.testing.assert_allclose(state.up_b, [[0, 0, 1]] * 3, atol=1e-12)
    np.testing.assert_allclose(state.foot_position[..., 2], FOOT_RADIUS, atol=1e-6)


MODELS = RandomizationConfig(friction=(0.3, 0.9), payload=(-0.2, 1.0))


@pytest.mark.parametrize("rows", [1, 4], ids=["single", "batch"])
def test_friction_and_payload_are_in_the_model_of_the_row(rows):
    plain = load_model()
    base = plain.body("base_link").id
    model = load_model()
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


def test_a_reset_of_some_rows_leaves_the_models_of_the_others():
    task = make_task(4, randomization=MODELS)
    friction, mass = (task.simulation.model_field(name) for name in ("geom_friction", "body_mass"))
    before = friction.copy(), mass.copy()
    task.reset(np.array([1, 3]))
    for values, old in zip((friction, mass), before, strict=True):
        np.testing.assert_array_equal(values[[0, 2]], old[[0, 2]])
        assert (values[[1, 3]] != old[[1, 3]]).any(axis=tuple(range(1, values.ndim))).all()


def test_a_payload_presses_on_the_ground():
    heavy = make_task(2, randomization=dataclasses.replace(STILL_START, payload=(1.0, 1.0)), termination=NEVER_FALLS)
    plain = make_task(2, randomization=STILL_START, termination=NEVER_FALLS)
    for _ in range(60):
        heavy.step(np.zeros((2, 8))), plain.step(np.zeros((2, 8)))
    weight = [task.simulation.state.foot_force.sum(axis=1) for task in (heavy, plain)]
    np.testing.assert_allclose(weight[0] - weight[1], 9.81, rtol=0.05)


def test_pushes_add_a_horizontal_velocity_at_their_intervals():
    interval, size = 0.2, 0.5
    pushed = make_env(
        command=ONE_COMMAND,
        randomization=dataclasses.replace(STILL_START, push_velocity=size, push_interval=(interval, interval)),
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
            velocities.append(pushed.data.qvel[:3] - still.data.qvel[:3])
            np.testing.assert_array_equal(pushed.data.qvel[3:], still.data.qvel[3:])
            np.testing.assert_array_equal(pushed.data.qpos, still.data.qpos)
        elif step < every:
            still.step(np.zeros(8))
            np.testing.assert_array_equal(pushed.data.qvel, still.data.qvel)
    velocities = np.array(velocities)
    assert len(np.unique(velocities[:, 0])) == len(np.unique(velocities[:, 1])) == 10
    assert (abs(velocities[:, :2]) <= size).all()
    assert abs(velocities[:, :2]).max() > 0.5 * size
    np.testing.assert_array_equal(velocities[:, 2], 0.0)


# --- the config ---


CONFIG = TaskConfig(
    decimation=5,
    physics_timestep=0.002,
    clock_frequency=1.5,
    action=ActionConfig(mode="residual", residual_scale=0.3),
    command=CommandConfig(forward_velocity=(0.0, 1.0), standing_fraction=0.2),
    reward=RewardConfig(weights=RewardConfig().weights | {"upright": -3.0}, base_height=0.15),
    termination=TerminationConfig(max_tilt=0.7),
    randomization=RandomizationConfig(friction=(0.5, 1.0), payload=None, push_velocity=0.4),
)


def test_a_config_survives_json():
    document = json.loads(json.dumps(CONFIG.to_dict()))
    again = TaskConfig.from_dict(document)
    assert again == CONFIG
    assert again.to_dict() == CONFIG.to_dict()
    assert TaskConfig.from_dict({}) == TaskConfig()
    assert TaskConfig.from_dict(TaskConfig().to_dict()) == TaskConfig()


def test_what_a_config_leaves_out_keeps_its_default():
    config = TaskConfig.from_dict({"decimation": 2, "reward": {"weights": {"upright": -7}}})
    default = TaskConfig()
    assert config.decimation == 2
    assert config.control_timestep == default.physics_timestep * 2
    assert config.reward.weights == default.reward.weights | {"upright": -7.0}
    assert tuple(config.reward.weights) == tuple(default.reward.weights), "the order in which terms are added"
    assert config.command == default.command


def test_configs_share_nothing_and_do_not_change():
    one, other = TaskConfig(), TaskConfig()
    assert one.reward.weights is not other.reward.weights
    with pytest.raises(dataclasses.FrozenInstanceError):
        one.decimation = 3
    document = one.to_dict()
    document["reward"]["weights"]["upright"] = 9.0
    assert one == other


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"tempo": 1}, r"config: unknown field 'tempo'; valid fields are decimation, physics_timestep"),
        ({"command": {"speed": 1}}, r"config.command: unknown field 'speed'; valid fields are forward_velocity"),
        ({"command": 0.3}, r"config.command: expected a mapping of fields; found 0.3"),
        ({"command": {"yaw_rate": 0.3}}, r"config.command.yaw_rate: expected a pair \(low, high\); found 0.3"),
        ({"command": {"yaw_rate": [0.3, 0.1]}}, r"command.yaw_rate must be a pair .* low <= high; found \(0.3, 0.1\)"),
        ({"command": {"yaw_rate": [0.3, "x"]}}, r"config.command.yaw_rate: expected a number; found 'x'"),
        ({"command": {"resample_interval": [0, 1]}}, r"command.resample_interval must be positive"),
        ({"command": {"standing_fraction": -0.1}}, r"command.standing_fraction must be at least 0; found -0.1"),
        ({"command": {"standing_fraction": 0.7, "straight_fraction": 0.7}}, r"must be at most 1; found 1.4"),
        ({"action": {"mode": "torque"}}, r"'torque' is unknown; valid modes are position, residual"),
        ({"action": {"position_scale": 0}}, r"action.position_scale must be positive \(rad\); found 0"),
        ({"action": {"residual_scale": math.nan}}, r"action.residual_scale.*found nan"),
        ({"decimation": True}, r"config.decimation: expected a whole number; found True"),
        ({"decimation": 0}, r"config: decimation must be 1 or more; found 0"),
        ({"physics_timestep": "fast"}, r"config.physics_timestep: expected a number; found 'fast'"),
        ({"physics_timestep": -0.1}, r"physics_timestep must be positive"),
        ({"clock_frequency": 0}, r"clock_frequency must be positive"),
        ({"clock_frequency": math.inf}, r"clock_frequency.*found inf"),
        ({"reward": {"weights": {"speed": 1}}}, r"reward.weights: unknown reward term 'speed'; valid terms are"),
        ({"reward": {"weights": {"upright": "much"}}}, r"config.reward.weights\['upright'\]: expected a number"),
        ({"reward": {"weights": {"upright": math.nan}}}, r"reward.weights\['upright'\].*found nan"),
        ({"reward": {"weights": [1, 2]}}, r"config.reward.weights: expected a mapping"),
        ({"reward": {"base_height": 0}}, r"reward.base_height must be positive; found 0"),
        ({"termination": {"max_tilt": 4}}, r"termination.max_tilt must be in \(0, pi\] \(rad\); found 4"),
        ({"termination": {"max_trunk_force": -1}}, r"termination.max_trunk_force must be at least 0"),
        ({"randomization": {"start_tilt": -1}}, r"randomization.start_tilt must be at least 0; found -1"),
        ({"randomization": {"friction": [0, 1]}}, r"randomization.friction must be positive"),
        ({"randomization": {"friction": [1, 0.5]}}, r"randomization.friction must be a pair"),
        ({"randomization": {"payload": [-3, 0]}}, r"randomization.payload must be over -1 kg"),
        ({"randomization": {"push_velocity": -1}}, r"randomization.push_velocity must be at least 0"),
        ({"randomization": {"push_interval": [0, 1]}}, r"randomization.push_interval must be positive"),
        ({"randomization": {"observation_noise": -1}}, r"randomization.observation_noise must be at least 0"),
    ],
)
def test_a_bad_config_names_the_field_the_value_and_the_rule(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TaskConfig.from_dict(values)


# --- memory ---


def test_tasks_of_one_config_share_no_arrays():
    config = TaskConfig()
    tasks = [Task(BatchSimulation(load_model(), 2, 1), config) for _ in range(2)]
    arrays = [{k: v for k, v in vars(task).items() if isinstance(v, np.ndarray)} for task in tasks]
    assert len(arrays[0]) > 10
    for name, array in arrays[0].items():
        for other in arrays[1].values():
            assert not np.shares_memory(array, other), name


def test_a_transition_is_not_overwritten_by_the_next_step():
    task = make_task()
    first = task.step(np.full((3, 8), 0.3))
    copies = {f.name: getattr(first, f.name).copy() for f in dataclasses.fields(first)}
    task.step(np.full((3, ACTION_WIDTH), -0.3))
    task.reset(np.arange(3))
    for name, value in copies.items():
        np.testing.assert_array_equal(getattr(first, name), value, err_msg=name)


def test_a_reset_clears_what_has_memory_and_only_there():
    task = make_task(3, termination=NEVER_FALLS)
    for _ in range(5):
        task.step(np.full((3, 8), 0.3))
    before = [task.get_state(row) for row in (0, 2)]
    task.reset(np.array([1]))
    fresh, others = task.get_state(1), [task.get_state(row) for row in (0, 2)]
    np.testing.assert_array_equal(fresh["_last_action"], 0.0)
    np.testing.assert_array_equal(fresh["_smooth_velocity"], 0.0)
    np.testing.assert_array_equal(task.steps, [5, 0, 5])
    for old, new in zip(before, others, strict=True):
        assert old["generator"] == new["generator"]
        np.testing.assert_array_equal(new["simulation"].integration, old["simulation"].integration)
        for name in old.keys() - {"generator", "simulation"}:
            np.testing.assert_array_equal(new[name], old[name], err_msg=name)
