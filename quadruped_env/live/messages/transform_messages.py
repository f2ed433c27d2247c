"""Messages of `/tf`, `/tf_static` and `/robot_description`."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.robot import Robot
from quadruped_env.ros import cdr
from quadruped_env.ros.tf import TfEncoder, tf_encoder, tf_numbers


class TransformWriter:
    """Writes `/tf` for joint states of a robot."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._encode: TfEncoder | None = None

    def __call__(self, stamp: int, positions: NDArray[np.float64]) -> bytes:
        """The CDR bytes of one message.

        Args:
            stamp: timestamp, ns.
            positions: joint positions, rad (J,).
        """
        transforms = self._robot.joint_transforms(positions)
        self._encode = self._encode or tf_encoder(transforms)
        return self._encode(stamp, tf_numbers(transforms, 1)[0])


def fixed_message(robot: Robot, stamp: int) -> bytes:
    """The CDR bytes of `/tf_static`."""
    fixed = robot.fixed_transforms()
    return tf_encoder(fixed)(stamp, tf_numbers(fixed, 1)[0])


def description_message(robot: Robot) -> Any:
    """The `/robot_description` message, which contains the URDF."""
    return cdr.message("std_msgs/msg/String", data=robot.urdf)
