import json
import math

import numpy as np
import pytest

from benchmarks import timestep_study
from benchmarks.timestep_study import Outcome, Reading, Setting, Study
from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig

CHOSEN = Setting.of_model_file()


def test_the_chosen_setting_is_the_model_files(model):
    assert CHOSEN.timestep == model.opt.timestep == TaskConfig().physics_timestep
    assert CHOSEN.substeps == TaskConfig().decimation
    assert TaskConfig().control_timestep == timestep_study.CONTROL_TIMESTEP
    compiled = CHOSEN.model().opt
    for name in ("timestep", "integrator", "cone", "iterations", "ls_iterations", "solver", "tolerance"):
        assert getattr(compiled, name) == getattr(model.opt, name), name


def test_every_setting_differs_from_the_chosen_one_in_one_thing_and_fits_the_control_step():
    settings = timestep_study.settings_to_compare()
    assert settings.count(CHOSEN) == 1
    for setting in settings:
        assert setting.substeps * setting.timestep == pytest.approx(timestep_study.CONTROL_TIMESTEP, rel=1e-12)
        different = [
            setting.timestep != CHOSEN.timestep,
            setting.integrator != CHOSEN.integrator,
            setting.cone != CHOSEN.cone,
            (setting.iterations, setting.ls_iterations) != (CHOSEN.iterations, CHOSEN.ls_iterations),
        ]
        assert sum(different) == (setting != CHOSEN)
        reference = setting.reference()
        assert reference.timestep == pytest.approx(setting.timestep / 5, rel=1e-12)
        assert (reference.integrator, reference.cone) == (setting.integrator, setting.cone)


def test_impact_velocity_is_that_of_free_fall():
    expected = math.sqrt(2 * 9.81 * 0.10)
    assert timestep_study.impact_velocity(CHOSEN.reference()) == pytest.approx(expected, rel=0.005)
    assert timestep_study.impact_velocity(CHOSEN) == pytest.approx(expected, rel=0.03)


def test_standing_height_does_not_depend_on_the_step():
    height = timestep_study.standing_height(CHOSEN)
    assert height == pytest.approx(MINI_QUADRUPED.stance_height, abs=1e-3)
    assert height == pytest.approx(timestep_study.standing_height(CHOSEN.reference()), rel=1e-3)


def test_gait_speeds_are_reproducible_and_leave_out_falls(monkeypatch):
    stand = SinusoidalGait(0.0, 0.6, 0.0, -0.72, 12.0, (0.0,) * 8)
    speeds = timestep_study.gait_speeds(CHOSEN, stand, 3, 2.6, seed=0, num_threads=1)
    np.testing.assert_allclose(speeds, 0.0, rtol=0, atol=0.01)
    np.testing.assert_array_equal(speeds, timestep_study.gait_speeds(CHOSEN, stand, 3, 2.6, seed=0, num_threads=2))
    monkeypatch.setattr(timestep_study, "_FALLEN", 1.1)  # nothing is ever upright enough
    assert np.isnan(timestep_study.gait_speeds(CHOSEN, stand, 3, 2.6, seed=0, num_threads=1)).all()


def test_comparison_leaves_out_starts_that_fell_in_either_run():
    values, references = np.array([1.1, 1.1, np.nan, 0.0]), np.array([1.0, 1.0, 1.0, np.nan])
    reading = timestep_study._compare(values, references, "trot")
    assert reading.error == pytest.approx(0.1)
    assert (reading.standard_error, reading.fallen) == (0.0, 2)
    with pytest.raises(QuadrupedError, match=r"'trot'.*falls"):
        timestep_study._compare(values, np.full(4, np.nan), "trot")


def test_table_and_verdict_and_report():
    good, bad = Reading(1.01, 1.0, 0.001, 0), Reading(1.04, 1.0, 0.002, 3)
    fine = Setting(0.002, "implicitfast", "pyramidal", 4, 8)
    outcomes = [Outcome(CHOSEN, 500.0, {"trot speed": bad}), Outcome(fine, 200.0, {"trot speed": good})]
    study = Study(outcomes, CHOSEN, ("trot",), 2, 3.0, 0)
    header, _, first, second = study.table().splitlines()
    assert header.count("|") == first.count("|") == second.count("|")
    assert "**+4.0 ± 0.2 % (3 fell)**" in first
    assert "| 0.40 | +1.0 ± 0.1 % | yes |" in second
    assert "is NOT within 3%" in study.verdict()
    assert "2 ms, implicitfast, pyramidal cone, 4 / 8 iterations" in study.verdict()
    report = json.loads(json.dumps(study.report()))
    assert report["outcomes"][1]["relative_speed"] == 0.4
    assert report["outcomes"][0]["errors"]["trot speed"] == pytest.approx(0.04)
