"""The scripted gaits on simulated robots, and the search that found their parameters."""

import numpy as np
import pytest
from built_in import STANCE, VELOCITY_LIMIT

from quadruped_env import CommandedGait, SinusoidalGait
from quadruped_env.gait import LEG_PHASES
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.training import gait_tuning

TUNED = CommandedGait.tuned()
TABLE = np.array([(speed, 0.0) for speed in TUNED.speeds if speed != 0.0])
"""At zero the commanded gait stands"""
TURNS = np.array(
    [(speed, side * yaw_rate) for speed in (0.0, 0.2, -0.2) for yaw_rate in (0.4, 0.7) for side in (1, -1)]
)


@pytest.fixture(scope="module")
def walked():
    return gait_tuning.measure_commands(TUNED, TABLE)


def test_the_tuned_gait_walks_at_the_speeds_of_its_table(walked):
    np.testing.assert_allclose(walked.forward_velocity, TABLE[:, 0], atol=0.035)
    assert abs(walked.lateral_velocity).max() < 0.04
    assert abs(walked.yaw_rate).max() < 0.15  # nothing holds the heading
    assert not walked.fallen.any()


def test_the_tuned_gait_lifts_every_foot(walked):
    assert walked.clearance.min() > 0.012
    assert walked.clock.min() > 0.2


def test_a_standing_robot_has_its_feet_on_the_ground():
    standing = gait_tuning.measure_commands(TUNED, np.zeros((1, 2)))
    assert standing.clearance[0] == pytest.approx(0.0, abs=0.001)
    # Against the clock as often as with it.
    assert standing.clock[0] == pytest.approx(0.0, abs=0.05)


def test_the_tuned_gait_turns_at_the_commanded_rate_on_lifted_feet():
    got = gait_tuning.measure_commands(TUNED, TURNS)
    np.testing.assert_allclose(got.yaw_rate, TURNS[:, 1], atol=0.25)
    assert (got.yaw_rate * np.sign(TURNS[:, 1]) > 0.4 * np.abs(TURNS[:, 1])).all()
    np.testing.assert_allclose(got.forward_velocity, TURNS[:, 0], atol=0.12)
    assert got.clearance.min() > 0.005


@pytest.mark.parametrize(("name", "angular_frequency", "speed"), gait_tuning.PRESET_SPEEDS)
def test_presets_walk_as_fast_as_they_were_tuned_for(name, angular_frequency, speed):
    preset = SinusoidalGait.preset(name)
    assert preset.angular_frequency == angular_frequency
    assert preset.violations() == []
    simulation = BatchSimulation(build_model(), 1)
    got = gait_tuning.measure(
        lambda t: preset.positions(np.array([t])), simulation, preset.angular_frequency, LEG_PHASES[name]
    )
    assert got.forward_velocity[0] == pytest.approx(speed, abs=0.03)
    assert not got.fallen[0]
    assert got.clearance[0] > 0.005


STRAIGHT = [[0.1, 0.6, 0.2, -0.15, -0.7], [0.05, 0.5, 0.1, -0.3, -0.8]]
NO_TURN = np.zeros((2, 2, 5))


def test_candidates_give_the_joint_targets_of_their_gait():
    """The search's own targets, against the gait's formula."""
    candidate = np.concatenate([[STRAIGHT], NO_TURN])
    preset = SinusoidalGait(
        hip_amplitude=(0.1, 0.1, 0.05, 0.05),
        hip_offset=(0.6, 0.6, 0.5, 0.5),
        knee_amplitude=tuple(np.hypot([0.2, 0.2, 0.1, 0.1], [0.15, 0.15, 0.3, 0.3])),
        knee_offset=(-0.7, -0.7, -0.8, -0.8),
        angular_frequency=12.0,
        phases=tuple(
            2 * np.pi * turn + lag
            for turn, knee in zip(
                LEG_PHASES["walk"], np.arctan2([0.15, 0.15, 0.3, 0.3], [0.2, 0.2, 0.1, 0.1]), strict=True
            )
            for lag in (0.0, knee)
        ),
    )
    targets = gait_tuning.gait_targets(np.array([candidate] * 2), np.array([0.0, 0.5]), 12.0, LEG_PHASES["walk"])
    for t in (0.0, 0.1, 0.77):
        np.testing.assert_allclose(targets(t), np.tile(preset.positions(t), (2, 1)), atol=1e-12)


