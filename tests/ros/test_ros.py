"""ROS messages as data and as bytes, compared with rosbags' own and with an installed ROS 2."""

import json
import struct

import numpy as np
import pytest
import ros2_peers

from quadruped_env import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import MESSAGE_TYPES, cdr, message_type
from quadruped_env.ros.robot_messages import joint_state, read_joint_state, read_recorded, transform_messages

typesys = pytest.importorskip("rosbags.typesys")

JOINT_STATE = "sensor_msgs/msg/JointState"


@pytest.fixture(scope="module", params=["ROS2_HUMBLE", "ROS2_IRON", "ROS2_JAZZY", "ROS2_KILTED", "ROS2_LYRICAL"])
def distribution(request):
    return typesys.get_typestore(typesys.Stores[request.param])


TEXT = "LF_hip_joint/ é漢0 9"


def random_text(rng):
    start, end = rng.integers(0, len(TEXT), 2)
    return TEXT[start:end]


def random_joint_state(rng):
    """Fields as a publisher might send them: any lengths, any numbers."""
    count = int(rng.integers(0, 15))
    numbers = [
        rng.normal(size=count) * 10.0 ** rng.integers(-300, 300) if rng.random() < 0.7 else np.empty(0)
        for _ in range(3)
    ]
    if count and rng.random() < 0.3:
        numbers[2] = np.full(count, np.nan)
    return {
        "stamp": int(rng.integers(0, 2**31)) * 10**9 + int(rng.integers(0, 10**9)),
        "frame_id": random_text(rng),
        "names": [random_text(rng) for _ in range(count)],
        "numbers": numbers,
    }


def as_message(state):
    position, velocity, effort = state["numbers"]
    return cdr.message(
        JOINT_STATE,
        header=cdr.header(state["stamp"], state["frame_id"]),
        name=state["names"],
        position=position,
        velocity=velocity,
        effort=effort,
    )


def assert_read(raw, state):
    assert (raw.stamp, list(raw.names)) == (state["stamp"], state["names"])
    for values, expected in zip(raw[2:], state["numbers"], strict=True):
        assert values.tobytes() == expected.tobytes()


class TestMessageTypes:
    def test_definitions_and_hashes_are_those_of_the_distributions(self, distribution):
        for kind in map(message_type, MESSAGE_TYPES):
            # Of these, rosbags has the definition of Humble; the test below compares them.
            if kind.name.partition("/")[0] != "rmw_dds_common":
                assert distribution.hash_rihs01(kind.name) == kind.type_hash

    @pytest.mark.parametrize("name", ros2_peers.DISTRIBUTIONS)
    def test_definitions_and_hashes_are_those_that_ros_2_installs(self, name):
        ros2 = ros2_peers.Ros2(name)
        checked = set()
        for kind in map(message_type, MESSAGE_TYPES):
            package, _, short = kind.name.split("/")
            if ros2.share(package) is not None:
                installed = json.loads((ros2.share(package) / "msg" / f"{short}.json").read_text())
                hashes = {one["type_name"]: one["hash_string"] for one in installed["type_hashes"]}
                fields = installed["type_description_msg"]["type_description"]["fields"]
                assert hashes[kind.name] == kind.type_hash
                assert [one["name"] for one in fields] == [one.name for one in kind.fields]
                checked.add(package)
        # These have no wheels, and tf2_msgs may not have been built.
        packages = {kind.name.partition("/")[0] for kind in map(message_type, MESSAGE_TYPES)}
        assert checked >= packages - {"tf2_msgs", "diagnostic_msgs"}

    def test_hash_of_the_joint_state_is_the_documented_one(self):
        kind = message_type(JOINT_STATE)
        assert kind.type_hash == "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"
        assert kind.dds_name == "sensor_msgs::msg::dds_::JointState_"

    def test_unknown_types_and_fields_are_named(self):
        with pytest.raises(QuadrupedError, match=r"unknown message type 'a/msg/B'; known are .*JointState"):
            message_type("a/msg/B")
        with pytest.raises(QuadrupedError, match=r"JointState: unknown field 'positions'; its fields are header, name"):
            cdr.message(JOINT_STATE, positions=[])
        with pytest.raises(QuadrupedError, match=r"Imu: orientation_covariance holds 9 values; found 2"):
            cdr.message("sensor_msgs/msg/Imu", orientation_covariance=[0, 1])


