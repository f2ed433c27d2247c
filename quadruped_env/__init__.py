"""MiniQuadruped: a Gymnasium environment around a MuJoCo model of an eight-joint quadruped.

import gymnasium
import quadruped_env

env = gymnasium.make("MiniQuadruped-v0")
"""

import sys

if sys.version_info < (3, 11):  # noqa: UP036 - a checkout needs no installation, which would check it
    raise ImportError(f"mini-quadruped needs Python 3.11 or later; this is {sys.executable}, {sys.version.split()[0]}")

import importlib
from typing import TYPE_CHECKING, Any, Final

from quadruped_env._version import __version__
from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning
from quadruped_env.gait import CommandedGait, SinusoidalGait
from quadruped_env.robot import JOINT_NAMES, LEG_NAMES, asset_path, forward_kinematics
from quadruped_env.utils.registration import register_envs

if TYPE_CHECKING:
    from quadruped_env import envs, policies
    from quadruped_env.api import evaluate, page, train
    from quadruped_env.evaluation.comparison import compare
    from quadruped_env.policies import load_policy
    from quadruped_env.simulation import build_model
    from quadruped_env.trajectory import JointState, JointTrajectory

__all__ = [
    "JOINT_NAMES",
    "LEG_NAMES",
    "CommandedGait",
    "JointState",
    "JointTrajectory",
    "MissingExtraError",
    "QuadrupedError",
    "QuadrupedWarning",
    "SinusoidalGait",
    "__version__",
    "asset_path",
    "build_model",
    "compare",
    "envs",
    "evaluate",
    "forward_kinematics",
    "load_policy",
    "page",
    "policies",
    "train",
]

_PACKAGES: Final = ("control", "envs", "policies", "simulation", "task", "trajectory")
_DEFINED_IN: Final = {
    "JointState": "trajectory",
    "JointTrajectory": "trajectory",
    "build_model": "simulation",
    "compare": "evaluation.comparison",
    "load_policy": "policies",
    **dict.fromkeys(("evaluate", "page", "train"), "api"),
}

register_envs()


def __getattr__(name: str) -> Any:
    """Packages, and names in them, that are imported when they are first used."""
    if name in _PACKAGES:
        return importlib.import_module(f"{__name__}.{name}")
    if name in _DEFINED_IN:
        return getattr(importlib.import_module(f"{__name__}.{_DEFINED_IN[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
