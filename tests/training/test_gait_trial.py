"""Measurements in a trial of scripted gaits: the readings of robots from several starts."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from built_in import FOOT_RADIUS, STANCE, STANCE_HEIGHT

from quadruped_env.gait import LEG_PHASES
from quadruped_env.task import TaskConfig
from quadruped_env.training import gait_trial, gait_tuning

TROT = LEG_PHASES["trot"]

MEASURED = np.arange(51, 151)
"""Control steps of 0.02 s after the warm-up of 1 s, until 3 s"""
CLOCKS = np.array([0.0, math.pi])
"""Gait clock of the two starts, rad."""


@pytest.fixture(autouse=True)
def two_starts(monkeypatch):
    """Two starts from rest, for which the expected values are computed."""
    monkeypatch.setattr(gait_trial, "STARTS", (gait_trial.Start(0.0, 0.7), gait_trial.Start(math.pi, 0.9)))


class FakeSimulation:
    """Four robots from each of two starts with known readings, until 3 s; those before the measurement are wild."""

    num_envs = 8

    def __init__(self, frequency, turns):
        self.targets = []
        self._frequency, self._turns = frequency, np.array(turns)
        joints, feet = np.zeros((8, 8)), np.zeros((8, 4, 3))
        self.readings = SimpleNamespace(
            up_b=np.zeros((8, 3)),
            trunk_force=np.zeros((8, 5)),
            linear_velocity_b=np.zeros((8, 3)),
            angular_velocity_b=np.zeros((8, 3)),
            joint_torque=joints,
            joint_velocity=joints.copy(),
            foot_force=np.zeros((8, 4)),
            foot_velocity=feet,
            foot_angular_velocity=feet.copy(),
            foot_position=feet.copy(),
        )

    def reset(self, env_ids, qpos, qvel):
        self.start = qpos.copy()
        assert env_ids.tolist() == list(range(8))
        assert qvel.shape == (8, 14)
        assert not qvel.any()

    def diverged(self):
        return np.arange(8) == (3 if len(self.targets) == 10 else -1)

    def sine(self, steps):
        """Sine of each leg's clock from each start (steps, 2, 4)."""
        cycles = self._frequency * 0.02 * steps[:, None, None] + self._turns
        return np.sin(2 * np.pi * cycles + CLOCKS[:, None])

    def heights(self, steps):
        """Heights of the soles (steps, 2, 4), m: 8 to 11 mm in a swing, 1 mm less from the second start."""
        swing = self.sine(steps) > 1e-9
        return swing * (0.001 * (8 + steps % 4)[:, None, None] - [[0.0], [0.001]])

    def step(self, target, substeps):
        assert substeps == 4
        self.targets.append(np.array(target))
        step, readings = len(self.targets), self.readings
        assert step <= 150
        readings.up_b[:] = [0.36, 0.48, 0.8]
        readings.up_b[4:, :2] = [0.18, 0.24]
        readings.up_b[[0, 4, 1], 2] = np.where(step == 20, [0.5, 0.5, math.nextafter(0.5, 0.0)], 0.8)
        readings.trunk_force[:, 3] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.001 * (step == 120), 0.0]
        # 0.5 m/s at all steps but the first that is measured and the last: 50 more make the mean of 100 steps 1.5 m/s.
        readings.linear_velocity_b[:] = [0.5 + 50 * (step in (51, 150)), 0.25, 9.0] if step > 50 else 77.0
        readings.angular_velocity_b[:] = [9.0, 9.0, -0.125] if step > 50 else 77.0
        if step > 50:
            readings.linear_velocity_b[4:] *= 3.0
            readings.angular_velocity_b[4:] *= 3.0
        readings.joint_torque[:, :3], readings.joint_velocity[:, :3] = [2.0, -1.0, 4.0], [3.0, 5.0, 0.5]
        readings.joint_torque[4:] *= 0.5
        swing = np.repeat(self.sine(np.array([step]))[0] > 1e-9, 4, axis=0)
        readings.foot_force[:] = np.where(swing, 1.0, 1.001)
        readings.foot_velocity[..., 0] = np.where(swing, 7.0, 0.3)
        readings.foot_velocity[..., 1] = np.where(swing, 7.0, 0.4 - 2.0 * FOOT_RADIUS)
        readings.foot_angular_velocity[..., 0] = 2.0  # rolls the sole sideways, by the radius
        readings.foot_position[..., 2] = FOOT_RADIUS + np.repeat(self.heights(np.array([step]))[0], 4, axis=0)


