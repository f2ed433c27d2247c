"""The gait clock: phase in closed form, the gait of residual mode on it, and a searched gait as a controller."""

import math

import numpy as np
import pytest

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.controllers import GaitController
from quadruped_env.gait import CommandedGait
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import ActionConfig


@pytest.mark.parametrize("mode", ["position", "residual"])
def test_phase_is_the_start_plus_the_clocks_cycles(mode):
    control = ControlInterface(MINI_QUADRUPED, ControlConfig(clock_frequency=2.7, action=ActionConfig(mode=mode)), 3)
    start, command = np.array([0.0, 1.0, 6.0]), np.tile((0.45, -0.3), (3, 1))
    control.reset(np.arange(3), start, command)
    for step in range(1, 60):
        control.advance()
        expected = start + math.tau * 2.7 * 0.02 * step
        np.testing.assert_allclose(np.exp(1j * control.phase), np.exp(1j * expected), atol=1e-9)
        assert ((control.phase >= 0) & (control.phase < math.tau)).all()
    if mode == "residual":
        # Zero action is the gait at this phase, exactly.
        gait = CommandedGait.preset("sinusoid", MINI_QUADRUPED, 2.7)
        np.testing.assert_array_equal(control.nominal(), gait.positions(control.phase, command))


def test_reset_leaves_the_clock_and_the_gait_of_the_zero_command():
    control = ControlInterface(MINI_QUADRUPED, ControlConfig(action=ActionConfig(mode="residual")), 2)
    standing = CommandedGait.preset("sinusoid", MINI_QUADRUPED, 3.4).positions(np.zeros(2), np.zeros((2, 2)))
    np.testing.assert_array_equal(control.nominal(), standing)
    control.set_command(np.arange(2), np.array([[0.4, 0.0], [0.4, 0.0]]))
    control.approach_requested()
    control.advance()
    control.reset(np.array([1]))
    np.testing.assert_array_equal(control.nominal()[1], standing[1])
    np.testing.assert_allclose(control.joint_target(np.zeros((2, 8)))[1], MINI_QUADRUPED.stance, atol=1e-12)
    assert np.abs(control.nominal()[0] - standing[0]).max() > 0.01


@pytest.mark.parametrize("edited", [False, True])
def test_tuned_gait_steps_with_the_clock_of_its_frequency_as_in_residual_mode(edited):
    controller = GaitController(CommandedGait.preset("tuned"))
    if edited:
        controller.settings = controller.settings
    residual = ControlInterface(MINI_QUADRUPED, ControlConfig(action=ActionConfig(mode="residual", gait="tuned")))
    control = ControlInterface(MINI_QUADRUPED, ControlConfig())
    for start in (2.0, 5.5):
        for each in (control, residual):
            each.reset(np.array([0]), start, np.array([[0.3, 0.2]]))
        for _ in range(40):
            control.advance()
            residual.advance()
            np.testing.assert_allclose(controller.act(None, control), residual.nominal(), atol=1e-9)


def test_tuned_gait_keeps_its_frequency_with_another_clock():
    control = ControlInterface(MINI_QUADRUPED, ControlConfig(clock_frequency=5.0))
    control.reset(np.array([0]), 2.0, np.array([[0.3, 0.2]]))
    for _ in range(40):
        control.advance()
    gait = CommandedGait.preset("tuned")
    expected = gait.positions(gait.angular_frequency * control.time, control.command)
    np.testing.assert_allclose(GaitController().act(None, control), expected, atol=1e-9)
