"""Observations of several control steps, stacked: against arrays stacked by hand, in envs, policies and export."""

import copy
import pickle

import gymnasium
import numpy as np
import pytest
from comparisons import random_policy
from settings import settings

from quadruped_env import QuadrupedError
from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.live_controller import LiveController, Measurement, Mode, Safety
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.policies import Policy, load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.readings import Readings
from quadruped_env.task import ActionConfig, TaskConfig

K, WIDTH = 4, 34
NOISY = settings(noise=1.0, resample=(0.1, 0.3), max_tilt=0.4, push_velocity=0.5, push_interval=[0.1, 0.3])

PRESENT = {**NOISY, "observation_history": 1}


class Stack:
    """The reference: a list of the observations of an episode, as long as it lasts."""

    def __init__(self, steps=K):
        self.steps, self.seen = steps, []

    def reset(self, observation):
        self.seen = [observation]
        return self.value

    def add(self, observation):
        self.seen.append(observation)
        return self.value

    @property
    def value(self):
        padded = [self.seen[0]] * (self.steps - 1) + self.seen
        return np.concatenate(padded[::-1][: self.steps])


def test_observations_of_all_envs_are_those_stacked_by_hand():
    """Each env without a history gives the frames; episodes end by falls, at different times."""
    plain = gymnasium.make_vec("MiniQuadruped-v0", num_envs=3, config=PRESENT, max_episode_steps=25)
    stacked_config = {**NOISY, "observation_history": K}
    vector = gymnasium.make_vec("MiniQuadruped-v0", num_envs=3, config=stacked_config, max_episode_steps=25)
    sb3 = make_sb3_vec_env(3, seed=3, config=stacked_config, max_episode_steps=25)
    single = gymnasium.make("MiniQuadruped-v0", config=stacked_config, max_episode_steps=25)
    assert vector.single_observation_space.shape == single.observation_space.shape == (K * WIDTH,)
    assert sb3.observation_space == single.observation_space
    stacks = [Stack() for _ in range(3)]
    frames, _ = plain.reset(seed=3)
    expected = np.stack([stack.reset(frame) for stack, frame in zip(stacks, frames, strict=True)])
    np.testing.assert_array_equal(vector.reset(seed=3)[0], expected)
    np.testing.assert_array_equal(sb3.reset(), expected)
    np.testing.assert_array_equal(single.reset(seed=3)[0], expected[0])
    rng, ends = np.random.default_rng(0), 0
    for _ in range(80):
        action = rng.uniform(-1, 1, (3, 8)).astype(np.float32)
        frames, reward, *flags, info = plain.step(action)
        found, other_reward, *_, other_info = vector.step(action)
        in_sb3, *_, infos = sb3.step(action)
        one, _, terminated, truncated, _ = single.step(action[0])
        done = flags[0] | flags[1]
        ends += done.sum()
        for i, stack in enumerate(stacks):
            if done[i]:
                last = stack.add(info["final_obs"][i])
                np.testing.assert_array_equal(other_info["final_obs"][i], last)
                np.testing.assert_array_equal(infos[i]["terminal_observation"], last)
                if i == 0:
                    np.testing.assert_array_equal(one, last)
                stack.reset(frames[i])
            else:
                stack.add(frames[i])
                if i == 0:
                    np.testing.assert_array_equal(one, stack.value)
            np.testing.assert_array_equal(found[i], stack.value)
            np.testing.assert_array_equal(in_sb3[i], stack.value)
        assert done[0] == (terminated or truncated)
        if done[0]:
            np.testing.assert_array_equal(single.reset()[0], stacks[0].value)
        np.testing.assert_array_equal(reward, other_reward)
        assert found in vector.observation_space
    assert ends > 6


def test_envs_that_reset_in_the_next_step_stack_alike():
    config = {**NOISY, "observation_history": 3}
    plain = gymnasium.make_vec(
        "MiniQuadruped-v0", num_envs=2, config=PRESENT, max_episode_steps=9, autoreset_mode="NextStep"
    )
    vector = gymnasium.make_vec(
        "MiniQuadruped-v0", num_envs=2, config=config, max_episode_steps=9, autoreset_mode="NextStep"
    )
    stacks = [Stack(3), Stack(3)]
    frames, _ = plain.reset(seed=1)
    vector.reset(seed=1)
    for stack, frame in zip(stacks, frames, strict=True):
        stack.reset(frame)
    done = np.zeros(2, dtype=bool)
    for _ in range(30):
        frames, _, terminated, truncated, _ = plain.step(np.zeros((2, 8), np.float32))
        found, *_ = vector.step(np.zeros((2, 8), np.float32))
        for i, stack in enumerate(stacks):
            np.testing.assert_array_equal(found[i], stack.reset(frames[i]) if done[i] else stack.add(frames[i]))
        done = terminated | truncated


def test_observing_twice_in_a_step_counts_once():
    env = gymnasium.make_vec("MiniQuadruped-v0", num_envs=2, config={"observation_history": 3})
    env.reset(seed=0)
    task = env.unwrapped.task
    for _ in range(4):
        observation, *_ = env.step(np.full((2, 8), 0.3, np.float32))
    np.testing.assert_array_equal(task.observe(), observation)
    np.testing.assert_array_equal(task.observe(), observation)
    # A command that changes within the step changes the present observation alone.
    task.control.command[:] = (0.5, 0.1)
    changed = task.observe()
    np.testing.assert_array_equal(changed[:, WIDTH:], observation[:, WIDTH:])
    columns = task.control.layout.slices["command"]
    np.testing.assert_allclose(changed[:, columns], [[2.0, 0.4]] * 2, rtol=1e-6)


