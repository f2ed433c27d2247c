"""The suite on a page: its file of results, its tables and figures, and the ranking of several policies."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.control.control_config import VELOCITIES
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.measures import METRICS, OF_FEET
from quadruped_env.evaluation.results import (
    ACCURACY,
    COMPONENTS,
    RESULTS_FILE,
    SECOND_ENGINE,
    aggregate,
    check_comparable,
    paired_differences,
    ranked,
    read_references,
    read_results,
    references_for,
    with_zero_action,
)
from quadruped_env.evaluation.verdict import listed
from quadruped_env.report.pages.page import figure, provenance, without_nan
from quadruped_env.report.plots import suite_plots as plots
from quadruped_env.utils.files import write_json
from quadruped_env.utils.text_table import Table

_SCORES: Final = ("", "score", *COMPONENTS)
"""Titles of the columns of a table of scores."""


def summary(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return the part of a result that is stored in metrics.json: suite, conditions and score."""
    return {**result["suite"], "conditions": result["conditions"], "score": result["score"], "file": RESULTS_FILE}


def write_results(evaluated: EvaluatedPolicy, result: Mapping[str, Any], command_line: str) -> Path:
    """Write a policy's results of the suite into the policy's output directory."""
    path = evaluated.output / RESULTS_FILE
    policy = {"name": evaluated.name, "card": without_nan(evaluated.policy.card)}
    write_json(path, {**provenance(command_line), "policy": policy, **result})
    return path


def stored_results(evaluated: EvaluatedPolicy, identity: Mapping[str, Any] | None = None) -> dict[str, Any] | None:
    """Return a policy's results of a suite with this identity, from the default directory of its evaluation.

    Without an identity, of any suite. None if there are none, or they belong to another suite or another policy.

    Raises:
        QuadrupedError: if the file is damaged.
    """
    path = evaluated.evaluation / RESULTS_FILE
    if not path.is_file():
        return None
    result = read_results(path)
    own = result.get("policy", {}).get("card") == without_nan(evaluated.policy.card)
    return result if own and identity in (None, result["suite"]) else None


