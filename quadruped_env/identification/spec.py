"""Model of the robot for an identification."""

import mujoco

from quadruped_env.robot import Robot
from quadruped_env.simulation.model import scene


def joint_spec(robot: Robot, base: str, timestep: float) -> mujoco.MjSpec:
    """A robot with its joint sensors only, on a stand (`fixed`) or on the ground (`free`)."""
    spec = scene(robot)
    spec.option.timestep = timestep
    wanted = {
        sensor for field in ("joint_position", "joint_velocity", "joint_torque") for sensor in robot.sensors[field]
    }
    for sensor in list(spec.sensors):
        if sensor.name not in wanted:
            spec.delete(sensor)
    # A fit compiles thousands of models, and the textures' pixels would take nine tenths of that.
    for geom in spec.geoms:
        geom.material = ""
    for looks in [*spec.materials, *spec.textures]:
        spec.delete(looks)
    if base == "fixed":
        for key in list(spec.keys):
            spec.delete(key)
        spec.delete(spec.joint("floating_base"))
        # In the air there are no contacts, and with contacts disabled the motion is a smooth function of the motors.
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return spec
