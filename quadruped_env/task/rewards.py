"""The built-in reward terms, in the order in which they are added.

A term is a function of a `TaskContext` with a weight per second, a unit and a docstring; it returns one value per env
(N,). Its arguments with a default are fields of `config["reward"]`. What several terms need is an attribute of the
context.
"""

from typing import Annotated, Final, cast

import numpy as np

from quadruped_env.task import quantities
from quadruped_env.task.context import TaskContext
from quadruped_env.task.terms import RewardTerm, reward, reward_group
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.parameters import Parameter

Positive = Parameter.positive


@reward_group(track_forward_velocity=9.0, track_yaw_rate=9.0)
class tracking:  # noqa: N801  named like the other terms
    """Tracking of the velocity command.

    track_forward_velocity: exp(-((v~ - v_command) / 0.07 m/s)^2)
    track_yaw_rate: exp(-((w~ - w_command) / 0.15 rad/s)^2)
    """

    def __init__(
        self,
        context: TaskContext,
        forward_velocity_std: Annotated[float, Positive("m/s")] = 0.07,
        yaw_rate_std: Annotated[float, Positive("rad/s")] = 0.15,
    ) -> None:
        self._std = np.array([forward_velocity_std, yaw_rate_std])

    def __call__(self, context: TaskContext) -> Floats:
        """Return the values (N, 2)."""
        return np.exp(-((context.tracking_error[:, :2] / self._std) ** 2))


@reward_group(forward_progress=9.0, turn_progress=9.0)
def progress(context: TaskContext) -> Floats:
    """Share of the commanded velocity that is reached: share - 2 max(0, share - 1), in [-1, 1].

    forward_progress: share = v~ / v_command, less below 0.1 m/s
    turn_progress: share = w~ / w_command, less below 0.2 rad/s
    """
    return _progress(context)[:, :2]


def _progress(context: TaskContext) -> Floats:
    """Return the progress in each velocity of the command (N, V)."""
    # Linear, so it has a gradient at standstill, where the tracking of a fast command is flat. Of the average velocity:
    # a peak at the command would else pull the median there, not the mean.
    command = context.command
    speed = np.abs(command)
    size = np.maximum(speed, context.smallest_command)
    share, whole = context.smooth_velocity * (np.sign(command) / size), speed / size
    return np.maximum(share - 2.0 * np.maximum(share - whole, 0.0), -1.0)


@reward(weight=0.0)
def steady_error(context: TaskContext) -> Floats:
    """Sum over the velocities of the average error over about 2 s, over 0.1 m/s and 0.2 rad/s: a bias costs."""
    return np.add.reduce(np.abs(context.steady_error) / context.smallest_command, axis=-1)


@reward(weight=8.0)
def gait_clock(
    context: TaskContext,
    foot_lift: Annotated[float, Positive("m")] = 0.012,
    highest_lift: Annotated[float, Positive("m")] = 0.06,
) -> Floats:
    """Mean over the feet of sin(phase) (1 - 2 min(1, abs(1 - height / lift))^2), lift 0.012 m or more.

    More where the ground on the foot's way rises: up to 0.06 m.
    """
    full = np.minimum(foot_lift + context.rise_ahead(), max(foot_lift, highest_lift))
    lift = quantities.foot_lift(context.sole_height, full)
    return quantities.clock_agreement(lift, context.leg_clock) * context.moving


@reward(weight=3.0)
def contact_clock(context: TaskContext) -> Floats:
    """Mean over the feet of sin(phase) (1 - 2 contact): feet in their stance that leave the ground cost."""
    return quantities.clock_agreement(1.0 - 2.0 * context.contact, context.leg_clock) * context.moving


@reward(weight=-10.0)
def upright(context: TaskContext) -> Floats:
    """Squared horizontal part of the base's up axis."""
    up = context.readings.up_b
    return up[:, 0] ** 2 + up[:, 1] ** 2


@reward(weight=-2.0, unit="m^2/s^2")
def base_motion(context: TaskContext, base_arm: Annotated[float, Positive("m")] = 0.2) -> Floats:
    """v_y^2 + v_z^2 + (0.2 m)^2 (w_x^2 + w_y^2): motion of the base that no command asks for."""
    v, w = context.readings.linear_velocity_b, context.readings.angular_velocity_b
    sideways = v[:, 1] - context.command[:, 2] if context.command.shape[1] > 2 else v[:, 1]
    return sideways**2 + v[:, 2] ** 2 + base_arm**2 * (w[:, 0] ** 2 + w[:, 1] ** 2)


@reward(weight=-1.0)
def action_rate(context: TaskContext) -> Floats:
    """Sum of (action - previous action)^2."""
    return np.add.reduce((context.action - context.previous_action) ** 2, axis=-1)


@reward(weight=-0.04, unit="W")
class electrical_power:  # noqa: N801
    """Sum of max(0, torque * joint velocity) + torque^2 R / K^2, mean over the physics steps."""

    def __init__(self, context: TaskContext) -> None:
        self._heat = context.motors.joule_coefficients(context.robot.joint_kinds)

    def __call__(self, context: TaskContext) -> Floats:
        """Return the values (N,)."""
        substeps = context.substeps
        power = quantities.electrical_power(substeps.joint_torque, substeps.joint_velocity, self._heat)
        return quantities.mean_over_steps(power)


@reward(weight=-2.0, unit="m^2/s^2")
def foot_slip(context: TaskContext) -> Floats:
    """Sum over the feet on the ground of the sole's squared sliding speed, mean over the physics steps."""
    return np.add.reduce(context.slip, axis=-1)


@reward(weight=-1.0, unit="m^2/s^3")
def landing(context: TaskContext) -> Floats:
    """Sum over the feet that touch down of their squared downward speed, over the time of the step: -v^2 a landing."""
    return np.add.reduce(context.landing_speed**2, axis=-1) / context.timestep


@reward(weight=-5.0, unit="rad^2")
def stand_still(context: TaskContext) -> Floats:
    """Sum of (joint position - stance)^2 while standing is commanded: at most 0.02 m/s and 0.02 rad/s."""
    return np.add.reduce(context.joint_offset**2, axis=-1) * (1.0 - context.moving)


@reward(weight=-250.0)
def fall(context: TaskContext) -> Floats:
    """1 where the episode ends in a fall."""
    return context.fallen


@reward_group(track_lateral_velocity=9.0, lateral_progress=9.0)
def lateral(context: TaskContext, lateral_velocity_std: Annotated[float, Positive("m/s")] = 0.07) -> Floats:
    """Tracking of the lateral velocity, and progress in it; of robots that move sideways, added after the others.

    track_lateral_velocity: exp(-((u~ - u_command) / 0.07 m/s)^2)
    lateral_progress: as forward_progress, share = u~ / u_command, less below 0.1 m/s
    """
    tracked = np.exp(-((context.tracking_error[:, 2] / lateral_velocity_std) ** 2))
    return np.stack([tracked, _progress(context)[:, 2]], axis=-1)


# mypy ignores the return type of a class decorator.
REWARDS: Final = cast(
    "tuple[RewardTerm, ...]",
    (
        tracking,
        progress,
        steady_error,
        gait_clock,
        contact_clock,
        upright,
        base_motion,
        action_rate,
        electrical_power,
        foot_slip,
        landing,
        stand_still,
        fall,
    ),
)
"""Built-in reward terms, in the order in which they are added."""
