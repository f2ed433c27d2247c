"""Safety of the live controller, with a manual clock and measurements that the tests set."""

import math

import numpy as np
import pytest
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, VELOCITY_LIMIT
from live_bench import EPOCH, LEVEL, LYING, PERIOD, Bench, Recording

from quadruped_env import JOINT_NAMES, QuadrupedError, SinusoidalGait
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import Mode, Safety
from quadruped_env.control.timestamp_filter import TimestampFilter
from quadruped_env.live.messages.imu_messages import read_imu
from quadruped_env.live.messages.joint_messages import (
    JointReader,
    command_message,
    read_target,
)
from quadruped_env.policies import GaitController, PolicyController, load_policy, task_of
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.readings import Readings
from quadruped_env.ros import cdr
from quadruped_env.simulation import SingleSimulation, build_model
from quadruped_env.task import Task
from quadruped_env.utils.rotations import rotate_inverse

ROW = np.zeros(1, dtype=np.intp)

pytest.importorskip("rosbags")


def test_live_controller_waits_for_fresh_states():
    bench = Bench()
    assert bench.pass_time(5.0, states=False) == []
    assert bench.mode is Mode.WAITING
    assert bench.pass_time(0.19) == []
    bench.pass_time(0.02)
    assert bench.mode is Mode.RAMPING


def test_live_controller_ramps_from_the_measured_pose_to_the_stance_before_it_walks():
    bench = Bench()
    answers = bench.pass_time(0.2 + 2.0)
    targets = np.array([answer.target for answer in answers])
    np.testing.assert_allclose(targets[0], LYING, atol=1e-6)
    np.testing.assert_allclose(targets[-1], STANCE, atol=1e-12)
    speeds = np.abs(np.diff(targets, axis=0)) / 0.02
    assert 0.0 < speeds.max() <= 1.5 * Safety().ramp_speed + 1e-6
    assert np.all(np.abs(np.diff(targets[:, 1])) <= np.abs(targets[0, 1] - STANCE[1]))
    assert np.all(np.diff(targets[:, 1]) <= 1e-12)  # straight there
    assert bench.mode is Mode.WALKING
    # 1 s of ramp and 0.5 s of settling before the first step.
    first = next(i for i, _ in enumerate(bench.controller.commands))
    assert first == 0
    assert len(bench.controller.commands) == pytest.approx((2.0 - 1.5) / 0.02, abs=2)


def test_joint_commands_have_the_control_rate_and_the_timestamps_of_their_states():
    answers = Bench().walk().pass_time(1.0, command=(0.3, 0.0))
    stamps = np.array([answer.stamp for answer in answers])
    assert len(stamps) == 50
    assert set(np.diff(stamps)) == {20_000_000}


@pytest.mark.parametrize(("early", "answered"), [(4_000_000, -4_000_000), (6_000_000, 10_000_000)])
def test_state_with_an_early_timestamp_is_answered_up_to_a_quarter_of_a_control_step(early, answered):
    """Timestamps of real robots jitter. A state that is too early leaves its tick to the next one, 10 ms later."""
    bench = Bench().walk()
    grid = bench.answers[-1].stamp
    for i in range(1, 101):
        bench.now += PERIOD
        bench.feed(grid + 10_000_000 * i - (early if i % 4 == 2 else 0))
    off = [answer.stamp - grid - 20_000_000 * tick for tick, answer in enumerate(bench.answers[-50:], start=1)]
    assert off == [answered, 0] * 25


@pytest.mark.parametrize("mode", [Mode.RAMPING, Mode.WALKING])
def test_live_controller_holds_after_a_fifth_of_a_second_without_states(mode):
    bench = Bench()
    if mode is Mode.WALKING:
        bench.walk()
    else:
        bench.pass_time(0.6)
    assert bench.mode is mode
    stamp = bench.answers[-1].stamp
    between = bench.pass_time(0.19, states=False)
    assert bench.mode is mode
    # Until then, control ticks use the newest state.
    assert len(between) == pytest.approx(9, abs=1)
    assert {answer.stamp for answer in between} == {stamp}
    held = bench.pass_time(0.3, states=False)
    assert bench.mode is Mode.HOLDING
    assert len(held) == pytest.approx(15, abs=1)
    # The first one may still belong to a control tick.
    assert all(np.array_equal(answer.target, held[1].target) for answer in held[1:])


