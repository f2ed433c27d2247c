"""Measures of locomotion: each quantity once, from readings over time to one number per episode.

The first axis of arrays is time: scalars are (T, N), vectors (T, N, ...). The mask `counted` (T, N) selects samples,
which are contiguous in each episode; an episode without a selected sample gets NaN. `dt` is the time between samples,
s. Angles are in rad, lengths in m, velocities in m/s and rad/s. `measure` computes every measure of a rollout over the
time after the first `START_UP` seconds and before a fall; the fall rate counts from the beginning. Tables, verdict,
suite and the gain over the zero action use these measures, whatever the condition of their episodes.
"""

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.control.control_config import VELOCITIES, velocity_commands
from quadruped_env.evaluation.rollout import PhysicsSamples, Rollout
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.rotations import up_in_body, yaw

GRAVITY: Final = 9.81
START_UP: Final = 1.0
"""Time at the beginning of an episode that only the fall rate counts, s: the robot drops 1 cm and accelerates."""
WINDOW: Final = 1.0
"""Length of the moving mean that removes the oscillation within a stride from a velocity, s."""
STANDING_SPEED: Final = 0.05
"""Speed below which a robot counts as standing, and the cost of transport is NaN, m/s."""
LIMIT_MARGIN: Final = 0.01
"""Distance from a position limit within which a joint counts as being at the limit, rad."""
TILTED: Final = 0.3
"""Tilt in rad of a robot that sits, leans or tumbles: gaits on level ground stay below it."""
STANDING_SWING: Final = 0.01
"""RMS hip swing below which a robot counts as not stepping, rad."""
CLOSE: Final = {"m/s": 0.05, "rad/s": 0.1}
"""Unit of a mean velocity -> its maximum error under a command that is met, for the built-in robot."""
ROUGH: Final = {"m/s": 0.1, "rad/s": 0.2}
"""The same where the command is followed, and not missed."""
CLEARANCE_QUANTILE: Final = 0.05
"""Quantile of the apexes of a foot's swings that is its clearance."""
SWING_SHARE: Final = 0.2
"""Share of a stride from which a time in the air is a swing; shorter ones are within a stance."""
BOUNCE: Final = 0.002
"""Height over the ground from which a shorter time in the air is a bounce, for the built-in robot, m."""
SPEED_SHARE: Final = 0.95
"""Share of a joint's velocity limit from which it counts as being at the limit."""
DRIFT_TIME: Final = 10.0
"""Time in which a heading drifts, s."""
_CONTACT: Final = 1.0
"""Normal force over which a foot of the built-in robot is on the ground, N."""
_STILL: Final = 0.2
"""RMS joint velocity below which the built-in robot stands, rad/s."""


@dataclass(frozen=True)
class Tolerance:
    """Errors of the mean velocities that count as small, for each velocity of the built-in robot, m/s and rad/s."""

    met: tuple[float, ...] = tuple(CLOSE.values())
    """Maximum errors under a command that is met."""
    share: float = 0.1
    """Maximum error under a command that is met closely, relative to the command ..."""
    least: tuple[float, ...] = (0.02, 0.05)
    """... or these, if they are larger; at most `met`."""
    missed: tuple[float, ...] = tuple(ROUGH.values())
    """Errors from which a command is missed."""

    def closely(self, command: ArrayLike) -> Floats:
        """Return the maximum errors under commands (..., V) that are met closely, (..., V)."""
        return np.minimum(np.maximum(self.share * np.abs(command), self.least), self.met)

    def accuracy(self, error: ArrayLike, command: ArrayLike) -> Floats:
        """Return the accuracy of errors (..., V) under commands (..., V), in [0, 1], (...).

        1 for a command that is met closely, from there linearly to 0 for one that is missed; of the worst velocity.
        Unknown errors, NaN, have an accuracy of 0.
        """
        missed, closely = np.asarray(self.missed), self.closely(command)
        score = (missed - np.abs(error)) / (missed - closely)
        return np.nan_to_num(np.clip(score, 0.0, 1.0).min(axis=-1))


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
        """Return the hardware limit of a robot, in `unit`; None for a metric without one."""
        return None if self.limit is None else self.limit(robot)

    def show(self, value: float) -> str:
        """Return the value as text without its unit, a dash for NaN."""
        if math.isnan(value):
            return "-"
        # z: no minus before a zero
        return f"{100.0 * value:z.{self.digits}f} %" if self.percent else f"{value:z.{self.digits}f}"


