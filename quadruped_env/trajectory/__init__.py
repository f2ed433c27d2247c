"""Recorded joint states: the trajectory type, and loading and saving it in any format.

What is here is imported when it is first used: a robot's controller takes the checks of recordings, and no reader.
"""

import importlib
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from quadruped_env.trajectory.column_map import ColumnMap
    from quadruped_env.trajectory.interpolation import Gap
    from quadruped_env.trajectory.joint_map import JointMap, JointRule
    from quadruped_env.trajectory.joint_trajectory import JointTrajectory
    from quadruped_env.trajectory.reading import ReadOptions
    from quadruped_env.trajectory.rows import JointState

__all__ = ["ColumnMap", "Gap", "JointMap", "JointRule", "JointState", "JointTrajectory", "ReadOptions"]

_DEFINED_IN: Final = {
    "ColumnMap": "column_map",
    "Gap": "interpolation",
    "JointMap": "joint_map",
    "JointRule": "joint_map",
    "JointState": "rows",
    "JointTrajectory": "joint_trajectory",
    "ReadOptions": "reading",
}


def __getattr__(name: str) -> Any:
    if name in _DEFINED_IN:
        return getattr(importlib.import_module(f"{__name__}.{_DEFINED_IN[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
