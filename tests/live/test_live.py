"""Live topics: messages equal ROS 2's, and connections that cannot work are reported in words."""

import os
import re
import signal
import socket
import sys

import numpy as np
import psutil
import pytest
from live_nodes import STAMP, joint_state, received_from
from manual_clock import ManualClock
from random_messages import filled
from waiting import DEADLINE, wait_until

from quadruped_env import JOINT_NAMES, QuadrupedError, asset_path, forward_kinematics
from quadruped_env.live import TOPICS, Network, Node, Topic
from quadruped_env.live.__main__ import main
from quadruped_env.live.messages.joint_messages import JointReader
from quadruped_env.live.middleware.topics import JOINT_STATES, ROBOT_DESCRIPTION, TF, TF_STATIC
from quadruped_env.live.pace import Pace
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import MESSAGE_TYPES, Qos, cdr

pytest.importorskip("cyclonedds")


def test_every_type_arrives_as_it_was_sent(nodes):
    node, rng = nodes(), np.random.default_rng(0)
    topics = [Topic(f"/test/{name.rpartition('/')[2].lower()}", name, Qos(depth=100)) for name in MESSAGE_TYPES]
    ends = [(node.publish(topic), node.subscribe(topic)) for topic in topics]
    sent = {topic.name: [cdr.serialize(filled(topic.type_name, rng)) for _ in range(5)] for topic in topics}
    wait_until(lambda: all(publisher.readers and subscription.writers for publisher, subscription in ends))
    for publisher, _ in ends:
        for data in sent[publisher.topic.name]:
            publisher.send_bytes(data)
    for _, subscription in ends:
        received = received_from(subscription, 5)
        # DDS pads the last word.
        assert [one.data[: len(data)] for one, data in zip(received, sent[subscription.topic.name], strict=True)] == (
            sent[subscription.topic.name]
        )
        assert cdr.serialize(subscription.decode(received[0])) == sent[subscription.topic.name][0]


def test_names_types_and_hashes_are_those_of_ros(nodes):
    node, other = nodes("one"), nodes("two")
    node.publish(JOINT_STATES)
    other.subscribe(TOPICS["/clock"])
    wait_until(lambda: len(other.graph.endpoints()) == 2)
    clock, states = other.graph.endpoints()
    assert (states.topic, states.type_name, states.kind) == ("/joint_states", "sensor_msgs/msg/JointState", "publisher")
    assert states.type_hash == "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"
    assert states.qos == JOINT_STATES.qos
    assert not other.graph.is_own(states)
    assert other.graph.is_own(clock)
    assert f"one (process {os.getpid()} on " in other.graph.owner(states)
    assert clock.qos == Qos(depth=1, reliable=False)
    node.close()
    wait_until(lambda: [one.topic for one in other.graph.endpoints()] == ["/clock"])


def test_latched_topic_reaches_a_late_subscriber(nodes):
    node = nodes()
    node.publish(ROBOT_DESCRIPTION).send(cdr.message("std_msgs/msg/String", data="<robot/>"))
    late = nodes().subscribe(ROBOT_DESCRIPTION)
    (received,) = received_from(late, 1)
    assert late.decode(received).data == "<robot/>"


@pytest.mark.parametrize(
    ("offered", "requested", "words"),
    [
        (Qos(10, reliable=False), Qos(10), "requests reliable delivery, the writer offers best effort"),
        (Qos(1), Qos(1, transient_local=True), "requests transient local (latched), the writer offers volatile"),
    ],
)
def test_incompatible_qos_is_reported_in_words(nodes, offered, requested, words):
    writer, reader = nodes("writer"), nodes("reader")
    publisher, subscription = writer.publish(JOINT_STATES, offered), reader.subscribe(JOINT_STATES, requested)
    for node, us in ((writer, "from this node to reader (process"), (reader, "to this node")):
        wait_until(node.graph.problems)
        (problem,) = node.graph.problems()
        assert words in problem
        assert us in problem
        assert problem.startswith("/joint_states, from ")
    assert publisher.readers == subscription.writers == 0


def test_different_types_on_a_topic_are_reported_in_words(nodes):
    writer, reader = nodes(), nodes()
    writer.publish(Topic("/joint_states", "std_msgs/msg/String", Qos(10)))
    subscription = reader.subscribe(JOINT_STATES)
    wait_until(reader.graph.problems)
    (problem,) = reader.graph.problems()
    assert "the types differ: std_msgs/msg/String and sensor_msgs/msg/JointState" in problem
    assert subscription.writers == 0


