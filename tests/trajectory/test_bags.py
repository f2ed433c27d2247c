"""Bags, read back by independent readers, and bags that others wrote."""

import itertools
import sqlite3
import struct
import sys
import zlib

import numpy as np
import pytest
from bags import JOINT_STATE, KINDS, fields, messages_of, save, write_bag, write_ros1
from trajectories import STAMPS, assert_same, random_trajectory

from quadruped_env import (
    JOINT_NAMES,
    JointTrajectory,
    MissingExtraError,
    QuadrupedError,
    asset_path,
    forward_kinematics,
)
from quadruped_env.ros import cdr
from quadruped_env.trajectory.formats import bag_writer

pytest.importorskip("rosbags")
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore


class TestRoundTrip:
    @pytest.mark.parametrize("kind", KINDS)
    def test_to_the_last_bit(self, tmp_path, kind):
        trajectory = random_trajectory(rows=1000)
        assert_same(JointTrajectory.load(save(trajectory, tmp_path / "new", kind)), trajectory)
        assert [entry.name for entry in (tmp_path / "new").iterdir()] in (["bag"], [kind])

    @pytest.mark.parametrize("changes", [{"velocities": None}, {"velocities": None, "efforts": None}])
    def test_fields_that_were_not_recorded_stay_missing(self, tmp_path, changes):
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
    def test_mcap_has_the_same_numbers(self, tmp_path):
        trajectory = random_trajectory(rows=300)
        trajectory.save(tmp_path / "a.mcap")
        topics = read_independently(tmp_path / "a.mcap")
        assert set(topics) == {"/joint_states", "/robot_description", "/tf", "/tf_static"}
        ((time, description),), ((_, static),) = topics["/robot_description"], topics["/tf_static"]
        assert (time, description.data) == (trajectory.stamps[0], asset_path("mini_quadruped.urdf").read_text())
        assert list(static.transforms) == []
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
        random_trajectory(rows=3000).save(tmp_path / "a.mcap")
        with (tmp_path / "a.mcap").open("rb") as file:
            records = list(reader.StreamReader(file, emit_chunks=True, validate_crcs=True).records)
        chunks = [record for record in records if type(record).__name__ == "Chunk"]
        assert len(chunks) > 1
        assert all(chunk.uncompressed_crc == zlib.crc32(chunk.data) for chunk in chunks)

    def test_transforms_are_those_of_the_rows_every_50_ms_at_most(self, tmp_path, monkeypatch):
        monkeypatch.setattr(bag_writer, "_ROWS_PER_PIECE", 64)
        trajectory = random_trajectory(rows=1000)
        trajectory.save(tmp_path / "a.mcap")
        found = read_independently(tmp_path / "a.mcap")["/tf"]
        due = np.diff(trajectory.stamps // 50_000_000, prepend=0) > 0
        assert 390 < due.sum() < 410
        assert [time for time, _ in found] == trajectory.stamps[due].tolist()
        for (stamp, message), row in list(zip(found, trajectory.positions[due], strict=True))[::40]:
            poses = {"base_link": np.eye(4)}
            for one in message.transforms:
                assert one.header.stamp.sec * 10**9 + one.header.stamp.nanosec == stamp
                poses[one.child_frame_id] = poses[one.header.frame_id] @ matrix_of(one.transform)
            for link, (position, quaternion) in forward_kinematics(row).items():
                np.testing.assert_allclose(poses[link], matrix(position, quaternion), rtol=0, atol=1e-9)

    def test_the_base_moves_in_its_odometry_frame(self, tmp_path):
        rows = 200
        yaw = np.linspace(0.0, 7.0, rows)
        base = np.zeros((rows, 7))
        base[:, 0], base[:, 3], base[:, 6] = np.arange(rows), np.cos(yaw / 2), np.sin(yaw / 2)
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
        assert_same(JointTrajectory.load(path, repair=["salvage"]), trajectory)

    def test_a_bag_in_several_files(self, tmp_path):
        trajectory = random_trajectory(rows=300)
        parts = [trajectory.at(trajectory.stamps[i : i + 25]) for i in range(0, 300, 25)]
        (tmp_path / "bag").mkdir()
        for i, part in enumerate(parts):
            part.save(tmp_path / "bag" / f"bag_{i}.mcap")
        loaded = JointTrajectory.load(tmp_path / "bag")
        assert_same(loaded, trajectory)

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

    @pytest.mark.parametrize("storage", ["MCAP", "SQLITE3"])
    def test_messages_in_another_serialization_are_refused(self, tmp_path, storage):
        with Writer(tmp_path / "bag", version=8, storage_plugin=StoragePlugin[storage]) as writer:
            kind = {"typestore": cdr.typestore(), "serialization_format": "json"}
            writer.write(writer.add_connection("/joint_states", JOINT_STATE, **kind), 0, b"{}")
        with pytest.raises(QuadrupedError, match=r"/joint_states is serialized as 'json'; only 'cdr' is known"):
            JointTrajectory.load(tmp_path / "bag")

    def test_timestamps_may_be_the_times_of_recording(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(5, fields()), (8, fields())])
        with pytest.raises(QuadrupedError, match=r"message 1, stamp_ns: 0 does not come after 0"):
            JointTrajectory.load(path)
        assert JointTrajectory.load(path, stamps="log").stamps.tolist() == [5, 8]

    def test_names_in_another_order_are_put_in_order(self, tmp_path):
        path = write_bag(
            tmp_path / "bag",
            [(0, fields(0, ("a", "b"), (1, 2), velocity=(3, 4))), (1, fields(1, ("b", "a"), (5, 6), velocity=(7, 8)))],
        )
        loaded = JointTrajectory.load(path)
        assert (loaded.names, loaded.positions.tolist()) == (("a", "b"), [[1, 2], [6, 5]])
        assert loaded.velocities.tolist() == [[3, 4], [8, 7]]


