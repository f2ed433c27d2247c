"""The built-in reward terms, in the order in which they are added.

A term is a function of a `TaskContext` with a weight per second, a unit and a docstring. Its arguments with a default
are fields of `config["reward"]`.
"""

from typing import Annotated, Any, Final, cast

import numpy as np
from numpy.typing import NDArray

from quadruped_env.task import quantities
from quadruped_env.task.context import TaskContext
from quadruped_env.task.terms import RewardTerm, reward, reward_group
from quadruped_env.utils.parameters import Parameter

Positive = Parameter.positive


@reward_group(pure=True, track_forward_velocity=8.0, track_yaw_rate=6.0)
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
        self._std = context.xp.constant([[forward_velocity_std, yaw_rate_std]])

    def __call__(self, context: TaskContext) -> Any:
        """Values (N, 2)."""
        return quantities.tracking_kernel(context.tracking_error, self._std, context.xp)


@reward_group(pure=True, forward_progress=4.0, turn_progress=6.0)
class progress:  # noqa: N801
    """Share of the commanded velocity that is reached: share - 2 max(0, share - 1), in [-1, 1].

    forward_progress: share = v~ / v_command, less below 0.1 m/s
    turn_progress: share = w~ / w_command, less below 0.2 rad/s
    """

    def __init__(self, context: TaskContext) -> None:
        self._scale = context.memory.zeros("progress_scale", 2)
        self._whole = context.memory.zeros("progress_whole", 2)

    def command_changed(self, env_ids: NDArray[np.intp], command: NDArray[np.float64]) -> None:
        """Update the scale for new velocity commands (R, 2) of some envs (R,)."""
        self._scale[env_ids], self._whole[env_ids] = quantities.progress_scale(command)

    def __call__(self, context: TaskContext) -> Any:
        """Values (N, 2)."""
        # The average: a peak at the command would else pull the median there, not the mean.
        return quantities.progress(context.smooth_velocity * self._scale, self._whole, context.xp)


@reward(weight=5.0, pure=True)
class gait_clock:  # noqa: N801
    """Mean over the feet of sin(phase) (1 - 2 missing^2), missing = max(0, 1 - sole height / 0.02 m)."""

    def __init__(self, context: TaskContext, foot_lift: Annotated[float, Parameter.length()] = 0.02) -> None:
        self._lift = quantities.FootLift(foot_lift, context.xp)

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        agreement = quantities.clock_agreement(self._lift(context.sole_height), context.control.leg_clock(), context.xp)
        return agreement * context.moving


@reward(weight=1.5, pure=True)
def contact_clock(context: TaskContext) -> Any:
    """Mean over the feet of sin(phase) (1 - 2 contact): feet in their stance that leave the ground cost."""
    lift = context.xp.one - context.contact * 2.0
    return quantities.clock_agreement(lift, context.control.leg_clock(), context.xp) * context.moving


@reward(weight=0.0, pure=True)
class touchdowns:  # noqa: N801
    """Number of feet that touch down: those on the ground that were in the air a step ago."""

    def __init__(self, context: TaskContext) -> None:
        self._airborne = context.memory.zeros("touchdowns_airborne", context.robot.num_legs)

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        contact = context.contact
        landed = context.xp.dot(self._airborne, contact)
        np.subtract(context.xp.one, contact, out=self._airborne)
        return landed


@reward(weight=-2.0, pure=True)
def upright(context: TaskContext) -> Any:
    """Squared horizontal part of the base's up axis."""
    horizontal = context.readings.up_b[:, :2]
    return context.xp.dot(horizontal, horizontal)


@reward(weight=-20.0, unit="m^2", pure=True)
class base_height:  # noqa: N801
    """max(0, 0.175 m - height)^2: standing taller is not penalized."""

    def __init__(self, context: TaskContext, base_height: Annotated[float, Parameter.length()] = 0.175) -> None:
        self._target = context.xp.constant(base_height)

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        missing = context.xp.positive(self._target - context.base_height)
        return missing * missing


