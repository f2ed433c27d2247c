"""robot_state_publisher's job: from /joint_states to /tf, with the robot's description for those who draw it.

Sends /robot_description and /tf_static once, latched, and a /tf for every joint state: where each link is in the frame
of its parent. The names may come in any order; what it cannot use it refuses, and says why. In RViz the fixed frame is
`base_link`, or `odom` beside `sim`.
"""

import argparse
import time

from quadruped_env.live.joints import JointReader
from quadruped_env.live.session import Session
from quadruped_env.live.topics import JOINT_STATES, ROBOT_DESCRIPTION, TF, TF_STATIC
from quadruped_env.live.transforms import TransformWriter, description_message, fixed_message
from quadruped_env.ros import SENSOR_DATA_QOS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """This node takes none of its own."""


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Publish until the session ends."""
    node = session.node
    description, fixed = node.publish(ROBOT_DESCRIPTION), node.publish(TF_STATIC)
    transforms = node.publish(TF)
    states = node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=JointReader(JOINT_STATES.name, ["positions"]))
    write = TransformWriter()
    description.send(description_message())
    fixed.send_bytes(fixed_message(time.time_ns()))
    for _ in session.turns():
        for _, joints in states.messages(session.refuse):
            assert joints.positions is not None
            transforms.send_bytes(write(joints.stamp, joints.positions))
        session.wait_for("" if states.count else JOINT_STATES.name)
        session.report()
    return 0
