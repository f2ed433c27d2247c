"""The map of achieved over commanded velocities against hand-computed arrays."""

from dataclasses import replace

import numpy as np
import pytest

from quadruped_env.evaluation.suite import command_map
from quadruped_env.evaluation.suite.suite_definition import full_suite

PART = replace(
    full_suite().commands, forward_velocity=(-0.2, -0.1, 0.0, 0.1, 0.2, 0.4), yaw_rate=(-0.5, 0.0, 0.5), num_seeds=2
)
COMMANDS = np.array(PART.commands).reshape(6, 3, 1, 2)


def exact():
    """Episodes that reach their commands exactly (V, W, S, 2)."""
    return np.repeat(COMMANDS, 2, axis=2)


NO_FALLS = np.zeros((6, 3, 2), dtype=bool)


def test_a_robot_that_reaches_its_commands_has_no_error_and_no_dead_zone():
    result = command_map.summary(PART, exact(), NO_FALLS)
    assert result["met"]["mean"] == 1.0
    assert result["forward_velocity_error"]["largest"] == 0.0
    assert result["dead_zone"] == {"forwards": 0.0, "backwards": 0.0, "left": 0.0, "right": 0.0}
    assert result["met"]["mean"] == 1.0


def test_errors_are_signed_and_their_summary_is_that_of_the_means_over_seeds():
    achieved = exact()
    achieved[5, 1, :, 0] += [0.04, 0.02]  # 0.4 m/s gives 0.43 m/s
    achieved[0, 1, :, 0] += [-0.08, 0.08]  # opposite errors cancel in the mean, and each misses the tolerance
    achieved[3, 2, :, 1] -= 0.3
    result = command_map.summary(PART, achieved, NO_FALLS)
    forward = result["forward_velocity_error"]
    assert forward["signed"][5][1] == pytest.approx(0.03)
    assert forward["signed"][0][1] == pytest.approx(0.0)
    assert forward["mean"] == pytest.approx(0.03 / 18)
    assert forward["largest"] == pytest.approx(0.03)
    assert result["yaw_rate_error"]["signed"][3][2] == pytest.approx(-0.3)
    assert result["yaw_rate_error"]["largest"] == pytest.approx(0.3)
    assert result["met"]["mean"] == pytest.approx(1.0 - 4 / 36)
    assert result["met"]["count"] == 36


def test_an_episode_that_falls_or_has_no_velocity_does_not_meet_its_command():
    achieved, fallen = exact(), NO_FALLS.copy()
    fallen[2, 0, 0] = True  # after a while: it has a mean velocity
    fallen[2, 2] = True
    achieved[2, 2] = np.nan  # at once
    result = command_map.summary(PART, achieved, fallen)
    assert result["met"]["mean"] == pytest.approx(33 / 36)
    assert result["falls"]["mean"] == pytest.approx(3 / 36)
    assert result["forward_velocity_error"]["signed"][2][2] is None
    assert result["forward_velocity_error"]["mean"] == 0.0
    # The tolerances are 0.05 m/s and 0.1 rad/s.
    for error, met in (((0.049, -0.099), 36), ((0.051, 0.0), 34), ((0.0, 0.101), 34)):
        achieved = exact()
        achieved[1, 1] += error
        assert command_map.summary(PART, achieved, NO_FALLS)["met"]["mean"] == pytest.approx(met / 36)


def test_dead_zone_is_the_largest_command_of_which_less_than_half_is_reached():
    achieved = COMMANDS[:, :, 0].copy()
    achieved[3, 1, 0] = 0.049  # of 0.1 m/s
    achieved[0, 1, 0] = 0.2  # 0.2 m/s backwards goes forwards, and 0.1 m/s stands
    achieved[1, 1, 0] = 0.0
    achieved[2, 0, 1] = -0.26  # of 0.5 rad/s to the right: more than half
    achieved[2, 2, 1] = np.nan
    achieved[4, 0, 0] = 0.0  # a curve is not on the axis
    assert command_map.dead_zones(PART, achieved) == {"forwards": 0.1, "backwards": 0.2, "left": 0.5, "right": 0.0}


def mapped(achieved, fallen=NO_FALLS):
    """The map as `run` returns it."""
    return {
        "forward_velocity": list(PART.forward_velocity),
        "yaw_rate": list(PART.yaw_rate),
        "fall_share": fallen.mean(axis=-1).tolist(),
        **command_map.summary(PART, achieved, fallen),
    }


def test_envelope_ends_before_the_first_command_on_the_axis_that_is_missed():
    achieved, fallen = exact(), NO_FALLS.copy()
    whole = {"forwards": 0.4, "backwards": 0.2, "left": 0.5, "right": 0.5}
    assert command_map.envelope(mapped(achieved), PART.tolerance) == whole
    achieved[4, 1, :, 0] += 0.06  # 0.2 m/s is missed, and 0.4 m/s beyond it is met
    achieved[0, 1, :, 1] += 0.11  # 0.2 m/s backwards turns
    fallen[2, 0, 1] = True
    achieved[2, 2, :, 1] = np.nan
    achieved[3, 2, :, 0] = 0.0  # a curve is not on the axis
    found = command_map.envelope(mapped(achieved, fallen), PART.tolerance)
    assert found == {"forwards": 0.1, "backwards": 0.1, "left": 0.0, "right": 0.0}
