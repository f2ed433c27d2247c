"""Conversion of rows: degrees to rad, some of the joints, another robot's joints to this one's."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory.maps import JointMap
from quadruped_env.trajectory.rows import Rows

_IN_DEGREES: Final = ("position", "velocity")
"""Kinds that contain an angle."""


def from_degrees(rows: Rows) -> Rows:
    """The rows in rad and rad/s, for rows in degrees and degrees/s."""
    return replace(
        rows, values={kind: np.radians(array) if kind in _IN_DEGREES else array for kind, array in rows.values.items()}
    )


def select(rows: Rows, names: Sequence[str], recording: str) -> Rows:
    """The rows of some joints, in their order.

    Args:
        rows: of these joints and others.
        names: joints to keep.
        recording: name of the recording in errors.

    Raises:
        QuadrupedError: if the recording lacks a joint.
    """
    for name in names:
        if name not in rows.names:
            raise QuadrupedError(
                f"{recording}: joint {name!r} is missing; all {len(names)} are needed, and it has "
                f"{', '.join(rows.names)}; add its positions, or map another robot's joints (--map)"
            )
    order = [rows.names.index(name) for name in names]
    return replace(rows, names=tuple(names), values={kind: array[:, order] for kind, array in rows.values.items()})


def retarget(rows: Rows, joint_map: JointMap, recording: str) -> Rows:
    """The rows on the joints of a map: see `JointMap.to_joints`.

    Args:
        rows: of the other robot.
        joint_map: converts its joints.
        recording: name of the recording in errors.

    Raises:
        QuadrupedError: if the recording lacks a joint that the map names as a source.
    """
    return replace(rows, names=tuple(joint_map.rules), values=joint_map.to_joints(rows.names, rows.values, recording))
