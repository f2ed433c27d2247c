"""Many trainings at once on Ray Tune: seeds of one config, and searches over the settings of task and training."""

from quadruped_env.sweep.definition import SweepConfig
from quadruped_env.sweep.space import Dimension

__all__ = ["Dimension", "SweepConfig"]
