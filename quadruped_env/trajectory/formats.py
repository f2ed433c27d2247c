"""From a file of any known format to checked rows: recognised by what is in it, not by its name."""

import os
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.documents import check_regular
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory import bag, column_map, csv, echo, salvage
from quadruped_env.trajectory.column_map import ColumnMap
from quadruped_env.trajectory.joint_map import JointMap
from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.reading import (
    TORQUE_ONLY,
    Block,
    Progress,
    Reading,
    ReadOptions,
    Sample,
    assemble,
    joined,
    salvaged,
    without_ignored,
)
from quadruped_env.trajectory.salvage.found import ZSTD_MAGIC
from quadruped_env.trajectory.validation import Source, falling_stamp

SUSPICIOUS: Final = 4.0 * np.pi
"""rad: two turns; no leg's joint goes there, and a log in degrees nearly always does"""

_AS_IT_IS: Final = ReadOptions()
_MIN_ROWS: Final = 1024
_MAX_FIX: Final = 1 << 22
"""Rows: room for no more is made in advance, since damage may claim any number"""
_FIX: Final = "name a file of joint states, or the directory of a bag"
_HEAD: Final = 65536
"""Bytes that are enough to recognise a format"""
_KNOWN: Final = (
    "known are the project's CSV, any CSV with a column map, ros2 topic echo (YAML and --csv), rosbag2 (MCAP and "
    "sqlite3) and ROS 1 bags"
)

_SampleReader = Callable[[Reading], Iterator[Sample]]
_BlockReader = Callable[[Reading], Iterator[Block]]
_MAGICS: Final[dict[bytes, _SampleReader]] = {
    b"\x89MCAP0": bag.read_mcap,
    b"SQLite format 3\x00": bag.read_sqlite3,
    b"#ROSBAG V2.0": bag.read_ros1,
}
"""How a file begins -> its reader"""


def options(
    columns: ColumnMap | str | Path | None = None, joint_map: JointMap | str | Path | None = None, **others: Any
) -> ReadOptions:
    """Options for reading, with maps that may still be in TOML files; the others as `ReadOptions` has them.

    Raises:
        QuadrupedError: if a map or an option is wrong.
    """
    if columns is not None and not isinstance(columns, ColumnMap):
        columns = ColumnMap.load(columns)
    if joint_map is not None and not isinstance(joint_map, JointMap):
        joint_map = JointMap.load(joint_map)
    return ReadOptions(columns, joint_map, **others)


def stream(path: str | Path, options: ReadOptions = _AS_IT_IS, progress: Progress | None = None) -> "Stream":
    """The trajectory in a file, piece by piece: memory does not grow with the length of the recording.

    Args:
        path: of the file or bag.
        options: as for `JointTrajectory.load`; `sort` is the one that needs the whole recording in memory.
        progress: is told the share that is done.

    Raises:
        QuadrupedError: while it is read, if something in it is wrong.
    """
    return Stream(Reading(Path(path), options, progress))


class Stream:
    """Iterates over a recording as trajectories that follow each other; see `stream`."""

    def __init__(self, reading: Reading) -> None:
        self._reading = reading

    def remarks(self) -> tuple[str, ...]:
        """What to know about the numbers: rows left out, damage. Complete when the last piece was read."""
        return self._reading.remarks()

    @property
    def is_complete(self) -> bool:
        """Whether the rows are those of the file, all and in their order."""
        return not self._reading.left_out and not self._reading.options.sort

    @property
    def unchecked_rows(self) -> int:
        """How many rows were salvaged that no checksum covers, those included that were left out later."""
        return self._reading.unchecked_rows

    @property
    def expected_rows(self) -> int:
        """How many rows there may be in all; 0 where that is not known."""
        return self._reading.expected_rows

    def __iter__(self) -> Iterator[JointTrajectory]:
        reading = self._reading
        with ExitStack() as stack:
            path = reading.path
            blocks = _blocks(reading, stack)
            if reading.options.sort:
                blocks = _sorted(blocks)
            rows = 0
            for trajectory in _checked(blocks, reading):
                rows += len(trajectory)
                yield trajectory
        if not rows:
            raise QuadrupedError(f"{path}: no row is left; {'; '.join(reading.remarks()) or 'record again'}")
        reading.at(1.0)


