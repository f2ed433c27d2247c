"""How the robot moves: one interface, and two drivers that give the same numbers to the last bit."""

from quadruped_env.simulation.batch import BatchSimulation
from quadruped_env.simulation.interface import Simulation
from quadruped_env.simulation.single import SingleSimulation

__all__ = ["BatchSimulation", "Simulation", "SingleSimulation"]
