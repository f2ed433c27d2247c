"""Rotations as unit quaternions wxyz, as in MuJoCo: an orientation turns the body frame into the world frame.

Every function takes arrays with any leading axes (...), computes in float64, and expects quaternions of length 1. ROS
messages and SciPy order a quaternion xyzw.
"""

import numpy as np
from numpy.typing import ArrayLike

from quadruped_env.utils.arrays import Floats


def from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Floats:
    """Return quaternions (..., 4) of rotations by angles (...) in rad about unit axes (3,) or (..., 3)."""
    half = 0.5 * _floats(angle)[..., None]
    xyz = np.sin(half) * _floats(axis)
    return np.concatenate([np.broadcast_to(np.cos(half), (*xyz.shape[:-1], 1)), xyz], axis=-1)


def from_yaw(angle: ArrayLike) -> Floats:
    """Return quaternions (..., 4) of rotations by angles (...) in rad about the vertical."""
    return from_axis_angle([0.0, 0.0, 1.0], angle)


def from_roll_pitch_yaw(angles: ArrayLike) -> Floats:
    """Return quaternions (..., 4) of roll, pitch and yaw (..., 3) in rad, as in a URDF.

    Roll about the fixed x axis, then pitch about the fixed y axis, then yaw about the fixed z axis.
    """
    half = 0.5 * _floats(angles)
    (cr, cp, cy), (sr, sp, sy) = _components(np.cos(half)), _components(np.sin(half))
    cc, cs, sc, ss = cr * cp, cr * sp, sr * cp, sr * sp
    quaternions = np.empty((*half.shape[:-1], 4))
    quaternions[..., 0] = cc * cy + ss * sy
    quaternions[..., 1] = sc * cy - cs * sy
    quaternions[..., 2] = cs * cy + sc * sy
    quaternions[..., 3] = cc * sy - ss * cy
    return quaternions


def multiply(first: ArrayLike, second: ArrayLike) -> Floats:
    """Return products (..., 4): the rotation by `second` (..., 4), and after it the one by `first` (..., 4)."""
    a, b, c, d = _components(first)
    w, x, y, z = _components(second)
    return np.stack(
        [
            a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w,
        ],
        axis=-1,
    )


def inverse(rotation: ArrayLike) -> Floats:
    """Return inverse rotations (..., 4)."""
    return _floats(rotation) * [1.0, -1.0, -1.0, -1.0]


def rotate(rotation: ArrayLike, vector: ArrayLike) -> Floats:
    """Return vectors (..., 3) rotated by quaternions (..., 4); by an orientation: from body to world."""
    quaternion, v = _floats(rotation), _floats(vector)
    w, axis = quaternion[..., :1], quaternion[..., 1:]
    turned = 2.0 * np.cross(axis, v)
    return v + w * turned + np.cross(axis, turned)


def rotate_inverse(rotation: ArrayLike, vector: ArrayLike) -> Floats:
    """Vectors (..., 3) rotated by the inverses of quaternions (..., 4); of an orientation: from world to body."""
    return rotate(inverse(rotation), vector)


def up_in_body(orientation: ArrayLike) -> Floats:
    """Return the world's up direction in the body frame (..., 3), for orientations (..., 4)."""
    w, x, y, z = _components(orientation)
    return np.stack([2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)], axis=-1)


def yaw(orientation: ArrayLike) -> Floats:
    """Heading of the body's x axis in the ground plane, rad from the world's x axis in [-pi, pi], shape (...)."""
    w, x, y, z = _components(orientation)
    return np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


def tilt(orientation: ArrayLike) -> Floats:
    """Return the angle between the body's and the world's up direction, rad in [0, pi], shape (...)."""
    up = up_in_body(orientation)
    return np.arctan2(np.hypot(up[..., 0], up[..., 1]), up[..., 2])


def _floats(values: ArrayLike) -> Floats:
    return np.asarray(values, dtype=np.float64)


def _components(rotation: ArrayLike) -> Floats:
    """Return the components w, x, y, z (4, ...) of quaternions (..., 4), or of other vectors."""
    values = _floats(rotation)
    return values.transpose(-1, *range(values.ndim - 1))
