"""Controllers, which compute joint targets from observations."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.clock import CommandedFrequency
from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.gait import CommandedGait, SinusoidalGait
from quadruped_env.robot.robot import Robot, check_same_robot

if TYPE_CHECKING:
    from quadruped_env.policies.policy_data import PolicyData
    from quadruped_env.trajectory import JointTrajectory

Floats = NDArray[np.float64]


class ZeroController:
    """Zero action: the robot stands, or in mode `residual` walks with the scripted gait.

    Args:
        action_mode: action mode of the task.
    """

    name = "zero"

    def __init__(self, action_mode: str = "position") -> None:
        self.action_mode = action_mode
        self.follows_command = action_mode == "residual"

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`."""
        return control.joint_target(np.zeros_like(control.action))


class GaitController:
    """A scripted gait as a function of the time since the reset; it ignores the command.

    It has no part in the task's gait clock, so the reward's terms of the clock say nothing about it.
    """

    action_mode = "position"
    follows_command = False

    def __init__(self, gait: SinusoidalGait, name: str) -> None:
        self.gait = gait
        self.name = name

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`."""
        return self.gait.positions(control.time)


class CommandedGaitController:
    """The searched gait, adapted to each env's command.

    It steps with the task's gait clock, as the gait of `residual` mode does. A clock of another frequency it cannot
    follow: its phase is then that of its own frequency since the reset.

    Args:
        gait: the gait; None: the tuned one of the robot that is controlled.
        name: name in reports.
    """

    action_mode = "position"
    follows_command = True

    def __init__(self, gait: CommandedGait | None = None, name: str = "tuned") -> None:
        self.name = name
        self._gait = gait

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`."""
        gait = self._gait or CommandedGait.tuned(control.robot)
        clock = control.config.clock_frequency
        shared = not isinstance(clock, CommandedFrequency) and math.isclose(math.tau * clock, gait.angular_frequency)
        phase = control.phase if shared else gait.angular_frequency * control.time
        return gait.positions(phase, control.command)


class TrajectoryController:
    """Plays recorded joint positions back as joint targets, and holds the last ones at the end.

    Args:
        trajectory: the recording; time 0 is its first timestamp.
        name: name in reports.
    """

    action_mode = "position"
    follows_command = False

    def __init__(self, trajectory: "JointTrajectory", name: str = "recording") -> None:
        self.trajectory = trajectory
        self.name = name
        self._ordered: tuple[Robot, JointTrajectory] | None = None

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`.

        Raises:
            QuadrupedError: if the recording lacks a joint of the robot.
        """
        return self.positions_at(control.robot, control.time)

    def positions_at(self, robot: Robot, seconds: Floats) -> Floats:
        """Recorded positions of a robot's joints (N, J) in rad at times (N,) in s."""
        if self._ordered is None or self._ordered[0] is not robot:
            self._ordered = robot, self.trajectory.in_joint_order(robot)
        return self._ordered[1].positions_at(seconds)


class LoopController(TrajectoryController):
    """Plays a recording from its beginning again when it ends."""

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`."""
        # One control step lies between the last sample and the first.
        period = self.trajectory.duration + control.config.timestep
        return self.positions_at(control.robot, control.time % period)


class PolicyController:
    """A trained policy."""

    follows_command = True

    def __init__(self, policy: "PolicyData", name: str = "policy") -> None:
        self.policy = policy
        self.name = name
        self.action_mode = policy.action_mode
        self._checked: ControlConfig | None = None

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`.

        Raises:
            QuadrupedError: if the policy is for another robot, or its actions or observations have another meaning in
                this task.
        """
        if control.config is not self._checked:
            check_same_robot(self.policy.robot.identity, control.robot)
            self.policy.check_control(control.config)
            self.policy.check_observations(control.layout)
            self._checked = control.config
        if (begun := control.steps == 1).any():
            self.policy.begin(begun)
        return control.joint_target(self.policy.predict(observation))
