"""The report of an evaluation: one HTML file that needs nothing beside it, and the numbers as JSON."""

import dataclasses
from pathlib import Path
from typing import Any, Final

from quadruped_env.evaluation import plots
from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.films.film import Motion
from quadruped_env.evaluation.metrics import WINDOW
from quadruped_env.evaluation.pages.failures import Failure, worst_episodes
from quadruped_env.evaluation.pages.page import circumstances, data_url, figure, tables, without_nan, words, write_page
from quadruped_env.evaluation.pages.pictures import Pictures, filmed, scene, shown_commands, take_pictures
from quadruped_env.evaluation.pages.verdict import verdict
from quadruped_env.evaluation.subject import Subject, prepare
from quadruped_env.progress import Progress
from quadruped_env.robot import EFFORT_LIMIT, VELOCITY_LIMIT

_EPISODE: Final = "Shown is the first episode without a fall, or else the longest."


def write_report(
    subject: Subject,
    comparison: Comparison,
    command_line: str,
    with_video: bool = True,
    progress: Progress | None = None,
) -> tuple[Path, Path, list[str]]:
    """Write the report and the numbers into the subject's output directory, over those of an earlier evaluation.

    Args:
        subject: what was evaluated.
        comparison: what came out.
        command_line: what a person types to repeat it.
        with_video: whether to film it, if there is OpenGL.
        progress: is told how far the filming is.

    Returns:
        The paths of the report and of the numbers, and a message for each part that could not be made.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if a file cannot be written, or the run's learning curve cannot be read.
    """
    prepare(subject.output)
    failures = worst_episodes(comparison)
    rollout = comparison.rollouts["policy"]
    if with_video:
        moments = [(Motion.of_rollout(rollout, failure.row, ""), failure) for failure in failures]
        motions = filmed(comparison)
        pictures = take_pictures(motions, ", then ".join(motion.title for motion in motions), moments, progress)
    else:
        pictures = Pictures({"missing": "No video: it was not asked for."})
    replay = scene(comparison)
    judged = verdict(comparison)
    document = {
        **circumstances(command_line),
        "policy": {"name": subject.name, "card": without_nan(subject.policy.card)},
        "verdict": {"level": judged.level, "headline": judged.headline, "findings": dict(judged.findings)},
        "worst_episodes": [without_nan(dataclasses.asdict(failure)) for failure in failures],
        "config": comparison.config.to_dict(),
        **comparison.to_dict(),
    }
    context = {
        "name": subject.name,
        "verdict": judged,
        "video": pictures.video,
        "scene": replay,
        "figures": _figures(subject, comparison),
        "failures": [_failure(comparison, failure, pictures) for failure in failures],
        **tables(comparison),
    }
    report, numbers = write_page(subject.output, "report.html", document, context)
    missing = [part["missing"] for part in (pictures.video, replay) if "missing" in part]
    return report, numbers, missing if with_video else missing[1:]


def _failure(comparison: Comparison, failure: Failure, pictures: Pictures) -> dict[str, Any]:
    return {
        "title": f"Asked {'for' if any(failure.command) else 'to'} {words(failure.command)}",
        "seed": failure.seed,
        "story": failure.story,
        "stills": pictures.stills.get(failure.row),
        "moment": failure.moment,
        "fell": failure.fell_at is not None,
        "figure": data_url("image/svg+xml", plots.episode(comparison, "policy", failure.row).encode()),
    }


def _figures(subject: Subject, comparison: Comparison) -> list[dict[str, str]]:
    shown = shown_commands(comparison)
    main = shown.get("forwards", 0)
    asked = words(comparison.commands[main])
    figures = [
        figure(
            "Following the command",
            plots.tracking(comparison),
            "Mean velocity that each controller reaches, over the velocity that it is asked for. On the dashed line it "
            "does what it is told. Hollow marks are turns while walking. Bars are 95 % confidence intervals; most are "
            "smaller than the marks.",
        )
    ]
    if shown.keys() & {"forwards", "turning"}:
        figures.append(
            figure(
                "Velocity over time",
                plots.velocity_over_time(comparison, shown.get("forwards"), shown.get("turning")),
                f"{_EPISODE} Strong lines are means over {WINDOW:g} s; the thin line is the policy's velocity itself, "
                f"with the swing of every stride.",
            )
        )
    figures.append(
        figure(
            "Gait: which feet are on the ground",
            plots.gait_diagram(comparison, main),
            f"A bar for every foot on the ground, asked for {asked}. L and R: left and right; F and H: front and hind.",
        )
    )
    if comparison.conditions("forwards"):
        figures.append(
            figure(
                "Cost of transport over speed",
                plots.cost_over_speed(comparison),
                "Energy that the motors put in, by weight and distance (left), and by time (right). Each mark is a "
                "command; hollow ones walk backwards. Who travels under 0.05 m/s has no cost of transport.",
            )
        )
    figures += [
        figure(
            "Torque and speed against the motors' limits",
            plots.motor_limits(comparison),
            "The policy, all commands. Above: how often a motor gives which torque at which speed. Red is all that "
            "the motor can; a foot that hits the ground can turn a joint faster. Below: what each joint stays under in "
            "half of the time (white), in 95 % (bar) and always (diamond), as a share of "
            f"{EFFORT_LIMIT:g} N m and {VELOCITY_LIMIT:g} rad/s.",
        ),
        figure(
            "Joints over time",
            plots.joint_traces(comparison, main),
            f"Position, speed and torque of the policy's eight joints, asked for {asked}. Red lines are the limits.",
        ),
        figure(
            "Foot clearance and slip",
            plots.feet(comparison, main),
            f"Asked for {asked}. Above: how high the policy lifts its feet. Below: the height that a sole exceeds in "
            f"5 % of the time, and how fast it slides while it is on the ground.",
        ),
        figure(
            "Reward terms",
            plots.reward_terms(comparison),
            "What each weighted term of the policy's reward comes to in a second: above those that pay, below, on "
            "scales of their own, those that cost. The scripted gaits (marks) were not made for this reward; they show "
            "what it would have paid them.",
        ),
    ]
    if subject.progress_file is not None:
        columns = plots.read_progress(subject.progress_file)
        if len(columns["timesteps"]) > 1 and any(name in columns for name, _ in plots.LEARNING_CURVES):
            figures.append(
                figure(
                    "Learning curve",
                    plots.learning_curve({subject.name: columns}),
                    "What the training measured on its way, with the noise that it explores with.",
                )
            )
    return figures
