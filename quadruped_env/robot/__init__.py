"""Robots as values: names, limits, models, kinematics; the built-in robot, and a builder for others like it."""

from quadruped_env.robot.assets import asset_path
from quadruped_env.robot.mini_quadruped import JOINT_NAMES, LEG_NAMES, MINI_QUADRUPED, forward_kinematics
from quadruped_env.robot.motors import JOINT_KINDS, JointMotor, MotorConfig
from quadruped_env.robot.quadruped_design import QuadrupedDesign
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.transforms import Transform

# The names below go as soon as no other package reads them.
LINK_NAMES = MINI_QUADRUPED.link_names
STANCE = MINI_QUADRUPED.stance
STANCE_HEIGHT = MINI_QUADRUPED.stance_height
FOOT_RADIUS = MINI_QUADRUPED.foot_radius
JOINT_POSITION_LOW = MINI_QUADRUPED.joint_position_low
JOINT_POSITION_HIGH = MINI_QUADRUPED.joint_position_high
VELOCITY_LIMIT = float(MINI_QUADRUPED.velocity_limit[0])
EFFORT_LIMIT = float(MINI_QUADRUPED.effort_limit[0])
TOTAL_MASS = 4.0
resting_pose = MINI_QUADRUPED.resting_pose
sole_heights = MINI_QUADRUPED.sole_heights
foot_centres = MINI_QUADRUPED.foot_centres
joint_transforms = MINI_QUADRUPED.joint_transforms
fixed_transforms = MINI_QUADRUPED.fixed_transforms

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
    "QuadrupedDesign",
    "Robot",
    "Transform",
    "asset_path",
    "fixed_transforms",
    "foot_centres",
    "forward_kinematics",
    "joint_transforms",
    "resting_pose",
    "sole_heights",
]
