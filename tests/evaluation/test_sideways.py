"""The lateral velocity of a robot that moves sideways in measures, verdict and suite, by hand-computed arrays."""

import math
from dataclasses import replace

import numpy as np
import pytest
from suites import tiny_suite
from synthetic import DT, synthetic_rollout
from tasks import random_readings
from twelve_joints import ROBOT

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.comparison import Comparison, run
from quadruped_env.evaluation.conditions import (
    COMMANDS,
    SIDEWAYS,
    commands_for,
    evaluation_task,
    motion_of,
    words,
)
from quadruped_env.evaluation.learning_gain import table_note
from quadruped_env.evaluation.measures import CLOSE, METRICS, measure, metrics_of, own_commands_met, tolerances
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.evaluation.suite import changing, steady
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import run_suite
from quadruped_env.evaluation.suite.suite_definition import for_robot, full_suite, quick_suite, with_velocities
from quadruped_env.evaluation.trace import measured
from quadruped_env.evaluation.verdict import reached_share, verdict, worst_episodes
from quadruped_env.policies import ZeroController
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.units import scale_of
from quadruped_env.task import TaskConfig

UNIT = scale_of("m/s", ROBOT)
LEFT, RIGHT, AHEAD, STAND = (0.0, 0.0, 0.2), (0.0, 0.0, -0.2), (0.5, 0.0, 0.0), (0.0, 0.0, 0.0)
TASK = TaskConfig().for_robot(ROBOT)
SUITE = with_velocities(full_suite(), ROBOT)


def rollout(velocity, command, **changes):
    """Rollout of 4 s of robots with constant velocities and commands (N, 3)."""
    steps, (envs, _) = 200, np.shape(velocity)
    values = {
        "joint_position": np.tile(ROBOT.stance, (steps, envs, 1)),
        "joint_velocity": np.zeros((steps, envs, 12)),
        "joint_torque": np.zeros((steps, envs, 12)),
        "velocity": np.tile(velocity, (steps, 1, 1)),
        "command": np.tile(command, (steps, 1, 1)),
        **changes,
    }
    return synthetic_rollout(steps, envs, ROBOT, **values)


class TestConditions:
    def test_a_command_to_the_side_is_sideways_unless_it_turns(self):
        commands = (AHEAD, STAND, (-0.2, 0.0, 0.0), (0.0, 0.5, 0.1), LEFT, (0.3, 0.0, -0.1), (0.3, 0.0, 0.01))
        assert [motion_of(command, ROBOT) for command in commands] == [
            "forwards", "standing", "backwards", "turning", "sideways", "sideways", "forwards",
        ]  # fmt: skip
        assert motion_of((0.3, 0.0), ROBOT) == "forwards"

    def test_words_name_the_side(self):
        assert words(LEFT) == "0.2 m/s to the left"
        assert words((0.3, 0.0, -0.15)) == "0.3 m/s and 0.15 m/s to the right"
        assert (words((0.3, -0.5)), words(STAND), words((0.0, 0.0))) == ("0.3 m/s and -0.5 rad/s", "stand", "stand")

    def test_default_commands_go_on_with_the_lateral_ones_in_the_units_of_the_robot(self):
        own = np.array(commands_for(ROBOT))
        units = [scale_of(unit, ROBOT) for unit in ("m/s", "rad/s", "m/s")]
        expected = np.array([*((*command, 0.0) for command in COMMANDS), *SIDEWAYS]) * units
        np.testing.assert_allclose(own, expected, rtol=0, atol=0.005 + 1e-9)
        assert commands_for(MINI_QUADRUPED) == list(COMMANDS)

    def test_ranges_of_the_task_include_lateral_commands(self):
        task = evaluation_task(TASK, [(0.5, 0.0), (0.0, 0.0, -0.9)], "none").command
        assert task.lateral_velocity == (-0.9, TASK.command.lateral_velocity[1])
        assert task.yaw_rate == TASK.command.yaw_rate


