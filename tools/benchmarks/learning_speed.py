"""Learning speed: wall-clock time from the start of learning until the policy meets most of its commands.

The commands are those that the suite draws, one undisturbed episode of 10 s each, with the suite's tolerance. The time
of these tests is not counted.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.evaluation.measures import reached
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.policies import Policy
from quadruped_env.task import TaskConfig
from quadruped_env.training.sb3_models import make_model
from quadruped_env.training.schedules import Scheduled
from quadruped_env.training.train_config import TrainConfig

MET: Final = 0.8
"""Share of the commands from which a policy has learned its task."""


@dataclass(frozen=True)
class CommandTest:
    """One test of a policy."""

    met: float
    """Share of the commands that it meets"""
    falls: float
    """Share of the episodes that end in a fall"""

    @property
    def passed(self) -> bool:
        """True if the policy has learned its task, as this module defines it."""
        return self.met >= MET


def command_test(policy: Policy, commands: int | None = None, seconds: float | None = None) -> CommandTest:
    """Test a policy, at all commands of the suite's map or the first of them."""
    part = full_suite().commands
    drawn = list(part.drawn)[:commands]
    measured = Candidate.of_policy(policy, "policy")
    rollout = measured.run(drawn, part.seeds[:1], part.seconds if seconds is None else seconds)
    met = reached(rollout, drawn, part.tolerance).met
    return CommandTest(float(met.mean()), float(rollout.fallen.mean()))


@dataclass(frozen=True)
class Learned:
    """Result of the training with one seed."""

    action_mode: str
    seed: int
    seconds: float | None
    """Wall-clock time of learning until the policy passed the test, s; None if it never did"""
    timesteps: int
    """Time steps until then, or in total"""
    last: CommandTest


def time_to_learn(
    action_mode: str, seed: int, limit: float, interval: float, say: Callable[[str], None], **training: Any
) -> Learned:
    """Train until the policy passes the test, or for `limit` s; it is tested every `interval` s of learning."""
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
    passed = watch.last.passed
    return Learned(action_mode, seed, watch.learning if passed else None, model.num_timesteps, watch.last)


class _Watch(Scheduled):
    """Callback that tests the policy at intervals and stops when it passes or the time limit is reached."""

    def __init__(
        self, config: TrainConfig, task: TaskConfig, limit: float, interval: float, say: Callable[[str], None]
    ) -> None:
        super().__init__()
        self._task, self._activation = task, config.activation
        self._limit, self._interval, self._say = limit, interval, say
        self.learning = 0.0
        self.last: CommandTest | None = None

    def _on_training_start(self) -> None:
        super()._on_training_start()
        self._resumed = time.perf_counter()
        self._next = self._interval

    def _on_step(self) -> bool:
        return not (self.last is not None and (self.last.passed or self.learning >= self._limit))

    def _on_rollout_start(self) -> None:
        super()._on_rollout_start()
        now = self.learning + time.perf_counter() - self._resumed
        if now < self._next:
            return
        self.learning = now
        self._next = now + self._interval
        self.last = command_test(Policy.from_sb3(self.model, {}))
        self._say(
            f"  {self.learning:5.1f} s, {self.num_timesteps:>9,} steps: {self.last.met:.0%} of the commands met, "
            f"{self.last.falls:.1%} falls"
        )
        self._resumed = time.perf_counter()


def summary(results: list[Learned]) -> str:
    """Return a Markdown table of the seeds of each action mode; a seed that never passed counts as infinitely slow."""
    lines = ["| action mode | seeds that learn | median s | each seed, s | median steps |", "|---|---|---|---|---|"]
    for mode in dict.fromkeys(result.action_mode for result in results):
        found = [result for result in results if result.action_mode == mode]
        seconds = sorted(np.inf if result.seconds is None else result.seconds for result in found)
        steps = sorted(result.timesteps for result in found)
        passed = sum(result.seconds is not None for result in found)
        each = ", ".join("never" if np.isinf(value) else f"{value:.1f}" for value in seconds)
        lines.append(
            f"| {mode} | {passed} of {len(found)} | {np.median(seconds):.1f} | {each} | {np.median(steps):,.0f} |"
        )
    return "\n".join(lines)
