"""Stable-Baselines3's view of the native environment."""

from types import SimpleNamespace

import gymnasium
import numpy as np
import pytest
from environments import EPISODE_STEPS, NUM_ENVS, ROUGH, assert_same, make_native
from stable_baselines3.common.monitor import Monitor

from quadruped_env import QuadrupedError


@pytest.fixture
def sb3(request):
    """Stable-Baselines3's view and the native environment, made with the same arguments."""
    from quadruped_env.envs import make_sb3_vec_env

    kwargs = {"config": ROUGH, "max_episode_steps": EPISODE_STEPS}
    return SimpleNamespace(
        env=make_sb3_vec_env(NUM_ENVS, seed=3, **kwargs), native=make_native(**kwargs), make=make_sb3_vec_env
    )


def test_stable_baselines3s_view_gives_the_native_numbers(sb3):
    observation = sb3.env.reset()
    assert_same(observation, sb3.native.reset(seed=3)[0])
    rng = np.random.default_rng(0)
    returns, lengths = np.zeros(NUM_ENVS), np.zeros(NUM_ENVS, dtype=int)
    term_sums = np.zeros((NUM_ENVS, len(sb3.native.task.term_names)))
    falls = time_outs = 0
    for _ in range(200):
        action = rng.uniform(-1, 1, (NUM_ENVS, 8)).astype(np.float32)
        observation, reward, done, infos = sb3.env.step(action)
        expected, expected_reward, terminated, truncated, native_info = sb3.native.step(action)
        assert_same(observation, expected)
        assert_same(reward, expected_reward.astype(np.float32))
        assert_same(done, terminated | truncated)
        returns += expected_reward
        lengths += 1
        for row, info in enumerate(infos):
            source = native_info["final_info"] if done[row] else native_info
            term_sums[row] += [source[f"reward_{name}"][row] for name in sb3.native.task.term_names]
            if not done[row]:
                assert info == {}
                continue
            assert_same(info["terminal_observation"], native_info["final_obs"][row])
            assert info["TimeLimit.truncated"] is bool(truncated[row] and not terminated[row])
            assert info["episode"]["r"] == pytest.approx(returns[row], rel=1e-12, abs=1e-12)
            assert info["episode"]["l"] == lengths[row]
            np.testing.assert_allclose(info["episode"]["terms"], term_sums[row], rtol=1e-12)
            returns[row], lengths[row], term_sums[row] = 0.0, 0, 0.0
            falls += terminated[row]
            time_outs += info["TimeLimit.truncated"]
    assert falls > 0
    assert time_outs > 0


@pytest.mark.parametrize(("max_tilt", "fallen"), [(3.1, False), (1e-6, True)])
def test_env_that_falls_in_the_step_of_its_time_limit_is_not_bootstrapped(sb3, max_tilt, fallen):
    config = {"termination": {"max_tilt": max_tilt}, "randomization": {"start_tilt": 0.2}}
    env = sb3.make(2, seed=0, config=config, max_episode_steps=1)
    env.reset()
    done, infos = env.step(np.zeros((2, 8), dtype=np.float32))[2:]
    assert done.all()
    assert [info["TimeLimit.truncated"] for info in infos] == [not fallen] * 2


def test_episodes_reported_to_stable_baselines3_equal_those_of_its_monitor(sb3):
    from stable_baselines3.common.vec_env import VecMonitor

    with pytest.warns(UserWarning, match="already wrapped with a `Monitor`"):
        monitored = VecMonitor(sb3.env)
    plain = sb3.make(NUM_ENVS, seed=3, config=ROUGH, max_episode_steps=EPISODE_STEPS)
    monitored.reset(), plain.reset()
    rng = np.random.default_rng(0)
    count, times = 0, [0.0]
    for _ in range(100):
        action = rng.uniform(-1, 1, (NUM_ENVS, 8)).astype(np.float32)
        seen, told = monitored.step(action)[3], plain.step(action)[3]
        for one, other in zip(seen, told, strict=True):
            if other:
                assert set(one["episode"]) <= set(other["episode"])
                assert other["episode"]["l"] == one["episode"]["l"]
                assert 0.0 <= times[-1] <= other["episode"]["t"]
                times.append(other["episode"]["t"])
                assert other["episode"]["r"] == pytest.approx(one["episode"]["r"], rel=1e-5, abs=1e-4)
                count += 1
    assert count > 0


