"""Measures of the gait against trajectories with known apexes, touchdowns, limits and attitudes."""

import math

import numpy as np
import pytest
from synthetic import DT, synthetic_rollout

from quadruped_env.evaluation import metrics
from quadruped_env.evaluation.suite import gait_measures
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.reporting.pages.suite_section import _GAIT_ROWS
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.utils.rotations import from_roll_pitch_yaw

PART = full_suite().gait
STRIDE = 25
"""Samples of a stride: 2 Hz."""
SWING = 10
"""Samples of a swing."""


def stride(apexes, steps):
    """Height and contact (T,) of a foot that swings along a parabola to the apex of each stride, and stands then."""
    height, contact = np.zeros(steps), np.ones(steps, dtype=bool)
    share = (np.arange(SWING) + 0.5) / SWING
    parabola = 4.0 * share * (1.0 - share)
    for i, apex in enumerate(apexes):
        swing = slice(i * STRIDE + 5, i * STRIDE + 5 + SWING)
        height[swing] = apex * parabola / parabola.max()
        contact[swing] = False
    return height, contact


def test_swing_apexes_are_those_of_whole_swings_that_last_long_enough():
    height, contact = stride([0.01, 0.02, 0.03], 3 * STRIDE)
    np.testing.assert_allclose(gait_measures.swing_apexes(height, contact, DT, 0.05), [0.01, 0.02, 0.03])
    # The swings at both ends are cut: their apex may have been missed.
    cut = slice(8, 2 * STRIDE + 9)
    np.testing.assert_allclose(gait_measures.swing_apexes(height[cut], contact[cut], DT, 0.05), [0.02])
    # A bounce of two samples is no swing; one of three samples is 0.06 s long.
    for samples, found in ((2, 0), (3, 1)):
        bounce, grounded = np.zeros(50), np.ones(50, dtype=bool)
        bounce[20 : 20 + samples], grounded[20 : 20 + samples] = 0.004, False
        assert len(gait_measures.swing_apexes(bounce, grounded, DT, 0.05)) == found
    assert len(gait_measures.swing_apexes(np.ones(50), np.zeros(50, dtype=bool), DT, 0.05)) == 0


def clearance_of(height, contact, strides, counted=None):
    shape = (len(height), 1, 1)
    counted = np.ones((len(height), 1), dtype=bool) if counted is None else counted
    return gait_measures.clearance(
        height.reshape(shape), contact.reshape(shape), counted, np.array([strides]), DT, 0.05
    )[0, 0]


def test_clearance_is_the_fifth_percentile_of_the_apexes():
    apexes = np.arange(1, 42) / 1000.0  # the 5th percentile of 1, 2, ..., 41 mm is 3 mm
    height, contact = stride(apexes, 41 * STRIDE)
    assert clearance_of(height, contact, 41.0) == pytest.approx(0.003)


def test_clearance_counts_strides_without_a_swing_as_an_apex_of_zero():
    height, contact = stride([0.02] * 40, 40 * STRIDE)
    assert clearance_of(height, contact, 40.0) == pytest.approx(0.02)
    dragged = np.arange(40) % 4 == 3
    height, contact = stride(np.where(dragged, 0.0, 0.02), 40 * STRIDE)
    contact |= np.repeat(dragged, STRIDE)
    assert clearance_of(height, contact, 40.0) == 0.0
    assert clearance_of(np.zeros(100), np.ones(100, dtype=bool), 4.0) == 0.0


def test_clearance_without_a_stride_is_zero_and_without_samples_nan():
    height, contact = stride([0.02] * 4, 4 * STRIDE)
    assert clearance_of(height, contact, math.nan) == 0.0
    assert math.isnan(clearance_of(height, contact, 4.0, np.zeros((4 * STRIDE, 1), dtype=bool)))


def test_touchdowns_are_counted_between_counted_samples():
    contact = np.zeros((8, 1, 2), dtype=bool)
    contact[:, 0, 0] = [0, 1, 0, 1, 1, 0, 1, 0]
    contact[:, 0, 1] = 1
    counted = np.ones((8, 1), dtype=bool)
    np.testing.assert_array_equal(gait_measures.touchdowns(contact, counted), [[3, 0]])
    counted[6:] = False
    np.testing.assert_array_equal(gait_measures.touchdowns(contact, counted), [[2, 0]])
    counted[0] = False
    np.testing.assert_array_equal(gait_measures.touchdowns(contact, counted), [[1, 0]])


def test_speed_limit_share_is_the_time_with_any_joint_over_its_limit():
    velocity = np.zeros((10, 1, 2))
    velocity[:3, 0, 0] = -4.8
    velocity[2:4, 0, 1] = 4.8
    velocity[9, 0, 1] = 99.0
    counted = np.ones((10, 1), dtype=bool)
    limit = np.array([4.75, 4.75])
    assert gait_measures.speed_limit_share(velocity, counted, limit) == pytest.approx(0.5)
    counted[9] = False
    assert gait_measures.speed_limit_share(velocity, counted, limit) == pytest.approx(4 / 9)
    assert gait_measures.speed_limit_share(velocity, counted, np.array([5.0, 4.75])) == pytest.approx(2 / 9)


