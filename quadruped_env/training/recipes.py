"""Recipes: named settings of a training and its task, and the settings of a training in which a user gave some."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final

from quadruped_env.control.control_config import ActionConfig
from quadruped_env.envs.arguments import changed
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import foot_travel, scaled
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
        "rough": Recipe(
            "all kinds of terrain, with a curriculum, another robot in each episode, and pushes",
            # On top of the scripted trot it climbs lower steps.
            {"timesteps": 6_000_000, "action_mode": "position"},
            # For a hundred tiles: with 256 robots one of five seeds did not learn the steepest slopes.
            {"num_envs": 512, "batch_size": 3072},
            {
                "terrain": {
                    "name": "tiles",
                    "curriculum": True,
                    # Slopes and steps are learned last.
                    "kinds": ["flat", *["slope"] * 3, "rough", *["steps"] * 2, "stairs", "gaps", "wave"],
                },
                "randomization": "moderate",
                # A foot has more time to rise above a step.
                "clock_frequency": 3.0,
                # The feet rise above the steps that they climb, which takes power, and come down from there.
                "reward": {
                    "foot_lift": 0.045,
                    "weights": {"gait_clock": 14.0, "electrical_power": -0.01, "landing": -0.1, "action_rate": -0.3},
                },
            },
        ),
    }
)
"""The recipes by name; `flat` is the default."""


def with_recipe(given: Mapping[str, Any], robot: Robot, whole: Iterable[str] = ()) -> TrainConfig:
    """Return the settings of a training: what the user gave, then the recipe, then the algorithm.

    All numbers of the recipe's task follow the robot's size by their units, and the scale of residual actions follows
    how far its joints move its feet.

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
    mode = given.get("action_mode", recipe.training.get("action_mode", TrainConfig.action_mode))
    if mode == "residual" and (travel := foot_travel(robot)) > 1.0:
        # What explores on one robot topples another one, whose joints move its feet further.
        task["action"] = {"residual_scale": scaled(ActionConfig.residual_scale, 1.0 / travel, 2)}
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
