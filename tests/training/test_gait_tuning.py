"""The scripted gaits on simulated robots, the search that found their parameters, and the tables that it makes."""

import math
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from built_in import STANCE, VELOCITY_LIMIT

from quadruped_env import CommandedGait, SinusoidalGait
from quadruped_env.cli.main import main
from quadruped_env.gait import LEG_PHASES
from quadruped_env.training import gait_styles, gait_trial, gait_tuning

tuned_on_this_mujoco = pytest.mark.skipif(
    mujoco.__version__ < "4", reason="the gaits are tuned on MuJoCo 4; on 3.17 some miss their tables by a little"
)
TUNED = CommandedGait.tuned()
CROUCHED = CommandedGait.preset("crouched")
LOW = CommandedGait.preset("low")
FAST = CommandedGait.preset("fast")
TURN_COMMANDS = np.array(
    [(speed, side * yaw_rate) for speed in (0.0, 0.2, -0.2) for yaw_rate in (0.25, 0.5) for side in (1, -1)]
)


def table(gait):
    """Commands at the speeds of a gait's table; at zero the gait stands."""
    return np.array([(speed, 0.0) for speed in gait.speeds if speed != 0.0])


@pytest.fixture(scope="module")
def walked():
    """Results of the gaits that follow a command, at the speeds of their tables."""
    return {gait: gait_tuning.measure_commands(gait, table(gait)) for gait in (TUNED, CROUCHED, LOW, FAST)}


# A walking robot is chaotic: on another processor some starts lead to another stride, a few of them to feet that drag.


@tuned_on_this_mujoco
@pytest.mark.parametrize("gait", [TUNED, CROUCHED, LOW, FAST], ids=["tuned", "crouched", "low", "fast"])
def test_gaits_walk_at_the_speeds_of_their_tables(walked, gait):
    got = walked[gait]
    error = np.abs(got.forward_velocity - table(gait)[:, 0])
    assert np.median(error) < 0.005
    assert error.max() < 0.04
    assert abs(got.lateral_velocity).max() < 0.01
    assert abs(got.yaw_rate).max() < 0.02  # nothing holds the heading
    assert not got.fallen.any()


@tuned_on_this_mujoco
@pytest.mark.parametrize(
    ("gait", "least", "agreement", "error"),
    [(TUNED, 0.008, 0.4, 0.04), (CROUCHED, 0.008, 0.45, 0.05), (LOW, 0.004, 0.3, 0.05), (FAST, 0.006, 0.3, 0.1)],
    ids=["tuned", "crouched", "low", "fast"],
)
def test_gaits_lift_every_foot(walked, gait, least, agreement, error):
    got = walked[gait]
    assert np.quantile(got.clearance, 0.25) > least
    assert got.clock.min() > agreement
    assert np.median(got.touchdown_error) < error
    assert got.touchdown_error.max() < 6.0 * error


def test_the_low_gait_lifts_no_foot_as_high_as_the_tuned_one(walked):
    assert walked[LOW].highest.max() < 0.008
    assert walked[TUNED].highest.min() > 0.010


def test_the_fast_gait_is_faster_than_the_tuned_one():
    assert FAST.speeds[-1] > 1.25 * TUNED.speeds[-1]


def test_the_tuned_gait_needs_less_power_than_the_others(walked):
    """Motors' work and heat. The search of the others does not charge heat; at low speeds `low` lifts its feet less."""
    speeds = (-0.2, 0.1, 0.2, 0.3, 0.4)
    power = {
        gait: np.interp(speeds, gait.speeds, np.insert(got.electrical_power, gait.speeds.index(0.0), 0.0))
        for gait, got in walked.items()
    }
    assert (power[TUNED] < power[CROUCHED]).all()
    assert np.median(power[TUNED] / power[CROUCHED]) < 0.85
    assert (power[TUNED] < 0.9 * power[LOW])[[0, 4]].all()
    assert power[TUNED][0] < 0.9 * power[FAST][0]
    assert power[TUNED][4] < power[FAST][4]


