"""The search for gaits that need little energy."""

import argparse
import json

import numpy as np
import pytest

import energy_study
from quadruped_env.gait import LEG_PHASES, CommandedGait
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.training.gait_trial import Achieved
from quadruped_env.training.gait_tuning import gait_targets


def achieved(count, **values):
    """Results of so many gaits, zero but for the given ones."""
    return Achieved(**{name: np.zeros(count) for name in Achieved.__annotations__} | values)


def test_legs_are_those_of_the_gait():
    gait, clock = CommandedGait.tuned(), 1.2
    candidate = np.zeros((1, 3, 2, 6))
    candidate[:, 0] = energy_study.legs_of(gait, 0.35)
    targets = gait_targets(candidate, np.zeros(1), LEG_PHASES["trot"])(clock)
    np.testing.assert_allclose(targets, gait.positions([clock], [[0.35, 0.0]]), atol=1e-12)


def test_transport_is_energy_over_weight_and_distance():
    got = achieved(2, electrical_power=np.array([6.0, 6.0]), forward_velocity=np.array([0.4, 0.0]))
    weight = MINI_QUADRUPED.total_mass * 9.81
    # A gait that does not move is judged as if it did at 0.1 m/s.
    assert energy_study.transport(got) == pytest.approx([6.0 / (weight * 0.4), 6.0 / (weight * 0.1)])


@pytest.mark.parametrize("judge", energy_study.JUDGES.values(), ids=energy_study.JUDGES)
def test_of_two_gaits_the_cheaper_is_better_unless_it_is_slower_or_falls(judge):
    """Half of the power is worth less than 0.2 m/s of speed."""
    got = achieved(
        4,
        electrical_power=np.array([6.0, 3.0, 3.0, 3.0]),
        forward_velocity=np.array([0.4, 0.4, 0.2, 0.4]),
        fallen=np.array([False, False, False, True]),
        lowest_apex=np.ones((4, 6, 4)),
        mean_apex=np.ones((4, 6, 4)),
    )
    dear, cheap, slow, fallen = judge(got, 0.4, np.zeros(4))
    assert cheap > dear > slow
    assert cheap == pytest.approx(fallen + 10.0)


@pytest.mark.slow
def test_study_saves_energy_and_writes_what_it_found(tmp_path, capsys):
    output = tmp_path / "energy.json"
    arguments = argparse.Namespace(speed=0.4, frequencies=[3.4], generations=3, output=output)
    assert energy_study.run(arguments) == 0
    results = json.loads(output.read_text())["results"]
    assert [result["score"] for result in results] == ["energy", "steps"]
    printed = capsys.readouterr().out.splitlines()
    for line, result in zip(printed[2:4], results, strict=True):
        assert f"{result['electrical_cost_of_transport']:.2f}" in line
        assert line.endswith("no |")
        assert np.shape(result["legs"]) == (2, 6)
    energy, steps = (result["electrical_cost_of_transport"] for result in results)
    assert energy <= steps
