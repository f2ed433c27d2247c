"""Tables of a comparison, for a terminal and for pages, where a line break in a cell begins its small print."""

import math
from collections.abc import Mapping
from typing import Final

from quadruped_env.evaluation.comparison import Comparison, Motion
from quadruped_env.evaluation.conditions import words
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.learning_gain import GAIN_HEADER, LearningGain, gain_rows, reward_in_words
from quadruped_env.evaluation.measures import METRICS, metrics_of
from quadruped_env.evaluation.term_gain import TERM_HEADER, TERM_NOTE, term_rows
from quadruped_env.report import plots
from quadruped_env.report.plots.canvas import label
from quadruped_env.utils.text_table import Table, text_table

SUMMARY: Final = (
    ("Falls", "fall_rate", None),
    ("Forwards: velocity error", "forward_velocity_error", "forwards"),
    ("Standing: velocity error", "forward_velocity_error", "standing"),
    ("Backwards: velocity error", "forward_velocity_error", "backwards"),
    ("Turning: yaw rate error", "yaw_rate_error", "turning"),
    ("Sideways: lateral velocity error", "lateral_velocity_error", "sideways"),
    ("Forwards: electrical cost of transport", "electrical_cost_of_transport", "forwards"),
    ("Forwards: mechanical cost of transport", "mechanical_cost_of_transport", "forwards"),
    ("Forwards: foot slip", "slip", "forwards"),
    ("Forwards: height of the base", "base_height", "forwards"),
    ("Forwards: rise of the feet", "apex", "forwards"),
    ("Forwards: landing speed", "landing_speed", "forwards"),
)
"""Label, metric and motion of each row of the summary table."""


def summary_table(comparison: Comparison) -> str:
    """Return the summary of a comparison as plain text, with its condition."""
    rows = [["", *map(label, comparison.values)]]
    for title, metric, motion in SUMMARY:
        if comparison.conditions(motion):
            unit = METRICS[metric].unit
            cells = _estimates(comparison, metric, motion, "{} [{}, {}]")
            rows.append([f"{title} ({unit})" if unit else title, *cells])
    condition = f"\n{comparison.condition}: {len(comparison.seeds)} starts of each command, {comparison.seconds:g} s"
    note = "" if len(comparison.seeds) > 1 else "\nNo intervals: a single random start of each command has none."
    return text_table(rows, left=len(rows[0])) + condition + note


def metric_tables(comparison: Comparison) -> list[Table]:
    """Return the tables of a page: the summary, then every metric for each motion, with its commands as note."""
    head = ["", *map(label, comparison.values)]
    tables = [Table("", head, [_row(comparison, *row) for row in SUMMARY if comparison.conditions(row[2])])]
    for motion in comparison.motions:
        commands = "; ".join(words(comparison.commands[i]) for i in comparison.conditions(motion))
        rows = [_row(comparison, metric.label, name, motion) for name, metric in metrics_of(comparison.robot).items()]
        tables.append(Table(motion.capitalize(), head, rows, commands))
    return tables


def _row(comparison: Comparison, title: str, metric: str, motion: Motion) -> list[str]:
    unit, limit = METRICS[metric].unit, METRICS[metric].limit_of(comparison.robot)
    return [
        f"{title}\n{unit}" + ("" if limit is None else f" limit {limit:g}"),
        *_estimates(comparison, metric, motion, "{}\n{} to {}"),
    ]


def _estimates(comparison: Comparison, metric: str, motion: Motion, form: str) -> list[str]:
    """Return the mean of a metric with its interval for each controller, or the mean alone if it has no interval."""
    show, cells = METRICS[metric].show, []
    for name in comparison.values:
        found = comparison.estimate(name, metric, motion)
        mean, low, high = map(show, (found.mean, found.low, found.high))
        cells.append(mean if low == "-" else form.format(mean, low, high))
    return cells


def reward_terms(
    policies: Mapping[str, EvaluatedPolicy], comparison: Comparison
) -> dict[str, dict[str, dict[str, float]]]:
    """Return policy -> reward term of its task -> weight, and weighted mean per second over all commands.

    The mean is NaN for a policy that always falls. `policies` have their names in the comparison.
    """
    means, found = plots.mean_terms(comparison), {}
    for name, evaluated in policies.items():
        weights, names = evaluated.policy.config.reward.weights, comparison.rollouts[name].term_names
        values = means[name].tolist() if name in means else [math.nan] * len(names)
        found[name] = {
            term: {"weight": weights[term], "per_second": value} for term, value in zip(names, values, strict=True)
        }
    return found


def terms_table(policies: Mapping[str, EvaluatedPolicy], comparison: Comparison) -> Table:
    """Return the table of reward terms per second, with the terms of all policies in their order."""
    terms = reward_terms(policies, comparison)

    def cell(term: Mapping[str, float] | None) -> str:
        if term is None or math.isnan(term["per_second"]) or not term["weight"]:
            return "-" if term is None else f"-\nweight {term['weight']:g}"
        mean = term["per_second"] / term["weight"] + 0.0  # no -0
        return f"{term['per_second']:.3g}\n{term['weight']:g} \N{MULTIPLICATION SIGN} {mean:.3g}"

    every = dict.fromkeys(term for own in terms.values() for term in own)
    rows = [[term, *(cell(own.get(term)) for own in terms.values())] for term in every]
    return Table("Reward terms", ["", *map(label, terms)], rows)


def gain_tables(gains: Mapping[str, LearningGain]) -> list[Table]:
    """Return the table of each policy and its zero action, with the reward of both as note, and of its own terms."""
    tables = []
    for name, document in {name: gain.to_dict() for name, gain in gains.items()}.items():
        tables.append(Table(label(name), GAIN_HEADER, gain_rows(document), reward_in_words(document)))
        if rows := term_rows(document):
            tables.append(Table(label(name), TERM_HEADER, rows, TERM_NOTE))
    return tables
