"""Files that crash, hang or flood a naive reader: every reader refuses them with a short error of this package."""

import json
import os
import re
import shutil
import struct

import numpy as np
import pytest
from bags import fields, write_bag
from hanging import bounded

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.control.policy import CARD_FILE, TENSORS_FILE, load_policy, shipped_directory
from quadruped_env.documents import MAX_BYTES, MAX_DEPTH, parse_json, read_json, read_toml
from quadruped_env.errors import MAX_MESSAGE, cut, short
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.reporting.plots.learning import read_progress
from quadruped_env.task import TaskConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run import CONFIG_FILE, PROGRESS_FILE, RESUME_FILE
from quadruped_env.trajectory import ColumnMap, JointMap

DEEP = 30_000
MEGABYTES = "x" * 4_800_000


class Reader:
    """A reader and the file that it reads."""

    def __init__(self, name, read, prepare=None):
        self.name = name
        self.read = read
        self.prepare = prepare

    def path(self, directory):
        if self.prepare is not None:
            self.prepare(directory)
        return directory / self.name


def prepare_policy(directory):
    shutil.copytree(shipped_directory("flat"), directory, dirs_exist_ok=True)


def prepare_run(directory):
    for name in (CARD_FILE, TENSORS_FILE, RESUME_FILE, PROGRESS_FILE):
        (directory / name).touch()


def prepare_bag(directory):
    write_bag(directory / "bag", [(0, fields())])


def prepare_map(directory):
    (directory / "map.toml").write_text('[columns]\nstamp = "t"\npositions = ["q"]\n')


READERS = {
    "policy": Reader(CARD_FILE, lambda path: load_policy(path.parent), prepare_policy),
    "config": Reader(CONFIG_FILE, lambda path: Parent.load(path.parent), prepare_run),
    "motors": Reader("motors.json", read_motors),
    "columns": Reader("columns.toml", ColumnMap.load),
    "joints": Reader("joints.toml", JointMap.load),
    "recording": Reader("recording", JointTrajectory.load),
    "salvaged": Reader("recording", lambda path: JointTrajectory.load(path, salvage=True, drop=True)),
    "table": Reader("a.csv", lambda path: JointTrajectory.load(path, columns=path.with_name("map.toml")), prepare_map),
    "metadata": Reader("bag/metadata.yaml", lambda path: JointTrajectory.load(path.parent), prepare_bag),
    "storage": Reader("bag/bag.mcap", lambda path: JointTrajectory.load(path.parent, salvage=True), prepare_bag),
    "tensors": Reader(TENSORS_FILE, lambda path: load_policy(path.parent), prepare_policy),
    "progress": Reader("progress.csv", read_progress),
}

JSON = ("policy", "config", "motors")
TOML = ("columns", "joints")
ECHO = (
    "header:\n  stamp:\n    sec: 1\n    nanosec: 0\n  frame_id: ''\nname:\n- a\nposition:\n- 0.5\nvelocity: []\n"
    "effort: []\n---\n"
)


def tensors(**header):
    text = json.dumps(header).encode()
    return struct.pack("<Q", len(text)) + text + bytes(16)


