"""The one place that compiles MuJoCo's model: the robot with its motors, on its ground."""

import copy
import functools
from typing import Final

import mujoco

from quadruped_env.robot.assets import asset_path
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.motors import MotorConfig
from quadruped_env.robot.robot import Robot

_SCENE: Final = "scene.xml"
_ROBOT: Final = "mini_quadruped.xml"
"""File that the scene includes: the robot's MJCF takes its place."""


def build_model(
    timestep: float | None = None, motors: MotorConfig | None = None, robot: Robot = MINI_QUADRUPED
) -> mujoco.MjModel:
    """Compiled model of a robot on flat ground; every call returns a new copy.

    Args:
        timestep: physics time step, s. None: that of the robot's model.
        motors: motors that replace the robot's own.
        robot: the robot.

    Raises:
        QuadrupedError: if the robot's model does not hold the robot that it describes.
    """
    path = asset_path(_SCENE)
    # Compiling takes thirty times as long as copying, so every process compiles each variant once.
    return copy.copy(_compiled(timestep, motors, robot, path.stat().st_mtime_ns))


@functools.lru_cache(maxsize=8)
def _compiled(timestep: float | None, motors: MotorConfig | None, robot: Robot, _modified: int) -> mujoco.MjModel:
    spec = scene(robot)
    if timestep is not None:
        spec.option.timestep = timestep
    if motors is not None and motors != robot.motors:
        motors.write(spec)
    model = spec.compile()
    robot.check_model(model)
    return model


def scene(robot: Robot) -> mujoco.MjSpec:
    """A robot on a plane, with light and camera."""
    try:
        return mujoco.MjSpec.from_string(asset_path(_SCENE).read_text(), include={_ROBOT: robot.mjcf.encode()})
    except ValueError:
        robot.spec()  # whose error names the robot
        raise
