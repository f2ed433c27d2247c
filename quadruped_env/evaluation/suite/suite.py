"""Runs the suite: from a controller to its results."""

import time
from collections.abc import Callable, Mapping
from typing import Any, Final

import numpy as np

from quadruped_env.evaluation.results import ZERO_ACTION
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.changing import run_joystick, run_pushes, run_transients
from quadruped_env.evaluation.suite.steady import (
    gait_score,
    regulation_score,
    run_command_map,
    run_gait,
    run_regulation,
    run_terrain,
)
from quadruped_env.evaluation.suite.suite_definition import (
    Suite,
    TerrainPart,
    for_robot,
    full_suite,
    with_velocities,
)
from quadruped_env.simulation.height_field import GROUND
from quadruped_env.utils.progress import Progress, part_of

_STANDING_WEIGHT: Final = 0.2
"""Share of a score that is lost by a robot that does not stand still."""


def moving_and_standing(result: Mapping[str, Any], part: object) -> float:
    """Score in [0, 1] the shares of commands to move and to stand that are met.

    Standing alone earns nothing; a robot that moves as commanded, and never stands still, loses a fifth.
    """
    return float(result["moving"]["mean"] * (1.0 - _STANDING_WEIGHT * (1.0 - result["standing"]["mean"])))


def _joystick_score(result: Mapping[str, Any], part: object) -> float:
    return float(np.mean([law["windows_met"]["mean"] for law in result.values()]))


def _transients_score(result: Mapping[str, Any], part: object) -> float:
    return float(np.mean([change["score"] for change in result.values()]))


def _terrain_score(result: Mapping[str, Any], part: TerrainPart) -> float:
    return float(np.mean([kind["highest_level"] for kind in result.values()])) / part.levels


_Run = Callable[[Any, Candidate, Progress | None], dict[str, Any]]
_Score = Callable[[Any, Any], float]
PARTS: Final[dict[str, tuple[_Run, _Score]]] = {
    "commands": (run_command_map, moving_and_standing),
    "joystick": (run_joystick, _joystick_score),
    "gait": (run_gait, gait_score),
    "transients": (run_transients, _transients_score),
    "pushes": (run_pushes, moving_and_standing),
    "regulation": (run_regulation, regulation_score),
    "terrain": (run_terrain, _terrain_score),
}
"""Component -> function that runs the part, and the component in [0, 1] of its result."""
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
        Results as plain values: `suite` (name, version and hash), `conditions` (robot and physics), `definition`,
        `score`, one entry per part, and with `zero_action` the same of the zero action.

    Raises:
        QuadrupedError: if the controller cannot run in the task.
    """
    suite = with_velocities(suite or full_suite(), candidate.robot)
    share = 0.6 if zero_action else 1.0
    result = _results(candidate, suite, part_of(progress, 0.0, share))
    result["definition"] = for_robot(suite, candidate.robot).to_dict()
    if zero_action:
        result[ZERO_ACTION] = _results(candidate.zero_action(), suite, part_of(progress, share, 1.0))
    return result


def _results(candidate: Candidate, suite: Suite, progress: Progress | None) -> dict[str, Any]:
    own, total, done, began = for_robot(suite, candidate.robot), sum(_COSTS.values()), 0, time.perf_counter()
    parts: dict[str, Any] = {}
    for name, (run, _) in PARTS.items():
        part = part_of(progress, done / total, (done + _COSTS[name]) / total)
        parts[name] = run(getattr(own, name), candidate, part)
        done += _COSTS[name]
    if progress is not None:
        progress(1.0)
    return {
        "suite": suite.identity,
        "conditions": _physics(candidate),
        "name": candidate.name,
        "seconds": round(time.perf_counter() - began, 1),
        "score": scores(own, parts),
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


def scores(suite: Suite, parts: Mapping[str, Any]) -> dict[str, Any]:
    """Return the score in [0, 1]: `total`, the mean of the components, and `components`."""
    components = {name: score(parts[name], getattr(suite, name)) for name, (_, score) in PARTS.items()}
    return {"total": sum(components.values()) / len(components), "components": components}
