"""Files that crash, hang or flood a naive reader: every reader refuses them with a short error of this package."""

import argparse
import dataclasses
import json
import math
import os
import shutil
import struct
from typing import Any, ClassVar, Literal, NotRequired, TypedDict

import numpy as np
import pytest
from bags import fields, write_bag
from hanging import bounded
from mutations import mutated_json, mutated_text

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.cli.train import task_change
from quadruped_env.errors import MAX_MESSAGE, cut, short
from quadruped_env.export.golden_trace import TRACE_FILE
from quadruped_env.export.manifest import FORMAT
from quadruped_env.export.trace_check import ExportedTrace
from quadruped_env.policies.files import read_policy, shipped_directory
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.task import TaskConfig, load_task_file
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_COLUMNS, PROGRESS_FILE, RESUME_FILE
from quadruped_env.trajectory import ColumnMap, JointMap
from quadruped_env.utils.documents import MAX_BYTES, MAX_DEPTH, fitted, parse_json, read_json, read_toml

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


def prepare_whole_run(directory):
    """A run that can be resumed, but for its network, from the shipped policy."""
    prepare_policy(directory)
    card = json.loads((directory / CARD_FILE).read_text())
    card["card"] |= {"timesteps": 100, "seconds": 1.0, "budget_left": 0.5}
    (directory / CARD_FILE).write_text(json.dumps(card))
    training = dataclasses.asdict(TrainConfig(action_mode=card["action_mode"]))
    (directory / CONFIG_FILE).write_text(json.dumps({"training": training, "task": card["config"]}))
    row = {**dict.fromkeys(PROGRESS_COLUMNS, "1"), "timesteps": "50"}
    (directory / PROGRESS_FILE).write_text(f"{','.join(row)}\n{','.join(row.values())}\n")
    (directory / RESUME_FILE).touch()


def read_task(path):
    """A file of `--task`, and the config that it changes."""
    try:
        TaskConfig.from_dict(task_change(str(path)))
    except argparse.ArgumentTypeError as error:
        raise QuadrupedError(str(error)) from error


def prepare_export(directory):
    """Manifest and golden trace of an export, with two fields."""
    field = {"part": "result", "width": 2, "unit": "1", "tolerance": 1e-4, "description": ""}
    trace = {"file": TRACE_FILE, "fields": [{**field, "name": "action"}, {**field, "name": "joint_target"}]}
    trace |= {"largest_rates": [1.0, 4.0], "timestep_s": 0.02}
    (directory / "manifest.json").write_text(json.dumps({"format": FORMAT, "golden_trace": trace}))
    (directory / TRACE_FILE).write_text("step,action_0,action_1,joint_target_0,joint_target_1\n0,1,nan,-1e-3,0.5\n")


TERMS = "from quadruped_env.task import reward\n@reward(1.0)\ndef mine(context):\n    return context.base_height\n"
MOTORS = json.dumps({"motor": TaskConfig().to_dict()["motor"]})
COLUMNS = '[columns]\nstamp = "t"\nstamp_unit = "s"\npositions = ["a", "b"]\nmissing = [-1]\n'
JOINTS = '[joints.LF_hip_joint]\nsource = "a"\nscale = 2.0\noffset = 0.1\nunit = "deg"\n'
TASK = json.dumps({"decimation": 4, "reward": {"weights": {"upright": -1.0}}, "command": {"yaw_rate": [-0.4, 0.4]}})
TABLE = "t,q\n0.0,1.5\n0.1,1.25\n"

READERS = {
    "policy": Reader(CARD_FILE, lambda path: read_policy(path.parent), prepare_policy),
    "config": Reader(CONFIG_FILE, lambda path: Parent.load(path.parent), prepare_whole_run),
    "motors": Reader("motors.json", read_motors, sound=MOTORS),
    "task": Reader("task.json", read_task, sound=TASK),
    "terms": Reader("terms.py", load_task_file, sound=TERMS),
    "golden trace": Reader(TRACE_FILE, lambda path: ExportedTrace.load(path.parent), prepare_export),
    "traced export": Reader("manifest.json", lambda path: ExportedTrace.load(path.parent), prepare_export),
    "columns": Reader("columns.toml", ColumnMap.load, sound=COLUMNS),
    "joints": Reader("joints.toml", JointMap.load, sound=JOINTS),
    "recording": Reader("recording", JointTrajectory.load, sound=ECHO + ECHO.replace("sec: 1", "sec: 2")),
    "salvaged": Reader("recording", lambda path: JointTrajectory.load(path, repair=["salvage", "drop"]), sound=ECHO),
    "table": Reader(
        "a.csv", lambda path: JointTrajectory.load(path, columns=path.with_name("map.toml")), prepare_map, TABLE
    ),
    "storage": Reader("bag/bag.mcap", lambda path: JointTrajectory.load(path.parent, repair=["salvage"]), prepare_bag),
    "tensors": Reader(TENSORS_FILE, lambda path: read_policy(path.parent), prepare_policy),
}
BINARY = ("tensors", "storage")
"""Readers of binary files; tests/trajectory/test_formats_fuzz.py mutates bags."""

