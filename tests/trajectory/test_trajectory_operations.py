"""Resampling, slicing, differentiating and retargeting, against closed forms and SciPy."""

import re

import numpy as np
import pytest

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError
from quadruped_env.trajectory import JointMap, JointRule

START = 1_763_500_000_000_000_001


def trajectory_of(function, seconds, **changes):
    """Two joints: a function of time in s, and its negative."""
    values = function(np.asarray(seconds))
    stamps = START + np.rint(np.asarray(seconds) * 1e9).astype(np.int64)
    return JointTrajectory(stamps, ["a", "b"], np.stack([values, -values], axis=1), **changes)


@pytest.fixture
def uneven():
    """Times in s, unevenly spaced about 10 ms."""
    rng = np.random.default_rng(0)
    return np.cumsum(np.rint(rng.uniform(5e-3, 15e-3, 400) * 1e9)) / 1e9


class TestResample:
    def test_straight_lines_stay_straight(self, uneven):
        line = trajectory_of(lambda t: 3.0 * t - 1.0, uneven, velocities=np.full((400, 2), 3.0))
        even = line.resample(50.0)
        np.testing.assert_array_equal(np.diff(even.stamps), 20_000_000)
        assert even.stamps[0] == line.stamps[0]
        assert 0 <= line.stamps[-1] - even.stamps[-1] < 20_000_000
        np.testing.assert_allclose(even.positions[:, 0], 3.0 * (even.times + uneven[0]) - 1.0, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(even.velocities, 3.0)
        assert even.efforts is None

    def test_rows_at_their_own_rate_come_back_to_the_last_bit(self):
        wave = trajectory_of(np.sin, np.arange(1000) / 50.0)
        again = wave.resample(50.0)
        np.testing.assert_array_equal(again.stamps, wave.stamps)
        np.testing.assert_array_equal(again.positions, wave.positions)

    @pytest.mark.parametrize("rate", [30.0, 1e3 / 7, 400.0])
    def test_rates_without_a_whole_period_in_ns_keep_their_grid(self, rate):
        wave = trajectory_of(np.sin, np.arange(100) / 50.0)
        again = wave.resample(rate)
        assert len(again) == int(99 / 50 * rate) + 1
        np.testing.assert_allclose(again.times, np.arange(len(again)) / rate, rtol=0, atol=0.6e-9)

    def test_an_unknown_effort_stays_unknown_only_around_its_row(self):
        efforts = np.ones((4, 2))
        efforts[2, 0] = np.nan
        fine = trajectory_of(np.sin, np.arange(4) / 10.0, efforts=efforts).resample(20.0)
        assert np.isnan(fine.efforts[:, 0]).tolist() == [False, False, False, True, True, True, False]
        assert np.isfinite(fine.efforts[:, 1]).all()

    def test_timestamps_outside_the_recording_are_named(self):
        wave = trajectory_of(np.sin, [0.0, 1.0])
        with pytest.raises(QuadrupedError, match=rf"stamp {START - 1} ns lies outside the recording, {START} to"):
            wave.at([START - 1, START])
        with pytest.raises(QuadrupedError, match="does not come after"):
            wave.at([START, START])
        for rate in (0.0, -1.0, np.nan, 2e9):
            with pytest.raises(QuadrupedError, match="expected a rate above 0 Hz"):
                wave.resample(rate)


class TestSlice:
    def test_start_is_in_and_stop_is_out(self):
        wave = trajectory_of(np.sin, np.arange(10) / 10.0)
        part = wave.slice(0.2, 0.5)
        np.testing.assert_array_equal(part.stamps, wave.stamps[2:5])
        np.testing.assert_array_equal(part.positions, wave.positions[2:5])
        assert len(wave.slice()) == 10
        np.testing.assert_array_equal(wave.slice(stop=0.2).stamps, wave.stamps[:2])
        assert part.source.row(0) == "JointTrajectory: row 2"

    def test_an_empty_slice_is_named(self):
        with pytest.raises(QuadrupedError, match=r"slice: no row between 5 and None s; it lasts 0\.9 s"):
            trajectory_of(np.sin, np.arange(10) / 10.0).slice(5)


class TestDifferentiate:
    def test_is_exact_for_parabolas_at_uneven_times_ends_included(self, uneven):
        parabola = trajectory_of(lambda t: 2.0 * t**2 - 5.0 * t + 1.0, uneven)
        for window in (0.01, 0.05, 0.3):
            velocities = parabola.differentiate(window).velocities
            np.testing.assert_allclose(velocities[:, 0], 4.0 * uneven - 5.0, rtol=0, atol=1e-9)
            np.testing.assert_allclose(velocities[:, 1], 5.0 - 4.0 * uneven, rtol=0, atol=1e-9)

    @pytest.mark.parametrize("rows", [3, 5, 11])
    def test_is_the_filter_of_savitzky_and_golay_on_even_times(self, rows):
        signal = pytest.importorskip("scipy.signal")
        rng = np.random.default_rng(1)
        positions = rng.normal(size=(300, 2))
        trajectory = JointTrajectory(START + 10_000_000 * np.arange(300), ["a", "b"], positions)
        expected = signal.savgol_filter(positions, rows, 2, deriv=1, delta=0.01, axis=0, mode="interp")
        np.testing.assert_allclose(
            trajectory.differentiate((rows - 1) * 0.01).velocities, expected, rtol=0, atol=1e-9 * np.abs(expected).max()
        )

    def test_filters_noise_and_does_not_delay(self):
        rng, times = np.random.default_rng(2), np.arange(2000) / 100.0
        noisy = trajectory_of(lambda t: np.sin(2.0 * t) + rng.normal(0.0, 1e-3, len(t)), times)
        error = noisy.differentiate(0.2).velocities[:, 0] - 2.0 * np.cos(2.0 * times)
        central = np.gradient(noisy.positions[:, 0], times) - 2.0 * np.cos(2.0 * times)
        assert np.sqrt(np.mean(error**2)) < 0.2 * np.sqrt(np.mean(central**2))

    def test_two_rows_give_their_slope(self):
        slope = trajectory_of(lambda t: 3.0 * t, [0.0, 0.5]).differentiate()
        np.testing.assert_allclose(slope.velocities, [[3.0, -3.0]] * 2)

    def test_recordings_without_a_slope_are_refused(self):
        with pytest.raises(QuadrupedError, match=r"two rows or more; found .* and 1"):
            trajectory_of(np.sin, [0.0]).differentiate()
        with pytest.raises(QuadrupedError, match="window above 0 s"):
            trajectory_of(np.sin, [0.0, 1.0]).differentiate(0.0)


MAP = """
[joints.LF_hip_joint]
source = "a"
sign = -1
scale = 2
offset = 30
unit = "deg"

[joints.LF_knee_joint]
source = "b"

[joints.RF_hip_joint]
offset = 0.25
"""


class TestRetarget:
    def test_sign_scale_offset_and_unit(self, tmp_path):
        (tmp_path / "map.toml").write_text(MAP)
        source = JointTrajectory(
            [0, 10], ["b", "unused", "a"], [[1.0, 9, 45.0], [2.0, 9, -90.0]], [[3, 9, 90]] * 2, [[4.0, 9, 6.0]] * 2
        )
        target = source.retarget(tmp_path / "map.toml")
        assert target.names == ("LF_hip_joint", "LF_knee_joint", "RF_hip_joint")
        expected = [[np.radians(-60), 1.0, 0.25], [np.radians(210), 2.0, 0.25]]
        np.testing.assert_allclose(target.positions, expected, rtol=1e-15)
        np.testing.assert_allclose(target.velocities, [[-np.pi, 3.0, 0.0]] * 2, rtol=1e-15)
        np.testing.assert_array_equal(target.efforts, [[-3.0, 4.0, np.nan]] * 2)
        np.testing.assert_array_equal(target.stamps, source.stamps)

    @pytest.mark.parametrize(
        ("unit", "factor"),
        [("rad/s", 1.0), ("deg/s", np.pi / 180), ("rpm", 2 * np.pi / 60), ("turn/s", 2 * np.pi)],
    )
    def test_velocities_may_have_a_unit_of_their_own(self, unit, factor):
        source = JointTrajectory([0], ["a"], [[180.0]], [[2.0]])
        target = source.retarget(JointMap({"b": JointRule("a", sign=-1, scale=0.5, unit="deg", velocity_unit=unit)}))
        np.testing.assert_allclose(target.positions, [[-np.pi / 2]])
        np.testing.assert_allclose(target.velocities, [[-factor]])

    @pytest.mark.parametrize(
        ("units", "position", "velocity"),
        [
            ({"unit": "turn"}, 2.25, 9.0),
            ({"unit": "turn", "velocity_unit": "rpm"}, 2.25, 540.0),
            ({"unit": "ticks", "ticks_per_turn": 4096}, 2.25 * 4096, 9.0 * 4096),
            ({"unit": "ticks", "ticks_per_turn": 4096, "velocity_unit": "rpm"}, 2.25 * 4096, 540.0),
            ({"unit": "deg", "ticks_per_turn": 4096, "velocity_unit": "ticks/s"}, 2.25 * 360.0, 9.0 * 4096),
        ],
    )
    def test_turns_and_ticks_before_a_gear(self, units, position, velocity):
        """A motor that turns by 2.25 turns, at 9 turns/s with 0.5 N m, before a gear of 9."""
        joint_map = JointMap({"b": JointRule("a", sign=-1, gear=np.float64(9.0), **units)})
        motor = {"position": np.array([position]), "velocity": np.array([velocity]), "effort": np.array([0.5])}
        joint = joint_map.to_joints(["a"], motor)
        np.testing.assert_allclose(list(joint.values()), [[-np.pi / 2], [-2 * np.pi], [-4.5]])
        np.testing.assert_allclose(list(joint_map.to_sources(joint).values()), list(motor.values()))
        # A velocity that is computed from positions has the map's unit, too.
        np.testing.assert_allclose(joint_map.rates * position / 0.25, velocity)
        assert joint_map.periods == pytest.approx((2 * np.pi, 2 * np.pi / 9))
        text = joint_map.text()
        assert JointMap(JointMap.of(joint_map).rules).text() == text
        assert "gear = 9.0" in text

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("", r"expected a table \[joints\]; found none"),
            ("[joints.a]\noffset = 1.0", r"no joint has a source"),
            ("[joints.a]\nsorce = 'b'", r"\[joints\.a\]: unknown key 'sorce'; known are source, sign"),
            ("[joints.a]\nsource = 3", r"\[joints\.a\] source: expected a text; found 3"),
            ("[joints.a]\nsource = 'b'\nsign = 2", r"\[joints\.a\] sign: expected 1 or -1; found 2"),
            ("[joints.a]\nsource = 'b'\nscale = 0", r"\[joints\.a\] scale: expected a number above 0; found 0"),
            ("[joints.a]\nsource = 'b'\noffset = nan", r"\[joints\.a\] offset: expected a finite number; found nan"),
            (
                "[joints.a]\nsource = 'b'\nunit = 'grad'",
                r"\[joints\.a\] unit: expected 'rad' or 'deg' or 'turn' .*found 'grad'",
            ),
            ("[joints.a]\nsource = 'b'\ngear = -9", r"\[joints\.a\] gear: expected a number above 0; found -9"),
            ("[joints.a]\nsource = 'b'\nunit = 'ticks'", r"\[joints\.a\] ticks_per_turn: expected .*; found None"),
            (
                "[joints.a]\nsource = 'b'\nticks_per_turn = 9",
                r"\[joints\.a\] ticks_per_turn: .* only there \(here rad and rad/s\); found 9",
            ),
            (
                "[joints.a]\nsource = 'b'\nscale = 6.2832\nvelocity_unit = 'rpm'",
                r"\[joints\.a\] scale: 6\.2832 is the unit turn in rad, .* velocity in rpm, too; give unit = \"turn\"",
            ),
            ("[joints.a]\nsource = 'b'\nsources = {c = 1}", r"\[joints\.a\] sources: expected .* instead of source"),
            ("[joints.a]\nsources = {c = 0}", r"\[joints\.a\] sources: expected .* factors other than 0"),
            ("[joints.a]\nsources = {}", r"\[joints\.a\] sources: expected a table joint = factor"),
            ("[joints.a]\nsource = 'b'\neffort_scale = 0", r"\[joints\.a\] effort_scale: expected .* other than 0"),
            ("[joints.a", r"not valid TOML: .*; fix it"),
            ("[joints.a]\nsource = 'gone'", r"\[joints\.a\] source: JointTrajectory has no joint 'gone'; it has a, b"),
        ],
    )
    def test_mistakes_are_named(self, tmp_path, text, message):
        path = tmp_path / "map.toml"
        path.write_text(text)
        with pytest.raises(QuadrupedError, match=f"^{re.escape(str(path))}: {message}"):
            trajectory_of(np.sin, [0.0]).retarget(path)

    FIVE_BAR = """
[joints.extension]
sources = { m0 = 0.5, m1 = 0.5 }
offset = 10
unit = "deg"

[joints.swing]
sources = { m1 = -0.5, m0 = 0.5 }
sign = -1
unit = "deg"
effort_scale = 2.0

[joints.wheel]
source = "m7"
scale = 4

[joints.fixed]
offset = 0.25
"""

    def test_joint_that_several_motors_move_both_ways(self, tmp_path):
        (tmp_path / "map.toml").write_text(self.FIVE_BAR)
        joint_map = JointMap.load(tmp_path / "map.toml")
        names = ["m1", "other", "m7", "m0"]
        motors = {
            "position": np.array([[[20.0, 9.0, 0.5, 40.0]], [[-30.0, 9.0, 0.0, 10.0]]]),
            "velocity": np.array([[[1.0, 9.0, 2.0, 3.0]], [[0.0, 9.0, 1.0, -2.0]]]),
            "effort": np.array([[[3.0, 9.0, 8.0, 5.0]], [[np.nan, 9.0, 4.0, 1.0]]]),
        }
        joints = joint_map.to_joints(names, motors)
        degrees = [[[40.0, -10.0]], [[0.0, -20.0]]]
        np.testing.assert_allclose(np.degrees(joints["position"][..., :2]), degrees, atol=1e-12)
        np.testing.assert_array_equal(joints["position"][..., 2:], [[[2.0, 0.25]], [[0.0, 0.25]]])
        np.testing.assert_allclose(joints["velocity"][0], [[np.radians(2.0), np.radians(-1.0), 8.0, 0.0]])
        # Extension and swing turn the motors by m0 = extension - swing and m1 = extension + swing.
        np.testing.assert_allclose(joints["effort"][0], [[3.0 + 5.0, 2.0 * (3.0 - 5.0), 2.0, np.nan]])
        np.testing.assert_array_equal(joints["effort"][1], [[np.nan, np.nan, 1.0, np.nan]])
        assert joint_map.sources == ("m0", "m1", "m7")
        back = joint_map.to_sources(joints)
        for kind, array in motors.items():
            np.testing.assert_allclose(back[kind], array[..., [3, 0, 2]] + 0.0 * back[kind], atol=1e-12)
        (tmp_path / "again.toml").write_text(joint_map.text())
        assert JointMap.load(tmp_path / "again.toml").rules == joint_map.rules

    def test_power_is_kept(self):
        rng = np.random.default_rng(0)
        gears = rng.normal(size=(3, 3))
        rules = {f"q{i}": JointRule(sources={f"m{k}": float(gears[i, k]) for k in range(3)}) for i in range(3)}
        speed, torque = rng.normal(size=(2, 50, 3))
        joints = JointMap(rules).to_joints(["m0", "m1", "m2"], {"velocity": speed, "effort": torque})
        np.testing.assert_allclose((joints["velocity"] * joints["effort"]).sum(axis=1), (speed * torque).sum(axis=1))

    def test_joints_that_do_not_determine_the_motors_cannot_be_sent_back(self):
        for rules in (
            {"a": JointRule(sources={"m0": 0.5, "m1": 0.5})},
            {"a": JointRule("m0"), "b": JointRule("m0")},
            {"a": JointRule(sources={"m0": 1.0, "m1": 1.0}), "b": JointRule(sources={"m0": 2.0, "m1": 2.0})},
        ):
            with pytest.raises(QuadrupedError, match=r"do not determine the \d sources m0.*nothing can be sent back"):
                JointMap(rules).to_sources({"position": np.zeros(len(rules))})

    def test_a_missing_file_is_named(self, tmp_path):
        with pytest.raises(QuadrupedError, match=r"gone\.toml: there is no such file"):
            JointMap.load(tmp_path / "gone.toml")


def test_gaps_are_found():
    times = np.concatenate([np.arange(10) * 0.02, 0.78 + np.arange(10) * 0.02])
    (gap,) = trajectory_of(np.sin, times).gaps()
    assert (gap.row, round(gap.start, 9), round(gap.seconds, 9)) == (9, 0.18, 0.6)
    assert trajectory_of(np.sin, np.arange(10) * 0.02).gaps() == ()
    assert trajectory_of(np.sin, [0.0, 0.02, 0.08, 0.1]).gaps() == (), "three steps and no more"
    assert trajectory_of(np.sin, [0.0]).gaps() == ()


def test_selected_joints_are_named_when_missing():
    wave = trajectory_of(np.sin, [0.0, 1.0])
    np.testing.assert_array_equal(wave.select(["b"]).positions, wave.positions[:, 1:])
    with pytest.raises(QuadrupedError, match=rf"joint '{JOINT_NAMES[0]}' is missing"):
        wave.select(JOINT_NAMES)
