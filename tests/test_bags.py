"""Bags, read back by independent readers, and bags that others wrote."""

import itertools
import re
import sqlite3
import struct
import sys
import zlib

import numpy as np
import pytest
from trajectories import STAMPS, assert_same, random_trajectory

from quadruped_env import (
    JOINT_NAMES,
    JointTrajectory,
    MissingExtraError,
    QuadrupedError,
    asset_path,
    forward_kinematics,
)
from quadruped_env.robot import joint_transforms
from quadruped_env.ros import cdr
from quadruped_env.ros.tf import TfEncoder
from quadruped_env.trajectory import JointMap, JointRule, formats

pytest.importorskip("rosbags")
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

JOINT_STATE = "sensor_msgs/msg/JointState"
KINDS = ("mcap", "sqlite3", "bare.mcap", "bare.db3", "mcap zstd", "sqlite3 zstd")


def save(trajectory, directory, kind, **options):
    """A bag of one of the kinds, and its path."""
    name, _, compression = kind.partition(" ")
    path = directory / (name if "." in name else "bag")
    trajectory.save(path, storage=None if "." in name else name, compress=bool(compression), **options)
    return path


def write_bag(path, messages, storage="mcap", compression=None, topics=("/joint_states",)):
    """A bag of messages (ns of recording, fields), by rosbags alone."""
    writer = Writer(path, version=8, storage_plugin=StoragePlugin[storage.upper()])
    if compression:
        writer.set_compression(CompressionMode[compression.upper()], CompressionFormat.ZSTD)
    with writer:
        connections = [writer.add_connection(topic, JOINT_STATE, typestore=cdr.typestore()) for topic in topics]
        for (time, fields), connection in zip(messages, itertools.cycle(connections), strict=False):
            writer.write(connection, time, cdr.serialize(cdr.message(JOINT_STATE, **fields)))
    return path


def messages_of(trajectory):
    for state in trajectory:
        arrays = {"position": state.position, "velocity": state.velocity, "effort": state.effort}
        yield state.stamp, {"header": cdr.header(state.stamp), "name": state.names, **arrays}


def fields(stamp=0, names=("a", "b"), position=(0.1, 0.2), **others):
    return {"header": cdr.header(stamp), "name": names, "position": position, **others}


class TestRoundTrip:
    @pytest.mark.parametrize("kind", KINDS)
    def test_to_the_last_bit(self, tmp_path, kind):
        trajectory = random_trajectory(rows=5000)
        assert_same(JointTrajectory.load(save(trajectory, tmp_path / "new", kind)), trajectory)
        assert [entry.name for entry in (tmp_path / "new").iterdir()] in (["bag"], [kind])

    @pytest.mark.parametrize(
        "changes", [{"velocities": None}, {"efforts": None}, {"velocities": None, "efforts": None}]
    )
    def test_what_was_not_recorded_stays_so(self, tmp_path, changes):
        trajectory = random_trajectory(**changes)
        assert_same(JointTrajectory.load(save(trajectory, tmp_path, "mcap")), trajectory)

    def test_other_robots_have_joint_states_only(self, tmp_path):
        trajectory = random_trajectory(names=["wheel", *JOINT_NAMES[1:]])
        path = save(trajectory, tmp_path, "bare.mcap")
        assert_same(JointTrajectory.load(path), trajectory)
        assert set(read_independently(path)) == {"/joint_states"}

    def test_extra_joints_stay(self, tmp_path):
        trajectory = random_trajectory(names=["wheel", *JOINT_NAMES])
        path = save(trajectory, tmp_path, "bare.mcap")
        assert_same(JointTrajectory.load(path), trajectory)
        assert "/tf" in read_independently(path)


def read_independently(path):
    """Topic -> [(ns, message)], by a reader that shares no code with rosbags."""
    reader = pytest.importorskip("mcap_ros2.reader")
    found = {}
    for message in reader.read_ros2_messages(str(path)):
        found.setdefault(message.channel.topic, []).append((message.log_time_ns, message.ros_msg))
    return found


