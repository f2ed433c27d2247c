"""Simulation of many robots, on `mujoco.batch.Batch` and its thread pool."""

from collections.abc import Callable
from typing import Final

import mujoco
import numpy as np
from mujoco.batch import Batch, SimulationError
from numpy.typing import NDArray

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.motors import fill_command_history
from quadruped_env.robot.readings import Readings, sensor_columns
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.simulation.simulation_interface import DIVERGENCE_WARNINGS, SETTLED, SimulationState, restored
from quadruped_env.utils.arrays import Floats

_WARNING_COUNT = 1
_DISABLE: Final = mujoco.mjtDisableBit
_NO_FORCES: Final = int(_DISABLE.mjDSBL_CONSTRAINT) | int(_DISABLE.mjDSBL_SPRING) | int(_DISABLE.mjDSBL_DAMPER)


class BatchSimulation:
    """`Simulation` with many envs.

    A number of threads, the calling one included, steps them; 0 uses every core. The results do not depend on it.
    """

    def __init__(
        self, model: mujoco.MjModel, num_envs: int, num_threads: int = 0, robot: Robot = MINI_QUADRUPED
    ) -> None:
        self.model = model
        self.robot = robot
        self.height_field = HeightField.of(model)
        self.num_envs = num_envs
        self._num_threads = num_threads
        # A persistent batch would not compute positions and velocities twice, at the end of a control step and in the
        # next one. But it has an MjData per env, and loading these into the caches takes longer.
        self.batch = Batch(model, num_envs, num_threads)
        self._disableflags = self.batch.expand("opt.disableflags")
        self._switched_off = 0
        self._initial = self.batch.state[0].copy()
        self._computed = self.batch.bind("sensordata")
        self._sensordata = np.zeros_like(self._computed)
        self.sensordata = self._sensordata.view()
        self.sensordata.flags.writeable = False
        self.readings = Readings.from_sensordata(model, self.sensordata, robot)
        self._record(0)
        self._qpos = self.batch.bind("qpos")
        self._qvel = self.batch.bind("qvel")
        self._ctrl = self.batch.bind("ctrl")
        self._history = self.batch.bind("history")
        self._external = self.batch.bind("xfrc_applied")
        self._base = model.body(robot.base_name).id
        self._warnings = self.batch.warning[:, DIVERGENCE_WARNINGS, _WARNING_COUNT]
        self._failed = np.zeros(num_envs, dtype=np.bool_)
        self._varied_fields: set[str] = set()
        forces = np.repeat(model.sensor_needstage == int(mujoco.mjtStage.mjSTAGE_ACC), model.sensor_dim)
        self._force_columns, self._other_columns = _slices(forces), _slices(~forces)
        self.sensor_columns = sensor_columns(model, robot)

    def step(self, joint_target: Floats, substeps: int, env_ids: NDArray[np.intp] | None = None) -> None:
        """See `Simulation.step`."""
        if substeps != len(self._recorded):
            self._record(substeps)
        if env_ids is not None and not len(env_ids):
            return
        self._ctrl[:] = joint_target
        rows = slice(None) if env_ids is None else env_ids
        self._switch_off(0)
        for recorded in self._recorded:
            self._try(self.batch.step, env_ids)
            recorded[rows] = self._computed[rows]
        self._read(self._force_columns, env_ids)
        # Positions and velocities do not depend on forces, and finding contacts would take as long again.
        self._switch_off(_NO_FORCES)
        self._try(self.batch.forward, env_ids, stage=SETTLED)
        self._read(self._other_columns, env_ids)

    def _record(self, substeps: int) -> None:
        """Make room for the readings of a number of physics steps."""
        self._recorded = np.zeros((substeps, *self._computed.shape))
        self.substeps = Readings.from_sensordata(self.model, self._recorded, self.robot)

    def _switch_off(self, parts: int) -> None:
        """Switch off parts of MuJoCo, besides those that the model switches off: the bits of `disableflags`."""
        if parts != self._switched_off:
            self._disableflags[:] = self.model.opt.disableflags | parts
            self._switched_off = parts

    def _try(self, call: Callable[..., None], env_ids: NDArray[np.intp] | None, **arguments: int) -> None:
        """Call a method of the batch for some envs (R,), or all, and note those in which it failed."""
        try:
            call(env_ids, **arguments)
        except SimulationError as error:
            self._failed[error.ids] = True

    def _read(self, columns: list[slice], env_ids: NDArray[np.intp] | None) -> None:
        """Copy columns of what the sensors of some envs (R,), or all, have read in the last call."""
        rows = slice(None) if env_ids is None else env_ids
        for some in columns:
            self._sensordata[rows, some] = self._computed[rows, some]

    def reset(self, env_ids: NDArray[np.intp], qpos: Floats, qvel: Floats) -> None:
        """See `Simulation.reset`."""
        self._clear(env_ids)
        self._qpos[env_ids] = qpos
        self._qvel[env_ids] = qvel
        self._ctrl[env_ids] = qpos[:, 7:]
        if self.model.nhistory:
            history = self._history[env_ids]
            fill_command_history(self.model, history, qpos[:, 7:])
            self._history[env_ids] = history
        self._switch_off(0)
        if not all(np.count_nonzero(np.abs(start) <= mujoco.mjMAXVAL) == start.size for start in (qpos, qvel)):
            self.batch.forward(env_ids, stage=SETTLED)  # reports and replaces a bad start; the next line does not
        self.batch.forward(env_ids)
        self._sensordata[env_ids] = self._computed[env_ids]

    def _clear(self, env_ids: NDArray[np.intp]) -> None:
        """Reset to the model's defaults, update constants that depend on its fields, clear the divergence flags."""
        if self._varied_fields:
            self.batch.set_const(env_ids)
        # All that the batch's `reset` does if a `forward` follows, in a tenth of the time.
        self.batch.state[env_ids] = self._initial
        self.batch.warning[env_ids] = 0
        self._failed[env_ids] = False

    def diverged(self) -> NDArray[np.bool_]:
        """See `Simulation.diverged`."""
        if not np.count_nonzero(self._warnings):
            return self._failed.copy()
        return self._warnings.any(axis=1) | self._failed

    def push(self, env_ids: NDArray[np.intp], velocity: Floats) -> None:
        """See `Simulation.push`."""
        self._qvel[env_ids, : velocity.shape[1]] += velocity

    def set_force(self, env_ids: NDArray[np.intp], force: Floats) -> None:
        """See `Simulation.set_force`."""
        self._external[env_ids, self._base, :3] = force

    def model_field(self, name: str) -> Floats:
        """See `Simulation.model_field`."""
        self._varied_fields.add(name)
        return self.batch.expand(name)

    def compiled_field(self, name: str) -> Floats:
        """See `Simulation.compiled_field`."""
        return getattr(self.model, name)

    def field_values(self, name: str) -> Floats:
        """See `Simulation.field_values`."""
        return self.batch.expand(name) if name in self._varied_fields else getattr(self.model, name)[None]

    def restore_model_fields(self, env_ids: NDArray[np.intp]) -> None:
        """See `Simulation.restore_model_fields`."""
        for name in self._varied_fields:
            self.batch.expand(name)[env_ids] = getattr(self.model, name)

    def get_state(self, env_id: int) -> SimulationState:
        """See `Simulation.get_state`."""
        fields = {name: self.batch.expand(name)[env_id].copy() for name in sorted(self._varied_fields)}
        return SimulationState(
            self.batch.state[env_id].copy(), self.sensordata[env_id].copy(), bool(self.diverged()[env_id]), fields
        )

    def set_state(self, env_id: int, state: SimulationState) -> None:
        """See `Simulation.set_state`."""
        for name, values in state.model_fields.items():
            self.model_field(name)[env_id] = values
        self._clear(np.array([env_id]))
        self.batch.state[env_id] = state.integration
        self._sensordata[env_id] = state.readings
        self._failed[env_id] = state.diverged

    def __reduce__(self) -> tuple[object, ...]:
        # A batch and its threads do not support pickling.
        arguments = self.model, self.num_envs, self._num_threads, self.robot
        return restored, (type(self), arguments, [self.get_state(env_id) for env_id in range(self.num_envs)])

    def copy_data(self, env_id: int) -> mujoco.MjData:
        """A copy of the MuJoCo data of one env, for rendering."""
        data, model = self.batch.get_data(env_id), self.model
        if self._varied_fields:
            model = self.batch.get_model(env_id)
            model.opt.disableflags = self.model.opt.disableflags
        mujoco.mj_forward(model, data)
        return data


def _slices(mask: NDArray[np.bool_]) -> list[slice]:
    """Slices of the columns where a mask (W,) is true."""
    ends = np.flatnonzero(np.diff(mask, prepend=False, append=False))
    return [slice(start, stop) for start, stop in ends.reshape(-1, 2).tolist()]
