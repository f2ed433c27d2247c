"""Recipes: named settings of a training and its task, as plain values that the run keeps."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.robot import Robot
from quadruped_env.task.task_config import values_for


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
    """Changes to the task's config; `randomization` may be the name of a preset. Its numbers are those of the built-in
    robot."""


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


def recipe(name: str) -> Recipe:
    """A recipe by its name.

    Raises:
        QuadrupedError: if there is none; the message names those that there are.
    """
    if name not in RECIPES:
        raise QuadrupedError(f"--recipe: {short(name)} is unknown; valid recipes are {', '.join(RECIPES)}")
    return RECIPES[name]


def task_values(name: str, robot: Robot) -> dict[str, Any]:
    """Changes of a recipe to the task's config, for a robot, as plain values: those of the preset in place of its name.

    All numbers follow the robot's size by their units.

    Raises:
        QuadrupedError: if there is no such recipe.
    """
    return values_for(recipe(name).task, robot)
