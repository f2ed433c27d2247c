"""From trajectories to a file of any format that is written here: the name says which."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory import bag_writer, csv
from quadruped_env.trajectory.bag_writer import STORAGES, TF_RATE, BagOptions, Piece
from quadruped_env.trajectory.joint_trajectory import JointTrajectory

_CSV: Final = ".csv"
_ROWS_A_PIECE: Final = 4096


@dataclass(frozen=True)
class WriteOptions:
    """What `JointTrajectory.save` may be told; see there."""

    storage: str | None = None
    tf_rate: float = TF_RATE
    compress: bool = False
    overwrite: bool = False


def pieces_of(
    trajectory: JointTrajectory,
    base: NDArray[np.float64] | None = None,
    progress: Callable[[float], None] | None = None,
) -> Iterator[Piece]:
    """A trajectory in pieces, so that writing it takes little memory, while saying how far it is."""
    for start in range(0, len(trajectory), _ROWS_A_PIECE):
        rows = slice(start, start + _ROWS_A_PIECE)
        yield trajectory.rows(rows), None if base is None else base[rows]
        if progress is not None:
            progress(min(rows.stop / len(trajectory), 1.0))


def save(pieces: Iterable[Piece], path: Path, options: WriteOptions) -> None:
    """Write trajectories that follow each other, in full or not at all; see `JointTrajectory.save`.

    Raises:
        QuadrupedError: if the name or an option fits no format, the file is there already, or cannot be written.
    """
    check(path, options)
    following = iter(pieces)
    # Whatever is wrong with the beginning of a recording is known before anything is written.
    first = next(following)
    pieces = chain([first], following)
    if path.suffix.lower() == _CSV:
        csv.write((piece for piece, _ in pieces), path, options.overwrite)
    else:
        bag_writer.write(pieces, path, _bag_options(path, options), options.overwrite)


def check(path: Path, options: WriteOptions) -> None:
    """Raise a QuadrupedError if nothing can be written there so."""
    if path.suffix.lower() == _CSV:
        if options.storage is not None or options.compress:
            raise QuadrupedError(f"{path}: a CSV has no storage and is not compressed; name a bag, or leave that out")
        csv.check_target(path, options.overwrite)
        return
    _bag_options(path, options)
    bag_writer.check_target(path, options.overwrite)


def _bag_options(path: Path, options: WriteOptions) -> BagOptions:
    suffixes = {suffix: storage for storage, suffix in STORAGES.items()}
    if path.suffix and path.suffix not in suffixes:
        raise QuadrupedError(
            f"{path}: unknown ending {path.suffix!r}; a CSV ends in .csv, a bare storage file in "
            f"{' or '.join(suffixes)}, and a bag is a directory, named without an ending"
        )
    storage = suffixes.get(path.suffix, options.storage or "mcap")
    if options.storage not in {None, storage}:
        raise QuadrupedError(f"{path}: the ending is that of {storage}, and asked for is {options.storage}; change one")
    if path.suffix and options.compress and storage == "sqlite3":
        raise QuadrupedError(f"{path}: a bare sqlite3 file cannot be compressed; name a directory, or use mcap")
    return BagOptions(storage, options.tf_rate, options.compress)
