"""Trials of open-loop gaits: what many of them reach on flat ground, in parallel."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gait_search.strides import Strides
from quadruped_env.gait.gait_presets import TUNED_ON
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import TaskConfig
from quadruped_env.task.quantities import (
    clock_agreement,
    electrical_power,
    foot_lift,
    mechanical_power,
    sliding_squared,
)
from quadruped_env.utils.arrays import Floats

Targets = Callable[[float], Floats]
"""Joint targets (N, J) in rad of N gaits as a function of the gait clock in rad."""

WARM_UP: Final = 1.0
"""Time before measurement starts, s."""
SECONDS: Final = 3.0
TARGET_OFFSET: Final = 0.01
"""Largest offset of a joint target in new starts, as large as the encoders' in the preset `moderate`, rad."""


class Scale:
    """Size of a robot relative to the one on which the presets were tuned.

    The same motion of a robot that is s times as tall is sqrt(s) times as fast, and has sqrt(1/s) times the frequency.
    """

    def __init__(self, robot: Robot) -> None:
        self.length = scale_of("m", robot)
        self.velocity = scale_of("m/s", robot)
        self.rate = 1.0 / self.velocity
        self.power = robot.total_mass / TUNED_ON.total_mass * self.velocity


class Starts(NamedTuple):
    """States in which trials start, the first axis of each over the starts.

    Gait clock (rad); coefficient of sliding friction of the ground and the robot; time constant of the contacts, as a
    multiple of the robot's; velocity of the base, linear in m/s (world frame) and angular in rad/s (body frame), and of
    the joints (rad/s); joint positions relative to the stance, and what is added to the targets of the whole trial
    (rad).
    """

    clock: Floats
    friction: Floats
    softness: Floats
    velocity: Floats
    joint_offset: Floats
    target_offset: Floats


def draw_starts(robot: Robot, *seeds: int, target_offset: float = 0.0) -> Starts:
    """For each seed six starts over the gait's cycle, with velocities and joint positions as in episodes or more.

    Two of the six come once more, with soft contacts: these change about what stiffer ones, and another engine's,
    change in the other direction.
    """
    largest = np.repeat([0.3, 0.5, 0.1], [6, robot.num_joints, robot.num_joints])
    row = [0, 1, 2, 3, 4, 5, 1, 4]
    parts = []
    for seed in seeds:
        rng = np.random.default_rng(seed)
        velocity, joint_offset = np.split(rng.uniform(-largest, largest, (6, len(largest))), [robot.num_velocities], 1)
        offset = rng.uniform(-target_offset, target_offset, (6, robot.num_joints))
        clock, friction = math.tau * np.arange(6) / 6, np.array([0.7, 0.8, 0.9] * 2)
        softness = np.repeat([1.0, 2.0], [6, 2])
        parts.append((clock[row], friction[row], softness, velocity[row], joint_offset[row], offset[row]))
    return Starts(*map(np.concatenate, zip(*parts, strict=True)))


def new_starts(robot: Robot, generation: int, draws: int = 1) -> Starts:
    """Starts that no other generation of a search has, with offsets of the joint targets; `draws` times `draw_starts`.

    From the same ones again and again, a search finds gaits that need these starts and their own numbers exactly.
    """
    seeds = range(1000 + draws * generation, 1000 + draws * (generation + 1))
    return draw_starts(robot, *seeds, target_offset=TARGET_OFFSET)


@dataclass(frozen=True)
class Achieved:
    """Results of N gaits, (N,) each, in SI units: means over the starts with the robot's own contacts, unless said.

    `tilt` is the root mean square of the horizontal part of the base's up axis; `power` positive mechanical power, and
    `electrical_power` that and the heat in the windings; `slip` the sliding velocity of feet on the ground (root mean
    square); `lift` and `clock` the agreement, in [-1, 1], of the feet's heights and contacts with a clock that swings
    each foot while the sine of its phase is positive; `touchdown_error` the difference of each foot's touchdowns per
    stride from one.
    """

    forward_velocity: Floats
    yaw_rate: Floats
    lateral_velocity: Floats
    tilt: Floats
    power: Floats
    electrical_power: Floats
    slip: Floats
    lift: Floats
    clock: Floats
    touchdown_error: Floats
    clearance: Floats
    """Largest height of a sole in a stride or in a swing: the smallest of all strides, swings, feet and starts."""
    lowest_apex: Floats
    """The same of each foot from each start (N, S, 4)."""
    mean_apex: Floats
    """Largest height of each sole in a stride, mean over the whole strides (N, S, 4)."""
    highest: Floats
    """The same of the foot that is lifted most."""
    fallen: NDArray[np.bool_]
    """From any of the starts."""
    forward_velocity_spread: Floats
    """Largest difference from the mean, from any start and with soft contacts too."""
    yaw_rate_spread: Floats

    def like_the_tuned_robot(self, robot: Robot) -> "Achieved":
        """Return the same motion of a robot of the size for which the costs of a search are given."""
        scale = Scale(robot)
        units = {
            scale.velocity: ("forward_velocity", "lateral_velocity", "slip", "forward_velocity_spread"),
            scale.rate: ("yaw_rate", "yaw_rate_spread"),
            scale.length: ("clearance", "lowest_apex", "mean_apex", "highest"),
            scale.power: ("power", "electrical_power"),
        }
        values = dict(vars(self))
        for unit, names in units.items():
            values |= {name: values[name] / unit for name in names}
        return Achieved(**values)


