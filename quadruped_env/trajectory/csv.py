"""This project's CSV of joint states: a header line, then a line a row.

    stamp_ns,position.LF_hip_joint,...,velocity.LF_hip_joint,...,effort.LF_hip_joint,...
    0,0.6,...

`stamp_ns` is a whole number of ns, positions are rad, velocities rad/s, efforts N m. Velocities and efforts may be
left out, each for all joints; an effort may be `nan`. Columns after the first may come in any order. Numbers are
written in the shortest form that reads back to the same bits. Nothing is quoted and every line ends, the last one
too: that is how a file that was cut off is known.
"""

import os
from array import array
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Final, TextIO

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory.joint_trajectory import Source

STAMP_COLUMN: Final = "stamp_ns"
KINDS: Final = ("position", "velocity", "effort")

_HEADER: Final = f"{STAMP_COLUMN},position.<joint>,...[,velocity.<joint>,...][,effort.<joint>,...]"
_FIRST_ROW: Final = 2
"""The line of the first row; the header is line 1."""
_ROWS_A_WRITE: Final = 1000

Values = dict[str, NDArray[np.float64]]


def read(path: Path) -> tuple[NDArray[np.int64], tuple[str, ...], Values, Source]:
    """Stamps (T,), joint names (J,), arrays (T, J) by kind, and their source.

    Raises:
        QuadrupedError: if the file is missing or damaged; whether its values make sense is for `JointTrajectory`.
    """
    try:
        # A byte-order mark is what spreadsheets put in front of UTF-8.
        with path.open(encoding="utf-8-sig") as file:
            columns = _read_header(file, path)
            stamps, numbers = _read_rows(file, columns, path)
    except UnicodeDecodeError as error:
        raise QuadrupedError(f"{path}: not a text file ({error.reason}); expected a CSV of joint states") from error
    except FileNotFoundError as error:
        raise QuadrupedError(f"{path}: there is no such file; check its name") from error
    except OSError as error:
        raise QuadrupedError(f"{path}: cannot be read ({error.strerror}); name a CSV of joint states") from error

    table = np.frombuffer(numbers, dtype=np.float64).reshape(len(stamps), len(columns) - 1)
    names = tuple(joint for kind, joint in columns[1:] if kind == "position")
    values = {}
    for kind in KINDS:
        if any(kind == found for found, _ in columns):
            values[kind] = table[:, [columns.index((kind, name)) - 1 for name in names]]
    return np.frombuffer(stamps, dtype=np.int64), names, values, Source(str(path), "line", _FIRST_ROW)


def write(
    path: Path,
    stamps: NDArray[np.int64],
    names: Sequence[str],
    values: Mapping[str, NDArray[np.float64] | None],
    overwrite: bool,
) -> None:
    """Write stamps (T,) and the arrays (T, J) that are not None; see `JointTrajectory.save`."""
    check_name(path)
    for name in names:
        if name.splitlines() != [name] or not {",", '"'}.isdisjoint(name):
            raise QuadrupedError(f"{path}: joint name {name!r} cannot stand in a CSV header; rename the joint")
    present = {kind: array for kind, array in values.items() if array is not None}
    titles = [f"{kind}.{name}" for kind in present for name in names]
    write_table(path, stamps, titles, np.concatenate(list(present.values()), axis=1), overwrite)


def check_name(path: Path) -> None:
    """Raise a QuadrupedError if a file of this name would not be a CSV."""
    if path.suffix.lower() != ".csv":
        raise QuadrupedError(f"{path}: end the name in .csv; found {path.suffix!r}")


