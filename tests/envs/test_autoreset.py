"""The native vector environment equals Gymnasium's SyncVectorEnv in every autoreset mode, and works in its wrappers."""

import gymnasium
import numpy as np
import pytest
from environments import EPISODE_STEPS, ROUGH, SAFE, assert_same, episodes, make_native, make_sync
from gymnasium.envs.registration import EnvSpec
from gymnasium.vector import AutoresetMode
from gymnasium.wrappers import vector as wrappers

from quadruped_env import QuadrupedError

MODES = list(AutoresetMode)
# Rough motions, and episodes short enough to be truncated too.
KWARGS = {"config": ROUGH, "max_episode_steps": EPISODE_STEPS}


def results_of(env, mode, steps, seed=0):
    """Results of every call under random actions, in episodes that end by falls and by the time limit."""
    if mode is not AutoresetMode.DISABLED:
        return episodes(env, steps, seed)
    rng = np.random.default_rng(seed)
    log = [env.reset(seed=seed)]
    for step in range(steps):
        log.append(env.step(rng.uniform(-1.3, 1.3, env.action_space.shape).astype(np.float32)))
        done = log[-1][2] | log[-1][3]
        # Now and then, also envs whose episode has not ended.
        if step % 41 == 40:
            done |= rng.random(env.num_envs) < 0.5
        if done.any():
            log.append(env.reset(options={"reset_mask": done}))
    return log


# `SameStep` is the mode of the comparison with single environments in test_envs.py.
@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.DISABLED], ids=lambda mode: mode.value)
def test_native_env_in_every_autoreset_mode_equals_sync_vector_env_bit_for_bit(mode):
    expected = results_of(make_sync(autoreset_mode=mode, **KWARGS), mode, 120)
    assert_same(results_of(make_native(autoreset_mode=mode, num_threads=2, **KWARGS), mode, 120), expected)
    steps = [entry for entry in expected if len(entry) == 5]
    falls = sum(terminated.sum() for _, _, terminated, _, _ in steps)
    time_outs = sum(truncated.sum() for _, _, _, truncated, _ in steps)
    assert falls > 10
    assert time_outs > 1
    assert not any("final_info" in info for *_, info in steps)


@pytest.mark.parametrize("mode", MODES, ids=lambda mode: mode.value)
@pytest.mark.parametrize("num_envs", [1, 3])
def test_native_env_in_every_autoreset_mode_equals_sync_vector_env_where_all_end_at_once(mode, num_envs):
    kwargs = {"config": SAFE, "max_episode_steps": 7}
    expected = results_of(make_sync(num_envs, autoreset_mode=mode, **kwargs), mode, 40)
    assert_same(results_of(make_native(num_envs, autoreset_mode=mode, **kwargs), mode, 40), expected)
    assert any(len(entry) == 5 and entry[3].all() for entry in expected)


def test_next_step_mode_ignores_the_action_of_an_env_that_restarts():
    env, other = (make_native(2, autoreset_mode="NextStep", config=SAFE, max_episode_steps=3) for _ in range(2))
    for e in (env, other):
        e.reset(seed=0)
        e.reset(options={"reset_mask": np.array([False, True])})
        for _ in range(3):
            e.step(np.zeros((2, 8)))
        e.reset(options={"reset_mask": np.array([False, True])})
    action = np.zeros((2, 8))
    expected = other.step(action)
    action[0] = np.nan
    assert_same(env.step(action), expected)
    np.testing.assert_array_equal(expected[4]["_diverged"], [False, True])
    with pytest.raises(QuadrupedError, match="value nan for LF_hip_joint in env 0"):
        env.step(action)


def test_next_step_mode_does_not_move_an_env_that_restarts_with_other_draws():
    # Pushes and new commands at every step draw from the generators: an env that restarts must not draw them.
    config = ROUGH | {
        "command": {"resample_interval": [0.02, 0.02]},
        "randomization": ROUGH["randomization"] | {"push_interval": [0.02, 0.02]},
    }
    kwargs = {"config": config, "max_episode_steps": 5, "autoreset_mode": AutoresetMode.NEXT_STEP}
    expected = results_of(make_sync(**kwargs), AutoresetMode.NEXT_STEP, 60)
    assert_same(results_of(make_native(**kwargs), AutoresetMode.NEXT_STEP, 60), expected)


