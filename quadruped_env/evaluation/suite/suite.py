"""The suite from a controller to its results, the files of results, and the check that two can be compared."""

import os
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.evaluation.suite import (
    command_map,
    gait,
    joystick,
    pushes,
    regulation,
    terrains,
    transients,
)
from quadruped_env.evaluation.suite.measured_controller import (
    MeasuredController,
    conditions,
    share_with_standing,
)
from quadruped_env.evaluation.suite.suite_definition import Suite, for_robot, full_suite
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.progress import Progress, part_of
from quadruped_env.utils.text_table import text_table

RESULTS_FILE: Final = "suite.json"
REFERENCE_FILE: Final = Path(__file__).with_name("references.json")
"""Written by `tools/suite_references.py`; a package without it has no reference rows."""

COMPONENTS: Final = {
    "commands": "share of the commands drawn over the rectangle that are met; less a fifth if it never stands still",
    "joystick": "share of 5 s of changing commands without a fall and with small errors",
    "gait": "clearance, soft landings, no bounces and little slip, where the command is followed",
    "transients": "1 - settling time / 5 s after steps of the command",
    "pushes": "share of the pushes after which it does what was asked; less a fifth if it never stands still",
    "regulation": "share of the episodes that keep their speed: one disturbance at a time, and all together",
    "terrain": "highest level over 10, mean over the kinds",
}
"""Component of the score, which is a part of the suite -> meaning."""


def _moving_and_standing(result: Mapping[str, Any], part: Any) -> float:
    return share_with_standing(result["moving"]["mean"], result["standing"]["mean"])


_Run = Callable[[Any, MeasuredController, Progress | None], dict[str, Any]]
_Score = Callable[[Any, Any], float]
PARTS: Final[dict[str, tuple[_Run, _Score]]] = {
    "commands": (command_map.run, _moving_and_standing),
    "joystick": (joystick.run, lambda result, part: joystick.score(result)),
    "gait": (gait.run, gait.score),
    "transients": (transients.run, lambda result, part: _mean(change["score"] for change in result.values())),
    "pushes": (pushes.run, _moving_and_standing),
    "regulation": (regulation.run, regulation.score),
    "terrain": (terrains.run, terrains.score),
}
"""Component -> function that runs the part, and the component in [0, 1] of its result."""
ZERO_ACTION: Final = "zero_action"
"""Field of a policy's results that holds those of the zero action in its task."""
_AGAIN: Final = "evaluate the policy with --suite"
_TERRAIN_COST: Final = 1.6
"""Time of an episode on tiles relative to that on a plane."""


def episode_seconds(suite: Suite) -> dict[str, float]:
    """Simulated seconds of each part, summed over its episodes: name -> s. On tiles, an upper bound."""
    s = suite
    commands = len(s.commands.drawn) + sum(map(len, s.commands.axes.values()))
    scored = len(s.pushes.commands) * len(s.pushes.sizes) * s.pushes.num_seeds
    alone = len(s.regulation.factors) * s.regulation.num_seeds * s.regulation.seconds
    together = s.regulation.together_seeds * s.regulation.together_seconds
    crossings = len(s.terrain.kinds) * s.terrain.levels * len(s.terrain.terrain_seeds) * s.terrain.num_seeds
    return {
        "commands": commands * s.commands.num_seeds * s.commands.seconds,
        "joystick": len(s.joystick.laws) * s.joystick.num_seeds * s.joystick.seconds,
        "gait": len(s.gait.commands) * s.gait.num_seeds * s.gait.seconds,
        "transients": len(s.transients.changes) * s.transients.num_seeds * (s.transients.before + s.transients.after),
        "pushes": scored * (s.pushes.before[1] + s.pushes.after),
        "regulation": len(s.regulation.commands) * (alone + together),
        "terrain": crossings * s.terrain.seconds,
    }


def run_suite(
    measured: MeasuredController,
    suite: Suite | None = None,
    progress: Progress | None = None,
    zero_action: bool = False,
) -> dict[str, Any]:
    """Measure a controller with the suite; None: the full one.

    Args:
        measured: the controller, in its task.
        suite: definition of the suite, which is measured in the units of the controller's robot.
        progress: called with the fraction done.
        zero_action: also measure the zero action in the controller's task.

    Returns:
        Results as plain values: `suite` (name, version and hash), `conditions` (robot and physics), `definition`,
        `score`, one entry per part, and with `zero_action` the same of the zero action.

    Raises:
        QuadrupedError: if the controller cannot run in the task.
    """
    suite = suite or full_suite()
    share = 0.6 if zero_action else 1.0
    result = _results(measured, suite, part_of(progress, 0.0, share))
    result["definition"] = for_robot(suite, measured.robot).to_dict()
    if zero_action:
        result[ZERO_ACTION] = _results(measured.zero_action(), suite, part_of(progress, share, 1.0))
    return result


