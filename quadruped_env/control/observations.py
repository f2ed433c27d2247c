"""Observations of a policy: a list of fields, each with its reader, scale, bounds, noise and mirror rule."""

import importlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final, Literal

import numpy as np

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.readings import Readings
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.utils.arrays import Floats, frozen
from quadruped_env.utils.parameters import described
from quadruped_env.utils.plain import Plain

if TYPE_CHECKING:
    from quadruped_env.control.control_interface import ControlInterface


Reader = Callable[..., Floats]
PerRobot = float | Callable[[Robot], float | Floats]
"""Number, or function that computes it from the robot; as an array, one number per column."""
MirrorRule = Literal["joints", "feet", "velocities"] | tuple[float, ...]
_VELOCITY_SIGNS: Final = (1.0, -1.0, -1.0)
"""Effect of the left/right mirror on forward velocity, yaw rate and lateral velocity."""


@dataclass(frozen=True)
class Field:
    """A group of columns: value = clip((reading + noise) * scale, low, high)."""

    name: str
    read: Reader
    """Function that returns the reading (N, width) in `unit`."""
    unit: str
    mirror: MirrorRule
    """Effect of the left/right mirror on the reading: `joints` or `feet` if its columns, one per joint or foot, swap
    sides; `velocities` for one column per velocity of the robot's command; else one sign per column."""
    scale: PerRobot
    bound: PerRobot
    """Bound to which the scaled value is clipped, +-bound."""
    noise: float
    """Amplitude of uniform noise on the reading if `randomization.observation_noise` is 1, in the reading's unit; of a
    built-in field, for the built-in robot."""
    description: str

    def __reduce__(self) -> tuple[object, ...]:
        # Pickled by name, like functions: a field of a user's file may hold a lambda.
        return _named, (self.read.__module__, self.name)

    def width(self, robot: Robot) -> int:
        """Number of columns."""
        if self.mirror == "joints":
            return robot.num_joints
        if self.mirror == "feet":
            return robot.num_legs
        return len(self.signs(robot))

    def unit_of(self, robot: Robot) -> str:
        """Unit of the columns for a robot."""
        return f"{self.unit}, m/s" if self.mirror == "velocities" and self.width(robot) == 3 else self.unit

    def signs(self, robot: Robot) -> tuple[float, ...]:
        """Sign of each column under the mirror, if they keep their places."""
        if self.mirror == "velocities":
            return _VELOCITY_SIGNS[: len(velocity_commands(robot))]
        return tuple(map(float, self.mirror))


class ObservationField(Field):
    """A field of the observation, whose `read` is a function (readings, control interface).

    The decorator `observation` creates it. If the policy is to run on a real robot, the robot must measure all readings
    that the field uses.
    """


def observation(
    *, unit: str, mirror: MirrorRule, scale: PerRobot = 1.0, bound: PerRobot = 1.0, noise: float = 0.0
) -> Callable[[Reader], ObservationField]:
    """Decorator: a function (readings, control) -> (N, width) becomes an `ObservationField` of the same name.

    Args:
        unit: unit of the reading.
        mirror: `"joints"` for one column per joint, whose sign changes with the joint's (`Robot.joint_signs`), `"feet"`
            for one per foot, `"velocities"` for one per velocity of the robot's command; else one sign per column.
        scale: factor from the reading to the observation.
        bound: the scaled value is clipped to +-bound.
        noise: amplitude of uniform noise on the reading, in its unit.
    """
    return lambda read: ObservationField(read.__name__, read, unit, mirror, scale, bound, noise, described(read))


def per_unit(number: float, *units: str) -> Callable[[Robot], Floats]:
    """Scale of a built-in field: a number per unit for the built-in robot, and for another one per unit of its size.

    The number is the factor from the reading to the scaled value; there is one unit, or one per column.
    """
    return lambda robot: np.array([number / scale_of(unit, robot) for unit in units])


def per_velocity(number: float) -> Callable[[Robot], Floats]:
    """Return the scale of a built-in field with the columns `velocities`; see `per_unit`."""
    return lambda robot: per_unit(number, *(entry.unit for entry in velocity_commands(robot)))(robot)


def _named(module: str, name: str) -> Field:
    return getattr(importlib.import_module(module), name)


def _largest_joint_offset(robot: Robot) -> float:
    """Distance of the joint limit that is farthest from the stance, rad."""
    low, high = robot.stance - robot.joint_position_low, robot.joint_position_high - robot.stance
    return float(np.maximum(low, high).max())


@observation(unit="1", mirror=(1.0, -1.0, 1.0), noise=0.02)
def projected_gravity(readings: Readings, control: "ControlInterface") -> Floats:
    """Unit vector of gravity in the base frame."""
    return -readings.up_b


