"""The search for the scripted gaits: what is limited, and which candidate is best."""

import math
import sys

import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.errors import MissingExtraError
from quadruped_env.gait import LEG_PHASES
from quadruped_env.training import gait_styles, gait_trial, gait_tuning
from quadruped_env.training.gait_tuning import Achieved

LOW, HIGH = np.array([-0.5, 0.1, -0.5, -0.5, -1.6, -0.5]), np.array([0.5, 1.2, 0.5, 0.5, -0.4, 0.5])
"""Bounds of a leg's columns."""
LEG = [0.1, 0.6, 0.15, -0.1, -0.7]
"""Columns of a leg whose hip has no cosine part, the last column."""
TROT = LEG_PHASES["trot"]


def candidate_of(straight, turn=0.0, side=0.0):
    """A candidate (3, 2, 6) from values that are broadcast to (2, 5)."""
    return np.stack([with_hip_cosine(np.broadcast_to(part, (2, 5))) for part in (straight, turn, side)])


def with_hip_cosine(legs, value=0.0):
    """Columns of legs (..., 6) from those but the last (..., 5)."""
    legs = np.asarray(legs, dtype=float)
    return np.concatenate([legs, np.full((*legs.shape[:-1], 1), value)], axis=-1)


# --- limits ---


def test_straight_candidates_are_kept_within_the_search_and_the_motors_speed():
    free = candidate_of([0.1, 0.5, 0.2, -0.1, -0.8], 7.0, -7.0)
    wide = candidate_of([[0.6, 0.0, 0.4, 0.3, -2.0], [-0.6, 1.5, 0.0, 0.0, 0.0]], 7.0, -7.0)
    # At 5 rad/s an amplitude of 1 rad would be as fast as the motors, beyond the bounds of the search.
    found = gait_tuning._within_limits(np.stack([free, wide]), 5.0, 0.0)
    np.testing.assert_array_equal(found[0], free)
    # No hip is sent beyond 1.35 rad.
    np.testing.assert_allclose(found[1, 0], with_hip_cosine([[0.5, 0.1, 0.4, 0.3, -1.6], [-0.5, 0.85, 0.0, 0.0, -0.4]]))
    np.testing.assert_array_equal(found[1, 1:], wide[1:], "they are not searched")
    # At 20 rad/s it is 0.25 rad less a thousandth, of the hip and of the knee's sine and cosine together.
    slow = gait_tuning._within_limits(wide[None], 20.0, 0.0)[0, 0]
    size = 0.999 * 0.25
    expected = [[size, 0.1, 0.8 * size, 0.6 * size, -1.6], [-size, 1.35 - size, 0.0, 0.0, -0.4]]
    np.testing.assert_allclose(slow, with_hip_cosine(expected), rtol=1e-12)
    # The hip's sine and cosine together as well.
    wide[0, :, 0], wide[0, :, 5] = 0.3, -0.4
    both = gait_tuning._within_limits(wide[None], 20.0, 0.0)[0, 0]
    np.testing.assert_allclose(both[:, [0, 5]], [[0.6 * size, -0.8 * size]] * 2, rtol=1e-12)


def test_turns_are_kept_within_the_same_limits_on_both_sides_at_the_largest_yaw_rate():
    straight = [0.2, 0.6, 0.0, -0.1, -0.7]
    turn, side = [0.2, 0.1, 0.0, 0.0, 0.2], [0.4, -0.3, 0.0, 0.2, 0.2]
    found = gait_tuning._within_limits(candidate_of(straight, turn, side)[None], 20.0, 0.5)
    size = 0.999 * 0.25
    # At 0.5 rad/s the left legs would be at 0.1, 0.8, 0, -0.2, -0.7, the right ones at 0.5, 0.5, 0, 0, -0.5.
    left = np.array([0.1, 0.8, 0.0, -0.2, -0.7])
    right = np.array([size, 0.5, 0.0, 0.0, -0.5])
    straight, left, right = with_hip_cosine([straight, left, right])
    for leg in range(2):
        np.testing.assert_allclose(found[0, 0, leg], straight)
        np.testing.assert_allclose(found[0, 0, leg] + 0.5 * (found[0, 1, leg] - found[0, 2, leg]), left, atol=1e-12)
        np.testing.assert_allclose(found[0, 0, leg] + 0.5 * (found[0, 1, leg] + found[0, 2, leg]), right, atol=1e-12)
    # A straight gait beyond its limits is limited first.
    wide = gait_tuning._within_limits(candidate_of([0.9, 2.0, 0.0, 0.0, -0.7])[None], 20.0, 0.5)[0]
    np.testing.assert_allclose(wide, candidate_of([size, 1.35 - size, 0.0, 0.0, -0.7]), atol=1e-12)


