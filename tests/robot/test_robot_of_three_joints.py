"""A robot with three joints per leg in recordings, maps, replay and ROS: as with two, by the robot's own names."""

from pathlib import Path

import numpy as np
import pytest
from twelve_joints import JOINTS, ROBOT

from quadruped_env import JointTrajectory
from quadruped_env.cli.main import main
from quadruped_env.replay.replay import replay

FILE = "from twelve_joints import ROBOT\n"
MAP = """[joints.{joint}]
source = "motor_{index}"
sign = -1
offset = 0.1
"""


@pytest.fixture
def task(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "task.py").write_text(FILE)
    return "--task", "task.py"


@pytest.fixture(scope="module")
def recording():
    """Two seconds of the joints about the stance, each at its own frequency and amplitude."""
    t = np.arange(101) / 50
    angle = 2.0 * np.pi * (0.5 + 0.05 * np.arange(12)) * t[:, None]
    positions = ROBOT.stance + np.linspace(0.05, 0.1, 12) * np.sin(angle)
    return JointTrajectory(np.rint(t * 1e9).astype(np.int64), JOINTS, positions)


def test_bag_and_csv_hold_the_same_recording(recording, task):
    highlevel = pytest.importorskip("rosbags.highlevel")
    recording.save("a.csv")
    assert main(["convert", "a.csv", "bag", *task]) == 0
    assert main(["convert", "bag", "b.csv", *task]) == 0
    with open("a.csv", "rb") as one, open("b.csv", "rb") as other:
        assert one.read() == other.read()
    with highlevel.AnyReader([Path("bag")]) as reader:
        (topic,) = (one for one in reader.connections if one.topic == "/robot_description")
        ((_, _, message),) = reader.messages([topic])
        assert reader.deserialize(message, topic.msgtype).data == ROBOT.description


def test_recording_with_other_names_and_signs_is_mapped(recording, task):
    other = JointTrajectory(recording.stamps, [f"motor_{i}" for i in range(12)], 0.1 - recording.positions)
    shuffled = np.random.default_rng(0).permutation(12)
    names = [other.names[i] for i in shuffled]
    JointTrajectory(other.stamps, names, other.positions[:, shuffled]).save("other.csv")
    with open("map.toml", "w", encoding="utf-8") as file:
        file.writelines(MAP.format(joint=joint, index=i) for i, joint in enumerate(JOINTS))
    assert main(["convert", "other.csv", "mapped.csv", "--map", "map.toml", *task]) == 0
    found = JointTrajectory.load("mapped.csv", names=JOINTS, unit="rad")
    assert found.names == JOINTS
    np.testing.assert_allclose(found.positions, recording.positions, rtol=0, atol=1e-12)


def test_replay_repeats_its_recording(recording):
    first = replay(recording, robot=ROBOT)
    assert np.ptp(first.played.positions, axis=0).min() > 0.05, "all joints move"
    recorded, simulated = replay(recording, measured=first.played, robot=ROBOT).comparison
    assert recorded.names == simulated.names == JOINTS
    for signal in ("positions", "velocities", "efforts"):
        np.testing.assert_array_equal(getattr(simulated, signal), getattr(recorded, signal))
