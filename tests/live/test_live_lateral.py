"""Robots whose legs can roll on live topics: `/cmd_vel` moves them sideways, and the viewer sends it."""

from pathlib import Path

import numpy as np
import pytest
import twelve_joints
from live_bench import Bench, Loop
from live_nodes import received_from
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.control.control_config import velocity_commands
from quadruped_env.control.live_controller import LiveController, Mode
from quadruped_env.live.live_robot import LiveRobot
from quadruped_env.live.messages.steering_messages import read_velocity, velocity_message
from quadruped_env.live.middleware.topics import CMD_VEL, ODOMETRY
from quadruped_env.policies.by_name import find_controller
from quadruped_env.ros import Qos, cdr
from quadruped_env.utils.rotations import rotate_inverse, yaw

pytest.importorskip("cyclonedds")


def test_twist_holds_the_lateral_velocity_in_linear_y():
    for command in ((0.3, -0.2), (0.3, -0.2, 0.1)):
        message = velocity_message(command)
        assert (message.linear.y, message.linear.z, message.angular.x) == (0.1 if len(command) == 3 else 0.0, 0.0, 0.0)
        data = cdr.serialize(message)
        assert read_velocity(cdr.deserialize(data, CMD_VEL.type_name)) == (*command, 0.0)[:3]
    stamped = cdr.message(
        "geometry_msgs/msg/TwistStamped", twist={"linear": {"x": 1.0, "y": 2.0}, "angular": {"z": 3.0}}
    )
    assert read_velocity(stamped) == (1.0, 3.0, 2.0)


def test_lateral_velocity_that_is_not_finite_is_refused_unless_the_robot_has_none():
    live_controller = Loop("sinusoid", robot=twelve_joints.ROBOT).live_controller
    with pytest.raises(QuadrupedError, match=r"/cmd_vel: \[0.1, 0.0, nan\] is not finite"):
        live_controller.command((0.1, 0.0, np.nan), 1.0)
    bench = Bench().walk((0.3, 0.1, np.nan))
    assert bench.controller.commands[-1] == [0.3, 0.1]


def test_lateral_velocity_is_clipped_to_the_range():
    said, robot = [], twelve_joints.ROBOT
    live_controller = LiveController(find_controller("sinusoid", robot=robot).make(), robot=robot, say=said.append)
    live_controller.command((0.0, 0.0, -0.9), 1.0)
    low = velocity_commands(robot)[2].range[0]
    assert said[-1:] == [f"/cmd_vel: lateral_velocity = -0.9 is outside {low:g} to {-low:g} m/s, and is clipped to it"]


def test_robot_follows_each_of_three_velocities_on_the_live_controller():
    loop = Loop("sinusoid", robot=twelve_joints.ROBOT)
    loop.run(4.0)
    assert loop.live_controller.mode is Mode.WALKING
    for command in ((0.3, 0.0), (0.0, 0.0, 0.15), (0.0, 0.0, -0.15), (0.0, 0.5, 0.0)):
        loop.run(2.0, command)
        state, seconds = loop.robot.state, 4.0
        place, heading = state.base_position[0].copy(), state.orientation[0].copy()
        loop.run(seconds, command)
        moved = rotate_inverse(heading, state.base_position[0] - place) / seconds
        turned = (yaw(state.orientation[0]) - yaw(heading) + np.pi) % (2.0 * np.pi) - np.pi
        forward, turn, left = (*command, 0.0)[:3]
        assert moved[:2] == pytest.approx([forward, left], abs=0.1), command
        assert turned / seconds == pytest.approx(turn, abs=0.2), command
        loop.run(1.0)


def test_nodes_move_a_robot_of_three_joints_per_leg_sideways(start, nodes):
    task = ("--task", str(Path(twelve_joints.__file__)))
    node = nodes("watcher")
    velocities, odometry = node.publish(CMD_VEL), node.subscribe(ODOMETRY, Qos(1000))
    sim, controller = start("sim", *task), start("controller", "sinusoid", *task)
    for left in (0.2, -0.2):
        speeds = []

        def moves(left=left, speeds=speeds):
            velocities.send(velocity_message((0.0, 0.0, left)))
            speeds.extend(odometry.decode(one).twist.twist.linear.y for one in odometry.take())
            return len(speeds) > 100 and abs(np.mean(speeds[-100:]) - left) < 0.1

        wait_until(moves, lambda: f"walking sideways: {sim.said} {controller.said}", interval=0.05)
    assert controller.interrupt() == 0
    assert sim.interrupt() == 0


def test_viewed_live_robot_sends_three_velocities(nodes):
    received = nodes("controller").subscribe(CMD_VEL)
    robot = LiveRobot(nodes("view"), twelve_joints.ROBOT)
    wait_until(lambda: robot.offered().command)
    robot.set_command((0.1, 0.2, -0.15))
    trace = robot.step()
    assert trace.command.tolist() == [0.1, 0.2, -0.15]
    assert read_velocity(received.decode(received_from(received, 1)[0])) == pytest.approx((0.1, 0.2, -0.15))