@pytest.fixture
def measured():
    """A simulation and what is measured in it, of targets 0.2 rad from the stance."""
    turns = LEG_PHASES["walk"]
    simulation = FakeSimulation(2.0, turns)
    got = gait_tuning.measure(lambda clock: np.tile(np.add(STANCE, 0.2), (4, 1)), simulation, 2 * np.pi * 2.0, turns)
    return simulation, got


def test_measured_values_are_means_over_the_time_after_the_warm_up_and_over_the_starts(measured):
    """Velocities are three times as large from the second start, tilt and torques half as large as from the first."""
    _, got = measured
    for name, value in (("forward_velocity", 1.5), ("lateral_velocity", 0.25), ("yaw_rate", -0.125)):
        assert getattr(got, name).tolist() == pytest.approx([(value + 3.0 * value) / 2] * 4), name
    assert got.tilt.tolist() == pytest.approx([(0.6 + 0.3) / 2] * 4)
    power = 2.0 * 3.0 + 4.0 * 0.5
    assert got.power.tolist() == pytest.approx([0.75 * power] * 4), "braking gives nothing back"
    heat = 0.5 * (2.0**2 + 1.0**2 + 4.0**2)  # 0.5 W per squared N m; from the second start torques are half as large
    assert got.electrical_power.tolist() == pytest.approx([0.75 * power + 0.625 * heat] * 4)


def test_measured_feet_slide_lift_and_keep_the_clock(measured):
    simulation, got = measured
    sine, heights = simulation.sine(MEASURED), simulation.heights(MEASURED)
    swing = sine > 1e-9
    # The soles slide at 0.5 m/s while on the ground: root of the mean square over time and feet.
    assert got.slip.tolist() == pytest.approx([np.sqrt(0.25 * (~swing).mean(axis=(0, 2))).mean()] * 4)
    # The mean of |sin|.
    contact_agreement = (sine * np.where(swing, 1.0, -1.0)).mean()
    assert contact_agreement == pytest.approx(2 / math.pi, rel=0.01)
    assert got.clock.tolist() == pytest.approx([contact_agreement] * 4)
    missing = np.maximum(0.0, 1.0 - heights / 0.02)
    assert got.lift.tolist() == pytest.approx([(sine * (1.0 - 2.0 * missing**2)).mean()] * 4)
    assert got.touchdown_error.tolist() == [0.0] * 4
    assert got.clearance.tolist() == pytest.approx([0.010] * 4), "11 mm from the first start"
    assert got.highest.tolist() == pytest.approx([(0.011 + 0.010) / 2] * 4)
    assert got.mean_apex.shape == got.lowest_apex.shape == (4, 2, 4), "candidates, starts, feet"
    for start, height in enumerate((0.011, 0.010)):
        np.testing.assert_allclose(got.lowest_apex[:, start].min(axis=-1), height)
        np.testing.assert_allclose(got.mean_apex[:, start].max(axis=-1), height)


# Each stride has 20 steps. The swing of the first and the last foot starts at step 60 from the first start, and at
# step 70 from the second; that of the two others at 70 and at 60.
STRIDES = {60: (60, 80, 100, 120), 70: (70, 90, 110, 130)}
"""First steps of the whole strides in steps 51 to 150"""
FIRST_STRIDE = np.array([[60, 70, 70, 60], [70, 60, 60, 70]])
"""Of each start and foot."""
A_LITTLE_LATE = (0.01, 0.51, 0.51, 0.01)
"""Phases of a trot in cycles; without the hundredth a step would fall on the moment that begins a stride."""


