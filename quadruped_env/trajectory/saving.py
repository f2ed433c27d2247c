"""From rows to a file; its name determines the format."""

from pathlib import Path
from typing import Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import Robot
from quadruped_env.trajectory.formats import bag_writer, project_csv
from quadruped_env.trajectory.formats.bag_writer import STORAGES
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.files import check_free

_CSV: Final = ".csv"


def save(rows: Rows, path: Path, robot: Robot, storage: str | None, base_pose: Floats | None, overwrite: bool) -> None:
    """Write valid rows, in full or not at all; see `JointTrajectory.save`."""
    check(path, overwrite, storage)
    if path.suffix.lower() == _CSV:
        project_csv.write(rows, path, overwrite)
    else:
        bag_writer.write(rows, path, robot, _storage(path, storage), base_pose, overwrite)


def check(path: Path, overwrite: bool, storage: str | None = None) -> None:
    """Raise a QuadrupedError if the name and the storage do not match, or something exists at the path."""
    if storage is not None and storage not in STORAGES:
        raise QuadrupedError(f"storage: expected one of {', '.join(STORAGES)}; found {storage!r}")
    if path.suffix.lower() != _CSV:
        _storage(path, storage)
        bag_writer.check_target(path, overwrite)
    elif storage is not None:
        raise QuadrupedError(f"{path}: a CSV has no storage; name a bag, or leave the storage out")
    else:
        check_free([path], overwrite)


def _storage(path: Path, given: str | None) -> str:
    """Return the storage of a bag, from the ending of its path and the one that was given."""
    suffixes = {suffix: storage for storage, suffix in STORAGES.items()}
    if path.suffix and path.suffix not in suffixes:
        raise QuadrupedError(
            f"{path}: unknown ending {path.suffix!r}; a CSV ends in .csv, a bare storage file in "
            f"{' or '.join(suffixes)}, and a bag is a directory, named without an ending"
        )
    storage = suffixes.get(path.suffix, given or "mcap")
    if given not in {None, storage}:
        raise QuadrupedError(
            f"{path}: the ending belongs to {storage}, and the storage is to be {given}; change one of them"
        )
    return storage
