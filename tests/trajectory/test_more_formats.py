"""Messages other than joint states, several messages for one robot, CSVs by their titles, odd bags."""

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
    types, empty = typestore().types, np.empty(0)
    point, duration = types["trajectory_msgs/msg/JointTrajectoryPoint"], types["builtin_interfaces/msg/Duration"]
    made = [point(np.array(q, float), np.array(v, float), empty, empty, duration(0, time)) for time, q, v in points]
    return types[TYPES["plan"]](cdr.header(stamp), list(names), made)


def dynamic(stamp, joints):
    """A DynamicJointState of joint -> {interface: value}."""
    types = typestore().types
    value = types["control_msgs/msg/InterfaceValue"]
    values = [value(list(table), np.array(list(table.values()), float)) for table in joints.values()]
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
        points = [(0, (0.0, 1.0), ()), (100, (0.1, 1.1), ()), (200, (0.2, 1.2), ())]
        first = plan(1000, ("a", "b"), points)
        second = plan(1150, ("b", "a"), [(0, (2.0, 0.5), ()), (100, (2.1, 0.6), ())])
        loaded = JointTrajectory.load(write(tmp_path / "bag", [(7, "/p", "plan", first), (8, "/p", "plan", second)]))
        assert loaded.stamps.tolist() == [1000, 1100, 1150, 1250]
        np.testing.assert_array_equal(loaded.positions, [[0, 1], [0.1, 1.1], [0.5, 2.0], [0.6, 2.1]])
        assert loaded.source.notes == ("1 points that a later trajectory replaced",)
        # One without a time begins when it was recorded.
        found = [(i * 50, "/plan", "plan", plan(0, ["a"], [(20, [float(i)], [1.0])])) for i in range(3)]
        loaded = JointTrajectory.load(write(tmp_path / "late", found))
        assert (loaded.stamps.tolist(), loaded.velocities.tolist()) == ([20, 70, 120], [[1.0]] * 3)

    def test_arrays_are_read_with_names_at_their_time_of_recording(self, tmp_path):
        found = [(i, "/commands", "array", cdr.message(TYPES["array"], data=[0.1 * i, 0.5])) for i in range(1, 4)]
        path = write(tmp_path / "bag", [*found, (5, "/joint_states", "state", cdr.message(TYPES["state"], **fields()))])
        assert len(JointTrajectory.load(path)) == 1
        with pytest.raises(QuadrupedError, match=r"2 positions and no names: give .*--names"):
            JointTrajectory.load(path, topic="/commands")
        loaded = JointTrajectory.load(path, topic="/commands", names=["x", "y"])
        assert loaded.stamps.tolist() == [1, 2, 3]
        assert loaded.positions.tolist() == [[0.1, 0.5], [0.2, 0.5], [0.1 * 3, 0.5]]


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
        with pytest.raises(QuadrupedError, match=r"message 1: it lacks joint 'f1', .* merge .*\(--repair merge\)"):
            JointTrajectory.load(path, unit="rad")
        loaded = JointTrajectory.load(path, repair=["merge"], unit="rad")
        assert loaded.names == ("f1", "f2", "r1")
        assert loaded.stamps.tolist() == [i * 10 + 2 for i in range(40)]
        np.testing.assert_array_equal(loaded.positions, [[i, -i, 10 * i] for i in range(40)])
        np.testing.assert_array_equal(loaded.velocities, [[1, 2, 3]] * 40)
        np.testing.assert_array_equal(loaded.efforts, [[np.nan, np.nan, 4]] * 40)
        assert loaded.source.notes[0] == "merged 2 kinds of messages: 3 joints"
        # At the rate of the slowest message, with the newest values.
        loaded = JointTrajectory.load(write_bag(tmp_path / "slow", self.messages(4)), repair=["merge"], unit="rad")
        assert loaded.stamps.tolist() == [i * 10 + 2 for i in range(0, 40, 4)]
        np.testing.assert_array_equal(loaded.positions[:, 0], np.arange(0, 40, 4))

    def test_joints_of_over_one_and_a_half_periods_apart_are_left_out(self, tmp_path):
        late = [(time + 60 * (time >= 200 and "r1" in one["name"]), one) for time, one in self.messages()]
        late.sort(key=lambda one: one[0])
        loaded = JointTrajectory.load(write_bag(tmp_path / "late", late), repair=["merge"], unit="rad")
        assert "left out 14 of 34: the joints' messages are over 1.5 periods apart" in loaded.source.notes

    def test_topics_of_one_robot_are_merged(self, tmp_path):
        parts = ((time, f"/{one['name'][0][0]}", one) for time, one in self.messages())
        found = [(time, topic, "state", cdr.message(TYPES["state"], **one)) for time, topic, one in parts]
        bag = write(tmp_path / "bag", found)
        with pytest.raises(QuadrupedError, match=r"topics /f,/r: several are read .*\(--repair merge\)"):
            JointTrajectory.load(bag, topic="/f,/r")
        assert len(JointTrajectory.load(bag, topic="/f,/r", repair=["merge"], unit="rad")) == 40


