"""Parts of the suite in which something changes while the robot moves: joystick commands, steps of them, and pushes."""

from collections.abc import Mapping
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import bootstrap_mean, mean_of, poisson_rate, proportion
from quadruped_env.evaluation.measures import reached
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite_definition import Change, Joystick, Pushes, Transients
from quadruped_env.task import Task
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.progress import Progress, part_of

_SECONDS_PER_HOUR: Final = 3600.0
_STANDING_WEIGHT: Final = 0.2
"""Share of a score that is lost by a robot that does not stand still."""


def run_joystick(part: Joystick, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure hours of changing commands under each law of disturbances: name -> plain values."""
    dt = candidate.config.control_timestep
    command = np.stack([schedule(part, seed, dt) for seed in part.seeds], axis=1)
    new = np.ones(command.shape[:2], np.bool_)
    new[1:] = (np.diff(command, axis=0) != 0.0).any(axis=-1)

    def change_commands(task: Task, step: int) -> None:
        if (changed := np.flatnonzero(new[step])).size:
            task.control.set_command(changed, command[step, changed])

    result: dict[str, Any] = {}
    for i, law in enumerate(part.laws):
        done = part_of(progress, i / len(part.laws), (i + 1) / len(part.laws))
        rollout = candidate.run(
            [(0.0, 0.0)], part.seeds, part.seconds, done, law.randomization, change_commands, part.rectangle
        )
        result[law.name] = joystick_measures(rollout, command, part)
    return {"laws": result, "contributions": joined(result)}


def joined(entries: Mapping[str, dict[str, Any]]) -> list[float]:
    """Take the contributions out of each of several entries, and return all of them."""
    return [value for entry in entries.values() for value in entry.pop("contributions")]


def schedule(part: Joystick, seed: int, dt: float) -> Floats:
    """Return the command in each control step of `dt` seconds (T, V) of the episode of a seed."""
    generator = np.random.default_rng(seed)
    low, high = np.array(part.rectangle)
    steps, command, now = round(part.seconds / dt), np.zeros(len(low)), 0
    commands = np.zeros((steps, len(low)))
    stand, reverse, full = np.cumsum(part.shares)
    while now < steps:
        kind = generator.random()
        drawn = generator.uniform(low, high)
        # Not all in the middle, which would be standing.
        end = generator.choice([-1, 1, 0, -1, 1], len(low), replace=False)
        if kind < stand:
            command = np.zeros(len(low))
        elif kind < reverse and command.any():
            command = np.clip(-command, low, high)
        elif kind < full:
            command = np.where(end > 0, high, np.where(end < 0, low, 0.0))
        else:
            command = drawn
        length = max(1, round(generator.uniform(*part.held) / dt))
        commands[now : now + length] = command
        now += length
    return commands


def joystick_measures(rollout: Rollout, command: Floats, part: Joystick) -> dict[str, Any]:
    """Return falls per hour until each robot's fall, errors, and the accuracy over windows, as plain values.

    `command` (T, N, V) are the commands that were given, whatever the task makes of them.
    """
    valid, dt = rollout.valid, rollout.timestep
    error = stretch_errors(rollout.velocity, command, valid, part, dt)
    counted = error[np.isfinite(error[..., 0])]
    accuracy, windows = window_accuracy(error, command, valid, part, dt)
    # Windows in which a robot that stands still would earn something do not count.
    still = stretch_errors(np.zeros_like(rollout.velocity), command, np.ones_like(valid), part, dt)
    windows &= window_accuracy(still, command, np.ones_like(valid), part, dt)[0] == 0.0
    hours = valid.sum(axis=0) * dt / _SECONDS_PER_HOUR
    falls = int(rollout.fallen.sum())
    sums = np.array([(accuracy * windows).sum(axis=0), windows.sum(axis=0), rollout.fallen, hours])
    return {
        "robot_hours": float(hours.sum()),
        "falls": falls,
        "falls_per_hour": poisson_rate(falls, float(hours.sum())).to_dict(),
        "mean_error": mean_of(np.abs(counted)) if len(counted) else [None] * command.shape[-1],
        "accuracy": bootstrap_mean(sums[0] / np.where(sums[1], sums[1], np.nan)).to_dict(),
        "contributions": joystick_contributions(sums, part.halving).tolist(),
    }


def joystick_contributions(sums: Floats, halving: float) -> Floats:
    """Return N numbers whose mean is the score of N robots, and whose spread is its uncertainty: jackknife values.

    Of each robot, `sums` (4, N) has the sum of the accuracy over its windows, their number, its falls and its hours.
    The score is the mean accuracy over all windows, times 1 / (1 + falls per hour / `halving`).
    """

    def score(accuracy: Floats, windows: Floats, falls: Floats, hours: Floats) -> Floats:
        return accuracy / np.maximum(windows, 1.0) / (1.0 + falls / (halving * hours))

    total, count = sums.sum(axis=1), sums.shape[1]
    whole = score(*total)
    if count == 1:
        return np.array([whole])
    values = count * whole - (count - 1) * score(*(total[:, None] - sums))
    return values + whole - values.mean()


def stretch_errors(velocity: NDArray[Any], command: Floats, valid: Bools, part: Joystick, dt: float) -> Floats:
    """Return the error of the mean velocity over the stretch of one command that each sample belongs to (T, N, V).

    A stretch begins `allowance` after a change of the command, and ends at the next change or a fall. NaN outside
    stretches, and in those shorter than `shortest`.
    """
    steps, robots = valid.shape
    error = np.full((steps, robots, command.shape[-1]), np.nan)
    allowance, shortest = round(part.allowance / dt), round(part.shortest / dt)
    for robot in range(robots):
        alive = int(valid[:, robot].sum())
        changes = np.flatnonzero((np.diff(command[:alive, robot], axis=0) != 0.0).any(axis=-1)) + 1
        for change, end in zip([0, *changes], [*changes, alive], strict=True):
            begin = change + allowance
            if end - begin >= max(shortest, 1):
                mean = velocity[begin:end, robot].mean(axis=0, dtype=np.float64)
                error[begin:end, robot] = mean - command[begin, robot]
    return error


def window_accuracy(error: Floats, command: Floats, valid: Bools, part: Joystick, dt: float) -> tuple[Floats, Bools]:
    """Return the accuracy of the mean absolute error in each window, and True for those that count (windows, N).

    A window counts without a fall, and with a sample whose error is known. The accuracy is the one under the mean
    absolute command of these samples.
    """
    length = round(part.window / dt)
    count = len(valid) // length
    shape = count, length, valid.shape[1]
    size, wanted = (np.abs(values[: count * length]).reshape(*shape, error.shape[-1]) for values in (error, command))
    known = np.isfinite(size)
    number = np.maximum(known.sum(axis=1), 1)
    mean, asked = (np.where(known, values, 0.0).sum(axis=1) / number for values in (size, wanted))
    whole = valid[: count * length].reshape(shape).all(axis=1)
    return part.tolerance.accuracy(mean, asked), np.asarray(whole & known.any(axis=(1, 3)))


def run_transients(part: Transients, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure each step of the command: name -> plain values."""
    blocks = [np.arange(part.num_seeds) + i * part.num_seeds for i in range(len(part.changes))]

    def change_commands(task: Task, step: int) -> None:
        if step == round(part.before / task.control.config.timestep):
            for block, change in zip(blocks, part.changes, strict=True):
                task.set_command(block, change.then)

    rollout = candidate.run(
        [change.first for change in part.changes],
        part.seeds,
        part.before + part.after,
        progress,
        before_step=change_commands,
        reached=[change.then for change in part.changes],
    )
    result = {
        change.name: step_measures(rollout.select(block), change, part)
        for block, change in zip(blocks, part.changes, strict=True)
    }
    return {"changes": result, "contributions": joined(result)}


def step_measures(rollout: Rollout, change: Change, part: Transients) -> dict[str, Any]:
    """Measure the episodes of one step of the command; plain values.

    An episode that falls or does not follow the change counts with the longest settling time, `part.after`.
    """
    wanted, then = np.subtract(change.then, change.first), np.array(change.then)
    settling, before, final = step_response(rollout.velocity, wanted, part, rollout.timestep)
    made = (final - before) * np.sign(wanted) >= part.followed_share * np.abs(wanted)
    followed = made.all(axis=-1) & ~rollout.fallen
    settling = np.where(followed, settling, part.after)
    accuracy = np.where(followed, part.tolerance.accuracy(final - then, then), 0.0)
    return {
        "first": list(change.first),
        "then": list(change.then),
        "falls": proportion(rollout.fallen).to_dict(),
        "followed": proportion(followed).to_dict(),
        "steady_error": mean_of(np.where(rollout.fallen[:, None], np.nan, np.abs(final - then))),
        "settling_time": bootstrap_mean(settling).to_dict(),
        "contributions": (accuracy * (1.0 - settling / part.after)).tolist(),
    }


def step_response(velocity: NDArray[Any], wanted: Floats, part: Transients, dt: float) -> tuple[Floats, Floats, Floats]:
    """Return the settling time (s) of velocities (T, N, V) after commanded changes (V,), (N,).

    It is the time from the change until each velocity that changes stays in the band around its final value; followed
    by the mean velocities before the change, and the final ones (N, V). The velocities are from `part.before` before
    the change to `part.after` after it, every `dt` seconds; the last half window counts only within the means before
    it.
    """
    change, half, tail = (round(seconds / dt) for seconds in (part.before, 0.5 * part.window, part.final))
    smooth = centred_mean(velocity, half)
    before = smooth[change - half - tail : change - half].mean(axis=0)
    # Where the window is cut short, it lets the oscillation within a stride through.
    after = smooth[change : len(smooth) - half]
    final = after[len(after) - tail :].mean(axis=0)
    band = np.where(wanted, np.maximum(part.band * np.abs(wanted), part.tolerance.met), np.inf)
    outside = (np.abs(after - final) > band).any(axis=-1)
    # Sample i is the velocity (i + 1) control steps after the change.
    last = len(outside) - outside[::-1].argmax(axis=0)
    return np.where(outside[-1], part.after, np.where(outside.any(axis=0), last, 0) * dt), before, final


def centred_mean(values: NDArray[Any], half: int) -> Floats:
    """Return means (T, N) over each sample, `half` samples before and `half` after it; shorter windows at both ends."""
    total = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0, dtype=np.float64)])
    index = np.arange(len(values))
    low, high = np.maximum(index - half, 0), np.minimum(index + half + 1, len(values))
    return (total[high] - total[low]) / (high - low).reshape(-1, *(1,) * (values.ndim - 1))


