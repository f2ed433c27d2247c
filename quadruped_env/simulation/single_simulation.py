"""Simulation of one robot, on `MjData`; it supports pickling, copying and rendering."""

import copy

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.motors import fill_command_history
from quadruped_env.robot.readings import Readings, sensor_columns
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.simulation.simulation_interface import (
    DIVERGENCE_WARNINGS,
    STATE_SPEC,
    SimulationState,
    restored,
)
from quadruped_env.utils.arrays import Floats


class SingleSimulation:
    """`Simulation` with one env, to which alone the model belongs: steps and randomizations write to it."""

    num_envs = 1

    def __init__(self, model: mujoco.MjModel, robot: Robot = MINI_QUADRUPED) -> None:
        self.model = model
        self.robot = robot
        self.height_field = HeightField.of(model)
        self.data = mujoco.MjData(model)
        self._failed = False
        self._settled = False
        """True if the first half of the next step has been computed. It is outdated after a push or a changed field."""
        self._varied_fields: dict[str, Floats] = {}
        """Values of the fields before they were varied, by name."""
        self._base = model.body(robot.base_name).id
        self.sensor_columns = sensor_columns(model, robot)
        self.sensordata = self.data.sensordata[None]
        self.readings = Readings.from_sensordata(self.model, self.sensordata, self.robot)
        self._ctrl = self.data.ctrl
        self._warnings = self.data.warning.number[DIVERGENCE_WARNINGS]
        self._record(0)

    def _record(self, substeps: int) -> None:
        """Make room for the readings of a number of physics steps."""
        self._recorded = np.zeros((substeps, *self.sensordata.shape))
        self.substeps = Readings.from_sensordata(self.model, self._recorded, self.robot)

    def step(self, joint_target: Floats, substeps: int, env_ids: NDArray[np.intp] | None = None) -> None:
        """See `Simulation.step`."""
        if substeps != len(self._recorded):
            self._record(substeps)
        if env_ids is not None and not len(env_ids):
            return
        self._ctrl[:] = joint_target[0]
        model, data = self.model, self.data
        # The last call ended after the first half of a step (mj_step1), so that the second half comes first.
        finish_step = mujoco.mj_step2 if self._settled else mujoco.mj_step
        self._settled = False
        try:
            for recorded in self._recorded:
                finish_step(model, data)
                recorded[:] = self.sensordata
                mujoco.mj_step1(model, data)
                finish_step = mujoco.mj_step2
            self._settled = True
        except mujoco.FatalError:
            self._failed = True

    def reset(self, env_ids: NDArray[np.intp], qpos: Floats, qvel: Floats) -> None:
        """See `Simulation.reset`."""
        if not len(env_ids):
            return
        data = self.data
        self._clear()
        data.qpos = qpos[0]
        data.qvel = qvel[0]
        self._ctrl[:] = qpos[0, 7:]
        if self.model.nhistory:
            fill_command_history(self.model, data.history[None], qpos[:, 7:])
        mujoco.mj_checkPos(self.model, data)  # mj_forward does not check the start for NaN
        mujoco.mj_checkVel(self.model, data)
        mujoco.mj_forward(self.model, data)
        self._settled = True

    def _clear(self) -> None:
        """Reset to the model's defaults, update constants that depend on its fields, clear the divergence flags."""
        if self._varied_fields:
            mujoco.mj_setConst(self.model, self.data)
        mujoco.mj_resetData(self.model, self.data)
        self._failed = False

    def diverged(self) -> NDArray[np.bool_]:
        """See `Simulation.diverged`."""
        result = np.zeros(1, np.bool_)
        if self._failed or any(self._warnings.tolist()):
            result[0] = True
        return result

    def push(self, env_ids: NDArray[np.intp], velocity: Floats) -> None:
        """See `Simulation.push`."""
        if not len(env_ids):
            return
        self.data.qvel[: velocity.shape[1]] += velocity[0]
        self._settled = False

    def set_force(self, env_ids: NDArray[np.intp], force: Floats) -> None:
        """See `Simulation.set_force`."""
        if len(env_ids):
            self.data.xfrc_applied[self._base, :3] = force[0]

    def model_field(self, name: str) -> Floats:
        """See `Simulation.model_field`."""
        values: Floats = getattr(self.model, name)
        if name not in self._varied_fields:
            self._varied_fields[name] = values.copy()
        self._settled = False
        return values[None]

    def compiled_field(self, name: str) -> Floats:
        """See `Simulation.compiled_field`."""
        return self._varied_fields.get(name, getattr(self.model, name))

    def field_values(self, name: str) -> Floats:
        """See `Simulation.field_values`."""
        values: Floats = getattr(self.model, name)
        return values[None]

    def restore_model_fields(self, env_ids: NDArray[np.intp]) -> None:
        """See `Simulation.restore_model_fields`."""
        if len(env_ids):
            for name, values in self._varied_fields.items():
                getattr(self.model, name)[...] = values

    def get_state(self, env_id: int) -> SimulationState:
        """See `Simulation.get_state`."""
        integration = np.empty(mujoco.mj_stateSize(self.model, STATE_SPEC))
        mujoco.mj_getState(self.model, self.data, integration, STATE_SPEC)
        fields = {name: getattr(self.model, name).copy() for name in sorted(self._varied_fields)}
        return SimulationState(integration, self.data.sensordata.copy(), bool(self.diverged()[0]), fields)

    def set_state(self, env_id: int, state: SimulationState) -> None:
        """See `Simulation.set_state`."""
        for name, values in state.model_fields.items():
            self.model_field(name)[0] = values
        self._clear()
        mujoco.mj_setState(self.model, self.data, state.integration, STATE_SPEC)
        mujoco.mj_step1(self.model, self.data)
        # Those before a push, if there was one.
        self.data.sensordata = state.readings
        self._settled = False
        self._failed = state.diverged

    def __reduce__(self) -> tuple[object, ...]:
        model = copy.copy(self.model)
        for name, values in self._varied_fields.items():
            getattr(model, name)[...] = values
        return restored, (type(self), (model, self.robot), [self.get_state(0)])
