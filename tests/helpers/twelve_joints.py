"""A robot with three joints per leg: roll, pitch, pitch. Its numbers are similar to the A1's."""

import math

import mujoco
import numpy as np

from quadruped_env.robot import JointMotor, MotorConfig, Robot

LEGS = ("RF", "LF", "RH", "LH")
"""Not in the order of the corners."""
JOINTS = tuple(f"{leg}_{part}" for leg in LEGS for part in ("roll", "thigh", "shank"))
LINK, RADIUS, BEND = 0.2, 0.02, 0.85
"""Length of thigh and shank, radius of the feet, m; angle between thigh and vertical in the stance, rad."""
KP = 6.0 * 12.2 * 9.81 * 2.0 * LINK * math.cos(BEND)
"""About 6 m g L, N m/rad."""


def spec() -> mujoco.MjSpec:
    """All axes are along x and y, so a leg's roll is the other way than its counterpart's under the mirror."""
    made = mujoco.MjSpec()
    made.compiler.degree = False
    made.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    box, capsule, ball = mujoco.mjtGeom.mjGEOM_BOX, mujoco.mjtGeom.mjGEOM_CAPSULE, mujoco.mjtGeom.mjGEOM_SPHERE
    base = made.worldbody.add_body(name="trunk")
    base.add_freejoint(name="free")
    base.add_geom(type=box, size=[0.14, 0.07, 0.05], mass=6.0)
    for leg in LEGS:
        x, y = (1 if leg[1] == "F" else -1), (1 if leg[0] == "L" else -1)
        hip = base.add_body(name=f"{leg}_hip", pos=[0.18 * x, 0.05 * y, 0.0])
        hip.add_geom(type=ball, size=[0.03, 0, 0], mass=0.6, contype=0, conaffinity=0)
        thigh = hip.add_body(name=f"{leg}_upper", pos=[0.0, 0.08 * y, 0.0])
        thigh.add_geom(type=capsule, size=[0.02, 0, 0], fromto=[0, 0, -0.02, 0, 0, -0.15], mass=0.8)
        shank = thigh.add_body(name=f"{leg}_lower", pos=[0.0, 0.0, -LINK])
        shank.add_geom(type=capsule, size=[RADIUS, 0, 0], fromto=[0, 0, -0.03, 0, 0, -LINK], mass=0.15)
        shank.add_site(name=f"{leg}_foot", pos=[0.0, 0.0, -LINK])
        limits = ([-0.8, 0.8], [-1.0, 3.0], [-2.7, -0.9])
        axes = ([1, 0, 0], [0, 1, 0], [0, 1, 0])
        for joint, body, axis, limit in zip(("roll", "thigh", "shank"), (hip, thigh, shank), axes, limits, strict=True):
            body.add_joint(name=f"{leg}_{joint}", axis=axis, range=limit)
    return made


def robot() -> Robot:
    """The robot of which only what the model does not say is given."""
    made = spec()
    made.compile()
    motor = JointMotor(stall_torque=33.5, no_load_speed=21.0, kp=KP, kd=KP / 40.0, damping=0.05, armature=0.01)
    stance = np.tile([0.0, BEND, -2.0 * BEND], 4)
    return Robot(name="twelve", mjcf=made.to_xml(), stance=stance, motors=MotorConfig(motor, motor))


ROBOT = robot()