class TestReadByOthers:
    @pytest.mark.parametrize("compress", [False, True])
    def test_mcap_has_the_same_numbers(self, tmp_path, compress):
        trajectory = random_trajectory(rows=3000)
        trajectory.save(tmp_path / "a.mcap", compress=compress)
        topics = read_independently(tmp_path / "a.mcap")
        assert set(topics) == {"/joint_states", "/robot_description", "/tf", "/tf_static"}
        states = topics["/joint_states"]
        assert [time for time, _ in states] == trajectory.stamps.tolist()
        assert [m.header.stamp.sec * 10**9 + m.header.stamp.nanosec for _, m in states] == trajectory.stamps.tolist()
        assert all(tuple(message.name) == JOINT_NAMES for _, message in states)
        for name, values in (
            ("position", trajectory.positions),
            ("velocity", trajectory.velocities),
            ("effort", trajectory.efforts),
        ):
            np.testing.assert_array_equal(np.array([getattr(message, name) for _, message in states]), values)

    def test_every_chunk_has_its_checksum(self, tmp_path):
        reader = pytest.importorskip("mcap.stream_reader")
        random_trajectory(rows=6000).save(tmp_path / "a.mcap")
        with (tmp_path / "a.mcap").open("rb") as file:
            records = list(reader.StreamReader(file, emit_chunks=True, validate_crcs=True).records)
        chunks = [record for record in records if type(record).__name__ == "Chunk"]
        assert len(chunks) > 1
        assert all(chunk.uncompressed_crc == zlib.crc32(chunk.data) for chunk in chunks)

    def test_latched_topics_stand_at_the_beginning(self, tmp_path):
        trajectory = random_trajectory(rows=100)
        trajectory.save(tmp_path / "a.mcap")
        topics = read_independently(tmp_path / "a.mcap")
        ((time, description),) = topics["/robot_description"]
        assert (time, description.data) == (STAMPS[0], asset_path("mini_quadruped.urdf").read_text())
        ((time, static),) = topics["/tf_static"]
        assert (time, list(static.transforms)) == (STAMPS[0], [])

    @pytest.mark.parametrize(("rate", "period"), [(20.0, 50_000_000), (100.0, 10_000_000), (30.0, 33_333_333)])
    def test_transforms_are_the_robots_at_multiples_of_the_period(self, tmp_path, rate, period):
        trajectory = random_trajectory(rows=5000)
        trajectory.save(tmp_path / "a.mcap", tf_rate=rate)
        found = read_independently(tmp_path / "a.mcap")["/tf"]
        stamps = np.array([time for time, _ in found])
        first = -(-STAMPS[0] // period) * period
        np.testing.assert_array_equal(stamps, np.arange(first, trajectory.stamps[-1] + 1, period))
        positions = trajectory.positions_at((stamps - STAMPS[0]) / 1e9)
        for (stamp, message), row in list(zip(found, positions, strict=True))[:: len(found) // 20]:
            poses = {"base_link": np.eye(4)}
            for one in message.transforms:
                assert one.header.stamp.sec * 10**9 + one.header.stamp.nanosec == stamp
                poses[one.child_frame_id] = poses[one.header.frame_id] @ matrix_of(one.transform)
            for link, (position, quaternion) in forward_kinematics(row).items():
                expected = matrix(position, quaternion)
                np.testing.assert_allclose(poses[link], expected, rtol=0, atol=1e-9)

    def test_no_transforms_when_not_wanted(self, tmp_path):
        random_trajectory().save(tmp_path / "a.mcap", tf_rate=0.0)
        assert "/tf" not in read_independently(tmp_path / "a.mcap")

    def test_the_base_moves_in_its_odometry_frame(self, tmp_path):
        rows = 200
        yaw = np.linspace(0.0, 7.0, rows)
        base = np.zeros((rows, 7))
        base[:, 0], base[:, 3], base[:, 6] = np.arange(rows), np.cos(yaw / 2), np.sin(yaw / 2)
        base[::2, 3:] *= -1.0  # the same turns
        random_trajectory(rows=rows).save(tmp_path / "a.mcap", base_pose=base)
        for stamp, message in read_independently(tmp_path / "a.mcap")["/tf"]:
            one = message.transforms[0]
            assert (one.header.frame_id, one.child_frame_id) == ("odom", "base_link")
            row = (stamp - STAMPS[0]) / 20e6
            angle = row * 7.0 / (rows - 1)
            assert one.transform.translation.x == pytest.approx(row, abs=1e-6)
            assert (
                abs(one.transform.rotation.w * np.cos(angle / 2) + one.transform.rotation.z * np.sin(angle / 2))
                > 1 - 1e-6
            )

    def test_sqlite3_has_the_same_numbers(self, tmp_path):
        trajectory = random_trajectory(rows=300)
        trajectory.save(tmp_path / "a.db3")
        with sqlite3.connect(tmp_path / "a.db3") as database:
            rows = database.execute(
                "SELECT timestamp, data FROM messages JOIN topics ON topics.id = topic_id "
                "WHERE name = '/joint_states' ORDER BY timestamp"
            ).fetchall()
        store = get_typestore(Stores.ROS2_HUMBLE)
        messages = [store.deserialize_cdr(data, JOINT_STATE) for _, data in rows]
        assert [time for time, _ in rows] == trajectory.stamps.tolist()
        np.testing.assert_array_equal(np.array([message.position for message in messages]), trajectory.positions)
        np.testing.assert_array_equal(np.array([message.effort for message in messages]), trajectory.efforts)

    @pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
    def test_metadata_are_of_version_8_with_the_qualities_of_service(self, tmp_path, storage):
        yaml = pytest.importorskip("yaml")
        trajectory = random_trajectory(rows=300)
        trajectory.save(tmp_path / "bag", storage=storage)
        found = yaml.safe_load((tmp_path / "bag" / "metadata.yaml").read_text())["rosbag2_bagfile_information"]
        assert (found["version"], found["storage_identifier"]) == (8, storage)
        assert found["starting_time"]["nanoseconds_since_epoch"] == STAMPS[0]
        assert found["duration"]["nanoseconds"] == trajectory.stamps[-1] - STAMPS[0]
        (name,) = found["relative_file_paths"]
        assert (tmp_path / "bag" / name).is_file()
        profiles = {}
        for topic in found["topics_with_message_count"]:
            (profile,) = yaml.safe_load(topic["topic_metadata"]["offered_qos_profiles"])
            profiles[topic["topic_metadata"]["name"]] = profile
        latched = {name for name, profile in profiles.items() if profile["durability"] == 1}
        assert latched == {"/robot_description", "/tf_static"}
        assert all(profile["reliability"] == 1 for profile in profiles.values())
        assert {name: profile["depth"] for name, profile in profiles.items()} == {
            "/joint_states": 10,
            "/robot_description": 1,
            "/tf": 100,
            "/tf_static": 1,
        }

    def test_transform_bytes_are_those_of_rosbags(self):
        rng = np.random.default_rng(0)
        transforms = joint_transforms(rng.normal(size=8))
        numbers = rng.normal(size=(8, 7))
        message = cdr.message(
            "tf2_msgs/msg/TFMessage",
            transforms=[
                {
                    "header": cdr.header(STAMPS[0], one.parent),
                    "child_frame_id": one.child,
                    "transform": {
                        "translation": dict(zip("xyz", row[:3], strict=True)),
                        "rotation": dict(zip("xyzw", row[3:], strict=True)),
                    },
                }
                for one, row in zip(transforms, numbers, strict=True)
            ],
        )
        encode = TfEncoder([(one.parent, one.child) for one in transforms])
        assert encode(STAMPS[0], numbers) == cdr.serialize(message)


def matrix(position, quaternion):
    w, x, y, z = quaternion
    result = np.eye(4)
    result[:3, 3] = position
    result[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return result


def matrix_of(transform):
    t, r = transform.translation, transform.rotation
    return matrix([t.x, t.y, t.z], [r.w, r.x, r.y, r.z])


class TestBagsOfOthers:
    @pytest.mark.parametrize(
        ("storage", "compression"),
        [
            *itertools.product(["mcap", "sqlite3"], [None, "message", "file"]),
            ("mcap", "storage"),  # sqlite3 has no compression of its own
        ],
    )
    def test_rosbag2(self, tmp_path, storage, compression):
        trajectory = random_trajectory(rows=200)
        path = write_bag(tmp_path / "bag", messages_of(trajectory), storage, compression)
        assert_same(JointTrajectory.load(path), trajectory)
        (file,) = (entry for entry in path.iterdir() if entry.name != "metadata.yaml")
        assert_same(JointTrajectory.load(file), trajectory)
        assert_same(JointTrajectory.load(file.rename(tmp_path / "no_suffix")), trajectory)

    @pytest.mark.parametrize("compression", [None, "BZ2", "LZ4"])
    def test_ros_1(self, tmp_path, compression):
        trajectory = random_trajectory(rows=200)
        path = write_ros1(tmp_path / "a.bag", trajectory, compression)
        assert_same(JointTrajectory.load(path), trajectory)
        assert_same(JointTrajectory.load(path, salvage=True), trajectory)

    def test_a_bag_in_several_files(self, tmp_path):
        trajectory = random_trajectory(rows=300)
        parts = [trajectory.rows(np.s_[i : i + 25]) for i in range(0, 300, 25)]
        (tmp_path / "bag").mkdir()
        for i, part in enumerate(parts):
            part.save(tmp_path / "bag" / f"bag_{i}.mcap", tf_rate=0)
        with pytest.raises(
            QuadrupedError, match=r"bag: the bag is damaged.*metadata file .* does not exist.*--salvage"
        ):
            JointTrajectory.load(tmp_path / "bag")
        assert_same(JointTrajectory.load(tmp_path / "bag", salvage=True), trajectory)

    def test_topics_are_chosen_and_never_guessed(self, tmp_path):
        messages = [(i, fields(stamp=i)) for i in range(10)]
        path = write_bag(tmp_path / "two", messages, topics=["/left/joint_states", "/right/joint_states"])
        with pytest.raises(
            QuadrupedError, match=r"several topics .*\(--topic\): /left/joint_states, /right/joint_states"
        ):
            JointTrajectory.load(path)
        assert JointTrajectory.load(path, topic="/right/joint_states").stamps.tolist() == [1, 3, 5, 7, 9]
        with pytest.raises(
            QuadrupedError, match=r"no topic '/gone' of type .*; it has /left/joint_states \(sensor_msgs"
        ):
            JointTrajectory.load(path, topic="/gone")
        path = write_bag(tmp_path / "default", messages, topics=["/joint_states", "/other"])
        loaded = JointTrajectory.load(path)
        assert loaded.stamps.tolist() == [0, 2, 4, 6, 8]
        assert loaded.source.notes == ("read /joint_states; there are joint states on /other too (--topic)",)

    def test_a_bag_of_something_else_is_named(self, tmp_path):
        with Writer(tmp_path / "bag", version=8, storage_plugin=StoragePlugin.MCAP) as writer:
            connection = writer.add_connection("/chatter", "std_msgs/msg/String", typestore=cdr.typestore())
            writer.write(connection, 0, cdr.serialize(cdr.message("std_msgs/msg/String", data="x")))
        with pytest.raises(QuadrupedError, match=r"no topic of type .*; the types in it are: std_msgs/msg/String"):
            JointTrajectory.load(tmp_path / "bag")

    def test_stamps_may_be_those_of_the_recording(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(5, fields()), (8, fields())])
        with pytest.raises(QuadrupedError, match=r"message 1, stamp_ns: 0 does not come after 0"):
            JointTrajectory.load(path)
        assert JointTrajectory.load(path, stamps="log").stamps.tolist() == [5, 8]

    def test_names_in_another_order_are_put_in_order(self, tmp_path):
        path = write_bag(
            tmp_path / "bag",
            [
                (0, fields(0, ("a", "b"), (1, 2), velocity=(3, 4))),
                (1, fields(1, ("b", "a"), (5, 6), velocity=(7, 8))),
            ],
        )
        loaded = JointTrajectory.load(path)
        assert (loaded.names, loaded.positions.tolist()) == (("a", "b"), [[1, 2], [6, 5]])
        assert loaded.velocities.tolist() == [[3, 4], [8, 7]]


def write_ros1(path, trajectory, compression=None):
    store = get_typestore(Stores.ROS1_NOETIC)
    writer = Writer1(path)
    if compression:
        writer.set_compression(Writer1.CompressionFormat[compression])
    with writer:
        connection = writer.add_connection("/joint_states", JOINT_STATE, typestore=store)
        for number, state in enumerate(trajectory):
            time = store.types["builtin_interfaces/msg/Time"](*divmod(state.stamp, 10**9))
            header = store.types["std_msgs/msg/Header"](number, time, "")
            none = np.empty(0)
            message = store.types[JOINT_STATE](
                header,
                list(state.names),
                state.position,
                none if state.velocity is None else state.velocity,
                none if state.effort is None else state.effort,
            )
            writer.write(connection, state.stamp, store.serialize_ros1(message, JOINT_STATE))
    return path


class TestBadMessages:
    """Every case is refused by default, with a cure; those that `drop` mends keep the other rows."""

    @pytest.mark.parametrize(
        ("bad", "message", "drop"),
        [
            (
                fields(1, position=[0.1]),
                r"message 1: 2 names and 1 positions; mend it, or leave .* out \(--drop\)",
                True,
            ),
            (fields(1, velocity=[0.1]), r"message 1: 2 names and 1 velocities", True),
            (fields(1, effort=[0.1, 0.2, 0.3]), r"message 1: 2 names and 3 efforts", True),
            (
                fields(1, names=[]),
                r"message 1: 2 positions and no names: give the joints in their order \(--names\)",
                True,
            ),
            (fields(1, names=["a", "a"]), r"message 1: joint 'a' is named twice", True),
            (fields(1, names=["a", ""]), r"message 1: 2 positions and 2 names, of which 1 are empty", True),
            (fields(1, names=["a", "c"]), r"message 1: it lacks joint 'b', which the messages before it have", True),
            (fields(1, names=["a"], position=[1]), r"message 1: it lacks joint 'b'", True),
            (fields(1, velocity=[1, 2]), r"message 1: it has the velocity that the messages before it lack", True),
            (fields(1, position=[np.nan, 0]), r"message 1, position\.a: nan is not finite; leave the row out", True),
            (fields(1, position=[0, np.inf]), r"message 1, position\.b: inf is not finite", True),
            (fields(0), r"message 1, stamp_ns: 0 does not come after 0 .*\(--sort\).*\(--drop", True),
            (fields(1, position=[90.0, 0]), r"message 1, position\.a: 90 rad is more than two turns.*--degrees", False),
        ],
    )
    def test_is_named_and_dropped(self, tmp_path, bad, message, drop):
        good = [(i, fields(i)) for i in range(6)]
        path = write_bag(tmp_path / "bag", [good[0], (1, bad), *good[2:]])
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: {message}"):
            JointTrajectory.load(path)
        if drop:
            loaded = JointTrajectory.load(path, drop=True)
            assert loaded.stamps.tolist() == [0, 2, 3, 4, 5]
            (note,) = loaded.source.notes
            assert note.startswith("left out 1 of 6: ")

    def test_an_empty_bag(self, tmp_path):
        with pytest.raises(QuadrupedError, match=r"the topic has no message; record again"):
            JointTrajectory.load(write_bag(tmp_path / "bag", []))

    def test_no_row_left(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(0, fields(position=[np.nan, 0]))])
        with pytest.raises(QuadrupedError, match=r"no row is left; left out 1 of 1: a number is not finite"):
            JointTrajectory.load(path, drop=True)

    def test_names_given_for_messages_without(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(i, fields(i, names=[])) for i in range(3)])
        assert JointTrajectory.load(path, names=["x", "y"]).names == ("x", "y")
        with pytest.raises(QuadrupedError, match=r"message 0: 3 names and 2 positions"):
            JointTrajectory.load(path, names=["x", "y", "z"])

    def test_falling_stamps_are_sorted_or_dropped_on_request(self, tmp_path):
        path = write_bag(
            tmp_path / "bag", [(i, fields(stamp, position=(stamp, 0))) for i, stamp in enumerate([3, 1, 2, 5])]
        )
        with pytest.raises(QuadrupedError, match=r"message 1, stamp_ns: 1 does not come after 3"):
            JointTrajectory.load(path)
        by_stamp = JointTrajectory.load(path, sort=True)
        assert (by_stamp.stamps.tolist(), by_stamp.positions[:, 0].tolist()) == ([1, 2, 3, 5], [1, 2, 3, 5])
        assert JointTrajectory.load(path, drop=True).stamps.tolist() == [3, 5]

    def test_repeated_stamps_are_not_mended_by_sorting(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(i, fields(stamp)) for i, stamp in enumerate([3, 1, 3])])
        with pytest.raises(QuadrupedError, match=r"message 2, stamp_ns: 3 does not come after 3"):
            JointTrajectory.load(path, sort=True)
        assert JointTrajectory.load(path, sort=True, drop=True).stamps.tolist() == [1, 3]

    @pytest.mark.parametrize("row", [4095, 4096, 4097])
    def test_stamps_that_fall_between_blocks_are_seen(self, tmp_path, row):
        stamps = np.arange(5000) * 10
        stamps[row] = stamps[row - 1]
        path = write_bag(tmp_path / "bag", [(i, fields(int(stamp))) for i, stamp in enumerate(stamps)], "sqlite3")
        with pytest.raises(QuadrupedError, match=rf"message {row}, stamp_ns: {stamps[row]} does not come after"):
            JointTrajectory.load(path)
        assert len(JointTrajectory.load(path, drop=True)) == 4999

    def test_degrees_are_converted_on_request_only(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(0, fields(position=(90, -45), velocity=(180, 0), effort=(3, 4)))])
        converted = JointTrajectory.load(path, degrees=True)
        np.testing.assert_allclose(converted.positions, [[np.pi / 2, -np.pi / 4]])
        np.testing.assert_allclose(converted.velocities, [[np.pi, 0]])
        assert converted.efforts.tolist() == [[3, 4]]
        assert JointTrajectory.load(path, degrees=False).positions.tolist() == [[90, -45]]

    def test_unknown_velocities_are_none_and_unknown_efforts_stay(self, tmp_path):
        unknown = {"velocity": (np.nan, np.nan), "effort": (np.nan, np.nan)}
        loaded = JointTrajectory.load(write_bag(tmp_path / "bag", [(i, fields(i, **unknown)) for i in range(3)]))
        assert loaded.velocities is None
        assert np.isnan(loaded.efforts).all()
        loaded = JointTrajectory.load(tmp_path / "bag", ignore=["effort"])
        assert loaded.efforts is None

    def test_options_are_checked(self, tmp_path):
        with pytest.raises(QuadrupedError, match=r"stamps: expected one of header, log; found 'now'"):
            JointTrajectory.load(tmp_path, stamps="now")
        with pytest.raises(QuadrupedError, match=r"ignore: expected velocity or effort; found 'position'"):
            JointTrajectory.load(tmp_path, ignore=["position"])


