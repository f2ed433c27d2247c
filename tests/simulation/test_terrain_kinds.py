"""Terrains with levels: heights at hand-computed points, angles and edges, and what is refused."""

import math
import re

import numpy as np
import pytest
from built_in import STANCE_HEIGHT
from grounds import ray_heights
from paths import ROOT
from second_robot import ROBOT

from quadruped_env import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import TERRAINS, build_model, find_terrain
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.simulation.terrain import LEVELS, Grid
from quadruped_env.task import TaskConfig, terrain

KINDS = ("flat", "slope", "rough", "steps", "stairs", "gaps", "wave")
LEVEL = 4
HEIGHT = 0.022
"""Height of level 4, m: 4 * 5.5 mm."""


def field_of(name, **values):
    return HeightField.of(build_model(terrain=find_terrain(name).variant(**values)))


# --- heights, at points that were computed by hand

WAVE = 0.25 * HEIGHT
HEIGHTS = {
    # The level square around the start ends at 0.4 m. A step's side is the 5 cm before its edge.
    "steps": [
        (0.0, 0.0, 0.0),
        (0.81, 0.0, 0.0),
        (-0.6, 0.2, HEIGHT),
    ],
    "stairs": [
        (0.34, 0.1, 0.0),
        (0.375, 0.0, 0.5 * HEIGHT),
        (0.41, 0.0, HEIGHT),
        (0.2, -0.9, 3 * HEIGHT),
        (1.1, 1.0, 2 * HEIGHT),
        (1.5, 0.0, 0.0),
        (1.7, 0.0, HEIGHT),
    ],
    "gaps": [
        (0.0, 0.0, 0.0),
        (0.675, 0.0, -0.5 * HEIGHT),
        (0.71, 0.0, -HEIGHT),
        (0.825, 0.0, -0.5 * HEIGHT),
        (-0.86, 0.0, 0.0),
    ],
    # Crests of height 2 * WAVE along x where y is 0, and of the full height where both are at half a wave.
    "wave": [(0.0, 0.0, 0.0), (2.0, 0.0, 2 * WAVE), (2.4, 0.0, 0.0), (2.0, 2.0, 4 * WAVE), (2.2, 0.0, WAVE)],
    "slope": [
        (0.4, 0.0, 0.0),
        (1.4, 0.0, math.tan(math.radians(8.0))),
        (0.0, 2.4, 2 * math.tan(math.radians(8.0))),
        (-3.4, 1.0, math.tan(math.radians(8.0))),
        (8.0, 0.0, 0.4 * math.tan(math.radians(8.0))),
        (10.0, 0.0, 0.0),
    ],
}


@pytest.mark.parametrize("name", HEIGHTS)
def test_heights_of_a_kind_at_points_computed_by_hand(name):
    field = field_of(name, level=LEVEL)
    for x, y, height in HEIGHTS[name]:
        assert field.at(np.array([x, y])) == pytest.approx(height, abs=1e-6), (x, y)


@pytest.mark.parametrize("name", KINDS)
def test_kind_is_level_around_the_start_and_repeats_with_its_seed(name):
    shape = find_terrain(name).variant(3, level=LEVELS)
    np.testing.assert_array_equal(shape.heights(), shape.variant(3, level=LEVELS).heights())
    if name == "flat":
        assert not shape.heights().any()
        return
    field = HeightField.of(build_model(terrain=shape))
    # `fade` begins at a circle, into which the corners of the footprint reach.
    assert abs(float(field.highest(np.zeros(2), MINI_QUADRUPED.footprint))) < 5e-4
    around = np.random.default_rng(0).uniform(-0.2, 0.2, (200, 2))
    np.testing.assert_allclose(field.at(around), 0.0, atol=1e-6)


@pytest.mark.parametrize("name", [name for name in KINDS if name != "flat"])
def test_lookup_of_a_kind_equals_mujocos_rays(name):
    model = build_model(terrain=find_terrain(name).variant(1, level=7))
    points = np.random.default_rng(0).uniform(-12.5, 12.5, (1000, 2))
    np.testing.assert_allclose(HeightField.of(model).at(points), ray_heights(model, points), atol=1e-12)