# --- the search ---

PER_FOOT = ("lowest_apex", "mean_apex")
NEUTRAL = (
    dict.fromkeys(Achieved.__annotations__, 0.0) | dict.fromkeys(("clearance", *PER_FOOT), 1.0) | {"fallen": False}
)


class Trials:
    """Replaces the simulation in a search; `quantities` gives what (candidates, sizes of the turn) achieve."""

    def __init__(self, monkeypatch, quantities):
        self.candidates, self.sizes, self._quantities = [], [], quantities
        self.starts = []
        monkeypatch.setattr(gait_tuning, "trials", lambda count, starts: self.starts.append(starts) or count)
        monkeypatch.setattr(gait_tuning, "gait_targets", lambda *arguments: arguments)
        monkeypatch.setattr(gait_tuning, "measure", self._measure)

    def _measure(self, targets, count, angular_frequency, turns, starts):
        assert starts is self.starts[-1]
        candidates, sizes, phases = targets
        assert len(candidates) == len(sizes) == count
        assert phases == turns
        self.candidates.append(np.array(candidates))
        self.sizes.append(np.array(sizes))
        values = NEUTRAL | self._quantities(candidates, sizes)
        per_foot = {name: np.broadcast_to(values.pop(name), (count, 6, 4)) for name in PER_FOOT}
        return Achieved(**per_foot, **{name: np.broadcast_to(value, count) for name, value in values.items()})


def hip_offset(candidates):
    """Input of these tests' quantities: the fore legs' hip offset less 0.6 rad."""
    return candidates[:, 0, 0, 1] - 0.6


COUNT = gait_tuning.CANDIDATES + 1
"""Candidates of a generation, with the mean."""
NOT_NEGATIVE = ("tilt", "power", "slip", "touchdown_error")


@pytest.mark.parametrize(
    ("quantity", "wanted"),
    [
        *(("forward_velocity", speed) for speed in (0.3, -0.2)),
        *((name, 0.0) for name in ("lateral_velocity", "yaw_rate", *NOT_NEGATIVE)),
        *((name, "more") for name in ("clock", "lift")),
    ],
)
def test_search_prefers_the_better_value_of_each_quantity(monkeypatch, quantity, wanted):
    """The quantity is the hip's offset; all others are the same for every candidate."""

    def quantities(given, _):
        offset = hip_offset(given)
        return {"forward_velocity": 0.3, quantity: abs(offset) if quantity in NOT_NEGATIVE else offset}

    speed = wanted if quantity == "forward_velocity" else 0.3
    Trials(monkeypatch, quantities)
    start = candidate_of([0.0, 0.72, 0.0, 0.0, -0.7])
    found = gait_tuning.search(speed, 10.0, TROT, start, 0.15, 12)
    offset = hip_offset(found.candidate[None])[0]
    if wanted == "more":
        assert offset > 0.3, "near the bound of the search, 1.2 rad"
    else:
        assert offset == pytest.approx(wanted, abs=0.01)


