"""Input of real robots: joints in several messages or unknown ones, no velocities, an IMU that is mounted turned."""

import dataclasses
import math
import re
import time
from types import SimpleNamespace

import numpy as np
import pytest
from built_in import STANCE
from live_bench import Bench
from live_nodes import STAMP, joint_state, received_from
from waiting import wait_until

from quadruped_env import JOINT_NAMES, QuadrupedError
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.live_controller import LiveController, Measurement, Mode
from quadruped_env.live.control_time import SystemTime
from quadruped_env.live.controller_inputs import Measurements, VelocityCommands
from quadruped_env.live.live_robot import LiveRobot
from quadruped_env.live.messages.imu_messages import Imu, in_base
from quadruped_env.live.messages.joint_messages import JointMerger, JointReader, Joints, Period
from quadruped_env.live.middleware.topics import (
    CMD_VEL,
    CMD_VEL_STAMPED,
    IMU,
    JOINT_COMMANDS,
    JOINT_STATES,
    TF,
)
from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import SENSOR_DATA_QOS, Qos, cdr

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

MS = 1_000_000
FRONT, HIND = np.arange(4), np.arange(4, 8)


def read(stamp=STAMP, **fields):
    return JointReader(MINI_QUADRUPED, states=True)(cdr.serialize(joint_state(stamp, **fields)))


def part(stamp, joints, positions, velocities=None):
    """A message with some of the joints."""
    arrays = [np.full(8, np.nan), None if velocities is None else np.full(8, np.nan)]
    arrays[0][joints] = positions
    if velocities is not None:
        arrays[1][joints] = velocities
    return Joints(stamp, *arrays, None)


def test_state_with_some_joints_and_others_is_read():
    found = read(
        names=("gripper", "RH_knee_joint", "LF_hip_joint"), position=(9.0, -1.0, 0.5), velocity=(0.0, math.nan, 2.0)
    )
    np.testing.assert_array_equal(found.positions, [0.5, *[math.nan] * 6, -1.0])
    np.testing.assert_array_equal(found.velocities, [2.0, *[math.nan] * 7])
    assert found.others == ("gripper",)
    # Messages of another device are no error, whatever they lack.
    assert np.isnan(read(0, names=("wheel",), position=(), velocity=(1.0,)).positions).all()


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"stamp": 0}, "the timestamp is empty"),
        ({"position": ()}, "holds no positions"),
        ({"position": (math.nan,) * 8}, "position of LF_hip_joint is nan"),
        ({"velocity": (math.inf,) * 8}, "velocity of LF_hip_joint is inf"),
        ({"names": ("LF_hip_joint",) * 8}, "one comes twice"),
        ({"names": (), "position": (0.0,) * 12}, "position holds 12 values for 0 names"),
    ],
)
def test_state_that_cannot_be_used_is_refused(changes, words):
    with pytest.raises(QuadrupedError, match=words):
        read(**changes)


def test_parts_of_a_state_are_merged_when_each_joint_was_measured():
    merger = JointMerger(MINI_QUADRUPED, velocities=False)
    assert "LF_hip_joint and 7 more on /joint_states" in merger.missing
    assert merger.add(part(STAMP, FRONT, 1.0)) is None
    assert "LH_hip_joint and 3 more on /joint_states" in merger.missing
    assert merger.add(part(STAMP + 5 * MS, FRONT, 2.0)) is None
    state = merger.add(part(STAMP + 6 * MS, HIND, 3.0, 0.5))
    assert (state.stamp, merger.missing) == (STAMP + 6 * MS, "")
    np.testing.assert_array_equal(state.positions, [2.0] * 4 + [3.0] * 4)
    np.testing.assert_array_equal(state.velocities, [math.nan] * 4 + [0.5] * 4)
    # A part that stops is not replaced by its last value.
    assert all(merger.add(part(STAMP + i * MS, FRONT, 4.0)) is None for i in range(10, 500, 10))
    assert merger.missing == "LH_hip_joint on /joint_states: 0.48 s older than LF_hip_joint"
    assert merger.add(part(STAMP + 7 * MS, HIND, 3.0)) is None
    # The clock of a restarted simulator is another one.
    assert merger.add(part(10 * MS, FRONT, 1.0)) is None
    assert merger.add(part(11 * MS, HIND, 1.0)).stamp == 11 * MS


