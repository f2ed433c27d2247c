"""The topics of this robot: name, message type, quality of service."""

from dataclasses import dataclass
from typing import Final

from quadruped_env.ros import (
    ANY_PUBLISHER_QOS,
    JOINT_STATES_QOS,
    LATCHED_QOS,
    TF_QOS,
    MessageType,
    Qos,
    message_type,
)


@dataclass(frozen=True)
class Topic:
    """A ROS 2 topic."""

    name: str
    type_name: str
    qos: Qos
    """Quality of service that publishers offer, and that subscriptions request unless `requests` says otherwise."""
    is_global: bool = False
    """True if a node's namespace does not apply to the name."""
    requests: tuple[Qos, ...] = ()
    """Quality of service of a subscription's readers, where it has several; empty: one, with `qos`."""

    @property
    def dds_name(self) -> str:
        """The topic's name on DDS; a name without a slash is DDS's own."""
        return f"rt{self.name}" if self.name.startswith("/") else self.name

    @property
    def type(self) -> MessageType:
        """Its message type."""
        return message_type(self.type_name)


def ros_name(dds_name: str) -> str:
    """Return the ROS 2 name of a DDS topic; empty if it is not a ROS 2 topic."""
    return dds_name.removeprefix("rt") if dds_name.startswith("rt/") else ""


_DEFAULT: Final = Qos(depth=10)
"""Default of rclcpp and `ros2 topic pub`."""
_LATEST: Final = Qos(depth=1)

DISCOVERY_INFO: Final = Topic("ros_discovery_info", "rmw_dds_common/msg/ParticipantEntitiesInfo", LATCHED_QOS, True)
"""Nodes of each process and their publishers and subscriptions, from which ROS 2 makes its graph."""
JOINT_STATES: Final = Topic("/joint_states", "sensor_msgs/msg/JointState", JOINT_STATES_QOS)
IMU: Final = Topic("/imu/data", "sensor_msgs/msg/Imu", _DEFAULT)
ODOMETRY: Final = Topic("/odom", "nav_msgs/msg/Odometry", _DEFAULT)
TF: Final = Topic("/tf", "tf2_msgs/msg/TFMessage", TF_QOS, is_global=True)
TF_STATIC: Final = Topic("/tf_static", "tf2_msgs/msg/TFMessage", LATCHED_QOS, is_global=True)
CLOCK: Final = Topic("/clock", "rosgraph_msgs/msg/Clock", Qos(depth=1, reliable=False), is_global=True)
DIAGNOSTICS: Final = Topic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", _DEFAULT, is_global=True)
ROBOT_DESCRIPTION: Final = Topic("/robot_description", "std_msgs/msg/String", LATCHED_QOS)
CMD_VEL: Final = Topic("/cmd_vel", "geometry_msgs/msg/Twist", _DEFAULT)
CMD_VEL_STAMPED: Final = Topic("/cmd_vel", "geometry_msgs/msg/TwistStamped", _DEFAULT)
"""The default of Nav2 since Kilted; see `messages.velocity_messages`."""
JOINT_COMMANDS: Final = Topic("/joint_commands", "sensor_msgs/msg/JointState", _LATEST)
"""Joint targets: names with positions in rad. Names with efforts of zero and no positions let the robot go limp."""
JOINT_POSITIONS: Final = Topic("/forward_position_controller/commands", "std_msgs/msg/Float64MultiArray", _LATEST)
"""Joint targets for the `forward_position_controller` of ros2_control: rad, in the order of `JOINT_NAMES`."""
PUSH: Final = Topic("/push", "geometry_msgs/msg/Vector3", _DEFAULT, requests=ANY_PUBLISHER_QOS)
"""To `sim`: velocity in the world frame, m/s, that is added to the base's."""
RESET: Final = Topic("/reset", "std_msgs/msg/Empty", _DEFAULT, requests=ANY_PUBLISHER_QOS)
"""To `sim` and `controller`: start again."""
ESTOP: Final = Topic("/estop", "std_msgs/msg/Bool", LATCHED_QOS, requests=ANY_PUBLISHER_QOS)
"""Emergency stop, to all nodes that move the robot, see `emergency_stop`. Latched, for those that start later."""
GAIT: Final = Topic("/gait", "std_msgs/msg/Float64MultiArray", _LATEST, requests=ANY_PUBLISHER_QOS)
"""To `gait`: amplitude as a multiple of the preset's, frequency in Hz, phases of LF, RF, LH and RH in cycles."""
GAIT_SETTINGS: Final = Topic("/gait/settings", "std_msgs/msg/Float64MultiArray", LATCHED_QOS)
"""From `gait`: the current settings, in the same format."""

TOPICS: Final = {
    topic.name: topic
    for topic in list(globals().values())
    if isinstance(topic, Topic) and topic not in (DISCOVERY_INFO, CMD_VEL_STAMPED)
}
"""Topics of this robot by name, `/cmd_vel` as Twist."""