class TestSalvage:
    @pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "sqlite3 zstd"])
    @pytest.mark.parametrize("share", [0.35, 0.9])
    def test_a_bag_that_was_cut_off_is_read_up_to_the_cut(self, tmp_path, kind, share):
        trajectory = random_trajectory(rows=5000)
        path = save(trajectory, tmp_path, kind)
        file = next(entry for entry in path.iterdir() if entry.suffix != ".yaml") if path.is_dir() else path
        data = file.read_bytes()
        file.write_bytes(data[: int(len(data) * share)])
        place = r"\([\w.]+: .*byte \d+.*\)"
        with pytest.raises(QuadrupedError, match=rf"the bag is damaged, cut off, .* {place}; keep .*\(--salvage\)"):
            JointTrajectory.load(path)
        loaded = JointTrajectory.load(path, salvage=True)
        # A page of sqlite3 or a block of zstd is lost as a whole.
        assert 5000 * (share - 0.15) < len(loaded) < 5000
        assert_same(loaded, trajectory.rows(np.s_[: len(loaded)]))
        assert loaded.source.notes

    @pytest.mark.parametrize("compression", [None, "BZ2", "LZ4"])
    def test_a_ros_1_bag_that_was_cut_off(self, tmp_path, compression):
        trajectory = random_trajectory(rows=12_000)
        path = write_ros1(tmp_path / "a.bag", trajectory, compression)
        data = path.read_bytes()
        path.write_bytes(data[: len(data) // 2])
        with pytest.raises(QuadrupedError, match=r"the bag is damaged, cut off"):
            JointTrajectory.load(path)
        loaded = JointTrajectory.load(path, salvage=True)
        assert 3000 < len(loaded) < 12_000
        assert_same(loaded, trajectory.rows(np.s_[: len(loaded)]))

    def test_a_damaged_chunk_is_left_out_by_its_checksum(self, tmp_path):
        trajectory = random_trajectory(rows=12_000)
        path = save(trajectory, tmp_path, "bare.mcap")
        data = bytearray(path.read_bytes())
        data[len(data) // 2] ^= 1
        path.write_bytes(data)
        with pytest.raises(QuadrupedError, match=r"message \d+: the bag is damaged.*[Cc]hecksum"):
            JointTrajectory.load(path)
        loaded = JointTrajectory.load(path, salvage=True)
        assert 4000 < len(loaded) < 12_000
        kept = np.isin(trajectory.stamps, loaded.stamps)
        np.testing.assert_array_equal(loaded.positions, trajectory.positions[kept])
        assert any("checksum" in note for note in loaded.source.notes)
        (gap,) = loaded.gaps()
        assert gap.seconds > 1.0

    @pytest.mark.parametrize("compress", [False, True])
    def test_what_stands_behind_a_damaged_record_is_found(self, tmp_path, compress):
        trajectory = random_trajectory(rows=20_000)
        trajectory.save(tmp_path / "a.mcap", compress=compress)
        data = bytearray((tmp_path / "a.mcap").read_bytes())
        chunks, at = [], 8
        while at < len(data) - 8:
            chunks += [at] if data[at] == 0x06 else []
            at += 9 + struct.unpack_from("<Q", data, at + 1)[0]
        assert len(chunks) > 2
        data[chunks[1] + 8] = 0xFF  # the greatest byte of its length
        (tmp_path / "a.mcap").write_bytes(data)
        loaded = JointTrajectory.load(tmp_path / "a.mcap", salvage=True)
        assert any(f"cut off or damaged from byte {chunks[1]} on" in note for note in loaded.source.notes)
        assert_same(loaded, trajectory)

    def test_damaged_messages_are_named_and_left_out(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(i, fields(i)) for i in range(20)], "sqlite3")
        (file,) = path.glob("*.db3")
        with sqlite3.connect(file) as database:
            database.execute("UPDATE messages SET data = substr(data, 1, 40) WHERE id = 6")
        with pytest.raises(QuadrupedError, match=r"message 5: byte \d+: .*; leave damaged messages out \(--salvage\)"):
            JointTrajectory.load(path)
        loaded = JointTrajectory.load(path, salvage=True)
        assert loaded.stamps.tolist() == [i for i in range(20) if i != 5]
        assert loaded.source.notes == ("left out 1 of 20: the message is damaged",)


class TestStream:
    def test_pieces_are_short_and_add_up(self, tmp_path):
        trajectory = random_trajectory(rows=10_000)
        trajectory.save(tmp_path / "a.mcap")
        shares = []
        stream = formats.stream(tmp_path / "a.mcap", progress=shares.append)
        pieces = list(stream)
        assert max(map(len, pieces)) <= 4096
        np.testing.assert_array_equal(np.concatenate([piece.efforts for piece in pieces]), trajectory.efforts)
        assert pieces[1].source.row(0).endswith("message 4096")
        assert shares == sorted(shares)
        assert shares[-1] == 1.0
        assert len(shares) > 5

    def test_a_bag_that_lacks_messages_is_refused(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(i, fields(i)) for i in range(20)], "sqlite3")
        (file,) = path.glob("*.db3")
        with sqlite3.connect(file) as database:
            database.execute("DELETE FROM messages WHERE id > 15")
        with pytest.raises(QuadrupedError, match=r"message 15: .*it says that there are 20 messages; keep .*--salvage"):
            JointTrajectory.load(path)
        assert len(JointTrajectory.load(path, salvage=True)) == 15

    def test_degrees_are_not_converted_twice(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(0, fields(position=(90, 45)))])
        joint_map = JointMap({"x": JointRule("a", unit="deg")})
        assert JointTrajectory.load(path, joint_map=joint_map).positions.tolist() == [[np.pi / 2]]
        with pytest.raises(QuadrupedError, match=r"\[joints\.x\] has units of its own, and degrees were asked for too"):
            JointTrajectory.load(path, joint_map=joint_map, degrees=True)


