"""The comparison page of several policies: the best policy for each motion, and their metrics and figures."""

import difflib
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import Comparison, equal_up_to, error_of
from quadruped_env.evaluation.conditions import MOTIONS
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy, find_policy
from quadruped_env.evaluation.learning_gain import LearningGain
from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.evaluation.verdict import listed, verdict
from quadruped_env.report.pages import page
from quadruped_env.report.pages.learning import gain_section, learning_curves
from quadruped_env.report.pages.page import METRICS_FILE
from quadruped_env.report.pages.pictures import shown_commands
from quadruped_env.report.pages.suite_section import interval, ranking_in_words, score_rows
from quadruped_env.report.report_directory import prepare_output
from quadruped_env.utils.files import write_json


def find_policies(
    runs: Sequence[str], output: Path, task_file: Path | None = None, trust_task: bool = False
) -> dict[str, EvaluatedPolicy]:
    """Find policies by name or directory: name -> policy.

    Raises:
        QuadrupedError: if there are fewer than two, two have the same name, or one is missing or damaged.
    """
    policies: dict[str, EvaluatedPolicy] = {}
    for run in runs:
        evaluated = find_policy(run, output, task_file, trust_task)
        if evaluated.name in policies:
            raise QuadrupedError(f"{run}: a policy called {evaluated.name!r} is named before; name each one once")
        policies[evaluated.name] = evaluated
    if len(policies) < 2:
        raise QuadrupedError(f"expected at least two runs to compare; found {len(policies)}")
    return policies


def best_at(comparison: Comparison, names: Sequence[str], motion: str) -> list[str]:
    """The most accurate policies for a motion: the best one, and those that are equal to it.

    A policy is equal if the interval of the paired difference includes zero, or its mean is within `equal_up_to`.
    Policies that fall too early have no value and no rank; empty if there are not two others, or they share no episode.
    """
    metric = error_of(motion)
    means = {name: comparison.estimate(name, metric, motion).mean for name in names}
    known = [name for name in names if means[name] == means[name]]
    if len(known) < 2:
        return []
    best = min(known, key=lambda name: means[name])
    differences = {name: comparison.difference(metric, name, best, motion) for name in known}
    if any(math.isnan(difference.mean) for difference in differences.values()):
        return []
    level = equal_up_to(metric, comparison.robot)
    return [name for name, difference in differences.items() if difference.mean <= level or difference.low <= 0.0]


def headline(comparison: Comparison, names: Sequence[str]) -> str:
    """A sentence: the policies that fall more often than others, and the most accurate ones for each motion."""
    falls = {name: comparison.estimate(name, "fall_rate") for name in names}
    # "More often" requires that the confidence intervals do not overlap.
    unsteady = [name for name in names if falls[name].low > min(fall.high for fall in falls.values())]
    parts = [f"{listed(unsteady)} {_agreed(unsteady, 'falls', 'fall')} more often"] if unsteady else []
    if len(comparison.seeds) == 1:
        return _sentence([*parts, "one start of each command gives no interval, so errors are not ranked"])
    leaders: dict[tuple[str, ...], list[str]] = {}
    for motion in MOTIONS:
        if comparison.conditions(motion):
            leaders.setdefault(tuple(best_at(comparison, names, motion)), []).append(motion)
    for best, motions in leaders.items():
        if len(best) == len(names):
            parts.append(f"all are equally accurate {listed(motions)}")
        elif best:
            parts.append(f"{listed(list(best))} {_agreed(best, 'is', 'are')} most accurate {listed(motions)}")
        else:
            parts.append(f"not comparable {listed(motions)}, because of early falls")
    return _sentence(parts)


def _sentence(parts: Sequence[str]) -> str:
    sentence = "; ".join(parts)
    return f"{sentence[:1].upper()}{sentence[1:]}."


def _agreed(names: Sequence[str], one: str, many: str) -> str:
    return one if len(names) == 1 else many


