"""`BatchSimulation` with torch tensors in and out, so that a task on tensors can be compared with the one on arrays."""

import dataclasses

import numpy as np
import torch

from quadruped_env.robot.readings import Readings
from quadruped_env.scale.gpu.torch_arrays import TensorArray
from quadruped_env.simulation import BatchSimulation

EXACT = {"model", "robot", "height_field", "num_envs", "sensor_columns", "compiled_field"}
"""Attributes that are the same for both kinds of arrays."""


class TorchDriver:
    """A batch simulation behind tensors; its physics is MuJoCo's, so the two tasks see the same numbers."""

    def __init__(self, model, num_envs, robot):
        self.batch = BatchSimulation(model, num_envs, 1, robot)
        self.sensordata = TensorArray(torch.zeros(self.batch.sensordata.shape, dtype=torch.float64))
        self.readings = Readings.from_sensordata(model, self.sensordata, robot)

    def __getattr__(self, name):
        if name not in EXACT:
            raise AttributeError(name)
        return getattr(self.batch, name)

    def _update(self):
        self.sensordata[:] = self.batch.sensordata.copy()

    def step(self, joint_target, substeps, env_ids=None):
        self.batch.step(joint_target.numpy(), substeps, None if env_ids is None else env_ids.numpy())
        of_all = {f.name: getattr(self.batch.substeps, f.name).copy() for f in dataclasses.fields(Readings)}
        self.substeps = Readings(**{name: TensorArray(torch.tensor(values)) for name, values in of_all.items()})
        self._update()

    def reset(self, env_ids, qpos, qvel):
        self.batch.reset(env_ids.numpy(), qpos.numpy(), qvel.numpy())
        self._update()

    def diverged(self):
        return TensorArray(torch.tensor(self.batch.diverged()))

    def push(self, env_ids, velocity):
        self.batch.push(env_ids.numpy(), velocity.numpy())
        self._update()

    def set_force(self, env_ids, force):
        self.batch.set_force(env_ids.numpy(), force.numpy())

    def model_field(self, name):
        return TensorArray(torch.from_numpy(self.batch.model_field(name)))  # shares its memory

    def field_values(self, name):
        return np.asarray(np.array(self.batch.field_values(name)), like=self.sensordata)

    def restore_model_fields(self, env_ids):
        self.batch.restore_model_fields(env_ids.numpy())
