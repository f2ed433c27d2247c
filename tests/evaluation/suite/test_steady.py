"""Parts of the suite with a fixed command, against hand-computed values and the simulated motion."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from synthetic import synthetic_rollout

from quadruped_env.evaluation.measures import reached
from quadruped_env.evaluation.suite import steady
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.changing import moving_and_standing
from quadruped_env.evaluation.suite.suite_definition import Disturbance, full_suite
from quadruped_env.policies import GaitController, ZeroController
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import Task, TaskConfig

MAP = replace(
    full_suite().commands,
    axes={"forwards": ((0.1, 0.0), (0.2, 0.0), (0.4, 0.0)), "right": ((0.0, -0.2), (0.0, -0.5))},
    num_seeds=2,
)
REGULATION = replace(full_suite().regulation, commands=((0.3, 0.0), (-0.2, 0.0), (0.3, 0.5)))
KEPT = np.array(REGULATION.commands)
COMMANDS = np.array([(-0.2, 0.3), (0.4, 0.0), (0.0, 0.0), (0.1, -0.8)])


def judged(achieved, fallen=(), marching=()):
    """`reached` of robots with constant velocities (N, 2) under `COMMANDS`; some fall at the end, or do not stand."""
    steps, count = 200, len(achieved)
    fell, joints = np.zeros((steps, count), bool), np.zeros((steps, count, 8))
    fell[-1, list(fallen)] = True
    joints[:, list(marching)] = 1.0
    velocity = np.tile(np.asarray(achieved, float), (steps, 1, 1))
    rollout = synthetic_rollout(steps, count, velocity=velocity, fell=fell, joint_velocity=joints)
    return reached(rollout, COMMANDS[:count], MAP.tolerance)


class TestAccuracy:
    @pytest.mark.parametrize(
        ("command", "error", "met", "closely", "accuracy"),
        [
            ((0.4, 0.0), (0.039, -0.049), 1, 1, 1.0),  # a tenth of 0.4 m/s; 0.05 rad/s
            ((0.4, 0.0), (0.041, 0.0), 1, 0, 0.059 / 0.06),
            ((0.1, 0.0), (-0.019, 0.0), 1, 1, 1.0),  # 0.02 m/s, which is more than a tenth
            ((0.1, 0.0), (-0.049, 0.0), 1, 0, 0.051 / 0.08),
            ((0.1, 0.0), (-0.051, 0.0), 0, 0, 0.049 / 0.08),
            ((0.6, 0.0), (0.051, 0.0), 0, 0, 0.049 / 0.05),  # a tenth, but not met
            ((0.1, -0.8), (0.0, 0.079), 1, 1, 1.0),
            ((0.1, -0.8), (0.0, 0.099), 1, 0, 0.101 / 0.12),
            ((0.1, -0.8), (0.0, 0.101), 0, 0, 0.099 / 0.12),
            ((0.1, -0.8), (0.06, 0.14), 0, 0, 0.5),  # of the worse velocity, which are equal here
            ((0.1, -0.8), (0.101, 0.0), 0, 0, 0.0),
            ((0.1, -0.8), (0.0, -0.201), 0, 0, 0.0),
        ],
    )
    def test_commands_are_met_closely_met_or_missed(self, command, error, met, closely, accuracy):
        rollout = synthetic_rollout(200, velocity=np.tile(np.add(command, error), (200, 1, 1)))
        found = reached(rollout, [command], MAP.tolerance)
        assert (found.met[0], found.closely[0]) == (met, closely)
        assert found.accuracy[0] == pytest.approx(accuracy, abs=1e-5)

    def test_three_quarters_of_every_command_are_not_close_and_earn_little(self):
        """What a robot earns that always does a share of what is asked, over the commands of the map."""
        drawn = np.array(full_suite().commands.drawn[:248])
        found = [MAP.tolerance.accuracy((share - 1.0) * drawn, drawn).mean() for share in (1.0, 0.9, 0.75, 0.5)]
        assert found[:2] == [1.0, pytest.approx(1.0, abs=0.02)]  # above 0.5 m/s a tenth is not met
        assert 0.3 < found[2] < 0.4
        assert found[3] < 0.1

    def test_nothing_is_met_after_a_fall_or_without_a_velocity(self):
        achieved = COMMANDS.copy()
        achieved[3] = math.nan
        found = judged(achieved, fallen=[0])
        for values in found[1:]:
            np.testing.assert_array_equal(values, [0, 1, 1, 0])

    def test_a_command_to_stand_is_met_only_by_standing_still(self):
        for values in judged(COMMANDS, marching=[0, 1, 2, 3])[1:]:
            np.testing.assert_array_equal(values, [1, 1, 0, 1])

    def test_standing_alone_earns_nothing_and_marching_loses_a_fifth(self):
        for moving, standing, expected in ((0.0, 1.0, 0.0), (1.0, 1.0, 1.0), (0.5, 0.0, 0.4)):
            found = moving_and_standing(np.full((2, 3), moving), np.full(4, standing))
            assert found == pytest.approx([expected] * 6)


class TestCommandMap:
    def test_errors_are_signed_and_their_summary_is_over_the_means_of_the_seeds(self):
        achieved = np.repeat(COMMANDS[:, None], 2, axis=1)
        achieved[1, :, 0] += [0.04, 0.02]  # 0.4 m/s gives 0.43 m/s
        achieved[0, :, 0] += [-0.08, 0.08]  # opposite errors cancel in the mean
        achieved[3, :, 1] -= 0.3
        achieved[2, 0] = np.nan
        result = steady.signed_errors(COMMANDS, achieved)
        forward = result["forward_velocity_error"]
        np.testing.assert_allclose(forward["signed"], [0.0, 0.03, 0.0, 0.0], atol=1e-12)
        assert forward["mean"] == pytest.approx(0.03 / 4)
        assert forward["largest"] == pytest.approx(0.03)
        assert result["yaw_rate_error"]["signed"][3] == pytest.approx(-0.3)
        achieved[2] = np.nan
        assert steady.signed_errors(COMMANDS, achieved)["forward_velocity_error"]["signed"][2] is None

    def test_map_counts_the_drawn_commands_and_leaves_the_axes_to_the_envelope(self):
        part = replace(MAP, points=3, standing=1, seconds=3.0)
        given = [*part.drawn, *(command for axis in part.axes.values() for command in axis)]

        def run(commands, seeds, seconds, progress):
            """All do what they are asked to do, but one robot under the first command, and all to the right."""
            velocity = np.repeat(commands, 2, axis=0).astype(float)
            velocity[0] += 0.045, 0.0
            velocity[-4:] = 0.0
            return synthetic_rollout(150, len(velocity), velocity=np.tile(velocity, (150, 1, 1)))

        found = steady.run_command_map(part, SimpleNamespace(run=run))
        assert found["commands"] == [list(command) for command in given[:4]]
        assert (found["met"]["mean"], found["met"]["count"], found["met_closely"]["mean"]) == (1.0, 8, 7 / 8)
        assert found["envelope"] == {"forwards": 0.4, "right": 0.0}
        assert found["standing"]["count"] == 2
        near = max(0.02, 0.1 * abs(given[0][0]))
        assert found["contributions"] == pytest.approx([(0.1 - 0.045) / (0.1 - near), *[1.0] * 5], abs=1e-5)

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
        fallen = np.zeros(3, dtype=bool)
        np.testing.assert_array_equal(steady.keeps(REGULATION, KEPT + error, fallen), expected)
        assert not steady.keeps(REGULATION, KEPT + error, ~fallen).any()

    def test_one_disturbance_at_a_time_counts_as_much_as_all_together(self, monkeypatch):
        factors = (Disturbance("a"), Disturbance("b"))
        part = replace(REGULATION, commands=((0.3, 0.0),), factors=factors, num_seeds=2, together_seeds=5)

        def regulated(part, candidate, factor, seeds, seconds, progress):
            """Kept but for one episode with b; half way from 0.03 to 0.1 m/s with all of them, which is not kept."""
            velocity = np.tile([0.3, 0.0], (200, len(seeds), 1))
            velocity[:, :, 0] += 0.065 * (factor.name == "hard")
            velocity[:, 0, 1] += 0.2 * (factor.name == "b")
            return synthetic_rollout(200, len(seeds), velocity=velocity)

        monkeypatch.setattr(steady, "regulated", regulated)
        result = steady.run_regulation(part, None)
        kept = {name: entry["kept"]["mean"] for name, entry in result["disturbances"].items()}
        assert kept == {"a": 1.0, "b": 0.5, "hard": 0.0}
        assert result["disturbances"]["hard"]["accuracy"]["mean"] == pytest.approx(0.5, abs=1e-5)
        assert len(result["contributions"]) == 4 + 5
        assert np.mean(result["contributions"]) == pytest.approx(0.5 * (0.75 + 0.5), abs=1e-5)

    def test_latency_delays_the_motors_of_every_episode(self):
        """Two joint targets of a robot that stands up to a latency of 60 ms later than one without."""
        (late,) = (factor for factor in full_suite().regulation.factors if factor.name == "latency_60_ms")
        config = Candidate("standing", ZeroController(), TaskConfig()).task([(0.3, 0.0)], late.randomization)
        task = Task(BatchSimulation(config.compiled_model(), 3), config)
        task.reset(np.arange(3), [1_600_000, 1_600_001, 1_600_002])
        np.testing.assert_allclose(task.simulation.model_field("actuator_delay") - config.motor.delay, 0.06)

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
        ahead, back = result["disturbances"]["nominal"]["commands"]
        assert ahead["share"][0] == pytest.approx(ahead["velocity"][0] / 0.3)
        assert (ahead["share"][1], back["share"][1]) == (None, None)
        assert ahead["share"][0] == pytest.approx(1.0, abs=0.25)
        assert back["share"][0] == pytest.approx(1.0, abs=0.25)
        assert result["disturbances"]["hard"]["accuracy"]["count"] == 2
