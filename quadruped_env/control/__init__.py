"""Control: from readings to observations, and from observations to joint targets, in training and on a real robot."""

from quadruped_env.control.config import ActionConfig, Command, ControlConfig
from quadruped_env.control.controllers import (
    CommandedGaitController,
    Controller,
    GaitController,
    PolicyController,
    TrajectoryController,
    ZeroController,
)
from quadruped_env.control.interface import ControlInterface
from quadruped_env.control.observations import OBSERVATIONS, ObservationField, ObservationLayout, observation

__all__ = [
    "OBSERVATIONS",
    "ActionConfig",
    "Command",
    "CommandedGaitController",
    "ControlConfig",
    "ControlInterface",
    "Controller",
    "GaitController",
    "ObservationField",
    "ObservationLayout",
    "PolicyController",
    "TrajectoryController",
    "ZeroController",
    "observation",
]