@pytest.mark.parametrize("name", ["rough", "steps", "stairs", "gaps", "wave"])
def test_highest_and_lowest_point_follow_from_the_level(name):
    for level in (1, 5, 10):
        heights = find_terrain(name).variant(level=level).heights()
        height = 0.0055 * level
        if name == "stairs":
            assert (heights.min(), heights.max()) == pytest.approx((0.0, 3 * height))
        elif name == "gaps":
            assert (heights.min(), heights.max()) == pytest.approx((-height, 0.0))
        else:
            assert heights.min() == pytest.approx(0.0, abs=1e-4 * height)
            assert 0.97 * height < heights.max() <= height * (1 + 1e-12)


# --- levels


def test_tallest_level_is_30_percent_of_the_leg_length():
    assert find_terrain("stairs").defaults(LEVELS)["height"] == pytest.approx(0.3 * STANCE_HEIGHT, abs=5e-4)
    scale = scale_of("m", ROBOT)
    assert scale == pytest.approx(ROBOT.stance_height / STANCE_HEIGHT, rel=1e-5) != 1.0
    assert find_terrain("stairs").defaults(LEVELS, scale)["height"] == pytest.approx(0.055 * scale)
    assert find_terrain("slope").defaults(LEVELS, scale)["angle"] == pytest.approx(math.radians(20.0))
    tall = find_terrain("steps").variant(level=LEVELS, scale=scale).heights()
    assert tall.max() == pytest.approx(0.055 * scale)
    config = TaskConfig().for_robot(ROBOT).on_terrain(find_terrain("steps").variant(level=5))
    assert config.terrain.height == pytest.approx(0.0275 * scale)
    assert config.ground.heights().max() == pytest.approx(0.0275 * scale)
    tiles = TaskConfig().for_robot(ROBOT).on_terrain("tiles").ground
    assert tiles.tile(3, LEVELS).max() == pytest.approx(0.055 * scale)


def test_levels_of_the_page_are_those_of_the_terrains():
    text = (ROOT / "docs" / "environment.md").read_text()
    ((millimetres, degrees),) = re.findall(r"each level adds ([\d.]+) mm to .* and (\d+)\s+degrees to", text, re.DOTALL)
    for level in range(1, LEVELS + 1):
        for name, field in (*((name, "height") for name in ("rough", "steps", "stairs", "wave")), ("gaps", "depth")):
            assert find_terrain(name).defaults(level)[field] == pytest.approx(1e-3 * level * float(millimetres))
        assert find_terrain("slope").defaults(level)["angle"] == pytest.approx(math.radians(level * float(degrees)))
    table = re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE)
    assert {shape.name for shape in TERRAINS} <= set(table)


def test_level_gives_the_defaults_and_a_parameter_replaces_one():
    stairs = find_terrain("stairs")
    assert stairs.variant(level=4) == stairs.variant(level=4, height=0.022)
    assert stairs.variant(level=4) != stairs.variant(height=0.022), "the level is part of it"
    np.testing.assert_array_equal(stairs.variant(level=4).heights(), stairs.variant(height=0.022).heights())
    steep = stairs.variant(level=4, height=0.05)
    assert steep.heights().max() == pytest.approx(0.15)
    assert steep.variant(level=4) == stairs.variant(level=4)


@pytest.mark.parametrize("level", [0, 11, 2.5, "4", True])
def test_invalid_level_is_refused_with_the_valid_ones(level):
    with pytest.raises(QuadrupedError, match="terrain stairs: level must be a whole number from 1 to 10; found"):
        find_terrain("stairs").variant(level=level)


def test_level_of_a_terrain_without_levels_is_refused():
    with pytest.raises(QuadrupedError, match="terrain hills: found level 3, but it has no levels; leave it out"):
        find_terrain("hills").variant(level=3)


def test_users_terrain_has_levels_if_it_says_what_the_hardest_is():
    @terrain(cell=0.05, size=10.0, hardest={"height": 0.1})
    def ridges(grid: Grid, height: float = 0.02, width: float = 0.3):
        """Ridges."""
        return height * (grid.x // width % 2) * grid.fade

    assert ridges.defaults(5) == {"height": 0.05, "width": 0.3}
    assert ridges.variant(level=5).heights().max() == pytest.approx(0.05)
    with pytest.raises(QuadrupedError, match=r"hardest must be valid values of its parameters; found {'depth': 0.1}"):

        @terrain(hardest={"depth": 0.1})
        def wrong(grid: Grid, height: float = 0.02):
            """A parameter that does not exist."""
            return grid.x

    with pytest.raises(QuadrupedError, match="'level' is a field of every terrain"):
        terrain(lambda grid, level=1: grid.x)
