"""Messages other than joint states, several messages for one robot, motion clips, CSVs by their titles, odd bags."""

import json
import re
import sqlite3
from contextlib import closing

import numpy as np
import pytest
from trajectories import assert_same, random_trajectory

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.trajectory import ColumnMap

pytest.importorskip("rosbags")
from bags import fields, write_bag
from rosbags.rosbag2 import StoragePlugin, Writer

from quadruped_env.ros import cdr
from quadruped_env.ros.message_types import typestore

TYPES = {
    "state": "sensor_msgs/msg/JointState",
    "dynamic": "control_msgs/msg/DynamicJointState",
    "plan": "trajectory_msgs/msg/JointTrajectory",
    "array": "std_msgs/msg/Float64MultiArray",
}


def write(path, messages, storage="mcap"):
    """Write (time of recording in ns, topic, key of TYPES, message) to a bag; returns its path."""
    with Writer(path, version=8, storage_plugin=StoragePlugin[storage.upper()]) as writer:
        connections = {}
        for time, topic, kind, message in messages:
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, TYPES[kind], typestore=typestore())
            writer.write(connections[topic], time, cdr.serialize(message))
    return path


def plan(stamp, names, points):
    """A JointTrajectory with points (time from start in ns, positions, velocities)."""
    types = typestore().types
    empty = np.empty(0)
    made = [
        types["trajectory_msgs/msg/JointTrajectoryPoint"](
            np.array(positions, float),
            np.array(velocities, float),
            empty,
            empty,
            types["builtin_interfaces/msg/Duration"](*divmod(time, 10**9)),
        )
        for time, positions, velocities in points
    ]
    return types[TYPES["plan"]](cdr.header(stamp), list(names), made)


def dynamic(stamp, joints):
    """A DynamicJointState of joint -> {interface: value}."""
    types = typestore().types
    values = [
        types["control_msgs/msg/InterfaceValue"](list(table), np.array(list(table.values()), float))
        for table in joints.values()
    ]
    return types[TYPES["dynamic"]](cdr.header(stamp), list(joints), values)


class TestMessages:
    @pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
    def test_dynamic_joint_states(self, tmp_path, storage):
        found = [
            (i, "/dynamic_joint_states", "dynamic", dynamic(i, {
                "a": {"velocity": 2.0 + i, "position": 0.1 * i, "temperature": 40.0},
                "b": {"position": -0.1 * i, "velocity": 3.0, "effort": 5.0},
            }))
            for i in range(3)
        ]  # fmt: skip
        loaded = JointTrajectory.load(write(tmp_path / "bag", found, storage))
        assert (loaded.names, loaded.stamps.tolist()) == (("a", "b"), [0, 1, 2])
        np.testing.assert_allclose(loaded.positions, [[0, 0], [0.1, -0.1], [0.2, -0.2]])
        np.testing.assert_array_equal(loaded.velocities, [[2, 3], [3, 3], [4, 3]])
        np.testing.assert_array_equal(loaded.efforts, [[np.nan, 5]] * 3)

    def test_points_of_a_trajectory_end_where_the_next_begins(self, tmp_path):
        names = ("a", "b")
        found = [
            (
                7,
                "/plan",
                "plan",
                plan(1000, names, [(0, (0.0, 1.0), ()), (100, (0.1, 1.1), ()), (200, (0.2, 1.2), ())]),
            ),
            (8, "/plan", "plan", plan(1150, ("b", "a"), [(0, (2.0, 0.5), ()), (100, (2.1, 0.6), ())])),
        ]
        loaded = JointTrajectory.load(write(tmp_path / "bag", found))
        assert loaded.stamps.tolist() == [1000, 1100, 1150, 1250]
        np.testing.assert_array_equal(loaded.positions, [[0, 1], [0.1, 1.1], [0.5, 2.0], [0.6, 2.1]])
        assert loaded.source.notes == ("1 points that a later trajectory replaced",)

    def test_trajectory_without_a_time_begins_when_it_was_recorded(self, tmp_path):
        found = [(i * 50, "/plan", "plan", plan(0, ["a"], [(20, [float(i)], [1.0])])) for i in range(3)]
        loaded = JointTrajectory.load(write(tmp_path / "bag", found))
        assert (loaded.stamps.tolist(), loaded.velocities.tolist()) == ([20, 70, 120], [[1.0]] * 3)

    def test_arrays_are_read_with_names_at_their_time_of_recording(self, tmp_path):
        found = [(i, "/commands", "array", cdr.message(TYPES["array"], data=[0.1 * i, 0.5])) for i in range(1, 4)]
        path = write(tmp_path / "bag", [*found, (5, "/joint_states", "state", cdr.message(TYPES["state"], **fields()))])
        assert len(JointTrajectory.load(path)) == 1
        with pytest.raises(QuadrupedError, match=r"2 positions and no names: give .*--names"):
            JointTrajectory.load(path, topic="/commands")
        loaded = JointTrajectory.load(path, topic="/commands", names=["x", "y"])
        assert (loaded.stamps.tolist(), loaded.positions.tolist()) == (
            [1, 2, 3],
            [[0.1, 0.5], [0.2, 0.5], [0.1 * 3, 0.5]],
        )

    def test_echoed_yaml_of_each_type(self, tmp_path):
        head = "header:\n  stamp:\n    sec: 1\n    nanosec: 5\n  frame_id: ''\njoint_names: [a, b]\n"
        (tmp_path / "a").write_text(
            f"{head}interface_values:\n- interface_names: [position, velocity]\n  values: [0.25, 1.0]\n"
            "- interface_names: [velocity, position]\n  values: [2.0, -0.5]\n---\n"
        )
        loaded = JointTrajectory.load(tmp_path / "a")
        assert (loaded.positions.tolist(), loaded.velocities.tolist()) == ([[0.25, -0.5]], [[1.0, 2.0]])
        point = "- positions: [{0}, 0.5]\n  velocities: []\n  accelerations: []\n  effort: []\n"
        points = [point.format(i) + f"  time_from_start:\n    sec: 0\n    nanosec: {i}\n" for i in range(3)]
        (tmp_path / "b").write_text(f"{head}points:\n{''.join(points)}---\n")
        loaded = JointTrajectory.load(tmp_path / "b")
        assert (loaded.stamps - 10**9).tolist() == [5, 6, 7]
        assert loaded.positions.tolist() == [[0.0, 0.5], [1.0, 0.5], [2.0, 0.5]]


