"""The parts of the search for the scripted gaits: what is measured, what is limited, and which candidate is best."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from built_in import FOOT_RADIUS, STANCE, STANCE_HEIGHT

from quadruped_env import QuadrupedError
from quadruped_env.gait import LEG_PHASES
from quadruped_env.training import gait_tuning
from quadruped_env.training.gait_tuning import Achieved

LOW, HIGH = np.array([-0.5, 0.1, -0.5, -0.5, -1.3]), np.array([0.5, 1.1, 0.5, 0.5, -0.4])
"""Bounds of a leg's columns."""
LEG = [0.1, 0.6, 0.15, -0.1, -0.7]
TROT = LEG_PHASES["trot"]


def candidate_of(straight, turn=0.0, side=0.0):
    """A candidate (3, 2, 5) from values that are broadcast to (2, 5)."""
    return np.stack([np.broadcast_to(np.asarray(part, dtype=float), (2, 5)) for part in (straight, turn, side)])


# --- what is measured ---

MEASURED = np.arange(51, 151)
"""Control steps of 0.02 s after the warm-up of 1 s, until 3 s"""


class FakeSimulation:
    """Four robots with known readings, until 3 s; those before the measurement are wild."""

    num_envs = 4

    def __init__(self, frequency, turns):
        self.targets = []
        self._frequency, self._turns = frequency, np.array(turns)
        joints, feet = np.zeros((4, 8)), np.zeros((4, 4, 3))
        self.readings = SimpleNamespace(
            up_b=np.zeros((4, 3)),
            trunk_force=np.zeros((4, 5)),
            linear_velocity_b=np.zeros((4, 3)),
            angular_velocity_b=np.zeros((4, 3)),
            joint_torque=joints,
            joint_velocity=joints.copy(),
            foot_force=np.zeros((4, 4)),
            foot_velocity=feet,
            foot_angular_velocity=feet.copy(),
            foot_position=feet.copy(),
        )

    def reset(self, env_ids, qpos, qvel):
        self.start = qpos.copy()
        assert env_ids.tolist() == [0, 1, 2, 3]
        assert qvel.shape == (4, 14)
        assert not qvel.any()

    def diverged(self):
        return np.array([False, False, False, len(self.targets) == 10])

    def sine(self, steps):
        return np.sin(2 * np.pi * (self._frequency * 0.02 * steps[:, None] + self._turns))

    def heights(self, steps):
        """Heights of the soles (steps, 4), m: 8 to 11 mm in a swing, less of the second foot, and 0 in a stance."""
        swing = self.sine(steps) > 1e-9
        return swing * (0.001 * (8 + steps % 4)[:, None] - [0.0, 0.002, 0.0, 0.0])

    def step(self, target, substeps):
        assert substeps == 4
        self.targets.append(np.array(target))
        step, readings = len(self.targets), self.readings
        assert step <= 150
        readings.up_b[:] = [0.36, 0.48, 0.8]
        readings.up_b[:2, 2] = np.where(step == 20, [0.5, math.nextafter(0.5, 0.0)], 0.8)
        readings.trunk_force[:, 3] = [1.0, 0.0, 1.001 * (step == 120), 0.0]
        # 0.5 m/s at all steps but the first that is measured and the last: 50 more make the mean of 100 steps 1.5 m/s.
        readings.linear_velocity_b[:] = [0.5 + 50 * (step in (51, 150)), 0.25, 9.0] if step > 50 else 77.0
        readings.angular_velocity_b[:] = [9.0, 9.0, -0.125] if step > 50 else 77.0
        readings.joint_torque[:, :3], readings.joint_velocity[:, :3] = [2.0, -1.0, 4.0], [3.0, 5.0, 0.5]
        swing = self.sine(np.array([step]))[0] > 1e-9
        readings.foot_force[:] = np.where(swing, 1.0, 1.001)
        readings.foot_velocity[..., 0] = np.where(swing, 7.0, 0.3)
        readings.foot_velocity[..., 1] = np.where(swing, 7.0, 0.4 - 2.0 * FOOT_RADIUS)
        readings.foot_angular_velocity[..., 0] = 2.0  # rolls the sole sideways, by the radius
        readings.foot_position[..., 2] = FOOT_RADIUS + self.heights(np.array([step]))[0]