def test_the_fast_gait_turns_sharply():
    commands = np.array([(0.0, 1.2), (0.0, -1.2), (0.4, 1.2), (0.4, -1.2)])
    got = gait_tuning.measure_commands(FAST, commands)
    np.testing.assert_allclose(got.yaw_rate, commands[:, 1], atol=0.2)
    np.testing.assert_allclose(got.forward_velocity, commands[:, 0], atol=0.08)
    assert not got.fallen.any()


def test_a_standing_robot_has_its_feet_on_the_ground():
    standing = gait_tuning.measure_commands(TUNED, np.zeros((1, 2)))
    assert standing.clearance[0] == pytest.approx(0.0, abs=0.001)
    # Against the clock as often as with it.
    assert standing.clock[0] == pytest.approx(0.0, abs=0.05)
    assert standing.touchdown_error[0] == 1.0


def test_the_tuned_gait_turns_at_the_commanded_rate():
    got = gait_tuning.measure_commands(TUNED, TURN_COMMANDS)
    error = np.abs(got.yaw_rate - TURN_COMMANDS[:, 1])
    assert np.median(error) < 0.05
    assert error.max() < 0.2
    np.testing.assert_allclose(got.forward_velocity, TURN_COMMANDS[:, 0], atol=0.08)
    # In nearly every stride every foot clears the ground, and lands once.
    assert got.mean_apex.min(axis=2).mean() > 0.008
    assert np.median(got.touchdown_error) < 0.25


def test_no_hip_is_sent_near_its_limit():
    """A hip overshoots its target by up to a tenth of a radian; its limit is 1.5 rad."""
    speeds, yaw_rates = np.linspace(-0.4, 0.7, 45), np.linspace(-1.0, 1.0, 21)
    commands = np.stack(np.meshgrid(speeds, yaw_rates), axis=-1).reshape(-1, 2)
    sine, cosine, offset = TUNED.waves(commands)
    assert (offset + np.hypot(sine, cosine))[:, 0::2].max() < 1.355


@pytest.mark.parametrize(("name", "angular_frequency", "speed"), gait_tuning.PRESET_SPEEDS)
def test_presets_walk_as_fast_as_they_were_tuned_for(name, angular_frequency, speed):
    preset = SinusoidalGait.preset(name)
    assert preset.angular_frequency == angular_frequency
    assert preset.violations() == []
    got = gait_tuning.measure(
        lambda clock: preset.positions(np.array([clock / angular_frequency])),
        gait_trial.trials(1),
        angular_frequency,
        LEG_PHASES[name],
    )
    assert got.forward_velocity[0] == pytest.approx(speed, abs=0.05)
    assert not got.fallen[0]
    assert got.highest[0] > 0.01
    assert got.touchdown_error[0] < 0.4


TROT = LEG_PHASES["trot"]
STRAIGHT = [[0.1, 0.6, 0.2, -0.15, -0.7, 0.03], [0.05, 0.5, 0.1, -0.3, -0.8, -0.07]]
"""Hip sine, hip offset, knee cosine, knee sine, knee offset, hip cosine."""
NO_TURN = np.zeros((2, 2, 6))


def test_candidates_give_the_joint_targets_of_their_gait():
    """The search's own targets, against the gait's formula."""
    candidate = np.concatenate([[STRAIGHT], NO_TURN])
    hip_sine, hip_offset, knee_cosine, knee_sine, knee_offset, hip_cosine = np.repeat(STRAIGHT, 2, axis=0).T
    # Each knee is a cosine, each hip a sine, with its own phase.
    lags = np.stack([np.arctan2(hip_cosine, hip_sine), np.arctan2(-knee_sine, knee_cosine)], axis=1)
    preset = SinusoidalGait(
        hip_amplitude=tuple(np.hypot(hip_sine, hip_cosine)),
        hip_offset=tuple(hip_offset),
        knee_amplitude=tuple(np.hypot(knee_cosine, knee_sine)),
        knee_offset=tuple(knee_offset),
        angular_frequency=12.0,
        phases=tuple((2 * np.pi * np.array(LEG_PHASES["walk"])[:, None] + lags).ravel()),
    )
    targets = gait_tuning.gait_targets(np.array([candidate] * 2), np.array([0.0, 0.5]), LEG_PHASES["walk"])
    for t in (0.0, 0.1, 0.77):
        np.testing.assert_allclose(targets(12.0 * t), np.tile(preset.positions(t), (2, 1)), atol=1e-12)


