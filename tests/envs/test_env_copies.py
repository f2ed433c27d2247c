"""Environments remade from a spec, copied, and restored continue identically."""

import copy
import pickle

import gymnasium
import numpy as np
import pytest
from environments import EPISODE_STEPS, NUM_ENVS, ROUGH, assert_same, make, make_native, play
from gymnasium.envs.registration import EnvSpec
from gymnasium.vector import AutoresetMode

from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.task import TaskConfig


def through_json(spec):
    return EnvSpec.from_json(spec.to_json())


def through_pickle(value):
    return pickle.loads(pickle.dumps(value))  # noqa: S301


@pytest.mark.parametrize("remake", [through_json, through_pickle])
@pytest.mark.parametrize(("maker", "make_again"), [(make, gymnasium.make), (make_native, gymnasium.make_vec)])
def test_a_spec_makes_the_same_environment_again(maker, make_again, remake):
    env = maker(action_mode="residual", config=ROUGH, max_episode_steps=EPISODE_STEPS)
    again = make_again(remake(env.spec))
    assert again.spec == env.spec
    assert type(again.unwrapped) is type(env.unwrapped)
    for one in (env, again):
        one.reset(seed=2)
        one.action_space.seed(3)
    for _ in range(60):
        assert_same(again.step(again.action_space.sample()), env.step(env.action_space.sample()))


@pytest.mark.parametrize("maker", [make, make_native])
def test_spec_of_an_env_made_with_objects_and_numpy_values_goes_through_json(maker):
    config = TaskConfig.from_dict(ROUGH)
    for value in (config, {"decimation": np.int64(4), "command": {"yaw_rate": np.array([-0.5, 0.5])}}):
        env = maker(config=value, width=np.int64(32))
        document = env.spec.to_json()
        again = EnvSpec.from_json(document)
        assert again == env.spec
        made = gymnasium.make(again) if maker is make else gymnasium.make_vec(again)
        assert made.unwrapped.task.config == env.unwrapped.task.config


def test_config_object_is_accepted_like_plain_values():
    config = TaskConfig.from_dict(ROUGH)
    env, again = make(config=config), make(config=ROUGH)
    assert env.unwrapped.task.config == again.unwrapped.task.config == config
    residual = make(config=config, action_mode="residual").unwrapped.task.config
    assert residual.action.mode == "residual"
    assert config.action.mode == "position", "the caller's config must not change"


@pytest.mark.parametrize("duplicate", [copy.deepcopy, through_pickle])
def test_a_copy_taken_within_an_episode_continues_identically(duplicate):
    env = make(action_mode="residual", config=ROUGH, max_episode_steps=EPISODE_STEPS)
    env.reset(seed=4)
    play(env, 17)
    copied = duplicate(env)
    expected = play(env, 120, seed=9)
    assert_same(play(copied, 120, seed=9), expected)
    assert sum(len(entry) == 2 for entry in expected) > 2, "the rollout must continue into new episodes"


def test_a_restored_single_environment_continues_identically():
    # A small tilt limit, so that some episodes end by a fall.
    config = ROUGH | {"termination": {"max_tilt": 0.15}}
    env, fresh = (make(config=config, disable_env_checker=True).unwrapped for _ in range(2))
    env.reset(seed=4)
    play(env, 33)
    state = through_pickle(env.get_state())
    expected = play(env, 150, seed=9)
    assert sum(len(entry) == 2 for entry in expected) > 1, "the rollout must continue into new episodes"
    for other in (env, fresh):
        other.set_state(state)
        assert_same(play(other, 150, seed=9), expected)


@pytest.mark.parametrize(
    ("duplicate", "mode"),
    [(copy.deepcopy, AutoresetMode.DISABLED), (through_pickle, AutoresetMode.NEXT_STEP)],
    ids=["deepcopy, disabled", "pickle, next step"],
)
def test_copy_of_a_vector_environment_taken_within_episodes_continues_identically(duplicate, mode):
    env = make_native(
        action_mode="residual", config=ROUGH, max_episode_steps=EPISODE_STEPS, autoreset_mode=mode, num_threads=2
    )
    rng = np.random.default_rng(1)

    def continue_(e, actions):
        log = []
        for action in actions:
            log.append(e.step(action))
            done = log[-1][2] | log[-1][3]
            if mode is AutoresetMode.DISABLED and done.any():
                log.append(e.reset(options={"reset_mask": done}))
        return log

    env.reset(seed=3)
    continue_(env, rng.uniform(-1, 1, (33, *env.action_space.shape)))
    copied = duplicate(env)
    assert copied.spec == env.spec
    assert copied.np_random_seed == env.np_random_seed
    actions = rng.uniform(-1, 1, (100, *env.action_space.shape))
    expected = continue_(env, actions)
    assert sum((entry[2] | entry[3]).sum() for entry in expected if len(entry) == 5) > 5
    assert_same(continue_(copied, actions), expected)
    assert_same(copied.get_state(), env.get_state())
    assert_same(copied.reset(), env.reset())


@pytest.mark.parametrize("duplicate", [copy.deepcopy, through_pickle])
def test_copy_of_the_sb3_environment_taken_within_episodes_continues_identically(duplicate):
    env = make_sb3_vec_env(NUM_ENVS, seed=3, config=ROUGH, max_episode_steps=EPISODE_STEPS)
    env.reset()
    rng = np.random.default_rng(1)
    for _ in range(20):
        env.step(rng.uniform(-1, 1, (NUM_ENVS, 8)).astype(np.float32))
    copied = duplicate(env)
    assert copied.task is copied.env.task
    assert copied.task is not env.task

    def continue_(e, actions):
        log = [e.step(action) for action in actions]
        for *_, infos in log:
            for info in infos:
                info.get("episode", {}).pop("t", None)  # wall-clock time
        return log

    actions = rng.uniform(-1, 1, (60, NUM_ENVS, 8)).astype(np.float32)
    expected = continue_(env, actions)
    assert sum(done.sum() for _, _, done, _ in expected) > 5
    assert_same(continue_(copied, actions), expected)
    assert_same(copied.reset(), env.reset())


def test_env_of_a_vector_environment_continues_in_a_single_environment():
    vector, single = make_native(config=ROUGH), make(config=ROUGH, disable_env_checker=True).unwrapped
    vector.reset(seed=0)
    rng = np.random.default_rng(0)
    for _ in range(5):
        vector.step(rng.uniform(-1, 1, (NUM_ENVS, 8)))
    single.set_state(vector.get_state()[2])
    for _ in range(10):
        action = rng.uniform(-1, 1, (NUM_ENVS, 8)).astype(np.float32)
        observation, reward, terminated, *_ = vector.step(action)
        one, one_reward, one_terminated, *_ = single.step(action[2])
        assert one_terminated == terminated[2]
        assert one_reward == reward[2]
        if terminated[2]:
            break
        assert_same(one, observation[2])