@pytest.fixture
def measured():
    """A simulation and what is measured in it, of targets 0.2 rad from the stance."""
    turns = LEG_PHASES["walk"]
    simulation = FakeSimulation(2.0, turns)
    got = gait_tuning.measure(lambda t: np.tile(np.add(STANCE, 0.2), (4, 1)), simulation, 2 * np.pi * 2.0, turns)
    return simulation, got


def test_measured_values_are_means_over_the_time_after_the_warm_up(measured):
    _, got = measured
    for name, value in (("forward_velocity", 1.5), ("lateral_velocity", 0.25), ("yaw_rate", -0.125), ("tilt", 0.6)):
        assert getattr(got, name).tolist() == pytest.approx([value] * 4), name
    assert got.power.tolist() == pytest.approx([2.0 * 3.0 + 4.0 * 0.5] * 4), "braking gives nothing back"


def test_measured_feet_slide_lift_and_keep_the_clock(measured):
    simulation, got = measured
    sine, heights = simulation.sine(MEASURED), simulation.heights(MEASURED)
    swing = sine > 1e-9
    # The soles slide at 0.5 m/s while on the ground: root of the mean square over time and feet.
    assert got.slip.tolist() == pytest.approx([math.sqrt(0.25 * (~swing).mean())] * 4)
    # The mean of |sin|.
    contact_agreement = (sine * np.where(swing, 1.0, -1.0)).mean()
    assert contact_agreement == pytest.approx(2 / math.pi, rel=0.01)
    assert got.clock.tolist() == pytest.approx([contact_agreement] * 4)
    missing = np.maximum(0.0, 1.0 - heights / 0.02)
    assert got.lift.tolist() == pytest.approx([(sine * (1.0 - 2.0 * missing**2)).mean()] * 4)
    assert got.touchdowns.tolist() == pytest.approx([1.0] * 4)


class SteppingSimulation(FakeSimulation):
    """Four robots whose feet have known normal forces (150, 4, 4), N."""

    def __init__(self, forces):
        super().__init__(2.5, TROT)
        self._forces = forces

    def step(self, target, substeps):
        super().step(target, substeps)
        self.readings.foot_force[:] = self._forces[len(self.targets) - 1]


LIGHTEST = math.nextafter(1.0, 2.0)
"""Force of the lightest contact, N"""


def feet(landings, contact=1, force=LIGHTEST):
    """Forces on four feet (100, 4), N: each lands so often for some steps, and is unloaded to 1 N in between."""
    forces = np.ones((100, 4))
    for foot, count in enumerate(landings):
        for i in range(count):
            first = 2 + foot + 100 // count * i
            forces[first : first + contact, foot] = force
    return forces


def test_touchdowns_are_counted_per_stride_and_foot_after_the_warm_up():
    """In 2 s at 2.5 Hz, five strides: a foot is on the ground above 1 N, and a contact that lasts counts once."""
    forces = np.ones((150, 4, 4))
    forces[1:50:2] = 30.0  # before the measurement all feet chatter
    forces[50:, 0] = feet([5, 5, 5, 5], contact=10, force=20.0)
    forces[50:, 1] = feet([5, 10, 20, 0])
    forces[50:, 2] = 20.0  # as in the last step before
    turns, frequency = TROT, 2 * np.pi * 2.5
    got = gait_tuning.measure(lambda t: np.tile(STANCE, (4, 1)), SteppingSimulation(forces), frequency, turns)
    assert got.touchdowns.tolist() == pytest.approx([1.0, (1 + 2 + 4 + 0) / 4, 0.0, 0.0], rel=1e-12)


