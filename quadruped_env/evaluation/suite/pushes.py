"""Survival of pushes over their size and direction."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import percentile_interval, proportion
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Pushes
from quadruped_env.task import Task
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.rotations import yaw

Floats = NDArray[np.float64]

RESAMPLES = 2_000
_HALF = 0.5


def run(part: Pushes, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Survival of every size and direction, as plain values."""
    size, angle = (values.ravel() for values in np.meshgrid(part.sizes, np.radians(part.directions), indexing="ij"))
    size, angle = (np.repeat(values, part.num_seeds) for values in (size, angle))

    def push(task: Task, step: int) -> None:
        if step == round(part.before / task.control.config.timestep):
            pushed = np.flatnonzero(size > 0.0)
            direction = yaw(task.simulation.readings.orientation[pushed]) + angle[pushed]
            velocity = np.stack([np.cos(direction), np.sin(direction), np.zeros(len(pushed))], axis=-1)
            task.simulation.push(pushed, size[pushed, None] * velocity)

    conditions = len(part.sizes) * len(part.directions)
    rollout = measured.run(
        [part.command] * conditions, part.seeds, part.before + part.after, progress, before_step=push
    )
    return summary(part, ~rollout.fallen.reshape(len(part.sizes), len(part.directions), part.num_seeds))


def summary(part: Pushes, survived: NDArray[np.bool_]) -> dict[str, Any]:
    """Survival by size and direction, and the size of 50 % survival per direction, as plain values.

    `survived` is True for episodes without a fall (sizes, directions, seeds).
    """
    return {
        "sizes": list(part.sizes),
        "directions": list(part.directions),
        "survived": survived.mean(axis=-1).tolist(),
        "by_size": [proportion(episodes).to_dict() for episodes in survived],
        "all": proportion(survived[np.array(part.sizes) > 0.0]).to_dict(),
        "half_survival": [half_survival(np.array(part.sizes), survived[:, i]) for i in range(len(part.directions))],
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