class SteppingSimulation(FakeSimulation):
    """Robots whose feet have known normal forces in N and heights in m, (150, 8, 4) each, at 2.5 Hz."""

    def __init__(self, forces, heights):
        super().__init__(2.5, A_LITTLE_LATE)
        self._forces, self._known_heights = forces, heights

    def step(self, target, substeps):
        super().step(target, substeps)
        self.readings.foot_force[:] = self._forces[len(self.targets) - 1]
        self.readings.foot_position[..., 2] = FOOT_RADIUS + self._known_heights[len(self.targets) - 1]


LIGHTEST = math.nextafter(1.0, 2.0)
"""Force of the lightest contact, N"""


def trod(contacts=lambda gait, start, foot, stride: (), apex=lambda gait, start, foot, stride: 0.0):
    """Results of feet with contacts (first step in the stride, steps, force) and apexes in m.

    Where no contact is, the feet press with 1 N; outside whole strides they chatter, and are higher and lower.
    """
    forces, heights = np.ones((151, 8, 4)), np.zeros((151, 8, 4))
    forces[1::2] = 30.0
    heights[1::3], heights[2::3] = 0.5, -0.5
    for gait, start, foot in np.ndindex(4, 2, 4):
        robot = 4 * start + gait
        first = FIRST_STRIDE[start, foot]
        forces[first - 1 : first + 80, robot, foot], heights[first : first + 80, robot, foot] = 1.0, 0.0
        for i, step in enumerate(STRIDES[first]):
            for offset, steps, force in contacts(gait, start, foot, i):
                forces[step + offset : step + offset + steps, robot, foot] = force
            heights[step + 7, robot, foot] = apex(gait, start, foot, i)
    simulation = SteppingSimulation(forces[1:], heights[1:])
    return gait_tuning.measure(lambda clock: np.tile(STANCE, (4, 1)), simulation, 2 * np.pi * 2.5, A_LITTLE_LATE)


def test_touchdowns_of_whole_strides_are_compared_with_one_per_stride_and_foot():
    """A foot is on the ground above 1 N, and a contact that lasts counts once."""
    once, thrice = [(10, 8, 20.0)], [(1, 1, LIGHTEST), (5, 2, LIGHTEST), (12, 8, 20.0)]

    def contacts(gait, start, foot, stride):
        return (
            once,
            # One foot bounces and one never lands: their mean would be one.
            [(), [*once, (1, 2, LIGHTEST)], once, once][foot],
            thrice if start == 1 and foot == 3 else once,
            once if stride in (0, 3) else (),
        )[gait]

    got = trod(contacts)
    expected = [0.0, (1 + 1 + 0 + 0) / 4, 2 / 4 / 2, 2 / 4]
    assert got.touchdown_error.tolist() == pytest.approx(expected, rel=1e-12)


def test_clearance_is_the_lowest_whole_stride_of_the_foot_that_is_lifted_least():
    """Of each gait, start, foot and stride."""
    low = {(0, 0, 2, 3): 0.007, (0, 1, 2, 0): 0.012, (1, 1, 3, 0): 0.009, (1, 0, 0, 2): 0.011}
    got = trod(apex=lambda *at: low.get(at, 0.02))
    assert got.clearance.tolist() == pytest.approx([0.007, 0.009, 0.02, 0.02], abs=1e-12)


def test_clearance_counts_a_second_swing_of_a_stride_from_three_steps_on():
    def contacts(gait, start, foot, stride):
        return [(8, 3, 20.0), (14 - min(gait, 1), 6 + min(gait, 1), 20.0)]

    got = trod(contacts, lambda *at: 0.02)
    assert got.clearance.tolist()[:2] == pytest.approx([0.0, 0.02], abs=1e-12), "after steps 8 to 10 it is in the air"


def test_highest_is_the_mean_stride_of_the_foot_that_is_lifted_most():
    high = {(0, 0, 2, stride): height for stride, height in enumerate((0.03, 0.05, 0.03, 0.05))}
    high |= {(1, start, foot, 1): 0.06 for start in range(2) for foot in range(4)}
    got = trod(apex=lambda *at: high.get(at, 0.02))
    assert got.highest.tolist() == pytest.approx([(0.04 + 0.02) / 2, (0.06 + 3 * 0.02) / 4, 0.02, 0.02], abs=1e-12)


