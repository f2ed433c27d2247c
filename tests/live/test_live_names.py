"""Namespaces, remapping, and node names in the graph."""

import pytest
from test_live_nodes import Watcher
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.live import Node
from quadruped_env.live.middleware.names import Names
from quadruped_env.live.middleware.topics import CLOCK, CMD_VEL, GAIT_SETTINGS, JOINT_STATES, TF

pytest.importorskip("cyclonedds")


def names_of(names, *topics):
    return [names.resolved(topic).name for topic in topics]


def test_names_are_resolved_as_in_ros():
    topics = (JOINT_STATES, GAIT_SETTINGS, TF, CLOCK)
    assert names_of(Names.of("sim"), *topics) == [topic.name for topic in topics]
    names = Names.of("sim", "r1", ("joint_states:=/states", "/tf:=tf", "gait/settings:=~/gait"))
    assert names.full_node == "/r1/sim"
    assert names_of(names, *topics) == ["/states", "/r1/sim/gait", "/r1/tf", "/clock"]
    # A rule holds for full names: this one is for a topic outside the namespace.
    assert names_of(Names.of("sim", "/r1", ("/joint_states:=/states",)), JOINT_STATES) == ["/r1/joint_states"]


@pytest.mark.parametrize(
    ("rules", "namespace", "words"),
    [
        (("cmd_vel",), None, "--remap: expected FROM:=TO with names of topics; found 'cmd_vel'"),
        (("cmd_vel:=",), None, "expected FROM:=TO"),
        (("cmd_vel:=/a b",), None, "with names of topics; found 'cmd_vel:=/a b'"),
        (("a:=b:=c",), None, "expected FROM:=TO"),
        ((), "a//b", "--namespace: expected names"),
    ],
)
def test_names_that_ros_does_not_allow_are_refused(rules, namespace, words):
    with pytest.raises(QuadrupedError, match=words):
        Names.of("sim", namespace, rules)


def test_two_robots_on_a_domain_walk_each_with_its_own_command(run_node):
    """The second one is commanded on a remapped topic; neither hears the other's command."""
    first = Watcher(0.5, Names.of("watcher", "r1"))
    for name in ("r1", "r2"):
        run_node("sim", "--namespace", name)
        run_node("controller", "--namespace", name, *["--remap", "cmd_vel:=/drive_r2"] * (name == "r2"))
    second = Watcher(-0.2, Names.of("driver", "r2", ("cmd_vel:=/drive_r2",)))
    first.until_it_walks()
    second.until_it_walks()
    first.until_it_walks()
    graph = second.node.graph
    (sim,) = (one for one in graph.endpoints("/r2/joint_states") if one.writes)
    wait_until(lambda: graph.owner(sim).startswith("/r2/sim (process "))
    first.node.close()
    second.node.close()


@pytest.mark.slow
def test_rclpy_lists_the_nodes_with_their_topics(nodes, ros2):
    ours = Node("sim", names=Names.of("sim", "r1"))
    ours.publish(JOINT_STATES)
    ours.subscribe(CMD_VEL)
    with ros2.node("ros_peer") as peer:
        peer.subscribe(JOINT_STATES)

        def asked():
            peer.ask(nodes="/r1/sim")
            return any("/r1/sim" in one["nodes"] and one["publishers"] for one in peer.said("nodes"))

        wait_until(asked, peer.state, peer.process, interval=0.2)
        found = peer.said("nodes")[-1]
        (reader,) = (one for one in ours.graph.endpoints(JOINT_STATES.name) if not one.writes)
        wait_until(lambda: ours.graph.owner(reader).startswith("ros_peer"), alive=peer.process)
    assert found["publishers"] == {"/r1/joint_states": [JOINT_STATES.type_name]}
    assert found["subscriptions"] == {"/r1/cmd_vel": [CMD_VEL.type_name]}
    ours.close()
