"""The tools: `echo` prints what was sent, recordings replay to the same motion, `teleop` drives the robot by keys."""

import os
import pty
import re
import select
import struct
import subprocess
import time
from collections import deque
from dataclasses import dataclass

import numpy as np
import pytest
from live_nodes import STAMP, joint_state, received_from, started
from trajectories import assert_same, random_trajectory
from waiting import DEADLINE, wait_until

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError, SinusoidalGait, asset_path
from quadruped_env.live import Network, Topic
from quadruped_env.live.__main__ import main
from quadruped_env.live.keyboard import DOWN, LEFT, RIGHT, UP, split_keys
from quadruped_env.live.message_recorder import Recorder
from quadruped_env.live.messages.message_text import as_yaml, field_at, plain
from quadruped_env.live.middleware.dds import open_participant
from quadruped_env.live.middleware.topics import CMD_VEL, ESTOP, JOINT_STATES, ROBOT_DESCRIPTION, TF
from quadruped_env.live.nodes.gamepad import Gamepad
from quadruped_env.live.nodes.listen import common_qos, rate_text
from quadruped_env.live.nodes.teleop import STAND, after
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import Qos, cdr
from quadruped_env.ros.robot_messages import transform_messages

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

DEEP = Qos(depth=1000)


def message_of(trajectory, row):
    return joint_state(
        int(trajectory.stamps[row]),
        trajectory.names,
        trajectory.positions[row],
        () if trajectory.velocities is None else trajectory.velocities[row],
        () if trajectory.efforts is None else trajectory.efforts[row],
    )


def test_echo_output_can_be_read_back(tmp_path):
    """By the reader of what `ros2 topic echo` prints, to the last bit: NaN, and numbers of any size."""
    trajectory = random_trajectory(40)
    file = tmp_path / "echo.yaml"
    file.write_text(
        "".join(as_yaml(plain(message_of(trajectory, row))) for row in range(len(trajectory))), encoding="utf-8"
    )
    assert_same(JointTrajectory.load(file), trajectory)


def test_echo_yaml_is_that_of_ros():
    """As `ros2 topic echo` prints it: its own documentation's form, block lists and `''` for an empty text."""
    message = joint_state(STAMP, ["a", "b"], [0.5, -1e-05])
    assert as_yaml(plain(message)) == (
        "header:\n  stamp:\n    sec: 1700000000\n    nanosec: 123456789\n  frame_id: ''\n"
        "name:\n- a\n- b\nposition:\n- 0.5\n- -1.0e-05\nvelocity: []\neffort: []\n---\n"
    )


def test_echo_field_is_chosen_by_its_path():
    values = plain(
        cdr.deserialize(
            next(transform_messages([STAMP], MINI_QUADRUPED.skeleton.joint_transforms(np.zeros(8)))), TF.type_name
        )
    )
    assert field_at(values, "transforms.0.header.stamp.sec") == 1_700_000_000
    assert as_yaml(field_at(values, "transforms.0.child_frame_id")) == "LF_hip\n---\n"
    assert field_at(values, "") is values
    with pytest.raises(QuadrupedError, match=r"--field transforms\.8: there is no '8'; there is a list of 8"):
        field_at(values, "transforms.8")
    with pytest.raises(QuadrupedError, match="there is no 'x'; there is transforms"):
        field_at(values, "x")


def test_listeners_print_and_record_every_message_of_a_reliable_topic(nodes, run_node, capsys, tmp_path):
    """Echo one by one, `hz` with its rate, and `record` into a bag whose trajectory is the one that was sent."""
    stamps = STAMP + 20_000_000 * np.arange(100)
    times = (stamps - STAMP) / 1e9
    gait = SinusoidalGait.preset("tuned")
    trajectory = JointTrajectory(
        stamps=stamps, names=JOINT_NAMES, positions=gait.positions(times), velocities=gait.velocities(times)
    )
    node, bag = nodes(), tmp_path / "bag"
    states, transforms = node.publish(JOINT_STATES, DEEP), node.publish(TF, DEEP)
    node.publish(ROBOT_DESCRIPTION).send(cdr.message("std_msgs/msg/String", data=MINI_QUADRUPED.urdf))
    tf_bytes = list(transform_messages(stamps.tolist(), MINI_QUADRUPED.skeleton.joint_transforms(trajectory.positions)))
    # Without the slash, the name is relative to the node's namespace.
    echo = run_node("echo", "joint_states", "--field", "position")
    listeners = [echo, run_node("hz"), run_node("record", "-o", str(bag))]
    wait_until(lambda: (states.readers, transforms.readers) == (3, 2))
    for row in range(100):
        states.send(message_of(trajectory, row))
        transforms.send_bytes(tf_bytes[row])
    assert states.wait_until_read(DEADLINE)
    assert transforms.wait_until_read(DEADLINE)
    printed = []
    for listener in listeners:
        assert listener.interrupt() == 0
        printed.append(capsys.readouterr().out)
    lines = "".join(printed)
    position = "".join(as_yaml(row.tolist()) for row in trajectory.positions)
    assert "".join(line for line in lines.splitlines(True) if line.startswith("-")) == position
    rates = re.findall(r"^/joint_states: average rate \d+\.\d\d Hz, period .* ms, (\d+) messages$", lines, re.MULTILINE)
    assert rates[-1] == "100"
    assert f"201 messages of 3 topics: {bag}" in lines
    assert_same(JointTrajectory.load(bag), trajectory)
    assert contents(bag)["/tf"] == tf_bytes
    assert_read_by_others(bag, trajectory)


