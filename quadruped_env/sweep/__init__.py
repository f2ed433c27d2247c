"""Many trainings at once on Ray Tune: seeds of one config, and searches over the settings of task and training."""

from quadruped_env.sweep.search_space import Dimension
from quadruped_env.sweep.sweep_definition import SweepConfig

__all__ = ["Dimension", "SweepConfig"]
