"""`MiniQuadrupedRough-v0`, and tiles in the environments: single == vector, copies, resets, `info`, configs."""

import copy
import json
import pickle

import gymnasium
import numpy as np
import pytest
from environments import ROUGH, assert_same, episodes
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode

from quadruped_env import QuadrupedError
from quadruped_env.envs import (
    ENV_ID,
    MAX_EPISODE_STEPS,
    ROUGH_CONFIG,
    ROUGH_ENV_ID,
    MiniQuadrupedRoughEnv,
    MiniQuadrupedRoughVectorEnv,
)
from quadruped_env.task import TaskConfig

STEPS = 40
# Falls and random actions change the levels up and down within a few short episodes.
LIVELY = ROUGH | {"terrain": {"levels": 4, "promote_share": 1e-3, "demote_share": 1e-3}}


def make(**kwargs):
    return gymnasium.make(ROUGH_ENV_ID, **kwargs)


def make_native(num_envs, **kwargs):
    return gymnasium.make_vec(ROUGH_ENV_ID, num_envs=num_envs, **kwargs)


def make_sync(num_envs, mode=AutoresetMode.SAME_STEP, **kwargs):
    vector_kwargs = {"autoreset_mode": mode}
    return gymnasium.make_vec(
        ROUGH_ENV_ID, num_envs=num_envs, vectorization_mode="sync", vector_kwargs=vector_kwargs, **kwargs
    )


def levels_in(log):
    return np.array([entry[-1]["terrain_level"] for entry in log])


def test_environments_are_registered_on_tiles_with_the_curriculum():
    env, vector = make(), make_native(3)
    assert isinstance(env.unwrapped, MiniQuadrupedRoughEnv)
    assert isinstance(vector, MiniQuadrupedRoughVectorEnv)
    assert env.spec.max_episode_steps == vector.task.max_episode_steps == MAX_EPISODE_STEPS
    for task in (env.unwrapped.task, vector.task):
        assert task.config == TaskConfig.from_dict(ROUGH_CONFIG)
        assert (task.config.terrain.name, task.config.terrain.curriculum) == ("tiles", True)
    assert gymnasium.make(ENV_ID).unwrapped.task.tiles is None
    assert "terrain_level" not in gymnasium.make(ENV_ID).reset(seed=0)[1]


def test_checkers_find_nothing_to_warn_about():
    check_env(make().unwrapped, skip_render_check=True)
    from stable_baselines3.common.env_checker import check_env as check_sb3_env

    check_sb3_env(make())


@pytest.mark.parametrize("mode", [AutoresetMode.SAME_STEP, AutoresetMode.NEXT_STEP])
def test_single_and_vector_environment_are_bit_identical_with_the_curriculum(mode):
    kwargs = {"config": LIVELY, "max_episode_steps": STEPS}

    def results(env):
        if mode is AutoresetMode.SAME_STEP:
            return episodes(env, 200)
        rng = np.random.default_rng(0)
        actions = rng.uniform(-1.3, 1.3, (200, *env.action_space.shape)).astype(np.float32)
        return [env.reset(seed=0), *(env.step(action) for action in actions)]

    expected = results(make_sync(4, mode, **kwargs))
    assert_same(results(make_native(4, num_threads=2, autoreset_mode=mode, **kwargs)), expected)
    changes = np.diff(levels_in(expected), axis=0)
    assert (changes > 0).any()
    assert (changes < 0).any()


def play(env, steps, seed):
    rng = np.random.default_rng(seed)
    return [env.step(rng.uniform(-1.0, 1.0, env.action_space.shape).astype(np.float32)) for _ in range(steps)]


def test_copied_pickled_and_restored_envs_keep_their_levels():
    kwargs = {"config": LIVELY, "max_episode_steps": STEPS}
    env, fresh = make_native(4, **kwargs), make_native(4, **kwargs)
    env.reset(seed=3)
    play(env, 90, 0)
    copies = [copy.deepcopy(env), pickle.loads(pickle.dumps(env))]  # noqa: S301
    fresh.reset(seed=9)
    fresh.set_state(env.get_state())
    expected = play(env, 90, 1)
    assert len(np.unique(levels_in(expected), axis=0)) > 3
    for other in (*copies, fresh):
        assert_same(play(other, 90, 1), expected)
    single = make(**kwargs, disable_env_checker=True).unwrapped
    single.set_state(fresh.get_state()[2])
    assert single.get_state()["tiles"] == fresh.get_state()[2]["tiles"]


def test_reset_without_a_seed_keeps_the_history_and_one_with_a_seed_begins_again():
    env = make(config=LIVELY)
    first = env.reset(seed=4)
    kind, level = int(first[1]["terrain_kind"]), int(first[1]["terrain_level"])
    task = env.unwrapped.task
    task.tiles.level[:] = 3 if level != 3 else 2
    info = env.reset()[1]
    assert (int(info["terrain_kind"]), int(info["terrain_level"])) == (kind, 3 if level != 3 else 2)
    assert_same(env.reset(seed=4), first)


