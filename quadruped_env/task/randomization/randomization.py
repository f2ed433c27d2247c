"""Randomizations: quantities that are drawn at the start of an episode, or at intervals within it."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, Final, Literal, Protocol, Self, get_args

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, steadiness
from quadruped_env.simulation import Simulation
from quadruped_env.task.randomization.sensor_errors import Quantity, Sensors
from quadruped_env.task.randomization.servo_errors import ServoErrors
from quadruped_env.utils.arrays import EnvIds, Floats
from quadruped_env.utils.fields import Amplitude, Range, Section, check, converted, one_of
from quadruped_env.utils.parameters import Parameter

Law = Literal["uniform", "log_uniform", "direction"]
Width = int | Literal["joints", "feet", "links"]

_PLANE: Final = 2
"""Number of components of a horizontal vector."""


@dataclass(slots=True)
class Event:
    """Envs to which a randomization is applied, at the start of their episodes or within them."""

    simulation: Simulation
    robot: Robot
    env_ids: EnvIds
    """Indices of the envs (R,)."""
    qpos: Floats
    """Initial base pose and joint positions in MuJoCo's order, (R, 7 + J); empty within an episode."""
    qvel: Floats
    """Initial base and joint velocities in MuJoCo's order, (R, 6 + J)."""
    tilt: Floats
    """Initial roll, pitch and heading of the base (R, 3), rad."""
    sensors: Sensors | None = None
    """Errors of the sensors; None if no randomization of the task sets any."""
    servos: ServoErrors | None = None
    """Errors of the servos; None if the motors have none and no randomization sets any."""
    payload_position: Floats = field(default_factory=lambda: np.zeros((1, 3)))
    """Position of the payload relative to the centre of mass of the base, in its frame, (R, 3) or (1, 3), m."""

    @property
    def at_start(self) -> bool:
        """True at the start of an episode."""
        return self.qpos.size > 0


Apply = Callable[[Event, Floats], None]
"""Function that applies the values (R, width) of a randomization."""


class Bindable(Protocol):
    """Description of what a randomization changes; a simulation turns it into a function."""

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """Return the function for a simulation and `width` values per env.

        Raises:
            QuadrupedError: if the model lacks what it changes, or cannot take that many values.
        """
        ...


@dataclass(frozen=True)
class SensorError:
    """Randomizes an error of the sensors, which the policy observes and rewards do not: see `Sensors`.

    Args:
        quantity: `encoder_offset` in rad, one value per joint or one for all; `imu_mounting`, roll, pitch and yaw in
            rad; or `latency` of the readings in s.
    """

    quantity: Quantity

    def __post_init__(self) -> None:
        one_of(self.quantity, get_args(Quantity), "SensorError: quantity")

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """Return the itself; raise a QuadrupedError if the quantity cannot take `width` values."""
        joints = simulation.robot.num_joints
        valid = {"encoder_offset": (1, joints), "imu_mounting": (3,), "latency": (1,)}[self.quantity]
        check(width in valid, f"SensorError({self.quantity!r}): width", width, " or ".join(map(str, valid)))
        return self

    def __call__(self, event: Event, values: Floats) -> None:
        """Set the quantity in the envs of an event."""
        assert event.sensors is not None
        getattr(event.sensors, self.quantity)[event.env_ids] = values


