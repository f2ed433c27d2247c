"""Mutated files of every format: refused with this package's own error, or read exactly as their bytes now say.

With more files per format: `FUZZED_FILES=2000 pytest tests/trajectory/test_formats_fuzz.py`.
"""

import csv
import os
import re
import sqlite3
import struct
from fractions import Fraction

import numpy as np
import pytest
from bags import JOINT_STATE, messages_of, write_bag
from hanging import bounded
from trajectories import assert_same, random_trajectory

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.errors import MAX_MESSAGE

pytest.importorskip("rosbags")
import yaml
from rosbags.typesys import Stores, get_typestore

NAMES = ["a_joint", "b_joint"]
FILES = int(os.environ.get("FUZZED_FILES", "80"))


def small(rows=12):
    trajectory = random_trajectory(rows=rows)
    numbers = [np.round(array[:, :2], 3) for array in (trajectory.positions, trajectory.efforts)]
    return JointTrajectory(trajectory.stamps, NAMES, numbers[0], numbers[0] * 2.0, np.nan_to_num(numbers[1]))


# Contents of a file by code that shares nothing with the reader, without any checks.


def parse_csv(path):
    """This project's CSV, by Python's own reader."""
    with path.open(encoding="utf-8-sig", newline=None) as file:
        header, *rows = csv.reader(file)
    header = [title.strip() for title in header]
    names = [title.removeprefix("position.") for title in header if title.startswith("position.")]
    columns = {
        kind: [[float(row[header.index(f"{kind}.{name}")]) for name in names] for row in rows]
        for kind in ("position", "velocity", "effort")
        if f"{kind}.{names[0]}" in header
    }
    stamps = [round(Fraction(row[0].strip())) for row in rows]
    return JointTrajectory(stamps, names, columns["position"], columns.get("velocity"), columns.get("effort"))


def parse_yaml(path):
    """Echoed YAML, by PyYAML's own types."""
    number = re.compile(r"^[-+]?[\d.]+(e[-+]?\d+)?$", re.IGNORECASE)
    special = {".nan": np.nan, ".inf": np.inf, "-.inf": -np.inf}

    def value(item):
        if isinstance(item, str) and (
            number.match(item.strip()) or item.strip().lower().strip("+-") in {"nan", "inf", "infinity"}
        ):
            return float(item)
        return special.get(item, item)

    text = path.read_text(encoding="utf-8-sig")
    found = []
    for document in re.split(r"---[^\S\n]*\n", text):
        if document.strip() and not document.lstrip().startswith("A message was lost!!!"):
            found.append(yaml.load(document, yaml.BaseLoader))
    names = found[0]["name"]
    assert all(set(one["name"]) == set(names) for one in found)
    arrays = {
        kind: [[value(one[kind][one["name"].index(name)]) for name in names] for one in found]
        if found[0][kind]
        else None
        for kind in ("position", "velocity", "effort")
    }
    stamps = [int(one["header"]["stamp"]["sec"]) * 10**9 + int(one["header"]["stamp"]["nanosec"]) for one in found]
    return built(stamps, names, **{kind: None if a is None else np.array(a, float) for kind, a in arrays.items()})


def built(stamps, names, position, velocity, effort):
    """A trajectory of messages' numbers; velocities that are all unknown become None."""
    if velocity is not None and np.isnan(velocity).all():
        velocity = None
    return JointTrajectory(stamps, names, position, velocity, effort)


def trajectory_of(messages):
    """Messages of rosbags, put together."""
    names = list(messages[0].name)
    order = [[list(message.name).index(name) for name in names] for message in messages]

    def array(kind):
        rows = [getattr(message, kind) for message in messages]
        return np.array([row[o] for row, o in zip(rows, order, strict=True)]) if len(rows[0]) else None

    stamps = [message.header.stamp.sec * 10**9 + message.header.stamp.nanosec for message in messages]
    return built(stamps, names, array("position"), array("velocity"), array("effort"))


