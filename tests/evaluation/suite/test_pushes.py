"""Pushes: credit for what was asked, 50 % points against known curves, and pushes as the simulation gets them."""

from dataclasses import replace

import numpy as np
import pytest
from synthetic import DT, falls, synthetic_rollout

from quadruped_env.evaluation.suite import pushes
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite import PARTS
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.policies import ZeroController
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import TaskConfig

PART = full_suite().pushes
SIZES = np.array(PART.horizontal_sizes)


def pooled(values):
    """Non-increasing isotonic regression by pooling adjacent violators, one after the other."""
    blocks = []
    for value in values:
        blocks.append([value, 1])
        while len(blocks) > 1 and blocks[-2][0] < blocks[-1][0]:
            last, before = blocks.pop(), blocks.pop()
            count = last[1] + before[1]
            blocks.append([(last[0] * last[1] + before[0] * before[1]) / count, count])
    return [value for value, count in blocks for _ in range(count)]


def test_isotonic_fit_by_hand_and_by_pooling():
    np.testing.assert_allclose(pushes.non_increasing(np.array([[1.0, 0.4, 0.6, 0.2]])), [[1.0, 0.5, 0.5, 0.2]])
    lines = np.random.default_rng(0).integers(0, 17, (200, 11)) / 16.0
    np.testing.assert_allclose(pushes.non_increasing(lines), [pooled(line) for line in lines])


@pytest.mark.parametrize(
    ("shares", "expected"),
    [
        ([1.0, 1.0, 0.0, 0.0], 0.3),
        ([1.0, 0.75, 0.25, 0.0], 0.3),
        ([1.0, 0.5, 0.0, 0.0], 0.2),
        ([1.0, 0.9, 0.8, 0.7], 0.6),  # more than half survive the largest push
        ([0.4, 0.2, 0.0, 0.0], 0.0),  # most fall without a push
    ],
)
def test_half_point_is_interpolated(shares, expected):
    assert pushes.half_point(np.array([0.0, 0.2, 0.4, 0.6]), np.array([shares]))[0] == pytest.approx(expected)


def logistic(middle, width, seeds, generator):
    """Survival of a logistic law with a known 50 % point (K, S)."""
    return generator.random((len(SIZES), seeds)) < 1.0 / (1.0 + np.exp((SIZES[:, None] - middle) / width))


@pytest.mark.parametrize("middle", [0.55, 0.9, 1.3])
def test_half_survival_of_a_logistic_law_is_its_middle(middle):
    generator = np.random.default_rng(1)
    found = pushes.half_survival(SIZES, logistic(middle, 0.1, 4000, generator))
    assert found["mean"] == pytest.approx(middle, abs=0.02)
    assert found["low"] <= found["mean"] <= found["high"]
    assert found["high"] - found["low"] < 0.03
    assert not found["censored"]


def test_interval_of_the_half_point_covers_the_truth_about_as_often_as_it_says():
    generator = np.random.default_rng(2)
    covered = 0
    for _ in range(100):
        found = pushes.half_survival(SIZES, logistic(0.9, 0.15, 16, generator))
        covered += found["low"] - 0.02 <= 0.9 <= found["high"] + 0.02  # interpolation errs by less than 0.02
    assert covered >= 88


def test_half_survival_of_a_robot_that_never_falls_is_censored():
    found = pushes.half_survival(SIZES, np.ones((len(SIZES), 16), dtype=bool))
    assert found == {"mean": 2.0, "low": 2.0, "high": 2.0, "censored": True}


def test_survival_by_size_and_direction():
    part = replace(PART, horizontal_sizes=(0.0, 0.5, 1.0), directions=(0.0, 90.0))
    survived = np.zeros((3, 2, 4), dtype=bool)
    survived[0] = True
    survived[1, 0] = True
    survived[1, 1, :2] = True
    result = pushes.survival(part, survived)
    assert result["survived"] == [[1.0, 1.0], [1.0, 0.5], [0.0, 0.0]]
    assert [entry["mean"] for entry in result["by_size"]] == [1.0, 0.75, 0.0]
    assert [entry["mean"] for entry in result["half_survival"]] == [0.75, 0.5]