@reward(weight=0.0, unit="m^2", pure=True)
class crouch:  # noqa: N801
    """max(0, height - 0.145 m)^2: the lower a robot, the harder a push must be to tip it over its feet."""

    def __init__(self, context: TaskContext, crouch_height: Annotated[float, Parameter.length()] = 0.145) -> None:
        self._target = context.xp.constant(crouch_height)

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        above = context.xp.positive(context.base_height - self._target)
        return above * above


@reward(weight=0.0, unit="m^2", pure=True)
class high_steps:  # noqa: N801
    """Sum over the feet of max(0, sole height - 0.01 m)^2: the higher its feet, the sooner a push tips the robot."""

    def __init__(self, context: TaskContext, step_height: Annotated[float, Parameter.length()] = 0.01) -> None:
        self._allowed = context.xp.constant(step_height)

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        excess = context.xp.positive(context.sole_height - self._allowed)
        return context.xp.dot(excess, excess)


@reward(weight=-0.5, unit="m^2/s^2", pure=True)
def vertical_velocity(context: TaskContext) -> Any:
    """v_z^2."""
    velocity = context.readings.linear_velocity_b[:, 2]
    return velocity * velocity


@reward(weight=-0.03, unit="rad^2/s^2", pure=True)
def roll_pitch_rate(context: TaskContext) -> Any:
    """w_x^2 + w_y^2."""
    rate = context.readings.angular_velocity_b[:, :2]
    return context.xp.dot(rate, rate)


@reward(weight=-0.5, unit="m^2/s^2", pure=True)
def lateral_velocity(context: TaskContext) -> Any:
    """v_y^2."""
    velocity = context.readings.linear_velocity_b[:, 1]
    return velocity * velocity


@reward(weight=-0.08, pure=True)
def action_rate(context: TaskContext) -> Any:
    """Sum of (action - previous action)^2."""
    change = context.action - context.previous_action
    return context.xp.dot(change, change)


@reward(weight=-0.005, unit="W", pure=True)
def mechanical_power(context: TaskContext) -> Any:
    """Sum of max(0, torque * joint velocity)."""
    return quantities.mechanical_power(context.readings.joint_torque, context.readings.joint_velocity, context.xp)


@reward(weight=0.0, unit="W", pure=True)
class electrical_power:  # noqa: N801
    """Sum of max(0, torque * joint velocity) + torque^2 R / K^2: mechanical power, and heat in the windings."""

    def __init__(self, context: TaskContext) -> None:
        self._heat = context.xp.constant(context.motors.joule_coefficients(context.robot.joint_kinds))[None]

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        readings = context.readings
        return quantities.electrical_power(readings.joint_torque, readings.joint_velocity, self._heat, context.xp)


@reward(weight=-0.3, unit="m^2/s^2", pure=True)
class foot_slip:  # noqa: N801
    """Sum over the feet on the ground of the squared velocity of the sole's lowest point."""

    def __init__(self, context: TaskContext) -> None:
        self._radius = context.xp.constant(context.robot.foot_radius)

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        readings = context.readings
        sliding = quantities.sliding_squared(readings.foot_velocity, readings.foot_angular_velocity, self._radius)
        return context.xp.dot(sliding, context.contact)


@reward(weight=-1.0, unit="rad^2", pure=True)
def stand_still(context: TaskContext) -> Any:
    """Sum of (joint position - stance)^2 while standing is commanded: at most 0.02 m/s and 0.02 rad/s."""
    offset = context.joint_offset
    return context.xp.dot(offset, offset) * (context.xp.one - context.moving)


@reward(weight=-1.0, unit="rad^2/s^2", pure=True)
class joint_speed:  # noqa: N801
    """Sum of max(0, joint speed - 4 rad/s)^2: a motor at its top speed of 5 rad/s has no torque left."""

    def __init__(self, context: TaskContext, joint_speed_margin: Annotated[float, Parameter("rad/s")] = 1.0) -> None:
        self._free = context.xp.constant(context.robot.velocity_limit - joint_speed_margin)[None]

    def __call__(self, context: TaskContext) -> Any:
        """Values (N,)."""
        excess = context.xp.positive(context.xp.abs(context.readings.joint_velocity) - self._free)
        return context.xp.dot(excess, excess)


@reward(weight=-50.0, pure=True)
def fall(context: TaskContext) -> Any:
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
