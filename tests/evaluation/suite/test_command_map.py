"""The map of achieved over commanded velocities, and the envelope, against hand-computed arrays."""

from dataclasses import replace

import numpy as np
import pytest

from quadruped_env.evaluation.measures import meets
from quadruped_env.evaluation.suite import steady
from quadruped_env.evaluation.suite.suite import moving_and_standing
from quadruped_env.evaluation.suite.suite_definition import full_suite

PART = replace(
    full_suite().commands,
    axes={"forwards": ((0.1, 0.0), (0.2, 0.0), (0.4, 0.0)), "right": ((0.0, -0.2), (0.0, -0.5))},
    num_seeds=2,
)
COMMANDS = np.array([(-0.2, 0.3), (0.4, 0.0), (0.0, 0.0), (0.1, -0.8)])


def exact():
    """Episodes that reach their commands exactly (K, S, 2)."""
    return np.repeat(COMMANDS[:, None], 2, axis=1)


NONE, ALL = np.zeros((4, 2), dtype=bool), np.ones((4, 2), dtype=bool)


def met(achieved, fallen=NONE, still=ALL):
    return meets(achieved, COMMANDS[:, None], still, fallen, PART.tolerance)


def test_an_episode_meets_its_command_within_the_tolerance_without_a_fall():
    assert met(exact()).all()
    for error, expected in (((0.049, -0.099), True), ((-0.051, 0.0), False), ((0.0, 0.101), False)):
        achieved = exact()
        achieved[1] += error
        np.testing.assert_array_equal(met(achieved), [[True] * 2, [expected] * 2, [True] * 2, [True] * 2])
    fallen, achieved = NONE.copy(), exact()
    fallen[0, 1] = True  # after a while: it has a mean velocity
    achieved[3, 0] = np.nan  # at once
    np.testing.assert_array_equal(met(achieved, fallen).sum(axis=1), [1, 2, 2, 1])


def test_a_command_to_stand_is_met_only_by_standing_still():
    np.testing.assert_array_equal(met(exact(), still=NONE).sum(axis=1), [2, 2, 0, 2])


def test_standing_alone_earns_nothing_and_marching_loses_a_fifth():
    for moving, standing, expected in ((0.0, 1.0, 0.0), (1.0, 1.0, 1.0), (0.5, 0.0, 0.4)):
        result = {"moving": {"mean": moving}, "standing": {"mean": standing}}
        assert moving_and_standing(result, PART) == pytest.approx(expected)


def test_errors_are_signed_and_their_summary_is_that_of_the_means_over_seeds():
    achieved = exact()
    achieved[1, :, 0] += [0.04, 0.02]  # 0.4 m/s gives 0.43 m/s
    achieved[0, :, 0] += [-0.08, 0.08]  # opposite errors cancel in the mean, and each misses the tolerance
    achieved[3, :, 1] -= 0.3
    achieved[2, 0] = np.nan
    result = steady.summary(COMMANDS, achieved, NONE, met(achieved))
    forward = result["forward_velocity_error"]
    np.testing.assert_allclose(forward["signed"], [0.0, 0.03, 0.0, 0.0], atol=1e-12)
    assert forward["mean"] == pytest.approx(0.03 / 4)
    assert forward["largest"] == pytest.approx(0.03)
    assert result["yaw_rate_error"]["signed"][3] == pytest.approx(-0.3)
    assert (result["met"]["mean"], result["met"]["count"]) == (pytest.approx(3 / 8), 8)
    achieved[2] = np.nan
    unknown = steady.summary(COMMANDS, achieved, NONE, met(achieved))
    assert unknown["forward_velocity_error"]["signed"][2] is None


def test_envelope_ends_before_the_first_command_on_the_axis_that_is_missed():
    kept = np.ones((5, 2), dtype=bool)
    assert steady.envelope(PART, kept) == {"forwards": 0.4, "right": 0.5}
    kept[1, 1] = False  # 0.2 m/s is missed in one episode, and 0.4 m/s beyond it is met
    kept[3] = False
    assert steady.envelope(PART, kept) == {"forwards": 0.1, "right": 0.0}