def test_live_controller_goes_limp_after_a_second_without_states_and_then_waits():
    bench = Bench().walk()
    bench.pass_time(0.99, states=False)
    assert bench.mode is Mode.HOLDING
    answers = bench.pass_time(0.04, states=False)
    assert answers[-1].target is LIMP
    assert bench.pass_time(4.0, states=False) == []
    assert bench.mode is Mode.WAITING
    assert "limp (no state for 1 s)" in bench.said


def test_live_controller_ramps_from_the_measured_pose_when_states_come_back():
    bench = Bench().walk()
    bench.pass_time(5.0, states=False)
    bench.positions = np.array([-0.4, -1.9] * 4)
    answers = bench.pass_time(0.5)
    assert bench.mode is Mode.RAMPING
    np.testing.assert_allclose(answers[0].target, bench.positions, atol=1e-6)
    bench.pass_time(8.0)
    assert bench.mode is Mode.WALKING


def test_live_controller_follows_the_command_and_stands_half_a_second_after_the_last():
    bench = Bench().walk((0.3, 0.1))
    bench.controller.commands.clear()
    bench.pass_time(0.2, command=(0.3, 0.1))
    assert set(map(tuple, bench.controller.commands)) == {(0.3, 0.1)}
    bench.controller.commands.clear()
    bench.pass_time(0.5)
    assert set(map(tuple, bench.controller.commands)) == {(0.3, 0.1)}
    bench.pass_time(0.05)
    bench.controller.commands.clear()
    bench.pass_time(1.0)
    # It approaches zero at 1 m/s^2 and 4 rad/s^2; two steps of that are before the first one here.
    expected = np.maximum([0.3, 0.1] - np.arange(3, 53)[:, None] * [0.02, 0.08], 0.0)
    np.testing.assert_allclose(bench.controller.commands, expected, atol=1e-12)
    assert bench.mode is Mode.WALKING


def test_velocity_command_from_before_the_clock_was_set_back_no_longer_counts():
    """Its time of receipt lies in the future then, so that its age would never exceed 0.5 s."""
    bench = Bench().walk((0.3, 0.1))
    bench.now -= 40.0
    bench.live_controller.restart("the clock was set back")
    assert not bench.live_controller.moving(bench.now)
    bench.controller.commands.clear()
    bench.pass_time(3.0)
    assert bench.mode is Mode.WALKING
    assert set(map(tuple, bench.controller.commands)) == {(0.0, 0.0)}


def test_velocity_command_out_of_range_is_clipped():
    bench = Bench().walk((9.0, -9.0))
    assert bench.controller.commands[-1] == [0.6, -0.8]
    clipped = "/cmd_vel: forward_velocity = 9 is outside -0.3 to 0.6 m/s, and is clipped to it"
    assert bench.said.count(clipped) == 1
    bench.pass_time(2.0, command=(0.3, 0.0))
    bench.pass_time(0.2, command=(9.0, 0.0))
    assert bench.said.count(clipped) == 2


@pytest.mark.parametrize("command", [(math.nan, 0.0), (0.0, math.inf)])
def test_velocity_command_that_is_not_finite_is_refused_and_the_last_one_stays(command):
    bench = Bench().walk((0.3, 0.0))
    with pytest.raises(QuadrupedError, match=r"/cmd_vel: .* is not finite"):
        bench.live_controller.command(command, bench.now)
    bench.pass_time(0.3)
    assert bench.controller.commands[-1] == [0.3, 0.0]
    bench.pass_time(0.6)
    assert bench.controller.commands[-1] == [0.0, 0.0]