class TestMeasures:
    def test_velocities_are_forward_yaw_rate_and_to_the_left(self):
        readings = random_readings(np.random.default_rng(0), 3)
        linear, angular = readings.linear_velocity_b, readings.angular_velocity_b
        expected = np.stack([linear[:, 0], angular[:, 2], linear[:, 1]], axis=1)
        np.testing.assert_array_equal(measured(ROBOT, readings)["velocity"], expected)
        np.testing.assert_array_equal(measured(MINI_QUADRUPED, readings)["velocity"], expected[:, :2])

    def test_lateral_velocity_and_its_error_by_hand(self):
        values = measure(rollout([(0.1, 0.2, 0.15), (0.1, 0.2, -0.05)], [(0.1, 0.0, 0.2), (0.0, 0.2, 0.1)]))
        np.testing.assert_allclose(values["lateral_velocity"], [0.15, -0.05])
        np.testing.assert_allclose(values["lateral_velocity_error"], [0.05, 0.15])
        np.testing.assert_allclose(values["forward_velocity_error"], [0.0, 0.1], atol=1e-12)
        np.testing.assert_allclose(values["yaw_rate_error"], [0.2, 0.0], atol=1e-12)
        assert values.keys() <= metrics_of(ROBOT).keys() == METRICS.keys()

    def test_a_command_is_met_only_with_its_lateral_velocity(self):
        allowed = tolerances(CLOSE, ROBOT)
        assert allowed == pytest.approx((0.05 * UNIT, 0.1 * scale_of("rad/s", ROBOT), 0.05 * UNIT), rel=1e-2)
        error = allowed[0] + np.array([-0.004, 0.004])
        reached = [(0.0, 0.0, 0.2 - error[0]), (0.0, 0.0, 0.2 - error[1]), (0.0, 0.0, -0.2)]
        np.testing.assert_array_equal(own_commands_met(rollout(reached, [LEFT] * 3), allowed), [True, False, False])
        # A lateral command alone is no command to stand, which marching would miss.
        marching = rollout([LEFT], [LEFT], joint_velocity=np.ones((200, 1, 12)))
        assert own_commands_met(marching, allowed).all()

    def test_rollout_follows_lateral_commands_and_refuses_others(self):
        found = roll_out(ZeroController("position"), [LEFT, AHEAD], [1], 0.1, TASK)
        np.testing.assert_array_equal(found.command, [[LEFT, AHEAD]] * 5)
        assert found.velocity.shape == (5, 2, 3)
        shorter = roll_out(ZeroController("position"), [AHEAD[:2]], [1], 0.1, TASK)
        np.testing.assert_array_equal(shorter.command, [[AHEAD]] * 5)
        with pytest.raises(QuadrupedError, match=r"commands must have shape \(K, 3\); found \(1, 4\)"):
            roll_out(ZeroController("position"), [(0.0,) * 4], [1], 0.1, TASK)
        with pytest.raises(QuadrupedError, match=r"commands must have shape \(K, 2\); found \(1, 3\)"):
            roll_out(ZeroController("position"), [LEFT], [1], 0.1)


def compared(share, tuned_error=0.2, commands=(AHEAD, LEFT, RIGHT, (0.3, 0.0, 0.2)), seeds=3, forward=1.0):
    """A comparison whose policy reaches shares of the lateral and the forward velocities."""
    command = np.array(commands)
    reached = command * (forward, 1.0, share)
    rollouts = {"policy": rollout(np.repeat(reached, seeds, axis=0), np.repeat(command, seeds, axis=0))}
    shape, found = (len(commands), seeds), measure(rollouts["policy"])
    values = {m: np.reshape(found[m], shape) if m in found else np.full(shape, np.nan) for m in METRICS}
    other = {m: np.full_like(v, tuned_error if m.endswith("error") else 0.0) for m, v in values.items()}
    return Comparison(tuple(commands), tuple(range(seeds)), 4.0, TASK, rollouts, {"policy": values, "tuned": other})