@pytest.mark.parametrize(("style", "height"), [("tuned", 0.012), ("crouched", 0.014), ("low", 0.004), ("fast", 0.008)])
def test_search_wants_every_foot_lifted_by_so_much_and_no_more(monkeypatch, style, height):
    def quantities(given, _):
        # Tilt speaks for less.
        return {"clearance": height - 0.005 + 0.1 * hip_offset(given), "tilt": 0.1 * hip_offset(given)}

    Trials(monkeypatch, quantities)
    found = gait_tuning.search(
        0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20, judge=gait_styles.STYLES[style].straight.steps.judge
    )
    assert found.achieved.clearance[0] == pytest.approx(height, abs=2e-4)


@pytest.mark.parametrize(
    ("style", "part", "height"),
    [
        ("tuned", "straight", 0.020),
        ("tuned", "turns", 0.025),
        ("crouched", "turns", 0.035),
        ("low", "straight", 0.006),
        ("low", "turns", 0.009),
    ],
)
def test_search_wants_no_foot_lifted_higher(monkeypatch, style, part, height):
    def quantities(given, _):
        # Agreement with the clock speaks for more.
        return {"highest": 0.002 + 0.1 * hip_offset(given), "clock": hip_offset(given)}

    Trials(monkeypatch, quantities)
    start = candidate_of([0.0, 0.3, 0.0, 0.0, -0.7])
    steps = getattr(gait_styles.STYLES[style], part).steps
    found = gait_tuning.search(0.0, 10.0, TROT, start, 0.15, 40, judge=steps.judge)
    assert found.achieved.highest[0] == pytest.approx(height, abs=2e-4)


@pytest.mark.parametrize(
    ("quantity", "height"), [("lowest_apex", 0.010), ("mean_apex", 0.012)], ids=["in every stride", "in the mean"]
)
@pytest.mark.parametrize(("start", "foot"), [(0, 0), (5, 3), (2, 1)])
def test_search_wants_each_foot_lifted_from_each_start(monkeypatch, quantity, height, start, foot):
    """The height of one foot from one start of six matters, whatever the others do; tilt speaks for less."""

    def quantities(given, _):
        heights = np.full((len(given), 6, 4), 0.02)
        heights[:, start, foot] = height - 0.005 + 0.1 * hip_offset(given)
        return {quantity: heights, "tilt": 0.1 * hip_offset(given)}

    Trials(monkeypatch, quantities)
    steps = gait_styles.STYLES["tuned"].turns.steps
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20, judge=steps.judge)
    assert getattr(found.achieved, quantity)[0, start, foot] == pytest.approx(height, abs=2e-4)


@pytest.mark.parametrize(("worth", "wanted"), [(0.1 / 0.035, 0.1), (0.1 / 0.045, 0.0)])
def test_search_weighs_a_yaw_rate_by_how_fast_it_moves_the_feet_and_more(monkeypatch, worth, wanted):
    """0.1 rad/s are worth 4 cm/s. Speed is met at an offset of 0, the yaw rate at 0.1 rad."""

    def quantities(given, _):
        offset = hip_offset(given)
        return {"forward_velocity": offset, "yaw_rate": worth * (0.1 - offset)}

    Trials(monkeypatch, quantities)
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20)
    assert hip_offset(found.candidate[None])[0] == pytest.approx(wanted, abs=0.005)


@pytest.mark.parametrize(("worth", "wanted"), [(10.5, 0.1), (9.5, 0.0)])
def test_search_of_tuned_turns_weighs_tilt_as_30_against_300_of_speed(monkeypatch, worth, wanted):
    """Speed is met at an offset of 0, the body is level at 0.1 rad."""

    def quantities(given, _):
        offset = hip_offset(given)
        return {"forward_velocity": offset, "tilt": worth * abs(0.1 - offset)}

    Trials(monkeypatch, quantities)
    steps = gait_styles.STYLES["tuned"].turns.steps
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20, judge=steps.judge)
    assert hip_offset(found.candidate[None])[0] == pytest.approx(wanted, abs=0.005)


