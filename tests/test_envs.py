"""The environments: Gymnasium's and Stable-Baselines3's contracts, single == vector to the last bit, and bad input."""

import copy
import json
import pickle
import subprocess
import sys
from types import SimpleNamespace

import gymnasium
import mujoco
import numpy as np
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env
from gymnasium.utils.passive_env_checker import env_render_passive_checker
from gymnasium.vector import AutoresetMode

from quadruped_env import QuadrupedError, _opengl
from quadruped_env.envs import ENV_ID, MAX_EPISODE_STEPS, MiniQuadrupedVectorEnv
from quadruped_env.task import OBSERVATION_WIDTH, TaskConfig

ROWS = 6
EPISODE_STEPS = 40
ACTION_MODES = ("position", "residual")

# Rough enough for falls within an episode of EPISODE_STEPS, and everything that is random is on.
ROUGH = {
    "command": {"resample_interval": [0.1, 0.5]},
    "termination": {"max_tilt": 0.35},
    "randomization": {
        "start_tilt": 0.2,
        "friction": [0.2, 1.2],
        "payload": [-0.5, 1.0],
        "push_velocity": 3.0,
        "push_interval": [0.2, 0.8],
        "observation_noise": 1.0,
    },
}
# Nothing ends an episode but time.
SAFE = {"termination": {"max_tilt": 3.1, "max_trunk_force": 1e9}}


def make(**kwargs):
    return gymnasium.make(ENV_ID, **kwargs)


def make_native(num_envs=ROWS, **kwargs):
    return gymnasium.make_vec(ENV_ID, num_envs=num_envs, **kwargs)


def make_sync(num_envs=ROWS, **kwargs):
    vector_kwargs = {"autoreset_mode": AutoresetMode.SAME_STEP}
    return gymnasium.make_vec(
        ENV_ID, num_envs=num_envs, vectorization_mode="sync", vector_kwargs=vector_kwargs, **kwargs
    )


def assert_same(actual, expected, path="result"):
    """Equal in type, shape and every bit, NaN and the sign of zero included."""
    assert type(actual) is type(expected), path
    if isinstance(expected, dict):
        assert sorted(actual) == sorted(expected), path
        for key, value in expected.items():
            assert_same(actual[key], value, f"{path}[{key!r}]")
    elif isinstance(expected, (list, tuple)) or (isinstance(expected, np.ndarray) and expected.dtype == object):
        assert len(actual) == len(expected), path
        for i, (one, other) in enumerate(zip(actual, expected, strict=True)):
            assert_same(one, other, f"{path}[{i}]")
    elif isinstance(expected, (np.ndarray, np.generic)):
        assert (actual.shape, actual.dtype) == (expected.shape, expected.dtype), path
        if actual.tobytes() != expected.tobytes():
            np.testing.assert_array_equal(actual, expected, err_msg=path)
            raise AssertionError(f"{path}: equal but for the bits of a NaN or of a zero")
    elif isinstance(expected, float):
        assert actual.hex() == expected.hex(), path
    else:
        assert actual == expected, path


def episodes(env, steps, seed=0):
    """Random play with masked, fixed-command and partly seeded resets in between: all that the calls returned."""
    rng = np.random.default_rng(seed)
    log = [env.reset(seed=seed)]
    for step in range(1, steps + 1):
        action = rng.uniform(-1.3, 1.3, env.action_space.shape).astype(np.float32)
        log.append(env.step(action))
        if step % 37 == 0:
            mask = rng.random(env.num_envs) < 0.5
            mask[rng.integers(env.num_envs)] = True
            options = {"reset_mask": mask}
            if step % 2:
                options["command"] = [0.2, -0.1]
            seeds = [None if rng.random() < 0.5 else int(rng.integers(1000)) for _ in range(env.num_envs)]
            log.append(env.reset(seed=seeds, options=options))
    return log


def play(env, steps, seed=0):
    """Random play of a single environment from where it is, a new episode after each that ends."""
    rng = np.random.default_rng(seed)
    log = []
    for _ in range(steps):
        log.append(env.step(rng.uniform(-1.0, 1.0, 8).astype(np.float32)))
        if log[-1][2] or log[-1][3]:
            log.append(env.reset())
    return log


@pytest.fixture
def opengl(model):
    """Skips where nothing can be rendered."""
    try:
        mujoco.Renderer(model, 8, 8).close()
    except Exception as error:  # every backend fails in its own way
        pytest.skip(f"no OpenGL: {type(error).__name__}: {error}")


# --- the contracts ---


