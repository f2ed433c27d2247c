"""The environments: Gymnasium's contract, single == vector to the last bit, info and divergence."""

import copy
import subprocess
import sys

import gymnasium
import mujoco
import numpy as np
import pytest
import twelve_joints
from environments import (
    ACTION_MODES,
    EPISODE_STEPS,
    NUM_ENVS,
    ROUGH,
    SAFE,
    assert_same,
    episodes,
    make,
    make_native,
    make_sync,
    play,
)
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode
from tasks import OBSERVATION_WIDTH
from waiting import output_of

from quadruped_env.envs import ENV_ID, MAX_EPISODE_STEPS, MiniQuadrupedVectorEnv

# --- the contracts ---


@pytest.mark.parametrize("mode", ACTION_MODES)
def test_checkers_of_gymnasium_and_stable_baselines3_find_nothing_to_warn_about(mode):
    from stable_baselines3.common.env_checker import check_env as check_sb3_env

    check_env(make(action_mode=mode).unwrapped, skip_render_check=True)
    check_sb3_env(make(action_mode=mode))


def test_observations_stay_in_their_space_under_extreme_actions():
    env = make_native(
        64, action_mode="residual", config=ROUGH | {"termination": {"max_tilt": 3.1, "max_trunk_force": 1e9}}
    )
    observation, _ = env.reset(seed=0)
    rng = np.random.default_rng(0)
    for _ in range(100):
        assert observation in env.observation_space
        # Actions that jump from one bound to the other: rougher than any policy.
        observation, *_ = env.step(rng.choice([-1.0, 1.0], (64, 8)).astype(np.float32))


def test_native_vector_environment_describes_itself():
    env = make_native(3)
    assert isinstance(env, MiniQuadrupedVectorEnv)
    assert env.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP
    assert env.task.max_episode_steps == MAX_EPISODE_STEPS
    single = make()
    assert env.single_observation_space == single.observation_space
    assert env.single_action_space == single.action_space
    assert env.observation_space.shape == (3, OBSERVATION_WIDTH)


# --- single == vector, to the last bit ---


