"""Scripted gaits: joint positions as sinusoids of time or phase, their presets, and a user's changes to them."""

from quadruped_env.gait.gait_presets import COMMANDED, LEG_PHASES, PRESETS, LegTable
from quadruped_env.gait.gaits import CommandedGait, SinusoidalGait, turn_size
from quadruped_env.gait.waves import joint_phases, wave_positions

__all__ = [
    "COMMANDED",
    "LEG_PHASES",
    "PRESETS",
    "CommandedGait",
    "LegTable",
    "SinusoidalGait",
    "joint_phases",
    "turn_size",
    "wave_positions",
]
