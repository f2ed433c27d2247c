"""Mirror image of a robot's state."""

import numpy as np


def mirrored(qpos, qvel, ctrl):
    """The reflection in the plane y = 0: left legs become right legs, rotations about x and z change sign."""
    swap = np.array([2, 3, 0, 1, 6, 7, 4, 5])
    base_pose = qpos[:7] * [1, -1, 1, 1, -1, 1, -1]
    base_velocity = qvel[:6] * [1, -1, 1, -1, 1, -1]
    return (np.concatenate([base_pose, qpos[7:][swap]]), np.concatenate([base_velocity, qvel[6:][swap]]), ctrl[swap])
