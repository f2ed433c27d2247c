"""The simulated robot with the live controller, without a network; its messages; its display in the viewer."""

import itertools
from types import SimpleNamespace

import numpy as np
import pytest
from built_in import FOOT_RADIUS, STANCE_HEIGHT
from live_bench import EPOCH, Loop
from live_nodes import received_from
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import Mode
from quadruped_env.live.live_robot import NAME, LiveRobot
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.joint_messages import JointReader, command_message
from quadruped_env.live.messages.sensor_messages import Sensors
from quadruped_env.live.middleware.topics import CLOCK, CMD_VEL, IMU, JOINT_COMMANDS, JOINT_STATES, ODOMETRY, PUSH, TF
from quadruped_env.live.nodes import sim
from quadruped_env.live.simulated import WATCHDOG, SimulatedRobot
from quadruped_env.policies import load_policy
from quadruped_env.robot import JOINT_NAMES, MINI_QUADRUPED
from quadruped_env.ros import Qos, cdr
from quadruped_env.ros.timestamps import read_stamp
from quadruped_env.simulation import build_model, find_terrain, flat
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.task import terrain
from quadruped_env.viewer import ViewController

pytest.importorskip("cyclonedds")

SPREAD = 0.06
"""Between starts, m/s: the policy cannot measure its velocity."""


def speed_in_environment(velocity):
    """Mean forward velocity in m/s of the shipped policy in the environment, over the last 8 of 10 s."""
    policy = load_policy("flat")
    env = policy.make_env()
    observation, _ = env.reset(seed=0, options={"command": (velocity, 0.0)})
    speeds = []
    for _ in range(500):
        observation, _, _, _, info = env.step(policy.predict(observation))
        speeds.append(info["base_linear_velocity"][0])
    env.close()
    return np.mean(speeds[100:])


@pytest.fixture(scope="module")
def in_environment():
    """Forward velocity in m/s of the shipped policy in the environment, at 0.5 m/s commanded."""
    return speed_in_environment(0.5)


def test_live_controller_walks_turns_and_stands(in_environment):
    loop = Loop()
    loop.run(3.0)
    assert loop.live_controller.mode is Mode.WALKING
    speeds, upright = loop.run(6.0, (0.5, 0.0))
    assert np.mean(speeds[400:]) == pytest.approx(in_environment, abs=SPREAD)
    assert upright.min() > 0.95
    before = loop.robot.state.orientation[0].copy()
    loop.run(2.0, (0.0, 0.6))
    assert abs(before @ loop.robot.state.orientation[0]) < np.cos(0.5 * 0.6)  # over 0.6 rad around
    speeds, _ = loop.run(2.0)
    assert np.abs(speeds[-200:]).max() < 0.01


def test_watchdog_without_commands_makes_the_robot_limp_and_a_new_controller_gets_it_up(in_environment):
    loop = Loop()
    loop.run(5.0, (0.3, 0.0))
    loop.run(WATCHDOG - 0.05, commands=False)
    assert not loop.robot.limp
    # The motors only brake: it sinks slowly.
    loop.run(9.0, commands=False)
    assert loop.robot.limp
    assert loop.robot.state.base_position[0, 2] < 0.1
    loop.restart_live_controller()
    loop.run(8.0)
    assert loop.robot.state.base_position[0, 2] == pytest.approx(STANCE_HEIGHT, abs=0.02)
    speeds, _ = loop.run(5.0, (0.5, 0.0))
    assert np.mean(speeds[-400:]) == pytest.approx(in_environment, abs=SPREAD)


@pytest.mark.parametrize("terrain", ["rough", "hills"])
def test_live_controller_walks_on_other_terrains(terrain):
    loop = Loop(seed=1, terrain=terrain)
    loop.run(3.0)
    speeds, upright = loop.run(9.0, (0.4, 0.0))
    assert np.mean(speeds[800:]) > 0.35
    assert upright.min() > 0.9
    # It is on that ground, and not on the flat one under it.
    ground = HeightField.of(build_model(terrain=find_terrain(terrain).variant(1)))
    feet = loop.robot.state.foot_position[0]
    assert (feet[:, 2] - FOOT_RADIUS - ground.at(feet)).min() > -0.005
    assert ground.at(feet).max() > 0.003


