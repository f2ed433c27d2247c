"""Messages in both directions with an independent DDS: Debian's Fast DDS, in a C++ program that is built here."""

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from live_nodes import joint_state, received_from
from paths import TESTS
from random_messages import random_joint_states
from waiting import DEADLINE, killed_on_failure, output_of, status_of, wait_until

from quadruped_env import asset_path
from quadruped_env.live import Topic
from quadruped_env.live.middleware.topics import JOINT_STATES, ROBOT_DESCRIPTION
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import Qos, cdr

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

SOURCE = TESTS / "helpers" / "fastdds_peer" / "peer.cpp"
COUNT = 1000
DEEP = Qos(depth=COUNT)
FROM_PEER, TO_PEER = (Topic(name, JOINT_STATES.type_name, DEEP) for name in ("/from_peer", "/to_peer"))

discoveries = pytest.mark.parametrize(
    "discovery", ["localhost", *(pytest.param(way, marks=pytest.mark.slow) for way in ("loopback", "subnet"))]
)
"""Discovery settings of a ROS 2 installation."""


@pytest.fixture(scope="module")
def peer(tmp_path_factory):
    """Starts the peer, which is built first; skips the test if it cannot be built."""
    program = tmp_path_factory.mktemp("peer") / "peer"
    compiler = shutil.which("g++")
    if compiler is None:
        pytest.skip("no g++: the independent DDS peer cannot be built")
    if not Path("/usr/include/fastdds/dds/domain/DomainParticipant.hpp").exists():
        pytest.skip("no Fast DDS: apt-get install libfastrtps-dev libfastcdr-dev")
    subprocess.run(
        [compiler, "-std=c++17", "-O1", "-w", SOURCE, "-lfastrtps", "-lfastcdr", "-pthread", "-o", program], check=True
    )

    def start(discovery, *arguments):
        process = subprocess.Popen(
            [program, *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | {"PEER_DISCOVERY": discovery, "PEER_DEADLINE": str(round(DEADLINE))},
        )
        return killed_on_failure(process)

    return start


@discoveries
def test_all_messages_come_from_an_independent_dds(nodes, peer, discovery):
    subscription = nodes().subscribe(FROM_PEER)
    with peer(discovery, "publish", str(COUNT)) as process:
        wait_until(lambda: subscription.writers, alive=process)
        process.stdin.write("\n")
        process.stdin.flush()
        received = received_from(subscription, COUNT, process)
        assert status_of(process) == 0
    assert len(received) == COUNT
    for i, one in enumerate(received):
        message, joints = subscription.decode(one), np.arange(1 + i % 8)
        assert (message.header.stamp.sec, message.header.stamp.nanosec) == (1_700_000_000 + i, 999_999_999 - i)
        assert message.header.frame_id == "f" * (i % 5)
        assert message.name == [f"joint_{joint * i}" for joint in joints]
        assert message.position.tolist() == (0.5 * i - joints).tolist()
        assert message.velocity.tolist() == []
        assert message.effort.tolist() == [-0.25 * i] * (len(joints) if i % 2 else 0)


@discoveries
def test_all_messages_reach_an_independent_dds(nodes, peer, discovery):
    publisher = nodes().publish(TO_PEER)
    sent = list(random_joint_states(COUNT))
    with peer(discovery, "receive", str(COUNT)) as process:
        wait_until(lambda: publisher.readers, alive=process)
        assert process.stdout.readline() == "ready\n"
        for message in sent:
            publisher.send(joint_state(*message))
        output, _ = output_of(process)
    assert process.returncode == 0
    found = [read(line) for line in output.splitlines()]
    assert len(found) == COUNT
    for one, message in zip(found, sent, strict=True):
        assert repr(one) == repr(message)  # NaN is not equal to itself


def read(line):
    """The message that the peer printed."""
    stamp, frame, names, *arrays, _ = line.split("|")
    sec, nanosec = map(int, stamp.split())
    assert frame == ""
    return sec * 10**9 + nanosec, names.split(), *([float.fromhex(one) for one in array.split()] for array in arrays)


def test_an_independent_dds_that_joins_late_gets_the_description(nodes, peer):
    nodes().publish(ROBOT_DESCRIPTION).send(cdr.message("std_msgs/msg/String", data=MINI_QUADRUPED.urdf))
    with peer("localhost", "description") as process:
        output, _ = output_of(process)
    assert process.returncode == 0
    assert output == asset_path("mini_quadruped.urdf").read_text()
