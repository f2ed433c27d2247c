"""Playback of a recording over and over."""

import numpy as np
from numpy.typing import NDArray

from quadruped_env.policies.controllers import TrajectoryController
from quadruped_env.task import Task, Transition


class LoopController(TrajectoryController):
    """Plays a recording, and starts it again when it ends."""

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `quadruped_env.policies.Controller.step`."""
        time = task.steps * task.config.control_timestep
        # One control step lies between the last sample and the first.
        return task.step_joint_target(
            self.trajectory.positions_at(time % (self.trajectory.duration + task.config.control_timestep))
        )