@pytest.mark.parametrize("mode", ACTION_MODES)
def test_gymnasiums_checker_finds_nothing_to_warn_about(mode):
    check_env(make(action_mode=mode).unwrapped, skip_render_check=True)


@pytest.mark.parametrize("mode", ACTION_MODES)
def test_stable_baselines3s_checker_finds_nothing_to_warn_about(mode):
    from stable_baselines3.common.env_checker import check_env as check_sb3_env

    check_sb3_env(make(action_mode=mode))


@pytest.mark.usefixtures("tmp_cwd")
@pytest.mark.parametrize("mode", ACTION_MODES)
def test_observations_stay_in_their_space_whatever_happens(mode):
    env = make_native(64, action_mode=mode, config=ROUGH | {"termination": {"max_tilt": 3.1, "max_trunk_force": 1e9}})
    observation, _ = env.reset(seed=0)
    rng = np.random.default_rng(0)
    for _ in range(200):
        assert observation in env.observation_space
        # Full swings from one end to the other: harder than any policy.
        observation, *_ = env.step(rng.choice([-1.0, 1.0], (64, 8)).astype(np.float32))


def test_a_native_vector_environment_says_what_it_is():
    env = make_native(3)
    assert isinstance(env, MiniQuadrupedVectorEnv)
    assert env.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP
    assert env.task.max_episode_steps == MAX_EPISODE_STEPS
    single = make()
    assert env.single_observation_space == single.observation_space
    assert env.single_action_space == single.action_space
    assert env.observation_space.shape == (3, OBSERVATION_WIDTH)


def test_metadata_belongs_to_the_instance():
    default, slow = make(), make(config={"decimation": 8})
    assert default.metadata["render_fps"] == round(1.0 / default.unwrapped.dt)
    assert slow.metadata["render_fps"] == round(1.0 / slow.unwrapped.dt) != default.metadata["render_fps"]
    slow.unwrapped.metadata["render_fps"] = 1
    assert make(config={"decimation": 8}).metadata["render_fps"] != 1
    vector = make_native(2, config={"decimation": 8})
    assert vector.metadata["render_fps"] == round(1.0 / (8 * vector.task.config.physics_timestep))


# --- single == vector, to the last bit ---


@pytest.mark.parametrize("mode", ACTION_MODES)
def test_the_native_vector_environment_is_many_single_ones_to_the_last_bit(mode):
    kwargs = {"action_mode": mode, "config": ROUGH, "max_episode_steps": EPISODE_STEPS}
    expected = episodes(make_sync(**kwargs), 500)
    for threads in (1, 2, 3):
        assert_same(episodes(make_native(num_threads=threads, **kwargs), 500), expected)
    steps = [entry for entry in expected if len(entry) == 5]
    resets = [entry for entry in expected if len(entry) == 2]
    assert len(resets) > 5, "masked resets"
    falls = sum(terminated.sum() for _, _, terminated, _, _ in steps)
    time_outs = sum(truncated.sum() for _, _, _, truncated, _ in steps)
    assert falls > 20
    assert time_outs > 5
    finished = sum(info["_final_obs"].sum() for *_, info in steps if "final_info" in info)
    assert finished == sum((terminated | truncated).sum() for _, _, terminated, truncated, _ in steps)


@pytest.mark.slow
def test_the_asynchronous_vector_environment_is_the_native_one_too():
    kwargs = {"config": ROUGH, "max_episode_steps": EPISODE_STEPS}
    vector_kwargs = {"autoreset_mode": AutoresetMode.SAME_STEP, "context": "spawn"}
    env = gymnasium.make_vec(ENV_ID, num_envs=2, vectorization_mode="async", vector_kwargs=vector_kwargs, **kwargs)
    try:
        assert_same(episodes(env, 100), episodes(make_native(2, **kwargs), 100))
    finally:
        env.close()


@pytest.mark.parametrize("config", [{}, {"randomization": {"observation_noise": 0.5}}], ids=["default", "noise"])
def test_rows_that_all_time_out_at_once_are_many_single_environments_too(config):
    kwargs = {"config": SAFE | config, "max_episode_steps": 7}
    expected = episodes(make_sync(3, **kwargs), 30)
    assert_same(episodes(make_native(3, **kwargs), 30), expected)
    assert any(len(entry) == 5 and entry[3].all() for entry in expected)


def test_one_row_is_the_single_environment():
    kwargs = {"config": ROUGH, "max_episode_steps": EPISODE_STEPS}
    assert_same(episodes(make_native(1, **kwargs), 100), episodes(make_sync(1, **kwargs), 100))


