"""DDS domains for tests: one per test, also with several test suites on a machine, and without other programs."""

import contextlib
import random
import socket

import psutil

FIRST, LAST = 41, 100
"""Domains above those in common use, and below those whose ports Linux gives to any program (from 32768 on)."""


def ports(number):
    """The UDP ports of a domain in the DDSI-RTPS standard; participants take the first ones."""
    return range(7400 + 250 * number, 7400 + 250 * (number + 1))


@contextlib.contextmanager
def claimed():
    """A domain that no other test and no other program of this machine uses now.

    Another suite that claims the same domain cannot bind its last port. Participants of any DDS bind the first ones.
    """
    for number in random.sample(range(FIRST, LAST + 1), LAST + 1 - FIRST):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as claim:
            try:
                claim.bind(("127.0.0.1", ports(number)[-1]))
            except OSError:
                continue
            if len({one.laddr.port for one in psutil.net_connections("udp") if one.laddr} & {*ports(number)}) > 1:
                continue
            yield number
            return
    raise RuntimeError(f"every domain from {FIRST} to {LAST} is used by another test or program on this machine")
