"""Pushes of six components: following the command after them."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import proportion
from quadruped_env.evaluation.measures import masked_mean, meets, stands_still
from quadruped_env.evaluation.rollout import BeforeStep, Rollout
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Pushes
from quadruped_env.task import Task
from quadruped_env.utils.progress import Progress

Floats = NDArray[np.float64]


def run(part: Pushes, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Pushes of six components under every command."""
    seeds = len(part.sizes) * part.num_seeds
    episodes = range(part.first_seed, part.first_seed + seeds)
    size = np.tile(np.repeat(part.sizes, part.num_seeds), len(part.commands))
    drawn = [push_of(part, seed) for seed in episodes] * len(part.commands)
    velocity = size[:, None] * np.array([velocity for _, velocity in drawn])
    times = np.array([time for time, _ in drawn])
    seconds = part.before[1] + part.after
    return obeyed(part, measured.run(part.commands, episodes, seconds, progress, before_step=_at(times, velocity)))


def push_of(part: Pushes, seed: int) -> tuple[float, Floats]:
    """Time in s and direction of the push of an episode's seed: (6,) in the units of `part.unit`."""
    generator = np.random.default_rng(seed)
    direction = generator.standard_normal(6)
    return generator.uniform(*part.before), direction / np.linalg.norm(direction) * part.unit


def _at(times: Floats, velocity: Floats) -> BeforeStep:
    """Adds a velocity (N, 6) to the base of each robot at its time (N,), s."""

    def push(task: Task, step: int) -> None:
        now = np.flatnonzero(np.round(times / task.control.config.timestep) == step)
        if len(now):
            task.simulation.push(now, velocity[now])

    return push


def obeyed(part: Pushes, rollout: Rollout) -> dict[str, Any]:
    """Shares of the episodes that do what was asked after the push, and that do not fall, as plain values.

    Without a fall, the mean velocities over the last `final` seconds must be close to the command; under a command
    to stand, the robot must also stand still.
    """
    last = np.zeros_like(rollout.valid)
    last[len(last) - round(part.final / rollout.timestep) :] = True
    shape = len(part.commands), len(part.sizes), part.num_seeds
    command = np.repeat(part.commands, shape[1] * shape[2], axis=0)
    achieved, still = masked_mean(rollout.velocity, last), stands_still(rollout, last)
    good = meets(achieved, command, still, rollout.fallen, part.tolerance)
    moving = np.any(part.commands, axis=-1)
    good, survived = good.reshape(shape), ~rollout.fallen.reshape(shape)
    return {
        "obeyed": proportion(good).to_dict(),
        "moving": proportion(good[moving]).to_dict(),
        "standing": proportion(good[~moving]).to_dict(),
        "survived": proportion(survived).to_dict(),
        "commands": [
            {
                "command": list(wanted),
                "obeyed": [proportion(episodes).to_dict() for episodes in good[i]],
                "survived": survived[i].mean(axis=-1).tolist(),
            }
            for i, wanted in enumerate(part.commands)
        ],
    }
