"""Several policies beside each other: which one does what best, and a page that shows it."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation import plots
from quadruped_env.evaluation.comparison import MOTIONS, Comparison
from quadruped_env.evaluation.films.film import Motion
from quadruped_env.evaluation.pages.page import circumstances, figure, tables, without_nan, words, write_page
from quadruped_env.evaluation.pages.pictures import filmed, shown_commands, take_pictures
from quadruped_env.evaluation.pages.verdict import LEVEL, error_of, listed, verdict
from quadruped_env.evaluation.subject import Subject, find_subject, prepare
from quadruped_env.progress import Progress


def find_subjects(runs: Sequence[str], output: Path) -> dict[str, Subject]:
    """The policies that a person names, each once, by name.

    Raises:
        QuadrupedError: if there are fewer than two, two have the same name, or one is missing or damaged.
    """
    subjects: dict[str, Subject] = {}
    for run in runs:
        subject = find_subject(run, output)
        if subject.name in subjects:
            raise QuadrupedError(f"{run}: a policy called {subject.name!r} is named before; name each one once")
        subjects[subject.name] = subject
    if len(subjects) < 2:
        raise QuadrupedError(f"expected at least two runs to compare; found {len(subjects)}")
    return subjects


def best_at(comparison: Comparison, names: Sequence[str], motion: str) -> list[str]:
    """The policies that are closest to a motion's commands: the closest, and those that are as good as level with it.

    A policy is level where the paired difference is not clear of zero, or within `LEVEL`. Empty where all fall early.
    """
    metric = error_of(motion)
    means = {name: comparison.estimate(name, metric, motion).mean for name in names}
    known = [name for name in names if means[name] == means[name]]
    if not known:
        return []
    best = min(known, key=lambda name: means[name])

    def level(name: str) -> bool:
        difference = comparison.difference(metric, name, best, motion)
        return difference.mean <= LEVEL or difference.low <= 0.0

    return [name for name in known if name == best or level(name)]


def headline(comparison: Comparison, names: Sequence[str]) -> str:
    """Who is closest to the commands of which motions, and who falls more often than the steadiest, in a sentence."""
    leaders: dict[tuple[str, ...], list[str]] = {}
    for motion in MOTIONS:
        if comparison.conditions(motion):
            leaders.setdefault(tuple(best_at(comparison, names, motion)), []).append(motion)
    parts = []
    for best, motions in leaders.items():
        if len(best) == len(names):
            parts.append(f"all are level {listed(motions)}")
        elif best:
            parts.append(f"{listed(list(best))} {_agreed(best, 'is', 'are')} closest {listed(motions)}")
        else:
            parts.append(f"all fall too early to tell {listed(motions)}")
    falls = {name: comparison.estimate(name, "fall_rate") for name in names}
    # More often only where the intervals are apart.
    unsteady = [name for name in names if falls[name].low > min(fall.high for fall in falls.values())]
    if unsteady:
        parts.append(f"{listed(unsteady)} {_agreed(unsteady, 'falls', 'fall')} more often")
    sentence = "; ".join(parts)
    return f"{sentence[:1].upper()}{sentence[1:]}."


def _agreed(names: Sequence[str], one: str, many: str) -> str:
    return one if len(names) == 1 else many


def write_comparison(
    subjects: Mapping[str, Subject],
    comparison: Comparison,
    output: Path,
    command_line: str,
    with_video: bool = True,
    progress: Progress | None = None,
) -> tuple[Path, Path, list[str]]:
    """Write a page and its numbers into a directory; arguments and results as those of `report.write_report`.

    Raises:
        MissingExtraError, QuadrupedError: as `report.write_report`.
    """
    prepare(output)
    names = list(subjects)
    judged = {name: verdict(comparison.seen_as(name)) for name in names}
    head = headline(comparison, names)
    if with_video:
        shown = f"{', then '.join(names)}, each under the same commands"
        video = take_pictures(films(comparison, names), shown, progress=progress).video
    else:
        video = {"missing": "No video: it was not asked for."}
    document = {
        **circumstances(command_line),
        "headline": head,
        "policies": {
            name: {
                "card": without_nan(subject.policy.card),
                "verdict": {"level": judged[name].level, "headline": judged[name].headline},
            }
            for name, subject in subjects.items()
        },
        **comparison.to_dict(),
    }
    context: dict[str, Any] = {
        "names": names,
        "headline": head,
        "verdicts": judged,
        "video": video,
        "figures": _figures(subjects, comparison),
        **tables(comparison),
    }
    report, numbers = write_page(output, "comparison.html", document, context)
    return report, numbers, [video["missing"]] if with_video and "missing" in video else []


def films(comparison: Comparison, names: Sequence[str]) -> list[Motion]:
    """What the page's film shows: each policy in turn."""
    return [motion for name in names for motion in filmed(comparison, name)]


def _figures(subjects: Mapping[str, Subject], comparison: Comparison) -> list[dict[str, str]]:
    shown = shown_commands(comparison)
    main = shown.get("forwards", 0)
    figures = [
        figure(
            "Following the command",
            plots.tracking(comparison),
            "Mean velocity that each reaches, over the velocity that it is asked for. On the dashed line it does what "
            "it is told. Hollow marks are turns while walking. Bars are 95 % confidence intervals.",
        ),
        figure(
            "Cost of transport over speed",
            plots.cost_over_speed(comparison),
            "Energy that the motors put in, by weight and distance (left), and by time (right). Each mark is a "
            "command; hollow ones walk backwards.",
        ),
        figure(
            "Gait: which feet are on the ground",
            plots.gait_diagram(comparison, main),
            f"A bar for every foot on the ground, asked for {words(comparison.commands[main])}. L and R: left and "
            "right; F and H: front and hind.",
        ),
    ]
    curves = {
        name: plots.read_progress(subject.progress_file)
        for name, subject in subjects.items()
        if subject.progress_file is not None
    }
    if curves:
        figures.append(
            figure(
                "Learning curves",
                plots.learning_curve(curves),
                "What each training measured on its way, with its noise.",
            )
        )
    return figures
