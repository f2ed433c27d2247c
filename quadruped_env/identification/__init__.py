"""System identification: the motors that explain what a robot's joints did when they were told something.

The simulator hears the recorded commands, and its motors are changed until its joints do what was measured: a
nonlinear least-squares fit with MuJoCo's own toolbox, `mujoco.sysid`. The first part of the recording is for the fit;
the rest is held out and says whether the fit is any good.
"""

from quadruped_env.identification.dataset import find_commands
from quadruped_env.identification.identify import BASES, Identification, identify
from quadruped_env.identification.quantities import FITTED, QUANTITIES

__all__ = ["BASES", "FITTED", "QUANTITIES", "Identification", "find_commands", "identify"]