class TestVerdict:
    def test_motions_and_numbers_include_sideways(self):
        comparison = compared(0.9)
        assert comparison.motions == ["forwards", "sideways"]
        assert comparison.conditions("sideways") == [1, 2, 3]
        document = comparison.to_dict()
        assert document["commands"][1] == {
            "forward_velocity": 0.0, "yaw_rate": 0.0, "lateral_velocity": 0.2, "motion": "sideways",
        }  # fmt: skip
        found = document["controllers"]["policy"]["by_motion"]["sideways"]["lateral_velocity_error"]
        assert found["mean"] == pytest.approx(0.02)
        assert document["metrics"]["lateral_velocity"]["unit"] == "m/s"

    def test_reached_share_counts_both_sides(self):
        assert reached_share(compared(0.8), "policy", "sideways") == pytest.approx(0.8)
        assert reached_share(compared(-0.3), "policy", "sideways") == pytest.approx(-0.3)

    @pytest.mark.parametrize(
        ("numbers", "level", "headline"),
        [
            ({"share": 0.9}, "good", "at least as well as the scripted gait"),
            ({"share": 0.9, "tuned_error": 0.0}, "fair", "less accurate than the scripted gait sideways"),
            ({"share": 0.4}, "fair", "but it does not walk sideways."),
            ({"share": -1.0}, "fair", "does not walk sideways and is less accurate than the scripted gait sideways."),
            ({"share": 1.0, "commands": (AHEAD, (0.6, 0.0, 0.2)), "forward": 0.7}, "fair",
             "does not follow 0.5 m/s and 0.6 m/s and 0.2 m/s to the left"),
            ({"share": 1.8}, "fair", "does not follow 0.2 m/s to the left, 0.2 m/s to the right"),
        ],
    )  # fmt: skip
    def test_headline(self, numbers, level, headline):
        judged = verdict(compared(**numbers))
        assert judged.level == level
        assert headline in judged.headline

    def test_worst_episodes_name_three_errors(self):
        (worst, *_) = worst_episodes(compared(0.0, commands=(AHEAD, LEFT)))
        assert worst.command == LEFT
        assert worst.badness == pytest.approx(0.2 / (0.1 * UNIT))
        assert worst.story.endswith("Errors: 0.000 m/s, 0.000 rad/s and 0.200 m/s.")

    def test_commands_without_a_lateral_velocity_are_completed(self):
        comparison = run({"policy": ZeroController("position")}, {}, TASK, [(0.1, 0.0)], 1, 2.0)
        assert comparison.commands == ((0.1, 0.0, 0.0),)

    def test_note_of_the_gain_names_the_lateral_velocity_where_it_counts(self):
        assert "turns of the yaw rate. Random" in table_note({"motions": [{"motion": "turning"}]})
        assert "or sideways of the lateral velocity." in table_note({"motions": [{"motion": "sideways"}]})