def test_episodes_start_in_the_middle_of_their_tile_and_info_names_it():
    env = make_native(40)
    _, info = env.reset(seed=0)
    centres = env.task.config.ground.centres()
    np.testing.assert_allclose(
        info["base_position"][:, :2], centres[info["terrain_kind"], info["terrain_level"] - 1], atol=1e-12
    )
    assert len(np.unique(info["terrain_kind"])) == 7
    assert (env.task.context.sole_height > 0.0).all()
    assert info["terrain_level"].dtype == make().reset(seed=0)[1]["terrain_level"].dtype == np.int64


def test_config_changes_the_default_one_or_names_another_terrain():
    task = make(config={"terrain": {"levels": 3}, "decimation": 5}).unwrapped.task
    assert task.config.terrain.changes() == {"name": "tiles", "curriculum": True, "levels": 3}
    assert task.config.decimation == 5
    stairs = make(config={"terrain": {"name": "stairs", "level": 4}}).unwrapped.task
    assert (stairs.config.terrain.name, stairs.config.terrain.height, stairs.tiles) == ("stairs", 0.022, None)
    assert make(terrain="hills").unwrapped.task.config.terrain.name == "hills"
    assert make(config=TaskConfig()).unwrapped.task.config == TaskConfig(), "a complete config is not changed"
    assert ROUGH_CONFIG == {"terrain": {"name": "tiles", "curriculum": True}}


def test_config_of_tiles_is_saved_and_read_again():
    config = TaskConfig.from_dict({"terrain": {"name": "tiles", "kinds": ["stairs", "rough", "rough"], "levels": 6}})
    document = json.loads(json.dumps(config.to_dict()))
    assert document["terrain"] == {
        "name": "tiles",
        "seed": 0,
        "kinds": ["stairs", "rough", "rough"],
        "levels": 6,
        "curriculum": False,
        "start_levels": 5,
        "promote_share": 0.8,
        "demote_share": 0.5,
    }
    assert TaskConfig.from_dict(document) == config == pickle.loads(pickle.dumps(config))  # noqa: S301
    assert config.ground == TaskConfig().on_terrain(config.ground).ground
    assert config.on_terrain("stairs").terrain.name == "stairs"
    assert [kind.name for kind in config.ground.kinds] == ["stairs", "rough", "rough"]


WITH_LEVELS = "flat, rough, slope, steps, stairs, gaps, wave"


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"name": "stairs", "level": 11}, "terrain.level must be a whole number from 1 to 10; found 11"),
        ({"name": "stairs", "level": "hard"}, "config.terrain.level must be a whole number from 1 to 10; found 'hard'"),
        ({"name": "hills", "level": 2}, f"'hills' has no levels; leave it out, or name one of {WITH_LEVELS}"),
        (
            {"name": "tiles", "level": 2},
            "unknown field 'level'; valid fields are name, seed, kinds, levels, curriculum",
        ),
        ({"name": "tiles", "kinds": ["moon"]}, f"kinds must be one of {WITH_LEVELS}; found 'moon'"),
        ({"name": "tiles", "kinds": []}, r"kinds must be a list of one or more terrains with levels: .*; found \[\]"),
        ({"name": "tiles", "levels": 11}, "terrain.levels must be a whole number from 1 to 10; found 11"),
        ({"name": "tiles", "curriculum": 1}, "config.terrain.curriculum: expected true or false; found 1"),
        ({"name": "tiles", "promote_share": 0.0}, "terrain.promote_share must be positive, 1e-09 or more; found 0.0"),
        (
            {"name": "tiles", "demote_share": 0.9},
            r"terrain.demote_share must be at most promote_share \(0.8\); found 0.9",
        ),
    ],
)
def test_invalid_level_or_tiles_are_refused_with_the_valid_values(values, message):
    with pytest.raises(QuadrupedError, match=message):
        gymnasium.make(ENV_ID, config={"terrain": values})


def test_level_of_a_section_follows_when_it_is_replaced():
    config = TaskConfig.from_dict({"terrain": {"name": "stairs", "level": 4}})
    assert config.terrain.to_dict() == {"name": "stairs", "seed": 0, "level": 4, "height": 0.022, "run": 0.2}
    assert config.terrain.replace(level=7).height == pytest.approx(0.0385)
    assert config.terrain.replace(level=None).height == 0.02
    assert config.terrain.replace(height=0.05).replace(level=7).height == 0.05
    assert config.on_terrain("stairs").ground == config.ground == TaskConfig().on_terrain(config.ground).ground
    steep = config.on_terrain(config.ground.variant(level=9))
    assert steep.terrain.height == pytest.approx(0.0495)
    assert steep.on_terrain("slope").terrain.level is None
