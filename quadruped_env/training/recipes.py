"""Recipes: named settings of a training and its task, and the settings of a training in which a user gave some."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final

from quadruped_env.envs.arguments import changed
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.task.randomization.randomization_presets import PRESET
from quadruped_env.task.sections import values_for
from quadruped_env.training.algorithms import ALGORITHMS, SETTINGS
from quadruped_env.training.train_config import TrainConfig, check_fields


@dataclass(frozen=True)
class Recipe:
    """Settings of a training and its task that differ from the defaults."""

    description: str
    """Purpose of the training, in a few words."""
    training: Mapping[str, Any] = field(default_factory=dict)
    """Fields of `TrainConfig`, without the task."""
    ppo: Mapping[str, Any] = field(default_factory=dict)
    """Fields of `TrainConfig` for PPO alone."""
    task: Mapping[str, Any] = field(default_factory=dict)
    """Changes to the task's config; `randomization` may be the name of a preset. Its numbers are for the
    built-in robot."""


RECIPES: Final[Mapping[str, Recipe]] = MappingProxyType(
    {
        "flat": Recipe("level ground, another robot in each episode, and pushes", task={"randomization": "moderate"}),
        "walker": Recipe(
            "one policy for level ground and all kinds of terrain: a curriculum, and robots that differ widely",
            # On top of the scripted trot it climbs lower steps.
            {"timesteps": 30_000_000, "action_mode": "position"},
            # For a hundred and forty tiles: with 256 robots one of five seeds did not learn the steepest slopes.
            {"num_envs": 512, "batch_size": 3072, "n_epochs": 5, "desired_kl": 0.015, "final_log_std": -3.0},
            {
                "terrain": {
                    "name": "tiles",
                    "curriculum": True,
                    "kinds": [*["flat"] * 5, *["slope"] * 2, "rough", *["steps"] * 2, *["stairs"] * 2, "gaps", "wave"],
                },
                "randomization": {
                    "preset": "moderate",
                    "friction": [0.3, 1.2],
                    "contact_time_constant": [0.01, 0.02],
                    "contact_damping_ratio": [0.7, 1.1],
                    "payload": [-0.4, 1.0],
                    "supply_voltage": [0.7, 1.1],
                    "encoder_offset": 0.015,
                    "action_latency": [0.0, 0.08],
                    "observation_latency": [0.0, 0.015],
                    "push_velocity": 0.6,
                    "push_rotation": 1.0,
                    "push_force": [0.0, 5.0],
                },
                # A foot has more time to rise above a step.
                "clock_frequency": 3.0,
                # Half of a stride: one step of each foot, from which the speed can be told.
                "observation_history": 8,
                "reward": {
                    "foot_lift": 0.015,
                    "weights": {
                        "steady_error": -3.0,
                        "gait_clock": 10.0,
                        "electrical_power": -0.04,
                        "landing": -0.6,
                        "action_rate": -0.6,
                    },
                },
            },
        ),
    }
)
"""The recipes by name; `flat` is the default."""


def with_recipe(given: Mapping[str, Any], robot: Robot, whole: Iterable[str] = ()) -> TrainConfig:
    """Return the settings of a training: what the user gave, then the recipe, then the algorithm.

    All numbers of the recipe's task follow the robot's size by their units.

    Args:
        given: fields of `TrainConfig`; of `task`, changes to the config.
        robot: robot of the task.
        whole: sections of the task's config that the user chose as a whole, instead of the recipe's.

    Raises:
        QuadrupedError: if a value is not valid, or the algorithm does not use one; the message begins with the field.
    """
    check_fields(given)
    algo, recipe = given.get("algo", TrainConfig.algo), RECIPES[given.get("recipe", TrainConfig.recipe)]
    check_used(algo, given)
    own = given.get("task", {})
    chosen = {*whole, *(section for section, values in own.items() if isinstance(values, dict) and PRESET in values)}
    task = {name: values for name, values in values_for(recipe.task, robot).items() if name not in chosen}
    defaults = {"name": algo, **ALGORITHMS[algo].defaults, **recipe.training, **(recipe.ppo if algo == "ppo" else {})}
    return TrainConfig(**{**defaults, **given, "task": changed(task, own)})


def check_used(algo: str, given: Iterable[str]) -> None:
    """Check that an algorithm uses the settings that a user gave.

    Raises:
        QuadrupedError: naming the first field that it does not use, and the algorithms that do.
    """
    for name in given:
        if name in SETTINGS - ALGORITHMS[algo].settings:
            users = [other for other, entry in ALGORITHMS.items() if name in entry.settings]
            raise QuadrupedError(
                f"training.{name}: {algo} does not use it; leave it out, or choose algo {' or '.join(users)}"
            )