def test_trials_start_with_each_friction():
    simulation = gait_trial.trials(3)
    assert simulation.num_envs == 6
    friction = simulation.field_values("geom_friction")[..., 0]
    np.testing.assert_array_equal(friction, np.repeat([0.7, 0.9], 3)[:, None] * np.ones(friction.shape))


def test_trials_start_with_contacts_of_each_softness(monkeypatch):
    starts = gait_trial.Start(0.0, 0.7), gait_trial.Start(0.0, 0.7, softness=2.0)
    monkeypatch.setattr(gait_trial, "STARTS", starts)
    simulation = gait_trial.trials(3)
    own = simulation.compiled_field("geom_solref")
    feet_or_ground = own[:, 0] == 0.01
    assert feet_or_ground.sum() >= 5
    found = simulation.field_values("geom_solref")
    np.testing.assert_array_equal(found[:3], np.broadcast_to(own, (3, *own.shape)))
    np.testing.assert_array_equal(found[3:, feet_or_ground], np.tile([0.02, 1.0], (3, feet_or_ground.sum(), 1)))


def test_soft_contacts_count_by_what_they_change_and_by_falls(measured, monkeypatch):
    """The second start, from which the robots are three times as fast, has soft contacts."""
    _, both = measured
    np.testing.assert_allclose(both.forward_velocity_spread, 1.5)
    np.testing.assert_allclose(both.yaw_rate_spread, 0.125)
    starts = gait_trial.Start(CLOCKS[0], 0.7), gait_trial.Start(CLOCKS[1], 0.7, softness=2.0)
    monkeypatch.setattr(gait_trial, "STARTS", starts)
    turns = LEG_PHASES["walk"]
    got = gait_tuning.measure(lambda clock: np.tile(STANCE, (4, 1)), FakeSimulation(2.0, turns), 2 * np.pi * 2.0, turns)
    np.testing.assert_allclose(got.forward_velocity, 1.5)
    np.testing.assert_allclose(got.forward_velocity_spread, 3.0)
    np.testing.assert_allclose(got.yaw_rate_spread, 0.25)
    np.testing.assert_allclose(got.tilt, 0.6)
    np.testing.assert_allclose(got.clearance, 0.011)
    assert got.lowest_apex.shape == got.mean_apex.shape == (4, 1, 4)
    assert got.fallen.tolist() == both.fallen.tolist()


def test_robots_start_with_the_velocities_and_joint_positions_of_their_start(monkeypatch):
    velocity, offset = tuple(0.1 * np.arange(1, 15)), tuple(0.01 * np.arange(8))
    starts = gait_trial.Start(0.0, 0.7), gait_trial.Start(0.0, 0.7, velocity, offset)
    monkeypatch.setattr(gait_trial, "STARTS", starts)
    simulation = FakeSimulation(2.0, TROT)
    reset = []
    monkeypatch.setattr(simulation, "reset", lambda env_ids, qpos, qvel: reset.extend((qpos[:, 7:], qvel)))
    gait_tuning.measure(lambda clock: np.tile(STANCE, (4, 1)), simulation, 2 * np.pi * 2.0, TROT)
    np.testing.assert_array_equal(reset[0], [STANCE] * 4 + [np.add(STANCE, offset)] * 4)
    np.testing.assert_array_equal(reset[1], [[0.0] * 14] * 4 + [velocity] * 4)


def test_starts_cover_the_cycle_and_the_starts_of_episodes():
    starts = gait_trial.draw_starts(0)
    own, soft = starts[:6], starts[6:]
    np.testing.assert_allclose([start.clock for start in own], np.arange(6) * math.pi / 3)
    assert sorted({start.friction for start in own}) == [0.7, 0.8, 0.9]
    assert {start.softness for start in own} == {1.0}
    assert soft == tuple(own[k]._replace(softness=2.0) for k in (1, 4))
    velocity = np.abs([start.velocity for start in own]).max(axis=0)
    episode = TaskConfig().randomization
    assert (velocity[:6] <= 1.5 * episode.start_base_velocity).all()
    assert (velocity[6:] <= episode.start_joint_velocity).all()
    assert np.abs([start.joint_offset for start in own]).max() <= episode.start_joint_position
    assert velocity.min() > 0.05, "nothing is at rest in all of them"
    assert starts == gait_trial.draw_starts(0)
    assert {start.target_offset for start in starts} == {(0.0,) * 8}


