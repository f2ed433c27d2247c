"""Simulation of the robot: one interface, and two drivers with bit-identical results."""

from quadruped_env.simulation.batch import BatchSimulation
from quadruped_env.simulation.interface import Simulation
from quadruped_env.simulation.model import build_model
from quadruped_env.simulation.single import SingleSimulation

__all__ = ["BatchSimulation", "Simulation", "SingleSimulation", "build_model"]
