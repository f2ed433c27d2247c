"""Nodes and what others send them: nothing that was received is lost, and no message of any content ends a node."""

import contextlib
import io
import re
import threading
import time

import numpy as np
import pytest
from live_nodes import joint_state
from waiting import wait_until

from quadruped_env import JOINT_NAMES, QuadrupedError
from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.joints import JointReader
from quadruped_env.live.mirror import Mirror, mirror_source
from quadruped_env.live.node import Received
from quadruped_env.live.nodes import node_module
from quadruped_env.live.pace import Pace
from quadruped_env.live.refusals import MOST_REASONS, PERIOD, Refusals
from quadruped_env.live.session import Session
from quadruped_env.live.text import check_field
from quadruped_env.live.topics import CMD_VEL, IMU, JOINT_COMMANDS, JOINT_POSITIONS, JOINT_STATES, ODOMETRY, TOPICS
from quadruped_env.robot import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE
from quadruped_env.ros import Qos, cdr
from quadruped_env.viewer import ViewController

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

SENT = 12
"""Messages that arrive between a node's last taking and the signal"""


class InterruptedSession(Session):
    """Ends at the one moment at which messages could be lost: they are there, and the node has just taken others."""

    publisher = None

    def wait_for(self, what):
        super().wait_for(what)
        if self.publisher.readers and not self.publisher.count:
            for i in range(SENT):
                self.publisher.send(joint_state(i, position=[i] * 8))
            wait_until(lambda: self.publisher.wait_until_read(1.0))
            self._interrupted(2, None)


def run_interrupted(node, *arguments):
    args = make_parser().parse_args(arguments)
    with InterruptedSession(arguments[0], args, io.StringIO()) as session:
        session.publisher = node.publish(JOINT_STATES, Qos(100))
        return node_module(arguments[0]).run(session, args)


def test_echo_interrupted_prints_what_was_received(nodes, capsys):
    assert run_interrupted(nodes(), "echo", "/joint_states", "--field", "position.0") == 0
    assert re.findall(r"\d+\.\d", capsys.readouterr().out) == [f"{i}.0" for i in range(SENT)]


def test_hz_interrupted_counts_what_was_received(nodes, capsys):
    assert run_interrupted(nodes(), "hz", "/joint_states") == 0
    assert capsys.readouterr().out.splitlines()[-1].endswith(f"{SENT} messages")


def test_hz_interrupted_after_a_line_prints_what_came_since(nodes, capsys, monkeypatch):
    """The line of the first second says 0 messages; what came after it is printed all the same."""
    monkeypatch.setattr("quadruped_env.live.nodes.hz.PERIOD", 1e-3)
    assert run_interrupted(nodes(), "hz", "/joint_states") == 0
    assert capsys.readouterr().out.splitlines()[-1].endswith(f"{SENT} messages")


def test_record_interrupted_writes_what_was_received(nodes, capsys, tmp_path):
    assert run_interrupted(nodes(), "record", "/joint_states", "-o", str(tmp_path / "bag")) == 0
    assert f"{SENT} messages of 1 topics" in capsys.readouterr().out


def test_state_interrupted_answers_what_was_received(nodes):
    node = nodes()
    transforms = node.subscribe(TOPICS["/tf"])
    assert run_interrupted(node, "state") == 0
    received = []
    wait_until(lambda: received.extend(transforms.take()) or len(received) >= 5)  # best effort keeps the last 5


# --- reading


@pytest.mark.parametrize("topic", TOPICS.values(), ids=str)
def test_subscribe_has_read_a_message_before_the_first_comes(topic, nodes, monkeypatch):
    """What the first reading costs, it costs before the subscription exists."""
    order = []
    monkeypatch.setattr("quadruped_env.live.node.Subscription", lambda *_, **__: order.append("subscribed") or Made())

    class Made:
        condition = None

    node = nodes()
    monkeypatch.setattr(node, "_waitset", type("Waitset", (), {"attach": lambda self, condition: None})())
    node.subscribe(topic, read=lambda data: order.append(cdr.deserialize(data, topic.type_name).__msgtype__))
    assert order == [topic.type_name, "subscribed"]
    node.subscriptions.clear()


