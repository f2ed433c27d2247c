"""Settings of a training under which a user gave some: those of the recipe and the algorithm."""

from collections.abc import Iterable, Mapping
from typing import Any, Final

from quadruped_env.envs.arguments import changed
from quadruped_env.robot import Robot
from quadruped_env.task.randomization.randomization_presets import PRESET
from quadruped_env.training.algorithms import ALGORITHMS, algorithm, base_of
from quadruped_env.training.recipes import RECIPES, recipe, task_values
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.training.user_classes import recorded_name

CHOICES: Final = {"recipe": RECIPES, "algo": ALGORITHMS}
"""Settings that change the defaults of others, with their values."""


def with_recipe(typed: dict[str, Any], robot: Robot, whole: Iterable[str]) -> dict[str, Any]:
    """Fields of `TrainConfig`: those of the algorithm and of the recipe, and over them those that the user typed.

    Args:
        typed: fields that the user typed; of `task`, changes to the config.
        robot: robot of the task.
        whole: sections of the task's config that the user chose as a whole, in place of the recipe's.
    """
    name, own = typed.get("recipe", TrainConfig.recipe), typed.get("task", {})
    chosen = {*whole, *(section for section, values in own.items() if isinstance(values, dict) and PRESET in values)}
    task = {section: values for section, values in task_values(name, robot).items() if section not in chosen}
    task = changed(task, own)
    return {**default_settings(typed), **typed, **({"task": task} if task else {})}


def default_settings(typed: Mapping[str, Any]) -> dict[str, Any]:
    """Fields of `TrainConfig`, without the task, whose defaults depend on the recipe and algorithm."""
    name, algo = (typed.get(option, getattr(TrainConfig, option)) for option in CHOICES)
    entry = recipe(name)
    return {
        "name": recorded_name(algo).rpartition(":")[2].lower(),
        **algorithm(algo).defaults,
        **entry.training,
        **(entry.ppo if base_of(algo) == TrainConfig.algo else {}),
        # The actor of a policy class of one's own may see all columns that the critic sees.
        **({"asymmetric_critic": False} if typed.get("policy") else {}),
    }
