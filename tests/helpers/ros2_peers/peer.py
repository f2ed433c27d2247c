"""An rclpy node for tests: publishes and subscribes on request. Runs in a ROS 2 distribution, without this package.

    python peer.py NAME

Standard input and output hold one JSON object per line. Input:

    {"subscribe": "/topic", "type": "std_msgs/msg/String", "qos": {"depth": 10, "reliable": true}}
    {"publish": "/topic", "type": ..., "qos": ...}
    {"send": "/topic", "message": {"data": "text"}}
    {"drive": "/cmd_vel", "message": {...}, "period": 0.1}      sends the message periodically from now on
    {"endpoints": "/topic"}
    {"nodes": "/namespace/name"}

Output: `{"received": "/topic", "message": {...}}`, `{"matched": "/topic", "count": 1}`,
`{"incompatible": "/topic", "policy": "QoSPolicyKind.RELIABILITY"}`, `{"endpoints": "/topic", "found": [...]}`, and
`{"ready": NAME}` at the beginning. Ends at the end of its standard input.
"""

import importlib
import json
import queue
import sys
import threading

import rclpy
from rclpy._rclpy_pybind11 import NodeNameNonExistentError
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy


def say(**line):
    print(json.dumps(line), flush=True)


def message_type(name):
    package, kind, name = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), name)


def profile(depth=10, reliable=True, transient_local=False):
    return QoSProfile(
        depth=depth,
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if transient_local else DurabilityPolicy.VOLATILE,
    )


def plain(value):
    """The JSON value of a message."""
    if hasattr(value, "get_fields_and_field_types"):
        return {name: plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, str):
        return value
    return [plain(one) for one in value] if hasattr(value, "__iter__") else value


def field_value(base, value):
    """Value of a field of type `base`, from its JSON value."""
    if "/" not in base:
        return value
    package, name = base.split("/")
    nested = message_type(f"{package}/msg/{name}")
    return [filled(nested, one) for one in value] if isinstance(value, list) else filled(nested, value)


def filled(kind, fields):
    """A message with the fields of its JSON value."""
    message = kind()
    types = message.get_fields_and_field_types()
    for name, value in fields.items():
        base = types[name].removeprefix("sequence<").removesuffix(">").partition("[")[0]
        setattr(message, name, field_value(base, value))
    return message


class Peer:
    def __init__(self, name):
        self.node = rclpy.create_node(name)
        self.publishers = {}
        self.subscriptions = []

    def take(self, line):
        """Execute one line of input."""
        if "subscribe" in line:
            self.subscribe(line["subscribe"], message_type(line["type"]), profile(**line["qos"]))
        elif "publish" in line:
            self.publish(line["publish"], message_type(line["type"]), profile(**line["qos"]))
        elif "send" in line:
            publisher, kind = self.publishers[line["send"]]
            publisher.publish(filled(kind, line["message"]))
        elif "drive" in line:
            publisher, kind = self.publishers[line["drive"]]
            message = filled(kind, line["message"])
            self.node.create_timer(line["period"], lambda: publisher.publish(message))
        elif "endpoints" in line:
            topic = line["endpoints"]
            say(endpoints=topic, found=[self.endpoint(one) for one in self.infos(topic)])
        elif "nodes" in line:
            self.list_nodes(line["nodes"])

    def list_nodes(self, full):
        """The names of all nodes, and topics and types of one of them, as far as it is known."""
        namespace, _, name = full.rpartition("/")
        try:
            ends = [
                dict(self.node.get_publisher_names_and_types_by_node(name, namespace or "/")),
                dict(self.node.get_subscriber_names_and_types_by_node(name, namespace or "/")),
            ]
        except NodeNameNonExistentError:
            ends = {}, {}
        names = [f"{space.rstrip('/')}/{one}" for one, space in self.node.get_node_names_and_namespaces()]
        say(nodes=names, publishers=ends[0], subscriptions=ends[1])

    def subscribe(self, topic, kind, qos):
        events = SubscriptionEventCallbacks(
            incompatible_qos=lambda event: say(incompatible=topic, policy=str(event.last_policy_kind)),
            matched=lambda event: say(matched=topic, count=event.current_count),
        )
        self.subscriptions.append(
            self.node.create_subscription(
                kind, topic, lambda message: say(received=topic, message=plain(message)), qos, event_callbacks=events
            )
        )

    def publish(self, topic, kind, qos):
        events = PublisherEventCallbacks(
            incompatible_qos=lambda event: say(incompatible=topic, policy=str(event.last_policy_kind)),
            matched=lambda event: say(matched=topic, count=event.current_count),
        )
        self.publishers[topic] = self.node.create_publisher(kind, topic, qos, event_callbacks=events), kind

    def infos(self, topic):
        return [*self.node.get_publishers_info_by_topic(topic), *self.node.get_subscriptions_info_by_topic(topic)]

    @staticmethod
    def endpoint(info):
        return {
            "kind": info.endpoint_type.name,
            "node": info.node_name,
            "type": info.topic_type,
            "hash": str(info.topic_type_hash),
            "reliable": info.qos_profile.reliability == ReliabilityPolicy.RELIABLE,
            "transient_local": info.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL,
        }


def main(name):
    rclpy.init()
    peer = Peer(name)
    lines = queue.SimpleQueue()

    def read():
        for line in sys.stdin:
            lines.put(json.loads(line))
        lines.put(None)

    threading.Thread(target=read, daemon=True).start()
    say(ready=name)
    while True:
        rclpy.spin_once(peer.node, timeout_sec=0.01)
        while not lines.empty():
            line = lines.get()
            if line is None:
                peer.node.destroy_node()
                rclpy.shutdown()
                return
            peer.take(line)


if __name__ == "__main__":
    main(sys.argv[1])
