"""A policy of a robot with three joints per leg, from its task file to its env, its file and the live controller."""

import csv
import inspect
import json

import numpy as np
import pytest
import twelve_joints
from trainings import SMALL
from twelve_joints import ROBOT

from quadruped_env import QuadrupedError
from quadruped_env.control.live_controller import LiveController
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.policies import PolicyController, load_policy
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.training import TrainConfig
from quadruped_env.training.run_directory import PROGRESS_FILE


@pytest.fixture(scope="module")
def task_file(tmp_path_factory):
    file = tmp_path_factory.mktemp("task") / "my_robot.py"
    file.write_text(inspect.getsource(twelve_joints))
    return file


@pytest.fixture(scope="module")
def run(task_file):
    from quadruped_env.training.train import train

    config = TrainConfig(**SMALL, timesteps=256)
    return train(config, task_file.parent / "runs", "train", task_file=task_file)[0]


def test_a_training_makes_a_policy_that_follows_three_commands(run, task_file):
    policy = load_policy(run, task_file)
    assert policy.robot == ROBOT
    assert [entry.name for entry in policy.control.commands] == ["forward_velocity", "yaw_rate", "lateral_velocity"]
    env = policy.make_env()
    observation, _ = env.reset(seed=0, options={"command": (0.1, 0.0, -0.2)})
    action = policy.predict(observation)
    assert action.shape == (12,)
    *_, info = env.step(action)
    np.testing.assert_array_equal(info["command"], [0.1, 0.0, -0.2])
    with pytest.raises(QuadrupedError, match="robot"):
        load_policy(run)


def test_the_policy_of_a_saved_copy_is_the_same(run, task_file, tmp_path):
    policy = load_policy(run, task_file)
    policy.save(tmp_path / "copy")
    copy = load_policy(tmp_path / "copy", task_file)
    assert copy.control == policy.control
    seen = np.random.default_rng(0).normal(size=(5, policy.weights[0].shape[0])).astype(np.float32)
    np.testing.assert_array_equal(copy.predict(seen), policy.predict(seen))


def test_a_gait_that_another_processor_rounds_is_the_same(run, task_file, tmp_path):
    load_policy(run, task_file).save(tmp_path / "copy")
    file = tmp_path / "copy" / CARD_FILE
    card = json.loads(file.read_text())
    card["scripted_gait"]["lateral"][1][2][0] += 1e-6
    file.write_text(json.dumps(card))
    load_policy(tmp_path / "copy", task_file)
    card["scripted_gait"]["lateral"][1][2][0] += 1e-3
    file.write_text(json.dumps(card))
    with pytest.raises(QuadrupedError, match="scripted_gait differs"):
        load_policy(tmp_path / "copy", task_file)


def test_the_policy_is_symmetric(run, task_file):
    """To the rounding of float32: rolls turn the other way, and so do yaw rate and lateral velocity."""
    policy = load_policy(run, task_file)
    mirror = MirrorMap.of(ObservationLayout(ROBOT, history=policy.control.observation_history))
    seen = np.random.default_rng(0).normal(size=(5, policy.weights[0].shape[0])).astype(np.float32)
    mirrored = policy.predict(mirror.observation(seen))
    np.testing.assert_allclose(mirrored, mirror.action(policy.predict(seen)), atol=1e-5)


def test_progress_has_the_error_of_each_velocity(run):
    with (run / PROGRESS_FILE).open() as file:
        rows = list(csv.DictReader(file))
    names = list(rows[0])
    assert names[4:7] == ["forward_velocity_error", "yaw_rate_error", "lateral_velocity_error"]
    # The largest command sideways is half as fast as the one forwards, and a turn counts in rad/s.
    for row in rows:
        forward, turn, sideways = (float(row[name]) for name in names[4:7])
        assert 0.0 < sideways < turn
        assert sideways != forward


def test_the_live_controller_takes_what_the_robot_has_of_a_velocity(run, task_file):
    policy = load_policy(run, task_file)
    live = LiveController(PolicyController(policy))
    for velocity, expected in (((0.1,), (0.1, 0, 0)), ((0.1, 0.2), (0.1, 0.2, 0)), ((0.0, 0.0, -9.0), None)):
        live.command(velocity, now=0.0)
        low = policy.control.commands[2].range[0]
        np.testing.assert_array_equal(live._command, (0.0, 0.0, low) if expected is None else expected)
