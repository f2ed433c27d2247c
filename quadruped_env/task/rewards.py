"""The built-in reward terms, in the order in which they are added.

A term is a function of a `TaskContext` with a weight per second, a unit and a docstring; it returns one value per env
(N,). Its arguments with a default are fields of `config["reward"]`. What several terms need is an attribute of the
context.
"""

from typing import Annotated, Final, cast

import numpy as np
from numpy.typing import NDArray

from quadruped_env.task import quantities
from quadruped_env.task.context import TaskContext
from quadruped_env.task.terms import RewardTerm, reward, reward_group
from quadruped_env.utils.arrays import frozen
from quadruped_env.utils.parameters import Parameter

Floats = NDArray[np.float64]
Positive = Parameter.positive

_SMALLEST_COMMAND: Final = frozen(np.array([0.1, 0.2]))
"""Command below which progress is reduced in proportion, for the built-in robot, m/s and rad/s."""


@reward_group(track_forward_velocity=8.0, track_yaw_rate=6.0)
class tracking:  # noqa: N801  named like the other terms
    """Tracking of the velocity command.

    track_forward_velocity: exp(-((v~ - v_command) / 0.1 m/s)^2)
    track_yaw_rate: exp(-((w~ - w_command) / 0.2 rad/s)^2)
    """

    def __init__(
        self,
        context: TaskContext,
        forward_velocity_std: Annotated[float, Positive("m/s")] = 0.1,
        yaw_rate_std: Annotated[float, Positive("rad/s")] = 0.2,
    ) -> None:
        self._std = frozen(np.array([forward_velocity_std, yaw_rate_std]))

    def __call__(self, context: TaskContext) -> Floats:
        """Values (N, 2)."""
        return np.exp(-((context.tracking_error / self._std) ** 2))


@reward_group(forward_progress=4.0, turn_progress=6.0)
def progress(context: TaskContext) -> Floats:
    """Share of the commanded velocity that is reached: share - 2 max(0, share - 1), in [-1, 1].

    forward_progress: share = v~ / v_command, less below 0.1 m/s
    turn_progress: share = w~ / w_command, less below 0.2 rad/s
    """
    # Linear, so it has a gradient at standstill, where the tracking of a fast command is flat. Of the average velocity:
    # a peak at the command would else pull the median there, not the mean.
    size = np.maximum(np.abs(context.command), _SMALLEST_COMMAND * context.velocity_unit)
    share, whole = context.smooth_velocity * (np.sign(context.command) / size), np.abs(context.command) / size
    return np.maximum(share - 2.0 * np.maximum(share - whole, 0.0), -1.0)


@reward(weight=5.0)
def gait_clock(context: TaskContext, foot_lift: Annotated[float, Positive("m")] = 0.02) -> Floats:
    """Mean over the feet of sin(phase) (1 - 2 missing^2), missing = max(0, 1 - sole height / 0.02 m)."""
    lift = quantities.foot_lift(context.sole_height, foot_lift)
    return quantities.clock_agreement(lift, context.leg_clock) * context.moving


@reward(weight=1.5)
def contact_clock(context: TaskContext) -> Floats:
    """Mean over the feet of sin(phase) (1 - 2 contact): feet in their stance that leave the ground cost."""
    return quantities.clock_agreement(1.0 - 2.0 * context.contact, context.leg_clock) * context.moving


@reward(weight=0.0)
class touchdowns:  # noqa: N801
    """Number of feet that touch down: those on the ground that were in the air a step ago."""

    def __init__(self, context: TaskContext) -> None:
        self._airborne = context.memory.zeros("touchdowns_airborne", context.robot.num_legs)

    def __call__(self, context: TaskContext) -> Floats:
        """Values (N,)."""
        landed = (self._airborne * context.contact).sum(axis=-1)
        self._airborne[:] = 1.0 - context.contact
        return landed


@reward(weight=-2.0)
def upright(context: TaskContext) -> Floats:
    """Squared horizontal part of the base's up axis."""
    up = context.readings.up_b
    return up[:, 0] ** 2 + up[:, 1] ** 2


@reward(weight=-20.0, unit="m^2")
def base_height(context: TaskContext, base_height: Annotated[float, Positive("m")] = 0.175) -> Floats:
    """max(0, 0.175 m - height)^2: standing taller is not penalized."""
    return np.maximum(base_height - context.base_height, 0.0) ** 2