def test_simulator_takes_commands_of_one_publisher_in_order_and_none_while_it_is_stopped(nodes):
    refused, robot = [], SimulatedRobot()
    session = SimpleNamespace(node=nodes("sim"), refuse=refused.append)
    commands = sim.Commands(session, robot, DriverJoints(MINI_QUADRUPED))
    first, second = (nodes(name).publish(JOINT_COMMANDS) for name in ("first", "second"))
    wait_until(lambda: first.readers and second.readers)

    def send(publisher, stamp, offset, stopped=False):
        publisher.send_bytes(command_message(MINI_QUADRUPED, stamp, MINI_QUADRUPED.stance + offset))
        wait_until(lambda: session.node.wait(0.1))
        commands.take(stopped)
        return robot.target - MINI_QUADRUPED.stance

    np.testing.assert_allclose(send(first, 5, 0.1), 0.1)
    np.testing.assert_allclose(send(second, 6, 0.2), 0.1)
    assert "/joint_commands: second (process" in refused[-1]
    assert "sends joint targets too, which comes from first (process" in refused[-1]
    np.testing.assert_allclose(send(first, 4, 0.3), 0.1)
    assert refused[-1] == "/joint_commands: older than the previous command; ignored"
    send(first, 7, 0.3, stopped=True)
    assert robot.limp
    np.testing.assert_allclose(send(first, 8, 0.2), 0.2)
    assert not robot.limp


def test_limp_robot_sinks_without_motor_torque():
    """It sinks to the ground and comes to rest there, far from its stance."""
    robot = SimulatedRobot()
    robot.command(LIMP)
    for _ in range(1000):
        robot.step()
    assert robot.limp
    assert robot.state.base_position[0, 2] < 0.1
    assert np.abs(robot.state.joint_velocity[0]).max() < 0.05
    assert np.abs(robot.state.joint_torque[0]).max() < 0.2


def test_push_adds_its_velocity_and_a_pick_up_ends_a_fall():
    robot = SimulatedRobot()
    for _ in range(100):
        robot.step()
    robot.push(np.array([0.0, 3.0, 3.0]))
    for _ in range(400):
        robot.step()
    place = robot.state.base_position[0, :2].copy()
    assert np.linalg.norm(place) > 0.2
    robot.pick_up()
    np.testing.assert_allclose(robot.state.base_position[0, :2], place, atol=1e-9)
    assert not robot.fallen
    assert robot.state.base_position[0, 2] == pytest.approx(STANCE_HEIGHT)


def test_pushes_that_add_up_are_refused_and_the_robot_stays_whole():
    """Six pushes of 5 m/s in one step would end in joint positions of 100,000 rad."""
    robot = SimulatedRobot()
    robot.push(np.array([0.0, 3.0, 4.0]))
    for _ in range(5):
        with pytest.raises(QuadrupedError, match=r"/push: .* of the last 1 s add up to 10 m/s"):
            robot.push(np.array([0.0, 3.0, 4.0]))
    for _ in range(400):
        robot.step()
        assert not robot.diverged
    # The time of the limit is the simulated one.
    robot.push(np.array([0.0, 3.0, 4.0]))


def test_simulator_publishes_no_diverged_state(nodes, run_node, monkeypatch):
    """Without the limit on pushes, as after any other cause."""
    monkeypatch.setattr("quadruped_env.simulation.push_limit.MAX_PUSH", 1e3)
    node, found = nodes(), []
    states = node.subscribe(JOINT_STATES, Qos(1000), read=JointReader(MINI_QUADRUPED))
    pushes = node.publish(PUSH)
    log = run_node("sim")

    def diverged():
        pushes.send(cdr.message(PUSH.type_name, x=20.0, y=10.0, z=-10.0))
        found.extend(joints.positions for _, joints in states.messages(pytest.fail))
        return "the simulation diverged; the robot is back at its start" in log.said

    wait_until(diverged, lambda: log.said, interval=0.2)
    found.extend(joints.positions for _, joints in states.messages(pytest.fail))
    assert len(found) > 10
    assert np.max(found - np.array(MINI_QUADRUPED.joint_position_high)) < 0.5
    assert np.max(np.array(MINI_QUADRUPED.joint_position_low) - found) < 0.5


def numbers(vector):
    return [vector.x, vector.y, vector.z]


