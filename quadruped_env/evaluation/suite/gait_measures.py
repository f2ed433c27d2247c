"""Measures of the gait: clearance, touchdowns, slip, limits, smoothness, attitude. Axes and masks as in `metrics`."""

import itertools
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation import metrics
from quadruped_env.evaluation.confidence import mean_of
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import GaitPart
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.rotations import up_in_body

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

CLEARANCE_QUANTILE: Final = 0.05
"""Quantile of the apexes of a foot's swings that is its clearance."""

PER_FOOT: Final = ("clearance", "touchdowns_per_stride", "slip", "duty_factor")
"""Measures with one value per foot."""


def run(part: GaitPart, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Measures of each command, means over the episodes, as plain values."""
    rollout = measured.run(part.commands, part.seeds, part.seconds, progress)
    values = measures(rollout, part)
    shape = len(part.commands), part.num_seeds
    grouped = {name: value.reshape(*shape, *value.shape[1:]) for name, value in values.items()}
    return {
        "feet": list(measured.robot.leg_names),
        "commands": [
            {
                "command": list(command),
                "fall_share": float(rollout.fallen.reshape(shape)[i].mean()),
                **{name: mean_of(value[i]) for name, value in grouped.items()},
            }
            for i, command in enumerate(part.commands)
        ],
    }


def measures(rollout: Rollout, part: GaitPart) -> dict[str, Floats]:
    """Every measure of each episode, in SI units: name -> (N,), or (N, L) for those `PER_FOOT`."""
    r, dt, counted = rollout, rollout.timestep, metrics.counted_samples(rollout)
    hips = [joints[0] for joints in r.robot.leg_joints]
    frequency = metrics.stride_frequency(r.joint_position[..., hips], counted, dt)
    strides = frequency * counted.sum(axis=0) * dt
    roll, pitch = roll_and_pitch(r.orientation)
    return {
        "clearance": clearance(r.foot_height, r.contact, counted, strides, dt, part.shortest_swing),
        "touchdowns_per_stride": touchdowns(r.contact, counted) / strides[:, None],
        "slip": metrics.slip_of_feet(r.slip_speed, r.contact, counted),
        "duty_factor": metrics.duty_factor(r.contact, counted),
        "stride_frequency": frequency,
        "joint_limit_share": metrics.joints_at_limit(r.joint_position, counted, r.robot),
        "speed_limit_share": speed_limit_share(r.joint_velocity, counted, part.speed_share * r.robot.velocity_limit),
        "torque_rate": metrics.rms_rate(r.joint_torque, counted, dt),
        "roll": root_mean_square(roll, counted),
        "pitch": root_mean_square(pitch, counted),
        "electrical_cost_of_transport": metrics.measure(r)["electrical_cost_of_transport"],
    }


def swing_apexes(height: NDArray[Any], contact: Mask, dt: float, shortest: float) -> Floats:
    """Largest height of each whole swing of one foot, m, from the height of its sole over the ground (T,).

    A swing is an unbroken time in the air of at least `shortest` s, with the lift-off before and the touchdown after.
    """
    edges = np.flatnonzero(np.diff(contact.astype(np.int8)))
    apexes = []
    for off, on in itertools.pairwise(edges):
        if contact[off] and (on - off) * dt >= shortest - 1e-9:
            apexes.append(float(height[off + 1 : on + 1].max()))
    return np.array(apexes)


def clearance(
    foot_height: NDArray[Any], contact: Mask, counted: Mask, strides: Floats, dt: float, shortest: float
) -> Floats:
    """Clearance of each foot (N, L), m: the quantile `CLEARANCE_QUANTILE` of the apexes of its swings.

    A stride in which a foot does not swing counts as an apex of 0; at both ends of an episode one stride may be cut.
    NaN for an episode without counted samples; 0 for a robot that does not stride, whose number of strides in the
    counted time (N,) is NaN.
    """
    result = np.full(contact.shape[1:], np.nan)
    for episode, foot in np.ndindex(*result.shape):
        samples = counted[:, episode]
        if not samples.any():
            continue
        if not np.isfinite(strides[episode]):
            result[episode, foot] = 0.0
            continue
        apexes = swing_apexes(foot_height[samples, episode, foot], contact[samples, episode, foot], dt, shortest)
        missing = max(0, int(strides[episode]) - 1 - len(apexes))
        padded = np.concatenate([np.maximum(apexes, 0.0), np.zeros(missing)])
        result[episode, foot] = np.quantile(padded, CLEARANCE_QUANTILE) if len(padded) else 0.0
    return result


def touchdowns(contact: Mask, counted: Mask) -> Floats:
    """Number of touchdowns of each foot (N, L): samples on the ground whose sample before is in the air."""
    landed = contact[1:] & ~contact[:-1] & (counted[1:] & counted[:-1])[..., None]
    return landed.sum(axis=0).astype(np.float64)


def speed_limit_share(joint_velocity: NDArray[Any], counted: Mask, limit: Floats) -> Floats:
    """Share of time with any joint faster than its limit (J,) in rad/s, (N,)."""
    return metrics.masked_mean((np.abs(joint_velocity) > limit).any(axis=-1), counted)


def roll_and_pitch(orientation: NDArray[Any]) -> tuple[Floats, Floats]:
    """Roll and pitch, rad, of quaternions wxyz (..., 4), from the world's up axis in the base frame.

    Positive with the right side down, and with the nose down.
    """
    x, y, z = np.moveaxis(up_in_body(orientation), -1, 0)
    return np.arctan2(y, z), np.arctan2(-x, np.hypot(y, z))


def root_mean_square(values: Floats, counted: Mask) -> Floats:
    """Root mean square over time (N,), for values (T, N)."""
    return np.sqrt(metrics.masked_mean(values**2, counted))


def score(result: dict[str, Any], part: GaitPart) -> float:
    """Score in [0, 1] of the part: mean over the commands of three shares, each 0 for a robot that does not step.

    The clearance of the foot that is lifted least, over `full_clearance`, at most 1; x or 1 / x, the one below 1, of
    the foot with the worst number x of touchdowns per stride; and the share of time below the speed limits.
    """
    total = 0.0
    for entry in result["commands"]:
        steps = [value for value in entry["touchdowns_per_stride"] if value]
        if len(steps) < len(result["feet"]) or None in entry["clearance"]:
            continue
        lifted = min(1.0, max(0.0, min(entry["clearance"])) / part.full_clearance)
        regular = min(min(x, 1.0 / x) for x in steps)
        total += (lifted + regular + 1.0 - entry["speed_limit_share"]) / 3.0
    return total / len(result["commands"])
