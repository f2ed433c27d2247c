"""Joint states as plain arrays: what readers and writers of all formats exchange."""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

ARRAYS: Final = {"position": "positions", "velocity": "velocities", "effort": "efforts"}
"""Kind of value, named as in ROS's message and in its order -> the array of a `JointTrajectory` that holds it."""
KINDS: Final = tuple(ARRAYS)

TORQUE_ONLY: Final = (
    "torque-only: efforts and no positions, and a joint state needs the position of every joint; record them too"
)
"""Why recordings of torque commands cannot be used, for error messages."""


@dataclass(frozen=True, eq=False)
class JointState:
    """One row of a trajectory: in ROS, a `sensor_msgs/JointState`."""

    stamp: int
    """ns"""
    names: tuple[str, ...]
    """(J,)"""
    position: NDArray[np.float64]
    """rad (J,)"""
    velocity: NDArray[np.float64] | None
    """rad/s (J,)"""
    effort: NDArray[np.float64] | None
    """N m (J,); NaN where it was not measured"""


@dataclass(frozen=True, eq=False)
class Source:
    """Origin of a trajectory's rows, for error messages."""

    name: str = "JointTrajectory"
    """A file, or the type for a trajectory made in memory"""
    row_name: str = "row"
    """The source's word for a row, such as `line` or `message`"""
    numbers: NDArray[np.int64] | None = None
    """The source's numbers of the rows (T,); None counts them from 0"""
    notes: tuple[str, ...] = ()
    """Remarks on the numbers: rows that were left out, damage, what is not plausible"""

    def row(self, index: int) -> str:
        """Name of a row, for error messages."""
        return f"{self.name}: {self.row_name} {index if self.numbers is None else int(self.numbers[index])}"


@dataclass(frozen=True, eq=False)
class Rows:
    """Consecutive joint states of a recording, not validated: see `validation.validate`."""

    numbers: NDArray[np.int64]
    """Line or message numbers in the file (n,)"""
    stamps: NDArray[np.int64]
    """Timestamps in ns (n,)"""
    names: tuple[str, ...]
    """Joints (J,)"""
    values: dict[str, NDArray[np.float64]]
    """Kind -> (n, J) in rad, rad/s or N m, in the order of `KINDS`; velocities and efforts only if recorded"""

    def __len__(self) -> int:
        return len(self.stamps)

    def take(self, index: Any) -> "Rows":
        """The rows that a NumPy index, mask or slice selects."""
        values = {kind: array[index] for kind, array in self.values.items()}
        return Rows(self.numbers[index], self.stamps[index], self.names, values)