def test_candidates_in_a_turn_are_the_commanded_gait_with_their_tables():
    rng = np.random.default_rng(0)
    candidates = {speed: rng.uniform(-0.3, 0.3, (3, 2, 6)).round(4) for speed in (0.1, 0.2, 0.4)}
    gait = gait_tuning.commanded_gait(candidates, 12.0, 0.8)
    assert gait.speeds == (0.1, 0.2, 0.4)
    # The size of a turn is the root of the yaw rate times the largest, 0.8 rad/s.
    sizes = np.array([-0.6, 0.0, 0.4])
    targets = gait_tuning.gait_targets(np.array([candidates[0.2]] * 3), sizes, LEG_PHASES["trot"])
    commands = np.column_stack([np.full(3, 0.2), [-0.45, 0.0, 0.2]])
    for t in (0.0, 0.13, 1.7):
        np.testing.assert_allclose(targets(12.0 * t), gait.positions(np.full(3, 12.0 * t), commands), atol=1e-12)


@pytest.fixture
def small_search(monkeypatch):
    monkeypatch.setattr(gait_tuning, "CANDIDATES", 29)
    monkeypatch.setattr(gait_trial, "SECONDS", 2.0)


@pytest.mark.slow
def test_search_improves_the_straight_gait_and_stays_within_the_motors_speed(small_search):
    leg = [0.1, STANCE[0], 0.15, -0.1, STANCE[1], 0.0]
    start, frequency = np.concatenate([[[leg, leg]], NO_TURN]), 14.0
    found = [
        gait_tuning.search(0.25, frequency, LEG_PHASES["trot"], start, 0.15, generations, seed=1)
        for generations in (1, 5)
    ]
    assert found[1].score > found[0].score + 1.0
    candidate = found[1].candidate
    np.testing.assert_array_equal(candidate[1:], 0.0, "straight ahead, no turning column is searched")
    hip_sine, _, cosine, sine, _, hip_cosine = candidate[0].T
    assert (frequency * np.maximum(np.hypot(hip_sine, hip_cosine), np.hypot(cosine, sine)) <= VELOCITY_LIMIT).all()


def test_search_of_a_turn_keeps_the_straight_gait_and_the_motors_speed_on_both_sides(small_search):
    start = np.concatenate([[STRAIGHT], np.full((2, 2, 6), 0.1)])
    start[0, :, 2:4] *= 0.5
    found = gait_tuning.search(0.2, 20.0, LEG_PHASES["trot"], start, 0.2, 1, seed=1, yaw_rates=(0.5, 1.0))
    np.testing.assert_array_equal(found.candidate[0], start[0])
    assert found.achieved.yaw_rate.shape == (2,)
    assert np.abs(found.candidate[1:] - start[1:]).max() > 0.01
    straight, turn, side = found.candidate
    for sign in (-1.0, 1.0):
        hip_sine, _, cosine, sine, _, hip_cosine = (straight + turn + sign * side).T
        assert (
            20.0 * np.maximum(np.hypot(hip_sine, hip_cosine), np.hypot(cosine, sine)) <= VELOCITY_LIMIT + 0.01
        ).all()


def test_table_of_results_names_every_command():
    table = gait_tuning.achieved_table(TUNED)
    rows = [line for line in table.splitlines() if line.startswith(("| +", "| -"))]
    straight = [f"{sign}0.{tenths}, +0.0" for sign, all_ in (("-", "4321"), ("+", "012345")) for tenths in all_]
    turning = [f"+0.{tenths}, {rate}" for tenths in "03" for rate in ("-0.6", "-0.3", "+0.3", "+0.6")]
    assert [row.split(" | ")[0].removeprefix("| ") for row in rows] == straight + turning
    assert all(row.endswith("| no |") for row in rows)
    values = np.array([[float(value) for value in row.split(" | ")[1:6]] for row in rows])
    np.testing.assert_allclose(values[:10, 0], [max(float(row[2:6]), TUNED.speeds[0]) for row in rows[:10]], atol=0.04)
    np.testing.assert_array_equal(np.sign(values[10:, 1]), [-1, -1, 1, 1] * 2)
    assert (abs(values[:10, 2]) < 0.035).all(), "sideways, straight ahead"
    assert (abs(values[10:, 2]) < 0.08).all(), "sideways, in turns"
    assert (values[:, 4] >= 0).all(), "mm"
    assert (values[:, 4] < 50).all(), "mm"


