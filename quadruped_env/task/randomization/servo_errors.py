"""Errors with which position servos follow their joint targets: steps of the input, backlash, dead band."""

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.robot.motors import SERVO_ERRORS, MotorConfig, servo_target
from quadruped_env.simulation import Simulation
from quadruped_env.utils.arrays import Floats


class ServoErrors:
    """Errors of the servos of N robots, constant during an episode; see `servo_target`.

    They are computed once per control step. The motors' own errors are the least. The servos' delay comes after them,
    in the simulation.
    """

    def __init__(self, simulation: Simulation, motors: MotorConfig) -> None:
        robot = simulation.robot
        self.memory = EpisodeMemory(simulation.num_envs)
        self._least: list[Floats] = list(motors.servo_errors(robot.joint_kinds))
        self._values: list[Floats] = [self.memory.zeros(name, robot.num_joints) for name in SERVO_ERRORS]
        self._play: Floats = self.memory.zeros("play", robot.num_joints)

    def clear(self, env_ids: NDArray[np.intp]) -> None:
        """Set the errors of some envs (R,) to the motors' own."""
        for values, least in zip(self._values, self._least, strict=True):
            values[env_ids] = least

    def add(self, quantity: str, env_ids: NDArray[np.intp], values: Floats) -> None:
        """Add values (R, 1) or (R, J) in rad to the motors' own error in some envs (R,)."""
        i = SERVO_ERRORS.index(quantity)
        self._values[i][env_ids] = self._least[i] + values

    def start(self, env_ids: NDArray[np.intp], position: Floats) -> None:
        """Let the gears of some envs (R,) begin at measured joint positions (R, J) in rad."""
        self._play[env_ids] = position

    def joint_target(self, target: Floats, position: Floats) -> Floats:
        """Return the positions (N, J) that the gains pull to, for targets and measured positions (N, J); all in rad."""
        return servo_target(target, position, self._play, *self._values)
