"""Output of `ros2 topic echo`, and CSVs with other columns."""

import re

import numpy as np
import pytest

from quadruped_env import JointTrajectory, QuadrupedError

yaml = pytest.importorskip("yaml")

BLOCK = """header:
  stamp:
    sec: 1700000000
    nanosec: 50000000
  frame_id: ''
name:
- LF_hip_joint
- LF_knee_joint
position:
- 0.1
- -1e-05
velocity: []
effort:
- .nan
- 2.5
---
"""
FLOW = """header:
  stamp: {sec: 1700000000, nanosec: 100000000}
  frame_id: base_link
name: [LF_hip_joint, LF_knee_joint]
position: [0.3, -0.4]
velocity: []
effort: [1, .inf]
---
"""
LOST = "A message was lost!!!\n\ttotal count change:1\n\ttotal count: 1---\n"
LINE = "1700000000,50000000,,LF_hip_joint,LF_knee_joint,0.1,-1e-05,,nan,2.5\n"


def load(path, text, **options):
    path.write_text(text)
    return JointTrajectory.load(path, **options)


class TestYaml:
    @pytest.mark.parametrize("text", [BLOCK, "---\n" + BLOCK, BLOCK.removesuffix("---\n"), BLOCK.replace("''", '""')])
    def test_one_message(self, tmp_path, text):
        loaded = load(tmp_path / "echo.yaml", text)
        assert loaded.stamps.tolist() == [1_700_000_000_050_000_000]
        assert loaded.names == ("LF_hip_joint", "LF_knee_joint")
        assert loaded.positions.tolist() == [[0.1, -1e-05]]
        assert loaded.velocities is None
        np.testing.assert_array_equal(loaded.efforts, [[np.nan, 2.5]])

    def test_messages_in_both_styles_and_a_lost_one(self, tmp_path):
        loaded = load(tmp_path / "a", BLOCK + LOST + FLOW.replace(".inf", "3.5"))
        assert loaded.positions.tolist() == [[0.1, -1e-05], [0.3, -0.4]]
        assert loaded.source.notes == ("the recording itself says that messages were lost",)
        assert loaded.source.row(1).endswith("message 1")

    @pytest.mark.parametrize("text", [BLOCK.replace("2.5\n---", "2.5---"), FLOW.replace("inf]\n---", "inf]---")])
    def test_a_separator_at_the_end_of_a_value_is_damage(self, tmp_path, text):
        for damaged in (
            text,
            BLOCK + text,
            BLOCK + LOST + text,
            text.replace("---", "--- ").replace("2.5", "-0.7944---"),
        ):
            with pytest.raises(
                QuadrupedError, match=r"a: line \d+: '.*---' ends in ---, which .* may be cut off; fix it"
            ):
                load(tmp_path / "a", damaged)

    def test_a_recording_may_begin_with_a_lost_message(self, tmp_path):
        assert len(load(tmp_path / "a", LOST + BLOCK)) == 1

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            (BLOCK + BLOCK, r"message 1, stamp_ns: .* does not come after"),
            (BLOCK.replace("- 0.1\n", ""), r"message 0: 2 names and 1 positions"),
            (
                BLOCK.replace("- 2.5\n", "- 2.5\n- '...'\n"),
                r"message 0: an array is shortened to '\.\.\.'; .*--full-length",
            ),
            (BLOCK.replace("effort:", "position:"), r"message 0: the message must have .*effort; found .*position"),
            (BLOCK.replace("velocity: []\n", ""), r"message 0: the message must have header, name, position, velocity"),
            (BLOCK.replace("0.1", "O.1"), r"message 0: position: 'O\.1' is not a number"),
            (BLOCK.replace("- 0.1", "- [0.1]"), r"message 0: position must hold single values"),
            (BLOCK.replace("50000000", "1000000000"), r"message 0: .* s and 1000000000 ns are not a valid timestamp"),
            (BLOCK.replace("- .nan", "- : ]"), r"message 0: .*; expected what ros2 topic echo prints"),
            ("header:\n" + " x" * 600_000 + "\n", r"a message of over 1000000 characters is no joint state"),
        ],
    )
    def test_damage_is_named(self, tmp_path, text, message):
        path = tmp_path / "echo.yaml"
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: {message}"):
            load(path, text)

    def test_load_message_of_efforts_alone_is_called_torque_only(self, tmp_path):
        torques = FLOW.replace("[0.3, -0.4]", "[]").replace(".inf", "2")
        with pytest.raises(
            QuadrupedError, match=r"message 0: torque-only: efforts and no positions.*\(--repair drop\)"
        ):
            load(tmp_path / "a", torques)
        loaded = load(tmp_path / "a", BLOCK + torques, repair=["drop"])
        assert len(loaded) == 1
        assert loaded.source.notes[0].startswith("left out 1 of 2: torque-only: ")

    def test_damage_at_the_end_is_salvaged(self, tmp_path):
        loaded = load(tmp_path / "a", BLOCK + FLOW[:40], repair=["salvage"])
        assert len(loaded) == 1
        end, damage, unchecked = loaded.source.notes
        assert "the last line does not end" in end
        assert damage.startswith("damaged, and read up to the damage: ")
        assert unchecked.endswith("damage in their numbers would not show: 1 of 1 messages")


