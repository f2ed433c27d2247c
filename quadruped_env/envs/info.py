"""Contents of `info`, shared by the single and the vector environment."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.task import Task

_READINGS: Final = {
    "base_position": "base_position",
    "base_linear_velocity": "linear_velocity_b",
    "base_angular_velocity": "angular_velocity_b",
    "joint_position": "joint_position",
    "joint_velocity": "joint_velocity",
    "joint_torque": "joint_torque",
    "foot_force": "foot_force",
}
"""Entries of `info`, and the field of `Readings` that each one holds."""


class Info:
    """Entries of `info` for the robots of a task.

    Args:
        task: the task.
    """

    def __init__(self, task: Task) -> None:
        self._task = task
        self._columns = {entry: task.simulation.sensor_columns[field] for entry, field in _READINGS.items()}
        self._width = max(columns.stop for columns in self._columns.values())

    def readings(
        self, env: int | slice = slice(None), only: NDArray[np.bool_] | None = None
    ) -> dict[str, NDArray[Any]]:
        """Entries that describe the state of one env, or with entries (N, ...) of all, as views of copies.

        Args:
            env: index of the env, or the slice of all.
            only: mask (N,) of the envs to describe; the entries of the others are zero. None: all.
        """
        task, tiles = self._task, self._task.tiles
        # One copy, with a view per reading, is cheaper than a copy per reading.
        values = task.simulation.sensordata[env, : self._width].copy()
        info: dict[str, NDArray[Any]] = {"command": task.control.command[env].copy()}
        if tiles is not None:
            info |= {"terrain_kind": tiles.kind[env].copy(), "terrain_level": tiles.level[env].copy()}
        if only is not None:
            for entry in (values, *info.values()):
                entry[~only] = 0
        for name, columns in self._columns.items():
            info[name] = values[..., columns]
        info["foot_contact"] = info["foot_force"] > task.context.contact_threshold
        return info

    def step_results(self, diverged: NDArray[np.bool_], terms: NDArray[np.float64]) -> dict[str, NDArray[Any]]:
        """Entries that only a step has, (N,) each: `diverged`, and the weighted reward terms (N, T)."""
        return {"diverged": diverged, **dict(zip(self._task.reward_keys, terms.T, strict=True))}
