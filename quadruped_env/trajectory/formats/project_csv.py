"""This project's CSV of joint states: a header line, then one line per row.

    stamp_ns,position.LF_hip_joint,...,velocity.LF_hip_joint,...,effort.LF_hip_joint,...
    0,0.6,...

`stamp_ns` is a whole number of ns, positions are rad, velocities rad/s, efforts N m. Velocities and efforts may be
left out, each for all joints; an effort may be `nan`. Columns after the first may come in any order. Numbers are
written in the shortest form that reads back to the same bits. Every line has a line end; a last one without it is
reported, since it may be cut off.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.column_map import ColumnMap
from quadruped_env.trajectory.reading import Reading
from quadruped_env.trajectory.rows import KINDS, TORQUE_ONLY, Rows
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.files import check_free, whole
from quadruped_env.utils.progress import Progress

STAMP_COLUMN: Final = "stamp_ns"

_HEADER: Final = f"{STAMP_COLUMN},position.<joint>,...[,velocity.<joint>,...][,effort.<joint>,...]"
_ROWS_PER_WRITE: Final = 1000


def column_map(line: str, reading: Reading) -> ColumnMap:
    """Return the columns that a header line names.

    Raises:
        QuadrupedError: if it names unknown columns, a joint in some of its kinds only, or no position.
    """
    stamp, *titles = [title.strip() for title in line.split(",")]
    found: dict[str, dict[str, str | int]] = {kind: {} for kind in KINDS}
    problem = "" if stamp == STAMP_COLUMN else f"the first column must be {STAMP_COLUMN!r}; found {short(stamp)};"
    for title in titles:
        kind, _, joint = title.partition(".")
        if kind not in KINDS or not joint:
            problem = problem or f"column {short(title)} is unknown; rename it, or leave it out;"
        else:
            found[kind][joint] = title
    if not found["position"]:
        problem = problem or (f"{TORQUE_ONLY};" if found["effort"] else "no position column;")
    if problem:
        raise reading.error(None, f"line 1, the header: {problem} expected {_HEADER}")
    name = f"{reading.name}: line 1, the header"
    return ColumnMap(stamp, found["position"], found["velocity"] or None, found["effort"] or None, "ns", name=name)


def write(rows: Rows, path: Path, overwrite: bool) -> None:
    """Write rows, in full or not at all.

    Raises:
        QuadrupedError: if a joint's name has characters that a CSV header cannot hold, the file exists and must not be
            overwritten, or it cannot be written.
    """
    for name in rows.names:
        if name.splitlines() != [name] or not {",", '"'}.isdisjoint(name):
            raise QuadrupedError(f"{path}: joint name {name!r} cannot stand in a CSV header; rename the joint")
    titles = [f"{kind}.{name}" for kind in rows.values for name in rows.names]
    write_table(path, rows.stamps, titles, list(rows.values.values()), overwrite)


def write_table(
    path: Path,
    stamps: NDArray[np.int64],
    titles: Sequence[str],
    tables: Sequence[Floats],
    overwrite: bool = False,
    progress: Progress | None = None,
) -> None:
    """Write a CSV of timestamps and numbers, in full or not at all.

    Args:
        path: of the file.
        stamps: ns (T,).
        titles: of the columns of all tables (C,).
        tables: numbers, each (T, columns).
        overwrite: replace an existing file.
        progress: called with the fraction of the rows written.

    Raises:
        QuadrupedError: if the file exists and must not be overwritten, or cannot be written.
    """
    check_free([path], overwrite)
    with whole(path) as part, part.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join([STAMP_COLUMN, *titles]) + "\n")
        # In pieces: as Python objects, a long recording would not fit into memory.
        for start in range(0, len(stamps), _ROWS_PER_WRITE):
            piece = slice(start, start + _ROWS_PER_WRITE)
            table = np.concatenate([table[piece] for table in tables], axis=1)
            for stamp, row in zip(stamps[piece].tolist(), table.tolist(), strict=True):
                file.write(f"{stamp},{','.join(map(repr, row))}\n")
            if progress is not None:
                progress(min(piece.stop / len(stamps), 1.0))
