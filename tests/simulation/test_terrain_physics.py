"""Contacts on a height field against those on a plane, and closed forms on a slope."""

import dataclasses
import math

import mujoco
import numpy as np
import pytest
from built_in import FOOT_RADIUS, STANCE, STANCE_HEIGHT, TOTAL_MASS
from grounds import level_field, slope

from quadruped_env.envs.arguments import task_config
from quadruped_env.policies import GaitController, PolicyController, load_policy
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.simulation import model as model_module
from quadruped_env.simulation.built_in_terrains import hills
from quadruped_env.task import Task

ENV = np.zeros(1, dtype=np.intp)
_FRICTION = [0.8, 0.0, 0.0]


# --- contacts


def standing(model, seconds=1.5, yaw=0.4):
    """A simulation of a robot that has stood for a while, away from grid points."""
    simulation = SingleSimulation(model)
    qpos = np.array([0.027, 0.017, STANCE_HEIGHT, math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2), *STANCE])
    simulation.reset(ENV, qpos[None], np.zeros((1, 14)))
    simulation.step(STANCE[None], round(seconds / model.opt.timestep))
    return simulation


def test_robot_beyond_the_edge_of_the_field_stands_on_the_plane_around_it():
    simulation = SingleSimulation(build_model(terrain=hills))
    qpos = np.array([25.0, 3.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0, *STANCE])
    simulation.reset(ENV, qpos[None], np.zeros((1, 14)))
    simulation.step(STANCE[None], 400)
    assert touched(simulation) == {"surroundings"}
    height = simulation.readings.base_position[0, 2] - simulation.height_field.at(simulation.readings.base_position)[0]
    assert height == pytest.approx(STANCE_HEIGHT, abs=1e-3)


def test_walking_robot_leaves_the_field_without_falling():
    """Down the step at the edge."""
    small = dataclasses.replace(hills, size=3.0)
    controller = PolicyController(load_policy("flat"))
    task = Task(BatchSimulation(build_model(terrain=small), 6), controller.policy.config.randomized("none"))
    task.reset(np.arange(6), seeds=list(range(6)), command=(0.5, 0.0))
    observation, fallen = task.observe(), np.zeros(6, dtype=bool)
    for _ in range(350):
        transition = task.act(controller, observation)
        observation, fallen = transition.observation, fallen | transition.terminated
    outside = np.abs(task.simulation.readings.base_position[:, :2]).max(axis=1) > 1.75
    assert outside.all()
    assert not fallen.any()


def touched(simulation):
    """Names of the fixed geoms in contact with the robot."""
    model, data = simulation.model, simulation.data
    mujoco.mj_forward(model, data)
    return {model.geom(geom).name for contact in data.contact for geom in contact.geom if not model.geom_bodyid[geom]}


def test_robot_on_a_level_height_field_stands_as_on_the_plane():
    plane, field = standing(build_model()), standing(build_model(terrain=level_field))
    assert touched(field) == {"ground"}
    for simulation in (plane, field):
        assert simulation.readings.foot_force.sum() == pytest.approx(9.81 * TOTAL_MASS, rel=1e-3)
    np.testing.assert_allclose(field.readings.base_position, plane.readings.base_position, atol=2e-4)
    np.testing.assert_allclose(field.readings.orientation, plane.readings.orientation, atol=5e-4)


