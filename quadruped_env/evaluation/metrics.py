"""Locomotion metrics: pure functions from sensor readings over time to one number per episode.

The first axis of arrays is time: scalars are (T, N), vectors (T, N, ...). The mask `counted` (T, N) selects samples,
which are contiguous in each episode; an episode without a selected sample gets NaN. `dt` is the time between samples,
s. Angles are in rad, lengths in m, velocities in m/s and rad/s. `measure` computes every metric of a rollout over the
time after the first `START_UP` seconds and before a fall; the fall rate counts from the beginning.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.robot import Robot
from quadruped_env.task.quantities import electrical_power, mechanical_power
from quadruped_env.utils.rotations import tilt, yaw

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

GRAVITY: Final = 9.81
START_UP: Final = 1.0
"""Time at the beginning of an episode that only the fall rate counts, s: the robot drops 1 cm and accelerates."""
WINDOW: Final = 1.0
"""Length of the moving mean that removes the oscillation within a stride from a velocity, s."""
STANDING_SPEED: Final = 0.05
"""Speed below which a robot counts as standing, and metrics per metre are NaN, m/s."""
LIMIT_MARGIN: Final = 0.01
"""Distance from a position limit within which a joint counts as being at the limit, rad."""
CLEARANCE_QUANTILE: Final = 0.95
"""Quantile of a sole's height over time that is its clearance."""
TILTED: Final = 0.3
"""Tilt in rad of a robot that sits, leans or tumbles: gaits on level ground stay below it."""
STANDING_SWING: Final = 0.01
"""RMS hip swing below which a robot counts as not stepping, rad."""


@dataclass(frozen=True)
class Metric:
    """Label, unit and meaning of a metric, and how to format its values."""

    label: str
    unit: str
    meaning: str
    digits: int = 2
    limit: Callable[[Robot], float] | None = None
    """Hardware limit of a robot, in `unit`"""
    percent: bool = False
    """True to show the value, a fraction, as a percentage"""

    def limit_of(self, robot: Robot) -> float | None:
        """Hardware limit of a robot, in `unit`; None for a metric without one."""
        return None if self.limit is None else self.limit(robot)

    def show(self, value: float) -> str:
        """The value as text without its unit, a dash for NaN."""
        if math.isnan(value):
            return "-"
        # z: no minus before a zero
        return f"{100.0 * value:z.{self.digits}f} %" if self.percent else f"{value:z.{self.digits}f}"


METRICS: Final[dict[str, Metric]] = {
    "fall_rate": Metric("Falls", "", "share of episodes that end in a fall", 0, percent=True),
    "forward_velocity_error": Metric(
        "Forward velocity error", "m/s", "RMS over time of the 1 s mean of the forward velocity minus its command", 3
    ),
    "yaw_rate_error": Metric(
        "Yaw rate error", "rad/s", "RMS over time of the 1 s mean of the yaw rate minus its command", 3
    ),
    "forward_velocity": Metric("Forward velocity", "m/s", "mean, in the robot's own frame", 3),
    "yaw_rate": Metric("Yaw rate", "rad/s", "mean; positive turns left", 3),
    "distance": Metric("Distance", "m", "travelled forwards by the end of the episode, or by the fall"),
    "lateral_drift": Metric("Lateral drift", "m/m", "metres sideways per metre ahead, on straight commands", 3),
    "heading_drift": Metric("Heading drift", "rad/s", "change of heading over time, on straight commands", 3),
    "electrical_cost_of_transport": Metric(
        "Electrical cost of transport", "", "electrical power / (weight x speed); undefined for a robot that stands"
    ),
    "mechanical_cost_of_transport": Metric(
        "Mechanical cost of transport", "", "mechanical power / (weight x speed); undefined for a robot that stands"
    ),
    "electrical_power": Metric(
        "Electrical power", "W", "mean of the mechanical power and the heat in the motors' windings", 1
    ),
    "mechanical_power": Metric(
        "Mechanical power", "W", "mean positive power of the motors; braking recovers no energy", 1
    ),
    "peak_torque": Metric(
        "Peak torque", "N m", "largest of any joint", 1, lambda robot: float(robot.effort_limit.max())
    ),
    "peak_joint_speed": Metric(
        "Peak joint speed", "rad/s", "largest of any joint", 1, lambda robot: float(robot.velocity_limit.max())
    ),
    "joint_acceleration": Metric(
        "Joint acceleration", "rad/s²", "RMS over joints and time; small for smooth motion", 0
    ),
    "joints_at_limit": Metric(
        "Joints at a limit", "", "share of time with any joint at a position limit", 1, percent=True
    ),
    "foot_slip": Metric("Foot slip", "m/s", "mean sliding speed of the soles that are on the ground", 3),
    "foot_clearance": Metric(
        "Foot clearance", "m", "height that a sole exceeds 5 % of the time; of the foot that is lifted least", 3
    ),
    "duty_factor": Metric("Duty factor", "", "share of time that a foot is on the ground, mean of the feet"),
    "stride_frequency": Metric("Stride frequency", "Hz", "strongest frequency of the hips' swing"),
}
"""Every metric, in the order of tables."""


