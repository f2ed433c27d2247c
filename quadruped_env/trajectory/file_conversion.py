"""Conversion of a file of joint states to another format, piece by piece, with an account of its content."""

from array import array
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory import saving
from quadruped_env.trajectory.interpolation import Gap, find_gaps
from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.loading import Stream
from quadruped_env.trajectory.read_options import ReadOptions
from quadruped_env.trajectory.rows import ARRAYS, Rows
from quadruped_env.trajectory.saving import WriteOptions
from quadruped_env.utils.progress import Progress

Change = Callable[[JointTrajectory], JointTrajectory]

_GAPS_SHOWN: Final = 5


@dataclass(frozen=True)
class Account:
    """Content of a recording."""

    rows: int
    names: tuple[str, ...]
    kinds: tuple[str, ...]
    """Arrays that were recorded, of `positions`, `velocities` and `efforts`"""
    seconds: float
    """Time from the first timestamp to the last"""
    rate: float
    """Hz, from the median time between rows; NaN for one row"""
    gaps: tuple[Gap, ...]
    remarks: tuple[str, ...]
    """Rows that were left out, damage, and rows that were salvaged without a checksum"""
    unchecked_rows: int = 0
    """Number of salvaged rows of the source that no checksum covers: damage in their numbers would not show"""

    def text(self) -> str:
        """The account as text, one fact per line."""
        lines = [
            f"{self.rows} rows over {self.seconds:.3f} s, usually at {self.rate:.4g} Hz: {', '.join(self.kinds)}",
            f"{len(self.names)} joints: {', '.join(self.names)}",
        ]
        lines += [f"gap of {gap.seconds:.3f} s at {gap.start:.3f} s" for gap in self.gaps[:_GAPS_SHOWN]]
        if len(self.gaps) > _GAPS_SHOWN:
            longest = max(gap.seconds for gap in self.gaps)
            lines.append(f"... {len(self.gaps)} gaps in all, the longest {longest:.3f} s")
        return "\n".join([*lines, *self.remarks])


def convert(
    source: Path,
    target: Path,
    reading: ReadOptions,
    writing: WriteOptions,
    change: Change | None = None,
    progress: Progress | None = None,
) -> Account:
    """Read a file and write another, each of any format.

    Memory does not grow with the length of the recording, unless it is to be sorted or changed.

    Args:
        source: file to read.
        target: file to write; its name determines the format.
        reading: options for reading.
        writing: options for writing.
        change: called with the whole trajectory; returns the one to write.
        progress: called with the fraction read.

    Returns:
        The content of the target.

    Raises:
        QuadrupedError: if one cannot be read or the other cannot be written; then nothing is written.
        MissingExtraError: if a format needs libraries that are not installed.
    """
    saving.check(target, writing)
    if target.exists() and source.exists() and target.samefile(source):
        raise QuadrupedError(f"{target}: is the file that is read; name another place")
    stream = Stream(source, reading, progress)
    pieces: Iterable[Rows] = stream
    if change is not None:
        pieces = saving.in_pieces(change(JointTrajectory.from_stream(stream)).to_rows())
    stamps = array("q")
    names: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()

    def observed() -> Iterator[Rows]:
        nonlocal names, kinds
        for piece in pieces:
            stamps.frombytes(piece.stamps.tobytes())
            names, kinds = piece.names, tuple(ARRAYS[kind] for kind in piece.values)
            yield piece

    saving.save(observed(), target, writing)
    times: NDArray[np.int64] = np.frombuffer(stamps, np.int64)
    rate = NS_PER_SECOND / float(np.median(np.diff(times))) if len(times) > 1 else float("nan")
    if stream.without_efforts:
        kinds = tuple(kind for kind in kinds if kind != ARRAYS["effort"])
    seconds = float(times[-1] - times[0]) / NS_PER_SECOND
    found = stream.reading
    return Account(len(times), names, kinds, seconds, rate, find_gaps(times), found.remarks(), found.unchecked_rows)
