"""Starts on tiles and the curriculum: hand-computed histories, and the law of the tiles."""

import types

import numpy as np
import pytest

from quadruped_env.simulation import find_terrain
from quadruped_env.task import TaskConfig
from quadruped_env.task.randomization.draws import Draws
from quadruped_env.task.randomization.tile_assignment import TileAssignment

TIMESTEP = 0.02
TILES = find_terrain("tiles")
CENTRES = TILES.centres()


def assignment(num_envs=1, seed=0, **changes):
    """Tiles of envs that have begun their first episodes, and the draws of the envs."""
    section = TaskConfig.from_dict({"terrain": {"name": "tiles", "curriculum": True, **changes}}).terrain
    tiles, draws = TileAssignment(section, num_envs), Draws(num_envs)
    for env_id in range(num_envs):
        draws.set_key(env_id, np.random.default_rng(seed + env_id))
    begin(tiles, draws, first=True)
    return tiles, draws


def begin(tiles, draws, first=False):
    """Begin the next episodes; returns where they start."""
    env_ids = np.arange(tiles.memory.num_envs)
    draws.begin_episode(env_ids)
    return tiles.begin_episodes(env_ids, np.full(len(env_ids), first), draws)


def walk(tiles, seconds, command, velocity, *, offset=(0.0, 0.0), terminated=False, diverged=False):
    """Control steps of all envs with the same readings; `terminated` and `diverged` hold in the last one."""
    n, steps = tiles.memory.num_envs, round(seconds / TIMESTEP)
    centres = tiles._centre_of(slice(None))
    context = types.SimpleNamespace(
        command=np.insert(np.tile(np.atleast_1d(command), (n, 1)), 1, 0.3, axis=1),
        velocity=np.insert(np.tile(np.atleast_1d(velocity), (n, 1)), 1, 0.1, axis=1),
        readings=types.SimpleNamespace(base_position=np.c_[centres + offset, np.zeros(n)]),
        timestep=TIMESTEP,
    )
    for step in range(1, steps + 1):
        last = step == steps
        tiles.update(context, np.full(n, last and terminated), np.full(n, last and diverged), None)


def level_after(history, level=5, **changes):
    """Level of an env of some level after an episode."""
    tiles, draws = assignment(**changes)
    tiles.level[:] = level
    history(tiles)
    begin(tiles, draws)
    return int(tiles.level[0])


# --- promotion and demotion, by hand

CHANGES = {
    # seconds, command, velocity, fall, change of the level
    "all of 5 m": (10.0, 0.5, 0.5, False, 1),
    "82 % of 5 m": (10.0, 0.5, 0.41, False, 1),
    "78 %": (10.0, 0.5, 0.39, False, 0),
    "52 %": (10.0, 0.5, 0.26, False, 0),
    "48 %": (10.0, 0.5, 0.24, False, -1),
    "backwards as commanded": (10.0, -0.3, -0.29, False, 1),
    "forwards instead of backwards": (10.0, -0.3, 0.3, False, -1),
    "backwards instead of forwards": (10.0, 0.3, -0.3, False, -1),
    "more than commanded": (10.0, 0.2, 0.5, False, 1),
    "no command": (20.0, 0.0, 0.4, False, 0),
    "0.4 m commanded": (10.0, 0.04, 0.0, False, 0),
    "0.6 m commanded": (15.0, 0.04, 0.0, False, -1),
    # A fallen robot was to walk until 20 s, 10 m in all.
    "fall after 2.5 of 10 m": (5.0, 0.5, 0.5, True, -1),
    "fall after 5.5 of 10 m": (11.0, 0.5, 0.5, True, 0),
    "fall after 8.5 of 10 m": (17.0, 0.5, 0.5, True, 1),
    "fall at once": (0.02, 0.5, 0.5, True, -1),
    "fall without a command": (5.0, 0.0, 0.0, True, 0),
    "fall after 20 s": (25.0, 0.2, 0.18, True, 1),
}


@pytest.mark.parametrize(("seconds", "command", "velocity", "fall", "change"), CHANGES.values(), ids=CHANGES)
def test_level_after_an_episode(seconds, command, velocity, fall, change):
    found = level_after(lambda tiles: walk(tiles, seconds, command, velocity, terminated=fall))
    assert found == 5 + change


@pytest.mark.parametrize(
    ("velocity", "change"),
    [((0.3, -0.4), 1), ((0.5, 0.0), 0), ((0.4, 0.3), -1), ((0.0, -0.5), 1), ((-0.3, 0.4), -1)],
)
def test_way_of_a_robot_that_moves_sideways_counts_along_the_command(velocity, change):
    """Of 5 m along (0.6, -0.8): 5, 3, 0, 4 and -5 m."""
    assert level_after(lambda tiles: walk(tiles, 10.0, (0.3, -0.4), velocity), promote_share=0.79) == 5 + change


def test_shares_of_the_config_decide():
    episode = lambda tiles: walk(tiles, 10.0, 0.5, 0.35)  # noqa: E731  70 %
    assert level_after(episode) == 5
    assert level_after(episode, promote_share=0.65) == 6
    assert level_after(episode, promote_share=0.9, demote_share=0.75) == 4


@pytest.mark.parametrize(("offset", "change"), [((2.01, 0.0), 1), ((0.3, -2.01), 1), ((1.99, 1.99), -1)])
def test_robot_that_left_its_tile_is_promoted_though_it_came_back_or_fell(offset, change):
    def history(tiles):
        walk(tiles, 1.0, 0.5, 0.1, offset=offset)
        walk(tiles, 9.0, 0.5, 0.0, terminated=True)

    assert level_after(history) == 5 + change


