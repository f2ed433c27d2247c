"""Workers that one process starts and waits for: processes of this machine, or tasks of a Ray cluster."""

import contextlib
import logging
import os
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Final

import quadruped_env
from quadruped_env.errors import MissingExtraError, QuadrupedError, short
from quadruped_env.sweep.folder import STORAGE, Sweep
from quadruped_env.sweep.worker import work

_GRACE: Final = 10.0
"""Time for workers to save their checkpoints after a signal, s."""
_POLL: Final = 1.0
"""Time between calls of `show`, s."""
_CONNECTION: Final = 10.0
"""Maximum time for a connection to the head of a Ray cluster, s."""
_RETRIES: Final = 10
"""Number of times that Ray restarts a worker whose node or process was lost."""


def run_here(sweep: Sweep, count: int, trusted: bool, show: Callable[[], None]) -> list[str]:
    """Run workers as processes of this machine until none is left.

    Args:
        sweep: the sweep.
        count: number of workers.
        trusted: True to execute the sweep's copy of the user's task file.
        show: shows the progress; called once per second.

    Returns:
        The last lines of workers that ended with an error, each once.

    Raises:
        KeyboardInterrupt: after a signal; the workers have saved their checkpoints and ended.
    """
    command = [sys.executable, str(Path(quadruped_env.__file__).parent), "sweep", "--work", str(sweep.path)]
    command += ["--trust-task"] * trusted
    with contextlib.ExitStack() as stack:
        files = [stack.enter_context(tempfile.TemporaryFile("w+", encoding="utf-8")) for _ in range(count)]
        # In sessions of their own, Ctrl-C reaches this process alone, which then stops each of them once.
        processes = [
            subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=file, start_new_session=True)  # noqa: S603
            for file in files
        ]
        try:
            while None in [process.poll() for process in processes]:
                show()
                time.sleep(_POLL)
        except BaseException:
            for process in processes:
                process.terminate()
            raise
        finally:
            for process in processes:
                try:
                    process.wait(_GRACE)
                except subprocess.TimeoutExpired:
                    process.kill()
        show()
        errors = []
        for process, file in zip(processes, files, strict=True):
            file.seek(0)
            lines = file.read().strip().splitlines() if process.returncode > 0 else []
            if process.returncode < 0:
                errors.append(f"a worker was ended by signal {-process.returncode}; perhaps the memory was full")
            errors += lines[-1:]
        return list(dict.fromkeys(errors))


def run_on_ray(sweep: Sweep, count: int | None, trusted: bool, address: str, show: Callable[[], None]) -> list[str]:
    """Run workers as tasks of a running Ray cluster, which restarts them if their node is lost.

    Args:
        sweep: the sweep, in a directory that all nodes share under the same name.
        count: number of workers; None: one per core of the cluster.
        trusted: see `run_here`.
        address: address of the cluster, to which this machine belongs; `auto` finds it.
        show: see `run_here`.

    Returns:
        The errors of workers, each once.

    Raises:
        MissingExtraError: if Ray is not installed.
        QuadrupedError: if there is no such cluster, or it refuses this process.
        KeyboardInterrupt: after a signal.
    """
    try:
        import ray
    except ImportError as error:
        raise MissingExtraError("A sweep on a Ray cluster", "ray") from error
    variables = {STORAGE: os.environ[STORAGE]} if STORAGE in os.environ else {}
    try:
        host, colon, port = address.rpartition("/")[2].rpartition(":")
        if colon:  # Ray itself waits for minutes
            socket.create_connection((host, int(port)), _CONNECTION).close()
        ray.init(address, logging_level=logging.ERROR, log_to_driver=False, runtime_env={"env_vars": variables})
    except Exception as error:  # Ray raises several types
        reason = (str(error).strip().splitlines() or [type(error).__name__])[0]
        raise QuadrupedError(
            f"sweep.ray: no cluster can be used at {short(address)} ({reason}); check that `ray status` works here, "
            f"that all nodes have the same Python, Ray and token (docs/scaling.md)"
        ) from error
    try:
        task = ray.remote(num_cpus=1, max_retries=_RETRIES)(_work_as_task)
        count = count or int(ray.cluster_resources().get("CPU", 1))
        tasks = [task.remote(str(sweep.path.resolve()), trusted) for _ in range(count)]
        try:
            while ray.wait(tasks, num_returns=count, timeout=_POLL)[1]:
                show()
        except BaseException:
            for one in tasks:
                ray.cancel(one)
            ray.wait(tasks, num_returns=count, timeout=_GRACE)
            raise
        show()
        return list(dict.fromkeys(message for message in ray.get(tasks) if message))
    finally:
        ray.shutdown()


def _work_as_task(path: str, trusted: bool) -> str:
    """Do trials, and return the error that ended the worker; empty if there was none."""
    try:
        work(Sweep.open(Path(path)), trusted, print)
    except (QuadrupedError, OSError, MemoryError, ImportError) as error:
        return str(error)
    return ""
