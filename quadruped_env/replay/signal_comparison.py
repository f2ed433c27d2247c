"""Comparison of recorded and simulated joint signals, and of requested torques with the motors' limits."""

from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MotorConfig
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.text_table import Table

SIGNALS: Final = {"positions": "rad", "velocities": "rad/s", "efforts": "N m"}
"""Array of a `JointTrajectory` -> unit."""

MAX_LAG: Final = 0.4
"""Maximum lag that `lag` finds, s."""
_LAG_STEP: Final = 0.002
"""Resolution of the lag, s."""
_LAG_ROWS: Final = 5000
"""Maximum number of rows used to find the lag."""
_ALIKE: Final = 0.05
"""Maximum error of a lag that fits as well as the best, over the range of the errors of all lags."""
_RISE: Final = 0.25
"""Minimum error between two such lags, over the same range."""
_MIN_RANGE: Final = 0.01
"""Minimum range of a joint's target for which a lag is computed, rad."""


def side_by_side(recorded: JointTrajectory, simulated: JointTrajectory) -> tuple[JointTrajectory, JointTrajectory]:
    """Return a recording and a simulation at the times of the simulation that the recording covers.

    Args:
        recorded: all joints of the simulation, on its clock. Missing velocities are computed from positions.
        simulated: measurements of the simulation.

    Raises:
        QuadrupedError: if they have no time in common, or a joint is missing.
    """
    inside = (simulated.stamps >= recorded.stamps[0]) & (simulated.stamps <= recorded.stamps[-1])
    if np.count_nonzero(inside) < 2:
        raise QuadrupedError(
            f"{recorded.source.name}: lasts from {recorded.stamps[0]} to {recorded.stamps[-1]} ns, the simulation from "
            f"{simulated.stamps[0]} to {simulated.stamps[-1]} ns; compare recordings from the same clock"
        )
    ordered = recorded.select(simulated.names)
    if ordered.velocities is None and len(ordered) > 1:
        ordered = ordered.differentiate()
    stamps = simulated.stamps[inside]
    return ordered.at(stamps), simulated.at(stamps)


def common_signals(recorded: JointTrajectory, simulated: JointTrajectory) -> dict[str, tuple[Floats, Floats]]:
    """Return the signals that both have: name in `SIGNALS` -> recorded and simulated values, each (T, J)."""
    pairs = {name: (getattr(recorded, name), getattr(simulated, name)) for name in SIGNALS}
    return {name: pair for name, pair in pairs.items() if pair[0] is not None and pair[1] is not None}


def comparison_report(recorded: JointTrajectory, simulated: JointTrajectory) -> dict[str, Any]:
    """Return the differences of a recording and a simulation at the same times as JSON-serializable values."""
    return {
        signal: {
            "unit": SIGNALS[signal],
            "joints": {name: _agreement(here[:, i], there[:, i]) for i, name in enumerate(simulated.names)},
        }
        for signal, (here, there) in common_signals(recorded, simulated).items()
    }


def comparison_table(report: dict[str, Any], source: str) -> Table:
    """Return a comparison as a table; `source` names the recording, and says if velocities were computed."""
    rows = []
    for signal, entry in report.items():
        for name, found in entry["joints"].items():
            cells = [found[key] for key in ("rms", "mean", "max", "correlation")]
            rows.append([f"{name}, {signal} ({entry['unit']})", *("-" if c is None else f"{c:.4f}" for c in cells)])
    return Table(
        "Recorded against simulated",
        ["simulated minus recorded", "RMS", "mean", "largest", "correlation"],
        rows,
        f"Recorded: {source}",
    )


def saturation(
    targets: JointTrajectory, played: JointTrajectory, motors: MotorConfig, kinds: Sequence[str]
) -> tuple[Floats, Floats]:
    """Return torques that the controllers requested, and their part beyond the motors' limits, N m, each (T, J).

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


def lag(target: JointTrajectory, played: JointTrajectory) -> list[float | None]:
    """Return the lag of each joint behind its target, s.

    The lag is the first time shift, up to `MAX_LAG`, with about the smallest error: a motion that repeats fits again
    after a period. None for a joint that hardly moves. Both trajectories have the same joints in the same order.
    """
    shifts = np.arange(0.0, MAX_LAG, _LAG_STEP)
    # At the start, target and motion are equal for every lag.
    rows = np.flatnonzero(played.times >= MAX_LAG)
    if len(rows) < 2:
        return [None] * len(played.names)
    rows = rows[:: -(-len(rows) // _LAG_ROWS)]
    times = played.times[rows] + (int(played.stamps[0]) - int(target.stamps[0])) / NS_PER_SECOND
    errors = np.array(
        [np.mean((played.positions[rows] - target.positions_at(times - shift)) ** 2, axis=0) for shift in shifts]
    )
    moving = np.ptp(target.positions, axis=0) > _MIN_RANGE
    return [
        float(shifts[_first_minimum(error)]) if moved else None for error, moved in zip(errors.T, moving, strict=True)
    ]


def _first_minimum(error: Floats) -> int:
    """Return the index of the first minimum of an error (K,) that is about as small as the smallest."""
    height = (error - error.min()) / max(float(np.ptp(error)), 1e-300)
    # Noise has minima within a valley, so valleys are parted by a clear rise.
    valleys = np.split(np.arange(len(error)), np.flatnonzero(np.diff(height > _RISE)) + 1)
    lowest = [int(valley[height[valley].argmin()]) for valley in valleys]
    return next(index for index in lowest if height[index] <= _ALIKE)


def _agreement(recorded: Floats, simulated: Floats) -> dict[str, float | None]:
    known = np.isfinite(recorded)
    if not known.any():
        return {"rms": None, "mean": None, "max": None, "correlation": None}
    difference = (simulated - recorded)[known]
    vary = min(np.ptp(recorded[known]), np.ptp(simulated[known])) > 1e-9
    return {
        "rms": float(np.sqrt(np.mean(difference**2))),
        "mean": float(np.mean(difference)),
        "max": float(np.max(np.abs(difference))),
        "correlation": float(np.corrcoef(recorded[known], simulated[known])[0, 1]) if vary else None,
    }