CONTENTS = {
    JSON: {
        "deep list": "[" * DEEP,
        "deep table": '{"a":' * DEEP,
        "deep, and whole": '{"format_version": 1, "motor": ' + "[" * 500 + "]" * 500 + "}",
        "5000 digits": '{"format_version": ' + "9" * 5000 + "}",
        "400 digits": '{"motor": {"delay": ' + "9" * 400 + "}}",
        "infinity": '{"motor": {"delay": 1e999}}',
        "megabytes": json.dumps({"format_version": MEGABYTES, MEGABYTES: MEGABYTES}),
        "megabytes as a value": json.dumps({"motor": {"delay": MEGABYTES}, "training": MEGABYTES}),
        "megabytes of fields": json.dumps({"motor": {f"{i}{'x' * 40}": i for i in range(50_000)}}),
        "half a character": '{"format_version": "\\ud800"}',
        "not text": b"\x80\x81" * 5000,
        "NUL": b"\0" * 100,
        "empty": b"",
        "two documents": "{}{}",
    },
    TOML: {
        "deep list": "[columns]\nstamp = " + "[" * DEEP,
        "deep, and whole": "[columns]\nstamp = " + "[" * 60 + "]" * 60,
        "deep table": "a = " + "{a = " * DEEP,
        "long key": ".".join(["a"] * 20_000) + " = 1",
        "long table": "[" + ".".join(["a"] * 20_000) + "]",
        "5000 digits": "[joints.a]\nscale = " + "9" * 5000,
        "5000 hexadecimal digits": "[columns]\nstamp = 0x" + "f" * 5000,
        "400 digits": "[columns]\nstamp = " + "9" * 400 + "\n[joints.a]\nscale = " + "9" * 400,
        "megabytes": f'[columns]\nstamp = 1\npositions = ["{MEGABYTES}", 3]\n[joints.a]\nunit = "{MEGABYTES}"',
        "megabytes as a key": f'[columns]\n"{MEGABYTES}" = 1\n[joints.a]\n"{MEGABYTES}" = 1',
        "megabytes of tables": f'columns = ["{MEGABYTES}"]\njoints = ["{MEGABYTES}"]',
        "not text": b"\x80\x81" * 5000,
    },
    ("recording", "salvaged"): {
        "deep flow": "header:\n" + "[" * DEEP,
        "deep tables": "header:\n" + "{a: " * DEEP,
        "deep blocks": "header:\n" + "- " * DEEP,
        "deep keys": "header:\n" + "? " * DEEP,
        "deep within": ECHO.replace("- 0.5", "- " + "[" * DEEP + "]" * DEEP),
        "5000 digits of seconds": ECHO.replace("sec: 1", "sec: " + "9" * 5000),
        "400 digits": ECHO.replace("0.5", "9" * 400),
        "400 digits of a count": ECHO.replace("sec: 1\n", "sec: !!int " + "9" * 400 + "\n"),
        "megabyte of keys": "header:\n" + "".join(f"key{i}: 1\n" for i in range(60_000)),
        "megabyte as a key": "header:\n  stamp: 1\n" + "x" * 900_000 + ": 1\n",
        "megabyte as a name": ECHO.replace("- a", f"- {'x' * 400_000}\n- {'x' * 400_000}"),
        "megabytes in a line": "header:\n" + MEGABYTES + "\n",
        "aliases": "header: &a [1]\nname: [*a, *a]\n",
        "echoed seconds": "9" * 5000 + ",0,,a,0.5,,\n",
        "echoed name": f"1,0,,{MEGABYTES},{MEGABYTES},0.5,0.5,,\n",
        "echoed number": f"1,0,,a,{'9' * 400},,\n",
        "timestamp of 5000 digits": f"stamp_ns,position.a\n{'9' * 5000},1\n",
        "position of 5000 digits": f"stamp_ns,position.a\n0,{'9' * 5000}\n",
        "column of megabytes": f"stamp_ns,position.{MEGABYTES},position.{MEGABYTES}\n0,1,1\n",
        "unpaired column of megabytes": f"stamp_ns,position.a,effort.{MEGABYTES}\n0,1,1\n",
        "one line": MEGABYTES,
        "other text": MEGABYTES + "," + MEGABYTES + "\n",
        "not text": b"\x80\x81" * 5000,
        "empty": b"",
    },
    ("table",): {
        "columns of megabytes": ",".join(f"column {i}" for i in range(300_000)) + "\n0\n",
        "megabytes in a cell": f"t,q\n0,{MEGABYTES}\n",
        "megabytes in a timestamp": f"t,q\n{MEGABYTES},0\n",
        "timestamp of 5000 digits": f"t,q\n{'9' * 5000},0\n",
        "timestamp of any size": "t,q\n1e999999999,0\n",
        "position of 400 digits": f"t,q\n0,{'9' * 400}\n",
        "open quotes": 't,q\n"' + "0,\n" * 100_000,
    },
    ("metadata",): {
        "deep flow": "[" * DEEP,
        "deep tables": "{a: " * DEEP,
        "deep blocks": "- " * DEEP,
        "deep, and whole": "[" * 100 + "]" * 100,
        "5000 digits": "rosbag2_bagfile_information:\n  version: " + "9" * 5000,
        "400 digits": "rosbag2_bagfile_information:\n  version: " + "9" * 400,
        "megabytes": "rosbag2_bagfile_information:\n  version: " + MEGABYTES,
        "one file 10,000 times": "rosbag2_bagfile_information:\n  relative_file_paths:\n" + "  - bag.mcap\n" * 10_000,
        "one file by two names": "rosbag2_bagfile_information:\n  relative_file_paths: [a/bag.mcap, b/bag.mcap]",
        "not text": b"\x80\x81" * 5000,
    },
    ("tensors",): {
        "types that NumPy lacks": tensors(a={"dtype": "BF16", "shape": [8], "data_offsets": [0, 16]}),
        "small types": tensors(a={"dtype": "F8_E4M3", "shape": [16], "data_offsets": [0, 16]}),
        "deep header": struct.pack("<Q", DEEP) + b"[" * DEEP,
        "endless header": struct.pack("<Q", 2**63) + b"{}",
    },
    ("progress",): {
        "columns of megabytes": ",".join(f"column {i}" for i in range(300_000)) + "\n0\n",
        "megabytes in a cell": f"timesteps\n{MEGABYTES}\n",
        "not a number": f"timesteps\n{'x' * 100_000}\n",
        "not text": b"\x80\x81" * 5000,
    },
}


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
    if kind in {"a pipe", "a device"} and name != "config":
        assert f"{path}: is {kind}" in message


