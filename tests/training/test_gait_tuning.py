"""The scripted gaits on simulated robots, and the search that found their parameters."""

import numpy as np
import pytest
from built_in import STANCE, VELOCITY_LIMIT

from quadruped_env import CommandedGait, SinusoidalGait
from quadruped_env.gait import LEG_PHASES
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.training import gait_tuning

TUNED = CommandedGait.tuned()
TABLE = np.array([(speed, 0.0) for speed in TUNED.speeds])


@pytest.fixture(scope="module")
def walked():
    return gait_tuning.measure_commands(TUNED, TABLE)


def test_the_tuned_gait_walks_at_the_speeds_of_its_table(walked):
    np.testing.assert_allclose(walked.forward_velocity, TABLE[:, 0], atol=0.02)
    assert abs(walked.lateral_velocity).max() < 0.02
    assert abs(walked.yaw_rate).max() < 0.1
    assert not walked.fallen.any()


def test_the_tuned_gait_lifts_every_foot(walked):
    moving = TABLE[:, 0] != 0.0
    assert walked.clearance[moving].min() > 0.0005
    assert np.median(walked.clearance[moving]) > 0.002
    assert walked.clock[moving].min() > 0.2
    # The stance holds all feet on the ground, against the clock as often as with it.
    assert walked.clearance[~moving] == pytest.approx(0.0, abs=0.001)
    assert walked.clock[~moving] == pytest.approx(0.0, abs=0.05)


def test_the_tuned_gait_turns_the_right_way():
    commands = np.array([(0.0, 0.6), (0.0, -0.6), (0.3, 0.6), (0.3, -0.6)])
    got = gait_tuning.measure_commands(TUNED, commands)
    assert (np.sign(got.yaw_rate) == np.sign(commands[:, 1])).all()
    assert (abs(got.yaw_rate) > 0.3).all()


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


def test_candidates_give_the_joint_targets_of_their_gait():
    """The search's own targets, against the gait's formula."""
    column = [0.1, 0.6, 0.2, -0.15, -0.7, 0.05, 0.5, 0.1, -0.3, -0.8]
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
    targets = gait_tuning.gait_targets(np.array([column, column]), 12.0, LEG_PHASES["walk"])
    for t in (0.0, 0.1, 0.77):
        np.testing.assert_allclose(targets(t), np.tile(preset.positions(t), (2, 1)), atol=1e-12)


def test_search_improves_and_stays_within_the_motors_speed(monkeypatch):
    monkeypatch.setattr(gait_tuning, "CANDIDATES", 40)
    monkeypatch.setattr(gait_tuning, "ELITE", 8)
    start = np.tile([0.1, STANCE[0], 0.15, -0.1, STANCE[1]], 2)
    frequency = 14.0
    found = [
        gait_tuning.search(0.25, frequency, LEG_PHASES["trot"], start, 0.15, generations, seed=1)
        for generations in (1, 8)
    ]
    assert abs(found[1].speed - 0.25) < abs(found[0].speed - 0.25)
    hip, _, cosine, sine, _ = found[1].columns.reshape(2, 5).T
    assert (frequency * np.maximum(abs(hip), np.hypot(cosine, sine)) <= VELOCITY_LIMIT).all()
    again = gait_tuning.search(0.25, frequency, LEG_PHASES["trot"], start, 0.15, 8, seed=1)
    np.testing.assert_array_equal(again.columns, found[1].columns)


def test_table_of_results_names_every_command():
    table = gait_tuning.achieved_table(TUNED)
    rows = [line for line in table.splitlines() if line.startswith(("| +", "| -"))]
    assert len(rows) == 18
    assert all(row.endswith("| no |") for row in rows)