# --- the tables, with a search that takes no time ---

YAW_RATES = (0.4, 0.8)
SPEEDS, TURNING_SPEEDS = (0.2, 0.0, 0.5, -0.1), (0.2, 0.5, -0.1, 0.0)
"""Order of the searches, m/s."""


class FakeSearch:
    """Search that reaches a share of the speed, and whose number is in what it finds; it records how it was called."""

    def __init__(self, share):
        self.calls, self._share = [], share

    def __call__(
        self,
        speed,
        angular_frequency,
        turns,
        start,
        spread,
        generations,
        seed=0,
        yaw_rates=(0.0,),
        judge=None,
        starts=None,
    ):
        number = len(self.calls) + 1
        self.calls.append(SimpleNamespace(**locals() | {"start": np.array(start)}))
        result = np.array(start)
        changed = slice(1, 3) if yaw_rates != (0.0,) else slice(0, 1)
        result[changed] = found(number, result[changed].shape)
        several = np.ones(len(yaw_rates))
        values = dict.fromkeys(gait_tuning.Achieved.__annotations__, several)
        values |= {"forward_velocity": self._share * speed * several, "clearance": 0.012 * several}
        values |= {"yaw_rate": 0.9 * np.array(yaw_rates)}
        return gait_tuning.Found(result, gait_tuning.Achieved(**values), 0.0)


def found(number, shape):
    """Columns that a `FakeSearch` finds as its so manieth."""
    return 0.01 * number + np.arange(math.prod(shape)).reshape(shape) / 1e3 + 0.00004


def tuned_with(
    monkeypatch,
    share,
    say=lambda line: None,
    name="low",
    straight_speeds=SPEEDS,
    turning_speeds=TURNING_SPEEDS,
    refined=None,
):
    """The searches, and the gait that they give."""
    monkeypatch.setattr(gait_tuning, "search", searches := FakeSearch(share))
    style = gait_styles.STYLES[name]
    style = gait_styles.Style(
        style.straight._replace(speeds=straight_speeds), style.turns._replace(speeds=turning_speeds)
    )
    gait = gait_tuning.tune_commanded_gait(13.0, YAW_RATES, 7, say, style, refined)
    steps = [style.straight.steps] * len(straight_speeds) + [style.turns.steps] * len(turning_speeds)
    assert [call.judge.__self__ for call in searches.calls] == steps
    return searches.calls, gait


def test_straight_gaits_are_searched_from_their_neighbours(monkeypatch):
    calls, _ = tuned_with(monkeypatch, 1.0)
    straight = calls[:4]
    assert [call.speed for call in straight] == list(SPEEDS)
    assert all((call.angular_frequency, call.turns, call.seed) == (13.0, TROT, 0) for call in calls)
    assert all((call.spread, call.generations, call.yaw_rates) == (0.04, 7, (0.0,)) for call in straight)
    for call in straight:
        np.testing.assert_array_equal(call.start[1:], NO_TURN)
    steps = np.stack([straight[i + 1].start[0] - found(number, (2, 6)) for i, number in enumerate((1, 1, 2))])
    # The start changes in proportion to the difference of the speeds: 0 and 0.5 m/s are near to 0.2, -0.1 to 0.
    faster = steps[0] / -0.2
    assert abs(faster).max() > 0.5
    np.testing.assert_allclose(steps, np.array([-0.2, 0.3, -0.1])[:, None, None] * faster, atol=1e-12)


