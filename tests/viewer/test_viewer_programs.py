"""The viewer's server and its program."""

import math
import os
import signal
import socket
import subprocess
import sys

import psutil
import pytest
from paths import ROOT
from policies import TASK, make_policy
from waiting import output_of

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env.policies import Policy
from quadruped_env.task import TaskConfig
from quadruped_env.viewer import open_show
from quadruped_env.viewer.server import start_server, stop_server


def test_port_in_use_is_replaced_by_the_next_free_one():
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        taken = other.getsockname()[1]
        server = start_server(port=taken)
        try:
            assert taken < server.get_port() < taken + 100
            listening = {
                c.laddr.ip
                for c in psutil.Process().net_connections("inet")
                if c.status == psutil.CONN_LISTEN and c.laddr.port == server.get_port()
            }
            assert listening == {"127.0.0.1"}
        finally:
            stop_server(server)


def test_address_of_another_machine_is_refused():
    with pytest.raises(QuadrupedError, match=r"--host: cannot listen on '203\.0\.113\.1'"):
        start_server("203.0.113.1")
    with pytest.raises(QuadrupedError, match="--port: expected 0 to"):
        start_server(port=70000)


def test_missing_viser_error_names_the_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "viser", None)
    with pytest.raises(MissingExtraError, match=r"The viewer needs the 'viewer' extra: .*\[viewer\]"):
        open_show(port=0)


@pytest.mark.parametrize(
    ("command", "found"),
    [
        ((5.0, 0.0), "forward_velocity = 5 is outside -0.3 to 0.6 m/s"),
        ((0.0, -1.0), "yaw_rate = -1 is outside -0.8 to 0.8 rad/s"),
        ((math.nan, 0.0), "forward_velocity = nan is outside -0.3 to 0.6 m/s"),
    ],
)
def test_initial_command_out_of_range_is_refused_with_the_range(command, found):
    with pytest.raises(QuadrupedError, match=f"command: {found}; give a command in this range"):
        open_show(["flat"], command, port=0)


def test_command_range_is_the_widest_of_the_default_and_the_robots_tasks(control, tmp_path):
    policy = make_policy()
    config = TaskConfig.from_dict(TASK.to_dict() | {"command": {"forward_velocity": (-0.1, 0.9)}})
    Policy.for_task(policy.weights, policy.biases, policy.activation, config, policy.card).save(tmp_path / "fast")
    fast = str(tmp_path / "fast")
    ranges = [entry.range for entry in control(asked=[fast]).command_ranges]
    assert ranges == [(-0.3, 0.9), (-0.8, 0.8)]
    with pytest.raises(QuadrupedError, match=r"forward_velocity = 1 is outside -0\.3 to 0\.9 m/s"):
        open_show([fast], (1.0, 0.0), port=0)


def _program(*arguments, **options):
    return subprocess.Popen(
        [sys.executable, ROOT / "evaluate" / "view.py", "--port", "0", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=os.environ | {"PYTHONWARNINGS": "error"},
        **options,
    )


def test_program_prints_its_address_and_ends_at_ctrl_c(tmp_path):
    process = _program("flat", "trot", cwd=tmp_path)
    line = process.stdout.readline()
    assert line.startswith("policy flat, gait trot: http://127.0.0.1:")
    process.send_signal(signal.SIGINT)
    out, err = output_of(process)
    assert (process.returncode, out, err) == (0, "ending\n", "")