def ranking(policies: Mapping[str, EvaluatedPolicy], results: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Return the ranking of several policies by their results, as plain values.

    `suite` and `seed`, `policies` (the best first; each with its paired difference to the best one), and `recipes`: the
    aggregates of runs that differ in their training seed only.

    Raises:
        QuadrupedError: if the results cannot be compared.
    """
    check_comparable(results)
    groups: dict[str, list[str]] = {}
    for name, evaluated in policies.items():
        groups.setdefault(evaluated.recipe, []).append(name)
    order = ranked(
        (name if row is result else row["name"], row)
        for name, result in results.items()
        for row in with_zero_action(result)
    )
    return {
        **{field: order[0][1][field] for field in ("suite", "seed")},
        "policies": [
            {"name": name, **row["score"], "difference": paired_differences(row, order[0][1]) if i else None}
            for i, (name, row) in enumerate(order)
        ],
        "recipes": [
            aggregate([{**results[name], "name": name} for name in names])
            for names in groups.values()
            if len(names) > 1
        ],
    }


def ranking_in_words(found: Mapping[str, Any]) -> str:
    """Return a sentence that names the policies in the order of their scores, and what each one is behind the best."""
    order = ", ".join(f"{entry['name']} {entry['total']:.3f}{_behind(entry, ' ({})')}" for entry in found["policies"])
    return f"Score in {_label(found)} with the seed {found['seed']}, the best first: {order}."


def _behind(entry: Mapping[str, Any], form: str) -> str:
    """Return the difference to the best policy with its interval; nothing for the best, or without pairs."""
    return form.format(interval(entry["difference"]["score"], 3)) if entry["difference"] else ""


def ranking_table(found: Mapping[str, Any]) -> Table:
    """Return the scores of a ranking, with a row for the mean of each recipe."""
    rows = [[*_scores(entry["name"], entry), _behind(entry, "{}")] for entry in found["policies"]]
    for recipe in found["recipes"]:
        names = listed([run["name"] for run in recipe["runs"]])
        parts = (interval(recipe["components"][name], 2) for name in COMPONENTS)
        label = f"{len(recipe['runs'])} training seeds of one recipe ({names}): mean"
        rows.append([label, interval(recipe["score"], 3), *parts, ""])
    note = f"{ranking_in_words(found)} All ran the same episodes, so differences to the best are over pairs of them"
    return Table("Ranking", (*_SCORES, "to the best"), rows, note)


def section(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return the template variables of the suite's sections in the report of one policy."""
    rows = *with_zero_action(result), *references_for(result, read_references())
    scores = [_scores(name, row["score"]) for name, row in ranked((row["name"], row) for row in rows)]
    return {
        "label": _label(result),
        "quick": result["suite"]["quick"],
        "sha256": result["suite"]["sha256"],
        "seed": result["seed"],
        "accuracy": ACCURACY,
        "meaning": COMPONENTS,
        "scores": Table("", _SCORES, scores),
        "own": result["name"],
        "figures": _figures(result),
        "tables": [
            *(_joystick(result), _gait(result), _feet(result), _transients(result), _regulation(result)),
            *([] if result.get(SECOND_ENGINE) is None else [_second_engine(result[SECOND_ENGINE])]),
        ],
        "second_engine": result.get(SECOND_ENGINE) is not None,
    }


def percent(share: Mapping[str, Any]) -> str:
    """Return a share with its interval as text."""
    mean, low, high = (100.0 * share[end] for end in ("mean", "low", "high"))
    return f"{mean:z.0f} % [{low:z.0f}, {high:z.0f}]"


def interval(entry: Mapping[str, Any], digits: int, factor: float = 1.0) -> str:
    """Return a mean with its interval as text, without the interval if there is none; a dash for no mean."""
    known = [f"{factor * entry[end]:z.{digits}f}" for end in ("mean", "low", "high") if entry[end] is not None]
    if len(known) < 3:
        return known[0] if known else "-"
    return f"{known[0]} [{known[1]}, {known[2]}]"


def _label(result: Mapping[str, Any]) -> str:
    suite = result["suite"]
    return f"{suite['name']} {suite['version']}{' (quick)' if suite['quick'] else ''}"


def _scores(name: str, score: Mapping[str, Any]) -> list[str]:
    return [name, f"{score['total']:.3f}", *(f"{score['components'][component]:.2f}" for component in COMPONENTS)]


def _command(command: Sequence[float]) -> str:
    return ", ".join(f"{v:g} {entry.unit}" for v, entry in zip(command, VELOCITIES, strict=False))


def _joystick(result: Mapping[str, Any]) -> Table:
    errors = ("speed error (m/s)", "yaw error (rad/s)", "sideways error (m/s)")
    width = max(len(law["mean_error"]) for law in result["joystick"]["laws"].values())
    head = ("", "robot hours", "falls per hour", *errors[:width], "accuracy (%)")
    rows = [
        [
            name,
            f"{law['robot_hours']:.2f}",
            interval(law["falls_per_hour"], 1),
            *("-" if error is None else f"{error:.3f}" for error in law["mean_error"]),
            interval(law["accuracy"], 0, 100.0),
        ]
        for name, law in result["joystick"]["laws"].items()
    ]
    return Table("Changing commands", head, rows)


def _gait(result: Mapping[str, Any]) -> Table:
    entries = result["gait"]["commands"]
    rows = []
    for name in filter(entries[0].__contains__, METRICS):
        cells = []
        for entry in entries:
            feet = np.array(entry[name], dtype=np.float64)  # NaN where a value is unknown
            cells.append(METRICS[name].show(float(OF_FEET[name](feet) if name in OF_FEET else feet)))
        rows.append([f"{METRICS[name].label}\n{METRICS[name].unit}", *cells])
    return Table("Gait at every speed", ["", *(_command(entry["command"]) for entry in entries)], rows)


def _feet(result: Mapping[str, Any]) -> Table:
    names = ("apex", "touchdowns_per_stride", "landing_speed", "peak_force")
    rows = [
        [
            _command(entry["command"]),
            *(" / ".join(METRICS[name].show(float(np.array(v, float))) for v in entry[name]) for name in names),
        ]
        for entry in result["gait"]["commands"]
    ]
    head = [
        "",
        *(f"{METRICS[name].label} {METRICS[name].unit and f'({METRICS[name].unit})'}".strip() for name in names),
    ]
    return Table("Every foot", head, rows, f"Feet in the order {' / '.join(result['gait']['feet'])}")


def _transients(result: Mapping[str, Any]) -> Table:
    rows = [
        [
            f"{name.replace('_', ' ')}\n{' to '.join(map(_command, (entry['first'], entry['then'])))}",
            percent(entry["followed"]),
            interval(entry["settling_time"], 2),
            " / ".join("-" if error is None else f"{error:.3f}" for error in entry["steady_error"]),
        ]
        for name, entry in result["transients"]["changes"].items()
    ]
    units = " / ".join(entry.unit for entry, _ in zip(VELOCITIES, result["commands"]["commands"][0], strict=False))
    head = ("", "followed", "settling time (s)", f"error at the end ({units})")
    return Table("Changes of the command", head, rows)


def _envelope(result: Mapping[str, Any]) -> str:
    return ", ".join(
        f"{name.replace('_', ' to the ')} {reached:g} {'rad/s' if name in ('left', 'right') else 'm/s'}"
        for name, reached in result["commands"]["envelope"].items()
    )


def _regulation(result: Mapping[str, Any]) -> Table:
    entries = result["regulation"]["disturbances"]
    commands = [entry["command"] for entry in next(iter(entries.values()))["commands"]]
    rows = []
    for name, entry in entries.items():
        shares = [
            " / ".join("-" if share is None else f"{100.0 * share:.0f}" for share, wanted in pairs if wanted)
            for pairs in (zip(one["share"], one["command"], strict=True) for one in entry["commands"])
        ]
        rows.append([name.replace("_", " "), percent(entry["kept"]), percent(entry["falls"]), *shares])
    velocities = listed(["speed", "yaw rate", "lateral velocity"][: len(commands[0])])
    note = (
        f"An episode is kept if {velocities} are within 20 % of the command, with one disturbance, and with all "
        f"of them. The other columns are the shares of the commanded {velocities} that are kept, %."
    )
    return Table("Regulation", ["", "episodes kept", "falls", *map(_command, commands)], rows, note)


def _second_engine(transfer: Mapping[str, Any]) -> Table:
    here, there = (engine["name"] for engine in transfer["engines"])
    rows = [
        [
            _command(entry["command"]),
            *(" / ".join("-" if v is None else f"{v:z.3f}" for v in entry[engine]) for engine in ("here", "there")),
            *(str(entry[f"falls_{engine}"]) for engine in ("here", "there")),
        ]
        for entry in transfer["commands"]
    ]
    changes = ", ".join(
        f"{way} {'-' if change is None else f'{100.0 * change:+z.0f} %'}"
        for way, change in transfer["largest_change"].items()
    )
    note = f"Mean velocities of the policy in both engines. Largest change of a commanded velocity: {changes}"
    return Table(f"In {there}", ["", here, there, f"falls in {here}", f"in {there}"], rows, note)


def _figures(result: Mapping[str, Any]) -> list[dict[str, str]]:
    met, closely = (percent(result["commands"][name]) for name in ("met", "met_closely"))
    return [
        figure(
            "Every command",
            plots.command_map(result),
            f"Achieved minus commanded velocity at commands drawn over the rectangle: red too much, blue too little. "
            f"Crosses mark commands with falls. {met} of the episodes meet their command, {closely} closely. "
            f"Envelope, the largest command in one direction alone up to which all are met: {_envelope(result)}.",
        ),
        figure(
            "Pushes",
            plots.pushes(result),
            "Accuracy after a push of all six components, by its size.",
        ),
        figure(
            "Terrain",
            plots.crossings(result),
            "Share of the tiles that the robot crosses, up to the first level that it does not pass. A level is passed "
            "above the dashed line.",
        ),
    ]