def test_a_publisher_refuses_a_message_of_another_type(nodes):
    publisher = nodes().publish(JOINT_STATES)
    with pytest.raises(QuadrupedError, match=r"/joint_states: holds .*JointState; found std_msgs/msg/String"):
        publisher.send(cdr.message("std_msgs/msg/String"))


def test_damaged_bytes_are_not_sent(nodes):
    with pytest.raises(QuadrupedError, match="/tf: 8 bytes could not be sent as a tf2_msgs/msg/TFMessage"):
        nodes().publish(TF).send_bytes(b"\x00\x01\x00\x00\xff\xff\xff\x7f")


def test_sockets_are_bound_to_this_machine_only(nodes, domain_id):
    """Every socket of the domain is bound to the loopback interface, or to its address."""
    if not sys.platform.startswith("linux"):
        pytest.skip("the device of a socket can be read on Linux only")
    nodes().publish(JOINT_STATES)
    ports = range(7400 + 250 * domain_id, 7400 + 250 * (domain_id + 1))
    found = 0
    for connection in psutil.Process().net_connections("udp4"):
        with socket.socket(fileno=os.dup(connection.fd)) as duplicate:
            device = duplicate.getsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, 16).rstrip(b"\0")
        assert connection.laddr.ip == "127.0.0.1" or device == b"lo", connection
        found += connection.laddr.port in ports
    assert found >= 2


def test_node_of_a_test_without_a_claimed_domain_is_refused():
    with pytest.raises(QuadrupedError, match="found 'none in tests; take the fixture domain_id'"):
        Node("test")


def test_error_about_a_domain_is_one_line(capsys, monkeypatch):
    monkeypatch.setenv("ROS_DOMAIN_ID", "9999")
    assert main(["list"]) == 2
    assert re.fullmatch("mini-quadruped live list: error: .*9999\n", capsys.readouterr().err)


def test_damaged_packets_print_nothing(nodes, domain_id, capfd):
    """CycloneDDS's line for each of them would hide all other lines."""
    packet = b"RTPS\x02\x01\x01\x10" + bytes(12) + b"\x15\x05\x10\x00" + b"\x01" * 16
    node, other = nodes(), nodes()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.sendto(packet, ("127.0.0.1", 7410 + 250 * domain_id))
    node.publish(ROBOT_DESCRIPTION).send(cdr.message("std_msgs/msg/String"))
    received_from(other.subscribe(ROBOT_DESCRIPTION), 1)
    assert capfd.readouterr().err == ""


def test_joining_domains_leaves_no_files_open(nodes):
    nodes("first")
    before = psutil.Process().num_fds()
    for _ in range(5):
        nodes().close()
    assert psutil.Process().num_fds() == before


def test_domain_is_the_one_that_ros_uses_and_an_invalid_one_is_refused(monkeypatch):
    for value, expected in (("", 0), ("42", 42), (" 7 ", 7)):
        monkeypatch.setenv("ROS_DOMAIN_ID", value)
        assert Network.from_environment() == Network(expected, subnet=False)
    for value in ("x", "-1", "233", "1.5"):
        monkeypatch.setenv("ROS_DOMAIN_ID", value)
        with pytest.raises(QuadrupedError, match=f"ROS_DOMAIN_ID: expected .*0 to 232; found '?{value}"):
            Network.from_environment()


def test_joints_are_read_in_any_order_of_names():
    order = np.random.default_rng(1).permutation(8)
    positions, velocities = np.linspace(-1.0, 1.0, 8), np.arange(8.0)
    message = joint_state(names=[JOINT_NAMES[i] for i in order], position=positions[order], velocity=velocities[order])
    joints = JointReader(MINI_QUADRUPED)(cdr.serialize(message))
    np.testing.assert_array_equal(joints.positions, positions)
    np.testing.assert_array_equal(joints.velocities, velocities)
    assert joints.efforts is None
    assert joints.stamp == STAMP


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"names": (), "position": (0.0,) * 12}, "LF_hip_joint is missing among 0"),
        ({"names": JOINT_NAMES[:7], "position": (0.0,) * 7}, "RH_knee_joint is missing among 7"),
        ({"names": ("left", *JOINT_NAMES[1:])}, "unknown 'left' among 8"),
        ({"names": (*JOINT_NAMES, "LF_hip_joint"), "position": (0.0,) * 9}, "one comes twice"),
        ({"position": (0.0,) * 7}, "position holds 7 values for 8 names"),
        ({"position": (0.0, 0.0, np.nan, *(0.0,) * 5)}, "position of RF_hip_joint is nan"),
        ({"velocity": (np.inf,) * 8}, "velocity of LF_hip_joint is inf"),
    ],
)
def test_joints_that_are_not_this_robots_are_refused(changes, words):
    with pytest.raises(QuadrupedError, match=words):
        JointReader(MINI_QUADRUPED)(cdr.serialize(joint_state(**changes)))


