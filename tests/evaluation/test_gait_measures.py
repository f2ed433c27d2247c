"""Measures of the gait against trajectories with known apexes, bounces, landings, limits and attitudes."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from synthetic import DT, synthetic_rollout

from quadruped_env.evaluation import measures
from quadruped_env.evaluation.measures import gait_measures
from quadruped_env.evaluation.rollout import PhysicsSamples, roll_out
from quadruped_env.evaluation.suite import steady
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.policies import GaitController
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.utils.rotations import from_roll_pitch_yaw

PART = full_suite().gait
FINE = 0.005
"""Physics step, s."""
STRIDE, SWING = 100, 40
"""Physics steps of a stride (2 Hz) and of its swing."""


def stride(apexes, landing=0.3):
    """Height, upward velocity and contact (K,) of a foot that swings along a parabola in each stride, and then stands.

    In the sample before the touchdown it falls at `landing` m/s, in the first one on the ground at a third of that.
    """
    steps = len(apexes) * STRIDE
    height, rise, contact = np.zeros(steps), np.zeros(steps), np.ones(steps, dtype=bool)
    share = (np.arange(SWING) + 0.5) / SWING
    parabola = 4.0 * share * (1.0 - share)
    for i, apex in enumerate(apexes):
        swing = slice(i * STRIDE + 20, i * STRIDE + 20 + SWING)
        height[swing] = apex * parabola / parabola.max()
        contact[swing] = False
        rise[swing.stop - 1 : swing.stop + 1] = -landing, -landing / 3.0
    return height, rise, contact


def bounce(height, contact, at, apex, steps=6):
    """Put a hop into a stance, in place."""
    height[at : at + steps], contact[at : at + steps] = apex, False


def test_swings_have_apexes_and_landings():
    height, rise, contact = stride([0.01, 0.02, 0.03])
    found = measures.flights_of(height, rise, contact, 20, 0.002)
    np.testing.assert_allclose(found.apexes, [0.01, 0.02, 0.03])
    np.testing.assert_allclose(found.landings, 0.3)
    assert found.bounces == 0
    # The swings at both ends are cut: their apex and landing may have been missed.
    cut = slice(30, 2 * STRIDE + 40)
    assert len(measures.flights_of(height[cut], rise[cut], contact[cut], 20, 0.002).apexes) == 1
    in_the_air = np.zeros(50, dtype=bool)
    assert len(measures.flights_of(np.ones(50), np.ones(50), in_the_air, 20, 0.002).apexes) == 0


def test_each_short_flight_over_the_height_is_one_bounce():
    height, rise, contact = stride([0.02] * 3)
    bounce(height, contact, 70, 0.0019)  # too low: chatter
    bounce(height, contact, STRIDE + 70, 0.0021)
    bounce(height, contact, 2 * STRIDE + 70, 0.004)
    bounce(height, contact, 2 * STRIDE + 85, 0.003, steps=2)
    found = measures.flights_of(height, rise, contact, 20, 0.002)
    assert found.bounces == 3
    np.testing.assert_allclose(found.apexes, 0.02)
    # A flight of the shortest swing is a swing.
    assert measures.flights_of(height, rise, contact, 6, 0.002).bounces == 1


def feet(columns, frequency=2.0, counted=None):
    """Measures of one episode of one foot from `stride`'s arrays."""
    height, rise, contact = (np.asarray(column).reshape(-1, 1, 1) for column in columns)
    counted = np.ones((len(height), 1), dtype=bool) if counted is None else counted
    physics = PhysicsSamples(height, rise, 100.0 * contact, 0 * height, 0 * height)
    found = measures.feet(physics, contact, counted, np.array([frequency]), FINE, measures.BOUNCE)
    return {name: value[0, 0] for name, value in found.items()}


def test_clearance_is_the_fifth_percentile_of_the_apexes():
    apexes = np.arange(1, 42) / 1000.0  # the 5th percentile of 1, 2, ..., 41 mm is 3 mm
    found = feet(stride(apexes))
    assert found["clearance"] == pytest.approx(0.003)
    assert found["apex"] == pytest.approx(0.021)
    assert found["touchdowns_per_stride"] == pytest.approx(1.0)
    assert found["bounces_per_stride"] == 0.0
    assert found["landing_speed"] == pytest.approx(0.3)


def test_clearance_counts_strides_without_a_swing_as_an_apex_of_zero():
    assert feet(stride([0.02] * 40))["clearance"] == pytest.approx(0.02)
    dragged = np.arange(40) % 4 == 3
    height, rise, contact = stride(np.where(dragged, 0.0, 0.02))
    contact |= np.repeat(dragged, STRIDE)
    found = feet((height, rise, contact))
    assert found["clearance"] == 0.0
    assert found["apex"] == pytest.approx(0.02)
    assert found["touchdowns_per_stride"] == pytest.approx(0.75)


def test_feet_without_a_stride_are_not_lifted_and_without_samples_unknown():
    found = feet(stride([0.02] * 4), frequency=math.nan)
    assert found["clearance"] == found["apex"] == 0.0
    assert math.isnan(found["landing_speed"])
    nothing = feet(stride([0.02] * 4), counted=np.zeros((4 * STRIDE, 1), dtype=bool))
    assert all(math.isnan(value) for value in nothing.values())


def test_speed_limit_share_is_the_time_with_any_joint_over_its_limit():
    velocity = np.zeros((10, 1, 2))
    velocity[:3, 0, 0] = -4.8
    velocity[2:4, 0, 1] = 4.8
    velocity[9, 0, 1] = 99.0
    counted = np.ones((10, 1), dtype=bool)
    limit = np.array([4.75, 4.75])
    assert measures.speed_limit_share(velocity, counted, limit) == pytest.approx(0.5)
    counted[9] = False
    assert measures.speed_limit_share(velocity, counted, limit) == pytest.approx(4 / 9)
    assert measures.speed_limit_share(velocity, counted, np.array([5.0, 4.75])) == pytest.approx(2 / 9)


def test_roll_and_pitch_do_not_depend_on_the_heading():
    roll, pitch = 0.2, -0.3
    for yaw in (0.0, 1.0, -3.0):
        pose = np.concatenate([[0.0, 0.0, 0.184], from_roll_pitch_yaw([roll, pitch, yaw])])
        rollout = walking()
        found = gait_measures(replace(rollout, base_pose=np.tile(pose, (len(rollout), 1, 1))))
        np.testing.assert_allclose([*found["roll"], *found["pitch"]], (roll, -pitch), rtol=1e-6)


def walking(strides=22, apex=0.02):
    """A trot at 2 Hz for 11 s, at the rate of control and of the physics; the second foot bounces in every stride."""
    steps = 25 * strides
    t = np.arange(steps) * DT
    columns = np.stack(stride([apex] * strides), axis=-1)
    height, rise, contact = (np.repeat(column[:, None, None], 4, axis=2) for column in np.moveaxis(columns, -1, 0))
    for i in range(strides):
        bounce(height[:, 0, 1], contact[:, 0, 1], i * STRIDE + 80, 0.003)
    position = np.tile(MINI_QUADRUPED.stance, (steps, 1, 1))
    position[:, 0, 0::2] += 0.3 * np.sin(2 * np.pi * 2.0 * t)[:, None]
    orientation = from_roll_pitch_yaw(np.stack([0.05 * np.ones(steps), 0.02 * np.sign(np.sin(20 * t)), t], axis=-1))
    base = np.concatenate([np.tile([0.0, 0.0, 0.184], (steps, 1)), orientation], axis=1)
    rollout = synthetic_rollout(
        steps, base_pose=base[:, None], joint_position=position, velocity=np.tile([0.3, 0.0], (steps, 1, 1))
    )
    joints = np.ones((len(height), 1, 8))
    force = np.where(contact, 10.0, 0.0)
    force[2000, 0, 2] = 3.0 * MINI_QUADRUPED.total_mass * 9.81
    return replace(rollout, physics=PhysicsSamples(height, rise, force, 0.04 * contact, 0.5 * joints))


def test_measures_of_a_synthetic_gait():
    values, every = gait_measures(walking()), measures.measure(walking())
    assert {*values, *steady._GAIT_MEASURES} <= measures.METRICS.keys()
    for name in measures.OF_FEET:
        assert values[name].shape == (1, 4)
        assert every[name].shape == (1,)
    assert (every["bounces_per_stride"], every["duty_factor"]) == pytest.approx((1.0, 0.585), abs=0.06)
    np.testing.assert_allclose(values["stride_frequency"], 2.0, rtol=2e-3)
    np.testing.assert_allclose(values["clearance"], 0.02)
    np.testing.assert_allclose(values["apex"], 0.02)
    np.testing.assert_allclose(values["touchdowns_per_stride"], [[1.0, 2.0, 1.0, 1.0]], atol=0.06)
    np.testing.assert_allclose(values["bounces_per_stride"], [[0.0, 1.0, 0.0, 0.0]], atol=0.06)
    np.testing.assert_allclose(values["landing_speed"], 0.3, rtol=1e-6)
    np.testing.assert_allclose(values["slip"], 0.04)
    np.testing.assert_allclose(values["duty_factor"], [[0.6, 0.54, 0.6, 0.6]], atol=0.01)
    weight = MINI_QUADRUPED.total_mass * 9.81
    np.testing.assert_allclose(values["peak_force"], [[10.0 / weight, 10.0 / weight, 3.0, 10.0 / weight]], rtol=1e-6)
    np.testing.assert_allclose(values["torque_rate"], 0.0)
    np.testing.assert_allclose(values["roll"], 0.05)
    np.testing.assert_allclose(values["pitch"], 0.02, rtol=1e-2)
    assert every["joint_limit_share"] == every["speed_limit_share"] == 0.0


def test_gait_of_an_episode_with_a_fall_or_at_another_speed_earns_nothing():
    part, walked = replace(PART, commands=((0.3, 0.0),), num_seeds=1), walking()
    late_fall = np.zeros_like(walked.fell)
    late_fall[-1] = True
    slow = np.array([1.0 - 0.065 / 0.3, 1.0], np.float32) * walked.velocity  # half way from 0.03 to 0.1 m/s
    for changes, accuracy in (
        ({}, 1.0),
        ({"velocity": slow}, 0.5),
        ({"fell": late_fall}, 0.0),
        ({"velocity": 1.5 * walked.velocity}, 0.0),
    ):
        measured = SimpleNamespace(robot=MINI_QUADRUPED, run=lambda *_, **__: replace(walked, **changes))  # noqa: B023
        found = steady.run_gait(part, measured)
        assert found["commands"][0]["accuracy"] == pytest.approx(accuracy, abs=1e-5)
        quality = (1.0 + 0.5 + 0.2 / 0.3 + 1.0) / 4.0  # the second foot touches down twice, and all land at 0.3 m/s
        assert found["contributions"] == pytest.approx([accuracy * quality], abs=0.01)


def test_measure_of_all_feet_is_the_one_of_the_worst_foot_or_a_mean():
    feet = np.array([[1.0, 3.0, 2.0]])
    found = {name: float(of_feet(feet)[0]) for name, of_feet in measures.OF_FEET.items()}
    assert (found.pop("clearance"), found.pop("apex"), found.pop("duty_factor")) == (1.0, 2.0, 2.0)
    assert set(found.values()) == {3.0}


def test_physics_samples_hold_every_physics_step():
    soles = []

    def record(task, step):
        soles.append(task.context.sole_height.copy())

    seeds = [1_600_000, 1_600_001]
    rollout = roll_out(GaitController(), [(0.3, 0.0)], seeds, 3.0, before_step=record, physics=True)
    physics = rollout.physics
    assert physics.height.shape == (150 * 4, 2, 4)
    # The first physics step of a control step begins where the control step before has ended.
    np.testing.assert_allclose(physics.height[::4], soles, atol=1e-6)
    found = gait_measures(rollout)
    assert 0.1 < found["landing_speed"].min() < found["landing_speed"].max() < 1.5
    assert 1.0 < found["peak_force"].max() < 15.0
    np.testing.assert_array_equal(rollout.select([1]).physics.force[:, 0], physics.force[:, 1])


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({}, 1.0),
        ({"clearance": [0.02, 0.004, 0.02, 0.02]}, (0.4 + 3.0) / 4.0),
        ({"touchdowns_per_stride": [1.0, 0.5, 1.2, 1.0]}, (0.5 + 3.0) / 4.0),
        ({"touchdowns_per_stride": [1.0, 1.0, 2.5, 1.0]}, (0.4 + 3.0) / 4.0),
        ({"landing_speed": [0.4, 0.2, 0.2, 0.2]}, (0.5 + 3.0) / 4.0),
        ({"slip": [0.1, 0.0, 0.0, 0.0]}, (0.5 + 3.0) / 4.0),
        ({"landing_speed": [0.1, math.nan, 0.1, 0.1]}, 0.0),
        ({"clearance": [math.nan] * 4}, 0.0),
    ],
)
def test_score_of_a_gait(changes, expected):
    good = {
        "clearance": [0.02, 0.02, 0.02, 0.02],
        "touchdowns_per_stride": [1.0, 1.0, 1.0, 1.0],
        "landing_speed": [0.1, 0.2, 0.0, 0.1],
        "slip": [0.01, 0.0, 0.0, 0.05],
    }
    values = {name: np.array([{**good, **changes}[name], value]) for name, value in good.items()}
    np.testing.assert_allclose(steady.gait_scores(values, PART), [expected, 1.0])


def on_a_line(sideways, turning, heading=0.7, command=(0.3, 0.0), steps=550):
    """A robot that walks ahead at 0.3 m/s, and to its left and about the vertical at constant rates, from a heading."""
    t = np.arange(1, steps + 1) * DT
    way = heading + turning * t
    velocity = 0.3 * np.stack([np.cos(way), np.sin(way)], axis=-1)
    velocity += sideways * np.stack([-np.sin(way), np.cos(way)], axis=-1)
    base = np.tile([0.0, 0.0, 0.184, 1.0, 0.0, 0.0, 0.0], (steps, 1, 1))
    base[:, 0, :2] = np.cumsum(velocity, axis=0) * DT
    base[:, 0, 3:] = from_roll_pitch_yaw(np.stack([0 * t, 0 * t, way], axis=-1))
    return synthetic_rollout(steps, base_pose=base, command=np.tile(command, (steps, 1, 1)))


@pytest.mark.parametrize(
    ("walked", "sideways", "heading"),
    [
        (on_a_line(0.0, 0.0), 0.0, 0.0),
        (on_a_line(-0.04, 0.0), 0.04, 0.0),
        (on_a_line(0.0, -0.03), 0.0, 0.3),  # a known angle: 0.3 rad to the right after 10 s
        (on_a_line(0.02, 0.4, heading=2.0, command=(0.3, 0.5)), 0.02, 1.0),  # through the jump from pi to -pi
    ],
)
def test_drifts_are_those_of_the_path_in_the_world(walked, sideways, heading):
    found = measures.measure(walked)
    assert found["sideways_drift"] == pytest.approx(sideways, abs=2e-3)
    assert found["heading_drift"] == pytest.approx(heading, abs=1e-4)
    # What happens in the first second or after a fall does not count.
    fell, pose = walked.fell.copy(), walked.base_pose.copy()
    fell[300, 0] = True
    pose[301:], pose[:25] = np.nan, 0.5
    again = measures.measure(replace(walked, fell=fell, base_pose=pose))
    assert again["sideways_drift"] == pytest.approx(sideways, abs=2e-3)
    assert again["heading_drift"] == pytest.approx(heading, abs=1e-4)
