"""The files of a sweep, and the locks by which its workers share the trials."""

import contextlib
import errno
import fcntl
import json
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from paths import importing
from sweeps import finish, make_sweep
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.sweep import folder
from quadruped_env.sweep.folder import Sweep
from quadruped_env.utils import locks

HOLD = """
import sys, time
from pathlib import Path
from quadruped_env.sweep.folder import Sweep
for number in Sweep.open(Path(sys.argv[1])).take_trials():
    print(number, flush=True)
    time.sleep(1000)
"""


def test_trial_of_a_killed_worker_is_taken_over_and_each_is_done_once(tmp_path):
    sweep = make_sweep(tmp_path, seeds=4)
    with subprocess.Popen(
        [sys.executable, "-c", HOLD, str(sweep.path)], stdout=subprocess.PIPE, text=True, env=importing()
    ) as other:
        assert other.stdout.readline() == "0\n"
        done = []
        with contextlib.closing(sweep.take_trials()) as numbers:
            for number in numbers:
                done.append(number)
                finish(sweep, number, 0.5)
                if number == 2:
                    other.send_signal(signal.SIGKILL)
                    other.wait()
    assert sorted(done) == [0, 1, 2, 3]
    assert done[0] == 1, "trial 0 was the other's"
    assert sweep.open_trials() == []


def test_worker_waits_for_the_trials_of_others(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path, seeds=2)
    waits = []

    def sleep(seconds):
        waits.append(seconds)
        finish(sweep, 0, 0.5)

    monkeypatch.setattr(folder.time, "sleep", sleep)
    with sweep.locked("0000"):
        for number in sweep.take_trials():
            finish(sweep, number, 0.5)
    assert len(waits) == 1


def test_trial_that_another_worker_ends_before_the_lock_is_taken_is_not_done_again(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path, seeds=2)
    locked = Sweep.locked

    def late(self, name, wait=True):
        if name == "0000":
            finish(sweep, 0, 0.5)
        return locked(self, name, wait)

    monkeypatch.setattr(Sweep, "locked", late)
    assert next(sweep.take_trials()) == 1


def test_definition_comes_back_from_its_file(tmp_path):
    sweep = make_sweep(
        tmp_path, "gamma=0.9..1", "hidden=[8],[16,8]", training={"seed": 7, "task": {"reward": {}}}, settings=3, seeds=2
    )
    assert Sweep.open(sweep.path) == sweep
    assert [(sweep.setting(n), sweep.seed(n)) for n in range(len(sweep))] == [
        (0, 7),
        (0, 8),
        (1, 7),
        (1, 8),
        (2, 7),
        (2, 8),
    ]
    assert str(sweep) == "3 settings of gamma, hidden, each with 2 seeds"


def test_config_of_a_trial_has_its_values_and_seed(tmp_path):
    sweep = make_sweep(tmp_path, "gamma=0.9..1", settings=1)
    values = {"gamma": 0.97, "hidden": [16, 8], "task.reward.weights.foot_slip": -0.5}
    config = sweep.config(values, 5)
    assert (config.gamma, config.hidden, config.seed, config.timesteps) == (0.97, (16, 8), 5, 96)
    assert config.task["reward"]["weights"]["foot_slip"] == -0.5


@pytest.mark.parametrize(
    ("definition", "error"),
    [
        ({"seeds": 0}, "seeds: expected 1 to 100,000 trainings in all; found 0"),
        ({"seeds": 10**6}, "seeds: expected 1"),
        ({"training": {"gamma": 2.0}}, r"training\.gamma must be in"),
        ({"training": {"seed": 2**32 - 1}, "seeds": 2}, r"training\.seed must be"),
    ],
)
def test_definition_that_is_not_valid_is_an_error(tmp_path, definition, error):
    with pytest.raises(QuadrupedError, match=error):
        make_sweep(tmp_path, **definition)


@pytest.mark.parametrize(
    ("vary", "error"),
    [
        ("gamma=0.9..1.5", "vary gamma=1.5: training.gamma must be in"),
        ("task.reward.foot_lift=-3,0.1", "vary task.reward.foot_lift=-3"),
    ],
)
def test_end_of_a_range_that_is_not_valid_is_an_error_before_the_first_trial(tmp_path, vary, error):
    with pytest.raises(QuadrupedError, match=error):
        make_sweep(tmp_path, vary, settings=2).check()


def test_sweep_of_an_earlier_version_is_one_line_with_that_version(tmp_path):
    (tmp_path / "sweep.json").write_text(json.dumps({"format_version": 1, "versions": {"mini-quadruped": "0.0.9"}}))
    with pytest.raises(
        QuadrupedError, match=r"sweep.json: made by version '0.0.9' of mini-quadruped, which goes on with it"
    ):
        Sweep.open(tmp_path)