def test_a_rows_numbers_do_not_depend_on_the_number_of_rows():
    few, many = (make_native(n, config=ROUGH, max_episode_steps=EPISODE_STEPS) for n in (2, 9))
    first_few, first_many = few.reset(seed=5)[0], many.reset(seed=5)[0]
    assert_same(first_many[:2], first_few)
    rng = np.random.default_rng(0)
    for _ in range(150):
        action = rng.uniform(-1, 1, (9, 8)).astype(np.float32)
        for one, other in zip(few.step(action[:2])[:4], many.step(action)[:4], strict=True):
            assert_same(other[:2], one)


def test_a_masked_reset_leaves_the_other_rows_alone():
    env, untouched = (make_native(4, config=SAFE) for _ in range(2))
    rng = np.random.default_rng(0)
    for e in (env, untouched):
        e.reset(seed=1)
    mask = np.array([False, True, False, True])
    for step in range(20):
        action = rng.uniform(-1, 1, (4, 8)).astype(np.float32)
        observation, expected = env.step(action)[0], untouched.step(action)[0]
        if step == 5:
            options = {"reset_mask": mask, "command": [0.1, 0.2]}
            observation, info = env.reset(options=options)
            assert set(options) == {"reset_mask", "command"}, "the caller's options are the caller's"
            np.testing.assert_array_equal(info["_command"], mask)
            np.testing.assert_array_equal(info["command"][mask], [[0.1, 0.2]] * 2)
            assert (observation[mask] != expected[mask]).any(axis=1).all()
            np.testing.assert_array_equal(env.task.steps, [6, 0, 6, 0])
        assert_same(observation[~mask], expected[~mask])


# --- seeds ---


def test_the_seed_decides_everything_the_commands_included():
    def trace(seed):
        env = make_native(config=ROUGH, max_episode_steps=EPISODE_STEPS)
        return episodes(env, 100, seed)

    first, again = trace(3), trace(3)
    assert_same(again, first)
    commands = np.array([info["command"] for *_, info in first])
    assert len(np.unique(commands[:, 0], axis=0)) > 5, "commands must have been sampled anew"
    assert (commands != np.array([info["command"] for *_, info in trace(4)])).any(axis=(1, 2)).all()


def test_row_i_gets_the_seed_plus_i():
    env = make_native(4, config=ROUGH)
    numbered, _ = env.reset(seed=10)
    listed, _ = env.reset(seed=[10, 11, 12, 13])
    assert_same(listed, numbered)
    single = make(config=ROUGH)
    assert_same(single.reset(seed=12)[0], numbered[2])


@pytest.mark.parametrize("maker", [make, make_native])
def test_the_default_seed_is_not_a_fixed_one(maker):
    assert (maker().reset()[0] != maker().reset()[0]).any()


def test_a_reset_without_a_seed_goes_on_with_the_generator():
    env, other = make(config=ROUGH), make(config=ROUGH)
    first = [env.reset(seed=1)[0], env.reset()[0], env.reset()[0]]
    assert (first[1] != first[0]).any()
    assert (first[2] != first[1]).any()
    assert_same([other.reset(seed=1)[0], other.reset()[0], other.reset()[0]], first)


def test_a_fixed_command_stays_for_the_episode_and_no_longer():
    env = make(config={"command": {"resample_interval": [0.02, 0.04]}, **SAFE})
    _, info = env.reset(seed=0, options={"command": (0.25, -0.125)})
    np.testing.assert_array_equal(info["command"], [0.25, -0.125])
    for _ in range(20):
        *_, info = env.step(np.zeros(8))
        np.testing.assert_array_equal(info["command"], [0.25, -0.125])
    _, info = env.reset()
    assert (info["command"] != [0.25, -0.125]).any()


# --- remade, copied, restored ---


def through_json(spec):
    return EnvSpec.from_json(spec.to_json())


def through_pickle(value):
    return pickle.loads(pickle.dumps(value))  # noqa: S301


@pytest.mark.parametrize("remake", [through_json, through_pickle])
def test_a_spec_makes_the_same_environment_again(remake):
    env = make(action_mode="residual", config=ROUGH, max_episode_steps=EPISODE_STEPS)
    again = gymnasium.make(remake(env.spec))
    assert again.spec == env.spec
    env.reset(seed=2), again.reset(seed=2)
    assert_same(play(again, 60), play(env, 60))


@pytest.mark.parametrize("remake", [through_json, through_pickle])
def test_a_vector_spec_makes_the_same_environment_again(remake):
    env = make_native(action_mode="residual", config=ROUGH, max_episode_steps=EPISODE_STEPS)
    again = gymnasium.make_vec(remake(env.spec))
    assert isinstance(again, MiniQuadrupedVectorEnv)
    assert_same(episodes(again, 60), episodes(env, 60))


