"""Fast serialization of `tf2_msgs/msg/TFMessage` with the same frames in every message."""

import struct
from collections.abc import Iterable, Sequence
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray

from quadruped_env.ros.timestamps import NS_PER_SECOND

_ENCAPSULATION: Final = b"\x00\x01\x00\x00"
_STAMP: Final = struct.Struct("<iI")
_COUNT: Final = struct.Struct("<I")
_NUMBERS: Final = 7
"""Numbers per transform: x, y, z, and the quaternion x, y, z, w."""


class FrameTransform(Protocol):
    """Pose of a frame in its parent, over time or constant, such as a `quadruped_env.robot.Transform`."""

    @property
    def parent(self) -> str:
        """Name of the parent frame."""

    @property
    def child(self) -> str:
        """Name of the frame."""

    @property
    def translation(self) -> NDArray[np.float64]:
        """Translation (..., 3), m."""

    @property
    def rotation(self) -> NDArray[np.float64]:
        """Quaternion wxyz (..., 4)."""


class TfEncoder:
    """Writes messages of one set of frames.

    Args:
        frames: (parent, child) of each transform.
    """

    def __init__(self, frames: Sequence[tuple[str, str]]) -> None:
        data = bytearray(_COUNT.pack(len(frames)))
        self._stamps, self._numbers = [], []
        for parent, child in frames:
            data += bytes(-len(data) % 4)
            self._stamps.append(len(data) + len(_ENCAPSULATION))
            data += bytes(_STAMP.size)
            for name in (parent, child):
                data += bytes(-len(data) % 4)
                encoded = name.encode() + b"\x00"
                data += _COUNT.pack(len(encoded)) + encoded
            data += bytes(-len(data) % 8)
            self._numbers.append(len(data) + len(_ENCAPSULATION))
            data += bytes(8 * _NUMBERS)
        self._template = _ENCAPSULATION + bytes(data)

    def __call__(self, stamp: int, numbers: NDArray[np.float64]) -> bytes:
        """The CDR bytes of one message.

        Args:
            stamp: ns, of all transforms.
            numbers: (F, 7): translation in m, and quaternion in ROS's order, xyzw.
        """
        data = bytearray(self._template)
        time = _STAMP.pack(*divmod(stamp, NS_PER_SECOND))
        values = numbers.astype("<f8", copy=False).tobytes()
        size = 8 * _NUMBERS
        for i, (at, start) in enumerate(zip(self._stamps, self._numbers, strict=True)):
            data[at : at + _STAMP.size] = time
            data[start : start + size] = values[i * size : (i + 1) * size]
        return bytes(data)


def tf_encoder(transforms: Iterable[FrameTransform]) -> TfEncoder:
    """Encoder of messages with these transforms."""
    return TfEncoder([(transform.parent, transform.child) for transform in transforms])


def tf_numbers(transforms: Iterable[FrameTransform], count: int) -> NDArray[np.float64]:
    """Numbers of `count` messages for their encoder: (count, F, 7), quaternions in ROS's order xyzw."""
    parts = [
        np.concatenate([one.translation, one.rotation[..., [1, 2, 3, 0]]], axis=-1).reshape(-1, _NUMBERS)
        for one in transforms
    ]
    return np.stack(parts, axis=1) if parts else np.empty((count, 0, _NUMBERS))
