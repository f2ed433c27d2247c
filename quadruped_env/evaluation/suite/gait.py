"""The part of the suite that measures the gait while the robot walks steadily."""

from typing import Any

import numpy as np

from quadruped_env.evaluation.confidence import mean_of
from quadruped_env.evaluation.measures import gait_measures, mean_velocities, measure, meets
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import GaitPart
from quadruped_env.utils.progress import Progress

_MEASURES = ("joint_limit_share", "speed_limit_share", "electrical_power", "electrical_cost_of_transport")


def run(part: GaitPart, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Measures of each command, means over the episodes, as plain values."""
    rollout = measured.run(part.commands, part.seeds, part.seconds, progress, physics=True)
    every = measure(rollout)
    values = {**gait_measures(rollout), **{name: every[name] for name in _MEASURES}}
    shape = len(part.commands), part.num_seeds
    commands = np.repeat(part.commands, part.num_seeds, axis=0)
    followed = meets(mean_velocities(rollout), commands, True, rollout.fallen, part.tolerance)
    grouped = {name: value.reshape(*shape, *value.shape[1:]) for name, value in values.items()}
    return {
        "feet": list(measured.robot.leg_names),
        "commands": [
            {
                "command": list(command),
                "fall_share": float(rollout.fallen.reshape(shape)[i].mean()),
                "followed": float(followed.reshape(shape)[i].mean()),
                **{name: mean_of(value[i]) for name, value in grouped.items()},
            }
            for i, command in enumerate(part.commands)
        ],
    }


def score(result: dict[str, Any], part: GaitPart) -> float:
    """Score in [0, 1] of the part: mean over the commands of the share of episodes that follow it times five numbers.

    Their mean, 0 for a robot with a foot that does not step: the clearance of the foot that is lifted least, over
    `full_clearance`; x or 1 / x, the one below 1, of the foot with the worst number x of swings per stride; 1 - bounces
    per stride; `soft_landing` over the speed of the hardest landing; `little_slip` over the largest slip. Each is at
    least 0 and at most 1.
    """
    total = 0.0
    for entry in result["commands"]:
        landings = entry["landing_speed"]
        if None in landings or None in entry["clearance"]:
            continue
        numbers = (
            min(entry["clearance"]) / part.full_clearance,
            min(min(x, 1.0 / x) for x in entry["swings_per_stride"]),
            1.0 - max(entry["bounces_per_stride"]),
            part.soft_landing / max(*landings, 1e-9),
            part.little_slip / max(*entry["slip"], 1e-9),
        )
        total += entry["followed"] * sum(min(1.0, max(0.0, number)) for number in numbers) / len(numbers)
    return total / len(result["commands"])
