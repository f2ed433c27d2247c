"""Height at which a robot is placed on its ground."""

import numpy as np
from numpy.typing import NDArray

from quadruped_env.simulation.simulation_interface import Simulation


def highest_ground(simulation: Simulation, positions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Height (...,) of the highest ground below a simulation's robot at positions (..., 2 or 3), m."""
    if simulation.height_field is None:
        return np.zeros_like(positions[..., 0])
    return simulation.height_field.highest(positions, simulation.robot.footprint)
