"""The ROS 2 message types that this package uses, as `rosbags` defines them.

They are the same in every distribution from Humble to Lyrical, but for `Gid`, which is longer in Humble. A type hash is
the digest of a type's definition (REP 2016): from Iron on, peers and bags compare it.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError

MESSAGE_TYPES: Final = (
    "sensor_msgs/msg/JointState",
    "sensor_msgs/msg/Imu",
    "builtin_interfaces/msg/Time",
    "std_msgs/msg/Header",
    "std_msgs/msg/String",
    "std_msgs/msg/Bool",
    "std_msgs/msg/Empty",
    "std_msgs/msg/MultiArrayDimension",
    "std_msgs/msg/MultiArrayLayout",
    "std_msgs/msg/Float64MultiArray",
    "geometry_msgs/msg/Vector3",
    "geometry_msgs/msg/Point",
    "geometry_msgs/msg/Quaternion",
    "geometry_msgs/msg/Pose",
    "geometry_msgs/msg/PoseWithCovariance",
    "geometry_msgs/msg/Transform",
    "geometry_msgs/msg/TransformStamped",
    "geometry_msgs/msg/Twist",
    "geometry_msgs/msg/TwistWithCovariance",
    "geometry_msgs/msg/TwistStamped",
    "tf2_msgs/msg/TFMessage",
    "nav_msgs/msg/Odometry",
    "rosgraph_msgs/msg/Clock",
    "diagnostic_msgs/msg/KeyValue",
    "diagnostic_msgs/msg/DiagnosticStatus",
    "diagnostic_msgs/msg/DiagnosticArray",
    "rmw_dds_common/msg/Gid",
    "rmw_dds_common/msg/NodeEntitiesInfo",
    "rmw_dds_common/msg/ParticipantEntitiesInfo",
)
"""Names, `package/msg/Type`."""
_GID: Final = "rmw_dds_common/msg/Gid"


_CONTROL_TYPES: Final = {
    "control_msgs/msg/InterfaceValue": "string[] interface_names\nfloat64[] values\n",
    "control_msgs/msg/DynamicJointState": (
        "std_msgs/Header header\nstring[] joint_names\ncontrol_msgs/InterfaceValue[] interface_values\n"
    ),
}
"""Types of recordings that `rosbags` lacks; bags of sqlite3 do not define theirs."""


@dataclass(frozen=True)
class Field:
    """One field of a message."""

    name: str
    base: str
    """A primitive such as `float64` or `string`, or the name of another message type."""
    is_message: bool
    """True if the field holds another message, or several."""
    many: bool
    """True for an array."""
    count: int | None
    """Length of an array of fixed length, else None."""


@dataclass(frozen=True)
class MessageType:
    """One message type."""

    name: str
    """`package/msg/Type`."""
    fields: tuple[Field, ...]
    type_hash: str
    """RIHS01 hash, in the notation of DDS user data and bags."""

    @property
    def dds_name(self) -> str:
        """Name of the type on DDS."""
        package, kind, name = self.name.split("/")
        return f"{package}::{kind}::dds_::{name}_"


@cache
def typestore() -> Any:
    """Return ROS 2 Humble's message types, as `rosbags` knows them, with the keys of DDS entities from Iron on.

    Raises:
        MissingExtraError: if rosbags is not installed.
    """
    try:
        from rosbags.typesys import Stores, get_types_from_msg, get_typestore
    except ImportError as error:
        raise MissingExtraError("reading and writing ROS messages", "ros") from error
    store = get_typestore(Stores.ROS2_HUMBLE)
    # rosbags has the type of Humble, and registers no second one of that name.
    del store.fielddefs[_GID], store.types[_GID]
    store.register(get_types_from_msg("uint8[16] data", _GID))
    for name, definition in _CONTROL_TYPES.items():
        store.register(get_types_from_msg(definition, name))
    return store


@cache
def message_type(name: str) -> MessageType:
    """Return the type of a name.

    Raises:
        QuadrupedError: if it is not one of `MESSAGE_TYPES`.
        MissingExtraError: if rosbags is not installed.
    """
    if name not in MESSAGE_TYPES:
        raise QuadrupedError(f"unknown message type {name!r}; known are {', '.join(MESSAGE_TYPES)}")
    store = typestore()
    _, definitions = store.fielddefs[name]
    return MessageType(name, tuple(_field(*one) for one in definitions), store.hash_rihs01(name))


def _field(name: str, definition: Any) -> Field:
    kind, content = definition
    many, count = kind.name in ("ARRAY", "SEQUENCE"), None
    if many:
        (element, content), length = content
        count = length if kind.name == "ARRAY" else None
        kind = element
    is_message = kind.name == "NAME"
    return Field(name, content if is_message else content[0], is_message, many, count)
