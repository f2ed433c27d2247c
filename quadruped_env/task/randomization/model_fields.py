"""Randomized fields of MuJoCo's model."""

import functools
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import ClassVar, Final, Literal, get_args

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation import Simulation
from quadruped_env.task.randomization.randomization import Apply, Event, Randomization, ends_of
from quadruped_env.utils.arrays import EnvIds, Floats
from quadruped_env.utils.fields import Range, check, one_of

Mode = Literal["set", "scale", "divide", "add"]

_DELAY: Final = "actuator_delay"
_POSITIVE: Final = ("body_mass", "body_inertia")
_NOT_NEGATIVE: Final = ("geom_friction", "dof_damping", "dof_frictionloss", "dof_armature", _DELAY)
_DC_MOTOR: Final = int(mujoco.mjtGain.mjGAIN_DCMOTOR)


@dataclass(frozen=True)
class ModelField:
    """Randomizes a field of the MuJoCo model, with one value per env.

    Several randomizations of one field apply at the start of an episode in their declared order, each to the result of
    the one before; within an episode one applies to the value of the model file. If the field is a mass, the inertia is
    scaled in proportion, as for a body of the same size.

    Args:
        field: field of `MjModel`, such as `geom_friction` or `body_mass`.
        names: names of the bodies, geoms, joints or other elements to change, or a function of the robot that returns
            them; None selects all. The elements of `dof_` fields are named by their joints.
        column: index along the second axis of the field; None selects all.
        mode: `set` replaces the value of the model file, `scale` multiplies it, `divide` divides it, `add` is added to
            it.
    """

    field: str
    names: Sequence[str] | Callable[[Robot], Sequence[str]] | None = None
    column: int | None = None
    mode: Mode = "scale"

    def __post_init__(self) -> None:
        one_of(self.mode, get_args(Mode), f"ModelField({self.field!r}): mode")

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """Look the names up in a model, for `width` values per env.

        Raises:
            QuadrupedError: if the model has no such field or element, or `width` is neither 1, nor the number of
                elements, nor the number of columns of a single element.
        """
        before = self._values(simulation)
        ids = self.ids(simulation)
        columns = before.shape[1] if before.ndim > 1 and self.column is None else 1
        fits = width in (1, len(ids)) or (len(ids) == 1 and width == columns)
        check(fits, f"ModelField({self.field!r}): width", width, f"1, for one value for all, or {len(ids)}")
        for name in (self.field, *(["body_inertia"] if self.field == "body_mass" else [])):
            simulation.model_field(name)
        return functools.partial(self._write, simulation, ids, len(ids) == 1 and width == columns > 1)

    def _write(self, simulation: Simulation, ids: EnvIds, by_column: bool, event: Event, values: Floats) -> None:
        """Write values (R, 1), (R, E) for E elements, or with `by_column` (R, C) for the columns of one element."""
        rows: tuple[NDArray[np.intp] | int, ...] = (event.env_ids[:, None], ids[None, :])
        target = simulation.model_field(self.field)
        where = rows if self.column is None else (*rows, self.column)
        compiled = simulation.compiled_field(self.field)[ids]
        model_file = compiled if self.column is None else compiled[..., self.column]
        old = target[where] if event.at_start else model_file[None]
        shaped = values[:, None] if by_column else values.reshape(*values.shape, *([1] * (old.ndim - 2)))
        target[where] = new = self.changed(old, shaped)
        if self.field == "body_mass":
            inertia = simulation.model_field("body_inertia")
            base = inertia[rows] if event.at_start else simulation.compiled_field("body_inertia")[ids]
            # A body without mass, such as the world, has no inertia either.
            factor = np.divide(new, old, out=np.ones_like(new), where=old > 0.0)
            inertia[rows] = factor[..., None] * base

    def _values(self, simulation: Simulation) -> Floats:
        """Return the values of the compiled model."""
        array = isinstance(getattr(simulation.model, self.field, None), np.ndarray)
        check(array, "ModelField", self.field, "an array of MuJoCo's model; see the docs of MjModel")
        return simulation.compiled_field(self.field)

    def ids(self, simulation: Simulation) -> NDArray[np.intp]:
        """Return the indices of the elements."""
        model, kind = simulation.model, self.field.partition("_")[0]
        names = self.names(simulation.robot) if callable(self.names) else self.names
        try:
            if names is None:
                return np.arange(len(getattr(model, self.field)))
            if kind == "dof":
                return np.concatenate([np.arange(model.nv)[model.jnt_dofadr[model.joint(n).id], None] for n in names])
            return np.array([getattr(model, kind)(name).id for name in names], dtype=np.intp)
        except (AttributeError, KeyError) as error:
            raise QuadrupedError(f"ModelField({self.field!r}): {error}") from error

    def changed(self, old: Floats, value: Floats | float) -> Floats:
        """Return new values (..., shape of the element) for old ones and a value that broadcasts to them."""
        if self.mode == "set":
            return value + 0.0 * old
        if self.mode == "add":
            return value + old
        return old / value if self.mode == "divide" else value * old


@dataclass(frozen=True)
class MotorField(ModelField):
    """A `ModelField` of the motors that means what it says only for MuJoCo's `dcmotor`."""

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """See `ModelField.bind`; also raises a QuadrupedError if a motor of the robot is of another type."""
        if (simulation.model.actuator_gaintype != _DC_MOTOR).any():
            raise QuadrupedError(
                f"the motors of the robot {simulation.robot.name!r} are not all MuJoCo's dcmotor; set the "
                f"randomization to null"
            )
        return super().bind(simulation, width)


