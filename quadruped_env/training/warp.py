"""A training on a GPU: the task on MuJoCo Warp, PPO of rsl-rl, and the same run directory as on the CPU."""

import copy
import io
import time
from contextlib import ExitStack
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training.models import LinearSchedule, linear_layers

# isort: split
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.files import unwritable
from quadruped_env.policies import Policy
from quadruped_env.seeds import check_training_seeds
from quadruped_env.task import BUILT_IN, TaskConfig, load_task_file
from quadruped_env.training.actor_critic import symmetrized
from quadruped_env.training.config import WARP_DEVICES, TrainConfig
from quadruped_env.training.ppo import Recorder, stop_on_signal
from quadruped_env.training.resume import Parent
from quadruped_env.training.run import RSL_FILE, Run, check_latest

try:
    import torch
    from stable_baselines3.common.logger import configure

    from quadruped_env.training.warp_env import WarpVecEnv
    from quadruped_env.training.warp_ppo import make_ppo
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("--device cuda", "gpu") from error


class Watcher(Protocol):
    """Object that watches a training and may end it, such as a `Recorder`."""

    def on_training_start(self, local_names: dict[str, Any], global_names: dict[str, Any]) -> None:
        """Called before the first step."""
        ...

    def on_step(self) -> bool:
        """Called after each control step of all envs; False ends the training."""
        ...

    def on_rollout_end(self) -> None:
        """Called before each update."""
        ...


class WarpModel:
    """A training's networks and its place in the schedules, with the attributes that a `Recorder` reads.

    Args:
        config: settings of the training.
        env: the envs.
    """

    def __init__(self, config: TrainConfig, env: WarpVecEnv) -> None:
        self._config, self._env = config, env
        self.ppo = make_ppo(config, env)
        self.num_timesteps = self._first = 0
        self.budget_left_at_start = 1.0
        self._learning_rate = LinearSchedule(config.learning_rate)
        self._log_std = (config.log_std_init, min(config.log_std_init, config.final_log_std))
        self._started = time.perf_counter()
        self.logger: Any = None

    def get_env(self) -> WarpVecEnv:
        """The envs."""
        return self._env

    def budget_left(self) -> float:
        """Share of the schedules that is left, from 1 at the start of a first training to 0."""
        if self._config.seconds is not None:
            used = (time.perf_counter() - self._started) / self._config.seconds
        else:
            used = (self.num_timesteps - self._first) / self._config.timesteps
        return self.budget_left_at_start * max(0.0, 1.0 - used)

    def learn(self, recorder: Watcher) -> None:
        """Train until the budget is used, or the recorder stops it."""
        ppo, env, config = self.ppo, self._env, self._config
        self._first, self._started = self.num_timesteps, time.perf_counter()
        recorder.on_training_start({}, {})
        observations = env.get_observations()
        ppo.train_mode()
        while config.seconds is not None or self.num_timesteps - self._first < config.timesteps:
            left = self.budget_left()
            first, final = self._log_std
            actor: Any = ppo.actor
            actor.distribution.log_std_param.data.clamp_(max=final + (first - final) * left)
            for group in ppo.optimizer.param_groups:
                group["lr"] = self._learning_rate(left)
            with torch.no_grad():
                for _ in range(config.n_steps):
                    observations, rewards, done, extras = env.step(ppo.act(observations))
                    ppo.process_env_step(observations, rewards, done, extras)
                    self.num_timesteps += env.num_envs
                    if not recorder.on_step():
                        return
                ppo.compute_returns(observations)
            recorder.on_rollout_end()
            ppo.update()

    def save(self, file: io.BytesIO) -> None:
        """Write the networks and the optimizer's state."""
        torch.save(self.ppo.save(), file)

    def go_on_from(self, parent: Parent) -> None:
        """Take over a run's networks, optimizer, step count and place in the schedules.

        Raises:
            QuadrupedError: if its file cannot be read.
        """
        path = parent.directory / RSL_FILE
        try:
            state = torch.load(path, map_location=self._env.device, weights_only=True)
            self.ppo.load(state, None, strict=True)
        except Exception as error:
            # Torch and rsl-rl each fail in their own way on a damaged file, and torch then advises to unpickle it.
            reason = type(error).__name__
            raise QuadrupedError(f"{path}: cannot be read ({reason}); start a new training") from error
        self.num_timesteps = parent.timesteps
        self.budget_left_at_start = parent.budget_left

    def policy(self, task: TaskConfig, card: dict[str, Any]) -> Policy:
        """The deterministic part of the policy as plain arrays."""
        actor: Any = self.ppo.actor
        layers = linear_layers(copy.deepcopy(actor.mlp).cpu(), self._config.activation)
        if self._config.symmetric:
            layers = symmetrized(layers, MirrorMap.of(self._env.task.control.layout))
        return Policy(
            weights=tuple(weight for weight, _ in layers),
            biases=tuple(bias for _, bias in layers),
            activation=self._config.activation,
            config=task,
            card=card,
        )


