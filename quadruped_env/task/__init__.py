"""The task: config, terms (rewards, terminations, randomizations, commands), and the `Task` that runs episodes."""

from quadruped_env.control.config import ActionConfig, Command
from quadruped_env.control.observations import ObservationField, observation
from quadruped_env.control.task_file import TaskFile
from quadruped_env.task.config import (
    CommandConfig,
    RandomizationConfig,
    RewardConfig,
    TaskConfig,
    TerminationConfig,
)
from quadruped_env.task.context import TaskContext
from quadruped_env.task.definition import BUILT_IN, TaskDefinition, load_task_file
from quadruped_env.task.randomization import Event, ModelField, Randomization
from quadruped_env.task.settings import Section
from quadruped_env.task.task import Task, Transition
from quadruped_env.task.terms import Parameter, RewardTerm, Termination, reward, reward_group, termination

__all__ = [
    "BUILT_IN",
    "ActionConfig",
    "Command",
    "CommandConfig",
    "Event",
    "ModelField",
    "ObservationField",
    "Parameter",
    "Randomization",
    "RandomizationConfig",
    "RewardConfig",
    "RewardTerm",
    "Section",
    "Task",
    "TaskConfig",
    "TaskContext",
    "TaskDefinition",
    "TaskFile",
    "Termination",
    "TerminationConfig",
    "Transition",
    "load_task_file",
    "observation",
    "reward",
    "reward_group",
    "termination",
]
