"""Record topics into a bag, like `ros2 bag record`.

    mini-quadruped live record                           all topics of known types, as they appear
    mini-quadruped live record /joint_states -o my_bag

The bag (rosbag2, MCAP) contains the received bytes with their arrival times, and the QoS that each topic's publishers
offer. Ctrl-C completes it. During recording it is in `my_bag.part/my_bag`; if the recorder is killed it stays there,
and `--repair salvage` recovers it. The recorded motion and the recorded joint targets can be replayed:

    mini-quadruped replay my_bag
    mini-quadruped replay my_bag --topic /joint_commands
    ros2 bag play my_bag
"""

import argparse
from pathlib import Path

from quadruped_env.live.listener import Listener
from quadruped_env.live.message_recorder import Recorder
from quadruped_env.live.session import Session
from quadruped_env.trajectory.formats.bag_writer import STORAGES
from quadruped_env.utils.files import free_path


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the topics and the bag."""
    parser.add_argument("topics", nargs="*", metavar="TOPIC", help="such as /joint_states (default: all)")
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="BAG",
        help="directory to create (default: results/recording, or that name with the next free number)",
    )
    parser.add_argument("-s", "--storage", choices=STORAGES, default="mcap", help="(default: %(default)s)")


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Record until the session ends."""
    listener = Listener(session, arguments.topics)
    path = arguments.output or free_path(Path("results") / "recording")
    with Recorder(path, arguments.storage) as recorder:
        for _ in session.turns():
            listener.update()
            for subscription in listener.subscriptions:
                for received in subscription.take():
                    recorder.write(subscription.topic, received.data)
            session.wait_for(listener.missing)
            session.report(f"{recorder.size / 1e6:.1f} MB")
    if not recorder.count:
        raise listener.nothing_to("record")
    print(f"{recorder.count} messages of {recorder.topics} topics: {path}")
    return 0
