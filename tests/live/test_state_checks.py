"""Content of live states: an IMU that repeats itself, joints that freeze, two publishers or controllers."""

import time
from types import SimpleNamespace

import numpy as np
import pytest
from built_in import STANCE
from fake_robot import FakeRobot
from live_nodes import joint_state
from waiting import wait_until

from quadruped_env import JOINT_NAMES, QuadrupedError
from quadruped_env.live import single_publisher
from quadruped_env.live.messages.imu_messages import Imu
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, JOINT_STATES
from quadruped_env.live.state_checks import FrozenJoints, ImuRepetition

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

MS = 1_000_000
REST = np.zeros(16)


def repeated(count, period=10, moved=REST, content=b"same"):
    """An IMU that has sent one message, and `count` equal ones after it."""
    repetition = ImuRepetition()
    for i in range(count + 1):
        repetition.add(Imu(i * period * MS, None, None, "", content), REST if i < count else moved)
    return repetition


@pytest.mark.parametrize("period", [10, 20])
def test_imu_that_repeats_itself_for_a_fifth_of_a_second_while_the_robot_moves_is_frozen(period):
    moved = REST.copy()
    moved[3] = 0.02
    enough = 200 // period
    assert not repeated(enough - 1, period, moved).frozen
    repetition = repeated(enough, period, moved)
    assert repetition.frozen
    # It stays so at rest, until other numbers come.
    repetition.add(Imu(10**9, None, None, "", b"same"), moved)
    assert repetition.frozen
    repetition.add(Imu(2 * 10**9, None, None, "", b"other"), moved)
    assert not repetition.frozen


def test_imu_of_a_robot_that_rests_exactly_may_repeat_itself():
    """As a simulated one, of which the solver comes to rest."""
    assert not repeated(1000).frozen


def test_imu_that_repeats_itself_since_before_the_first_positions_is_frozen_once_they_change():
    repetition = repeated(100, moved=np.full(16, np.nan))
    for i, joints in enumerate((REST, REST, REST + 0.02)):
        repetition.add(Imu((1000 + 10 * i) * MS, None, None, "", b"same"), joints)
        assert repetition.frozen == (i == 2)


def trot(count, period=0.01):
    """Positions (count, 8) of legs that move by 0.3 rad at 2 Hz, with noise."""
    t = period * np.arange(count)[:, None]
    noise = np.random.default_rng(0).normal(0.0, 1e-4, (count, 8))
    return STANCE + 0.3 * np.sin(4.0 * np.pi * t + np.arange(8)) + noise


def problems_of(positions, targets):
    """Problems, and lines said, of a robot with these positions and targets (n, 8) every 10 ms."""
    said = []
    joints = FrozenJoints(JOINT_NAMES, said.append)
    for i, (row, target) in enumerate(zip(positions, targets, strict=True)):
        joints.commanded(target)
        joints.add(10**18 + i * 10 * MS, row)
    return joints.problems, said


def test_walking_robot_has_no_problem():
    assert problems_of(trot(300), trot(300)) == ((), [])


@pytest.mark.parametrize("value", [0.0, -0.4])
def test_joint_that_stays_at_one_position_while_others_move_is_named(value):
    positions = trot(300)
    positions[100:, 5] = value
    for targets, why in ((trot(300), "its target moves"), (np.broadcast_to(STANCE, (300, 8)), "other joints move")):
        problems, said = problems_of(positions, targets)
        expected = f"LH_knee_joint stays at exactly {value:.4g} rad for 1 s while {why}; check its encoder and motor"
        assert (list(problems), said) == ([expected], [expected]), "not again before 10 s"


def test_joint_of_a_robot_at_rest_or_with_few_states_is_not_called_frozen():
    at_rest = np.broadcast_to(STANCE, (300, 8))
    assert problems_of(at_rest, at_rest) == ((), [])
    few = trot(300)[::10]
    few[:, 5] = 0.0
    joints = FrozenJoints(JOINT_NAMES, pytest.fail)
    for i, row in enumerate(few):
        joints.commanded(row)
        joints.add(10**18 + i * 100 * MS, row)
    assert joints.problems == ()


