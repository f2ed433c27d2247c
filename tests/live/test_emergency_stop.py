"""The emergency stop: publishers of any QoS and namespace, restarts, and who may release it."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from fake_robot import FakeRobot
from live_nodes import received_from
from waiting import wait_until

from quadruped_env.live import Node
from quadruped_env.live import emergency_stop as module
from quadruped_env.live.emergency_stop import EmergencyStop
from quadruped_env.live.middleware.names import Names
from quadruped_env.live.middleware.topics import ESTOP, RESET
from quadruped_env.ros import LATCHED_QOS, Qos, cdr

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

QOS = {"latched": LATCHED_QOS, "volatile": Qos(10), "best effort": Qos(1, reliable=False)}
READERS = {"latched": 3, "volatile": 2, "best effort": 1}
"""Readers of a subscription that each publisher matches."""


@pytest.fixture(name="stop_of")
def _stop_of(nodes, monkeypatch):
    """Factory of the emergency stop of a node, which takes first messages for new ones from the start."""
    monkeypatch.setattr(module, "_DISCOVERY", 0.0)
    made = []

    def make(stopped=False, namespace="/"):
        made.append(Node("robot", names=Names("robot", namespace)))
        return EmergencyStop(
            SimpleNamespace(node=made[-1], say=lambda text: None, refuse=pytest.fail, every_turn=[]), stopped
        )

    yield make
    for node in made:
        node.close()


class Button:
    """A publisher of `/estop` on a node of its own, matched with a stop."""

    def __init__(self, node, stop, qos="volatile", name=ESTOP.name):
        self.node, self.stop = node, stop
        before = self._matched()
        self.publisher = node.publish(replace(ESTOP, name=name, is_global=True), QOS[qos])
        wait_until(lambda: self.publisher.readers == READERS[qos] and self._matched() - before)

    def _matched(self):
        return {handle for subscription in self.stop._subscriptions for handle in subscription.matched}

    def send(self, value):
        """Send a message, again until it has arrived, as best effort may lose one."""
        count = self._count()

        def arrived():
            self.publisher.send(cdr.message(ESTOP.type_name, data=value))
            self.stop.take()
            return self._count() > count

        wait_until(arrived, interval=0.02)
        self.stop.take()
        return self.stop.stopped

    def _count(self):
        return sum(subscription.count for subscription in self.stop._subscriptions)

    def leave(self):
        count = len(self._matched())
        self.node.remove(self.publisher)
        wait_until(lambda: len(self._matched()) < count)


@pytest.mark.parametrize(
    ("namespace", "name"), [("/", "/estop"), ("/r1", "/r1/estop"), ("/r1", "/estop")], ids=["plain", "own", "global"]
)
@pytest.mark.parametrize("qos", QOS)
def test_publisher_of_any_qos_stops_and_releases_again_and_again(nodes, stop_of, qos, namespace, name):
    stop, node = stop_of(namespace=namespace), nodes("button")
    button = Button(node, stop, qos, name)
    assert [button.send(value) for value in 5 * (True, False)] == 5 * [True, False]
    # The readers that do not match it are no problem: another one of the same subscription does.
    assert node.graph.problems() == []


def test_latched_stop_reaches_a_node_that_starts_later(nodes, stop_of):
    nodes("button").publish(ESTOP).send(cdr.message(ESTOP.type_name, data=True))
    stop = stop_of()
    wait_until(lambda: stop.take() or stop.stopped)


def test_stop_is_released_by_its_publisher_while_that_one_is_there(nodes, stop_of):
    stop = stop_of()
    first, second = Button(nodes("first"), stop), Button(nodes("second"), stop)
    assert first.send(True)
    assert second.send(False)
    assert stop.awaited.startswith("the release of the emergency stop (/estop: by first")
    assert second.send(True)
    assert second.send(False)
    assert not first.send(False)


def test_matched_publishers_have_the_handles_of_their_messages(nodes):
    """Which are random 64-bit numbers: with ten, some are beyond the signed ones."""
    received = nodes("robot").subscribe(ESTOP)
    publishers = [nodes(f"button{number}").publish(ESTOP) for number in range(10)]
    wait_until(lambda: received.writers == 10)
    for publisher in publishers:
        publisher.send(cdr.message(ESTOP.type_name, data=True))
    assert {one.writer for one in received_from(received, 10)} == received.matched


def test_stop_of_a_publisher_that_left_is_released_by_news_and_not_by_a_repetition(nodes, stop_of):
    stop = stop_of()
    first, unpressed = Button(nodes("first"), stop), Button(nodes("unpressed"), stop)
    assert not unpressed.send(False)
    assert first.send(True)
    first.leave()
    assert [unpressed.send(False) for _ in range(5)] == 5 * [True]
    assert "true and then false" in stop.awaited
    assert not Button(nodes("new"), stop).send(False)
    assert unpressed.send(True)
    assert not unpressed.send(False)


def test_node_that_starts_stopped_is_not_released_by_what_was_sent_before(nodes, stop_of, monkeypatch):
    released = nodes("gamepad").publish(ESTOP)
    released.send(cdr.message(ESTOP.type_name, data=False))
    stop = stop_of(stopped=True)
    monkeypatch.setattr(module, "_DISCOVERY", 1000.0)
    wait_until(lambda: stop.take() or sum(one.count for one in stop._subscriptions))
    assert stop.stopped
    monkeypatch.setattr(module, "_DISCOVERY", 0.0)
    assert not Button(nodes("new"), stop).send(False)


@pytest.mark.parametrize("qos", QOS)
def test_subscription_with_several_readers_receives_each_message_once(nodes, qos):
    """A command that arrives twice would be two commands."""
    received = nodes("robot").subscribe(RESET)
    publisher = nodes("user").publish(RESET, QOS[qos])
    wait_until(lambda: publisher.readers == READERS[qos] and received.writers == 1)
    for number in range(1, 6):
        publisher.send(cdr.message(RESET.type_name))
        received_from(received, 1)
        assert received.count == number
    publisher.send(cdr.message(RESET.type_name))
    received_from(received, 1)
    assert received.take() == []


def test_controller_that_starts_stopped_stays_limp_until_release_and_command(run_node, nodes):
    """As systemd starts it again after it was killed, with a velocity command that goes on."""
    with FakeRobot() as robot:
        controller = run_node("controller", "trot", "--start-stopped")
        stops = nodes("button").publish(ESTOP, Qos(10))
        wait_until(lambda: "waiting for the release of the emergency stop" in controller.said and stops.readers)
        # States and commands that would make it move.
        count = robot.velocities.count
        wait_until(lambda: robot.velocities.count > count + 100)
        assert robot.targets == 0
        stops.send(cdr.message(ESTOP.type_name, data=True))
        stops.send(cdr.message(ESTOP.type_name, data=False))
        wait_until(lambda: robot.targets, lambda: controller.said)
        assert not robot.limp