@pytest.mark.parametrize(
    ("change", "error"),
    [
        ({"space": {"gamma": "x"}}, "damaged"),
        ({"seeds": "3"}, "damaged"),
        ({"settings": None}, "damaged"),
        ({"training": {"gamma": "x"}}, "training.gamma: expected a number; found 'x'"),
    ],
)
def test_definition_that_was_edited_wrongly_is_an_error_with_the_file(tmp_path, change, error):
    path = make_sweep(tmp_path, "gamma=0.9..1", settings=1).path / "sweep.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    with pytest.raises(QuadrupedError, match=rf"sweep.json: {error}"):
        Sweep.open(path.parent)


def test_directory_that_cannot_be_written_is_an_error_with_the_reason(tmp_path):
    sweep = make_sweep(tmp_path)
    (sweep.path / "locks").write_text("")
    with pytest.raises(QuadrupedError, match=r"locks.*: cannot be written \(.*; make room, or allow it"):
        sweep.join()


@pytest.mark.parametrize("name", ["worker.json", "result.json", "sweep.json"])
def test_damaged_file_is_named_with_the_fix(tmp_path, name):
    sweep = make_sweep(tmp_path)
    finish(sweep, 0, 0.5)
    sweep.join()
    path = sweep.trial(0) / name if name == "result.json" else sweep.path / name
    path.write_text("{}" if name != "worker.json" else "[")
    read = (lambda: sweep.result(0)) if name == "result.json" else lambda: Sweep.open(sweep.path).join()
    with pytest.raises(QuadrupedError, match=rf"{name}: .*(start a new|open again|no trial is finished)"):
        read()


def test_worker_with_another_package_is_refused_in_a_line(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path)
    sweep.join()
    sweep.join()
    first = json.loads((sweep.path / "worker.json").read_text())
    monkeypatch.setattr(folder, "package_hash", lambda *files: "another")
    with pytest.raises(QuadrupedError, match=rf"worker.json: .* has package {first['package']} \(here another\), so"):
        sweep.join()


@pytest.mark.parametrize("name", ["python", "torch", "mujoco"])
def test_worker_with_another_library_is_refused(tmp_path, name):
    sweep = make_sweep(tmp_path)
    sweep.join()
    path = sweep.path / "worker.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), name: "0.1"}))
    with pytest.raises(QuadrupedError, match=rf"worker.json: the sweep's first worker has {name} 0.1 \(here"):
        sweep.join()


def test_file_of_the_package_that_changes_changes_its_hash(tmp_path):
    from quadruped_env.utils.provenance import package_hash

    file = tmp_path / "a.xml"
    file.write_text("1")
    before = package_hash(file)
    assert package_hash(file) == before
    file.write_text("2")
    assert package_hash(file) != before


def test_file_system_without_locks_is_named(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path)
    system = locks.file_system(tmp_path)

    def refuse(file, operation):
        raise OSError(errno.ENOLCK, "No locks available")

    with monkeypatch.context() as patched:
        patched.setattr(fcntl, "flock", refuse)
        with pytest.raises(QuadrupedError, match=rf"its file system \({system}.*\) has no file locks \(.*No locks"):
            sweep.join()
    monkeypatch.setattr(fcntl, "flock", lambda file, operation: None)
    with pytest.raises(QuadrupedError, match="two processes got the same lock"):
        sweep.join()
    monkeypatch.undo()
    monkeypatch.setattr(locks, "file_system", lambda path: "nfs4, rw,local_lock=all")
    with pytest.raises(QuadrupedError, match="other machines do not see its locks"):
        sweep.join()


@pytest.mark.skipif(not Path("/proc/self/mounts").exists(), reason="only Linux lists its mounts there")
def test_file_system_is_the_one_of_the_nearest_mount_above():
    assert locks.file_system(Path("/proc/self")) == "proc"


def test_sweep_that_was_removed_is_not_made_again_by_writing(tmp_path):
    sweep = make_sweep(tmp_path)
    (sweep.path / "sweep.json").unlink()
    with pytest.raises(QuadrupedError, match="the sweep was removed"):
        finish(sweep, 0, 0.5)
    assert list(sweep.path.iterdir()) == []


def test_failed_trials_are_open_again_after_retry(tmp_path):
    sweep = make_sweep(tmp_path, seeds=3)
    for number, total in enumerate((0.5, None, None)):
        finish(sweep, number, total)
    sweep.retry_failed()
    assert sweep.open_trials() == [1, 2]
    assert json.loads((sweep.path / "trials" / "0001.failed" / "result.json").read_text())["state"] == "failed"
    assert wait_until(lambda: sweep.result(0))["state"] == "finished"