class TestCsv:
    def test_one_message_per_line(self, tmp_path):
        second = LINE.replace("50000000", "60000000").replace("0.1", "7")
        loaded = load(tmp_path / "echo.csv", LINE + LOST + second)
        assert loaded.stamps.tolist() == [1_700_000_000_050_000_000, 1_700_000_000_060_000_000]
        assert loaded.names == ("LF_hip_joint", "LF_knee_joint")
        assert loaded.positions.tolist() == [[0.1, -1e-05], [7, -1e-05]]
        assert loaded.velocities is None
        np.testing.assert_array_equal(loaded.efforts, [[np.nan, 2.5]] * 2)

    def test_messages_without_names_need_them(self, tmp_path):
        text = "1,0,,,0.1,0.2,0.3,,\n"
        with pytest.raises(QuadrupedError, match=r"line 1: 3 positions and no names: give .*\(--names\)"):
            load(tmp_path / "a", text)
        assert load(tmp_path / "a", text, names=["x", "y", "z"]).positions.tolist() == [[0.1, 0.2, 0.3]]
        full = load(tmp_path / "a", "1,0,,,0.1,0.2,3,4,5,6\n", names=["x", "y"])
        assert (full.velocities.tolist(), full.efforts.tolist()) == ([[3, 4]], [[5, 6]])

    @pytest.mark.parametrize(
        ("line", "message"),
        [
            (LINE.replace(",2.5", ""), r"line 1: 2 joints and 1 numbers for effort"),
            (LINE.replace("\n", ",1\n"), r"line 1: there are 1 fields more than 2 joints need"),
            (LINE.replace("2.5", "..."), r"line 1: an array is shortened to '\.\.\.'"),
            (LINE.removesuffix(",2.5\n"), r"line 1: 2 joints and 1 numbers for effort"),
            (LINE + "\n", r"line 2: 1 fields are too few"),
        ],
    )
    def test_damage_is_named(self, tmp_path, line, message):
        path = tmp_path / "echo.csv"
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: {message}"):
            load(path, line)


COLUMNS = """
[columns]
stamp = "time"
positions = { LF_hip_joint = "hip", LF_knee_joint = "knee" }
"""
TABLE = 'time,mode,knee,hip\n1700000000.123456789,walk,-0.5,0.25\n1700000000.2,"a, b",-0.6,0.35\n'