@reward(weight=0.0, unit="m^2")
def crouch(context: TaskContext, crouch_height: Annotated[float, Positive("m")] = 0.145) -> Floats:
    """max(0, height - 0.145 m)^2: the lower a robot, the harder a push must be to tip it over its feet."""
    return np.maximum(context.base_height - crouch_height, 0.0) ** 2


@reward(weight=0.0, unit="m^2")
def high_steps(context: TaskContext, step_height: Annotated[float, Positive("m")] = 0.01) -> Floats:
    """Sum over the feet of max(0, sole height - 0.01 m)^2: the higher its feet, the sooner a push tips the robot."""
    return (np.maximum(context.sole_height - step_height, 0.0) ** 2).sum(axis=-1)


@reward(weight=-0.5, unit="m^2/s^2")
def vertical_velocity(context: TaskContext) -> Floats:
    """v_z^2."""
    return context.readings.linear_velocity_b[:, 2] ** 2


@reward(weight=-0.03, unit="rad^2/s^2")
def roll_pitch_rate(context: TaskContext) -> Floats:
    """w_x^2 + w_y^2."""
    rate = context.readings.angular_velocity_b
    return rate[:, 0] ** 2 + rate[:, 1] ** 2


@reward(weight=-0.5, unit="m^2/s^2")
def lateral_velocity(context: TaskContext) -> Floats:
    """v_y^2."""
    return context.readings.linear_velocity_b[:, 1] ** 2


@reward(weight=-0.08)
def action_rate(context: TaskContext) -> Floats:
    """Sum of (action - previous action)^2."""
    return ((context.action - context.previous_action) ** 2).sum(axis=-1)


@reward(weight=-0.005, unit="W")
def mechanical_power(context: TaskContext) -> Floats:
    """Sum of max(0, torque * joint velocity)."""
    return quantities.mechanical_power(context.readings.joint_torque, context.readings.joint_velocity)


@reward(weight=0.0, unit="W")
class electrical_power:  # noqa: N801
    """Sum of max(0, torque * joint velocity) + torque^2 R / K^2: mechanical power, and heat in the windings."""

    def __init__(self, context: TaskContext) -> None:
        self._heat = frozen(context.motors.joule_coefficients(context.robot.joint_kinds))

    def __call__(self, context: TaskContext) -> Floats:
        """Values (N,)."""
        return quantities.electrical_power(context.readings.joint_torque, context.readings.joint_velocity, self._heat)


@reward(weight=-0.3, unit="m^2/s^2")
def foot_slip(context: TaskContext) -> Floats:
    """Sum over the feet on the ground of the squared velocity of the sole's lowest point."""
    readings, radius = context.readings, context.robot.foot_radius
    sliding = quantities.sliding_squared(readings.foot_velocity, readings.foot_angular_velocity, radius)
    return (sliding * context.contact).sum(axis=-1)


@reward(weight=-1.0, unit="rad^2")
def stand_still(context: TaskContext) -> Floats:
    """Sum of (joint position - stance)^2 while standing is commanded: at most 0.02 m/s and 0.02 rad/s."""
    return (context.joint_offset**2).sum(axis=-1) * (1.0 - context.moving)


@reward(weight=-1.0, unit="rad^2/s^2")
def joint_speed(context: TaskContext, joint_speed_margin: Annotated[float, Parameter("rad/s")] = 1.0) -> Floats:
    """Sum of max(0, joint speed - 4 rad/s)^2: a motor at its top speed of 5 rad/s has no torque left."""
    excess = np.abs(context.readings.joint_velocity) - (context.robot.velocity_limit - joint_speed_margin)
    return (np.maximum(excess, 0.0) ** 2).sum(axis=-1)


@reward(weight=-50.0)
def fall(context: TaskContext) -> Floats:
    """1 where the episode ends in a fall."""
    return context.fallen


# mypy ignores the return type of a class decorator.
REWARDS: Final = cast(
    "tuple[RewardTerm, ...]",
    (
        tracking,
        progress,
        gait_clock,
        contact_clock,
        touchdowns,
        upright,
        base_height,
        crouch,
        high_steps,
        vertical_velocity,
        roll_pitch_rate,
        lateral_velocity,
        action_rate,
        mechanical_power,
        electrical_power,
        foot_slip,
        stand_still,
        joint_speed,
        fall,
    ),
)
"""Built-in reward terms, in the order in which they are added."""