def test_controller_names_a_frozen_joint_and_lets_go_when_the_imu_stops_measuring(run_node, nodes):
    with FakeRobot() as robot:
        log = run_node("controller", "trot")
        wait_until(lambda: "following the command" in log.said, lambda: log.said)
        robot.fault, words = "zero", "LH_hip_joint stays at exactly 0 rad"
        wait_until(lambda: words in log.said and words in robot.problems, lambda: log.said)
        robot.fault = ""
        wait_until(lambda: not robot.problems, lambda: log.said)
        other = nodes("other").publish(JOINT_STATES)

        def named():
            other.send(joint_state(time.time_ns(), JOINT_NAMES[:2], STANCE[:2]))
            return "sends LF_hip_joint too" in log.said and "end one of the two" in robot.problems

        wait_until(named, lambda: log.said, interval=0.01)
        assert not robot.limp
        robot.fault = "imu"
        wait_until(lambda: robot.limp, lambda: log.said)
        assert "/imu/data: repeats the same numbers bit for bit while the robot moves" in log.said
        targets = robot.targets
        wait_until(lambda: "waiting for /imu/data: repeats the same" in log.said, lambda: log.said)
        assert robot.targets == targets
        robot.fault = ""
        wait_until(lambda: log.said.count("following the command") > 1, lambda: log.said)


def test_second_controller_of_a_robot_is_refused(run_node):
    with FakeRobot() as robot:
        log = run_node("controller", "trot")
        wait_until(lambda: robot.targets > 10, lambda: log.said)
        second = run_node("controller", "trot")
        assert second.status() == 2
        assert "/joint_commands: controller" in second.said
        assert "publishes it already" in second.said
        assert "limp" not in log.said


def test_of_two_controllers_that_wait_together_one_ends_before_both_command(run_node, monkeypatch):
    """However long they have waited."""
    monkeypatch.setattr(single_publisher, "CONTEST", 1.0)
    first, second = run_node("controller", "trot"), run_node("controller", "trot")
    for node in (first, second):
        wait_until(lambda node=node: "waiting for a publisher" in node.said, lambda node=node: node.said)
    since = time.monotonic()
    wait_until(lambda: time.monotonic() > since + 1.1)
    with FakeRobot() as robot:
        wait_until(lambda: first.poll() is not None or second.poll() is not None)
        left, ended = (first, second) if first.poll() is None else (second, first)
        assert ended.status() == 2
        assert "there can be one publisher only" in ended.said
        wait_until(lambda: "following the command" in left.said, lambda: left.said)
        assert robot.targets


@pytest.mark.parametrize("publishing", [True, False])
def test_publisher_that_no_other_has_precedence_over_gives_way_only_while_it_waits(nodes, publishing):
    ours, other = nodes("ours"), nodes("other")
    said = []
    session = SimpleNamespace(node=ours, running=False, every_turn=[], say_once=said.append)
    guard = single_publisher.SinglePublisherGuard(session, JOINT_COMMANDS, lambda: publishing)
    ours.graph.participant = ""  # sorts before the other one
    publisher = other.publish(JOINT_COMMANDS)
    wait_until(lambda: publisher.readers)

    def noticed():
        publisher.send(joint_state())
        try:
            session.every_turn[0]()
        except QuadrupedError as error:
            return str(error)
        return guard.problem

    words = "publishes /joint_commands too; end one" if publishing else "publishes it already on domain"
    assert words in wait_until(noticed)
    assert bool(said) == publishing


def test_node_that_starts_while_another_one_publishes_is_refused(nodes):
    ours, other = nodes("ours"), nodes("other")
    publisher = other.publish(JOINT_COMMANDS)
    session = SimpleNamespace(node=ours, running=True, every_turn=[], wait=lambda _: publisher.send(joint_state()))
    with pytest.raises(QuadrupedError, match=r"/joint_commands: .* publishes it already on domain"):
        single_publisher.SinglePublisherGuard(session, JOINT_COMMANDS)
