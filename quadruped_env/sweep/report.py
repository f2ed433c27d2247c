"""Results of a sweep, their statistics, and the report: settings by score, trials, learning curves."""

import math
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from quadruped_env.evaluation.confidence import Estimate, student_mean
from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.report.pages.page import figure, provenance, write_html
from quadruped_env.report.plots.learning_plots import learning_curve, read_progress
from quadruped_env.report.report_directory import REPORT_FILE
from quadruped_env.sweep.folder import SWEEP_FILE, Sweep
from quadruped_env.sweep.space import in_words
from quadruped_env.training.run_directory import PROGRESS_FILE
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.files import write_json
from quadruped_env.utils.text_table import Table


def score_of(results: Sequence[Mapping[str, Any] | None], component: str | None = None) -> Estimate:
    """Score of a setting, or one component of it, from the results of its seeds; NaN if one of them has none.

    A failed training counts as the zero action, whose score its result holds.
    """
    scores = [result and result["score"] for result in results]
    if None in scores:
        return Estimate(math.nan, math.nan, math.nan, len(scores))
    return student_mean([s["total"] if component is None else s["components"][component] for s in scores if s])


def collect(sweep: Sweep) -> dict[str, Any]:
    """All results of a sweep so far, as plain values.

    Returns:
        `trials`, one entry for each; `settings` that have a result, the best first, each with its `values` and the
        `results` of its seeds; `states`, a count of the trials' states; and `best`, the best trial, or None.

    Raises:
        QuadrupedError: if a file is damaged.
    """
    none: dict[str, Any] = {"state": "open", "values": {}, "score": None}
    trials = [{"trial": n, "seed": sweep.seed(n), **(sweep.result(n) or none)} for n in range(len(sweep))]
    settings = []
    for first in range(0, len(sweep), sweep.seeds):
        own = [trial for trial in trials[first : first + sweep.seeds] if trial["state"] != "open"]
        settings += [{"values": own[0]["values"], "results": own}] if own else []
    settings.sort(key=lambda entry: -np.nan_to_num(score_of(entry["results"]).mean))
    finished = [trial for trial in trials if trial["state"] == "finished" and trial["score"] is not None]
    best = max(finished, key=lambda trial: float(trial["score"]["total"]), default=None)
    return {"trials": trials, "settings": settings, "states": Counter(t["state"] for t in trials), "best": best}


def headline(found: Mapping[str, Any]) -> str:
    """The results in a sentence."""
    parts = [f"{found['states']['finished']} of {len(found['trials'])} trials finished"]
    parts += [f"{found['states'][state]} {state}" for state in ("failed", "open") if found["states"][state]]
    best = found["best"]
    end = "" if best is None else f"; the best is trial {best['trial']} with a score of {best['score']['total']:.3f}"
    return f"{', '.join(parts)}{end}."


def table(found: Mapping[str, Any], seeds: int) -> Table:
    """The settings, the best first: values of the fields, seeds that were trained to the end, score and components."""
    rows = []
    for entry in found["settings"]:
        failed = sum(result["state"] == "failed" for result in entry["results"])
        count = f"{len(entry['results']) - failed} of {seeds} seeds{f', {failed} failed' if failed else ''}"
        scores = [score_of(entry["results"], component) for component in COMPONENTS]
        cells = [estimate_in_words(score_of(entry["results"])), *(f"{score.mean:.2f}" for score in scores)]
        rows.append([in_words(entry["values"]) or "all", count, *cells])
    note = "Quick suite: mean over all seeds [95 % interval]; a failed seed counts as the zero action."
    return Table("Scores", ["setting", "", "score", *COMPONENTS], rows, note)


def estimate_in_words(estimate: Estimate) -> str:
    """A mean with its interval; a dash if it is not known."""
    interval = "" if math.isnan(estimate.low) else f" [{estimate.low:.3f}, {estimate.high:.3f}]"
    return "-" if math.isnan(estimate.mean) else f"{estimate.mean:.3f}{interval}"


def write_report(sweep: Sweep) -> Path:
    """Write report.html and results.json into the directory of a sweep, unless they hold all results; the page.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if a file of the sweep is damaged, or one cannot be written.
    """
    page = sweep.path / REPORT_FILE
    with sweep.locked("report"):
        found = collect(sweep)
        newest = max((path.stat().st_mtime_ns for path in sweep.path.glob("trials/*/result.json")), default=0)
        if os.path.isfile(page) and page.stat().st_mtime_ns > newest:
            return page
        write_json(sweep.path / "results.json", found)
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
