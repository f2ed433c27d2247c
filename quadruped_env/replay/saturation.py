"""Where a replay asked more of the motors than they can give."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import JOINT_NAMES, MotorConfig
from quadruped_env.trajectory import JointTrajectory


@dataclass(frozen=True)
class Saturation:
    """What each of the eight joints asked of its motor, sampled at the ends of the control steps."""

    asked: NDArray[np.float64]
    """Torque (T, 8) in N m that the controller wanted"""
    excess: NDArray[np.float64]
    """By how much that was over what the motor can give at its speed, N m (T, 8); 0 where it was not"""
    times: NDArray[np.float64]
    """s (T,)"""

    def report(self) -> dict[str, dict[str, Any]]:
        """Joint -> share of the time at its motor's limit, largest torque wanted, and when the limit was first met."""
        at_limit = self.excess > 0.0
        return {
            name: {
                "share": float(at_limit[:, i].mean()),
                "largest_torque_asked": float(np.abs(self.asked[:, i]).max()),
                "first_at": float(self.times[at_limit[:, i]][0]) if at_limit[:, i].any() else None,
            }
            for i, name in enumerate(JOINT_NAMES)
        }


def saturation(targets: JointTrajectory, played: JointTrajectory, motors: MotorConfig) -> Saturation:
    """What the motors were asked for, from their targets and from what the joints did.

    Args:
        targets: joint targets, in the order of `JOINT_NAMES`.
        played: measured in the simulation, a row at the end of every control step, with velocities.
        motors: those of the simulation.
    """
    assert played.velocities is not None
    times = played.times
    step = float(np.median(np.diff(times))) if len(times) > 1 else 0.0
    # A target is held over its control step, and arrives later by the motors' delay.
    sent = np.maximum(np.ceil((times - motors.delay) / step - 1e-6) - 1.0, 0.0) * step if step else times
    speed = played.velocities
    of_joint = [motors.of_joint(name) for name in JOINT_NAMES]
    kp, kd, stall, top = (
        np.array([getattr(motor, name) for motor in of_joint]) for name in ("kp", "kd", "stall_torque", "no_load_speed")
    )
    asked = kp * (targets.positions_at(sent) - played.positions) - kd * speed
    slope = stall / top
    excess = np.maximum(asked - np.minimum(stall, stall - slope * speed), 0.0)
    excess += np.maximum(np.maximum(-stall, -stall - slope * speed) - asked, 0.0)
    return Saturation(asked, excess, times)