def test_a_fallen_robot_goes_limp_and_stays_so_until_it_is_put_up():
    bench = Bench().walk()
    bench.orientation = np.array([math.cos(0.6), math.sin(0.6), 0.0, 0.0])  # 1.2 rad of roll
    answers = bench.pass_time(3.0)
    assert [answer.target for answer in answers] == [LIMP]
    assert bench.mode is Mode.LIMP
    assert any("fallen" in text for text in bench.said)
    bench.orientation = LEVEL
    bench.pass_time(0.5)
    assert bench.mode is Mode.RAMPING


@pytest.mark.parametrize("asked", [1e3, -1e3])
def test_joint_targets_of_an_extreme_controller_stay_within_range_and_speed(asked):
    bench = Bench(Recording(np.full(8, asked)))
    bench.walk()
    targets = np.array([answer.target for answer in bench.answers])
    assert np.all(targets >= JOINT_POSITION_LOW)
    assert np.all(targets <= JOINT_POSITION_HIGH)
    speeds = np.abs(np.diff(targets, axis=0)) / 0.02
    assert speeds.max() == pytest.approx(VELOCITY_LIMIT)
    np.testing.assert_allclose(targets[-1], JOINT_POSITION_HIGH if asked > 0 else JOINT_POSITION_LOW)


def test_repeated_and_reordered_states_are_refused_and_change_nothing():
    """Every state ten times, and old ones in between: the answers equal the clean stream's."""
    clean, dirty = Bench(), Bench()
    clean.pass_time(4.0, command=(0.3, 0.0))
    stamps = []
    for _ in range(400):
        dirty.now += PERIOD
        dirty.live_controller.command((0.3, 0.0), dirty.now)
        dirty.feed()
        stamps.append(EPOCH + round(dirty.now * 1e9))
        for stamp in [stamps[-1]] * 9 + stamps[-4:-1]:
            with pytest.raises(QuadrupedError, match="not later than the one before"):
                dirty.feed(stamp)
    assert len(dirty.answers) == len(clean.answers)
    for one, other in zip(dirty.answers, clean.answers, strict=True):
        assert one.stamp == other.stamp
        np.testing.assert_array_equal(one.target, other.target)


def test_late_states_at_the_beginning_do_not_become_the_reference():
    """Delayed states come first, then current ones: it starts with the current ones."""
    bench = Bench()
    for _ in range(5):
        bench.now += PERIOD
        bench.feed(EPOCH + round((bench.now - 0.5) * 1e9))
    bench.now += PERIOD
    with pytest.raises(QuadrupedError, match="or earlier messages were late"):
        bench.feed()
    bench.pass_time(1.5, states=False)
    bench.pass_time(2.0)
    assert bench.mode is Mode.WALKING


def test_clock_that_jumps_ahead_is_rejected_until_the_filter_restarts():
    """The clock of a restarted simulator may differ widely."""
    bench = Bench().walk()
    shift = -(10**15)
    for _ in range(120):
        bench.now += PERIOD
        if bench.mode is Mode.WALKING:
            with pytest.raises(QuadrupedError, match="not later"):
                bench.feed(EPOCH + shift + round(bench.now * 1e9))
        bench.live_controller.silent(bench.now)
    assert bench.mode is Mode.WAITING
    for _ in range(300):
        bench.now += PERIOD
        bench.feed(EPOCH + shift + round(bench.now * 1e9))
    assert bench.mode is Mode.WALKING


def test_timestamp_filter_tolerates_clocks_that_drift():
    timestamps = TimestampFilter("/test")
    for second in range(0, 3600):
        assert timestamps.refusal(round(second * 1e9), second * 1.0005) == ""
    assert "jumped ahead" in timestamps.refusal(round(3600.5e9), 3600.5)


def test_states_that_are_later_little_by_little_are_refused():
    timestamps = TimestampFilter("/test")
    lags = [0.03 * i for i in range(10)]
    refusals = [timestamps.refusal(round(i * 2e7), i * 0.02 + lag) for i, lag in enumerate(lags)]
    assert ["late" in refusal for refusal in refusals] == [lag > 0.2 for lag in lags]