class WarpRecorder(Recorder):
    """Watches a training on a GPU; what it sums up stays on the device until it is logged."""

    resume_file = RSL_FILE

    def _clear(self) -> None:
        super()._clear()
        xp = self._task.simulation.xp
        self._squares, self._terms = xp.zeros(2), xp.zeros(len(self._task.term_names))
        self._falls_before = float(self._env.falls[0])

    def _on_step(self) -> bool:
        error = self._task.tracking_error
        self._squares += (error * error).mean(axis=0)
        self._terms += self._env.last_terms.mean(axis=0)
        self._steps += 1
        self.elapsed = time.perf_counter() - self._start
        return not self._over()

    @property
    def sums(self) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
        """See `StepStatistics.sums`."""
        xp = self._task.simulation.xp
        falls = float(self._env.falls[0]) - self._falls_before
        return xp.numpy(self._squares), xp.numpy(self._terms), falls

    def _policy(self, card: dict[str, Any]) -> Policy:
        model: Any = self.model
        return model.policy(self._task_config, card)


def train(
    config: TrainConfig, runs: Path, command: str, resume: Path | None = None, task_file: Path | None = None
) -> tuple[Path, bool]:
    """Train a policy on a GPU; see `quadruped_env.training.ppo.train`."""
    check_latest(runs)
    parent = None
    if resume is not None:
        parent = Parent.load(resume, BUILT_IN if task_file is None else load_task_file(task_file))
        parent.check(asdict(config))
        config = replace(config, task=parent.config.task)
    task = task_config(config.action_mode, config.task, task_file)
    check_training_seeds("config.terrain.seed", task.terrain["seed"])
    device = WARP_DEVICES.get(config.device, config.device)
    print(
        f"MuJoCo Warp loads its kernels for {device}; once per machine it compiles them, which takes minutes",
        flush=True,
    )
    env = WarpVecEnv(task, config.num_envs, device, config.seed, config.asymmetric_critic)
    model = WarpModel(config, env)
    if parent is None:
        run = Run(runs, config, task.to_dict(), command)
    else:
        model.go_on_from(parent)
        run = Run(runs, config, task.to_dict(), command, parent.facts(), parent.curve)
    recorder = WarpRecorder(run, config, task, 0.0 if parent is None else parent.seconds)
    recorder.init_callback(model)
    try:
        with ExitStack() as stack:
            stack.callback(run.close)
            model.logger = configure(str(run.directory / "tensorboard"), ["tensorboard"])
            stack.callback(recorder.finish)
            stack.callback(recorder.save)
            with stop_on_signal(recorder):
                model.learn(recorder)
    except (OSError, QuadrupedError) as error:
        cause = error if isinstance(error, QuadrupedError) else unwritable(run.directory, error)
        raise QuadrupedError(f"{cause}; what was saved before is kept in {run.directory}") from error
    return run.directory, not recorder.stopped