@pytest.mark.parametrize(
    ("quantity", "worth", "wanted"),
    [
        # 1 m/s costs 1000, 1 W 6, a touchdown more 300, a difference of 1 m/s between the starts 300.
        ("electrical_power", 170.0, 0.1),
        ("electrical_power", 163.0, 0.0),
        ("touchdown_error", 3.5, 0.1),
        ("touchdown_error", 3.2, 0.0),
        ("forward_velocity_spread", 3.5, 0.1),
        ("forward_velocity_spread", 3.2, 0.0),
    ],
)
def test_search_of_tuned_weighs_power_touchdowns_and_differences_against_speed(monkeypatch, quantity, worth, wanted):
    """Speed is met at an offset of 0; no power is needed, and no foot bounces, at 0.1 rad."""

    def quantities(given, _):
        offset = hip_offset(given)
        return {"forward_velocity": offset, quantity: worth * abs(0.1 - offset)}

    Trials(monkeypatch, quantities)
    steps = gait_styles.STYLES["tuned"].straight.steps
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20, judge=steps.judge)
    assert hip_offset(found.candidate[None])[0] == pytest.approx(wanted, abs=0.005)


def test_search_prefers_to_stay_on_its_feet_at_every_yaw_rate(monkeypatch):
    def quantities(given, sizes):
        return {"fallen": (sizes > 0.4) & (given[:, 1, 0, 1] > 0.1), "yaw_rate": sizes}

    Trials(monkeypatch, quantities)
    start = candidate_of(LEG, [0.0, 0.12, 0.0, 0.0, 0.0])
    found = gait_tuning.search(0.0, 10.0, TROT, start, 0.15, 8, yaw_rates=(0.3, 0.5))
    assert found.achieved.fallen.tolist() == [False, False]
    assert found.candidate[1, 0, 1] <= 0.1


def test_search_of_a_turn_meets_each_yaw_rate_by_its_own(monkeypatch):
    """A robot that turns with the square of the size, times what depends on the fore legs' hip offset in turns."""
    Trials(monkeypatch, lambda given, sizes: {"yaw_rate": sizes**2 / 0.8 * (1.0 + given[:, 1, 0, 1])})
    found = gait_tuning.search(
        0.0, 10.0, TROT, candidate_of(LEG, [0.0, 0.1, 0.0, 0.0, 0.0]), 0.15, 12, yaw_rates=(0.4, 0.8)
    )
    assert found.candidate[1, 0, 1] == pytest.approx(0.0, abs=0.01)
    np.testing.assert_allclose(found.achieved.yaw_rate, [0.4, 0.8], atol=0.01)


@pytest.mark.parametrize(
    ("yaw_rates", "sizes"), [((0.2, 0.45, 0.8), [0.4, 0.6, 0.8]), ((0.1, 0.4), [0.2, 0.4]), ((0.0,), [0.0])]
)
def test_search_runs_all_candidates_in_turns_of_each_size(monkeypatch, yaw_rates, sizes):
    """The size of a turn is the root of the yaw rate times the largest."""
    trials = Trials(monkeypatch, lambda given, sizes: {"yaw_rate": sizes})
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.1, 2, yaw_rates=yaw_rates)
    for candidates, tried in zip(trials.candidates, trials.sizes, strict=True):
        np.testing.assert_allclose(tried, np.repeat(sizes, COUNT), rtol=1e-12)
        np.testing.assert_array_equal(candidates, np.tile(candidates[:COUNT], (len(sizes), 1, 1, 1)))
    np.testing.assert_allclose(found.achieved.yaw_rate, sizes, rtol=1e-12)


