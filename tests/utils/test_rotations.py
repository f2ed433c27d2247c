"""Rotations, against MuJoCo's functions and SciPy's."""

import math

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from quadruped_env.utils import rotations

AXIS = np.array([2.0, -1.0, 2.0]) / 3.0


@pytest.fixture
def quaternions():
    """Random unit quaternions wxyz (50, 4), w of both signs."""
    values = np.random.default_rng(0).normal(size=(50, 4))
    return values / np.linalg.norm(values, axis=1, keepdims=True)


@pytest.fixture
def vectors():
    """Random vectors (50, 3)."""
    return np.random.default_rng(1).normal(size=(50, 3))


def scipy_of(quaternions):
    return Rotation.from_quat(quaternions, scalar_first=True)


def test_rotate_random_vectors_matches_scipy_and_mujoco(quaternions, vectors):
    rotated = rotations.rotate(quaternions, vectors)
    np.testing.assert_allclose(rotated, scipy_of(quaternions).apply(vectors), atol=1e-14)
    expected = np.empty(3)
    for quaternion, vector, found in zip(quaternions, vectors, rotated, strict=True):
        mujoco.mju_rotVecQuat(expected, vector, quaternion)
        np.testing.assert_allclose(found, expected, atol=1e-14)


def test_rotate_one_vector_by_many_quaternions_broadcasts(quaternions):
    rotated = rotations.rotate(quaternions.reshape(5, 10, 4), [1.0, 2.0, 3.0])
    expected = scipy_of(quaternions).apply([1.0, 2.0, 3.0])
    np.testing.assert_allclose(rotated, expected.reshape(5, 10, 3), atol=1e-14)


def test_rotate_inverse_after_rotate_gives_the_vector_back(quaternions, vectors):
    np.testing.assert_allclose(
        rotations.rotate_inverse(quaternions, rotations.rotate(quaternions, vectors)), vectors, atol=1e-14
    )
    np.testing.assert_allclose(
        rotations.rotate_inverse(quaternions, vectors), scipy_of(quaternions).inv().apply(vectors), atol=1e-14
    )


def test_multiply_applies_the_second_rotation_first(quaternions, vectors):
    first, second = quaternions, quaternions[::-1]
    product = rotations.multiply(first, second)
    np.testing.assert_allclose(
        rotations.rotate(product, vectors), rotations.rotate(first, rotations.rotate(second, vectors)), atol=1e-14
    )
    expected = np.empty(4)
    for a, b, found in zip(first, second, product, strict=True):
        mujoco.mju_mulQuat(expected, a, b)
        np.testing.assert_allclose(found, expected, atol=1e-15)


def test_multiply_one_quaternion_with_many_broadcasts(quaternions):
    product = rotations.multiply(quaternions[0], quaternions)
    np.testing.assert_array_equal(product[7], rotations.multiply(quaternions[0], quaternions[7]))


def test_multiply_with_the_inverse_is_the_identity(quaternions):
    product = rotations.multiply(quaternions, rotations.inverse(quaternions))
    np.testing.assert_allclose(product, np.tile([1.0, 0.0, 0.0, 0.0], (50, 1)), atol=1e-15)


@pytest.mark.parametrize("shape", [(), (3,), (4, 2)])
def test_from_axis_angle_any_shape_matches_mujoco(shape):
    angles = np.random.default_rng(2).uniform(-7.0, 7.0, shape)
    found = rotations.from_axis_angle(AXIS, angles)
    assert found.shape == (*shape, 4)
    expected = np.empty(4)
    for angle, quaternion in zip(angles.ravel(), found.reshape(-1, 4), strict=True):
        mujoco.mju_axisAngle2Quat(expected, AXIS, angle)
        np.testing.assert_allclose(quaternion, expected, atol=1e-15)


def test_from_axis_angle_one_axis_per_angle_rotates_about_each():
    found = rotations.from_axis_angle(np.eye(3), [0.1, 0.2, 0.3])
    np.testing.assert_allclose(found[:, 0], np.cos([0.05, 0.1, 0.15]))
    np.testing.assert_allclose(found[:, 1:], np.diag(np.sin([0.05, 0.1, 0.15])), atol=1e-15)


def test_from_roll_pitch_yaw_matches_scipys_fixed_axes():
    angles = np.random.default_rng(3).uniform(-math.pi, math.pi, (4, 5, 3))
    found = rotations.from_roll_pitch_yaw(angles)
    expected = Rotation.from_euler("xyz", angles.reshape(-1, 3)).as_matrix()
    np.testing.assert_allclose(scipy_of(found.reshape(-1, 4)).as_matrix(), expected, atol=1e-14)


def test_yaw_of_from_yaw_is_the_angle():
    angles = np.linspace(-3.1, 3.1, 11)
    np.testing.assert_allclose(rotations.yaw(rotations.from_yaw(angles)), angles, atol=1e-15)
    np.testing.assert_allclose(rotations.from_yaw(angles), rotations.from_axis_angle([0, 0, 1], angles))


def test_yaw_of_any_orientation_is_the_direction_of_its_x_axis(quaternions):
    ahead = scipy_of(quaternions).apply([1.0, 0.0, 0.0])
    np.testing.assert_allclose(rotations.yaw(quaternions), np.arctan2(ahead[:, 1], ahead[:, 0]), atol=1e-12)


def test_up_in_body_and_tilt_match_rotation_matrices(quaternions):
    up = scipy_of(quaternions).as_matrix()[:, 2]
    np.testing.assert_allclose(rotations.up_in_body(quaternions), up, atol=1e-14)
    np.testing.assert_allclose(rotations.tilt(quaternions), np.arccos(up[:, 2]), atol=1e-7)


def test_single_precision_orientations_are_computed_in_double(quaternions):
    single = quaternions.astype(np.float32)
    assert rotations.up_in_body(single).dtype == np.float64
    np.testing.assert_array_equal(rotations.yaw(single), rotations.yaw(single.astype(np.float64)))
