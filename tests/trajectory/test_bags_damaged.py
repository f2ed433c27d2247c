"""Bags with bad messages, damaged bags, and bags in pieces."""

import re
import sqlite3
import struct
import subprocess
import sys
from contextlib import closing

import numpy as np
import pytest
from bags import fields, save, write_bag, write_ros1
from paths import importing
from trajectories import assert_same, random_trajectory

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.trajectory import JointMap, JointRule

pytest.importorskip("rosbags")

UNCHECKED = "salvaged without a checksum, so that damage in their numbers would not show"


class TestBadMessages:
    """Every case is refused by default, with a fix; where `drop` leaves bad messages out, the other rows stay."""

    @pytest.mark.parametrize(
        ("bad", "message", "drop"),
        [
            (
                fields(1, position=[0.1]),
                r"message 1: 2 names and 1 positions; fix it, or leave .* out \(--repair drop\)",
                True,
            ),
            (
                fields(1, names=[]),
                r"message 1: 2 positions and no names: give the joints in their order \(--names\)",
                True,
            ),
            (fields(1, names=["a", "a"]), r"message 1: joint 'a' is named twice", True),
            (fields(1, names=["a", ""]), r"message 1: 2 positions and 2 names, of which 1 are empty", True),
            (fields(1, names=["a", "c"]), r"message 1: it lacks joint 'b', which the messages before it have", True),
            (fields(1, velocity=[1, 2]), r"message 1: it has the velocity that the messages before it lack", True),
            (fields(1, position=[np.nan, 0]), r"message 1, position\.a: nan is not finite; leave the row out", True),
            (fields(0), r"message 1, stamp_ns: 0 does not come after 0 .*\(--repair sort\).*\(--repair drop", True),
            (
                fields(1, position=[90.0, 0]),
                r"message 1, position\.a: 90 rad is more than two turns.*--unit deg",
                False,
            ),
        ],
    )
    def test_is_named_and_dropped(self, tmp_path, bad, message, drop):
        good = [(i, fields(i)) for i in range(6)]
        path = write_bag(tmp_path / "bag", [good[0], (1, bad), *good[2:]])
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: {message}"):
            JointTrajectory.load(path)
        if drop:
            loaded = JointTrajectory.load(path, repair=["drop"])
            assert loaded.stamps.tolist() == [0, 2, 3, 4, 5]
            (note,) = loaded.source.notes
            assert note.startswith("left out 1 of 6: ")

    def test_an_empty_bag(self, tmp_path):
        with pytest.raises(QuadrupedError, match=r"the topic has no message; record again"):
            JointTrajectory.load(write_bag(tmp_path / "bag", []))

    def test_no_row_left(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(0, fields(position=[np.nan, 0]))])
        with pytest.raises(QuadrupedError, match=r"no row is left; left out 1 of 1: a number is not finite"):
            JointTrajectory.load(path, repair=["drop"])

    def test_names_given_for_messages_without(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(i, fields(i, names=[])) for i in range(3)])
        assert JointTrajectory.load(path, names=["x", "y"]).names == ("x", "y")
        with pytest.raises(QuadrupedError, match=r"message 0: 3 names and 2 positions"):
            JointTrajectory.load(path, names=["x", "y", "z"])

    def test_decreasing_timestamps_are_sorted_or_dropped_on_request(self, tmp_path):
        path = write_bag(
            tmp_path / "bag", [(i, fields(stamp, position=(stamp, 0))) for i, stamp in enumerate([3, 1, 2, 5])]
        )
        with pytest.raises(QuadrupedError, match=r"message 1, stamp_ns: 1 does not come after 3"):
            JointTrajectory.load(path)
        by_stamp = JointTrajectory.load(path, repair=["sort"])
        assert (by_stamp.stamps.tolist(), by_stamp.positions[:, 0].tolist()) == ([1, 2, 3, 5], [1, 2, 3, 5])
        assert JointTrajectory.load(path, repair=["drop"]).stamps.tolist() == [3, 5]

    def test_repeated_timestamps_are_refused_after_sorting_too(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(i, fields(stamp)) for i, stamp in enumerate([3, 1, 3])])
        with pytest.raises(QuadrupedError, match=r"message 2, stamp_ns: 3 does not come after 3"):
            JointTrajectory.load(path, repair=["sort"])
        assert JointTrajectory.load(path, repair=["sort", "drop"]).stamps.tolist() == [1, 3]

    @pytest.mark.parametrize("row", [4095, 4096])
    def test_timestamps_that_decrease_between_blocks_are_refused(self, tmp_path, row):
        stamps = np.arange(5000) * 10
        stamps[row] = stamps[row - 1]
        path = write_bag(tmp_path / "bag", [(i, fields(int(stamp))) for i, stamp in enumerate(stamps)], "sqlite3")
        with pytest.raises(QuadrupedError, match=rf"message {row}, stamp_ns: {stamps[row]} does not come after"):
            JointTrajectory.load(path)
        assert len(JointTrajectory.load(path, repair=["drop"])) == 4999

    def test_degrees_are_converted_on_request_only(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(0, fields(position=(90, -45), velocity=(180, 0), effort=(3, 4)))])
        converted = JointTrajectory.load(path, unit="deg")
        np.testing.assert_allclose(converted.positions, [[np.pi / 2, -np.pi / 4]])
        np.testing.assert_allclose(converted.velocities, [[np.pi, 0]])
        assert converted.efforts.tolist() == [[3, 4]]
        assert JointTrajectory.load(path, unit="rad").positions.tolist() == [[90, -45]]

    def test_velocities_that_are_all_unknown_are_dropped_and_efforts_in_part_stay(self, tmp_path):
        unknown = {"velocity": (np.nan, np.nan), "effort": (np.nan, 1.5)}
        loaded = JointTrajectory.load(write_bag(tmp_path / "bag", [(i, fields(i, **unknown)) for i in range(3)]))
        assert loaded.velocities is None
        np.testing.assert_array_equal(loaded.efforts, [[np.nan, 1.5]] * 3)
        loaded = JointTrajectory.load(tmp_path / "bag", ignore=["effort"])
        assert loaded.efforts is None


