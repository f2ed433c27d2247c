"""The command `sweep`, and workers as processes: of one machine, of two, and of a Ray cluster."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import psutil
import pytest
from paths import ROOT, importing
from sweeps import finish, make_sweep, policies, start_worker
from trainings import learn
from waiting import DEADLINE, output_of, status_of, wait_until

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.cli.sweep import Progress
from quadruped_env.sweep import workers
from quadruped_env.sweep.folder import Sweep
from quadruped_env.sweep.workers import run_here, run_on_ray
from quadruped_env.training import run_directory
from quadruped_env.training.resume import Parent

LOOPBACK = {"RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER": "0", "RAY_USAGE_STATS_ENABLED": "0"}
"""Variables with which all of Ray's processes listen on loopback alone."""
TURNS = int(os.environ.get("SWEEP_TURNS", "3"))
"""Random moments of a signal that are tried; one takes about a minute."""
TINY = ("--timesteps", "96", "--num-envs", "4", "--n-steps", "8", "--batch-size", "16", "--hidden", "8")


def command(*arguments):
    return [sys.executable, str(ROOT / "train" / "sweep.py"), *map(str, arguments)]


def made(directory, *arguments):
    """The sweep that the command makes, without workers."""
    before = set(directory.glob("*"))
    assert main(["sweep", *map(str, arguments), *TINY, "--workers", "0", "-o", str(directory)]) == 0
    (path,) = set(directory.iterdir()) - before
    return Sweep.open(path)


def test_command_makes_a_sweep_of_all_choices_or_of_20_trials(tmp_path, capsys):
    sweep = made(tmp_path / "a", "--seeds", "2", "--vary", "gamma=0.9,0.95", "--vary", "n_epochs=1..3")
    assert (sweep.settings, sweep.seeds, sweep.training["timesteps"]) == (6, 2, 96)
    assert f"sweep --work {sweep.path}\n" in capsys.readouterr().out
    assert made(tmp_path / "b", "--vary", "gamma=0.9..1").settings == 20
    assert made(tmp_path / "c", "--vary", "gamma=0.9..1", "--trials", "3").settings == 3
    assert made(tmp_path / "d", "--recipe", "walker", "--terrain", "slope").whole == ("terrain",)


def test_sweeps_of_one_second_have_directories_of_their_own(tmp_path, monkeypatch):
    monkeypatch.setattr(run_directory.time, "strftime", lambda form: "now")
    # As two processes see it, of which each looks before the other writes.
    monkeypatch.setattr(Path, "exists", lambda path, **named: False)
    assert [made(tmp_path, "--seeds", count).seeds for count in (1, 2)] == [1, 2]
    assert {path.name for path in tmp_path.iterdir()} == {"now-ppo", "now-ppo-2"}


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (("--work", "DIR", "--seeds", "3"), "--seeds: a sweep keeps its own definition"),
        (("--report", "DIR", "--timesteps", "3"), "--timesteps: a sweep keeps its own definition"),
        (("--work", "DIR", "--task", "mine.py"), "--task: "),
        (("--retry-failed",), "--retry-failed, --trust-task: only with --work or --ray"),
        (("--workers", "-1"), "--workers: expected 0 or more"),
        (("--work", "DIR", "--workers", "-1"), "--workers: expected 0 or more"),
        (("--vary", "gamma=0.9,0.95", "--vary", "gamma=0.8,0.85"), "--vary: found gamma, gamma; give each field once"),
        (("--vary", "gamma=0.9,2"), "--vary gamma=2"),
        (
            ("--vary", "gamma=0.9,0.95", "--trials", "3"),
            "--trials: found 3, but a setting is tried once",
        ),
        (("--work", "nowhere"), "has no sweep.json; name a directory that 'sweep' made"),
        (("--ray", "127.0.0.1:1", "DIR"), "ray"),
    ],
)
def test_options_that_do_not_fit_are_one_line(tmp_path, monkeypatch, capsys, arguments, error):
    monkeypatch.chdir(tmp_path)
    path = make_sweep(tmp_path).path
    monkeypatch.setitem(sys.modules, "ray", None)
    assert main(["sweep", *(str(path) if word == "DIR" else word for word in arguments)]) in (1, 2)
    (line,) = capsys.readouterr().err.splitlines()
    assert error in line
    assert list(tmp_path.iterdir()) == [path]


def test_report_of_a_sweep_so_far(tmp_path, capsys):
    sweep = make_sweep(tmp_path, seeds=2)
    finish(sweep, 0, None)
    assert main(["sweep", "--report", str(sweep.path)]) == 1
    out = capsys.readouterr().out
    assert "0 of 2 trials finished, 1 failed, 1 open." in out
    assert f"report:  {sweep.path}/report.html" in out