def test_a_config_object_is_taken_as_well_as_plain_values():
    config = TaskConfig.from_dict(ROUGH)
    env, again = make(config=config), make(config=ROUGH)
    assert env.unwrapped.task.config == again.unwrapped.task.config == config
    residual = make(config=config, action_mode="residual").unwrapped.task.config
    assert residual.action.mode == "residual"
    assert config.action.mode == "position", "the caller's config must not change"


@pytest.mark.parametrize("mode", ACTION_MODES)
@pytest.mark.parametrize("duplicate", [copy.deepcopy, through_pickle])
def test_a_copy_taken_within_an_episode_goes_on_identically(mode, duplicate):
    env = make(action_mode=mode, config=ROUGH, max_episode_steps=EPISODE_STEPS)
    env.reset(seed=4)
    play(env, 17)
    copied = duplicate(env)
    expected = play(env, 120, seed=9)
    assert_same(play(copied, 120, seed=9), expected)
    assert sum(len(entry) == 2 for entry in expected) > 2, "the play must go on into new episodes"


@pytest.mark.parametrize("mode", ACTION_MODES)
def test_a_restored_single_environment_goes_on_identically(mode):
    env, fresh = (make(action_mode=mode, config=ROUGH, disable_env_checker=True).unwrapped for _ in range(2))
    env.reset(seed=4)
    play(env, 33)
    state = through_pickle(env.get_state())
    expected = play(env, 120, seed=9)
    assert sum(len(entry) == 2 for entry in expected) > 1, "the play must go on into new episodes"
    for other in (env, fresh):
        other.set_state(state)
        assert_same(play(other, 120, seed=9), expected)


def test_a_restored_vector_environment_goes_on_identically():
    kwargs = {"action_mode": "residual", "config": ROUGH, "max_episode_steps": EPISODE_STEPS}
    env, fresh = make_native(**kwargs), make_native(**kwargs)
    episodes(env, 50)
    state = env.get_state()

    def go_on(e):
        rng = np.random.default_rng(1)
        return [e.step(rng.uniform(-1, 1, e.action_space.shape).astype(np.float32)) for _ in range(100)]

    expected = go_on(env)
    assert any("final_info" in info for *_, info in expected)
    for other in (env, fresh):
        other.set_state(state)
        assert_same(go_on(other), expected)


def test_a_row_can_go_on_in_a_single_environment():
    vector, single = make_native(config=ROUGH), make(config=ROUGH, disable_env_checker=True).unwrapped
    vector.reset(seed=0)
    rng = np.random.default_rng(0)
    for _ in range(5):
        vector.step(rng.uniform(-1, 1, (ROWS, 8)))
    single.set_state(vector.get_state()[2])
    for _ in range(10):
        action = rng.uniform(-1, 1, (ROWS, 8)).astype(np.float32)
        observation, reward, terminated, *_ = vector.step(action)
        one, one_reward, one_terminated, *_ = single.step(action[2])
        assert one_terminated == terminated[2]
        assert one_reward == reward[2]
        if terminated[2]:
            break
        assert_same(one, observation[2])


def test_environments_share_nothing():
    env, other = make(config=ROUGH), make(config=ROUGH)
    env.reset(seed=0)
    expected = play(env, 40)
    env.reset(seed=0), other.reset(seed=7)
    log = []
    rng = np.random.default_rng(0)
    for _ in range(40):
        log.append(env.step(rng.uniform(-1.0, 1.0, 8).astype(np.float32)))
        other.step(np.ones(8, dtype=np.float32))
        other.unwrapped.model.geom_friction[:] = 0.01
        other.unwrapped.model.opt.gravity[2] = -1.0
        if log[-1][2] or log[-1][3]:
            log.append(env.reset())
    assert_same(log, expected)


# --- info ---


@pytest.mark.parametrize("mode", ACTION_MODES)
def test_the_reward_terms_in_info_add_up_to_the_reward_exactly(mode):
    env = make(action_mode=mode, config=ROUGH)
    env.reset(seed=0)
    names = [f"reward_{name}" for name in env.unwrapped.task.term_names]
    falls = 0
    for _, reward, terminated, _, info in (entry for entry in play(env, 300) if len(entry) == 5):
        assert [name for name in info if name.startswith("reward_")] == names
        assert sum(info[name] for name in names) == reward
        falls += terminated
    assert falls >= 1