def test_copies_and_states_hold_the_history():
    env = gymnasium.make("MiniQuadruped-v0", config={"observation_history": 3})
    env.reset(seed=0)
    for _ in range(5):
        env.step(env.action_space.sample())
    copies = [copy.deepcopy(env.unwrapped), pickle.loads(pickle.dumps(env.unwrapped))]  # noqa: S301
    other = gymnasium.make("MiniQuadruped-v0", config={"observation_history": 3}).unwrapped
    other.reset(seed=9)
    other.set_state(env.unwrapped.get_state())
    expected, *_ = env.step(np.zeros(8))
    for twin in (*copies, other):
        np.testing.assert_array_equal(twin.step(np.zeros(8))[0], expected)


def test_mirror_of_a_history_is_the_mirror_of_each_step():
    rng = np.random.default_rng(0)
    one = MirrorMap.of(ObservationLayout(MINI_QUADRUPED))
    stacked = MirrorMap.of(ObservationLayout(MINI_QUADRUPED, history=K))
    frames = rng.standard_normal((K, 5, WIDTH))
    expected = np.concatenate([one.observation(frame) for frame in frames], axis=1)
    np.testing.assert_array_equal(stacked.observation(np.concatenate(frames, axis=1)), expected)
    np.testing.assert_array_equal(stacked.observation(stacked.observation(expected)), expected)


def policy_with_history(mode="residual", history=3):
    """A random policy of a task with a history."""
    rng = np.random.default_rng(2)
    shapes = ((history * WIDTH, 12), (12, 8))
    weights = [rng.normal(0.0, 0.1, shape).astype(np.float32) for shape in shapes]
    biases = [rng.normal(0.0, 0.1, shape[1]).astype(np.float32) for shape in shapes]
    task = TaskConfig(action=ActionConfig(mode=mode), observation_history=history)
    return Policy.for_task(weights, biases, "elu", task, {"timesteps": 1})


def test_policy_keeps_its_history_and_refuses_other_observations(tmp_path):
    policy = policy_with_history()
    policy.save(tmp_path)
    loaded = load_policy(tmp_path)
    env = loaded.make_env()
    loaded.check_env(env)
    assert env.observation_space.shape == (3 * WIDTH,)
    observation, _ = env.reset(seed=0)
    np.testing.assert_array_equal(loaded.predict(observation), policy.predict(observation))
    for config, found in (({"observation_history": 1}, 1), ({"observation_history": 2}, 2)):
        other = gymnasium.make("MiniQuadruped-v0", action_mode="residual", config=config)
        with pytest.raises(QuadrupedError, match=rf"trained with observation_history 3, and .* has {found}; make"):
            loaded.check_env(other)
    with pytest.raises(QuadrupedError, match=r"trained with observation_history 1, and .* has 3"):
        random_policy("residual", observation_history=1).check_env(env)


def test_live_controller_stacks_as_the_interface_does():
    policy = policy_with_history("position")
    safety = Safety(min_ramp_time=0.1, settle=0.0, command_timeout=100.0, fresh_states=1)
    live = LiveController(PolicyController(policy), safety=safety)
    rng = np.random.default_rng(0)
    zeros, upright, stance = np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0]), np.array(MINI_QUADRUPED.stance)
    i = 1
    while live.mode is not Mode.WALKING:
        live.measured(Measurement(i * 20_000_000, stance, np.zeros(8), upright, zeros), i * 0.02)
        i += 1
    control = ControlInterface(MINI_QUADRUPED, policy.control)
    readings, frames = Readings.of_a_real_robot(MINI_QUADRUPED), Stack(3)
    plain = ControlInterface(MINI_QUADRUPED, ControlConfig(observation_history=1))
    for step in range(8):
        live.command((0.3, 0.1), now=i * 0.02)
        positions, velocities = stance + rng.uniform(-0.1, 0.1, 8), rng.uniform(-1, 1, 8)
        readings.joint_position[0], readings.joint_velocity[0] = positions, velocities
        for interface in (control, plain):
            interface.set_command(np.array([0]), np.array([[0.3, 0.1]]))
            interface.approach_requested()
        frame = plain.observe(readings)[0]
        expected = frames.add(frame) if step else frames.reset(frame)
        np.testing.assert_array_equal(control.observe(readings)[0], expected)
        live.measured(Measurement(i * 20_000_000, positions, velocities, upright, zeros), i * 0.02)
        action = np.clip(policy.predict(expected), -1, 1).astype(float)
        np.testing.assert_array_equal(live._control.action[0], action)
        for interface in (control, plain):
            interface.advance()
            interface.joint_target(action[None])
        i += 1


@pytest.mark.parametrize("value", [0, -1, 1.5, "two", True])
def test_bad_history_is_refused(value):
    with pytest.raises(QuadrupedError, match=r"observation_history"):
        TaskConfig.from_dict({"observation_history": value})
    with pytest.raises(QuadrupedError, match=r"observation_history must be a whole number from 1 to 1000; found"):
        ControlConfig.of_task({"observation_history": value}, MINI_QUADRUPED)