def test_local_workers_say_once_why_they_ended_and_trust_the_task_file_that_their_parent_trusts(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    term = "from quadruped_env.task import reward\n@reward(1.0)\ndef mine(context):\n    return context.base_height\n"
    (tmp_path / "mine.py").write_text(term)
    sweep = made(tmp_path / "a", "--task", "mine.py")
    (line,) = run_here(sweep, 2, False, lambda: None)
    assert "task.py: this sweep has terms from 'mine.py', which is not executed automatically" in line
    finish(sweep, 0, None)
    assert run_here(sweep, 1, True, lambda: None) == []


def test_command_that_makes_a_sweep_trusts_its_task_file_and_the_status_is_1_while_trials_are_open(
    tmp_path, monkeypatch, capsys
):
    trusts = []

    def do_trials(sweep, arguments, trusted):
        trusts.append(trusted)
        return []

    monkeypatch.setattr("quadruped_env.cli.sweep.do_trials", do_trials)
    assert main(["sweep", *TINY, "-o", str(tmp_path)]) == 1
    (path,) = tmp_path.iterdir()
    assert main(["sweep", "--work", str(path)]) == 1
    assert main(["sweep", "--work", str(path), "--trust-task"]) == 1
    assert trusts == [True, False, True]
    assert capsys.readouterr().out.count("open trials: 1 of 1; go on with:") == 3


def test_progress_says_each_result_once_also_of_other_machines(tmp_path, monkeypatch, capsys):
    shares = []
    monkeypatch.setattr("quadruped_env.cli.sweep.ProgressLine", lambda name: lambda *state: shares.append(state))
    sweep = make_sweep(tmp_path, seeds=2)
    finish(sweep, 0, 0.5)
    progress = Progress(sweep)
    finish(sweep, 1, None)
    progress()
    progress()
    assert capsys.readouterr().out == "trial 1: failed: diverged\n", "trial 0 was there before"
    assert shares == [(1.0, ", 2 of 2 trials done")] * 2


def test_cluster_that_cannot_be_reached_is_an_error_without_a_wait_for_ray(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "ray", SimpleNamespace())
    sweep = make_sweep(tmp_path)
    for address in ("127.0.0.1:1", "127.0.0.1:port"):
        with pytest.raises(QuadrupedError, match=rf"no cluster can be used at '{address}' \((.*refused|invalid)"):
            run_on_ray(sweep, 1, False, address, lambda: None)


def test_error_of_a_worker_is_status_1_also_if_no_trial_is_open(tmp_path, monkeypatch, capsys):
    path = make_sweep(tmp_path).path
    finish(Sweep.open(path), 0, 0.5)
    (path / "worker.json").write_text(json.dumps({"python": "0.1"}))
    assert main(["sweep", "--work", str(path)]) == 1
    captured = capsys.readouterr()
    assert "has python 0.1" in captured.err
    assert "open trials" not in captured.out


def test_no_more_workers_start_than_there_are_trials(tmp_path, monkeypatch):
    counts = []

    def run_here(sweep, count, trusted, show):
        counts.append(count)
        return []

    monkeypatch.setattr(workers, "run_here", run_here)
    path = make_sweep(tmp_path, seeds=3).path
    for count in (2, 5):
        assert main(["sweep", "--work", str(path), "--workers", str(count)]) == 1
    assert counts == [2, 3]


@pytest.mark.slow
def test_sweep_whose_worker_is_killed_finishes_each_trial_once_and_reports(tmp_path):
    with subprocess.Popen(
        command("--seeds", 4, "--workers", 2, *TINY, "-o", tmp_path),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=importing(),
    ) as process:
        wait_until(lambda: list(tmp_path.glob("*/trials/*/2*/config.json")), alive=process)
        next(child for child in psutil.Process(process.pid).children() if "--work" in child.cmdline()).kill()
        out, err = output_of(process)
    assert process.returncode == 0, out + err
    assert "a worker was ended by signal 9" in err
    (path,) = tmp_path.iterdir()
    assert sorted(map(int, re.findall(r"^trial (\d): finished", out, re.MULTILINE))) == [0, 1, 2, 3]
    assert (path / "report.html").is_file()
    assert "4 of 4 trials finished" in out


@pytest.mark.slow
def test_signal_to_the_command_stops_its_workers_with_their_checkpoints(tmp_path):
    with subprocess.Popen(
        command("--seeds", 2, "--workers", 2, *TINY, "--timesteps", 10**9, "-o", tmp_path),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=importing(),
    ) as process:
        wait_until(lambda: len(list(tmp_path.glob("*/trials/*/2*/progress.csv"))) == 2, alive=process)
        process.send_signal(signal.SIGINT)
        out, err = output_of(process)
    assert process.returncode == 130, err
    (path,) = tmp_path.iterdir()
    assert "stopped; go on with:  " in out
    assert str(path) in out
    assert not (path / "report.html").exists()


@pytest.mark.slow
@pytest.mark.parametrize("turn", range(TURNS))
def test_two_machines_and_a_signal_do_each_trial_once_with_the_bits_of_its_checkpoint(tmp_path, turn):
    sweep = make_sweep(tmp_path, training={"timesteps": 32 * 100, "checkpoint_seconds": 0.2}, seeds=3)
    with start_worker(sweep, "a") as stopped, start_worker(sweep, "b") as other:
        wait_until(lambda: list(sweep.path.glob("trials/*/2*")), alive=stopped)
        try:
            stopped.wait(np.random.default_rng(turn).uniform(0.0, 3.0))
        except subprocess.TimeoutExpired:
            stopped.send_signal(signal.SIGTERM)
        output_of(stopped)
        _, err = output_of(other)
    assert stopped.returncode in (0, 143)
    assert other.returncode == 0, err
    assert sweep.open_trials() == []
    for number in range(3):
        last, bits = list(policies(sweep, number).items())[-1]
        assert sweep.result(number)["run"].endswith(last)
        before = json.loads((sweep.trial(number) / last / "config.json").read_text()).get("resumed_from")
        parent, config = None, sweep.config({}, number)
        if before is not None:
            parent = Parent.load(sweep.trial(number) / before["run"])
            config = parent.resumed({"timesteps": config.timesteps - parent.timesteps})
        undisturbed = learn(tmp_path / str(number), config, parent)
        assert (undisturbed / "policy.safetensors").read_bytes() == bits


@pytest.mark.slow
def test_full_disk_leaves_open_trials_and_with_more_room_they_are_done(tmp_path):
    place = tmp_path / "small"
    place.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=1500k", "tmpfs", str(place)]
    if subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("only root can mount a file system of 1.5 MB")
    try:
        sweep = make_sweep(place, seeds=4, training={"hidden": (128, 128)})
        worker = start_worker(sweep)
        _, err = output_of(worker)
        assert worker.returncode == 1
        assert "No space left on device" in err.splitlines()[-1]
        left = sweep.open_trials()
        assert 0 < len(left) < 4
        assert not any((sweep.trial(number) / "result.json").exists() for number in left)
        subprocess.run(["mount", "-o", "remount,size=50m", str(place)], check=True)
        worker = start_worker(sweep)
        _, err = output_of(worker)
        assert worker.returncode == 0, err
        assert sweep.open_trials() == []
    finally:
        subprocess.run(["umount", str(place)], check=True)


@pytest.mark.slow
def test_two_nodes_of_ray_do_the_trials_after_a_sweep_of_this_machine(tmp_path):
    pytest.importorskip("ray", reason="Ray is not installed")
    home = {**importing(), **LOOPBACK, "HOME": str(tmp_path)}

    def run(*arguments):
        done = subprocess.run(arguments, capture_output=True, text=True, check=False, env=home, timeout=4 * DEADLINE)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    ray = (sys.executable, "-m", "ray.scripts.scripts")
    run(*command("--seeds", 1, *TINY, "-o", tmp_path / "a"))
    sweep = made(tmp_path / "b", "--seeds", 3)
    run(*ray, "get-auth-token", "--generate")
    home["RAY_AUTH_MODE"] = "token"
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{free.getsockname()[1]}"
    start = (*ray, "start", "--block", "--node-ip-address=127.0.0.1", "--num-cpus=1")
    head = (*start, "--head", f"--port={address.partition(':')[2]}", "--include-dashboard=false")
    nodes = [subprocess.Popen(head, env=home, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)]
    try:
        status = (*ray, "status", f"--address={address}")
        wait_until(
            lambda: not subprocess.run(status, env=home, capture_output=True, check=False).returncode, alive=nodes[0]
        )
        node = (*start, f"--address={address}")
        nodes.append(subprocess.Popen(node, env=home, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        assert "3 of 3 trials finished" in run(*command("--ray", address, sweep.path))
    finally:
        for process in reversed(nodes):
            process.terminate()
            status_of(process)
