"""The terrain of tiles: its layout, its borders, and a robot on each tile."""

import math

import mujoco
import numpy as np
import pytest
from built_in import FOOT_RADIUS, STANCE, STANCE_HEIGHT
from grounds import ray_heights

from quadruped_env import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation, build_model, find_terrain, highest_ground
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.task import terrain

TILES = find_terrain("tiles")
MODEL = build_model(terrain=TILES)
FIELD = HeightField.of(MODEL)
NAMES = [kind.name for kind in TILES.kinds]
CENTRES = TILES.centres()


def centre(name, level):
    return CENTRES[NAMES.index(name), level - 1]


def test_tiles_are_4_m_apart_with_levels_along_x_and_kinds_along_y():
    assert NAMES == ["flat", "slope", "rough", "steps", "stairs", "gaps", "wave"]
    assert CENTRES.shape == (7, 10, 2)
    np.testing.assert_allclose(CENTRES[0, 0], [-18.0, -12.0])
    np.testing.assert_allclose(np.diff(CENTRES, axis=1), np.broadcast_to([4.0, 0.0], (7, 9, 2)))
    np.testing.assert_allclose(np.diff(CENTRES, axis=0), np.broadcast_to([0.0, 4.0], (6, 10, 2)))
    assert TILES.extent == (42.0, 30.0)
    assert TILES.heights().shape == (601, 841)


@pytest.mark.parametrize("level", [1, 4, 10])
def test_heights_of_tiles_at_points_computed_by_hand(level):
    height, slope = 0.0055 * level, math.tan(math.radians(2.0 * level))
    for name, offset, expected in [
        ("flat", (1.0, 0.7), 0.0),
        # In a tile the first steps and slopes lead down.
        ("stairs", (0.5, 0.0), -height),
        ("stairs", (0.0, -0.7), -2 * height),
        ("stairs", (-0.9, 0.2), -3 * height),
        ("stairs", (0.3, 1.1), -2 * height),
        ("stairs", (1.3, -1.0), -height),
        ("stairs", (1.5, 0.0), 0.0),
        ("steps", (0.5, 0.0), height),
        ("steps", (0.6, 0.6), 0.0),
        ("steps", (-1.3, 0.1), height),
        ("gaps", (0.75, 0.0), -height),
        ("gaps", (1.2, 0.3), -height),
        ("gaps", (0.0, 1.65), -height),
        ("gaps", (1.0, 0.0), 0.0),
        ("slope", (0.7, 0.0), -0.3 * slope),
        ("slope", (0.2, 1.05), -0.65 * slope),
        ("slope", (-1.5, 0.0), -0.2 * slope),
        ("slope", (1.7, 0.0), 0.0),
        ("wave", (1.2, 0.0), 0.5 * height),
        ("wave", (1.2, 1.2), height),
        ("wave", (0.8, 0.8), 0.0),
    ]:
        found = FIELD.at(centre(name, level) + offset)
        assert found == pytest.approx(expected, abs=1e-6), (name, offset)


def test_every_tile_is_its_kind_at_its_level_and_no_two_tiles_are_equal():
    seen = {}
    for kind, name in enumerate(NAMES):
        for level in range(1, 11):
            heights = TILES.tile(kind, level)
            seen[heights.tobytes()] = name, level
            bumps = np.abs(heights).max()
            expected = {"flat": 0.0, "slope": 0.65 * math.tan(math.radians(2.0 * level)), "stairs": 0.0165 * level}
            assert bumps <= expected.get(name, 0.0055 * level) * (1 + 1e-9)
            assert bumps >= 0.85 * expected.get(name, 0.0055 * level)
    assert len(seen) == 61, "the ten flat ones are equal"


def test_tiles_are_level_along_their_borders_and_around_their_middles():
    along = np.linspace(-2.0, 2.0, 81)
    border = np.concatenate([[(x, y), (y, x)] for x in along for y in (-2.0, -1.8, 1.8, 2.0)])
    for middle in CENTRES.reshape(-1, 2):
        np.testing.assert_allclose(FIELD.at(middle + border), 0.0, atol=1e-7)
        # Less than the clearance of a start, 1 cm. The corners of the footprint reach into the beginning of `fade`.
        assert abs(float(FIELD.highest(middle, MINI_QUADRUPED.footprint))) < 1e-3


