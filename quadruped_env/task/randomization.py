"""What differs from episode to episode, and within one: a list of `Randomization`s, the built-in ones at the end."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, Final, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.config import Range
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation import Simulation
from quadruped_env.task.terms import Parameter

Floats = NDArray[np.float64]
Law = Literal["uniform", "log_uniform", "normal"]


@dataclass(slots=True)
class Event:
    """Some envs (R,) at the start of their episodes, or in the middle of one: what a randomization may change."""

    simulation: Simulation
    robot: Robot
    env_ids: NDArray[np.intp]
    """(R,)"""
    qpos: Floats
    """The start: base pose and joint positions as MuJoCo has them, (R, 7 + J); empty within an episode"""
    qvel: Floats
    """(R, 6 + J)"""
    tilt: Floats
    """Roll, pitch and heading of the base at the start, rad (R, 3)"""


class Apply(Protocol):
    """Carries out a randomization."""

    def __call__(self, event: Event, values: Floats) -> None:
        """Apply values (R, width)."""
        ...


@dataclass(frozen=True)
class Randomization:
    """One quantity that is drawn anew, at every reset or at intervals within an episode."""

    name: str
    """Also its field in `config["randomization"]`"""
    apply: "Apply | ModelField"
    """(event, values (R, width)); or a `ModelField`"""
    default: Range | float | None
    """The range to draw from: a number stands for -number to number; None or 0 draws nothing"""
    unit: str = "1"
    width: int | Literal["joints", "feet"] = 1
    """Numbers per env"""
    law: Law = "uniform"
    """`uniform`; `log_uniform`; or `normal`, around the middle of the range with a quarter of its width as standard
    deviation, clipped to it"""
    valid: Parameter = field(default_factory=Parameter)
    """What a range may hold"""
    interval: tuple[str, Range] | None = None
    """For one that comes again within an episode: the config's field for the seconds between, and its default"""

    def columns(self, robot: Robot) -> int:
        """Numbers per env."""
        if self.width == "joints":
            return robot.num_joints
        return robot.num_legs if self.width == "feet" else self.width

    def draws(self, robot: Robot) -> int:
        """Uniform numbers per env."""
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
    """Whether a setting of a randomization draws anything."""
    return setting is not None and setting not in (0.0, (0.0, 0.0))


def between(bounds: Range, draw: Floats) -> Floats:
    """Uniform draws in [0, 1) stretched to [low, high)."""
    low, high = bounds
    return low + (high - low) * draw


@dataclass(frozen=True)
class ModelField:
    """Changes a field of each env's own MuJoCo model.

    A mass is changed together with its inertia, in proportion, as for a body of the same size.

    Args:
        field: of `MjModel`, such as `geom_friction` or `body_mass`.
        names: bodies, geoms, joints or whatever the field has rows for; None takes all.
        column: of a field with columns; None takes all.
        mode: `set`, or `scale` or `add` to what the model file says.
    """

    field: str
    names: Sequence[str] | None = None
    column: int | None = None
    mode: Literal["set", "scale", "add"] = "scale"

    def bind(self, simulation: Simulation) -> Apply:
        """Look the names up in a model.

        Raises:
            QuadrupedError: if the field or a name is not the model's.
        """
        model = simulation.model
        kind = self.field.partition("_")[0]
        if not isinstance(getattr(model, self.field, None), np.ndarray):
            raise QuadrupedError(f"ModelField: {self.field!r} is no array of MuJoCo's model; see the docs of MjModel")
        before = getattr(model, self.field).copy()
        try:
            rows: Any = slice(None) if self.names is None else [getattr(model, kind)(name).id for name in self.names]
        except (AttributeError, KeyError) as error:
            raise QuadrupedError(f"ModelField({self.field!r}): {error}") from error
        ids = np.arange(len(before))[rows]
        return _BoundField(self, simulation, ids, before, model.body_inertia.copy())


@dataclass(frozen=True, eq=False)
class _BoundField:
    """A `ModelField` in a simulation."""

    model_field: ModelField
    simulation: Simulation
    ids: NDArray[np.intp]
    before: Floats
    """What the model file says"""
    inertia: Floats

    def __call__(self, event: Event, values: Floats) -> None:
        """Write values (R, 1), or (R, rows) for one per row."""
        field, simulation = self.model_field, self.simulation
        column = field.column if self.before.ndim > 1 else None
        where: tuple[Any, ...] = (event.env_ids[:, None], self.ids[None, :])
        old = self.before[self.ids] if column is None else self.before[self.ids, column]
        shaped = values.reshape(*values.shape, *([1] * (old.ndim - 1)))
        new = {"set": shaped + 0.0 * old, "scale": shaped * old, "add": shaped + old}[field.mode]
        simulation.model_field(field.field)[where if column is None else (*where, column)] = new
        if field.field == "body_mass":
            simulation.model_field("body_inertia")[where] = (new / old)[..., None] * self.inertia[self.ids]


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


def _push(event: Event, values: Floats) -> None:
    velocity = np.zeros((len(values), 3))
    velocity[:, :2] = values
    event.simulation.push(event.env_ids, velocity)


RANDOMIZATIONS: Final[tuple[Randomization, ...]] = (
    Randomization("start_joint_position", _joint_position, 0.1, "rad", "joints"),
    Randomization("start_joint_velocity", _joint_velocity, 0.5, "rad/s", "joints"),
    Randomization("start_base_velocity", _base_velocity, 0.2, "m/s, rad/s", 6),
    Randomization("start_tilt", _tilt, 0.05, "rad", 2),
    Randomization("start_heading", _heading, math.pi, "rad"),
    # A contact takes the larger friction of its two geoms, so that all are set.
    Randomization("friction", ModelField("geom_friction", column=0, mode="set"), None, valid=Parameter.positive()),
    Randomization(
        "payload",
        ModelField("body_mass", ("base_link",), mode="add"),
        None,
        "kg",
        valid=Parameter("kg", -1.0, exclusive=True),
    ),
    Randomization("push_velocity", _push, 0.0, "m/s", 2, interval=("push_interval", (4.0, 8.0))),
)
"""Start offsets around the stance at rest, friction of foot and ground, mass on the base, and pushes."""


def bound(randomization: Randomization, simulation: Simulation) -> Callable[[Event, Floats], None]:
    """What carries a randomization out in a simulation."""
    apply = randomization.apply
    return apply.bind(simulation) if isinstance(apply, ModelField) else apply
