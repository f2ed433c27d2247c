"""Terrain in the task and its config: heights over the ground, one ground for every env, a user's own terrain."""

import copy
import dataclasses
import json
import pickle
import subprocess
import sys

import gymnasium
import numpy as np
import pytest
from built_in import FOOT_RADIUS, STANCE, STANCE_HEIGHT
from comparisons import random_policy
from environments import ROUGH, assert_same, episodes, make, make_native, make_sync
from grounds import ray_heights, slope

from quadruped_env import QuadrupedError
from quadruped_env.envs import ENV_ID
from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation, build_model, find_terrain
from quadruped_env.simulation.built_in_terrains import hills, rough
from quadruped_env.task import Task, TaskConfig, load_task_file

UNEVEN = ("hills", "tiles")


# --- the task


def test_heights_of_the_task_are_over_the_ground_below():
    task = make_native(6, terrain="hills").task
    task.reset(np.arange(6), list(range(6)))
    simulation, field = task.simulation, task.simulation.height_field
    qpos = np.tile([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, *STANCE], (6, 1))
    qpos[:, :2] = np.random.default_rng(0).uniform(-10.0, 10.0, (6, 2))
    qpos[:, 2] = STANCE_HEIGHT + field.at(qpos)
    task.place(np.arange(6), qpos, np.zeros((6, 14)))
    assert np.ptp(simulation.readings.base_position[:, 2]) > 0.02
    np.testing.assert_allclose(task.context.base_height, STANCE_HEIGHT, atol=1e-9)
    feet = simulation.readings.foot_position
    ground = np.reshape(ray_heights(simulation.model, feet[..., :2].reshape(-1, 2)), (6, 4))
    expected = feet[..., 2] - FOOT_RADIUS - ground
    np.testing.assert_allclose(task.context.sole_height, expected, atol=1e-9)
    np.testing.assert_allclose(task.context.ground_height(feet), field.at(feet))
    flat = make_native(2).task.context.ground_height(feet[:2])
    assert flat.shape == (2, 4)
    assert not flat.any()


def test_start_is_over_the_highest_ground_below_the_robot():
    config = TaskConfig.from_dict({"randomization": {"start_joint_position": 0.0, "start_tilt": 0.0}})
    for shape in (hills, slope, slope.variant(angle=0.4, direction=1.0)):
        task = Task(BatchSimulation(build_model(terrain=shape), 4), config)
        task.reset(np.arange(4), list(range(4)))
        expected = STANCE_HEIGHT + task.simulation.height_field.highest(np.zeros(2), MINI_QUADRUPED.footprint)
        np.testing.assert_allclose(task.simulation.readings.base_position[:, 2], expected)
        assert (task.context.sole_height > -1e-9).all()
        assert (expected > STANCE_HEIGHT + 0.01) == (shape is not hills)


def test_config_on_a_terrain_that_its_definition_lacks_has_its_seed_and_parameters():
    on_slope = TaskConfig().on_terrain(slope.variant(4, angle=0.1))
    assert on_slope.ground == slope.variant(4, angle=0.1)
    assert on_slope.terrain.to_dict() == {"name": "slope", "seed": 4, "angle": 0.1, "direction": 0.0}
    assert on_slope.on_terrain("rough").on_terrain("slope").ground == slope.variant(4)
    assert on_slope.on_terrain(slope, seed=5).ground == slope.variant(5, angle=0.1)
    assert on_slope == pickle.loads(pickle.dumps(on_slope)) == copy.deepcopy(on_slope)  # noqa: S301
    assert on_slope.definition != TaskConfig().definition
    assert TaskConfig().on_terrain(rough.variant(3)) == TaskConfig().on_terrain("rough", 3)
    steep = dataclasses.replace(slope, name="rough")
    assert TaskConfig().on_terrain("rough").on_terrain(steep).ground == steep
    with pytest.raises(QuadrupedError, match="'cliff' is unknown; there are flat, rough, hills"):
        TaskConfig().on_terrain("cliff")


GRAVEL = """
from quadruped_env.task import Randomization, terrain


@terrain(size=8.0)
def gravel(grid, height: float = 0.02):
    return height * grid.random.random(grid.x.shape) * grid.fade


aside = Randomization("aside", lambda event, values: None, 1.0)
"""


def gravel_from(path, text=GRAVEL):
    """Definition of a file at a path, and its terrain."""
    path.write_text(text)
    definition = load_task_file(path)
    return definition, find_terrain("gravel", definition.terrains)