class TestCdr:
    def test_an_empty_message_comes_back(self):
        for name in MESSAGE_TYPES:
            data = cdr.serialize(cdr.message(name))
            assert data[:4] == b"\x00\x01\x00\x00"
            assert cdr.serialize(cdr.deserialize(data, name)) == data

    def test_bytes_are_the_documented_ones(self):
        twist = cdr.message("geometry_msgs/msg/Twist", linear={"x": 0.5}, angular={"z": -1})
        assert cdr.serialize(twist) == b"\x00\x01\x00\x00" + struct.pack("<6d", 0.5, 0, 0, 0, 0, -1)
        text = cdr.message("std_msgs/msg/String", data="hé")
        assert cdr.serialize(text) == b"\x00\x01\x00\x00\x04\x00\x00\x00h\xc3\xa9\x00"
        assert cdr.serialize(cdr.header(5_000_000_007).stamp) == b"\x00\x01\x00\x00" + struct.pack("<iI", 5, 7)
        assert cdr.message("geometry_msgs/msg/Quaternion").w == 1.0

    def test_whole_numbers_are_written_as_numbers(self):
        message = cdr.message(JOINT_STATE, name=["a", "b"], position=np.array([1, -2]))
        assert cdr.deserialize(cdr.serialize(message), JOINT_STATE).position.tolist() == [1.0, -2.0]

    @pytest.mark.parametrize("data", [b"", b"\x00\x01\x00\x00", b"\x00\x03\x00\x00" + bytes(64), bytes(7)])
    def test_damage_is_an_error_of_this_package(self, data):
        with pytest.raises(QuadrupedError, match=r"bytes do not hold a sensor_msgs/msg/JointState"):
            cdr.deserialize(data, JOINT_STATE)


class TestJointState:
    def test_a_thousand_random_messages_come_back(self):
        rng = np.random.default_rng(0)
        for _ in range(1000):
            state = random_joint_state(rng)
            assert_read(read_joint_state(cdr.serialize(as_message(state))), state)
            state["frame_id"] = ""
            assert joint_state(state["stamp"], state["names"], *state["numbers"]) == cdr.serialize(as_message(state))

    @pytest.mark.parametrize("rest", [bytes(3), bytes(8), b"astrtps_", 1000 * b"x"])
    def test_bytes_behind_a_message_are_ignored(self, rest):
        """As ROS does: rclpy's `serialize_message` adds 8, with any content, where velocities and efforts are empty."""
        state = random_joint_state(np.random.default_rng(3))
        data = cdr.serialize(as_message(state)) + rest
        assert_read(read_joint_state(data), state)
        assert_read(read_recorded(data, JOINT_STATE, 0)[0], state)

    def test_timestamp_out_of_range_is_refused(self):
        with pytest.raises(QuadrupedError, match=r"stamp 2147483648000000000 ns: a ROS message holds"):
            joint_state(2**31 * 10**9, ["a"], [0.0])

    def test_damaged_bytes_are_refused_or_read(self):
        rng = np.random.default_rng(4)
        good = cdr.serialize(as_message(random_joint_state(np.random.default_rng(3))))
        refused = 0
        for _ in range(2000):
            data = bytearray(good[: rng.integers(0, len(good) + 1)] if rng.random() < 0.5 else good)
            for at in rng.integers(0, max(len(data), 1), rng.integers(0, 4)):
                data[at : at + 1] = bytes([rng.integers(0, 256)])
            try:
                read_joint_state(bytes(data))
            except QuadrupedError as error:
                assert f"{len(data)} bytes do not hold a {JOINT_STATE}" in str(error)  # noqa: PT017
                refused += 1
        assert refused > 500


class TestTransforms:
    STAMP = 1_763_500_000_000_000_001

    def message(self, transforms, row):
        """The message of one row of transforms, field by field."""
        return cdr.message(
            "tf2_msgs/msg/TFMessage",
            transforms=[
                {
                    "header": cdr.header(self.STAMP, one.parent),
                    "child_frame_id": one.child,
                    "transform": {
                        "translation": dict(zip("xyz", np.atleast_2d(one.translation)[row], strict=True)),
                        "rotation": dict(zip("wxyz", np.atleast_2d(one.rotation)[row], strict=True)),
                    },
                }
                for one in transforms
            ],
        )

    @pytest.mark.parametrize("with_base", [False, True])
    def test_bytes_are_those_of_rosbags(self, with_base):
        rng = np.random.default_rng(0)
        poses = rng.normal(size=(5, 7)) if with_base else None
        transforms = MINI_QUADRUPED.skeleton.joint_transforms(rng.normal(size=(5, 8)), poses)
        for row, data in enumerate(transform_messages([self.STAMP] * 5, transforms)):
            assert data == cdr.serialize(self.message(transforms, row))

    def test_constant_transforms_and_none(self):
        fixed = MINI_QUADRUPED.skeleton.fixed_transforms()
        for transforms in (fixed, ()):
            assert list(transform_messages([self.STAMP], transforms)) == [cdr.serialize(self.message(transforms, 0))]
