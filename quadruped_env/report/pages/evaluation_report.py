"""The report of an evaluation: a self-contained HTML file, and the numbers as JSON."""

import dataclasses
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.conditions import words
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.failures import Failure, worst_episodes
from quadruped_env.evaluation.learning_gain import LearningGain
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.report import plots
from quadruped_env.report.pages import page
from quadruped_env.report.pages.learning import gain_section, learning_clips, learning_curves
from quadruped_env.report.pages.page import METRICS_FILE
from quadruped_env.report.pages.pictures import film, filmed, shown_commands
from quadruped_env.report.pages.suite_section import section, summary, write_results
from quadruped_env.report.report_directory import prepare_output
from quadruped_env.utils.files import write_json
from quadruped_env.utils.progress import Progress, part_of


def write_report(
    evaluated: EvaluatedPolicy,
    comparison: Comparison,
    document: dict[str, Any],
    with_video: bool = True,
    progress: Progress | None = None,
    suite: Mapping[str, Any] | None = None,
    gain: LearningGain | None = None,
    walking_page: str | None = None,
) -> tuple[Path, list[str]]:
    """Write the report into the policy's output directory; an existing file is replaced.

    Args:
        evaluated: policy that was evaluated.
        comparison: results of the evaluation.
        document: what `write_numbers` returned.
        with_video: True to render a film, if OpenGL is available.
        progress: called with the fraction of the films that is rendered.
        suite: the policy's results of the suite; None: it was not run.
        gain: the policy against the zero action; None: it was not measured.
        walking_page: file next to the report in which the robot walks, to which the report links; None: there is none.

    Returns:
        The path of the report, and a message for each part that could not be made.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if a file cannot be written, or the run's learning curve cannot be read.
    """
    prepare_output(evaluated.output)
    # Rendering and encoding leave the interpreter to another thread, which draws the figures on another core.
    with ThreadPoolExecutor(1) as executor:
        drawn = executor.submit(_figures, evaluated, comparison, gain)
        failures = executor.submit(lambda: [_failure(comparison, failure) for failure in worst_episodes(comparison)])
        video, learning = {"missing": "No video: it was switched off."}, None
        if with_video:
            video = film(filmed(comparison), "", part_of(progress, 0.0, 0.7))
        if "source" in video:
            learning = _learning_film(evaluated, comparison, part_of(progress, 0.7, 1.0))
    context = {
        "name": evaluated.name,
        "verdict": verdict(comparison, gain),
        "video": video,
        "learning": None if gain is None else gain_section({evaluated.name: gain}),
        "learning_film": learning,
        "walking_page": walking_page,
        "figures": drawn.result(),
        "reward_terms": page.term_rows({evaluated.name: evaluated}, comparison, {evaluated.name: "policy"}),
        "suite": None if suite is None else section(suite),
        "failures": failures.result(),
        **page.tables(comparison),
    }
    report = page.write_report_page(evaluated.output, "report.html", document, context)
    return report, [video["missing"]] if with_video and "missing" in video else []


def write_numbers(
    evaluated: EvaluatedPolicy,
    comparison: Comparison,
    command_line: str,
    suite: Mapping[str, Any] | None = None,
    gain: LearningGain | None = None,
) -> dict[str, Any]:
    """Write the numbers of a report, and the suite's results; `command_line` reproduces them.

    Returns:
        The document that was written.

    Raises:
        QuadrupedError: if a file cannot be written.
    """
    document = {
        **page.provenance(command_line),
        "policy": {
            "name": evaluated.name,
            "card": page.without_nan(evaluated.policy.card),
            "task_file": page.task_of(evaluated),
        },
        "verdict": dataclasses.asdict(verdict(comparison, gain)),
        "learning": None if gain is None else gain.to_dict(),
        "worst_episodes": [page.without_nan(dataclasses.asdict(one)) for one in worst_episodes(comparison)],
        "suite": None if suite is None else summary(suite),
        "config": comparison.config.to_dict(),
        **comparison.to_dict(),
    }
    write_json(evaluated.output / METRICS_FILE, document)
    if suite is not None:
        write_results(evaluated, suite, command_line)
    return document


def _learning_film(evaluated: EvaluatedPolicy, comparison: Comparison, progress: Progress | None) -> dict[str, str]:
    """Source and caption of the film of a training."""
    try:
        clips = learning_clips(evaluated, comparison)
    except QuadrupedError as error:  # a damaged checkpoint
        return {"missing": f"No video: {error}"}
    return film(clips, "; the same start and command", progress)


def _failure(comparison: Comparison, failure: Failure) -> dict[str, Any]:
    return {
        "title": f"Command: {words(failure.command)}",
        "seed": failure.seed,
        "story": failure.story,
        "figure": page.data_url("image/svg+xml", plots.episode(comparison, "policy", failure.row).encode()),
    }


def _figures(evaluated: EvaluatedPolicy, comparison: Comparison, gain: LearningGain | None) -> list[dict[str, str]]:
    tracking, cost, gait = page.shared_figures(comparison, shown_commands(comparison).get("forwards", 0))
    return [
        tracking,
        *([gait, cost] if comparison.conditions("forwards") else [gait]),
        page.figure(
            "Torque and speed against the motors' limits",
            plots.motor_limits(comparison),
            f"The policy, all commands ({comparison.condition}): median (white), 95th percentile (bar) and maximum "
            f"(diamond) of each joint. A foot that hits the ground can turn a joint faster than its motor.",
        ),
        *learning_curves({evaluated.name: evaluated}, {} if gain is None else {evaluated.name: gain}),
    ]