def test_rate_of_a_ramp_and_of_an_alternation():
    counted = np.ones((100, 2), dtype=bool)
    values = np.zeros((100, 2, 2))
    values[:, 0] = 3.0 * DT * np.arange(100)[:, None]
    values[:, 1, 0] = 0.5 * (-1.0) ** np.arange(100)  # changes by 1 in every step; the other joint not at all
    np.testing.assert_allclose(metrics.rms_rate(values, counted, DT), [3.0, math.sqrt(0.5) / DT])


def test_roll_and_pitch_are_those_of_the_orientation_whatever_the_heading():
    roll, pitch = 0.2, -0.3
    for yaw in (0.0, 1.0, -3.0):
        found = gait_measures.roll_and_pitch(from_roll_pitch_yaw([roll, pitch, yaw]))
        np.testing.assert_allclose(found, (roll, pitch))


def walking(frequency=2.0, apex=0.02, touchdowns_extra=False):
    """A trot with known clearance, touchdowns, duty factor and stride frequency, for 11 s."""
    steps = 550
    t = np.arange(steps) * DT
    count = steps // STRIDE
    assert frequency == 1.0 / (STRIDE * DT)
    height, contact = stride([apex] * count, steps)
    if touchdowns_extra:
        contact[np.arange(count) * STRIDE + 20] = False  # one sample in the air: a bounce
    position = np.tile(MINI_QUADRUPED.stance, (steps, 1, 1))
    position[:, 0, 0::2] += 0.3 * np.sin(2 * np.pi * frequency * t)[:, None]
    orientation = from_roll_pitch_yaw(np.stack([0.05 * np.ones(steps), 0.02 * np.sign(np.sin(20 * t)), t], axis=-1))
    base = np.concatenate([np.tile([0.0, 0.0, 0.184], (steps, 1)), orientation], axis=1)
    return synthetic_rollout(
        steps,
        base_pose=base[:, None],
        joint_position=position,
        contact=np.repeat(contact[:, None, None], 4, axis=2),
        foot_height=np.repeat(height[:, None, None], 4, axis=2),
        velocity=np.tile([0.3, 0.0], (steps, 1, 1)),
    )


def test_measures_of_a_synthetic_gait():
    values = gait_measures.measures(walking(), PART)
    assert list(values) == list(_GAIT_ROWS)
    for name in gait_measures.PER_FOOT:
        assert values[name].shape == (1, 4)
    np.testing.assert_allclose(values["stride_frequency"], 2.0, rtol=2e-3)
    np.testing.assert_allclose(values["clearance"], 0.02)
    np.testing.assert_allclose(values["touchdowns_per_stride"], 1.0, rtol=5e-3)
    np.testing.assert_allclose(values["duty_factor"], 1.0 - SWING / STRIDE)
    np.testing.assert_allclose(values["roll"], 0.05)
    np.testing.assert_allclose(values["pitch"], 0.02, rtol=1e-2)
    assert values["joint_limit_share"] == 0.0
    assert values["speed_limit_share"] == 0.0
    bouncing = gait_measures.measures(walking(touchdowns_extra=True), PART)
    np.testing.assert_allclose(bouncing["touchdowns_per_stride"], 2.0, rtol=5e-3)
    np.testing.assert_allclose(bouncing["clearance"], 0.02)  # a bounce is no swing


def test_speed_limit_is_a_share_of_the_robots_own():
    velocity = np.zeros((250, 1, 8))
    velocity[50:150, 0, 3] = 0.96 * MINI_QUADRUPED.velocity_limit[3]
    assert gait_measures.measures(synthetic_rollout(joint_velocity=velocity), PART)[
        "speed_limit_share"
    ] == pytest.approx(0.5)
    velocity[50:150, 0, 3] = 0.94 * MINI_QUADRUPED.velocity_limit[3]
    assert gait_measures.measures(synthetic_rollout(joint_velocity=velocity), PART)["speed_limit_share"] == 0.0


def entry(**changes):
    return {
        "clearance": [0.02, 0.02, 0.02, 0.02],
        "touchdowns_per_stride": [1.0, 1.0, 1.0, 1.0],
        "speed_limit_share": 0.0,
        **changes,
    }


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({}, 1.0),
        ({"clearance": [0.02, 0.004, 0.02, 0.02]}, (0.4 + 1.0 + 1.0) / 3.0),
        ({"touchdowns_per_stride": [1.0, 2.5, 1.0, 1.0]}, (1.0 + 0.4 + 1.0) / 3.0),
        ({"touchdowns_per_stride": [1.0, 0.5, 1.2, 1.0]}, (1.0 + 0.5 + 1.0) / 3.0),
        ({"speed_limit_share": 0.3}, (1.0 + 1.0 + 0.7) / 3.0),
        ({"touchdowns_per_stride": [1.0, 0.0, 1.0, 1.0]}, 0.0),
        ({"touchdowns_per_stride": [None] * 4}, 0.0),
        ({"clearance": [None] * 4}, 0.0),
    ],
)
def test_score_of_a_gait(changes, expected):
    result = {"feet": ["RF", "LF", "RH", "LH"], "commands": [entry(**changes), entry()]}
    assert gait_measures.score(result, PART) == pytest.approx(0.5 * (expected + 1.0))
