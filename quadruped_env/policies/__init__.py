"""What decides: controllers, and trained policies as data."""

from quadruped_env.policies.by_name import ControllerSpec, find_controller, find_controllers
from quadruped_env.policies.controllers import (
    CommandedGaitController,
    Controller,
    GaitController,
    PolicyController,
    TrajectoryController,
    ZeroController,
)
from quadruped_env.policies.policy import Policy, load_policy

__all__ = [
    "CommandedGaitController",
    "Controller",
    "ControllerSpec",
    "GaitController",
    "Policy",
    "PolicyController",
    "TrajectoryController",
    "ZeroController",
    "find_controller",
    "find_controllers",
    "load_policy",
]
