"""What was recorded: joint states over time, and the formats that they are kept in."""

from quadruped_env.trajectory.joint_map import JointMap, JointRule
from quadruped_env.trajectory.joint_trajectory import JointState, JointTrajectory
from quadruped_env.trajectory.signals import NANOSECONDS, Gap

__all__ = ["NANOSECONDS", "Gap", "JointMap", "JointRule", "JointState", "JointTrajectory"]