def test_the_reward_terms_of_a_vector_environment_add_up_exactly_in_the_row_that_fell_too():
    env = make_native(config=ROUGH)
    env.reset(seed=0)
    names = [f"reward_{name}" for name in env.task.term_names]
    rng = np.random.default_rng(0)
    falls = 0
    for _ in range(150):
        _, reward, terminated, _, info = env.step(rng.uniform(-1, 1, (ROWS, 8)))
        for row in range(ROWS):
            source = info["final_info"] if terminated[row] else info
            assert all(source[f"_{name}"][row] for name in names)
            assert sum(float(source[name][row]) for name in names) == reward[row]
        falls += terminated.sum()
    assert falls > 5


def test_info_describes_the_state_that_the_step_ended_in():
    env = make(config=ROUGH)
    env.reset(seed=0)
    for _ in range(10):
        *_, info = env.step(env.action_space.sample())
    data = env.unwrapped.data
    np.testing.assert_array_equal(info["joint_position"], data.qpos[7:])
    np.testing.assert_array_equal(info["joint_velocity"], data.qvel[6:])
    np.testing.assert_array_equal(info["base_position"], data.qpos[:3])
    np.testing.assert_array_equal(info["joint_torque"], data.actuator_force)
    rotation = np.zeros(9)
    mujoco.mju_quat2Mat(rotation, data.qpos[3:7])
    np.testing.assert_allclose(info["base_linear_velocity"], rotation.reshape(3, 3).T @ data.qvel[:3], atol=1e-12)
    np.testing.assert_allclose(info["base_angular_velocity"], data.qvel[3:6], atol=1e-12)
    threshold = env.unwrapped.task.config.reward.contact_threshold
    np.testing.assert_array_equal(info["foot_contact"], info["foot_force"] > threshold)
    assert info["diverged"] is False


def test_what_a_call_returned_does_not_change_later():
    env = make_native(config=ROUGH, max_episode_steps=EPISODE_STEPS)
    env.reset(seed=0)
    rng = np.random.default_rng(0)
    entries, copies = [], []
    for _ in range(60):
        entries.append(env.step(rng.uniform(-1, 1, (ROWS, 8))))
        copies.append(copy.deepcopy(entries[-1]))
    assert_same(entries, copies)


# --- divergence ---


@pytest.mark.usefixtures("tmp_cwd")
@pytest.mark.parametrize("value", [np.nan, np.inf, 1e11])
def test_a_state_that_blows_up_ends_the_episode_as_diverged(value):
    env = make(config=SAFE)
    env.reset(seed=0)
    env.step(np.zeros(8))
    env.unwrapped.data.qvel[3] = value
    observation, reward, terminated, truncated, info = env.step(np.zeros(8))
    assert info["diverged"] is True
    assert terminated
    assert not truncated
    assert observation in env.observation_space
    assert np.isfinite(reward)
    env.reset()
    *_, terminated, _, info = env.step(np.zeros(8))
    assert info["diverged"] is False
    assert not terminated


@pytest.mark.usefixtures("tmp_cwd")
@pytest.mark.parametrize("value", [np.nan, 1e11])
def test_a_row_that_blows_up_leaves_the_others_bits_untouched(value):
    env, healthy = (make_native(4, config=SAFE) for _ in range(2))
    env.reset(seed=0), healthy.reset(seed=0)
    others = np.array([True, True, False, True])
    rng = np.random.default_rng(0)
    for step in range(20):
        action = rng.uniform(-1, 1, (4, 8)).astype(np.float32)
        if step == 8:
            env.task.simulation.batch.bind("qvel")[2, 3] = value
        observation, reward, terminated, truncated, info = env.step(action)
        expected = healthy.step(action)
        for actual, wanted in zip((observation, reward, terminated, truncated), expected, strict=False):
            assert_same(actual[others], wanted[others])
        if step == 8:
            np.testing.assert_array_equal(terminated, ~others)
            np.testing.assert_array_equal(info["final_info"]["diverged"], ~others)
            assert np.isfinite(reward).all()
            assert info["final_obs"][2] in env.single_observation_space
        else:
            assert not terminated.any()
            assert not info["diverged"].any()
        assert observation in env.observation_space


# --- Stable-Baselines3 ---


@pytest.fixture
def sb3(request):
    """Stable-Baselines3's view and the native environment, alike."""
    from quadruped_env.envs import make_sb3_vec_env

    kwargs = {"config": ROUGH, "max_episode_steps": EPISODE_STEPS}
    return SimpleNamespace(
        env=make_sb3_vec_env(ROWS, seed=3, **kwargs),
        native=make_native(**kwargs),
        make=make_sb3_vec_env,
    )