def load(path: str | Path, options: ReadOptions = _AS_IT_IS, progress: Progress | None = None) -> JointTrajectory:
    """The trajectory in a file; see `JointTrajectory.load`."""
    return joined_pieces(path, stream(path, options, progress))


def joined_pieces(path: str | Path, pieces: "Stream") -> JointTrajectory:
    """The pieces of a stream as one trajectory; `path` names it in errors."""
    columns: dict[str, _Column] = {}
    names: tuple[str, ...] = ()
    first: Source | None = None
    for piece in pieces:
        names = piece.names
        first = first or piece.source
        for field in ("stamps", *piece.kinds):
            columns.setdefault(field, _Column(pieces.expected_rows)).append(getattr(piece, field))
    source = Source(str(path), "kept row", 0, notes=pieces.remarks())
    if pieces.is_complete and first is not None and first.rows is not None:
        source = replace(source, row_name=first.row_name, first_row=int(first.rows[0]))
    return JointTrajectory(names=names, source=source, **{field: column.values() for field, column in columns.items()})


class _Column:
    """Collects rows in one array, which grows if there are more than expected: no block of memory is held twice."""

    def __init__(self, expected: int) -> None:
        self._expected = min(max(expected, _MIN_ROWS), _MAX_FIX)
        self._array: NDArray[Any] | None = None
        self._rows = 0

    def append(self, rows: NDArray[Any]) -> None:
        """Take rows (n, ...)."""
        end = self._rows + len(rows)
        if self._array is None:
            self._array = np.empty((max(self._expected, end), *rows.shape[1:]), rows.dtype)
        elif end > len(self._array):
            larger = np.empty((max(end, len(self._array) * 3 // 2), *rows.shape[1:]), rows.dtype)
            larger[: self._rows] = self._array[: self._rows]
            self._array = larger
        self._array[self._rows : end] = rows
        self._rows = end

    def values(self) -> NDArray[Any]:
        """The rows, read-only: such arrays are shared and not copied."""
        assert self._array is not None
        result = self._array[: self._rows]
        result.flags.writeable = False
        return result


def _blocks(reading: Reading, stack: ExitStack) -> Iterator[Block]:
    """The rows of a file as they are."""
    while True:
        head = _head(reading)
        if not head.startswith(ZSTD_MAGIC):
            break
        reading.path = salvage.decompressed(reading.path, stack, reading)
    read_blocks: _BlockReader | None = None
    if reading.options.columns is not None:
        read_blocks = column_map.read
    elif head.startswith((csv.STAMP_COLUMN.encode(), b"\xef\xbb\xbf" + csv.STAMP_COLUMN.encode())):
        read_blocks = csv.read
    if read_blocks is not None:
        return without_ignored(salvaged(read_blocks(reading), reading, is_text=True), reading)
    read_samples = _sample_reader(head, reading)
    is_text = read_samples in {echo.read_yaml, echo.read_csv}
    return assemble(salvaged(read_samples(reading), reading, is_text), reading)


def _head(reading: Reading) -> bytes:
    """The first bytes of a file, or b"" for a directory."""
    try:
        if os.path.isdir(reading.path):
            for path in reading.path.iterdir():
                if not path.is_dir():
                    check_regular(path, _FIX)
            return b""
        check_regular(reading.path, _FIX)
        with reading.path.open("rb") as file:
            head = file.read(_HEAD)
    except OSError as error:
        raise reading.error(None, f"cannot be read ({error.strerror}); name a file of joint states") from error
    if not head:
        raise reading.error(None, "the file is empty; record again")
    return head


def _sample_reader(head: bytes, reading: Reading) -> _SampleReader:
    """The reader of messages for a file that begins so."""
    if reading.path.is_dir():
        if not salvage.storage_files(reading.path):
            raise reading.error(None, "the directory is no bag; expected metadata.yaml and .mcap or .db3 files")
        return bag.read_rosbag2
    for magic, reader in _MAGICS.items():
        if head.startswith(magic):
            return reader
    if head.startswith(b"#ROSBAG"):
        raise reading.error(
            None, f"a bag of an old version, {short(head[:13].decode(errors='replace'))}; rosbag migrate"
        )
    try:
        # The last character may be cut in two.
        text = head.decode("utf-8-sig", errors="strict" if len(head) < _HEAD else "ignore")
    except UnicodeDecodeError as error:
        raise reading.error(None, f"not a text file ({error.reason}) nor a known bag; {_KNOWN}") from error
    line = next((line for line in text.splitlines() if line.strip(" -") and not line.startswith((echo.LOST, "\t"))), "")
    cells = line.split(",")
    if line.rstrip() == "header:" or line.startswith(("header: {", "{header:")):
        return echo.read_yaml
    if len(cells) >= 7 and all(cell.lstrip("-").isdecimal() for cell in cells[:2]):
        return echo.read_csv
    if len(cells) > 1:
        raise reading.error(
            None,
            f"text that begins with {short(line)}; if it is a CSV of other columns, say which is which with a column "
            f"map (--columns FILE); {_KNOWN}",
        )
    raise reading.error(None, f"text that begins with {short(line)} is no recording of joint states; {_KNOWN}")


def _sorted(blocks: Iterator[Block]) -> Iterator[Block]:
    """All rows in the order of their stamps; equal stamps in the order of the file."""
    found = list(blocks)
    if found:
        whole = joined(found)
        yield whole.take(np.argsort(whole.stamps, kind="stable"))


def _checked(blocks: Iterator[Block], reading: Reading) -> Iterator[JointTrajectory]:
    """The rows as trajectories in rad, each beginning later than the one before ends."""
    last: int | None = None
    for found in blocks:
        torque_only = _torque_only(found)
        if torque_only.any() and not reading.options.drop:
            row = int(found.rows[torque_only.argmax()])
            raise reading.error(row, f"{TORQUE_ONLY}, or leave such {reading.row_name}s out (--drop)")
        block = _without_bad_rows(found, last, reading) if reading.options.drop else found
        if not len(block.rows):
            continue
        if last is not None and block.stamps[0] <= last:
            raise falling_stamp(reading.source(block.rows), 0, int(block.stamps[0]), last)
        yield _in_rad(block.trajectory(reading), reading.options)
        last = int(block.stamps[-1])


def _without_bad_rows(block: Block, last: int | None, reading: Reading) -> Block:
    """The rows that a trajectory may have: known positions and velocities, rising stamps."""
    torque_only = _torque_only(block)
    reading.leave_out(TORQUE_ONLY, int(torque_only.sum()))
    block = block.take(~torque_only)
    known = np.ones(len(block.rows), dtype=bool)
    for kind, values in block.values.items():
        bad = np.isinf(values) if kind == "effort" else ~np.isfinite(values)
        known &= ~bad.any(axis=1)
    known &= block.stamps >= 0
    reading.leave_out("a number is not finite, or a stamp negative", int((~known).sum()))
    block = block.take(known)
    latest = np.maximum.accumulate(np.concatenate([[-1 if last is None else last], block.stamps]))[:-1]
    rising = block.stamps > latest
    reading.leave_out("the stamp is not later than those before", int((~rising).sum()))
    return block.take(rising)


def _torque_only(block: Block) -> NDArray[np.bool_]:
    """Which rows (n,) have efforts and no position at all."""
    efforts = block.values.get("effort")
    if efforts is None:
        return np.zeros(len(block.rows), dtype=np.bool_)
    return np.logical_and(
        np.isnan(block.values["position"]).all(axis=1), np.isfinite(efforts).any(axis=1), dtype=np.bool_
    )


def _in_rad(trajectory: JointTrajectory, options: ReadOptions) -> JointTrajectory:
    """The trajectory in rad, on the joints of the map if there is one.

    Raises:
        QuadrupedError: if the numbers look like degrees and nobody said what they are.
    """
    if options.degrees:
        trajectory = trajectory.from_degrees()
    if options.joint_map is not None:
        trajectory = trajectory.retarget(options.joint_map)
    if options.degrees is None:
        size = np.abs(trajectory.positions)
        if size.max() > SUSPICIOUS:
            row, column = np.argwhere(size > SUSPICIOUS)[0]
            value = trajectory.positions[row, column]
            mark = f"; if it stands for no value, name it in the map (missing = {value:g})" if options.columns else ""
            raise QuadrupedError(
                f"{trajectory.source.row(row)}, position.{trajectory.names[column]}: "
                f"{value:g} rad is more than two turns: these may be degrees. Say so "
                f'(--degrees, or unit = "deg" in a map) to have them converted, or that they are rad (--radians){mark}'
            )
    return trajectory
