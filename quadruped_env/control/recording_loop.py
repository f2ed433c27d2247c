"""Playback of a recording in a loop."""

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.controllers import TrajectoryController


class LoopController(TrajectoryController):
    """Plays a recording from its beginning again when it ends."""

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> NDArray[np.float64]:
        """See `Controller.act`."""
        # One control step lies between the last sample and the first.
        period = self.trajectory.duration + control.config.timestep
        return self.positions_at(control.robot, control.time % period)
