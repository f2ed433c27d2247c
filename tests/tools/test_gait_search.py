"""The search for the scripted gaits: trials, limits, which candidate is best, and tables for any robot."""

import dataclasses
import json
import math

import gymnasium
import numpy as np
import pytest
import second_robot
import twelve_joints

import tune_gait
from gait_search import search as gait_search
from gait_search import trial
from gait_search.strides import Strides
from gait_search.styles import HIGH_STEPS, STYLES, Steps, Style
from gait_search.trial import Achieved, Scale, draw_starts, measure, new_starts
from quadruped_env import CommandedGait, QuadrupedError
from quadruped_env.gait import LEG_PHASES
from quadruped_env.robot import MINI_QUADRUPED

TALL, TROT = second_robot.ROBOT, LEG_PHASES["trot"]
LEG = [0.1, 0.6, 0.15, -0.1, -0.7, 0.0]
ROBOTS = pytest.mark.parametrize("robot", [MINI_QUADRUPED, TALL], ids=["built-in", "second"])


def candidate_of(straight, turn=0.0, side=0.0):
    """A candidate (3, 2, 6) from values that are broadcast to (2, 6)."""
    return np.stack([np.broadcast_to(part, (2, 6)) for part in (straight, turn, side)]).astype(float)


# --- trials ---


@ROBOTS
def test_standing_robot_achieves_nothing(robot):
    got = measure(robot, lambda _: np.tile(robot.stance, (2, 1)), 2, 20.0, TROT, draw_starts(robot, 0))
    for name in ("forward_velocity", "yaw_rate", "lateral_velocity", "power", "clearance", "clock"):
        np.testing.assert_allclose(getattr(got, name), 0.0, atol=0.05, err_msg=name)
    np.testing.assert_allclose(got.touchdown_error, 1.0)
    assert not got.fallen.any()
    assert got.lowest_apex.shape == got.mean_apex.shape == (2, 6, 4), "without the starts with soft contacts"


def test_results_are_those_of_each_gait():
    """One candidate lays its legs down, so that the trunk is on the ground; the other walks on."""
    gait = CommandedGait.preset("tuned")

    def targets(clock):
        return np.stack([gait.positions([clock], [[0.3, 0.0]])[0], [1.5, 0.0] * 4])

    got = measure(MINI_QUADRUPED, targets, 2, gait.angular_frequency, TROT, draw_starts(MINI_QUADRUPED, 0))
    assert got.fallen.tolist() == [False, True]
    assert got.forward_velocity[0] == pytest.approx(0.3, abs=0.02)
    assert got.electrical_power[0] > got.power[0] > 1.0
    assert 0.0 < got.forward_velocity_spread[0] < 0.1
    assert got.clearance[0] == got.lowest_apex[0].min()


