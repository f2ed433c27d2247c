"""Measures of the gait: swings, bounces, landings, slip and power at the rate of the physics, limits and attitude."""

import itertools
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation import metrics
from quadruped_env.evaluation.confidence import mean_of
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.measured_controller import MeasuredController, mean_velocities
from quadruped_env.evaluation.suite.suite_definition import GaitPart
from quadruped_env.robot.units import scale_of
from quadruped_env.task import Task
from quadruped_env.task.quantities import electrical_power, sliding_squared
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.rotations import up_in_body

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

CLEARANCE_QUANTILE: Final = 0.05
"""Quantile of the apexes of a foot's swings that is its clearance."""
_CONTACT: Final = 1.0
"""Normal force over which a foot of the built-in robot is on the ground, N."""

PER_FOOT: Final = ("clearance", "swings_per_stride", "bounces_per_stride", "landing_speed", "slip", "duty_factor")
"""Measures with one value per foot."""


class PhysicsRecorder:
    """Records what the measures need in every physics step, as the argument `before_step` of a rollout.

    The last control step is missing. Level ground at height 0.
    """

    def __init__(self) -> None:
        self._samples: list[tuple[NDArray[np.float32], ...]] = []

    def __call__(self, task: Task, step: int) -> None:
        """Record the control step before."""
        if step:
            now = task.simulation.substeps
            slip = np.sqrt(
                sliding_squared(now.foot_velocity, now.foot_angular_velocity, task.simulation.robot.foot_radius)
            )
            height, rise = now.foot_position[..., 2] - task.simulation.robot.foot_radius, now.foot_velocity[..., 2]
            values = height, rise, now.foot_force, slip, now.joint_torque, now.joint_velocity
            self._samples.append(tuple(value.astype(np.float32) for value in values))

    def samples(self) -> "PhysicsSamples":
        """Everything that was recorded."""
        return PhysicsSamples(*(np.concatenate(values) for values in zip(*self._samples, strict=True)))


class PhysicsSamples(NamedTuple):
    """K physics steps of N robots with L feet and J joints; those of a control step follow each other."""

    height: NDArray[Any]
    """Height of each sole over the ground (K, N, L), m."""
    rise: NDArray[Any]
    """Upward velocity of each sole (K, N, L), m/s."""
    force: NDArray[Any]
    """Normal force on each foot (K, N, L), N."""
    slip: NDArray[Any]
    """Horizontal velocity of each sole's lowest point (K, N, L), m/s."""
    torque: NDArray[Any]
    """Motor torques (K, N, J), N m."""
    joint_velocity: NDArray[Any]
    """(K, N, J), rad/s."""


