"""A process on plain `cyclonedds`, which announces the structure of its types, and answers each joint state.

    python cyclonedds_peer.py COUNT

Subscribes to /to_peer, and publishes each message on /from_peer with twice the positions, COUNT times.
"""

import contextlib
import subprocess
import sys
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos, ReadCondition, SampleState, WaitSet
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import float64, int32, sequence, uint32
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

from quadruped_env.live.middleware.dds import Network, open_participant


@dataclass
@final
class Time(IdlStruct, typename="builtin_interfaces.msg.dds_.Time_"):
    sec: int32
    nanosec: uint32


@dataclass
@final
class Header(IdlStruct, typename="std_msgs.msg.dds_.Header_"):
    stamp: Time
    frame_id: str


@dataclass
@final
class JointState(IdlStruct, typename="sensor_msgs.msg.dds_.JointState_"):
    header: Header
    name: sequence[str]
    position: sequence[float64]
    velocity: sequence[float64]
    effort: sequence[float64]


def main(count):
    # Used for its network settings only; everything else is unmodified cyclonedds.
    participant = open_participant(Network.from_environment(), "cyclonedds peer")
    qos = Qos(Policy.Reliability.Reliable(10**8), Policy.History.KeepLast(count))
    reader = DataReader(participant, Topic(participant, "rt/to_peer", JointState), qos=qos)
    writer = DataWriter(participant, Topic(participant, "rt/from_peer", JointState), qos=qos)
    waiting = WaitSet(participant)
    waiting.attach(ReadCondition(reader, SampleState.NotRead))
    while count:
        waiting.wait(10**9)
        for one in reader.take(count):
            one.position = [2.0 * value for value in one.position]
            writer.write(one)
            count -= 1
    writer.wait_for_acks(60 * 10**9)


@contextlib.contextmanager
def started(count):
    """This program as a process, which does not outlive the context."""
    with subprocess.Popen([sys.executable, __file__, str(count)]) as process:
        try:
            yield process
        finally:
            process.kill()


if __name__ == "__main__":
    main(int(sys.argv[1]))