def test_echo_ends_when_its_output_is_closed(nodes):
    """As with `echo ... | head -1`."""
    publisher = nodes().publish(JOINT_STATES)
    with started("echo", "/joint_states", stderr=subprocess.PIPE) as process:
        wait_until(lambda: publisher.readers)

        def ended():
            publisher.send(joint_state())
            return process.poll() is not None

        wait_until(lambda: publisher.send(joint_state()) or select.select([process.stdout], [], [], 0.01)[0])
        assert process.stdout.readline() == "header:\n"
        process.stdout.close()
        wait_until(ended)
        assert "Traceback" not in process.stderr.read()
    assert process.returncode == 141


def test_list_names_topics_types_owners_and_incompatibilities(nodes, capsys):
    one, other = nodes("one"), nodes("other")
    one.publish(JOINT_STATES, Qos(10, reliable=False))
    other.subscribe(JOINT_STATES)

    def listed():
        """Output once it has found both: it listens for a moment only, which a busy machine may miss."""
        assert main(["list", "--verbose", "--seconds", "0.3"]) == 0
        lines = capsys.readouterr().out.splitlines()
        return lines if len(lines) >= 4 else None

    lines = wait_until(listed, "the topic, its two ends and the problem")
    assert lines[0] == "/joint_states [sensor_msgs/msg/JointState]"
    assert lines[1].startswith(f"    publisher    one (process {os.getpid()} on ")
    assert ": best effort, volatile, RIHS01_a13ee3a3" in lines[1]
    assert lines[2].startswith(f"    subscription other (process {os.getpid()} on ")
    assert lines[3].startswith("! /joint_states, from one (process")
    assert "the reader requests reliable delivery, the writer offers best effort" in lines[3]


def test_hz_rates_are_those_of_the_arrivals():
    assert rate_text(deque([1.0, 1.01, 1.03, 1.04])) == (
        "average rate 75.00 Hz, period 10.00 to 20.00 ms, standard deviation 4.71 ms, 4 messages"
    )
    assert rate_text(deque([1.0])) == "1 message"


def test_common_qos_is_what_all_publishers_offer():
    reliable, latched, loose = Qos(5), Qos(1, transient_local=True), Qos(7, reliable=False)
    assert common_qos([reliable, latched], "/other") == Qos(10)
    assert common_qos([latched, latched], "/robot_description") == Qos(1, transient_local=True)
    assert common_qos([reliable, loose], "/tf") == Qos(100, reliable=False)


def assert_read_by_others(bag, trajectory):
    """An independent reader finds the positions, and the URDF whole."""
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    positions, texts = [], []
    with next(bag.glob("*.mcap")).open("rb") as file:
        for _, channel, _, message in make_reader(file, decoder_factories=[DecoderFactory()]).iter_decoded_messages():
            if channel.topic == "/joint_states":
                positions.append(message.position)
            elif channel.topic == "/robot_description":
                texts.append(message.data)
    np.testing.assert_array_equal(positions, trajectory.positions)
    assert texts == [asset_path("mini_quadruped.urdf").read_text(encoding="utf-8")]


def contents(bag):
    """Topic -> bytes of its messages, as rosbags reads a bag."""
    from rosbags.rosbag2 import Reader

    found = {}
    with Reader(bag) as reader:
        for connection, _, data in reader.messages():
            found.setdefault(connection.topic, []).append(bytes(data))
    return found


