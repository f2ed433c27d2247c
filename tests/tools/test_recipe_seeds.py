"""The program that compares the training seeds of a recipe."""

import argparse
from types import SimpleNamespace

import numpy as np
import pytest
from comparisons import random_policy

import recipe_seeds
from quadruped_env import QuadrupedError
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.policies import GaitController, load_policy
from quadruped_env.task import TaskConfig

HEADER = "timesteps,seconds,return,fall_rate,forward_velocity_error,yaw_rate_error\n"


def say_nothing(share):
    """A progress that shows nothing."""


@pytest.fixture
def trained(tmp_path):
    """Makes a run with random weights: directory from recipe, seed and further parts of its card."""

    def make(recipe, seed, **card):
        directory = tmp_path / f"20260101-000000-{recipe}-{seed}"
        card = {"recipe": recipe, "algo": "ppo", "seed": seed, "timesteps": 1000, **card}
        random_policy("residual").with_card(card).save(directory)
        lines = "".join(f"{100 * i},{i},{10.0 * i},{0.1 * seed},0.2,0.3\n" for i in range(1, 11))
        (directory / "progress.csv").write_text(HEADER + lines)
        return find_policy(str(directory), tmp_path)

    return make


def test_an_envelope_leaves_out_every_command_at_which_a_robot_falls(monkeypatch):
    # Two episodes of each command: 0.4 and 0.8 m/s, 0.5 and 1.0 rad/s.
    fallen = np.array([False, False, False, True, False, False, False, False])
    means = np.array([[0.4, 0], [0.42, 0], [0.8, 0], [0.2, 0], [0, 0.5], [0, 0.7], [0, 1.0], [0, 0.8]])
    monkeypatch.setattr(recipe_seeds, "mean_velocities", lambda rollout: means)
    row = recipe_seeds.fastest(SimpleNamespace(fallen=fallen), straight=2, episodes=2)
    assert row == {"forwards, m/s": pytest.approx(0.41), "turning in place, rad/s": pytest.approx(0.9)}
    row = recipe_seeds.fastest(SimpleNamespace(fallen=np.ones(8, dtype=bool)), straight=2, episodes=2)
    assert set(row.values()) == {0.0}


def test_the_gait_is_that_of_the_worst_foot_at_the_worst_command(monkeypatch):
    def entry(command, clearance, bounces, cost=None, duty=(0.5, 0.5)):
        return {
            "duty_factor": list(duty),
            "command": command,
            "clearance": clearance,
            "bounces_per_stride": bounces,
            "electrical_cost_of_transport": cost,
        }

    commands = [
        entry([0.4, 0.0], [0.012, 0.011], [1.0, 1.1], 0.6),
        entry([0.5, 0.0], [0.009, 0.014], [1.2, 1.0], 0.7, (0.4, 0.6)),
        entry([-0.2, 0.0], [0.0, 0.013], [1.0, None]),
        entry([0.0, 0.5], [0.010, 0.020], [1.3, 1.4]),
        entry([0.3, -0.5], [0.015, 0.011], [1.0, 1.0]),
    ]
    monkeypatch.setattr(recipe_seeds, "run_gait", lambda part, measured, progress: {"commands": commands})
    assert recipe_seeds.gait(None, say_nothing) == pytest.approx(
        {
            "clearance forwards, mm": 9.0,
            "clearance backwards, mm": 0.0,
            "clearance turning, mm": 10.0,
            "bounces forwards": 1.2,
            "bounces backwards": np.nan,
            "bounces turning": 1.4,
            "duty factors apart forwards": 0.2,
            "duty factors apart backwards": 0.0,
            "electrical cost of transport": 0.6,
        },
        nan_ok=True,
    )


def test_errors_are_signed_and_those_of_the_scripted_gait_are_small():
    row = recipe_seeds.errors(Candidate("tuned", GaitController(), TaskConfig()), say_nothing, episodes=2)
    assert len(row) == len(recipe_seeds.STRAIGHT_COMMANDS) + len(recipe_seeds.TURN_COMMANDS)
    assert row["0 m/s"] == pytest.approx(0.0, abs=0.01)
    assert row["0.3 m/s"] == pytest.approx(0.0, abs=0.02)
    assert row["0 m/s, 0.5 rad/s"] == pytest.approx(-row["0 m/s, -0.5 rad/s"], abs=0.02)


