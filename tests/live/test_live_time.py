"""Simulated time at any rate, resets and the emergency stop."""

import itertools
import re
import time

import numpy as np
import pytest
from built_in import STANCE, STANCE_HEIGHT
from live_bench import Bench
from live_nodes import joint_state, received_from
from test_live_nodes import Watcher
from waiting import wait_until

from quadruped_env import JOINT_NAMES
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import Mode
from quadruped_env.live.middleware.topics import (
    CLOCK,
    CMD_VEL,
    DIAGNOSTICS,
    ESTOP,
    IMU,
    JOINT_COMMANDS,
    JOINT_STATES,
    RESET,
)
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import cdr

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

PERIOD = 10_000_000
"""Of the states, ns."""


@pytest.mark.parametrize("with_clock", [True, False])
def test_controller_in_simulated_time_moves_and_starts_again_after_a_jump_back(run_node, nodes, with_clock):
    """Simulated time advances with the states, whatever the speed of this machine."""
    robot = nodes("simulator")
    states, attitudes, commands = robot.publish(JOINT_STATES), robot.publish(IMU), robot.subscribe(JOINT_COMMANDS)
    velocities, diagnostics = robot.publish(CMD_VEL), robot.subscribe(DIAGNOSTICS)
    clock = robot.publish(CLOCK) if with_clock else None
    log = run_node("controller", "--sim-time")

    def send(stamp):
        header = cdr.header(stamp)
        if clock is not None:
            clock.send(cdr.message(CLOCK.type_name, clock=header.stamp))
        attitudes.send(cdr.message(IMU.type_name, header=header, orientation={"w": 1.0}))
        states.send(joint_state(stamp, JOINT_NAMES, STANCE, np.zeros(8)))
        time.sleep(0.002)

    wait_until(lambda: states.readers and attitudes.readers and (clock is None or clock.readers))
    wait_until(lambda: velocities.readers)
    for start in (100 * 10**9, PERIOD):
        seen = log.said.count("following the command")
        stamps = itertools.count(start, PERIOD)
        if start > PERIOD:
            velocities.send(cdr.message(CMD_VEL.type_name, linear={"x": 0.3}))
        wait_until(lambda stamps=stamps, seen=seen: (
            send(next(stamps)) or log.said.count("following the command") > seen
        ), lambda: log.said)  # fmt: skip
    assert "waiting for fresh states (the clock was set back)" in log.said
    assert "limp" not in log.said
    assert commands.take()

    def stands():
        """The velocity command, which came at 100 s by the clock before, has expired."""
        send(next(stamps))
        found = [status_values(diagnostics, one) for one in diagnostics.take()]
        return found and found[-1]["velocity command"] == "False"

    wait_until(stands, lambda: log.said)


def test_emergency_stop_makes_the_robot_limp_until_it_is_released():
    bench = Bench().walk()
    assert bench.live_controller.emergency_stop(True).target is LIMP
    assert bench.live_controller.emergency_stop(True) is None
    assert bench.pass_time(5.0) == []
    assert bench.live_controller.waiting_for == "the release of the emergency stop"
    assert bench.live_controller.emergency_stop(False) is None
    # Zero is what an idle joystick or keyboard sends.
    assert bench.pass_time(5.0, command=(0.0, 0.0)) == []
    assert bench.live_controller.waiting_for.startswith("a velocity command other than zero (/cmd_vel)")
    assert bench.pass_time(0.1, command=(0.3, 0.0)) == []
    bench.pass_time(3.0)
    assert bench.mode is Mode.WALKING


def status_values(diagnostics, received):
    """Values of the controller's status by key."""
    return {one.key: one.value for one in diagnostics.decode(received).status[0].values}


def status_of_controller(diagnostics):
    """Level, message and values of the newest status, after those that were sent before."""
    diagnostics.take()
    newest = received_from(diagnostics, 2)[-1]
    (status,) = diagnostics.decode(newest).status
    assert (status.name, status.hardware_id) == ("/controller: robot", MINI_QUADRUPED.name)
    return status.level, status.message, status_values(diagnostics, newest)


@pytest.mark.slow
@pytest.mark.parametrize("factor", ["0.3", "0.98", "2"])
def test_robot_walks_in_a_simulator_that_is_slower_or_faster_than_real_time(start, domain_id, factor):
    watcher = Watcher()
    start("sim", "--real-time-factor", factor)
    start("controller", "--sim-time")
    watcher.until_it_walks()
    watcher.node.close()


def test_simulation_resets_and_stops(run_node, nodes):
    watcher = Watcher()
    user = nodes("user")
    resets, stops = user.publish(RESET), user.publish(ESTOP)
    diagnostics = user.subscribe(DIAGNOSTICS)
    controller = [run_node(name) for name in ("sim", "controller")][1]
    # Both nodes, of each of which the three readers that match a reliable publisher; a volatile one two of them.
    wait_until(lambda: (resets.readers, stops.readers) == (4, 6))
    watcher.until_it_walks()
    assert status_of_controller(diagnostics)[:2] == (0, "following the command")
    wait_until(lambda: watcher.watch(0.1) and watcher.distance > 0.3)
    resets.send(cdr.message(RESET.type_name))
    wait_until(lambda: "waiting for fresh states (reset)" in controller.said, lambda: controller.said)
    wait_until(lambda: watcher.watch(0.1) and watcher.distance < 0.2)
    wait_until(lambda: controller.said.count("following the command") == 2, lambda: controller.said)
    stops.send(cdr.message(ESTOP.type_name, data=True))
    # The simulator's motors go limp too: it sinks.
    wait_until(lambda: watcher.watch(0.1)[1][-1] < STANCE_HEIGHT - 0.03, lambda: controller.said)
    waiting = r"waiting for the release of the emergency stop \(/estop: by user.*\) \(\d+ s\)"
    wait_until(lambda: re.search(waiting, controller.said), lambda: controller.said)
    level, message, values = status_of_controller(diagnostics)
    assert level == 2
    assert message.startswith("limp; waits for the release of the emergency stop (/estop: by user")
    assert values["policy"] == "flat"
    assert float(values["/joint_states, Hz"]) > 0.0
    stops.send(cdr.message(ESTOP.type_name, data=False))
    walking = "following the command"
    wait_until(lambda: watcher.watch(0.1) and controller.said.count(walking) == 3, lambda: controller.said)
    assert watcher.watch(0.5)[1][-1] == pytest.approx(STANCE_HEIGHT, abs=0.03)
    watcher.node.close()