def run_pushes(part: Pushes, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure pushes of six components under every command."""
    episodes = range(part.first_seed, part.first_seed + len(part.sizes) * part.num_seeds)
    size = np.tile(np.repeat(part.sizes, part.num_seeds), len(part.commands))
    times, directions = zip(*([push_of(part, seed) for seed in episodes] * len(part.commands)), strict=True)
    velocity = size[:, None] * np.array(directions)

    def push(task: Task, step: int) -> None:
        now = np.flatnonzero(np.round(np.array(times) / task.control.config.timestep) == step)
        if len(now):
            task.simulation.push(now, velocity[now])

    return push_measures(
        candidate.run(part.commands, episodes, part.before[1] + part.after, progress, before_step=push), part
    )


def push_of(part: Pushes, seed: int) -> tuple[float, Floats]:
    """Return the time in s and direction of the push in the episode of a seed: (6,) in the units of `part.unit`."""
    generator = np.random.default_rng(seed)
    direction = generator.standard_normal(6)
    return generator.uniform(*part.before), direction / np.linalg.norm(direction) * part.unit


def push_measures(rollout: Rollout, part: Pushes) -> dict[str, Any]:
    """Return how accurately the episodes follow their command after the push, and how many do not fall; plain values.

    The mean velocities over the last `final` seconds count; under a command to stand, the robot must also stand still.
    """
    last = np.zeros_like(rollout.valid)
    last[len(last) - round(part.final / rollout.timestep) :] = True
    shape = len(part.commands), len(part.sizes), part.num_seeds
    commands = np.repeat(part.commands, shape[1] * shape[2], axis=0)
    accuracy = reached(rollout, commands, part.tolerance, last).accuracy.reshape(shape)
    moving = np.any(part.commands, axis=-1)
    return {
        "survived": proportion(~rollout.fallen).to_dict(),
        "commands": [
            {
                "command": list(wanted),
                "accuracy": [bootstrap_mean(episodes).to_dict() for episodes in accuracy[i]],
            }
            for i, wanted in enumerate(part.commands)
        ],
        "contributions": moving_and_standing(accuracy[moving], accuracy[~moving]),
    }


def moving_and_standing(moving: Floats, standing: Floats) -> list[float]:
    """Return what each episode under a command to move contributes to a score, from accuracies of any shape.

    Standing alone earns nothing; a robot that moves as commanded, and never stands still, loses a fifth.
    """
    share: Floats = moving.ravel() * (1.0 - _STANDING_WEIGHT * (1.0 - standing.mean()))
    return share.tolist()
