"""The task: config, terms (rewards, terminations, randomizations, commands, terrains), and the `Task` that runs it."""

from quadruped_env.control.control_config import ActionConfig, Command
from quadruped_env.control.observations import ObservationField, observation
from quadruped_env.simulation.terrain import Grid, Terrain, terrain
from quadruped_env.task.command_sampling import CommandSection
from quadruped_env.task.context import TaskContext
from quadruped_env.task.privileged import PrivilegedReading, TrueState, privileged
from quadruped_env.task.randomization.model_fields import ModelField
from quadruped_env.task.randomization.randomization import Event, Randomization, SensorError
from quadruped_env.task.randomization.randomization_presets import PRESETS, preset_values
from quadruped_env.task.task import Task, Transition
from quadruped_env.task.task_config import (
    CommandConfig,
    RandomizationConfig,
    RewardConfig,
    TaskConfig,
    TerminationConfig,
    TerrainConfig,
)
from quadruped_env.task.task_definition import BUILT_IN, TaskDefinition, load_task_file
from quadruped_env.task.terms import RewardTerm, Termination, reward, reward_group, termination
from quadruped_env.utils.fields import Section
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.provenance import TaskFile

__all__ = [
    "BUILT_IN",
    "PRESETS",
    "ActionConfig",
    "Command",
    "CommandConfig",
    "CommandSection",
    "Event",
    "Grid",
    "ModelField",
    "ObservationField",
    "Parameter",
    "PrivilegedReading",
    "Randomization",
    "RandomizationConfig",
    "RewardConfig",
    "RewardTerm",
    "Section",
    "SensorError",
    "Task",
    "TaskConfig",
    "TaskContext",
    "TaskDefinition",
    "TaskFile",
    "Termination",
    "TerminationConfig",
    "Terrain",
    "TerrainConfig",
    "Transition",
    "TrueState",
    "load_task_file",
    "observation",
    "preset_values",
    "privileged",
    "reward",
    "reward_group",
    "termination",
    "terrain",
]