def measure(
    robot: Robot,
    joint_targets: Targets,
    count: int,
    angular_frequency: float,
    turns: tuple[float, ...],
    starts: Starts,
) -> Achieved:
    """Run so many gaits from the stance.

    Args:
        robot: the robot.
        joint_targets: of all gaits.
        count: number of gaits, N.
        angular_frequency: of the gait clock, rad/s.
        turns: phase of the leg of each corner, cycles.
        starts: every gait is tried from each.
    """
    config, n = TaskConfig().for_robot(robot), count * len(starts.clock)
    simulation = BatchSimulation(config.compiled_model(), n, robot=robot)
    # As in the task's randomization, all geoms are set: the larger friction of the two in contact counts.
    simulation.model_field("geom_friction")[..., 0] = np.repeat(starts.friction, count)[:, None]
    simulation.model_field("geom_solref")[..., 0] *= np.repeat(starts.softness, count)[:, None]
    qpos = np.zeros((n, robot.num_positions))
    qpos[:, 2], qpos[:, 3] = robot.stance_height, 1.0
    qpos[:, 7:] = robot.stance + np.repeat(starts.joint_offset, count, axis=0)
    simulation.reset(np.arange(n), qpos, np.repeat(starts.velocity, count, axis=0))
    state = simulation.readings
    heat = robot.motors.joule_coefficients(robot.joint_kinds)
    phases = math.tau * np.array(turns)[list(robot.corners)] + np.repeat(starts.clock, count)[:, None]
    fallen, contact = np.zeros(n, dtype=np.bool_), np.ones((n, robot.num_legs), dtype=np.bool_)
    sums, strides, steps = np.zeros((9, n)), Strides(n), 0
    for k in range(1, round(SECONDS / config.control_timestep) + 1):
        t = k * config.control_timestep
        # The gait starts with its whole amplitude, as in the env.
        targets = [
            joint_targets(angular_frequency * t + clock) + offset
            for clock, offset in zip(starts.clock.tolist(), starts.target_offset, strict=True)
        ]
        simulation.step(np.concatenate(targets), config.decimation)
        fallen |= (state.up_b[:, 2] < 0.5) | (state.trunk_force > 1.0).any(axis=1) | simulation.diverged()
        if t <= WARM_UP:
            continue
        steps += 1
        before, contact = contact, state.foot_force > 1.0
        sliding = sliding_squared(state.foot_velocity, state.foot_angular_velocity, robot.foot_radius)
        height = state.foot_position[..., 2] - robot.foot_radius
        angle = angular_frequency * t + phases
        sine = np.sin(angle)
        strides.add(np.floor(angle / math.tau), height, contact, before)
        sums += [
            state.linear_velocity_b[:, 0],
            state.angular_velocity_b[:, 2],
            state.linear_velocity_b[:, 1],
            (state.up_b[:, :2] ** 2).sum(axis=1),
            mechanical_power(state.joint_torque, state.joint_velocity),
            electrical_power(state.joint_torque, state.joint_velocity, heat),
            (sliding * contact).sum(axis=1),
            clock_agreement(foot_lift(height, config.reward["foot_lift"]), sine),
            clock_agreement(1.0 - 2.0 * contact, sine),
        ]
    vx, wz, vy, tilt, power, electrical, slip, lift, clock = sums / steps
    mean_apex = strides.apexes / strides.count
    each = {
        "forward_velocity": vx,
        "yaw_rate": wz,
        "lateral_velocity": vy,
        "tilt": np.sqrt(tilt),
        "power": power,
        "electrical_power": electrical,
        "slip": np.sqrt(slip / robot.num_legs),
        "lift": lift,
        "clock": clock,
        "touchdown_error": np.abs(strides.touchdowns / strides.count - 1.0).mean(axis=1),
        "highest": mean_apex.max(axis=1),
    }
    own = starts.softness == 1.0
    by_start = {name: value.reshape(-1, count) for name, value in each.items()}
    means = {name: value[own].mean(axis=0) for name, value in by_start.items()}
    spreads = {
        f"{name}_spread": np.abs(by_start[name] - means[name]).max(axis=0) for name in ("forward_velocity", "yaw_rate")
    }
    lowest, mean_apex = (
        part.reshape(-1, count, robot.num_legs)[own].swapaxes(0, 1) for part in (strides.lowest_apex, mean_apex)
    )
    return Achieved(
        **means,
        **spreads,
        lowest_apex=lowest,
        mean_apex=mean_apex,
        clearance=lowest.min(axis=(1, 2)),
        fallen=np.any(fallen.reshape(-1, count), axis=0),
    )
