"""List the topics on the domain and their types, and with --verbose their publishers and subscriptions.

Listens for a moment, since discovery takes time. Reports why a publisher and a subscription do not match: different
types, incompatible quality of service, or announced type structures that cannot be compared.
"""

import argparse
import itertools

from quadruped_env.live.listener import DISCOVERY, NO_TOPICS
from quadruped_env.live.middleware.ros_graph import Endpoint, Graph
from quadruped_env.live.session import Session


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the level of detail."""
    parser.add_argument(
        "-v", "--verbose", action="store_true", help="also list publishers and subscriptions, with QoS and type hash"
    )
    parser.add_argument("--nodes", action="store_true", help="list the nodes instead, like 'ros2 node list'")


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Listen, print, and end."""
    listen = DISCOVERY if arguments.seconds is None else arguments.seconds
    while session.running and session.elapsed < listen:
        session.wait()
    graph = session.node.graph
    if arguments.nodes:
        print("\n".join(graph.nodes()))
        return 0
    endpoints = graph.endpoints()
    for name, group in itertools.groupby(endpoints, key=lambda one: one.topic):
        ends = list(group)
        print(f"{name} [{', '.join(dict.fromkeys(one.type_name for one in ends))}]")
        if arguments.verbose:
            for one in ends:
                print(f"    {_line(graph, one)}")
    for problem in graph.problems(all_processes=True):
        print(f"! {problem}")
    if not endpoints:
        session.say(f"listened on {session.node.network} for {session.elapsed:.1f} s; {NO_TOPICS}")
    return 0


def _line(graph: Graph, endpoint: Endpoint) -> str:
    qos = endpoint.qos
    return (
        f"{endpoint.kind:<12} {graph.owner(endpoint)}: {'reliable' if qos.reliable else 'best effort'}, "
        f"{'transient local' if qos.transient_local else 'volatile'}, {endpoint.type_hash or 'no type hash'}"
    )