def test_names_that_are_not_the_robots_are_in_the_reason():
    merger = JointMerger(MINI_QUADRUPED, velocities=False)
    assert merger.add(read(names=[f"{name}s" for name in JOINT_NAMES])) is None
    assert merger.missing == (
        "LF_hip_joint and 7 more on /joint_states, which holds 'LF_hip_joints', 'LF_knee_joints', 'RF_hip_joints', "
        "'RF_knee_joints', ..."
    )


def test_missing_velocities_are_differences_of_positions_through_a_low_pass_filter():
    said = []
    merger = JointMerger(MINI_QUADRUPED, velocities=True, say=said.append)
    positions = np.array([0.0, 0.02, 0.03, 0.03])
    stamps = STAMP + np.array([0, 10, 30, 30]) * MS
    assert merger.add(part(int(stamps[0]), FRONT, positions[0])) is None
    assert merger.add(part(int(stamps[0]), HIND, positions[0], 7.0)) is None
    found = []
    for stamp, position in zip(stamps[1:].tolist(), positions[1:], strict=True):
        assert merger.add(part(stamp, HIND, position, 7.0)) is None
        found.append(merger.add(part(stamp, FRONT, position)).velocities)
    # Slopes 2 and 0.5 rad/s; over 20 ms the filter of 10 ms keeps exp(-2) of its value. The last timestamp is repeated.
    second = 0.5 + math.exp(-2.0) * (2.0 - 0.5)
    np.testing.assert_allclose(found, [[v] * 4 + [7.0] * 4 for v in (2.0, second, second)])
    assert said == [
        "/joint_states: no velocities; they are computed from the positions, with a low-pass filter of 10 ms"
    ]


@pytest.mark.parametrize(("period", "tolerance"), [(1, 0.02), (20, 0.03), (100, 0.15), (1000, 0.2)])
def test_tolerance_is_one_and_a_half_periods_whatever_is_lost(period, tolerance):
    stream = Period()
    assert stream.tolerance == 0.02
    for i in (0, 1, 2, 2, 3, 9, 10, 11):
        stream.add(STAMP + i * period * MS)
    assert stream.tolerance == pytest.approx(tolerance)


@pytest.mark.parametrize("age", [0.03, -0.03])
def test_imu_that_is_older_or_newer_than_the_joints_by_more_than_the_tolerance_is_refused(age):
    stream, level = Period(), np.array([1.0, 0.0, 0.0, 0.0])
    merger, repetition = SimpleNamespace(period=stream), SimpleNamespace(frozen=False)
    fields = {"_merger": merger, "_repetition": repetition, "_imu_period": stream, "_base": "base", "_mount": None}
    joints = Joints(STAMP, STANCE, np.zeros(8), None)

    def paired(age):
        imu = Imu(STAMP - round(age * 1e9), level, np.zeros(3), "")
        return Measurements._paired(SimpleNamespace(**fields), joints, imu)

    assert paired(age / 2).stamp == STAMP
    with pytest.raises(QuadrupedError, match=f"0.03 s {'older' if age > 0 else 'newer'} than /joint_states, over 0.02"):
        paired(age)


HALF = math.sqrt(0.5)
YAWED, ROLLED = (HALF, 0.0, 0.0, HALF), (HALF, HALF, 0.0, 0.0)


