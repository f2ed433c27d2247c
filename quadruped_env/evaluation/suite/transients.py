"""Steps of the command: settling time, overshoot and stopping distance."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import bootstrap_mean, proportion
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Change, Transients
from quadruped_env.task import Task
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.rotations import yaw

Floats = NDArray[np.float64]


def run(part: Transients, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Measures of each change: name -> plain values."""
    seeds = part.num_seeds

    def change_commands(task: Task, step: int) -> None:
        if step == round(part.before / task.control.config.timestep):
            for i, change in enumerate(part.changes):
                task.set_command(np.arange(i * seeds, (i + 1) * seeds), change.then)

    rollout = measured.run(
        [change.first for change in part.changes],
        part.seeds,
        part.before + part.after,
        progress,
        before_step=change_commands,
        reached=[change.then for change in part.changes],
    )
    return {
        change.name: measures(rollout.select(np.arange(i * seeds, (i + 1) * seeds)), change, part)
        for i, change in enumerate(part.changes)
    }


def measures(rollout: Rollout, change: Change, part: Transients) -> dict[str, Any]:
    """Measures of the episodes of one change, as plain values.

    An episode that falls or does not follow the change counts with the longest settling time, that of the episode.
    """
    dt = rollout.timestep
    wanted = np.subtract(change.then, change.first)
    answers = [
        step_response(rollout.velocity[..., column], float(wanted[column]), part, dt, part.narrowest[column])
        for column in range(len(wanted))
        if wanted[column]
    ]
    followed = np.all([answer.followed for answer in answers], axis=0) & ~rollout.fallen
    settling = np.where(followed, np.max([answer.settling_time for answer in answers], axis=0), part.after)
    overshoot = np.where(followed, np.max([answer.overshoot for answer in answers], axis=0), np.nan)
    result = {
        "first": list(change.first),
        "then": list(change.then),
        "falls": proportion(rollout.fallen).to_dict(),
        "followed": proportion(followed).to_dict(),
        "settling_time": bootstrap_mean(settling).to_dict(),
        "overshoot": bootstrap_mean(overshoot).to_dict(),
        "score": float(np.where(followed, 1.0 - settling / part.after, 0.0).mean()),
    }
    if not any(change.then):
        result["stopping_distance"] = bootstrap_mean(
            np.where(rollout.fallen, np.nan, stopping_distance(rollout, part))
        ).to_dict()
    return result


@dataclass(frozen=True)
class StepResponse:
    """Measures of one velocity after a step of its command, for N episodes."""

    settling_time: Floats
    """Time from the change after which the velocity stays in the band around its final value, s (N,)"""
    overshoot: Floats
    """Largest excess over the final value, relative to the commanded change (N,)"""
    followed: NDArray[np.bool_]
    """True if the velocity changed by at least `followed_share` of the commanded change (N,)"""


def step_response(
    velocity: NDArray[Any], wanted: float, part: Transients, dt: float, narrowest: float = 0.0
) -> StepResponse:
    """Settling time and overshoot of a velocity (T, N) after a commanded change (`wanted`), in the same unit.

    The velocity is from `part.before` before the change to `part.after` after it, every `dt` seconds; the last half
    window counts only within the means before it. `narrowest` is the least half width of the band.
    """
    change, half, tail = (round(seconds / dt) for seconds in (part.before, 0.5 * part.window, part.final))
    smooth = centred_mean(velocity, half)
    before = smooth[change - half - tail : change - half].mean(axis=0)
    # Where the window is cut short, it lets the oscillation within a stride through.
    after = smooth[change : len(smooth) - half]
    final = after[len(after) - tail :].mean(axis=0)
    outside = np.abs(after - final) > max(part.band * abs(wanted), narrowest)
    # Sample i is the velocity (i + 1) control steps after the change.
    last = len(outside) - outside[::-1].argmax(axis=0)
    settling = np.where(outside[-1], part.after, np.where(outside.any(axis=0), last, 0) * dt)
    overshoot = np.maximum(((after - final) * np.sign(wanted)).max(axis=0), 0.0) / abs(wanted)
    return StepResponse(settling, overshoot, (final - before) * np.sign(wanted) >= part.followed_share * abs(wanted))


def centred_mean(values: NDArray[Any], half: int) -> Floats:
    """Means (T, N) over each sample, `half` samples before and `half` after it; shorter windows at both ends."""
    total = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0, dtype=np.float64)])
    index = np.arange(len(values))
    low, high = np.maximum(index - half, 0), np.minimum(index + half + 1, len(values))
    return (total[high] - total[low]) / (high - low).reshape(-1, *(1,) * (values.ndim - 1))


def stopping_distance(rollout: Rollout, part: Transients) -> Floats:
    """Distance from the position at the change to that at the end, along the heading at the change, m (N,)."""
    change = round(part.before / rollout.timestep) - 1
    heading = yaw(rollout.orientation[change])
    x, y = np.moveaxis((rollout.base_position[-1] - rollout.base_position[change]).astype(np.float64)[..., :2], -1, 0)
    return x * np.cos(heading) + y * np.sin(heading)