class TestColumns:
    def test_any_csv_with_a_map(self, tmp_path):
        (tmp_path / "map.toml").write_text(COLUMNS)
        loaded = load(tmp_path / "a.csv", TABLE, columns=tmp_path / "map.toml")
        assert loaded.stamps.tolist() == [1_700_000_000_123_456_789, 1_700_000_000_200_000_000]
        assert loaded.names == ("LF_hip_joint", "LF_knee_joint")
        assert loaded.positions.tolist() == [[0.25, -0.5], [0.35, -0.6]]

    @pytest.mark.parametrize(("unit", "text", "stamp"), [("ms", "1.5", 1_500_000), ("us", "7", 7000), ("ns", "3", 3)])
    def test_units_of_time(self, tmp_path, unit, text, stamp):
        (tmp_path / "map.toml").write_text(f'{COLUMNS}stamp_unit = "{unit}"\nseparator = ";"\n')
        loaded = load(tmp_path / "a.csv", f"time;hip;knee\n{text};0;0\n", columns=tmp_path / "map.toml")
        assert loaded.stamps.tolist() == [stamp]

    def test_velocities_in_a_file_of_their_own(self, tmp_path):
        (tmp_path / "map.toml").write_text(f'{COLUMNS}velocity_files = {{ "a.csv" = "speed.csv" }}\n')
        speeds = "time,hip,knee\n1700000000.123456789,1,2\n1700000000.2,3,4\n"
        (tmp_path / "speed.csv").write_text(speeds)
        loaded = load(tmp_path / "a.csv", TABLE, columns=tmp_path / "map.toml")
        assert loaded.velocities.tolist() == [[1, 2], [3, 4]]
        for wrong in (speeds.replace("0.2", "0.3"), "".join(speeds.splitlines(True)[:2]), speeds + "1700000001,3,4\n"):
            (tmp_path / "speed.csv").write_text(wrong)
            with pytest.raises(QuadrupedError, match=r"a\.csv: speed\.csv must have the same timestamps"):
                load(tmp_path / "a.csv", TABLE, columns=tmp_path / "map.toml")
        (tmp_path / "speed.csv").unlink()
        with pytest.raises(QuadrupedError, match=r"speed\.csv: there is no such file"):
            load(tmp_path / "a.csv", TABLE, columns=tmp_path / "map.toml")

    def test_load_velocities_of_another_file_and_efforts_keep_the_order_of_columns(self, tmp_path):
        (tmp_path / "map.toml").write_text(
            "[columns]\nstamp = 't'\npositions.a = 'q'\nefforts.a = 'e'\nvelocities.a = 'w'\n"
            "velocity_files = { 'a.csv' = 'w.csv' }\n"
        )
        (tmp_path / "a.csv").write_text("t,q,e\n1,2,3\n")
        (tmp_path / "w.csv").write_text("t,w\n1,4\n")
        JointTrajectory.load(tmp_path / "a.csv", columns=tmp_path / "map.toml").save(tmp_path / "b.csv")
        expected = "stamp_ns,position.a,velocity.a,effort.a\n1000000000,2.0,4.0,3.0\n"
        assert (tmp_path / "b.csv").read_text() == expected

    @pytest.mark.parametrize(("damaged", "kept"), [("a.csv", 4500), ("w.csv", 4500), (None, 5000)])
    def test_load_salvage_of_two_files_keeps_the_rows_before_the_damage(self, tmp_path, damaged, kept):
        (tmp_path / "map.toml").write_text(
            "[columns]\nstamp = 1\npositions.a = 2\nvelocity_files = { 'a.csv' = 'w.csv' }\n"
        )
        for name in ("a.csv", "w.csv"):
            lines = [f"{i},0.5\n" for i in range(5000)]
            if name == damaged:
                lines[4500] = "4500,x\n"
            (tmp_path / name).write_text("".join(lines))
        loaded = JointTrajectory.load(tmp_path / "a.csv", columns=tmp_path / "map.toml", repair=["salvage"])
        assert len(loaded) == kept
        if damaged is not None:
            place = (
                f"damaged, and read up to the damage: {tmp_path / damaged}: line 4501, column 2: 'x' is not a number"
            )
            assert loaded.source.notes[0].startswith(place)

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("", r"the file is empty"),
            ("time,hip\n", r"line 1: no column 'knee', which .* positions names; found time, hip"),
            ("time,hip,knee,hip\n", r"line 1: two columns 'hip'"),
            ("time,hip,knee\n", r"there is a header and no row"),
            ("time,hip,knee\n0,1\n", r"line 2: expected 3 columns, as in the header; found 2"),
            ("time,hip,knee\n0,1,x\n", r"line 2, knee: 'x' is not a number"),
            ("time,hip,knee\nnoon,1,2\n", r"line 2, time: 'noon' is not a time in s"),
            ("time,hip,knee\n0,1", r"line 2: expected 3 columns, .* keep the lines before it \(--repair salvage\)"),
            ('time,hip,knee\n0,"1"x,2\n', r"line 2: .*; fix the line"),
        ],
    )
    def test_damage_is_named(self, tmp_path, text, message):
        (tmp_path / "map.toml").write_text(COLUMNS)
        path = tmp_path / "a.csv"
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: {message}"):
            load(path, text, columns=tmp_path / "map.toml")

    @pytest.mark.parametrize(
        "given",
        [
            'stamp = "t"\npositions = ["q0", "q1"]\nheader = ["t", "mode", "q0", "q1"]',
            "stamp = 1\npositions = { q0 = 3, q1 = 4 }",
            'stamp = 1\npositions = { q0 = "x", q1 = 4 }\nheader = ["t", "mode", "x", "y"]',
            "stamp = 1\npositions = { q0 = 3, q1 = 4 }\nheader = false",
        ],
    )
    def test_load_without_a_header_line_reads_the_first_line_as_a_row(self, tmp_path, given):
        (tmp_path / "map.toml").write_text(f"[columns]\n{given}\n")
        loaded = load(tmp_path / "a.csv", "0.5,walk,1,2\n0.6,walk,3,4\n", columns=tmp_path / "map.toml")
        assert loaded.stamps.tolist() == [500_000_000, 600_000_000]
        assert (loaded.names, loaded.positions.tolist()) == (("q0", "q1"), [[1, 2], [3, 4]])
        assert loaded.source.row(0).endswith("line 1")

    def test_load_column_numbers_with_a_header_line_skip_it(self, tmp_path):
        (tmp_path / "map.toml").write_text("[columns]\nstamp = 1\npositions.q = 2\nheader = true\n")
        assert load(tmp_path / "a.csv", "t,x\n1,2\n", columns=tmp_path / "map.toml").positions.tolist() == [[2]]

    @pytest.mark.parametrize(
        ("given", "text", "message"),
        [
            ("stamp = 1\npositions.q = 3", "0,1\n", r"line 1: no column 3, which .* positions asks for; found 2"),
            ("stamp = 1\npositions.q = 2", "t,x\n0,1\n", r"line 1, column 1: 't' is not a time in s"),
            ("stamp = 1\npositions.q = 2", "0,1\n0.1\n", r"line 2: expected 2 columns"),
            ("stamp = 't'\npositions = ['q']\nheader = ['t', 'q']", "0,1,2\n", r"line 1: expected 2 columns.*found 3"),
            ("stamp = 't'\npositions = ['q']", "0,1\n", r"line 1: no column 't'.*header = \[\.\.\.\]"),
        ],
    )
    def test_load_with_a_wrong_header_names_the_place(self, tmp_path, given, text, message):
        (tmp_path / "map.toml").write_text(f"[columns]\n{given}\n")
        path = tmp_path / "a.csv"
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: {message}"):
            load(path, text, columns=tmp_path / "map.toml")

    MARKED = """
    [columns]
    stamp = "t"
    positions = { a = "qa", b = "qb" }
    efforts = { a = "ta", b = "tb" }
    missing = [2.146e9, "-"]
    """

    def test_load_values_marked_as_missing_are_not_recorded(self, tmp_path):
        (tmp_path / "map.toml").write_text(self.MARKED)
        text = "t,qa,qb,ta,tb\n0,0.1,0.2,2146000000.0,1\n1,0.3,0.4, - ,2\n2,2.146e+09,0.5,3,4\n3,-2.146e9,0.5,3,4\n"
        path = tmp_path / "a.csv"
        unnamed = tmp_path / "unnamed.toml"
        unnamed.write_text(self.MARKED.replace("missing", "# missing"))
        with pytest.raises(QuadrupedError, match=r"degrees.*; if it marks a missing value.*\(missing = 2\.146e\+09\)"):
            load(path, text.replace(" - ", "1"), columns=unnamed)
        with pytest.raises(
            QuadrupedError, match=r"line 4, position\.a: nan is not finite; leave the row out \(--repair drop\)"
        ):
            load(path, text, columns=tmp_path / "map.toml")
        loaded = load(path, text, columns=tmp_path / "map.toml", repair=["drop"], unit="rad")
        assert loaded.positions.tolist() == [[0.1, 0.2], [0.3, 0.4], [-2.146e9, 0.5]]
        np.testing.assert_array_equal(loaded.efforts, [[np.nan, 1], [np.nan, 2], [3, 4]])
        assert loaded.source.notes == (
            "3 values that the column map marks as missing: read as not recorded (NaN)",
            "left out 1 of 4: a number is not finite, or a timestamp is negative",
        )

    def test_load_rows_without_any_position_are_torque_only(self, tmp_path):
        (tmp_path / "map.toml").write_text(self.MARKED)
        text = "t,qa,qb,ta,tb\n0,0.1,0.2,3,1\n1,2.146e9,2.146e9,3,2\n"
        with pytest.raises(QuadrupedError, match=r"line 3: torque-only: .*\(--repair drop\)"):
            load(tmp_path / "a.csv", text, columns=tmp_path / "map.toml")
        loaded = load(tmp_path / "a.csv", text, columns=tmp_path / "map.toml", repair=["drop"])
        assert len(loaded) == 1
        assert loaded.source.notes[-1].startswith("left out 1 of 2: torque-only: ")

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("[columns]\n", r"\[columns\]: positions is missing; add it"),
            (
                "[columns]\nstamp = 'a'\npositions = []\n",
                r"positions: expected each joint of the positions once, .*; found \[\]",
            ),
            (
                "[columns]\nstamp = 'a'\npositions = ['b', 'b']\n",
                r"positions: expected each joint of the positions once",
            ),
            (
                "[columns]\nstamp = 0\npositions = ['b']\n",
                r"stamp: expected a name, or a number from 1 on; found 0",
            ),
            (
                "[columns]\nstamp = 'a'\npositions = ['b']\nstamp_unit = 'h'\n",
                r"stamp_unit: expected 's' or 'ms' or 'us' or 'ns'; found 'h'",
            ),
            (
                "[columns]\nstamp = 'a'\npositions = ['b']\nvelocity_files.a = '../b'\n",
                r"velocity_files: expected files in the same directory",
            ),
            ("[columns]\nstamp = 'a'\npositions = ['b']\nfoo = 1\n", r"unknown key 'foo'; known are stamp, positions"),
        ],
    )
    def test_mistakes_in_the_map_are_named(self, tmp_path, text, message):
        path = tmp_path / "map.toml"
        path.write_text(text)
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: .*{message}"):
            load(tmp_path / "a.csv", TABLE, columns=path)


