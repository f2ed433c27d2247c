"""The robot of the live topics in the viewer: drawn from received messages, commanded and pushed by messages."""

import functools
import math
import time
from typing import Any, Final

import numpy as np

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gait_settings import GaitSettings
from quadruped_env.gait.gaits import limit_violations
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.joint_messages import JointReader, Joints
from quadruped_env.live.messages.steering_messages import read_settings, settings_message, velocity_message
from quadruped_env.live.middleware.node import Node, Refused, message_reader
from quadruped_env.live.middleware.topics import (
    CMD_VEL,
    GAIT,
    GAIT_SETTINGS,
    JOINT_STATES,
    ODOMETRY,
    PUSH,
)
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import SENSOR_DATA_QOS, cdr
from quadruped_env.simulation import SingleSimulation, Terrain, build_model, flat, highest_ground
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.rotations import rotate
from quadruped_env.viewer.viewed_robot import Offered, ViewedRobot, ViewedTrace, heading, sample, world_vector

NAME: Final = "live robot"
_ROW: Final = np.zeros(1, dtype=np.intp)
_TIMESTEP: Final = 0.02
"""Time between samples, s."""
_SMOOTHING: Final = 1.0 - math.exp(-_TIMESTEP / 0.2)
"""Filter gain of the velocity average over about one gait cycle, as in the simulated robot's plots."""
_CONTACT: Final = 1.0
"""Contact force above which a foot counts as on the ground, N."""
_ODOMETRY_TIMEOUT: Final = 1.0
"""Age of the last odometry after which the robot is drawn standing at its last position, without velocity, s."""
_STOP_PERIOD: Final = 1.0
"""Time for which a zero command is repeated, so that other publishers may take over afterwards, s."""
_COMMAND_PERIOD: Final = 0.1
_SETTINGS_HOLD: Final = 1.0
"""Time after a change of the gait's settings during which received settings are ignored, s."""
_OVERTRAVEL: Final = 0.02
"""Angle by which a joint stop may give way, and speed tolerance, rad and rad/s."""
_MAX_VALUE: Final = 1e6
"""Largest accepted value, m, m/s or rad/s."""
_MIN_NORM: Final = 1e-3
"""Smallest quaternion norm that still defines an orientation."""


