"""Commands to the robot's motors: valid joint targets within the limits, or limp (motors disabled)."""

import math
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

LIMP: Final = None
"""Value that is sent instead of joint targets to disable the motors."""

Target = Floats | None
"""Joint targets (J,) in rad, or `LIMP`."""

MAX_TARGET: Final = 1e12
"""Largest joint target that may be sent, in the motors' unit, such as ticks of an encoder; larger ones follow from
damaged data or maps."""
MAX_MEASURED: Final = 1e3
"""Largest position and velocity that a measurement may hold, rad and rad/s."""
INVALID_TIMEOUT: Final = 0.2
"""Time of invalid joint targets after which the motors are disabled, s."""
_ROUNDING: Final = 1e-6


class TargetGate:
    """Decides which joint targets may reach the motors: those that are finite and at most `MAX_TARGET`.

    In place of invalid targets, the last valid ones are sent again, and after `INVALID_TIMEOUT` the motors are
    disabled. Valid targets in between do not prolong this time unless they last as long. At the first invalid target
    `say` is called with a line of text.
    """

    def __init__(self, joints: Sequence[str], say: Callable[[str], None]) -> None:
        self.fault = ""
        """Description of an invalid target; empty after `INVALID_TIMEOUT` of valid ones."""
        self._joints, self._say = joints, say
        self._since = self._latest = -math.inf

    def passes(self, target: Floats, now: float) -> bool:
        """True if joint targets (J,) may be sent; otherwise, send the last valid ones again. `now` is in s.

        Raises:
            QuadrupedError: if targets were invalid for `INVALID_TIMEOUT`: disable the motors.
        """
        invalid = ~(np.abs(target) <= MAX_TARGET)
        if not invalid.any():
            if now - self._latest > INVALID_TIMEOUT:
                self.fault = ""
            return True
        if not self.fault:
            joint = int(invalid.argmax())
            self.fault, self._since = f"the joint target of {self._joints[joint]} is {target[joint]}", now
            self._say(f"{self.fault}: the last valid targets are held")
        self._latest = now
        if now - self._since >= INVALID_TIMEOUT - _ROUNDING:
            raise QuadrupedError(f"{self.fault}; check the policy with 'evaluate', and --map")
        return False


def limited(robot: Robot, target: Floats, last: Floats, seconds: float) -> Floats:
    """Joint targets within the joints' ranges that change no faster than the robot's velocity limit.

    They are finite whatever the arguments are: a joint whose target is NaN keeps its last one, and one whose last one
    is not finite either goes to the stance. `last` are the previous targets or the measured positions, `seconds` ago;
    all are (J,) in rad.
    """
    reach = robot.velocity_limit * seconds
    low, high = robot.joint_position_low, robot.joint_position_high
    last = np.where(np.isfinite(last), last, robot.stance)
    within = np.minimum(np.maximum(np.where(np.isnan(target), last, target), low), high)
    # The range takes precedence over the velocity limit: joints outside it return to it at once.
    near = np.minimum(np.maximum(within, last - reach), last + reach)
    return np.minimum(np.maximum(near, low), high)
