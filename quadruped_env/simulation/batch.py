"""Many robots at once, on `mujoco.batch.Batch` and its thread pool."""

import mujoco
import numpy as np
from mujoco.batch import Batch, SimulationError
from numpy.typing import NDArray

from quadruped_env.simulation.interface import DIVERGENCE_WARNINGS, SETTLED, SimulationState
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
        self.model = model
        self.num_rows = num_rows
        # Persistent: the next step goes on from the stages that the last one ended with, and they cost nothing.
        self.batch = Batch(model, num_rows, num_threads, persistent=True)
        self._sensordata = self.batch.bind("sensordata")
        self.state = State.from_sensordata(model, self._sensordata)
        self._qpos = self.batch.bind("qpos")
        self._qvel = self.batch.bind("qvel")
        self._ctrl = self.batch.bind("ctrl")
        self._warnings = self.batch.warning[:, DIVERGENCE_WARNINGS, _WARNING_COUNT]
        self._failed = np.zeros(num_rows, dtype=np.bool_)
        self._model_varies = False

    def step(self, joint_target: NDArray[np.float64], substeps: int) -> None:
        """See `Simulation.step`."""
        self._ctrl[:] = joint_target
        try:
            self.batch.step(nstep=substeps, stage=SETTLED)
        except SimulationError as error:
            self._failed[error.ids] = True

    def reset(self, rows: NDArray[np.intp], qpos: NDArray[np.float64], qvel: NDArray[np.float64]) -> None:
        """See `Simulation.reset`."""
        if self._model_varies:
            self.batch.set_const(rows)
        self.batch.reset(rows, stage=mujoco.mjtStage.mjSTAGE_NONE)
        self._qpos[rows] = qpos
        self._qvel[rows] = qvel
        self._ctrl[rows] = qpos[:, 7:]
        self.batch.forward(rows)
        self._failed[rows] = False

    def diverged(self) -> NDArray[np.bool_]:
        """See `Simulation.diverged`."""
        return self._warnings.any(axis=1) | self._failed

    def push(self, rows: NDArray[np.intp], velocity: NDArray[np.float64]) -> None:
        """See `Simulation.push`."""
        self._qvel[rows, :3] += velocity
        self.batch.forward(rows, stage=SETTLED)

    def model_field(self, name: str) -> NDArray[np.float64]:
        """See `Simulation.model_field`."""
        self._model_varies = True
        return self.batch.expand(name)

    def get_state(self, row: int) -> SimulationState:
        """See `Simulation.get_state`."""
        return self.batch.state[row].copy(), self._sensordata[row].copy()

    def set_state(self, row: int, state: SimulationState) -> None:
        """See `Simulation.set_state`."""
        self.batch.state[row] = state[0]
        self.batch.forward(np.array([row]), stage=SETTLED)
        # The batch hands its outputs out read-only because the next call overwrites them: until then, these are due.
        self._sensordata.flags.writeable = True
        self._sensordata[row] = state[1]
        self._sensordata.flags.writeable = False

    def row_data(self, row: int) -> mujoco.MjData:
        """A copy of one row, to render it."""
        return self.batch.get_data(row)
