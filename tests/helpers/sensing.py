"""Random poses of the robot, and readings of its sensors by name."""

import numpy as np
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW
from scipy.spatial.transform import Rotation

GRAVITY = 9.81


def random_pose(rng, data, height):
    """A random attitude and random joints, at a height in m."""
    data.qpos[:3] = [0, 0, height]
    data.qpos[3:7] = Rotation.random(rng=rng).as_quat(scalar_first=True)
    data.qpos[7:] = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)


def reading(data, *names):
    return np.concatenate([data.sensor(name).data for name in names])