def test_strides_count_touchdowns_and_apexes_of_whole_strides():
    """A stride of ten steps, five of them in the air; the second foot bounces, and is low in its second swing."""
    strides, before = Strides(1), np.ones((1, 4), dtype=bool)
    for step in range(45):
        k = step % 10
        contact = np.array([[k >= 5, k == 4 or k >= 8, k >= 5, True]])
        height = np.array([[0.02 * (k == 2), 0.01 * (k == 2) + 0.004 * (k == 6), 0.03 * (k == 2), 0.0]])
        strides.add(np.full((1, 4), step // 10), height, contact, before)
        before = contact
    assert strides.count[0].tolist() == [3.0] * 4, "the measurement starts and ends within a stride"
    np.testing.assert_allclose(strides.touchdowns / strides.count, [[1.0, 2.0, 1.0, 0.0]])
    np.testing.assert_allclose(strides.apexes / strides.count, [[0.02, 0.01, 0.03, 0.0]])
    np.testing.assert_allclose(strides.lowest_apex, [[0.02, 0.004, 0.03, 0.0]])


def test_starts_repeat_cover_the_cycle_and_are_new_in_each_generation():
    starts = draw_starts(MINI_QUADRUPED, 0)
    np.testing.assert_allclose(starts.clock[:6], np.arange(6) * math.pi / 3)
    np.testing.assert_array_equal(starts.softness, [1.0] * 6 + [2.0] * 2)
    np.testing.assert_array_equal(starts.velocity[6:], starts.velocity[[1, 4]])
    assert not starts.target_offset.any()
    np.testing.assert_array_equal(starts.velocity, draw_starts(MINI_QUADRUPED, 0).velocity)
    generations = [new_starts(MINI_QUADRUPED, k, 3) for k in range(3)]
    assert len({tuple(row) for part in generations for row in part.velocity}) == 54
    assert 0.009 < abs(generations[0].target_offset).max() <= trial.TARGET_OFFSET


def test_results_are_judged_by_the_size_of_the_robot():
    """Motion that differs only by the size of the robot is worth the same."""
    half = {name: 2.0 * getattr(second_robot.DESIGN, name) for name in ("hip_to_knee", "leg_length")}
    robot = dataclasses.replace(second_robot.DESIGN, name="giant", **half).robot()
    scale = Scale(robot)
    assert scale.length == pytest.approx(robot.stance_height / MINI_QUADRUPED.stance_height)
    values = {name: np.ones(1) for name in Achieved.__annotations__}
    got = Achieved(**values).like_the_tuned_robot(robot)
    assert got.clearance[0] == pytest.approx(1.0 / scale.length)
    assert got.forward_velocity[0] == got.slip[0] == pytest.approx(scale.length**-0.5)
    assert got.yaw_rate[0] == pytest.approx(scale.length**0.5)
    assert got.power[0] == pytest.approx(MINI_QUADRUPED.total_mass / robot.total_mass * scale.length**-0.5)
    assert got.tilt[0] == got.touchdown_error[0] == 1.0
    assert vars(Achieved(**values).like_the_tuned_robot(MINI_QUADRUPED)) == values


# --- limits ---


@ROBOTS
@pytest.mark.parametrize("largest", [0.0, 0.8])
def test_candidates_are_kept_within_ranges_and_speeds_on_both_sides(robot, largest):
    wide = np.random.default_rng(0).normal(0.0, 2.0, (50, 3, 2, 6))
    found, frequency = gait_search.within_limits(robot, wide, 20.0, largest), 20.0
    margin = 0.05 * (robot.joint_position_high - robot.joint_position_low)
    for size in {-largest, 0.0, largest}:
        targets = gait_search.gait_targets(robot, found, np.full(50, size), TROT)
        waves = np.array([targets(clock) for clock in np.linspace(0.0, math.tau, 25)])
        assert (waves > robot.joint_position_low + margin - 1e-9).all()
        assert (waves < robot.joint_position_high - margin + 1e-9).all()
        assert (frequency * np.ptp(waves, axis=0) / 2.0 < robot.velocity_limit).all()
    kept = gait_search.within_limits(robot, candidate_of(LEG)[None], 5.0, largest)[0]
    np.testing.assert_allclose(kept, candidate_of(LEG), atol=1e-12)


# --- the search ---

NEUTRAL = dict.fromkeys(Achieved.__annotations__, 0.0) | {"clearance": 1.0, "lowest_apex": 1.0, "mean_apex": 1.0}


@pytest.fixture
def pretend(monkeypatch):
    """Replaces the trials by a function (candidates, sizes) -> quantities; returns these arguments, as they come."""

    def replaced(quantities):
        seen = []

        def measured(robot, targets, count, *_):
            seen.append(targets)
            values = NEUTRAL | quantities(*targets) | {"fallen": np.zeros(count, dtype=bool)}
            shapes = dict.fromkeys(("lowest_apex", "mean_apex"), (count, 6, 4))
            return Achieved(**{n: np.broadcast_to(v, shapes.get(n, count)) for n, v in values.items()})

        monkeypatch.setattr(gait_search, "gait_targets", lambda robot, candidates, sizes, _: (candidates, sizes))
        monkeypatch.setattr(gait_search, "measure", measured)
        return seen

    return replaced


def offset(candidates):
    """Input of these tests' quantities: the fore legs' hip offset less 0.6 rad."""
    return candidates[:, 0, 0, 1] - 0.6


def found_by(steps=HIGH_STEPS, speed=0.0, generations=20, start=LEG, **options):
    return gait_search.search(
        MINI_QUADRUPED,
        speed,
        10.0,
        TROT,
        candidate_of(start),
        dataclasses.replace(steps, spread=0.15),
        generations,
        **options,
    )


@pytest.mark.parametrize(
    ("quantity", "wanted"),
    [("forward_velocity", 0.3), ("forward_velocity", -0.2), ("lateral_velocity", 0.0), ("yaw_rate", 0.0)]
    + [(name, "less") for name in ("tilt", "power", "slip", "touchdown_error")]
    + [("clock", "more"), ("lift", "more")],
)
def test_search_prefers_the_better_value_of_each_quantity(pretend, quantity, wanted):
    pretend(lambda given, _: {quantity: abs(offset(given)) if wanted == "less" else offset(given)})
    found = found_by(speed=wanted if quantity == "forward_velocity" else 0.0)
    if wanted == "more":
        assert offset(found.candidate[None])[0] > 0.3
    else:
        expected = 0.0 if wanted == "less" else wanted
        assert offset(found.candidate[None])[0] == pytest.approx(expected, abs=0.01)


@pytest.mark.parametrize("quantity", ["lowest_apex", "mean_apex"])
def test_search_wants_each_foot_lifted_from_each_start(pretend, quantity):
    """The height of one foot from one start of six matters, whatever the others do; tilt speaks for less."""

    def quantities(given, _):
        heights = np.full((len(given), 6, 4), 0.02)
        heights[:, 5, 3] = 0.005 + 0.1 * offset(given)
        return {quantity: heights, "tilt": 0.1 * np.abs(offset(given))}

    pretend(quantities)
    found = found_by(dataclasses.replace(STYLES["tuned"].turns, draws=0))
    least = {"lowest_apex": 0.010, "mean_apex": 0.012}[quantity]
    assert getattr(found.achieved, quantity)[0, 5, 3] == pytest.approx(least, abs=2e-4)


def test_search_of_a_turn_varies_what_turning_changes(pretend):
    """A robot that turns with the square of the size, times what depends on the fore legs' hip offset in turns."""
    pretend(lambda given, sizes: {"yaw_rate": sizes**2 / 0.8 * (1.0 + given[:, 1, 0, 1])})
    found = found_by(yaw_rates=(0.4, 0.8))
    assert found.candidate[1, 0, 1] == pytest.approx(0.0, abs=0.01)
    np.testing.assert_array_equal(found.candidate[0], np.tile(LEG, (2, 1)))
    np.testing.assert_allclose(found.achieved.yaw_rate, [0.4, 0.8], atol=0.01)


def test_search_with_new_starts_ends_with_its_mean_else_with_the_best(pretend):
    """A high score from kind starts does not make a candidate better."""
    kindness = iter([0.0, 50.0, 0.0] * 2)
    seen = pretend(lambda given, _: {"power": 10.0 * abs(offset(given)) - next(kindness)})
    np.testing.assert_array_equal(found_by(Steps(0.0, 1.0, 0.0, draws=1), generations=3).candidate, seen[2][0][0])
    best = found_by(generations=3).candidate
    assert abs(seen[4][0] - best).max(axis=(1, 2, 3)).min() == 0.0


# --- tables ---


@pytest.mark.slow
def test_program_makes_a_gait_that_another_robot_takes(monkeypatch, tmp_path, capsys):
    """With one generation of three candidates, a start and no time to walk."""
    monkeypatch.setattr(gait_search, "CANDIDATES", 4)
    monkeypatch.setattr(trial, "SECONDS", 1.5)
    monkeypatch.setitem(STYLES, "low", Style(*[Steps(0.004, 0.006, 4000.0)] * 2, (0.0, 0.3), (0.0,)))
    output = tmp_path / "gait.json"
    options = ["--preset", "low", "--generations", "1", "-o", str(output)]
    assert tune_gait.main([*options, "--task", second_robot.__file__]) == 0
    gaits = json.loads(output.read_text())
    robot = dataclasses.replace(TALL, gaits=gaits)
    gait = CommandedGait.preset("low", robot)
    assert gait.angular_frequency == pytest.approx(CommandedGait.preset("low").angular_frequency * Scale(TALL).rate)
    assert gait.parameters() == gaits["low"]
    assert CommandedGait.preset("fast", robot).parameters() == CommandedGait.preset("fast", TALL).parameters()
    assert robot != TALL
    config = {"action": {"gait": "low"}, "clock_frequency": gait.angular_frequency / math.tau}
    env = gymnasium.make("MiniQuadruped-v0", robot=robot, action_mode="residual", config=config)
    env.reset(seed=0, options={"command": (0.3, 0.0)})
    env.step(np.zeros(8, dtype=np.float32))
    assert "in turns: reached" in capsys.readouterr().out
    for wrong in ({"fore": 3}, {**gaits["low"], "speeds": [0.0]}, {**gaits["low"], "pace": 1}):
        with pytest.raises(QuadrupedError, match=r"'tall': gaits\['low'\] must be what tools/tune_gait.py writes"):
            CommandedGait.preset("low", dataclasses.replace(TALL, gaits={"low": wrong}))
    with pytest.raises(QuadrupedError, match="'tall': gaits: unknown field 'lower'; valid fields are sinusoid"):
        CommandedGait.preset("tuned", dataclasses.replace(TALL, gaits={"lower": gaits["low"]}))
    with pytest.raises(QuadrupedError, match="'tall': gaits must be a dict of preset -> parameters; found 3"):
        dataclasses.replace(TALL, gaits=3)


def test_table_of_a_robot_with_three_joints_per_leg_has_steps_to_the_side(monkeypatch):
    monkeypatch.setattr(trial, "SECONDS", 3.0)
    head, _, *rows = gait_search.achieved_table(CommandedGait.preset("tuned", twelve_joints.ROBOT)).splitlines()
    assert head.startswith("| command m/s, rad/s, m/s to the left | forward m/s")
    for row in rows[-2:]:
        wanted, _, _, reached = row.split(" | ")[:4]
        assert float(reached) / float(wanted.split(",")[2]) == pytest.approx(1.0, abs=0.4)


def test_search_and_gaits_of_a_robot_with_three_joints_per_leg_are_refused(capsys):
    assert tune_gait.main(["--task", twelve_joints.__file__]) == 2
    assert "a search of a gait is for legs of two joints, and its legs have 3; leave it out" in capsys.readouterr().err
    own = dataclasses.replace(twelve_joints.ROBOT, gaits={"tuned": CommandedGait.preset("tuned").parameters()})
    with pytest.raises(QuadrupedError, match=r": gaits\['tuned'\] is for legs of two joints, and its legs have 3"):
        CommandedGait.preset("tuned", own)


def test_program_searches_the_presets_for_one_speed_of_the_built_in_robot(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(gait_search, "CANDIDATES", 4)
    options = ["--preset", "walk", "--generations", "1", "-o", str(tmp_path / "gait.json")]
    assert tune_gait.main(options) == 0
    assert np.shape(json.loads((tmp_path / "gait.json").read_text())["walk"]["hind"]) == (6,)
    assert tune_gait.main([*options, "--task", second_robot.__file__]) == 2
    assert "--preset walk is searched for the built-in robot" in capsys.readouterr().err
