"""The scripted gaits on simulated robots, and the search that found their parameters."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from built_in import STANCE, VELOCITY_LIMIT

from quadruped_env import CommandedGait, SinusoidalGait
from quadruped_env.gait import LEG_PHASES
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.training import gait_tuning

POSITIVE = ("tilt", "power", "slip")
TUNED = CommandedGait.tuned()
TABLE = np.array([(speed, 0.0) for speed in TUNED.speeds if speed != 0.0])
"""At zero the commanded gait stands"""
TURNS = np.array(
    [(speed, side * yaw_rate) for speed in (0.0, 0.2, -0.2) for yaw_rate in (0.4, 0.7) for side in (1, -1)]
)


@pytest.fixture(scope="module")
def walked():
    return gait_tuning.measure_commands(TUNED, TABLE)


def test_the_tuned_gait_walks_at_the_speeds_of_its_table(walked):
    np.testing.assert_allclose(walked.forward_velocity, TABLE[:, 0], atol=0.035)
    assert abs(walked.lateral_velocity).max() < 0.04
    assert abs(walked.yaw_rate).max() < 0.15  # nothing holds the heading
    assert not walked.fallen.any()


def test_the_tuned_gait_lifts_every_foot(walked):
    assert walked.clearance.min() > 0.012
    assert walked.clock.min() > 0.2


def test_a_standing_robot_has_its_feet_on_the_ground():
    standing = gait_tuning.measure_commands(TUNED, np.zeros((1, 2)))
    assert standing.clearance[0] == pytest.approx(0.0, abs=0.001)
    # Against the clock as often as with it.
    assert standing.clock[0] == pytest.approx(0.0, abs=0.05)


def test_the_tuned_gait_turns_at_the_commanded_rate_on_lifted_feet():
    got = gait_tuning.measure_commands(TUNED, TURNS)
    np.testing.assert_allclose(got.yaw_rate, TURNS[:, 1], atol=0.25)
    assert (got.yaw_rate * np.sign(TURNS[:, 1]) > 0.4 * np.abs(TURNS[:, 1])).all()
    np.testing.assert_allclose(got.forward_velocity, TURNS[:, 0], atol=0.12)
    assert got.clearance.min() > 0.005


@pytest.mark.parametrize(("name", "angular_frequency", "speed"), gait_tuning.PRESET_SPEEDS)
def test_presets_walk_as_fast_as_they_were_tuned_for(name, angular_frequency, speed):
    preset = SinusoidalGait.preset(name)
    assert preset.angular_frequency == angular_frequency
    assert preset.violations() == []
    simulation = BatchSimulation(build_model(), 1)
    got = gait_tuning.measure(
        lambda t: preset.positions(np.array([t])), simulation, preset.angular_frequency, LEG_PHASES[name]
    )
    assert got.forward_velocity[0] == pytest.approx(speed, abs=0.03)
    assert not got.fallen[0]
    assert got.clearance[0] > 0.005


STRAIGHT = [[0.1, 0.6, 0.2, -0.15, -0.7], [0.05, 0.5, 0.1, -0.3, -0.8]]
NO_TURN = np.zeros((2, 2, 5))


def test_candidates_give_the_joint_targets_of_their_gait():
    """The search's own targets, against the gait's formula."""
    candidate = np.concatenate([[STRAIGHT], NO_TURN])
    preset = SinusoidalGait(
        hip_amplitude=(0.1, 0.1, 0.05, 0.05),
        hip_offset=(0.6, 0.6, 0.5, 0.5),
        knee_amplitude=tuple(np.hypot([0.2, 0.2, 0.1, 0.1], [0.15, 0.15, 0.3, 0.3])),
        knee_offset=(-0.7, -0.7, -0.8, -0.8),
        angular_frequency=12.0,
        phases=tuple(
            2 * np.pi * turn + lag
            for turn, knee in zip(
                LEG_PHASES["walk"], np.arctan2([0.15, 0.15, 0.3, 0.3], [0.2, 0.2, 0.1, 0.1]), strict=True
            )
            for lag in (0.0, knee)
        ),
    )
    targets = gait_tuning.gait_targets(np.array([candidate] * 2), np.array([0.0, 0.5]), 12.0, LEG_PHASES["walk"])
    for t in (0.0, 0.1, 0.77):
        np.testing.assert_allclose(targets(t), np.tile(preset.positions(t), (2, 1)), atol=1e-12)


def test_candidates_at_a_yaw_rate_are_the_commanded_gait_with_their_tables():
    rng = np.random.default_rng(0)
    candidates = {speed: rng.uniform(-0.3, 0.3, (3, 2, 5)).round(4) for speed in (0.1, 0.2, 0.4)}
    gait = gait_tuning.commanded_gait(candidates, 12.0, 0.8)
    assert gait.speeds == (0.1, 0.2, 0.4)
    yaw_rates = np.array([-0.6, 0.0, 0.5])
    targets = gait_tuning.gait_targets(np.array([candidates[0.2]] * 3), yaw_rates, 12.0, LEG_PHASES["trot"])
    commands = np.column_stack([np.full(3, 0.2), yaw_rates])
    for t in (0.0, 0.13, 1.7):
        np.testing.assert_allclose(targets(t), gait.positions(np.full(3, 12.0 * t), commands), atol=1e-12)


@pytest.fixture
def small_search(monkeypatch):
    monkeypatch.setattr(gait_tuning, "CANDIDATES", 30)
    monkeypatch.setattr(gait_tuning, "ELITE", 6)
    monkeypatch.setattr(gait_tuning, "SECONDS", 2.0)


def test_search_improves_the_straight_gait_and_stays_within_the_motors_speed(small_search):
    leg = [0.1, STANCE[0], 0.15, -0.1, STANCE[1]]
    start, frequency = np.concatenate([[[leg, leg]], NO_TURN]), 14.0
    found = [
        gait_tuning.search(0.25, frequency, LEG_PHASES["trot"], start, 0.15, generations, seed=1)
        for generations in (1, 8, 8)
    ]
    errors = [abs(one.achieved.forward_velocity[0] - 0.25) for one in found]
    assert errors[1] < errors[0]
    candidate = found[1].candidate
    np.testing.assert_array_equal(candidate[1:], 0.0, "straight ahead, no turning column is searched")
    hip, _, cosine, sine, _ = candidate[0].T
    assert (frequency * np.maximum(abs(hip), np.hypot(cosine, sine)) <= VELOCITY_LIMIT).all()
    np.testing.assert_array_equal(candidate, found[2].candidate)


def test_search_of_a_turn_keeps_the_straight_gait_and_the_motors_speed_on_both_sides(small_search):
    start = np.concatenate([[STRAIGHT], np.full((2, 2, 5), 0.1)])
    start[0, :, 2:4] *= 0.5
    found = gait_tuning.search(0.2, 20.0, LEG_PHASES["trot"], start, 0.2, 3, seed=1, yaw_rates=(0.5, 1.0))
    np.testing.assert_array_equal(found.candidate[0], start[0])
    assert found.achieved.yaw_rate.shape == (2,)
    assert np.abs(found.candidate[1:] - start[1:]).max() > 0.01
    straight, turn, side = found.candidate
    for sign in (-1.0, 1.0):
        hip, _, cosine, sine, _ = (straight + turn + sign * side).T
        assert (20.0 * np.maximum(abs(hip), np.hypot(cosine, sine)) <= VELOCITY_LIMIT + 0.01).all()


def test_table_of_results_names_every_command():
    table = gait_tuning.achieved_table(TUNED)
    rows = [line for line in table.splitlines() if line.startswith(("| +", "| -"))]
    straight = [f"{sign}0.{tenths}, +0.0" for sign, all_ in (("-", "4321"), ("+", "012345")) for tenths in all_]
    turning = [f"+0.{tenths}, {rate}" for tenths in "03" for rate in ("-0.6", "-0.3", "+0.3", "+0.6")]
    assert [row.split(" | ")[0].removeprefix("| ") for row in rows] == straight + turning
    assert all(row.endswith("| no |") for row in rows)
    values = np.array([[float(value) for value in row.split(" | ")[1:6]] for row in rows])
    np.testing.assert_allclose(values[:10, 0], [float(row[2:6]) for row in rows[:10]], atol=0.02)
    np.testing.assert_array_equal(np.sign(values[10:, 1]), [-1, -1, 1, 1] * 2)
    assert (abs(values[:, 2]) < 0.03).all(), "sideways"
    assert (values[:, 4] >= 0).all(), "mm"
    assert (values[:, 4] < 40).all(), "mm"


class FakeSimulation:
    """Two robots with known readings for 4 s; those of the first second, before the measurement, are wild."""

    def __init__(self, frequency, turns):
        self.num_envs, self.targets, self._steps = 2, [], 0
        self._angles = lambda t: 2 * np.pi * (frequency * t + np.array(turns))
        feet, joints = np.zeros((2, 4, 3)), np.zeros((2, 8))
        self.readings = SimpleNamespace(
            up_b=np.zeros((2, 3)),
            trunk_force=np.zeros((2, 5)),
            linear_velocity_b=np.zeros((2, 3)),
            angular_velocity_b=np.zeros((2, 3)),
            joint_torque=joints,
            joint_velocity=joints.copy(),
            foot_force=np.zeros((2, 4)),
            foot_velocity=feet,
            foot_angular_velocity=feet.copy(),
            foot_position=feet.copy(),
        )

    def reset(self, env_ids, qpos, qvel):
        self.started = qpos.copy()
        assert env_ids.tolist() == [0, 1]
        assert not qvel.any()

    def diverged(self):
        return np.zeros(2, dtype=bool)

    def step(self, target, substeps):
        assert substeps == 4
        self._steps += 1
        self.targets.append(np.array(target))
        measured = self._steps > 50
        readings = self.readings
        readings.up_b[:] = [0.6, 0.0, 0.8]
        readings.up_b[1, 2] = 0.4 if self._steps == 20 else 0.8
        # 0.5 m/s at all steps but the first that is measured and the last: 75 more make the mean of 150 steps 1.5 m/s.
        readings.linear_velocity_b[:] = [0.5 + 75 * (self._steps in (51, 200)), 0.25, 9.0] if measured else 77.0
        readings.angular_velocity_b[:] = [9.0, 9.0, -0.125] if measured else 77.0
        readings.joint_torque[:, :3], readings.joint_velocity[:, :3] = [2.0, -1.0, 4.0], [3.0, 5.0, 0.5]
        # Each foot is on the ground while its clock is not positive, and is lifted by 10 mm, or 8 mm, while it is.
        swing = np.sin(self._angles(0.02 * self._steps)) > 1e-9
        readings.foot_force[:] = np.where(swing, 0.5, 2.0)
        readings.foot_velocity[..., 0] = np.where(swing, 7.0, 0.3)
        readings.foot_velocity[..., 1] = np.where(swing, 7.0, 0.4)
        readings.foot_position[..., 2] = gait_tuning.ROBOT.foot_radius + swing * [0.010, 0.008, 0.010, 0.010]


def test_measured_values_are_means_over_the_time_after_the_warm_up():
    turns = (0.0, 0.5, 0.5, 0.0)
    simulation = FakeSimulation(2.0, turns)
    asked = STANCE + 0.2
    got = gait_tuning.measure(lambda t: np.tile(asked, (2, 1)), simulation, 2 * np.pi * 2.0, turns)
    assert got.forward_velocity.tolist() == pytest.approx([1.5, 1.5])
    assert got.lateral_velocity.tolist() == pytest.approx([0.25, 0.25])
    assert got.yaw_rate.tolist() == pytest.approx([-0.125, -0.125])
    assert got.tilt.tolist() == pytest.approx([0.6, 0.6])
    assert got.power.tolist() == pytest.approx([2.0 * 3.0 + 4.0 * 0.5] * 2), "braking gives nothing back"
    # 0.5 m/s while on the ground, half of the time: the root of a mean square over the feet.
    assert got.slip.tolist() == pytest.approx([0.5 * math.sqrt(0.5)] * 2, rel=0.03)
    assert got.clearance.tolist() == pytest.approx([0.008, 0.008])
    # The mean of |sin| is 2 / pi. Feet that are lifted by half of a full lift have 1 - 2 / 4 of it in their swing.
    assert got.clock.tolist() == pytest.approx([2 / math.pi] * 2, rel=0.01)
    assert got.lift.tolist() == pytest.approx([(3 * 0.5 + (1 - 2 * 0.6**2) + 4) / 8 * 2 / math.pi] * 2, rel=0.01)
    assert got.fallen.tolist() == [False, True], "the second has once been tilted by more than 60 degrees"
    # The targets grow from the stance within 0.5 s.
    assert len(simulation.targets) == 200
    np.testing.assert_allclose(simulation.started[:, 7:], [STANCE, STANCE])
    for k, share in ((0, 0.04), (12, 0.52), (24, 1.0), (199, 1.0)):
        np.testing.assert_allclose(simulation.targets[k], np.tile(STANCE + share * 0.2, (2, 1)))


class FakeSearch:
    """Search that reaches every speed but those beyond 0.25 m/s; it records how it was called."""

    def __init__(self):
        self.calls = []

    def __call__(self, speed, angular_frequency, turns, start, spread, generations):
        self.calls.append((speed, np.array(start), spread))
        columns = np.tile([0.1 + abs(speed), 0.6, 0.15, -0.1, -0.7], 2)
        columns[5:] += 0.01
        columns += 0.0004
        return gait_tuning.Found(columns, float(np.clip(speed, -0.25, 0.25)), 0.012)


@pytest.fixture
def fake_search(monkeypatch):
    monkeypatch.setattr(gait_tuning, "search", found := FakeSearch())
    return found


def test_table_of_a_gait_holds_the_speeds_that_were_reached(monkeypatch, fake_search):
    monkeypatch.setattr(gait_tuning, "_with_tuned_track", lambda gait, say: gait)
    lines = []
    gait = gait_tuning.tune_commanded_gait(13.0, (0.1, 0.2, 0.4), (-0.2,), 3, lines.append)
    assert gait.angular_frequency == 13.0
    assert gait.speeds == (-0.2, 0.0, 0.1, 0.2, 0.25)
    # The column for a speed is the one that was found for it; at 0 the legs stand.
    assert gait.fore.hip_amplitude == pytest.approx((0.3, 0.0, 0.2, 0.3, 0.5), abs=1e-3)
    assert gait.hind.hip_amplitude == pytest.approx((0.31, 0.0, 0.21, 0.31, 0.51), abs=1e-3)
    assert gait.fore.hip_offset == pytest.approx((0.6, STANCE[0], 0.6, 0.6, 0.6), abs=1e-3)
    assert gait.hind.knee_offset == pytest.approx((-0.69, STANCE[1], -0.69, -0.69, -0.69), abs=1e-3)
    speeds, starts, spreads = zip(*fake_search.calls, strict=True)
    assert speeds == (0.1, 0.2, 0.4, -0.2)
    assert spreads == (0.15, 0.08, 0.08, 0.15), "a search from a neighbour's result is narrower"
    np.testing.assert_allclose(starts[1][:5], [0.2, 0.6, 0.15, -0.1, -0.7], atol=1e-3)
    step = np.array([0.1, 0.0, 0.15, -0.1, 0.0] * 2)
    stance = np.array([0.0, STANCE[0], 0.0, 0.0, STANCE[1]] * 2)
    np.testing.assert_allclose(starts[0], stance + step)
    np.testing.assert_allclose(
        starts[3], stance + step * ([1, 1, -1, 1, 1] * 2), err_msg="backwards the shank reverses"
    )
    assert lines[2].startswith("+0.40 m/s: reached +0.250 m/s, every foot lifted by 12 mm, with [0.5, 0.6, 0.15, ")


def test_presets_are_searched_at_their_frequency_and_speed(fake_search):
    lines = []
    tuned = gait_tuning.tune_presets(3, lines.append)
    assert [speed for speed, *_ in fake_search.calls] == [0.4, 0.25, 0.35, 0.3]
    assert list(tuned) == ["trot", "walk", "bound", "pace"]
    assert tuned["trot"] == [0.5, 0.6, 0.15, -0.1, -0.7, 0.51, 0.61, 0.16, -0.09, -0.69], "to a thousandth"
    assert lines[1].startswith("walk at 12.0 rad/s: reached +0.250 m/s")


def test_half_track_is_the_one_that_turns_as_commanded(monkeypatch):
    """A gait that turns with 0.34 m of half track as much as commanded; with more it turns too far."""
    asked = []

    def measured(gait, commands):
        asked.append(commands.tolist())
        turned = commands[:, 1] * gait.half_track / 0.34
        return SimpleNamespace(yaw_rate=turned, forward_velocity=commands[:, 0] + 0.01)

    monkeypatch.setattr(gait_tuning, "measure_commands", measured)
    lines = []
    assert gait_tuning._with_tuned_track(TUNED, lines.append).half_track == 0.34
    assert lines == ["half track 0.34 m: mean error 0.010 (rad/s + m/s)"]
    assert len(asked) == 13, "0.10 to 0.58 m in steps of 0.04 m"
    assert asked[0] == [[speed, rate] for speed in (0.0, 0.2, 0.3) for rate in (-0.6, -0.3, 0.3, 0.6)]


@pytest.mark.parametrize(
    ("quantity", "wanted"),
    [
        *(("forward_velocity", speed) for speed in (0.3, -0.2)),
        *((name, 0.0) for name in ("lateral_velocity", "yaw_rate", "tilt", "power", "slip")),
        *((name, "more") for name in ("clock", "lift")),
    ],
)
def test_search_prefers_the_better_value_of_each_quantity(monkeypatch, quantity, wanted):
    """The quantity is the offset of the fore hip less 0.6 rad; all others are the same for every candidate."""

    def measure(offset, simulation, angular_frequency, turns):
        values = np.zeros(len(offset))
        found = dict.fromkeys(gait_tuning.Achieved.__annotations__, values) | {"fallen": values > 0.0}
        if quantity != "forward_velocity":
            found["forward_velocity"] = values + 0.3
        return gait_tuning.Achieved(**found | {quantity: abs(offset) if quantity in POSITIVE else offset})

    monkeypatch.setattr(gait_tuning, "measure", measure)
    monkeypatch.setattr(gait_tuning, "BatchSimulation", lambda *arguments, **options: None)
    monkeypatch.setattr(gait_tuning, "gait_targets", lambda candidates, *_: candidates[:, 1] - 0.6)
    start = np.array([0.0, 0.72, 0.0, 0.0, -0.7] * 2)
    speed = wanted if quantity == "forward_velocity" else 0.3
    found = gait_tuning.search(speed, 10.0, LEG_PHASES["trot"], start, 0.15, 12).columns[1] - 0.6
    if wanted == "more":
        assert found > 0.3, "near the bound of the search, 1.1 rad"
    else:
        assert found == pytest.approx(wanted, abs=0.01)


def test_candidates_are_kept_within_the_search_and_the_motors_speed():
    free = np.array([0.1, 0.5, 0.2, -0.1, -0.8] * 2)
    wide = np.array([0.6, 0.0, 0.4, 0.3, -2.0, -0.6, 1.5, 0.0, 0.0, 0.0])
    # At 5 rad/s an amplitude of 1 rad would be as fast as the motors, beyond the bounds of the search.
    found = gait_tuning._within_limits(np.stack([free, wide]), 5.0)
    np.testing.assert_array_equal(found[0], free)
    np.testing.assert_allclose(found[1], [0.5, 0.1, 0.4, 0.3, -1.3, -0.5, 1.1, 0.0, 0.0, -0.4])
    # At 20 rad/s it is 0.25 rad, of the hip and of the knee's sine and cosine together: 0.4 and 0.3 make 0.5.
    slow = gait_tuning._within_limits(wide[None], 20.0)[0]
    np.testing.assert_allclose(slow, [0.25, 0.1, 0.2, 0.15, -1.3, -0.25, 1.1, 0.0, 0.0, -0.4], rtol=0.002)
    assert (np.hypot(slow[[0, 2, 5]], [0.0, slow[3], 0.0]) * 20.0 < 5.0).all()
