"""Results of a sweep, their statistics, and the report: settings by score, trials, learning curves."""

import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from quadruped_env.evaluation.results import COMPONENTS, seed_means
from quadruped_env.report.pages.page import figure, provenance, write_html
from quadruped_env.report.pages.suite_section import interval
from quadruped_env.report.plots.learning_plots import learning_curve, read_progress
from quadruped_env.report.report_directory import REPORT_FILE
from quadruped_env.sweep.folder import SWEEP_FILE, Sweep
from quadruped_env.sweep.space import in_words
from quadruped_env.training.run_directory import PROGRESS_FILE
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.files import write_json
from quadruped_env.utils.text_table import Table


def score_of(results: Sequence[Mapping[str, Any] | None]) -> dict[str, Any] | None:
    """Return the mean score of a setting over its seeds, as `seed_means` does; None if a seed has no score.

    A failed training counts as the zero action, whose score its result holds.
    """
    scores = [result["score"] for result in results if result and result["score"]]
    return seed_means(scores) if len(scores) == len(results) else None


def collect(sweep: Sweep) -> dict[str, Any]:
    """Return all results of a sweep so far, as plain values.

    Returns:
        `trials`, one entry for each; `settings` that have a result, the best first, each with its `values`, the
        `results` of its seeds and their `mean` (None if a policy has no score); `states`, the number of trials in each
        state; and `best`, the best trial, or None.

    Raises:
        QuadrupedError: if a file is damaged.
    """
    none: dict[str, Any] = {"state": "open", "values": {}, "score": None}
    trials = [{"trial": n, "seed": sweep.seed(n), **(sweep.result(n) or none)} for n in range(len(sweep))]
    settings = []
    for first in range(0, len(sweep), sweep.seeds):
        own = [trial for trial in trials[first : first + sweep.seeds] if trial["state"] != "open"]
        settings += [{"values": own[0]["values"], "results": own, "mean": score_of(own)}] if own else []
    settings.sort(key=lambda entry: -entry["mean"]["score"]["mean"] if entry["mean"] else 1.0)
    finished = [trial for trial in trials if trial["state"] == "finished" and trial["score"] is not None]
    best = max(finished, key=lambda trial: float(trial["score"]["total"]), default=None)
    return {"trials": trials, "settings": settings, "states": Counter(t["state"] for t in trials), "best": best}


def headline(found: Mapping[str, Any]) -> str:
    """Return the results in a sentence."""
    parts = [f"{found['states']['finished']} of {len(found['trials'])} trials finished"]
    parts += [f"{found['states'][state]} {state}" for state in ("failed", "open") if found["states"][state]]
    best = found["best"]
    end = "" if best is None else f"; the best is trial {best['trial']} with a score of {best['score']['total']:.3f}"
    return f"{', '.join(parts)}{end}."


def table(found: Mapping[str, Any], seeds: int) -> Table:
    """Return the settings, the best first: values, seeds that were trained to the end, mean score and components."""
    rows = []
    for entry in found["settings"]:
        failed = sum(result["state"] == "failed" for result in entry["results"])
        count = f"{len(entry['results']) - failed} of {seeds} seeds{f', {failed} failed' if failed else ''}"
        cells = ["-"] * (1 + len(COMPONENTS))
        if (mean := entry["mean"]) is not None:
            parts = (f"{mean['components'][component]['mean']:.2f}" for component in COMPONENTS)
            cells = [interval(mean["score"], 3), *parts]
        rows.append([in_words(entry["values"]) or "all", count, *cells])
    note = "Quick suite: mean over all seeds [95 % interval]; a failed seed counts as the zero action."
    return Table("Scores", ["setting", "", "score", *COMPONENTS], rows, note)


def write_report(sweep: Sweep) -> Path:
    """Write report.html and results.json into the directory of a sweep, unless they hold its results; return the page.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if a file of the sweep is damaged, or one cannot be written.
    """
    page, results = sweep.path / REPORT_FILE, sweep.path / "results.json"
    with sweep.locked("report"):
        found = collect(sweep)
        # The contents and not the times of the files, which come from the clocks of several machines.
        if os.path.isfile(page) and os.path.isfile(results) and read_json(results, "remove it") == found:
            return page
        context = {
            "document": {**provenance(read_json(sweep.path / SWEEP_FILE)["command_line"]), "states": found["states"]},
            "name": sweep.path.resolve().name,
            "definition": str(sweep),
            "headline": headline(found),
            "settings": table(found, sweep.seeds),
            "trials": _trials(found),
            "figures": _figures(sweep, found),
            "best": found["best"] and {**found["best"], "path": str(sweep.path / found["best"]["run"])},
        }
        write_html(page, "sweep.html", context)
        write_json(results, found)
    return page


def _trials(found: Mapping[str, Any]) -> Table:
    rows = []
    for trial in found["trials"]:
        score = "-" if trial["score"] is None else f"{trial['score']['total']:.3f}"
        facts = [str(trial.get(name, "-")) for name in ("seconds", "starts", "node", "error")]
        name = f"trial {trial['trial']}"
        rows.append([name, str(trial["seed"]), in_words(trial["values"]) or "-", trial["state"], score, *facts])
    return Table("Trials", ["", "seed", "setting", "state", "score", "time (s)", "starts", "node", "error"], rows)


def _figures(sweep: Sweep, found: Mapping[str, Any]) -> list[dict[str, str]]:
    best = found["settings"][0]["results"] if found["settings"] else []
    runs = {f"seed {trial['seed']}": sweep.path / trial["run"] for trial in best if trial["state"] == "finished"}
    if not runs:
        return []
    curves = learning_curve({name: read_progress(run / PROGRESS_FILE) for name, run in runs.items()})
    caption = "Return, velocity error and falls over the time steps, with the noise of the exploration."
    return [figure("Learning curves of the best setting", curves, caption)]