def turning_rate(model, controller, num_envs=16, seconds=5.0):
    """Mean yaw rate of a controller that turns on the spot at 0.5 rad/s, with random headings."""
    config = task_config(controller.action_mode, getattr(getattr(controller, "policy", None), "config", None))
    config = config.randomized("none")
    task = Task(BatchSimulation(model, num_envs), config)
    task.reset(np.arange(num_envs), seeds=list(range(num_envs)), command=(0.0, 0.5))
    observation, rates = task.observe(), []
    for _ in range(round(seconds / config.control_timestep)):
        observation = task.act(controller, observation).observation
        rates.append(task.simulation.readings.angular_velocity_b[:, 2].mean())
    return np.mean(rates[len(rates) // 4 :])


@pytest.mark.slow
@pytest.mark.parametrize("make_controller", [lambda: PolicyController(load_policy("flat")), GaitController])
def test_robot_on_a_level_height_field_turns_as_on_a_plane(make_controller):
    plane, field = build_model(), build_model(terrain=level_field)
    assert plane.opt.cone == field.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC
    controller = make_controller()
    assert turning_rate(field, controller) == pytest.approx(turning_rate(plane, controller), rel=0.05)


# --- closed forms on a slope


def body_on_slope(shape, *geoms):
    """A single body of geoms on a slope, without the robot: model and data."""
    spec = mujoco.MjSpec()
    spec.option.timestep, spec.option.impratio = 0.002, 100.0
    spec.option.cone = build_model().opt.cone
    spec.worldbody.add_geom(name="ground", type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 0.05], friction=_FRICTION)
    model_module.lay_ground(spec, shape.heights(), shape.extent)
    body = spec.worldbody.add_body()
    body.add_freejoint()
    for geom in geoms:
        body.add_geom(friction=_FRICTION, **geom)
    model = spec.compile()
    return model, mujoco.MjData(model)


def slid(angle, direction):
    """Distance that a sled of four balls slides on a slope in 1 s, m."""
    corners = [(x, y, 0.0) for x in (-0.1, 0.1) for y in (-0.1, 0.1)]
    balls = [{"type": mujoco.mjtGeom.mjGEOM_SPHERE, "size": [0.02, 0, 0], "pos": corner} for corner in corners]
    model, data = body_on_slope(slope.variant(angle=angle, direction=direction), *balls)
    uphill = np.array([math.cos(direction), math.sin(direction)])
    data.qpos[:3] = 0.0199 * normal_of(angle, direction)
    data.qpos[3:7] = tilted(angle, direction)
    start = data.qpos[:2].copy()
    mujoco.mj_step(model, data, 500)
    return (start - data.qpos[:2]) @ uphill / math.cos(angle)


@pytest.mark.parametrize("direction", [0.0, math.pi / 4, 1.0])
def test_friction_on_a_height_field_does_not_depend_on_the_direction(direction):
    """With MuJoCo's friction pyramid the sled slides along the diagonal where it should stand."""
    threshold = math.atan(_FRICTION[0])
    assert slid(threshold - 0.03, direction) == pytest.approx(0.0, abs=1e-3)
    angle = threshold + 0.03
    acceleration = 9.81 * (math.sin(angle) - _FRICTION[0] * math.cos(angle))
    assert slid(angle, direction) == pytest.approx(0.5 * acceleration, rel=0.1)


def normal_of(angle, direction):
    """Unit normal of a slope."""
    return np.array([-math.sin(angle) * math.cos(direction), -math.sin(angle) * math.sin(direction), math.cos(angle)])


def tilted(angle, direction):
    """Quaternion of a body that lies on a slope."""
    axis = np.array([math.sin(direction), -math.cos(direction), 0.0])
    return np.concatenate([[math.cos(angle / 2)], math.sin(angle / 2) * axis])


@pytest.mark.parametrize("direction", [0.0, math.pi, 2.0])
def test_robot_that_stands_on_a_slope_is_tilted_by_its_angle(direction):
    angle = 0.15
    simulation = SingleSimulation(build_model(terrain=slope.variant(angle=angle, direction=direction)))
    qpos = np.zeros(15)
    qpos[3:7], qpos[7:] = tilted(angle, direction), STANCE
    qpos[:3] = STANCE_HEIGHT * normal_of(angle, direction)
    simulation.reset(ENV, qpos[None], np.zeros((1, 14)))
    simulation.step(STANCE[None], 300)
    assert math.acos(simulation.readings.up_b[0, 2]) == pytest.approx(angle, abs=0.02)
    over_ground = simulation.readings.foot_position[0, :, 2] - simulation.height_field.at(
        simulation.readings.foot_position[0]
    )
    np.testing.assert_allclose(over_ground, FOOT_RADIUS / math.cos(angle), atol=5e-4)
    assert simulation.readings.foot_force.sum() == pytest.approx(9.81 * TOTAL_MASS * math.cos(angle), rel=0.02)
