"""Waiting for conditions. No test depends on how fast the machine is; only a test that fails waits for a deadline.

`TEST_TIMEOUT_SCALE=4 make test` makes every deadline four times as long.
"""

import contextlib
import os
import subprocess
import time

SCALE = float(os.environ.get("TEST_TIMEOUT_SCALE", "1"))
"""Factor on every deadline."""
DEADLINE = 120.0 * SCALE
"""Seconds that a test waits for a condition before it fails."""


def wait_until(condition, what="the condition that the test waits for", alive=None, interval=0.005):
    """Wait until a condition holds, and return its value.

    Args:
        condition: called again and again.
        what: the condition's name in the error, or a function that returns it.
        alive: a process without which the condition can no longer become true.
        interval: seconds between calls.
    """
    end = time.monotonic() + DEADLINE
    while not (found := condition()):
        # What the process did before it ended may have made the condition true.
        if alive is not None and alive.poll() is not None and not condition():
            raise AssertionError(f"{_text(what)}: the process ended with status {alive.returncode}")
        assert time.monotonic() < end, f"{_text(what)} did not come about within {DEADLINE:g} s"
        time.sleep(interval)
    return found


def output_of(process):
    """Wait until a process ends; returns its standard output and error, as far as they are pipes."""
    try:
        return process.communicate(timeout=DEADLINE)
    except subprocess.TimeoutExpired:
        process.kill()
        output = process.communicate()
        raise AssertionError(f"{process.args} did not end within {DEADLINE:g} s; it printed {output}") from None


def status_of(process):
    """Wait until a process ends; returns its exit status."""
    try:
        return process.wait(DEADLINE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        raise AssertionError(f"{process.args} did not end within {DEADLINE:g} s") from None


@contextlib.contextmanager
def killed_on_failure(process):
    """A process that a test ends itself; if the test fails first, it is killed, so that nothing waits for it."""
    with process:
        try:
            yield process
        except BaseException:
            process.kill()
            raise


def _text(what):
    return what() if callable(what) else what
