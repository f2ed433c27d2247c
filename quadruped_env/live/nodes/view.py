"""The robot of the live topics in the browser: what RViz shows, with plots, and arrow keys that steer it.

Draws the robot of /joint_states where /odom says it is, or on its feet where nobody says. The sliders and the arrow
keys send /cmd_vel, the push button /push, the sliders of the scripted gait /gait; each is there while a node takes what
it sends. The page is for browsers on this machine; the log says its address.
"""

import argparse
import time

from quadruped_env.live.live_robot import NAME, LiveRobot
from quadruped_env.live.session import POLL_PERIOD, Session
from quadruped_env.live.topics import JOINT_STATES
from quadruped_env.viewer import PORT, RESULTS, Show, ViewController
from quadruped_env.viewer.server import import_viser


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Where the page is."""
    parser.add_argument("--port", type=int, default=PORT, help="the next free one is taken (%(default)s)")


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Show until the session ends."""
    import_viser()
    robot = LiveRobot(session.node, session.refuse)
    controller = ViewController({NAME: lambda: robot}, [NAME], RESULTS)
    controller.restart_after_fall = False
    controller.offered = robot.offered()
    show = Show(controller, port=arguments.port)
    try:
        session.say(f"the live robot: {show.address}")
        while session.running:
            began = time.monotonic()
            show.run(POLL_PERIOD)
            controller.offered = robot.offered()
            if controller.paused and not controller.offered.clock:
                # The simulation that could be paused has gone, and the button with it.
                controller.paused = False
            session.wait_for("" if robot.receives_states else JOINT_STATES.name)
            for message in controller.messages():
                session.say(message)
            session.report("" if time.monotonic() - began < 2 * POLL_PERIOD else "slow")
    finally:
        show.close()
    return 0