METRICS: Final[dict[str, Metric]] = {
    "fall_rate": Metric("Falls", "", "share of episodes that end in a fall", 0, percent=True),
    **{
        f"{name}_error": Metric(
            f"{name.replace('_', ' ').capitalize()} error",
            unit,
            f"RMS over time of the 1 s mean of the {name.replace('_', ' ')} minus its command",
            3,
        )
        for name, unit in ((entry.name, entry.unit) for entry in VELOCITIES)
    },
    "forward_velocity": Metric("Forward velocity", "m/s", "mean, in the robot's own frame", 3),
    "yaw_rate": Metric("Yaw rate", "rad/s", "mean; positive turns left", 3),
    "lateral_velocity": Metric("Lateral velocity", "m/s", "mean, in the robot's own frame; positive to the left", 3),
    "sideways_drift": Metric("Sideways drift", "m/s", "mean velocity to the side minus its command, without sign", 3),
    "heading_drift": Metric("Heading drift", "rad", "heading after 10 s minus the commanded one, without sign", 2),
    "distance": Metric("Distance", "m", "travelled forwards by the end of the episode, or by the fall"),
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
    "joint_limit_share": Metric(
        "Time at a joint limit", "", "share of time with any joint at a position limit", 1, percent=True
    ),
    "speed_limit_share": Metric(
        "Time at a speed limit", "", "share of time with any joint over 95 % of its speed limit", 1, percent=True
    ),
    "stride_frequency": Metric("Stride frequency", "Hz", "strongest frequency of the hips' swing"),
    "clearance": Metric(
        "Foot clearance", "m", "height that 95 % of a foot's swings reach; of the foot that is lifted least", 3
    ),
    "apex": Metric("Rise of the feet", "m", "median height that a foot reaches in a swing; mean of the feet", 3),
    "touchdowns_per_stride": Metric("Touchdowns per stride", "", "of the foot that touches down most"),
    "bounces_per_stride": Metric("Bounces per stride", "", "short times in the air within a stance; of the worst foot"),
    "landing_speed": Metric("Landing speed", "m/s", "downward speed of the sole at touchdown; of the worst foot"),
    "slip": Metric("Foot slip", "m/s", "mean sliding speed of a sole on the ground; of the worst foot", 3),
    "duty_factor": Metric("Duty factor", "", "share of time that a foot is on the ground, mean of the feet"),
    "peak_force": Metric("Peak force on a foot", "body weights", "largest normal force; of the worst foot", 1),
    "torque_rate": Metric("Change of torque", "N m/s", "RMS over joints and time between physics steps", 0),
    "base_height": Metric("Height of the base", "m", "mean height of its centre over the ground", 3),
    "roll": Metric("Roll", "rad", "RMS over time", 3),
    "pitch": Metric("Pitch", "rad", "RMS over time", 3),
}
"""Every measure, in the order of tables."""


def metrics_of(robot: Robot) -> dict[str, Metric]:
    """Return the measures of a robot: all but the velocities, and their errors, that it has no command for."""
    missing = [entry.name for entry in VELOCITIES[len(velocity_commands(robot)) :]]
    return {name: metric for name, metric in METRICS.items() if name.removesuffix("_error") not in missing}


def errors_of(robot: Robot) -> list[str]:
    """Return the names of the errors of a robot's velocities, in the order of its `velocity_commands`."""
    return [f"{entry.name}_error" for entry in velocity_commands(robot)]


def tolerances(errors: Mapping[str, float], robot: Robot) -> tuple[float, ...]:
    """Return errors by unit of the built-in robot, such as `CLOSE`, for each velocity of a robot, in its units."""
    units = [entry.unit for entry in velocity_commands(robot)]
    return tuple(scaled(errors[unit], scale_of(unit, robot), 3) for unit in units)


OF_FEET: Final[dict[str, Callable[[Floats], Floats]]] = {
    "clearance": lambda feet: feet.min(axis=-1),
    "apex": lambda feet: feet.mean(axis=-1),
    "touchdowns_per_stride": lambda feet: feet.max(axis=-1),
    "bounces_per_stride": lambda feet: feet.max(axis=-1),
    "landing_speed": lambda feet: feet.max(axis=-1),
    "slip": lambda feet: feet.max(axis=-1),
    "duty_factor": lambda feet: feet.mean(axis=-1),
    "peak_force": lambda feet: feet.max(axis=-1),
}
"""Measure with one value per foot -> value of all feet, (..., L) to (...)."""


