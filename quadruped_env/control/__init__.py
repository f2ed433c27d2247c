"""Control in training and on a real robot: observations from readings, and joint targets from observations."""

from quadruped_env.control.control_config import ActionConfig, Command, ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.observations import OBSERVATIONS, ObservationField, ObservationLayout, observation

__all__ = [
    "OBSERVATIONS",
    "ActionConfig",
    "Command",
    "ControlConfig",
    "ControlInterface",
    "ObservationField",
    "ObservationLayout",
    "observation",
]