class TestTargets:
    def test_never_overwrites_unasked(self, tmp_path):
        trajectory = random_trajectory()
        for kind in ("mcap", "bare.mcap"):
            path = save(trajectory, tmp_path, kind)
            with pytest.raises(QuadrupedError, match=r"exists already; .*\(--overwrite\)"):
                save(trajectory, tmp_path, kind)
            shorter = random_trajectory(rows=2)
            save(shorter, tmp_path, kind, overwrite=True)
            assert_same(JointTrajectory.load(path), shorter)

    def test_never_removes_a_directory_that_is_more_than_a_bag(self, tmp_path):
        path = save(random_trajectory(), tmp_path, "mcap")
        (path / "thesis.tex").write_text("precious")
        with pytest.raises(QuadrupedError, match=r"is a directory that holds more than a bag"):
            save(random_trajectory(), tmp_path, "mcap", overwrite=True)
        assert (path / "thesis.tex").read_text() == "precious"

    def test_nothing_is_left_where_writing_fails(self, tmp_path):
        late = JointTrajectory([0, 2**62], JOINT_NAMES, np.zeros((2, 8)))
        with pytest.raises(QuadrupedError, match=r"stamp 4611686018427387904 ns: a ROS message holds"):
            late.save(tmp_path / "bag", tf_rate=0)
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize(
        ("name", "options", "message"),
        [
            ("a.bag", {}, r"unknown ending '\.bag'; a CSV ends in \.csv, a bare storage file in \.mcap or \.db3"),
            ("a.mcap", {"storage": "sqlite3"}, r"the ending is that of mcap, and asked for is sqlite3"),
            ("a", {"storage": "rosbag1"}, r"storage: expected one of mcap, sqlite3; found 'rosbag1'"),
            ("a", {"tf_rate": -1.0}, r"tf_rate: expected 0 to 1e6 Hz; found -1\.0"),
            ("a.db3", {"compress": True}, r"a bare sqlite3 file cannot be compressed"),
            ("a.csv", {"compress": True}, r"a CSV has no storage and is not compressed"),
            ("a", {"base_pose": np.zeros((4, 6))}, r"base_pose must be numbers of shape \(4, 7\)"),
        ],
    )
    def test_what_cannot_be_is_named(self, tmp_path, name, options, message):
        with pytest.raises(QuadrupedError, match=message):
            random_trajectory().save(tmp_path / name, **options)
        assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("module", ["rosbags.rosbag2", "rosbags.rosbag1", "yaml"])
def test_a_missing_library_names_its_extra(tmp_path, monkeypatch, module):
    random_trajectory().save(tmp_path / "a.mcap")
    (tmp_path / "a.yaml").write_text("header:\n")
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingExtraError, match=r"needs the 'ros' extra: pip install 'mini-quadruped\[ros\]'"):
        JointTrajectory.load(tmp_path / ("a.yaml" if module == "yaml" else "a.mcap"))
    if module == "rosbags.rosbag2":
        with pytest.raises(MissingExtraError, match="writing bags needs the 'ros' extra"):
            random_trajectory().save(tmp_path / "b.mcap")
        assert not (tmp_path / "b.mcap").exists()


def test_a_float_that_is_not_8_bytes_away_is_still_read(tmp_path):
    """Names of every length move the numbers to every alignment."""
    for length in range(1, 10):
        name = "x" * length
        path = write_bag(tmp_path / str(length), [(0, fields(names=[name], position=[0.5], effort=[1.5]))])
        loaded = JointTrajectory.load(path)
        assert (loaded.names, loaded.positions[0, 0], loaded.efforts[0, 0]) == ((name,), 0.5, 1.5)
        assert struct.calcsize("d") == 8
