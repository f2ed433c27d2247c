"""Many robots at once, on `mujoco.batch.Batch` and its thread pool."""

from typing import Any

import mujoco
import numpy as np
from mujoco.batch import Batch, SimulationError
from numpy.typing import NDArray

from quadruped_env.robot.motors import fill_command_history
from quadruped_env.simulation.interface import DIVERGENCE_WARNINGS, SETTLED, SimulationState, force_columns
from quadruped_env.simulation.state import State

_WARNING_COUNT = 1


class BatchSimulation:
    """`Simulation` with many rows.

    Args:
        model: the robot on its ground.
        num_rows: how many of them.
        num_threads: threads that step them, the caller's included; 0 takes every core. The numbers do not depend
            on it.
    """

    def __init__(self, model: mujoco.MjModel, num_rows: int, num_threads: int = 0) -> None:
        self._make(model, num_rows, num_threads)

    def _make(self, model: mujoco.MjModel, num_rows: int, num_threads: int) -> None:
        self.model = model
        self.num_rows = num_rows
        self._num_threads = num_threads
        # Persistent: the next step goes on from the stages that the last one ended with, and they cost nothing.
        self.batch = Batch(model, num_rows, num_threads, persistent=True)
        self._sensordata = self.batch.bind("sensordata")
        self.state = State.from_sensordata(model, self._sensordata)
        self._qpos = self.batch.bind("qpos")
        self._qvel = self.batch.bind("qvel")
        self._ctrl = self.batch.bind("ctrl")
        self._history = self.batch.bind("history")
        self._warnings = self.batch.warning[:, DIVERGENCE_WARNINGS, _WARNING_COUNT]
        self._failed = np.zeros(num_rows, dtype=np.bool_)
        self._varied_fields: set[str] = set()
        self._force_columns = force_columns(model)

    def step(self, joint_target: NDArray[np.float64], substeps: int, rows: NDArray[np.intp] | None = None) -> None:
        """See `Simulation.step`."""
        if rows is not None and not len(rows):
            return
        self._ctrl[:] = joint_target
        try:
            self.batch.step(rows, nstep=substeps, stage=SETTLED)
        except SimulationError as error:
            self._failed[error.ids] = True

    def reset(self, rows: NDArray[np.intp], qpos: NDArray[np.float64], qvel: NDArray[np.float64]) -> None:
        """See `Simulation.reset`."""
        self._clear(rows)
        self._qpos[rows] = qpos
        self._qvel[rows] = qvel
        self._ctrl[rows] = qpos[:, 7:]
        if self.model.nhistory:
            history = self._history[rows]
            fill_command_history(self.model, history, qpos[:, 7:])
            self._history[rows] = history
        self.batch.forward(rows, stage=SETTLED)  # checks the start for numbers that are none; the next line does not
        self.batch.forward(rows)

    def _clear(self, rows: NDArray[np.intp]) -> None:
        """Back to the model's defaults, with the constants that follow from its fields; no divergence on record."""
        if self._varied_fields:
            self.batch.set_const(rows)
        self.batch.reset(rows, stage=mujoco.mjtStage.mjSTAGE_NONE)
        self._failed[rows] = False

    def diverged(self) -> NDArray[np.bool_]:
        """See `Simulation.diverged`."""
        return self._warnings.any(axis=1) | self._failed

    def push(self, rows: NDArray[np.intp], velocity: NDArray[np.float64]) -> None:
        """See `Simulation.push`."""
        self._qvel[rows, :3] += velocity
        before = self._sensordata[rows]
        self.batch.forward(rows, stage=SETTLED)
        # For a row whose state was just set, the batch still remembers the forces of another past.
        self._write_readings(rows, np.where(self._force_columns, before, self._sensordata[rows]))

    def model_field(self, name: str) -> NDArray[np.float64]:
        """See `Simulation.model_field`."""
        self._varied_fields.add(name)
        return self.batch.expand(name)

    def get_state(self, row: int) -> SimulationState:
        """See `Simulation.get_state`."""
        fields = {name: self.batch.expand(name)[row].copy() for name in sorted(self._varied_fields)}
        return SimulationState(
            self.batch.state[row].copy(), self._sensordata[row].copy(), bool(self.diverged()[row]), fields
        )

    def set_state(self, row: int, state: SimulationState) -> None:
        """See `Simulation.set_state`."""
        fields = {name: values[None] for name, values in state.model_fields.items()}
        self._restore(np.array([row]), state.integration, state.readings, np.array([state.diverged]), fields)

    def _restore(
        self,
        rows: NDArray[np.intp],
        integration: NDArray[np.float64],
        readings: NDArray[np.float64],
        diverged: NDArray[np.bool_],
        model_fields: dict[str, NDArray[np.float64]],
    ) -> None:
        for name, values in model_fields.items():
            self.model_field(name)[rows] = values
        self._clear(rows)
        self.batch.state[rows] = integration
        self.batch.forward(rows, stage=SETTLED)
        self._write_readings(rows, readings)
        self._failed[rows] = diverged

    def _write_readings(self, rows: NDArray[np.intp], readings: NDArray[np.float64]) -> None:
        # The batch hands its outputs out read-only because the next call overwrites them: until then, these are due.
        self._sensordata.flags.writeable = True
        self._sensordata[rows] = readings
        self._sensordata.flags.writeable = False

    def __getstate__(self) -> dict[str, Any]:
        # A batch and its threads do not pickle: a copy makes its own, and goes on from the state of every row.
        return {
            "model": self.model,
            "num_rows": self.num_rows,
            "num_threads": self._num_threads,
            "integration": self.batch.state.copy(),
            "readings": self._sensordata.copy(),
            "diverged": self.diverged(),
            "model_fields": {name: self.batch.expand(name).copy() for name in sorted(self._varied_fields)},
        }

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._make(state["model"], state["num_rows"], state["num_threads"])
        self._restore(
            np.arange(self.num_rows),
            state["integration"],
            state["readings"],
            state["diverged"],
            state["model_fields"],
        )

    def row_data(self, row: int) -> mujoco.MjData:
        """A copy of one row, to render it."""
        return self.batch.get_data(row)
