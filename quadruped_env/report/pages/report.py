"""The report of an evaluation or a comparison: a self-contained HTML file of one or several policies, and its numbers.

Policies have the names of their controllers in the comparison: a single one is called `policy`.
"""

import dataclasses
import difflib
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.envs import MAX_EPISODE_STEPS
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.conditions import words
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.learning_gain import LearningGain, table_note
from quadruped_env.evaluation.measures import START_UP, WINDOW, metrics_of
from quadruped_env.evaluation.verdict import listed, verdict, worst_episodes
from quadruped_env.gait import fitness
from quadruped_env.policies import task_note
from quadruped_env.report import plots
from quadruped_env.report.pages import clips, suite_section
from quadruped_env.report.pages.page import METRICS_FILE, data_url, figure, provenance, without_nan, write_html
from quadruped_env.report.pages.run_comparison import headline
from quadruped_env.report.pages.tables import gain_tables, metric_tables, reward_terms, terms_table
from quadruped_env.report.plots.canvas import label
from quadruped_env.report.report_directory import REPORT_FILE, prepare_output
from quadruped_env.robot import Robot
from quadruped_env.task import TaskConfig
from quadruped_env.utils.files import write_json
from quadruped_env.utils.progress import Progress, part_of

Policies = Mapping[str, EvaluatedPolicy]
Gains = Mapping[str, LearningGain]


def write_numbers(
    evaluated: EvaluatedPolicy,
    comparison: Comparison,
    command_line: str,
    suite: Mapping[str, Any] | None = None,
    gain: LearningGain | None = None,
) -> dict[str, Any]:
    """Write the numbers of an evaluation, and the suite's results; `command_line` reproduces them.

    Returns:
        The document that was written.

    Raises:
        QuadrupedError: if a file cannot be written.
    """
    document = {
        **provenance(command_line),
        "policy": {"name": evaluated.name, **_origin(evaluated)},
        "verdict": dataclasses.asdict(verdict(comparison, gain)),
        "learning": None if gain is None else gain.to_dict(),
        "worst_episodes": [without_nan(dataclasses.asdict(one)) for one in worst_episodes(comparison)],
        "suite": None if suite is None else suite_section.summary(suite),
        "config": comparison.config.to_dict(),
        **comparison.to_dict(),
    }
    write_json(evaluated.output / METRICS_FILE, document)
    if suite is not None:
        suite_section.write_results(evaluated, suite, command_line)
    return document


def write_comparison_numbers(
    policies: Policies,
    comparison: Comparison,
    output: Path,
    command_line: str,
    ranking: Mapping[str, Any] | None = None,
    gains: Gains | None = None,
) -> dict[str, Any]:
    """Write the numbers of a comparison into a directory, and return their document.

    `ranking` is the one on the suite, from `suite_section.ranking`; None: there is none. `gains` are the policies
    against their zero actions, by name; None: they were not measured.

    Raises:
        MissingExtraError, QuadrupedError: as `write_report`.
    """
    prepare_output(output)
    terms = reward_terms(policies, comparison)
    document = {
        **provenance(command_line),
        "headline": headline(comparison, list(policies)),
        "suite": ranking,
        "policies": {
            name: {
                **_origin(evaluated),
                "reward_terms": without_nan(terms[name]),
                "verdict": dataclasses.asdict(verdict(comparison.seen_as(name))),
                "learning": gains[name].to_dict() if gains else None,
            }
            for name, evaluated in policies.items()
        },
        **comparison.to_dict(),
    }
    write_json(output / METRICS_FILE, document)
    return document


def _origin(evaluated: EvaluatedPolicy) -> dict[str, Any]:
    """Return a policy's card, and its task file: name, hash, text and differences of the task here; None without."""
    file, card = evaluated.task_file, without_nan(evaluated.policy.card)
    if file is None:
        return {"card": card, "task_file": None}
    text = file.content.decode(errors="replace")
    return {"card": card, "task_file": {**file.to_dict(), "text": text, "differences": task_note(evaluated.policy)}}


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
        drawn = executor.submit(lambda: _single(evaluated, comparison, suite, gain))
        video, learning = {"missing": "No video: it was switched off."}, None
        if with_video:
            video = clips.film(clips.filmed(comparison), part_of(progress, 0.0, 0.7))
        if "source" in video:
            learning = _learning_film(evaluated, comparison, part_of(progress, 0.7, 1.0))
    context = {**drawn.result(), "video": video, "learning_film": learning, "walking_page": walking_page}
    write_html(evaluated.output / REPORT_FILE, "report.html", {"document": document, **context})
    return evaluated.output / REPORT_FILE, [video["missing"]] if with_video and "missing" in video else []


