"""The nodes as processes: simulator and controller walk, also after one of them is killed, silent or sends noise."""

import re
import time
from itertools import count

import numpy as np
import pytest
from built_in import STANCE
from live_nodes import joint_state, received_from
from waiting import wait_until

from quadruped_env import JOINT_NAMES, SinusoidalGait
from quadruped_env.control.joint_command import LIMP
from quadruped_env.live import Node
from quadruped_env.live.messages.joint_messages import JointReader, read_target
from quadruped_env.live.middleware.topics import CMD_VEL, IMU, JOINT_COMMANDS, JOINT_STATES, ODOMETRY
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import SENSOR_DATA_QOS, Qos, cdr

pytest.importorskip("cyclonedds")


class Watcher:
    """A node that publishes a velocity command and watches the robot's odometry."""

    def __init__(self, velocity=0.5, names=None):
        self.node = Node("watcher", names=names)
        self.velocity = velocity
        self.distance = 0.0
        """Last distance of the base from the origin, m."""
        self._velocities = self.node.publish(CMD_VEL)
        self._odometry = self.node.subscribe(ODOMETRY, Qos(1000))
        self._twist = cdr.message(CMD_VEL.type_name, linear={"x": velocity})

    def watch(self, seconds):
        """Forward speeds (T,) and heights (T,) of the base over a period of the robot's time, with states at 100 Hz."""
        found = []

        def watched():
            self._velocities.send(self._twist)
            found.extend(self._odometry.decode(one) for one in self._odometry.take())
            if found:
                place = found[-1].pose.pose.position
                self.distance = np.hypot(place.x, place.y)
            return len(found) >= round(100.0 * seconds)

        wait_until(watched, f"{seconds:g} s of /odom", interval=0.05)
        return (
            np.array([one.twist.twist.linear.x for one in found]),
            np.array([one.pose.pose.position.z for one in found]),
        )

    def until_it_walks(self):
        """Wait until the mean speed over a second is the commanded one."""
        wait_until(lambda: abs(np.mean(self.watch(1.0)[0]) - self.velocity) < 0.1, "walking")

    def until_it_lies(self):
        """Wait until the robot has sunk to the ground, which takes over 10 s if its legs balance it."""
        wait_until(lambda: self.watch(0.3)[1][-1] < 0.12, "lying")


@pytest.fixture
def watcher(domain_id):
    made = Watcher()
    yield made
    made.node.close()


def test_two_processes_walk_and_a_second_simulator_is_refused(start, watcher, nodes):
    commands = nodes("listener").subscribe(JOINT_COMMANDS, read=JointReader(MINI_QUADRUPED))
    sim, controller = start("sim"), start("controller")
    watcher.watch(0.1)
    second = start("sim")
    watcher.until_it_walks()
    assert second.status() == 2
    assert "/joint_states: sim (process " in second.said
    assert "publishes it already on domain" in second.said
    assert controller.interrupt() == 0
    assert read_target(list(commands.messages(pytest.fail))[-1][1]) is LIMP
    assert sim.interrupt() == 0
    for node in (sim, controller):
        assert "ended after" in node.said.splitlines()[-1]
    steps = ["going to the stance", "following the command"]
    assert sorted(steps, key=controller.said.index) == steps


@pytest.mark.slow
def test_robot_after_its_controller_is_killed_goes_limp_and_walks_with_the_next_one(start, watcher):
    sim, controller = start("sim"), start("controller")
    watcher.until_it_walks()
    controller.kill()
    watcher.until_it_lies()
    assert "limp: no command for 1 s" in sim.said
    start("controller")
    watcher.until_it_walks()


def test_gait_publishes_the_tutorials_joint_states(run_node, nodes):
    states = nodes("listener").subscribe(JOINT_STATES, Qos(1000))
    gait = run_node("gait")
    received = received_from(states, 20, gait)
    assert gait.interrupt() == 0
    read = JointReader(MINI_QUADRUPED)
    joints = [read(one.data) for one in received]
    stamps = np.array([one.stamp for one in joints])
    # On a busy machine it may skip a tick.
    assert set(np.diff(stamps) % 50_000_000) == {0}
    assert min(np.diff(stamps)) == 50_000_000
    preset = SinusoidalGait.preset("article")
    # The publisher may have started before it was discovered: the first received state gives its phase.
    first = joints[0].positions
    offset = next(k for k in count() if np.allclose(preset.positions(0.05 * k), first, rtol=0.0, atol=1e-12))
    times = (stamps - stamps[0]) / 1e9 + 0.05 * offset
    np.testing.assert_allclose([one.positions for one in joints], preset.positions(times), rtol=0.0, atol=1e-12)
    np.testing.assert_allclose([one.velocities for one in joints], preset.velocities(times), rtol=0.0, atol=1e-12)
    assert np.all(np.array([one.efforts for one in joints]) == 0.0)
    message = cdr.deserialize(received[0].data, JOINT_STATES.type_name)
    assert message.name == list(JOINT_NAMES)


def test_best_effort_driver_is_received_and_a_second_robot_is_refused(run_node, nodes):
    driver = nodes("driver")
    states, attitudes = driver.publish(JOINT_STATES, SENSOR_DATA_QOS), driver.publish(IMU, SENSOR_DATA_QOS)
    commands = driver.subscribe(JOINT_COMMANDS)
    run_node("controller")
    second = run_node("sim")

    def send():
        header = cdr.header(time.time_ns())
        attitudes.send(cdr.message(IMU.type_name, header=header, orientation={"w": 1.0}))
        states.send(joint_state(time.time_ns(), **at_rest))
        time.sleep(0.01)

    at_rest = {"position": STANCE, "velocity": np.zeros(8)}
    wait_until(lambda: send() or commands.take(), "a command")
    wait_until(lambda: send() or second.poll() is not None, "the refusal")
    assert second.status() == 2
    assert f"{JOINT_STATES.name}: driver" in second.said


@pytest.mark.slow
def test_display_starts_and_ends_its_nodes(start):
    display = start("display", "--preset", "walk", "--port", "0")
    for words in (r"\[view\] the live robot: http://127\.0\.0\.1:", r"\[state\] waited .* for /joint_states"):
        wait_until(lambda words=words: re.search(words, display.said), words, alive=display.process)
    assert display.interrupt() == 0
    for name in ("gait", "state", "view"):
        assert f"[{name}] ended after" in display.said
