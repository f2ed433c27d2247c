"""Measure the rate of messages, like `ros2 topic hz`: one line per second and topic.

    mini-quadruped live hz /joint_states
    mini-quadruped live hz                 all published topics

Periods are measured between the arrivals of the last messages (--window). Messages since the last line are reported at
the end.
"""

import argparse
from collections import deque

import numpy as np

from quadruped_env.live.listener import Listener
from quadruped_env.live.middleware.node import Subscription
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session

PERIOD = 1.0
"""Time between lines, s."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the topics and the window."""
    parser.add_argument("topics", nargs="*", metavar="TOPIC", help="such as /joint_states (default: all)")
    parser.add_argument(
        "--window", type=int, default=1000, metavar="N", help="messages to measure over (default: %(default)s)"
    )


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Measure until the session ends."""
    listener = Listener(session, arguments.topics)
    arrivals: dict[Subscription[bytes], deque[float]] = {}
    pace, printed = Pace(PERIOD), 0
    pace.tick()
    for _ in session.turns():
        listener.update()
        for subscription in listener.subscriptions:
            times = arrivals.setdefault(subscription, deque(maxlen=max(2, arguments.window)))
            times.extend(received.taken for received in subscription.take())
        session.wait_for(listener.missing)
        if pace.tick():
            _print(arrivals)
            printed = _count(arrivals)
    if not _count(arrivals):
        raise listener.nothing_to("measure")
    if pace.ticks == 1 or _count(arrivals) > printed:
        _print(arrivals)
    return 0


def _count(arrivals: dict[Subscription[bytes], deque[float]]) -> int:
    return sum(subscription.count for subscription in arrivals)


def _print(arrivals: dict[Subscription[bytes], deque[float]]) -> None:
    for subscription, times in arrivals.items():
        print(f"{subscription.topic.name}: {rate_text(times)}", flush=True)


def rate_text(times: deque[float]) -> str:
    """Description of the rate and periods of messages with these arrival times, s."""
    if len(times) < 2:
        return f"{len(times)} messages" if len(times) != 1 else "1 message"
    periods = np.diff(times)
    milliseconds = 1e3 * periods
    return (
        f"average rate {1.0 / max(periods.mean(), 1e-9):.2f} Hz, period {milliseconds.min():.2f} to "
        f"{milliseconds.max():.2f} ms, standard deviation {milliseconds.std():.2f} ms, {len(times)} messages"
    )
