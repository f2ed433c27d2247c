"""Description of a robot, which other packages receive as an argument."""

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
    """Lower limits of the joint positions (J,), rad."""
    joint_position_high: NDArray[np.float64]
    """Upper limits of the joint positions (J,), rad."""
    velocity_limit: float
    """Maximum joint speed without load, rad/s."""
    effort_limit: float
    """Maximum joint torque at rest, N m."""
    stance: NDArray[np.float64]
    """Joint positions with each foot under its hip (J,), rad."""
    stance_height: float
    """Height of the base's centre in the stance, with the feet on the ground, m."""
    foot_radius: float
    """Radius of the feet, which are balls, m."""
    joint_mirror: tuple[int, ...]
    """Index of each joint's counterpart on the other side; all joints turn about the y axis, so no sign changes."""
    foot_mirror: tuple[int, ...]
    """Index of each foot's counterpart on the other side."""

    @property
    def base_name(self) -> str:
        """Name of the link that carries the legs."""
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
