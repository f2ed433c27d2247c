"""Messages in both directions with a real ROS 2: rclpy on Fast DDS, as `make ros2` installs it."""

import os
import pty
from dataclasses import replace

import numpy as np
import pytest
from live_nodes import joint_state, started
from random_messages import filled, random_joint_states
from waiting import output_of, status_of, wait_until

from quadruped_env import asset_path
from quadruped_env.live import TOPICS, Topic
from quadruped_env.live.messages.message_text import plain
from quadruped_env.live.middleware.topics import (
    CMD_VEL,
    CMD_VEL_STAMPED,
    ESTOP,
    JOINT_STATES,
    ODOMETRY,
    ROBOT_DESCRIPTION,
    TF_STATIC,
)
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import LATCHED_QOS, SENSOR_DATA_QOS, Qos, cdr, message_type
from quadruped_env.ros.robot_messages import joint_state as joint_state_bytes
from quadruped_env.ros.robot_messages import read_joint_state, read_recorded

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

pytestmark = pytest.mark.slow

COUNT = 1000
DEEP = Qos(depth=COUNT)
FROM_PEER, TO_PEER = (Topic(name, JOINT_STATES.type_name, DEEP) for name in ("/from_peer", "/to_peer"))


def known(ros2, topic):
    """Skip the test if the distribution lacks the type of the topic."""
    if ros2.share(topic.type_name.partition("/")[0]) is None:
        pytest.skip(f"no {topic.type_name} in {ros2.name}")


@pytest.mark.parametrize("name", TOPICS)
def test_topic_message_is_equal_in_both_directions(nodes, ros2, name):
    topic = TOPICS[name]
    known(ros2, topic)
    rng = np.random.default_rng(0)
    there, back = filled(topic.type_name, rng), plain(filled(topic.type_name, rng))
    returned = Topic("/returned", topic.type_name, topic.qos)
    node = nodes()
    publisher, subscription = node.publish(topic), node.subscribe(returned)
    received = []
    with ros2.node() as peer:
        peer.subscribe(topic)
        peer.publish(returned)
        wait_until(lambda: publisher.readers and subscription.writers, peer.state, peer.process)
        wait_until(lambda: peer.matched(topic) and peer.matched(returned), peer.state, peer.process)

        def arrived():
            # Best effort may lose a message, so both sides send theirs until it has arrived.
            if not received:
                peer.ask(send=returned.name, message=back)
            if not peer.received(topic):
                publisher.send(there)
            received.extend(subscription.take())
            return received and peer.received(topic)

        wait_until(arrived, peer.state, peer.process, interval=0.2)
        hashes = {one.type_hash for one in node.graph.endpoints() if one.topic in (topic.name, returned.name)}
    assert peer.received(topic)[0] == plain(there)
    assert plain(subscription.decode(received[0])) == back
    assert hashes == {message_type(topic.type_name).type_hash}
    assert node.graph.problems() == []


@pytest.mark.parametrize("discovery", [{}, {"ROS_LOCALHOST_ONLY": "1"}], ids=["LOCALHOST", "ROS_LOCALHOST_ONLY"])
def test_every_reliable_message_arrives_with_equal_values(nodes, ros2, discovery):
    from quadruped_env.ros import cdr

    sent = [plain(joint_state(*message)) for message in random_joint_states(COUNT)]
    node = nodes()
    publisher, subscription = node.publish(TO_PEER), node.subscribe(FROM_PEER)
    received = []
    with ros2.node(**discovery) as peer:
        peer.subscribe(TO_PEER)
        peer.publish(FROM_PEER)
        wait_until(lambda: publisher.readers and subscription.writers, peer.state, peer.process)
        wait_until(lambda: peer.matched(TO_PEER) and peer.matched(FROM_PEER), peer.state, peer.process)
        for message in sent:
            publisher.send(cdr.message(TO_PEER.type_name, **message))
            peer.ask(send=FROM_PEER.name, message=message)
            received += subscription.take()
        wait_until(
            lambda: received.extend(subscription.take()) or len(received) >= COUNT <= len(peer.received(TO_PEER)),
            lambda: f"{len(received)} of {COUNT} here, {len(peer.received(TO_PEER))} there",
            peer.process,
        )
    # NaN is not equal to itself.
    assert repr([plain(subscription.decode(one)) for one in received]) == repr(sent)
    assert repr(peer.received(TO_PEER)) == repr(sent)


