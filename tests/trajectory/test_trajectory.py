import re

import numpy as np
import pytest
from trajectories import STAMPS, assert_same, random_trajectory

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError, QuadrupedWarning


class TestType:
    def test_rows_are_joint_states(self):
        trajectory = random_trajectory()
        assert len(trajectory) == len(list(trajectory)) == 4
        state = trajectory[1]
        assert (state.stamp, state.names) == (STAMPS[1], JOINT_NAMES)
        np.testing.assert_array_equal(state.position, trajectory.positions[1])
        np.testing.assert_array_equal(state.velocity, trajectory.velocities[1])
        np.testing.assert_array_equal(state.effort, trajectory.efforts[1])
        assert trajectory[-1].stamp == STAMPS[-1]
        assert random_trajectory(velocities=None, efforts=None)[0].velocity is None
        with pytest.raises(IndexError):
            trajectory[4]

    def test_time_counts_from_the_first_timestamp(self):
        trajectory = random_trajectory()
        np.testing.assert_array_equal(trajectory.times, [0.0, 0.020000002, 0.049999999, 0.999999999])
        assert trajectory.duration == 0.999999999
        assert repr(trajectory) == "JointTrajectory(4 rows over 1 s, 8 joints, positions and velocities and efforts)"

    def test_arrays_are_copies_and_read_only(self):
        positions = np.zeros((4, 8))
        trajectory = random_trajectory(positions=positions)
        positions[:] = 1.0
        assert not trajectory.positions.any()
        for name in ("stamps", "positions", "velocities", "efforts", "times"):
            with pytest.raises(ValueError, match="read-only"):
                getattr(trajectory, name)[0] = 0
        with pytest.raises(ValueError, match="read-only"):
            trajectory[0].position[0] = 0
        with pytest.raises(AttributeError):
            trajectory.names = ()

    @pytest.mark.parametrize(
        ("changes", "message"),
        [
            ({"stamps": STAMPS[:3]}, r"positions .*shape \(3, 8\).*found \(4, 8\); leave out"),
            ({"velocities": np.zeros((4, 7))}, r"velocities .*shape \(4, 8\).*found \(4, 7\)"),
            ({"positions": [["a"] * 8] * 4}, r"positions .*not numbers"),
            ({"names": [*JOINT_NAMES[:7], "LF_hip_joint"]}, r"'LF_hip_joint' is named twice; keep one"),
            ({"names": "LF_hip_joint"}, r"names must be joint names"),
            ({"stamps": []}, r"stamps: expected shape \(T,\).*found \(0,\)"),
            ({"stamps": [0.0, 0.1, 0.2, 0.3]}, r"stamps: expected whole ns .*found float64; from seconds: np.rint"),
            ({"stamps": [-1, 1, 2, 3]}, r"row 0, stamp_ns: -1 is negative; count from 0"),
            ({"stamps": [0, 2, 1, 3]}, r"row 2, stamp_ns: 1 does not come after 2 .*sort the rows by time"),
        ],
    )
    def test_bad_arguments_are_named(self, changes, message):
        good = random_trajectory()
        arguments = {name: getattr(good, name) for name in ("stamps", "names", "positions", "velocities", "efforts")}
        with pytest.raises(QuadrupedError, match=f"^JointTrajectory: .*{message}"):
            JointTrajectory(**(arguments | changes))

    @pytest.mark.parametrize("value", [np.nan, -np.inf])
    @pytest.mark.parametrize(
        ("field", "singular"), [("positions", "position"), ("velocities", "velocity"), ("efforts", "effort")]
    )
    def test_numbers_must_be_finite_but_an_effort_may_be_unknown(self, field, singular, value):
        values = np.zeros((4, 8))
        values[2, 3] = value
        if field == "efforts" and np.isnan(value):
            assert np.isnan(random_trajectory(efforts=values).efforts[2, 3])
        else:
            with pytest.raises(QuadrupedError, match=rf"row 2, {singular}\.RF_knee_joint: {value} is not finite; \w"):
                random_trajectory(**{field: values})


