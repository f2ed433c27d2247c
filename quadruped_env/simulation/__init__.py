"""Simulation of the robot on its terrain: the model, one interface, and two drivers with bit-identical results."""

from quadruped_env.simulation.batch_simulation import BatchSimulation
from quadruped_env.simulation.built_in_terrains import TERRAINS, find_terrain, flat
from quadruped_env.simulation.model import build_model
from quadruped_env.simulation.simulation_interface import Simulation, highest_ground
from quadruped_env.simulation.single_simulation import SingleSimulation
from quadruped_env.simulation.terrain import Grid, Terrain, Tiles

__all__ = [
    "TERRAINS",
    "BatchSimulation",
    "Grid",
    "Simulation",
    "SingleSimulation",
    "Terrain",
    "Tiles",
    "build_model",
    "find_terrain",
    "flat",
    "highest_ground",
]
