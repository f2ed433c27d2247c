"""Films, stills and the 3D replay of a report."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np

from quadruped_env.errors import MissingExtraError, QuadrupedError, portable_message
from quadruped_env.evaluation.comparison import MOTIONS, Comparison
from quadruped_env.evaluation.failures import Failure
from quadruped_env.evaluation.metrics import START_UP
from quadruped_env.progress import Progress
from quadruped_env.reporting.films.film import Camera, Clip, Picture
from quadruped_env.reporting.films.overlay import AVERAGED
from quadruped_env.reporting.films.video import encode_mp4, encode_webp, halved
from quadruped_env.reporting.pages.page import data_url, words
from quadruped_env.reporting.pages.scene import scene_html
from quadruped_env.trace import Trace

CLIP_SECONDS: Final = 2.4
SCENE_SECONDS: Final = 20.0
STILL_TIMES: Final = (-0.6, -0.3, 0.0)
"""Times of the stills relative to the failure, s."""
OVERLAY_LEGEND: Final = (
    f"Black marks are commanded velocities, bars measured ones, averaged over {AVERAGED:g} s; coloured bands are feet "
    f"on the ground."
)
_FILMED: Final = ("forwards", "turning", "backwards")
_SHOWN_VELOCITY: Final = 0.4
"""Forward velocity of the episode that is plotted over time and filmed, m/s; the closest command is taken."""
_STILL_CROP: Final = np.s_[20:440, 40:600]


@dataclass(frozen=True)
class Pictures:
    """Rendered film and stills, or the reason why they are missing."""

    video: dict[str, str]
    """`source` and `caption` of the film, or the reason why it is `missing`"""
    stills: dict[int, str] = field(default_factory=dict)
    """Index of an episode -> data URL of its stills"""


def shown_commands(comparison: Comparison) -> dict[str, int]:
    """Motion -> index of the command that represents it in figures and films."""
    shown = {motion: comparison.conditions(motion)[0] for motion in MOTIONS if comparison.conditions(motion)}
    if "forwards" in shown:
        shown["forwards"] = min(
            comparison.conditions("forwards"), key=lambda i: abs(comparison.commands[i][0] - _SHOWN_VELOCITY)
        )
    return shown


def filmed(comparison: Comparison, controller: str = "policy") -> list[Clip]:
    """Clips of a report's film: a controller under one command of each kind of motion."""
    commands = shown_commands(comparison)
    whose = "" if controller == "policy" else f"{controller}, "
    motions: list[str] = [motion for motion in _FILMED if motion in commands]
    motions = motions or list(commands)
    return [
        _episode(comparison, commands[motion], CLIP_SECONDS, controller, f"{whose}{motion}: ") for motion in motions
    ]


def _episode(comparison: Comparison, command: int, seconds: float, controller: str, title: str) -> Clip:
    """Part of the episode that represents a command, after the start-up and before a fall."""
    rollout, row = comparison.rollouts[controller], comparison.episode(command, controller)
    alive = float(rollout.valid[:, row].sum()) * rollout.timestep
    start = max(0.0, min(START_UP, alive - seconds))
    return Clip.of_rollout(rollout, row, title + words(comparison.commands[command]), start, start + seconds)


def take_pictures(
    clips: Sequence[Clip],
    shown: str,
    failures: Sequence[tuple[Trace, Failure]] = (),
    progress: Progress | None = None,
) -> Pictures:
    """Render a film of clips, which `shown` describes in the caption, and stills of failures, if OpenGL works."""
    try:
        with Camera(clips[0].trace.robot) as camera:
            video = encode_mp4(camera.films(clips, progress))
            stills = {failure.row: _stills(camera, trace, failure) for trace, failure in failures}
    except QuadrupedError as error:
        return Pictures({"missing": f"No video: {portable_message(error)}"})

    caption = f"In real time: {shown}. {OVERLAY_LEGEND}"
    return Pictures({"source": data_url("video/mp4", video), "caption": caption}, stills)


def _stills(camera: Camera, trace: Trace, failure: Failure) -> str:
    """Pictures at the times of `STILL_TIMES`, side by side at half size."""
    samples = [round((failure.moment + time) / trace.timestep) - 1 for time in STILL_TIMES]
    last = len(trace) - 1
    strip: list[Picture] = [halved(camera.picture(trace, min(max(s, 0), last))[_STILL_CROP]) for s in samples]
    return data_url("image/webp", encode_webp(np.concatenate(strip, axis=1)))


def scene(comparison: Comparison) -> dict[str, Any]:
    """The 3D replay of one episode and its caption, or the reason why it is missing."""
    commands = shown_commands(comparison)
    command = commands.get("forwards", next(iter(commands.values())))
    clip = _episode(comparison, command, SCENE_SECONDS, "policy", "")
    try:
        page = scene_html(clip)
    except MissingExtraError as error:
        return {"missing": f"No 3D replay: {portable_message(error)}"}
    return {"page": page, "caption": f"The trained policy. Command: {words(comparison.commands[command])}."}
