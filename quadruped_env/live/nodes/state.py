"""Publish /tf from /joint_states, and the robot description, like robot_state_publisher.

Sends /robot_description and /tf_static once, latched, and one /tf message per joint state: the pose of each link in the
frame of its parent. The joint names may be in any order; invalid messages are refused and logged. In RViz the
fixed frame is `base_link`, or `odom` together with `sim`.
"""

import argparse
import time

from quadruped_env.live.messages.joint_messages import JointReader
from quadruped_env.live.middleware.topics import JOINT_STATES, ROBOT_DESCRIPTION, TF, TF_STATIC
from quadruped_env.live.node_options import add_robot_argument, robot_of
from quadruped_env.live.session import Session
from quadruped_env.ros import SENSOR_DATA_QOS, cdr
from quadruped_env.ros.robot_messages import transform_messages


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the robot."""
    add_robot_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Publish until the session ends."""
    node, robot = session.node, robot_of(arguments)
    description, fixed = node.publish(ROBOT_DESCRIPTION), node.publish(TF_STATIC)
    transforms = node.publish(TF)
    reader = JointReader(JOINT_STATES.name, robot, ["positions"])
    states = node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=reader)
    description.send(cdr.message(ROBOT_DESCRIPTION.type_name, data=robot.urdf))
    fixed.send_bytes(next(transform_messages([time.time_ns()], robot.fixed_transforms())))
    for _ in session.turns():
        for _, joints in states.messages(session.refuse):
            assert joints.positions is not None
            transforms.send_bytes(next(transform_messages([joints.stamp], robot.joint_transforms(joints.positions))))
        session.wait_for("" if states.count else JOINT_STATES.name)
        session.report()
    return 0
