"""Parts of the suite with a fixed command, against hand-computed values and the simulated motion."""

import math
from dataclasses import replace

import numpy as np
import pytest
from synthetic import synthetic_rollout

from quadruped_env.evaluation.measures import meets
from quadruped_env.evaluation.suite import steady
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import PARTS, moving_and_standing
from quadruped_env.evaluation.suite.suite_definition import Disturbance, full_suite
from quadruped_env.policies import GaitController, ZeroController
from quadruped_env.task import TaskConfig

MAP = replace(
    full_suite().commands,
    axes={"forwards": ((0.1, 0.0), (0.2, 0.0), (0.4, 0.0)), "right": ((0.0, -0.2), (0.0, -0.5))},
    num_seeds=2,
)
REGULATION = replace(full_suite().regulation, commands=((0.3, 0.0), (-0.2, 0.0), (0.3, 0.5)))
KEPT = np.array(REGULATION.commands)[:, None]
COMMANDS = np.array([(-0.2, 0.3), (0.4, 0.0), (0.0, 0.0), (0.1, -0.8)])


def exact():
    """Episodes that reach their commands exactly (K, S, 2)."""
    return np.repeat(COMMANDS[:, None], 2, axis=1)


NONE, ALL = np.zeros((4, 2), dtype=bool), np.ones((4, 2), dtype=bool)


def met(achieved, fallen=NONE, still=ALL):
    return meets(achieved, COMMANDS[:, None], still, fallen, MAP.tolerance)


class TestCommandMap:
    def test_an_episode_meets_its_command_within_the_tolerance_without_a_fall(self):
        assert met(exact()).all()
        for error, expected in (((0.049, -0.099), True), ((-0.051, 0.0), False), ((0.0, 0.101), False)):
            achieved = exact()
            achieved[1] += error
            np.testing.assert_array_equal(met(achieved), [[True] * 2, [expected] * 2, [True] * 2, [True] * 2])
        fallen, achieved = NONE.copy(), exact()
        fallen[0, 1] = True  # after a while: it has a mean velocity
        achieved[3, 0] = np.nan  # at once
        np.testing.assert_array_equal(met(achieved, fallen).sum(axis=1), [1, 2, 2, 1])

    def test_a_command_to_stand_is_met_only_by_standing_still(self):
        np.testing.assert_array_equal(met(exact(), still=NONE).sum(axis=1), [2, 2, 0, 2])

    def test_standing_alone_earns_nothing_and_marching_loses_a_fifth(self):
        for moving, standing, expected in ((0.0, 1.0, 0.0), (1.0, 1.0, 1.0), (0.5, 0.0, 0.4)):
            result = {"moving": {"mean": moving}, "standing": {"mean": standing}}
            assert moving_and_standing(result, MAP) == pytest.approx(expected)

    def test_errors_are_signed_and_their_summary_is_that_of_the_means_over_seeds(self):
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

    def test_envelope_ends_before_the_first_command_on_the_axis_that_is_missed(self):
        kept = np.ones((5, 2), dtype=bool)
        assert steady.envelope(MAP, kept) == {"forwards": 0.4, "right": 0.5}
        kept[1, 1] = False  # 0.2 m/s is missed in one episode, and 0.4 m/s beyond it is met
        kept[3] = False
        assert steady.envelope(MAP, kept) == {"forwards": 0.1, "right": 0.0}


class TestRegulation:
    @pytest.mark.parametrize(
        ("error", "expected"),
        [
            ((0.0, 0.0), [1, 1, 1]),
            ((0.04, 0.1), [1, 1, 1]),  # 20 % of 0.2 m/s and of 0.5 rad/s
            ((0.06, -0.1), [1, 0, 1]),
            ((-0.061, 0.0), [0, 0, 0]),
            ((0.0, 0.101), [0, 0, 0]),
            ((math.nan, 0.0), [0, 0, 0]),
        ],
    )
    def test_kept_is_a_fifth_of_the_command_or_the_tolerance_where_it_is_zero(self, error, expected):
        fallen = np.zeros((3, 1), dtype=bool)
        np.testing.assert_array_equal(steady.keeps(REGULATION, KEPT + error, fallen)[:, 0], expected)
        assert not steady.keeps(REGULATION, KEPT + error, ~fallen).any()

    def test_score_is_the_mean_of_one_disturbance_and_of_all(self):
        part = replace(REGULATION, factors=(Disturbance("a"), Disturbance("b")))
        result = {
            "a": {"kept": {"mean": 0.2}},
            "b": {"kept": {"mean": 0.6}},
            "hard": {"kept": {"mean": 0.0}, "held": {"mean": 0.9}},
        }
        assert PARTS["regulation"][1](result, part) == pytest.approx(0.65)

    def test_all_disturbances_together_have_their_own_tolerance(self, monkeypatch):
        part = replace(REGULATION, commands=((0.3, 0.0),), factors=(Disturbance("nominal"),), together_seeds=1)
        rollout = synthetic_rollout(200, velocity=np.tile([0.38, 0.15], (200, 1, 1)))
        monkeypatch.setattr(steady, "regulated", lambda *_: rollout)
        result = steady.run_regulation(part, None)["hard"]
        assert (result["kept"]["mean"], result["held"]["mean"]) == (0.0, 1.0)

    @pytest.mark.parametrize("slope", [16.0, -16.0])
    def test_robots_stand_on_an_incline_as_on_its_plane(self, slope):
        """At rest on friction of 1.2 the tilt against gravity is the slope, nose up or down, and no robot falls."""
        part = replace(REGULATION, num_seeds=2, seconds=2.0)
        factor = Disturbance("slope", {"start_heading": 0.0, "friction": (1.2, 1.2)}, slope)
        standing = Candidate("standing", ZeroController(), TaskConfig())
        rollout = steady.regulated(part, standing, factor, part.seeds, part.seconds)
        assert not rollout.fallen.any()
        pitch = np.degrees(2.0 * np.arctan2(rollout.orientation[-1, :, 2], rollout.orientation[-1, :, 0]))
        np.testing.assert_allclose(pitch, -slope, atol=3.0)
        along = rollout.base_position[-1, :, 0]
        assert np.abs(along).max() < 0.2
        assert rollout.contact[-1].all()

    def test_measures_hold_the_signed_share_of_each_command(self):
        part = replace(
            REGULATION, num_seeds=2, seconds=4.0, commands=((0.3, 0.0), (-0.2, 0.0)), factors=(Disturbance("nominal"),)
        )
        part = replace(part, together=Disturbance("hard"), together_seeds=1, together_seconds=2.0)
        result = steady.run_regulation(part, Candidate("tuned", GaitController(), TaskConfig()))
        ahead, back = result["nominal"]["commands"]
        assert ahead["share"][0] == pytest.approx(ahead["velocity"][0] / 0.3)
        assert (ahead["share"][1], back["share"][1]) == (None, None)
        assert ahead["share"][0] == pytest.approx(1.0, abs=0.25)
        assert back["share"][0] == pytest.approx(1.0, abs=0.25)
        assert result["hard"]["held"]["count"] == 2
