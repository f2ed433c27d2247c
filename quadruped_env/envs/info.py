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

    def state(self) -> dict[str, NDArray[Any]]:
        """The live arrays (N, ...) that `readings` describes."""
        task = self._task
        tiles = task.tiles
        return {
            **({} if tiles is None else {"terrain_kind": tiles.kind, "terrain_level": tiles.level}),
            "command": task.command,
            "sensordata": task.simulation.sensordata[:, : self._width],
        }

    def readings(self, state: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
        """Entries that describe the state of the robots, as views where possible.

        Args:
            state: copies of the arrays of `state()`, of all envs, with entries (N, ...), or of one.
        """
        # One copy, with a view per reading, is cheaper than a copy per reading.
        values = state.pop("sensordata")
        for entry, columns in self._columns.items():
            state[entry] = values[..., columns]
        state["foot_contact"] = state["foot_force"] > self._task.context.contact_threshold
        return state

    def step_results(self, diverged: NDArray[np.bool_], terms: NDArray[np.float64]) -> dict[str, NDArray[Any]]:
        """Entries that only a step has, (N,) each: `diverged`, and the weighted reward terms (N, T)."""
        return {"diverged": diverged, **dict(zip(self._task.reward_keys, terms.T, strict=True))}
