"""The report of an evaluation: one HTML file that needs nothing beside it, and the numbers as JSON."""

import base64
import datetime
import importlib.util
import json
import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.evaluation import plots
from quadruped_env.evaluation.comparison import CONTROLLERS, MOTIONS, Command, Comparison
from quadruped_env.evaluation.film import Camera, Motion
from quadruped_env.evaluation.metrics import METRICS, START_UP, WINDOW
from quadruped_env.evaluation.overlay import AVERAGED
from quadruped_env.evaluation.results import write_json
from quadruped_env.evaluation.rollout import Progress
from quadruped_env.evaluation.statistics import Estimate
from quadruped_env.evaluation.verdict import Verdict, verdict
from quadruped_env.evaluation.video import encode_mp4
from quadruped_env.policies import Policy, load_policy
from quadruped_env.policies.policy import SHIPPED
from quadruped_env.training.run import PROGRESS_FILE, machine, versions

FORMAT_VERSION: Final = 1
REPORT_FILE: Final = "report.html"
METRICS_FILE: Final = "metrics.json"
LATEST_RUN: Final = Path("runs", "latest")

CLIP_SECONDS: Final = 2.4
_EPISODE: Final = "Shown is the first episode without a fall, or else the longest."
_FILMED: Final = ("forwards", "turning", "backwards")
_SHOWN_VELOCITY: Final = 0.4
"""m/s; of the forward commands, the one next to this is drawn over time and filmed"""

SUMMARY: Final = (
    ("Falls", "fall_rate", None),
    ("Forwards: velocity error", "forward_velocity_error", "forwards"),
    ("Standing: velocity error", "forward_velocity_error", "standing"),
    ("Backwards: velocity error", "forward_velocity_error", "backwards"),
    ("Turning: yaw rate error", "yaw_rate_error", "turning"),
)
"""Label, metric and motion of the rows of the first table."""


@dataclass(frozen=True)
class Subject:
    """A policy to evaluate, and where its results go."""

    name: str
    """Of the run, or of the shipped policy"""
    policy: Policy
    directory: Path | None
    """The training run; None for a shipped policy"""
    output: Path


def find_subject(run: str | None, output: Path | None = None) -> Subject:
    """The policy that a person names.

    Args:
        run: a run's directory or a shipped policy's name; None takes the latest run, or else the shipped policy.
        output: where the results go; None takes `evaluation` in the run's directory, or `results/<name>`.

    Raises:
        QuadrupedError: if there is no such policy, or it is damaged.
    """
    if run is None:
        run = str(LATEST_RUN) if LATEST_RUN.exists() else SHIPPED[0]
    policy = load_policy(run)
    if run in SHIPPED:
        return Subject(run, policy, None, output or Path("results", run))
    directory = Path(run).resolve()
    # A checkpoint's own name does not say whose it is.
    name = "/".join(directory.parts[-3 if directory.parent.name == "checkpoints" else -1 :])
    return Subject(name, policy, directory, output or Path(run) / "evaluation")


def prepare(output: Path) -> None:
    """Make the directory of the results, and fail now if the report could not be written later.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if the directory cannot be made.
    """
    if any(importlib.util.find_spec(name) is None for name in ("matplotlib", "jinja2", "av")):
        raise MissingExtraError("The report", "report")
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise QuadrupedError(f"{output}: cannot be made ({error.strerror}); name another place") from error


def summary_table(comparison: Comparison) -> str:
    """The first table of the report as plain text."""
    rows = [["", *(CONTROLLERS[name] for name in comparison.values)]]
    for label, metric, motion in _summary_rows(comparison):
        unit = METRICS[metric].unit
        cells = [_cell(metric, comparison.estimate(name, metric, motion)) for name in comparison.values]
        rows.append(
            [f"{label} ({unit})" if unit else label, *(f"{c['mean']} [{c['low']}, {c['high']}]" for c in cells)]
        )
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows
    )