def test_clearance_is_that_of_the_foot_that_is_lifted_least_in_the_middle_of_its_swing(measured):
    simulation, got = measured
    sine, heights = simulation.sine(MEASURED), simulation.heights(MEASURED)
    middle = sine > 0.8
    feet = (heights * middle).sum(axis=0) / middle.sum(axis=0)
    assert feet.argmin() == 1
    assert got.clearance.tolist() == pytest.approx([feet[1]] * 4, abs=1e-12)
    assert abs(feet[1] - heights[:, 1].sum() / (sine[:, 1] > 0).sum()) > 1e-5, "not of the whole swing"


def test_robot_that_once_tips_strikes_its_trunk_or_diverges_has_fallen(measured):
    """At 60 degrees and at 1 N it has not; it has before the measurement as well."""
    assert measured[1].fallen.tolist() == [False, True, True, True]


def test_robot_starts_in_its_stance_and_the_amplitude_grows_within_half_a_second(measured):
    simulation, _ = measured
    assert len(simulation.targets) == 150
    np.testing.assert_allclose(simulation.start, [[0.0, 0.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0, *STANCE]] * 4)
    for k, share in ((0, 0.04), (12, 0.52), (23, 0.96), (24, 1.0), (25, 1.0), (149, 1.0)):
        np.testing.assert_allclose(simulation.targets[k], np.tile(np.add(STANCE, share * 0.2), (4, 1)))


def test_targets_are_asked_for_the_time_at_the_end_of_each_step():
    times = []
    gait_tuning.measure(
        lambda t: times.append(t) or np.tile(STANCE, (4, 1)), FakeSimulation(2.0, TROT), 2 * np.pi * 2.0, TROT
    )
    np.testing.assert_allclose(times, 0.02 * np.arange(1, 151))


# --- limits ---


def test_straight_candidates_are_kept_within_the_search_and_the_motors_speed():
    free = candidate_of([0.1, 0.5, 0.2, -0.1, -0.8], 7.0, -7.0)
    wide = candidate_of([[0.6, 0.0, 0.4, 0.3, -2.0], [-0.6, 1.5, 0.0, 0.0, 0.0]], 7.0, -7.0)
    # At 5 rad/s an amplitude of 1 rad would be as fast as the motors, beyond the bounds of the search.
    found = gait_tuning._within_limits(np.stack([free, wide]), 5.0, 0.0)
    np.testing.assert_array_equal(found[0], free)
    np.testing.assert_allclose(found[1, 0], [[0.5, 0.1, 0.4, 0.3, -1.3], [-0.5, 1.1, 0.0, 0.0, -0.4]])
    np.testing.assert_array_equal(found[1, 1:], wide[1:], "they are not searched")
    # At 20 rad/s it is 0.25 rad less a thousandth, of the hip and of the knee's sine and cosine together.
    slow = gait_tuning._within_limits(wide[None], 20.0, 0.0)[0, 0]
    size = 0.999 * 0.25
    expected = [[size, 0.1, 0.8 * size, 0.6 * size, -1.3], [-size, 1.1, 0.0, 0.0, -0.4]]
    np.testing.assert_allclose(slow, expected, rtol=1e-12)


