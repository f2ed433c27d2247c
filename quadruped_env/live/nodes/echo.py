"""Print the messages of a topic, like `ros2 topic echo --full-length`.

    mini-quadruped live echo /joint_states
    mini-quadruped live echo /imu/data --once
    mini-quadruped live echo /cmd_vel --field linear.x
    mini-quadruped live echo /joint_states --csv --seconds 10 > recording.csv

Requests a quality of service that all publishers of the topic offer. Messages that cannot be decoded or lack the field
are counted in the log; if none is printed, the exit status is 2. Printed joint states, as YAML or CSV, can be read
back: `mini-quadruped replay recording.csv`.
"""

import argparse

from quadruped_env.live.listener import Listener
from quadruped_env.live.messages.message_text import as_csv, as_yaml, check_field, field_at, plain
from quadruped_env.live.middleware.node import Read, message_reader
from quadruped_env.live.middleware.topics import Topic
from quadruped_env.live.session import Session


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the topic and the output format."""
    parser.add_argument("topic", metavar="TOPIC", help="topic name, for example /joint_states")
    parser.add_argument("--once", action="store_true", help="end after the first message")
    parser.add_argument("--csv", action="store_true", help="one line of values per message, and nothing else")
    parser.add_argument(
        "--field",
        default="",
        metavar="PATH",
        help="print only this field: header.stamp, position.0, transforms.0.transform",
    )


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Print until the session ends."""
    write = as_csv if arguments.csv else as_yaml

    def text_reader(topic: Topic) -> Read[str]:
        check_field(topic.type_name, arguments.field)
        return message_reader(topic, lambda message: write(field_at(plain(message), arguments.field)))

    listener = Listener(session, [arguments.topic], text_reader)
    printed = False
    for _ in session.turns():
        listener.update()
        for subscription in listener.subscriptions:
            for _, text in subscription.messages(session.refuse):
                print(text, end="", flush=True)
                printed = True
                if arguments.once:
                    return 0
        session.wait_for(listener.missing)
        session.report()
    if not printed:
        raise listener.nothing_to("print")
    return 0
