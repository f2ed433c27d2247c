"""The suite from a controller to its results, the files of results, and the check that two can be compared."""

import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.evaluation.suite import (
    command_map,
    gait_measures,
    pushes,
    recovery,
    suite_disturbances,
    terrains,
    transients,
)
from quadruped_env.evaluation.suite.measured_controller import Contender, conditions
from quadruped_env.evaluation.suite.suite_definition import Suite, full_suite
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.parameters import is_quantity
from quadruped_env.utils.progress import Progress, part_of

RESULTS_FILE: Final = "suite.json"

COMPONENTS: Final = {
    "commands": "share of the episodes on the rectangle of commands that meet their command",
    "gait": "clearance, one touchdown per stride, and joint speeds below their limits",
    "transients": "1 - settling time / 5 s after steps of the command",
    "pushes": "share of the pushes that are survived",
    "disturbances": "share of the episodes that hold their command: one disturbance at a time, and all together",
    "terrain": "highest level over 10, mean over the kinds",
    "recovery": "share of the recoveries from drops and falls",
}
"""Component of the score, which is a part of the suite -> meaning."""

_RUN: Final[dict[str, Callable[[Any, Contender, Progress | None], dict[str, Any]]]] = {
    "commands": command_map.run,
    "gait": gait_measures.run,
    "transients": transients.run,
    "pushes": pushes.run,
    "disturbances": suite_disturbances.run,
    "terrain": terrains.run,
    "recovery": recovery.run,
}
_TERRAIN_COST: Final = 1.6
"""Time of an episode on tiles relative to that on a plane."""
_RECOVERY_COST: Final = 10.0
"""Time of an episode with a live controller relative to that with the task."""


def episode_seconds(suite: Suite) -> dict[str, float]:
    """Simulated seconds of each part, summed over its episodes: name -> s. On tiles, an upper bound."""
    s = suite
    return {
        "commands": len(s.commands.commands) * s.commands.num_seeds * s.commands.seconds,
        "gait": len(s.gait.commands) * s.gait.num_seeds * s.gait.seconds,
        "transients": len(s.transients.changes) * s.transients.num_seeds * (s.transients.before + s.transients.after),
        "pushes": len(s.pushes.sizes)
        * len(s.pushes.directions)
        * s.pushes.num_seeds
        * (s.pushes.before + s.pushes.after),
        "disturbances": len(s.disturbances.commands)
        * (
            (1 + len(s.disturbances.factors)) * s.disturbances.num_seeds * s.disturbances.seconds
            + s.disturbances.together_seeds * s.disturbances.together_seconds
        ),
        "terrain": len(s.terrain.kinds) * s.terrain.levels * s.terrain.num_seeds * s.terrain.seconds,
        "recovery": len(s.recovery.releases) * s.recovery.num_seeds * (s.recovery.limp_seconds + s.recovery.seconds),
    }


def run_suite(contender: Contender, suite: Suite | None = None, progress: Progress | None = None) -> dict[str, Any]:
    """Measure a controller with the suite.

    Args:
        contender: controller and its task.
        suite: the suite; None: the full one.
        progress: called with the fraction done, in proportion to the simulated time.

    Returns:
        Results as plain values: `suite` (name, version and hash), `conditions` (robot and physics), `definition`,
        `score`, and one entry per part.

    Raises:
        QuadrupedError: if the controller cannot run in the task, or observes what a real robot does not measure.
    """
    suite = suite or full_suite()
    weights = episode_seconds(suite)
    weights["terrain"] *= _TERRAIN_COST
    weights["recovery"] *= _RECOVERY_COST
    total, done, began = sum(weights.values()), 0.0, time.perf_counter()
    parts: dict[str, Any] = {}
    for name, part_run in _RUN.items():
        part = part_of(progress, done / total, (done + weights[name]) / total)
        parts[name] = part_run(getattr(suite, name), contender, part)
        done += weights[name]
    if progress is not None:
        progress(1.0)
    return {
        "suite": suite.identity,
        "conditions": conditions(contender),
        "name": contender.name,
        "seconds": round(time.perf_counter() - began, 1),
        "definition": suite.to_dict(),
        "score": scores(suite, parts),
        **parts,
    }


