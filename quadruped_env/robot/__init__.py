"""Robots as values: names, limits, models, kinematics; the built-in robot, and a builder for others like it."""

from quadruped_env.robot.assets import asset_path
from quadruped_env.robot.mini_quadruped import JOINT_NAMES, LEG_NAMES, MINI_QUADRUPED, forward_kinematics
from quadruped_env.robot.motors import JOINT_KINDS, MOTOR_PRESETS, JointMotor, MotorConfig
from quadruped_env.robot.quadruped_design import QuadrupedDesign
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.skeleton import Transform

__all__ = [
    "JOINT_KINDS",
    "JOINT_NAMES",
    "LEG_NAMES",
    "MINI_QUADRUPED",
    "MOTOR_PRESETS",
    "JointMotor",
    "MotorConfig",
    "QuadrupedDesign",
    "Robot",
    "Transform",
    "asset_path",
    "forward_kinematics",
]