def test_distance_adds_up_over_changing_commands():
    def history(back):
        def walked(tiles):
            walk(tiles, 5.0, 0.5, 0.5)  # 2.5 of 2.5 m
            walk(tiles, 5.0, -0.3, back)  # of 1.5 m
            walk(tiles, 5.0, 0.0, 0.4)  # of nothing

        return walked

    assert level_after(history(-0.18)) == 6, "3.4 of 4 m"
    assert level_after(history(-0.1)) == 5, "3.0 of 4 m"
    assert level_after(history(0.15)) == 4, "1.75 of 4 m"


def test_divergence_is_a_fall_and_its_readings_do_not_count():
    assert level_after(lambda tiles: walk(tiles, 2.0, 0.5, 0.5, terminated=True, diverged=True)) == 4
    for velocity, offset in ((np.nan, (np.nan, 0.0)), (1e9, (50.0, 0.0))):

        def history(tiles, velocity=velocity, offset=offset):
            walk(tiles, 2.0, 0.5, 0.5)
            walk(tiles, TIMESTEP, 0.5, velocity, offset=offset, terminated=True, diverged=True)

        assert level_after(history) == 4


def test_episode_counts_once():
    tiles, draws = assignment()
    tiles.level[:] = 5
    walk(tiles, 10.0, 0.5, 0.5)
    assert [int(begin(tiles, draws)[0, 0] and tiles.level[0]) for _ in range(3)] == [6, 6, 6]


def test_envs_that_do_not_run_in_a_step_do_not_change():
    tiles, _ = assignment(3)
    tiles.level[:] = 5
    walk(tiles, 10.0, 0.5, 0.5)
    before = [tiles.memory.get_state(env_id) for env_id in (0, 2)]
    context = types.SimpleNamespace(
        command=np.full((3, 2), 0.5),
        velocity=np.zeros((3, 2)),
        readings=types.SimpleNamespace(base_position=np.full((3, 3), 99.0)),
        timestep=TIMESTEP,
    )
    tiles.update(context, np.ones(3, bool), np.zeros(3, bool), np.array([1]))
    for state, env_id in zip(before, (0, 2), strict=True):
        assert state == tiles.memory.get_state(env_id)
    assert tiles.memory.get_state(1)["left_tile"]


# --- ends of the range


def test_first_level_is_the_lowest():
    assert level_after(lambda tiles: walk(tiles, 5.0, 0.5, 0.0), level=1) == 1


@pytest.mark.parametrize("levels", [10, 4])
def test_env_that_finished_the_last_level_goes_to_a_random_one(levels):
    tiles, draws = assignment(2000, levels=levels)
    kinds = tiles.kind.copy()
    tiles.level[:] = levels
    walk(tiles, 10.0, 0.5, 0.5)
    begin(tiles, draws)
    counts = np.bincount(tiles.level, minlength=levels + 1)[1:]
    assert len(counts) == levels
    np.testing.assert_allclose(counts, 2000 / levels, atol=5 * np.sqrt(2000 / levels))
    np.testing.assert_array_equal(tiles.kind, kinds)


# --- distribution


def test_first_tiles_are_uniform_over_kinds_and_start_levels():
    tiles, _ = assignment(7000)
    counts = np.zeros((7, 11))
    np.add.at(counts, (tiles.kind, tiles.level), 1)
    assert not counts[:, 0].any()
    assert not counts[:, 6:].any()
    np.testing.assert_allclose(counts[:, 1:6], 200, atol=5 * np.sqrt(200))
    few, _ = assignment(500, levels=3)
    assert set(few.level) == {1, 2, 3}
    low, _ = assignment(500, start_levels=1)
    assert set(low.level) == {1}


def test_tiles_without_curriculum_are_uniform_and_independent_between_episodes():
    tiles, draws = assignment(3500, curriculum=False)
    first = tiles.kind.copy(), tiles.level.copy()
    walk(tiles, 10.0, 0.5, 0.5)
    begin(tiles, draws)
    for kind, level in (first, (tiles.kind, tiles.level)):
        counts = np.zeros((7, 11))
        np.add.at(counts, (kind, level), 1)
        np.testing.assert_allclose(counts[:, 1:], 50, atol=5 * np.sqrt(50))
    assert np.mean(tiles.kind == first[0]) == pytest.approx(1 / 7, abs=0.03)
    assert np.mean(tiles.level == first[1]) == pytest.approx(1 / 10, abs=0.03)


def test_kind_and_level_stay_as_long_as_nothing_counts():
    tiles, draws = assignment(200)
    kind, level = tiles.kind.copy(), tiles.level.copy()
    for _ in range(3):
        walk(tiles, 0.1, 0.5, 0.0)
        begin(tiles, draws)
    np.testing.assert_array_equal(tiles.kind, kind)
    np.testing.assert_array_equal(tiles.level, level)


def test_place_is_the_middle_of_the_tile_and_mean_levels_are_those_of_the_kinds():
    tiles, draws = assignment(300)
    place = begin(tiles, draws)
    np.testing.assert_array_equal(place, CENTRES[tiles.kind, tiles.level - 1])
    found = tiles.mean_levels()
    assert found.pop("mean_level") == pytest.approx(tiles.level.mean())
    assert list(found) == [f"level_{name}" for name in tiles.kinds]
    assert found["level_stairs"] == pytest.approx(tiles.level[tiles.kind == 4].mean())
    tiles.kind[:] = 2
    assert set(tiles.mean_levels()) == {"mean_level", "level_rough"}