def write_report(
    subject: Subject,
    comparison: Comparison,
    command_line: str,
    with_video: bool = True,
    progress: Progress | None = None,
) -> tuple[Path, Path]:
    """Write the report and the numbers into the subject's output directory, over those of an earlier evaluation.

    Args:
        subject: what was evaluated.
        comparison: what came out.
        command_line: what a person types to repeat it.
        with_video: whether to film it, if there is OpenGL.
        progress: is told how far the filming is.

    Returns:
        The paths of the report and of the numbers.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if a file cannot be written, or the run's learning curve cannot be read.
    """
    prepare(subject.output)
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    video = _video(comparison, progress) if with_video else {"missing": "No video: it was not asked for."}
    judged = verdict(comparison)
    document = _document(subject, comparison, judged, command_line)
    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent / "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["glued"] = _glued
    html = environment.get_template("report.html").render(
        subject=subject,
        verdict=judged,
        document=document,
        controllers={name: CONTROLLERS[name] for name in comparison.values},
        summary=_summary(comparison),
        tables=[_motion_table(comparison, motion) for motion in MOTIONS if comparison.conditions(motion)],
        metrics=METRICS,
        figures=_figures(subject, comparison),
        video=video,
        start_up=START_UP,
        window=WINDOW,
        config=json.dumps(document["config"], indent=2),
        card=json.dumps(document["policy"]["card"], indent=2),
    )
    report, numbers = subject.output / REPORT_FILE, subject.output / METRICS_FILE
    write_json(numbers, document)
    try:
        report.write_text(html, encoding="utf-8")
    except OSError as error:
        raise QuadrupedError(f"{report}: cannot be written ({error.strerror}); name another place") from error
    return report, numbers


def _document(subject: Subject, comparison: Comparison, judged: Verdict, command_line: str) -> dict[str, Any]:
    return {
        "format_version": FORMAT_VERSION,
        "policy": {"name": subject.name, "card": _without_nan(subject.policy.card)},
        "verdict": {"level": judged.level, "headline": judged.headline, "findings": dict(judged.findings)},
        "command_line": command_line,
        "time": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "machine": machine(),
        "versions": versions(),
        "config": comparison.config.to_dict(),
        **comparison.to_dict(),
    }


