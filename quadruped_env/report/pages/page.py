"""Common parts of the HTML pages: templates, tables of numbers, and embedded files."""

import base64
import json
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import MissingExtraError
from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.conditions import MOTIONS, words
from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.measures import METRICS, START_UP, WINDOW
from quadruped_env.policies import task_note
from quadruped_env.report import plots
from quadruped_env.report.plots.canvas import label
from quadruped_env.report.report_directory import REPORT_FILE
from quadruped_env.robot import Robot
from quadruped_env.utils.files import write_whole
from quadruped_env.utils.provenance import circumstances
from quadruped_env.utils.text_table import text_table

METRICS_FILE: Final = "metrics.json"
FORMAT_VERSION: Final = 3

SUMMARY: Final = (
    ("Falls", "fall_rate", None),
    ("Forwards: velocity error", "forward_velocity_error", "forwards"),
    ("Standing: velocity error", "forward_velocity_error", "standing"),
    ("Backwards: velocity error", "forward_velocity_error", "backwards"),
    ("Turning: yaw rate error", "yaw_rate_error", "turning"),
    ("Forwards: electrical cost of transport", "electrical_cost_of_transport", "forwards"),
    ("Forwards: mechanical cost of transport", "mechanical_cost_of_transport", "forwards"),
    ("Forwards: foot slip", "slip", "forwards"),
)
"""Label, metric and motion of each row of the summary table."""


def summary_table(comparison: Comparison) -> str:
    """The summary table of a report as plain text."""
    rows = [["", *map(label, comparison.values)]]
    for title, metric, motion in _summary_rows(comparison):
        unit = METRICS[metric].unit
        cells = [_cell(metric, comparison.estimate(name, metric, motion)) for name in comparison.values]
        texts = [c["mean"] if c["low"] == "-" else f"{c['mean']} [{c['low']}, {c['high']}]" for c in cells]
        rows.append([f"{title} ({unit})" if unit else title, *texts])
    condition = f"\n{comparison.condition}: {len(comparison.seeds)} starts of each command, {comparison.seconds:g} s"
    note = "" if len(comparison.seeds) > 1 else "\nNo intervals: a single random start of each command has none."
    return text_table(rows, left=len(rows[0])) + condition + note


def _summary_rows(comparison: Comparison) -> list[tuple[str, str, str | None]]:
    return [row for row in SUMMARY if comparison.conditions(row[2])]


def tables(comparison: Comparison) -> dict[str, Any]:
    """Template variables of the tables."""
    return {
        "controllers": [label(name) for name in comparison.values],
        "summary": [_row(title, metric, comparison, motion) for title, metric, motion in _summary_rows(comparison)],
        "motions": [
            {
                "title": motion.capitalize(),
                "commands": "; ".join(words(comparison.commands[i]) for i in comparison.conditions(motion)),
                "rows": [_row(metric.label, name, comparison, motion) for name, metric in METRICS.items()],
            }
            for motion in MOTIONS
            if comparison.conditions(motion)
        ],
        "metrics": METRICS,
        "robot": _description(comparison.robot),
        "start_up": START_UP,
        "window": WINDOW,
    }


def _row(title: str, metric: str, comparison: Comparison, motion: str | None) -> dict[str, Any]:
    return {
        "label": title,
        "unit": METRICS[metric].unit,
        "limit": METRICS[metric].limit_of(comparison.robot),
        "cells": [_cell(metric, comparison.estimate(name, metric, motion)) for name in comparison.values],
    }


def _cell(metric: str, estimate: Estimate) -> dict[str, str]:
    show = METRICS[metric].show
    return {"mean": show(estimate.mean), "low": show(estimate.low), "high": show(estimate.high)}


def _description(robot: Robot) -> str:
    """A sentence that introduces a robot and its task."""
    return (
        f"A robot with {robot.num_legs} legs and {robot.num_joints} motors, of {robot.total_mass:.3g} kg and with its "
        f"base {100.0 * robot.stance_height:.0f} cm above the ground, walks in a physics simulation (MuJoCo) and "
        f"follows commands of forward velocity and yaw rate."
    )


def task_of(evaluated: EvaluatedPolicy) -> dict[str, Any] | None:
    """The user's file that a policy was trained with: name, hash, text, differences of the task here; None without."""
    file = evaluated.task_file
    if file is None:
        return None
    text = file.content.decode(errors="replace")
    return {**file.to_dict(), "text": text, "differences": task_note(evaluated.policy)}


def provenance(command_line: str) -> dict[str, Any]:
    """First fields of a document of numbers: its format, and where it comes from."""
    return {"format_version": FORMAT_VERSION, **circumstances(command_line)}