@dataclass(frozen=True)
class Payload:
    """A mass on the base, of the base's shape and at the event's `payload_position`.

    A negative mass is missing in the base as a whole, so its position does not count: the base stays physical.
    """

    mass: ClassVar[ModelField] = ModelField("body_mass", lambda robot: (robot.base_name,), mode="add")
    """Field that holds the mass."""

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """Return the function for a simulation."""
        for name in ("body_mass", "body_inertia", "body_ipos", "body_iquat"):
            simulation.model_field(name)
        return functools.partial(self._add, simulation, simulation.model.body(simulation.robot.base_name).id)

    def _add(self, simulation: Simulation, base: int, event: Event, values: Floats) -> None:
        """Add masses (R, 1) in kg."""
        masses, inertias, centres, axes = (
            simulation.model_field(name) for name in ("body_mass", "body_inertia", "body_ipos", "body_iquat")
        )
        where = (event.env_ids, base)
        old, added = masses[where], values[:, 0]
        masses[where] = new = added + old
        inertias[where] = (new / old)[:, None] * inertias[where]
        offsets = event.payload_position
        off_centre = np.flatnonzero(np.any(offsets != 0.0, axis=-1) & (added > 0.0))
        if len(off_centre):
            at = event.env_ids[off_centre], base
            shift, inertias[at], axes[at] = _joined(
                old[off_centre], added[off_centre], offsets[off_centre], inertias[at], axes[at]
            )
            centres[at] += shift


def _joined(
    mass: Floats, added: Floats, offset: Floats, inertia: Floats, axes: Floats
) -> tuple[Floats, Floats, Floats]:
    """Join bodies (R,) with payloads; return shifts of the centre of mass, moments of inertia and their axes.

    Two bodies about their common centre of mass: parallel axis theorem with the reduced mass. `offset` (R, 3) is from
    the body's centre of mass to the payload's; `inertia` (R, 3) is of both as if at one point, about the `axes` (R, 4).
    """
    total = added + mass
    turn, moments, turned = np.empty((len(mass), 3, 3)), np.empty((len(mass), 3)), np.empty((len(mass), 4))
    for matrix, quaternion in zip(turn.reshape(-1, 9), axes, strict=True):
        mujoco.mju_quat2Mat(matrix, quaternion)
    # Neither `@` nor `np.linalg`: their results depend on the processor, by rounding.
    tensor = np.einsum("rij,rj,rkj->rik", turn, inertia, turn)
    squared = (offset**2).sum(axis=-1)[:, None, None] * np.eye(3)
    tensor += (mass * added / total)[:, None, None] * (squared - offset[:, :, None] * offset[:, None, :])
    principal = np.empty(9)
    for moment, quaternion, matrix in zip(moments, turned, tensor.reshape(-1, 9), strict=True):
        mujoco.mju_eig3(moment, principal, quaternion, matrix)
    return (added / total)[:, None] * offset, moments, turned


def longest_delay(delay: float, active: Iterable[tuple[Randomization, Range | float]]) -> float:
    """Return the longest delay that randomizations with their settings allow for motors with a delay, s."""
    delays = [delay]
    for randomization, setting in active:
        for part in randomization.parts:
            if isinstance(part, ModelField) and part.field == _DELAY:
                delays += [float(part.changed(np.array(delays[-1]), end)) for end in ends_of(setting)]
    return max(delays)


def check_physical(active: Iterable[tuple[Randomization, Range | float]], simulation: Simulation) -> None:
    """Check that ranges leave masses, inertia, friction, damping and delays possible, also at their worst together.

    Raises:
        QuadrupedError: naming the randomization, its range, what it would lead to, and what is possible.
    """
    bounds: dict[str, tuple[Floats, Floats]] = {}
    fields = [(entry, setting, part) for entry, setting in active for part in entry.parts]
    for randomization, setting, part in fields:
        entry, ends = part.mass if isinstance(part, Payload) else part, ends_of(setting)
        if not isinstance(entry, ModelField):
            continue
        compiled = simulation.compiled_field(entry.field)
        low, high = bounds.setdefault(entry.field, (compiled.copy(), compiled.copy()))
        ids = entry.ids(simulation)
        rows = ids if entry.column is None else (ids, entry.column)
        candidates = [entry.changed(values[rows], end) for values in (low, high) for end in ends]
        low[rows], high[rows] = np.minimum.reduce(candidates), np.maximum.reduce(candidates)
        # A body without mass, as the world is, stays so.
        changed = low[rows] != compiled[rows]
        problem = _problem(entry.field, low[rows][changed], high[rows], simulation.model)
        if problem:
            unit = "" if randomization.unit == "1" else f" {randomization.unit}"
            raise QuadrupedError(f"randomization.{randomization.name}: {short(list(ends))}{unit} {problem}")


def _problem(field: str, low: Floats, high: Floats, model: mujoco.MjModel) -> str:
    """Return the problem of the lowest and highest values of a field, with its fix; empty if there is none."""
    least = float(low.min(initial=np.inf))
    if field in _POSITIVE and least <= 0.0:
        return f"makes {field} {least:.3g}, which must be positive: raise the lower end"
    if field in _NOT_NEGATIVE and least < 0.0:
        return f"makes {field} {least:.3g}, which must be 0 or more: raise the lower end"
    # The delay that the buffers of the motors hold.
    samples = int(model.actuator_history[:, 0].min()) if model.nu else 0
    longest = max(samples - 1, 0) * float(model.opt.timestep)
    if field == _DELAY and high.max() > longest + 1e-9:
        return (
            f"makes the delay of the motors {high.max():.3g} s, and the model's buffer holds {longest:.3g} s: lower "
            f"the upper end, or build the model with TaskConfig.compiled_model()"
        )
    return ""
