"""Recorded joint states: the trajectory type, and loading and saving it in any format."""

from quadruped_env.trajectory.interpolation import Gap
from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.maps import ColumnMap, JointMap, JointRule
from quadruped_env.trajectory.rows import JointState

__all__ = ["ColumnMap", "Gap", "JointMap", "JointRule", "JointState", "JointTrajectory", "load", "save"]

load = JointTrajectory.load
save = JointTrajectory.save
