"""Randomizations: quantities that are drawn at the start of an episode, or at intervals within it."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, Final, Literal, Self, get_args

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation import Simulation
from quadruped_env.task.randomization.event import Apply, Bindable, Event
from quadruped_env.task.randomization.model_fields import ModelField, check_choice
from quadruped_env.task.randomization.sensor_errors import Quantity
from quadruped_env.utils.fields import Amplitude, Range, Section
from quadruped_env.utils.parameters import Parameter, is_quantity

Floats = NDArray[np.float64]
Law = Literal["uniform", "log_uniform", "normal", "direction"]
Width = int | Literal["joints", "feet", "links"]

_PLANE: Final = 2
"""Number of components of a horizontal vector."""


@dataclass(frozen=True)
class SensorError:
    """Randomizes an error of the sensors, which the policy observes and rewards do not: see `Sensors`.

    Args:
        quantity: `encoder_offset` in rad, one value per joint or one for all; `imu_mounting`, roll, pitch and yaw in
            rad; or `latency` of the readings in s.
    """

    quantity: Quantity

    def __post_init__(self) -> None:
        check_choice("SensorError: quantity", self.quantity, get_args(Quantity))

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """Function for a simulation.

        Raises:
            QuadrupedError: if the quantity cannot take `width` values.
        """
        joints = simulation.robot.num_joints
        valid = {"encoder_offset": (1, joints), "imu_mounting": (3,), "latency": (1,)}[self.quantity]
        if width not in valid:
            rule = " or ".join(str(number) for number in valid)
            raise QuadrupedError(f"SensorError({self.quantity!r}): {width} values; width must be {rule}")
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
    apply: Apply | Bindable | tuple[ModelField, ...]
    """Function (event, values (R, width)); or a `ModelField`, several that receive the same values, or a
    `SensorError`."""
    default: Amplitude
    """Range to draw from; a number x stands for (-x, x), and None or 0 disables the randomization."""
    unit: str = "1"
    width: Width = 1
    """Number of values per env."""
    law: Law = "uniform"
    """Distribution: `uniform`, `log_uniform` (both ends positive), `normal`, or `direction`. The normal one has its
    mean at the middle of the range and a quarter of the width as standard deviation, and is clipped to the range. With
    `direction` the two values are a horizontal vector, whose length is uniform in the range and its direction in the
    circle."""
    valid: Parameter = field(default_factory=Parameter)
    """Constraint on both ends of the range."""
    interval: tuple[str, Range] | None = None
    """For a randomization that repeats within an episode: the config's field for the interval in s, and its default."""
    duration: tuple[str, Range] | None = None
    """For one that lasts: the config's field for the duration in s, and its default. At its end, zeros are applied."""
    description: str = ""
    """Meaning of the values, for the docs."""
    source: str = ""
    """Reason or reference for the built-in ranges, in the docs."""

    def __post_init__(self) -> None:
        check_choice(f"randomization {self.name}: law", self.law, get_args(Law))
        if self.law == "log_uniform" and not self.valid.low > 0.0:
            object.__setattr__(self, "valid", replace(self.valid, low=0.0, exclusive=True))
        if self.law == "direction" and not self.valid.low >= 0.0:
            object.__setattr__(self, "valid", replace(self.valid, low=0.0))
        if isinstance(self.width, int) and self.width < 1:
            raise QuadrupedError(f"randomization {self.name}: width must be 1 or more; found {self.width}")
        if self.law == "direction" and self.width != _PLANE:
            raise QuadrupedError(
                f"randomization {self.name}: width must be {_PLANE} for the law direction, which draws a horizontal "
                f"vector; found {short(self.width)}"
            )
        if self.duration is not None and self.interval is None:
            raise QuadrupedError(
                f"randomization {self.name}: a duration needs an interval, after which the next one begins; found none"
            )
        setting = self.default
        if setting is None:
            return
        if not isinstance(setting, (tuple, list)):
            # An amplitude x stands for (-x, x).
            paired = {"log_uniform": "a pair of positive numbers", "direction": "a pair of numbers, 0 or more"}
            valid = is_quantity(setting) and setting >= 0 and self.law not in paired
            rule = paired.get(self.law, "0 or more, or a pair (low, high)")
        else:
            valid = (
                len(setting) == 2
                and all(is_quantity(end) and self.valid.accepts(end) for end in setting)
                and setting[0] <= setting[1]
            )
            rule = f"None, or a pair (low, high) with low <= high, each {self.valid.rule()}"
        if not valid:
            raise QuadrupedError(f"randomization {self.name}: default must be {rule}; found {short(setting)}")

    def columns(self, robot: Robot) -> int:
        """Number of values per env."""
        numbers = {"joints": robot.num_joints, "feet": robot.num_legs, "links": len(robot.link_names)}
        return numbers[self.width] if isinstance(self.width, str) else self.width

    def draws(self, robot: Robot) -> int:
        """Number of uniform draws per env."""
        return self.columns(robot) * (2 if self.law == "normal" else 1)

    def values(self, draws: Floats, setting: Range | float) -> Floats:
        """Values (R, width) for uniform draws (R, draws) in [0, 1)."""
        low, high = ends_of(setting)
        if self.law == "uniform":
            return between((low, high), draws)
        if self.law == "log_uniform":
            return np.exp(between((math.log(low), math.log(high)), draws))
        if self.law == "direction":
            length, angle = between((low, high), draws[:, 0]), math.tau * draws[:, 1]
            return np.stack([length * np.cos(angle), length * np.sin(angle)], axis=-1)
        # Box and Muller 1958, https://doi.org/10.1214/aoms/1177706645
        first, second = np.split(draws, 2, axis=1)
        normal = np.sqrt(-2.0 * np.log1p(-first)) * np.cos(math.tau * second)
        return np.clip(0.5 * (low + high) + 0.25 * (high - low) * normal, low, high)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class NoiseAmplitude(Section, path="config.randomization.noise_amplitude"):
    """Amplitude of the noise on each observation, by its name, in its unit."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class RandomizationSection(Section, path="config.randomization"):
    """Settings of the randomizations: ranges, intervals and durations are fields of the names that these have."""

    observation_noise: Annotated[float, Parameter(low=0.0)] = 0.0
    """Factor on the noise of the observations."""
    noise_amplitude: Mapping[str, float]

    def active(self, randomizations: Iterable[Randomization]) -> list[Randomization]:
        """Those that their settings enable."""
        return [entry for entry in randomizations if is_active(self[entry.name])]

    def longest_delay(self, delay: float, randomizations: Iterable[Randomization]) -> float:
        """Longest delay that these randomizations allow for motors with a delay, s."""
        delays = [delay]
        for entry in self.active(randomizations):
            for part in entry.apply if isinstance(entry.apply, tuple) else (entry.apply,):
                if isinstance(part, ModelField) and part.field == "actuator_delay":
                    delays += [float(part.changed(np.array(delays[-1]), end)) for end in ends_of(self[entry.name])]
        return max(delays)


def is_active(setting: Amplitude) -> bool:
    """True if a setting enables its randomization."""
    return setting is not None and setting not in (0.0, (0.0, 0.0))


def ends_of(setting: Range | float) -> Range:
    """The range of a setting, in which a number x stands for (-x, x)."""
    return setting if isinstance(setting, tuple) else (-setting, setting)


def between(bounds: Range, draw: Floats) -> Floats:
    """Uniform draws in [0, 1), scaled to [low, high)."""
    low, high = bounds
    return low + (high - low) * draw


def in_steps(seconds: Floats, timestep: float) -> NDArray[np.int64]:
    """Times in s as numbers of control steps, at least one."""
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
        """A randomization with a setting, in a simulation.

        Raises:
            QuadrupedError: if the model lacks what it changes, or cannot take that many values.
        """
        apply: Any = randomization.apply
        width = randomization.columns(simulation.robot)
        try:
            functions = [
                part.bind(simulation, width) if hasattr(part, "bind") else part
                for part in (apply if isinstance(apply, tuple) else (apply,))
            ]
        except QuadrupedError as error:
            raise QuadrupedError(f"randomization {randomization.name}: {error}") from error
        return cls(randomization, tuple(functions), setting)

    @property
    def name(self) -> str:
        """Name of the randomization."""
        return self.randomization.name

    def values(self, draws: Floats) -> Floats:
        """Values (R, width) for uniform draws (R, draws) in [0, 1)."""
        return self.randomization.values(draws, self.setting)

    def apply(self, event: Event, values: Floats) -> None:
        """Apply values (R, width)."""
        for function in self.functions:
            function(event, values)
