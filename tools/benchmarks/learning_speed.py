"""Learning speed: wall-clock time from the start of learning until the policy walks.

A policy walks if, with a command of 0.5 m/s straight ahead, deterministic actions and 64 episodes of 10 s that differ
in their starts alone, it falls at most twice, its mean forward speed is within 0.05 m/s of the command, and the mean
over episodes of the absolute mean yaw rate is at most 0.1 rad/s. The time of these tests is not counted.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import Policy, PolicyController
from quadruped_env.task import TaskConfig
from quadruped_env.training.sb3_models import make_model
from quadruped_env.training.schedules import Scheduled
from quadruped_env.training.train_config import TrainConfig

COMMAND: Final = (0.5, 0.0)
EPISODES: Final = 64
SECONDS: Final = 10.0
MAX_FALLS: Final = 2
SPEED_TOLERANCE: Final = 0.05
MAX_YAW_RATE: Final = 0.1


@dataclass(frozen=True)
class WalkTest:
    """One test of a policy."""

    falls: int
    speed: float
    """Mean forward speed until a fall, m/s"""
    yaw_rate: float
    """Mean over episodes of the absolute mean yaw rate, rad/s"""

    @property
    def walks(self) -> bool:
        """True if the policy walks, as this module defines it."""
        return (
            self.falls <= MAX_FALLS
            and abs(self.speed - COMMAND[0]) <= SPEED_TOLERANCE
            and self.yaw_rate <= MAX_YAW_RATE
        )


def walk_test(policy: Policy, episodes: int = EPISODES, seconds: float = SECONDS) -> WalkTest:
    """Test a policy."""
    rollout = roll_out(
        PolicyController(policy),
        [COMMAND],
        range(FIRST_SEED, FIRST_SEED + episodes),
        seconds,
        policy.config.randomized("none"),
    )
    counts = np.maximum(rollout.valid.sum(axis=0), 1)
    speed, yaw_rate = ((rollout.velocity * rollout.valid[..., None]).sum(axis=0) / counts[:, None]).T
    return WalkTest(int(rollout.fallen.sum()), float(speed.mean()), float(np.abs(yaw_rate).mean()))


@dataclass(frozen=True)
class Learned:
    """Result of the training with one seed."""

    action_mode: str
    seed: int
    seconds: float | None
    """Wall-clock time of learning until the policy walked, s; None if it never did"""
    timesteps: int
    """Time steps until the policy walked, or in total"""
    last: WalkTest


def time_to_walk(
    action_mode: str, seed: int, limit: float, interval: float, say: Callable[[str], None], **training: Any
) -> Learned:
    """Train until the policy walks, or for `limit` s; the policy is tested every `interval` s of learning."""
    config = TrainConfig(**{"action_mode": action_mode, "seed": seed, **training})
    env = make_sb3_vec_env(
        config.num_envs,
        seed=seed,
        action_mode=action_mode,
        config=config.task,
        privileged=config.asymmetric_critic,
    )
    model = make_model(config, env)
    watch = _Watch(config, env.task.config, limit, interval, say)
    model.learn(config.timesteps, callback=watch)
    env.close()
    assert watch.last is not None
    walked = watch.last.walks
    return Learned(action_mode, seed, watch.learning if walked else None, model.num_timesteps, watch.last)


class _Watch(Scheduled):
    """Callback that tests the policy at intervals and stops when it walks or the time limit is reached."""

    def __init__(
        self, config: TrainConfig, task: TaskConfig, limit: float, interval: float, say: Callable[[str], None]
    ) -> None:
        super().__init__()
        self._task, self._activation = task, config.activation
        self._limit, self._interval, self._say = limit, interval, say
        self.learning = 0.0
        self.last: WalkTest | None = None

    def _on_training_start(self) -> None:
        super()._on_training_start()
        self._resumed = time.perf_counter()
        self._next = self._interval

    def _on_step(self) -> bool:
        return not (self.last is not None and (self.last.walks or self.learning >= self._limit))

    def _on_rollout_start(self) -> None:
        super()._on_rollout_start()
        now = self.learning + time.perf_counter() - self._resumed
        if now < self._next:
            return
        self.learning = now
        self._next = now + self._interval
        self.last = walk_test(Policy.from_sb3(self.model, {}))
        self._say(
            f"  {self.learning:5.1f} s, {self.num_timesteps:>9,} steps: {self.last.speed:+.3f} m/s, "
            f"yaw {self.last.yaw_rate:.3f} rad/s, {self.last.falls} falls{', walks' if self.last.walks else ''}"
        )
        self._resumed = time.perf_counter()


def summary(results: list[Learned]) -> str:
    """A Markdown table of the seeds of each action mode; a seed that never walked counts as infinitely slow."""
    lines = ["| action mode | seeds that walk | median s | each seed, s | median steps |", "|---|---|---|---|---|"]
    for mode in dict.fromkeys(result.action_mode for result in results):
        found = [result for result in results if result.action_mode == mode]
        seconds = sorted(np.inf if result.seconds is None else result.seconds for result in found)
        steps = sorted(result.timesteps for result in found)
        walked = sum(result.seconds is not None for result in found)
        each = ", ".join("never" if np.isinf(value) else f"{value:.1f}" for value in seconds)
        lines.append(
            f"| {mode} | {walked} of {len(found)} | {np.median(seconds):.1f} | {each} | {np.median(steps):,.0f} |"
        )
    return "\n".join(lines)