def measure(rollout: Rollout) -> dict[str, Floats]:
    """Return every measure, in SI units, one number per episode: name -> (N,); NaN where undefined.

    Those of the gait are left out if the rollout has no physics steps.
    """
    r, dt, counted = rollout, rollout.timestep, counted_samples(rollout)
    names = [entry.name for entry in velocity_commands(r.robot)]
    velocities = dict(zip(names, np.moveaxis(r.velocity, -1, 0), strict=True))
    commands = dict(zip(names, r.command[0].T, strict=True))
    speed = masked_mean(r.velocity[..., 0], counted)
    electrical, mechanical = masked_mean(r.electrical_power, counted), masked_mean(r.mechanical_power, counted)
    values: dict[str, Floats] = {
        "fall_rate": r.fallen.astype(np.float64),
        **{f"{name}_error": tracking_error(v, commands[name], counted, dt) for name, v in velocities.items()},
        **{name: masked_mean(v, counted) for name, v in velocities.items()},
        **drifts(r, counted),
        "distance": distance(r.velocity[..., 0], r.valid, dt),
        "electrical_cost_of_transport": cost_of_transport(electrical, speed, r.robot.total_mass),
        "mechanical_cost_of_transport": cost_of_transport(mechanical, speed, r.robot.total_mass),
        "electrical_power": electrical,
        "mechanical_power": mechanical,
        "base_height": masked_mean(r.base_height, counted),
        "peak_torque": peak(r.joint_torque, counted),
        "peak_joint_speed": peak(r.joint_velocity, counted),
        "joint_acceleration": rms_rate(r.joint_velocity, counted, dt),
        "joint_limit_share": joint_limit_share(r.joint_position, counted, r.robot),
        "speed_limit_share": speed_limit_share(r.joint_velocity, counted, SPEED_SHARE * r.robot.velocity_limit),
    }
    if r.physics is not None:
        gait = gait_measures(r)
        values |= {name: OF_FEET[name](value) if name in OF_FEET else value for name, value in gait.items()}
    return values


def gait_measures(rollout: Rollout) -> dict[str, Floats]:
    """Return the measures that need every physics step: name -> (N,), or (N, L) for those in `OF_FEET`."""
    r, dt, counted, physics = rollout, rollout.timestep, counted_samples(rollout), rollout.physics
    assert physics is not None
    hips = [joints[0] for joints in r.robot.leg_joints]
    frequency = stride_frequency(r.joint_position[..., hips], counted, dt)
    substeps = len(physics.force) // len(counted)
    fine, step = np.repeat(counted, substeps, axis=0), dt / substeps
    contact = physics.force > _CONTACT * scale_of("N", r.robot)
    x, y, z = np.moveaxis(up_in_body(r.orientation), -1, 0)
    return {
        "stride_frequency": frequency,
        **feet(physics, contact, fine, frequency, step, BOUNCE * scale_of("m", r.robot)),
        "slip": slip_of_feet(physics.slip, contact, fine),
        "duty_factor": masked_mean(contact, fine),
        "peak_force": peak(physics.force[..., None], fine[..., None]) / (r.robot.total_mass * GRAVITY),
        "torque_rate": rms_rate(physics.torque, fine, step),
        "roll": root_mean_square(np.arctan2(y, z), counted),
        "pitch": root_mean_square(np.arctan2(-x, np.hypot(y, z)), counted),
    }


def meets(achieved: ArrayLike, command: ArrayLike, still: ArrayLike, fallen: ArrayLike, tolerance: ArrayLike) -> Bools:
    """Return True for each episode, or stretch of one, that meets its command (...).

    Without a fall, the mean velocities (..., V) must be within `tolerance` (..., V) of the command (..., V), m/s and
    rad/s, and a robot whose command is to stand must stand `still`. Unknown velocities, NaN, do not meet a command.
    """
    command = np.asarray(command, dtype=np.float64)
    # Decimal commands are not exact in binary.
    close = (np.abs(np.asarray(achieved) - command) <= np.asarray(tolerance) + 1e-9).all(axis=-1)
    return np.asarray(close & ~np.asarray(fallen) & (np.asarray(still) | command.any(axis=-1)))


class Reached(NamedTuple):
    """What episodes (N,) reach of their commands."""

    velocity: Floats
    """Mean velocities, m/s and rad/s (N, V)."""
    met: Bools
    closely: Bools
    """True for a command that is met closely."""
    accuracy: Floats
    """`Tolerance.accuracy`; 0 after a fall, or where a robot whose command is to stand does not stand still."""


