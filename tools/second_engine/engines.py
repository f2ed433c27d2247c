"""The two engines that a controller is run in: a call makes N simulated robots for a task."""

import importlib.util
import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from importlib import metadata
from typing import Any, ClassVar, Final, Literal, NamedTuple, get_args

import mujoco

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.simulation import BatchSimulation, Simulation
from quadruped_env.task import TaskConfig

Approximation = Literal["sap", "lagged", "similar"]
Cone = Literal["pyramidal", "elliptic"]

_CONES: Final = {"pyramidal": mujoco.mjtCone.mjCONE_PYRAMIDAL, "elliptic": mujoco.mjtCone.mjCONE_ELLIPTIC}


class Contact(NamedTuple):
    """Contact model in Drake: contact between points, on every link and the ground."""

    approximation: Approximation
    """Discrete contact approximation."""
    friction: float
    """Coefficient of static and dynamic friction."""
    relaxation_time: float
    """Time constant of the dissipation with `sap`, s."""


@dataclass(frozen=True)
class MuJoCo:
    """MuJoCo, the engine of this package, with the contact model of the robot's MJCF or another one.

    Another time step is one of the task's config (`physics_timestep`, with `decimation`).
    """

    name: ClassVar[str] = "MuJoCo"

    cone: Cone | None = None
    """Friction cone; None: the model's."""
    impratio: float | None = None
    """Ratio of frictional to normal impedance of contacts; None: the model's."""
    time_constant: float | None = None
    """Time constant of all contacts, s, critically damped; None: the model's."""
    noslip_iterations: int | None = None
    """Iterations of the solver that removes slip after each step; None: the model's."""
    friction: float | None = None
    """Coefficient of sliding friction of all contacts; None: the model's."""

    def __post_init__(self) -> None:
        _check("cone", self.cone, lambda value: value in _CONES, " or ".join(_CONES))
        _check("impratio", self.impratio, lambda value: value > 0.0, "positive")
        _check("time_constant", self.time_constant, lambda value: value > 0.0, "positive (s)")
        _check("noslip_iterations", self.noslip_iterations, lambda value: value >= 0, "0 or more")
        _check("friction", self.friction, lambda value: 0.0 <= value < math.inf, "0 or more")

    def __call__(self, config: TaskConfig, num_envs: int) -> Simulation:
        """Return N robots of a task, on its ground."""
        model = config.compiled_model()
        if self.cone is not None:
            model.opt.cone = _CONES[self.cone]
        if self.impratio is not None:
            model.opt.impratio = self.impratio
        if self.time_constant is not None:
            model.geom_solref[:] = self.time_constant, 1.0
        if self.noslip_iterations is not None:
            model.opt.noslip_iterations = self.noslip_iterations
        if self.friction is not None:
            model.geom_friction[:, 0] = self.friction
        return BatchSimulation(model, num_envs, robot=config.robot)

    def settings(self, config: TaskConfig) -> dict[str, Any]:
        """Return the version, time step and contact model for a task, as plain values."""
        model = config.compiled_model()
        option = model.opt
        return {
            "version": mujoco.__version__,
            "timestep": config.physics_timestep,
            "cone": {number: name for name, number in _CONES.items()}[mujoco.mjtCone(option.cone)],
            "impratio": float(option.impratio),
            "time_constant": float(model.geom("ground").solref[0]),
            "noslip_iterations": int(option.noslip_iterations),
            "friction": friction_of(config),
            **{name: value for name, value in asdict(self).items() if value is not None},
        }


@dataclass(frozen=True)
class Drake:
    """Drake, which builds the robot from its URDF alone.

    Contacts are points with Drake's default stiffness; the ground is a half space.
    """

    name: ClassVar[str] = "Drake"

    approximation: Approximation = "sap"
    """Discrete contact approximation, as named in Drake.

    With `sap` and `similar` a sliding foot glides by tenths of a millimetre above the ground and touches it at some
    steps only; `lagged` limits friction by the normal force of the step before, which is inexact in impacts. Sources:
    Castro et al. 2022, arXiv:2110.10107, and 2023, arXiv:2312.03908.
    """
    max_timestep: float = 0.002
    """Maximum time step, s; a control step has a whole number of steps."""
    friction: float | None = None
    """Coefficient of friction, static and dynamic, of all contacts; None: the feet's in the MJCF."""
    relaxation_time: float = 0.001
    """Time constant of the dissipation with `sap`, s; the other approximations have Drake's default dissipation.

    About critical damping, as in MuJoCo: 2 sqrt(m / k) is 2 ms for a quarter of the built-in robot's mass on Drake's
    default stiffness of 1e6 N/m. Drake's default is 0.1 s.
    """

    def __post_init__(self) -> None:
        known = get_args(Approximation)
        _check("approximation", self.approximation, lambda value: value in known, " or ".join(known))
        _check("max_timestep", self.max_timestep, lambda value: 0.0 < value < math.inf, "positive (s)")
        _check("relaxation_time", self.relaxation_time, lambda value: 0.0 <= value < math.inf, "0 or more (s)")
        _check("friction", self.friction, lambda value: 0.0 <= value < math.inf, "0 or more")

    def __call__(self, config: TaskConfig, num_envs: int) -> Simulation:
        """Return N robots of a task, on level ground.

        Raises:
            QuadrupedError: if Drake is not installed, the task's ground is not level, or the URDF is not the robot's.
        """
        check_drake()
        from second_engine.drake_simulation import DrakeSimulation

        return DrakeSimulation(config, num_envs, self.timestep(config), self._contact(config))

    def timestep(self, config: TaskConfig) -> float:
        """Return the time step for a task, s."""
        # Rounding must not add a step.
        return config.control_timestep / math.ceil(config.control_timestep / self.max_timestep - 1e-9)

    def _contact(self, config: TaskConfig) -> Contact:
        friction = friction_of(config) if self.friction is None else self.friction
        return Contact(self.approximation, friction, self.relaxation_time)

    def settings(self, config: TaskConfig) -> dict[str, Any]:
        """Return the version, time step and contact model for a task, as plain values."""
        check_drake()
        return {
            "version": metadata.version("drake"),
            "timestep": self.timestep(config),
            "contact": "point",
            **self._contact(config)._asdict(),
        }


def check_drake() -> None:
    """Raise a QuadrupedError if Drake is not installed."""
    if importlib.util.find_spec("pydrake") is None:
        raise QuadrupedError(
            "Drake is not installed: pip install -c constraints.txt -r tools/second_engine/requirements.txt"
        )


def friction_of(config: TaskConfig) -> float:
    """Return the sliding friction between feet and ground in a task's model: MuJoCo takes the larger one."""
    model = config.compiled_model()
    feet = {int(model.site_bodyid[model.site(site).id]) for site in config.robot.foot_sites}
    touching = [geom for geom in range(model.ngeom) if model.geom_contype[geom] and model.geom_bodyid[geom] in feet]
    return float(model.geom_friction[[model.geom("ground").id, *touching], 0].max())


def _check(name: str, value: Any, valid: Callable[[Any], bool], rule: str) -> None:
    if value is not None and not valid(value):
        raise QuadrupedError(f"engine: {name} must be {rule}; found {short(value)}")