# Mirroring flips the x and z components of an axial vector.
@observation(unit="rad/s", mirror=(-1.0, 1.0, -1.0), scale=per_unit(0.25, "rad/s"), bound=4.0, noise=0.1)
def angular_velocity(readings: Readings, control: "ControlInterface") -> Floats:
    """Angular velocity in the base frame (gyroscope)."""
    return readings.angular_velocity_b


@observation(unit="rad", mirror="joints", bound=_largest_joint_offset, noise=0.01)
def joint_position(readings: Readings, control: "ControlInterface") -> Floats:
    """Joint positions relative to the stance."""
    return readings.joint_position - control.stance


# Impacts can move a joint faster than its motor can, hence the bound of 3.
@observation(unit="rad/s", mirror="joints", scale=lambda robot: 1.0 / robot.velocity_limit.max(), bound=3.0, noise=0.3)
def joint_velocity(readings: Readings, control: "ControlInterface") -> Floats:
    """Joint velocities."""
    return readings.joint_velocity


@observation(unit="1", mirror="joints")
def last_action(readings: Readings, control: "ControlInterface") -> Floats:
    """Previous action, clipped to [-1, 1]."""
    return control.action


@observation(unit="m/s, rad/s", mirror="velocities", scale=per_velocity(4.0), bound=4.0)
def command(readings: Readings, control: "ControlInterface") -> Floats:
    """Commanded forward velocity and yaw rate."""
    return control.command


# In a trot the left fore leg swings with the right hind leg, so the mirrored clock is shifted by half a cycle.
@observation(unit="1", mirror=(-1.0, -1.0))
def gait_clock(readings: Readings, control: "ControlInterface") -> Floats:
    """Sine and cosine of the gait phase; 0 when standing is commanded: at most 0.02 m/s and 0.02 rad/s."""
    return control.clock


OBSERVATIONS: Final = (
    projected_gravity,
    angular_velocity,
    joint_position,
    joint_velocity,
    last_action,
    command,
    gait_clock,
)
"""Built-in fields, in the order of their columns."""


@dataclass(frozen=True, eq=False)
class ObservationLayout:
    """Columns of the observation of one robot at one control step, computed from a list of fields.

    Raises:
        QuadrupedError: if the list is empty or two fields have the same name.
    """

    robot: Robot
    fields: tuple[Field, ...] = OBSERVATIONS
    history: int = 1
    """Number of control steps whose observations a policy gets at once, the latest first. The other attributes describe
    the columns of one step."""
    width: int = field(init=False)
    slices: dict[str, slice] = field(init=False)
    """Columns of each field, by name."""
    scale: Floats = field(init=False)
    """Factor per column, (width,); `low` and `high` have the same shape."""
    low: Floats = field(init=False)
    high: Floats = field(init=False)

    def __post_init__(self) -> None:
        names = [entry.name for entry in self.fields]
        if not names or len(set(names)) < len(names):
            raise QuadrupedError(f"observations: expected one or more fields with unique names; found {names}")
        widths = [entry.width(self.robot) for entry in self.fields]
        starts = [sum(widths[:i]) for i in range(len(widths))]
        bounds = self._columns("bound", widths)
        values: dict[str, object] = {
            "width": sum(widths),
            "slices": {n: slice(s, s + w) for n, s, w in zip(names, starts, widths, strict=True)},
            "scale": self._columns("scale", widths),
            "low": -bounds,
            "high": bounds,
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def _columns(self, attribute: str, widths: Sequence[int]) -> Floats:
        numbers = [self._numbers(getattr(entry, attribute)) for entry in self.fields]
        columns = [np.broadcast_to(number, width) for number, width in zip(numbers, widths, strict=True)]
        return frozen(np.concatenate(columns))

    def _numbers(self, value: PerRobot) -> Floats:
        return np.asarray(value(self.robot) if callable(value) else value, dtype=np.float64)

    def _plain(self, value: PerRobot) -> float | list[float]:
        """One number if all columns have the same, else one per column."""
        numbers = np.unique(self._numbers(value))
        return float(numbers[0]) if len(numbers) == 1 else self._numbers(value).tolist()

    def document(self) -> list[dict[str, Plain]]:
        """The layout as plain values, as stored in a policy's file."""
        return [
            {
                "name": entry.name,
                "width": entry.width(self.robot),
                "unit": entry.unit_of(self.robot),
                "scale": self._plain(entry.scale),
                "low": -float(self._numbers(entry.bound)),
                "high": float(self._numbers(entry.bound)),
            }
            for entry in self.fields
        ]