class LiveRobot(ViewedRobot):
    """A robot that takes its state from topics and sends commands as messages.

    Args:
        node: the node that subscribes, and publishes commands and pushes.
        robot: the robot.
        refused: called with the reason for each message that cannot be drawn.
        terrain: the ground to draw, which no message describes.
        driver: conversion of the driver's joints; None: they are the robot's.
    """

    def __init__(
        self,
        node: Node,
        robot: Robot,
        refused: Refused = lambda reason: None,
        terrain: Terrain = flat,
        driver: DriverJoints | None = None,
    ) -> None:
        simulation = SingleSimulation(build_model(terrain=terrain, robot=robot), robot)
        super().__init__(NAME, robot, simulation, terrain, _TIMESTEP)
        self._driver = driver or DriverJoints(robot)
        joints = JointReader(self._driver, states=True)
        self._states = node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=joints)
        self._odometry = node.subscribe(ODOMETRY, SENSOR_DATA_QOS, read=message_reader(ODOMETRY, _read_odometry))
        self._velocities, self._pushes = node.publish(CMD_VEL), node.publish(PUSH)
        self._gaits = node.publish(GAIT)
        read = functools.partial(read_settings, robot=robot)
        self._gait_settings = node.subscribe(GAIT_SETTINGS, read=message_reader(GAIT_SETTINGS, read))
        self._settings: GaitSettings | None = None
        self._changed_at = -_SETTINGS_HOLD
        self._positions, self._joint_velocities, self._efforts = robot.stance, *np.zeros((2, robot.num_joints))
        self.receives_states = False
        """True once a joint of the robot has been received."""
        self._pose = robot.skeleton.resting_pose(robot.stance)
        self._twist = np.zeros(6)
        self._odometry_at = -_ODOMETRY_TIMEOUT
        self._command = np.zeros(len(velocity_commands(robot)))
        self._commanded_at = -_STOP_PERIOD
        self._sent_at = 0.0
        self._refused = refused
        self._steps = 0
        self._smooth_velocity = np.zeros_like(self._command)
        self.reset(0, (0.0,) * len(self._command))

    def reset(self, seed: int, command: tuple[float, ...]) -> None:
        """Clear the plots and set the command; the robot stays where it is."""
        self._command = np.array(command)
        self._steps = 0
        self._smooth_velocity[:] = 0.0
        self.history.clear()
        self._place()

    def set_command(self, command: tuple[float, ...]) -> None:
        """Set the velocity command, m/s and rad/s. Sent with the next message."""
        self._command = np.array(command)

    def push(self, velocity: tuple[float, float]) -> None:
        """Send a push: a velocity (forwards, left) in the robot's heading frame, m/s, that is added to its base."""
        x, y, z = world_vector(velocity, heading(self.data)).tolist()
        self._pushes.send(cdr.message(PUSH.type_name, x=x, y=y, z=z))

    def step(self) -> ViewedTrace:
        """Take the newest state from the topics, and send the command."""
        now = time.monotonic()
        self._listen(now)
        self._steer(self._command, now)
        if now - self._odometry_at > _ODOMETRY_TIMEOUT:
            resting = self.robot.skeleton.resting_pose(self._positions)
            resting[2] += highest_ground(self._simulation, self._pose[:2])
            self._pose, self._twist = np.concatenate([self._pose[:2], resting[2:]]), np.zeros(6)
        self._steps += 1
        return self._place()

    def _place(self) -> ViewedTrace:
        """Set the model to the last received state."""
        qpos = np.concatenate([self._pose, self._positions])
        qvel = np.concatenate([self._twist, self._joint_velocities])
        self._simulation.reset(_ROW, qpos[None], qvel[None])
        readings = self._simulation.readings
        (forward, left, _), turn = readings.linear_velocity_b[0], readings.angular_velocity_b[0, 2]
        velocity = np.array([forward, turn, left])[: len(self._smooth_velocity)]
        self._smooth_velocity += _SMOOTHING * (velocity - self._smooth_velocity)
        moment = sample(
            self.robot,
            self.timestep,
            self.terrain,
            readings,
            time=np.array([self._steps * self.timestep]),
            command=self._command[None],
            smooth_velocity=self._smooth_velocity[None],
            joint_torque=self._efforts[None],
            contact=readings.foot_force > _CONTACT,
            reward_terms=np.zeros((1, 0)),
        )
        self.history.append(moment)
        return moment

    @property
    def gait(self) -> GaitSettings | None:
        """The settings of the `gait` node's gait; None while there is no such node."""
        return self._settings if self._gaits.readers else None

    @gait.setter
    def gait(self, settings: GaitSettings) -> None:
        if self.gait is None:
            raise QuadrupedError(f"gait: {self.name!r} has no scripted gait; start the `gait` node to change one")
        self._gaits.send(settings_message(settings))
        self._settings, self._changed_at = settings, time.monotonic()

    def complaints(self) -> list[str]:
        """Return the descriptions of the joint limits that the last states of the `gait` node's gait exceed."""
        if self.gait is None:
            return []
        positions = np.array([moment.joint_position for moment in self.history])
        speed = np.abs([moment.joint_velocity for moment in self.history]).max(axis=0)
        return limit_violations(self.robot, positions.min(axis=0), positions.max(axis=0), speed, _OVERTRAVEL)

    def offered(self) -> Offered:
        """Return the available controls, those with a subscriber, and readings."""
        return Offered(
            command=bool(self._velocities.readers),
            push=bool(self._pushes.readers),
            sources=False,
            motion=time.monotonic() - self._odometry_at <= _ODOMETRY_TIMEOUT,
        )

    def _listen(self, now: float) -> None:
        for _, joints in self._states.messages(self._refused):
            self._take(self._driver.to_robot(joints))
        newest = self._odometry.newest(self._refused)
        if newest is not None:
            self._odometry_at = now
            self._pose, self._twist = newest[1]
        settings = self._gait_settings.newest(self._refused)
        # While a slider is dragged, received settings are older than the slider.
        if settings is not None and now - self._changed_at > _SETTINGS_HOLD:
            self._settings = settings[1]

    def _take(self, joints: Joints) -> None:
        """Take a message, which may hold some of the joints only; velocities and torques that it lacks are zero."""
        assert joints.positions is not None
        found = np.isfinite(joints.positions)
        zeros = np.zeros(len(found))
        velocities = zeros if joints.velocities is None else np.nan_to_num(joints.velocities)
        efforts = zeros if joints.efforts is None else joints.efforts
        self._positions = np.where(found, joints.positions, self._positions)
        self._joint_velocities = np.where(found, velocities, self._joint_velocities)
        self._efforts = np.where(found, efforts, self._efforts)
        self.receives_states |= bool(found.any())

    def _steer(self, command: Floats, now: float) -> None:
        """Send the viewer's command while it is not zero, and zero for a moment afterwards."""
        if command.any():
            self._commanded_at = now
        if now - self._commanded_at > _STOP_PERIOD or now - self._sent_at < _COMMAND_PERIOD:
            return
        self._sent_at = now
        self._velocities.send(velocity_message(command))


def _read_odometry(odometry: Any) -> tuple[Floats, Floats]:
    """Read base pose (7,) and velocity (6,) of an `/odom` message, in MuJoCo's conventions.

    Raises:
        QuadrupedError: if a value is not finite or too large, or the orientation is zero.
    """
    place, turn = odometry.pose.pose.position, odometry.pose.pose.orientation
    linear, angular = odometry.twist.twist.linear, odometry.twist.twist.angular
    pose = np.array([place.x, place.y, place.z, turn.w, turn.x, turn.y, turn.z])
    velocity = np.array([linear.x, linear.y, linear.z])
    rate = np.array([angular.x, angular.y, angular.z])
    length = float(np.linalg.norm(pose[3:]))
    if not (np.abs(np.concatenate([pose, velocity, rate])) <= _MAX_VALUE).all() or length < _MIN_NORM:
        raise QuadrupedError(
            f"a value is not finite or over {_MAX_VALUE:g}, or the orientation is zero; send finite "
            f"numbers and a unit quaternion"
        )
    pose[3:] /= length
    return pose, np.concatenate([rotate(pose[3:], velocity), rate])