def pushed_rollout(part, velocity, **changes):
    count = len(part.commands) * len(part.sizes) * part.num_seeds
    steps = round((part.before[1] + part.after) / DT)
    return synthetic_rollout(steps, count, velocity=np.tile(velocity, (steps, count, 1)), **changes)


def test_a_robot_that_stands_earns_nothing_under_a_command_to_move():
    part = replace(PART, commands=((0.3, 0.0), (0.0, 0.5), (-0.2, 0.0), (0.0, 0.0)), sizes=(1.0,), num_seeds=3)
    result = pushes.obeyed(part, pushed_rollout(part, [0.0, 0.0]))
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
    found = pushes.obeyed(part, replace(rollout, velocity=moving, fell=falls(valid), joint_velocity=joints))
    means = [[size["mean"] for size in entry["obeyed"]] for entry in found["commands"]]
    assert means == [[1.0, 0.5], [0.5, 1.0]]
    assert found["survived"]["mean"] == pytest.approx(7 / 8)
    assert PARTS["pushes"][1](found, part) == pytest.approx(0.75 * (1.0 - 0.2 * 0.25))


def test_pushes_have_six_components_and_random_times():
    drawn = [pushes.push_of(PART, seed) for seed in range(2000)]
    times, scaled = np.array([time for time, _ in drawn]), np.array([push for _, push in drawn]) / PART.unit
    np.testing.assert_allclose(np.linalg.norm(scaled, axis=1), 1.0)
    np.testing.assert_allclose(scaled.mean(axis=0), 0.0, atol=0.04)
    np.testing.assert_allclose((scaled**2).mean(axis=0), 1.0 / 6.0, atol=0.02)
    assert (times.min() > 3.0, times.max() < 4.0) == (True, True)
    assert np.ptp(times) > 0.99


@pytest.fixture
def recorded(monkeypatch):
    """Arguments of every push, with the attitudes before it."""
    pushed, push = [], BatchSimulation.push

    def record(self, env_ids, velocity):
        pushed.append((env_ids.copy(), velocity.copy(), self.readings.orientation[env_ids].copy()))
        push(self, env_ids, velocity)

    monkeypatch.setattr(BatchSimulation, "push", record)
    return pushed


STANDING = MeasuredController("standing", ZeroController(), TaskConfig())


def test_every_robot_is_pushed_once_by_its_own_push(recorded):
    part = replace(
        PART, sizes=(0.1, 0.2), num_seeds=2, before=(0.1, 0.4), after=0.2, final=0.1, horizontal_sizes=(0.0,)
    )
    result = pushes.run(part, STANDING)
    ids = np.concatenate([env_ids for env_ids, _, _ in recorded[:-1]])  # the last call pushes no robot
    np.testing.assert_array_equal(np.sort(ids), np.arange(20))
    found = np.concatenate([velocity for _, velocity, _ in recorded[:-1]])[np.argsort(ids)] / PART.unit
    np.testing.assert_allclose(np.linalg.norm(found, axis=1), np.tile([0.1, 0.1, 0.2, 0.2], 5))
    np.testing.assert_array_equal(found[:4], found[4:8])  # the same under every command
    assert len({tuple(push) for push in found[:4]}) == 4
    assert len(recorded) > 2
    assert np.array(result["horizontal"]["survived"]).shape == (1, 8)


def test_horizontal_push_has_its_size_and_direction_relative_to_the_heading(recorded):
    part = replace(PART, horizontal_sizes=(0.0, 0.4), directions=(0.0, 90.0, 225.0), horizontal_seeds=3)
    part = replace(part, before=(0.5, 0.6), after=0.1, sizes=(1.0,), num_seeds=1, final=0.1)
    pushes.run(part, STANDING)
    env_ids, velocity, orientation = recorded[-1]
    np.testing.assert_array_equal(env_ids, np.arange(9, 18))  # the first nine are not pushed
    np.testing.assert_allclose(np.hypot(velocity[:, 0], velocity[:, 1]), 0.4)
    np.testing.assert_array_equal(velocity[:, 2:], 0.0)
    heading = 2.0 * np.arctan2(orientation[:, 3], orientation[:, 0])
    relative = np.arctan2(velocity[:, 1], velocity[:, 0]) - heading
    expected = np.repeat(np.radians(part.directions), 3)
    np.testing.assert_allclose(np.cos(relative - expected), 1.0, atol=2e-3)
    assert np.ptp(heading) > 1.0
