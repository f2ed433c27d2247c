"""Speed and memory of the task and of training on MuJoCo Warp, and the time until a policy walks."""

import resource
import time
from dataclasses import dataclass
from typing import Any, Final

import torch
import warp

from benchmarks.learning_speed import CommandTest, command_test
from benchmarks.measures import Say
from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.scale.gpu.warp_env import WarpVecEnv
from quadruped_env.scale.gpu.warp_training import WarpModel
from quadruped_env.task import TaskConfig
from quadruped_env.training.train_config import GPU_DEFAULTS, WARP_DEVICES, TrainConfig

GOALS: Final = {"env": 1e6, "training": 4e5}
"""Steps per second to reach on a GPU of a data centre, at the best number of envs."""
_STEPS: Final = 10**12
"""More environment steps than any training takes that a `Watch` ends."""


@dataclass(frozen=True)
class Speed:
    """Measurements at one number of envs."""

    num_envs: int
    env_steps: float
    """Environment steps per second with random actions, resets included."""
    training_steps: float
    """Environment steps per second of a training with PPO."""
    memory: float
    """Memory in use, GB: of the GPU, or of this process."""
    compilation: float
    """Time until the first step and the first update were done, s: kernels are compiled or loaded."""


@dataclass(frozen=True)
class Walked:
    """Result of a training until the policy walks."""

    num_envs: int
    seconds: float | None
    """Wall-clock time of learning without compilation and tests, s; None if the policy did not walk in the limit."""
    timesteps: int
    last: CommandTest | None


class Watch:
    """Watches a training without a run directory: stops it after some updates, a time, or when the policy walks.

    Args:
        updates: number of updates; 0: no limit.
        seconds: time of learning, s.
        interval: time between tests of the policy, s; 0: it is not tested.
        say: receives a line after each test.
    """

    def __init__(self, updates: int, seconds: float, interval: float, say: Say) -> None:
        self._updates, self._limit, self._interval, self._say = updates, seconds, interval, say
        self.model: WarpModel | None = None
        self.learning = 0.0
        self.rollouts = 0
        self.ended = False
        self.last: CommandTest | None = None

    def init_callback(self, model: WarpModel) -> None:
        """See `WarpModel.learn`."""
        self.model = model

    def on_training_start(self, local_names: dict[str, Any], global_names: dict[str, Any]) -> None:
        """See `WarpModel.learn`."""
        self._resumed, self._next = time.perf_counter(), self._interval

    def on_step(self) -> bool:
        """False if the training is to end."""
        done = self.last is not None and self.last.passed
        enough = self._updates > 0 and self.rollouts > self._updates
        return not (done or enough or self.learning >= self._limit)

    def on_rollout_end(self) -> None:
        """Test the policy if it is time."""
        self.rollouts += 1
        _synchronize()
        self.learning += time.perf_counter() - self._resumed
        assert self.model is not None
        if self._interval and self.learning >= self._next:
            self._next = self.learning + self._interval
            task: TaskConfig = self.model.get_env().task.config
            self.last = command_test(self.model.policy(task, {}))
            self._say(
                f"  {self.learning:6.1f} s, {self.model.num_timesteps:>11,} steps: {self.last.met:.0%} met, "
                f"{self.last.falls:.1%} falls"
            )
        self._resumed = time.perf_counter()


def _synchronize() -> None:
    if torch.cuda.is_available():
        torch.cuda.synchronize()


def make(device: str, num_envs: int, steps: int, **settings: Any) -> WarpModel:
    """A fresh training of the default task."""
    own = {"device": device, "num_envs": num_envs, "n_steps": steps, "batch_size": max(2, num_envs * steps // 4)}
    config = TrainConfig(**{**own, **settings})
    task = task_config(config.action_mode, config.task)
    return WarpModel(config, WarpVecEnv(task, num_envs, WARP_DEVICES.get(device, device), 0, config.asymmetric_critic))


def measure(device: str, num_envs: int, steps: int, updates: int, say: Say = print) -> Speed:
    """Speed and memory at one number of envs.

    Args:
        device: as `--device` of a training.
        num_envs: number of envs.
        steps: control steps of each env in an update, and in the measurement of the environment.
        updates: number of updates that are measured.
        say: receives the progress.
    """
    start = time.perf_counter()
    model = make(device, num_envs, steps)
    env = model.get_env()
    actions = 2.0 * torch.rand((num_envs, env.num_actions), device=env.device) - 1.0
    env.step(actions)
    watch = Watch(1, 1e9, 0.0, say)
    model.learn(_STEPS, watch)
    _synchronize()
    compilation = time.perf_counter() - start

    start = time.perf_counter()
    for _ in range(steps):
        env.step(actions)
    _synchronize()
    env_speed = num_envs * steps / (time.perf_counter() - start)

    watch, before = Watch(updates, 1e9, 0.0, say), model.num_timesteps
    model.ppo.storage.clear()
    start = time.perf_counter()
    model.learn(_STEPS, watch)
    _synchronize()
    training_speed = (model.num_timesteps - before) / (time.perf_counter() - start)
    model.ppo.storage.clear()
    speed = Speed(num_envs, env_speed, training_speed, _memory(env.device), compilation)
    say(
        f"{num_envs} envs: {env_speed:,.0f} environment steps/s, {training_speed:,.0f} training steps/s, "
        f"{speed.memory:.2f} GB"
    )
    return speed


def _memory(device: str) -> float:
    if device.startswith("cuda"):
        found = warp.device_from_torch(torch.device(device))
        return (found.total_memory - found.free_memory) / 1e9
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1e3 / 1e9


def walk(
    device: str, num_envs: int, steps: int, limit: float, interval: float, say: Say = print, **settings: Any
) -> Walked:
    """Train until the policy walks, as `tools/learning_speed.py` defines it, or for `limit` s of learning.

    The budget, which the schedules follow, is that of a GPU's default training. Kernels are compiled before.
    """
    settings = {"timesteps": GPU_DEFAULTS["timesteps"], **settings}
    warm_up = make(device, num_envs, steps, **settings)
    watch = Watch(1, limit, 0.0, say)
    warm_up.learn(_STEPS, watch)
    model = make(device, num_envs, steps, **settings)
    watch = Watch(0, limit, interval, say)
    model.learn(_STEPS, watch)
    walked = watch.last is not None and watch.last.passed
    return Walked(num_envs, watch.learning if walked else None, model.num_timesteps, watch.last)


def table(speeds: list[Speed]) -> str:
    """The measurements as a Markdown table."""
    lines = ["| envs | environment steps/s | training steps/s | memory, GB | compilation, s |", "|---|---|---|---|---|"]
    lines += [
        f"| {s.num_envs:,} | {s.env_steps:,.0f} | {s.training_steps:,.0f} | {s.memory:.2f} | {s.compilation:.0f} |"
        for s in speeds
    ]
    return "\n".join(lines)


def unreached(speeds: list[Speed]) -> list[str]:
    """Goals for a GPU that the best of the measurements does not reach, as lines."""
    best = {"env": max(s.env_steps for s in speeds), "training": max(s.training_steps for s in speeds)}
    return [f"{name} steps/s: {best[name]:,.0f}; goal {goal:,.0f}" for name, goal in GOALS.items() if best[name] < goal]


def check_counts(counts: list[int]) -> None:
    """Raise a QuadrupedError unless all numbers of envs are 1 or more."""
    for count in counts:
        if count < 1:
            raise QuadrupedError(f"--num-envs: expected 1 or more; found {count}")
