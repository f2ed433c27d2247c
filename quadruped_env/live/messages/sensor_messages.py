"""The robot's sensor topics, published from a simulation's readings."""

from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.middleware.node import Node
from quadruped_env.live.middleware.topics import CLOCK, IMU, JOINT_STATES, ODOMETRY, TF
from quadruped_env.robot.readings import Readings
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.skeleton import ODOMETRY_FRAME, Transform
from quadruped_env.ros import cdr
from quadruped_env.ros.robot_messages import joint_state, transform_messages
from quadruped_env.utils.arrays import Floats


class Sensors:
    """The robot's publishers: joint states, IMU, odometry, the base's transform and the clock.

    Args:
        robot: robot whose readings are sent.
        driver: conversion to the driver's joints; None: they are the robot's.
    """

    def __init__(self, node: Node, robot: Robot, driver: DriverJoints | None = None) -> None:
        topics = CLOCK, IMU, JOINT_STATES, ODOMETRY, TF
        self._clock, self._imu, self._joints, self._odometry, self._tf = map(node.publish, topics)
        self._base = robot.base_name
        self._driver = driver or DriverJoints(robot)

    def send(self, stamp: int, state: Readings) -> None:
        """Send all messages of one time step.

        Args:
            stamp: timestamp, ns.
            state: readings of a single env.
        """
        position, orientation = state.base_position[0], state.orientation[0]
        turn, rate = _fields("wxyz", orientation), _fields("xyz", state.angular_velocity_b[0])
        at_base, in_world = cdr.header(stamp, self._base), cdr.header(stamp, ODOMETRY_FRAME)
        self._clock.send(cdr.message(CLOCK.type_name, clock=at_base.stamp))
        force = _fields("xyz", state.linear_acceleration_b[0])
        self._imu.send(
            cdr.message(
                IMU.type_name, header=at_base, orientation=turn, angular_velocity=rate, linear_acceleration=force
            )
        )
        # After the IMU message, since a controller uses both; before the others, since the controller waits for it.
        joints = self._driver.to_driver(state.joint_position[0], state.joint_velocity[0], state.joint_torque[0])
        self._joints.send_bytes(joint_state(stamp, self._driver.joint_names, *joints))
        pose = {"position": _fields("xyz", position), "orientation": turn}
        twist = {"linear": _fields("xyz", state.linear_velocity_b[0]), "angular": rate}
        self._odometry.send(
            cdr.message(
                ODOMETRY.type_name,
                header=in_world,
                child_frame_id=self._base,
                pose={"pose": pose},
                twist={"twist": twist},
            )
        )
        base = Transform(ODOMETRY_FRAME, self._base, position, orientation)
        self._tf.send_bytes(next(transform_messages([stamp], [base])))


def _fields(names: str, values: Floats) -> dict[str, float]:
    """Name the numbers of a vector, a point or a quaternion."""
    return dict(zip(names, values.tolist(), strict=True))
