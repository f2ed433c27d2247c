"""The gait clock whose frequency follows the command: phase in closed form, envs, policies, export and input."""

import math

import gymnasium
import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.control import CommandedFrequency, ControlConfig, ControlInterface
from quadruped_env.control.clock import frequency_at, frequency_of
from quadruped_env.control.controllers import GaitController
from quadruped_env.gait import CommandedGait
from quadruped_env.policies import Policy, load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import ActionConfig, TaskConfig

TABLE = {"speeds": [0.1, 0.3, 0.6], "frequencies": [2.0, 2.5, 4.0], "turn_arm": 0.5}
FOLLOWING = CommandedFrequency((0.1, 0.3, 0.6), (2.0, 2.5, 4.0), 0.5)
DT = 0.02
"""The same control step in ns."""


@pytest.mark.parametrize(
    ("command", "hertz"),
    [
        ((0.0, 0.0), 2.0),  # constant below the first speed
        ((0.1, 0.0), 2.0),
        ((0.2, 0.0), 2.25),
        ((-0.2, 0.0), 2.25),  # backwards as forwards
        ((0.3, 0.0), 2.5),
        ((0.45, 0.0), 3.25),
        ((0.0, 0.4), 2.25),  # 0.2 m/s on the arm of 0.5 m
        ((0.1, -0.2), 2.25),
        ((-0.25, 0.4), 3.25),
        ((0.6, 0.8), 4.0),  # constant above the last speed
    ],
)
def test_frequency_is_interpolated_at_the_commanded_speed(command, hertz):
    assert frequency_at(FOLLOWING, np.array([command])) == pytest.approx(hertz, abs=1e-12)


@pytest.mark.parametrize("mode", ["position", "residual"])
def test_phase_is_the_integral_of_the_commanded_frequencies(mode):
    """Each command holds for some steps: phase = start + 2 pi * sum of frequency * time."""
    config = ControlConfig(clock_frequency=FOLLOWING, action=ActionConfig(mode=mode))
    control = ControlInterface(MINI_QUADRUPED, config, 3)
    start = np.array([0.0, 1.0, 6.0])
    control.reset(np.arange(3), start)
    cycles = 2.0 * 0.02 * np.ones(3)
    control.advance()  # before any command, as at the command 0
    for command, steps, hertz in (
        ((0.45, 0.0), 31, 3.25),
        ((0.0, 0.4), 17, 2.25),
        ((0.0, 0.0), 5, 2.0),
        ((0.9, 0.0), 40, 4.0),
    ):
        control.reset(np.arange(3), control.phase.copy(), np.tile(command, (3, 1)))
        for _ in range(steps):
            control.advance()
        cycles += hertz * steps * DT
        np.testing.assert_allclose(np.exp(1j * control.phase), np.exp(1j * (start + math.tau * cycles)), atol=1e-9)
        assert ((control.phase >= 0) & (control.phase < math.tau)).all()
        if mode == "residual":
            # The scripted gait's phase, exactly: zero action is the gait at this phase.
            gait = CommandedGait.sinusoid(MINI_QUADRUPED, 3.0)  # the middle of the frequencies
            expected = gait.positions(control.phase, np.tile(command, (3, 1)))
            np.testing.assert_array_equal(control.nominal(), expected)
    control.reset(np.array([1]))
    control.advance()
    assert control.phase[1] == pytest.approx(math.tau * 2.0 * DT), "a reset forgets the command"


def test_reset_leaves_the_clock_and_the_gait_of_the_zero_command():
    control = ControlInterface(MINI_QUADRUPED, ControlConfig(action=ActionConfig(mode="residual")), 2)
    standing = CommandedGait.sinusoid(MINI_QUADRUPED, 3.4).positions(np.zeros(2), np.zeros((2, 2)))
    np.testing.assert_array_equal(control.nominal(), standing)
    control.set_command(np.arange(2), np.array([[0.4, 0.0], [0.4, 0.0]]))
    control.approach_requested()
    control.advance()
    control.reset(np.array([1]))
    np.testing.assert_array_equal(control.nominal()[1], standing[1])
    np.testing.assert_allclose(control.joint_target(np.zeros((2, 8)))[1], MINI_QUADRUPED.stance, atol=1e-12)
    assert np.abs(control.nominal()[0] - standing[0]).max() > 0.01


