"""`/imu/data`: orientation and angular velocity of the base, validated."""

from typing import Any, NamedTuple

import numpy as np

from quadruped_env.control.joint_command import MAX_MEASURED
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.ros.timestamps import read_stamp
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.rotations import inverse, multiply, rotate

_NORM_ERROR = 0.05


class Imu(NamedTuple):
    """One IMU message."""

    stamp: int
    """Timestamp, ns."""
    orientation: Floats
    """Unit quaternion wxyz of the sensor (4,)."""
    angular_velocity: Floats
    """Angular velocity in the sensor's frame (3,), rad/s."""
    frame: str
    """The sensor's frame; empty if the message names none."""
    content: bytes = b""
    """All numbers of the message, to see whether they change."""


def read_imu(message: Any) -> Imu:
    """Read the measurement of a `sensor_msgs/msg/Imu` message.

    Raises:
        QuadrupedError: if it has no orientation or timestamp, or a value is not finite or too large.
    """
    stamp = read_stamp(message.header.stamp)
    if stamp == 0:
        raise QuadrupedError("the timestamp is empty; have the publisher fill header.stamp")
    if message.orientation_covariance[0] == -1.0:
        raise QuadrupedError("is marked as having no orientation; send one, such as from an attitude filter")
    turn, rate = message.orientation, message.angular_velocity
    orientation = np.array([turn.w, turn.x, turn.y, turn.z])
    angular_velocity = np.array([rate.x, rate.y, rate.z])
    if not (np.isfinite(orientation).all() and np.isfinite(angular_velocity).all()):
        raise QuadrupedError("a value is not finite; send finite numbers")
    if np.abs(angular_velocity).max() > MAX_MEASURED:
        raise QuadrupedError(
            f"the angular velocity is {angular_velocity.tolist()}; send at most {MAX_MEASURED:g} rad/s"
        )
    norm = float(np.linalg.norm(orientation))
    if abs(norm - 1.0) > _NORM_ERROR:
        raise QuadrupedError(f"the orientation has length {norm:.3g}; send a unit quaternion")
    force = message.linear_acceleration
    content = np.concatenate([orientation, angular_velocity, [force.x, force.y, force.z]]).tobytes()
    return Imu(stamp, orientation / norm, angular_velocity, message.header.frame_id, content)


def in_base(imu: Imu, base: str, mount: Floats | None) -> Imu:
    """Convert the measurement of an IMU to the base frame.

    Args:
        imu: the measurement in the sensor's frame.
        base: name of the base's frame.
        mount: the sensor's orientation in the base frame, unit quaternion wxyz (4,); None: the sensor's frame has to be
            the base's.

    Raises:
        QuadrupedError: if the orientation of the sensor's frame is not known.
    """
    if mount is not None:
        return imu._replace(
            orientation=multiply(imu.orientation, inverse(mount)), angular_velocity=rotate(mount, imu.angular_velocity)
        )
    # ROS 1 wrote names of frames with a leading slash.
    if imu.frame.removeprefix("/") not in ("", base):
        raise QuadrupedError(
            f"/imu/data: is in the frame {short(imu.frame)} and not in {base!r}; give the sensor's orientation on the "
            f"base with --imu-mount (0 0 0 if they are aligned)"
        )
    return imu