def _without_nan(value: Any) -> Any:
    """Plain nested values with None for what JSON has no word for."""
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_without_nan(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _glued(text: str) -> str:
    """The text with numbers and their units kept on one line."""
    return re.sub(r"(?<=\d) (?=(%|m|s|N|W|Hz|rad)\b|%)", "\N{NO-BREAK SPACE}", text)


def _cell(metric: str, estimate: Estimate) -> dict[str, str]:
    show = METRICS[metric].show
    return {"mean": show(estimate.mean), "low": show(estimate.low), "high": show(estimate.high)}


def _summary_rows(comparison: Comparison) -> list[tuple[str, str, str | None]]:
    return [row for row in SUMMARY if comparison.conditions(row[2])]


def _summary(comparison: Comparison) -> list[dict[str, Any]]:
    return [
        {
            "label": label,
            "unit": METRICS[metric].unit,
            "limit": METRICS[metric].limit,
            "cells": [_cell(metric, comparison.estimate(name, metric, motion)) for name in comparison.values],
        }
        for label, metric, motion in _summary_rows(comparison)
    ]


def _motion_table(comparison: Comparison, motion: str) -> dict[str, Any]:
    return {
        "title": motion.capitalize(),
        "commands": "; ".join(_words(comparison.commands[i]) for i in comparison.conditions(motion)),
        "rows": [
            {
                "label": metric.label,
                "unit": metric.unit,
                "limit": metric.limit,
                "cells": [
                    _cell(name, comparison.estimate(controller, name, motion)) for controller in comparison.values
                ],
            }
            for name, metric in METRICS.items()
        ],
    }


def _words(command: Command) -> str:
    forward, yaw_rate = command
    if not forward and not yaw_rate:
        return "stand"
    parts = [f"{forward:g} m/s"] if forward or not yaw_rate else []
    if yaw_rate:
        parts.append(f"{yaw_rate:g} rad/s")
    return " and ".join(parts)


def _shown_commands(comparison: Comparison) -> dict[str, int]:
    """Motion -> index of the command that stands for it in figures and in the video."""
    shown = {motion: comparison.conditions(motion)[0] for motion in MOTIONS if comparison.conditions(motion)}
    if "forwards" in shown:
        shown["forwards"] = min(
            comparison.conditions("forwards"), key=lambda i: abs(comparison.commands[i][0] - _SHOWN_VELOCITY)
        )
    return shown


def _figures(subject: Subject, comparison: Comparison) -> list[dict[str, str]]:
    shown = _shown_commands(comparison)
    main = shown.get("forwards", 0)
    asked = _words(comparison.commands[main])
    figures = [
        (
            "Following the command",
            plots.tracking(comparison),
            "Mean velocity that each controller reaches, over the velocity that it is asked for. On the dashed line it "
            "does what it is told. Bars are 95 % confidence intervals; most are smaller than the marks.",
        )
    ]
    if shown.keys() & {"forwards", "turning"}:
        figures.append(
            (
                "Velocity over time",
                plots.velocity_over_time(comparison, shown.get("forwards"), shown.get("turning")),
                f"{_EPISODE} Strong lines are means over {WINDOW:g} s; the thin line is the policy's velocity itself, "
                f"with the swing of every stride.",
            )
        )
    figures += [
        (
            "Feet on the ground",
            plots.gait_diagram(comparison, main),
            f"A bar for every foot on the ground, asked for {asked}. L and R: left and right; F and H: front and hind.",
        ),
        (
            "Joints of the policy",
            plots.joint_traces(comparison, main),
            f"Position, speed and torque of the eight joints, asked for {asked}. Red lines are the robot's limits.",
        ),
    ]
    progress = None if subject.directory is None else subject.directory / PROGRESS_FILE
    if progress is not None and progress.is_file():
        columns = plots.read_progress(progress)
        if len(columns["timesteps"]) > 1 and any(name in columns for name, _ in plots.LEARNING_CURVES):
            figures.append(("Learning", plots.learning_curve(columns), "What the training measured on its way."))
    return [
        {"title": title, "source": _data_url("image/svg+xml", svg.encode()), "caption": caption}
        for title, svg, caption in figures
    ]


def filmed(comparison: Comparison) -> list[Motion]:
    """What the report's film shows: the policy under a command of each kind of motion."""
    rollout = comparison.rollouts["policy"]
    motions = []
    for motion in _FILMED:
        command = _shown_commands(comparison).get(motion)
        if command is not None:
            row = comparison.episode(command)
            alive = float(rollout.valid[:, row].sum()) * rollout.timestep
            start = max(0.0, min(START_UP, alive - CLIP_SECONDS))
            title = f"{motion}: {_words(comparison.commands[command])}"
            motions.append(Motion.of_rollout(rollout, row, title, start, start + CLIP_SECONDS))
    return motions


def _video(comparison: Comparison, progress: Progress | None) -> dict[str, str]:
    """The source of a video and its caption, or why it is missing."""
    motions = filmed(comparison)
    try:
        with Camera() as camera:
            video = encode_mp4(camera.films(motions, progress))
    except QuadrupedError as error:
        return {"missing": f"No video: {error}"}
    shown = ", then ".join(motion.title for motion in motions)
    caption = (
        f"The trained policy in real time. {shown[:1].upper()}{shown[1:]}. {_EPISODE} The black marks are what it is "
        f"asked for, the bars what it does, averaged over {AVERAGED:g} s; coloured bands are feet on the ground."
    )
    return {"source": _data_url("video/mp4", video), "caption": caption}


def _data_url(kind: str, content: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"