class TestTargets:
    def test_existing_target_without_overwrite_is_refused(self, tmp_path):
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
        with pytest.raises(QuadrupedError, match=r"is a directory that contains more than a bag"):
            save(random_trajectory(), tmp_path, "mcap", overwrite=True)
        assert (path / "thesis.tex").read_text() == "precious"

    def test_nothing_is_left_where_writing_fails(self, tmp_path):
        late = JointTrajectory([0, 2**62], JOINT_NAMES, np.zeros((2, 8)))
        with pytest.raises(QuadrupedError, match=r"stamp 4611686018427387904 ns: a ROS message holds"):
            late.save(tmp_path / "bag")
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize(
        ("name", "options", "message"),
        [
            ("a.bag", {}, r"unknown ending '\.bag'; a CSV ends in \.csv, a bare storage file in \.mcap or \.db3"),
            ("a.mcap", {"storage": "sqlite3"}, r"the ending belongs to mcap, and the storage is to be sqlite3"),
            ("a", {"storage": "rosbag1"}, r"storage: expected one of mcap, sqlite3; found 'rosbag1'"),
            ("a.csv", {"storage": "mcap"}, r"a CSV has no storage"),
            ("a", {"base_pose": np.zeros((4, 6))}, r"base_pose must be numbers of shape \(4, 7\)"),
        ],
    )
    def test_invalid_targets_and_options_are_named(self, tmp_path, name, options, message):
        with pytest.raises(QuadrupedError, match=message):
            random_trajectory().save(tmp_path / name, **options)
        assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("module", ["rosbags.rosbag2", "rosbags.convert", "yaml"])
def test_a_missing_library_names_its_extra(tmp_path, monkeypatch, module):
    write_ros1(tmp_path / "a.bag", random_trajectory())
    (tmp_path / "a.yaml").write_text("header:\n")
    monkeypatch.setitem(sys.modules, module, None)
    programs = {
        "rosbags.rosbag2": lambda: random_trajectory().save(tmp_path / "b.mcap"),
        "rosbags.convert": lambda: JointTrajectory.load(tmp_path / "a.bag"),
        "yaml": lambda: JointTrajectory.load(tmp_path / "a.yaml"),
    }
    with pytest.raises(MissingExtraError, match=r"needs the 'ros' extra: .*pip install 'mini-quadruped\[ros\]'"):
        programs[module]()
    assert not (tmp_path / "b.mcap").exists()


def test_float_with_any_alignment_is_read(tmp_path):
    """Names of different lengths give the numbers every alignment."""
    for length in range(1, 10):
        name = "x" * length
        path = write_bag(tmp_path / str(length), [(0, fields(names=[name], position=[0.5], effort=[1.5]))])
        loaded = JointTrajectory.load(path)
        assert (loaded.names, loaded.positions[0, 0], loaded.efforts[0, 0]) == ((name,), 0.5, 1.5)
        assert struct.calcsize("d") == 8
