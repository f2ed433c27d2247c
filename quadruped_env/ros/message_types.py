"""The ROS 2 message types that this package uses, as data.

They are the same in every distribution from Humble to Lyrical. A type hash is the digest of a type's definition
(REP 2016): from Iron on, peers and bags compare it.
"""

import re
from dataclasses import dataclass
from typing import Final

from quadruped_env.errors import QuadrupedError

_TYPE: Final = re.compile(r"(?P<base>[\w/]+?)(?P<many>\[(?P<count>\d*)\])?( (?P<default>\S+))?$")


@dataclass(frozen=True)
class Field:
    """One field of a message."""

    name: str
    base: str
    """A primitive such as `float64` or `string`, or the name of another message type"""
    many: bool
    """True for an array."""
    count: int | None
    """Length of an array of fixed length, else None."""
    default: float = 0.0
    """Value of a number that is not set."""

    @property
    def is_message(self) -> bool:
        """True if the field holds another message."""
        return "/" in self.base


@dataclass(frozen=True)
class MessageType:
    """One message type."""

    name: str
    """`package/msg/Type`"""
    fields: tuple[Field, ...]
    type_hash: str
    """RIHS01 hash, in the notation of DDS user data and bags."""

    @property
    def dds_name(self) -> str:
        """Name of the type on DDS."""
        package, kind, name = self.name.split("/")
        return f"{package}::{kind}::dds_::{name}_"


def _type(type_name: str, digest: str, **fields: str) -> MessageType:
    parsed = []
    for name, text in fields.items():
        match = _TYPE.match(text)
        assert match is not None
        count = match["count"]
        many = match["many"] is not None
        parsed.append(Field(name, match["base"], many, int(count) if count else None, float(match["default"] or 0.0)))
    return MessageType(type_name, tuple(parsed), f"RIHS01_{digest}")


_TYPES: Final = (
    _type(
        "builtin_interfaces/msg/Time",
        "b106235e25a4c5ed35098aa0a61a3ee9c9b18d197f398b0e4206cea9acf9c197",
        sec="int32",
        nanosec="uint32",
    ),
    _type(
        "std_msgs/msg/Header",
        "f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01",
        stamp="builtin_interfaces/msg/Time",
        frame_id="string",
    ),
    _type(
        "std_msgs/msg/String",
        "df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18",
        data="string",
    ),
    _type(
        "std_msgs/msg/MultiArrayDimension",
        "5e773a60a4c7fc8a54985f307c7837aa2994252a126c301957a24e31282c9cbe",
        label="string",
        size="uint32",
        stride="uint32",
    ),
    _type(
        "std_msgs/msg/MultiArrayLayout",
        "4c66e6f78e740ac103a94cf63259f968e48c617e7699e829b63c21a5cb50dac6",
        dim="std_msgs/msg/MultiArrayDimension[]",
        data_offset="uint32",
    ),
    _type(
        "std_msgs/msg/Float64MultiArray",
        "1025ddc6b9552d191f89ef1a8d2f60f3d373e28b283d8891ddcc974e8c55397f",
        layout="std_msgs/msg/MultiArrayLayout",
        data="float64[]",
    ),
    _type(
        "geometry_msgs/msg/Vector3",
        "cc12fe83e4c02719f1ce8070bfd14aecd40f75a96696a67a2a1f37f7dbb0765d",
        x="float64",
        y="float64",
        z="float64",
    ),
    _type(
        "geometry_msgs/msg/Point",
        "6963084842a9b04494d6b2941d11444708d892da2f4b09843b9c43f42a7f6881",
        x="float64",
        y="float64",
        z="float64",
    ),
    _type(
        "geometry_msgs/msg/Quaternion",
        "8a765f66778c8ff7c8ab94afcc590a2ed5325a1d9a076ffff38fbce36f458684",
        x="float64",
        y="float64",
        z="float64",
        w="float64 1",
    ),
    _type(
        "geometry_msgs/msg/Pose",
        "d501954e9476cea2996984e812054b68026ae0bfae789d9a10b23daf35cc90fa",
        position="geometry_msgs/msg/Point",
        orientation="geometry_msgs/msg/Quaternion",
    ),
    _type(
        "geometry_msgs/msg/PoseWithCovariance",
        "9a7c0fd234b7f45c6098745ecccd773ca1085670e64107135397aee31c02e1bb",
        pose="geometry_msgs/msg/Pose",
        covariance="float64[36]",
    ),
    _type(
        "geometry_msgs/msg/Transform",
        "beb83fbe698636351461f6f35d1abb20010c43d55374d81bd041f1ba2581fddc",
        translation="geometry_msgs/msg/Vector3",
        rotation="geometry_msgs/msg/Quaternion",
    ),
    _type(
        "geometry_msgs/msg/TransformStamped",
        "0a241f87d04668d94099cbb5ba11691d5ad32c2f29682e4eb5653424bd275206",
        header="std_msgs/msg/Header",
        child_frame_id="string",
        transform="geometry_msgs/msg/Transform",
    ),
    _type(
        "geometry_msgs/msg/Twist",
        "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a",
        linear="geometry_msgs/msg/Vector3",
        angular="geometry_msgs/msg/Vector3",
    ),
    _type(
        "geometry_msgs/msg/TwistWithCovariance",
        "49f574f033f095d8b6cd1beaca5ca7925e296e84af1716d16c89d38b059c8c18",
        twist="geometry_msgs/msg/Twist",
        covariance="float64[36]",
    ),
    _type(
        "geometry_msgs/msg/TwistStamped",
        "5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64",
        header="std_msgs/msg/Header",
        twist="geometry_msgs/msg/Twist",
    ),
    _type(
        "tf2_msgs/msg/TFMessage",
        "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087",
        transforms="geometry_msgs/msg/TransformStamped[]",
    ),
    _type(
        "sensor_msgs/msg/JointState",
        "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e",
        header="std_msgs/msg/Header",
        name="string[]",
        position="float64[]",
        velocity="float64[]",
        effort="float64[]",
    ),
    _type(
        "sensor_msgs/msg/Imu",
        "7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b",
        header="std_msgs/msg/Header",
        orientation="geometry_msgs/msg/Quaternion",
        orientation_covariance="float64[9]",
        angular_velocity="geometry_msgs/msg/Vector3",
        angular_velocity_covariance="float64[9]",
        linear_acceleration="geometry_msgs/msg/Vector3",
        linear_acceleration_covariance="float64[9]",
    ),
    _type(
        "nav_msgs/msg/Odometry",
        "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0",
        header="std_msgs/msg/Header",
        child_frame_id="string",
        pose="geometry_msgs/msg/PoseWithCovariance",
        twist="geometry_msgs/msg/TwistWithCovariance",
    ),
    _type(
        "rosgraph_msgs/msg/Clock",
        "692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564",
        clock="builtin_interfaces/msg/Time",
    ),
)

MESSAGE_TYPES: Final = {one.name: one for one in _TYPES}
"""Name -> type; one that another holds comes before it"""


def message_type(name: str) -> MessageType:
    """The type of a name.

    Raises:
        QuadrupedError: if it is not one of `MESSAGE_TYPES`.
    """
    try:
        return MESSAGE_TYPES[name]
    except KeyError:
        raise QuadrupedError(f"unknown message type {name!r}; known are {', '.join(MESSAGE_TYPES)}") from None