def test_turns_are_kept_within_the_same_limits_on_both_sides_at_the_largest_yaw_rate():
    straight = [0.2, 0.6, 0.0, -0.1, -0.7]
    turn, side = [0.2, 0.1, 0.0, 0.0, 0.2], [0.4, -0.3, 0.0, 0.2, 0.2]
    found = gait_tuning._within_limits(candidate_of(straight, turn, side)[None], 20.0, 0.5)
    size = 0.999 * 0.25
    # At 0.5 rad/s the left legs would be at 0.1, 0.8, 0, -0.2, -0.7, the right ones at 0.5, 0.5, 0, 0, -0.5.
    left = np.array([0.1, 0.8, 0.0, -0.2, -0.7])
    right = np.array([size, 0.5, 0.0, 0.0, -0.5])
    for leg in range(2):
        np.testing.assert_allclose(found[0, 0, leg], straight)
        np.testing.assert_allclose(found[0, 0, leg] + 0.5 * (found[0, 1, leg] - found[0, 2, leg]), left, atol=1e-12)
        np.testing.assert_allclose(found[0, 0, leg] + 0.5 * (found[0, 1, leg] + found[0, 2, leg]), right, atol=1e-12)
    # A straight gait beyond its limits is limited first.
    wide = gait_tuning._within_limits(candidate_of([0.9, 2.0, 0.0, 0.0, -0.7])[None], 20.0, 0.5)[0]
    np.testing.assert_allclose(wide, candidate_of([size, 1.1, 0.0, 0.0, -0.7]), atol=1e-12)


# --- the search ---

NEUTRAL = dict.fromkeys(Achieved.__annotations__, 0.0) | {"clearance": 1.0, "fallen": False}


class Trials:
    """Replaces the simulation in a search; `quantities` gives what (candidates, sizes of the turn) achieve."""

    def __init__(self, monkeypatch, quantities):
        self.candidates, self.sizes, self._quantities = [], [], quantities
        monkeypatch.setattr(gait_tuning, "BatchSimulation", lambda model, num_envs, robot: num_envs)
        monkeypatch.setattr(gait_tuning, "gait_targets", lambda *arguments: arguments)
        monkeypatch.setattr(gait_tuning, "measure", self._measure)

    def _measure(self, targets, num_envs, angular_frequency, turns):
        candidates, sizes, *clock = targets
        assert len(candidates) == len(sizes) == num_envs
        assert clock == [angular_frequency, turns]
        self.candidates.append(np.array(candidates))
        self.sizes.append(np.array(sizes))
        values = NEUTRAL | self._quantities(candidates, sizes)
        return Achieved(**{name: np.broadcast_to(value, num_envs) for name, value in values.items()})


def hip_offset(candidates):
    """Input of these tests' quantities: the fore legs' hip offset less 0.6 rad."""
    return candidates[:, 0, 0, 1] - 0.6


@pytest.mark.parametrize(
    ("quantity", "wanted"),
    [
        *(("forward_velocity", speed) for speed in (0.3, -0.2)),
        *((name, 0.0) for name in ("lateral_velocity", "yaw_rate", "tilt", "power", "slip")),
        *((name, "more") for name in ("clock", "lift")),
    ],
)
def test_search_prefers_the_better_value_of_each_quantity(monkeypatch, quantity, wanted):
    """The quantity is the hip's offset; all others are the same for every candidate."""

    def quantities(given, _):
        offset = hip_offset(given)
        return {"forward_velocity": 0.3, quantity: abs(offset) if quantity in ("tilt", "power", "slip") else offset}

    speed = wanted if quantity == "forward_velocity" else 0.3
    Trials(monkeypatch, quantities)
    start = candidate_of([0.0, 0.72, 0.0, 0.0, -0.7])
    found = gait_tuning.search(speed, 10.0, TROT, start, 0.15, 12)
    offset = hip_offset(found.candidate[None])[0]
    if wanted == "more":
        assert offset > 0.3, "near the bound of the search, 1.1 rad"
    else:
        assert offset == pytest.approx(wanted, abs=0.01)


def test_search_wants_every_foot_lifted_by_15_mm_and_no_more(monkeypatch):
    def quantities(given, _):
        return {"clearance": 0.01 + 0.1 * hip_offset(given), "tilt": 0.1 * hip_offset(given)}

    Trials(monkeypatch, quantities)
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20)
    assert found.achieved.clearance[0] == pytest.approx(0.015, abs=2e-4), "tilt speaks for less"