def joint_state(**changes):
    fields = {"name": list(JOINT_NAMES), "position": STANCE, "velocity": np.zeros(8), "effort": ()}
    return cdr.serialize(cdr.message("sensor_msgs/msg/JointState", header=cdr.header(1), **(fields | changes)))


def imu(**changes):
    fields = {"orientation": {"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0}}
    return cdr.message("sensor_msgs/msg/Imu", header=cdr.header(5), **(fields | changes))


def test_an_attitude_is_read_in_this_packages_order():
    read = read_imu(imu(orientation={"w": 0.5, "x": 0.1, "y": -0.7, "z": 0.5}, angular_velocity={"x": 1, "z": 3}))
    np.testing.assert_allclose(read.orientation, [0.5, 0.1, -0.7, 0.5])
    np.testing.assert_array_equal(read.angular_velocity, [1.0, 0.0, 3.0])
    assert read.stamp == 5


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"orientation": {"w": math.nan}}, "not finite"),
        ({"angular_velocity": {"x": math.inf}}, "not finite"),
        ({"orientation": {"w": 0.0, "x": 0.0, "y": 0.0, "z": 0.0}}, "length 0; send a unit quaternion"),
        ({"orientation_covariance": [-1.0] + [0.0] * 8}, "no orientation"),
    ],
)
def test_an_attitude_that_cannot_be_used_is_refused(changes, words):
    with pytest.raises(QuadrupedError, match=words):
        read_imu(imu(**changes))


def test_commands_are_read_as_they_are_written():
    read = JointReader(MINI_QUADRUPED)
    command = command_message(MINI_QUADRUPED, 7, STANCE)
    np.testing.assert_array_equal(read_target(read(command)), STANCE)
    assert read(command).stamp == 7
    assert read_target(read(command_message(MINI_QUADRUPED, 7, LIMP))) is LIMP
    with pytest.raises(QuadrupedError, match="has no positions"):
        read_target(read(joint_state(position=(), velocity=np.ones(8))))
    with pytest.raises(QuadrupedError, match="has no positions"):
        read_target(read(joint_state(position=(), velocity=(), effort=np.ones(8))))


@pytest.mark.parametrize("kind", ["policy", "gait"])
def test_readings_of_a_real_robot_give_the_same_joint_targets_as_the_environment(kind):
    """The environment's controller, and one that only receives what a robot measures, give the same joint targets."""
    if kind == "policy":
        controller = PolicyController(load_policy("flat"))
    else:
        controller = GaitController(SinusoidalGait.preset("trot"), "trot")
    config = task_of(controller).randomized("none")
    simulation = SingleSimulation(build_model(config.physics_timestep, config.motor))
    asked = []
    original = simulation.step
    simulation.step = lambda target, *rest: (asked.append(target[0].copy()), original(target, *rest))
    task = Task(simulation, config)
    task.reset(ROW, seeds=[4], command=(0.4, 0.2))
    control = ControlInterface(MINI_QUADRUPED, config.control)
    control.reset(ROW, task.control.phase, task.command)
    measured, observation = Readings.of_a_real_robot(MINI_QUADRUPED), task.observe()
    for _ in range(100):
        readings = simulation.readings
        for name in ("joint_position", "joint_velocity", "orientation", "angular_velocity_b"):
            getattr(measured, name)[:] = getattr(readings, name)
        measured.up_b[0] = rotate_inverse(readings.orientation[0], [0.0, 0.0, 1.0])
        np.testing.assert_allclose(measured.up_b, readings.up_b, atol=1e-12)
        seen = control.observe(measured)
        np.testing.assert_allclose(seen, observation, atol=1e-6)
        control.advance()
        target = control.within_limits(controller.act(seen, control))
        observation = task.act(controller, observation).observation
        np.testing.assert_allclose(target[0], asked[-1], atol=1e-6)
