"""Disturbances of robot, ground and sensors: one at a time, and all together."""

from typing import Any

import numpy as np

from quadruped_env.evaluation.confidence import mean_of, proportion
from quadruped_env.evaluation.suite.measured_controller import MeasuredController, mean_velocities
from quadruped_env.evaluation.suite.suite_definition import Disturbances, Factor
from quadruped_env.utils.progress import Progress, part_of


def run(part: Disturbances, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Falls and errors of each factor and of all together: name -> plain values."""
    result = {}
    entries = [(factor, part.seeds, part.seconds) for factor in (Factor("nominal", {}), *part.factors)]
    together = range(part.first_seed, part.first_seed + part.together_seeds)
    entries.append((part.together, together, part.together_seconds))
    steps = [len(seeds) * seconds for _, seeds, seconds in entries]
    for i, (factor, seeds, seconds) in enumerate(entries):
        share_done = part_of(progress, sum(steps[:i]) / sum(steps), sum(steps[: i + 1]) / sum(steps))
        result[factor.name] = _measured(part, measured, factor, seeds, seconds, share_done)
    return result


def _measured(
    part: Disturbances,
    measured: MeasuredController,
    factor: Factor,
    seeds: range,
    seconds: float,
    progress: Progress | None,
) -> dict[str, Any]:
    rollout = measured.run(part.commands, seeds, seconds, progress, randomization=factor.randomization)
    error = mean_velocities(rollout) - rollout.command[0]
    held = (np.abs(error) <= part.tolerance).all(axis=-1) & ~rollout.fallen
    return {
        "falls": proportion(rollout.fallen).to_dict(),
        "held": proportion(held).to_dict(),
        "forward_velocity_error": mean_of(np.abs(error[:, 0])),
        "yaw_rate_error": mean_of(np.abs(error[:, 1])),
    }


def score(result: dict[str, Any], part: Disturbances) -> float:
    """Score in [0, 1] of the part: mean of two shares of episodes that hold their command.

    That with one disturbance at a time, mean over the factors, and that with all together.
    """
    alone = np.mean([result[factor.name]["held"]["mean"] for factor in part.factors])
    return 0.5 * float(alone + result[part.together.name]["held"]["mean"])