class TestSalvage:
    @pytest.mark.parametrize(
        ("kind", "share"),
        # The tree of a database that is cut off early lacks pages that lead to the others.
        [("mcap", 0.35), ("bare.mcap", 0.35), ("bare.mcap", 0.9), ("sqlite3", 0.9), ("bare.db3", 0.9)],
    )
    def test_a_bag_that_was_cut_off_is_read_up_to_the_cut(self, tmp_path, kind, share):
        trajectory = random_trajectory(rows=5000)
        path = save(trajectory, tmp_path, kind)
        file = next(entry for entry in path.iterdir() if entry.suffix != ".yaml") if path.is_dir() else path
        data = file.read_bytes()
        file.write_bytes(data[: int(len(data) * share)])
        with pytest.raises(QuadrupedError, match=r"the bag is damaged, cut off, .*byte \d+.*; keep .*\(--repair salv"):
            JointTrajectory.load(path)
        loaded = JointTrajectory.load(path, repair=["salvage"])
        # A page of sqlite3 or a block of zstd is lost as a whole.
        assert 5000 * (share - 0.15) < len(loaded) < 5000
        assert_same(loaded, trajectory.at(trajectory.stamps[: len(loaded)]))
        assert loaded.source.notes

    def test_a_ros_1_bag_that_was_cut_off_is_left_to_ros(self, tmp_path):
        path = write_ros1(tmp_path / "a.bag", random_trajectory(rows=1000))
        data = path.read_bytes()
        path.write_bytes(data[: len(data) // 2])
        for repair in ((), ("salvage",)):
            with pytest.raises(QuadrupedError, match=r"the bag is damaged, .*; repair it .* \(rosbag reindex .*\)"):
                JointTrajectory.load(path, repair=repair)

    def test_a_bag_in_wal_mode_whose_recorder_was_killed_is_read_whole_and_left_as_it_is(self, tmp_path):
        code = """
import os, signal, sqlite3, sys
from bags import JOINT_STATE, cdr, fields, write_bag
database = sqlite3.connect(sys.argv[1], isolation_level=None)
database.execute("PRAGMA journal_mode = WAL")
for i in range(1, 400):
    message = cdr.serialize(cdr.message(JOINT_STATE, **fields(i)))
    database.execute("INSERT INTO messages (topic_id, timestamp, data) VALUES (1, ?, ?)", (i, bytes(message)))
os.kill(os.getpid(), signal.SIGKILL)
"""
        bag = write_bag(tmp_path / "bag", [(0, fields(0))], "sqlite3")
        (file,) = bag.glob("*.db3")
        subprocess.run([sys.executable, "-c", code, file], env=importing(), check=False)
        before = {path.name: (path.read_bytes(), path.stat().st_mtime_ns) for path in bag.iterdir()}
        assert len(before[f"{file.name}-wal"][0]) > 100_000
        for path, repair in ((bag, ()), (file, ()), (file, ("salvage",))):
            loaded = JointTrajectory.load(path, repair=repair)
            assert loaded.stamps.tolist() == list(range(400))
            assert "db3-wal holds changes that are not in" in loaded.source.notes[0]
        assert before == {path.name: (path.read_bytes(), path.stat().st_mtime_ns) for path in bag.iterdir()}

    def test_a_database_with_damaged_pages_of_rows_gives_all_others_and_counts_those_that_it_lacks(self, tmp_path):
        trajectory = random_trajectory(rows=5000)
        path = save(trajectory, tmp_path, "bare.db3")
        with closing(sqlite3.connect(path)) as database:
            query = "SELECT pageno, pagetype, ncell FROM dbstat WHERE name = 'messages' ORDER BY path"
            pages = database.execute(query).fetchall()
        leaves = [(number, cells) for number, kind, cells in pages if kind == "leaf"]
        _, first_inner, *_ = [number for number, kind, _ in pages if kind == "internal"]
        data = path.read_bytes()
        for damaged in ([leaves[40][0]], [leaves[10][0], leaves[11][0], leaves[150][0]], [first_inner]):
            broken = bytearray(data)
            for number in damaged:
                broken[4096 * (number - 1) : 4096 * number] = b"\xff" * 4096
            path.write_bytes(broken)
            loaded = JointTrajectory.load(path, repair=["salvage"])
            assert 0 < len(loaded) < 5000
            kept = np.isin(trajectory.stamps, loaded.stamps)
            np.testing.assert_array_equal(loaded.positions, trajectory.positions[kept])
            notes = "; ".join(loaded.source.notes)
            assert "messages are damaged behind row" in notes
            if damaged != [first_inner]:  # of which the rows of all its pages are lost
                missing = sum(cells for number, cells in leaves if number in damaged)
                assert 5000 - missing <= len(loaded)
                assert f"left out {missing} rows of messages" in notes

    def test_a_damaged_chunk_is_left_out_by_its_checksum(self, tmp_path):
        trajectory = random_trajectory(rows=6000)
        path = save(trajectory, tmp_path, "bare.mcap")
        data = bytearray(path.read_bytes())
        data[len(data) // 2] ^= 1
        path.write_bytes(data)
        with pytest.raises(QuadrupedError, match=r"the bag is damaged.* byte \d+: .*checksum"):
            JointTrajectory.load(path)
        loaded = JointTrajectory.load(path, repair=["salvage"])
        assert 1500 < len(loaded) < 6000
        kept = np.isin(trajectory.stamps, loaded.stamps)
        np.testing.assert_array_equal(loaded.positions, trajectory.positions[kept])
        assert any("checksum" in note for note in loaded.source.notes)

    def test_messages_after_a_damaged_record_are_found(self, tmp_path):
        trajectory = random_trajectory(rows=8000)
        trajectory.save(tmp_path / "a.mcap")
        data = bytearray((tmp_path / "a.mcap").read_bytes())
        chunks, at = [], 8
        while at < len(data) - 8:
            chunks += [at] if data[at] == 0x06 else []
            at += 9 + struct.unpack_from("<Q", data, at + 1)[0]
        assert len(chunks) > 2
        data[chunks[1] + 8] = 0xFF  # the greatest byte of its length
        (tmp_path / "a.mcap").write_bytes(data)
        loaded = JointTrajectory.load(tmp_path / "a.mcap", repair=["salvage"])
        assert any(f"cut off or damaged from byte {chunks[1]} on" in note for note in loaded.source.notes)
        assert_same(loaded, trajectory)

    def test_damaged_messages_are_named_and_left_out(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(i, fields(i)) for i in range(20)], "sqlite3")
        (file,) = path.glob("*.db3")
        with sqlite3.connect(file) as database:
            database.execute("UPDATE messages SET data = substr(data, 1, 40) WHERE id = 6")
        with pytest.raises(QuadrupedError, match=r"message 5: 40 bytes do not hold .*; leave damaged messages"):
            JointTrajectory.load(path)
        loaded = JointTrajectory.load(path, repair=["salvage"])
        assert loaded.stamps.tolist() == [i for i in range(20) if i != 5]
        assert loaded.source.notes == (
            f"{UNCHECKED}: 19 of 20 messages",
            "left out 1 of 20: the message is damaged",
        )

    @pytest.mark.parametrize(("kind", "checked"), [("bare.mcap", True), ("bare.db3", False)])
    def test_messages_that_were_salvaged_without_a_checksum_are_counted(self, tmp_path, kind, checked):
        trajectory = random_trajectory(rows=60, positions=np.full((60, 8), -0.5), velocities=None)
        path = save(trajectory, tmp_path, kind)
        notes = JointTrajectory.load(path, repair=["salvage"]).source.notes
        assert notes == (() if checked else (f"{UNCHECKED}: 60 of 60 messages",))
        # Without the repair the index has to be whole, and nothing is said.
        assert JointTrajectory.load(path).source.notes == ()

    def test_load_of_an_mcap_whose_chunks_lack_checksums_marks_their_messages(self, tmp_path):
        trajectory = random_trajectory(rows=60, positions=np.full((60, 8), -0.5), velocities=None)
        path = save(trajectory, tmp_path, "bare.mcap")
        data = bytearray(path.read_bytes())
        at = 8
        while data[at] != 0x06:
            at += 9 + struct.unpack_from("<Q", data, at + 1)[0]
        data[at + 9 + 24 : at + 9 + 28] = bytes(4)
        path.write_bytes(data)
        loaded = JointTrajectory.load(path, repair=["salvage"])
        assert_same(loaded, trajectory)
        assert loaded.source.notes == (f"{UNCHECKED}: 60 of 60 messages",)

    def test_progress_of_reading_grows_to_one(self, tmp_path):
        random_trajectory(rows=5000).save(tmp_path / "a.mcap")
        shares = []
        assert JointTrajectory.load(tmp_path / "a.mcap", progress=shares.append).source.row(4096).endswith("ge 4096")
        assert (shares, shares[-1]) == (sorted(shares), 1.0)
        assert len(shares) > 4

    def test_degrees_are_not_converted_twice(self, tmp_path):
        path = write_bag(tmp_path / "bag", [(0, fields(position=(90, 45)))])
        joint_map = JointMap({"x": JointRule("a", unit="deg")})
        assert JointTrajectory.load(path, joint_map=joint_map).positions.tolist() == [[np.pi / 2]]
        with pytest.raises(
            QuadrupedError, match=r"\[joints\.x\] has units of its own, so --unit deg would convert them twice"
        ):
            JointTrajectory.load(path, joint_map=joint_map, unit="deg")
