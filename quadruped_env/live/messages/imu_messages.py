"""`/imu/data`: orientation and angular velocity of the base, validated."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import MAX_MEASURED
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.live.middleware.topics import TF_STATIC
from quadruped_env.ros.timestamps import read_stamp
from quadruped_env.utils.rotations import inverse, multiply, rotate

_NORM_ERROR = 0.05
_MAX_FRAMES = 1000
"""Number of frames that are remembered."""


class Imu(NamedTuple):
    """One IMU message."""

    stamp: int
    """Timestamp, ns."""
    orientation: NDArray[np.float64]
    """Unit quaternion wxyz of the sensor (4,)."""
    angular_velocity: NDArray[np.float64]
    """Angular velocity in the sensor's frame (3,), rad/s."""
    frame: str
    """The sensor's frame; empty if the message names none."""
    content: bytes = b""
    """All numbers of the message, to see whether they change."""


def read_imu(message: Any) -> Imu:
    """The IMU measurement of a `sensor_msgs/msg/Imu` message.

    Raises:
        QuadrupedError: if it has no orientation or timestamp, or a value is not finite or too large.
    """
    stamp = read_stamp(message.header.stamp)
    if stamp == 0:
        raise QuadrupedError("/imu/data: the timestamp is empty; have the publisher fill header.stamp")
    if message.orientation_covariance[0] == -1.0:
        raise QuadrupedError("/imu/data: is marked as having no orientation; send one, such as from an attitude filter")
    turn, rate = message.orientation, message.angular_velocity
    orientation = np.array([turn.w, turn.x, turn.y, turn.z])
    angular_velocity = np.array([rate.x, rate.y, rate.z])
    if not (np.isfinite(orientation).all() and np.isfinite(angular_velocity).all()):
        raise QuadrupedError("/imu/data: a value is not finite; send finite numbers")
    if np.abs(angular_velocity).max() > MAX_MEASURED:
        raise QuadrupedError(
            f"/imu/data: the angular velocity is {angular_velocity.tolist()}; send at most {MAX_MEASURED:g} rad/s"
        )
    norm = float(np.linalg.norm(orientation))
    if abs(norm - 1.0) > _NORM_ERROR:
        raise QuadrupedError(f"/imu/data: the orientation has length {norm:.3g}; send a unit quaternion")
    force = message.linear_acceleration
    content = np.concatenate([orientation, angular_velocity, [force.x, force.y, force.z]]).tobytes()
    return Imu(stamp, orientation / norm, angular_velocity, message.header.frame_id, content)


class ImuMount:
    """Rotation of the IMU in the base frame: given, or looked up in the transforms of `/tf_static`.

    Args:
        base: name of the base's frame.
        mount: the sensor's orientation in the base frame, unit quaternion wxyz (4,); None: look it up.
    """

    def __init__(self, base: str, mount: NDArray[np.float64] | None = None) -> None:
        self._base = base
        self._mount = mount
        self._parents: dict[str, tuple[str, NDArray[np.float64]]] = {}
        """Frame -> its parent, and its orientation in the parent."""
        self._found: dict[str, NDArray[np.float64]] = {}

    def add(self, message: Any) -> None:
        """Take the transforms of a `/tf_static` message; those with an invalid quaternion are ignored."""
        self._found.clear()
        for one in message.transforms:
            turn = one.transform.rotation
            rotation = np.array([turn.w, turn.x, turn.y, turn.z])
            norm = float(np.linalg.norm(rotation))
            frame, parent = _frame(one.child_frame_id), _frame(one.header.frame_id)
            if abs(norm - 1.0) <= _NORM_ERROR and (frame in self._parents or len(self._parents) < _MAX_FRAMES):
                self._parents[frame] = parent, rotation / norm

    def in_base(self, imu: Imu) -> Imu:
        """The measurement of an IMU at the base.

        Raises:
            QuadrupedError: if no transform is known from its frame to the base's.
        """
        mount = self._mount
        if mount is None:
            frame = _frame(imu.frame)
            if frame in ("", self._base):
                return imu
            if frame not in self._found:
                self._found[frame] = self._look_up(frame)
            mount = self._found[frame]
        orientation = multiply(imu.orientation, inverse(mount))
        return Imu(imu.stamp, orientation, rotate(mount, imu.angular_velocity), self._base)

    def _look_up(self, frame: str) -> NDArray[np.float64]:
        ours, theirs = self._ancestors(self._base), self._ancestors(frame)
        for ancestor, rotation in theirs.items():
            if ancestor in ours:
                return multiply(inverse(ours[ancestor]), rotation)
        raise QuadrupedError(
            f"/imu/data: {TF_STATIC.name} has no transform from {short(frame)} to {self._base!r}; publish it, or give "
            f"the sensor's mounting angles (--imu-mount 0 0 0 if it is aligned with the base)"
        )

    def _ancestors(self, frame: str) -> dict[str, NDArray[np.float64]]:
        """A frame and all above it, with the frame's orientation in each."""
        found, rotation = {frame: np.array([1.0, 0.0, 0.0, 0.0])}, np.array([1.0, 0.0, 0.0, 0.0])
        while frame in self._parents:
            frame, above = self._parents[frame]
            if frame in found:
                break
            found[frame] = rotation = multiply(above, rotation)
        return found


def _frame(name: str) -> str:
    """A frame's name without the leading slash of ROS 1."""
    return name.removeprefix("/")
