"""From one file of joint states to another, piece by piece, with an account of what was in it."""

from array import array
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory import formats, saving
from quadruped_env.trajectory.bag_writer import Piece
from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.reading import Progress, ReadOptions
from quadruped_env.trajectory.saving import WriteOptions
from quadruped_env.trajectory.signals import NANOSECONDS, Gap, find_gaps

Change = Callable[[JointTrajectory], JointTrajectory]

_GAPS_SHOWN: Final = 5


@dataclass(frozen=True)
class Account:
    """What a recording holds."""

    rows: int
    names: tuple[str, ...]
    kinds: tuple[str, ...]
    seconds: float
    """From the first stamp to the last"""
    rate: float
    """Hz, by the usual (median) time between rows; NaN for one row"""
    gaps: tuple[Gap, ...]
    remarks: tuple[str, ...]
    """What was left out, damage, and which rows were salvaged without a checksum"""
    unchecked_rows: int = 0
    """Rows of the source that were salvaged and that no checksum covers: damage in their numbers would not show"""

    def text(self) -> str:
        """The account for people."""
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
        source: the file that is read.
        target: the file that is written, whose name says its format.
        reading: how the source is read.
        writing: how the target is written.
        change: what to make of the whole trajectory on the way.
        progress: is told the share that is done.

    Returns:
        What was written.

    Raises:
        QuadrupedError: if one cannot be read or the other cannot be written; then nothing is written.
        MissingExtraError: if a format needs libraries that are not installed.
    """
    saving.check(target, writing)
    if target.exists() and source.exists() and target.samefile(source):
        raise QuadrupedError(f"{target}: is the file that is read; name another place")
    teller = _Teller()
    stream = formats.stream(source, reading, progress)
    if change is None:
        saving.save(teller.listen(stream), target, writing)
    else:
        changed = change(formats.joined_pieces(source, stream))
        saving.save(teller.listen(piece for piece, _ in saving.pieces_of(changed)), target, writing)
    return teller.account(stream)


class _Teller:
    """Listens to pieces on their way, and remembers what an account needs."""

    def __init__(self) -> None:
        self._stamps = array("q")
        self._names: tuple[str, ...] = ()
        self._kinds: tuple[str, ...] = ()

    def listen(self, pieces: Iterator[JointTrajectory] | formats.Stream) -> Iterator[Piece]:
        """The pieces, as they come."""
        for piece in pieces:
            self._stamps.frombytes(piece.stamps.tobytes())
            self._names, self._kinds = piece.names, piece.kinds
            yield piece, None

    def account(self, stream: formats.Stream) -> Account:
        """What came from a stream."""
        stamps: NDArray[np.int64] = np.frombuffer(self._stamps, np.int64)
        rate = NANOSECONDS / float(np.median(np.diff(stamps))) if len(stamps) > 1 else float("nan")
        seconds = float(stamps[-1] - stamps[0]) / NANOSECONDS
        gaps = find_gaps(stamps)
        return Account(
            len(stamps), self._names, self._kinds, seconds, rate, gaps, stream.remarks(), stream.unchecked_rows
        )