def figure(title: str, svg: str, caption: str, text: str = "") -> dict[str, str]:
    """Template variables of a figure: title, SVG document as a data URL, caption, and introductory text."""
    return {"title": title, "source": data_url("image/svg+xml", svg.encode()), "caption": caption, "text": text}


def shared_figures(comparison: Comparison, command: int) -> list[dict[str, str]]:
    """Figures of all controllers: tracking, cost of transport, and the gait under one command (its index)."""
    names = comparison.robot.leg_names
    known = all(len(name) == 2 and name[0] in "LR" and name[1] in "FH" for name in names)
    legs = " L and R: left and right; F and H: front and hind." if known else ""
    return [
        figure(
            "Following the command",
            plots.tracking(comparison),
            "Mean velocity that each controller reaches, over the commanded velocity. On the dashed line the two are "
            "equal. Hollow marks are turns while walking. Bars are 95 % confidence intervals; most are smaller than "
            "the marks.",
        ),
        figure(
            "Cost of transport over speed",
            plots.cost_over_speed(comparison),
            "Energy of the motors per weight and distance (left), and per time (right). Above: electrical, that is "
            "mechanical energy and heat in the windings; below: mechanical. Each mark is a command; hollow marks are "
            "backwards. Below 0.05 m/s the cost of transport is undefined.",
        ),
        figure(
            "Gait: which feet are on the ground",
            plots.gait_diagram(comparison, command),
            f"Bars show when a foot is on the ground. Command: {words(comparison.commands[command])}.{legs}",
        ),
    ]


def reward_terms(
    policies: Mapping[str, EvaluatedPolicy], comparison: Comparison, controllers: Mapping[str, str] | None = None
) -> dict[str, dict[str, dict[str, float]]]:
    """Policy -> reward term of its task -> weight, and weighted mean per second over all commands (NaN: it falls).

    `controllers` are the names of the policies in the comparison, if they have others there.
    """
    means, found = plots.mean_terms(comparison), {}
    for name, evaluated in policies.items():
        controller = name if controllers is None else controllers[name]
        weights, names = evaluated.policy.config.reward.weights, comparison.rollouts[controller].term_names
        values = means[controller].tolist() if controller in means else [math.nan] * len(names)
        found[name] = {
            term: {"weight": weights[term], "per_second": value} for term, value in zip(names, values, strict=True)
        }
    return found


def term_rows(
    policies: Mapping[str, EvaluatedPolicy], comparison: Comparison, controllers: Mapping[str, str] | None = None
) -> list[dict[str, Any]]:
    """Rows of the table of reward terms, the terms of all policies in their order."""
    terms = reward_terms(policies, comparison, controllers)

    def cell(term: Mapping[str, float] | None) -> dict[str, str]:
        if term is None or math.isnan(term["per_second"]) or not term["weight"]:
            return {"value": "-", "parts": "" if term is None else f"weight {term['weight']:g}"}
        mean = term["per_second"] / term["weight"] + 0.0  # no -0
        return {"value": f"{term['per_second']:.3g}", "parts": f"{term['weight']:g} \N{MULTIPLICATION SIGN} {mean:.3g}"}

    every = dict.fromkeys(term for own in terms.values() for term in own)
    return [{"label": term, "cells": [cell(own.get(term)) for own in terms.values()]} for term in every]


def data_url(kind: str, content: bytes) -> str:
    """A file as a base64 data URL; `kind` is its media type."""
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def without_nan(value: Any) -> Any:
    """Nested plain values with None for NaN and infinities, which JSON cannot represent."""
    if isinstance(value, Mapping):
        return {key: without_nan(item) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [without_nan(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def write_report_page(output: Path, template: str, document: dict[str, Any], context: dict[str, Any]) -> Path:
    """Write a report into a directory, and return its file; an existing one is replaced.

    The document of its numbers is the template's variable `document`.
    """
    write_html(output / REPORT_FILE, template, {"document": document, **context})
    return output / REPORT_FILE


def write_html(path: Path, template: str, context: dict[str, Any]) -> None:
    """Render a template to a file; an existing file is replaced. A MissingExtraError if jinja2 is not installed."""
    try:
        from jinja2 import Environment, FileSystemLoader, StrictUndefined
    except ImportError as error:
        raise MissingExtraError("The report", "report") from error

    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent / "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["glued"] = _glued
    environment.filters["json"] = lambda value: json.dumps(value, indent=2)
    html = environment.get_template(template).render(**context)
    write_whole({path: html.encode()})


def _glued(text: str) -> str:
    """The text with no-break spaces between numbers and their units."""
    return re.sub(r"(?<=\d) (?=(%|m|s|N|W|Hz|rad)\b|%)", "\N{NO-BREAK SPACE}", text)
