"""A recording that is played over and over."""

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.controllers import TrajectoryController
from quadruped_env.control.interface import ControlInterface


class LoopController(TrajectoryController):
    """Plays a recording again from its beginning when it ends."""

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> NDArray[np.float64]:
        """See `Controller.act`."""
        # One more step lies between the last row and the first.
        return self.trajectory.positions_at(control.time % (self.trajectory.duration + control.config.timestep))
