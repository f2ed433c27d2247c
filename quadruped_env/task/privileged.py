"""Privileged readings: what a simulation knows and a robot does not measure, for the value function of a training."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.observations import (
    Field,
    MirrorRule,
    ObservationLayout,
    PerRobot,
    Reader,
    per_unit,
    per_velocity,
)
from quadruped_env.errors import QuadrupedError
from quadruped_env.simulation import Simulation
from quadruped_env.task.context import TaskContext
from quadruped_env.task.randomization.sensor_errors import Sensors
from quadruped_env.task.reward_function import check_fields
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.parameters import described


@dataclass(frozen=True)
class TrueState:
    """Input of privileged readings: N robots after a control step."""

    context: TaskContext
    """True readings, command, clock, and heights over the ground."""
    simulation: Simulation
    sensors: Sensors | None
    """Errors of the sensors; None if they have none."""

    def model_values(self, field: str) -> Floats:
        """Return a field of MuJoCo's model in each env (N, ...), with what randomizations have changed; read-only."""
        values = self.simulation.field_values(field)
        return np.broadcast_to(values, (self.simulation.num_envs, *values.shape[1:]))


class PrivilegedReading(Field):
    """A group of columns for the value function alone, whose `read` is a function of a `TrueState`.

    The decorator `privileged` creates it.
    """


def privileged(
    *, unit: str, mirror: MirrorRule, scale: PerRobot = 1.0, bound: PerRobot = 1.0
) -> Callable[[Reader], PrivilegedReading]:
    """Decorator: a function (state) -> (N, width) becomes a `PrivilegedReading` of the same name.

    Args:
        unit: unit of the reading.
        mirror: as of `observation`.
        scale: factor from the reading to the value function's input.
        bound: the scaled value is clipped to +-bound.
    """
    return lambda read: PrivilegedReading(read.__name__, read, unit, mirror, scale, bound, 0.0, described(read))


@privileged(unit="m/s", mirror=(1.0, -1.0, 1.0), scale=per_unit(2.0, "m/s"), bound=4.0)
def base_velocity(state: TrueState) -> Floats:
    """Linear velocity of the base in its own frame."""
    return state.context.readings.linear_velocity_b


@privileged(unit="m/s, rad/s", mirror="velocities", scale=per_velocity(4.0), bound=4.0)
def smooth_velocity(state: TrueState) -> Floats:
    """Forward velocity and yaw rate, averaged as for the rewards of tracking and progress."""
    return state.context.smooth_velocity


@privileged(unit="m/s, rad/s", mirror="velocities", scale=per_velocity(10.0), bound=4.0)
def steady_error(state: TrueState) -> Floats:
    """Errors of forward velocity and yaw rate, averaged as for the reward `steady_error`."""
    return state.context.steady_error


@privileged(unit="m", mirror=(1.0,), scale=per_unit(10.0, "m"), bound=2.0)
def base_height(state: TrueState) -> Floats:
    """Height of the base's centre over the ground below it, relative to the stance."""
    return (state.context.base_height - state.context.robot.stance_height)[:, None]


@privileged(unit="1", mirror="feet")
def foot_contact(state: TrueState) -> Floats:
    """1 for each foot on the ground, else 0."""
    return state.context.contact


@privileged(unit="m", mirror="feet", scale=per_unit(20.0, "m"), bound=4.0)
def foot_height(state: TrueState) -> Floats:
    """Height of each foot's lowest point over the ground below it."""
    return state.context.sole_height


@privileged(unit="1", mirror=(1.0,), bound=2.0)
def friction(state: TrueState) -> Floats:
    """Largest coefficient of sliding friction of ground and robot, which counts in a contact."""
    model = state.simulation.model
    collides = (model.geom_contype | model.geom_conaffinity) != 0
    return state.model_values("geom_friction")[:, collides, 0].max(axis=1, keepdims=True)


@privileged(unit="kg", mirror=(1.0,), scale=lambda robot: 4.0 / robot.total_mass, bound=4.0)
def added_mass(state: TrueState) -> Floats:
    """Mass of the whole robot minus its model's: payload and masses of the links."""
    own = state.simulation.compiled_field("body_mass")
    return (state.model_values("body_mass") - own).sum(axis=1, keepdims=True)


@privileged(unit="s", mirror=(1.0,), scale=per_unit(20.0, "s"), bound=4.0)
def action_latency(state: TrueState) -> Floats:
    """Mean delay from joint target to motor."""
    delays = state.model_values("actuator_delay")
    return delays.reshape(len(delays), -1).mean(axis=1, keepdims=True)


@privileged(unit="s", mirror=(1.0,), scale=per_unit(20.0, "s"), bound=4.0)
def observation_latency(state: TrueState) -> Floats:
    """Age of the readings when the policy receives them."""
    return np.zeros_like(state.context.velocity[:, :1]) if state.sensors is None else state.sensors.latency


PRIVILEGED: Final = (
    base_velocity,
    smooth_velocity,
    steady_error,
    base_height,
    foot_contact,
    foot_height,
    friction,
    added_mass,
    action_latency,
    observation_latency,
)
"""Built-in privileged readings, in the order of their columns."""


class PrivilegedReadings:
    """The privileged readings of N robots, scaled and clipped like an observation.

    Raises:
        QuadrupedError: if a reading is not an array with its columns.
    """

    def __init__(self, fields: Sequence[PrivilegedReading], state: TrueState) -> None:
        self.layout = ObservationLayout(state.context.robot, tuple(fields))
        self._state = state
        check_fields("privileged reading", self.layout, state.simulation.num_envs, state)

    def values(self) -> NDArray[np.float32]:
        """Return the scaled readings (N, layout.width) in a new array.

        Raises:
            QuadrupedError: if one of them is not finite.
        """
        layout, state = self.layout, self._state
        raw: Floats = np.concatenate([field.read(state) for field in layout.fields], axis=1)
        if not np.isfinite(raw).all():
            column = int(np.argwhere(~np.isfinite(raw))[0, 1])
            name = next(name for name, columns in layout.slices.items() if column < columns.stop)
            raise QuadrupedError(f"privileged reading {name}: found NaN or infinity; return finite numbers")
        return np.clip(raw * layout.scale, layout.low, layout.high).astype(np.float32)