class TestOddBags:
    @pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
    def test_renamed_storage_file_is_read_with_a_note(self, tmp_path, storage):
        trajectory, bag = random_trajectory(), tmp_path / "bag"
        trajectory.save(bag, storage=storage)
        (file,) = (path for path in bag.iterdir() if path.name != "metadata.yaml")
        file.rename(bag / f"renamed{''.join(file.suffixes)}")
        loaded = JointTrajectory.load(bag)
        assert_same(loaded, trajectory)
        assert re.search(r"names bag\..*, and the directory holds renamed\..*: those were read", loaded.source.notes[0])

    def test_missing_storage_file_is_named(self, tmp_path):
        random_trajectory().save(tmp_path / "bag")
        metadata = tmp_path / "bag/metadata.yaml"
        metadata.write_text(re.sub(r"(\n *)- bag\.mcap", r"\1- bag.mcap\1- bag_1.mcap", metadata.read_text(), count=1))
        with pytest.raises(QuadrupedError, match=r"names bag\.mcap, bag_1\.mcap, and .* holds bag\.mcap; add bag_1"):
            JointTrajectory.load(tmp_path / "bag")

    def test_bag_with_fewer_messages_than_its_metadata_count_is_read_with_a_note(self, tmp_path):
        bag, trajectory = tmp_path / "bag", random_trajectory()
        trajectory.save(bag, storage="sqlite3")
        with closing(sqlite3.connect(bag / "bag.db3")) as database, database:
            database.execute("DELETE FROM messages WHERE timestamp = ?", (int(trajectory.stamps[-1]),))
        loaded = JointTrajectory.load(bag)
        assert_same(loaded, trajectory.slice(stop=trajectory.duration))
        note = "metadata.yaml counts 4 messages of /joint_states, and 3 were found: the bag was cut off, or files of it"
        assert [one[: len(note)] for one in loaded.source.notes] == [note]

    @pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
    @pytest.mark.parametrize(("old", "new"), [("depth: 10", "depth: 5"), ("depth: 10", "dept: 10")])
    def test_edited_qos_in_the_metadata_loses_no_message(self, tmp_path, storage, old, new):
        trajectory, metadata = random_trajectory(), tmp_path / "bag/metadata.yaml"
        trajectory.save(tmp_path / "bag", storage=storage)
        edited = metadata.read_text().replace(old, new)
        assert edited != metadata.read_text()
        metadata.write_text(edited)
        assert_same(JointTrajectory.load(tmp_path / "bag"), trajectory)

    def test_bag_in_wal_mode_that_was_closed_is_read(self, tmp_path):
        trajectory = random_trajectory()
        trajectory.save(tmp_path / "bag", storage="sqlite3")
        with closing(sqlite3.connect(tmp_path / "bag/bag.db3")) as database:
            assert database.execute("PRAGMA journal_mode = WAL").fetchone() == ("wal",)
        for path in (tmp_path / "bag", tmp_path / "bag/bag.db3"):
            assert_same(JointTrajectory.load(path), trajectory)


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

    @staticmethod
    def load(tmp_path, text, *names, **options):
        (tmp_path / "a.csv").write_text(text)
        return JointTrajectory.load(tmp_path / "a.csv", names=names or None, **options)

    def test_titles_with_kinds_and_other_names(self, tmp_path):
        titles = "__time;/joint_states/q1/position;/joint_states/q1/velocity;/joint_states/q1/effort;/cmd/q1/position"
        loaded = self.load(tmp_path, f"{titles}\n0.5;0.1;2;3;9\n", "q1")
        assert [loaded.positions, loaded.velocities, loaded.efforts] == [[[0.1]], [[2]], [[3]]]
        with pytest.raises(QuadrupedError, match=r"no column bears the name 'q2' \(--names\)"):
            self.load(tmp_path, f"{titles}\n0.5;0.1;2;3;9\n", "q1", "q2")
        with pytest.raises(QuadrupedError, match=r"two columns hold the position of q1"):
            self.load(tmp_path, "t,pos_q1,q1\n0,1,2\n", "q1")

    def test_dates_and_times_are_read_to_the_nanosecond(self, tmp_path):
        rows = "1970-01-02T00:00:01.000000005,0\n1970-01-02 01:00:02.5+01:00,0\n"
        day = 86_400 * 10**9
        assert self.load(tmp_path, f"time,q\n{rows}", "q").stamps.tolist() == [day + 10**9 + 5, day + 2_500_000_000]
        with pytest.raises(QuadrupedError, match=r"line 2, time: '1970-13-02T00:00:01' is not a time in s"):
            self.load(tmp_path, "time,q\n1970-13-02T00:00:01,0\n", "q")

    @pytest.mark.parametrize("title", ["t;LF_hip_joint;LF_knee_joint", "stamp_ns;position.LF_hip_joint;LF_knee_joint"])
    def test_decimal_commas_of_a_spreadsheet_are_read_and_said(self, tmp_path, title):
        loaded = self.load(tmp_path, f"{title}\n0;0,5;-1e-2\n1;0,25;0\n")
        np.testing.assert_array_equal(loaded.positions, [[0.5, -0.01], [0.25, 0.0]])
        assert loaded.source.notes[0].endswith("2 joints, in rad, with decimal commas")
        with pytest.raises(
            QuadrupedError, match=r"line 2, (position\.)?LF_hip_joint: '0,5' is not .*\(decimal = \",\"\)"
        ):
            self.load(tmp_path, f"{title}\n0;0,5;-1e-2\n1;0,25;1.000,5\n")
        with pytest.raises(
            QuadrupedError, match=r"line 3, .*LF_hip_joint: '0,25' .*decimal comma, .*\(decimal = \",\"\)"
        ):
            self.load(tmp_path, f"{title}\n0;0.5;-1e-2\n1;0,25;0\n")

    def test_decimal_commas_by_a_map(self, tmp_path):
        given = {"stamp": "t", "positions": ["q"], "separator": ";"}
        text = "t;q\n0,5;1,25\n2024-01-01 00:00:00,25;7\n"
        loaded = self.load(tmp_path, text, columns=ColumnMap(**given, decimal=","))
        assert loaded.positions.tolist() == [[1.25], [7.0]]
        assert loaded.stamps[0] == 500_000_000
        assert loaded.stamps[1] % 10**9 == 250_000_000
        with pytest.raises(
            QuadrupedError, match=r"line 2, q: '1\.000,5' is not a number; fix the value or delete the l"
        ):
            self.load(tmp_path, "t;q\n0,5;1.000,5\n", columns=ColumnMap(**given, decimal=","))
        with pytest.raises(QuadrupedError, match=r"line 2, t: '0,5' is not a time in s; .*\(decimal = \",\"\)"):
            self.load(tmp_path, text, columns=ColumnMap(**given))
        with pytest.raises(QuadrupedError, match=r"decimal: expected '\.' or ','; found 'x'"):
            ColumnMap(**given, decimal="x")

    def test_csv_without_a_time_needs_a_period(self, tmp_path):
        text, joints = "LF_hip_joint,LF_knee_joint\n0.1,0.2\n0.3,0.4\n", ["LF_knee_joint"]
        with pytest.raises(QuadrupedError, match=r"no timestamps: .*\(period in the map, or --stamps 0\.02\)"):
            self.load(tmp_path, text)
        by_map, without = ColumnMap(None, joints, period=0.02), ColumnMap(None, joints)
        for options in ({"stamps": 0.02}, {"columns": by_map}, {"columns": without, "stamps": "0.02"}):
            assert self.load(tmp_path, text, **options).stamps.tolist() == [0, 20_000_000]
        with pytest.raises(QuadrupedError, match=r"period: expected .* 1e-6 to 1e6 s, instead of stamp; found 0\.02"):
            ColumnMap("t", ["a"], period=0.02)


def test_convert_map_back_gives_the_motors_of_the_robot_that_the_map_describes(tmp_path):
    rule = "[joints.{}]\nsource = 'm{}'\nsign = -1\nunit = 'deg'\n"
    (tmp_path / "map.toml").write_text("".join(rule.format(name, i) for i, name in enumerate(JOINT_NAMES)))
    positions = np.linspace(-0.4, 0.4, 24).reshape(3, 8)
    JointTrajectory([0, 10, 20], JOINT_NAMES, positions).save(tmp_path / "a.csv")
    files = [str(tmp_path / name) for name in ("a.csv", "b.csv", "map.toml")]
    assert main(["convert", *files[:2], "--map-back", files[2]]) == 0
    sent = JointTrajectory.load(files[1], unit="rad")
    assert sent.names == tuple(f"m{i}" for i in range(8))
    np.testing.assert_allclose(sent.positions, np.degrees(-positions))
    again = JointTrajectory.load(files[1], joint_map=files[2])
    np.testing.assert_allclose(again.positions, positions, rtol=1e-15)
