"""The robot of the live topics in the browser: like RViz, with plots, and arrow keys to steer it.

Draws the robot of /joint_states at the pose of /odom, or standing without /odom. The sliders and the arrow
keys send /cmd_vel, the push button /push, the sliders of the scripted gait /gait; each control is shown while a node
subscribes to its topic. No message describes the ground: give it the options --terrain, --level and --seed of `sim`.
The page accepts browsers on this machine only; the log prints its address.
"""

import argparse

from quadruped_env.live.live_robot import NAME, LiveRobot
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.middleware.topics import JOINT_STATES
from quadruped_env.live.node_options import (
    add_robot_argument,
    add_terrain_arguments,
    chosen_terrain,
    robot_of,
)
from quadruped_env.live.nodes.launch import add_view_arguments
from quadruped_env.live.session import POLL_PERIOD, Session
from quadruped_env.viewer import RESULTS, Show, ViewController
from quadruped_env.viewer.server import import_viser


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the viewer's port, the ground, the robot and the map of its driver's joints."""
    add_robot_argument(parser)
    add_view_arguments(parser)
    add_terrain_arguments(parser, "seed of the terrain")


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Show until the session ends."""
    import_viser()
    chosen = robot_of(arguments)
    driver = DriverJoints.load(arguments.map, chosen, commands=False)
    robot = LiveRobot(session.node, chosen, session.refuse, chosen_terrain(arguments), driver)
    controller = ViewController({NAME: lambda: robot}, [NAME], RESULTS, chosen)
    controller.available = robot.offered()
    show = Show(controller, port=arguments.port, allowed_hosts=arguments.allow_host)
    try:
        session.say(f"the live robot: {show.address}")
        for _ in session.turns(lambda: 0.0):
            show.run(POLL_PERIOD)
            controller.available = robot.offered()
            session.wait_for("" if robot.receives_states else JOINT_STATES.name)
            for message in controller.messages():
                session.say(message)
    finally:
        show.close()
    return 0
