"""Model of the robot for an identification."""

import mujoco

from quadruped_env.robot import JOINT_NAMES, asset_path


def joint_spec(base: str, timestep: float) -> mujoco.MjSpec:
    """The robot with its joint sensors only, on a stand (`fixed`) or on the ground (`free`)."""
    spec = mujoco.MjSpec.from_file(str(asset_path("scene.xml")))
    spec.option.timestep = timestep
    wanted = {
        name.removesuffix("joint") + signal for name in JOINT_NAMES for signal in ("position", "velocity", "torque")
    }
    for sensor in list(spec.sensors):
        if sensor.name not in wanted:
            spec.delete(sensor)
    if base == "fixed":
        for key in list(spec.keys):
            spec.delete(key)
        spec.delete(spec.joint("floating_base"))
        # In the air there are no contacts, and with contacts disabled the motion is a smooth function of the motors.
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return spec