@pytest.mark.parametrize("yaw_rates", [(0.0,), (0.25, 0.5)])
def test_first_generation_has_the_start_and_what_is_drawn_around_it(monkeypatch, yaw_rates):
    """Of what the search varies: the straight gait, or what the largest yaw rate adds to it."""
    trials = Trials(monkeypatch, lambda given, _: {})
    start = candidate_of(LEG, [0.0, 0.02, 0.0, 0.0, 0.0])
    for seed in range(20):
        gait_tuning.search(0.75, 10.0, TROT, start, 0.02, 1, seed=seed, yaw_rates=yaw_rates)
    drawn = np.array([candidates[:COUNT] for candidates in trials.candidates])
    np.testing.assert_array_equal(drawn[:, 0], np.broadcast_to(start, (20, 3, 2, 6)))
    np.testing.assert_array_equal(drawn, drawn.round(4))
    share = (drawn[:, 1:] - start) / (HIGH - LOW)
    fixed, varied, largest = ((1, 2), (0,), 1.0) if yaw_rates == (0.0,) else ((0,), (1, 2), 0.5)
    assert not share[:, :, fixed].any()
    share = largest * share[:, :, varied].reshape(20 * gait_tuning.CANDIDATES, -1)
    np.testing.assert_allclose(share.mean(axis=0), 0.0, atol=5 * 0.02 / math.sqrt(len(share)))
    np.testing.assert_allclose(share.std(axis=0), 0.02, rtol=0.2)


def test_search_finds_the_end_of_a_narrow_valley(monkeypatch):
    """The fore legs' hip offset must follow the knee's to a hundredth of what it costs to leave the start."""

    def quantities(given, _):
        hip, knee = hip_offset(given), given[:, 0, 0, 4] + 0.7
        return {"forward_velocity": knee - 0.3, "lateral_velocity": 1000.0 * (hip - knee)}

    Trials(monkeypatch, quantities)
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.05, 60).candidate
    assert hip_offset(found[None])[0] == pytest.approx(0.3, abs=0.002)
    assert found[0, 0, 4] + 0.7 == pytest.approx(0.3, abs=0.002)


def test_search_gives_the_best_candidate_of_all_generations(monkeypatch):
    """Speeds turn out different in each generation, and of each candidate: one of the second is the best."""
    count = iter((2, 1, 3))

    def quantities(given, _):
        generation = next(count)
        return {"forward_velocity": 0.1 * generation + 0.001 * np.abs(np.arange(len(given)) - 7)}

    trials = Trials(monkeypatch, quantities)
    found = gait_tuning.search(0.1, 10.0, TROT, candidate_of(LEG), 0.1, 3)
    np.testing.assert_array_equal(found.candidate, trials.candidates[1][7])
    assert found.achieved.forward_velocity.tolist() == [0.1]


def test_search_repeats_and_another_seed_draws_others(monkeypatch):
    trials = Trials(monkeypatch, lambda given, _: {"forward_velocity": given[:, 0, 0, 1]})
    for seed in (3, 3, 4):
        gait_tuning.search(0.75, 10.0, TROT, candidate_of(LEG), 0.02, 2, seed=seed)
    np.testing.assert_array_equal(trials.candidates[0:2], trials.candidates[2:4])
    assert (trials.candidates[0] != trials.candidates[4]).any()


def test_search_without_its_package_says_how_to_install_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "cmaes", None)
    with pytest.raises(MissingExtraError, match=r"search of a gait needs the 'train' extra"):
        gait_tuning.search(0.3, 10.0, TROT, candidate_of(LEG), 0.1, 1)


def test_search_with_new_starts_in_each_generation_takes_the_mean_of_the_last(monkeypatch):
    """A high score from kind starts does not make a candidate better."""
    monkeypatch.setattr(gait_trial, "STARTS", ())
    rounds = []

    def starts(generation):
        rounds.append(generation)
        return gait_trial.STARTS

    kindness = iter((0.0, 50.0, 0.0))
    trials = Trials(monkeypatch, lambda given, _: {"power": 10.0 * abs(hip_offset(given)) - next(kindness)})
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.1, 3, starts=starts)
    assert rounds == [0, 0, 1, 2], "the first for the simulation, too"
    np.testing.assert_array_equal(found.candidate, trials.candidates[-1][0])
    assert found.score == pytest.approx(-abs(hip_offset(found.candidate[None])[0]))


def test_search_takes_no_seed_of_an_evaluation():
    with pytest.raises(QuadrupedError, match=r"seed.*1000000"):
        gait_tuning.search(0.3, 10.0, TROT, candidate_of(LEG), 0.1, 1, seed=1_000_000)
