"""The suite on a page: its file of results, its tables and figures, and the ranking of several policies."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.measures import OF_FEET
from quadruped_env.evaluation.results import (
    COMPONENTS,
    RESULTS_FILE,
    aggregate,
    check_comparable,
    ranked,
    read_references,
    read_results,
    references_for,
    with_zero_action,
)
from quadruped_env.report.pages.page import figure, provenance, without_nan
from quadruped_env.report.plots import suite_plots as plots
from quadruped_env.utils.files import write_json

_GAIT_ROWS: Final[dict[str, tuple[str, float, int, str]]] = {
    "clearance": ("Clearance of the lowest foot", 1000.0, 1, "mm"),
    "swings_per_stride": ("Swings per stride, most", 1.0, 2, ""),
    "bounces_per_stride": ("Bounces per stride, worst foot", 1.0, 2, ""),
    "landing_speed": ("Landing speed, worst foot", 1.0, 2, "m/s"),
    "slip": ("Slip, worst foot", 1.0, 3, "m/s"),
    "duty_factor": ("Duty factor, mean", 1.0, 2, ""),
    "stride_frequency": ("Stride frequency", 1.0, 2, "Hz"),
    "peak_force": ("Peak force on a foot", 1.0, 1, "body weights"),
    "joint_limit_share": ("Time at a joint limit", 100.0, 1, "%"),
    "speed_limit_share": ("Time at a speed limit", 100.0, 1, "%"),
    "torque_rate": ("Change of torque", 1.0, 0, "N m/s"),
    "roll": ("Roll", 57.29578, 1, "°"),
    "pitch": ("Pitch", 57.29578, 1, "°"),
    "electrical_power": ("Electrical power", 1.0, 1, "W"),
    "electrical_cost_of_transport": ("Electrical cost of transport", 1.0, 2, ""),
}
"""Measure of the gait -> label, factor, digits and unit in the table."""


def summary(result: Mapping[str, Any]) -> dict[str, Any]:
    """The part of a result that is stored in metrics.json: suite, conditions and score."""
    return {**result["suite"], "conditions": result["conditions"], "score": result["score"], "file": RESULTS_FILE}


def write_results(evaluated: EvaluatedPolicy, result: Mapping[str, Any], command_line: str) -> Path:
    """Write a policy's results of the suite into the policy's output directory."""
    path = evaluated.output / RESULTS_FILE
    policy = {"name": evaluated.name, "card": without_nan(evaluated.policy.card)}
    write_json(path, {**provenance(command_line), "policy": policy, **result})
    return path


def results_of(evaluated: EvaluatedPolicy) -> dict[str, Any]:
    """A policy's results of the suite, from the default directory of its evaluation.

    Raises:
        QuadrupedError: if there are no results, or they are those of another policy.
    """
    path = evaluated.evaluation / RESULTS_FILE
    fix = f"evaluate it first: mini-quadruped evaluate {evaluated.source} --suite"
    if not path.is_file():
        raise QuadrupedError(f"{path}: there are no results of the suite for {evaluated.name}; {fix}")
    result = read_results(path)
    if result.get("policy", {}).get("card") != without_nan(evaluated.policy.card):
        raise QuadrupedError(f"{path}: holds the results of another policy than {evaluated.name}; {fix}")
    return result


def section(result: Mapping[str, Any]) -> dict[str, Any]:
    """Template variables of the suite's sections in the report of one policy."""
    rows = *with_zero_action(result), *references_for(result, read_references())
    compared = ranked([(row["name"], row) for row in rows])
    return {
        "label": _label(result),
        "quick": result["suite"]["quick"],
        "sha256": result["suite"]["sha256"],
        "meaning": COMPONENTS,
        "scores": score_rows(compared),
        "components": list(COMPONENTS),
        "own": result["name"],
        "figures": _figures(result),
        "gait": _gait_table(result),
        "transients": _transients(result),
        "joystick": [
            {
                "label": name,
                "cells": [
                    f"{law['robot_hours']:.2f}",
                    interval(law["falls_per_hour"], 1),
                    *("-" if error is None else f"{error:.3f}" for error in law["mean_error"]),
                    percent(law["windows_met"]),
                ],
            }
            for name, law in result["joystick"].items()
        ],
        "envelope": _envelope(result),
        "regulation": _regulation(result),
    }


def ranking(policies: Mapping[str, EvaluatedPolicy]) -> dict[str, Any]:
    """Ranking of several policies on the suite, as plain values: `suite`, `policies` (the best first) and `recipes`.

    A recipe is the aggregate of a group of runs that differ in their training seed only.

    Raises:
        QuadrupedError: if a policy has no results, or they cannot be compared.
    """
    results = {name: results_of(evaluated) for name, evaluated in policies.items()}
    check_comparable(results)
    groups: dict[str, list[str]] = {}
    for name, evaluated in policies.items():
        groups.setdefault(evaluated.recipe, []).append(name)
    rows = [
        (name if row is result else row["name"], row)
        for name, result in results.items()
        for row in with_zero_action(result)
    ]
    order = ranked(rows)
    return {
        "suite": order[0][1]["suite"],
        "policies": [{"name": name, **row["score"]} for name, row in order],
        "recipes": [
            aggregate([{**results[name], "name": name} for name in names])
            for names in groups.values()
            if len(names) > 1
        ],
    }