@dataclass(frozen=True)
class Randomization:
    """A quantity that is drawn at every reset, or at intervals within an episode."""

    name: str
    """Name of the randomization, and of its field in `config["randomization"]`."""
    apply: Apply | Bindable | tuple[Bindable, ...]
    """Function (event, values (R, width)); or a `ModelField`, several that receive the same values, or a
    `SensorError`."""
    default: Amplitude
    """Range to draw from; a number x stands for (-x, x), and None or 0 disables the randomization."""
    unit: str = "1"
    width: Width = 1
    """Number of values per env."""
    law: Law = "uniform"
    """Distribution: `uniform`, `log_uniform` (both ends positive), or `direction`: the two values are a horizontal
    vector, whose length is uniform in the range and its direction in the circle."""
    valid: Parameter = field(default_factory=Parameter)
    """Constraint on both ends of the range."""
    interval: tuple[str, Range] | None = None
    """For a randomization that repeats within an episode: the config's field for the interval in s, and its default."""
    duration: tuple[str, Range] | None = None
    """For one that lasts: the config's field for the duration in s, and its default. At its end, zeros are applied."""
    description: str = ""
    """Meaning of the values, for the docs."""
    source: str = ""
    """Reason or reference for the built-in ranges."""
    tips: bool = False
    """True for what tips a robot over: its ranges for the built-in robot follow another one's `steadiness`, too."""

    def __post_init__(self) -> None:
        what = f"randomization {self.name}"
        one_of(self.law, get_args(Law), f"{what}: law")
        if self.law == "log_uniform" and not self.valid.low > 0.0:
            object.__setattr__(self, "valid", replace(self.valid, low=0.0, exclusive=True))
        if self.law == "direction" and not self.valid.low >= 0.0:
            object.__setattr__(self, "valid", replace(self.valid, low=0.0))
        check(isinstance(self.width, str) or self.width >= 1, f"{what}: width", self.width, "1 or more")
        plane = f"{_PLANE} for the law direction, which draws a horizontal vector"
        check(self.law != "direction" or self.width == _PLANE, f"{what}: width", self.width, plane)
        if self.duration is not None and self.interval is None:
            raise QuadrupedError(f"{what}: a duration needs an interval, after which the next one begins; found none")
        kind = Amplitude if self.law == "uniform" else Range | None
        object.__setattr__(self, "default", converted(self.default, Annotated[kind, self.valid], f"{what}: default"))

    @property
    def parts(self) -> tuple[Apply | Bindable, ...]:
        """Functions and descriptions that receive the same values."""
        return self.apply if isinstance(self.apply, tuple) else (self.apply,)

    def scale(self, robot: Robot) -> float:
        """Return the factor on a range for the built-in robot that suits another one."""
        return scale_of(self.unit, robot) * (steadiness(robot) if self.tips else 1.0)

    def columns(self, robot: Robot) -> int:
        """Return the number of values, and of uniform draws, per env."""
        numbers = {"joints": robot.num_joints, "feet": robot.num_legs, "links": len(robot.link_names)}
        return numbers[self.width] if isinstance(self.width, str) else self.width

    def values(self, draws: Floats, setting: Range | float) -> Floats:
        """Return the values (R, width) for uniform draws (R, width) in [0, 1)."""
        low, high = ends_of(setting)
        if self.law == "uniform":
            return between((low, high), draws)
        if self.law == "log_uniform":
            return np.exp(between((math.log(low), math.log(high)), draws))
        length, angle = between((low, high), draws[:, 0]), math.tau * draws[:, 1]
        return np.stack([length * np.cos(angle), length * np.sin(angle)], axis=-1)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class NoiseAmplitude(Section, path="config.randomization.noise_amplitude"):
    """Amplitude of the noise on each observation, by its name, in its unit."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class RandomizationSection(Section, path="config.randomization"):
    """Settings of the randomizations: ranges, intervals and durations are fields of the names that these have."""

    observation_noise: Annotated[float, Parameter(low=0.0)] = 0.0
    """Factor on the noise of the observations."""
    noise_amplitude: Mapping[str, float]

    def active(self, randomizations: Iterable[Randomization]) -> list[tuple[Randomization, Range | float]]:
        """Return the randomizations that are enabled, with their settings."""
        return [(entry, self[entry.name]) for entry in randomizations if is_active(self[entry.name])]


def is_active(setting: Amplitude) -> bool:
    """Return True if a setting enables its randomization."""
    return setting is not None and setting not in (0.0, (0.0, 0.0))


def ends_of(setting: Range | float) -> Range:
    """Return the range of a setting, in which a number x stands for (-x, x)."""
    return setting if isinstance(setting, tuple) else (-setting, setting)


def between(bounds: Range, draw: Floats) -> Floats:
    """Return uniform draws in [0, 1), scaled to [low, high)."""
    low, high = bounds
    return low + (high - low) * draw


def in_steps(seconds: Floats, timestep: float) -> NDArray[np.int64]:
    """Return the times in s as numbers of control steps, at least one."""
    return np.maximum(np.rint(seconds / timestep), 1.0).astype(np.int64)


@dataclass(frozen=True, slots=True)
class Active:
    """A randomization that its setting enables, in a simulation."""

    randomization: Randomization
    functions: tuple[Apply, ...]
    """Functions that apply it, which receive the same values."""
    setting: Range | float

    @classmethod
    def of(cls, randomization: Randomization, setting: Range | float, simulation: Simulation) -> Self:
        """Bind a randomization with a setting to a simulation.

        Raises:
            QuadrupedError: if the model lacks what it changes, or cannot take that many values.
        """
        width = randomization.columns(simulation.robot)
        try:
            functions: list[Any] = [
                part.bind(simulation, width) if hasattr(part, "bind") else part for part in randomization.parts
            ]
        except QuadrupedError as error:
            raise QuadrupedError(f"randomization {randomization.name}: {error}") from error
        return cls(randomization, tuple(functions), setting)

    @property
    def name(self) -> str:
        """Name of the randomization."""
        return self.randomization.name

    def draw(self, event: Event, draws: Floats) -> None:
        """Apply the values for uniform draws (R, width) in [0, 1)."""
        self.apply(event, self.randomization.values(draws, self.setting))

    def apply(self, event: Event, values: Floats) -> None:
        """Apply values (R, width)."""
        for function in self.functions:
            function(event, values)
