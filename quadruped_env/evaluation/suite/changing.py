"""Parts of the suite in which something changes while the robot moves: joystick commands, steps of them, and pushes."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import bootstrap_mean, mean_of, poisson_rate, proportion
from quadruped_env.evaluation.measures import masked_mean, meets, stands_still
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite_definition import Change, Joystick, Pushes, Transients
from quadruped_env.task import Task
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.progress import Progress, part_of

_SECONDS_PER_HOUR: Final = 3600.0


def run_joystick(part: Joystick, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure hours of changing commands under each law of disturbances: name -> plain values."""
    dt = candidate.config.control_timestep
    command = np.stack([schedule(part, seed, dt) for seed in part.seeds], axis=1)
    new = np.ones(command.shape[:2], np.bool_)
    new[1:] = (np.diff(command, axis=0) != 0.0).any(axis=-1)

    def change_commands(task: Task, step: int) -> None:
        if (changed := np.flatnonzero(new[step])).size:
            task.control.set_command(changed, command[step, changed])

    result = {}
    for i, law in enumerate(part.laws):
        done = part_of(progress, i / len(part.laws), (i + 1) / len(part.laws))
        rollout = candidate.run(
            [(0.0, 0.0)], part.seeds, part.seconds, done, law.randomization, change_commands, part.rectangle
        )
        result[law.name] = joystick_measures(rollout, command, part)
    return result


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
    """Return falls per hour until each robot's fall, errors, and the share of met windows, as plain values.

    `command` (T, N, V) are the commands that were given, whatever the task makes of them.
    """
    valid = rollout.valid
    error = stretch_errors(rollout.velocity, command, valid, part, rollout.timestep)
    counted = error[np.isfinite(error[..., 0])]
    windows = met_windows(error, valid, part, rollout.timestep)
    # Windows that a robot standing still would meet do not count.
    still = stretch_errors(np.zeros_like(rollout.velocity), command, np.ones_like(valid), part, rollout.timestep)
    trivial = met_windows(still, np.ones_like(valid), part, rollout.timestep)
    hours = float(valid.sum() * rollout.timestep) / _SECONDS_PER_HOUR
    return {
        "robot_hours": hours,
        "falls": int(rollout.fallen.sum()),
        "falls_per_hour": poisson_rate(int(rollout.fallen.sum()), hours).to_dict(),
        "mean_error": mean_of(np.abs(counted)) if len(counted) else [None] * command.shape[-1],
        "windows_met": proportion(windows[~trivial]).to_dict(),
    }


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


def met_windows(error: Floats, valid: Bools, part: Joystick, dt: float) -> Bools:
    """Return True for each whole window without a fall and with mean absolute errors in the tolerance (windows, N).

    A window without a counted sample is not met.
    """
    length = round(part.window / dt)
    count = len(valid) // length
    shape = count, length, valid.shape[1]
    size = np.abs(error[: count * length]).reshape(*shape, error.shape[-1])
    known = np.isfinite(size)
    mean = np.where(known, size, 0.0).sum(axis=1) / np.maximum(known.sum(axis=1), 1)
    whole = valid[: count * length].reshape(shape).all(axis=1)
    return np.asarray(whole & known.any(axis=(1, 3)) & (mean <= part.tolerance).all(axis=-1))


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
    return {
        change.name: step_measures(rollout.select(block), change, part)
        for block, change in zip(blocks, part.changes, strict=True)
    }


def step_measures(rollout: Rollout, change: Change, part: Transients) -> dict[str, Any]:
    """Measure the episodes of one step of the command; plain values.

    An episode that falls or does not follow the change counts with the longest settling time, `part.after`.
    """
    dt = rollout.timestep
    wanted = np.subtract(change.then, change.first)
    answers = [
        step_response(rollout.velocity[..., column], float(wanted[column]), part, dt, part.narrowest[column])
        for column in range(len(wanted))
        if wanted[column]
    ]
    followed = np.all([followed for _, followed in answers], axis=0) & ~rollout.fallen
    settling = np.where(followed, np.max([settling for settling, _ in answers], axis=0), part.after)
    return {
        "first": list(change.first),
        "then": list(change.then),
        "falls": proportion(rollout.fallen).to_dict(),
        "followed": proportion(followed).to_dict(),
        "settling_time": bootstrap_mean(settling).to_dict(),
        "score": float(np.where(followed, 1.0 - settling / part.after, 0.0).mean()),
    }


def step_response(
    velocity: NDArray[Any], wanted: float, part: Transients, dt: float, narrowest: float = 0.0
) -> tuple[Floats, Bools]:
    """Return the settling time (s) of a velocity (T, N) after a commanded change, and True where it followed, (N,).

    The settling time is from the change until the velocity stays in the band around its final value. The velocity is
    from `part.before` before the change to `part.after` after it, every `dt` seconds; the last half window counts only
    within the means before it. `narrowest` is the least half width of the band, in the unit of the velocity.
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
    return settling, (final - before) * np.sign(wanted) >= part.followed_share * abs(wanted)


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
    """Return the shares of the episodes that follow their command after the push and that do not fall, plain values.

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
