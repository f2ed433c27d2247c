"""Say which topics there are on the domain, of which types, and with --verbose who publishes and hears them.

Listens for a moment, since those who are there tell of themselves only then. Names what keeps a publisher and a
subscription apart: types or qualities of service that do not fit, or announced structures that cannot be compared.
"""

import argparse
import itertools

from quadruped_env.live.graph import Endpoint, Graph
from quadruped_env.live.listener import DISCOVERY
from quadruped_env.live.session import Session


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """How much is said."""
    parser.add_argument("-v", "--verbose", action="store_true", help="say who, with which quality of service and hash")


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Listen, print, and end."""
    listen = DISCOVERY if arguments.seconds is None else arguments.seconds
    while session.running and session.elapsed < listen:
        session.wait()
    graph = session.node.graph
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
        session.say(f"nobody is on {session.node.network}")
    return 0


def _line(graph: Graph, endpoint: Endpoint) -> str:
    qos = endpoint.qos
    return (
        f"{endpoint.kind:<12} {graph.owner(endpoint)}: {'reliable' if qos.reliable else 'best effort'}, "
        f"{'transient local' if qos.transient_local else 'volatile'}, {endpoint.type_hash or 'no type hash'}"
    )
