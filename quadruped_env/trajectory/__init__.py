"""What was recorded: joint states over time, and the formats that they are kept in."""

from quadruped_env.trajectory.joint_map import JointMap, JointRule
from quadruped_env.trajectory.joint_trajectory import Gap, JointState, JointTrajectory

__all__ = ["Gap", "JointMap", "JointRule", "JointState", "JointTrajectory"]
