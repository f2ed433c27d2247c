"""A user's changes to a scripted gait."""

import math
import re

import numpy as np
import pytest
import twelve_joints

from quadruped_env import CommandedGait, QuadrupedError, SinusoidalGait
from quadruped_env.gait import PRESETS
from quadruped_env.gait.gait_settings import GaitSettings, edited

PHASES = (0.0, 0.25, 0.5, 0.75)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ((-0.001, 1.0, PHASES), "amplitude must be in [0, 2]; found -0.001"),
        ((2.001, 1.0, PHASES), "amplitude must be in [0, 2]; found 2.001"),
        ((math.nan, 1.0, PHASES), "amplitude: expected a number"),
        ((1.0, 0.099, PHASES), "frequency must be in [0.1, 6] (Hz); found 0.099"),
        ((1.0, 6.001, PHASES), "frequency must be in [0.1, 6] (Hz); found 6.001"),
        ((1.0, 1.0, (0.0, math.inf, 0.0, 0.0)), "phases must be 4 finite numbers"),
    ],
)
def test_settings_beyond_their_limits_are_refused(values, message):
    with pytest.raises(QuadrupedError, match=re.escape(message)):
        GaitSettings(*values)


@pytest.mark.parametrize("name", PRESETS)
def test_settings_of_a_gait_leave_it_unchanged(name):
    gait = SinusoidalGait.preset(name)
    settings = GaitSettings.of(gait)
    assert settings.amplitude == 1.0
    assert settings.frequency == pytest.approx(gait.angular_frequency / 6.283185307)
    assert all(0.0 <= phase < 1.0 for phase in settings.phases)
    times = np.linspace(0.0, 1.0, 7)
    np.testing.assert_allclose(edited(gait, settings).positions(times), gait.positions(times), atol=1e-12)


def test_settings_of_three_joints_per_leg_leave_a_gait_unchanged():
    """The roll joint has a phase of its own, and the leg's is the hip's before the knee."""
    robot = twelve_joints.robot()
    gait = CommandedGait.preset("tuned", robot).at((0.2, 0.1, 0.2))
    times = np.linspace(0.0, 1.0, 7)
    np.testing.assert_allclose(edited(gait, GaitSettings.of(gait)).positions(times), gait.positions(times), atol=1e-12)


def test_each_setting_changes_what_it_names():
    gait = SinusoidalGait.preset("trot")
    base = gait.positions(np.array([0.1]))[0]
    offset = edited(gait, GaitSettings(0.0, 2.0, PHASES)).positions(np.array([0.1]))[0]
    settings = GaitSettings.of(gait)
    twice = edited(gait, GaitSettings(2.0, settings.frequency, settings.phases))
    np.testing.assert_allclose(twice.positions(np.array([0.1]))[0] - offset, 2.0 * (base - offset), atol=1e-12)
    slower = edited(gait, GaitSettings(1.0, 0.5 * settings.frequency, settings.phases))
    np.testing.assert_allclose(slower.positions(np.array([0.2]))[0], base, atol=1e-12)
    # A leg that is a quarter of a cycle ahead is where it would be a quarter of the period later: hip and knee.
    second_leg_ahead = tuple(phase + 0.25 * (leg == 1) for leg, phase in enumerate(settings.phases))
    moved = edited(gait, GaitSettings(1.0, settings.frequency, second_leg_ahead)).positions(np.array([0.1]))[0]
    later = gait.positions(np.array([0.1 + 0.25 / settings.frequency]))[0]
    np.testing.assert_allclose(moved[2:4], later[2:4], atol=1e-12)
    np.testing.assert_allclose(np.delete(moved, [2, 3]), np.delete(base, [2, 3]), atol=1e-12)


def test_phases_are_one_per_leg():
    with pytest.raises(QuadrupedError, match="expected 4 phases, one per leg; found 3"):
        edited(SinusoidalGait.preset("trot"), GaitSettings(1.0, 1.0, PHASES[:3]))