class TestJointOrder:
    def test_columns_follow_their_names(self):
        trajectory = random_trajectory(names=JOINT_NAMES[::-1])
        ordered = trajectory.in_joint_order()
        assert ordered.names == JOINT_NAMES
        np.testing.assert_array_equal(ordered.positions, trajectory.positions[:, ::-1])
        np.testing.assert_array_equal(ordered.velocities, trajectory.velocities[:, ::-1])
        np.testing.assert_array_equal(ordered.efforts, trajectory.efforts[:, ::-1])
        np.testing.assert_array_equal(trajectory.positions_at(0.0), trajectory.positions[0])

    def test_joints_of_other_robots_are_left_out_with_a_warning(self):
        trajectory = random_trajectory(names=["wheel", *JOINT_NAMES, "RH_ankle_joint"])
        with pytest.warns(QuadrupedWarning, match=r"left out joints .* does not have: wheel, RH_ankle_joint"):
            ordered = trajectory.in_joint_order()
        assert ordered.names == JOINT_NAMES
        np.testing.assert_array_equal(ordered.efforts, trajectory.efforts[:, 1:-1])

    def test_missing_joints_are_named(self):
        with pytest.raises(QuadrupedError, match=r"joint 'RH_knee_joint' is missing; all 8 .*RH_hip_joint; add"):
            random_trajectory(names=JOINT_NAMES[:7]).in_joint_order()


class TestPositionsAt:
    def test_straight_lines_between_rows(self):
        trajectory = random_trajectory()
        seconds = np.linspace(-0.1, 1.1, 1001)
        expected = [np.interp(seconds, trajectory.times, column) for column in trajectory.positions.T]
        np.testing.assert_allclose(trajectory.positions_at(seconds), np.transpose(expected), rtol=0, atol=1e-12)

    def test_holds_the_ends(self):
        trajectory = random_trajectory()
        for early in (-1.0, -np.inf):
            np.testing.assert_array_equal(trajectory.positions_at(early), trajectory.positions[0])
        for late in (1.0, 1e9, np.inf):
            np.testing.assert_array_equal(trajectory.positions_at(late), trajectory.positions[-1])

    def test_keeps_the_shape_of_the_times(self):
        trajectory = random_trajectory(rows=1)
        for shape in ((), (3,), (2, 0), (2, 3)):
            at = trajectory.positions_at(np.zeros(shape))
            np.testing.assert_array_equal(at, np.broadcast_to(trajectory.positions[0], (*shape, 8)))

    @pytest.mark.parametrize("timestep", [0.02, 0.05, 0.005 * 3, 1 / 30])
    def test_rows_come_back_to_the_last_bit_on_a_floating_point_clock(self, timestep):
        steps = np.arange(5000)
        trajectory = random_trajectory(
            rows=5000, stamps=np.rint(steps * timestep * 1e9).astype(np.int64), velocities=None, efforts=None
        )
        exact = steps if timestep != 1 / 30 else steps[::3]  # a third of a ns is not a timestamp
        np.testing.assert_array_equal(trajectory.positions_at(exact * timestep), trajectory.positions[exact])

    def test_nan_as_a_time_is_refused(self):
        with pytest.raises(QuadrupedError, match="NaN"):
            random_trajectory().positions_at([0.0, np.nan])


def write(path, *lines):
    path.write_text("".join(lines))
    return path


HEADER = ",".join(["stamp_ns", *(f"position.{name}" for name in JOINT_NAMES)]) + "\n"
ROW = "0" + ",-0.5" * 8 + "\n"


