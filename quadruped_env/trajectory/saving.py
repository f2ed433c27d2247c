"""From rows to a file; its name determines the format."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED, Robot
from quadruped_env.trajectory.formats import bag_writer, project_csv
from quadruped_env.trajectory.formats.bag_writer import STORAGES, TF_RATE
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.files import check_free
from quadruped_env.utils.progress import Progress

_CSV: Final = ".csv"
_ROWS_PER_PIECE: Final = 4096


@dataclass(frozen=True)
class WriteOptions:
    """Options of `JointTrajectory.save`, which describes them."""

    storage: str | None = None
    tf_rate: float = TF_RATE
    compress: bool = False
    overwrite: bool = False
    robot: Robot = MINI_QUADRUPED

    def __post_init__(self) -> None:
        if self.storage is not None and self.storage not in STORAGES:
            raise QuadrupedError(f"storage: expected one of {', '.join(STORAGES)}; found {self.storage!r}")
        if not 0.0 <= self.tf_rate <= 1e6:
            raise QuadrupedError(f"tf_rate: expected 0 to 1e6 Hz; found {self.tf_rate!r}")


def in_pieces(rows: Rows, progress: Progress | None = None) -> Iterator[Rows]:
    """The rows in short pieces, so that writing them takes little memory; `progress` gets the fraction written."""
    for start in range(0, len(rows), _ROWS_PER_PIECE):
        stop = start + _ROWS_PER_PIECE
        yield rows.take(slice(start, stop))
        if progress is not None:
            progress(min(stop / len(rows), 1.0))


def save(pieces: Iterable[Rows], path: Path, options: WriteOptions) -> None:
    """Write valid rows, in full or not at all; see `JointTrajectory.save`.

    Raises:
        QuadrupedError: if the name or an option fits no format, the file exists and must not be overwritten, or it
            cannot be written.
        MissingExtraError: if a bag is to be written and the libraries for it are not installed.
    """
    check(path, options)
    following = iter(pieces)
    # Errors at the beginning of a recording come before anything is written.
    first = next(following)
    pieces = chain([first], following)
    if path.suffix.lower() == _CSV:
        project_csv.write(pieces, path, options.overwrite)
    else:
        storage = _storage(path, options)
        bag_writer.write(pieces, path, options.robot, storage, options.tf_rate, options.compress, options.overwrite)


def check(path: Path, options: WriteOptions) -> None:
    """Raise a QuadrupedError if the name and the options do not match, or something exists at the path."""
    if path.suffix.lower() == _CSV:
        if options.storage is not None or options.compress:
            raise QuadrupedError(
                f"{path}: a CSV has no storage and is not compressed; name a bag, or leave these options out"
            )
        check_free([path], options.overwrite)
        return
    _storage(path, options)
    bag_writer.check_target(path, options.overwrite)


def _storage(path: Path, options: WriteOptions) -> str:
    """Storage of a bag, from the ending of its path and the options."""
    suffixes = {suffix: storage for storage, suffix in STORAGES.items()}
    if path.suffix and path.suffix not in suffixes:
        raise QuadrupedError(
            f"{path}: unknown ending {path.suffix!r}; a CSV ends in .csv, a bare storage file in "
            f"{' or '.join(suffixes)}, and a bag is a directory, named without an ending"
        )
    storage = suffixes.get(path.suffix, options.storage or "mcap")
    if options.storage not in {None, storage}:
        raise QuadrupedError(
            f"{path}: the ending is that of {storage}, and the storage is to be {options.storage}; change one of them"
        )
    if path.suffix and options.compress and storage == "sqlite3":
        raise QuadrupedError(f"{path}: a bare sqlite3 file cannot be compressed; name a directory, or use mcap")
    return storage