def test_turns_are_searched_from_their_neighbours_on_top_of_the_straight_gaits(monkeypatch):
    calls, _ = tuned_with(monkeypatch, 1.0)
    turns = calls[4:]
    assert [call.speed for call in turns] == list(TURNING_SPEEDS)
    assert all((call.spread, call.generations, call.yaw_rates) == (0.1, 7, YAW_RATES) for call in turns)
    for call, number in zip(turns, (1, 3, 4, 2), strict=True):
        np.testing.assert_allclose(call.start[0], found(number, (2, 6)))
    assert abs(turns[0].start[1:]).max() > 0.1, "the first is the turn with which the search begins"
    # 0.5 and -0.1 m/s are nearest to 0.2, and 0 to -0.1: the sixth and the eighth search.
    for call, number in zip(turns[1:], (5, 5, 7), strict=True):
        np.testing.assert_allclose(call.start[1:], found(number, (2, 2, 6)), err_msg=f"{call.speed}")


def test_a_course_asks_for_more_generations_and_starts(monkeypatch):
    calls, _ = tuned_with(monkeypatch, 1.0, name="tuned")
    assert [call.generations for call in calls] == 4 * [27] + 4 * [7]
    assert [call.starts for call in calls] == 4 * [gait_trial.many_new_starts] + 4 * [gait_trial.new_starts]


def test_gait_is_refined_from_its_own_tables(monkeypatch):
    """A search starts from the nearest speed that was searched before, or is in the tables."""
    known = gait_tuning.candidates_of(TUNED)
    calls, _ = tuned_with(
        monkeypatch, 1.0, straight_speeds=(0.3, 0.28, 0.52), refined=TUNED, turning_speeds=(0.3, 0.28)
    )
    faster = gait_tuning._FASTER
    near, last = TUNED.speeds[-4], TUNED.speeds[-1]
    np.testing.assert_allclose(calls[0].start[0], known[near][0] + (0.3 - near) * faster)
    np.testing.assert_allclose(calls[1].start[0], found(1, (2, 6)) - 0.02 * faster)
    np.testing.assert_allclose(calls[2].start[0], known[last][0] + (0.52 - last) * faster)
    np.testing.assert_allclose(calls[3].start[1:], known[near][1:])
    np.testing.assert_allclose(calls[4].start[1:], found(4, (2, 2, 6)))


def test_program_refines_the_tables_of_the_preset(monkeypatch, tmp_path):
    monkeypatch.setattr(gait_tuning, "search", searches := FakeSearch(1.0))
    monkeypatch.setattr(gait_tuning, "achieved_table", lambda gait: "")
    for options in (("--refine",), ()):
        assert main(["tune-gait", "--preset", "low", *options, "-o", str(tmp_path / "gait.json")]) == 0
    refined, fresh = (call for call in searches.calls if call.speed == 0.2 and call.yaw_rates == (0.0,))
    near = min(LOW.speeds, key=lambda speed: abs(speed - 0.2))
    faster = gait_tuning._FASTER
    expected = gait_tuning.candidates_of(LOW)[near][0] + (0.2 - near) * faster
    np.testing.assert_allclose(refined.start[0], expected)
    assert abs(fresh.start[0] - expected).max() > 0.01


def test_tables_and_candidates_are_the_same_numbers():
    assert gait_tuning.commanded_gait(gait_tuning.candidates_of(LOW), LOW.angular_frequency, 0.8) == LOW


def test_the_search_for_low_steps_starts_from_low_steps(monkeypatch):
    """Turns from high ones stay high: no column is where the other search starts."""
    low, _ = tuned_with(monkeypatch, 1.0, name="low")
    tuned, _ = tuned_with(monkeypatch, 1.0, name="tuned")
    for i, part in ((0, slice(0, 1)), (4, slice(1, 3))):
        assert (low[i].start[part] != tuned[i].start[part]).all()


def test_tables_hold_what_was_found_at_each_speed(monkeypatch):
    _, gait = tuned_with(monkeypatch, 1.0)
    assert (gait.angular_frequency, gait.speeds, gait.largest_yaw_rate) == (13.0, (-0.1, 0.0, 0.2, 0.5), 0.8)
    straight, turning = np.array([4, 2, 1, 3]), np.array([7, 8, 5, 6])
    names = ("hip_sine", "hip_offset", "knee_cosine", "knee_sine", "knee_offset", "hip_cosine")
    tables = (gait.fore, gait.hind, gait.fore_turn, gait.hind_turn, gait.fore_side, gait.hind_side)
    first_values = (0.0, 0.006, 0.0, 0.006, 0.012, 0.018)
    for i, (table, first) in enumerate(zip(tables, first_values, strict=True)):
        numbers = straight if i < 2 else turning
        for column, name in enumerate(names):
            expected = 0.01 * numbers + first + 0.001 * column
            # To four digits: the searches' 0.00004 rad more is rounded away.
            np.testing.assert_allclose(getattr(table, name), expected, atol=1e-9, err_msg=f"{i} {name}")