def test_every_generation_has_starts_of_its_own_with_offset_targets():
    generations = [gait_trial.many_new_starts(k) for k in range(3)]
    for starts in generations:
        assert len({start.velocity for start in starts if start.softness == 1.0}) == 18
        # What the search sets at its start alone.
        ground = [(start.friction, start.softness) for start in starts]
        assert ground == [(start.friction, start.softness) for start in generations[0]]
        offsets = np.array([start.target_offset for start in starts])
        assert 0.009 < abs(offsets).max() <= 0.01
        assert abs(offsets).min() > 0.0
    assert len({start.velocity for starts in generations for start in starts}) == 54
    assert gait_trial.new_starts(0) == generations[0][:8]


def test_robot_that_once_tips_strikes_its_trunk_or_diverges_from_either_start_has_fallen(measured):
    """At 60 degrees and at 1 N it has not; it has before the measurement as well."""
    assert measured[1].fallen.tolist() == [False, True, True, True]


def test_robot_starts_in_its_stance_with_the_whole_amplitude(measured):
    simulation, _ = measured
    np.testing.assert_allclose(simulation.start, [[0.0, 0.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0, *STANCE]] * 8)
    np.testing.assert_allclose(simulation.targets, np.broadcast_to(np.add(STANCE, 0.2), (150, 8, 8)))


def test_a_start_may_offset_the_joint_targets_of_its_trial(monkeypatch):
    offset = tuple(0.01 * np.arange(8))
    starts = gait_trial.Start(0.0, 0.7), gait_trial.Start(0.0, 0.7, target_offset=offset)
    monkeypatch.setattr(gait_trial, "STARTS", starts)
    simulation = FakeSimulation(2.0, TROT)
    gait_tuning.measure(lambda _: np.tile(STANCE, (4, 1)), simulation, 2 * np.pi * 2.0, TROT)
    expected = np.array([STANCE] * 4 + [np.add(STANCE, offset)] * 4)
    np.testing.assert_allclose(simulation.targets, np.broadcast_to(expected, (150, 8, 8)))


def test_targets_are_asked_for_the_clock_of_each_start_at_the_end_of_each_step():
    def targets(clock):
        return np.add(STANCE, [[clock + 100.0 * gait] * 8 for gait in range(4)])

    simulation = FakeSimulation(2.0, TROT)
    gait_tuning.measure(targets, simulation, 2 * np.pi * 2.0, TROT)
    clocks = 2 * np.pi * 2.0 * 0.02 * np.arange(1, 151)[:, None] + np.repeat(CLOCKS, 4)
    expected = (clocks + np.tile(100.0 * np.arange(4), 2))[..., None] + STANCE
    np.testing.assert_allclose(simulation.targets, expected, rtol=1e-12)


def test_given_starts_take_the_place_of_the_usual_ones():
    starts = gait_trial.Start(0.0, 0.5), gait_trial.Start(1.0, 0.6, softness=2.0), gait_trial.Start(2.0, 0.9)
    simulation = gait_trial.trials(2, starts)
    np.testing.assert_array_equal(simulation.field_values("geom_friction")[:, 0, 0], [0.5, 0.5, 0.6, 0.6, 0.9, 0.9])
    clocks = []

    def targets(clock):
        clocks.append(clock)
        return np.tile(STANCE, (2, 1))

    got = gait_tuning.measure(targets, simulation, 10.0, TROT, starts)
    np.testing.assert_allclose(clocks[:3], 0.2 + np.array([0.0, 1.0, 2.0]))
    assert got.lowest_apex.shape == (2, 2, 4), "from those with the robot's own contacts"