def test_ten_hours_of_joystick_commands_are_a_minute_with_each_seed(monkeypatch):
    def run(part, measured, progress):
        assert part.num_seeds * part.seconds == pytest.approx(10 * 3600)
        return {"laws": {"undisturbed": {"falls_per_hour": {"mean": 0.1, "low": 0.0, "high": 0.6}}}}

    monkeypatch.setattr(recipe_seeds, "run_joystick", run)
    row = recipe_seeds.joystick_hours(None, say_nothing)
    assert row == {"falls per hour, undisturbed": 0.1, "95 % to, undisturbed": 0.6}


def test_regulation_is_that_of_the_policy_next_to_its_zero_action(monkeypatch):
    shares = {"flat": 0.75, "flat, zero action": 0.25}
    monkeypatch.setattr(
        recipe_seeds,
        "run_regulation",
        lambda part, measured, _: {"disturbances": {"friction_0.3": {"kept": {"mean": shares[measured.name]}}}},
    )
    row = recipe_seeds.regulation(Candidate.of_policy(load_policy("flat"), "flat"), say_nothing)
    assert row == {"friction_0.3": 75.0, "friction_0.3, zero action": 25.0}


def test_falls_in_the_own_env_are_counted_once_an_episode_with_their_interval(monkeypatch):
    policy = load_policy("flat")
    seconds = 3 * policy.config.control_timestep
    # Env 1 falls twice, as it restarts, and env 3 once: two of four, right after the start, when all commands are new.
    fallen = iter([[0, 1, 0, 0], [0, 1, 0, 1], [0, 0, 0, 0]])
    make = policy.make_vec_env

    def scripted(num_envs):
        env = make(num_envs)
        step = env.step
        monkeypatch.setattr(env, "step", lambda a: (*step(a)[:2], np.array(next(fallen), dtype=bool), *step(a)[3:]))
        return env

    monkeypatch.setattr(type(policy), "make_vec_env", lambda self, num_envs: scripted(num_envs))
    row = recipe_seeds.own_env(Candidate.of_policy(policy, "flat"), say_nothing, episodes=4, seconds=seconds)
    assert row == {
        "episodes": 4,
        "falls": 2,
        "falls, %": 50.0,
        "95 % from": pytest.approx(15.0, abs=0.1),
        "95 % to": pytest.approx(85.0, abs=0.1),
        "falls within 0.8 s of a new command": 2,
    }


def test_runs_of_a_recipe_differ_in_the_seed_only(trained):
    same = [trained("flat", 0), trained("flat", 1, timesteps=900), trained("rough", 0), trained("flat", 3, algo="sac")]
    groups = recipe_seeds.by_recipe(same)
    assert {name: len(runs) for name, runs in groups.items()} == {"flat": 2, "rough": 1, "flat, sac": 1}
    with pytest.raises(QuadrupedError, match=r"flat-2: expected the settings of .*flat-0"):
        recipe_seeds.by_recipe([*same, trained("flat", 2, timesteps=2000)])
    without_recipe = SimpleNamespace(name="odd", policy=same[0].policy.with_card({"seed": 0}))
    with pytest.raises(QuadrupedError, match=r"odd: expected a trained policy"):
        recipe_seeds.by_recipe([without_recipe])


def test_program_prints_tables_and_draws_curves(trained, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(recipe_seeds, "MEASURES", {"length": lambda measured, progress: {"mm": len(measured.name)}})
    runs = [str(trained(recipe, seed).directory) for recipe in ("flat", "walker") for seed in (0, 1)]
    picture = tmp_path / "new" / "curves.svg"
    assert recipe_seeds.run(argparse.Namespace(runs=runs, only=None, picture=picture)) == 0
    printed = capsys.readouterr().out
    assert "flat, length" in printed
    assert "walker, length" in printed
    assert picture.read_text().rstrip().endswith("</svg>")