def write_numbers(
    policies: Mapping[str, EvaluatedPolicy],
    comparison: Comparison,
    output: Path,
    command_line: str,
    ranked: Mapping[str, Any] | None = None,
    gains: Mapping[str, LearningGain] | None = None,
) -> dict[str, Any]:
    """Write the numbers of a comparison into a directory, and return their document.

    `ranked` is the ranking on the suite, from `suite_section.ranking`; None: there is none. `gains` are the policies
    against their zero actions, by name; None: they were not measured.

    Raises:
        MissingExtraError, QuadrupedError: as `evaluation_report.write_report`.
    """
    prepare_output(output)
    names = list(policies)
    judged = {name: verdict(comparison.seen_as(name)) for name in names}
    terms = page.reward_terms(policies, comparison)
    document = {
        **page.provenance(command_line),
        "headline": headline(comparison, names),
        "suite": ranked,
        "policies": {
            name: {
                "card": page.without_nan(evaluated.policy.card),
                "task_file": page.task_of(evaluated),
                "reward_terms": page.without_nan(terms[name]),
                "verdict": {"level": judged[name].level, "headline": judged[name].headline},
                "learning": gains[name].to_dict() if gains else None,
            }
            for name, evaluated in policies.items()
        },
        **comparison.to_dict(),
    }
    write_json(output / METRICS_FILE, document)
    return document


def write_page(
    policies: Mapping[str, EvaluatedPolicy],
    comparison: Comparison,
    output: Path,
    document: dict[str, Any],
    ranked: Mapping[str, Any] | None = None,
    gains: Mapping[str, LearningGain] | None = None,
) -> Path:
    """Write the page of a comparison, whose numbers are in `document`; arguments as in `write_numbers`."""
    names = list(policies)
    context: dict[str, Any] = {
        "names": names,
        "headline": headline(comparison, names),
        "verdicts": {name: verdict(comparison.seen_as(name)) for name in names},
        "gains": {name: gain.verdict() for name, gain in (gains or {}).items()},
        "learning": gain_section(gains) if gains else None,
        "reward_terms": page.term_rows(policies, comparison),
        "diffs": _diffs(policies),
        "ranking": None if ranked is None else _ranking(ranked),
        "figures": [
            *page.shared_figures(comparison, shown_commands(comparison).get("forwards", 0)),
            *learning_curves(policies, gains or {}),
        ],
        **page.tables(comparison),
    }
    return page.write_report_page(output, "comparison.html", document, context)


def _ranking(found: Mapping[str, Any]) -> dict[str, Any]:
    """Template variables of the ranking."""
    return {
        "words": ranking_in_words(found),
        "components": COMPONENTS,
        "scores": score_rows([(entry["name"], {"score": entry}) for entry in found["policies"]]),
        "recipes": [
            {
                "names": listed([run["name"] for run in recipe["runs"]]),
                "count": len(recipe["runs"]),
                "score": interval(recipe["score"], 3),
                "components": [interval(recipe["components"][name], 2) for name in COMPONENTS],
                "terrain": ", ".join(f"{kind} {level}" for kind, level in recipe["terrain"].items()),
            }
            for recipe in found["recipes"]
        ],
    }


def _diffs(policies: Mapping[str, EvaluatedPolicy]) -> list[dict[str, str]]:
    """Unified differences of the task files that the runs keep, each from that of the first such run."""
    texts = {
        f"{name}/{file.name}": file.content.decode(errors="replace").splitlines()
        for name, evaluated in policies.items()
        if (file := evaluated.task_file) is not None and file.content
    }
    found = []
    for name in list(texts)[1:]:
        first = next(iter(texts))
        lines = difflib.unified_diff(texts[first], texts[name], first, name, lineterm="")
        found.append({"title": f"From {first} to {name}", "text": "\n".join(lines) or "No difference."})
    return found
