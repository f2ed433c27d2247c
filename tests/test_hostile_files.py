"""Files that crash, hang or flood a naive reader: every reader refuses them with a short error of this package."""

import argparse
import json
import os
import shutil
import struct

import numpy as np
import pytest
from bags import fields, write_bag
from hanging import bounded
from mutations import mutated_json, mutated_text

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.cli.train import task_change
from quadruped_env.errors import MAX_MESSAGE
from quadruped_env.policies.files import read_policy, shipped_directory
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.task import TaskConfig
from quadruped_env.trajectory import ColumnMap, JointMap

ECHO = (
    "header:\n  stamp:\n    sec: 1\n    nanosec: 0\n  frame_id: ''\nname:\n- a\nposition:\n- 0.5\nvelocity: []\n"
    "effort: []\n---\n"
)
DEEP = 30_000
MEGABYTES = "x" * 4_800_000


class Reader:
    """A reader and the file that it reads.

    `prepare` writes the files around it; `sound` is a content that is read without an error, and None if `prepare`
    writes it.
    """

    def __init__(self, name, read, prepare=None, sound=None):
        self.name = name
        self.read = read
        self.prepare = prepare
        self.sound = sound

    def path(self, directory):
        if self.prepare is not None:
            self.prepare(directory)
        return directory / self.name


def prepare_policy(directory):
    shutil.copytree(shipped_directory("flat"), directory, dirs_exist_ok=True)


def prepare_bag(directory):
    write_bag(directory / "bag", [(0, fields())])


def prepare_map(directory):
    (directory / "map.toml").write_text('[columns]\nstamp = "t"\npositions = ["q"]\n')


def read_task(path):
    """A file of `--task`, and the config that it changes."""
    try:
        TaskConfig.from_dict(task_change(str(path)))
    except argparse.ArgumentTypeError as error:
        raise QuadrupedError(str(error)) from error


MOTORS = json.dumps({"motor": TaskConfig().to_dict()["motor"]})
COLUMNS = '[columns]\nstamp = "t"\nstamp_unit = "s"\npositions = ["a", "b"]\nmissing = [-1]\n'
JOINTS = '[joints.LF_hip_joint]\nsource = "a"\nscale = 2.0\noffset = 0.1\nunit = "deg"\n'
TASK = json.dumps({"decimation": 4, "reward": {"weights": {"upright": -1.0}}, "command": {"yaw_rate": [-0.4, 0.4]}})
TABLE = "t,q\n0.0,1.5\n0.1,1.25\n"

READERS = {
    "policy": Reader(CARD_FILE, lambda path: read_policy(path.parent), prepare_policy),
    "motors": Reader("motors.json", read_motors, sound=MOTORS),
    "task": Reader("task.json", read_task, sound=TASK),
    "columns": Reader("columns.toml", ColumnMap.load, sound=COLUMNS),
    "joints": Reader("joints.toml", JointMap.load, sound=JOINTS),
    "recording": Reader("recording", JointTrajectory.load, sound=ECHO + ECHO.replace("sec: 1", "sec: 2")),
    "table": Reader(
        "a.csv", lambda path: JointTrajectory.load(path, columns=path.with_name("map.toml")), prepare_map, TABLE
    ),
    "storage": Reader("bag/bag.mcap", lambda path: JointTrajectory.load(path.parent, repair=["salvage"]), prepare_bag),
    "tensors": Reader(TENSORS_FILE, lambda path: read_policy(path.parent), prepare_policy),
}
BINARY = ("tensors", "storage")
"""Readers of binary files; tests/trajectory/test_formats_fuzz.py mutates bags."""

JSON = ("policy", "motors")
TOML = ("columns", "joints")


def tensors(**header):
    text = json.dumps(header).encode()
    return struct.pack("<Q", len(text)) + text + bytes(16)


CONTENTS = {
    JSON: {
        "deep list": "[" * DEEP,
        "5000 digits": '{"format_version": ' + "9" * 5000 + "}",
        "infinity": '{"motor": {"delay": 1e999}}',
        "megabytes": json.dumps({"format_version": MEGABYTES, MEGABYTES: MEGABYTES}),
        "megabytes of fields": json.dumps({"motor": {f"{i}{'x' * 40}": i for i in range(50_000)}}),
        "half a character": '{"format_version": "\\ud800"}',
        "not text": b"\x80\x81" * 5000,
        "empty": b"",
    },
    TOML: {
        "deep list": "[columns]\nstamp = " + "[" * DEEP,
        "5000 digits": "[joints.a]\nscale = " + "9" * 5000,
        "400 digits": "[columns]\nstamp = " + "9" * 400 + "\n[joints.a]\nscale = " + "9" * 400,
        "megabytes": f'[columns]\nstamp = 1\npositions = ["{MEGABYTES}", 3]\n[joints.a]\nunit = "{MEGABYTES}"',
        "not text": b"\x80\x81" * 5000,
    },
    ("recording",): {
        "deep flow": "header:\n" + "[" * DEEP,
        "deep within": ECHO.replace("- 0.5", "- " + "[" * DEEP + "]" * DEEP),
        "5000 digits of seconds": ECHO.replace("sec: 1", "sec: " + "9" * 5000),
        "400 digits": ECHO.replace("0.5", "9" * 400),
        "megabyte of keys": "header:\n" + "".join(f"key{i}: 1\n" for i in range(30_000)),
        "megabyte as a name": ECHO.replace("- a", f"- {'x' * 400_000}\n- {'x' * 400_000}"),
        "megabytes in a line": "header:\n" + MEGABYTES + "\n",
        "aliases": "header: &a [1]\nname: [*a, *a]\n",
        "echoed seconds": "9" * 5000 + ",0,,a,0.5,,\n",
        "echoed name": f"1,0,,{MEGABYTES},{MEGABYTES},0.5,0.5,,\n",
        "echoed number": f"1,0,,a,{'9' * 400},,\n",
        "position of 5000 digits": f"stamp_ns,position.a\n0,{'9' * 5000}\n",
        "column of megabytes": f"stamp_ns,position.{MEGABYTES},position.{MEGABYTES}\n0,1,1\n",
        "one line": MEGABYTES,
        "not text": b"\x80\x81" * 5000,
        "empty": b"",
    },
    ("table",): {
        "columns of megabytes": ",".join(f"column {i}" for i in range(300_000)) + "\n0\n",
        "megabytes in a cell": f"t,q\n0,{MEGABYTES}\n",
        "timestamp of 5000 digits": f"t,q\n{'9' * 5000},0\n",
        "timestamp of any size": "t,q\n1e999999999,0\n",
        "position of 400 digits": f"t,q\n0,{'9' * 400}\n",
        "open quotes": 't,q\n"' + "0,\n" * 100_000,
    },
    ("tensors",): {
        "types that NumPy lacks": tensors(a={"dtype": "BF16", "shape": [8], "data_offsets": [0, 16]}),
        "deep header": struct.pack("<Q", DEEP) + b"[" * DEEP,
        "endless header": struct.pack("<Q", 2**63) + b"{}",
    },
}