class TestMerge:
    @staticmethod
    def messages(rear_every=1, skew=2):
        """Front and rear joints in messages of their own, 10 ns apart; the rear ones come later, and not always."""
        for i in range(40):
            yield i * 10, fields(i * 10, ("f1", "f2"), (i, -i), velocity=(1, 2))
            if i % rear_every == 0:
                yield i * 10 + skew, fields(i * 10 + skew, ("r1",), (10 * i,), velocity=(3,), effort=(4,))

    def test_messages_of_parts_of_a_robot_become_whole_rows(self, tmp_path):
        path = write_bag(tmp_path / "bag", self.messages())
        with pytest.raises(
            QuadrupedError, match=r"message 1: it lacks joint 'f1', .* merge the messages .*\(--merge\)"
        ):
            JointTrajectory.load(path, degrees=False)
        loaded = JointTrajectory.load(path, merge=True, degrees=False)
        assert loaded.names == ("f1", "f2", "r1")
        assert loaded.stamps.tolist() == [i * 10 + 2 for i in range(40)]
        np.testing.assert_array_equal(loaded.positions, [[i, -i, 10 * i] for i in range(40)])
        np.testing.assert_array_equal(loaded.velocities, [[1, 2, 3]] * 40)
        np.testing.assert_array_equal(loaded.efforts, [[np.nan, np.nan, 4]] * 40)
        assert loaded.source.notes[0] == "merged 2 kinds of messages: 3 joints"

    def test_rows_come_at_the_rate_of_the_slowest_message_with_the_newest_values(self, tmp_path):
        loaded = JointTrajectory.load(write_bag(tmp_path / "bag", self.messages(4)), merge=True, degrees=False)
        assert loaded.stamps.tolist() == [i * 10 + 2 for i in range(0, 40, 4)]
        np.testing.assert_array_equal(loaded.positions[:, 0], np.arange(0, 40, 4))

    def test_joints_of_over_one_and_a_half_periods_apart_are_left_out(self, tmp_path):
        lost = [one for one in self.messages() if not (100 <= one[0] < 200 and "r1" in one[1]["name"])]
        loaded = JointTrajectory.load(write_bag(tmp_path / "bag", lost), merge=True, degrees=False)
        assert len(loaded) == 30
        late = [
            (time + 60, one) if time >= 200 and "r1" in one["name"] else (time, one) for time, one in self.messages()
        ]
        late.sort(key=lambda one: one[0])
        loaded = JointTrajectory.load(write_bag(tmp_path / "late", late), merge=True, degrees=False)
        assert "left out 14 of 34: the joints' messages are over 1.5 periods apart" in loaded.source.notes

    def test_topics_of_one_robot_are_merged(self, tmp_path):
        bag = write(
            tmp_path / "bag",
            [
                (time, f"/{one['name'][0][0]}", "state", cdr.message(TYPES["state"], **one))
                for time, one in self.messages()
            ],
        )
        with pytest.raises(QuadrupedError, match=r"topics /f,/r: several are read .*\(--merge\)"):
            JointTrajectory.load(bag, topic="/f,/r")
        assert len(JointTrajectory.load(bag, topic="/f,/r", merge=True, degrees=False)) == 40


