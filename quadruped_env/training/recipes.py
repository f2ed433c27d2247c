"""Recipes: named settings of a training and its task, as plain values that the run keeps."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final

from quadruped_env.envs.arguments import changed
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.robot import Robot
from quadruped_env.task import BUILT_IN
from quadruped_env.task.randomization.randomization_presets import with_preset
from quadruped_env.task.terrain_section import leg_scale


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
    """Changes to the task's config; `randomization` may be the name of a preset. Lengths of the reward are those of the
    built-in robot."""
    on_gait: Mapping[str, Any] = field(default_factory=dict)
    """Further changes in the mode `residual`."""


RECIPES: Final[Mapping[str, Recipe]] = MappingProxyType(
    {
        # With a friction of its own in each episode, the policy turns by its gyroscope.
        "flat": Recipe(
            "level ground of any friction, and an undisturbed robot",
            {"asymmetric_critic": True},
            task={"randomization": {"friction": [0.6, 1.0]}},
        ),
        "robust": Recipe(
            "another robot in each episode, with sensor noise, latency and pushes",
            {"timesteps": 3_000_000, "asymmetric_critic": True},
            # With more exploration the policy gives up walking: a robot that stands does not fall.
            # So it does not learn to survive a push either: the reflex does.
            {"hidden": (128, 128), "log_std_init": -3.0, "final_log_std": -4.5, "reflex_rounds": 8},
            {
                # A push that catches two feet in the air tips the robot over the more easily, the higher they are.
                "action": {"gait": "low"},
                "clock_frequency": 5.0,
                # More pushes than in the preset: in 20 s most robots survive those.
                "randomization": {"preset": "hard", "push_speed": [0.5, 1.0], "push_interval": [1.0, 2.0]},
                "reward": {
                    # By default a fall costs about a second's reward: less than what a policy that follows its commands
                    # a little better earns between two falls.
                    "foot_lift": 0.006,
                },
            },
        ),
        "rough": Recipe(
            "all kinds of terrain, with a curriculum, and moderate randomization",
            {"timesteps": 6_000_000, "asymmetric_critic": True},
            # To learn what the scripted gait does not do needs more noise than to keep what it does.
            {
                # For a hundred tiles: with 256 robots one of five seeds did not learn the steepest slopes.
                "num_envs": 512,
                "n_steps": 24,
                "batch_size": 6144,
                "learning_rate": 2e-3,
                "hidden": (128, 128),
                "log_std_init": -1.0,
                "final_log_std": -4.0,
            },
            # On straighter legs it climbs lower steps.
            {
                "action": {"gait": "crouched"},
                # A foot has more time to rise above a step than at the gait's own 3.6 Hz; at 2.5 Hz strides are so long
                # that the fore feet run into a slope.
                "clock_frequency": 3.0,
                "terrain": {
                    "name": "tiles",
                    "curriculum": True,
                    # Slopes and steps are learned last.
                    "kinds": ["flat", *["slope"] * 3, "rough", *["steps"] * 2, "stairs", "gaps", "wave"],
                },
                "randomization": "moderate",
                "reward": {"foot_lift": 0.045},
            },
        ),
        "fast": Recipe(
            "commands up to 0.9 m/s and 1.5 rad/s, with longer strides",
            {"timesteps": 5_000_000},
            # With as much noise as for terrain the policy becomes no faster than its gait, with as little as for level
            # ground slower.
            {"n_steps": 32, "hidden": (128, 128), "log_std_init": -2.2, "final_log_std": -4.5},
            {
                "action": {"gait": "fast"},
                "clock_frequency": 3.2,
                "command": {"forward_velocity": [-0.4, 0.9], "yaw_rate": [-1.5, 1.5]},
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


def task_values(name: str, robot: Robot, action_mode: str) -> dict[str, Any]:
    """Changes of a recipe to the task's config in an action mode, for a robot, as plain values.

    The preset is replaced by its values. They and the lengths of the reward follow the robot's size.

    Raises:
        QuadrupedError: if there is no such recipe.
    """
    entry = recipe(name)
    values = changed(entry.task, entry.on_gait if action_mode == "residual" else {})
    if "randomization" in values:
        values["randomization"] = with_preset(values["randomization"], robot)
    if "reward" in values:
        parameters = [item for term in BUILT_IN.rewards for item in term.parameters.items()]
        lengths = {key for key, (parameter, _) in parameters if parameter.scales}
        scale = leg_scale(robot)
        values["reward"] = {key: scale * value if key in lengths else value for key, value in values["reward"].items()}
    return values