MUTATIONS = int(os.environ.get("MUTATIONS", "12"))
"""Damaged variants of each file; with more, `MUTATIONS=1000 pytest tests/test_hostile_files.py`."""


@pytest.mark.filterwarnings("ignore::quadruped_env.errors.QuadrupedWarning")
@pytest.mark.parametrize("name", sorted(READERS.keys() - set(BINARY)))
def test_read_damaged_file_is_an_error_of_this_package(tmp_path, name):
    reader = READERS[name]
    rng = np.random.default_rng(sorted(READERS).index(name))
    (sound := tmp_path / "sound").mkdir()
    file = reader.path(sound)
    if reader.sound is not None:
        file.write_text(reader.sound)
    mutate = mutated_json if file.suffix == ".json" else mutated_text
    for number in range(MUTATIONS + 1):
        directory = tmp_path / f"copy{number}"
        path = shutil.copytree(sound, directory) / file.relative_to(sound)
        content = path.read_text() if number == 0 else mutate(path.read_text(), rng)
        path.write_text(content)
        try:
            with bounded():
                reader.read(path)
        except Exception as error:
            if number == 0 or not isinstance(error, QuadrupedError):
                raise AssertionError(f"{name}: {content[:2000]!r}") from error
        shutil.rmtree(directory)


def refused(read, path):
    """The message of the error with which a file is refused."""
    with bounded(), pytest.raises(QuadrupedError) as caught:
        read(path)
    message = str(caught.value)
    assert len(message) <= MAX_MESSAGE
    return message


@pytest.mark.parametrize(
    ("name", "content"),
    [
        pytest.param(name, content, id=f"{name}: {what}")
        for names, contents in CONTENTS.items()
        for name in names
        for what, content in contents.items()
    ],
)
def test_read_hostile_content_is_a_short_error_that_names_the_file(tmp_path, name, content):
    reader = READERS[name]
    path = reader.path(tmp_path)
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    message = refused(reader.read, path)
    assert message.startswith((str(path), str(path.parent)))
    assert message.isprintable()


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize("kind", ["a pipe", "a directory", "a device", "a loop"])
def test_read_path_that_is_not_a_regular_file_is_refused_without_waiting(tmp_path, name, kind):
    reader = READERS[name]
    path = reader.path(tmp_path)
    path.unlink(missing_ok=True)
    if kind == "a pipe":
        os.mkfifo(path)
    elif kind == "a directory":
        path.mkdir()
    else:
        path.symlink_to("/dev/zero" if kind == "a device" else path)
    message = refused(reader.read, path)
    if kind in {"a pipe", "a device"}:
        assert f"{path}: is {kind}" in message


@pytest.mark.parametrize("name", READERS)
def test_read_name_that_no_file_can_have_is_refused(tmp_path, name):
    for bad in ("x" * 5000, "a\0b"):
        refused(READERS[name].read, tmp_path / bad / READERS[name].name)


@pytest.mark.parametrize("text", ["[" * DEEP, "  - bag.mcap\n" * 100_000, MEGABYTES, "\0"])
def test_metadata_of_any_content_do_not_matter_to_a_bag(tmp_path, text):
    prepare_bag(tmp_path)
    (tmp_path / "bag/metadata.yaml").write_text(text)
    with bounded():
        assert len(JointTrajectory.load(tmp_path / "bag")) == 1


class TestMessages:
    @pytest.mark.parametrize("value", [10**400, 10**5000, [10**5000], MEGABYTES, np.inf], ids=range(5))
    def test_config_values_of_any_size_are_refused(self, value):
        for config in ({"decimation": value}, {"reward": {"weights": {"fall": value}}}, {"motor": {"delay": value}}):
            with pytest.raises(QuadrupedError) as caught:
                TaskConfig.from_dict(config)
            assert len(str(caught.value)) <= MAX_MESSAGE