class TestOddBags:
    def test_renamed_storage_file_is_read_with_a_note(self, tmp_path):
        trajectory = random_trajectory()
        for storage in ("mcap", "sqlite3"):
            bag = tmp_path / storage
            trajectory.save(bag, storage=storage, compress=storage == "sqlite3")
            (file,) = (path for path in bag.iterdir() if path.name != "metadata.yaml")
            file.rename(bag / f"renamed{''.join(file.suffixes)}")
            loaded = JointTrajectory.load(bag)
            assert_same(loaded, trajectory)
            assert re.search(
                rf"names {storage}\..*, and the directory holds renamed\..*: those were read", loaded.source.notes[0]
            )

    def test_missing_storage_file_is_named(self, tmp_path):
        random_trajectory().save(tmp_path / "bag")
        text = (tmp_path / "bag/metadata.yaml").read_text()
        (tmp_path / "bag/metadata.yaml").write_text(
            re.sub(r"(\n *)- bag\.mcap", r"\1- bag.mcap\1- bag_1.mcap", text, count=1)
        )
        with pytest.raises(
            QuadrupedError, match=r"names bag\.mcap, bag_1\.mcap, and the directory holds bag\.mcap; add"
        ):
            JointTrajectory.load(tmp_path / "bag")

    def test_bag_in_wal_mode_that_was_closed_is_read(self, tmp_path):
        trajectory = random_trajectory()
        trajectory.save(tmp_path / "bag", storage="sqlite3")
        with closing(sqlite3.connect(tmp_path / "bag/bag.db3")) as database:
            assert database.execute("PRAGMA journal_mode = WAL").fetchone() == ("wal",)
        for path in (tmp_path / "bag", tmp_path / "bag/bag.db3"):
            assert_same(JointTrajectory.load(path), trajectory)


class TestMotionClip:
    def test_frames_of_named_joints_with_and_without_a_base(self, tmp_path):
        joints = [[0.1 * i, 0.2 * i] for i in range(5)]
        for pose in ([], [0, 0, 0.4, 0, 0, 0, 1]):
            clip = {"LoopMode": "Wrap", "FrameDuration": 0.025, "Frames": [pose + row for row in joints]}
            (tmp_path / "clip.txt").write_text(json.dumps(clip, indent=1))
            loaded = JointTrajectory.load(tmp_path / "clip.txt", names=["a", "b"])
            assert loaded.stamps.tolist() == [0, 25_000_000, 50_000_000, 75_000_000, 100_000_000]
            np.testing.assert_array_equal(loaded.positions, joints)
        with pytest.raises(
            QuadrupedError, match=r"frames of 9 numbers, which have no names: .*--names.* 9, or 2 after"
        ):
            JointTrajectory.load(tmp_path / "clip.txt")
        by_number = ColumnMap(None, {"a": 9, "b": 8}, velocities={"b": 1, "a": 2})
        loaded = JointTrajectory.load(tmp_path / "clip.txt", columns=by_number)
        np.testing.assert_array_equal(loaded.positions, np.array(joints)[:, ::-1])

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ('{"FrameDuration": 0, "Frames": [[1]]}', r"FrameDuration: expected a time .*; found 0"),
            ('{"FrameDuration": 0.1, "Frames": []}', r"Frames: expected lists of .*; found \[\]"),
            ('{"FrameDuration": 0.1, "Frames": [[1], [2, 3]]}', r"Frames: .*; found \[\[1\], \[2, 3\]\]"),
            ('{"FrameDuration": 0.1, "Frames": [["x"]]}', r"Frames: .*; found \[\['x'\]\]"),
        ],
    )
    def test_mistakes_are_named(self, tmp_path, text, message):
        (tmp_path / "clip").write_text(text)
        with pytest.raises(QuadrupedError, match=message):
            JointTrajectory.load(tmp_path / "clip", names=["a"])