def ranking_in_words(found: Mapping[str, Any]) -> str:
    """A sentence that names the policies in the order of their scores."""
    suite = found["suite"]
    order = ", ".join(f"{entry['name']} {entry['total']:.3f}" for entry in found["policies"])
    quick = " (quick)" if suite["quick"] else ""
    return f"Score in {suite['name']} {suite['version']}{quick}, the best first: {order}."


def score_rows(entries: Sequence[tuple[str, Mapping[str, Any]]]) -> list[dict[str, Any]]:
    """Rows of a table of scores: label, total and components as text."""
    return [
        {
            "label": name,
            "cells": [
                f"{entry['score']['total']:.3f}",
                *(f"{entry['score']['components'][component]:.2f}" for component in COMPONENTS),
            ],
        }
        for name, entry in entries
    ]


def percent(share: Mapping[str, Any]) -> str:
    """A share with its interval as text."""
    mean, low, high = (100.0 * share[end] for end in ("mean", "low", "high"))
    return f"{mean:z.0f} % [{low:z.0f}, {high:z.0f}]"


def _label(result: Mapping[str, Any]) -> str:
    suite = result["suite"]
    return f"{suite['name']} {suite['version']}{' (quick)' if suite['quick'] else ''}"


def interval(entry: Mapping[str, Any], digits: int, factor: float = 1.0) -> str:
    """A mean with its interval as text; a dash for what is not known."""
    if entry["mean"] is None:
        return "-"
    mean, low, high = (f"{factor * entry[end]:z.{digits}f}" for end in ("mean", "low", "high"))
    return f"{mean} [{low}, {high}]"


def _gait_table(result: Mapping[str, Any]) -> dict[str, Any]:
    rows = []
    for name, (label, factor, digits, unit) in _GAIT_ROWS.items():
        cells = []
        for entry in result["gait"]["commands"]:
            value = entry[name]
            if name in OF_FEET:
                value = None if None in value else float(OF_FEET[name](np.array(value)))
            cells.append("-" if value is None else f"{factor * value:z.{digits}f}")
        rows.append({"label": label, "unit": unit, "cells": cells})
    commands = (entry["command"] for entry in result["gait"]["commands"])
    return {"commands": [f"{v:g} m/s, {w:g} rad/s" for v, w in commands], "rows": rows}


def _transients(result: Mapping[str, Any]) -> list[dict[str, Any]]:
    return [
        {
            "label": name.replace("_", " "),
            "note": " to ".join(f"{v:g} m/s, {w:g} rad/s" for v, w in (entry["first"], entry["then"])),
            "cells": [
                percent(entry["followed"]),
                interval(entry["settling_time"], 2),
            ],
        }
        for name, entry in result["transients"].items()
    ]


def _envelope(result: Mapping[str, Any]) -> str:
    units = {"forwards": "m/s", "backwards": "m/s", "left": "rad/s", "right": "rad/s"}
    return ", ".join(f"{name} {result['commands']['envelope'][name]:g} {unit}" for name, unit in units.items())


def _regulation(result: Mapping[str, Any]) -> dict[str, Any]:
    """Table of the signed share of each commanded velocity that is kept, by factor and command."""
    entries = result["regulation"]
    commands = [entry["command"] for entry in next(iter(entries.values()))["commands"]]
    rows = []
    for name, entry in entries.items():
        shares = [
            " / ".join("-" if share is None else f"{100.0 * share:.0f}" for share, wanted in pairs if wanted)
            for pairs in (zip(one["share"], one["command"], strict=True) for one in entry["commands"])
        ]
        cells = [percent(entry["kept"]), percent(entry["falls"]), *shares]
        rows.append({"label": name.replace("_", " "), "cells": cells})
    return {"commands": [f"{v:g} m/s, {w:g} rad/s" for v, w in commands], "rows": rows}


def _figures(result: Mapping[str, Any]) -> dict[str, dict[str, str]]:
    met = percent(result["commands"]["met"])
    return {
        "commands": figure(
            "Every command",
            plots.command_map(result),
            f"Achieved minus commanded velocity at commands drawn over the rectangle: red too much, blue too little. "
            f"Crosses mark commands with falls. {met} of the episodes meet their command.",
        ),
        "pushes": figure(
            "Pushes",
            plots.pushes(result),
            "Share of the robots that follow their command after a push of all six components, by its size.",
        ),
        "terrain": figure(
            "Terrain",
            plots.crossings(result),
            "Share of the tiles that the robot crosses, up to the first level that it does not pass. The dashed line "
            "is what passes a level.",
        ),
    }
