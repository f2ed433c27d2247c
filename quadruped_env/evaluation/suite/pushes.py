"""Pushes: doing what was asked after a push of six components, and survival of horizontal ones by direction."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import percentile_interval, proportion
from quadruped_env.evaluation.measures import masked_mean, meets, stands_still
from quadruped_env.evaluation.rollout import BeforeStep, Rollout
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Pushes
from quadruped_env.task import Task
from quadruped_env.utils.progress import Progress, part_of
from quadruped_env.utils.rotations import yaw

Floats = NDArray[np.float64]

RESAMPLES = 2_000
_HALF = 0.5


def run(part: Pushes, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Pushes of six components under every command, and survival of horizontal ones by size and direction."""
    seeds = len(part.sizes) * part.num_seeds
    episodes = range(part.first_seed, part.first_seed + seeds)
    size = np.tile(np.repeat(part.sizes, part.num_seeds), len(part.commands))
    drawn = [push_of(part, seed) for seed in episodes] * len(part.commands)
    velocity = size[:, None] * np.array([velocity for _, velocity in drawn])
    times = np.array([time for time, _ in drawn])
    done = part_of(progress, 0.0, 0.5)
    rollout = measured.run(part.commands, episodes, part.before[1] + part.after, done, before_step=_at(times, velocity))
    return {
        **obeyed(part, rollout),
        "horizontal": _horizontal(part, measured, part_of(progress, 0.5, 1.0)),
    }


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


def _horizontal(part: Pushes, measured: MeasuredController, progress: Progress | None) -> dict[str, Any]:
    """Survival of horizontal pushes under the first command, by size and direction."""
    grid = np.meshgrid(part.horizontal_sizes, np.radians(part.directions), indexing="ij")
    size, angle = (np.repeat(values.ravel(), part.horizontal_seeds) for values in grid)

    def push(task: Task, step: int) -> None:
        if step == round(part.before[0] / task.control.config.timestep):
            pushed = np.flatnonzero(size > 0.0)
            direction = yaw(task.simulation.readings.orientation[pushed]) + angle[pushed]
            velocity = np.zeros((len(pushed), 6))
            velocity[:, 0], velocity[:, 1] = size[pushed] * np.cos(direction), size[pushed] * np.sin(direction)
            task.simulation.push(pushed, velocity)

    conditions = len(part.horizontal_sizes) * len(part.directions)
    seeds = range(part.first_seed, part.first_seed + part.horizontal_seeds)
    rollout = measured.run(
        [part.commands[0]] * conditions, seeds, part.before[0] + part.after, progress, before_step=push
    )
    shape = len(part.horizontal_sizes), len(part.directions), part.horizontal_seeds
    return survival(part, ~rollout.fallen.reshape(shape))


def survival(part: Pushes, survived: NDArray[np.bool_]) -> dict[str, Any]:
    """Survival by size and direction, and the size of 50 % survival per direction, as plain values.

    `survived` is True for episodes without a fall (sizes, directions, seeds).
    """
    sizes = np.array(part.horizontal_sizes)
    return {
        "sizes": sizes.tolist(),
        "directions": list(part.directions),
        "survived": survived.mean(axis=-1).tolist(),
        "by_size": [proportion(episodes).to_dict() for episodes in survived],
        "half_survival": [half_survival(sizes, survived[:, i]) for i in range(len(part.directions))],
    }


def half_survival(sizes: Floats, survived: NDArray[np.bool_]) -> dict[str, Any]:
    """Size of the push that half of the robots survive, with its bootstrap interval over the seeds, m/s.

    Survival is fitted by a function that does not increase with the size (isotonic regression), and interpolated
    linearly between the increasing sizes (K,). If more than half survive the largest push, the value is that size and
    `censored` is true. `survived` is (K, S); a seed has the same start for all sizes.
    """
    generator = np.random.default_rng(0)
    chosen = generator.integers(0, survived.shape[1], (RESAMPLES, survived.shape[1]))
    resampled = survived.T[chosen].mean(axis=1)  # (RESAMPLES, K)
    low, high = percentile_interval(half_point(sizes, resampled))
    all_seeds = survived.mean(axis=1)[None]
    censored = bool(non_increasing(all_seeds)[0, -1] >= _HALF)
    return {"mean": float(half_point(sizes, all_seeds)[0]), "low": low, "high": high, "censored": censored}


def non_increasing(shares: Floats) -> Floats:
    """Isotonic regression of each line (R, K): the closest values, by squares, that do not increase along the line.

    By the min-max formula (Robertson, Wright & Dykstra 1988, Order Restricted Statistical Inference, section 1.4):
    the value at k is the maximum over b >= k of the minimum over a <= k of the mean from a to b.
    """
    count = shares.shape[1]
    total = np.concatenate([np.zeros((len(shares), 1)), np.cumsum(shares, axis=1)], axis=1)
    begin, end = np.arange(count)[:, None], np.arange(count)[None, :]
    length = np.maximum(end - begin + 1, 1)
    means = (total[:, None, 1:] - total[:, :-1, None]) / length  # from a to b
    fitted = np.empty_like(shares)
    for k in range(count):
        fitted[:, k] = means[:, : k + 1, k:].min(axis=1).max(axis=1)
    return fitted


def half_point(sizes: Floats, shares: Floats) -> Floats:
    """Size (R,) at which the fitted survival (R, K) falls to one half; the largest size if it does not."""
    fitted = non_increasing(shares)
    below = fitted < _HALF
    first = below.argmax(axis=1)
    previous, lines = np.maximum(first - 1, 0), np.arange(len(fitted))
    high, low = fitted[lines, previous], fitted[lines, first]
    drop = np.where(high > low, high - low, 1.0)
    crossing = sizes[previous] + (sizes[first] - sizes[previous]) * (high - _HALF) / drop
    return np.where(below.any(axis=1), np.where(first == 0, sizes[0], crossing), sizes[-1])
