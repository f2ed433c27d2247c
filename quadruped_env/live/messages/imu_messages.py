"""`/imu/data`: orientation and angular velocity of the base, validated."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.messages.joint_messages import MAX_VALUE
from quadruped_env.ros.timestamps import read_stamp

_NORM_ERROR = 0.05


class Imu(NamedTuple):
    """One IMU message."""

    stamp: int
    """Timestamp, ns."""
    orientation: NDArray[np.float64]
    """Unit quaternion wxyz (4,)."""
    angular_velocity: NDArray[np.float64]
    """Angular velocity in the base frame (3,), rad/s."""


def read_imu(message: Any) -> Imu:
    """The IMU measurement of a `sensor_msgs/msg/Imu` message.

    Raises:
        QuadrupedError: if it has no orientation, or a value is not finite or too large.
    """
    if message.orientation_covariance[0] == -1.0:
        raise QuadrupedError("/imu/data: is marked as having no orientation; send one, such as from an attitude filter")
    turn, rate = message.orientation, message.angular_velocity
    orientation = np.array([turn.w, turn.x, turn.y, turn.z])
    angular_velocity = np.array([rate.x, rate.y, rate.z])
    if not (np.isfinite(orientation).all() and np.isfinite(angular_velocity).all()):
        raise QuadrupedError("/imu/data: a value is not finite; send finite numbers")
    if np.abs(angular_velocity).max() > MAX_VALUE:
        raise QuadrupedError(
            f"/imu/data: the angular velocity is {angular_velocity.tolist()}; send at most {MAX_VALUE:g} rad/s"
        )
    norm = float(np.linalg.norm(orientation))
    if abs(norm - 1.0) > _NORM_ERROR:
        raise QuadrupedError(f"/imu/data: the orientation has length {norm:.3g}; send a unit quaternion")
    return Imu(read_stamp(message.header.stamp), orientation / norm, angular_velocity)