def run(part: GaitPart, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Measures of each command, means over the episodes, as plain values."""
    recorder = PhysicsRecorder()
    rollout = measured.run(part.commands, part.seeds, part.seconds, progress, before_step=recorder)
    values = measures(rollout, recorder.samples(), part)
    shape = len(part.commands), part.num_seeds
    error = np.abs(mean_velocities(rollout) - np.repeat(part.commands, part.num_seeds, axis=0))
    followed = (error <= part.tolerance).all(axis=-1) & ~rollout.fallen
    grouped = {name: value.reshape(*shape, *value.shape[1:]) for name, value in values.items()}
    return {
        "feet": list(measured.robot.leg_names),
        "commands": [
            {
                "command": list(command),
                "fall_share": float(rollout.fallen.reshape(shape)[i].mean()),
                "followed": float(followed.reshape(shape)[i].mean()),
                **{name: mean_of(value[i]) for name, value in grouped.items()},
            }
            for i, command in enumerate(part.commands)
        ],
    }


def measures(rollout: Rollout, physics: PhysicsSamples, part: GaitPart) -> dict[str, Floats]:
    """Every measure of each episode, in SI units: name -> (N,), or (N, L) for those `PER_FOOT`."""
    r, dt, counted = rollout, rollout.timestep, metrics.counted_samples(rollout)
    hips = [joints[0] for joints in r.robot.leg_joints]
    frequency = metrics.stride_frequency(r.joint_position[..., hips], counted, dt)
    roll, pitch = roll_and_pitch(r.orientation)
    # The recorder has no sample of the last control step.
    substeps = -(-len(physics.force) // (len(counted) - 1))
    fine, step = np.repeat(counted, substeps, axis=0)[: len(physics.force)], dt / substeps
    contact = physics.force > _CONTACT * scale_of("N", rollout.robot)
    weight = r.robot.total_mass * metrics.GRAVITY
    coefficient = r.motors.joule_coefficients(r.robot.joint_kinds)
    power = metrics.masked_mean(electrical_power(physics.torque, physics.joint_velocity, coefficient), fine)
    speed = metrics.masked_mean(r.velocity[..., 0], counted)
    return {
        **feet(physics, contact, fine, frequency, step, part),
        "slip": metrics.slip_of_feet(physics.slip, contact, fine),
        "duty_factor": metrics.duty_factor(contact, fine),
        "stride_frequency": frequency,
        "peak_force": metrics.peak(physics.force, fine) / weight,
        "joint_limit_share": metrics.joints_at_limit(r.joint_position, counted, r.robot),
        "speed_limit_share": speed_limit_share(r.joint_velocity, counted, part.speed_share * r.robot.velocity_limit),
        "torque_rate": metrics.rms_rate(physics.torque, fine, step),
        "roll": root_mean_square(roll, counted),
        "pitch": root_mean_square(pitch, counted),
        "electrical_power": power,
        "electrical_cost_of_transport": metrics.cost_of_transport(power, speed, r.robot.total_mass),
    }


class Flights(NamedTuple):
    """Times in the air of one foot, between a lift-off and a touchdown."""

    apexes: Floats
    """Largest height of the sole in each swing, m."""
    landings: Floats
    """Downward speed of the sole at the end of each swing, m/s."""
    bounces: int
    """Number of times in the air within a stance in which the sole rises high enough for a bounce."""


def flights_of(height: NDArray[Any], rise: NDArray[Any], contact: Mask, shortest: int, bounce: float) -> Flights:
    """Flights of one foot from height (m), upward velocity (m/s) and contact of its sole in every physics step (K,).

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
    physics: PhysicsSamples, contact: Mask, counted: Mask, frequency: Floats, dt: float, part: GaitPart
) -> dict[str, Floats]:
    """Clearance, swings and bounces per stride, and landing speed of each foot: name -> (N, L).

    The clearance is the quantile `CLEARANCE_QUANTILE` of the apexes. A stride in which a foot does not swing counts as
    an apex of 0; at both ends of an episode one stride may be cut. For a robot that does not stride, whose frequency
    (N,) is NaN, it is 0, and the others are NaN; all are NaN for an episode without counted samples.
    """
    names = ("clearance", "swings_per_stride", "bounces_per_stride", "landing_speed")
    result = {name: np.full(contact.shape[1:], np.nan) for name in names}
    for episode, foot in np.ndindex(*contact.shape[1:]):
        samples, hertz = counted[:, episode], float(frequency[episode])
        if not samples.any():
            continue
        result["clearance"][episode, foot] = 0.0
        if not np.isfinite(hertz):
            continue
        height, rise, grounded = (values[samples, episode, foot] for values in (physics.height, physics.rise, contact))
        found = flights_of(height, rise, grounded, max(1, round(part.swing_share / (hertz * dt))), part.bounce)
        strides = hertz * samples.sum() * dt
        missing = max(0, int(strides) - 1 - len(found.apexes))
        padded = np.concatenate([np.maximum(found.apexes, 0.0), np.zeros(missing)])
        if len(padded):
            result["clearance"][episode, foot] = np.quantile(padded, CLEARANCE_QUANTILE)
        result["swings_per_stride"][episode, foot] = len(found.apexes) / strides
        result["bounces_per_stride"][episode, foot] = found.bounces / strides
        if len(found.landings):
            result["landing_speed"][episode, foot] = found.landings.mean()
    return result


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
    """Score in [0, 1] of the part: mean over the commands of the share of episodes that follow it times five numbers.

    Their mean, 0 for a robot with a foot that does not step: the clearance of the foot that is lifted least, over
    `full_clearance`; x or 1 / x, the one below 1, of the foot with the worst number x of swings per stride; 1 - bounces
    per stride; `soft_landing` over the speed of the hardest landing; `little_slip` over the largest slip. Each is at
    least 0 and at most 1.
    """
    total = 0.0
    for entry in result["commands"]:
        landings = entry["landing_speed"]
        if None in landings or None in entry["clearance"]:
            continue
        numbers = (
            min(entry["clearance"]) / part.full_clearance,
            min(min(x, 1.0 / x) for x in entry["swings_per_stride"]),
            1.0 - max(entry["bounces_per_stride"]),
            part.soft_landing / max(*landings, 1e-9),
            part.little_slip / max(*entry["slip"], 1e-9),
        )
        total += entry["followed"] * sum(min(1.0, max(0.0, number)) for number in numbers) / len(numbers)
    return total / len(result["commands"])
