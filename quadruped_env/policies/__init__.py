"""What decides: controllers, and trained policies as data."""

from quadruped_env.control.controllers import (
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
    "GaitController",
    "Policy",
    "PolicyController",
    "TrajectoryController",
    "ZeroController",
    "load_policy",
]
