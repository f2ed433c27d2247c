"""Conversion of rows: degrees to rad, some of the joints, another robot's joints to this one's."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

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
    """The rows on the joints of a map; efforts of joints without a source are NaN.

    Args:
        rows: of the other robot.
        joint_map: converts its joints.
        recording: name of the recording in errors.

    Raises:
        QuadrupedError: if the recording lacks a joint that the map names as a source.
    """
    for joint, rule in joint_map.rules.items():
        if rule.source is not None and rule.source not in rows.names:
            raise QuadrupedError(
                f"{joint_map.name}: [joints.{joint}] source: {recording} has no joint {rule.source!r}; "
                f"it has {', '.join(rows.names)}"
            )
    rules = joint_map.rules.values()

    def of_sources(array: NDArray[np.float64], missing: float) -> NDArray[np.float64]:
        columns = [
            np.full(len(rows), missing) if rule.source is None else array[:, rows.names.index(rule.source)]
            for rule in rules
        ]
        return np.stack(columns, axis=1)

    def factors(name: str) -> NDArray[np.float64]:
        return np.array([getattr(rule, name) for rule in rules], dtype=np.float64)

    values = {"position": of_sources(rows.values["position"], 0.0) * factors("factor") + factors("offset_rad")}
    if "velocity" in rows.values:
        values["velocity"] = of_sources(rows.values["velocity"], 0.0) * factors("velocity_factor")
    if "effort" in rows.values:
        values["effort"] = of_sources(rows.values["effort"], np.nan) / factors("gear")
    return replace(rows, names=tuple(joint_map.rules), values=values)