def _results(measured: MeasuredController, suite: Suite, progress: Progress | None) -> dict[str, Any]:
    own, weights = for_robot(suite, measured.robot), episode_seconds(suite)
    weights["terrain"] *= _TERRAIN_COST
    total, done, began = sum(weights.values()), 0.0, time.perf_counter()
    parts: dict[str, Any] = {}
    for name, (run, _) in PARTS.items():
        part = part_of(progress, done / total, (done + weights[name]) / total)
        parts[name] = run(getattr(own, name), measured, part)
        done += weights[name]
    if progress is not None:
        progress(1.0)
    return {
        "suite": suite.identity,
        "conditions": conditions(measured),
        "name": measured.name,
        "seconds": round(time.perf_counter() - began, 1),
        "score": scores(own, parts),
        **parts,
    }


def with_zero_action(result: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Results, and those of the zero action that they hold, as rows of a table."""
    return [result, result[ZERO_ACTION]] if ZERO_ACTION in result else [result]


def scores(suite: Suite, parts: Mapping[str, Any]) -> dict[str, Any]:
    """Score in [0, 1]: `total`, the mean of the components, and `components`."""
    components = {name: score(parts[name], getattr(suite, name)) for name, (_, score) in PARTS.items()}
    return {"total": sum(components.values()) / len(components), "components": components}


def _mean(values: Iterable[float]) -> float:
    return float(np.mean(list(values)))


def read_results(path: Path) -> dict[str, Any]:
    """Results of the suite from a file, with all parts; a QuadrupedError if it cannot be read or lacks one."""
    document: dict[str, Any] = read_json(path, _AGAIN)
    check_results(document, str(path), PARTS)
    return document


def check_results(document: Any, where: str, parts: Iterable[str] = ()) -> None:
    """Raise a QuadrupedError, which names `where`, if a document does not hold the score of the suite, or a part."""
    if not isinstance(document, dict):
        raise QuadrupedError(f"{where}: expected a table; found {short(document)}; {_AGAIN}")
    for name in ("suite", "conditions", "name", "score", *parts):
        if name not in document:
            raise QuadrupedError(f"{where}: {name} is missing; {_AGAIN}")
    components = document["score"].get("components") if isinstance(document["score"], dict) else None
    if not isinstance(components, dict) or not components.keys() >= COMPONENTS.keys():
        raise QuadrupedError(f"{where}: score lacks a component of {', '.join(COMPONENTS)}; {_AGAIN}")


def check_comparable(documents: Mapping[str, Mapping[str, Any]]) -> None:
    """Raise a QuadrupedError if results (by name) differ in suite, version, definition, robot or physics."""
    (one, a), *others = documents.items()
    same_version = "evaluate both with the same version of the package"
    fixes = {
        **dict.fromkeys(("suite.name", "suite.version"), same_version),
        "suite.quick": "a quick result is never comparable with a full one; evaluate without --quick",
        "suite.sha256": f"the definitions of the suite differ; {same_version}",
    }
    for other, b in others:
        for field in sorted({*a["conditions"], *b["conditions"]}):
            fixes[f"conditions.{field}"] = f"{same_version}, and on the same robot"
        for name, fix in fixes.items():
            section, field = name.split(".")
            x, y = a[section].get(field), b[section].get(field)
            if x != y:
                raise QuadrupedError(
                    f"{one} and {other} cannot be compared: {name} is {short(x)} in one and {short(y)} in the other; "
                    f"{fix}"
                )
        if a.get("terrain", {}).keys() != b.get("terrain", {}).keys():
            raise QuadrupedError(f"{one} and {other} cannot be compared: their terrains differ; evaluate both again")


def ranked(documents: Iterable[tuple[str, Mapping[str, Any]]]) -> list[tuple[str, Mapping[str, Any]]]:
    """Results by their score, the best first; equal scores keep their order."""
    return sorted(documents, key=lambda entry: -entry[1]["score"]["total"])


def read_references(path: Path = REFERENCE_FILE) -> list[dict[str, Any]]:
    """All reference rows; none if the file does not exist, a QuadrupedError if it is damaged."""
    if not os.path.lexists(path):
        return []
    fix = "write it again with tools/suite_references.py"
    document = read_json(path, fix)
    rows = document.get("rows") if isinstance(document, dict) else None
    if not isinstance(rows, list):
        raise QuadrupedError(f"{path}: expected a list 'rows'; found {short(rows)}; {fix}")
    for i, row in enumerate(rows):
        check_results(row, f"{path.name}: row {i + 1}")
    return rows


def references_for(result: Mapping[str, Any], rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Reference rows that may be compared with a result: the same suite, robot and physics."""
    return [row for row in rows if row["suite"] == result["suite"] and row["conditions"] == result["conditions"]]


def score_table(results: list[Mapping[str, Any]]) -> str:
    """Scores and their components of several results as plain text, in the given order."""
    scores = (result["score"] for result in results)
    numbers = [[f"{score['total']:.3f}", *(f"{score['components'][c]:.2f}" for c in COMPONENTS)] for score in scores]
    rows = [[result["name"], *cells] for result, cells in zip(results, numbers, strict=True)]
    return text_table([["", "score", *COMPONENTS], *rows])
