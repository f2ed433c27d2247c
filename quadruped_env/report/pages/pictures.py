"""Films of a report."""

from collections.abc import Sequence
from typing import Final

from quadruped_env.evaluation.comparison import MOTIONS, Comparison, words
from quadruped_env.evaluation.measures import START_UP
from quadruped_env.evaluation.trace import Trace
from quadruped_env.report.films.film import Camera, Clip
from quadruped_env.report.films.overlay import AVERAGED
from quadruped_env.report.films.video import encode_mp4
from quadruped_env.report.pages.page import data_url
from quadruped_env.utils.progress import Progress

CLIP_SECONDS: Final = 2.4
OVERLAY_LEGEND: Final = (
    f"Green marks are commanded velocities, bars measured ones, averaged over {AVERAGED:g} s; coloured bands are feet "
    f"on the ground."
)
_FILMED_VELOCITIES: Final = (0.2, 0.5)
"""Forward velocities that are filmed, m/s; the closest commands are taken."""
_FILMED_TOO: Final = ("turning", "backwards")
_SHOWN_VELOCITY: Final = 0.4
"""Forward velocity of the episode that is plotted over time, m/s; the closest command is taken."""


def shown_commands(comparison: Comparison) -> dict[str, int]:
    """Motion -> index of the command that represents it in figures and films."""
    shown = {motion: comparison.conditions(motion)[0] for motion in MOTIONS if comparison.conditions(motion)}
    if "forwards" in shown:
        shown["forwards"] = _closest(comparison, _SHOWN_VELOCITY)
    return shown


def _closest(comparison: Comparison, velocity: float) -> int:
    """Index of the command to walk forwards that is closest to a velocity in m/s."""
    return min(comparison.conditions("forwards"), key=lambda i: abs(comparison.commands[i][0] - velocity))


def filmed(comparison: Comparison, controller: str = "policy") -> list[Clip]:
    """Clips of a report's film: a controller walking slowly and fast, turning and walking backwards."""
    commands = shown_commands(comparison)
    whose = "" if controller == "policy" else f"{controller}, "
    ahead = dict.fromkeys(_closest(comparison, v) for v in _FILMED_VELOCITIES) if "forwards" in commands else {}
    parts = [("forwards", command) for command in ahead]
    parts += [(motion, commands[motion]) for motion in _FILMED_TOO if motion in commands]
    parts = parts or list(commands.items())
    return [_episode(comparison, command, CLIP_SECONDS, controller, f"{whose}{what}: ") for what, command in parts]


def recorded(comparison: Comparison) -> Trace:
    """The episode of the policy that a report plots over time, until it ends or the robot falls."""
    command = next(iter(shown_commands(comparison).values()))
    rollout = comparison.rollouts["policy"].env(comparison.episode(command))
    return rollout.window(0, max(1, int(rollout.valid.sum())))


def _episode(comparison: Comparison, command: int, seconds: float, controller: str, title: str) -> Clip:
    """Part of the episode that represents a command, after the start-up and before a fall."""
    rollout, row = comparison.rollouts[controller], comparison.episode(command, controller)
    alive = float(rollout.valid[:, row].sum()) * rollout.timestep
    start = max(0.0, min(START_UP, alive - seconds))
    return Clip.of_rollout(rollout, row, title + words(comparison.commands[command]), start, start + seconds)


def film(clips: Sequence[Clip], note: str = "", progress: Progress | None = None) -> dict[str, str]:
    """`source` and `caption` of a film of clips, or the reason why it is `missing`; `note` follows their titles."""
    try:
        with Camera(clips[0].trace.robot) as camera:
            video = encode_mp4(camera.film(clips, progress))
    except Exception as error:  # a library for films may fail in any way, and the report stands without them
        return {"missing": f"No video: {error}"}
    shown = ", then ".join(clip.title for clip in clips)
    return {"source": data_url("video/mp4", video), "caption": f"In real time: {shown}{note}. {OVERLAY_LEGEND}"}
