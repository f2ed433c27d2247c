"""The robot's sensor topics, published from a simulation's readings."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.middleware.node import Node
from quadruped_env.live.middleware.topics import CLOCK, IMU, JOINT_STATES, ODOMETRY, TF
from quadruped_env.robot.readings import Readings
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.skeleton import ODOMETRY_FRAME, Transform
from quadruped_env.ros import cdr
from quadruped_env.ros.robot_messages import joint_state, transform_messages
from quadruped_env.ros.timestamps import write_stamp


class Sensors:
    """The robot's publishers: joint states, IMU, odometry, the base's transform and the clock.

    Args:
        robot: robot whose readings are sent.
        driver: conversion to the driver's joints; None: they are the robot's.
    """

    def __init__(self, node: Node, robot: Robot, driver: DriverJoints | None = None) -> None:
        base = robot.base_name
        self._clock, self._imu, self._odometry = node.publish(CLOCK), node.publish(IMU), node.publish(ODOMETRY)
        self._tf, self._joints = node.publish(TF), node.publish(JOINT_STATES)
        self._robot = robot
        self._driver = driver or DriverJoints(robot)
        self._time = cdr.message("rosgraph_msgs/msg/Clock")
        self._attitude = cdr.message("sensor_msgs/msg/Imu", header=cdr.header(0, base))
        self._odom = cdr.message("nav_msgs/msg/Odometry", header=cdr.header(0, ODOMETRY_FRAME), child_frame_id=base)

    def send(self, stamp: int, state: Readings) -> None:
        """Send all messages of one time step.

        Args:
            stamp: timestamp, ns.
            state: readings of a single env.
        """
        position, (w, x, y, z) = state.base_position[0], state.orientation[0].tolist()
        rate, velocity = state.angular_velocity_b[0], state.linear_velocity_b[0]

        write_stamp(self._time.clock, stamp)
        self._clock.send(self._time)

        imu = self._attitude
        write_stamp(imu.header.stamp, stamp)
        imu.orientation.w, imu.orientation.x, imu.orientation.y, imu.orientation.z = w, x, y, z
        _write_vector(imu.angular_velocity, rate)
        _write_vector(imu.linear_acceleration, state.linear_acceleration_b[0])
        self._imu.send(imu)

        # After the IMU message, since a controller uses both; before the others, since the controller waits for it.
        joints = self._driver.to_driver(state.joint_position[0], state.joint_velocity[0], state.joint_torque[0])
        self._joints.send_bytes(joint_state(stamp, self._driver.joint_names, *joints))

        odom = self._odom
        write_stamp(odom.header.stamp, stamp)
        _write_vector(odom.pose.pose.position, position)
        turn = odom.pose.pose.orientation
        turn.w, turn.x, turn.y, turn.z = w, x, y, z
        _write_vector(odom.twist.twist.linear, velocity)
        _write_vector(odom.twist.twist.angular, rate)
        self._odometry.send(odom)

        pose = Transform(ODOMETRY_FRAME, self._robot.base_name, position, state.orientation[0])
        self._tf.send_bytes(next(transform_messages([stamp], [pose])))


def _write_vector(vector: Any, values: NDArray[np.float64]) -> None:
    """Write numbers (3,) into a message's vector or point."""
    vector.x, vector.y, vector.z = values.tolist()
