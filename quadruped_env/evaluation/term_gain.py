"""Gain of a policy over its zero action in the reward terms that its user defined or changed."""

import csv
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.evaluation.confidence import Estimate, bootstrap_mean
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.policies import Policy
from quadruped_env.task import TaskConfig
from quadruped_env.task.sections import section_of, section_type, values_for
from quadruped_env.task.terms import RewardSection
from quadruped_env.training.recipes import RECIPES
from quadruped_env.training.run_directory import TERM_COLUMN
from quadruped_env.utils.fields import known

TERM_HEADER: Final = ("your terms", "weight", "first", "last", "zero action", "last, per second", "")
"""Titles of the columns of `term_rows`."""
TERM_NOTE: Final = (
    "Mean of each reward term that the user defined or changed, in the policy's own task: in the first second of the "
    "training, with the noise of its exploration; after it; and of the zero action. A term is not learned if the 95 % "
    "interval of its gain over the zero action, from pairs of episodes, is not above 0"
)
_LITTLE: Final = 0.1
"""Share of the zero action's value below which a change is little."""


@dataclass(frozen=True)
class TermGain:
    """A reward term without its weight: mean over time of a policy and of the zero action, with 95 % intervals."""

    name: str
    unit: str
    weight: float
    """Reward per second of a value of 1"""
    first: float | None
    """Mean over the first second of the training, with the noise of its exploration; None: not known"""
    policy: Estimate
    zero: Estimate
    difference: Estimate
    """Policy minus zero action, over pairs of episodes"""

    @property
    def result(self) -> str:
        """Return what became of the term: `not learned` unless the whole interval of the gain is above 0."""
        low, high = sorted(np.sign(self.weight) * np.array([self.difference.low, self.difference.high]))
        if low <= 0.0 <= high:
            return "not learned" if self.weight else "not counted"
        share = abs(self.difference.mean / self.zero.mean) if self.zero.mean else np.inf
        word = "worse" if low < 0.0 else "hardly learned" if share < _LITTLE else "better"
        return word if share > 10.0 else f"{word} by {100.0 * share:.0f} %"

    def to_dict(self) -> dict[str, Any]:
        """Return the result as JSON-serializable values."""
        return {**asdict(self), "result": self.result}


def term_gains(policy: Policy, ours: Rollout, zeros: Rollout, progress_file: Path | None) -> tuple[TermGain, ...]:
    """Return the gain in each term of `changed_terms`, from paired episodes in the policy's own task.

    `progress_file` is the progress.csv of the training; None: there is none.
    """
    found, first = [], _first(progress_file)
    for name, unit in changed_terms(policy.config, str(policy.card.get("recipe", ""))).items():
        weight, column = policy.config.reward.weights[name], ours.term_names.index(name)
        scale = weight or 1.0
        own, zero = (
            one.reward_terms[..., column].mean(axis=0, dtype=np.float64) / (scale * one.timestep)
            for one in (ours, zeros)
        )
        estimates = map(bootstrap_mean, (own, zero, own - zero))
        found.append(TermGain(name, unit, weight, first[name] / scale if name in first else None, *estimates))
    return tuple(found)


def changed_terms(config: TaskConfig, recipe: str) -> dict[str, str]:
    """Return the name and unit of each reward term that is not built in, or whose weight or a parameter is changed.

    A change is a difference from the recipe, or from the default task if there is no such recipe.
    """
    definition = config.definition
    values = values_for(RECIPES[recipe].task, config.robot).get("reward", {}) if recipe in RECIPES else {}
    kind = section_type(RewardSection, definition, config.reward)
    usual = section_of(RewardSection, definition, known(values, kind))
    own, found = definition.own_terms()["rewards"], {}
    for term in definition.paid:
        changed = any(config.reward[name] != usual[name] for name in term.parameters)
        for name in term.names:
            if changed or name in own or config.reward.weights[name] != usual.weights[name]:
                found[name] = term.unit
    return found


def _first(progress_file: Path | None) -> dict[str, float]:
    """Return the weighted mean per second of each term in the first row of a progress.csv."""
    if progress_file is None:
        return {}
    with progress_file.open(newline="", encoding="utf-8") as file:
        row = next(csv.DictReader(file), {})
    return {name.removeprefix(TERM_COLUMN): float(text) for name, text in row.items() if name.startswith(TERM_COLUMN)}


def term_rows(document: Mapping[str, Any]) -> list[tuple[str, ...]]:
    """Return the rows of `TermGain.to_dict`s below the header `TERM_HEADER`."""
    rows = []
    for term in document.get("terms", ()):
        unit, weight = "" if term["unit"] == "1" else f" ({term['unit']})", term["weight"]
        last = term["policy"]["mean"]
        values = (term["first"], last, term["zero"]["mean"]) if weight else (None,) * 3
        cells = ["-" if value is None else f"{value:z.3g}" for value in values]
        rows.append((f"{term['name']}{unit}", f"{weight:g}", *cells, f"{weight * last:+z.2f}", term["result"]))
    return rows
