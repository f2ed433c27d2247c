"""Pushes: credit for following the command, and pushes as the simulation receives them."""

from dataclasses import replace

import numpy as np
import pytest
from synthetic import DT, falls, synthetic_rollout

from quadruped_env.evaluation.suite import changing
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import PARTS
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.policies import ZeroController
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import TaskConfig

PART = full_suite().pushes


def pushed_rollout(part, velocity, **changes):
    count = len(part.commands) * len(part.sizes) * part.num_seeds
    steps = round((part.before[1] + part.after) / DT)
    return synthetic_rollout(steps, count, velocity=np.tile(velocity, (steps, count, 1)), **changes)


def test_a_robot_that_stands_earns_nothing_under_a_command_to_move():
    part = replace(PART, commands=((0.3, 0.0), (0.0, 0.5), (-0.2, 0.0), (0.0, 0.0)), sizes=(1.0,), num_seeds=3)
    result = changing.push_measures(pushed_rollout(part, [0.0, 0.0]), part)
    assert result["survived"]["mean"] == 1.0
    assert [entry["obeyed"][0]["mean"] for entry in result["commands"]] == [0.0, 0.0, 0.0, 1.0]
    assert PARTS["pushes"][1](result, part) == 0.0


def test_only_the_time_after_the_push_counts_and_a_fall_earns_nothing():
    part = replace(PART, commands=((0.3, 0.0), (0.0, 0.0)), sizes=(1.0, 2.0), num_seeds=2)
    rollout = pushed_rollout(part, [0.0, 0.0])
    last = round(part.final / DT)
    moving = rollout.velocity.copy()
    moving[-last:, :4] = 0.36, -0.1
    moving[:-last] = 3.0
    valid = rollout.valid.copy()
    valid[-1, 3] = False
    joints = rollout.joint_velocity.copy()
    joints[-last:, 5] = 1.0  # marches
    found = changing.push_measures(replace(rollout, velocity=moving, fell=falls(valid), joint_velocity=joints), part)
    means = [[size["mean"] for size in entry["obeyed"]] for entry in found["commands"]]
    assert means == [[1.0, 0.5], [0.5, 1.0]]
    assert found["survived"]["mean"] == pytest.approx(7 / 8)
    assert PARTS["pushes"][1](found, part) == pytest.approx(0.75 * (1.0 - 0.2 * 0.25))


def test_pushes_have_six_components_and_random_times():
    drawn = [changing.push_of(PART, seed) for seed in range(2000)]
    times, scaled = np.array([time for time, _ in drawn]), np.array([push for _, push in drawn]) / PART.unit
    np.testing.assert_allclose(np.linalg.norm(scaled, axis=1), 1.0)
    np.testing.assert_allclose(scaled.mean(axis=0), 0.0, atol=0.04)
    np.testing.assert_allclose((scaled**2).mean(axis=0), 1.0 / 6.0, atol=0.02)
    assert (times.min() > 3.0, times.max() < 4.0) == (True, True)
    assert np.ptp(times) > 0.99


@pytest.fixture
def recorded(monkeypatch):
    """Arguments of every push."""
    pushed, push = [], BatchSimulation.push

    def record(self, env_ids, velocity):
        pushed.append((env_ids.copy(), velocity.copy()))
        push(self, env_ids, velocity)

    monkeypatch.setattr(BatchSimulation, "push", record)
    return pushed


STANDING = Candidate("standing", ZeroController(), TaskConfig())


def test_every_robot_is_pushed_once_by_its_own_push(recorded):
    part = replace(PART, sizes=(0.1, 0.2), num_seeds=2, before=(0.1, 0.4), after=0.2, final=0.1)
    changing.run_pushes(part, STANDING)
    ids = np.concatenate([env_ids for env_ids, _ in recorded])
    np.testing.assert_array_equal(np.sort(ids), np.arange(20))
    found = np.concatenate([velocity for _, velocity in recorded])[np.argsort(ids)] / PART.unit
    np.testing.assert_allclose(np.linalg.norm(found, axis=1), np.tile([0.1, 0.1, 0.2, 0.2], 5))
    np.testing.assert_array_equal(found[:4], found[4:8])  # the same under every command
    assert len({tuple(push) for push in found[:4]}) == 4
    assert len(recorded) > 2
