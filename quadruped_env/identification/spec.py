"""The robot as an identification sees it."""

import mujoco

from quadruped_env.robot import JOINT_NAMES, asset_path


def joint_spec(base: str, timestep: float) -> mujoco.MjSpec:
    """The robot with no sensors but those of its joints, on a stand (`fixed`) or on its ground (`free`)."""
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
        # In the air there is nothing to touch, and without contacts the motion is a smooth function of the motors.
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return spec
