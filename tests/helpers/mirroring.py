"""Mirror image of a robot's state."""

import numpy as np
import twelve_joints

SWAP = np.array([2, 3, 0, 1, 6, 7, 4, 5])
"""Counterpart of each joint of the built-in robot."""
TWELVE_SWAP, TWELVE_SIGNS = np.array([3, 4, 5, 0, 1, 2, 9, 10, 11, 6, 7, 8]), np.tile([-1.0, 1.0, 1.0], 4)
"""The same for the robot with twelve joints, and the signs of its joints: its rolls turn the other way."""


def mirrored(qpos, qvel, ctrl, robot=None):
    """The reflection in the plane y = 0: left legs become right legs, rotations about x and z change sign."""
    swap, signs = (TWELVE_SWAP, TWELVE_SIGNS) if robot is twelve_joints.ROBOT else (SWAP, 1.0)
    base_pose = qpos[:7] * [1, -1, 1, 1, -1, 1, -1]
    base_velocity = qvel[:6] * [1, -1, 1, -1, 1, -1]
    joints = (signs * values[swap] for values in (qpos[7:], qvel[6:], ctrl))
    position, velocity, target = joints
    return np.concatenate([base_pose, position]), np.concatenate([base_velocity, velocity]), target