def parse_sqlite3(path):
    """A bag's sqlite3 file, by SQLite itself."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    database = sqlite3.connect(f"{path.as_uri()}?immutable=1", uri=True)
    try:
        database.execute("PRAGMA writable_schema = ON")
        rows = database.execute(
            "SELECT data FROM messages NOT INDEXED JOIN topics ON topics.id = topic_id "
            "WHERE type = 'sensor_msgs/msg/JointState' ORDER BY messages.id"
        ).fetchall()
    finally:
        database.close()
    return trajectory_of([store.deserialize_cdr(data, JOINT_STATE) for (data,) in rows])


def write_yaml(trajectory, path):
    documents = []
    for state in trajectory:
        lists = zip(
            ("name", "position", "velocity", "effort"),
            (NAMES, state.position, state.velocity, state.effort),
            strict=True,
        )
        body = "".join(f"{key}:\n" + "".join(f"- {value}\n" for value in values) for key, values in lists)
        sec, nanosec = divmod(state.stamp, 10**9)
        documents.append(f"header:\n  stamp:\n    sec: {sec}\n    nanosec: {nanosec}\n  frame_id: ''\n{body}---\n")
    path.write_text("".join(documents))


WRITERS = {
    "csv": lambda trajectory, path: trajectory.save(path),
    "echo.yaml": write_yaml,
    "mcap": lambda trajectory, path: trajectory.save(path),
    "db3": lambda trajectory, path: trajectory.save(path),
    "db3.zstd": lambda trajectory, path: write_bag(path, messages_of(trajectory), "sqlite3", "file"),
}

PARSERS = {
    "csv": parse_csv,
    "echo.yaml": parse_yaml,
    "db3": parse_sqlite3,
}
"""Formats without checksums; in the others, everything that is read must be what was written."""


def mutated(data, rng):
    """The bytes with one or a few kinds of damage."""
    for _ in range(rng.integers(1, 4)):
        start = int(rng.integers(0, len(data) + 1))
        end = min(len(data), start + int(rng.integers(1, 40)))
        before, part, after, short = data[:start], data[start:end], data[end:], int(rng.integers(1, 9))
        typed = bytes(rng.choice(list(b"0123456789.,-+eE \n\r\t_\"'naif[]{}:#&*"), rng.integers(1, 4)).astype(np.uint8))
        lines = data.split(b"\n")
        one, other = rng.integers(0, len(lines), 2).tolist()
        lines[one], lines[other] = lines[other], lines[one]
        damages = {
            "cut off": before,
            "inserted": before + rng.bytes(short) + part + after,
            "overwritten": before + rng.bytes(short) + data[start + short :],
            "mistyped": before + typed + data[start + short % 4 :],
            "removed": before + after,
            "repeated": before + part + part + after,
            "zeroed": before + bytes(len(part)) + after,
            "long length": before + struct.pack("<Q", 2**64 - short) + data[start + 8 :],
            "other length": before + struct.pack("<I", int(rng.integers(0, 2**32))) + data[start + 4 :],
            "lines swapped": b"\n".join(lines),
            "bit flipped": before + bytes(byte ^ 1 << short - 1 for byte in part[:1]) + data[start + 1 :],
        }
        data = list(damages.values())[rng.integers(0, len(damages))]
    return data


def fuzz(directory, kind, count, seed):
    """Read `count` mutated files; returns how many were refused and how many were read."""
    rng = np.random.default_rng(seed)
    original, path = small(), directory / f"file.{kind}"
    if kind == "db3.zstd":
        path = directory / "bag"
    WRITERS[kind](original, path)
    damaged = path / "bag.db3.zstd" if kind == "db3.zstd" else path
    data = damaged.read_bytes()
    refused = read = 0
    for _ in range(count):
        damaged.write_bytes(mutated(data, rng))
        options = {"unit": "rad"}
        plain = rng.random() < 0.6
        if not plain:
            options["repair"] = [name for name in ("salvage", "drop", "sort") if rng.random() < 0.6]
        try:
            with bounded():
                loaded = JointTrajectory.load(path, **options)
        except QuadrupedError as error:
            assert str(error).startswith((str(path), "slice"))  # noqa: PT017
            assert len(str(error)) <= MAX_MESSAGE  # noqa: PT017
            refused += 1
            continue
        read += 1
        if plain:
            expected = PARSERS[kind](damaged) if kind in PARSERS else original
            assert_same(loaded, expected)
    return refused, read


@pytest.mark.parametrize("kind", WRITERS)
def test_damaged_files_are_refused_or_read_as_they_are(tmp_path, kind):
    refused, read = fuzz(tmp_path, kind, FILES, seed=0)
    assert refused > FILES // 10
    assert read > 0