def test_candidates_at_a_yaw_rate_are_the_commanded_gait_with_their_tables():
    rng = np.random.default_rng(0)
    candidates = {speed: rng.uniform(-0.3, 0.3, (3, 2, 5)).round(4) for speed in (0.1, 0.2, 0.4)}
    gait = gait_tuning.commanded_gait(candidates, 12.0, 0.8)
    assert gait.speeds == (0.1, 0.2, 0.4)
    yaw_rates = np.array([-0.6, 0.0, 0.5])
    targets = gait_tuning.gait_targets(np.array([candidates[0.2]] * 3), yaw_rates, 12.0, LEG_PHASES["trot"])
    commands = np.column_stack([np.full(3, 0.2), yaw_rates])
    for t in (0.0, 0.13, 1.7):
        np.testing.assert_allclose(targets(t), gait.positions(np.full(3, 12.0 * t), commands), atol=1e-12)


@pytest.fixture
def small_search(monkeypatch):
    monkeypatch.setattr(gait_tuning, "CANDIDATES", 30)
    monkeypatch.setattr(gait_tuning, "ELITE", 6)
    monkeypatch.setattr(gait_tuning, "SECONDS", 2.0)


def test_search_improves_the_straight_gait_and_stays_within_the_motors_speed(small_search):
    leg = [0.1, STANCE[0], 0.15, -0.1, STANCE[1]]
    start, frequency = np.concatenate([[[leg, leg]], NO_TURN]), 14.0
    found = [
        gait_tuning.search(0.25, frequency, LEG_PHASES["trot"], start, 0.15, generations, seed=1)
        for generations in (1, 8, 8)
    ]
    errors = [abs(one.achieved.forward_velocity[0] - 0.25) for one in found]
    assert errors[1] < errors[0]
    candidate = found[1].candidate
    np.testing.assert_array_equal(candidate[1:], 0.0, "straight ahead, no turning column is searched")
    hip, _, cosine, sine, _ = candidate[0].T
    assert (frequency * np.maximum(abs(hip), np.hypot(cosine, sine)) <= VELOCITY_LIMIT).all()
    np.testing.assert_array_equal(candidate, found[2].candidate)


def test_search_of_a_turn_keeps_the_straight_gait_and_the_motors_speed_on_both_sides(small_search):
    start = np.concatenate([[STRAIGHT], np.full((2, 2, 5), 0.1)])
    start[0, :, 2:4] *= 0.5
    found = gait_tuning.search(0.2, 20.0, LEG_PHASES["trot"], start, 0.2, 3, seed=1, yaw_rates=(0.5, 1.0))
    np.testing.assert_array_equal(found.candidate[0], start[0])
    assert found.achieved.yaw_rate.shape == (2,)
    assert np.abs(found.candidate[1:] - start[1:]).max() > 0.01
    straight, turn, side = found.candidate
    for sign in (-1.0, 1.0):
        hip, _, cosine, sine, _ = (straight + turn + sign * side).T
        assert (20.0 * np.maximum(abs(hip), np.hypot(cosine, sine)) <= VELOCITY_LIMIT + 0.01).all()


def test_table_of_results_names_every_command():
    table = gait_tuning.achieved_table(TUNED)
    rows = [line for line in table.splitlines() if line.startswith(("| +", "| -"))]
    assert len(rows) == 18
    assert all(row.endswith("| no |") for row in rows)