def reached(rollout: Rollout, command: ArrayLike, tolerance: Tolerance, counted: Bools | None = None) -> Reached:
    """Judge episodes by their mean velocities over the counted samples (T, N); None: `counted_samples`.

    This is the law of commands that are met: see `meets`. `command` is (N, V), `tolerance` in the robot's units.
    """
    counted, wanted = counted_samples(rollout) if counted is None else counted, np.asarray(command, dtype=np.float64)
    velocity, still = masked_mean(rollout.velocity, counted), stands_still(rollout, counted)
    met, closely = (
        meets(velocity, wanted, still, rollout.fallen, allowed)
        for allowed in (tolerance.met, tolerance.closely(wanted))
    )
    allowed = ~rollout.fallen & (still | wanted.any(axis=-1))
    return Reached(velocity, met, closely, allowed * tolerance.accuracy(velocity - wanted, wanted))


def own_commands_met(rollout: Rollout, tolerance: Sequence[float]) -> Bools:
    """Return True for each command of a task's own law of commands that was met, robot by robot, (S,).

    A command holds until it changes, the robot falls or the time is over, and counts from `START_UP` after its
    beginning; see `meets`. One under which the robot falls is not met. Others that hold for less than `START_UP` +
    `WINDOW` are left out, and so are those through which a command passes as it approaches the requested one.
    """
    r, dt = rollout, rollout.timestep
    allowance, shortest = round(START_UP / dt), round((START_UP + WINDOW) / dt)
    begins = np.ones(r.fell.shape, np.bool_)
    begins[1:] = (r.command[1:] != r.command[:-1]).any(axis=-1) | r.fell[:-1]
    met = []
    for robot in range(r.fell.shape[1]):
        starts = np.flatnonzero(begins[:, robot])
        for start, stop in zip(starts, [*starts[1:], len(r)], strict=True):
            fell = bool(r.fell[stop - 1, robot])
            if fell or stop - start >= shortest:
                part = slice(start + allowance, stop)
                achieved = r.velocity[part, robot].mean(axis=0, dtype=np.float64) if not fell else np.nan
                still = is_still(r.joint_velocity[part, robot], r.robot) if not fell else False
                met.append(bool(meets(achieved, r.command[start, robot], still, fell, tolerance)))
    return np.array(met, np.bool_)


def mean_velocities(rollout: Rollout) -> Floats:
    """Return the mean of each velocity over each episode after the start-up, m/s and rad/s (N, V).

    NaN for an episode that falls during the start-up.
    """
    return masked_mean(rollout.velocity, counted_samples(rollout))


def is_still(joint_velocity: NDArray[Any], robot: Robot) -> bool:
    """Return True if the RMS joint velocity (T, J) is as low as at rest."""
    square = float((joint_velocity.astype(np.float64) ** 2).mean())
    return math.sqrt(square) < _STILL * scale_of("rad/s", robot)


def stands_still(rollout: Rollout, counted: Bools) -> Bools:
    """Return True for each episode (N,) whose joints are nearly at rest over the counted samples (T, N)."""
    squared = masked_mean(rollout.joint_velocity.astype(np.float64) ** 2, counted).mean(axis=-1)
    return np.asarray(np.sqrt(squared) < _STILL * scale_of("rad/s", rollout.robot))


def counted_samples(rollout: Rollout) -> Bools:
    """Return a mask of the samples after the start-up and before a fall, (T, N)."""
    counted = rollout.valid.copy()
    counted[: round(START_UP / rollout.timestep)] = False
    return counted


def masked_mean(values: NDArray[Any], mask: Bools) -> Floats:
    """Return the mean over time of values (T, N, ...) where mask (T, N) is True, shape (N, ...)."""
    mask = mask.reshape(mask.shape + (1,) * (values.ndim - mask.ndim))
    return _ratio(np.where(mask, values, 0).sum(axis=0, dtype=np.float64), mask.sum(axis=0))


def _ratio(numerator: NDArray[Any], denominator: NDArray[Any]) -> Floats:
    """Return the quotient, NaN where the denominator is 0."""
    shape = np.broadcast_shapes(np.shape(numerator), np.shape(denominator))
    return np.divide(numerator, denominator, out=np.full(shape, np.nan), where=np.asarray(denominator) != 0)