def test_a_message_is_timed_when_it_is_taken_not_when_it_was_read(nodes):
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

    # The example that subscribing reads is let pass.
    subscription = node.subscribe(CMD_VEL, Qos(100), read=lambda data: 1 // 0 if publisher.count else None)
    wait_until(lambda: publisher.readers)
    for _ in range(3):
        publisher.send(cdr.message(CMD_VEL.type_name))
    refused = []
    wait_until(lambda: list(subscription.messages(refused.append)) or len(refused) == 3)
    assert refused == ["/cmd_vel: 52 bytes cannot be read: ZeroDivisionError: integer division or modulo by zero"] * 3


def test_check_field_knows_a_types_fields():
    check_field(JOINT_STATES.type_name, "position.7")
    check_field(JOINT_STATES.type_name, "header.stamp.sec")
    check_field("tf2_msgs/msg/TFMessage", "transforms.3.transform.rotation.w")
    with pytest.raises(QuadrupedError, match=r"--field position\.x: there is no 'x'"):
        check_field(JOINT_STATES.type_name, "position.x")
    with pytest.raises(QuadrupedError, match="--field speed: there is no 'speed'; there is header, name, position"):
        check_field(JOINT_STATES.type_name, "speed")


# --- the log of refusals


class Hands:
    now = 100.0

    def __call__(self):
        return self.now


def test_refusals_are_logged_once_a_second_with_a_count():
    said, clock = [], Hands()
    refuse = Refusals(said.append, clock)
    for _ in range(1000):
        refuse("/push: too hard")
        clock.now += PERIOD / 100
    assert said[0] == "refused: /push: too hard"
    assert len(said) == 10
    assert all(re.fullmatch(r"refused: /push: too hard \(\d+ messages in 1\.0 s\)", line) for line in said[1:])
    refuse.report(last=True)
    counted = sum(int(re.search(r"\((\d+) message", line)[1]) for line in said[1:])
    assert counted + 1 == refuse.count == 1000
    clock.now += 2 * PERIOD
    refuse.report()
    refuse.report()
    refuse("/push: too hard")
    assert said[-1] == "refused: /push: too hard"


def test_refusals_of_endless_different_reasons_stay_few_and_short():
    said, clock = [], Hands()
    refuse = Refusals(said.append, clock)
    for i in range(10_000):
        refuse(f"{i}: \x1b[2J\n" + "x" * 10_000)
        clock.now += PERIOD / 1000
    assert len(said) <= 11 * (2 * MOST_REASONS + 1)
    assert max(map(len, said)) < 500
    assert "".join(said).isprintable()
    assert any(re.fullmatch(r"refused: \d+ messages for other reasons in 1\.0 s", line) for line in said)
    assert len(refuse._counts) <= MOST_REASONS


# --- messages of any content


def damaged(rng, topic):
    """Bytes of any content and size: random, or of a message that is cut, longer, changed, full of extreme values."""
    example = good(topic)
    kind = rng.integers(6)
    if kind == 0:
        return rng.bytes(int(rng.integers(0, 200)))
    if kind == 1:
        return example[: rng.integers(0, len(example))]
    if kind == 2:
        return example + rng.bytes(int(rng.integers(1, 100_000)))
    if kind == 3:
        data = bytearray(example)
        for at in rng.integers(4, len(data), rng.integers(1, 9)):
            data[at] = rng.integers(256)
        return bytes(data)
    if kind == 4:
        # Counts of sequences and lengths of texts beyond the end.
        data = bytearray(example)
        at = 4 * rng.integers(1, len(data) // 4)
        data[at : at + 4] = int(rng.choice([0, 1, 7, 9, 2**16, 2**31 - 1, 2**32 - 1])).to_bytes(4, "little")
        return bytes(data)
    data = bytearray(example)
    value = rng.choice([np.nan, np.inf, -np.inf, 1e308, -1e308, 1e30, 999.0, 5e-324, -0.0])
    words = np.frombuffer(data[4 : 4 + 8 * ((len(data) - 4) // 8)], dtype="<f8").copy()
    words[rng.random(len(words)) < rng.random()] = value
    data[4 : 4 + words.nbytes] = words.tobytes()
    return bytes(data)


def good(topic):
    """The bytes of a message that the node can use, of now."""
    now = time.time_ns()
    if topic.type_name == JOINT_STATES.type_name:
        return cdr.serialize(joint_state(now, JOINT_NAMES, STANCE, np.zeros(8), np.zeros(8)))
    fields = {
        IMU.name: {"header": cdr.header(now), "orientation": {"w": 1.0}},
        ODOMETRY.name: {"header": cdr.header(now), "pose": {"pose": {"orientation": {"w": 1.0}}}},
        JOINT_POSITIONS.name: {"data": STANCE},
    }
    return cdr.serialize(cdr.message(topic.type_name, **fields.get(topic.name, {})))


class Swamped(Session):
    """A session whose node gets what a test puts into its subscriptions, in place of what others send."""

    def __init__(self, arguments, log, rng, turns, size=3):
        super().__init__(arguments.node, arguments, log)
        self.turns_left = turns
        self._rng = rng
        self._size = size
        self._real_subscribe = self.node.subscribe
        self.node.subscribe = self._subscribe

    def _subscribe(self, topic, *rest, **options):
        subscription = self._real_subscribe(topic, *rest, **options)
        if options.get("ignore_own"):
            return subscription

        def take():
            if self.turns_left <= 0:
                return []
            datas = [damaged(self._rng, topic) for _ in range(self._size)] + [good(topic)]
            found = [Received(data, 0, 1, time.monotonic()) for data in datas]
            subscription.count += len(found)
            return found

        subscription.take = take
        return subscription

    def report(self, *details):
        super().report(*details)
        self.turns_left -= 1
        if self.turns_left <= 0:
            self.stop()

    def wait(self, seconds=0.0):
        return super().wait(min(seconds, 0.001))


NODES = {
    "sim": ["sim"],
    "controller": ["controller"],
    "state": ["state"],
    "gait": ["gait", "--commands"],
    "echo": ["echo", "/joint_states", "--field", "position.3"],
}


@pytest.mark.parametrize("name", NODES)
def test_node_swamped_with_damaged_messages_goes_on(name, nodes, capsys):
    run_swamped(NODES[name], nodes, turns=100)


@pytest.mark.slow
@pytest.mark.parametrize("name", NODES)
def test_node_swamped_with_many_damaged_messages_goes_on(name, nodes, capsys):
    run_swamped(NODES[name], nodes, turns=3000, seed=1)


def run_swamped(arguments, nodes, turns, seed=0):
    if arguments[0] == "echo":
        # It subscribes to what is published.
        nodes().publish(JOINT_STATES)
    args, log = make_parser().parse_args(arguments), io.StringIO()
    with Swamped(args, log, np.random.default_rng(seed), turns) as session:
        assert node_module(arguments[0]).run(session, args) == 0
    assert session.turns_left <= 0
    assert session.refuse.count > 0
    said = log.getvalue()
    assert "refused: /" in said
    assert len(said.splitlines()) < 40 + 2 * turns / 10
    return session


@pytest.mark.parametrize("seed", range(3))
def test_viewer_swamped_with_damaged_messages_goes_on(nodes, tmp_path, seed):
    """And what it then draws is finite, whatever came before."""
    node, rng, refused = nodes(), np.random.default_rng(seed), []
    mirror = Mirror(node, refused.append)
    for subscription in node.subscriptions:
        topic = subscription.topic
        subscription.take = lambda topic=topic: [Received(damaged(rng, topic), 0, 1) for _ in range(3)]
    source = mirror_source(mirror)
    show = ViewController({source.name: source}, [source.name], tmp_path)
    show.restart_after_fall = False
    for _ in range(200):
        show.advance(0.02)
        now = show.view().robots[0].now
        assert np.isfinite(now.base_pose).all()
        assert np.isfinite(now.joint_position).all()
    show.close()
    assert len(refused) > 200


def test_controller_swamped_with_damaged_messages_sends_only_finite_targets(nodes):
    """Among the good ones there are damaged ones that look well: what it commands stays within the joints' range."""
    commands = nodes().subscribe(JOINT_COMMANDS, Qos(5000), read=JointReader(JOINT_COMMANDS.name))
    run_swamped(NODES["controller"], nodes, turns=400, seed=5)
    targets = [one.positions for _, one in commands.messages(pytest.fail) if one.positions is not None]
    assert np.all(np.array(targets) <= JOINT_POSITION_HIGH)
    assert np.all(np.array(targets) >= JOINT_POSITION_LOW)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["sim", "controller", "state", "view", "gait", "hz", "record"])
def test_process_that_is_sent_damaged_messages_goes_on(name, start, nodes, tmp_path):
    """Over the wire, on every topic that it listens to."""
    options = {"gait": ["--commands"], "view": ["--port", "0"], "record": ["-o", str(tmp_path / "bag")]}
    rng = np.random.default_rng(3)
    sender = nodes("sender")
    # Beside another robot a simulator would refuse to run.
    publishers = [
        sender.publish(topic, Qos(100)) for topic in TOPICS.values() if topic is not JOINT_STATES or name != "sim"
    ]
    node = start(name, *options.get(name, []))
    reads = name not in ("hz", "record")
    sent = 0

    def swamp():
        nonlocal sent
        for publisher in publishers:
            if publisher.readers:
                data = damaged(rng, publisher.topic)
                # With another beginning or length DDS takes the whole packet for damaged, and the node gets nothing.
                data = b"\x00\x01\x00\x00" + data[4 : 4 * (len(data) // 4)]
                with contextlib.suppress(QuadrupedError):
                    publisher.send_bytes(data)
                publisher.send_bytes(good(publisher.topic))
                sent += 1
        return sent > 300 and ("refused" in node.said or not reads)

    wait_until(swamp, lambda: node.said, alive=node.process)
    for publisher in publishers:
        wait_until(lambda publisher=publisher: publisher.wait_until_read(1.0), alive=node.process)
    assert node.interrupt() == 0
    assert "ended after" in node.said


def test_controller_whose_first_twist_is_read_slowly_moves_the_robot(nodes, monkeypatch):
    """The states that come meanwhile are timed when they are taken, and so none of the later ones is late."""
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
    args, log = make_parser().parse_args(["controller"]), io.StringIO()

    def drive():
        for publisher in (velocities, attitudes, states):
            publisher.send_bytes(good(publisher.topic))
        return "going to the stance" in log.getvalue()

    with Session("controller", args, log) as session:
        thread = threading.Thread(target=node_module("controller").run, args=(session, args))
        thread.start()
        try:
            wait_until(drive, log.getvalue, interval=0.01)
        finally:
            session.stop()
            thread.join()
    assert len(twists) > 2


# --- the log on a terminal


class Terminal(io.StringIO):
    """A terminal that several nodes write to, and what it shows."""

    def isatty(self):
        return True

    def lines(self):
        shown = []
        for line in self.getvalue().split("\n"):
            text, column = "", 0
            for part in re.split(r"(\r|\x1b\[K)", line):
                if part == "\r":
                    column = 0
                elif part == "\x1b[K":
                    text = text[:column]
                else:
                    text = text[:column] + part + text[column + len(part) :]
                    column += len(part)
            shown.append(text)
        return shown


def test_line_of_one_node_does_not_follow_the_status_line_of_another(domain_id):
    """As of `display`, whose nodes share a terminal: the address stands in a line of its own."""
    terminal = Terminal()
    args = make_parser().parse_args(["list"])
    gait, view = Session("gait", args, terminal), Session("view", args, terminal)
    gait._status_pace = view._status_pace = Pace(1e-6)
    with gait, view:
        for _ in range(3):
            gait.report("a status that is rather long")
            view.say("the live robot: http://127.0.0.1:8080")
            view.report("short")
            gait.say("something")
        view.report("short")
    lines = terminal.lines()
    assert lines.count("[view] the live robot: http://127.0.0.1:8080") == 3
    assert lines.count("[gait] something") == 3
    assert all(line.count("[") <= 1 for line in lines)


def test_status_line_is_not_longer_than_the_terminal_is_wide(domain_id, monkeypatch):
    monkeypatch.setenv("COLUMNS", "40")
    terminal = Terminal()
    with Session("gait", make_parser().parse_args(["list"]), terminal) as session:
        session._status_pace = Pace(1e-6)
        session.report("x" * 200)
        assert len(terminal.lines()[-1]) == 39
