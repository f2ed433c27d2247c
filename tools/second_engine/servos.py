"""The law of the motors, from its documented formula, for an engine that has no motors of its own."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.motors import MotorConfig
from quadruped_env.utils.arrays import Floats


class Servos:
    """The position servos of N robots with J joints each, stepped together with an engine.

        wanted = kp (target - q) - kd w
        torque = clip(clip(wanted, -stall - slope w, stall - slope w), -stall, stall),   slope = stall / no_load_speed

    The target is the one of `delay` ago. Dry friction is not part of the motor's torque; `friction` computes it.

    Args:
        motors: gains, limits, friction and delay.
        kinds: kinds of the joints, in the order of the columns (J,); see `Robot.joint_kinds`.
        timestep: time step of the engine, s.
        num_robots: N.
    """

    def __init__(self, motors: MotorConfig, kinds: Sequence[str], timestep: float, num_robots: int = 1) -> None:
        of_joints = motors.of_joints(kinds)
        self._kp = np.array([motor.kp for motor in of_joints])
        self._kd = np.array([motor.kd for motor in of_joints])
        self._stall = np.array([motor.stall_torque for motor in of_joints])
        self._slope = self._stall / np.array([motor.no_load_speed for motor in of_joints])
        self._friction = np.array([motor.friction_loss for motor in of_joints])
        # A torque that stops the rotor alone within a step is stable on every joint, whose inertia is larger.
        self._stopping = np.array([motor.armature for motor in of_joints]) / timestep
        # Steps are counted from now backwards; between two of them the target is interpolated.
        self._age = motors.delay / timestep
        self._targets = np.zeros((math.ceil(self._age) + 1, num_robots, len(of_joints)))

    @property
    def has_friction(self) -> bool:
        """True if a joint has dry friction."""
        return bool(self._friction.any())

    def reset(self, robots: NDArray[np.intp], position: Floats) -> None:
        """Start some robots (R,) as if their targets had always been these positions (R, J) in rad."""
        self._targets[:, robots] = position

    def torque(self, target: Floats, position: Floats, velocity: Floats) -> Floats:
        """Return the motors' torques (N, J) in N m for the engine's next step, for joint targets sent now (N, J)."""
        if len(self._targets) > 1:
            self._targets[1:] = self._targets[:-1].copy()
        self._targets[0] = target
        wanted = self._kp * (self._delayed() - position) - self._kd * velocity
        back = self._slope * velocity
        within_line = np.clip(wanted, -self._stall - back, self._stall - back)
        return np.clip(within_line, -self._stall, self._stall)

    def friction(self, velocity: Floats) -> Floats:
        """Return the torques of the joints' dry friction (N, J) in N m at velocities (N, J) in rad/s.

        Below friction * timestep / armature, where full friction would turn the rotor back within a step, it is in
        proportion to the speed: a joint at rest creeps under a load instead of sticking.
        """
        return -np.clip(self._stopping * velocity, -self._friction, self._friction)

    def _delayed(self) -> Floats:
        whole = math.floor(self._age)
        part = self._age - whole
        newer = self._targets[whole]
        return newer if part == 0.0 else (1.0 - part) * newer + part * self._targets[whole + 1]
