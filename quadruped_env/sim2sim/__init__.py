"""A policy in a second engine: the same episodes in MuJoCo and, from the robot's URDF alone, in Drake."""

from quadruped_env.sim2sim.engines import Drake, MuJoCo
from quadruped_env.sim2sim.transfer import Transfer, run_transfer

__all__ = ["Drake", "MuJoCo", "Transfer", "run_transfer"]