def test_stable_baselines3s_view_gives_the_native_numbers(sb3):
    observation = sb3.env.reset()
    assert_same(observation, sb3.native.reset(seed=3)[0])
    rng = np.random.default_rng(0)
    returns, lengths = np.zeros(ROWS), np.zeros(ROWS, dtype=int)
    term_sums = np.zeros((ROWS, len(sb3.native.task.term_names)))
    falls = time_outs = 0
    for _ in range(200):
        action = rng.uniform(-1, 1, (ROWS, 8)).astype(np.float32)
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
    assert falls > 10
    assert time_outs > 5


def test_the_episodes_that_stable_baselines3_is_told_of_are_those_that_its_monitor_sees(sb3):
    from stable_baselines3.common.vec_env import VecMonitor

    monitored, plain = VecMonitor(sb3.env), sb3.make(ROWS, seed=3, config=ROUGH, max_episode_steps=EPISODE_STEPS)
    monitored.reset(), plain.reset()
    rng = np.random.default_rng(0)
    count = 0
    for _ in range(100):
        action = rng.uniform(-1, 1, (ROWS, 8)).astype(np.float32)
        seen, told = monitored.step(action)[3], plain.step(action)[3]
        for one, other in zip(seen, told, strict=True):
            if other:
                assert other["episode"]["l"] == one["episode"]["l"]
                assert other["episode"]["r"] == pytest.approx(one["episode"]["r"], rel=1e-5, abs=1e-4)
                count += 1
    assert count > 10


def test_seeds_and_options_reach_the_environment_at_stable_baselines3s_next_reset(sb3):
    first = sb3.env.reset()
    second = sb3.env.reset()
    assert (second != first).any(), "the seed counts once"
    sb3.env.seed(3)
    assert_same(sb3.env.reset(), first)
    sb3.env.set_options({"command": (0.25, 0.0)})
    sb3.env.reset()
    np.testing.assert_array_equal(sb3.env.task.command, [[0.25, 0.0]] * ROWS)
    sb3.env.reset()
    assert (sb3.env.task.command != [0.25, 0.0]).any(), "options count once"


def test_the_default_seed_of_stable_baselines3s_view_is_not_a_fixed_one(sb3):
    assert (sb3.make(2).reset() != sb3.make(2).reset()).any()


def test_attributes_can_be_read_through_stable_baselines3_and_not_written(sb3):
    assert sb3.env.num_envs == ROWS
    assert sb3.env.get_attr("num_envs", indices=[0, 2]) == [ROWS, ROWS]
    assert len(sb3.env.get_attr("metadata")) == ROWS
    assert sb3.env.env_is_wrapped(gymnasium.Wrapper, indices=0) == [False]
    assert sb3.env.render_mode is None
    with pytest.raises(NotImplementedError, match=r"set_attr.*'gravity'"):
        sb3.env.set_attr("gravity", 0)
    with pytest.raises(NotImplementedError, match=r"env_method.*'jump'"):
        sb3.env.env_method("jump")
    sb3.env.close()


# --- bad input ---


@pytest.mark.parametrize(
    ("action", "message"),
    [
        (np.zeros(7), r"action: expected shape \(1, 8\).*found \(1, 7\)"),
        (np.zeros((2, 8)), r"action: expected shape.*found \(1, 2, 8\)"),
        (0.0, r"action: expected shape"),
        (np.full(8, np.nan), r"action: value nan for LF_hip_joint in row 0 is not finite"),
        ([0, 0, 0, np.inf, 0, 0, 0, 0], r"action: value inf for RF_knee_joint in row 0 is not finite"),
        ([0, 0, 0, np.inf, 0, -np.inf, 0, 0], r"action: value inf for RF_knee_joint"),
    ],
)
def test_a_bad_action_is_refused_and_nothing_moves(action, message):
    env = make(disable_env_checker=True)
    env.reset(seed=0)
    before = env.unwrapped.get_state()
    with pytest.raises(QuadrupedError, match=message):
        env.step(action)
    assert_same(env.unwrapped.get_state(), before)


def test_a_bad_action_of_one_row_is_refused_and_no_row_moves():
    env = make_native(3)
    env.reset(seed=0)
    before = env.get_state()
    action = np.zeros((3, 8))
    action[1, 7] = np.nan
    with pytest.raises(QuadrupedError, match="value nan for RH_knee_joint in row 1 is not finite"):
        env.step(action)
    with pytest.raises(QuadrupedError, match=r"expected shape \(3, 8\).*found \(8,\)"):
        env.step(np.zeros(8))
    assert_same(env.get_state(), before)


