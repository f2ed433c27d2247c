"""The trot in closed form: its formula, written again, and its scaling to a robot of half the size."""

import dataclasses
import math

import half_robot
import numpy as np
import pytest

from quadruped_env import CommandedGait
from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import ActionConfig

LEG_LENGTH, HALF_TRACK, LIFT = 0.1837533, 0.1, 0.2
STANCE = (0.6, -0.72)
LEGS = [(0.0, -1.0), (0.5, 1.0), (0.5, -1.0), (0.0, 1.0)]
"""Phase in cycles and side of each leg: LF, RF, LH, RH."""


def formula(phase, command, frequency):
    """Joint positions (8,) at a phase in rad, for a velocity (m/s) and a yaw rate (rad/s)."""
    velocity, yaw_rate = command
    turn = math.copysign(math.sqrt(0.8 * min(abs(yaw_rate), 0.8)), yaw_rate)
    size = min(1.0, max(abs(velocity) / 0.05, abs(yaw_rate) / 0.15))
    joints = []
    for start, side in LEGS:
        p = phase + math.tau * start
        u = velocity + side * 4.0 * HALF_TRACK * turn
        hip = LIFT / math.tau + u / (2.8 * frequency * LEG_LENGTH) * math.cos(p) + LIFT / 4.0 * math.sin(p)
        knee = -LIFT / math.pi - LIFT / 2.0 * math.sin(p)
        joints += [STANCE[0] + size * hip, STANCE[1] + size * knee]
    return joints


def samples(count=200):
    rng = np.random.default_rng(0)
    commands = rng.uniform((-0.9, -1.2), (0.9, 1.2), (count, 2))
    commands[:40] *= 0.05  # steps that fade
    commands[40:50, 0], commands[50:60, 1], commands[60] = 0.0, 0.0, 0.0
    return rng.uniform(0.0, math.tau, count), commands


@pytest.mark.parametrize("frequency", [2.2, 3.4, 5.0])
def test_positions_are_the_formula_at_random_phases_and_commands(frequency):
    phases, commands = samples()
    gait = CommandedGait.preset("sinusoid", MINI_QUADRUPED, frequency)
    expected = [formula(*sample, frequency) for sample in zip(phases, commands, strict=True)]
    np.testing.assert_allclose(gait.positions(phases, commands), expected, rtol=0, atol=1e-9)
    assert gait.angular_frequency == pytest.approx(math.tau * frequency)


def test_feet_swing_forwards_in_the_air_and_push_backwards_on_the_ground():
    """Of each leg, in the half of its cycle in which the clock is positive; the other way round when backwards."""
    gait = CommandedGait.preset("sinusoid", MINI_QUADRUPED, 3.4)
    for speed in (0.3, -0.3):
        for leg, (start, _) in enumerate(LEGS):
            angles = np.linspace(0.0, math.tau, 100, endpoint=False)
            joints = gait.positions(angles - math.tau * start, np.tile((speed, 0.0), (100, 1)))
            feet = MINI_QUADRUPED.skeleton.foot_centres(joints)[:, leg]
            forwards = np.gradient(feet[:, 0], angles)
            swings = np.sin(angles) > 0.3
            stands = np.sin(angles) < -0.3
            assert (forwards[swings] * speed > 0.0).all()
            assert (forwards[stands] * speed < 0.0).all()
            assert feet[swings, 2].mean() > feet[stands, 2].mean() + 0.002


def test_robot_of_half_the_size_has_the_same_joint_angles_at_similar_commands():
    """The built-in robot by another name: its own gait is in closed form."""
    root = half_robot.TIME
    phases, commands = samples()
    full = CommandedGait.preset("sinusoid", dataclasses.replace(MINI_QUADRUPED, name="twin"), 3.4)
    half = CommandedGait.preset("sinusoid", half_robot.ROBOT, 3.4 / root)
    scaled = commands * (root, 1.0 / root)
    np.testing.assert_allclose(half.positions(phases, scaled), full.positions(phases, commands), rtol=0, atol=1e-5)
    assert half.angular_frequency == pytest.approx(full.angular_frequency / root)
    # Not at the same commands.
    assert np.abs(half.positions(phases, commands) - full.positions(phases, commands)).max() > 0.05


def test_residual_mode_takes_the_strides_of_its_clock():
    command, phase = np.array([[0.4, -0.3]]), 1.3
    config = ControlConfig(clock_frequency=2.7, action=ActionConfig(mode="residual"))
    control = ControlInterface(MINI_QUADRUPED, config)
    control.reset(np.array([0]), phase, command)
    np.testing.assert_allclose(control.nominal()[0], formula(phase, command[0], 2.7), rtol=0, atol=1e-9)
