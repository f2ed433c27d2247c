"""A user's own randomizations are off in recordings and evaluations, and in the viewer unless it shows them."""

import numpy as np
import pytest
from comparisons import random_policy

from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.recorded_episode import record
from quadruped_env.policies import ControllerSpec, PolicyController
from quadruped_env.task import BUILT_IN, TaskConfig, load_task_file, preset_values
from quadruped_env.viewer import ViewController
from quadruped_env.viewer.viewed_robot import RANDOMIZATIONS

OWN = """
from quadruped_env.task import ModelField, Randomization


def aside(event, values):
    event.qpos[:, :2] += values


def kick(event, values):
    velocity = values * [0.0, 1.0, 0.0]
    event.simulation.push(event.env_ids, velocity)


masses = Randomization("body_mass", ModelField("body_mass"), (1.5, 2.0))
start = Randomization("start_position", aside, (1.0, 2.0), "m", 2)
kicks = Randomization("kick", kick, (0.3, 0.5), "m/s", interval=("kick_interval", (0.1, 0.2)))
"""
REPLACED = """
tilt = Randomization("start_tilt", aside, (3.0, 4.0), "m", 2)
"""
COMMANDS = ((0.3, 0.0), (0.0, 0.5))


@pytest.fixture
def added(tmp_path):
    """The built-in task with randomizations of a user's file, each of which moves the robot visibly."""
    file = tmp_path / "added.py"
    file.write_text(OWN)
    return load_task_file(file)


@pytest.fixture
def own(tmp_path):
    """As `added`, and one that replaces a built-in one."""
    file = tmp_path / "own.py"
    file.write_text(OWN + REPLACED)
    return load_task_file(file)


def policy(definition):
    return random_policy("residual", definition=definition)


def test_task_without_randomization_has_every_one_off_and_a_preset_those_of_the_user(own):
    config = TaskConfig.from_dict({"task_file": own.file.to_dict(), "randomization": {"observation_noise": 1.0}}, own)
    assert config.randomization.kick == (0.3, 0.5)
    off = config.without_randomization().randomization
    names = {entry.name for entry in own.randomizations}
    assert {"body_mass", "start_position", "kick", "start_tilt", "friction"} < names
    assert {name for name in names if off[name] is not None} == set()
    assert off.observation_noise == 0.0
    moderate = config.randomized("moderate").randomization
    assert (moderate.friction, moderate.observation_noise) == ((0.5, 1.1), 1.0)
    plain = TaskConfig().randomized("moderate").randomization
    assert [plain[name] for name in preset_values("moderate")] == [moderate[name] for name in preset_values("moderate")]
    different = {name for name in names if moderate[name] != plain.get(name)}
    assert different == {"start_tilt"}
    assert moderate.start_tilt is None


def test_recording_is_the_same_with_randomizations_of_a_user(own):
    plain, randomized = (
        record(PolicyController(policy(definition)), 0.5, (0.3, 0.2), policy(definition).config)
        for definition in (BUILT_IN, own)
    )
    np.testing.assert_array_equal(plain.base_pose, randomized.base_pose)
    np.testing.assert_array_equal(plain.joint_position, randomized.joint_position)


def test_evaluation_randomizes_the_built_in_start_alone(added, own):
    plain, same, without_tilt = (
        compare(policy(definition), 2, 2.0, COMMANDS).rollouts for definition in (BUILT_IN, added, own)
    )
    for name in ("policy", "tuned"):
        assert plain[name].joint_position[0].std(axis=0).min() > 0.0, "starts are random"
        np.testing.assert_array_equal(same[name].base_pose, plain[name].base_pose)
        np.testing.assert_array_equal(same[name].joint_position, plain[name].joint_position)
        assert np.abs(without_tilt[name].base_pose[0, :, :2]).max() < 0.1


def walked(definition, name, tmp_path):
    """Base poses of the viewer's robot over a second, with one of the viewer's randomizations."""
    source = ControllerSpec("policy", lambda: PolicyController(policy(definition)))
    view = ViewController({"policy": source}, ["policy"], tmp_path)
    try:
        view.set_randomization(name)
        view.set_command(0.3, 0.2)
        for _ in range(10):
            view.advance(0.1)
        return np.array([moment.base_pose for moment in view.view().robots[0].history])
    finally:
        view.close()


def test_randomizations_of_a_user_are_on_in_the_viewer_only_as_trained(own, tmp_path):
    off, *_, as_trained = RANDOMIZATIONS
    np.testing.assert_array_equal(walked(own, off, tmp_path), walked(BUILT_IN, off, tmp_path))
    for name in RANDOMIZATIONS:
        aside = np.abs(walked(own, name, tmp_path)[0, :2]).min() > 0.9
        assert aside == (name == as_trained)
