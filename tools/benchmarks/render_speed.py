"""Rendering speed of films on one core: cost and visible effect of the shadow's resolution and of multisampling.

The chosen values are `SHADOW_SIZE` and `MULTISAMPLES` in `film.py`. The benchmark measures CPU time of all threads of
this process, pinned to one core, so that other work on the machine does not distort the result.
"""

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import GaitController
from quadruped_env.report.films.film import MULTISAMPLES, SHADOW_SIZE, Camera, Clip
from quadruped_env.report.films.video import encode_mp4

SHADOW_SIZES: Final = (0, 512, 1024, 2048, 4096)
MULTISAMPLINGS: Final = (0, 4)
GOAL: Final = 40.0
"""Target speed, pictures per second."""
_SECONDS: Final = 2.0
"""Length of the film for each measurement, s."""


@dataclass(frozen=True)
class RenderSpeed:
    """Rendering speed at one quality."""

    shadow_size: int
    multisamples: int
    rendering: float
    """Pictures per second, rendering only: the median over the film"""
    film: float
    """Pictures per second with overlays and H.264"""
    difference: float
    """Mean absolute difference from the best quality's pictures, in 255ths of a channel"""

    @property
    def chosen(self) -> bool:
        """True for the quality that films use."""
        return (self.shadow_size, self.multisamples) == (SHADOW_SIZE, MULTISAMPLES)


def stay_on_one_core() -> None:
    """Pin this process and its software renderer to one core. Call it before rendering."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])


def measure_rendering(say: Callable[[str], None]) -> list[RenderSpeed]:
    """Measure every quality, the best first; `say` receives a line of a Markdown table for each.

    Raises:
        QuadrupedError: if there is no OpenGL.
        MissingExtraError: if a library of the `report` extra is not installed.
    """
    rollout = roll_out(GaitController(), [(0.4, 0.0)], [FIRST_SEED], _SECONDS)
    walk = Clip.of_rollout(rollout, 0, "searched gait")
    say("| shadow | multisampling | rendering, pictures/s | film, pictures/s | difference | |")
    say("|---|---|---|---|---|---|")
    best, results = None, []
    for multisamples in reversed(MULTISAMPLINGS):
        for shadow_size in reversed(SHADOW_SIZES):
            with Camera(walk.trace.robot, shadow_size, multisamples) as camera:
                camera.picture(walk.trace, 0)
                times, pictures = [], []
                for sample in walk.frame_samples():
                    start = time.process_time()
                    pictures.append(camera.picture(walk.trace, sample))
                    times.append(time.process_time() - start)
                start = time.process_time()
                encode_mp4(camera.film([walk]))
                film = len(times) / (time.process_time() - start)
            shown = np.array(pictures, np.int16)
            best = shown if best is None else best
            difference = float(np.abs(shown - best).mean())
            result = RenderSpeed(shadow_size, multisamples, 1.0 / float(np.median(times)), film, difference)
            results.append(result)
            say(
                f"| {shadow_size or 'none'} | {multisamples or 'none'} | {result.rendering:.0f} | {film:.0f} | "
                f"{difference:.2f} | {'chosen' if result.chosen else ''} |"
            )
    return results
