"""Messages of `/tf`, `/tf_static` and `/robot_description`."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import asset_path, fixed_transforms, joint_transforms
from quadruped_env.ros import cdr
from quadruped_env.ros.tf import TfEncoder
from quadruped_env.trajectory.formats.bag_writer import tf_encoder, tf_numbers


class TransformWriter:
    """Writes `/tf` for joint states."""

    def __init__(self) -> None:
        self._encode: TfEncoder | None = None

    def __call__(self, stamp: int, positions: NDArray[np.float64]) -> bytes:
        """The CDR bytes of one message.

        Args:
            stamp: timestamp, ns.
            positions: joint positions, rad (8,).
        """
        transforms = joint_transforms(positions)
        self._encode = self._encode or tf_encoder(transforms)
        return self._encode(stamp, tf_numbers(transforms, 1)[0])


def fixed_message(stamp: int) -> bytes:
    """The CDR bytes of `/tf_static`."""
    fixed = fixed_transforms()
    return tf_encoder(fixed)(stamp, tf_numbers(fixed, 1)[0])


def description_message() -> Any:
    """The `/robot_description` message, which contains the URDF."""
    return cdr.message("std_msgs/msg/String", data=asset_path("mini_quadruped.urdf").read_text())
