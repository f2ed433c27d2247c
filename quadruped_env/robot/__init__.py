"""The robot: names and order, limits, assets, kinematics."""

from quadruped_env.robot.assets import asset_path
from quadruped_env.robot.facts import (
    EFFORT_LIMIT,
    FOOT_RADIUS,
    JOINT_NAMES,
    JOINT_POSITION_HIGH,
    JOINT_POSITION_LOW,
    LEG_NAMES,
    LINK_NAMES,
    STANCE,
    STANCE_HEIGHT,
    TOTAL_MASS,
    VELOCITY_LIMIT,
)
from quadruped_env.robot.ground import resting_pose, sole_heights
from quadruped_env.robot.kinematics import forward_kinematics
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.motors import JOINT_KINDS, JointMotor, MotorConfig
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.transforms import Transform, fixed_transforms, joint_transforms

__all__ = [
    "EFFORT_LIMIT",
    "FOOT_RADIUS",
    "JOINT_KINDS",
    "JOINT_NAMES",
    "JOINT_POSITION_HIGH",
    "JOINT_POSITION_LOW",
    "LEG_NAMES",
    "LINK_NAMES",
    "MINI_QUADRUPED",
    "STANCE",
    "STANCE_HEIGHT",
    "TOTAL_MASS",
    "VELOCITY_LIMIT",
    "JointMotor",
    "MotorConfig",
    "Robot",
    "Transform",
    "asset_path",
    "fixed_transforms",
    "forward_kinematics",
    "joint_transforms",
    "resting_pose",
    "sole_heights",
]
