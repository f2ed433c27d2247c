"""The program's errors before any trial, its resume, and the wait for a cluster that does not answer."""

import re
import socket
import subprocess
import sys
import time
from types import SimpleNamespace

import pytest
from waiting import DEADLINE

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.errors import MissingExtraError
from quadruped_env.sweep import SweepConfig, ray_connection
from quadruped_env.sweep.sweep_definition import sha256_of
from quadruped_env.sweep.sweep_records import SweepFolder

TINY = ("--timesteps", "2048", "--num-envs", "16", "--n-steps", "16", "--batch-size", "64")


@pytest.fixture
def fails(tmp_path, capsys):
    """Function that runs the program with arguments that it refuses; its message. No sweep begins."""
    pytest.importorskip("ray")

    def run(*arguments):
        capsys.readouterr()
        before = sorted(tmp_path.rglob("*"))
        assert main(["sweep", "-o", str(tmp_path), *map(str, arguments)]) == 2
        said = capsys.readouterr()
        assert said.err.startswith("mini-quadruped sweep: error: ")
        assert said.err.count("\n") == 1
        assert sorted(tmp_path.rglob("*")) == before
        return said.err

    return run


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ("--vary", "learning_rat=1..2"),
            "--vary learning_rat: unknown field 'learning_rat'; similar fields: learning_rate",
        ),
        (("--vary", "learning_rate=1e-2..1e-4"), "swap the ends: 0.0001..0.01"),
        (("--vary", "tau=0.1..0.2"), "tau: ppo does not use it"),
        (("--seeds", 0), "--seeds: expected 1 or more, and at most 1000000000; found 0"),
        (("--trials", 5), "--trials: found 5 without a field that varies"),
        (("--scheduler", "asha"), "--scheduler: asha compares trials"),
        (("--cores", 0), "--cores: expected 1 or more; found 0"),
        (("--cores-per-trial", 5000), "--cores-per-trial: found 5000; this machine has "),
        (("--cores", 1, "--address", "a:1"), "--cores: found with --address"),
        (("--num-envs", 0), "--num-envs: expected 1 or more, and at most 1000000; found 0"),
        (("--space", "nowhere.toml"), "nowhere.toml: there is no such file"),
        (("--resume", "nowhere"), "--resume: nowhere: there is no such directory"),
        (("--address", "ray://a:10001"), "--address: expected host:port"),
        (("--level", 3), "--level: found 3 without --terrain"),
    ],
)
def test_bad_option_is_an_error_before_any_file(fails, arguments, message):
    assert message in fails(*arguments)


def test_resumed_sweep_keeps_its_definition(fails, tmp_path):
    folder = SweepFolder.create(tmp_path, "ppo", SweepConfig({"timesteps": 2048}, seeds=8), "sweep").path
    for option, value, found in (
        ("--seeds", 4, f"4; the sweep in {folder} has 8, and a resumed sweep keeps its definition"),
        ("--timesteps", 4096, "4096"),
        ("--gamma", 0.9, "0.9"),
        ("--vary", "gamma=0.9..0.99", "['gamma=0.9..0.99']"),
        ("--scheduler", "asha", "'asha'"),
    ):
        assert f"{option}: found {found}" in fails("--resume", folder, option, value)


def test_task_file_that_only_a_sweep_names_is_not_executed(fails, tmp_path):
    file = tmp_path / "terms.py"
    file.write_text("raise RuntimeError('executed')\n")
    config = SweepConfig({"timesteps": 2048}, seeds=8, task_file=str(file), task_sha256=sha256_of(file))
    folder = SweepFolder.create(tmp_path, "ppo", config, "sweep").path
    message = fails("--resume", folder)
    assert "--resume: this sweep has terms from 'terms.py', which is not executed automatically: check" in message
    assert "executed" in fails("--resume", folder, "--task", file), "told to"
    file.write_text("from quadruped_env.task import reward\n@reward(1.0)\ndef mine(context): ...\n")
    message = fails("--resume", folder, "--task", file)
    assert f"--task {file}: SHA-256: found '{sha256_of(file)[:8]}" in message
    assert f"has '{config.task_sha256[:8]}" in message


def test_address_without_a_listener_is_an_error_that_says_what_to_check(fails):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{free.getsockname()[1]}"
    assert re.search(
        f"--address: {address} does not answer .*`ray start --head` runs there", fails("--address", address)
    )


def test_listener_that_is_no_ray_ends_in_an_error_after_a_bounded_wait():
    pytest.importorskip("ray")
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        address = f"127.0.0.1:{silent.getsockname()[1]}"
        began = time.monotonic()
        with pytest.raises(QuadrupedError, match=rf"no Ray cluster can be used at {address}.*`ray status --address"):
            ray_connection.check_answers(address, seconds=2.0)
        assert time.monotonic() - began < DEADLINE


def test_missing_ray_names_its_extra(monkeypatch):
    monkeypatch.setattr(ray_connection.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(MissingExtraError, match=r"A sweep needs the 'sweep' extra"):
        ray_connection.check_installed("A sweep")


def test_ray_that_would_listen_on_a_network_is_refused_and_ended(monkeypatch):
    ended = []
    ray = SimpleNamespace(
        init=lambda **options: None,
        shutdown=lambda: ended.append(True),
        util=SimpleNamespace(get_node_ip_address=lambda: "192.0.2.7"),
    )
    monkeypatch.setitem(sys.modules, "ray", ray)
    with pytest.raises(QuadrupedError, match=r"Ray would listen on 192\.0\.2\.7"), ray_connection.connected(None):
        pass
    assert ended


def test_program_and_package_do_not_import_ray():
    code = "import sys, quadruped_env, quadruped_env.cli.sweep; print({'ray', 'optuna', 'torch'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"
