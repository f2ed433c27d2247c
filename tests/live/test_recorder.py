"""A bag while it is recorded: it gets its name when it is complete, and can be salvaged until then."""

import errno
import os
import resource
import subprocess
import sys

import pytest
from paths import importing
from waiting import DEADLINE

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.robot import JOINT_NAMES
from quadruped_env.utils.files import free_path

pytest.importorskip("rosbags")
from quadruped_env.live.message_recorder import Recorder
from quadruped_env.live.middleware.topics import JOINT_STATES
from quadruped_env.ros import cdr


def joint_state(stamp):
    fields = {"header": cdr.header(stamp), "name": JOINT_NAMES, "position": [0.1] * 8}
    return cdr.serialize(cdr.message(JOINT_STATES.type_name, **fields))


def names(directory):
    return sorted(path.name for path in directory.iterdir())


@pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
def test_recording_gets_its_name_when_it_is_complete(tmp_path, storage):
    with Recorder(tmp_path / "bag", storage) as recorder:
        assert names(tmp_path) == []
        recorder.write(JOINT_STATES, joint_state(1))
        assert names(tmp_path) == ["bag.part"]
        assert free_path(tmp_path / "bag") == tmp_path / "bag-2"
    assert names(tmp_path) == ["bag"]
    assert JointTrajectory.load(tmp_path / "bag").stamps.tolist() == [1]


@pytest.mark.parametrize("storage", ["mcap", pytest.param("sqlite3", marks=pytest.mark.slow)])
def test_a_killed_recording_is_kept_under_another_name_and_can_be_salvaged(tmp_path, storage):
    code = """
import sys
from pathlib import Path
from test_recorder import JOINT_STATES, Recorder, joint_state
with Recorder(Path(sys.argv[1]), sys.argv[2]) as recorder:
    stamp = 0
    while True:
        recorder.write(JOINT_STATES, joint_state(stamp := stamp + 1))
        print(recorder.size, flush=True)
"""
    arguments = [sys.executable, "-c", code, str(tmp_path / "bag"), storage]
    process = subprocess.Popen(arguments, env=importing(), stdout=subprocess.PIPE, text=True)
    size = next(size for size in map(int, process.stdout) if size > 2_000_000)
    process.kill()
    process.communicate(timeout=DEADLINE)
    assert names(tmp_path) == ["bag.part"]
    loaded = JointTrajectory.load(tmp_path / "bag.part" / "bag", repair=["salvage"])
    assert loaded.stamps.tolist() == list(range(1, len(loaded) + 1))
    assert len(loaded) > (size - 1_100_000) / len(joint_state(0))
    with pytest.raises(QuadrupedError, match=r"bag\.part: holds a recording .*bag\.part/bag OUT --repair s"):
        Recorder(tmp_path / "bag")


@pytest.mark.parametrize("storage", ["mcap", pytest.param("sqlite3", marks=pytest.mark.slow)])
def test_a_recording_on_a_full_disk_ends_with_one_clear_error_and_is_kept(tmp_path, storage):
    """A limit on the size of files stands in for a full disk."""

    def record():
        with Recorder(tmp_path / "bag", storage) as recorder:
            for stamp in range(1, 100_000):
                recorder.write(JOINT_STATES, joint_state(stamp))

    words = r"bag: cannot be written \(.*\); make room, .*; .* kept in .*/bag\.part/bag \(--repair salvage\)$"
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (3_000_000, hard))
    try:
        with pytest.raises(QuadrupedError, match=words):
            record()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert names(tmp_path) == ["bag.part"]
    assert len(JointTrajectory.load(tmp_path / "bag.part" / "bag", repair=["salvage"])) > 1000


def test_a_recording_that_failed_once_never_gets_its_name(tmp_path, monkeypatch):
    recorder = Recorder(tmp_path / "bag")

    def fail(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def record():
        with recorder:
            recorder.write(JOINT_STATES, joint_state(1))
            # Like a disk that is full for a moment.
            with monkeypatch.context() as patched:
                patched.setattr(recorder._writer, "write", fail)
                recorder.write(JOINT_STATES, joint_state(2))

    with pytest.raises(QuadrupedError, match="make room"):
        record()
    assert names(tmp_path) == ["bag.part"]
