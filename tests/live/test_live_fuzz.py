"""No message of any size or content ends a node."""

import io
import time

import numpy as np
import pytest
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW
from live_nodes import usable

from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.live_robot import NAME, LiveRobot
from quadruped_env.live.messages.joint_messages import JointReader
from quadruped_env.live.middleware.node import Received
from quadruped_env.live.middleware.topics import ESTOP, JOINT_COMMANDS, JOINT_STATES, RESET
from quadruped_env.live.nodes import node_module
from quadruped_env.live.session import MAX_REASONS, REFUSALS_PERIOD, Session
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import Qos
from quadruped_env.viewer import ViewController

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")


def damaged(rng, topic):
    """Bytes of any content and size: random, or a message truncated, extended, changed, or full of extreme values."""
    example = usable(topic)
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
        at = 4 * rng.integers(1, max(2, len(data) // 4))
        data[at : at + 4] = int(rng.choice([0, 1, 7, 9, 2**16, 2**31 - 1, 2**32 - 1])).to_bytes(4, "little")
        return bytes(data)
    data = bytearray(example)
    value = rng.choice([np.nan, np.inf, -np.inf, 1e308, -1e308, 1e30, 999.0, 5e-324, -0.0])
    words = np.frombuffer(data[4 : 4 + 8 * ((len(data) - 4) // 8)], dtype="<f8").copy()
    words[rng.random(len(words)) < rng.random()] = value
    data[4 : 4 + words.nbytes] = words.tobytes()
    return bytes(data)


class FloodedSession(Session):
    """A session whose subscriptions deliver damaged messages instead of other nodes' messages."""

    def __init__(self, arguments, log, rng, turns, size=3):
        super().__init__(arguments.node, arguments, log)
        self.turns_left = turns
        self._rng = rng
        self._size = size
        self._real_subscribe = self.node.subscribe
        self.node.subscribe = self._subscribe

    def _subscribe(self, topic, *rest, **options):
        subscription = self._real_subscribe(topic, *rest, **options)
        # Resets and stops would leave nothing else to do.
        if options.get("ignore_own") or topic in (RESET, ESTOP):
            return subscription

        def take():
            if self.turns_left <= 0:
                return []
            datas = [damaged(self._rng, topic) for _ in range(self._size)] + [usable(topic)]
            found = [Received(data, 0, 1, time.monotonic()) for data in datas]
            subscription.count += len(found)
            return found

        subscription.take = take
        return subscription

    def report(self):
        super().report()
        self.turns_left -= 1
        if self.turns_left <= 0:
            self.stop()

    def wait(self, seconds=0.0):
        return super().wait(min(seconds, 0.001))


NODES = {
    "sim": ["sim"],
    "controller": ["controller"],
    "state": ["state"],
    "gait": ["gait"],
    "echo": ["echo", "/joint_states", "--field", "position.3"],
}


@pytest.mark.parametrize("name", NODES)
def test_node_flooded_with_damaged_messages_continues(name, nodes, capsys):
    run_flooded(NODES[name], nodes, turns=100)


def run_flooded(arguments, nodes, turns, seed=0):
    if arguments[0] == "echo":
        # It subscribes to the topics that are published.
        nodes().publish(JOINT_STATES)
    args, log = make_parser().parse_args(arguments), io.StringIO()
    with FloodedSession(args, log, np.random.default_rng(seed), turns) as session:
        assert node_module(arguments[0]).run(session, args) == 0
    assert session.turns_left <= 0
    assert session.refuse.count > 0
    said = log.getvalue()
    assert "refused: /" in said
    # Each second: the reasons that are logged once and with their number, the others, what is waited for.
    assert len(said.splitlines()) < 40 + (2 * MAX_REASONS + 4) * (session.elapsed / REFUSALS_PERIOD + 1)
    return session


def test_viewer_flooded_with_damaged_messages_continues(nodes, tmp_path):
    """Its scene is finite afterwards."""
    node, rng, refused = nodes(), np.random.default_rng(0), []
    live = LiveRobot(node, MINI_QUADRUPED, refused.append)
    for subscription in node.subscriptions:
        topic = subscription.topic
        subscription.take = lambda topic=topic: [Received(damaged(rng, topic), 0, 1) for _ in range(3)]
    show = ViewController({NAME: lambda: live}, [NAME], tmp_path)
    show.restart_after_fall = False
    for _ in range(200):
        show.advance(0.02)
        now = show.view().robots[0].now
        assert np.isfinite(now.base_pose).all()
        assert np.isfinite(now.joint_position).all()
    show.close()
    assert len(refused) > 200


def test_controller_flooded_with_damaged_messages_sends_only_finite_targets(nodes):
    """Some of the damaged messages look valid: its joint targets stay within the joints' range."""
    commands = nodes().subscribe(JOINT_COMMANDS, Qos(5000), read=JointReader(MINI_QUADRUPED))
    run_flooded(NODES["controller"], nodes, turns=400, seed=5)
    targets = [one.positions for _, one in commands.messages(pytest.fail) if one.positions is not None]
    assert np.all(np.array(targets) <= JOINT_POSITION_HIGH)
    assert np.all(np.array(targets) >= JOINT_POSITION_LOW)