@pytest.mark.parametrize(
    ("offered", "requested", "policy", "words"),
    [
        (Qos(10, reliable=False), Qos(10), "RELIABILITY", "requests reliable delivery, the writer offers best effort"),
        (
            Qos(1),
            Qos(1, transient_local=True),
            "DURABILITY",
            "requests transient local (latched), the writer offers volatile",
        ),
    ],
)
def test_incompatible_qos_is_reported_on_both_sides(nodes, ros2, offered, requested, policy, words):
    node = nodes()
    publisher, subscription = node.publish(TO_PEER, offered), node.subscribe(FROM_PEER, requested)
    with ros2.node() as peer:
        peer.subscribe(TO_PEER, requested)
        peer.publish(FROM_PEER, offered)
        for topic in (TO_PEER, FROM_PEER):
            wait_until(lambda topic=topic: peer.said("incompatible", topic.name), peer.state, peer.process)
            assert policy in peer.said("incompatible", topic.name)[0]["policy"]
        wait_until(lambda: len(node.graph.problems()) == 2, lambda: str(node.graph.problems()), peer.process)
        assert all(words in problem for problem in node.graph.problems())
        with started("list", "--verbose") as process:
            output, _ = output_of(process)
        assert (publisher.readers, subscription.writers) == (0, 0)
    for topic in (TO_PEER, FROM_PEER):
        assert any(line.startswith(f"! {topic.name}, ") and words in line for line in output.splitlines()), output


def test_late_subscriber_receives_description_and_static_transforms(nodes, ros2):
    known(ros2, TF_STATIC)
    node = nodes()
    transforms = filled(TF_STATIC.type_name, np.random.default_rng(3))
    node.publish(ROBOT_DESCRIPTION).send(cdr.message("std_msgs/msg/String", data=MINI_QUADRUPED.urdf))
    node.publish(TF_STATIC).send(transforms)
    with ros2.node() as peer:
        for topic in (ROBOT_DESCRIPTION, TF_STATIC):
            peer.subscribe(topic)
            wait_until(lambda topic=topic: peer.received(topic), peer.state, peer.process)
    assert peer.received(ROBOT_DESCRIPTION) == [{"data": asset_path("mini_quadruped.urdf").read_text()}]
    assert peer.received(TF_STATIC) == [plain(transforms)]
    assert transforms.transforms


class Track:
    """Distance that the robot walked, from /odom."""

    def __init__(self, node):
        self._odometry = node.subscribe(ODOMETRY, Qos(5000))
        self.speeds = []
        """Forward velocities, m/s, one per control step of 10 ms."""

    def over(self, seconds):
        """Distance in m over the last seconds of the robot's own time; 0 before."""
        self.speeds += [self._odometry.decode(one).twist.twist.linear.x for one in self._odometry.take()]
        count = round(100 * seconds)
        return 0.01 * sum(self.speeds[-count:]) if len(self.speeds) >= count else 0.0


def test_rclpy_node_drives_as_far_as_teleop(nodes, start, ros2):
    start("sim")
    start("controller")
    node = nodes()
    track, commands = Track(node), node.subscribe(CMD_VEL)
    asked = 0.5 * 10.0
    ours, terminal = pty.openpty()
    with started("teleop", stdin=terminal) as process:
        # Keys typed before it controls the terminal are dropped.
        wait_until(commands.take, "a message of teleop", process)
        os.write(ours, 5 * b"w")
        wait_until(lambda: track.over(10.0) > 0.9 * asked, lambda: f"walked {track.over(10.0)} m", process)
        by_teleop = track.over(10.0)
        os.write(ours, b"q")
        assert status_of(process) == 0
    os.close(ours)
    os.close(terminal)
    wait_until(lambda: track.over(1.0) and abs(track.over(1.0)) < 0.05, lambda: f"walks on: {track.over(1.0)} m")
    with ros2.node() as peer:
        peer.publish(CMD_VEL)
        wait_until(lambda: peer.matched(CMD_VEL), peer.state, peer.process)
        peer.ask(drive=CMD_VEL.name, message={"linear": {"x": 0.5}}, period=0.1)
        wait_until(lambda: track.over(10.0) > 0.9 * asked, lambda: f"walked {track.over(10.0)} m", peer.process)
        by_rclpy = track.over(10.0)
    assert by_rclpy == pytest.approx(by_teleop, rel=0.1)
    wait_until(lambda: abs(track.over(1.0)) < 0.05, lambda: f"walks on: {track.over(1.0)} m")
    with ros2.node() as peer:
        # As Nav2 since Kilted, and with the quality of service of sensors.
        peer.publish(CMD_VEL_STAMPED, SENSOR_DATA_QOS)
        wait_until(lambda: peer.matched(CMD_VEL_STAMPED), peer.state, peer.process)
        peer.ask(drive=CMD_VEL.name, message={"twist": {"linear": {"x": 0.5}}}, period=0.1)
        wait_until(lambda: track.over(3.0) > 0.9 * 1.5, lambda: f"walked {track.over(3.0)} m", peer.process)


