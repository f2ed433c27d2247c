"""Controllers: each advances a task by one control step in its own way."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quadruped_env.gait import CommandedGait, SinusoidalGait
from quadruped_env.policies.policy import Policy
from quadruped_env.task import ACTION_WIDTH, Task, TaskConfig, Transition
from quadruped_env.trajectory import JointTrajectory


class Controller(Protocol):
    """Something that can walk, or fail to."""

    name: str
    action_mode: str
    """The action mode of the task that it must be run on"""

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """Advance every row of the task by one control step, given its current observation (N, obs)."""
        ...


class ZeroController:
    """The zero action: it stands."""

    name = "zero"
    action_mode = "position"

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `Controller.step`."""
        return task.step(np.zeros((task.num_rows, ACTION_WIDTH)))


class GaitController:
    """A scripted gait by the clock, whatever the command."""

    action_mode = "position"

    def __init__(self, gait: SinusoidalGait, name: str) -> None:
        self.gait = gait
        self.name = name

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `Controller.step`."""
        return task.step_joint_target(self.gait.positions(task.steps * task.config.control_timestep))


class CommandedGaitController:
    """The tuned gait, bent to each row's command."""

    action_mode = "position"

    def __init__(self, gait: CommandedGait | None = None, name: str = "tuned") -> None:
        self.gait = gait or CommandedGait.tuned()
        self.name = name

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `Controller.step`."""
        phase = self.gait.angular_frequency * task.steps * task.config.control_timestep
        return task.step_joint_target(self.gait.positions(phase, task.command))


class TrajectoryController:
    """Plays recorded joint positions back through the motors, holding the last ones at the end.

    Args:
        trajectory: the recording; its time starts at its first stamp.
        name: what reports call it.
    """

    action_mode = "position"

    def __init__(self, trajectory: JointTrajectory, name: str = "recording") -> None:
        self.trajectory = trajectory
        self.name = name

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `Controller.step`."""
        return task.step_joint_target(self.trajectory.positions_at(task.steps * task.config.control_timestep))


class PolicyController:
    """A trained policy."""

    def __init__(self, policy: Policy, name: str = "policy") -> None:
        self.policy = policy
        self.name = name
        self.action_mode = policy.action_mode
        self._checked: TaskConfig | None = None

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `Controller.step`.

        Raises:
            QuadrupedError: if the policy's actions mean something else in this task.
        """
        if task.config is not self._checked:
            self.policy.check_task(task.config)
            self._checked = task.config
        return task.step(self.policy.predict(observation))