def test_pace_with_late_ticks_does_not_accumulate_lateness():
    """Each tick is met 3 ms late, and the hundredth is still due one second after the start."""
    clock = ManualClock()
    pace = Pace(0.01, clock)
    for i in range(100):
        assert pace.due == pytest.approx(100.0 + 0.01 * i)
        clock.now = pace.due - 1e-6
        assert not pace.tick()
        clock.now += 0.003
        assert pace.tick()
    assert pace.due == pytest.approx(101.0)
    assert pace.lost == 0


def test_pace_drops_ticks_that_are_too_late_and_keeps_its_grid():
    clock = ManualClock()
    pace = Pace(0.01, clock)
    clock.now = 100.05
    assert sum(pace.tick() for _ in range(20)) == 6  # caught up with
    clock.now = 105.004
    assert pace.tick()
    assert pace.lost == 494
    assert pace.due == pytest.approx(105.01)


def test_state_node_does_what_robot_state_publisher_does(nodes, run_node):
    """Its transforms, chained, are the forward kinematics."""
    node = nodes()
    publisher = node.publish(JOINT_STATES)
    transforms, fixed, description = (node.subscribe(topic) for topic in (TF, TF_STATIC, ROBOT_DESCRIPTION))
    positions = np.array([0.4, -0.5, 0.3, -0.1, -0.2, -1.5, 1.1, -0.9])
    state = run_node("state")
    wait_until(lambda: publisher.readers and transforms.writers)
    received = []

    def answered():
        # Repeated: the node may discover this publisher later than the publisher discovers the node.
        publisher.send(joint_state(position=(0.0,) * 5))
        publisher.send(joint_state(names=reversed(JOINT_NAMES), position=positions[::-1]))
        return received.extend(transforms.take()) or received

    wait_until(answered)
    (described,) = wait_until(description.take)
    assert description.decode(described).data == asset_path("mini_quadruped.urdf").read_text()
    wait_until(fixed.take)
    assert state.interrupt() == 0
    assert "refused: /joint_states: position holds 5 values for 8 names" in state.said
    assert state.said.splitlines()[-1].startswith("[state] ended after")
    expected = forward_kinematics(positions)
    poses = {"base_link": (np.zeros(3), np.eye(3))}
    for one in transforms.decode(received[0]).transforms:
        origin, rotation = poses[one.header.frame_id]
        move, turn = one.transform.translation, one.transform.rotation
        assert turn.x == turn.z == 0.0
        c, s = turn.w**2 - turn.y**2, 2.0 * turn.w * turn.y  # every joint turns about y
        local = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
        poses[one.child_frame_id] = (origin + rotation @ [move.x, move.y, move.z], rotation @ local)
        np.testing.assert_allclose(poses[one.child_frame_id][0], expected[one.child_frame_id][0], atol=1e-12)
    assert poses.keys() == expected.keys()


def test_waiting_for_readers_ends_at_its_timeout(nodes, start):
    """A suspended reader has not received everything; once it is resumed, it has."""
    publisher = nodes().publish(JOINT_STATES)
    reader = start("hz", "/joint_states")
    wait_until(lambda: publisher.readers)
    assert publisher.wait_until_read(DEADLINE)
    reader.process.send_signal(signal.SIGSTOP)
    wait_until(lambda: psutil.Process(reader.process.pid).status() == psutil.STATUS_STOPPED)
    publisher.send(joint_state())
    assert not publisher.wait_until_read(0.05)
    reader.process.send_signal(signal.SIGCONT)
    assert publisher.wait_until_read(DEADLINE)


def test_publisher_that_closed_sends_no_message(nodes):
    gone, node = nodes(), nodes()
    subscription = node.subscribe(JOINT_STATES)
    publisher = gone.publish(JOINT_STATES)
    wait_until(lambda: subscription.writers and publisher.readers)
    publisher.send(joint_state())
    assert publisher.wait_until_read(DEADLINE)
    gone.close()
    wait_until(lambda: not subscription.writers)
    assert len(subscription.take()) == 1
