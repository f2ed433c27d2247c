"""The one place that compiles MuJoCo's model: the robot with its motors, on its terrain."""

import copy
import functools
from typing import Final

import mujoco
import numpy as np

from quadruped_env.robot.assets import asset_path
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.motors import MotorConfig
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation.built_in_terrains import flat
from quadruped_env.simulation.height_field import GROUND, SURROUNDINGS
from quadruped_env.simulation.terrain import Terrain
from quadruped_env.utils.arrays import Floats

_SCENE: Final = "scene.xml"
_DROP: Final = 0.01
"""Height of a height field's lowest point over the plane around it, m.

At the same height a foot would touch both; a foot of a walking robot sinks in by up to 5 mm. A step of 2 cm holds one
robot in three at the edge.
"""
_THICKNESS: Final = 0.1
"""Thickness of a height field below its lowest point, m."""

_TOLERANCE: Final = 1e-3
"""Tolerance of the solver on a height field.

Compared with MuJoCo's default of 1e-8 it saves a third of the solver's steps and changes the forces on the base of a
walking robot by 0.3 % (root mean square).
"""

_LIGHT: Final = (0.8, 0.3, -0.4)
"""Direction of the light on uneven ground."""


def build_model(
    timestep: float | None = None,
    motors: MotorConfig | None = None,
    terrain: Terrain = flat,
    robot: Robot = MINI_QUADRUPED,
    max_delay: float = 0.0,
) -> mujoco.MjModel:
    """Compiled model of a robot on its terrain; every call returns a new copy.

    The ground is the geom `ground`: a plane at height 0, or a height field with a plane around it, `surroundings`.

    Args:
        timestep: physics time step, s. None: the robot model's.
        motors: motors that replace the robot's own.
        terrain: the ground; by default a plane.
        robot: the robot.
        max_delay: longest delay of the motors that `actuator_delay` may be set to later, s.

    Raises:
        QuadrupedError: if the terrain's heights are not valid, or the robot's model does not hold the robot that it
            describes.
    """
    _write_no_log_file()
    path = asset_path(_SCENE)
    # Compiling takes thirty times as long as copying, so every process compiles each variant once.
    return copy.copy(_compiled(timestep, motors, terrain, robot, max_delay, path.stat().st_mtime_ns))


def _write_no_log_file() -> None:
    """Let MuJoCo print its warnings, and write no MUJOCO_LOG.TXT into the working directory."""
    config = mujoco.MjLogConfig.get()
    if config.logto_file and config.logfile == "MUJOCO_LOG.TXT":  # not a file that the process has chosen
        config.logto_file = False
        config.set()


@functools.lru_cache(maxsize=8)
def _compiled(
    timestep: float | None, motors: MotorConfig | None, terrain: Terrain, robot: Robot, max_delay: float, _modified: int
) -> mujoco.MjModel:
    _ = robot.model  # whose errors name the robot
    return build_spec(timestep, motors, terrain, robot, max_delay).compile()


def build_spec(
    timestep: float | None, motors: MotorConfig | None, terrain: Terrain, robot: Robot, max_delay: float = 0.0
) -> mujoco.MjSpec:
    """Specification of the model that `build_model` compiles; see there."""
    spec = scene(robot)
    if timestep is not None:
        spec.option.timestep = timestep
    if motors is not None and motors != robot.motors:
        motors.write(spec, robot.joint_kinds)
    motors = motors or robot.motors
    motors.write_delay(spec, max(max_delay, motors.delay))
    heights = terrain.heights()
    if heights.any():
        lay_ground(spec, heights, terrain.extent)
    return spec


def scene(robot: Robot) -> mujoco.MjSpec:
    """A robot on a plane, with light and camera."""
    return robot.spec(asset_path(_SCENE).read_text(encoding="utf-8"))


def lay_ground(spec: mujoco.MjSpec, heights: Floats, extent: tuple[float, float]) -> None:
    """Replace the plane by a height field of an extent along x and y, m, and put a plane around it."""
    lowest, span = float(heights.min()), float(np.ptp(heights))
    rows, columns = heights.shape
    spec.add_hfield(
        name=GROUND,
        nrow=rows,
        ncol=columns,
        # MuJoCo refuses a span of 0, as of ground that is level at another height.
        size=[0.5 * extent[0], 0.5 * extent[1], span or 1.0, _THICKNESS],
        userdata=((heights - lowest) / (span or 1.0)).ravel().tolist(),
    )
    ground = spec.geom(GROUND)
    spec.worldbody.add_geom(
        name=SURROUNDINGS,
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        pos=[0.0, 0.0, lowest - _DROP],
        size=ground.size,
        material=ground.material,
        contype=ground.contype,
        conaffinity=ground.conaffinity,
        condim=ground.condim,
        friction=ground.friction,
        solref=ground.solref,
    )
    ground.type = mujoco.mjtGeom.mjGEOM_HFIELD
    ground.hfieldname = GROUND
    ground.pos = [0.0, 0.0, lowest]
    spec.option.tolerance = _TOLERANCE
    for light in spec.lights:
        # From the side, so that slopes differ in brightness. A height field's shadow map is slow, and leaves specks.
        light.dir, light.diffuse, light.castshadow = _LIGHT, [0.9] * 3, False
    spec.visual.headlight.diffuse, spec.visual.headlight.ambient = [0.3] * 3, [0.4] * 3
