"""What was recorded: joint states over time, and the formats that they are kept in."""

from quadruped_env.trajectory.joint_trajectory import JointState, JointTrajectory

__all__ = ["JointState", "JointTrajectory"]
