"""How fast films are made, on one core: what the size of the shadow and the multisampling cost, and what they change.

The choice is `SHADOW_SIZE` and `MULTISAMPLES` in `film.py`. Counted is the processor's time, of all threads of this
process on its one core: alone on the machine it is the time that passes, and beside other work it still is what the
film costs.
"""

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import CommandedGaitController
from quadruped_env.reporting.films.film import MULTISAMPLES, SHADOW_SIZE, Camera, Motion
from quadruped_env.reporting.films.video import encode_mp4

SHADOW_SIZES: Final = (0, 512, 1024, 2048, 4096)
MULTISAMPLINGS: Final = (0, 4)
GOAL: Final = 40.0
"""Pictures a second"""
_SECONDS: Final = 2.0
"""s of film for each measurement"""


@dataclass(frozen=True)
class RenderSpeed:
    """What one quality costs."""

    shadow_size: int
    multisamples: int
    rendering: float
    """Pictures a second, rendering alone: the median over the film"""
    film: float
    """Pictures a second with overlays and H.264"""
    difference: float
    """Mean absolute difference from the best quality's pictures, in 255ths of a channel"""

    @property
    def chosen(self) -> bool:
        """Whether films are made like this."""
        return (self.shadow_size, self.multisamples) == (SHADOW_SIZE, MULTISAMPLES)


def stay_on_one_core() -> None:
    """Keep this process, and the software renderer that it starts, on one core; to be called before rendering."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])


def measure_rendering(say: Callable[[str], None]) -> list[RenderSpeed]:
    """Every quality, the best first; a line of a Markdown table for each is said as it comes.

    Raises:
        QuadrupedError: if there is no OpenGL.
        MissingExtraError: if a library of the `report` extra is not installed.
    """
    rollout = roll_out(CommandedGaitController(), [(0.4, 0.0)], [FIRST_SEED], _SECONDS)
    walk = Motion.of_rollout(rollout, 0, "tuned gait")
    say("| shadow | multisampling | rendering, pictures/s | film, pictures/s | difference | |")
    say("|---|---|---|---|---|---|")
    best, results = None, []
    for multisamples in reversed(MULTISAMPLINGS):
        for shadow_size in reversed(SHADOW_SIZES):
            with Camera(shadow_size, multisamples) as camera:
                camera.picture(walk, 0)
                times, pictures = [], []
                for sample in walk.frame_samples():
                    start = time.process_time()
                    pictures.append(camera.picture(walk, sample))
                    times.append(time.process_time() - start)
                start = time.process_time()
                encode_mp4(camera.film(walk))
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
