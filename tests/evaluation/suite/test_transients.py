"""Measures of step responses against closed forms."""

import math

import numpy as np
import pytest
from synthetic import DT, falls, synthetic_rollout

from quadruped_env.evaluation.suite import changing
from quadruped_env.evaluation.suite.suite import PARTS
from quadruped_env.evaluation.suite.suite_definition import Change, full_suite

PART = full_suite().transients
BEFORE, AFTER = round(PART.before / DT), round(PART.after / DT)
TIME = (np.arange(BEFORE + AFTER) + 1 - BEFORE) * DT
"""Times of the samples since the change, s (T,)."""


def first_order(tau, start=0.0, end=0.5):
    """First-order response to a step at time 0, (T, 1)."""
    return np.where(TIME > 0, end + (start - end) * np.exp(-TIME / tau), start)[:, None]


def damped(omega, zeta, end=0.5):
    """Second-order response of an underdamped system, (T, 1)."""
    t = np.maximum(TIME, 0.0)
    natural = omega * math.sqrt(1.0 - zeta**2)
    swing = np.cos(natural * t) + zeta / math.sqrt(1.0 - zeta**2) * np.sin(natural * t)
    return (end * (1.0 - np.exp(-zeta * omega * t) * swing))[:, None]


def test_centred_mean_by_hand():
    values = np.array([[1.0], [2.0], [6.0], [3.0]])
    np.testing.assert_allclose(changing.centred_mean(values, 1)[:, 0], [1.5, 3.0, 11.0 / 3.0, 4.5])
    np.testing.assert_allclose(changing.centred_mean(values, 0), values)


@pytest.mark.parametrize("tau", [0.3, 0.5, 0.6])
@pytest.mark.parametrize(("start", "end"), [(0.0, 0.5), (0.5, 0.0), (0.3, -0.3)])
def test_settling_time_of_a_first_order_response_has_its_closed_form(tau, start, end):
    answer = changing.step_response(first_order(tau, start, end), end - start, PART, DT)
    # The centred mean over w multiplies an exponential with time constant tau by sinh(w / 2 tau) / (w / 2 tau).
    samples = 2 * round(0.5 * PART.window / DT) + 1
    ratio = 0.5 * samples * DT / tau
    settled = tau * math.log(math.sinh(ratio) / ratio / PART.band)
    assert answer.settling_time[0] == pytest.approx(settled, abs=1.5 * DT)
    assert answer.overshoot[0] == pytest.approx(0.0, abs=0.01)
    assert answer.followed[0]


def test_band_around_the_final_value_has_a_least_width():
    wide = changing.step_response(first_order(0.5), 0.5, PART, DT, narrowest=0.25)
    samples = 2 * round(0.5 * PART.window / DT) + 1
    ratio = 0.5 * samples * DT / 0.5
    assert wide.settling_time[0] == pytest.approx(0.5 * math.log(math.sinh(ratio) / ratio / 0.5), abs=1.5 * DT)
    narrow = changing.step_response(first_order(0.5), 0.5, PART, DT, narrowest=0.05)
    np.testing.assert_array_equal(
        narrow.settling_time, changing.step_response(first_order(0.5), 0.5, PART, DT).settling_time
    )


def test_overshoot_of_an_underdamped_response_has_its_closed_form():
    # So slow that the mean over 0.5 s hardly changes the peak.
    omega, zeta = 2.0, 0.4
    answer = changing.step_response(damped(omega, zeta), 0.5, PART, DT)
    assert answer.overshoot[0] == pytest.approx(math.exp(-math.pi * zeta / math.sqrt(1.0 - zeta**2)), rel=0.06)
    falling = changing.step_response(-damped(omega, zeta), -0.5, PART, DT)
    np.testing.assert_allclose(falling.overshoot, answer.overshoot)
    np.testing.assert_allclose(falling.settling_time, answer.settling_time)


def test_oscillation_within_a_stride_is_no_overshoot_and_does_not_delay_settling():
    swing = 0.1 * np.sin(2 * np.pi * 3.4 * TIME)[:, None]
    answer = changing.step_response(first_order(0.3) + swing, 0.5, PART, DT)
    quiet = changing.step_response(first_order(0.3), 0.5, PART, DT)
    np.testing.assert_allclose(answer.settling_time, quiet.settling_time, atol=2 * DT)
    assert answer.overshoot[0] < 0.02