def test_seeds_and_options_reach_the_environment_at_stable_baselines3s_next_reset(sb3):
    first = sb3.env.reset()
    second = sb3.env.reset()
    assert (second != first).any(), "the seed must apply to one reset only"
    sb3.env.seed(3)
    assert_same(sb3.env.reset(), first)
    sb3.env.set_options({"command": (0.25, 0.0)})
    sb3.env.reset()
    np.testing.assert_array_equal(sb3.env.task.command, [[0.25, 0.0]] * NUM_ENVS)
    sb3.env.reset()
    assert (sb3.env.task.command != [0.25, 0.0]).any(), "options must apply to one reset only"


def test_attributes_can_be_read_through_stable_baselines3_and_not_written(sb3):
    assert sb3.env.num_envs == NUM_ENVS
    assert sb3.env.get_attr("num_envs", indices=[0, 2]) == [NUM_ENVS, NUM_ENVS]
    assert len(sb3.env.get_attr("metadata")) == NUM_ENVS
    assert not sb3.env.has_attr("gravity")
    assert sb3.env.env_is_wrapped(gymnasium.Wrapper, indices=0) == [False]
    assert sb3.env.env_is_wrapped(Monitor) == [True] * NUM_ENVS, "the episodes are reported"
    assert sb3.env.render_mode is None
    with pytest.raises(NotImplementedError, match=r"set_attr.*'gravity'"):
        sb3.env.set_attr("gravity", 0)
    with pytest.raises(NotImplementedError, match=r"env_method.*'jump'"):
        sb3.env.env_method("jump")
    sb3.env.close()


def test_infos_written_to_by_a_wrapper_do_not_leak_into_the_next_step(sb3):
    sb3.env.reset()
    action = np.zeros((NUM_ENVS, 8), dtype=np.float32)
    first = sb3.env.step(action)[3]
    for info in first:
        info["mine"] = 1
    second = sb3.env.step(action)[3]
    assert not any("mine" in info for info in second)
    assert not {id(info) for info in first} & {id(info) for info in second}


def test_sb3_env_with_other_autoreset_mode_is_refused(sb3):
    with pytest.raises(QuadrupedError, match=r"autoreset_mode must be 'SameStep' .*found 'NextStep'"):
        sb3.make(2, autoreset_mode="NextStep")


def test_first_episodes_of_random_length_spread_the_time_limits(sb3):
    standing = {"termination": {"max_tilt": 3.1}}
    limit, envs = 40, 64
    env = sb3.make(envs, seed=3, config=standing, max_episode_steps=limit, random_first_length=True)
    plain = sb3.make(envs, seed=3, config=standing, max_episode_steps=limit)
    few = sb3.make(8, seed=3, config=standing, max_episode_steps=limit, random_first_length=True)
    assert_same(env.reset(), plain.reset())
    few.reset()
    action, ends = np.zeros((envs, 8), dtype=np.float32), np.zeros((2 * limit, envs), dtype=bool)
    running = np.ones(envs, dtype=bool)
    for step in range(2 * limit):
        observations, rewards, ends[step], infos = env.step(action)
        expected, expected_rewards = plain.step(action)[:2]
        running &= ~ends[step]
        # Until its end, an episode is the same as without a random length.
        assert_same(observations[running], expected[running])
        assert_same(rewards[running], expected_rewards[running])
        # Each end is a time limit, from which PPO bootstraps.
        assert all(infos[i]["TimeLimit.truncated"] for i in np.flatnonzero(ends[step]))
        assert_same(few.step(action[:8])[2], ends[step, :8])
    first = ends.argmax(axis=0) + 1
    assert (first.min(), first.max()) >= (1, limit - 5)
    assert len(np.unique(first)) > 20
    assert ends.sum(axis=1).max() <= 8, "in no step do many episodes end"
    for env_id, step in enumerate(first):
        assert np.flatnonzero(ends[:, env_id])[:2].tolist() == [step - 1, step - 1 + limit], "later ones are whole"
    # A reset by the caller begins first episodes again.
    env.reset()
    assert sum(env.step(action)[2].any() for _ in range(limit - 1)) > 20
