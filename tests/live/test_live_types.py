"""Type information that nodes announce, and peers that announce more."""

import pytest
from live_nodes import STAMP, joint_state
from waiting import status_of, wait_until

from quadruped_env.live import TOPICS, Topic
from quadruped_env.live.middleware.dds import Network, open_participant
from quadruped_env.live.middleware.topics import JOINT_STATES
from quadruped_env.live.middleware.wire import withhold_type_information
from quadruped_env.ros import Qos

pytest.importorskip("cyclonedds")
import cyclonedds_peer

COUNT = 100
FROM_PEER, TO_PEER = (Topic(name, JOINT_STATES.type_name, Qos(depth=COUNT)) for name in ("/from_peer", "/to_peer"))


def structures_of(node):
    """For each endpoint of the robot's topics on the domain: True if it announces the structure of its type."""
    from cyclonedds import builtin

    kinds = builtin.BuiltinTopicDcpsPublication, builtin.BuiltinTopicDcpsSubscription
    ends = [one for kind in kinds for one in builtin.BuiltinDataReader(node._participant, kind).take(1000)]
    ends = [one for one in ends if one.topic_name.startswith("rt/")]
    return [isinstance(getattr(one.type_id, "value", None), (bytes, list, tuple)) for one in ends]


def test_no_topic_announces_type_information(nodes):
    node, watcher = nodes(), nodes()
    for topic in TOPICS.values():
        node.publish(topic)
        node.subscribe(topic)
    readers = sum(len(subscription.entities) for subscription in node.subscriptions)
    wait_until(lambda: len(watcher.graph.endpoints()) == len(TOPICS) + readers)
    assert structures_of(watcher) == [False] * (len(TOPICS) + readers)
    assert all(one.type_hash for one in watcher.graph.endpoints())


def test_cyclonedds_peer_that_announces_type_information_exchanges_messages(nodes):
    node = nodes()
    publisher, subscription = node.publish(TO_PEER), node.subscribe(FROM_PEER)
    received = []
    with cyclonedds_peer.started(COUNT) as process:
        wait_until(lambda: publisher.readers and subscription.writers, alive=process)
        structures = structures_of(node)
        for i in range(COUNT):
            publisher.send(joint_state(STAMP + i, position=[float(i)] * 8))
        wait_until(lambda: received.extend(subscription.take()) or len(received) >= COUNT, alive=process)
        assert status_of(process) == 0
    assert structures.count(True) == 2
    messages = [subscription.decode(one) for one in received]
    assert [one.position.tolist() for one in messages] == [[2.0 * i] * 8 for i in range(COUNT)]
    assert [one.header.stamp.nanosec for one in messages] == [(STAMP + i) % 10**9 for i in range(COUNT)]


@pytest.fixture
def participant(nodes):
    """A participant of plain `cyclonedds` on the domain of this package's nodes."""
    made = open_participant(Network.from_environment(), "plain")
    yield made
    made._delete(made._ref)


def announced(participant, fields):
    """A type with the name of ROS 2's String; its publishers and subscriptions announce its structure."""
    from cyclonedds.idl import annotations, make_idl_struct
    from cyclonedds.topic import Topic as DdsTopic

    kind = annotations.final(make_idl_struct("String_", "std_msgs.msg.dds_.String_", fields))
    return DdsTopic(participant, "rt/chatter", kind)


def test_library_that_describes_types_in_another_way_is_left_unchanged(nodes, participant, monkeypatch):
    from cyclonedds.internal import DDS

    class Other:
        """A library without the expected functions."""

    topic = announced(participant, {"data": str})
    monkeypatch.setattr(DDS, "_dll_handle", Other())
    assert not withhold_type_information(topic)


def test_topic_is_made_once_for_all_readers_and_writers_of_a_node(nodes):
    """CycloneDDS searches without end, and takes all memory, once a process holds more than some thirty of a type."""
    node = nodes()
    for _ in range(10):
        node.subscribe(TOPICS["/estop"])
        node.publish(TOPICS["/estop"])
    assert ("rt/estop", "std_msgs/msg/Bool") in node._participant.quadruped_topics
    assert len(node._participant.quadruped_topics) == 2, "the other one is for discovery"