@pytest.mark.parametrize("maker", [make, make_native])
@pytest.mark.parametrize(
    ("kwargs", "message"),
    [
        ({"action_mode": "torque"}, r"action_mode: 'torque'.*position, residual"),
        ({"config": {"action": {"mode": "torque"}}}, r"'torque'.*position, residual"),
        ({"config": {"rewards": {}}}, r"config: unknown field 'rewards'; valid fields are .*reward.*randomization"),
        ({"config": {"reward": {"weight": {}}}}, r"config.reward: unknown field 'weight'; valid fields are weights"),
        ({"config": {"reward": {"weights": {"speed": 1}}}}, r"unknown reward term 'speed'; valid terms are .*upright"),
        ({"config": {"randomization": {"friction": 0.5}}}, r"config.randomization.friction: expected a pair.*0\.5"),
        ({"config": {"decimation": 2.5}}, r"config.decimation: expected a whole number; found 2\.5"),
        ({"config": {"decimation": 0}}, r"decimation must be 1 or more; found 0"),
        ({"config": []}, r"config: expected a mapping of fields; found \[\]"),
        ({"config": "fast"}, r"config: expected a mapping of fields; found 'fast'"),
        ({"render_mode": "ascii"}, r"render_mode: 'ascii' is unknown; valid modes are None, human, rgb_array"),
    ],
)
@pytest.mark.filterwarnings("ignore:.*possible render_modes")
def test_bad_arguments_are_named_with_the_valid_ones(maker, kwargs, message):
    with pytest.raises(QuadrupedError, match=message):
        maker(**kwargs)


@pytest.mark.parametrize("maker", [make, make_native])
def test_an_unknown_argument_is_refused(maker):
    with pytest.raises(TypeError, match="gravity"):
        maker(gravity=1.6)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"command": (9.0, 0.0)}, r"forward_velocity = 9 is outside .*widen config\['command'\]\['forward_velocity'\]"),
        ({"command": (0.0, -9.0)}, r"yaw_rate = -9 is outside"),
        ({"command": 0.3}, r"options\['command'\]: expected two finite numbers.*found 0\.3"),
        ({"command": (0.3,)}, r"expected two finite numbers"),
        ({"command": (0.3, 0.0, 0.0)}, r"expected two finite numbers"),
        ({"command": (0.3, np.nan)}, r"expected two finite numbers"),
        ({"command": "fast"}, r"expected two finite numbers.*found 'fast'"),
        ({"comand": (0.0, 0.0)}, r"options: unknown option 'comand'; valid options are 'command'"),
    ],
)
@pytest.mark.parametrize("maker", [make, lambda **kwargs: make_native(3, **kwargs)], ids=["single", "native"])
def test_bad_reset_options_are_refused_and_the_episode_goes_on(maker, options, message):
    env, untouched = maker(), maker()
    env.reset(seed=0), untouched.reset(seed=0)
    before = env.unwrapped.get_state()
    with pytest.raises(QuadrupedError, match=message):
        env.reset(options=options, seed=8)
    assert_same(env.unwrapped.get_state(), before)
    assert_same(env.unwrapped.reset(), untouched.unwrapped.reset())


def test_a_wider_command_range_lets_a_command_through_that_was_refused():
    env = make(config={"command": {"forward_velocity": [-1.0, 10.0]}})
    _, info = env.reset(options={"command": (9.0, 0.0)})
    assert info["command"][0] == 9.0


@pytest.mark.parametrize(
    "mask",
    [np.zeros(3, dtype=bool), np.ones(4, dtype=bool), np.ones(3), [True, False, True], True, np.ones((3, 1), bool)],
    ids=["none", "too long", "not bool", "a list", "a bool", "two axes"],
)
def test_a_bad_reset_mask_is_refused(mask):
    env = make_native(3)
    env.reset(seed=0)
    with pytest.raises(QuadrupedError, match=r"reset_mask.*bool array of shape \(3,\)"):
        env.reset(options={"reset_mask": mask})


def test_a_list_of_seeds_must_have_one_a_row():
    with pytest.raises(QuadrupedError, match="seed: expected one number, or 3, one a row; found 2"):
        make_native(3).reset(seed=[1, 2])


@pytest.mark.parametrize("count", [0, -1])
def test_there_must_be_a_robot(count):
    with pytest.raises(QuadrupedError, match=f"num_envs: expected 1 or more; found {count}"):
        make_native(count)


def test_an_episode_must_last_a_step():
    with pytest.raises(QuadrupedError, match="max_episode_steps: expected 1 or more, or None; found 0"):
        make_native(1, max_episode_steps=0)