def test_imu_is_turned_into_the_base_frame():
    """A sensor with its x axis to the robot's left, while the robot is rolled by 90 degrees and rolls further."""
    imu = Imu(STAMP, np.array([0.5, 0.5, -0.5, 0.5]), np.array([0.0, -1.0, 0.2]), "imu_link")
    mounted = in_base(imu, "base_link", np.array(YAWED))
    np.testing.assert_allclose(mounted.orientation, ROLLED, atol=1e-12)
    np.testing.assert_allclose(mounted.angular_velocity, [1.0, 0.0, 0.2], atol=1e-12)
    for frame in ("", "base_link", "/base_link"):
        assert in_base(imu._replace(frame=frame), "base_link", None).orientation is imu.orientation
    with pytest.raises(QuadrupedError, match=r"in the frame 'imu_link' and not in 'base_link'; .*--imu-mount"):
        in_base(imu, "base_link", None)


def test_waiting_controller_says_why():
    bench = Bench()
    assert bench.live_controller.waiting_for == "fresh states"
    bench.orientation = np.array([math.cos(0.6), math.sin(0.6), 0.0, 0.0])
    bench.pass_time(0.1)
    assert bench.live_controller.waiting_for == "an upright robot: tilted by 69 degrees"
    bench.orientation = np.array([1.0, 0.0, 0.0, 0.0])
    for _ in range(50):
        bench.positions[2] += 0.004
        bench.pass_time(0.01)
    assert bench.live_controller.waiting_for == "a robot at rest: RF_hip_joint moves at 0.4 rad/s"
    bench.pass_time(0.3)
    assert (bench.mode, bench.live_controller.waiting_for) == (Mode.RAMPING, "")


def test_only_a_policy_that_observes_velocities_needs_them():
    policy = load_policy("flat")
    assert LiveController(PolicyController(policy)).needs_velocities
    assert not Bench().live_controller.needs_velocities
    fields = tuple(field for field in policy.fields if field.name != "joint_velocity")
    width = sum(field.width(policy.robot) for field in fields) * policy.control.observation_history
    weights = 0.1 * np.random.default_rng(0).standard_normal((width, 8)).astype(np.float32)
    blind = dataclasses.replace(policy, fields=fields, weights=(weights,), biases=(np.zeros(8, np.float32),))
    live = LiveController(PolicyController(blind))
    assert not live.needs_velocities
    now, unknown = 50.0, np.full(8, np.nan)
    targets = []
    for i in range(400):
        at = STAMP + i * 10 * MS
        answer = live.measured(Measurement(at, STANCE, unknown, np.array([1.0, 0, 0, 0]), np.zeros(3)), now + i * 0.01)
        targets += [] if answer is None else [answer.target]
    assert live.mode is Mode.WALKING
    assert np.isfinite(targets).all()


def test_controller_moves_a_robot_that_sends_legs_apart_without_velocities_and_a_turned_imu(run_node, nodes):
    """At 50 Hz, with the IMU half a period apart, as no publisher of a real robot is in step with another."""
    driver = nodes("driver")
    states, attitudes = driver.publish(JOINT_STATES, Qos(50, reliable=False)), driver.publish(IMU)
    commands = driver.subscribe(JOINT_COMMANDS)
    log = run_node("controller", "--imu-mount", "0", "0", str(math.pi / 2))

    def send(imu=True):
        now = time.time_ns()
        turned = {"w": HALF, "z": -HALF}
        if imu:
            attitudes.send(cdr.message(IMU.type_name, header=cdr.header(now - 15 * MS, "imu"), orientation=turned))
        for leg in range(4):
            names = ("tail", *JOINT_NAMES[2 * leg + 1 : 2 * leg - 1 if leg else None : -1])
            states.send(joint_state(now, names, (0.1, STANCE[2 * leg + 1], STANCE[2 * leg])))
        time.sleep(0.02)

    wait_until(lambda: send() or commands.take(), lambda: log.said)
    assert log.said.count("they are computed from the positions") == 1
    # States alone give no command, and no reason is left to guess.
    wait_until(lambda: send(False) or re.search(r"waiting for /imu/data: no message .* for \d", log.said))
    assert re.search(r"refused: /imu/data: 0\.\d+ s older than /joint_states, over 0\.\d+ s", log.said)


