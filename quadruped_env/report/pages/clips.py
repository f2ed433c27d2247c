"""Clips of a report's films: the robot under several commands, and before, during and after its training."""

from collections.abc import Sequence
from pathlib import Path
from typing import Final

from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.conditions import words
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.measures import START_UP
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.evaluation.trace import Trace
from quadruped_env.policies import Controller, PolicyController, ZeroController, at_checkpoint
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.report.films.film import Camera, Clip
from quadruped_env.report.films.overlay import AVERAGED
from quadruped_env.report.films.video import encode_mp4
from quadruped_env.report.pages.page import data_url
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.progress import Progress

CLIP_SECONDS: Final = 2.4
_LEARNING_SECONDS: Final = 3.0
"""Length of a clip of a stage of the training, s."""
_FILMED_VELOCITIES: Final = (0.2, 0.5)
"""Forward velocities that are filmed, m/s; the closest commands are taken."""
_FILMED_TOO: Final = ("turning", "backwards", "sideways")
_SHOWN_VELOCITY: Final = 0.4
"""Forward velocity of the episode that is plotted over time, m/s; the closest command is taken."""


def shown_commands(comparison: Comparison) -> dict[str, int]:
    """Return motion -> index of the command that represents it in figures and films."""
    shown = {motion: comparison.conditions(motion)[0] for motion in comparison.motions}
    if "forwards" in shown:
        shown["forwards"] = _closest(comparison, _SHOWN_VELOCITY)
    return shown


def _closest(comparison: Comparison, velocity: float) -> int:
    """Return the index of the command to walk forwards that is closest to a velocity in m/s."""
    return min(comparison.conditions("forwards"), key=lambda i: abs(comparison.commands[i][0] - velocity))


def filmed(comparison: Comparison) -> list[Clip]:
    """Return the clips of a report's film: the policy walks slowly, fast, in turns, backwards and sideways."""
    commands, rollout = shown_commands(comparison), comparison.rollouts["policy"]
    ahead = dict.fromkeys(_closest(comparison, v) for v in _FILMED_VELOCITIES) if "forwards" in commands else {}
    parts = [("forwards", command) for command in ahead]
    parts += [(motion, commands[motion]) for motion in _FILMED_TOO if motion in commands]
    clips = []
    for motion, command in parts or commands.items():
        # After the start-up, and before a fall.
        row = comparison.episode(command)
        alive = float(rollout.valid[:, row].sum()) * rollout.timestep
        start = max(0.0, min(START_UP, alive - CLIP_SECONDS))
        title = f"{motion}: {words(comparison.commands[command])}"
        clips.append(Clip.of_rollout(rollout, row, title, start, start + CLIP_SECONDS))
    return clips


def recorded(comparison: Comparison) -> Trace:
    """Return the policy's episode under the command that stands for all, until it ends or the robot falls."""
    command = next(iter(shown_commands(comparison).values()))
    rollout = comparison.rollouts["policy"].env(comparison.episode(command))
    return rollout.window(0, max(1, int(rollout.valid.sum())))


def half_way(directory: Path, timesteps: int) -> tuple[Path, int] | None:
    """Return the checkpoint that is closest to half of the steps, and its steps; None if all are far from it.

    Args:
        directory: the run's directory, or the one of its last checkpoint.
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
    """Return the steps of the training until a checkpoint; None if its card does not say."""
    document = read_json(checkpoint / CARD_FILE)
    card = document.get("card") if isinstance(document, dict) else None
    steps = card.get("timesteps") if isinstance(card, dict) else None
    return steps if type(steps) is int else None


def learning_clips(evaluated: EvaluatedPolicy, comparison: Comparison) -> list[Clip]:
    """Return clips of a robot before, half way through and after its training, from one start and under one command.

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
    # The first curve among the commands, on which a gait without learning is weakest, or the last command.
    command = next((command for command in comparison.commands if all(command[:2])), comparison.commands[-1])
    seconds = START_UP + _LEARNING_SECONDS
    return [
        Clip.of_rollout(
            roll_out(controller, [command], [FIRST_SEED], seconds, comparison.config),
            0,
            f"{stage}: {words(command)}",
            START_UP,
        )
        for stage, controller in stages.items()
    ]


def film(clips: Sequence[Clip], progress: Progress | None = None) -> dict[str, str]:
    """Return `source` and `caption` of a film of clips, or the reason why it is `missing`."""
    try:
        with Camera(clips[0].trace.robot) as camera:
            video = encode_mp4(camera.film(clips, progress))
    except Exception as error:  # a library for films may fail in any way, and the report stands without them
        return {"missing": f"No video: {error}"}
    caption = (
        f"In real time: {', then '.join(clip.title for clip in clips)}. Green marks are commanded velocities, bars "
        f"measured ones, averaged over {AVERAGED:g} s; coloured bands are feet on the ground."
    )
    return {"source": data_url("video/mp4", video), "caption": caption}
