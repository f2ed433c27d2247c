"""Hours of commands that change at any time: falls per hour, errors, and the score by windows."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import mean_of, poisson_rate, proportion
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Joystick
from quadruped_env.task import Task
from quadruped_env.utils.progress import Progress, part_of

Floats = NDArray[np.float64]

_SECONDS_PER_HOUR = 3600.0


def run(part: Joystick, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Measures of each law of disturbances: name -> plain values."""
    dt = measured.config.control_timestep
    command = np.stack([schedule(part, seed, dt) for seed in part.seeds], axis=1)
    new = (np.diff(command, axis=0) != 0.0).any(axis=-1)

    def change_commands(task: Task, step: int) -> None:
        changed = np.arange(part.num_seeds) if step == 0 else np.flatnonzero(new[step - 1])
        if len(changed):
            task.control.set_command(changed, command[step, changed])

    result = {}
    for i, law in enumerate(part.laws):
        rollout = measured.run(
            [(0.0, 0.0)],
            part.seeds,
            part.seconds,
            part_of(progress, i / len(part.laws), (i + 1) / len(part.laws)),
            randomization=law.randomization,
            before_step=change_commands,
            reached=part.rectangle,
        )
        result[law.name] = measures(rollout, command, part)
    return result


def schedule(part: Joystick, seed: int, dt: float) -> Floats:
    """Command in each control step of `dt` seconds (T, 2) of the episode of a seed."""
    generator = np.random.default_rng(seed)
    low, high = np.array(part.rectangle)
    steps, command, now = round(part.seconds / dt), np.zeros(2), 0
    commands = np.zeros((steps, 2))
    stand, reverse, full = np.cumsum(part.shares)
    while now < steps:
        kind = generator.random()
        drawn = generator.uniform(low, high)
        # Not both in the middle, which would be standing.
        end = generator.choice([-1, 1, 0, -1, 1], 2, replace=False)
        if kind < stand:
            command = np.zeros(2)
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


def measures(rollout: Rollout, command: Floats, part: Joystick) -> dict[str, Any]:
    """Falls per hour until each robot's fall, errors, and the share of met windows, as plain values.

    `command` (T, N, 2) are the commands that were given, whatever the task makes of them.
    """
    valid = rollout.valid
    error = stretch_errors(rollout.velocity, command, valid, part, rollout.timestep)
    counted = np.isfinite(error[..., 0])
    flat = error[counted]
    windows = met_windows(error, valid, part, rollout.timestep)
    # The windows that a robot standing still would meet say nothing.
    still = stretch_errors(np.zeros_like(rollout.velocity), command, np.ones_like(valid), part, rollout.timestep)
    trivial = met_windows(still, np.ones_like(valid), part, rollout.timestep)
    hours = float(valid.sum() * rollout.timestep) / _SECONDS_PER_HOUR
    return {
        "robot_hours": hours,
        "falls": int(rollout.fallen.sum()),
        "falls_per_hour": poisson_rate(int(rollout.fallen.sum()), hours).to_dict(),
        "mean_error": mean_of(np.abs(flat)) if len(flat) else [None, None],
        "rms_error": np.sqrt((flat**2).mean(axis=0)).tolist() if len(flat) else [None, None],
        "windows_met": proportion(windows[~trivial]).to_dict(),
    }


def stretch_errors(
    velocity: NDArray[Any], command: Floats, valid: NDArray[np.bool_], part: Joystick, dt: float
) -> Floats:
    """Error of the mean velocity of the stretch of one command to which each sample belongs (T, N, 2).

    A stretch begins `allowance` after a change of the command, and ends at the next change or a fall. NaN outside
    stretches, and in those shorter than `shortest`.
    """
    steps, robots = valid.shape
    error = np.full((steps, robots, 2), np.nan)
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


def met_windows(error: Floats, valid: NDArray[np.bool_], part: Joystick, dt: float) -> NDArray[np.bool_]:
    """True for each whole window without a fall and with mean absolute errors in the tolerance (windows, N).

    A window without a counted sample is not met.
    """
    length = round(part.window / dt)
    count = len(valid) // length
    shape = count, length, valid.shape[1]
    size = np.abs(error[: count * length]).reshape(*shape, 2)
    known = np.isfinite(size)
    mean = np.where(known, size, 0.0).sum(axis=1) / np.maximum(known.sum(axis=1), 1)
    whole = valid[: count * length].reshape(shape).all(axis=1)
    return np.asarray(whole & known.any(axis=(1, 3)) & (mean <= part.tolerance).all(axis=-1))


def score(result: dict[str, Any]) -> float:
    """Score in [0, 1] of the part: mean over the laws of the share of met windows."""
    return float(np.mean([law["windows_met"]["mean"] for law in result.values()]))