def test_disabled_mode_refuses_to_step_an_ended_episode_and_nothing_moves():
    env = make_native(3, autoreset_mode="Disabled", config=SAFE, max_episode_steps=2)
    env.reset(seed=0)
    env.step(np.zeros((3, 8)))
    env.reset(options={"reset_mask": np.array([True, False, True])})
    env.step(np.zeros((3, 8)))
    before = env.get_state()
    with pytest.raises(QuadrupedError, match=r"episode of env 1 has ended.*'Disabled'.*reset_mask"):
        env.step(np.zeros((3, 8)))
    assert_same(env.get_state(), before)
    env.reset(options={"reset_mask": np.array([False, True, False])})
    env.step(np.zeros((3, 8)))


@pytest.mark.parametrize("mode", MODES, ids=lambda mode: mode.value)
def test_autoreset_mode_is_taken_as_enum_or_value_and_goes_through_json(mode):
    for given in (mode, mode.value):
        env = make_native(2, autoreset_mode=given)
        assert env.autoreset_mode is env.metadata["autoreset_mode"] is mode
        again = gymnasium.make_vec(EnvSpec.from_json(env.spec.to_json()))
        assert again.spec == env.spec
        assert again.autoreset_mode is mode


@pytest.mark.parametrize("mode", MODES, ids=lambda mode: mode.value)
def test_restored_env_remembers_which_episodes_have_ended(mode):
    kwargs = {"config": SAFE, "max_episode_steps": 4, "autoreset_mode": mode}
    env, fresh = make_native(2, **kwargs), make_native(2, **kwargs)
    env.reset(seed=0)
    for _ in range(4):
        truncated = env.step(np.zeros((2, 8)))[3]
    assert truncated.all()
    fresh.set_state(env.get_state())
    if mode is AutoresetMode.DISABLED:
        with pytest.raises(QuadrupedError, match="episode of env 0 has ended"):
            fresh.step(np.zeros((2, 8)))
    else:
        assert_same(fresh.step(np.zeros((2, 8))), env.step(np.zeros((2, 8))))


# --- Gymnasium's wrappers ---

WRAPPERS = {
    "normalize_observation": wrappers.NormalizeObservation,
    "transform_action": lambda env: wrappers.TransformAction(env, lambda action: action * 0.5),
    "record_episode_statistics": wrappers.RecordEpisodeStatistics,
    "dict_info_to_list": wrappers.DictInfoToList,
}
# Gymnasium's own rule: these wrappers cannot change `final_obs`.
REFUSED = (ValueError, AssertionError)
NOT_SAME_STEP = {name for name in WRAPPERS if name.endswith("_observation")}


def without_times(value):
    """The same value without the durations of episodes."""
    if isinstance(value, dict):
        return {key: without_times(entry) for key, entry in value.items() if key not in ("t", "_t")}
    if isinstance(value, (list, tuple)):
        return type(value)(without_times(entry) for entry in value)
    return value


@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP], ids=lambda mode: mode.value)
@pytest.mark.parametrize("name", WRAPPERS)
# Warnings of the wrappers about their own spaces.
@pytest.mark.filterwarnings("ignore:.*Box (low|high)'s precision:UserWarning", "ignore:overflow:RuntimeWarning")
def test_gymnasiums_vector_wrapper_over_the_native_env_equals_it_over_sync_vector_env(name, mode):
    kwargs = {"autoreset_mode": mode, "config": ROUGH, "max_episode_steps": 10}
    if mode is AutoresetMode.SAME_STEP and name in NOT_SAME_STEP:
        with pytest.raises(REFUSED):
            WRAPPERS[name](make_native(3, **kwargs))
        return
    native, sync = (WRAPPERS[name](make(3, **kwargs)) for make in (make_native, make_sync))
    rng = np.random.default_rng(0)
    assert_same(without_times(native.reset(seed=0)), without_times(sync.reset(seed=0)))
    ended = 0
    for _ in range(25):
        action = rng.uniform(-1, 1, (3, 8)).astype(np.float32)
        result, expected = native.step(action), sync.step(action)
        assert_same(without_times(result), without_times(expected))
        ended += int((result[2] | result[3]).sum())
    assert ended > 3