# --- pictures ---


def test_a_window_without_a_display_is_refused_with_the_cure(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(QuadrupedError, match="needs a display, and there is none; use 'rgb_array'"):
        make(render_mode="human")


def test_a_window_shows_one_robot_only():
    with pytest.raises(QuadrupedError, match="'human' shows one robot; use 'rgb_array' here"):
        make_native(2, render_mode="human")


def test_no_opengl_is_said_with_the_packages_that_bring_it(monkeypatch):
    def broken(*args, **kwargs):
        raise AttributeError("'NoneType' object has no attribute 'eglQueryString'")

    monkeypatch.setattr(mujoco, "Renderer", broken)
    env = make(render_mode="rgb_array", disable_env_checker=True)
    env.reset(seed=0)
    with pytest.raises(QuadrupedError, match=r"no OpenGL.*apt-get install libegl1.*MUJOCO_GL.*eglQueryString"):
        env.render()
    env.close()


def assert_same_picture(picture, expected):
    # A renderer's first picture of a scene can differ a little from its second one.
    np.testing.assert_allclose(picture.astype(int), expected.astype(int), atol=3)


@pytest.mark.usefixtures("opengl")
def test_a_picture_shows_something_of_the_size_asked_for():
    env = make(render_mode="rgb_array")
    env.reset(seed=0)
    env_render_passive_checker(env)
    picture = env.render()
    assert picture.shape == (480, 640, 3)
    assert picture.dtype == np.uint8
    assert picture.std() > 5
    for _ in range(20):
        env.step(np.full(8, -1.0, dtype=np.float32))
    assert (env.render() != picture).any()
    copied = copy.deepcopy(env)
    assert_same_picture(copied.render(), env.render())
    for e in (env, copied):
        e.close()
        e.close()
    small = make(render_mode="rgb_array", width=64, height=48)
    small.reset(seed=0)
    assert small.render().shape == (48, 64, 3)
    small.close()


@pytest.mark.usefixtures("opengl")
def test_a_vector_environment_gives_a_picture_a_row_each_the_single_environments():
    kwargs = {"render_mode": "rgb_array", "width": 64, "height": 48, "config": ROUGH}
    vector, sync = make_native(2, **kwargs), make_sync(2, **kwargs)
    for env in (vector, sync):
        env.reset(seed=0)
        env.step(np.zeros((2, 8), dtype=np.float32))
    pictures = vector.render()
    assert len(pictures) == 2
    assert (pictures[0] != pictures[1]).any()
    for picture, expected in zip(pictures, sync.render(), strict=True):
        assert_same_picture(picture, expected)
    vector.close(), sync.close()


@pytest.mark.usefixtures("opengl")
def test_stable_baselines3_tiles_the_pictures(sb3):
    env = sb3.make(2, render_mode="rgb_array", width=64, height=48)
    env.reset()
    assert env.render().shape == (96, 64, 3)
    env.close()


def test_rendering_without_a_mode_says_how_to_ask_for_one():
    env = make(disable_env_checker=True)
    env.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode='rgb_array'"):
        assert env.unwrapped.render() is None
    assert make_native(2).render() is None


# --- imports ---


@pytest.mark.parametrize(
    ("environment", "libraries", "chosen"),
    [
        ({"MUJOCO_GL": "osmesa"}, {"EGL", "OSMesa"}, "osmesa"),
        ({"MUJOCO_GL": ""}, {"EGL", "OSMesa"}, ""),
        ({"MUJOCO_GL": "glfw", "DISPLAY": ":0"}, {"EGL"}, "glfw"),
        ({"DISPLAY": ":0"}, {"EGL"}, None),
        ({"WAYLAND_DISPLAY": "wayland-0"}, {"EGL"}, None),
        ({}, {"EGL", "OSMesa"}, "egl"),
        ({}, {"OSMesa"}, "osmesa"),
        ({}, set(), None),
    ],
)
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="other systems always have a display")
def test_opengl_is_chosen_only_where_nobody_chose(monkeypatch, environment, libraries, chosen):
    for name in ("MUJOCO_GL", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(_opengl.ctypes.util, "find_library", lambda name: name if name in libraries else None)
    _opengl.choose_opengl()
    assert _opengl.os.environ.get("MUJOCO_GL") == chosen


def test_the_package_imports_none_of_its_extras():
    extras = ["torch", "stable_baselines3", "matplotlib", "viser", "rosbags", "jinja2", "av", "tensorboard", "tqdm"]
    code = f"import sys, json, quadruped_env; print(json.dumps([m for m in {extras} if m in sys.modules]))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == []
