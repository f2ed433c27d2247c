import math
from dataclasses import replace

import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.evaluation import measures
from quadruped_env.evaluation.measures import METRICS, measure, metrics_of
from quadruped_env.evaluation.rollout import FIRST_SEED, PhysicsSamples, roll_out
from quadruped_env.policies import GaitController, ZeroController
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.motors import JointMotor, MotorConfig
from quadruped_env.task import Task, TaskConfig

DT = 0.02
STEPS = 500  # 10 s
LATERAL = {"lateral_velocity", "lateral_velocity_error"}


def all_counted(steps=STEPS, rows=1):
    return np.ones((steps, rows), dtype=bool)


def columns(*series):
    """Series of length T as an array (T, N)."""
    return np.stack(series, axis=1)


def test_masked_mean_is_the_mean_of_counted_values_and_nan_without_any():
    values = np.array([[1.0, 5.0], [3.0, 7.0], [100.0, 9.0]])
    mask = np.array([[True, False], [True, False], [False, False]])
    np.testing.assert_equal(measures.masked_mean(values, mask), [2.0, np.nan])
    np.testing.assert_equal(measures.masked_mean(np.stack([values, 2 * values], -1), mask)[0], [2.0, 4.0])


def test_window_means_of_a_ramp():
    means, whole = measures.window_means(np.arange(60.0)[:, None], all_counted(60), DT)
    np.testing.assert_allclose(means[:, 0], 24.5 + np.arange(11))
    assert whole.all()


def test_tracking_error_is_the_offset_of_the_mean_and_ignores_the_swing_of_a_stride():
    t = np.arange(STEPS) * DT
    constant = np.full(STEPS, 0.25)
    swinging = 0.25 + 0.3 * np.sin(2 * np.pi * 2.0 * t)  # two whole strides in a window
    # Half the time 0.1 too slow, half 0.1 too fast: the windows in between average less.
    errors = measures.tracking_error(columns(constant, swinging), np.array([0.4, 0.4]), all_counted(rows=2), DT)
    np.testing.assert_allclose(errors, 0.15, atol=1e-12)
    # The error is 3 in windows within the first half, and 4 in those within the second; none in between counts.
    step = np.where(np.arange(100) < 50, 3.0, 4.0)[:, None]
    counted = all_counted(100)
    means, _ = measures.window_means(step, counted, DT)
    assert measures.tracking_error(step, np.zeros(1), counted, DT) == pytest.approx(math.sqrt((means**2).mean()))


def test_samples_after_a_fall_are_not_counted():
    velocity = np.full((STEPS, 2), 0.5)
    velocity[300:] = 1e9
    counted = all_counted(rows=2)
    counted[300:, 0] = False
    counted[20:, 1] = False  # falls before a whole window was seen
    errors = measures.tracking_error(velocity, np.full(2, 0.3), counted, DT)
    np.testing.assert_allclose(errors, [0.2, np.nan])
    np.testing.assert_allclose(measures.distance(velocity, counted, DT), [0.5 * 300 * DT, 0.5 * 20 * DT])


def test_cost_of_transport_by_hand():
    # 19.62 W / (4 kg * 9.81 m/s^2 * 0.5 m/s) = 1
    cost = measures.cost_of_transport(np.array([19.62, 19.62, 1.0]), np.array([0.5, -0.5, 0.01]), 4.0)
    np.testing.assert_allclose(cost, [1.0, 1.0, np.nan])


def test_power_in_a_rollout_is_that_of_the_torques_and_of_the_tasks_motors_in_every_physics_step(monkeypatch):
    samples, of = [], PhysicsSamples.of

    def keep(task):
        now = task.context.substeps
        samples.append((now.joint_torque.copy(), now.joint_velocity.copy()))
        return of(task)

    monkeypatch.setattr(PhysicsSamples, "of", keep)
    motors = MotorConfig(knee=JointMotor(stall_torque=8.0, no_load_speed=6.0))
    rollout = roll_out(GaitController(), [(0.3, 0.0)], [1], 3.0, TaskConfig(motor=motors), physics=True)
    values = measure(rollout)
    torque, speed = (np.concatenate(kind)[50 * 4 :, 0] for kind in zip(*samples, strict=True))
    mechanical = sum(max(0.0, t * w) for t, w in zip(torque.ravel(), speed.ravel(), strict=True)) / len(torque)
    heat = (torque[:, 0::2] ** 2).sum() * 5.0 / 10.0 + (torque[:, 1::2] ** 2).sum() * 6.0 / 8.0
    assert values["mechanical_power"] == pytest.approx([mechanical], rel=1e-5)
    assert values["electrical_power"] == pytest.approx([mechanical + heat / len(torque)], rel=1e-5)
    weight_times_speed = MINI_QUADRUPED.total_mass * 9.81 * values["forward_velocity"]
    assert values["electrical_cost_of_transport"] == pytest.approx(values["electrical_power"] / weight_times_speed)


def test_peak_is_the_largest_absolute_value_that_counts():
    values = np.zeros((STEPS, 2, 8))
    values[10, 0, 3] = -7.0
    values[11, 0, 0] = 5.0
    values[400, 0, 0] = 99.0
    counted = all_counted(rows=2)
    counted[300:] = False
    counted[:, 1] = False
    np.testing.assert_equal(measures.peak(values, counted), [7.0, np.nan])


def test_joint_acceleration_of_a_ramp_and_of_a_sine():
    t = np.arange(STEPS) * DT
    ramp = np.repeat(3.0 * t[:, None], 8, axis=1)
    omega = 2 * np.pi  # slow against the sampling, so that the difference quotient is the derivative
    sine = np.repeat(np.sin(omega * t)[:, None], 8, axis=1)
    rms = measures.rms_rate(np.stack([ramp, sine], axis=1), all_counted(rows=2), DT)
    assert rms[0] == pytest.approx(3.0)
    assert rms[1] == pytest.approx(omega / math.sqrt(2), rel=2e-3)


def test_joint_limit_share_is_the_share_of_time():
    position = np.tile(MINI_QUADRUPED.stance, (STEPS, 1, 1))
    position[:100, 0, 1] = -0.005  # a knee all but straight
    position[50:125, 0, 0] = 1.5
    assert measures.joint_limit_share(position, all_counted(), MINI_QUADRUPED) == pytest.approx(0.25)


def trot(frequency, duty, rows=1):
    """Contacts (T, rows, 4) of a trot and the joint positions (T, rows, 8) that go with it."""
    t = np.arange(STEPS) * DT
    phase = (frequency * t[:, None] + [0.0, 0.5, 0.5, 0.0]) % 1.0
    contact = phase < duty
    position = np.tile(MINI_QUADRUPED.stance, (STEPS, 1))
    position[:, 0::2] += 0.3 * np.sin(2 * np.pi * phase)
    return np.repeat(contact[:, None], rows, axis=1), np.repeat(position[:, None], rows, axis=1)


@pytest.mark.parametrize(("frequency", "duty"), [(1.27, 0.6), (2.2, 0.5), (3.9, 0.36)])
def test_a_synthetic_trot_has_its_duty_factor_and_stride_frequency(frequency, duty):
    contact, position = trot(frequency, duty, rows=2)
    counted = all_counted(rows=2)
    counted[350:, 1] = False  # falls after 7 s
    np.testing.assert_allclose(measures.masked_mean(contact, counted), duty, atol=0.02)
    np.testing.assert_allclose(measures.stride_frequency(position[..., 0::2], counted, DT), frequency, rtol=5e-3)


def test_standing_has_no_stride_frequency():
    position = np.tile(MINI_QUADRUPED.stance, (STEPS, 2, 1))
    counted = all_counted(rows=2)
    counted[:, 1] = False
    np.testing.assert_equal(measures.stride_frequency(position[..., 0::2], counted, DT), np.nan)


def test_slip_of_each_foot_while_it_is_on_the_ground():
    speed = np.array([[[1.0, 2.0, 3.0, 4.0]], [[3.0, 2.0, 3.0, 9.0]]])
    contact = np.array([[[True, True, False, True]], [[True, False, False, False]]])
    np.testing.assert_equal(measures.slip_of_feet(speed, contact, all_counted(2)), [[2.0, 2.0, np.nan, 4.0]])


def test_measuring_a_rollout_gives_every_metric_and_depends_on_seeds_alone():
    def run(seeds):
        return roll_out(GaitController(), [(0.0, 0.0), (0.3, 0.0)], seeds, seconds=4.0, physics=True)

    rollout = run([1, 2])
    values = measure(rollout)
    assert values.keys() == metrics_of(MINI_QUADRUPED).keys() == METRICS.keys() - LATERAL
    assert measure(replace(rollout, physics=None)).keys() < values.keys()
    assert all(value.shape == (4,) for value in values.values())
    np.testing.assert_equal(values["fall_rate"], 0.0)
    assert (values["forward_velocity"][:2] < 0.02).all()
    assert (values["forward_velocity"][2:] > 0.1).all()
    np.testing.assert_allclose(values["distance"][2:], values["forward_velocity"][2:] * 4.0, rtol=0.2)
    for kind in ("electrical", "mechanical"):
        assert np.isnan(values[f"{kind}_cost_of_transport"][:2]).all()
    assert (values["electrical_power"] > values["mechanical_power"]).all()
    assert values["peak_torque"].max() <= METRICS["peak_torque"].limit_of(rollout.robot) + 1e-3
    feet = measures.gait_measures(rollout)["clearance"]
    np.testing.assert_array_equal(values["clearance"], feet.min(axis=1))
    assert not np.array_equal(rollout.base_position[:, 2], rollout.base_position[:, 3])

    # The numbers of an env depend on its own seed and command only, and a selection has the same numbers.
    again = run([2])
    selected = rollout.select([1, 3])
    np.testing.assert_array_equal(again.base_position, selected.base_position)
    np.testing.assert_equal(measure(again)["distance"], values["distance"][[1, 3]])


def test_rollout_is_a_trace_of_float32_samples_after_each_step():
    rollout = roll_out(GaitController(), [(0.0, 0.0), (0.3, 0.1)], [1, 2], seconds=0.2)
    declared = rollout.quantities()
    types = {name: getattr(rollout, name).dtype for name in declared if name != "command"}
    assert types == {name: np.bool_ if name in ("fell", "contact") else np.float32 for name in types}
    np.testing.assert_array_equal(rollout.command, np.tile([[0.0, 0.0]] * 2 + [[0.3, 0.1]] * 2, (10, 1, 1)))
    assert rollout.command.strides[0] == 0
    one = rollout.env(3)
    assert one.seeds == (2,)
    np.testing.assert_array_equal(one.joints.stamps, 20_000_000 * np.arange(1, 11))
    np.testing.assert_array_equal(one.joints.efforts, rollout.joint_torque[:, 3])
    np.testing.assert_array_equal(rollout.select([3, 0]).seeds, [2, 1])


def test_commands_that_change_within_an_episode_are_recorded_from_the_step_that_follows_them():
    def change(task, step):
        if step == 3:
            task.set_command(np.array([1]), (0.2, 0.1))

    rollout = roll_out(GaitController(), [(0.0, 0.0), (0.3, 0.0)], [1], seconds=0.2, before_step=change)
    np.testing.assert_array_equal(rollout.command[:3], np.tile([[0.0, 0.0], [0.3, 0.0]], (3, 1, 1)))
    # Approached by 1 m/s^2 and 4 rad/s^2.
    np.testing.assert_allclose(rollout.command[3:, 1, 0], [0.3, 0.28, 0.26, 0.24, 0.22, 0.2, 0.2])
    np.testing.assert_allclose(rollout.command[3:, 1, 1], [0.0, 0.08, *[0.1] * 5])
    assert not rollout.command[:, 0].any()


class Collapse:
    """Swings every leg back until the base lies on the ground."""

    name = "collapse"
    action_mode = "position"

    def act(self, observation, control):
        return np.tile([1.5, 0.0], (control.num_envs, 4))


def test_fall_is_counted_once_and_ends_the_valid_samples():
    rollout = roll_out(Collapse(), [(0.0, 0.0)], [0, 1], seconds=2.0)
    assert rollout.fallen.all()
    assert (np.diff(rollout.valid.astype(int), axis=0) <= 0).all()
    np.testing.assert_array_equal(rollout.fell.sum(axis=0), 1)
    values = measure(rollout)
    np.testing.assert_equal(values["fall_rate"], 1.0)


@pytest.mark.parametrize(
    ("commands", "seeds", "seconds", "message"),
    [
        ([(2.0, 0.0)], [0], 1.0, "forward_velocity = 2 is outside"),
        ([(0.0, 0.0)], [], 1.0, "0 seeds"),
        ([(0.0, 0.0)], [0], 0.0, "0 s"),
        ([0.0, 0.0], [0], 1.0, r"shape \(K, 2\)"),
    ],
)
def test_invalid_rollout_is_refused_with_the_reason(commands, seeds, seconds, message):
    with pytest.raises(QuadrupedError, match=message):
        roll_out(ZeroController(), commands, seeds, seconds)


def test_slip_is_the_speed_of_the_lowest_point_of_each_foot(monkeypatch):
    read, act = [], Task.act

    def acted(self, *arguments):
        transition = act(self, *arguments)
        now = self.context.substeps
        read.append((now.foot_velocity.copy(), now.foot_angular_velocity.copy()))
        return transition

    monkeypatch.setattr(Task, "act", acted)
    walked = roll_out(GaitController(), [(0.3, 0.2)], [FIRST_SEED], 1.0, physics=True)
    velocity, angular_velocity = (np.concatenate(values) for values in zip(*read, strict=True))
    # The lowest point of a ball moves with the ball's centre and with its rotation.
    lowest = velocity + np.cross(angular_velocity, [0.0, 0.0, -MINI_QUADRUPED.foot_radius])
    expected = np.hypot(lowest[..., 0], lowest[..., 1])
    assert np.ptp(expected) > 0.05
    np.testing.assert_allclose(walked.physics.slip, expected, rtol=1e-4, atol=1e-6)


def test_contact_is_a_force_beyond_the_threshold():
    stands = TaskConfig().without_randomization()
    standing = roll_out(GaitController(), [(0.0, 0.0)], [FIRST_SEED], 1.0, stands)
    assert standing.contact.all(axis=-1)[25:].all(), "after it has come down"
    walking = roll_out(GaitController(), [(0.3, 0.0)], [FIRST_SEED], 2.0, stands, physics=True)
    in_the_air = walking.physics.height > 0.003
    assert in_the_air.any()
    assert not walking.physics.force[in_the_air].any()
