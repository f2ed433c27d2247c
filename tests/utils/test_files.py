"""Atomic writes: a file appears under its name only when it is complete, whatever interrupts its writing."""

import errno
import json
import os
import resource
import stat
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from paths import importing
from waiting import DEADLINE

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.policies import load_policy
from quadruped_env.report.films.video import save_video
from quadruped_env.utils.files import PART, free_path, shown_argument, whole, write_json, write_whole


def names(directory):
    return sorted(path.name for path in directory.iterdir())


def full(*_, **__):
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


# --- one file ---


def test_whole_file_appears_at_the_end_with_its_parents(tmp_path):
    path = tmp_path / "a" / "b.txt"
    with whole(path) as part:
        part.write_text("one")
        assert not path.exists()
    assert path.read_text() == "one"
    assert names(path.parent) == ["b.txt"]


@pytest.mark.parametrize("before", [None, "old"])
@pytest.mark.parametrize("error", [OSError(errno.ENOSPC, "full"), RuntimeError(), KeyboardInterrupt()])
def test_whole_file_after_an_error_keeps_the_old_file(tmp_path, before, error):
    path = tmp_path / "file"
    if before:
        path.write_text(before)

    def write():
        with whole(path) as part:
            part.write_text("new")
            raise error

    with pytest.raises((QuadrupedError, RuntimeError, KeyboardInterrupt)):
        write()
    assert names(tmp_path) == (["file"] if before else [])
    assert not before or path.read_text() == before


@pytest.mark.parametrize("mask", [0o022, 0o077, 0o002])
def test_whole_file_has_the_permissions_of_the_umask(tmp_path, mask):
    old = os.umask(mask)
    try:
        write_whole({tmp_path / "file": b"1"})
        with whole(tmp_path / "directory") as part:
            part.mkdir()
    finally:
        os.umask(old)
    assert stat.S_IMODE((tmp_path / "file").stat().st_mode) == 0o666 & ~mask
    assert stat.S_IMODE((tmp_path / "directory").stat().st_mode) == 0o777 & ~mask


def test_whole_directory_replaces_a_directory(tmp_path):
    path = tmp_path / "bag"
    for content in ("old", "new"):
        with whole(path) as part:
            part.mkdir()
            (part / content).write_text(content)
    assert names(path) == ["new"]
    assert names(tmp_path) == ["bag"]


def test_whole_directory_that_cannot_be_renamed_leaves_the_old_one(tmp_path, monkeypatch):
    path = tmp_path / "bag"
    path.mkdir()
    (path / "old").touch()
    rename = type(path).rename

    def refuse(self, target):
        if self.parent.name.endswith(PART) and self.name == "bag":
            full()
        return rename(self, target)

    monkeypatch.setattr(type(path), "rename", refuse)
    with pytest.raises(QuadrupedError, match="make room"), whole(path) as part:
        part.mkdir()
    assert names(path) == ["old"]
    assert names(tmp_path) == ["bag"]


def test_whole_file_behind_a_symbolic_link_is_replaced_and_the_link_stays(tmp_path):
    (tmp_path / "real").mkdir()
    link = tmp_path / "link"
    link.symlink_to("real/file")
    for content in (b"1", b"2"):
        write_whole({link: content})
        assert link.is_symlink()
        assert (tmp_path / "real" / "file").read_bytes() == content
    assert names(tmp_path / "real") == ["file"]


@pytest.mark.parametrize(
    ("argument", "shown", "name"),
    [
        ("{cwd}/runs/a", "runs/a", "a"),
        ("--output={cwd}/runs/a", "--output=runs/a", "--output=a"),
        ("/home/somebody/secret/a.py", "a.py", "a.py"),
        ("--task=/secret/a.py", "--task=a.py", "--task=a.py"),
        ("../runs/a", "../runs/a", "a"),
        ("hf://owner/name", "hf://owner/name", "hf://owner/name"),
        ("0.5", "0.5", "0.5"),
        ("-o", "-o", "-o"),
        (".", ".", "."),
        ("/", "/", "/"),
    ],
)
def test_arguments_are_shown_without_directories_of_the_machine(argument, shown, name):
    argument = argument.format(cwd=Path.cwd())
    assert shown_argument(argument) == shown
    assert shown_argument(argument, names_only=True) == name


def test_free_path_counts_up(tmp_path):
    path = tmp_path / "a.csv"
    assert free_path(path) == path
    path.touch()
    (tmp_path / "a-2.csv").touch()
    assert free_path(path) == tmp_path / "a-3.csv"
    with pytest.raises(QuadrupedError, match="cannot be written"):
        write_json(path / "b.json", {})


