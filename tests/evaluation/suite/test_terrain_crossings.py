"""Crossings of tiles: what counts as one, and the highest level passed."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from settings import settings
from synthetic import synthetic_rollout

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.suite import steady
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.policies import GaitController, ZeroController
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import Task, TaskConfig

PART = replace(full_suite().terrain, num_seeds=4, worlds=1)
TUNED = Candidate("tuned", GaitController(), TaskConfig())


def levels(*shares):
    return [{"mean": share} for share in shares]


@pytest.mark.parametrize(
    ("shares", "expected"), [((), 0), ((0.89,), 0), ((0.9, 1.0, 0.5), 2), ((1.0, 0.2, 1.0), 1), ((1.0,) * 10, 10)]
)
def test_highest_level_is_that_up_to_which_every_level_is_passed(shares, expected):
    assert steady.highest(levels(*shares), PART) == expected


def test_levels_are_tried_until_the_first_that_is_not_passed(monkeypatch):
    """A robot that passes `rough` up to level 3 and `steps` nowhere."""
    tried = []

    def crossings(part, measured, kinds, level, progress=None):
        tried.append((level, tuple(kinds)))
        return {kind: (np.arange(10) < (9 if kind == "rough" and level <= 3 else 8))[None] for kind in kinds}

    monkeypatch.setattr(steady, "crossings", crossings)
    done = []
    found = steady.run_terrain(replace(PART, kinds=("rough", "steps"), num_seeds=10), TUNED, done.append)
    result = found["kinds"]
    # Of 10 levels, eight starts cross 4 of rough and 1 of steps, one 3 of rough, and one none.
    assert found["contributions"] == pytest.approx([0.4] * 8 + [0.3, 0.0] + [0.1] * 8 + [0.0] * 2)
    assert tried == [(1, ("rough", "steps")), (2, ("rough",)), (3, ("rough",)), (4, ("rough",))]
    assert result["rough"]["highest_level"] == 3
    assert [entry["mean"] for entry in result["rough"]["crossed"]] == [0.9, 0.9, 0.9, 0.8]
    assert (result["steps"]["highest_level"], len(result["steps"]["crossed"])) == (0, 1)
    assert done == [1.0]


def test_robots_start_on_their_tiles_and_cross_when_they_leave_them():
    """On level 1 of `slope` the searched gait leaves the tile at 0.4 m/s; a robot that stands does not."""
    part = replace(PART, kinds=("rough", "slope"), levels=2)
    crossed = steady.crossings(part, TUNED, ["slope"], 1)
    assert list(crossed) == ["slope"]
    assert crossed["slope"].mean() >= 0.75
    standing = Candidate("standing", ZeroController(), TaskConfig())
    short = replace(part, seconds=1.0)
    assert not steady.crossings(short, standing, ["rough", "slope"], 2)["rough"].any()
    # 0.4 m/s for 4.5 s are 1.8 m: no robot can have left its tile.
    assert not steady.crossings(replace(part, seconds=4.5), TUNED, ["slope"], 1)["slope"].any()


def test_a_fall_before_the_edge_is_no_crossing_and_every_world_has_its_own_tiles():
    part = replace(PART, kinds=("rough",), levels=1, num_seeds=2, first_seed=1, worlds=3)
    worlds = []

    def run(commands, seeds, seconds, progress, terrain, tiles):
        """Both robots leave their tile at the third sample; the second one falls at the second."""
        worlds.append(terrain.seed)
        pose, fell = np.zeros((4, 2, 7)), np.zeros((4, 2), dtype=bool)
        pose[2:, :, 0], fell[1, 1] = 2.1, True
        return synthetic_rollout(4, 2, base_pose=pose, fell=fell, terrain=terrain)

    crossed = steady.crossings(part, SimpleNamespace(run=run), ["rough"], 1)["rough"]
    np.testing.assert_array_equal(crossed, [[True, False]] * 3)
    assert worlds == [1, 2, 3]


def tiled_task(envs):
    config = TaskConfig.from_dict({"terrain": {"name": "tiles", "kinds": ["rough", "steps"], "levels": 3}})
    return Task(BatchSimulation(config.compiled_model(), envs), config)


def test_reset_puts_envs_on_the_tiles_that_it_is_called_with():
    task = tiled_task(3)
    task.reset(np.arange(3), [1, 2, 3], tiles=np.array([[0, 1], [1, 3], [1, 2]]))
    # Levels along x, 4 m each, kinds along y.
    np.testing.assert_allclose(
        task.simulation.readings.base_position[:, :2], [[-4.0, -2.0], [4.0, 2.0], [0.0, 2.0]], atol=1e-9
    )
    before = task.simulation.readings.base_position.copy()
    task.reset(np.array([1]), [2], tiles=np.array([[0, 2]]))
    np.testing.assert_allclose(task.simulation.readings.base_position[1, :2], [0.0, -2.0], atol=1e-9)
    np.testing.assert_array_equal(task.simulation.readings.base_position[[0, 2]], before[[0, 2]])


@pytest.mark.parametrize(
    ("tiles", "words"),
    [
        ([[0, 1]], r"tiles must be of shape \(2, 2\)"),
        ([[0, 1], [2, 1]], r"kinds 0 to 1 and levels 1 to 3; found \[2, 1\] for episode 1"),
        ([[0, 0], [1, 1]], r"levels 1 to 3; found \[0, 0\] for episode 0"),
        ([[0, 4], [1, 1]], r"found \[0, 4\] for episode 0"),
        ([[-1, 1], [1, 1]], r"found \[-1, 1\] for episode 0"),
    ],
)
def test_tiles_that_do_not_exist_are_named_and_no_env_changes(tiles, words):
    task = tiled_task(2)
    task.reset(np.arange(2), [1, 2], tiles=np.array([[0, 1], [1, 3]]))
    before = task.simulation.readings.base_position.copy()
    with pytest.raises(QuadrupedError, match=words):
        task.reset(np.arange(2), [3, 4], tiles=np.array(tiles))
    np.testing.assert_array_equal(task.simulation.readings.base_position, before)


def test_tiles_need_their_terrain():
    config = TaskConfig.from_dict(settings())
    task = Task(BatchSimulation(config.compiled_model(), 1), config)
    with pytest.raises(QuadrupedError, match="tiles need the terrain 'tiles'; found 'flat'"):
        task.reset(np.arange(1), [1], tiles=np.array([[0, 1]]))