class TestArrays:
    BLOCK = "layout:\n  dim: []\n  data_offset: 0\ndata:\n- 0.25\n- -0.5\n---\n"
    FLOW = "layout: {dim: [], data_offset: 0}\ndata: [0.25, -0.5]\n---\n"

    @pytest.mark.parametrize("text", [BLOCK, FLOW])
    def test_arrays_need_names_and_a_period(self, tmp_path, text):
        path, names = tmp_path / "a", ["x", "y"]
        loaded = load(path, 3 * text, names=names, stamps=0.02)
        assert (loaded.names, loaded.stamps.tolist()) == (("x", "y"), [0, 20_000_000, 40_000_000])
        assert loaded.positions.tolist() == [[0.25, -0.5]] * 3
        with pytest.raises(QuadrupedError, match=r"an array has no timestamp: .*\(--stamps 0\.02\)"):
            load(path, text, names=names)
        with pytest.raises(QuadrupedError, match=r"2 positions and no names: .*\(--names\)"):
            load(path, text, stamps=0.02)


def test_yaml_of_ros1_is_read(tmp_path):
    text = (
        BLOCK.replace("    sec:", "    secs:")
        .replace("    nanosec:", "    nsecs:")
        .replace("header:", "header: \n  seq: 7")
    )
    assert load(tmp_path / "a", text).stamps.tolist() == [1_700_000_000_050_000_000]