def scores(suite: Suite, parts: Mapping[str, Any]) -> dict[str, Any]:
    """Score and its components, in [0, 1]: `total`, the mean of the components, and `components`."""
    components = {
        "commands": command_map.score(parts["commands"]),
        "gait": gait_measures.score(parts["gait"], suite.gait),
        "transients": transients.score(parts["transients"]),
        "pushes": pushes.score(parts["pushes"]),
        "disturbances": suite_disturbances.score(parts["disturbances"], suite.disturbances),
        "terrain": terrains.score(parts["terrain"], suite.terrain),
        "recovery": recovery.score(parts["recovery"]),
    }
    return {"total": sum(components.values()) / len(components), "components": components}


def read_results(path: Path) -> dict[str, Any]:
    """Results of the suite from a file.

    Raises:
        QuadrupedError: if the file cannot be read or does not hold results of the suite.
    """
    document = read_json(path, "evaluate the policy with --suite to make it")
    check_results(document, str(path))
    missing = [name for name in COMPONENTS if not isinstance(document.get(name), dict)]
    if missing:
        raise QuadrupedError(f"{path}: lacks the part {missing[0]!r} of the suite; evaluate the policy with --suite")
    for kind, entry in document["terrain"].items():
        level = entry.get("highest_level") if isinstance(entry, dict) else None
        if type(level) is not int:
            raise QuadrupedError(
                f"{path}: terrain.{short(kind)[1:-1]}.highest_level: expected a whole number; found {short(level)}; "
                f"evaluate the policy with --suite"
            )
    if not isinstance(document.get("policy", {}), dict):
        raise QuadrupedError(
            f"{path}: policy: expected a table; found {short(document['policy'])}; evaluate the policy with --suite"
        )
    result: dict[str, Any] = document
    return result


def check_results(document: Any, where: str) -> None:
    """Check that a document holds results of the suite; `where` names it in errors.

    Raises:
        QuadrupedError: if it does not.
    """
    try:
        identity = document["suite"]
        known = {name: identity[name] for name in ("name", "version", "quick", "sha256")}
        numbers = [document["score"]["total"], *(document["score"]["components"][name] for name in COMPONENTS)]
        complete = all(map(is_quantity, numbers)) and isinstance(document["name"], str)
        kinds = {"name": str, "version": int, "quick": bool, "sha256": str}
        complete = complete and all(type(known[name]) is kind for name, kind in kinds.items())
        conditions_known = isinstance(document["conditions"]["robot"], dict)
    except (KeyError, TypeError) as error:
        raise QuadrupedError(
            f"{where}: lacks the results of the suite ({short(str(error))}); evaluate the policy with --suite"
        ) from error
    if not complete or not conditions_known:
        raise QuadrupedError(f"{where}: its score is not complete ({short(known)}); evaluate the policy with --suite")


def check_comparable(documents: Mapping[str, Mapping[str, Any]]) -> None:
    """Check that results may be compared: the same suite, version and definition, robot and physics.

    Args:
        documents: name -> results, as `run_suite` returns them.

    Raises:
        QuadrupedError: if two of them differ; the message names both, the field and the fix.
    """
    first, *others = documents.items()
    for name, document in others:
        _check_pair(first[0], first[1], name, document)


def _check_pair(one: str, a: Mapping[str, Any], other: str, b: Mapping[str, Any]) -> None:
    for field in ("name", "version", "quick", "sha256"):
        x, y = a["suite"][field], b["suite"][field]
        if x != y:
            fix = {
                "quick": "a quick result is never comparable with a full one; evaluate without --quick",
                "sha256": "the definitions of the suite differ; evaluate both with the same version of the package",
            }.get(field, "evaluate both with the same version of the package")
            raise QuadrupedError(
                f"{one} and {other} cannot be compared: suite.{field} is {short(x)} in one and {short(y)} in the "
                f"other; {fix}"
            )
    if a.get("terrain", {}).keys() != b.get("terrain", {}).keys():
        raise QuadrupedError(f"{one} and {other} cannot be compared: their terrains differ; evaluate both again")
    for field in sorted({*a["conditions"], *b["conditions"]}):
        x, y = a["conditions"].get(field), b["conditions"].get(field)
        if x != y:
            raise QuadrupedError(
                f"{one} and {other} cannot be compared: conditions.{field} is {short(x)} in one and {short(y)} in the "
                f"other; evaluate both on the same robot and with the same version of the package"
            )


def ranked(documents: Iterable[tuple[str, Mapping[str, Any]]]) -> list[tuple[str, Mapping[str, Any]]]:
    """Results by their score, the best first; equal scores keep their order."""
    return sorted(documents, key=lambda entry: -entry[1]["score"]["total"])