def test_rclpy_attributes_publishers_to_their_node(nodes, ros2, capfd):
    nodes("reader").publish(JOINT_STATES)
    # Kilted attributes endpoints to nodes of rmw only, although it lists the node and its topics.
    node = "reader" if ros2.name == "jazzy" else "_CREATED_BY_BARE_DDS_APP_"
    with ros2.node("ros_peer") as peer:
        peer.subscribe(JOINT_STATES)
        wait_until(lambda: peer.matched(JOINT_STATES), peer.state, peer.process)

        def attributed():
            peer.ask(endpoints=JOINT_STATES.name)
            wait_until(lambda: peer.said("endpoints"), peer.state, peer.process)
            return {node, "ros_peer"} == {one["node"] for one in peer.said("endpoints")[-1]["found"]}

        wait_until(attributed, peer.state, peer.process, interval=0.2)
    found = {one.pop("kind"): one for one in peer.said("endpoints")[-1]["found"]}
    assert found["PUBLISHER"] == {
        "node": node,
        "type": JOINT_STATES.type_name,
        "hash": JOINT_STATES.type.type_hash,
        "reliable": True,
        "transient_local": False,
    }
    assert found["SUBSCRIPTION"]["hash"] == JOINT_STATES.type.type_hash
    # CycloneDDS logs what it cannot read.
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize("qos", [SENSOR_DATA_QOS, LATCHED_QOS, Qos(10)], ids=["best effort", "latched", "volatile"])
def test_rclpy_button_of_any_qos_stops_the_controller_again_and_again(start, nodes, ros2, qos):
    """As a micro-ROS button, a latched one, and `ros2 topic pub`. Each repeats its state: best effort may be lost."""
    controller = start("controller", "--namespace", "r1")
    listener = nodes()
    with ros2.node() as peer:
        for topic in (ESTOP, replace(ESTOP, name="/r1/estop")):
            peer.publish(topic, qos)
            wait_until(lambda topic=topic: peer.matched(topic), peer.state, peer.process)
            for text in 3 * ("emergency stop (", "emergency stop released ("):
                count = controller.said.count(f"] {text}")

                def obeyed(topic=topic, text=text, count=count):
                    peer.ask(send=topic.name, message={"data": "released" not in text})
                    return controller.said.count(f"] {text}") > count

                wait_until(obeyed, lambda: controller.said, peer.process, interval=0.2)
    assert listener.graph.problems(all_processes=True) == []


def test_latched_stop_of_rclpy_reaches_a_controller_that_starts_later(start, ros2):
    with ros2.node() as peer:
        peer.publish(ESTOP, LATCHED_QOS)
        peer.ask(send=ESTOP.name, message={"data": True})
        controller = start("controller")
        wait_until(lambda: "limp (emergency stop)" in controller.said, lambda: controller.said)


def test_padded_bytes_of_rclpy_are_read(ros2):
    """`serialize_message` pads behind empty sequences, as recorders write it into bags."""
    program = (
        "from rclpy.serialization import serialize_message; from sensor_msgs.msg import JointState; "
        "print(bytes(serialize_message(JointState(name=['a', 'b'], position=[0.5, 1.5]))).hex())"
    )
    with ros2.start("-c", program) as process:
        output, _ = output_of(process)
    data = bytes.fromhex(output.split()[-1])
    assert len(data) > len(joint_state_bytes(0, ["a", "b"], [0.5, 1.5]))
    assert read_joint_state(data).position.tolist() == [0.5, 1.5]
    assert read_recorded(data, JOINT_STATES.type_name, 0)[0].position.tolist() == [0.5, 1.5]