class TestCsv:
    @pytest.mark.parametrize("velocities", [True, False])
    @pytest.mark.parametrize("efforts", [True, False])
    def test_round_trip_to_the_last_bit(self, tmp_path, velocities, efforts):
        changes = {} if velocities else {"velocities": None}
        trajectory = random_trajectory(**(changes if efforts else changes | {"efforts": None}))
        trajectory.save(tmp_path / "new" / "a.csv")
        loaded = JointTrajectory.load(tmp_path / "new" / "a.csv")
        assert_same(loaded, trajectory)
        loaded.save(str(tmp_path / "b.csv"))
        assert (tmp_path / "b.csv").read_bytes() == (tmp_path / "new" / "a.csv").read_bytes()

    def test_round_trip_of_awkward_numbers(self, tmp_path):
        numbers = [0.1 + 0.2, 5e-324, -0.0, 1.7976931348623157e308, 1 / 3, -1e-5, 123456789.0, np.nextafter(1, 2)]
        trajectory = JointTrajectory([0], [f"joint {i}é.x" for i in range(8)], [numbers])
        trajectory.save(tmp_path / "a.csv")
        with pytest.raises(
            QuadrupedError, match=r"1\.79769e\+308 rad is more than two turns: .*--unit deg.*--unit rad"
        ):
            JointTrajectory.load(tmp_path / "a.csv")
        assert_same(JointTrajectory.load(tmp_path / "a.csv", unit="rad"), trajectory)

    def test_is_the_documented_format(self, tmp_path):
        JointTrajectory([5], ["a", "b"], [[0.1, 0.2]], [[1.0, 2.0]], [[np.nan, 3.0]]).save(tmp_path / "a.csv")
        text = "stamp_ns,position.a,position.b,velocity.a,velocity.b,effort.a,effort.b\n5,0.1,0.2,1.0,2.0,nan,3.0\n"
        assert (tmp_path / "a.csv").read_text() == text

    def test_columns_may_come_in_any_order_and_from_a_spreadsheet(self, tmp_path):
        path = tmp_path / "a.csv"
        path.write_bytes(b"\xef\xbb\xbfstamp_ns,velocity.b,position.a,velocity.a,position.b\r\n5, 1,2 ,3e0,4\r\n")
        loaded = JointTrajectory.load(path)
        assert loaded.names == ("a", "b")
        assert (loaded.positions.tolist(), loaded.velocities.tolist()) == ([[2.0, 4.0]], [[3.0, 1.0]])

    def test_existing_file_without_overwrite_is_refused(self, tmp_path):
        path = tmp_path / "a.csv"
        path.write_text("precious")
        with pytest.raises(QuadrupedError, match=rf"{re.escape(str(path))}: exists already; name another"):
            random_trajectory().save(path)
        assert path.read_text() == "precious"
        random_trajectory().save(path, overwrite=True)
        assert_same(JointTrajectory.load(path), random_trajectory())
        assert [entry.name for entry in tmp_path.iterdir()] == ["a.csv"]

    def test_target_that_cannot_be_written_is_named(self, tmp_path):
        write(tmp_path / "file", "")
        for name, message in {
            "a.bag": r"a\.bag: unknown ending '\.bag'; a CSV ends in \.csv",
            "file/a.csv": r"a\.csv: cannot be written \(.+\); .*name another",
        }.items():
            with pytest.raises(QuadrupedError, match=message):
                random_trajectory().save(tmp_path / name)
        for name in ("a,b", 'a"b', "a\nb", "a\n"):
            with pytest.raises(QuadrupedError, match="cannot stand in a CSV header; rename"):
                JointTrajectory([0], [name], [[0.0]]).save(tmp_path / "a.csv")

    @pytest.mark.parametrize(
        ("lines", "message"),
        [
            ([], r"the file is empty; record again"),
            ([HEADER], r"there is a header and no row; .*record again"),
            (["\n"], r"text that begins with '' is not a recording of joint states; known are"),
            (["time,position.a\n", "0,0\n"], r"begins with 'time,position\.a'; .*a column map .*\(--columns FILE\)"),
            (["0,0.1,0.2\n"], r"text that begins with '0,0\.1,0\.2'; if it is a CSV of other columns"),
            (["stamp_ns_,position.a\n"], r"line 1, .*must be 'stamp_ns'; found 'stamp_ns_'"),
            (["stamp_ns\n", "0\n"], r"line 1, .*no position column"),
            (["stamp_ns,effort.a\n", "0,1\n"], r"line 1, .*torque-only: efforts and no positions"),
            (["stamp_ns,position.a,stamp_ns\n"], r"line 1, .*column 'stamp_ns' is unknown"),
            (["stamp_ns,position.a,position.a\n"], r"line 1: two columns 'position\.a', which .* positions names"),
            (
                ["stamp_ns,position.a,position.b,effort.a\n"],
                r"line 1, .*efforts: expected each joint of the positions once, .*; found {'a': ",
            ),
            (
                ["stamp_ns,position.a,velocity.a,velocity.b\n"],
                r"line 1, .*velocities: expected each joint of the positions once, .*; found {'a': .*'b': ",
            ),
            (
                [HEADER, ROW, ROW[:10] + "\n"],
                r"line 3: expected 9 columns.*found 3; .*keep the lines before it \(--repair salvage\)",
            ),
            ([HEADER, ROW.replace("\n", ",1\n"), ROW], r"line 2: expected 9 columns.*found 10"),
            ([HEADER, ROW.replace("0,", "0x0,", 1)], r"line 2, stamp_ns: '0x0' is not a time in ns; fix"),
            ([HEADER, "1" * 5000 + ROW[1:]], r"line 2, stamp_ns: '1{40}\.\.\.' is not a time"),
            ([HEADER, ROW, "1,-0.5,x" + ",-0.5" * 6 + "\n"], r"line 3, position\.LF_knee_joint: 'x' is not a number"),
            ([HEADER, "0" + ",-0.5" * 7 + ",٣\n"], r"line 2, position\.RH_knee_joint: '٣' is not a number"),
            ([HEADER, "0" + ",-0.5" * 7 + ",nan\n"], r"line 2, position\.RH_knee_joint: nan is not finite; leave"),
            (
                ["stamp_ns,position.a,velocity.a\n", "0,0,nan\n"],
                r"line 2, velocity\.a: nan is not finite; leave the velocities out",
            ),
            (["stamp_ns,position.a,effort.a\n", "0,0,inf\n"], r"line 2, effort\.a: inf is not finite; NaN stands"),
            ([HEADER, "7" + ROW[1:], "8" + ROW[1:], ROW], r"line 4, stamp_ns: 0 does not come after 8"),
        ],
    )
    def test_damage_is_named_with_file_line_field_and_fix(self, tmp_path, lines, message):
        path = write(tmp_path / "a.csv", *lines)
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: .*{message}"):
            JointTrajectory.load(path)

    def test_load_salvage_keeps_the_lines_before_the_damage(self, tmp_path):
        lines = [HEADER, *(f"{i}" + ROW[1:] for i in range(5000)), "5000,-0.5"]
        loaded = JointTrajectory.load(write(tmp_path / "long.csv", *lines), repair=["salvage"])
        assert loaded.stamps.tolist() == list(range(5000))
        loaded = JointTrajectory.load(write(tmp_path / "short.csv", *lines[:4], *lines[-1:]), repair=["salvage"])
        assert loaded.stamps.tolist() == [0, 1, 2]
        end, damage, unchecked = loaded.source.notes
        assert end == "line 5: the last line does not end, so its last value, '-0.5', may be cut off"
        assert damage.startswith(f"damaged, and read up to the damage: {tmp_path / 'short.csv'}: line 5: ")
        assert unchecked.endswith("3 of 3 lines")
        cell = JointTrajectory.load(write(tmp_path / "cell.csv", *lines[:3], "2,-0.5,x" + ROW[10:]), repair=["salvage"])
        assert cell.stamps.tolist() == [0, 1]
        with pytest.raises(QuadrupedError, match=r"none\.csv: line 2: expected 9 columns"):
            JointTrajectory.load(write(tmp_path / "none.csv", HEADER, "0,1\n"), repair=["salvage"])

    def test_what_cannot_be_read_is_named(self, tmp_path):
        with pytest.raises(QuadrupedError, match=r"gone\.csv: there is no such file; check"):
            JointTrajectory.load(tmp_path / "gone.csv")
        with pytest.raises(QuadrupedError, match=r"the directory is not a bag; expected metadata\.yaml"):
            JointTrajectory.load(tmp_path)
        (tmp_path / "a.csv").write_bytes(b"\x89PNG\r\n\x1a\n\xff\xfe")
        with pytest.raises(QuadrupedError, match=r"a\.csv: not a text file .*nor a known bag; known are"):
            JointTrajectory.load(tmp_path / "a.csv")

    def test_joints_are_checked_with_the_files_name(self, tmp_path):
        path = write(tmp_path / "a.csv", "stamp_ns,position.wheel\n", "0,0\n")
        with pytest.raises(QuadrupedError, match=r"a\.csv: joint 'LF_hip_joint' is missing; .*it has wheel; add"):
            JointTrajectory.load(path).in_joint_order()


def test_a_file_cut_off_anywhere_within_a_line_is_refused_or_its_last_number_is_named(tmp_path):
    path = tmp_path / "a.csv"
    random_trajectory(rows=2, names=JOINT_NAMES[:2]).save(path)
    whole = path.read_bytes()
    for end in range(len(whole)):
        if whole[end - 1 : end] != b"\n" or whole[:end].count(b"\n") < 2:
            path.write_bytes(whole[:end])
            try:
                loaded = JointTrajectory.load(path)
            except QuadrupedError as error:
                assert str(error).startswith(str(path))  # noqa: PT017
            else:
                last = whole[:end].rpartition(b",")[2].decode()
                assert f"does not end, so its last value, '{last}', may be cut off" in loaded.source.notes[0]


@pytest.mark.slow
def test_a_long_recording_comes_back(tmp_path):
    trajectory = random_trajectory(rows=100_000)
    trajectory.save(tmp_path / "a.csv")
    assert_same(JointTrajectory.load(tmp_path / "a.csv"), trajectory)
