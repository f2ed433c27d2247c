"""ROS 2's message types, their serialization, and QoS, without a ROS installation.

The tables here need nothing. `cdr` needs the libraries of the `ros` extra, which it imports when it is first used.
"""

from quadruped_env.ros.message_types import MESSAGE_TYPES, Field, MessageType, message_type
from quadruped_env.ros.qos import ANY_PUBLISHER_QOS, JOINT_STATES_QOS, LATCHED_QOS, SENSOR_DATA_QOS, TF_QOS, Qos

__all__ = [
    "ANY_PUBLISHER_QOS",
    "JOINT_STATES_QOS",
    "LATCHED_QOS",
    "MESSAGE_TYPES",
    "SENSOR_DATA_QOS",
    "TF_QOS",
    "Field",
    "MessageType",
    "Qos",
    "message_type",
]