class TestSuite:
    def test_a_robot_that_does_not_move_sideways_keeps_the_suite(self):
        assert with_velocities(full_suite(), MINI_QUADRUPED) is full_suite()

    def test_every_command_and_tolerance_has_a_third_number(self):
        assert SUITE.sha256 != full_suite().sha256
        assert SUITE.commands.rectangle == ((-0.3, -0.8, -0.2), (0.6, 0.8, 0.2)) == SUITE.joystick.rectangle
        tolerance = SUITE.commands.tolerance
        assert (SUITE.commands.smallest, tolerance.met) == ((0.1, 0.2, 0.1), (0.05, 0.1, 0.05))
        assert (tolerance.least, tolerance.missed) == ((0.02, 0.05, 0.02), (0.1, 0.2, 0.1))
        assert SUITE.joystick.tolerance == SUITE.gait.tolerance == SUITE.pushes.tolerance == tolerance
        assert SUITE.terrain.command == (0.4, 0.0, 0.0)
        assert SUITE.commands.axes["left"][0] == (0.0, 0.2, 0.0)
        assert SUITE.commands.axes["sideways_right"][-1] == (0.0, 0.0, -0.5)
        assert SUITE.gait.commands == (*((*one, 0.0) for one in full_suite().gait.commands), *SIDEWAYS)
        assert SUITE.pushes.commands[-1] == SUITE.regulation.commands[-1] == (0.0, 0.0, 0.15)
        assert SUITE.transients.changes[-2].then == (0.0, 0.0, -0.15)
        assert SUITE.pushes.unit == full_suite().pushes.unit
        quick = with_velocities(quick_suite(), ROBOT)
        assert quick.commands.axes["sideways_left"] == ((0.0, 0.0, 0.15), (0.0, 0.0, 0.2))
        assert quick.gait.commands[-1] == SIDEWAYS[0]
        own = for_robot(SUITE, ROBOT)
        assert own.commands.tolerance.met[2] == own.commands.tolerance.met[0] == pytest.approx(0.05 * UNIT, rel=1e-5)
        assert own.pushes.commands[-1][2] == pytest.approx(0.15 * UNIT, rel=1e-5)

    def test_lateral_velocities_are_drawn_evenly(self):
        drawn = np.array(SUITE.commands.drawn)
        assert drawn.shape == (256, 3)
        counts, _ = np.histogramdd(drawn[:248], bins=2, range=((-0.3, 0.6), (-0.8, 0.8), (-0.2, 0.2)))
        np.testing.assert_allclose(counts, 31, atol=3)
        assert (np.abs(drawn[:248]) >= SUITE.commands.smallest).any(axis=1).all()

    def test_joystick_asks_for_lateral_velocities(self):
        commands = np.concatenate([changing.schedule(SUITE.joystick, seed, DT) for seed in SUITE.joystick.seeds])
        assert commands.shape[1] == 3
        assert (np.abs(commands[:, 2]).max(), np.ptp(np.sign(commands[:, 2]))) == (0.2, 2.0)
        assert (~commands.any(axis=1)).mean() == pytest.approx(0.15, abs=0.03)

    def test_errors_and_windows_count_the_lateral_velocity(self):
        command = np.tile(LEFT, (500, 1, 1))
        velocity = command - [0.0, 0.0, 0.12]
        error = changing.stretch_errors(velocity, command, np.ones((500, 1), bool), SUITE.joystick, DT)
        np.testing.assert_allclose(error[30:, 0], np.tile([0.0, 0.0, -0.12], (470, 1)), atol=1e-12)
        for share, expected in ((1.0, 0.0), (0.5, 0.5)):  # 0.06 m/s is half way from 0.02 to 0.1 m/s
            accuracy, _ = changing.window_accuracy(share * error, command, np.ones((500, 1), bool), SUITE.joystick, DT)
            np.testing.assert_allclose(accuracy, expected, atol=1e-9)

    def test_summary_has_the_signed_lateral_error_of_each_command(self):
        achieved = np.array([LEFT, AHEAD])[:, None] + (0.0, 0.0, -0.03)
        found = steady.signed_errors([LEFT, AHEAD], achieved)
        np.testing.assert_allclose(found["lateral_velocity_error"]["signed"], [-0.03, -0.03])
        assert found["lateral_velocity_error"]["largest"] == pytest.approx(0.03)

    def test_regulation_keeps_a_fifth_of_the_lateral_velocity(self):
        part = replace(SUITE.regulation, commands=(LEFT, AHEAD))
        achieved = np.repeat(part.commands, 2, axis=0)
        achieved[:, 2] += [0.039, 0.041] * 2
        np.testing.assert_array_equal(steady.keeps(part, achieved, np.zeros(4, bool)), [1, 0, 1, 1])

    def test_standing_meets_no_lateral_command_in_any_part(self):
        standing = Candidate("standing", ZeroController("position"), TASK)
        result = run_suite(standing, tiny_suite())
        assert result["suite"]["sha256"] == with_velocities(tiny_suite(), ROBOT).sha256
        assert result["commands"]["envelope"]["sideways_left"] == 0.0
        assert result["transients"]["changes"]["step_left"]["followed"]["mean"] == 0.0
        assert [entry["accuracy"][0]["mean"] for entry in result["pushes"]["commands"]] == [0.0, 1.0, 0.0]
        aside = result["regulation"]["disturbances"]["nominal"]["commands"][-1]
        assert aside["share"][:2] == [None, None]
        assert aside["share"][2] == pytest.approx(0.0, abs=0.05)
        assert math.isclose(aside["velocity"][2], aside["share"][2] * aside["command"][2])
