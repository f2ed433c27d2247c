"""Ray on this machine, on loopback alone, or a running cluster that is joined.

A Ray cluster executes what any process sends to it: it belongs in a trusted network (docs/sweeps.md).
"""

import contextlib
import importlib.util
import logging
import os
import tempfile
from collections.abc import Iterator
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.scale.ranks.ray_address import refused

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
"""With 0, Ray takes the loopback address for this node's, as on Windows and macOS, and then listens nowhere else."""


@contextlib.contextmanager
def connected(address: str | None, cores: int) -> Iterator[Any]:
    """Ray's module with a running cluster; one that was started here ends with the context.

    Args:
        address: `host:port` of a running cluster that answers (`check_answers`), of which this machine is a node; None
            starts Ray here.
        cores: cores of a cluster that is started here.

    Raises:
        MissingExtraError: if Ray is not installed.
        QuadrupedError: if the cluster does not answer, or Ray does not start.
    """
    os.environ.update(_ENVIRONMENT)
    if address is None:
        os.environ |= {_ONE_MACHINE: "0", "RAY_worker_niceness": "0"}  # the priority of a training by hand
    ray = _imported()
    options: dict[str, Any] = {"logging_level": logging.ERROR, "log_to_driver": False}
    if address is None:
        # Not the cluster that RAY_ADDRESS names.
        options |= {"address": "local", "num_cpus": cores, "include_dashboard": False, "_node_ip_address": _LOOPBACK}
    else:
        options["address"] = address
    # Lost trials are reported in a line, without the traceback of Ray Tune.
    logging.getLogger("ray.tune").setLevel(logging.CRITICAL)
    try:
        ray.init(**options)
    except (ConnectionError, RuntimeError, ValueError) as error:
        reason = (str(error).strip().splitlines() or [type(error).__name__])[0]
        if address is None:
            raise QuadrupedError(
                f"Ray does not start on this machine ({reason}); see {tempfile.gettempdir()}/ray/session_latest/logs"
            ) from error
        raise refused(address, reason) from error
    try:
        if address is None and (found := ray.util.get_node_ip_address()) != _LOOPBACK:
            raise QuadrupedError(
                f"Ray would listen on {found}, because it was imported before the sweep; start the sweep in a process "
                f"that has not imported ray, or set {_ONE_MACHINE}=0"
            )
        yield ray
    finally:
        ray.shutdown()


def check_installed() -> None:
    """Raise a MissingExtraError if Ray is not installed, without importing it."""
    if importlib.util.find_spec("ray") is None:
        raise MissingExtraError("A sweep", "sweep")


def _imported() -> Any:
    """Ray with Ray Tune. It reads `_ONE_MACHINE` when it is imported."""
    try:
        import ray
        import ray.tune
    except ImportError as error:
        raise MissingExtraError("A sweep", "sweep") from error
    return ray