def test_config_on_a_terrain_of_a_file_names_the_file_and_is_read_back_with_it_alone(tmp_path):
    definition, gravel = gravel_from(tmp_path / "gravel.py")
    config = TaskConfig().on_terrain(gravel.variant(3, height=0.01))
    document = json.loads(json.dumps(config.to_dict()))
    assert document["terrain"] == {"name": "gravel", "seed": 3, "height": 0.01}
    assert document["terrain_file"] == definition.file.to_dict()
    assert "task_file" not in document
    again = TaskConfig.from_dict(document, definition)
    assert again == config
    assert "aside" not in again.randomization, "the file gave its terrain alone"
    assert make(config=document, task_file=str(tmp_path / "gravel.py")).unwrapped.task.config == config
    # The file of the whole task is named once.
    whole = TaskConfig(definition=definition).on_terrain("gravel").to_dict()
    assert definition.file.to_dict().items() <= whole["task_file"].items()
    assert "terrain_file" not in whole
    assert "terrain_file" not in config.on_terrain("hills").to_dict()


def test_config_on_tiles_with_a_kind_of_a_file_names_the_file_and_is_read_back_with_it_alone(tmp_path):
    text = GRAVEL.replace("size=8.0", 'hardest={"height": 0.03}')
    definition, gravel = gravel_from(tmp_path / "gravel.py", text)
    tiles = find_terrain("tiles").of([find_terrain("slope"), gravel], levels=2)
    config = TaskConfig().on_terrain(tiles)
    assert config.ground.kinds == tiles.kinds
    document = json.loads(json.dumps(config.to_dict()))
    assert document["terrain"]["kinds"] == ["slope", "gravel"]
    assert document["terrain_file"] == definition.file.to_dict()
    again = TaskConfig.from_dict(document, definition)
    assert again == config
    assert again.ground.provenance() == {"terrain": "tiles", "terrain_file": definition.file.to_dict()}
    assert "aside" not in again.randomization, "the file gave its terrain alone"
    with pytest.raises(QuadrupedError, match=r"the terrain 'tiles' from 'gravel.py', which is not executed"):
        TaskConfig.from_dict(document)


def test_config_on_a_terrain_of_a_file_is_refused_without_the_file_and_read_with_another_version(tmp_path):
    _, gravel = gravel_from(tmp_path / "gravel.py")
    document = TaskConfig().on_terrain(gravel).to_dict()
    missing = r"the terrain 'gravel' from 'gravel.py', which is not executed.* name it with --task FILE"
    with pytest.raises(QuadrupedError, match=missing):
        TaskConfig.from_dict(document)
    other, _ = gravel_from(tmp_path / "other.py", GRAVEL + "# changed\n")
    assert TaskConfig.from_dict(document, other).ground.file == other.file
    with pytest.raises(QuadrupedError, match=r"config.terrain_file: expected name and sha256; found 3"):
        TaskConfig.from_dict(document | {"terrain_file": 3}, other)


def test_policy_for_a_terrain_of_a_file_is_loaded_with_the_file(tmp_path):
    _, gravel = gravel_from(tmp_path / "gravel.py")
    config = TaskConfig().on_terrain(gravel)
    policy = random_policy("residual", definition=config.definition, terrain=config.terrain)
    policy.save(tmp_path / "run")
    with pytest.raises(QuadrupedError, match=r"from 'gravel.py', which is not executed.* name it with --task FILE"):
        load_policy(tmp_path / "run")
    loaded = load_policy(tmp_path / "run", tmp_path / "gravel.py")
    assert loaded.config == policy.config
    assert loaded.make_env().unwrapped.task.config.ground == gravel


@pytest.mark.parametrize("name", UNEVEN)
def test_single_and_vector_environment_on_a_terrain_are_bit_identical(name):
    kwargs = {"config": ROUGH | {"terrain": {"name": name, "seed": 3}}, "max_episode_steps": 60}
    expected = episodes(make_sync(3, **kwargs), 100)
    assert_same(episodes(make_native(3, num_threads=2, **kwargs), 100), expected)


def walk(env, steps):
    """Rewards of an env that walks by the scripted gait, from its present state."""
    return [float(env.step(np.zeros(8, np.float32))[1]) for _ in range(steps)]


