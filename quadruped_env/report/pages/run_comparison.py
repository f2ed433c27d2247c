"""A comparison of several policies in words: the best policies for each motion."""

import math
from collections.abc import Sequence
from pathlib import Path

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import Comparison, equal_up_to, error_of
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy, find_policy
from quadruped_env.evaluation.verdict import listed


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
    """Return the most accurate policies for a motion: the best one, and those that are equal to it.

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
    """Return a sentence: the policies that fall more often than others, and the most accurate ones for each motion."""
    falls = {name: comparison.estimate(name, "fall_rate") for name in names}
    # "More often" requires that the confidence intervals do not overlap.
    unsteady = [name for name in names if falls[name].low > min(fall.high for fall in falls.values())]
    parts = [f"{listed(unsteady)} {_agreed(unsteady, 'falls', 'fall')} more often"] if unsteady else []
    if len(comparison.seeds) == 1:
        return _sentence([*parts, "one start of each command gives no interval, so errors are not ranked"])
    leaders: dict[tuple[str, ...], list[str]] = {}
    for motion in comparison.motions:
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