def test_controller_says_that_positions_are_missing(run_node, nodes):
    """As with servos that report nothing."""
    driver = nodes("driver")
    states, attitudes = driver.publish(JOINT_STATES), driver.publish(IMU)
    log = run_node("controller", "tuned")

    def send():
        attitudes.send(cdr.message(IMU.type_name, header=cdr.header(time.time_ns()), orientation={"w": 1.0}))
        states.send(joint_state(time.time_ns(), position=()))

    reason = (
        r"waiting for /joint_states: no message that can be read for \d\.\d s: holds no positions; send one per joint"
    )
    wait_until(lambda: send() or re.search(reason, log.said), lambda: log.said, interval=0.02)


def test_state_and_view_use_the_joints_that_they_know(run_node, nodes):
    driver = nodes("driver")
    states, poses = driver.publish(JOINT_STATES), driver.subscribe(TF)
    view = LiveRobot(nodes("view"), MINI_QUADRUPED, pytest.fail)
    log = run_node("state")
    wait_until(lambda: states.readers == 2, lambda: log.said)
    states.send(joint_state(STAMP, ("arm",), (0.3,)))
    states.send(joint_state(STAMP, ("RH_knee_joint", "arm", "LF_hip_joint"), (-1.0, 0.3, 0.4)))
    (received,) = received_from(poses, 1)
    found = {one.child_frame_id: one.transform for one in poses.decode(received).transforms}
    truth = STANCE.copy()
    truth[[0, 7]] = 0.4, -1.0
    moved = {one.child: one for one in MINI_QUADRUPED.skeleton.joint_transforms(truth)}
    assert len(found) == 2
    for link, pose in found.items():
        turn = pose.rotation
        np.testing.assert_allclose([turn.w, turn.x, turn.y, turn.z], moved[link].rotation, atol=1e-12)
    wait_until(lambda: view.step() and view.receives_states)
    np.testing.assert_array_equal(view.step().joint_position, truth)
    states.send(joint_state(0))
    wait_until(lambda: "the timestamp is empty" in log.said, lambda: log.said)


def test_velocity_commands_of_both_types_are_received(nodes):
    """Also while a publisher of the other type, which has nothing to say, is there."""
    ours, nav2, user = nodes(), nodes("nav2"), nodes("user")
    received = []
    commands = VelocityCommands(
        SimpleNamespace(node=ours, refuse=pytest.fail),
        SimpleNamespace(command=lambda velocity, now: received.append(tuple(velocity))),
    )
    stamped, twists = nav2.publish(CMD_VEL_STAMPED, SENSOR_DATA_QOS), user.publish(CMD_VEL)
    wait_until(lambda: stamped.readers and twists.readers)
    fields = {"linear": {"x": 0.3, "y": 0.1}, "angular": {"z": -0.2}}
    stamped.send(cdr.message(CMD_VEL_STAMPED.type_name, twist=fields))
    wait_until(lambda: commands.take(SystemTime()) or received == [(0.3, -0.2, 0.1)])
    twists.send(cdr.message(CMD_VEL.type_name, linear={"x": 0.1}))
    wait_until(lambda: commands.take(SystemTime()) or received == [(0.3, -0.2, 0.1), (0.1, 0.0, 0.0)])
    # The later one of two that have arrived counts.
    twists.send(cdr.message(CMD_VEL.type_name, linear={"x": 0.1}))
    stamped.send(cdr.message(CMD_VEL_STAMPED.type_name, twist=fields))
    twists.send(cdr.message(CMD_VEL.type_name, linear={"x": 0.5}))
    wait_until(lambda: [len(one.entities[0].read(9)) for one in commands._subscriptions] == [2, 1])
    commands.take(SystemTime())
    assert received[2:] == [(0.5, 0.0, 0.0)]
    for node in (ours, nav2, user):
        assert node.graph.problems() == []
