"""Ranks as threads of one process, so that a test sees each of them."""

import threading
from concurrent.futures import ThreadPoolExecutor

from waiting import DEADLINE

from quadruped_env.scale.ranks.torch_group import RankGroup


class _Meeting:
    def __init__(self, ranks):
        self.barrier = threading.Barrier(ranks, timeout=DEADLINE)
        self.values = [None] * ranks


class ThreadGroup(RankGroup):
    """A rank whose others are threads; it adds in the order of the ranks."""

    def __init__(self, meeting, rank, ranks):
        super().__init__(rank, ranks, threads=1)
        self._meeting = meeting

    def sum(self, values):
        meeting = self._meeting
        meeting.values[self.rank] = values.clone()
        meeting.barrier.wait()
        total = sum(meeting.values[1:], start=meeting.values[0].clone())
        meeting.barrier.wait()
        values.copy_(total)


def on_ranks(ranks, function):
    """Results of `function(group)` on each of several ranks; an error of one ends the others."""
    meeting = _Meeting(ranks)

    def run(rank):
        try:
            return function(ThreadGroup(meeting, rank, ranks))
        except BaseException:
            meeting.barrier.abort()
            raise

    with ThreadPoolExecutor(ranks) as pool:
        futures = [pool.submit(run, rank) for rank in range(ranks)]
    errors = [error for future in futures if (error := future.exception()) is not None]
    # An error before those that it made in the others.
    for error in sorted(errors, key=lambda error: isinstance(error, threading.BrokenBarrierError)):
        raise error
    return [future.result() for future in futures]
