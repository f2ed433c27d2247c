"""Runs the suite: from a controller to its results."""

import time
from collections.abc import Callable, Mapping
from typing import Any, Final

import numpy as np

from quadruped_env.evaluation.results import SECOND_ENGINE, ZERO_ACTION
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.changing import run_joystick, run_pushes, run_transients
from quadruped_env.evaluation.suite.steady import run_command_map, run_gait, run_regulation, run_terrain
from quadruped_env.evaluation.suite.suite_definition import Suite, for_robot, full_suite, with_velocities
from quadruped_env.simulation.height_field import GROUND
from quadruped_env.utils.progress import Progress, part_of

_Run = Callable[[Any, Candidate, Progress | None], dict[str, Any]]
PARTS: Final[dict[str, _Run]] = {
    "commands": run_command_map,
    "joystick": run_joystick,
    "gait": run_gait,
    "transients": run_transients,
    "pushes": run_pushes,
    "regulation": run_regulation,
    "terrain": run_terrain,
}
"""Component -> function that runs the part. The component is the mean of the `contributions` of its result."""
_COSTS: Final = {
    "commands": 6,
    "joystick": 8,
    "gait": 1,
    "transients": 2,
    "pushes": 2,
    "regulation": 8,
    "terrain": 10,
}
"""Component -> time that the full suite takes for it, in some unit."""


def run_suite(
    candidate: Candidate,
    suite: Suite | None = None,
    progress: Progress | None = None,
    zero_action: bool = False,
) -> dict[str, Any]:
    """Measure a controller with the suite; None: the full one.

    Args:
        candidate: the controller, in its task.
        suite: definition of the suite, which is measured in the units of the controller's robot, and with lateral
            velocities if that moves sideways.
        progress: called with the fraction done.
        zero_action: also measure the zero action in the controller's task.

    Returns:
        Results as plain values: `suite` (name, version and hash), `seed`, `conditions` (robot and physics),
        `definition`, `score`, one entry per part, and with `zero_action` the same of the zero action.

    Raises:
        QuadrupedError: if the controller cannot run in the task.
    """
    suite = with_velocities(suite or full_suite(), candidate.robot)
    share = 0.6 if zero_action else 1.0
    result = _results(candidate, suite, part_of(progress, 0.0, share))
    result |= {"definition": for_robot(suite, candidate.robot).to_dict(), SECOND_ENGINE: None}
    if zero_action:
        result[ZERO_ACTION] = _results(candidate.zero_action(), suite, part_of(progress, share, 1.0))
    return result


def _results(candidate: Candidate, suite: Suite, progress: Progress | None) -> dict[str, Any]:
    own, total, done, began = for_robot(suite, candidate.robot), sum(_COSTS.values()), 0, time.perf_counter()
    parts: dict[str, Any] = {}
    for name, run in PARTS.items():
        part = part_of(progress, done / total, (done + _COSTS[name]) / total)
        parts[name] = run(getattr(own, name), candidate, part)
        done += _COSTS[name]
    if progress is not None:
        progress(1.0)
    return {
        "suite": suite.identity,
        "seed": suite.seed,
        "conditions": _physics(candidate),
        "name": candidate.name,
        "seconds": round(time.perf_counter() - began, 1),
        "score": scores(parts),
        **parts,
    }


def _physics(candidate: Candidate) -> dict[str, Any]:
    """Return the robot and physics of a controller's task, which must be the same in results that are compared."""
    config = candidate.task([(0.0, 0.0)])
    model = config.compiled_model()
    option = model.opt
    return {
        "robot": config.robot.identity,
        "physics_timestep": config.physics_timestep,
        "cone": int(option.cone),
        "impratio": float(option.impratio),
        "integrator": int(option.integrator),
        "solver": int(option.solver),
        "noslip_iterations": int(option.noslip_iterations),
        "friction": model.geom(GROUND).friction.tolist(),
    }


def scores(parts: Mapping[str, Any]) -> dict[str, Any]:
    """Return the score in [0, 1]: `total`, the mean of the components, and `components`."""
    components = {name: float(np.mean(part["contributions"])) for name, part in parts.items()}
    return {"total": sum(components.values()) / len(components), "components": components}