def test_ground_around_the_tiles_goes_down_to_the_plane():
    lowest = TILES.heights().min()
    assert lowest == pytest.approx(-0.65 * math.tan(math.radians(20.0)))
    for outwards, edge in (((1.0, 0.0), 20.0), ((0.0, -1.0), 14.0), ((-1.0, 0.0), 20.0)):
        along = np.linspace(edge - 0.2, edge + 0.99, 100)[:, None] * outwards
        heights = FIELD.at(along)
        assert heights[0] == pytest.approx(0.0, abs=1e-7)
        assert heights[-1] == pytest.approx(lowest, abs=2e-3)
        assert (np.diff(heights) < 1e-9).all()
    assert FIELD.at(np.array([21.1, 0.0])) == pytest.approx(lowest - 0.01, abs=1e-6)


def test_lookup_on_tiles_equals_mujocos_rays():
    points = np.random.default_rng(0).uniform([-21.5, -15.5], [21.5, 15.5], (3000, 2))
    np.testing.assert_allclose(FIELD.at(points), ray_heights(MODEL, points), atol=1e-12)


def test_robot_placed_on_each_tile_stands_without_penetration():
    places = CENTRES.reshape(-1, 2)
    simulation = BatchSimulation(MODEL, len(places))
    qpos = np.tile([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, *STANCE], (len(places), 1))
    yaw = np.random.default_rng(0).uniform(-math.pi, math.pi, len(places))
    qpos[:, 3], qpos[:, 6] = np.cos(0.5 * yaw), np.sin(0.5 * yaw)
    qpos[:, :2] = places
    qpos[:, 2] = STANCE_HEIGHT + 1e-4 + highest_ground(simulation, places)
    simulation.reset(np.arange(len(places)), qpos, np.zeros((len(places), 14)))
    assert all(simulation.copy_data(env_id).ncon == 0 for env_id in range(len(places)))
    simulation.step(np.tile(STANCE, (len(places), 1)), 200)
    readings = simulation.readings
    assert (readings.up_b[:, 2] > 0.9999).all()
    np.testing.assert_allclose(readings.base_position[:, 2], STANCE_HEIGHT, atol=3e-3)
    np.testing.assert_allclose(readings.base_position[:, :2], places, atol=0.01)
    feet = readings.foot_position
    np.testing.assert_allclose(feet[..., 2] - FOOT_RADIUS - FIELD.at(feet), 0.0, atol=5e-3)
    for env_id in range(len(places)):
        data = simulation.copy_data(env_id)
        mujoco.mj_forward(MODEL, data)
        touching = {MODEL.geom(int(geom)).name for contact in data.contact for geom in contact.geom}
        assert touching == {"ground", *(f"{leg}_leg_collision" for leg in MINI_QUADRUPED.leg_names)}


def test_seed_kinds_levels_and_scale_change_the_tiles():
    rough = [find_terrain("rough")]
    few = TILES.of([find_terrain("stairs").variant(scale=2.0), *rough, *rough], 3, seed=2, scale=2.0)
    assert few.centres().shape == (3, 3, 2)
    assert (few.tile_size, few.extent) == (8.0, (28.0, 28.0))
    assert few.tile(0, 3).min() == pytest.approx(-3 * 0.0165 * 2.0)
    assert not np.array_equal(few.tile(1, 2), few.tile(2, 2)), "each tile has random numbers of its own"
    assert not np.array_equal(few.tile(1, 2), TILES.of(rough, 3, seed=3).tile(0, 2))
    assert few == TILES.of([find_terrain("stairs").variant(scale=2.0), *rough, *rough], 3, seed=2, scale=2.0)
    assert len({few, TILES, TILES.of(TILES.kinds, 10)}) == 2


def test_kind_without_levels_or_with_an_uneven_edge_is_refused():
    with pytest.raises(QuadrupedError, match="terrain tiles: the kind hills has no levels"):
        TILES.of([find_terrain("hills")], 3)
    with pytest.raises(QuadrupedError, match="terrain tiles: found level 3, but it has no levels"):
        TILES.variant(level=3)

    @terrain(hardest={"height": 0.1})
    def ramp(grid, height: float = 0.1):
        """Not level at its edge."""
        return height * grid.x

    with pytest.raises(
        QuadrupedError, match=r"terrain ramp: as a tile its edge must be at height 0.*up to 0.02 m.*fade"
    ):
        TILES.of([ramp], 2).heights()
