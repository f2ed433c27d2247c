"""Controllers, which compute joint targets from observations."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.gait import CommandedGait, SinusoidalGait
from quadruped_env.gait.gait_settings import GaitSettings, edited
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

if TYPE_CHECKING:
    from quadruped_env.policies.policy_data import PolicyData
    from quadruped_env.trajectory import JointTrajectory


class ZeroController:
    """Zero action: the robot stands, or in a task of the mode `residual` walks with the scripted gait."""

    name = "zero"

    def __init__(self, action_mode: str = "position") -> None:
        self.action_mode = action_mode
        self.follows_command = action_mode == "residual"

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`."""
        return control.joint_target(np.zeros_like(control.action))


class GaitController:
    """A scripted gait, whose settings can be changed at any time without a jump in its phase.

    A gait that follows the command steps with the task's gait clock, as in `residual` mode, if the clock has
    its frequency. Every other gait has a phase of its own, which begins at 0 with the episode. Without a gait it is the
    tuned one of the robot that is controlled, which follows the command.
    """

    action_mode = "position"

    def __init__(self, gait: SinusoidalGait | CommandedGait | None = None, name: str = "tuned") -> None:
        self.gait = gait
        self.name = name
        self.follows_command = not isinstance(gait, SinusoidalGait)
        self._settings: GaitSettings | None = None
        self._phase = 0.0
        """Phase of the gait of env 0, rad."""
        self._command: tuple[float, ...] | None = None

    @property
    def settings(self) -> GaitSettings:
        """Current settings. Once they are changed, only one robot can be controlled."""
        return self._settings or GaitSettings.of(self._preset())

    @settings.setter
    def settings(self, settings: GaitSettings) -> None:
        self._settings = settings

    def complaints(self) -> list[str]:
        """Messages about joint limits that the gait exceeds; empty if there are none."""
        return self._current().violations()

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`."""
        if self.gait is None:
            self.gait = CommandedGait.preset("tuned", control.robot)
        gait, clock = self.gait, control.config.clock_frequency
        self._command = tuple(control.command[0].tolist())
        phase = gait.angular_frequency * control.time
        if isinstance(gait, CommandedGait) and math.isclose(math.tau * clock, gait.angular_frequency):
            phase = control.phase
        if self._settings is None or control.time[0] == 0.0:
            self._phase = float(phase[0])
        else:
            self._phase += math.tau * self._settings.frequency * control.config.timestep
        if self._settings is not None:
            changed = self._current()
            return changed.positions(np.array([self._phase / changed.angular_frequency]))
        if isinstance(gait, SinusoidalGait):
            return gait.positions(control.time)
        return gait.positions(phase, control.command)

    def _preset(self) -> SinusoidalGait:
        """The gait with its own settings, straight ahead."""
        assert self.gait is not None, "a gait that follows from the robot is known after the first step"
        return self.gait if isinstance(self.gait, SinusoidalGait) else self.gait.straight_ahead

    def _current(self) -> SinusoidalGait:
        """The gait of env 0 at the present command and settings."""
        gait, preset = self.gait, self._preset()
        now = gait.at(self._command) if isinstance(gait, CommandedGait) and self._command else preset
        if self._settings is None:
            return now
        # The hips' phases depend on the command; the settings are the preset's, so its phases are subtracted.
        phases = zip(GaitSettings.of(now).phases, self._settings.phases, GaitSettings.of(preset).phases, strict=True)
        shifted = tuple((phase + setting - base) % 1.0 for phase, setting, base in phases)
        return edited(now, replace(self._settings, phases=shifted))


class TrajectoryController:
    """Plays recorded joint positions back as joint targets; time 0 is the first timestamp.

    With `loop` it begins again one control step after the last row; otherwise the last positions are held.
    """

    action_mode = "position"
    follows_command = False

    def __init__(self, trajectory: "JointTrajectory", name: str = "recording", loop: bool = False) -> None:
        self.trajectory = trajectory
        self.name = name
        self._loop = loop
        self._ordered: tuple[Robot, JointTrajectory] | None = None

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """See `Controller.act`.

        Raises:
            QuadrupedError: if the recording lacks a joint of the robot.
        """
        robot, time = control.robot, control.time
        if self._ordered is None or self._ordered[0] is not robot:
            self._ordered = robot, self.trajectory.in_joint_order(robot)
        if self._loop:
            time = time % (self.trajectory.duration + control.config.timestep)
        return self._ordered[1].positions_at(time)


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
            self.policy.check_fits(control.robot, control.config, control.layout)
            self._checked = control.config
        if (begun := control.steps == 1).any():
            self.policy.begin(begun)
        return control.joint_target(self.policy.predict(observation))