def _single(
    evaluated: EvaluatedPolicy, comparison: Comparison, suite: Mapping[str, Any] | None, gain: LearningGain | None
) -> dict[str, Any]:
    """Return the template variables of the report of one policy, but for its films."""
    judged = verdict(comparison, gain)
    return {
        **_context({"policy": evaluated}, comparison, {} if gain is None else {"policy": gain}),
        "title": f"{evaluated.name}: evaluation",
        "question": f"Does the trained policy {evaluated.name} walk?",
        "level": judged.level,
        "headline": judged.headline,
        "suite": None if suite is None else suite_section.section(suite),
        "failures": [
            {
                "title": f"Command: {words(failure.command)}",
                "seed": failure.seed,
                "story": failure.story,
                "figure": data_url("image/svg+xml", plots.episode(comparison, "policy", failure.row).encode()),
            }
            for failure in worst_episodes(comparison)
        ],
    }


def write_comparison(
    policies: Policies,
    comparison: Comparison,
    output: Path,
    document: dict[str, Any],
    ranking: Mapping[str, Any] | None = None,
    gains: Gains | None = None,
) -> Path:
    """Write the report of several policies, whose numbers are in `document`, and return its path.

    The other arguments are as in `write_comparison_numbers`.
    """
    gains = gains or {}
    judged = {name: verdict(comparison.seen_as(name)).headline for name in policies}
    own = {name: f" In its own task, it {gain.verdict()}." for name, gain in gains.items()}
    context: dict[str, Any] = {
        **_context(policies, comparison, gains),
        "title": f"{' and '.join(policies)}: comparison",
        "question": f"Which of {len(policies)} trained policies is the best?",
        "level": "good",
        "headline": headline(comparison, list(policies)),
        "verdicts": {name: sentence + own.get(name, "") for name, sentence in judged.items()},
        "ranking": None if ranking is None else suite_section.ranking_table(ranking),
        "diffs": _diffs(policies),
    }
    write_html(output / REPORT_FILE, "report.html", {"document": document, **context})
    return output / REPORT_FILE


def _context(policies: Policies, comparison: Comparison, gains: Gains) -> dict[str, Any]:
    """Return the template variables of what all reports have."""
    summary, *motions = metric_tables(comparison)
    return {
        "policies": {label(name): {"name": one.name, **_origin(one)} for name, one in policies.items()},
        "robot": _description(comparison.config),
        "learning": gain_tables(gains),
        "learning_note": _gain_note(next(iter(gains.values()))) if gains else "",
        "summary": summary,
        "motions": motions,
        "terms": terms_table(policies, comparison),
        "figures": _figures(policies, comparison) + _learning_curves(policies, gains),
        "metrics": metrics_of(comparison.robot),
        "velocities": _velocities(comparison.robot),
        "plotted": _velocities(comparison.robot, "tilt").capitalize(),
        "start_up": START_UP,
        "window": WINDOW,
        "config": comparison.config.to_dict(),
        **dict.fromkeys(("verdicts", "ranking", "video", "suite", "failures", "diffs")),
    }


def _velocities(robot: Robot, *more: str) -> str:
    """Return the names of a robot's `velocity_commands`, and further ones, in words."""
    return listed([*(entry.name.replace("_", " ") for entry in velocity_commands(robot)), *more])


def _description(config: TaskConfig) -> str:
    """Return a sentence that introduces the robot of a task."""
    robot, weak = config.robot, "; ".join(fitness(config.robot, config.clock_frequency, config.motor))
    return (
        f"A robot with {robot.num_legs} legs and {robot.num_joints} motors, of {robot.total_mass:.3g} kg and with its "
        f"base {100.0 * robot.stance_height:.0f} cm above the ground, walks in a physics simulation (MuJoCo) and "
        f"follows commands of {_velocities(robot)}." + (f" For a trot it lacks: {weak}." if weak else "")
    )