def measure(rollout: Rollout) -> dict[str, Floats]:
    """Every metric of `METRICS`, in SI units, one number per episode: name -> (N,); NaN where undefined."""
    r, dt, counted = rollout, rollout.timestep, counted_samples(rollout)
    forward, yaw_rate, command = r.velocity[..., 0], r.velocity[..., 1], r.command[0]
    straight = np.abs(command[:, 1]) <= moving_threshold(r.robot)[1]
    heading = heading_of(r.orientation)
    speed = masked_mean(forward, counted)
    hips = [joints[0] for joints in r.robot.leg_joints]
    coefficient = r.motors.joule_coefficients(r.robot.joint_kinds)
    electrical = masked_mean(electrical_power(r.joint_torque, r.joint_velocity, coefficient), counted)
    mechanical = masked_mean(mechanical_power(r.joint_torque, r.joint_velocity), counted)
    return {
        "fall_rate": r.fallen * 1.0,
        "forward_velocity_error": tracking_error(forward, command[:, 0], counted, dt),
        "yaw_rate_error": tracking_error(yaw_rate, command[:, 1], counted, dt),
        "forward_velocity": speed,
        "yaw_rate": masked_mean(yaw_rate, counted),
        "distance": distance(forward, r.valid, dt),
        "lateral_drift": np.where(straight, lateral_drift(r.base_position, heading, counted, dt), np.nan),
        "heading_drift": np.where(straight, heading_drift(heading, counted, dt), np.nan),
        "electrical_cost_of_transport": cost_of_transport(electrical, speed, r.robot.total_mass),
        "mechanical_cost_of_transport": cost_of_transport(mechanical, speed, r.robot.total_mass),
        "electrical_power": electrical,
        "mechanical_power": mechanical,
        "peak_torque": peak(r.joint_torque, counted),
        "peak_joint_speed": peak(r.joint_velocity, counted),
        "joint_acceleration": joint_acceleration(r.joint_velocity, counted, dt),
        "joints_at_limit": joints_at_limit(r.joint_position, counted, r.robot),
        "foot_slip": stance_slip(r.slip_speed, r.contact, counted),
        "foot_clearance": foot_clearance(r.foot_height, counted).min(axis=-1),
        "duty_factor": duty_factor(r.contact, counted).mean(axis=-1),
        "stride_frequency": stride_frequency(r.joint_position[..., hips], counted, dt),
    }


def without_fall_in_words(orientation: NDArray[Any], dt: float) -> str:
    """Predicate for a robot that did not fall, from its quaternions wxyz (T, 4) over time and the time step in s."""
    lean = tilt(orientation)
    tilted = lean > TILTED
    if not tilted.any():
        return "stayed on its feet"
    return (
        f"did not fall, but was tilted by more than {np.degrees(TILTED):.0f} degrees for {tilted.sum() * dt:.2f} s "
        f"(up to {np.degrees(lean.max()):.0f} degrees)"
    )


def counted_samples(rollout: Rollout) -> Mask:
    """Mask of the samples after the start-up and before a fall, (T, N)."""
    counted = rollout.valid.copy()
    counted[: round(START_UP / rollout.timestep)] = False
    return counted


def masked_mean(values: NDArray[Any], mask: Mask) -> Floats:
    """Mean over time of values (T, N, ...) where mask (T, N) is True, shape (N, ...)."""
    mask = mask.reshape(mask.shape + (1,) * (values.ndim - mask.ndim))
    return _ratio(np.where(mask, values, 0).sum(axis=0, dtype=np.float64), mask.sum(axis=0))


def _ratio(numerator: NDArray[Any], denominator: NDArray[Any]) -> Floats:
    """The quotient, NaN where the denominator is 0."""
    shape = np.broadcast_shapes(np.shape(numerator), np.shape(denominator))
    return np.divide(numerator, denominator, out=np.full(shape, np.nan), where=np.asarray(denominator) != 0)