def window_means(values: NDArray[Any], counted: Bools, dt: float) -> tuple[Floats, Bools]:
    """Return means of values (T, N, ...) over every `WINDOW` seconds, and a mask.

    Element i of the means (M, N, ...) is over samples i to i + window; the mask (M, N) is True if all of those samples
    count. M is 0 for a rollout shorter than a window.
    """
    window = round(WINDOW / dt)
    if len(values) < window:
        return np.empty((0, *values.shape[1:])), np.empty((0, *counted.shape[1:]), np.bool_)
    total = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0, dtype=np.float64)])
    return (total[window:] - total[:-window]) / window, counted[: len(counted) - window + 1] & counted[window - 1 :]


def tracking_error(velocity: NDArray[Any], command: Floats, counted: Bools, dt: float) -> Floats:
    """Return the RMS error between a velocity (T, N) and its command (N,), in the unit of the velocity, (N,).

    sqrt(mean over windows of (mean of the velocity over `WINDOW` - command)^2). The oscillation of a legged robot
    within each stride is not an error.
    """
    means, whole = window_means(velocity, counted, dt)
    return np.sqrt(masked_mean((means - command) ** 2, whole))


def drifts(rollout: Rollout, counted: Bools) -> dict[str, Floats]:
    """Return the drift to the side (m/s) and of the heading (rad in `DRIFT_TIME`), without sign: name -> (N,).

    From the base's position and heading in the world, so that they are known for every robot. The commands of the
    first sample hold for the whole episode.
    """
    command = np.pad(rollout.command[0].astype(np.float64), [(0, 0), (0, 1)])
    heading = np.unwrap(yaw(rollout.orientation), axis=0)
    x, y, _ = np.moveaxis(np.diff(rollout.base_position.astype(np.float64), axis=0) / rollout.timestep, -1, 0)
    way, whole = 0.5 * (heading[1:] + heading[:-1]), counted[1:] & counted[:-1]
    turning = masked_mean(np.diff(heading, axis=0) / rollout.timestep, whole)
    return {
        "sideways_drift": np.abs(masked_mean(np.cos(way) * y - np.sin(way) * x, whole) - command[:, 2]),
        "heading_drift": DRIFT_TIME * np.abs(turning - command[:, 1]),
    }


def distance(forward_velocity: NDArray[Any], valid: Bools, dt: float) -> Floats:
    """Integrate the forward velocity (T, N) in m/s until the end or the fall, m, (N,); negative backwards."""
    return np.where(valid, forward_velocity, 0).sum(axis=0, dtype=np.float64) * dt


def cost_of_transport(power: Floats, speed: Floats, mass: float) -> Floats:
    """Return the mean power / (m g |mean forward speed|), no unit, (N,); NaN below `STANDING_SPEED`.

    Collins et al. 2005 (https://doi.org/10.1126/science.1107799) distinguish the mechanical cost (positive work of the
    motors) from the energetic cost (all power that the robot draws). The electrical cost here counts the positive work
    of the motors and the heat in their windings, without electronics. Power (N,) is in W, mass in kg.
    """
    travels = np.abs(speed) > STANDING_SPEED
    return _ratio(power, np.where(travels, mass * GRAVITY * np.abs(speed), 0.0))


def peak(values: NDArray[Any], counted: Bools) -> Floats:
    """Return the largest absolute value over time and joints, in the unit of values (T, N, J), (N,)."""
    largest = np.where(counted, np.abs(values).max(axis=-1), 0.0).max(axis=0).astype(np.float64)
    return np.where(counted.any(axis=0), largest, np.nan)


def rms_rate(values: NDArray[Any], counted: Bools, dt: float) -> Floats:
    """Return the RMS over time and joints of the change between samples per time (N,), for values (T, N, J)."""
    change = np.diff(values.astype(np.float64), axis=0) / dt
    return np.sqrt(masked_mean((change**2).mean(axis=-1), counted[1:] & counted[:-1]))


def joint_limit_share(joint_position: NDArray[Any], counted: Bools, robot: Robot) -> Floats:
    """Return the fraction of time with any joint (T, N, J) within `LIMIT_MARGIN` of its limits, in [0, 1], (N,)."""
    low, high = robot.joint_position_low + LIMIT_MARGIN, robot.joint_position_high - LIMIT_MARGIN
    at_limit = (joint_position < low) | (joint_position > high)
    return masked_mean(np.any(at_limit, axis=-1) * 1.0, counted)