def test_sensor_messages_agree_with_the_robots_state(nodes):
    node = nodes()
    robot = SimulatedRobot(seed=3)
    robot.push(np.array([0.3, -0.4, 0.1]))
    for _ in range(20):
        robot.step()
    subscriptions = [node.subscribe(topic) for topic in (CLOCK, IMU, JOINT_STATES, ODOMETRY, TF)]
    sensors = Sensors(node, MINI_QUADRUPED)
    sensors.send(EPOCH + 5, robot.state)
    clock, imu, joints, odometry, tf = [one.decode(received_from(one, 1)[0]) for one in subscriptions]
    state = robot.state
    w, x, y, z = state.orientation[0]
    assert read_stamp(clock.clock) == EPOCH + 5
    assert {read_stamp(one.header.stamp) for one in (imu, joints, odometry, tf.transforms[0])} == {EPOCH + 5}
    assert (imu.header.frame_id, odometry.child_frame_id) == ("base_link", "base_link")
    assert odometry.header.frame_id == "odom"
    np.testing.assert_array_equal([imu.orientation.w, *numbers(imu.orientation)], [w, x, y, z])
    np.testing.assert_array_equal(numbers(imu.angular_velocity), state.angular_velocity_b[0])
    np.testing.assert_array_equal(numbers(imu.linear_acceleration), state.linear_acceleration_b[0])
    np.testing.assert_array_equal(joints.position, state.joint_position[0])
    np.testing.assert_array_equal(joints.velocity, state.joint_velocity[0])
    np.testing.assert_array_equal(joints.effort, state.joint_torque[0])
    np.testing.assert_array_equal(numbers(odometry.pose.pose.position), state.base_position[0])
    np.testing.assert_array_equal(numbers(odometry.twist.twist.linear), state.linear_velocity_b[0])
    (base,) = tf.transforms
    assert (base.header.frame_id, base.child_frame_id) == ("odom", "base_link")
    np.testing.assert_array_equal(numbers(base.transform.translation), state.base_position[0])
    np.testing.assert_array_equal([base.transform.rotation.w, *numbers(base.transform.rotation)], [w, x, y, z])


def test_viewer_shows_the_live_robot_and_steers_it(nodes, tmp_path):
    robot_node, viewer_node = nodes("robot"), nodes("viewer")
    live = LiveRobot(viewer_node, MINI_QUADRUPED)
    show = ViewController({NAME: lambda: live}, [NAME], tmp_path)
    robot, sensors = SimulatedRobot(), Sensors(robot_node, MINI_QUADRUPED)
    velocities, pushes = robot_node.subscribe(CMD_VEL), robot_node.subscribe(PUSH)
    robot.push(np.array([0.4, 0.2, 0.0]))
    show.set_command(0.3, -0.2)
    stamps = itertools.count(EPOCH, 5_000_000)

    def sends_a_state():
        robot.step()
        sensors.send(next(stamps), robot.state)
        show.advance(0.02)

    wait_until(lambda: sends_a_state() or (velocities.writers and live.receives_states), "both directions")
    show.advance(0.02)
    twist = velocities.decode(received_from(velocities, 1)[-1])
    assert (twist.linear.x, twist.angular.z) == (0.3, -0.2)

    def shown():
        sensors.send(next(stamps), robot.state)
        show.advance(0.02)
        return np.array_equal(show.view().robots[0].now.joint_position, robot.state.joint_position[0])

    wait_until(shown)
    seen = show.view().robots[0].now
    np.testing.assert_allclose(seen.base_pose[:3], robot.state.base_position[0], atol=1e-12)
    np.testing.assert_allclose(seen.joint_velocity, robot.state.joint_velocity[0], atol=1e-12)
    np.testing.assert_allclose(seen.velocity[0], robot.state.linear_velocity_b[0, 0], atol=1e-9)
    assert not pushes.take()
    wait_until(lambda: pushes.writers)
    show.push(direction=np.pi / 2, strength=0.5)
    (received,) = wait_until(pushes.take, "the push")
    push = pushes.decode(received)
    heading = show.view().robots[0].heading
    np.testing.assert_allclose(numbers(push), [-0.5 * np.sin(heading), 0.5 * np.cos(heading), 0.0], atol=1e-9)
    show.advance(0.02)
    assert not pushes.take()
    show.close()


@terrain(size=10.0)
def ramp(grid):
    """Slope of 0.1 along x."""
    return 0.1 * grid.x


@pytest.mark.parametrize("ground", [flat, ramp], ids=lambda ground: ground.name)
def test_viewer_without_odometry_shows_the_robot_on_its_feet(nodes, tmp_path, ground):
    robot_node, viewer_node = nodes("robot"), nodes("viewer")
    live = LiveRobot(viewer_node, MINI_QUADRUPED, terrain=ground)
    show = ViewController({NAME: lambda: live}, [NAME], tmp_path)
    states = robot_node.publish(JOINT_STATES)
    positions = np.array([0.3, -0.9] * 4)
    message = cdr.message(JOINT_STATES.type_name, header=cdr.header(EPOCH), name=list(JOINT_NAMES), position=positions)
    wait_until(lambda: states.send(message) or show.advance(0.02) or live.receives_states, "the robot's states")
    show.advance(0.02)
    seen = show.view().robots[0].now
    np.testing.assert_allclose(seen.joint_position, positions)
    expected = MINI_QUADRUPED.skeleton.resting_pose(positions)
    expected[2] += 0.03 if ground is ramp else 0.0  # 0.3 m uphill, where the grid covers the robot
    np.testing.assert_allclose(seen.base_pose, expected, atol=1e-6)
    show.close()