class TestTitles:
    @pytest.mark.parametrize(
        ("time", "unit"),
        [("t", 10**9), ("time [ms]", 10**6), ("stamp_ns", 1), ("__time", 10**9), ("Timestamp (us)", 1000)],
    )
    def test_csv_whose_columns_bear_the_joints_names_is_read(self, tmp_path, time, unit):
        titles = [time, "mode", *reversed(JOINT_NAMES)]
        rows = [[50 * i, "walk", *(0.01 * i * k for k in range(8))] for i in range(4)]
        (tmp_path / "a.csv").write_text("\n".join(",".join(map(str, row)) for row in [titles, *rows]))
        loaded = JointTrajectory.load(tmp_path / "a.csv")
        assert loaded.stamps.tolist() == [50 * i * unit for i in range(4)]
        np.testing.assert_allclose(loaded.select(JOINT_NAMES).positions[3], [0.03 * k for k in range(7, -1, -1)])
        assert "positions of 8 joints, in rad" in loaded.source.notes[0]

    def test_titles_with_kinds_and_other_names(self, tmp_path):
        (tmp_path / "a.csv").write_text(
            "__time;/joint_states/q1/position;/joint_states/q1/velocity;/joint_states/q1/effort;/cmd/q1/position\n"
            "0.5;0.1;2;3;9\n"
        )
        loaded = JointTrajectory.load(tmp_path / "a.csv", names=["q1"])
        assert (loaded.positions.tolist(), loaded.velocities.tolist(), loaded.efforts.tolist()) == (
            [[0.1]],
            [[2]],
            [[3]],
        )
        with pytest.raises(QuadrupedError, match=r"no column bears the name 'q2' \(--names\)"):
            JointTrajectory.load(tmp_path / "a.csv", names=["q1", "q2"])
        (tmp_path / "a.csv").write_text("t,pos_q1,q1\n0,1,2\n")
        with pytest.raises(QuadrupedError, match=r"two columns hold the position of q1"):
            JointTrajectory.load(tmp_path / "a.csv", names=["q1"])

    def test_dates_and_times_are_read_to_the_nanosecond(self, tmp_path):
        (tmp_path / "a.csv").write_text("time,q\n1970-01-02T00:00:01.000000005,0\n1970-01-02 01:00:02.5+01:00,0\n")
        day = 86_400 * 10**9
        assert JointTrajectory.load(tmp_path / "a.csv", names=["q"]).stamps.tolist() == [
            day + 10**9 + 5,
            day + 2_500_000_000,
        ]
        (tmp_path / "a.csv").write_text("time,q\n1970-13-02T00:00:01,0\n")
        with pytest.raises(QuadrupedError, match=r"line 2, time: '1970-13-02T00:00:01' is not a time in s"):
            JointTrajectory.load(tmp_path / "a.csv", names=["q"])

    def test_csv_without_a_time_needs_a_period(self, tmp_path):
        (tmp_path / "a.csv").write_text("LF_hip_joint,LF_knee_joint\n0.1,0.2\n0.3,0.4\n")
        with pytest.raises(QuadrupedError, match=r"no timestamps: .*\(period in the map, or --stamps 0\.02\)"):
            JointTrajectory.load(tmp_path / "a.csv")
        by_map = ColumnMap(None, ["LF_knee_joint"], period=0.02)
        for options in (
            {"stamps": 0.02},
            {"columns": by_map},
            {"columns": ColumnMap(None, ["LF_knee_joint"]), "stamps": "0.02"},
        ):
            assert JointTrajectory.load(tmp_path / "a.csv", **options).stamps.tolist() == [0, 20_000_000]
        with pytest.raises(
            QuadrupedError, match=r"period: expected a time of 1e-6 to 1e6 s, in place of stamp; found 0\.02"
        ):
            ColumnMap("t", ["a"], period=0.02)


def test_convert_map_back_gives_the_motors_of_the_robot_that_the_map_describes(tmp_path, capsys):
    joints = "".join(
        f"[joints.{name}]\nsource = 'm{i}'\nsign = -1\nunit = 'deg'\n" for i, name in enumerate(JOINT_NAMES)
    )
    (tmp_path / "map.toml").write_text(joints)
    positions = np.linspace(-0.4, 0.4, 24).reshape(3, 8)
    JointTrajectory([0, 10, 20], JOINT_NAMES, positions).save(tmp_path / "a.csv")
    assert (
        main(["convert", str(tmp_path / "a.csv"), str(tmp_path / "b.csv"), "--map-back", str(tmp_path / "map.toml")])
        == 0
    )
    sent = JointTrajectory.load(tmp_path / "b.csv", degrees=False)
    assert sent.names == tuple(f"m{i}" for i in range(8))
    np.testing.assert_allclose(sent.positions, np.degrees(-positions))
    again = JointTrajectory.load(tmp_path / "b.csv", joint_map=tmp_path / "map.toml")
    np.testing.assert_allclose(again.positions, positions, rtol=1e-15)
