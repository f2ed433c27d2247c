"""What the robot is: names and order, limits, assets, the compiled model, kinematics."""

from quadruped_env.robot.assets import asset_path, load_model
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
from quadruped_env.robot.kinematics import forward_kinematics

__all__ = [
    "EFFORT_LIMIT",
    "FOOT_RADIUS",
    "JOINT_NAMES",
    "JOINT_POSITION_HIGH",
    "JOINT_POSITION_LOW",
    "LEG_NAMES",
    "LINK_NAMES",
    "STANCE",
    "STANCE_HEIGHT",
    "TOTAL_MASS",
    "VELOCITY_LIMIT",
    "asset_path",
    "forward_kinematics",
    "load_model",
]