def test_recording_keeps_the_qos_of_publishers(tmp_path):
    from rosbags.interfaces import QosDurability, QosReliability
    from rosbags.rosbag2 import Reader

    with Recorder(tmp_path / "bag") as recorder:
        recorder.write(ROBOT_DESCRIPTION, cdr.serialize(cdr.message("std_msgs/msg/String", data=MINI_QUADRUPED.urdf)))
        recorder.write(Topic("/joint_states", JOINT_STATES.type_name, Qos(10, False)), cdr.serialize(joint_state()))
    with Reader(tmp_path / "bag") as reader:
        profiles = {one.topic: one.ext.offered_qos_profiles[0] for one in reader.connections}
    assert profiles["/robot_description"].durability == QosDurability.TRANSIENT_LOCAL
    assert profiles["/joint_states"].durability == QosDurability.VOLATILE
    assert profiles["/joint_states"].reliability == QosReliability.BEST_EFFORT


def test_times_of_recording_increase_even_within_a_burst(tmp_path, monkeypatch):
    from rosbags.rosbag2 import Reader

    monkeypatch.setattr(time, "time_ns", lambda: STAMP)
    with Recorder(tmp_path / "bag") as recorder:
        for i in range(5):
            recorder.write(JOINT_STATES, cdr.serialize(joint_state(STAMP - i)))
    with Reader(tmp_path / "bag") as reader:
        assert [time for _, time, _ in reader.messages()] == [STAMP + i for i in range(5)]


def test_recorder_with_an_existing_bag_is_refused(tmp_path):
    (tmp_path / "bag").mkdir()
    with pytest.raises(QuadrupedError, match="bag: exists already; name another place"):
        Recorder(tmp_path / "bag")


def test_record_without_messages_reports_it(domain_id, tmp_path, capsys):
    assert main(["record", "/joint_states", "--seconds", "0.3", "-o", str(tmp_path / "bag")]) == 2
    waited = f"nothing to record on domain {domain_id}, this machine only: waited for a publisher of /joint_states for "
    assert waited in capsys.readouterr().err
    assert not (tmp_path / "bag").exists()


@pytest.mark.parametrize("tool", [("echo", "nothing", "--once"), ("hz", "nothing")])
def test_tool_without_messages_ends_with_what_it_waited_for_and_what_there_is(tool, domain_id, nodes, capsys):
    def last_line():
        assert main([*tool, "--seconds", "0.5"]) == 2
        return capsys.readouterr().err.splitlines()[-1]

    last = last_line()
    assert f" on domain {domain_id}, this machine only: waited for a publisher of /nothing for 0." in last
    assert "live display', or look in another domain (ROS_DOMAIN_ID)" in last
    nodes().publish(TF)
    wait_until(lambda: last_line().endswith("; published there: /tf"))


def test_list_without_topics_says_where_it_looked_and_what_to_do(domain_id, capsys):
    assert main(["list", "--seconds", "0.1"]) == 0
    output = "".join(capsys.readouterr())
    assert f"listened on domain {domain_id}, this machine only for " in output
    assert " s; no topic is published there: start a node, such as " in output


def test_record_refuses_a_type_that_is_not_known(domain_id, tmp_path, capsys):
    """A type of DDS that is not one of ROS."""
    from cyclonedds.idl import IdlStruct
    from cyclonedds.pub import DataWriter
    from cyclonedds.topic import Topic as DdsTopic

    @dataclass
    class Strange(IdlStruct, typename="Strange"):
        x: int

    participant = open_participant(Network.from_environment(), "stranger")
    writer = DataWriter(participant, DdsTopic(participant, "rt/strange", Strange))
    assert main(["record", "strange", "-o", str(tmp_path / "bag")]) == 2
    assert writer is not None
    words = "error: /strange: has the unknown type Strange; known types: sensor_msgs/msg/JointState"
    assert words in capsys.readouterr().err


@pytest.mark.parametrize(
    ("data", "keys", "rest"),
    [
        (b"w \x1b[A\x1bOD", ["w", " ", UP, LEFT], b""),
        (b"\x1b[B\x1b[C\x1b[", [DOWN, RIGHT], b"\x1b["),
        (b"\x1b[5~\x1b[1;5Hq", ["q"], b""),
        (b"\x1b", [], b"\x1b"),
    ],
)
def test_keys_are_split_from_the_bytes_of_a_terminal(data, keys, rest):
    assert split_keys(data) == (keys, rest)


def test_keys_step_the_command_within_its_range():
    command = STAND
    for _ in range(20):
        command = after(after(after(command, UP), LEFT), ",")
    assert command == (0.6, 0.8, 0.2)
    for _ in range(20):
        command = after(after(after(command, "s"), "d"), ".")
    assert command == (-0.3, -0.8, -0.2)
    assert after(command, "x") == command
    assert after(command, " ") == STAND


