"""Publish /tf from /joint_states, and the robot description, like robot_state_publisher.

Sends /robot_description and /tf_static once, latched, and one /tf message per joint state: the pose of each link that
one of its joints moves, in the frame of its parent. Joint names may be in any order, and joints of others are ignored;
invalid messages are refused and logged. In RViz the fixed frame is `base_link`, or `odom` together with `sim`.
"""

import argparse
import time

import numpy as np

from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.joint_messages import JointReader, missing_joints
from quadruped_env.live.middleware.topics import JOINT_STATES, ROBOT_DESCRIPTION, TF, TF_STATIC
from quadruped_env.live.node_options import add_robot_argument, robot_of
from quadruped_env.live.session import Session
from quadruped_env.ros import SENSOR_DATA_QOS, cdr
from quadruped_env.ros.robot_messages import transform_messages


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the robot and the map of its driver's joints."""
    add_robot_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Publish until the session ends."""
    node, robot = session.node, robot_of(arguments)
    description, fixed = node.publish(ROBOT_DESCRIPTION), node.publish(TF_STATIC)
    transforms = node.publish(TF)
    driver = DriverJoints.load(arguments.map, robot, commands=False)
    reader = JointReader(driver, states=True)
    states = node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=reader)
    description.send(cdr.message(ROBOT_DESCRIPTION.type_name, data=robot.description))
    fixed.send_bytes(next(transform_messages([time.time_ns()], robot.skeleton.fixed_transforms())))
    waiting_for = JOINT_STATES.name
    for _ in session.turns(drain=True):
        for _, message in states.messages(session.refuse):
            joints = driver.to_robot(message)
            assert joints.positions is not None
            known = np.isfinite(joints.positions)
            links = robot.skeleton.joint_transforms(np.where(known, joints.positions, 0.0))
            if known.any():
                moved = [link for link, one in zip(links, known, strict=True) if one]
                transforms.send_bytes(next(transform_messages([joints.stamp], moved)))
            elif not transforms.count:
                waiting_for = missing_joints(driver.joint_names, joints.others)
        session.wait_for("" if transforms.count else waiting_for)
    return 0