def window_means(values: NDArray[Any], counted: Mask, dt: float) -> tuple[Floats, Mask]:
    """Means of values (T, N, ...) over every `WINDOW` seconds, and a mask.

    Element i of the means (M, N, ...) is over samples i to i + window; the mask (M, N) is True if all of those samples
    count. M is 0 for a rollout shorter than a window.
    """
    window = round(WINDOW / dt)
    if len(values) < window:
        return np.empty((0, *values.shape[1:])), np.empty((0, *counted.shape[1:]), np.bool_)
    total = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0, dtype=np.float64)])
    return (total[window:] - total[:-window]) / window, counted[: len(counted) - window + 1] & counted[window - 1 :]


def tracking_error(velocity: NDArray[Any], command: Floats, counted: Mask, dt: float) -> Floats:
    """RMS error between a velocity (T, N) and its command (N,), in the unit of the velocity, (N,).

    sqrt(mean over windows of (mean of the velocity over `WINDOW` - command)^2). The oscillation of a legged robot
    within each stride is not an error.
    """
    means, whole = window_means(velocity, counted, dt)
    return np.sqrt(masked_mean((means - command) ** 2, whole))


def distance(forward_velocity: NDArray[Any], valid: Mask, dt: float) -> Floats:
    """Integral of the forward velocity (T, N) in m/s until the end or the fall, m, (N,); negative backwards."""
    return np.where(valid, forward_velocity, 0).sum(axis=0, dtype=np.float64) * dt


def heading_of(orientation: NDArray[Any]) -> Floats:
    """Heading of the base from the world's x axis, without jumps of a turn (T, N), from quaternions wxyz (T, N, 4)."""
    return np.unwrap(yaw(orientation), axis=0)


def _first_and_last(values: NDArray[Any], counted: Mask, dt: float) -> tuple[Floats, Floats, Floats]:
    """Means over the first and the last whole window (N, ...) each, and the time between the two, s (N,).

    The time is NaN for an episode where those windows overlap.
    """
    means, whole = window_means(values, counted, dt)
    if not len(means):
        nothing = np.full(values.shape[1:], np.nan)
        return nothing, nothing, np.full(counted.shape[1:], np.nan)
    first = whole.argmax(axis=0)
    last = len(whole) - 1 - whole[::-1].argmax(axis=0)
    rows = np.arange(len(first))
    elapsed = (last - first) * dt
    return means[first, rows], means[last, rows], np.where(whole.any(axis=0) & (elapsed >= WINDOW), elapsed, np.nan)


def lateral_drift(base_position: NDArray[Any], heading: Floats, counted: Mask, dt: float) -> Floats:
    """|displacement across the heading at the beginning| / |displacement along it|, m/m, (N,).

    Beginning and end of the positions (T, N, 3) and of the heading (T, N) are means over `WINDOW`. NaN for a robot that
    does not travel (`STANDING_SPEED`).
    """
    start, end, elapsed = _first_and_last(base_position[..., :2], counted, dt)
    direction, _, _ = _first_and_last(heading, counted, dt)
    x, y = np.moveaxis(end - start, -1, 0)
    along = np.abs(x * np.cos(direction) + y * np.sin(direction))
    across = np.abs(y * np.cos(direction) - x * np.sin(direction))
    travels = along > STANDING_SPEED * elapsed
    return _ratio(across, np.where(travels, along, 0.0))


def heading_drift(heading: Floats, counted: Mask, dt: float) -> Floats:
    """|heading at the end - heading at the beginning| / time, both means over `WINDOW`, rad/s, (N,)."""
    start, end, elapsed = _first_and_last(heading, counted, dt)
    return np.abs(end - start) / elapsed


def cost_of_transport(power: Floats, speed: Floats, mass: float) -> Floats:
    """Mean power / (m g |mean forward speed|), no unit, (N,); NaN below `STANDING_SPEED`.

    Collins et al. 2005 (https://doi.org/10.1126/science.1107799) distinguish the mechanical cost, of the positive work
    of the motors, and the energetic one, of all power that the robot draws. The electrical cost here is that of the
    motors: their positive work and the heat in their windings, without electronics. Power (N,) is in W, mass in kg.
    """
    travels = np.abs(speed) > STANDING_SPEED
    return _ratio(power, np.where(travels, mass * GRAVITY * np.abs(speed), 0.0))


def peak(values: NDArray[Any], counted: Mask) -> Floats:
    """Largest absolute value over time and joints, in the unit of values (T, N, J), (N,)."""
    largest = np.where(counted, np.abs(values).max(axis=-1), 0.0).max(axis=0).astype(np.float64)
    return np.where(counted.any(axis=0), largest, np.nan)


