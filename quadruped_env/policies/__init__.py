"""Trained policies together with their tasks, and controllers that need no policy."""

from quadruped_env.control.by_name import ControllerSpec
from quadruped_env.control.control_interface import Controller
from quadruped_env.control.controllers import (
    CommandedGaitController,
    GaitController,
    PolicyController,
    TrajectoryController,
    ZeroController,
)
from quadruped_env.control.policy import Agent, Policy
from quadruped_env.control.policy_files import DEFAULT, SHIPPED
from quadruped_env.policies.code_policies import as_policy
from quadruped_env.policies.policy_loading import (
    at_checkpoint,
    find_controller,
    find_controllers,
    kept_definition,
    load_policy,
    task_differences,
    task_of,
    trained_with,
)
from quadruped_env.policies.policy_task import with_task

__all__ = [
    "DEFAULT",
    "SHIPPED",
    "Agent",
    "CommandedGaitController",
    "Controller",
    "ControllerSpec",
    "GaitController",
    "Policy",
    "PolicyController",
    "TrajectoryController",
    "ZeroController",
    "as_policy",
    "at_checkpoint",
    "find_controller",
    "find_controllers",
    "kept_definition",
    "load_policy",
    "task_differences",
    "task_of",
    "trained_with",
    "with_task",
]
