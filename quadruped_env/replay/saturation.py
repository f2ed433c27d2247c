"""Motor saturation in a replay: requested torques that exceed the motors' limits."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import MotorConfig
from quadruped_env.trajectory import JointTrajectory


@dataclass(frozen=True)
class Saturation:
    """Requested torques of the joints, sampled at the ends of the control steps."""

    joint_names: tuple[str, ...]
    """(J,)"""
    asked: NDArray[np.float64]
    """Torque that the controller requested, N m (T, J)"""
    excess: NDArray[np.float64]
    """Part of the torque beyond the motor's limit at its speed, N m (T, J); 0 within the limit"""
    times: NDArray[np.float64]
    """Times of the samples, s (T,)"""

    def report(self) -> dict[str, dict[str, Any]]:
        """Joint -> fraction of time at its motor's limit, largest requested torque, and time of first saturation."""
        at_limit = self.excess > 0.0
        return {
            name: {
                "share": float(at_limit[:, i].mean()),
                "largest_torque_asked": float(np.abs(self.asked[:, i]).max()),
                "first_at": float(self.times[at_limit[:, i]][0]) if at_limit[:, i].any() else None,
            }
            for i, name in enumerate(self.joint_names)
        }


def saturation(
    targets: JointTrajectory, played: JointTrajectory, motors: MotorConfig, kinds: Sequence[str]
) -> Saturation:
    """Compute the torques that the controllers requested, from joint targets and measured motion.

    Args:
        targets: joint targets.
        played: measurements of the simulation with velocities, one row at the end of each control step; its joints
            have the order of the targets'.
        motors: motors of the simulation.
        kinds: kinds of the joints (`Robot.joint_kinds`).
    """
    assert played.velocities is not None
    times = played.times
    step = float(np.median(np.diff(times))) if len(times) > 1 else 0.0
    # A target is held over its control step, and arrives later by the motors' delay.
    sent = np.maximum(np.ceil((times - motors.delay) / step - 1e-6) - 1.0, 0.0) * step if step else times
    speed = played.velocities
    kp, kd, stall, top = (
        np.array([getattr(motor, name) for motor in motors.of_joints(kinds)])
        for name in ("kp", "kd", "stall_torque", "no_load_speed")
    )
    asked = kp * (targets.positions_at(sent) - played.positions) - kd * speed
    slope = stall / top
    excess = np.maximum(asked - np.minimum(stall, stall - slope * speed), 0.0)
    excess += np.maximum(np.maximum(-stall, -stall - slope * speed) - asked, 0.0)
    return Saturation(played.names, asked, excess, times)