def speed_limit_share(joint_velocity: NDArray[Any], counted: Bools, limit: Floats) -> Floats:
    """Return the share of time with any joint (T, N, J) faster than its limit (J,) in rad/s, (N,)."""
    return masked_mean(np.any(np.abs(joint_velocity) > limit, axis=-1) * 1.0, counted)


def slip_of_feet(slip_speed: NDArray[Any], contact: Bools, counted: Bools) -> Floats:
    """Return the mean sliding speed (T, N, L) of each foot while it is on the ground (T, N, L), m/s, (N, L)."""
    stance = contact & counted[..., None]
    return _ratio(np.where(stance, slip_speed, 0).sum(axis=0, dtype=np.float64), stance.sum(axis=0))


def stride_frequency(hip_position: NDArray[Any], counted: Bools, dt: float) -> Floats:
    """Return the strides per second, Hz, (N,): the strongest frequency of the swing of the hips (T, N, hips).

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


class Flights(NamedTuple):
    """Times in the air of one foot, between a lift-off and a touchdown."""

    apexes: Floats
    """Largest height of the sole in each swing, m."""
    landings: Floats
    """Downward speed of the sole at the end of each swing, m/s."""
    bounces: int
    """Number of times in the air within a stance in which the sole rises high enough for a bounce."""


def flights_of(height: NDArray[Any], rise: NDArray[Any], contact: Bools, shortest: int, bounce: float) -> Flights:
    """Find the flights of one foot from height (m), upward velocity (m/s) and contact of its sole in every step (K,).

    A flight of `shortest` steps or more is a swing. A shorter one is within a stance, and a bounce if the sole rises
    over `bounce`, m.
    """
    apexes, landings, bounces = [], [], 0
    edges = np.flatnonzero(np.diff(contact.astype(np.int8)))
    for off, on in itertools.pairwise(edges):
        if not contact[off]:
            continue
        apex = float(height[off + 1 : on + 1].max())
        if on - off >= shortest:
            apexes.append(apex)
            # At the first contact the ground may have slowed the sole down already; before it the sole still falls.
            landings.append(-float(rise[on : on + 2].min()))
        else:
            bounces += apex > bounce
    return Flights(np.array(apexes), np.array(landings), bounces)


def feet(
    physics: PhysicsSamples, contact: Bools, counted: Bools, frequency: Floats, dt: float, bounce: float
) -> dict[str, Floats]:
    """Return the clearance, apex, touchdowns and bounces per stride, and landing speed of each foot: name -> (N, L).

    The clearance is the quantile `CLEARANCE_QUANTILE` of the apexes, the apex their median. A stride in which a foot
    does not swing counts as an apex of 0; at both ends of an episode one stride may be cut. A swing and a bounce end
    with a touchdown. For a robot that does not stride, whose frequency (N,) is NaN, clearance and apex are 0, and the
    others are NaN; all are NaN for an episode without counted samples. `bounce` is the height of a bounce, m.
    """
    names = ("clearance", "apex", "touchdowns_per_stride", "bounces_per_stride", "landing_speed")
    result = {name: np.full(contact.shape[1:], np.nan) for name in names}
    for episode, foot in np.ndindex(*contact.shape[1:]):
        samples, hertz = counted[:, episode], float(frequency[episode])
        if not samples.any():
            continue
        result["clearance"][episode, foot] = result["apex"][episode, foot] = 0.0
        if not np.isfinite(hertz):
            continue
        height, rise = (values[samples, episode, foot] for values in (physics.height, physics.rise))
        grounded = contact[samples, episode, foot]
        found = flights_of(height, rise, grounded, max(1, round(SWING_SHARE / (hertz * dt))), bounce)
        strides = hertz * samples.sum() * dt
        missing = max(0, int(strides) - 1 - len(found.apexes))
        padded = np.concatenate([np.maximum(found.apexes, 0.0), np.zeros(missing)])
        if len(padded):
            result["clearance"][episode, foot] = np.quantile(padded, CLEARANCE_QUANTILE)
            result["apex"][episode, foot] = np.median(padded)
        result["touchdowns_per_stride"][episode, foot] = (len(found.apexes) + found.bounces) / strides
        result["bounces_per_stride"][episode, foot] = found.bounces / strides
        if len(found.landings):
            result["landing_speed"][episode, foot] = found.landings.mean()
    return result


def root_mean_square(values: Floats, counted: Bools) -> Floats:
    """Return the root mean square over time (N,), for values (T, N)."""
    return np.sqrt(masked_mean(values**2, counted))
