"""Commands that change at any time: their law, and falls, errors and windows against hand-computed arrays."""

from dataclasses import replace

import numpy as np
import pytest
from synthetic import DT, falls, synthetic_rollout

from quadruped_env.evaluation.suite import changing
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite_definition import Disturbance, full_suite
from quadruped_env.policies import ZeroController
from quadruped_env.task import TaskConfig

PART = full_suite().joystick
STEPS = 1000


def given(*pieces):
    """Commands (T, 1, 2) of pieces (control steps, forward velocity, yaw rate)."""
    return np.concatenate([np.tile([v, w], (steps, 1, 1)) for steps, v, w in pieces])


def test_schedules_hold_each_command_and_have_every_kind():
    commands = np.concatenate([changing.schedule(PART, seed, DT) for seed in PART.seeds])
    single = changing.schedule(PART, PART.first_seed, DT)
    assert single.shape == (3000, 2)
    np.testing.assert_array_equal(single, changing.schedule(PART, PART.first_seed, DT))
    held = np.diff(np.flatnonzero((np.diff(single, axis=0) != 0.0).any(axis=1)))
    assert held.min() >= 25
    # Two commands to stand in a row look like one that is held longer.
    assert np.quantile(held, 0.9) <= 200
    assert (np.abs(commands - (0.15, 0.0)) <= np.array([0.45, 0.8]) + 1e-12).all()
    assert (~commands.any(axis=1)).mean() == pytest.approx(0.15, abs=0.03)
    ends = np.isin(commands[:, 0], (-0.3, 0.0, 0.6)) & np.isin(commands[:, 1], (-0.8, 0.0, 0.8)) & commands.any(axis=1)
    # A fifth, and most of those that reverse them.
    assert ends.mean() == pytest.approx(0.24, abs=0.03)
    change = np.flatnonzero((np.diff(commands, axis=0) != 0.0).any(axis=1))
    reversals = (commands[change + 1, 1] == -commands[change, 1]) & (commands[change, 1] != 0.0)
    assert reversals.mean() == pytest.approx(0.15, abs=0.05)


def test_error_is_that_of_the_mean_of_each_stretch_after_the_allowance():
    command = given((200, 0.3, 0.0), (30, 0.0, 0.5), (270, -0.2, 0.0))
    velocity = command.copy()
    velocity[:200, 0, 0] += 0.04 * (-1.0) ** np.arange(200)  # the oscillation within a stride is no error
    velocity[200:230] = 9.0  # held for 0.6 s: what is left after the allowance is shorter than a stride
    velocity[230:255] = 9.0  # within the allowance
    velocity[255:, 0, 0] += 0.1
    valid = np.ones((500, 1), dtype=bool)
    valid[400:] = False
    error = changing.stretch_errors(velocity, command, valid, PART, DT)[:, 0]
    counted = np.isfinite(error[:, 0])
    np.testing.assert_array_equal(np.flatnonzero(counted), [*range(25, 200), *range(255, 400)])
    np.testing.assert_allclose(error[25:200], 0.0, atol=1e-3)
    np.testing.assert_allclose(error[255:400], [[0.1, 0.0]] * 145, atol=1e-12)


def test_windows_with_a_fall_or_a_large_error_are_not_met():
    error = np.zeros((STEPS, 3, 2))
    error[250:500, 0, 0] = -0.11
    error[500:600, 1] = 0.2, -0.4  # a mean of 0.08 m/s and 0.16 rad/s over the window
    error[500:750, 2] = np.nan
    valid = np.ones((STEPS, 3), dtype=bool)
    valid[760:, 0] = False
    found = changing.met_windows(error, valid, PART, DT)
    np.testing.assert_array_equal(found.T, [[1, 0, 1, 0], [1, 1, 1, 1], [1, 1, 0, 1]])


def test_falls_per_hour_count_the_time_until_each_fall():
    command = np.repeat(given((STEPS, 0.3, 0.0)), 3, axis=1)
    valid = np.ones((STEPS, 3), dtype=bool)
    valid[500:, 1] = False
    result = changing.joystick_measures(
        synthetic_rollout(STEPS, 3, velocity=command.copy(), fell=falls(valid)), command, PART
    )
    assert (result["falls"], result["robot_hours"]) == (1, pytest.approx(50.0 / 3600.0))
    assert result["falls_per_hour"]["mean"] == pytest.approx(72.0)
    assert result["mean_error"] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert result["windows_met"]["mean"] == pytest.approx(10 / 12)


def test_standing_meets_no_window_that_counts():
    command = given((500, 0.05, 0.1), (500, 0.3, 0.0))
    result = changing.joystick_measures(synthetic_rollout(STEPS, velocity=np.zeros((STEPS, 1, 2))), command, PART)
    assert (result["windows_met"]["mean"], result["windows_met"]["count"]) == (0.0, 2)


def test_robots_get_their_own_commands_when_they_change():
    requested = []

    class Recorder(ZeroController):
        def act(self, observation, control):
            requested.append(control.requested.copy())
            return super().act(observation, control)

    part = replace(PART, num_seeds=3, seconds=4.0, laws=(Disturbance("undisturbed"),))
    result = changing.run_joystick(part, Candidate("standing", Recorder(), TaskConfig()))
    expected = np.stack([changing.schedule(part, seed, DT) for seed in part.seeds], axis=1)
    np.testing.assert_array_equal(requested, expected)
    assert result["undisturbed"]["robot_hours"] == pytest.approx(12.0 / 3600.0)
    assert result["undisturbed"]["windows_met"]["count"] == 0