def test_teleop_publishes_the_commands_of_its_keys_and_zero_when_it_ends(nodes, run_node, monkeypatch):
    velocities = nodes().subscribe(CMD_VEL, DEEP)
    ours, terminal = pty.openpty()
    commands = []

    def take():
        for _, twist in velocities.messages(pytest.fail):
            command = (twist.linear.x, twist.angular.z, twist.linear.y)
            if not commands or commands[-1] != command:
                commands.append(command)
        return commands

    with open(terminal, encoding="utf-8") as stdin:
        monkeypatch.setattr("sys.stdin", stdin)
        teleop = run_node("teleop")
        wait_until(take, lambda: teleop.said)
        walked = ((b"\x1b[A", (0.1, 0.0, 0.0)), (b"\x1b[A\x1b[C", (0.2, -0.2, 0.0)), (b".", (0.2, -0.2, -0.1)))
        for key, expected in walked:
            os.write(ours, key)
            wait_until(lambda expected=expected: take()[-1] == expected)
        os.write(ours, b"q")
        assert teleop.status() == 0
    wait_until(lambda: take()[-1] == STAND)
    assert commands == [STAND, *(expected for _, expected in walked), STAND]
    os.close(ours)


@pytest.fixture
def pad(tmp_path):
    """A pipe instead of the device `js0`, to which a test writes the events of Linux's joystick interface."""
    os.mkfifo(tmp_path / "js0")
    with (tmp_path / "js0").open("r+b", buffering=0) as pad:
        yield pad


def test_gamepad_sends_commands_while_it_is_enabled_and_stops(pad, nodes, run_node, tmp_path):
    def event(kind, number, value):
        return struct.pack("=IhBB", 0, value, kind, number)

    robot = nodes()
    velocities, stops = robot.subscribe(CMD_VEL, DEEP), robot.subscribe(ESTOP)
    log = run_node("gamepad", "--device", str(tmp_path / "js0"))
    wait_until(lambda: velocities.writers and stops.writers)
    sent = []

    def until(forward, turn, left=0.0):
        def sends():
            sent.extend(velocities.decode(one) for one in velocities.take())
            last = sent and (sent[-1].linear.x, sent[-1].angular.z, sent[-1].linear.y)
            return sent and last == pytest.approx((forward, turn, left))

        wait_until(sends, lambda: log.said)

    # The states at the start; sticks fully forward and half to the right.
    start = event(0x82, 1, -32767) + event(0x82, 3, 16384)
    pad.write(start + event(0x01, 4, 1))
    until(0.6, -0.8 * 16384 / 32767)
    assert len(sent) < 100
    pad.write(event(0x02, 1, 32767) + event(0x02, 3, -3000) + event(0x02, 0, -32767))
    until(-0.3, 0.0, 0.2)
    pad.write(event(0x02, 0, 0) + event(0x01, 4, 0))
    until(0.0, 0.0)
    pad.write(event(0x01, 1, 1))
    assert stops.decode(received_from(stops, 1)[0]).data
    pad.write(event(0x01, 1, 0) + event(0x01, 7, 1))
    assert not stops.decode(received_from(stops, 1)[0]).data
    assert not velocities.take()
    # Unplugged while the robot walks.
    pad.write(event(0x01, 4, 1))
    until(-0.3, 0.0)
    pad.close()
    until(0.0, 0.0)
    assert log.status() == 2
    assert "js0: was unplugged" in log.said


def test_gamepad_with_a_wrong_number_of_axes_is_an_error(domain_id, capsys):
    assert main(["gamepad", "--axes", "1"]) == 2
    assert "--axes: expected two or three numbers: forward, turn, left; found 1" in capsys.readouterr().err


def test_gamepad_that_is_missing_is_an_error(domain_id, tmp_path, capsys):
    assert main(["gamepad", "--device", str(tmp_path / "js0")]) == 2
    assert "cannot read" in capsys.readouterr().err
    os.mkfifo(tmp_path / "js1")
    # Without a writer, as a device after it was unplugged.
    with Gamepad(tmp_path / "js1") as gamepad, pytest.raises(QuadrupedError, match="js1: was unplugged"):
        gamepad.update()


def test_teleop_needs_a_terminal(domain_id, capsys, monkeypatch):
    with open(os.devnull, encoding="utf-8") as nothing:
        monkeypatch.setattr("sys.stdin", nothing)
        assert main(["teleop"]) == 2
    assert "error: the keyboard: standard input is not a terminal" in capsys.readouterr().err
