"""Motor saturation in a replay: requested torques that exceed the motors' limits."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import MotorConfig
from quadruped_env.trajectory import JointTrajectory


def saturation(
    targets: JointTrajectory, played: JointTrajectory, motors: MotorConfig, kinds: Sequence[str]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Torques that the controllers requested, and their part beyond the motors' limits, N m, each (T, J).

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
    return asked, excess