@pytest.mark.parametrize("name", READERS)
def test_read_name_that_no_file_can_have_is_refused(tmp_path, name):
    for bad in ("x" * 5000, "a\0b"):
        refused(READERS[name].read, tmp_path / bad / READERS[name].name)


def test_a_storage_file_that_the_metadata_name_repeatedly_is_not_opened(tmp_path, monkeypatch):
    path = READERS["metadata"].path(tmp_path)
    text = path.read_text()
    path.write_text(re.sub(r"( *- bag\.mcap\n)", r"\1" * 3, text, count=1))
    opened = []
    monkeypatch.setattr("rosbags.rosbag2.storage_mcap.McapReader.open", opened.append)
    assert "names 'bag.mcap' 3 times" in refused(READERS["metadata"].read, path)
    assert opened == []


class TestDocuments:
    def test_read_json_and_toml_returns_their_contents(self, tmp_path):
        path = tmp_path / "a"
        path.write_bytes(b'\xef\xbb\xbf{"a": [1, 2.5, null, {"b": "\xc3\xa4"}]}')
        assert read_json(path) == {"a": [1, 2.5, None, {"b": "ä"}]}
        path.write_text("a.b.'c.d' = [1, 2.5]\n# a.b.c.d.e is no key\n")
        assert read_toml(path) == {"a": {"b": {"c.d": [1, 2.5]}}}

    def test_read_json_up_to_the_greatest_depth(self):
        for depth, fits in ((MAX_DEPTH, True), (MAX_DEPTH + 1, False)):
            text = "[" * depth + "1" + "]" * depth
            if fits:
                parse_json(text, "text")
            else:
                with pytest.raises(QuadrupedError, match=rf"text: .*: nested deeper than {MAX_DEPTH} levels; fix it"):
                    parse_json(text, "text")

    def test_read_json_names_the_place_of_a_value_that_is_too_large(self):
        with pytest.raises(QuadrupedError, match=r"config: 'a\.b\.1': a whole number beyond 1\.8e\+308; fix it"):
            parse_json('{"a": {"b": [1, ' + "9" * 400 + "]}}", "config")

    def test_read_json_of_too_many_bytes_is_refused(self, tmp_path):
        path = tmp_path / "a.json"
        with path.open("wb") as file:
            file.truncate(MAX_BYTES["JSON"] + 1)
        with pytest.raises(QuadrupedError, match=rf"a\.json: over {MAX_BYTES['JSON']} bytes are too many"):
            read_json(path)


class TestMessages:
    @pytest.mark.parametrize(
        "value",
        [MEGABYTES, [MEGABYTES] * 1000, {MEGABYTES: [[[[[[[1]]]]]]]}, 10**10_000, b"x" * 9999],
        ids=["text", "list", "table", "number", "bytes"],
    )
    def test_short_values_are_short(self, value):
        assert len(short(value)) < 100

    def test_short_values_are_kept_whole(self):
        assert [short(value) for value in ("a", 3, None, [1, "b"], {"a": 1.5})] == [
            "'a'", "3", "None", "[1, 'b']", "{'a': 1.5}",
        ]  # fmt: skip

    def test_cut_keeps_the_file_and_the_fix(self):
        message = cut(f"file.csv: found {MEGABYTES}; fix it")
        assert len(message) == MAX_MESSAGE
        assert message.startswith("file.csv: found xxx")
        assert message.endswith("xxx; fix it")

    @pytest.mark.parametrize("value", [10**400, 10**5000, [10**5000], MEGABYTES, np.inf], ids=range(5))
    def test_config_values_of_any_size_are_refused(self, value):
        for config in ({"decimation": value}, {"reward": {"weights": {"fall": value}}}, {"motor": {"delay": value}}):
            with pytest.raises(QuadrupedError) as caught:
                TaskConfig.from_dict(config)
            assert len(str(caught.value)) <= MAX_MESSAGE