JSON = ("policy", "config", "motors", "traced export")
TOML = ("columns", "joints", "space")


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
    ("tensors",): {
        "types that NumPy lacks": tensors(a={"dtype": "BF16", "shape": [8], "data_offsets": [0, 16]}),
        "small types": tensors(a={"dtype": "F8_E4M3", "shape": [16], "data_offsets": [0, 16]}),
        "deep header": struct.pack("<Q", DEEP) + b"[" * DEEP,
        "endless header": struct.pack("<Q", 2**63) + b"{}",
    },
    ("golden trace",): {
        "columns of megabytes": ",".join(f"column {i}" for i in range(300_000)) + "\n0\n",
        "megabytes in a cell": f"step,action_0,action_1,joint_target_0,joint_target_1\n0,{MEGABYTES},0,0,0\n",
        "long text in a cell": f"step,action_0,action_1,joint_target_0,joint_target_1\n0,{'x' * 100_000},0,0,0\n",
        "open quotes": 'step,"' + "0,\n" * 100_000,
        "not text": b"\x80\x81" * 5000,
        "empty": b"",
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
    if kind in {"a pipe", "a device"} and name != "config":
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


class Inner(TypedDict):
    a: float | None
    b: NotRequired[list[int]]


class Outer(TypedDict):
    version: Literal[1]
    inner: dict[str, Inner]
    text: str | Inner
    free: Any


class TestForms:
    SOUND: ClassVar = {"version": 1, "inner": {"x": {"a": 1, "b": [1, 2]}, "y": {"a": None}}, "text": "t", "free": [{}]}

    def test_fitted_leaves_out_what_the_form_lacks(self):
        other = {**self.SOUND, "later": 1, "inner": {"x": {"a": 1, "b": [1, 2], "c": {}}, "y": {"a": None}}}
        assert fitted(self.SOUND, Outer, "file", "fix it") == self.SOUND
        assert fitted(other, Outer, "file", "fix it") == self.SOUND

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"version": 2}, "version: expected 1; found 2; fix it"),
            ({"version": True}, "version: expected 1; found True; fix it"),
            ({"inner": [1]}, r"inner: expected a table; found \[1\]; fix it"),
            ({"inner": {"x": {}}}, r"inner\.x\.a is missing; fix it"),
            ({"inner": {"x": {"a": "1"}}}, r"inner\.x\.a: expected a finite number or null; found '1'; fix it"),
            ({"inner": {"x": {"a": math.nan}}}, r"inner\.x\.a: expected a finite number or null; found nan; fix it"),
            ({"inner": {"x": {"a": True}}}, r"inner\.x\.a: expected a finite number or null; found True; fix it"),
            ({"inner": {"x": {"a": 10**300}}}, r"inner\.x\.a: expected a finite number or null; found 1000.*; fix it"),
            ({"inner": {"x": {"a": 1, "b": [1, 1.5]}}}, r"inner\.x\.b\.1: expected a whole number; found 1\.5; fix it"),
            ({"text": 3}, "text: expected a text or a table; found 3; fix it"),
            ({"text": {"a": "x"}}, r"text\.a: expected a finite number or null; found 'x'; fix it"),
        ],
    )
    def test_fitted_names_file_field_value_and_fix(self, change, message):
        with pytest.raises(QuadrupedError, match=rf"^file: {message}$"):
            fitted({**self.SOUND, **change}, Outer, "file", "fix it")

    def test_fitted_refuses_what_is_no_table(self):
        with pytest.raises(QuadrupedError, match=r"^file: expected a table; found \[\]; fix it$"):
            fitted([], Outer, "file", "fix it")


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