def following_policy():
    """The shipped network in a task whose clock follows the command."""
    policy = load_policy("flat")
    task = TaskConfig(clock_frequency=FOLLOWING, action=ActionConfig(mode="residual"))
    return Policy.for_task(policy.weights, policy.biases, policy.activation, task, {"timesteps": 1})


def test_policy_keeps_its_frequency_and_refuses_an_env_with_another(tmp_path):
    policy = following_policy()
    policy.save(tmp_path)
    loaded = load_policy(tmp_path)
    assert loaded.control.clock_frequency == loaded.config.clock_frequency == FOLLOWING
    env = loaded.make_env()
    assert env.unwrapped.task.config.clock_frequency == FOLLOWING
    loaded.check_env(env)
    other = gymnasium.make("MiniQuadruped-v0", action_mode="residual")
    with pytest.raises(QuadrupedError, match=r"trained with clock_frequency CommandedFrequency\(.* has 3\.4; make"):
        loaded.check_env(other)
    with pytest.raises(QuadrupedError, match=r"trained with clock_frequency 3\.4, .* has CommandedFrequency"):
        load_policy("flat").check_env(env)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (0.0, r"clock_frequency must be positive \(Hz\), at most .*, or a mapping with speeds and .*; found 0.0"),
        ("fast", r"clock_frequency must be positive .* found 'fast'"),
        ([2.2, 3.0], r"clock_frequency must be positive .* found \[2.2, 3.0\]"),
        (
            {"speeds": [0.0, 0.6]},
            r"config.clock_frequency: expected a frequency \(Hz\), or speeds and frequencies, .* found {'speeds'",
        ),
        ({**TABLE, "hertz": 1}, r"config.clock_frequency: expected a frequency \(Hz\), or .* found {"),
        ({**TABLE, "speeds": [0.3, 0.1, 0.6]}, r"clock_frequency.speeds must be 0 or more, and increasing \(m/s\)"),
        ({**TABLE, "speeds": [-0.1, 0.1, 0.6]}, r"clock_frequency.speeds must be 0 or more, and increasing"),
        ({**TABLE, "speeds": [0.0, 0.6]}, r"clock_frequency.frequencies must be as many as the speeds, 2; found"),
        ({**TABLE, "frequencies": [2.0, 0.0, 3.0]}, r"clock_frequency.frequencies must be positive \(Hz\)"),
        (
            {**TABLE, "frequencies": [2.0, math.nan, 3.0]},
            r"clock_frequency.frequencies must be a list of two or more num",
        ),
        ({**TABLE, "speeds": 0.3}, r"clock_frequency.speeds must be a list of two or more numbers, .*; found 0.3"),
        ({**TABLE, "turn_arm": -1.0}, r"clock_frequency.turn_arm must be 0 or more \(m\), .*; found -1.0"),
    ],
)
def test_bad_frequency_is_refused(value, message):
    for make in (frequency_of, lambda v: TaskConfig(clock_frequency=v), lambda v: TaskConfig.from_dict(as_field(v))):
        with pytest.raises(QuadrupedError, match=message):
            make(value)
    with pytest.raises(QuadrupedError, match=message):
        ControlConfig.of_task(as_field(value))


def as_field(value):
    return {"clock_frequency": value}


# --- the searched gait as a controller


@pytest.mark.parametrize("edited", [False, True])
def test_tuned_gait_steps_with_the_clock_of_its_frequency_as_in_residual_mode(edited):
    controller = GaitController(CommandedGait.tuned())
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


@pytest.mark.parametrize("frequency", [5.0, FOLLOWING])
def test_tuned_gait_keeps_its_frequency_with_another_clock(frequency):
    control = ControlInterface(MINI_QUADRUPED, ControlConfig(clock_frequency=frequency))
    control.reset(np.array([0]), 2.0, np.array([[0.3, 0.2]]))
    for _ in range(40):
        control.advance()
    gait = CommandedGait.tuned()
    expected = gait.positions(gait.angular_frequency * control.time, control.command)
    np.testing.assert_allclose(GaitController().act(None, control), expected, atol=1e-9)