def test_tables_have_the_speeds_that_were_reached(monkeypatch):
    calls, gait = tuned_with(monkeypatch, 0.96977)
    assert gait.speeds == (-0.097, 0.0, 0.194, 0.485), "to 1 mm/s"
    assert [call.speed for call in calls[4:]] == [0.194, 0.485, -0.097, 0.0], "turns are searched at them"


def test_each_search_says_what_it_reached(monkeypatch):
    lines = []
    tuned_with(monkeypatch, 0.9, lines.append)
    assert len(lines) == 8
    assert lines[2] == "+0.50 m/s: reached +0.450 m/s and +0.00 of 0 rad/s, every foot lifted by 12 mm"
    assert lines[6] == (
        "-0.10 m/s in turns: reached -0.081 m/s and +0.36 of 0.4 rad/s, every foot lifted by 12 mm; "
        "-0.081 m/s and +0.72 of 0.8 rad/s, every foot lifted by 12 mm"
    )


def test_presets_are_searched_at_their_frequency_and_speed(monkeypatch):
    monkeypatch.setattr(gait_tuning, "search", searches := FakeSearch(1.0))
    lines = []
    tuned = gait_tuning.tune_presets(3, lines.append)
    asked = [(call.angular_frequency, call.turns, call.speed) for call in searches.calls]
    speeds = {"trot": (14.0, 0.4), "walk": (12.0, 0.25), "bound": (14.0, 0.35), "pace": (14.0, 0.3)}
    assert asked == [(frequency, LEG_PHASES[name], speed) for name, (frequency, speed) in speeds.items()]
    assert list(tuned) == list(speeds)
    # A small step from the stance: the leg folds in its swing.
    leg = [0.1, STANCE[0], 0.15, -0.1, STANCE[1], 0.0]
    for call in searches.calls:
        np.testing.assert_allclose(call.start, np.concatenate([[[leg, leg]], NO_TURN]))
        assert (call.spread, call.generations, call.yaw_rates) == (0.15, 3, (0.0,))
    assert tuned["walk"] == [0.02, 0.021, 0.022, 0.023, 0.024, 0.025, 0.026, 0.027, 0.028, 0.029, 0.03, 0.031], (
        "to a thousandth"
    )
    assert lines[1] == "walk at 12.0 rad/s: reached +0.250 m/s and +0.00 of 0 rad/s, every foot lifted by 12 mm"


def test_row_of_the_table_of_results_shows_each_quantity_in_its_column(monkeypatch):
    def measured(gait, commands):
        assert gait is TUNED
        values = {name: np.full(len(commands), float(i)) for i, name in enumerate(gait_tuning.Achieved.__annotations__)}
        values |= {"forward_velocity": 0.9 * commands[:, 0], "yaw_rate": 0.8 * commands[:, 1]}
        values |= {"lateral_velocity": np.full(len(commands), -0.0125), "power": np.full(len(commands), 7.25)}
        values |= {"clearance": np.full(len(commands), 0.0114), "fallen": commands[:, 1] == 0.3}
        values |= {"touchdown_error": np.full(len(commands), 0.125)}
        return gait_tuning.Achieved(**values)

    monkeypatch.setattr(gait_tuning, "measure_commands", measured)
    lines = gait_tuning.achieved_table(TUNED).splitlines()
    assert len(lines) == 20
    assert {line.count("|") for line in lines} == {9}
    assert lines[2] == "| -0.4, +0.0 | -0.360 | +0.000 | -0.013 | 7.2 | 11 | 0.12 | no |"
    assert lines[18] == "| +0.3, +0.3 | +0.270 | +0.240 | -0.013 | 7.2 | 11 | 0.12 | yes |"