def _gain_note(gain: LearningGain) -> str:
    """Return what the tables of the gain show, and under which condition."""
    motions = "" if gain.comparison is None else f" Condition of the motions: {gain.comparison.condition}."
    return (
        f"The zero action is the stance, or the scripted gait under the policy. {table_note(gain.to_dict())}{motions} "
        f"The own task ran for {gain.episodes} episodes of {gain.seconds:g} s with the same seeds; a robot that falls "
        f"begins again. 95 % intervals are in brackets. A command is met if the mean velocities from {START_UP:g} s "
        f"after its beginning are within {gain.tolerance[0]:g} m/s and {gain.tolerance[1]:g} rad/s of it, and a "
        f"command to stand if the robot stands still, too."
    )


def _figures(policies: Policies, comparison: Comparison) -> list[dict[str, str]]:
    """Return the figures of all controllers, and for a single policy its motors."""
    names = comparison.robot.leg_names
    known = all(len(name) == 2 and name[0] in "LR" and name[1] in "FH" for name in names)
    legs = " L and R: left and right; F and H: front and hind." if known else ""
    command = clips.shown_commands(comparison).get("forwards", 0)
    figures = [
        figure(
            "Following the command",
            plots.tracking(comparison),
            "Mean velocity that each controller reaches, over the commanded velocity. On the dashed line the two are "
            "equal. Hollow marks are turns while walking. Bars are 95 % confidence intervals; most are smaller than "
            "the marks.",
        ),
        figure(
            "Gait: which feet are on the ground",
            plots.gait_diagram(comparison, command),
            f"Bars show when a foot is on the ground. Command: {words(comparison.commands[command])}.{legs}",
        ),
    ]
    if comparison.conditions("forwards"):
        cost = plots.cost_over_speed(comparison)
        text = (
            "Energy of the motors per weight and distance (left), and per time (right). Above: electrical, that is "
            "mechanical energy and heat in the windings; below: mechanical. Each mark is a command; hollow marks are "
            "backwards. Below 0.05 m/s the cost of transport is undefined."
        )
        figures.append(figure("Cost of transport over speed", cost, text))
    if len(policies) == 1:
        text = (
            f"The policy, all commands ({comparison.condition}): median (white), 95th percentile (bar) and maximum "
            f"(diamond) of each joint. A foot that hits the ground can turn a joint faster than its motor."
        )
        figures.append(figure("Torque and speed against the motors' limits", plots.motor_limits(comparison), text))
    return figures


def _learning_curves(policies: Policies, gains: Gains) -> list[dict[str, str]]:
    """Return figures of the learning curves of the policies that have one: all together, and by reward term."""
    curves = {
        name: columns
        for name, evaluated in policies.items()
        if evaluated.progress_file is not None
        and len((columns := plots.read_progress(evaluated.progress_file))["timesteps"]) > 1
        and any(quantity in columns for quantity, _ in plots.LEARNING_CURVES)
    }
    if not curves:
        return []
    zero = {name: zero_return(gains[name], policies[name].policy.config) for name in curves if name in gains}
    line = " The dashed line is the return of the zero action, without learning." if zero else ""
    caption = f"Measured during training, with exploration noise.{line}"
    figures = [figure("Learning curve", plots.learning_curve(curves, zero), caption)]
    if len(policies) > 1 and (by_term := plots.term_curves(curves)) is not None:
        note = "Weighted terms of the reward per second, each with the weight of its run, during training."
        figures.append(figure("Learning curves by reward term", by_term, note))
    return figures


def zero_return(gain: LearningGain, config: TaskConfig) -> float:
    """Return what an episode of the zero action returns, as the learning curve counts it."""
    return gain.zero.return_per_second.mean * MAX_EPISODE_STEPS * config.control_timestep


def _learning_film(evaluated: EvaluatedPolicy, comparison: Comparison, progress: Progress | None) -> dict[str, str]:
    """Return source and caption of the film of a training."""
    try:
        return clips.film(clips.learning_clips(evaluated, comparison), progress)
    except QuadrupedError as error:  # a damaged checkpoint
        return {"missing": f"No video: {error}"}


def _diffs(policies: Policies) -> list[dict[str, str]]:
    """Return unified differences of the task files that the runs keep, each from the first such run's file."""
    texts: dict[str, Sequence[str]] = {
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
