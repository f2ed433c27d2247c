"""Regulation: speed and yaw rate kept under friction, payload, encoder offsets and slopes, and all of `hard`."""

import math
from typing import Annotated, Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.evaluation.confidence import mean_of, proportion
from quadruped_env.evaluation.measures import mean_velocities, meets
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Factor, Regulation
from quadruped_env.simulation import flat
from quadruped_env.simulation.terrain import Grid, terrain
from quadruped_env.task import Task
from quadruped_env.utils import rotations
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.progress import Progress, part_of

Floats = NDArray[np.float64]

_DROP: Final = 0.01
"""Distance of the stance's soles from an incline at the start, m: randomized legs do not penetrate it."""


@terrain(size=24.0, cell=0.5)
def incline(grid: Grid, angle: Annotated[float, Parameter("rad", -0.5, 0.5)] = 0.0) -> Floats:
    """A plane that rises along x."""
    return math.tan(angle) * grid.x


def run(part: Regulation, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Measures of each factor and of all together: name -> plain values."""
    result, total = {}, len(part.factors) * part.num_seeds * part.seconds
    share = total / (total + part.together_seeds * part.together_seconds)
    for i, factor in enumerate(part.factors):
        done = part_of(progress, share * i / len(part.factors), share * (i + 1) / len(part.factors))
        rollout = _rollout(part, measured, factor, part.seeds, part.seconds, done)
        result[factor.name] = measures(rollout, part)
    together = range(part.first_seed, part.first_seed + part.together_seeds)
    done = part_of(progress, share, 1.0)
    rollout = _rollout(part, measured, part.together, together, part.together_seconds, done)
    commands = np.repeat(part.commands, part.together_seeds, axis=0)
    held = meets(mean_velocities(rollout), commands, True, rollout.fallen, part.together_tolerance)
    result[part.together.name] = {**measures(rollout, part), "held": proportion(held).to_dict()}
    return result


def _rollout(
    part: Regulation,
    measured: MeasuredController,
    factor: Factor,
    seeds: range,
    seconds: float,
    progress: Progress | None,
) -> Rollout:
    angle = math.radians(factor.slope)
    commands = np.repeat(part.commands, len(seeds), axis=0)

    def begin(task: Task, step: int) -> None:
        """Put the robots parallel to an incline, and let all stand before they get their commands."""
        if step == 0 and angle:
            _place(task, angle)
        if step == round(part.standing / task.control.config.timestep):
            task.control.set_command(np.arange(len(commands)), commands)

    return measured.run(
        [(0.0, 0.0)] * len(part.commands),
        seeds,
        seconds,
        progress,
        factor.randomization,
        before_step=begin,
        reached=part.commands,
        terrain=incline.variant(angle=angle) if angle else flat,
    )


def _place(task: Task, angle: float) -> None:
    """Put the robots onto an incline of an angle in rad: level, their front or hind feet would be in the ground."""
    start, robot = task.simulation.readings, task.simulation.robot
    height = robot.stance_height + _DROP
    qpos = np.zeros((task.num_envs, robot.num_positions))
    qpos[:, :3] = height * np.array([-math.sin(angle), 0.0, math.cos(angle)])
    qpos[:, 3:7] = rotations.multiply(rotations.from_axis_angle([0.0, 1.0, 0.0], -angle), start.orientation)
    qpos[:, 7:] = start.joint_position
    task.place(np.arange(task.num_envs), qpos, np.zeros((task.num_envs, robot.num_velocities)))


def measures(rollout: Rollout, part: Regulation) -> dict[str, Any]:
    """Falls, and the signed share of each command that is kept, of episodes with every command, as plain values."""
    achieved = mean_velocities(rollout).reshape(len(part.commands), -1, 2)
    kept = keeps(part, achieved, rollout.fallen.reshape(len(part.commands), -1))
    return {
        "falls": proportion(rollout.fallen).to_dict(),
        "kept": proportion(kept).to_dict(),
        "commands": [
            {
                "command": list(command),
                "velocity": mean_of(velocity),
                "share": [mean_of(velocity[:, i] / wanted) if wanted else None for i, wanted in enumerate(command)],
            }
            for command, velocity in zip(part.commands, achieved, strict=True)
        ],
    }


def keeps(part: Regulation, achieved: ArrayLike, fallen: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """True for each of S episodes that keeps both velocities of its command without a fall (K, S).

    `achieved` are mean velocities (K, S, 2), NaN if unknown.
    """
    command = np.array(part.commands)[:, None]
    allowed = np.where(command != 0.0, part.share * np.abs(command), part.tolerance)
    # The tolerance for rounding is that of decimal commands.
    return np.asarray((np.abs(np.asarray(achieved) - command) <= allowed + 1e-9).all(axis=-1) & ~fallen)


def score(result: dict[str, Any], part: Regulation) -> float:
    """Score in [0, 1] of the part: mean of two shares of episodes.

    Those that keep their velocities with one disturbance at a time, mean over the factors, and those that hold their
    command with all together.
    """
    alone = np.mean([result[factor.name]["kept"]["mean"] for factor in part.factors])
    return 0.5 * float(alone + result[part.together.name]["held"]["mean"])