def write_table(
    path: Path,
    stamps: NDArray[np.int64],
    titles: Sequence[str],
    table: NDArray[np.float64],
    overwrite: bool = False,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Write a CSV of stamps (T,) and numbers (T, C) with a title a column, in full or not at all.

    `progress` is told the share of the rows that is written, in [0, 1].

    Raises:
        QuadrupedError: if the file is there already and is not to be overwritten, or cannot be written.
    """
    if path.is_dir() or (path.exists() and not overwrite):
        raise QuadrupedError(f"{path}: exists already; name another file, or ask to overwrite it")
    partial = path.with_name(path.name + ".partial")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with partial.open("w", encoding="utf-8", newline="\n") as file:
            file.write(",".join([STAMP_COLUMN, *titles]) + "\n")
            # In blocks: as Python objects, a long recording would not fit into memory.
            for start in range(0, len(stamps), _ROWS_A_WRITE):
                block = slice(start, start + _ROWS_A_WRITE)
                for stamp, row in zip(stamps[block].tolist(), table[block].tolist(), strict=True):
                    file.write(f"{stamp},{','.join(map(repr, row))}\n")
                if progress is not None:
                    progress(min(block.stop / len(stamps), 1.0))
        os.replace(partial, path)
    except OSError as error:
        raise QuadrupedError(f"{path}: cannot be written ({error.strerror}); name another place") from error


def _read_header(file: TextIO, path: Path) -> list[tuple[str, str]]:
    """(kind, joint) of every column; the first is (STAMP_COLUMN, "")."""
    line = file.readline()
    if not line:
        raise QuadrupedError(f"{path}: the file is empty; expected the header {_HEADER} and a line a row")
    titles = line.removesuffix("\n").split(",")
    if titles[0] != STAMP_COLUMN:
        raise QuadrupedError(
            f"{path}: line 1, the header: the first column must be {STAMP_COLUMN!r}; found {_short(titles[0])}; "
            f"expected {_HEADER}"
        )
    columns = [(STAMP_COLUMN, "")]
    for title in titles[1:]:
        kind, _, joint = title.partition(".")
        if kind not in KINDS or not joint:
            raise QuadrupedError(
                f"{path}: line 1, the header: column {_short(title)} is unknown; rename it, or leave it out; "
                f"expected {_HEADER}"
            )
        if (kind, joint) in columns:
            raise QuadrupedError(f"{path}: line 1, the header: column {_short(title)} is there twice; keep one")
        columns.append((kind, joint))
    joints = {kind: {joint for found, joint in columns if found == kind} for kind in KINDS}
    if not joints["position"]:
        raise QuadrupedError(f"{path}: line 1, the header: no position column; expected {_HEADER}")
    for kind in KINDS[1:]:
        unpaired = sorted(joints[kind] ^ joints["position"])
        if joints[kind] and unpaired:
            found, lacking = ("position", kind) if unpaired[0] in joints["position"] else (kind, "position")
            raise QuadrupedError(
                f"{path}: line 1, the header: joint {_short(unpaired[0])} has a {found} column and no {lacking} "
                f"column; add it, or leave all {kind} columns out"
            )
    return columns


def _read_rows(file: TextIO, columns: list[tuple[str, str]], path: Path) -> tuple["array[int]", "array[float]"]:
    stamps, numbers = array("q"), array("d")
    for number, line in enumerate(file, _FIRST_ROW):
        cells = line.split(",")
        if len(cells) != len(columns):
            raise QuadrupedError(
                f"{path}: line {number}: expected {len(columns)} columns, as in the header; found {len(cells)}; "
                f"the line is damaged or cut off: mend it or delete it"
            )
        if not line.endswith("\n"):
            raise QuadrupedError(
                f"{path}: line {number}: the last line does not end, so its last number, {_short(cells[-1])}, may be "
                f"cut off; delete the line, or end it if it is whole"
            )
        # Python's own numbers may hold underscores and the digits of other scripts: here those are damage.
        if "_" in line or not line.isascii():
            raise _bad_cell(cells, columns, number, path)
        try:
            stamps.append(int(cells[0]))
            numbers.extend(map(float, cells[1:]))
        except (ValueError, OverflowError):
            raise _bad_cell(cells, columns, number, path) from None
    if not stamps:
        raise QuadrupedError(f"{path}: there is a header and no row; the recording is empty, record again")
    return stamps, numbers


def _bad_cell(cells: list[str], columns: list[tuple[str, str]], number: int, path: Path) -> QuadrupedError:
    """The error for the first cell of a line that is not a number."""
    title, cell, kind = next(
        (".".join(column).rstrip("."), cell.strip("\n"), "a whole number of ns" if i == 0 else "a number")
        for i, (column, cell) in enumerate(zip(columns, cells, strict=True))
        if not _is_number(cell, whole=i == 0)
    )
    return QuadrupedError(
        f"{path}: line {number}, {title}: {_short(cell)} is not {kind}; mend the value or delete the line"
    )


def _is_number(cell: str, whole: bool) -> bool:
    if "_" in cell or not cell.isascii():
        return False
    try:
        array("q", [int(cell)]) if whole else float(cell)
    except (ValueError, OverflowError):
        return False
    return True


def _short(text: str) -> str:
    """Text from a file as a message may show it."""
    return repr(text if len(text) <= 40 else text[:40] + "...")
