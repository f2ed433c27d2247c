"""Scripted gaits: joint positions as sinusoids of time or phase, their presets, and a user's changes to them."""

from quadruped_env.gait.fitness import fitness
from quadruped_env.gait.gait_presets import CLOCK_FREQUENCY, COMMANDED, LEG_PHASES, PRESETS, SINUSOID, LegTable
from quadruped_env.gait.gaits import CommandedGait, SinusoidalGait, has_tuned_shape, turn_size
from quadruped_env.gait.waves import joint_phases, leg_phases, wave_positions

__all__ = [
    "CLOCK_FREQUENCY",
    "COMMANDED",
    "LEG_PHASES",
    "PRESETS",
    "SINUSOID",
    "CommandedGait",
    "LegTable",
    "SinusoidalGait",
    "fitness",
    "has_tuned_shape",
    "joint_phases",
    "leg_phases",
    "turn_size",
    "wave_positions",
]
