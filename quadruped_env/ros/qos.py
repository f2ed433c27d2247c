"""QoS profiles of publishers, as data for bags and live topics."""

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True)
class Qos:
    """One profile: keep the last `depth` messages."""

    depth: int
    """Number of messages that are kept; 0: all."""
    reliable: bool = True
    """False: best effort."""
    transient_local: bool = False
    """True: subscriptions that join late receive the last messages (latched in ROS 1). False: volatile."""


JOINT_STATES_QOS: Final = Qos(depth=10)
"""QoS of joint_state_publisher and joint_state_broadcaster."""
TF_QOS: Final = Qos(depth=100)
"""`tf2_ros::DynamicBroadcasterQoS`"""
LATCHED_QOS: Final = Qos(depth=1, transient_local=True)
"""`/robot_description` and `/tf_static`"""
SENSOR_DATA_QOS: Final = Qos(depth=5, reliable=False)
"""`rclcpp::SensorDataQoS`, with which robot_state_publisher subscribes to `/joint_states`: it matches reliable and
best-effort publishers."""
ANY_PUBLISHER_QOS: Final = (Qos(depth=10, transient_local=True), Qos(depth=10), Qos(depth=10, reliable=False))
"""Requests of a subscription with three readers: it receives from every publisher, what that publisher has latched from
before it started, and again what was lost, as far as the publisher offers that."""
