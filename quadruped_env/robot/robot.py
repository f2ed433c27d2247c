"""A robot as a value: what the packages above need to know about it, passed down to them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Robot:
    """A legged robot: names, limits, stance and symmetry. Arrays are in the order of `joint_names` or `leg_names`."""

    name: str
    leg_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    link_names: tuple[str, ...]
    joint_position_low: NDArray[np.float64]
    """rad (J,)"""
    joint_position_high: NDArray[np.float64]
    """rad (J,)"""
    velocity_limit: float
    """Joint speed without load, rad/s"""
    effort_limit: float
    """Joint torque at rest, N m"""
    stance: NDArray[np.float64]
    """Joint positions with each foot under its hip, rad (J,)"""
    stance_height: float
    """Height of the base's centre in the stance, with the soles on the ground, m"""
    foot_radius: float
    """m; each foot is a ball"""
    joint_mirror: tuple[int, ...]
    """For each joint the joint on the other side; every joint turns about the y axis, so its sign stays"""
    foot_mirror: tuple[int, ...]
    """For each foot the foot on the other side"""

    @property
    def base_name(self) -> str:
        """The link that carries the legs."""
        return self.link_names[0]

    @property
    def num_joints(self) -> int:
        """Number of joints, J."""
        return len(self.joint_names)

    @property
    def num_legs(self) -> int:
        """Number of legs, L."""
        return len(self.leg_names)

    @property
    def num_positions(self) -> int:
        """Length of MuJoCo's `qpos`: the base's position (3,) and quaternion wxyz (4,), then the joints."""
        return 7 + self.num_joints

    @property
    def num_velocities(self) -> int:
        """Length of MuJoCo's `qvel`: the base's linear (3,) and angular (3,) velocity, then the joints."""
        return 6 + self.num_joints