@pytest.mark.parametrize(
    ("robot", "episode_steps"),
    [(None, EPISODE_STEPS), (twelve_joints.ROBOT, EPISODE_STEPS // 2)],  # the second falls sooner
    ids=["built-in", "twelve"],
)
@pytest.mark.parametrize("mode", ACTION_MODES)
def test_native_vector_environment_equals_single_environments_to_the_last_bit(mode, robot, episode_steps):
    kwargs = {"action_mode": mode, "config": ROUGH, "robot": robot, "max_episode_steps": episode_steps}
    expected = episodes(make_sync(**kwargs), 160)
    assert_same(episodes(make_native(num_threads=3, **kwargs), 160), expected)
    steps = [entry for entry in expected if len(entry) == 5]
    resets = [entry for entry in expected if len(entry) == 2]
    assert len(resets) > 1, "masked resets"
    falls = sum(terminated.sum() for _, _, terminated, _, _ in steps)
    time_outs = sum(truncated.sum() for _, _, _, truncated, _ in steps)
    assert falls > 0
    assert time_outs > 0
    finished = sum(info["_final_obs"].sum() for *_, info in steps if "final_info" in info)
    assert finished == sum((terminated | truncated).sum() for _, _, terminated, truncated, _ in steps)


@pytest.mark.slow
def test_asynchronous_vector_environment_equals_the_native_one():
    kwargs = {"config": ROUGH, "max_episode_steps": EPISODE_STEPS}
    vector_kwargs = {"autoreset_mode": AutoresetMode.SAME_STEP, "context": "spawn"}
    env = gymnasium.make_vec(ENV_ID, num_envs=2, vectorization_mode="async", vector_kwargs=vector_kwargs, **kwargs)
    try:
        assert_same(episodes(env, 100), episodes(make_native(2, **kwargs), 100))
    finally:
        env.close()


def test_masked_reset_leaves_the_other_envs_unchanged():
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
            assert set(options) == {"reset_mask", "command"}, "the caller's options must not change"
            np.testing.assert_array_equal(info["_command"], mask)
            np.testing.assert_array_equal(info["command"][mask], [[0.1, 0.2]] * 2)
            assert (observation[mask] != expected[mask]).any(axis=1).all()
            np.testing.assert_array_equal(env.task.control.steps, [6, 0, 6, 0])
        assert_same(observation[~mask], expected[~mask])


# --- seeds ---


def test_seed_determines_everything_including_the_commands():
    def trace(seed):
        env = make_native(config=ROUGH, max_episode_steps=EPISODE_STEPS)
        return episodes(env, 100, seed)

    first, again = trace(3), trace(3)
    assert_same(again, first)
    commands = np.array([info["command"] for *_, info in first])
    assert len(np.unique(commands.reshape(-1, 2), axis=0)) > 5 * commands.shape[1], (
        "commands must have been sampled again"
    )
    assert (commands != np.array([info["command"] for *_, info in trace(4)])).any(axis=(1, 2)).all()


@pytest.mark.parametrize("maker", [make, make_native])
def test_the_default_seed_is_not_a_fixed_one(maker):
    assert (maker().reset()[0] != maker().reset()[0]).any()


def test_reset_without_a_seed_continues_with_the_generator():
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
    assert not info["diverged"]


@pytest.mark.parametrize("mode", ACTION_MODES)
def test_info_values_are_numpy_of_the_vector_environments_dtype_and_shape(mode):
    env, vector = make(action_mode=mode, config=ROUGH), make_native(2, action_mode=mode, config=ROUGH)
    for single, many in (
        (env.reset(seed=0), vector.reset(seed=0)),
        (env.step(np.zeros(8)), vector.step(np.zeros((2, 8)))),
    ):
        info, infos = single[-1], many[-1]
        assert {*info, *(f"_{name}" for name in info)} == set(infos)
        for name, value in info.items():
            assert isinstance(value, (np.ndarray, np.generic)), name
            assert (value.dtype, value.shape) == (infos[name].dtype, infos[name].shape[1:]), name
            assert value.dtype != object
            assert isinstance(infos[f"_{name}"], np.ndarray)


def test_np_random_seed_after_a_seeded_reset_is_the_seed_in_every_environment():
    env, vector, sync = make(), make_native(3), make_sync(3)
    env.reset(seed=7), vector.reset(seed=7), sync.reset(seed=7)
    assert env.unwrapped.np_random_seed == 7
    assert vector.np_random_seed == sync.np_random_seed == (7, 8, 9)
    vector.reset(seed=[None, 3, 4], options={"reset_mask": np.array([True, True, False])})
    assert vector.np_random_seed == (7, 3, 9)
    vector.reset()
    assert vector.np_random_seed == (7, 3, 9), "a generator that runs on keeps its seed"
    restored = make().unwrapped
    restored.set_state(env.unwrapped.get_state())
    assert restored.np_random_seed == 7


def test_returned_values_do_not_change_later():
    env = make_native(config=ROUGH, max_episode_steps=EPISODE_STEPS)
    env.reset(seed=0)
    rng = np.random.default_rng(0)
    entries, copies = [], []
    for _ in range(60):
        entries.append(env.step(rng.uniform(-1, 1, (NUM_ENVS, 8))))
        copies.append(copy.deepcopy(entries[-1]))
    assert_same(entries, copies)


# --- divergence ---


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e11])
def test_state_that_diverges_ends_the_episode_as_diverged(value):
    env = make(config=SAFE)
    env.reset(seed=0)
    env.step(np.zeros(8))
    env.unwrapped.data.qvel[3] = value
    observation, reward, terminated, truncated, info = env.step(np.zeros(8))
    assert info["diverged"]
    assert terminated
    assert not truncated
    assert observation in env.observation_space
    assert np.isfinite(reward)
    env.reset()
    *_, terminated, _, info = env.step(np.zeros(8))
    assert not info["diverged"]
    assert not terminated


@pytest.mark.parametrize("value", [np.nan, 1e11])
def test_env_that_diverges_leaves_the_other_envs_identical_to_the_last_bit(value):
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


DIVERGE = """
import gymnasium, numpy as np{imports}, quadruped_env
env = gymnasium.make("MiniQuadruped-v0")
env.reset(seed=0)
env.unwrapped.data.qvel[3] = np.nan
assert env.step(np.zeros(8))[4]["diverged"]
env = gymnasium.make_vec("MiniQuadruped-v0", num_envs=64, num_threads=4)
env.reset(seed=0)
env.task.simulation.batch.bind("qvel")[:, 3] = np.nan
assert env.step(np.zeros((64, 8)))[4]["final_info"]["diverged"].all()
"""


def test_divergence_prints_mujocos_warnings_and_writes_no_file(tmp_path):
    process = run_python(DIVERGE.format(imports=""), tmp_path)
    _, errors = output_of(process)
    assert process.returncode == 0, errors
    # Once per simulation.
    assert errors.count("The simulation is unstable") == 65
    assert list(tmp_path.iterdir()) == []


def run_python(code, directory):
    return subprocess.Popen(
        [sys.executable, "-c", code], cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
