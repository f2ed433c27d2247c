"""Connection to Ray: on this machine, on loopback alone, or to a running cluster of which this machine is a node.

A Ray cluster executes what any process sends to it: it belongs in a trusted network (docs/scaling.md).
"""

import contextlib
import importlib.util
import logging
import os
import socket
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, short

_LOOPBACK: Final = "127.0.0.1"
_ENVIRONMENT: Final = {
    "RAY_USAGE_STATS_ENABLED": "0",
    "RAY_DISABLE_IMPORT_WARNING": "1",
    # Ray Tune's own tables, and its loggers that write the results a second time.
    "TUNE_DISABLE_AUTO_CALLBACK_LOGGERS": "1",
    "RAY_AIR_NEW_OUTPUT": "0",
    "TUNE_WARN_EXCESSIVE_EXPERIMENT_CHECKPOINT_SYNC_THRESHOLD_S": "0",
    "RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO": "0",
}
_ONE_MACHINE: Final = "RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER"
"""With 0, Ray takes the loopback address for this node's, as on Windows and macOS, and then listens nowhere else. It is
read when Ray is imported."""
_PROBE: Final = "import logging, sys, ray; ray.init(sys.argv[1], logging_level=logging.ERROR, log_to_driver=False)"


def check_installed(purpose: str) -> None:
    """Raise a MissingExtraError if Ray is not installed, without importing it."""
    if importlib.util.find_spec("ray") is None:
        raise MissingExtraError(purpose, "sweep")


def check_answers(address: str, seconds: float = 60.0) -> None:
    """Check that a Ray cluster answers at an address, within a bounded time.

    Args:
        address: `host:port`.
        seconds: time that the cluster has to answer as one, s, after 10 s to accept a connection.

    Raises:
        QuadrupedError: if the address is not `host:port`, or no cluster answers; the message says what to check.
    """
    host, _, port = address.rpartition(":")
    if not host or "/" in host or not port.isdigit():
        raise QuadrupedError(f"--address: expected host:port, as `ray start --head` prints it; found {short(address)}")
    try:
        socket.create_connection((host, int(port)), 10.0).close()
    except (OSError, OverflowError) as error:
        raise QuadrupedError(
            f"--address: {address} does not answer ({error}); check that `ray start --head` runs there, that the port "
            f"is the one it printed, and that no firewall is between"
        ) from error
    # What answers may be no Ray, and Ray's own client then waits for minutes, or ends its process.
    command = [sys.executable, "-c", _PROBE, address]
    try:
        probe = subprocess.run(command, capture_output=True, encoding="utf-8", check=False, timeout=seconds)  # noqa: S603
    except subprocess.TimeoutExpired as error:
        raise _refused(address, f"no answer within {seconds:g} s") from error
    if probe.returncode:
        raise _refused(address, (probe.stderr.strip().splitlines() or ["no message"])[-1])


@contextlib.contextmanager
def connected(address: str | None, cores: int = 1) -> Iterator[Any]:
    """Ray's module with a running cluster; one that was started here ends with the context.

    Args:
        address: `host:port` of a running cluster that answers (`check_answers`), of which this machine is a node; None
            starts Ray here.
        cores: cores of a cluster that is started here.

    Raises:
        QuadrupedError: if the cluster does not answer, or Ray does not start.
    """
    options: dict[str, Any] = {"address": address, "logging_level": logging.ERROR, "log_to_driver": False}
    os.environ.update(_ENVIRONMENT)
    if address is None:
        os.environ |= {_ONE_MACHINE: "0", "RAY_worker_niceness": "0"}  # the priority of a training by hand
        # Not the cluster that RAY_ADDRESS names.
        options |= {"address": "local", "num_cpus": cores, "include_dashboard": False, "_node_ip_address": _LOOPBACK}
    import ray

    try:
        ray.init(**options)
    except (ConnectionError, RuntimeError, ValueError) as error:
        reason = (str(error).strip().splitlines() or [type(error).__name__])[0]
        if address is not None:
            raise _refused(address, reason) from error
        raise QuadrupedError(
            f"Ray does not start on this machine ({reason}); see {tempfile.gettempdir()}/ray/session_latest/logs"
        ) from error
    try:
        if address is None and (found := ray.util.get_node_ip_address()) != _LOOPBACK:
            raise QuadrupedError(
                f"Ray would listen on {found}, because it was imported before the sweep; start the sweep in a process "
                f"that has not imported ray, or set {_ONE_MACHINE}=0"
            )
        yield ray
    finally:
        ray.shutdown()


def _refused(address: str, reason: str) -> QuadrupedError:
    return QuadrupedError(
        f"--address: no Ray cluster can be used at {address} ({short(reason)}); check that `ray status --address "
        f"{address}` works there, that this machine is a node of it (`ray start --address={address}`), and that Python "
        f"and Ray have the same versions on both"
    )