def test_copied_and_pickled_env_on_a_terrain_continues_identically():
    env = make(action_mode="residual", terrain="hills")
    env.reset(seed=1, options={"command": (0.5, 0.0)})
    walk(env, 150)
    state, copied, pickled = env.unwrapped.get_state(), copy.deepcopy(env), pickle.loads(pickle.dumps(env))  # noqa: S301
    other = make(action_mode="residual", terrain="hills")
    other.reset(seed=5)
    other.unwrapped.set_state(state)
    expected = walk(env, 50)
    task = env.unwrapped.task
    assert np.abs(task.context.ground_height(task.simulation.readings.foot_position)).max() > 0.0
    for again in (copied, pickled, other):
        assert walk(again, 50) == expected
    np.testing.assert_array_equal(pickled.unwrapped.task.context.base_height, task.context.base_height)


def test_env_on_a_terrain_is_made_again_from_its_spec():
    env = gymnasium.make(ENV_ID, terrain="rough", config={"terrain": {"seed": 2}})
    again = gymnasium.make(gymnasium.envs.registration.EnvSpec.from_json(env.spec.to_json()))
    for one in (env, again):
        section = one.unwrapped.task.config.terrain
        assert dict(section) == {"name": "rough", "seed": 2, "level": None, "height": 0.01, "distance": 0.2}
    np.testing.assert_array_equal(again.unwrapped.model.hfield_data, env.unwrapped.model.hfield_data)


# --- the config


def test_terrain_of_a_config_is_saved_and_validated():
    config = TaskConfig.from_dict({"terrain": {"name": "hills", "height": np.float32(0.5), "seed": 7}})
    document = json.loads(json.dumps(config.to_dict()))
    assert document["terrain"] == {"name": "hills", "seed": 7, "height": 0.5, "distance": 2.5}
    assert TaskConfig.from_dict(document) == config == pickle.loads(pickle.dumps(config))  # noqa: S301
    assert config.ground == hills.variant(7, height=0.5)
    assert config.on_terrain("hills") == config
    assert config.on_terrain("rough").ground == rough.variant(7)
    assert config.on_terrain("hills", 1).ground == hills.variant(1, height=0.5)
    assert "name='hills'" in repr(config.terrain)
    assert TaskConfig().ground == find_terrain("flat")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"name": "moon"}, "terrain: 'moon' is unknown; there are flat, rough, hills"),
        ({"height": 0.1}, "config.terrain: unknown field 'height'; valid fields are name, seed"),
        ({"name": "rough", "height": -1.0}, r"terrain.height must be at least 0 \(m\); found -1.0"),
        ({"seed": -1}, "terrain.seed must be a whole number from 0 to 4294967295; found -1"),
    ],
)
def test_invalid_terrain_of_a_config_is_refused_with_the_valid_values(values, message):
    with pytest.raises(QuadrupedError, match=message):
        gymnasium.make(ENV_ID, config={"terrain": values})


OWN = """
import numpy as np
from quadruped_env.task import terrain

@terrain(size=6.0, cell=0.05)
def ridges(grid, height: float = 0.02):
    "Steps of 0.5 m."
    return height * (grid.x // 0.5)
"""
STEP = """
import pickle, sys
env = pickle.load(open(sys.argv[1], "rb"))
print(float(env.step([0.1] * 8)[1]).hex())
"""


def test_terrain_of_a_users_file_is_chosen_by_name_and_pickled(tmp_path):
    file = tmp_path / "own.py"
    file.write_text(OWN)
    env = gymnasium.make(ENV_ID, task_file=file, config={"terrain": {"name": "ridges", "height": 0.05}})
    env.reset(seed=0)
    field = env.unwrapped.task.simulation.height_field
    assert field.points().shape == (121, 121, 3)
    assert field.at(np.array([0.75, 0.3])) == pytest.approx(0.05)
    assert gymnasium.make(ENV_ID, task_file=file).unwrapped.model.nhfield == 0
    config = env.unwrapped.task.config
    assert TaskConfig.from_dict(config.to_dict(), load_task_file(file)) == config
    pickled = tmp_path / "env.pickle"
    pickled.write_bytes(pickle.dumps(env))
    expected = float(env.step(np.full(8, 0.1))[1]).hex()
    done = subprocess.run([sys.executable, "-c", STEP, pickled], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == expected
    with pytest.raises(QuadrupedError, match="'ridges' is unknown; there are flat, rough, hills"):
        gymnasium.make(ENV_ID, terrain="ridges")


def test_level_replaces_the_parameters_that_the_config_had():
    stairs = find_terrain("stairs")
    config = TaskConfig.from_dict({"terrain": {"name": "stairs", "height": 0.011}})
    assert config.on_terrain(stairs.variant(level=3)).ground == stairs.variant(level=3)
    assert config.on_terrain(stairs.variant(level=3)).terrain.replace(level=5).ground == stairs.variant(level=5)
