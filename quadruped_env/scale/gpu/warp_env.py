"""rsl-rl's vector environment on a task that is simulated by MuJoCo Warp."""

from typing import Any

import numpy as np
import torch
from rsl_rl.env import VecEnv
from tensordict import TensorDict

from quadruped_env.envs import MAX_EPISODE_STEPS
from quadruped_env.scale.gpu.warp_simulation import WarpSimulation
from quadruped_env.task import Task, TaskConfig

OBSERVATION = "observation"
"""Group of the observations: what the policy sees."""
PRIVILEGED = "privileged"
"""Group of the privileged readings, which only the value function sees."""
FINAL = "final_observations"
"""Entry of the extras: observations after the step and before any reset."""
TIME_OUTS = "time_limit_reached"
"""Entry of the extras: mask (N,) of the envs whose episode the time limit ended. Not rsl-rl's `time_outs`, for which it
adds the value of the observation before the step."""


class WarpVecEnv(VecEnv):
    """N robots on a device; finished episodes begin again within the step.

    Args:
        config: config of the task, on level ground.
        num_envs: number of envs, N.
        device: Warp's name of the device.
        seed: seed of the first env; each further env has the next one.
        privileged: True for the group of privileged readings.

    Raises:
        QuadrupedError: if the device is not usable, or the task needs what a GPU does not simulate.
    """

    def __init__(self, config: TaskConfig, num_envs: int, device: str, seed: int, privileged: bool) -> None:
        simulation: Any = WarpSimulation(config.compiled_model(), num_envs, config.robot, device)
        self.task = task = Task(simulation, config, MAX_EPISODE_STEPS)
        self._privileged = task.privileged_readings() if privileged else None
        self.privileged_layout = None if self._privileged is None else self._privileged.layout
        """Columns of the privileged readings; None without them."""
        self.num_envs = num_envs
        self.num_actions = config.robot.num_joints
        self.max_episode_length = MAX_EPISODE_STEPS
        self.device = str(simulation.torch_device)
        self.cfg = config.to_dict()
        task.reset(np.arange(num_envs, like=simulation.sensordata), list(range(seed, seed + num_envs)))
        task.shorten_episodes()
        self.last_terms: Any = np.zeros((num_envs, len(task.term_names)), like=simulation.sensordata)
        """Weighted reward terms of the last step, (N, T)."""
        self.falls: Any = np.zeros(1, like=simulation.sensordata)
        """Number of falls since the start, (1,)."""

    @property
    def episode_length_buf(self) -> torch.Tensor:
        """Control steps since each env's reset, (N,)."""
        steps: Any = self.task.control.steps
        return steps.tensor

    def close(self) -> None:
        """As Stable-Baselines3's envs have it: there is nothing to free."""

    def get_observations(self) -> TensorDict:
        """Observations of all envs."""
        return self._groups(self.task.observe())

    def _groups(self, observation: Any) -> TensorDict:
        groups = {OBSERVATION: observation.tensor}
        if self._privileged is not None:
            readings: Any = self._privileged.values()
            groups[PRIVILEGED] = readings.tensor
        return TensorDict(groups, batch_size=[self.num_envs], device=self.device)

    def step(self, actions: torch.Tensor) -> tuple[TensorDict, torch.Tensor, torch.Tensor, dict[str, Any]]:
        """Advance every env by one control step with actions (N, J), and reset those whose episode has ended."""
        transition: Any = self.task.step(actions)
        self.last_terms = transition.terms
        self.falls += transition.terminated.sum()
        final = self._groups(transition.observation)
        time_outs: Any = transition.truncated & ~transition.terminated
        done: Any = self.task.finished.copy()
        env_ids: Any = np.flatnonzero(done)
        observations = final
        if len(env_ids):
            self.task.reset(env_ids)
            observations = self.get_observations()
        extras = {FINAL: final, TIME_OUTS: time_outs.tensor}
        return observations, transition.reward.tensor.float(), done.tensor, extras
