"""Parts of the suite with changing commands and pushes, against closed forms and hand-computed arrays."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from synthetic import DT, falls, synthetic_rollout

from quadruped_env.evaluation.measures import Tolerance
from quadruped_env.evaluation.suite import changing
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite_definition import Change, Disturbance, full_suite
from quadruped_env.policies import ZeroController
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import TaskConfig

JOYSTICK, TRANSIENTS, PUSHES = full_suite().joystick, full_suite().transients, full_suite().pushes
STEPS = 1000


def given(*pieces):
    """Commands (T, 1, 2) of pieces (control steps, forward velocity, yaw rate)."""
    return np.concatenate([np.tile([v, w], (steps, 1, 1)) for steps, v, w in pieces])


class TestJoystick:
    def test_schedules_hold_each_command_and_have_every_kind(self):
        commands = np.concatenate([changing.schedule(JOYSTICK, seed, DT) for seed in JOYSTICK.seeds])
        single = changing.schedule(JOYSTICK, JOYSTICK.first_seed, DT)
        assert single.shape == (3000, 2)
        np.testing.assert_array_equal(single, changing.schedule(JOYSTICK, JOYSTICK.first_seed, DT))
        held = np.diff(np.flatnonzero((np.diff(single, axis=0) != 0.0).any(axis=1)))
        assert held.min() >= 25
        # Two commands to stand in a row look like one that is held longer.
        assert np.quantile(held, 0.9) <= 200
        assert (np.abs(commands - (0.15, 0.0)) <= np.array([0.45, 0.8]) + 1e-12).all()
        assert (~commands.any(axis=1)).mean() == pytest.approx(0.15, abs=0.03)
        ends = np.isin(commands[:, 0], (-0.3, 0.0, 0.6)) & np.isin(commands[:, 1], (-0.8, 0.0, 0.8))
        # A fifth, and most of those that reverse them.
        assert (ends & commands.any(axis=1)).mean() == pytest.approx(0.24, abs=0.03)
        change = np.flatnonzero((np.diff(commands, axis=0) != 0.0).any(axis=1))
        reversals = (commands[change + 1, 1] == -commands[change, 1]) & (commands[change, 1] != 0.0)
        assert reversals.mean() == pytest.approx(0.15, abs=0.05)

    def test_error_is_the_mean_over_each_stretch_after_the_allowance(self):
        command = given((200, 0.3, 0.0), (30, 0.0, 0.5), (270, -0.2, 0.0))
        velocity = command.copy()
        velocity[:200, 0, 0] += 0.04 * (-1.0) ** np.arange(200)  # the oscillation within a stride is no error
        velocity[200:230] = 9.0  # held for 0.6 s: what is left after the allowance is shorter than a stride
        velocity[230:255] = 9.0  # within the allowance
        velocity[255:, 0, 0] += 0.1
        valid = np.ones((500, 1), dtype=bool)
        valid[400:] = False
        error = changing.stretch_errors(velocity, command, valid, JOYSTICK, DT)[:, 0]
        counted = np.isfinite(error[:, 0])
        np.testing.assert_array_equal(np.flatnonzero(counted), [*range(25, 200), *range(255, 400)])
        np.testing.assert_allclose(error[25:200], 0.0, atol=1e-3)
        np.testing.assert_allclose(error[255:400], [[0.1, 0.0]] * 145, atol=1e-12)

    def test_windows_have_the_accuracy_of_their_mean_error_and_none_with_a_fall_counts(self):
        error, command = np.zeros((STEPS, 3, 2)), np.tile([0.5, 0.0], (STEPS, 3, 1))
        error[250:500, 0, 0] = -0.11
        error[500:600, 1] = 0.1, -0.3125  # a mean of 0.04 m/s, which is met closely, and of 0.125 rad/s: half way
        error[500:750, 2] = np.nan
        valid = np.ones((STEPS, 3), dtype=bool)
        valid[760:, 0] = False
        accuracy, counted = changing.window_accuracy(error, command, valid, JOYSTICK, DT)
        np.testing.assert_allclose(accuracy.T[:2], [[1, 0, 1, 1], [1, 1, 0.5, 1]])
        np.testing.assert_array_equal(counted.T, [[1, 1, 1, 0], [1, 1, 1, 1], [1, 1, 0, 1]])

    def test_falls_divide_the_score_smoothly_and_its_spread_counts_them(self):
        """60 robots for a minute each with an accuracy of 0.8, and no fall, one, ten, or 62 in this hour."""
        sums = np.tile([[9.6], [12.0], [0.0], [1.0 / 60.0]], (1, 60))
        for count, expected in ((0, 0.8), (1, 0.8 / 1.1), (10, 0.4), (62, 0.8 / 7.2)):
            sums[2] = np.bincount(np.arange(count) % 60, minlength=60)
            found = changing.joystick_contributions(sums, JOYSTICK.halving)
            assert found.mean() == pytest.approx(expected)
            # The standard deviation of the count, times the derivative of the score.
            spread = 0.8 / 10.0 / (1.0 + count / 10.0) ** 2 * math.sqrt(60.0 * sums[2].var())
            assert found.std() / math.sqrt(60) == pytest.approx(spread, rel=0.15)
        assert changing.joystick_contributions(sums[:, :1], JOYSTICK.halving) == pytest.approx([0.8 / 13.0])

    def test_falls_per_hour_count_the_time_until_each_fall(self):
        command = np.repeat(given((STEPS, 0.3, 0.0)), 3, axis=1)
        valid = np.ones((STEPS, 3), dtype=bool)
        valid[500:, 1] = False
        rollout = synthetic_rollout(STEPS, 3, velocity=command.copy(), fell=falls(valid))
        result = changing.joystick_measures(rollout, command, JOYSTICK)
        assert (result["falls"], result["robot_hours"]) == (1, pytest.approx(50.0 / 3600.0))
        assert result["falls_per_hour"]["mean"] == pytest.approx(72.0)
        assert result["mean_error"] == pytest.approx([0.0, 0.0], abs=1e-6)
        assert result["accuracy"]["mean"] == 1.0
        assert np.mean(result["contributions"]) == pytest.approx(1.0 / 8.2)

    def test_three_quarters_of_every_command_earn_little_and_those_within_a_tenth_everything(self):
        command = np.repeat(np.stack([changing.schedule(JOYSTICK, 1_600_000 + i, DT) for i in range(8)], axis=1), 1, 1)
        found = []
        for share in (1.0, 0.91, 0.75, 0.0):
            rollout = synthetic_rollout(len(command), 8, velocity=share * command)
            found.append(np.mean(changing.joystick_measures(rollout, command, JOYSTICK)["contributions"]))
        assert found[:2] == [1.0, pytest.approx(1.0, abs=0.01)]
        assert 0.2 < found[2] < 0.6
        assert found[3] == 0.0

    def test_standing_meets_no_window_that_counts(self):
        command = given((500, 0.05, 0.1), (500, 0.3, 0.0))
        rollout = synthetic_rollout(STEPS, velocity=np.zeros((STEPS, 1, 2)))
        result = changing.joystick_measures(rollout, command, JOYSTICK)
        assert result["contributions"] == [0.0]
        assert result["accuracy"]["count"] == 1

    def test_robots_get_their_own_commands_when_they_change(self):
        requested = []

        class Recorder(ZeroController):
            def act(self, observation, control):
                requested.append(control.requested.copy())
                return super().act(observation, control)

        part = replace(JOYSTICK, num_seeds=3, seconds=4.0, laws=(Disturbance("undisturbed"),))
        result = changing.run_joystick(part, Candidate("standing", Recorder(), TaskConfig()))
        expected = np.stack([changing.schedule(part, seed, DT) for seed in part.seeds], axis=1)
        np.testing.assert_array_equal(requested, expected)
        assert result["laws"]["undisturbed"]["robot_hours"] == pytest.approx(12.0 / 3600.0)
        assert result["laws"]["undisturbed"]["accuracy"]["count"] == 0
        assert result["contributions"] == [0.0] * 3


TIME = (np.arange(round((TRANSIENTS.before + TRANSIENTS.after) / DT)) + 1) * DT - TRANSIENTS.before
"""Times of the samples since the change, s (T,)."""


def first_order(tau, start=0.0, end=0.5):
    """First-order response to a step at time 0, (T, 1)."""
    return np.where(TIME > 0, end + (start - end) * np.exp(-TIME / tau), start)[:, None]


def settling(velocity, wanted=0.5, least=0.0):
    """Settling time of the first episode, s, of a velocity (T, 1); `least` is the least half width of the band."""
    part = replace(TRANSIENTS, tolerance=Tolerance(met=(least,)))
    return changing.step_response(velocity[..., None], np.array([wanted]), part, DT)[0][0]


def measured(velocity, first, then, **changes):
    """Measures of a step of the command from velocities (T, N, 2)."""
    rollout = synthetic_rollout(len(TIME), velocity.shape[1], velocity=velocity, **changes)
    return changing.step_measures(rollout, Change("step", first, then), TRANSIENTS)


def settled(tau, band):
    """Settling time of a first-order response in closed form, s.

    The centred mean over w multiplies an exponential with time constant tau by sinh(w / 2 tau) / (w / 2 tau).
    """
    ratio = 0.5 * (2 * round(0.5 * TRANSIENTS.window / DT) + 1) * DT / tau
    return tau * math.log(math.sinh(ratio) / ratio / band)


class TestTransients:
    def test_centred_mean_by_hand(self):
        values = np.array([[1.0], [2.0], [6.0], [3.0]])
        np.testing.assert_allclose(changing.centred_mean(values, 1)[:, 0], [1.5, 3.0, 11.0 / 3.0, 4.5])
        np.testing.assert_allclose(changing.centred_mean(values, 0), values)

    @pytest.mark.parametrize("tau", [0.3, 0.6])
    @pytest.mark.parametrize(("start", "end"), [(0.0, 0.5), (0.5, 0.0), (0.3, -0.3)])
    def test_settling_time_of_a_first_order_response_has_its_closed_form(self, tau, start, end):
        velocity = np.stack([first_order(tau, start, end), np.zeros((len(TIME), 1))], axis=-1)
        wanted = np.array([end - start, 0.0])
        time, before, final = changing.step_response(velocity, wanted, TRANSIENTS, DT)
        assert time[0] == pytest.approx(settled(tau, TRANSIENTS.band), abs=1.5 * DT)
        np.testing.assert_allclose([before[0, 0], final[0, 0]], [start, end], atol=2e-3)

    def test_band_around_the_final_value_has_a_least_width(self):
        assert settling(first_order(0.5), least=0.25) == pytest.approx(settled(0.5, 0.5), abs=1.5 * DT)
        assert settling(first_order(0.5), least=0.05) == settling(first_order(0.5))

    def test_oscillation_within_a_stride_does_not_delay_settling(self):
        swing = 0.1 * np.sin(2 * np.pi * 3.4 * TIME)[:, None]
        assert settling(first_order(0.3) + swing) == pytest.approx(settling(first_order(0.3)), abs=2 * DT)

    def test_a_velocity_that_leaves_the_band_again_settles_after_its_return(self):
        late = first_order(0.2) + np.where((TIME > 2.0) & (TIME <= 2.5), 0.3, 0.0)[:, None]
        # Within the mean over 0.5 s, 0.3 m/s is over 0.05 m/s until a sixth of the window is left.
        assert settling(late) == pytest.approx(2.5 + 0.25 - 0.5 / 6.0, abs=2 * DT)
        drifting = np.maximum(TIME, 0.0)[:, None]
        assert settling(drifting) == TRANSIENTS.after

    @pytest.mark.parametrize(("end", "followed"), [(0.26, True), (0.24, False), (0.0, False), (-0.5, False)])
    def test_a_response_in_the_wrong_direction_or_too_small_is_not_followed(self, end, followed):
        velocity = np.stack([first_order(0.2, 0.0, end), np.zeros((len(TIME), 1))], axis=-1)
        assert measured(velocity, (0.0, 0.0), (0.5, 0.0))["followed"]["mean"] == followed

    def test_measures_of_a_stop(self):
        """Two robots stop with time constant 0.4 s, one of them falls afterwards; a third walks on."""
        speed = np.concatenate([first_order(0.4, 0.5, 0.0)] * 2 + [np.full((len(TIME), 1), 0.5)], axis=1)
        valid = np.ones((len(TIME), 3), dtype=bool)
        valid[-20:, 1] = False
        velocity = np.stack([speed, 0 * speed], axis=-1)
        result = measured(velocity, (0.5, 0.0), (0.0, 0.0), fell=falls(valid))
        assert result["falls"]["mean"] == pytest.approx(1 / 3)
        assert result["followed"]["mean"] == pytest.approx(1 / 3)
        time = settling(first_order(0.4, 0.5, 0.0), -0.5)
        assert result["settling_time"]["mean"] == pytest.approx((time + 2 * TRANSIENTS.after) / 3)
        assert result["contributions"] == pytest.approx([1.0 - time / TRANSIENTS.after, 0.0, 0.0])
        assert result["steady_error"] == pytest.approx([0.25, 0.0], abs=1e-3)  # without the one that falls

    @pytest.mark.parametrize(
        ("share", "first", "then", "accuracy"),
        [
            (1.0, (0.0, 0.0), (0.5, 0.0), 1.0),
            (0.91, (0.0, 0.0), (0.5, 0.0), 1.0),
            (0.85, (0.0, 0.0), (0.5, 0.0), 0.5),  # 0.075 m/s: half way from 0.05 to 0.1 m/s
            (0.75, (0.0, 0.0), (0.5, 0.0), 0.0),
            (0.75, (0.0, 0.0), (0.0, 0.5), 0.5),  # 0.125 rad/s: half way from 0.05 to 0.2 rad/s
            (0.75, (0.5, 0.0), (0.0, 0.0), 1.0),  # it stops
        ],
    )
    def test_steady_error_counts(self, share, first, then, accuracy):
        """A robot that follows at once, and always does a share of what is asked."""
        first_then = np.where(TIME[:, None, None] > 0.0, then, first)
        (contribution,) = measured(share * first_then, first, then)["contributions"]
        time = settling(share * first_then[..., :1][..., 0] if then[1] == 0 else share * first_then[..., 1], 0.5)
        assert contribution == pytest.approx(accuracy * (1.0 - time / TRANSIENTS.after), abs=0.02)

    def test_a_change_of_both_velocities_has_settled_when_the_slower_one_has(self):
        forward, turning = first_order(0.2, 0.1, 0.5), first_order(0.6, 0.5, -0.5)
        diagonal = (0.1, 0.5), (0.5, -0.5)
        result = measured(np.stack([forward, turning], axis=-1), *diagonal)
        assert settling(turning, -1.0) > settling(forward, 0.4) + 0.5
        assert result["settling_time"]["mean"] == pytest.approx(settling(turning, -1.0))
        # If one velocity does not follow, the change is not followed.
        result = measured(np.stack([forward, np.full_like(turning, 0.5)], axis=-1), *diagonal)
        assert (result["followed"]["mean"], result["contributions"]) == (0.0, [0.0])

    def test_every_episode_gets_the_command_of_its_change_and_counts(self):
        part, commands = replace(TRANSIENTS, num_seeds=3), {}

        def run(first, seeds, seconds, progress, before_step, reached):
            control = SimpleNamespace(config=SimpleNamespace(timestep=DT))
            set_command = lambda ids, then: commands.update(dict.fromkeys(ids, then))  # noqa: E731
            task = SimpleNamespace(control=control, set_command=set_command)
            for step in range(len(TIME)):
                before_step(task, step)
            return synthetic_rollout(len(TIME), 3 * len(first))

        result = changing.run_transients(part, SimpleNamespace(run=run))
        assert commands == {3 * i + k: change.then for i, change in enumerate(part.changes) for k in range(3)}
        assert {entry["followed"]["count"] for entry in result["changes"].values()} == {3}
        assert len(result["contributions"]) == 3 * len(part.changes)


def pushed_rollout(part, velocity, **changes):
    count = len(part.commands) * len(part.sizes) * part.num_seeds
    steps = round((part.before[1] + part.after) / DT)
    return synthetic_rollout(steps, count, velocity=np.tile(velocity, (steps, count, 1)), **changes)


@pytest.fixture
def recorded(monkeypatch):
    """Arguments of every push."""
    pushed, push = [], BatchSimulation.push

    def record(self, env_ids, velocity):
        pushed.append((env_ids.copy(), velocity.copy()))
        push(self, env_ids, velocity)

    monkeypatch.setattr(BatchSimulation, "push", record)
    return pushed


class TestPushes:
    def test_a_robot_that_stands_earns_nothing_under_a_command_to_move(self):
        part = replace(PUSHES, commands=((0.3, 0.0), (0.0, 0.5), (-0.2, 0.0), (0.0, 0.0)), sizes=(1.0,), num_seeds=3)
        result = changing.push_measures(pushed_rollout(part, [0.0, 0.0]), part)
        assert result["survived"]["mean"] == 1.0
        assert [entry["accuracy"][0]["mean"] for entry in result["commands"]] == [0.0, 0.0, 0.0, 1.0]
        assert result["contributions"] == [0.0] * 9

    def test_only_the_time_after_the_push_counts_and_a_fall_earns_nothing(self):
        part = replace(PUSHES, commands=((0.3, 0.0), (0.0, 0.0)), sizes=(1.0, 2.0), num_seeds=2)
        rollout = pushed_rollout(part, [0.0, 0.0])
        last = round(part.final / DT)
        moving = rollout.velocity.copy()
        moving[-last:, :4] = 0.365, -0.05  # half way from 0.03 to 0.1 m/s
        moving[:-last] = 3.0
        valid = rollout.valid.copy()
        valid[-1, 3] = False
        joints = rollout.joint_velocity.copy()
        joints[-last:, 5] = 1.0  # marches
        found = changing.push_measures(
            replace(rollout, velocity=moving, fell=falls(valid), joint_velocity=joints), part
        )
        means = [[size["mean"] for size in entry["accuracy"]] for entry in found["commands"]]
        np.testing.assert_allclose(means, [[0.5, 0.25], [0.5, 1.0]], atol=1e-6)
        assert found["survived"]["mean"] == pytest.approx(7 / 8)
        share = 0.5 * (1.0 - 0.2 * 0.25)
        assert found["contributions"] == pytest.approx([share, share, share, 0.0])

    def test_pushes_have_six_components_and_random_times(self):
        drawn = [changing.push_of(PUSHES, seed) for seed in range(2000)]
        times, scaled = np.array([time for time, _ in drawn]), np.array([push for _, push in drawn]) / PUSHES.unit
        np.testing.assert_allclose(np.linalg.norm(scaled, axis=1), 1.0)
        np.testing.assert_allclose(scaled.mean(axis=0), 0.0, atol=0.04)
        np.testing.assert_allclose((scaled**2).mean(axis=0), 1.0 / 6.0, atol=0.02)
        assert (times.min() > 3.0, times.max() < 4.0) == (True, True)
        assert np.ptp(times) > 0.99

    def test_every_robot_is_pushed_once_by_its_own_push(self, recorded):
        part = replace(PUSHES, sizes=(0.1, 0.2), num_seeds=2, before=(0.1, 0.4), after=0.2, final=0.1)
        changing.run_pushes(part, Candidate("standing", ZeroController(), TaskConfig()))
        ids = np.concatenate([env_ids for env_ids, _ in recorded])
        np.testing.assert_array_equal(np.sort(ids), np.arange(20))
        found = np.concatenate([velocity for _, velocity in recorded])[np.argsort(ids)] / PUSHES.unit
        np.testing.assert_allclose(np.linalg.norm(found, axis=1), np.tile([0.1, 0.1, 0.2, 0.2], 5))
        np.testing.assert_array_equal(found[:4], found[4:8])  # the same under every command
        assert len({tuple(push) for push in found[:4]}) == 4
        assert len(recorded) > 2