def test_search_wants_every_foot_to_land_once_per_stride_and_no_less(monkeypatch):
    def quantities(given, _):
        return {"touchdowns": 1.5 + 10.0 * hip_offset(given), "tilt": -0.1 * hip_offset(given)}

    Trials(monkeypatch, quantities)
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20)
    assert found.achieved.touchdowns[0] == pytest.approx(1.0, abs=0.02), "tilt speaks for more"


@pytest.mark.parametrize(("worth", "wanted"), [(0.1 / 0.02, 0.1), (0.1 / 0.03, 0.0)])
def test_search_weighs_a_yaw_rate_by_how_fast_it_moves_the_feet(monkeypatch, worth, wanted):
    """0.1 rad/s are worth 2 to 3 cm/s. Speed is met at an offset of 0, the yaw rate at 0.1 rad."""

    def quantities(given, _):
        offset = hip_offset(given)
        return {"forward_velocity": offset, "yaw_rate": worth * (0.1 - offset)}

    Trials(monkeypatch, quantities)
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.15, 20)
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
        np.testing.assert_allclose(tried, np.repeat(sizes, 80), rtol=1e-12)
        np.testing.assert_array_equal(candidates, np.tile(candidates[:80], (len(sizes), 1, 1, 1)))
    np.testing.assert_allclose(found.achieved.yaw_rate, sizes, rtol=1e-12)


@pytest.mark.parametrize("yaw_rates", [(0.0,), (0.25, 0.5)])
def test_generations_are_drawn_around_the_best_of_the_last(monkeypatch, yaw_rates):
    """The cross-entropy method, and its first candidate the mean: recomputed from the same draws."""
    trials = Trials(monkeypatch, lambda given, _: {"forward_velocity": given[:, :, 0, 1].sum(axis=1)})
    start = candidate_of(LEG, [0.0, 0.02, 0.0, 0.0, 0.0])
    gait_tuning.search(0.75, 10.0, TROT, start, 0.02, 3, seed=7, yaw_rates=yaw_rates)
    turning = yaw_rates != (0.0,)
    varied = np.zeros((3, 1, 1))
    varied[1:] = 2.0 * turning
    varied[0] = not turning
    mean, deviation = start, 0.02 * (HIGH - LOW) * varied
    rng = np.random.default_rng(7)
    for tried in trials.candidates:
        expected = mean + deviation * rng.standard_normal((80, 3, 2, 5))
        expected[0] = mean
        candidates = tried[:80]
        np.testing.assert_allclose(candidates, expected, atol=0.50001e-4)
        np.testing.assert_array_equal(candidates, candidates.round(4))
        error = abs(candidates[:, :, 0, 1].sum(axis=1) - 0.75)
        elite = candidates[np.argsort(error)[:12]]
        mean, deviation = elite.mean(axis=0), 0.4 * deviation + 0.6 * elite.std(axis=0) + 0.001 * varied


def test_search_gives_the_mean_that_was_best(monkeypatch):
    """Not a later one: each generation turns out slower than the one before."""
    count = iter(range(5))
    trials = Trials(monkeypatch, lambda given, _: {"forward_velocity": -0.1 * next(count)})
    found = gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.1, 5)
    np.testing.assert_array_equal(found.candidate, trials.candidates[0][0])
    np.testing.assert_allclose(found.candidate, candidate_of(LEG))
    assert found.achieved.forward_velocity.tolist() == [0.0]
    count = iter([2, 1, 0, 1, 2])
    assert gait_tuning.search(0.0, 10.0, TROT, candidate_of(LEG), 0.1, 5).achieved.forward_velocity.tolist() == [0.0]


def test_search_takes_no_seed_of_an_evaluation():
    with pytest.raises(QuadrupedError, match=r"seed.*1000000"):
        gait_tuning.search(0.3, 10.0, TROT, candidate_of(LEG), 0.1, 1, seed=1_000_000)
