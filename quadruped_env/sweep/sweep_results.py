"""Results of a sweep: a row for each trial, the aggregate of each setting over its seeds, and the best run."""

import csv
import io
import math
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.errors import MissingExtraError
from quadruped_env.evaluation.results import RESULTS_FILE as SUITE_FILE
from quadruped_env.evaluation.results import aggregate, read_results
from quadruped_env.sweep.search import add_trial, optuna_module
from quadruped_env.sweep.search_space import shown
from quadruped_env.sweep.sweep_definition import SweepConfig
from quadruped_env.sweep.sweep_records import TRIALS, SweepFolder
from quadruped_env.utils.files import write_json, write_whole
from quadruped_env.utils.provenance import git_commit, machine, versions

RESULTS_CSV: Final = "results.csv"
RESULTS_JSON: Final = "results.json"
LEAST_FOR_IMPORTANCE: Final = 4
"""Settings with a score from which the importance of the fields is estimated."""
_COLUMNS: Final = ("trial", "setting", "seed", "state", "score")
_MORE: Final = ("timesteps", "training_seconds", "scoring_seconds", "peak_memory_mb", "node", "run", "error")


def collect(folder: SweepFolder, command: str) -> dict[str, Any]:
    """All results of a sweep so far, as plain values.

    Returns:
        `trials`, one entry for every trial that has begun; `settings`, with the mean over the seeds;
        `importance` of the fields that vary; `best`, the best trial and its run directory, and provenance.

    Raises:
        QuadrupedError: if a file is damaged.
    """
    trials = [entry for number, _, _ in folder.config.trials() if (entry := _trial(folder, number)) is not None]
    settings = _settings(folder, trials)
    scored = [trial for trial in trials if trial["state"] == "finished" and None not in (trial["score"], trial["run"])]
    best = max(scored, key=lambda trial: trial["score"], default=None)
    return {
        "sweep": folder.identity,
        "definition": folder.config.to_dict(),
        "command": command,
        "git_commit": git_commit(),
        "versions": versions(),
        "machine": machine(),
        "states": dict(sorted(Counter(trial["state"] for trial in trials).items())),
        "trials": trials,
        "settings": settings,
        "importance": importance(folder.config, settings),
        "best": None if best is None else {name: best[name] for name in ("trial", "score", "run", "values", "seed")},
    }


def write(folder: SweepFolder, results: Mapping[str, Any]) -> tuple[Path, Path]:
    """Write results.json and results.csv; their paths.

    Raises:
        QuadrupedError: if a file cannot be written.
    """
    fields = [dimension.field for dimension in folder.config.space]
    parts = sorted({part for trial in results["trials"] for part in trial["components"] or ()})
    text = io.StringIO()
    writer = csv.DictWriter(text, [*_COLUMNS, *fields, *parts, *_MORE])
    writer.writeheader()
    for trial in results["trials"]:
        values = {name: shown(value) for name, value in trial["values"].items()}
        row = {name: trial[name] for name in (*_COLUMNS, *_MORE)}
        writer.writerow({**row, **values, **(trial["components"] or {})})
    numbers, table = folder.path / RESULTS_JSON, folder.path / RESULTS_CSV
    write_whole({table: text.getvalue().encode()})
    write_json(numbers, dict(results))
    return numbers, table


def _trial(folder: SweepFolder, number: int) -> dict[str, Any] | None:
    trial = folder.trial(number)
    settings, result = trial.settings(), trial.result()
    if settings is None:
        return None
    found = result or {"state": "begun"}
    score = found.get("score")
    run = None if found.get("run") is None else f"{TRIALS}/{trial.path.name}/{found['run']}"
    return {
        "trial": number,
        "setting": settings["setting"],
        "seed": settings["seed"],
        "values": settings["values"],
        "state": found["state"],
        "score": None if score is None else score["total"],
        "components": None if score is None else score["components"],
        "rungs": trial.scores(),
        "run": run,
        **{name: found.get(name) for name in _MORE if name != "run"},
    }


def _settings(folder: SweepFolder, trials: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Aggregate of each setting: the suite's, over the seeds that were trained to the end."""
    found = []
    for setting in sorted({trial["setting"] for trial in trials}):
        own = [trial for trial in trials if trial["setting"] == setting]
        scored = [trial for trial in own if trial["state"] == "finished" and None not in (trial["score"], trial["run"])]
        documents = [
            {**read_results(folder.path / trial["run"] / "evaluation" / SUITE_FILE), "name": f"trial {trial['trial']}"}
            for trial in scored
        ]
        found.append(
            {
                "setting": setting,
                "values": own[0]["values"],
                "trials": [trial["trial"] for trial in own],
                "finished": len(scored),
                "suite": aggregate(documents) if documents else None,
            }
        )
    return found


def score_of_setting(scores: Sequence[float]) -> float | None:
    """Score of a setting for a search: mean over its seeds; None without one."""
    return float(np.mean(scores)) if len(scores) else None


def importance(config: SweepConfig, settings: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Importance of each field for the score, adding up to 1, by PED-ANOVA.

    Watanabe et al. 2023, https://arxiv.org/abs/2304.10255, as Optuna has it. Empty with the reason in `missing` if
    there are too few settings, or Optuna is not installed.
    """
    scored = [entry for entry in settings if entry["suite"] is not None]
    if not config.space:
        return {"fields": {}, "missing": "no field varies"}
    if len(scored) < LEAST_FOR_IMPORTANCE:
        return {"fields": {}, "missing": f"{len(scored)} settings have a score; {LEAST_FOR_IMPORTANCE} are needed"}
    try:
        optuna = optuna_module()
    except MissingExtraError as error:
        return {"fields": {}, "missing": str(error)}
    study = optuna.create_study(direction="maximize", sampler=optuna.samplers.RandomSampler(seed=0))
    for entry in scored:
        # Values from JSON stand for the same choices.
        score = score_of_setting([run["total"] for run in entry["suite"]["runs"]])
        add_trial(study, config.space, entry["values"], score, optuna.trial.TrialState.COMPLETE)
    # At least two settings count as good ones, also in a small sweep.
    quantile = max(0.1, 2.0 / len(scored))
    evaluator = optuna.importance.PedAnovaImportanceEvaluator(target_quantile=quantile, evaluate_on_local=True)
    found = optuna.importance.get_param_importances(study, evaluator=evaluator)
    return {"fields": {name: float(np.round(value, 6)) for name, value in found.items()}, "missing": None}


def table(results: Mapping[str, Any]) -> str:
    """The settings in words, the best first."""
    lines = []
    scored = [entry for entry in results["settings"] if entry["suite"] is not None]
    for entry in sorted(scored, key=lambda entry: -entry["suite"]["score"]["mean"]):
        score = entry["suite"]["score"]
        known = score["low"] is not None and math.isfinite(score["low"])
        spread = f" [{score['low']:.3f}, {score['high']:.3f}]" if known else ""
        values = ", ".join(f"{name} {shown(value)}" for name, value in entry["values"].items())
        count = f"{entry['finished']} seed{'s' if entry['finished'] > 1 else ''}"
        lines.append(f"{score['mean']:.3f}{spread}  {count}{f'  {values}' if values else ''}")
    return "\n".join(lines)
