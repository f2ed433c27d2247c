"""Joint states as plain arrays: what readers and writers of all formats exchange."""

from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
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
    base_pose: NDArray[np.float64] | None = None
    """Position in m and quaternion wxyz of `base_link` in `odom` (n, 7), if known; only bags keep it"""

    def __len__(self) -> int:
        return len(self.stamps)

    def take(self, index: Any) -> "Rows":
        """The rows that a NumPy index, mask or slice selects."""
        return Rows(
            self.numbers[index],
            self.stamps[index],
            self.names,
            {kind: array[index] for kind, array in self.values.items()},
            None if self.base_pose is None else self.base_pose[index],
        )

    def without(self, kinds: Collection[str]) -> "Rows":
        """The rows without values of these kinds."""
        return replace(self, values={kind: array for kind, array in self.values.items() if kind not in kinds})


def joined(parts: Iterable[Rows]) -> Rows:
    """The rows of all parts, at least one, which have the same joints and kinds; without their base poses."""
    rows: Rows | None = None
    for part in parts:
        if rows is None:
            values = {kind: array.copy() for kind, array in part.values.items()}
            rows = Rows(part.numbers.copy(), part.stamps.copy(), part.names, values)
            continue
        # Grown in place, so that the memory never holds a long recording twice.
        for array, more in zip(_arrays(rows), _arrays(part), strict=True):
            length = len(array)
            array.resize((length + len(more), *array.shape[1:]), refcheck=False)
            array[length:] = more
    assert rows is not None
    return rows


def _arrays(rows: Rows) -> list[NDArray[Any]]:
    return [rows.numbers, rows.stamps, *rows.values.values()]
