"""Randomization of initial states, model parameters and pushes; the built-in randomizations are at the end."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final, Literal, Protocol, get_args

import numpy as np
from numpy.typing import NDArray

from quadruped_env._plain import is_finite_number
from quadruped_env.control.config import Range
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.parameters import Parameter
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation import Simulation

Floats = NDArray[np.float64]
Law = Literal["uniform", "log_uniform", "normal"]
Mode = Literal["set", "scale", "add"]


def _check_choice(what: str, value: object, choices: tuple[str, ...]) -> None:
    if value not in choices:
        raise QuadrupedError(f"{what} must be one of {', '.join(choices)}; found {short(value)}")


@dataclass(slots=True)
class Event:
    """Envs to which a randomization is applied, at the start of their episodes or within them."""

    simulation: Simulation
    robot: Robot
    env_ids: NDArray[np.intp]
    """Indices of the envs (R,)."""
    qpos: Floats
    """Initial base pose and joint positions in MuJoCo's order, (R, 7 + J); empty within an episode."""
    qvel: Floats
    """Initial base and joint velocities in MuJoCo's order, (R, 6 + J)."""
    tilt: Floats
    """Initial roll, pitch and heading of the base (R, 3), rad."""


class Apply(Protocol):
    """Function that applies a randomization."""

    def __call__(self, event: Event, values: Floats) -> None:
        """Apply values (R, width)."""
        ...


@dataclass(frozen=True)
class Randomization:
    """A quantity that is drawn at every reset, or at intervals within an episode."""

    name: str
    """Name of the randomization, and of its field in `config["randomization"]`."""
    apply: "Apply | ModelField"
    """Function (event, values (R, width)), or a `ModelField`."""
    default: Range | float | None
    """Range to draw from; a number x stands for (-x, x), and None or 0 disables the randomization."""
    unit: str = "1"
    width: int | Literal["joints", "feet"] = 1
    """Number of values per env."""
    law: Law = "uniform"
    """Distribution: `uniform`, `log_uniform` (both ends positive) or `normal`. The normal one has its mean at the
    middle of the range and a quarter of the width as standard deviation, and is clipped to the range."""
    valid: Parameter = field(default_factory=Parameter)
    """Constraint on both ends of the range."""
    interval: tuple[str, Range] | None = None
    """For a randomization that repeats within an episode: the config's field for the interval in s, and its default."""

    def __post_init__(self) -> None:
        _check_choice(f"randomization {self.name}: law", self.law, get_args(Law))
        if self.law == "log_uniform" and not self.valid.low > 0.0:
            object.__setattr__(self, "valid", replace(self.valid, low=0.0, exclusive=True))
        if isinstance(self.width, int) and self.width < 1:
            raise QuadrupedError(f"randomization {self.name}: width must be 1 or more; found {self.width}")
        setting = self.default
        if setting is None:
            return
        if not isinstance(setting, (tuple, list)):
            # An amplitude x stands for (-x, x).
            valid = is_finite_number(setting) and setting >= 0 and self.law != "log_uniform"
            rule = "a pair of positive numbers" if self.law == "log_uniform" else "0 or more, or a pair (low, high)"
        else:
            valid = (
                len(setting) == 2
                and all(is_finite_number(end) and self.valid.accepts(end) for end in setting)
                and setting[0] <= setting[1]
            )
            rule = f"None, or a pair (low, high) with low <= high, each {self.valid.rule()}"
        if not valid:
            raise QuadrupedError(f"randomization {self.name}: default must be {rule}; found {short(setting)}")

    def columns(self, robot: Robot) -> int:
        """Number of values per env."""
        if self.width == "joints":
            return robot.num_joints
        return robot.num_legs if self.width == "feet" else self.width

    def draws(self, robot: Robot) -> int:
        """Number of uniform draws per env."""
        return self.columns(robot) * (2 if self.law == "normal" else 1)

    def values(self, draws: Floats, setting: Range | float) -> Floats:
        """Values (R, width) for uniform draws (R, draws) in [0, 1)."""
        low, high = setting if isinstance(setting, tuple) else (-setting, setting)
        if self.law == "uniform":
            return between((low, high), draws)
        if self.law == "log_uniform":
            return np.exp(between((math.log(low), math.log(high)), draws))
        # Box and Muller 1958, https://doi.org/10.1214/aoms/1177706645
        first, second = np.split(draws, 2, axis=1)
        normal = np.sqrt(-2.0 * np.log1p(-first)) * np.cos(math.tau * second)
        return np.clip(0.5 * (low + high) + 0.25 * (high - low) * normal, low, high)


def is_active(setting: Range | float | None) -> bool:
    """True if a setting enables its randomization."""
    return setting is not None and setting not in (0.0, (0.0, 0.0))


def between(bounds: Range, draw: Floats) -> Floats:
    """Uniform draws in [0, 1), scaled to [low, high)."""
    low, high = bounds
    return low + (high - low) * draw


