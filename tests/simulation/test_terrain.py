"""Terrains: their heights, their lookup against MuJoCo's rays, and what is refused."""

import dataclasses

import mujoco
import numpy as np
import pytest
from grounds import ray_heights, slope
from second_robot import ROBOT

from quadruped_env import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import SingleSimulation, build_model, highest_ground
from quadruped_env.simulation.built_in_terrains import hills, rough
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.simulation.terrain import MAX_POINTS
from quadruped_env.task import terrain


@pytest.mark.parametrize("shape", [rough, hills], ids=lambda one: one.name)
def test_built_in_terrain_repeats_with_its_seed_and_is_level_at_start_and_edge(shape):
    heights = shape.variant(3).heights()
    np.testing.assert_array_equal(heights, shape.variant(3).heights())
    assert not np.array_equal(heights, shape.variant(4).heights())
    middle = len(heights) // 2
    assert not heights[middle - 2 : middle + 3, middle - 2 : middle + 3].any()
    assert not np.concatenate([heights[[0, -1]].ravel(), heights[:, [0, -1]].ravel()]).any()
    top = shape.parameters["height"][1]
    assert 0.8 * top < heights.max() <= top
    assert heights.min() >= 0.0
    np.testing.assert_allclose(shape.variant(3, height=2.0 * top).heights(), 2.0 * heights)


@pytest.mark.parametrize(
    "shape", [rough, hills.variant(5), slope.variant(angle=0.3, direction=1.0)], ids=lambda shape: shape.name
)
def test_height_field_lookup_equals_mujocos_rays_inside_and_outside(shape):
    model = build_model(terrain=shape)
    field = HeightField.of(model)
    points = np.random.default_rng(0).uniform(-0.52 * shape.size, 0.52 * shape.size, (400, 2))
    np.testing.assert_allclose(field.at(points), ray_heights(model, points), atol=1e-12)
    outside = np.abs(points).max(axis=1) > 0.5 * shape.size
    assert 10 < outside.sum() < 100
    np.testing.assert_allclose(field.at(points[outside]), shape.heights().min() - 0.01, atol=1e-9)


def test_height_field_lookup_of_a_point_does_not_depend_on_the_others():
    field = HeightField.of(build_model(terrain=rough))
    points = np.random.default_rng(1).uniform(-21.0, 21.0, (100, 4, 3))
    together, highest = field.at(points), field.highest(points, 0.25)
    for i, j in np.ndindex(100, 4):
        assert field.at(points[i, j]) == together[i, j]
        assert field.highest(points[i : i + 1, j], 0.25)[0] == highest[i, j]
    assert np.isfinite(field.at(np.full((2, 3), np.nan))).all()


def test_highest_ground_bounds_the_ground_around_a_point():
    field = HeightField.of(build_model(terrain=hills))
    rng = np.random.default_rng(2)
    for point in rng.uniform(-15.0, 15.0, (10, 2)):
        around = point + rng.uniform(-0.25, 0.25, (500, 2))
        nearby = point + rng.uniform(-0.45, 0.45, (5000, 2))
        assert field.at(around).max() <= field.highest(point, 0.25) <= field.at(nearby).max() + 0.003


def test_grid_points_cover_the_surroundings_of_positions():
    field = HeightField.of(build_model(terrain=rough))
    whole = field.points()
    assert whole.shape == (401, 401, 3)
    np.testing.assert_allclose(whole[..., 2], field.at(whole), atol=1e-9)
    part = field.points(np.array([[1.02, -3.01], [1.31, -2.07]]), margin=0.5)
    np.testing.assert_array_equal(part, whole[164:186, 205:220])
    np.testing.assert_allclose([part[0, 0, :2], part[-1, -1, :2]], [[0.5, -3.6], [1.9, -1.5]], atol=1e-9)
    at_the_edge = field.points(np.array([[19.93, 25.0]]), margin=0.5)
    np.testing.assert_array_equal(at_the_edge, whole[399:, 394:])


def test_highest_ground_below_a_robot_covers_its_own_footprint():
    terrain = slope.variant(angle=0.3)
    for robot in (MINI_QUADRUPED, ROBOT):
        simulation = SingleSimulation(build_model(terrain=terrain, robot=robot), robot)
        places = np.array([[0.3, 0.2], [-1.0, 0.5]])
        over = highest_ground(simulation, places) - simulation.height_field.at(places)
        assert (over >= np.tan(0.3) * robot.footprint - 1e-9).all()
        assert (over <= np.tan(0.3) * (robot.footprint + 2.0 * terrain.cell)).all()
        level = SingleSimulation(build_model(robot=robot), robot)
        np.testing.assert_array_equal(highest_ground(level, places), np.zeros(2))


def test_flat_model_is_a_plane_without_height_field():
    model = build_model()
    assert HeightField.of(model) is None
    assert model.nhfield == 0
    assert model.geom("ground").type == mujoco.mjtGeom.mjGEOM_PLANE
    assert model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC


REFUSED = {
    "shape": (lambda grid: grid.x[0], r"terrain shape: expected finite heights of shape \(401, 401\).*\(401,\)"),
    "infinite": (lambda grid: grid.x / 0.0, r"terrain infinite: expected finite heights.*found a height that is not"),
    "failure": (lambda grid: grid.z, r"terrain failure: AttributeError: .*'z'"),
}


@pytest.mark.parametrize(("function", "message"), REFUSED.values(), ids=REFUSED)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_terrain_with_invalid_heights_is_refused_with_its_name(function, message, request):
    function.__name__ = function.__qualname__ = request.node.callspec.id
    with pytest.raises(QuadrupedError, match=message):
        build_model(terrain=terrain(function))


def test_terrain_with_an_invalid_size_or_parameter_is_refused():
    with pytest.raises(QuadrupedError, match=rf"1 to {MAX_POINTS - 1} cells per side; found \(40.0, 0.001\)"):
        dataclasses.replace(rough, cell=0.001)
    with pytest.raises(
        QuadrupedError, match=r"terrain rough: unknown field 'depth'; valid fields are height, distance"
    ):
        rough.variant(depth=1.0)
    with pytest.raises(QuadrupedError, match=r"terrain rough: distance must be at least 0.2 \(m\); found 0.0"):
        rough.variant(distance=0.0)
    with pytest.raises(QuadrupedError, match="'seed' is a field of every terrain"):
        terrain(lambda grid, seed=1: grid.x)
