"""The report of a sweep: its settings by score, learning curves, parallel coordinates, importance, and the best run."""

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.report.pages.page import figure, provenance, write_html
from quadruped_env.report.pages.suite_section import interval
from quadruped_env.report.plots import sweep_plots as plots
from quadruped_env.report.plots.learning_plots import read_progress
from quadruped_env.report.report_directory import REPORT_FILE, prepare_output
from quadruped_env.training.run_directory import PROGRESS_FILE
from quadruped_env.utils.text_table import Table

SHOWN_TRIALS: Final = 200
"""Trials in the table of a page; results.csv has all."""


def write_sweep_report(folder: Path, results: Mapping[str, Any]) -> Path:
    """Write report.html for the results of a sweep into its directory, and return it; an existing one is replaced.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if a run's progress.csv is damaged, or the report cannot be written.
    """
    prepare_output(folder)
    best = results["best"]
    scored = [entry for entry in results["settings"] if entry["suite"] is not None]
    scored.sort(key=lambda entry: -float(entry["suite"]["score"]["mean"]))
    definition = results["definition"]
    context = {
        "document": {**provenance(results["command"]), "states": results["states"]},
        "name": folder.resolve().name,
        "headline": _headline(results),
        "measure": {"quick": "the quick suite", "suite": "the full suite", "none": "nothing"}[definition["score"]],
        "settings": Table("Scores", ["", "score", *COMPONENTS], [_setting_row(entry) for entry in scored]),
        "trials": Table(
            "Trials",
            ["", "seed", *definition["space"], "state", "score", "training (s)"],
            [_trial_row(trial, definition["space"]) for trial in results["trials"][:SHOWN_TRIALS]],
        ),
        "hidden_trials": max(0, len(results["trials"]) - SHOWN_TRIALS),
        "figures": _figures(folder, results, scored),
        "importance_missing": results["importance"]["missing"] if definition["space"] else None,
        "best": None
        if best is None
        else {**best, "view": f"mini-quadruped view {shlex.quote(str(folder / best['run']))}"},
        "definition": definition,
    }
    report = folder / REPORT_FILE
    write_html(report, "sweep.html", context)
    return report


def _headline(results: Mapping[str, Any]) -> str:
    finished, begun = results["states"].get("finished", 0), len(results["trials"])
    best = results["best"]
    parts = [f"{finished} of {begun} trials finished"]
    parts += [f"{results['states'][state]} {state}" for state in ("stopped", "failed") if state in results["states"]]
    if best is not None:
        parts.append(f"the best is trial {best['trial']} with a score of {best['score']:.3f}")
    return (
        ", ".join(parts[:-1])
        + ("; " if best is not None and len(parts) > 1 else ", " if parts[:-1] else "")
        + parts[-1]
        + "."
    )


def _setting_row(entry: Mapping[str, Any]) -> list[str]:
    label = ", ".join(f"{name} {_shown(value)}" for name, value in entry["values"].items()) or "all seeds"
    suite = entry["suite"]
    cells = [_interval(suite["score"], 3), *(_interval(suite["components"][name], 2) for name in COMPONENTS)]
    return [f"{label} ({entry['finished']} of {len(entry['trials'])} trials)", *cells]


def _interval(entry: Mapping[str, Any], digits: int) -> str:
    """A mean with its interval, which a single seed does not have."""
    return f"{entry['mean']:.{digits}f}" if entry["low"] is None else interval(entry, digits)


def _trial_row(trial: Mapping[str, Any], space: Mapping[str, Any]) -> list[str]:
    seconds = trial["training_seconds"]
    cells = [
        str(trial["seed"]),
        *(_shown(trial["values"][name]) for name in space),
        trial["state"],
        "-" if trial["score"] is None else f"{trial['score']:.3f}",
        "-" if seconds is None else f"{seconds:.0f}",
    ]
    return [f"trial {trial['trial']}", *cells]


def _shown(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else plots.plain_text(value)


def _figures(folder: Path, results: Mapping[str, Any], scored: list[Mapping[str, Any]]) -> list[dict[str, str]]:
    figures = []
    best = None if results["best"] is None else results["best"]["trial"]
    progress = {
        trial["trial"]: columns
        for trial in results["trials"]
        if trial["run"] is not None
        and len((columns := read_progress(folder / trial["run"] / PROGRESS_FILE))["timesteps"])
    }
    if progress:
        figures.append(
            figure(
                "Learning curves",
                plots.learning_curves(progress, best),
                "Return, velocity error and falls of each finished trial over its time steps, with the noise of the "
                "exploration; their median where more than half of the trials are.",
            )
        )
    space = results["definition"]["space"]
    lines = [{"values": entry["values"], "score": entry["suite"]["score"]["mean"]} for entry in scored]
    if space and lines:
        figures.append(
            figure(
                "Settings and their scores",
                plots.parallel_coordinates(lines, space),
                "Each line is a setting, from its value of each field to its score; lighter lines have higher scores.",
            )
        )
    if results["importance"]["fields"]:
        figures.append(
            figure(
                "Importance of the fields",
                plots.importances(results["importance"]["fields"]),
                "Share of each field in what distinguishes the best settings from all of them (PED-ANOVA). With few "
                "settings it is a rough estimate.",
            )
        )
    return figures
