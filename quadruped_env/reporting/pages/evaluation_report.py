"""The report of an evaluation: a self-contained HTML file, and the numbers as JSON."""

import dataclasses
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import Comparison, words
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.failures import Failure, worst_episodes
from quadruped_env.evaluation.learning_gain import LearningGain
from quadruped_env.evaluation.measures import WINDOW
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.reporting import plots
from quadruped_env.reporting.films.film import Clip
from quadruped_env.reporting.pages import page
from quadruped_env.reporting.pages.learning import ZERO_LINE, gain_section, learning_clips, zero_return
from quadruped_env.reporting.pages.page import METRICS_FILE
from quadruped_env.reporting.pages.pictures import Pictures, filmed, shown_commands, take_pictures
from quadruped_env.reporting.pages.suite_section import section, summary, write_results
from quadruped_env.reporting.report_directory import prepare_output
from quadruped_env.utils.files import write_json
from quadruped_env.utils.progress import Progress, part_of


def write_report(
    evaluated: EvaluatedPolicy,
    comparison: Comparison,
    command_line: str,
    with_video: bool = True,
    progress: Progress | None = None,
    suite: Mapping[str, Any] | None = None,
    gain: LearningGain | None = None,
    walking_page: str | None = None,
    document: dict[str, Any] | None = None,
) -> tuple[Path, Path, list[str]]:
    """Write the numbers and the report into the policy's output directory; existing files are replaced.

    Args:
        evaluated: policy that was evaluated.
        comparison: results of the evaluation.
        command_line: command that reproduces the report.
        with_video: True to render a film, if OpenGL is available.
        progress: called with the fraction of the films that is rendered.
        suite: the policy's results of the suite, which are written to a file of their own, too; None: it was not run.
        gain: the policy against the zero action; None: it was not measured.
        walking_page: file next to the report in which the robot walks, to which the report links; None: there is none.
        document: what `write_numbers` returned; None: they are written here, before the report.

    Returns:
        The paths of the report and of the numbers, and a message for each part that could not be made.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if a file cannot be written, or the run's learning curve cannot be read.
    """
    prepare_output(evaluated.output)
    document = document or write_numbers(evaluated, comparison, command_line, suite, gain)
    failures = worst_episodes(comparison)
    rollout = comparison.rollouts["policy"]
    # Rendering and encoding leave the interpreter to another thread, which draws the figures on another core.
    with ThreadPoolExecutor(1) as executor:
        drawn = executor.submit(_figures, evaluated, comparison, gain)
        of_failures = [executor.submit(plots.episode, comparison, "policy", failure.row) for failure in failures]
        if with_video:
            moments = [(Clip.of_rollout(rollout, failure.row, "").trace, failure) for failure in failures]
            clips = filmed(comparison)
            shown = ", then ".join(clip.title for clip in clips)
            pictures = take_pictures(clips, shown, moments, part_of(progress, 0.0, 0.7))
            learning = _learning_film(evaluated, comparison, part_of(progress, 0.7, 1.0)) if pictures.shown else None
        else:
            learning = None
            pictures = Pictures({"missing": "No video: it was switched off."})
    context = {
        "name": evaluated.name,
        "verdict": verdict(comparison, gain),
        "video": pictures.video,
        "learning": None if gain is None else gain_section({evaluated.name: gain}),
        "learning_film": learning,
        "walking_page": walking_page,
        "figures": drawn.result(),
        "suite": None if suite is None else section(suite),
        "failures": [_failure(f, pictures, svg.result()) for f, svg in zip(failures, of_failures, strict=True)],
        **page.tables(comparison),
    }
    report = page.write_report_page(evaluated.output, "report.html", document, context)
    missing = [pictures.video["missing"]] if with_video and "missing" in pictures.video else []
    return report, evaluated.output / METRICS_FILE, missing


def write_numbers(
    evaluated: EvaluatedPolicy,
    comparison: Comparison,
    command_line: str,
    suite: Mapping[str, Any] | None = None,
    gain: LearningGain | None = None,
) -> dict[str, Any]:
    """Write the numbers of a report, and the suite's results; arguments as in `write_report`.

    Returns:
        The document that was written.

    Raises:
        QuadrupedError: if a file cannot be written.
    """
    judged = verdict(comparison, gain)
    document = {
        **page.provenance(command_line),
        "policy": {
            "name": evaluated.name,
            "card": page.without_nan(evaluated.policy.card),
            "task_file": page.task_of(evaluated),
        },
        "verdict": dataclasses.asdict(judged),
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
    shown = ", then ".join(clip.title for clip in clips)
    return take_pictures(clips, f"{shown}; the same start and command", progress=progress).video


def _span(limits: NDArray[np.float64]) -> str:
    """The limits of all joints (J,) as text: one number, or their range."""
    low, high = limits.min(), limits.max()
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def _failure(failure: Failure, pictures: Pictures, svg: str) -> dict[str, Any]:
    return {
        "title": f"Command: {words(failure.command)}",
        "seed": failure.seed,
        "story": failure.story,
        "stills": pictures.stills.get(failure.row),
        "moment": failure.moment,
        "fell": failure.fell_at is not None,
        "figure": page.data_url("image/svg+xml", svg.encode()),
    }


def _figures(evaluated: EvaluatedPolicy, comparison: Comparison, gain: LearningGain | None) -> list[dict[str, str]]:
    shown = shown_commands(comparison)
    main, robot = shown.get("forwards", 0), comparison.robot
    command = words(comparison.commands[main])
    tracking, cost, gait = page.shared_figures(comparison, main)
    figures = [tracking]
    if shown.keys() & {"forwards", "turning"}:
        figures.append(
            page.figure(
                "Velocity over time",
                plots.velocity_over_time(comparison, shown.get("forwards"), shown.get("turning")),
                f"The episode is the first one without a fall, or else the longest. Thick lines are means over "
                f"{WINDOW:g} s; the thin line is the policy's instantaneous velocity, with the oscillation within each "
                f"stride.",
            )
        )
    figures += [gait, cost] if comparison.conditions("forwards") else [gait]
    figures += [
        page.figure(
            "Torque and speed against the motors' limits",
            plots.motor_limits(comparison),
            "The policy, all commands. Above: distribution of torque and speed. Red lines are the motor's limits; a "
            "foot that hits the ground can turn a joint faster. Below: median (white), 95th percentile (bar) and "
            f"maximum (diamond) of each joint, relative to {_span(robot.effort_limit)} N m and "
            f"{_span(robot.velocity_limit)} rad/s.",
        ),
        page.figure(
            "Joints over time",
            plots.joint_traces(comparison, main),
            f"Position, speed and torque of the policy's joints. Command: {command}. Red lines are the limits.",
        ),
        page.figure(
            "Reward terms",
            plots.reward_terms(comparison),
            "Weighted terms of the policy's reward, per second. Above: positive terms. Below, on separate scales: "
            "penalties. Marks show the same terms for the scripted gaits, which were not optimized for this reward. "
            "The searched gait steps with the reward's clock; the tutorial's gait does not.",
        ),
    ]
    if evaluated.progress_file is not None:
        columns = plots.read_progress(evaluated.progress_file)
        zero = {} if gain is None else {evaluated.name: zero_return(gain, evaluated.policy.config)}
        if len(columns["timesteps"]) > 1 and any(name in columns for name, _ in plots.LEARNING_CURVES):
            figures.append(
                page.figure(
                    "Learning curve",
                    plots.learning_curve({evaluated.name: columns}, zero),
                    f"Measured during training, with exploration noise.{' ' + ZERO_LINE if zero else ''}",
                )
            )
    return figures
