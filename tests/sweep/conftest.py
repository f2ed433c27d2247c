"""A cluster of Ray on this machine."""

import subprocess
import sys

import pytest
from paths import TESTS, importing
from sweeps import ONE_MACHINE, Family
from waiting import status_of


@pytest.fixture
def nodes():
    """A cluster of two nodes: its address, and a function that kills the second one."""
    pytest.importorskip("ray")
    process = subprocess.Popen(
        [sys.executable, str(TESTS / "helpers" / "ray_nodes.py")],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env={**importing(), **ONE_MACHINE},
    )
    family = Family(process.pid)

    def kill_one():
        process.stdin.write("kill\n")
        process.stdin.flush()
        assert process.stdout.readline() == "killed\n"

    try:
        address = process.stdout.readline().strip()
        assert address.startswith("127.0.0.1:"), address
        family.update()
        yield address, kill_one
    finally:
        family.update()
        process.stdin.close()
        try:
            status_of(process)
        finally:
            process.stdout.close()
            family.kill()