@dataclass(frozen=True)
class ModelField:
    """Randomizes a field of the MuJoCo model, with one value per env.

    If the field is a mass, the inertia is scaled in proportion, as for a body of the same size.

    Args:
        field: field of `MjModel`, such as `geom_friction` or `body_mass`.
        names: names of the bodies, geoms, joints or other elements to change, or a function of the robot that returns
            them; None selects all.
        column: index along the second axis of the field; None selects all.
        mode: `set` replaces the value of the model file, `scale` multiplies it, `add` is added to it.
    """

    field: str
    names: Sequence[str] | Callable[[Robot], Sequence[str]] | None = None
    column: int | None = None
    mode: Mode = "scale"

    def __post_init__(self) -> None:
        _check_choice(f"ModelField({self.field!r}): mode", self.mode, get_args(Mode))

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """Look the names up in a model, for `width` values per env.

        Raises:
            QuadrupedError: if the model has no such field or element, or `width` is neither 1 nor the number of
                elements.
        """
        model = simulation.model
        kind = self.field.partition("_")[0]
        if not isinstance(getattr(model, self.field, None), np.ndarray):
            raise QuadrupedError(
                f"ModelField: {self.field!r} is not an array of MuJoCo's model; see the docs of MjModel"
            )
        before = getattr(model, self.field).copy()
        names = self.names(simulation.robot) if callable(self.names) else self.names
        try:
            rows: Any = slice(None) if names is None else [getattr(model, kind)(name).id for name in names]
        except (AttributeError, KeyError) as error:
            raise QuadrupedError(f"ModelField({self.field!r}): {error}") from error
        ids = np.arange(len(before))[rows]
        if width not in (1, len(ids)):
            raise QuadrupedError(
                f"ModelField({self.field!r}): {width} values for {len(ids)} elements; width must be 1, for one value "
                f"for all, or {len(ids)}"
            )
        return _BoundField(self, simulation, ids, before, model.body_inertia.copy())


@dataclass(frozen=True, eq=False)
class _BoundField:
    """A `ModelField` of a simulation."""

    model_field: ModelField
    simulation: Simulation
    ids: NDArray[np.intp]
    before: Floats
    """Values of the model file."""
    inertia: Floats

    def __call__(self, event: Event, values: Floats) -> None:
        """Write values (R, 1), or (R, E) for E elements."""
        field, simulation = self.model_field, self.simulation
        column = field.column if self.before.ndim > 1 else None
        where: tuple[Any, ...] = (event.env_ids[:, None], self.ids[None, :])
        old = self.before[self.ids] if column is None else self.before[self.ids, column]
        shaped = values.reshape(*values.shape, *([1] * (old.ndim - 1)))
        new = {"set": shaped + 0.0 * old, "scale": shaped * old, "add": shaped + old}[field.mode]
        simulation.model_field(field.field)[where if column is None else (*where, column)] = new
        if field.field == "body_mass":
            # A body without mass, such as the world, has no inertia either.
            share = np.divide(new, old, out=np.ones_like(new), where=old > 0.0)
            simulation.model_field("body_inertia")[where] = share[..., None] * self.inertia[self.ids]


def _joint_position(event: Event, values: Floats) -> None:
    event.qpos[:, 7:] += values


def _joint_velocity(event: Event, values: Floats) -> None:
    event.qvel[:, 6:] += values


def _base_velocity(event: Event, values: Floats) -> None:
    event.qvel[:, :6] += values


def _tilt(event: Event, values: Floats) -> None:
    event.tilt[:, :2] += values


def _heading(event: Event, values: Floats) -> None:
    event.tilt[:, 2:] += values


def _base(robot: Robot) -> tuple[str]:
    return (robot.base_name,)


def _push(event: Event, values: Floats) -> None:
    velocity = np.zeros((len(values), 3))
    velocity[:, :2] = values
    event.simulation.push(event.env_ids, velocity)


_STARTS: Final = (
    Randomization("start_joint_position", _joint_position, 0.1, "rad", "joints"),
    Randomization("start_joint_velocity", _joint_velocity, 0.5, "rad/s", "joints"),
    Randomization("start_base_velocity", _base_velocity, 0.2, "m/s, rad/s", 6),
    Randomization("start_tilt", _tilt, 0.05, "rad", 2),
    Randomization("start_heading", _heading, math.pi, "rad"),
)
RANDOM_START: Final[Mapping[str, Any]] = {entry.name: entry.default for entry in _STARTS}
"""Settings of the built-in randomizations of the start: offsets from the stance at rest, and the heading."""

RANDOMIZATIONS: Final[tuple[Randomization, ...]] = (
    *_STARTS,
    # MuJoCo uses the larger friction of the two geoms in contact, so all geoms are set.
    Randomization("friction", ModelField("geom_friction", column=0, mode="set"), None, valid=Parameter.positive()),
    Randomization(
        "payload",
        ModelField("body_mass", _base, mode="add"),
        None,
        "kg",
        valid=Parameter("kg", -1.0, exclusive=True),
    ),
    Randomization("push_velocity", _push, 0.0, "m/s", 2, interval=("push_interval", (4.0, 8.0))),
)
"""Built-in randomizations: of the start, friction, payload on the base, and pushes."""


def bound(randomization: Randomization, simulation: Simulation) -> Callable[[Event, Floats], None]:
    """Function that applies a randomization in a simulation."""
    apply = randomization.apply
    if not isinstance(apply, ModelField):
        return apply
    try:
        return apply.bind(simulation, randomization.columns(simulation.robot))
    except QuadrupedError as error:
        raise QuadrupedError(f"randomization {randomization.name}: {error}") from error
