"""Input of the controller: measurements of joints and IMU, and velocity commands."""

import functools
import time
from collections.abc import Callable
from typing import Final

import numpy as np

from quadruped_env.control.joint_command import Target
from quadruped_env.control.live_controller import LiveController, Measurement
from quadruped_env.control.steering import Velocity
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.control_time import ControlTime
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.imu_messages import Imu, in_base, read_imu
from quadruped_env.live.messages.joint_messages import JointMerger, JointReader, Joints, Period
from quadruped_env.live.messages.steering_messages import read_velocity
from quadruped_env.live.middleware.node import message_reader
from quadruped_env.live.middleware.topics import CMD_VEL, CMD_VEL_STAMPED, IMU, JOINT_STATES
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.live.state_checks import FrozenJoints, ImuRepetition, Sources
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import SENSOR_DATA_QOS, Qos
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.arrays import Floats

_STATES_QOS: Final = Qos(depth=50, reliable=False)
"""As for sensor data, but deep enough for states that come as one message per joint."""
_COMMANDS_QOS: Final = Qos(depth=10, reliable=False)
"""Matches reliable and best-effort publishers."""
_COMMAND_TIMEOUT: Final = 0.5
"""System time after which a velocity command expires, where the controller's own timeout is in simulated time, s."""
_SILENCE: Final = 0.5
"""Time without a message after which a waiting node says so, s."""
_SLOW, _FAST = 0.9, 0.95
"""Fractions of the control rate: inputs below the first are slow, until they are above the second."""


class Measurements:
    """Combines joint states and orientations into measurements.

    Args:
        robot: the robot.
        driver: conversion of the driver's joints.
        velocities: True if measurements need joint velocities.
        mount: orientation of the IMU in the base frame, unit quaternion wxyz (4,); None: the base frame itself.
    """

    def __init__(
        self,
        session: Session,
        robot: Robot,
        driver: DriverJoints,
        velocities: bool,
        mount: Floats | None,
    ) -> None:
        node = session.node
        self._session = session
        # Drivers of real robots may offer only best-effort delivery.
        reader = JointReader(driver, states=True)
        self._states = node.subscribe(JOINT_STATES, _STATES_QOS, read=reader)
        self._attitudes = node.subscribe(IMU, SENSOR_DATA_QOS, read=message_reader(IMU, read_imu))
        self._driver = driver
        self._merger = JointMerger(driver, velocities, session.say, driver.rates)
        self._base, self._mount = robot.base_name, mount
        self._imu: Imu | None = None
        self._repetition = ImuRepetition()
        self._joint_sources = Sources(node.graph, self._states.topic, driver.joint_names)
        self._imu_sources = Sources(node.graph, self._attitudes.topic, ["an orientation"])
        self._joints = FrozenJoints(robot.joint_names, session.say)
        self._imu_period = Period()
        self._heard = dict.fromkeys((JOINT_STATES.name, IMU.name), time.monotonic())
        """Time at which the last message that can be read was taken, s, by topic."""
        self._unread: dict[str, str] = {}
        """Why the last message could not be read, by topic."""
        self._refusal = ""
        """Why the last messages gave no measurement; empty if they gave one."""

    def newest(self) -> tuple[Measurement, float] | None:
        """Return the newest valid measurement and the `time.monotonic` (s) at which it was taken, or None.

        Raises:
            QuadrupedError: if the times of joint states and IMU differ, the IMU only repeats itself, or its orientation
                on the base is unknown.
        """
        # Joint states first: an orientation sent before a joint state has then arrived as well.
        states = []
        for received, joints in self._states.messages(functools.partial(self._refuse, JOINT_STATES.name)):
            self._heard[JOINT_STATES.name] = received.taken
            self._unread.pop(JOINT_STATES.name, None)
            assert joints.positions is not None
            found = np.flatnonzero(np.isfinite(joints.positions))
            if refusal := self._joint_sources.refusal(received, found.tolist()):
                self._session.refuse(refusal)
            elif state := self._merger.add(joints):
                of_robot = self._driver.to_robot(state)
                assert of_robot.positions is not None
                self._joints.add(of_robot.stamp, of_robot.positions)
                states.append((received, of_robot))
        for received, imu in self._attitudes.messages(functools.partial(self._refuse, IMU.name)):
            self._heard[IMU.name] = received.taken
            self._unread.pop(IMU.name, None)
            if refusal := self._imu_sources.refusal(received, [0]):
                self._session.refuse(refusal)
                continue
            self._imu_period.add(imu.stamp)
            self._repetition.add(imu, self._joints.moved)
            self._imu = imu
        if not states or self._imu is None:
            return None
        received, newest = max(states, key=lambda state: state[1].stamp)
        try:
            measurement = self._paired(newest, self._imu)
        except QuadrupedError as error:
            self._refusal = str(error)
            raise
        self._refusal = ""
        return measurement, received.taken

    def commanded(self, target: Target) -> None:
        """Take the joint targets (J,) that the robot was sent, in rad."""
        self._joints.commanded(target)

    @property
    def problems(self) -> tuple[str, ...]:
        """Problems of messages that can be read."""
        return tuple(filter(None, (self._joint_sources.problem, self._imu_sources.problem, *self._joints.problems)))

    def _paired(self, joints: Joints, imu: Imu) -> Measurement:
        if self._repetition.frozen:
            raise QuadrupedError(
                f"{IMU.name}: repeats the same numbers bit for bit while the robot moves, with new timestamps; check "
                f"the sensor and its driver"
            )
        age = (joints.stamp - imu.stamp) / NS_PER_SECOND
        tolerance = max(self._merger.period.tolerance, self._imu_period.tolerance)
        if abs(age) > tolerance:
            raise QuadrupedError(
                f"{IMU.name}: {abs(age):.3g} s {'older' if age > 0.0 else 'newer'} than {JOINT_STATES.name}, over "
                f"{tolerance:.3g} s (1.5 periods); check the clocks of both publishers"
            )
        imu = in_base(imu, self._base, self._mount)
        assert joints.positions is not None
        assert joints.velocities is not None
        return Measurement(joints.stamp, joints.positions, joints.velocities, imu.orientation, imu.angular_velocity)

    def _refuse(self, name: str, reason: str) -> None:
        self._unread[name] = f": {reason.partition(': ')[2]}"
        self._session.refuse(reason)

    @property
    def rates(self) -> dict[str, float]:
        """Rates of complete joint states and of the IMU by their timestamps, Hz, by topic, as far as known."""
        found = {JOINT_STATES.name: self._merger.period.rate, IMU.name: self._imu_period.rate}
        return {name: rate for name, rate in found.items() if rate is not None}

    def missing(self) -> str:
        """Return why there are no measurements; empty if they come."""
        silent = [one.topic.name for one in (self._states, self._attitudes) if not one.writers]
        if silent:
            return f"a publisher of {' and of '.join(silent)}"
        now = time.monotonic()
        for name, heard in self._heard.items():
            if now - heard > _SILENCE:
                return f"{name}: no message that can be read for {now - heard:.1f} s{self._unread.get(name, '')}"
        return self._merger.missing or self._refusal


