"""Gain of a training on a page: the table of policy and zero action, the line in the curve, and the film."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from quadruped_env.envs import MAX_EPISODE_STEPS
from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.conditions import Command, words
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.learning_gain import GAIN_HEADER, TABLE_NOTE, LearningGain, gain_rows, reward_in_words
from quadruped_env.evaluation.measures import START_UP
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import Controller, PolicyController, ZeroController, at_checkpoint
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.report import plots
from quadruped_env.report.films.film import Clip
from quadruped_env.report.pages.page import figure
from quadruped_env.task import TaskConfig
from quadruped_env.utils.documents import read_json

CLIP_SECONDS: Final = 3.0


def gain_section(gains: Mapping[str, LearningGain]) -> dict[str, Any]:
    """Template variables of the tables; `gains` are those of policies by name, one or more."""
    documents = {name: gain.to_dict() for name, gain in gains.items()}
    tables = [
        {"name": name, "rows": gain_rows(document), "reward": reward_in_words(document)}
        for name, document in documents.items()
    ]
    first = next(iter(gains.values()))
    motions = "" if first.comparison is None else f" Condition of the motions: {first.comparison.condition}."
    note = (
        f"The zero action is the stance, or the scripted gait under the policy. {TABLE_NOTE}{motions} The own task ran "
        f"for {first.episodes} episodes of {first.seconds:g} s with the same seeds; a robot that falls begins again. "
        f"95 % intervals are in brackets. A command is met if the mean velocities from {START_UP:g} s after its "
        f"beginning are within {first.tolerance[0]:g} m/s and {first.tolerance[1]:g} rad/s of it, and a command to "
        f"stand if the robot stands still, too."
    )
    return {"header": GAIN_HEADER, "tables": tables, "note": note}


def zero_return(gain: LearningGain, config: TaskConfig) -> float:
    """Return of an episode of the zero action, as the learning curve counts it."""
    return gain.zero.return_per_second.mean * MAX_EPISODE_STEPS * config.control_timestep


def learning_curves(policies: Mapping[str, EvaluatedPolicy], gains: Mapping[str, LearningGain]) -> list[dict[str, str]]:
    """Figures of the learning curves of the policies that have one: all together, and by reward term."""
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


def half_way(directory: Path, timesteps: int) -> tuple[Path, int] | None:
    """The checkpoint that is closest to half of the steps, and its steps; None if all are far from it.

    Args:
        directory: that of a run, or of its last checkpoint.
        timesteps: steps of the whole training.

    Raises:
        QuadrupedError: if the card of a checkpoint is damaged.
    """
    inside = directory.parent.name == CHECKPOINTS
    places = directory.parent.iterdir() if inside else (directory / CHECKPOINTS).glob("*")
    steps = {path: _steps_of(path) for path in places if (path / CARD_FILE).is_file()}
    known = [(path, count) for path, count in steps.items() if count and 2 * abs(2 * count - timesteps) <= timesteps]
    return min(known, key=lambda found: (abs(2 * found[1] - timesteps), found[1]), default=None)


def _steps_of(checkpoint: Path) -> int | None:
    """Steps of the training until a checkpoint; None if its card does not say."""
    document = read_json(checkpoint / CARD_FILE)
    card = document.get("card") if isinstance(document, dict) else None
    steps = card.get("timesteps") if isinstance(card, dict) else None
    return steps if type(steps) is int else None


def learning_clips(evaluated: EvaluatedPolicy, comparison: Comparison) -> list[Clip]:
    """Clips of a robot before, half way through and after its training, from one start and under one command.

    Before the training it has the zero action. Without a checkpoint, there is no clip of half the training.
    """
    policy = evaluated.policy
    stages: dict[str, Controller] = {"before (zero action)": ZeroController(policy.action_mode)}
    timesteps = policy.card.get("timesteps")
    checkpoint = half_way(evaluated.directory, timesteps) if isinstance(timesteps, int) else None
    if checkpoint is not None:
        path, steps = checkpoint
        stages[f"half way ({steps:,} steps)"] = PolicyController(at_checkpoint(policy, path))
    stages[f"after ({timesteps:,} steps)" if isinstance(timesteps, int) else "after"] = PolicyController(policy)
    command = _filmed_command(comparison)
    seconds = START_UP + CLIP_SECONDS
    return [
        Clip.of_rollout(
            roll_out(controller, [command], [FIRST_SEED], seconds, comparison.config),
            0,
            f"{stage}: {words(command)}",
            START_UP,
        )
        for stage, controller in stages.items()
    ]


def _filmed_command(comparison: Comparison) -> Command:
    """The first curve among the commands, on which a gait without learning is weakest, or the last command."""
    return next((command for command in comparison.commands if all(command)), comparison.commands[-1])
