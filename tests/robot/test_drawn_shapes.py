"""The drawn robot against the one of physics: round feet, and the mark at the front."""

import io

import mujoco
import numpy as np
import pytest
import second_robot
import yourdfpy

from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import build_model

ROBOTS = pytest.mark.parametrize("robot", [MINI_QUADRUPED, second_robot.ROBOT], ids=lambda robot: robot.name)
VISUAL, COLLISION = 2, 3
"""Groups of geoms."""


def posed(robot, rng):
    """A model and its data with random joint angles, and a base that is tilted by up to half a radian."""
    model = build_model(robot=robot)
    data = mujoco.MjData(model)
    data.qpos[2] = 1.0
    quaternion = np.array([1.0, *rng.uniform(-0.15, 0.15, 3)])
    data.qpos[3:7] = quaternion / np.linalg.norm(quaternion)
    data.qpos[7:] = rng.uniform(robot.joint_position_low, robot.joint_position_high)
    mujoco.mj_kinematics(model, data)
    return model, data


def lowest_hit(model, data, group, x, y):
    """Height at which a ray from below meets the geoms of a group, by MuJoCo's own ray, m."""
    groups = np.zeros(6, np.uint8)
    groups[group] = 1
    geom = np.zeros(1, np.int32)
    start = np.array([x, y, 0.0])
    distance = mujoco.mj_ray(model, data, start, np.array([0.0, 0.0, 1.0]), groups, 0, -1, geom)
    return distance if distance >= 0.0 else np.nan


@ROBOTS
def test_a_ray_from_below_meets_the_drawn_foot_where_it_meets_the_one_of_physics(robot):
    rng = np.random.default_rng(0)
    checked = 0
    for _ in range(30):
        model, data = posed(robot, rng)
        for site in robot.foot_sites:
            x, y, z = data.site(site).xpos
            ball = z - robot.foot_radius
            if lowest_hit(model, data, COLLISION, x, y) != pytest.approx(ball, abs=1e-9):
                continue  # the knee or another part is below the foot
            assert lowest_hit(model, data, VISUAL, x, y) == pytest.approx(ball, abs=1e-9)
            x, y = x + 0.3 * robot.foot_radius, y - 0.4 * robot.foot_radius
            seen, felt = (lowest_hit(model, data, group, x, y) for group in (VISUAL, COLLISION))
            assert seen == pytest.approx(felt, abs=1e-9)
            checked += 1
    assert checked > 30


def lowest_point(shape, origin, pose):
    """Height of the lowest point of a URDF shape in a link at a pose (4, 4), by closed forms, m."""
    pose = pose @ (np.eye(4) if origin is None else origin)
    if shape.sphere is not None:
        return pose[2, 3] - shape.sphere.radius
    assert shape.cylinder is not None
    along = pose[2, 2]
    return pose[2, 3] - abs(along) * shape.cylinder.length / 2 - np.sqrt(1.0 - along**2) * shape.cylinder.radius


@ROBOTS
def test_the_lowest_drawn_point_of_the_urdf_is_that_of_the_ball(robot):
    urdf = yourdfpy.URDF.load(io.StringIO(robot.urdf), load_meshes=False, build_scene_graph=True)
    rng = np.random.default_rng(1)
    checked = 0
    for _ in range(30):
        urdf.update_cfg(rng.uniform(robot.joint_position_low, robot.joint_position_high))
        for name in robot.link_names:
            link = urdf.link_map[name]
            pose = urdf.get_transform(name, robot.link_names[0])
            if len(link.collisions) != 2 or pose[2, 2] < 0.0:  # not a leg, or the foot is above its knee
                continue
            ball = next(one for one in link.collisions if one.geometry.sphere is not None)
            physical = lowest_point(ball.geometry, ball.origin, pose)
            drawn = min(lowest_point(one.geometry, one.origin, pose) for one in link.visuals)
            assert drawn == pytest.approx(physical, abs=1e-12)
            checked += 1
    assert checked > 30


@ROBOTS
def test_the_mark_is_around_the_front_end_and_has_no_part_in_physics(robot):
    model = build_model(robot=robot)
    mark, base = model.geom("front_visual"), model.geom("base_visual")
    assert mark.bodyid == base.bodyid
    assert mark.contype == mark.conaffinity == 0
    low, high = mark.pos - mark.size, mark.pos + mark.size
    # It covers the front face and stands out there, above, below and at the sides.
    assert high[0] > base.size[0] > low[0] > 0.5 * base.size[0]
    assert (high[1:] > base.size[1:]).all()
    assert (low[1:] < -base.size[1:]).all()
    assert np.abs(np.concatenate([high, low[1:]]) - np.concatenate([base.size, -base.size[1:]])).max() < 0.002
    # In front of the base along x, which is forwards.
    colours = {tuple(model.mat_rgba[model.geom(name).matid].ravel()) for name in ("front_visual", "base_visual")}
    assert len(colours) == 2