class SlowInputs:
    """Names inputs that are slower than the control steps: a policy was trained with a new state in each of them.

    Args:
        control_rate: rate of the control steps, Hz.
        say: called with a line of text when the rates are known, and when an input becomes slow or fast enough.
    """

    def __init__(self, control_rate: float, say: Callable[[str], None]) -> None:
        self.warning = ""
        """The slow inputs; empty if there are none."""
        self._control_rate, self._say = control_rate, say
        self._slow: dict[str, bool] = {}
        self._pace = Pace(_SILENCE)

    def update(self, rates: dict[str, float]) -> None:
        """Take the present rates of the inputs in Hz, by topic; call it often."""
        if not self._pace.tick():
            return
        before, texts = self._slow, {name: f"{name} at {rate:.0f} Hz" for name, rate in rates.items()}
        limits = {name: self._control_rate * (_FAST if before.get(name) else _SLOW) for name in rates}
        self._slow = {name: rate < limits[name] for name, rate in rates.items()}
        slow = [texts[name] for name, is_slow in self._slow.items() if is_slow]
        self.warning = f"{', '.join(slow)}, below the control rate of {self._control_rate:g} Hz" if slow else ""
        if self._slow != before:
            effect = ": control steps without a new state use the last one, and the policy may walk worse"
            known = f"{', '.join(texts.values())}; control rate {self._control_rate:g} Hz"
            self._say(f"{self.warning}{effect}" if slow else known)


class VelocityCommands:
    """Forwards velocity commands, Twist and TwistStamped, to the controller."""

    def __init__(self, session: Session, live_controller: LiveController) -> None:
        self._session = session
        self._live_controller = live_controller
        self._subscriptions = [
            session.node.subscribe(topic, _COMMANDS_QOS, read=message_reader(topic, read_velocity))
            for topic in (CMD_VEL, CMD_VEL_STAMPED)
        ]
        self._last: tuple[float, Velocity] | None = None
        """The `time.monotonic` at which the last command was taken, s, and the command."""

    def take(self, clock: ControlTime) -> None:
        """Forward the newest command; `clock` is the controller's."""
        newest = [one for one in (each.newest(self._session.refuse) for each in self._subscriptions) if one]
        if newest:
            received, command = max(newest, key=lambda one: one[0].sent)
            self._last = received.taken, command
        elif not clock.simulated or self._last is None or time.monotonic() - self._last[0] > _COMMAND_TIMEOUT:
            # In simulated time, a command that is new by the system's time is repeated: its publisher may not be
            # slowed down or accelerated with the simulator.
            return
        assert self._last is not None
        taken, velocity = self._last
        try:
            self._live_controller.command(velocity, clock.of(taken))
        except QuadrupedError as error:
            self._last = None
            self._session.refuse(str(error))
