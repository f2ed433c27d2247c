"""This project's CSV of joint states: a header line, then one line per row.

    stamp_ns,position.LF_hip_joint,...,velocity.LF_hip_joint,...,effort.LF_hip_joint,...
    0,0.6,...

`stamp_ns` is a whole number of ns, positions are rad, velocities rad/s, efforts N m. Velocities and efforts may be
left out, each for all joints; an effort may be `nan`. Columns after the first may come in any order. Numbers are
written in the shortest form that reads back to the same bits. Nothing is quoted. Every line has a line end; a last one
without it is reported, since it may be cut off.
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.formats.delimited import Layout, lines, opened, parse_whole, salvaged_text, table_rows
from quadruped_env.trajectory.rows import KINDS, TORQUE_ONLY, Rows
from quadruped_env.utils.files import check_free, whole
from quadruped_env.utils.progress import Progress

STAMP_COLUMN: Final = "stamp_ns"

_HEADER: Final = f"{STAMP_COLUMN},position.<joint>,...[,velocity.<joint>,...][,effort.<joint>,...]"
_FIRST_ROW: Final = 2
"""Line of the first row; the header is line 1."""
_ROWS_PER_WRITE: Final = 1000


def read(reading: Reading) -> Iterator[Rows]:
    """The rows of a file, not validated. Raises a QuadrupedError if the file is missing or damaged."""
    return salvaged_text(_rows(reading), reading)


def _rows(reading: Reading) -> Iterator[Rows]:
    reading.row_name = "line"
    with opened(reading) as file:
        layout = _layout(_read_header(file.readline(), reading.path))
        table = ((number, line.split(",")) for number, line in enumerate(lines(file, reading, _FIRST_ROW), _FIRST_ROW))
        yield from table_rows(table, layout, reading)


def write(pieces: Iterable[Rows], path: Path, overwrite: bool) -> None:
    """Write rows, in full or not at all.

    Raises:
        QuadrupedError: if a joint's name has characters that a CSV header cannot hold, the file exists and must not be
            overwritten, or it cannot be written.
    """
    following = iter(pieces)
    first = next(following)
    for name in first.names:
        if name.splitlines() != [name] or not {",", '"'}.isdisjoint(name):
            raise QuadrupedError(f"{path}: joint name {name!r} cannot stand in a CSV header; rename the joint")

    titles = [f"{kind}.{name}" for kind in first.values for name in first.names]
    tables = (
        (piece.stamps, np.concatenate(list(piece.values.values()), axis=1)) for piece in chain([first], following)
    )
    _write_tables(path, titles, tables, overwrite)


def write_table(
    path: Path,
    stamps: NDArray[np.int64],
    titles: Sequence[str],
    table: NDArray[np.float64],
    overwrite: bool = False,
    progress: Progress | None = None,
) -> None:
    """Write a CSV of timestamps and numbers, in full or not at all.

    Args:
        path: of the file.
        stamps: ns (T,).
        titles: of the columns (C,).
        table: numbers (T, C).
        overwrite: replace an existing file.
        progress: called with the fraction of the rows written.

    Raises:
        QuadrupedError: if the file exists and must not be overwritten, or cannot be written.
    """

    def tables() -> Iterator[tuple[NDArray[np.int64], NDArray[np.float64]]]:
        for start in range(0, len(stamps), _ROWS_PER_WRITE):
            part = slice(start, start + _ROWS_PER_WRITE)
            yield stamps[part], table[part]
            if progress is not None:
                progress(min(part.stop / len(stamps), 1.0))

    _write_tables(path, titles, tables(), overwrite)


def _write_tables(
    path: Path, titles: Sequence[str], tables: Iterable[tuple[NDArray[np.int64], NDArray[np.float64]]], overwrite: bool
) -> None:
    check_free([path], overwrite)
    with whole(path) as part, part.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join([STAMP_COLUMN, *titles]) + "\n")
        # In pieces: as Python objects, a long recording would not fit into memory.
        for stamps, table in tables:
            for stamp, row in zip(stamps.tolist(), table.tolist(), strict=True):
                file.write(f"{stamp},{','.join(map(repr, row))}\n")


def _read_header(line: str, path: Path) -> list[tuple[str, str]]:
    """(kind, joint) of every column; the first is (STAMP_COLUMN, "")."""
    if not line:
        raise QuadrupedError(f"{path}: the file is empty; expected the header {_HEADER} and one line per row")
    titles = line.removesuffix("\n").split(",")
    if titles[0] != STAMP_COLUMN:
        raise QuadrupedError(
            f"{path}: line 1, the header: the first column must be {STAMP_COLUMN!r}; found {short(titles[0])}; "
            f"expected {_HEADER}"
        )
    columns = [(STAMP_COLUMN, "")]
    for title in titles[1:]:
        kind, _, joint = title.partition(".")
        if kind not in KINDS or not joint:
            raise QuadrupedError(
                f"{path}: line 1, the header: column {short(title)} is unknown; rename it, or leave it out; "
                f"expected {_HEADER}"
            )
        if (kind, joint) in columns:
            raise QuadrupedError(f"{path}: line 1, the header: column {short(title)} is there twice; keep one")
        columns.append((kind, joint))
    joints = {kind: {joint for found, joint in columns if found == kind} for kind in KINDS}
    if not joints["position"]:
        problem = f"{TORQUE_ONLY};" if joints["effort"] else "no position column;"
        raise QuadrupedError(f"{path}: line 1, the header: {problem} expected {_HEADER}")
    for kind in KINDS[1:]:
        unpaired = sorted(joints[kind] ^ joints["position"])
        if joints[kind] and unpaired:
            found, lacking = ("position", kind) if unpaired[0] in joints["position"] else (kind, "position")
            raise QuadrupedError(
                f"{path}: line 1, the header: joint {short(unpaired[0])} has a {found} column and no {lacking} "
                f"column; add it, or leave all {kind} columns out"
            )
    return columns


def _layout(columns: list[tuple[str, str]]) -> Layout:
    names = tuple(joint for kind, joint in columns if kind == "position")
    present = [kind for kind in KINDS if any(kind == found for found, _ in columns)]
    return Layout(
        titles=[".".join(column).rstrip(".") for column in columns],
        stamp=0,
        parse_stamp=parse_whole,
        stamp_form="a whole number of ns",
        columns={kind: [columns.index((kind, name)) for name in names] for kind in present},
        names=names,
    )