def test_a_velocity_that_leaves_the_band_again_settles_after_its_return():
    late = first_order(0.2) + np.where((TIME > 2.0) & (TIME <= 2.5), 0.3, 0.0)[:, None]
    # Within the mean over 0.5 s, 0.3 m/s is over 0.05 m/s until a sixth of the window is left.
    settled = changing.step_response(late, 0.5, PART, DT).settling_time[0]
    assert settled == pytest.approx(2.5 + 0.25 - 0.5 / 6.0, abs=2 * DT)


def test_a_velocity_that_does_not_come_to_rest_has_not_settled():
    drifting = np.maximum(TIME, 0.0)[:, None]
    assert changing.step_response(drifting, 0.5, PART, DT).settling_time[0] == PART.after


def test_a_response_in_the_wrong_direction_or_too_small_is_not_followed():
    for end, followed in ((0.26, True), (0.24, False), (0.0, False), (-0.5, False)):
        answer = changing.step_response(first_order(0.2, 0.0, end), 0.5, PART, DT)
        assert answer.followed[0] == followed


def test_measures_of_a_stop():
    """Two robots stop with time constant 0.4 s, one of them falls afterwards; a third walks on."""
    speed = np.concatenate([first_order(0.4, 0.5, 0.0)] * 2 + [np.full((len(TIME), 1), 0.5)], axis=1)
    heading = math.radians(30.0)
    along = np.cumsum(speed, axis=0) * DT
    pose = np.zeros((len(TIME), 3, 7))
    pose[..., 0], pose[..., 1] = along * math.cos(heading), along * math.sin(heading)
    pose[..., 3], pose[..., 6] = math.cos(0.5 * heading), math.sin(0.5 * heading)
    valid = np.ones((len(TIME), 3), dtype=bool)
    valid[-20:, 1] = False
    rollout = synthetic_rollout(
        len(TIME), 3, velocity=np.stack([speed, 0 * speed], axis=-1), base_pose=pose, fell=falls(valid)
    )
    result = changing.step_measures(rollout, Change("emergency_stop", (0.5, 0.0), (0.0, 0.0)), PART)
    assert result["falls"]["mean"] == pytest.approx(1 / 3)
    assert result["followed"]["mean"] == pytest.approx(1 / 3)
    settled = changing.step_response(first_order(0.4, 0.5, 0.0), -0.5, PART, DT).settling_time[0]
    assert result["settling_time"]["mean"] == pytest.approx((settled + 2 * PART.after) / 3)
    assert result["score"] == pytest.approx((1.0 - settled / PART.after) / 3)
    # The integral of 0.5 exp(-t / 0.4) is 0.2 m; the sum of samples at the end of each step is one step's share less.
    walked_on = 0.5 * PART.after
    assert result["stopping_distance"]["mean"] == pytest.approx((0.2 + walked_on) / 2, abs=0.005)
    assert result["stopping_distance"]["count"] == 2


def test_a_change_of_both_velocities_has_settled_when_the_slower_one_has():
    forward, turning = first_order(0.2, 0.1, 0.5), first_order(0.6, 0.5, -0.5)
    rollout = synthetic_rollout(len(TIME), 1, velocity=np.stack([forward, turning], axis=-1))
    change = Change("diagonal", (0.1, 0.5), (0.5, -0.5))
    result = changing.step_measures(rollout, change, PART)
    slower = changing.step_response(turning, -1.0, PART, DT).settling_time[0]
    faster = changing.step_response(forward, 0.4, PART, DT).settling_time[0]
    assert slower > faster + 0.5
    assert result["settling_time"]["mean"] == pytest.approx(slower)
    assert "stopping_distance" not in result
    # If one velocity does not follow, the change is not followed.
    stuck = synthetic_rollout(len(TIME), 1, velocity=np.stack([forward, np.full_like(turning, 0.5)], axis=-1))
    assert changing.step_measures(stuck, change, PART)["followed"]["mean"] == 0.0
    assert changing.step_measures(stuck, change, PART)["score"] == 0.0


def test_score_is_the_mean_over_the_changes():
    _, score = PARTS["transients"]
    assert score({"a": {"score": 0.2}, "b": {"score": 0.6}}, PART) == pytest.approx(0.4)
