"""Qualities of service: what a publisher offers, as data for bags and for live topics."""

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True)
class Qos:
    """One profile: keep the last `depth` messages."""

    depth: int
    reliable: bool = True
    """False is best effort"""
    transient_local: bool = False
    """True hands the last messages to readers that join late: ROS 1 called it latched. False is volatile"""


JOINT_STATES_QOS: Final = Qos(depth=10)
"""What joint_state_publisher and joint_state_broadcaster offer"""
TF_QOS: Final = Qos(depth=100)
"""`tf2_ros::DynamicBroadcasterQoS`"""
LATCHED_QOS: Final = Qos(depth=1, transient_local=True)
"""`/robot_description` and `/tf_static`"""
SENSOR_DATA_QOS: Final = Qos(depth=5, reliable=False)
"""`rclcpp::SensorDataQoS`, with which robot_state_publisher reads `/joint_states`: it hears reliable publishers and
others"""
