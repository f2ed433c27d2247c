"""The built-in robot."""

from typing import Final

from numpy.typing import ArrayLike

from quadruped_env.robot.quadruped_design import QuadrupedDesign
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.skeleton import Pose

MINI_QUADRUPED: Final = QuadrupedDesign().robot()
"""8-joint quadruped of the ROS 2 tutorial; assets/mini_quadruped/README.md derives its numbers."""

LEG_NAMES: Final = MINI_QUADRUPED.leg_names
"""Names of the built-in robot's legs: left (L) or right (R), front (F) or hind (H)."""

JOINT_NAMES: Final = MINI_QUADRUPED.joint_names
"""Names of the built-in robot's eight joints, in the order of every array."""


def forward_kinematics(
    positions: ArrayLike, base_pose: ArrayLike | None = None, robot: Robot = MINI_QUADRUPED
) -> dict[str, Pose]:
    """Return the pose of every link of a robot, by default the built-in one.

    Position (..., 3) in m and quaternion wxyz (..., 4) by link, for joint positions (..., J) in rad. Arguments and
    errors are as in `Robot.forward_kinematics`.
    """
    return robot.forward_kinematics(positions, base_pose)
