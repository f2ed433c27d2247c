"""Trained policies, and controllers that need no policy.

A robot's controller loads policies as data, with modules of this package that need no task; the rest is imported when
it is first used.
"""

from typing import TYPE_CHECKING, Any

from quadruped_env.control.control_interface import Controller
from quadruped_env.control.controllers import (
    GaitController,
    PolicyController,
    TrajectoryController,
    ZeroController,
)
from quadruped_env.policies.by_name import ControllerSpec, find_controller
from quadruped_env.policies.files import DEFAULT, SHIPPED
from quadruped_env.policies.policy_data import PolicyData

if TYPE_CHECKING:
    from quadruped_env.policies.choices import find_controllers
    from quadruped_env.policies.policy import Agent, Policy, as_policy, at_checkpoint, load_policy, task_note, task_of

__all__ = [
    "DEFAULT",
    "SHIPPED",
    "Agent",
    "Controller",
    "ControllerSpec",
    "GaitController",
    "Policy",
    "PolicyController",
    "PolicyData",
    "TrajectoryController",
    "ZeroController",
    "as_policy",
    "at_checkpoint",
    "find_controller",
    "find_controllers",
    "load_policy",
    "task_note",
    "task_of",
]


def __getattr__(name: str) -> Any:
    """Names that need the task."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from quadruped_env.policies import choices, policy

    return getattr(choices if name == "find_controllers" else policy, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
