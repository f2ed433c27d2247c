"""What the robot should do: config, commands, observations, rewards, terminations, randomization, and the `Task`."""

from quadruped_env.task.config import (
    ActionConfig,
    CommandConfig,
    RandomizationConfig,
    RewardConfig,
    TaskConfig,
    TerminationConfig,
)
from quadruped_env.task.observations import OBSERVATION_LAYOUT, OBSERVATION_WIDTH
from quadruped_env.task.task import ACTION_WIDTH, Task, Transition

__all__ = [
    "ACTION_WIDTH",
    "OBSERVATION_LAYOUT",
    "OBSERVATION_WIDTH",
    "ActionConfig",
    "CommandConfig",
    "RandomizationConfig",
    "RewardConfig",
    "Task",
    "TaskConfig",
    "TerminationConfig",
    "Transition",
]
