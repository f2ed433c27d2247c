"""Small sweeps, workers whose trainings or scores are stubs, and workers in processes of their own.

As a program: a worker of a sweep. `python sweeps.py DIR HOST` has another host name, and a score without the suite.
"""

import json
import socket
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

from paths import importing
from trainings import SMALL

from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.sweep import worker
from quadruped_env.sweep.folder import Sweep
from quadruped_env.sweep.space import parse_dimension
from quadruped_env.task import TaskConfig

TASK = TaskConfig().to_dict()


def score(total):
    return {"total": total, "components": dict.fromkeys(COMPONENTS, total)}


def make_sweep(parent, *vary, training=None, **definition):
    """A sweep in `parent/s`, with fields that vary as typed."""
    space = dict(parse_dimension(text, TASK) for text in vary)
    sweep = Sweep(parent / "s", {**SMALL, "timesteps": 96, **(training or {})}, space=space, **definition)
    if "settings" not in definition and space:
        sweep = replace(sweep, settings=int(sweep.size))
    return sweep.create("sweep")


def finish(sweep, number, total, values=None, **facts):
    """Write a result; a score of None is a failed training's, with 0.1 of the zero action."""
    failed = {"state": "failed", "error": "diverged", "score": score(0.1)}
    result = failed if total is None else {"state": "finished", "score": score(total), "run": f"trials/{number:04d}/r"}
    sweep.finish(number, {"values": values or {}, "seconds": 1.0, "starts": 1, "node": "here", **result, **facts})


def stub_score(monkeypatch, value=0.5):
    """Score all policies without the suite."""
    monkeypatch.setattr(worker, "score_of_run", lambda run, task_file: {"score": score(value)})
    monkeypatch.setattr(worker, "score_of_zero_action", lambda config, base, task_file: score(0.1))


def stub_training(monkeypatch, train):
    """Call `train(config, directory)` for a training; its run directory has a card alone."""

    def stub(config, directory, command, parent, task_file):
        train(config, directory)
        run = directory / "run"
        run.mkdir()
        (run / "policy.json").write_text(json.dumps({"card": {"timesteps": config.timesteps}}))
        return run

    monkeypatch.setattr(worker, "_train", stub)
    stub_score(monkeypatch)
    monkeypatch.setattr(worker, "write_report", lambda sweep: None)


def work(sweep, trusted=False):
    """Do the open trials in this process; the lines that the worker says."""
    said = []
    worker.work(sweep, trusted, said.append)
    return said


def start_worker(sweep, host="a", **options):
    """A worker process, with scores that are stubs."""
    return subprocess.Popen(
        [sys.executable, __file__, str(sweep.path), host],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=importing(),
        **options,
    )


def policies(sweep, number):
    """Policies of a trial's runs: name of the run -> bytes."""
    found = sorted(sweep.trial(number).glob("2*/policy.safetensors"))
    return {path.parent.name: path.read_bytes() for path in found}


if __name__ == "__main__":
    from quadruped_env.cli.main import main

    socket.gethostname = lambda: sys.argv[2]
    worker.score_of_run = lambda run, task_file: {"score": score(0.5)}
    sys.exit(main(["sweep", "--work", str(Path(sys.argv[1]))]))
