"""Messages that nodes receive: none is lost, reading makes none late, refusals are logged once per second."""

import io
import re
import time

import pytest
from live_nodes import joint_state, usable
from manual_clock import ManualClock
from waiting import wait_until

from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.middleware.topics import CMD_VEL, IMU, JOINT_STATES
from quadruped_env.live.nodes import launch, node_module
from quadruped_env.live.session import MAX_REASONS, REFUSALS_PERIOD, Refusals, Session
from quadruped_env.ros import Qos, cdr

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

SENT = 12
"""Number of messages that arrive between a node's last `take` and the signal."""


class InterruptedSession(Session):
    """Ends at the only moment at which messages could be lost: they have arrived since the node last took messages."""

    publisher = None

    def wait_for(self, what):
        super().wait_for(what)
        if self.publisher.readers and not self.publisher.count:
            for i in range(SENT):
                self.publisher.send(joint_state(i, position=[i] * 8))
            wait_until(lambda: self.publisher.wait_until_read(1.0))
            # Best effort is not acknowledged.
            wait_until(lambda: self.node.wait(0.1))
            self._interrupted(2)


def run_interrupted(node, *arguments):
    args = make_parser().parse_args(arguments)
    with InterruptedSession(arguments[0], args, io.StringIO()) as session:
        session.publisher = node.publish(JOINT_STATES, Qos(100))
        return node_module(arguments[0]).run(session, args)


def test_echo_interrupted_prints_what_was_received(nodes, capsys):
    assert run_interrupted(nodes(), "echo", "/joint_states", "--field", "position.0") == 0
    assert re.findall(r"\d+\.\d", capsys.readouterr().out) == [f"{i}.0" for i in range(SENT)]


def test_record_interrupted_writes_what_was_received(nodes, capsys, tmp_path):
    assert run_interrupted(nodes(), "record", "/joint_states", "-o", str(tmp_path / "bag")) == 0
    assert f"{SENT} messages of 1 topics" in capsys.readouterr().out


# --- reading


def test_message_gets_the_time_when_it_is_taken_not_when_it_was_read(nodes):
    node = nodes()
    publisher = node.publish(CMD_VEL)
    taken = []

    def slow(data):
        if taken:
            # Not a wait: a reader that costs time, as the first reading of a type does.
            time.sleep(0.02)
        return cdr.deserialize(data, CMD_VEL.type_name)

    velocities = node.subscribe(CMD_VEL, read=slow)
    wait_until(lambda: publisher.readers)
    publisher.send(cdr.message(CMD_VEL.type_name))
    wait_until(lambda: node.wait(0.1))
    taken.append(time.monotonic())
    for received, _ in velocities.messages(pytest.fail):
        read = time.monotonic()
        assert taken[0] <= received.taken <= read - 0.02


def test_reader_that_fails_in_any_way_refuses_the_message(nodes):
    node = nodes()
    publisher = node.publish(CMD_VEL, Qos(100))

    # The example that subscribing reads must pass.
    subscription = node.subscribe(CMD_VEL, Qos(100), read=lambda data: 1 // 0 if publisher.count else None)
    wait_until(lambda: publisher.readers)
    for _ in range(3):
        publisher.send(cdr.message(CMD_VEL.type_name))
    refused = []
    wait_until(lambda: list(subscription.messages(refused.append)) or len(refused) == 3)
    assert refused == ["/cmd_vel: 52 bytes cannot be read: ZeroDivisionError: integer division or modulo by zero"] * 3


# --- the log of refusals


def test_refusals_are_logged_once_a_second_with_a_count():
    said, clock = [], ManualClock()
    refuse = Refusals(said.append, clock)
    for _ in range(1000):
        refuse("/push: too hard")
        clock.now += REFUSALS_PERIOD / 100
    assert said[0] == "refused: /push: too hard"
    assert len(said) == 10
    assert all(re.fullmatch(r"refused: /push: too hard \(\d+ messages in 1\.0 s\)", line) for line in said[1:])
    refuse.report(last=True)
    counted = sum(int(re.search(r"\((\d+) message", line)[1]) for line in said[1:])
    assert counted + 1 == refuse.count == 1000
    clock.now += 2 * REFUSALS_PERIOD
    refuse.report()
    refuse.report()
    refuse("/push: too hard")
    assert said[-1] == "refused: /push: too hard"


def test_refusals_with_ever_different_reasons_stay_few_and_short():
    said, clock = [], ManualClock()
    refuse = Refusals(said.append, clock)
    for i in range(10_000):
        refuse(f"{i}: \x1b[2J\n" + "x" * 10_000)
        clock.now += REFUSALS_PERIOD / 1000
    assert len(said) <= 11 * (2 * MAX_REASONS + 1)
    assert max(map(len, said)) < 500
    assert "".join(said).isprintable()
    assert any(re.fullmatch(r"refused: for other reasons \(\d+ messages in 1\.0 s\)", line) for line in said)
    assert len(refuse._counts) <= MAX_REASONS + 1


def test_controller_whose_first_twist_is_read_slowly_moves_the_robot(nodes, run_node, monkeypatch):
    """The states that come meanwhile get the time when they are taken, so none of the later ones is late."""
    read, twists = cdr.deserialize, []

    def slow(data, type_name):
        if type_name == CMD_VEL.type_name:
            twists.append(data)
            if len(twists) == 2:
                # The first one is what subscribing reads. Not a wait: this is the delay.
                time.sleep(0.6)
        return read(data, type_name)

    monkeypatch.setattr(cdr, "deserialize", slow)
    robot = nodes("robot")
    states, attitudes, velocities = robot.publish(JOINT_STATES), robot.publish(IMU), robot.publish(CMD_VEL)
    log = run_node("controller")

    def drive():
        for publisher in (velocities, attitudes, states):
            publisher.send_bytes(usable(publisher.topic))
        return "going to the stance" in log.said

    wait_until(drive, lambda: log.said, interval=0.01)
    assert len(twists) > 2


# --- programs


@pytest.mark.usefixtures("domain_id")
def test_loop_ends_at_once_and_continues_only_where_a_node_drains_messages():
    with Session("gait", make_parser().parse_args(["gait"]), io.StringIO()) as session:
        turns = session.turns()
        assert next(turns, "ended") is None
        session.stop()
        assert next(turns, "ended") == "ended"
        assert next(session.turns(drain=True), "ended") is None


def test_launch_passes_the_options_of_each_node_on(monkeypatch):
    started = []
    monkeypatch.setattr(launch, "_launch", started.extend)
    robot = ["--map", "m.toml", "--namespace", "r1", "--remap", "a:=b"]
    ground, page = ["--terrain", "rough", "--seed", "2"], ["--port", "0"]
    launch.Walk.start(make_parser(only="walk").parse_args(["walk", "tuned", *robot, *ground, *page]))
    assert started[:4] == [
        ["sim", "--pick-up", "3", *ground, *robot],
        ["controller", "tuned", *robot],
        ["state", *robot],
        ["view", *page, *ground, *robot],
    ]
    started.clear()
    launch.Display.start(make_parser(only="display").parse_args(["display", "--preset", "walk", *robot, *page]))
    assert started == [["gait", "--preset", "walk", *robot], ["state", *robot], ["view", *page, *robot]]
