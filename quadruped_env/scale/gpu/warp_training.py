"""A training on a GPU: the task on MuJoCo Warp, PPO of rsl-rl, and the same run directory as on the CPU."""

import io
from pathlib import Path
from typing import Any, Final

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training.sb3_models import check_finite, resuming

# isort: split
import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import MissingExtraError
from quadruped_env.policies import Policy
from quadruped_env.policies.sb3 import linear_layers, symmetrized
from quadruped_env.task import TaskConfig
from quadruped_env.training.group import ALONE, Group
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import RSL_FILE
from quadruped_env.training.schedules import Schedule
from quadruped_env.training.step_statistics import StepStatistics
from quadruped_env.training.train import Trainer
from quadruped_env.training.train_config import WARP_DEVICES, TrainConfig, on_gpu
from quadruped_env.training.training_recorder import Recorder

try:
    import torch

    from quadruped_env.scale.gpu.warp_env import WarpVecEnv
    from quadruped_env.scale.gpu.warp_ppo import make_ppo
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("--device cuda", "gpu") from error


class WarpModel:
    """A training's networks and its place in the schedules, with the attributes that a `Recorder` reads.

    Args:
        config: settings of the training.
        env: the envs, of several ranks this one's share.
        group: this rank.
    """

    def __init__(self, config: TrainConfig, env: WarpVecEnv, group: Group = ALONE) -> None:
        self.config, self._env, self._group = config, env, group
        self.ppo = make_ppo(config, env, group)
        self.num_timesteps = 0
        self.learning_rate = Schedule(config)
        self.logger: Any = None

    def get_env(self) -> WarpVecEnv:
        """The envs."""
        return self._env

    def set_logger(self, logger: Any) -> None:
        """Set the logger of the progress, of Stable-Baselines3."""
        self.logger = logger

    def learn(self, total_timesteps: int, callback: Any, reset_num_timesteps: bool = True) -> None:
        """Train for a number of steps, or until the callback, such as a `StepStatistics`, stops it; as SB3's `learn`.

        Raises:
            DifferentWeightsError: if the weights of the ranks differ after an update.
        """
        ppo, env, config = self.ppo, self._env, self.config
        first = self.num_timesteps
        callback.init_callback(self)
        callback.on_training_start({}, {})
        observations = env.get_observations()
        ppo.train_mode()
        while self.num_timesteps - first < total_timesteps:
            self._follow_schedules()
            with torch.no_grad():
                for _ in range(config.n_steps):
                    observations, rewards, done, extras = env.step(ppo.act(observations))
                    ppo.process_env_step(observations, rewards, done, extras)
                    self.num_timesteps += env.num_envs * self._group.ranks
                    if not callback.on_step():
                        return
                ppo.compute_returns(observations)
            callback.on_rollout_end()
            if callback.ended:
                return
            ppo.update()
            if self._group.ranks > 1:
                self._group.check_same(ppo.parameters(), f"after {self.num_timesteps:,} steps")

    def _follow_schedules(self) -> None:
        """Set the bound of the exploration and the learning rate for the share of the budget that is left."""
        actor: Any = self.ppo.actor
        actor.distribution.log_std_param.data.clamp_(max=self.learning_rate.log_std_bound)
        for group in self.ppo.optimizer.param_groups:
            group["lr"] = self.learning_rate()

    def save(self, file: io.BytesIO) -> None:
        """Write the networks and the optimizer's state."""
        torch.save(self.ppo.save(), file)

    def go_on_from(self, parent: Parent) -> None:
        """Take over a run's networks, optimizer, step count and place in the schedules.

        Raises:
            QuadrupedError: if its file cannot be read.
        """
        path = parent.directory / RSL_FILE
        with resuming(path):
            state = torch.load(path, map_location=self._env.device, weights_only=True)
            check_finite(state)
            self.ppo.load(state, None, strict=True)
        self.num_timesteps = parent.timesteps
        self.learning_rate.go_on(parent.timesteps, parent.budget_left)

    def policy(self, task: TaskConfig, card: dict[str, Any]) -> Policy:
        """The deterministic part of the policy as plain arrays."""
        actor: Any = self.ppo.actor
        layers, activation = linear_layers(actor.mlp)
        if self.config.symmetric:
            layers = symmetrized(layers, MirrorMap.of(self._env.task.control.layout))
        return Policy.for_task(
            weights=tuple(weight for weight, _ in layers),
            biases=tuple(bias for _, bias in layers),
            activation=activation,
            config=task,
            card=card,
        )


class WarpStatistics(StepStatistics):
    """`StepStatistics` of a `WarpVecEnv`; between rollouts nothing is copied to the host."""

    _env: Any

    def _clear(self) -> None:
        super()._clear()
        self._clear_device()

    def _clear_device(self) -> None:
        like = self._task.simulation.sensordata
        self._squares: Any = np.zeros(2, like=like)
        self._terms: Any = np.zeros(len(self._task.term_names), like=like)
        self._falls_before = float(self._env.falls[0])

    def _on_step(self) -> bool:
        error = self._task.tracking_error
        self._squares += (error * error).mean(axis=0)
        self._terms += self._env.last_terms.mean(axis=0)
        self._steps += 1
        # A rank that ends within a rollout would leave the others waiting.
        return self._group.ranks > 1 or not self._over()

    def _exchange(self) -> None:
        self._own[:] = np.concatenate([np.ravel(part) for part in self._device_sums()])
        self._clear_device()
        super()._exchange()

    @property
    def sums(self) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
        """See `StepStatistics.sums`."""
        return self._device_sums() if self._group.ranks == 1 else super().sums

    def _device_sums(self) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
        return self._squares.numpy(), self._terms.numpy(), float(self._env.falls[0]) - self._falls_before


class WarpRecorder(Recorder, WarpStatistics):
    """Watches a training on a GPU."""

    resume_file = RSL_FILE

    def _policy(self, card: dict[str, Any]) -> Policy:
        model: Any = self.model
        return model.policy(self._task_config, card)


class WarpTrainer(Trainer):
    """Trains with MuJoCo Warp and rsl-rl."""

    recorder = WarpRecorder
    statistics = WarpStatistics

    def make(self, config: TrainConfig, task_file: Path | None, group: Group, threads: int) -> tuple[Any, Any]:
        """See `Trainer.make`."""
        task = task_config(config.action_mode, config.task, task_file)
        device = device_of(config.device, group)
        if group.rank == 0:
            print(
                f"MuJoCo Warp loads its kernels for {device}; once per machine it compiles them, which takes minutes",
                flush=True,
            )
        share = config.num_envs // group.ranks
        env = WarpVecEnv(task, share, device, config.seed + group.rank * share, config.asymmetric_critic)
        if group.ranks > 1 and on_gpu(config.device):
            torch.cuda.set_device(env.device)  # on which NCCL synchronizes
        return env, WarpModel(config, env, group)

    def go_on_from(self, model: Any, parent: Parent) -> None:
        """See `Trainer.go_on_from`."""
        model.go_on_from(parent)


ON_WARP: Final = WarpTrainer()


def device_of(device: str, group: Group) -> str:
    """Warp's name of the device of a rank: of several ranks on GPUs, each has the GPU with its index.

    Args:
        device: as `--device`.
        group: the rank.
    """
    if group.ranks == 1 or not on_gpu(device):
        return WARP_DEVICES.get(device, device)
    return f"cuda:{group.local_rank}"
