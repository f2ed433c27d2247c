"""The address of a running Ray cluster: whether a cluster answers there, and what to check if none does."""

import socket
import subprocess
import sys
from typing import Final

from quadruped_env.errors import QuadrupedError, short

CONNECT_SECONDS: Final = 10.0
"""Time that a cluster's address has to accept a connection, s."""
ANSWER_SECONDS: Final = 60.0
"""Time that the cluster has to answer as one, s."""
_PROBE: Final = """
import logging, sys, ray
ray.init(address=sys.argv[1], logging_level=logging.ERROR, log_to_driver=False)
print(sum(node["Resources"].get("CPU", 0.0) for node in ray.nodes() if node["Alive"]))
"""


def check_answers(address: str, seconds: float = ANSWER_SECONDS) -> float:
    """Check that a Ray cluster answers at an address, within a bounded time.

    Args:
        address: `host:port`.
        seconds: time that the cluster has to answer as one, s.

    Returns:
        Number of CPUs of the cluster.

    Raises:
        QuadrupedError: if the address is not `host:port`, or no cluster answers; the message says what to check.
    """
    host, _, port = address.rpartition(":")
    if not host or "/" in host or not port.isdigit():
        raise QuadrupedError(f"--address: expected host:port, as `ray start --head` prints it; found {short(address)}")
    try:
        socket.create_connection((host, int(port)), CONNECT_SECONDS).close()
    except (OSError, OverflowError) as error:
        raise QuadrupedError(
            f"--address: {address} does not answer ({error}); check that `ray start --head` runs there, that the port "
            f"is the one it printed, and that no firewall is between"
        ) from error
    # What answers may be no Ray, and Ray's own client then waits for minutes, or ends its process.
    try:
        probe = subprocess.run(  # noqa: S603
            [sys.executable, "-c", _PROBE, address], capture_output=True, text=True, check=False, timeout=seconds
        )
    except subprocess.TimeoutExpired as error:
        raise refused(address, f"no answer within {seconds:g} s") from error
    if probe.returncode:
        raise refused(address, (probe.stderr.strip().splitlines() or ["no message"])[-1])
    return float(probe.stdout.split()[-1])


def refused(address: str, reason: str) -> QuadrupedError:
    """The error of a cluster that cannot be used for this reason."""
    return QuadrupedError(
        f"--address: no Ray cluster can be used at {address} ({short(reason)}); check that `ray status --address "
        f"{address}` works there, that this machine is a node of it (`ray start --address={address}`), and that Python "
        f"and Ray have the same versions on both"
    )