def joint_acceleration(joint_velocity: NDArray[Any], counted: Mask, dt: float) -> Floats:
    """RMS over time and joints of (velocity now - velocity before) / dt, rad/s^2, (N,), for velocities (T, N, J).

    The quantity that the `dof_acc` term of legged_gym penalizes. Targets and actions are not suitable: a scripted gait
    has no action, and a joint follows a rough target smoothly.
    """
    return rms_rate(joint_velocity, counted, dt)


def rms_rate(values: NDArray[Any], counted: Mask, dt: float) -> Floats:
    """RMS over time and joints of the change between samples per time (N,), for values (T, N, J)."""
    change = np.diff(values.astype(np.float64), axis=0) / dt
    return np.sqrt(masked_mean((change**2).mean(axis=-1), counted[1:] & counted[:-1]))


def joints_at_limit(joint_position: NDArray[Any], counted: Mask, robot: Robot) -> Floats:
    """Fraction of time with any joint (T, N, J) within `LIMIT_MARGIN` of its limits, in [0, 1], (N,)."""
    low, high = robot.joint_position_low + LIMIT_MARGIN, robot.joint_position_high - LIMIT_MARGIN
    at_limit = (joint_position < low) | (joint_position > high)
    return masked_mean(np.any(at_limit, axis=-1) * 1.0, counted)


def stance_slip(slip_speed: NDArray[Any], contact: Mask, counted: Mask) -> Floats:
    """Mean sliding speed (T, N, L) over all feet and samples with the foot on the ground, m/s, (N,)."""
    stance = contact & counted[..., None]
    return _ratio(np.where(stance, slip_speed, 0).sum(axis=(0, 2), dtype=np.float64), stance.sum(axis=(0, 2)))


def slip_of_feet(slip_speed: NDArray[Any], contact: Mask, counted: Mask) -> Floats:
    """Mean sliding speed of each foot while it is on the ground, m/s, (N, L); arguments as for `stance_slip`."""
    stance = contact & counted[..., None]
    return _ratio(np.where(stance, slip_speed, 0).sum(axis=0, dtype=np.float64), stance.sum(axis=0))


def foot_clearance(foot_height: NDArray[Any], counted: Mask) -> Floats:
    """Height over the ground (T, N, L) that each sole exceeds 5 % of the time, m, (N, L).

    About the top of its swing, but robust against a single highest sample.
    """
    heights = np.sort(np.where(counted[..., None], foot_height, np.inf), axis=0)
    count = counted.sum(axis=0)
    place = np.ceil(CLEARANCE_QUANTILE * count).astype(np.intp) - 1
    chosen = np.take_along_axis(heights, np.maximum(place, 0)[None, :, None], axis=0)[0]
    return np.where(count[:, None] > 0, chosen.astype(np.float64), np.nan)


def duty_factor(contact: Mask, counted: Mask) -> Floats:
    """Fraction of time that each foot is on the ground (T, N, L), in [0, 1], (N, L)."""
    return masked_mean(contact, counted)


def stride_frequency(hip_position: NDArray[Any], counted: Mask, dt: float) -> Floats:
    """Strides per second, Hz, (N,): the strongest frequency of the swing of the hips (T, N, hips).

    The peak of the power spectrum (Hann window, summed over the hips), refined by a parabola through its neighbours.
    Touch-downs are not used, because a foot that bounces touches down more than once per stride. NaN where the hips
    swing less than `STANDING_SWING`, or for fewer than two strides.
    """
    hips = hip_position.astype(np.float64)
    swing = np.where(counted[..., None], hips - masked_mean(hips, counted), 0.0)
    length = counted.sum(axis=0)
    place = (np.arange(len(counted))[:, None] - counted.argmax(axis=0) + 0.5) / np.maximum(length, 1)
    window = np.where(counted, np.sin(np.pi * place) ** 2, 0.0)
    # Zero padding interpolates the spectrum on a finer grid of frequencies.
    padded = 4 * 2 ** math.ceil(math.log2(len(counted)))
    power = (np.abs(np.fft.rfft(swing * window[..., None], padded, axis=0)) ** 2).sum(axis=-1)
    top = np.clip(power.argmax(axis=0), 1, len(power) - 2)
    rows = np.arange(power.shape[1])
    before, here, after = (np.log(np.maximum(power[top + step, rows], 1e-300)) for step in (-1, 0, 1))
    shift = _ratio(0.5 * (before - after), before - 2.0 * here + after)
    moving = np.sqrt(_ratio((swing**2).sum(axis=0), length[:, None]).mean(axis=-1)) > STANDING_SWING
    frequency = (top + shift) / (padded * dt)
    return np.where(moving & (frequency * length * dt >= 2.0), frequency, np.nan)