# --- files that belong together ---


@pytest.mark.parametrize("at", range(3))
def test_files_that_belong_together_stay_unchanged_when_one_cannot_be_written(tmp_path, monkeypatch, at):
    files = {tmp_path / name: b"new" for name in "abc"}
    write_whole(dict.fromkeys(files, b"old"))
    calls = []
    fsync = os.fsync

    def fail(descriptor):
        calls.append(descriptor)
        return full() if len(calls) == at + 1 else fsync(descriptor)

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(QuadrupedError, match=r"[abc]: cannot be written \(No space left"):
        write_whole(files)
    assert names(tmp_path) == ["a", "b", "c"]
    assert {path.read_bytes() for path in files} == {b"old"}


# --- what this package writes ---


def recording(seed):
    numbers = np.random.default_rng(0).normal(size=(3000, 1))
    numbers[-1] = seed
    return JointTrajectory(np.arange(3000), ["a_joint"], numbers)


def save_policy(directory, seed):
    """Save as training saves a checkpoint: a new directory in one step."""
    files = load_policy("flat").with_card({"seed": seed}).files()
    with whole(directory) as part:
        part.mkdir()
        for name, content in files.items():
            (part / name).write_bytes(content)


def draw(path, seed):
    picture = np.random.default_rng(seed).integers(0, 256, (120, 240, 3), np.uint8)
    save_video(path, [picture] * 4)


def saved(**options):
    return lambda path, seed: recording(seed).save(path, overwrite=True, **options)


WRITERS = {
    "a.csv": saved(),
    "a.mcap": saved(),
    "a.db3": saved(),
    "bag": saved(storage="mcap"),
    "bag2": saved(storage="sqlite3"),
    "a.json": lambda path, seed: write_json(path, {"seed": seed, "numbers": list(range(9999))}),
    "a.webp": draw,
    "policy": save_policy,
}
"""Name -> function that writes a file or directory of that name, of over `LIMIT` bytes, which replaces an older one."""
LIMIT = 9000


def seed_of(path):
    """The seed that a file or directory was written with; raises an error if it is not complete."""
    if path.name == "policy":
        return load_policy(path).card["seed"]
    if path.suffix == ".json":
        return json.loads(path.read_text())["seed"]
    if path.suffix == ".webp":
        data = path.read_bytes()
        assert int.from_bytes(data[4:8], "little") == len(data) - 8
        return len(data)
    return int(JointTrajectory.load(path).positions[-1, 0])


def contents(path):
    return {file: file.read_bytes() for file in ([path] if path.is_file() else path.iterdir())}


@pytest.fixture
def small_files():
    """A switch that limits the size of files, which stands in for a full disk."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    yield lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT, hard))
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize("before", [False, True])
def test_writer_on_a_full_disk_raises_one_clear_error_and_keeps_the_old_file(tmp_path, small_files, name, before):
    pytest.importorskip("rosbags")
    path = tmp_path / name
    if before:
        WRITERS[name](path, 1)
        kept = contents(path)
    small_files()
    with pytest.raises(
        QuadrupedError,
        match=rf"/{name}: cannot be written \(.+\); make room, or name another place$",
    ):
        WRITERS[name](path, 2)
    assert names(tmp_path) == ([name] if before else [])
    if before:
        assert contents(path) == kept


@pytest.mark.slow
def test_writer_in_a_killed_process_leaves_complete_files_only(tmp_path):
    code = """
import sys
from pathlib import Path
from test_files import WRITERS
seed = 0
while True:
    seed += 1
    for name, write in WRITERS.items():
        write(Path(sys.argv[1]) / name, seed)
        print(seed, flush=True)
"""
    pytest.importorskip("rosbags")
    rng = np.random.default_rng(0)
    for _ in range(5):
        process = subprocess.Popen(
            [sys.executable, "-c", code, str(tmp_path)], env=importing(), stdout=subprocess.PIPE, text=True
        )
        # Any moment will do: some file is being written.
        for _ in range(len(WRITERS) + int(rng.integers(2 * len(WRITERS)))):
            assert process.stdout.readline()
        time.sleep(rng.uniform(0.0, 0.05))
        process.kill()
        process.communicate(timeout=DEADLINE)
        for name in WRITERS:
            # A directory that is being replaced is missing for a moment, and complete under a hidden name.
            if (tmp_path / name).exists() or name not in ("bag", "bag2", "policy"):
                assert seed_of(tmp_path / name) >= 1
    assert {path.name for path in tmp_path.iterdir() if not path.name.startswith(".")} <= set(WRITERS)
