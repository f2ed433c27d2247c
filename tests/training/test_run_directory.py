"""The directory of a run: its name, the link `latest`, and full disks."""

import errno
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from trainings import progress

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.policies import load_policy
from quadruped_env.training import TrainConfig
from quadruped_env.training.run_directory import Run


def test_runs_that_start_within_a_second_get_a_directory_each(tmp_path):
    runs = [Run(tmp_path, TrainConfig(), {}, "train") for _ in range(3)]
    for run in runs:
        run.close()
    assert len({run.directory for run in runs}) == 3
    assert (tmp_path / "latest").resolve() == runs[-1].directory.resolve()
    assert not list(tmp_path.glob(".*"))


@pytest.mark.parametrize("make", [Path.mkdir, Path.touch])
def test_runs_in_which_latest_is_not_a_link_are_refused_and_kept(tmp_path, make):
    make(tmp_path / "latest")
    message = r"latest is not a symbolic link.*; rename it, or name another"
    with pytest.raises(QuadrupedError, match=message):
        Run(tmp_path, TrainConfig(), {}, "train")
    assert [path.name for path in tmp_path.iterdir()] == ["latest"]
    assert not (tmp_path / "latest").is_symlink()


def test_run_that_cannot_be_started_leaves_no_files(tmp_path, monkeypatch):
    def fsync(descriptor):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", fsync)
    with pytest.raises(QuadrupedError, match=r"cannot be written \(No space left on device\); make room"):
        Run(tmp_path, TrainConfig(), {}, "train")
    assert not list(tmp_path.iterdir())


def test_a_row_of_progress_is_written_in_full_or_not_at_all(tmp_path):
    """A limit on the size of files stands in for a full disk: a part of the row still fits."""
    code = """
import resource, sys
from pathlib import Path
from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.training import TrainConfig
from quadruped_env.training.run_directory import PROGRESS_COLUMNS, Run
run = Run(Path(sys.argv[1]), TrainConfig(), {}, "train")
row = dict.fromkeys(PROGRESS_COLUMNS, 1.5)
run.log(row)
size = (run.directory / "progress.csv").stat().st_size
resource.setrlimit(resource.RLIMIT_FSIZE, (size + 7, size + 7))
try:
    run.log(row)
except QuadrupedError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True)
    assert re.search(r"progress\.csv: cannot be written \(.+\); make room", done.stdout)
    (row,) = progress(tmp_path / "latest")
    assert set(row.values()) == {"1.5"}


def test_a_training_on_a_full_disk_ends_with_one_clear_error_and_keeps_its_checkpoint(tmp_path, monkeypatch):
    from quadruped_env.training import train

    def fsync(descriptor):
        # Full from the end of the first checkpoint on.
        if list(tmp_path.glob("*/checkpoints/*s/policy.json")):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", fsync)
    config = TrainConfig(timesteps=10**9, num_envs=4, n_steps=8, batch_size=16, hidden=(8,), checkpoint_seconds=1e-3)
    with pytest.raises(QuadrupedError, match=r"cannot be written \(No space.*; what was saved before is kept in "):
        train.train(config, tmp_path, "train")
    (run,) = (path for path in tmp_path.iterdir() if not path.is_symlink())
    assert not list(run.rglob(".*"))
    with pytest.warns(QuadrupedWarning, match="last checkpoint"):
        assert load_policy(run).card["timesteps"] == 32


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_a_training_whose_curves_cannot_be_written_ends_with_one_clear_error(tmp_path, monkeypatch):
    from tensorboard.summary.writer.record_writer import RecordWriter

    from quadruped_env.training import train, training_recorder

    written = []

    def fail(self, data):
        written.append(data)
        if len(written) > 1:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(RecordWriter, "write", fail)
    monkeypatch.setattr(training_recorder, "_LOG_INTERVAL", 0.0)
    config = TrainConfig(timesteps=10**9, num_envs=4, n_steps=8, batch_size=16, hidden=(8,))
    with pytest.raises(QuadrupedError, match=r"-ppo: cannot be written \(No space left on device\); make room"):
        train.train(config, tmp_path, "train")
    assert load_policy(tmp_path / "latest").card["timesteps"] > 0
