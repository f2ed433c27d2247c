"""A recording made in the viewer, and the thread that saves it."""

import os
import queue
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, portable_message
from quadruped_env.evaluation.trace import Trace
from quadruped_env.reporting.films.film import Clip
from quadruped_env.reporting.films.video import save_film
from quadruped_env.utils.files import free_path
from quadruped_env.viewer.viewed_trace import ViewedTrace

MAX_SECONDS: Final = 300.0
"""Maximum duration of a take, s; a longer one ends automatically."""
MAX_WAITING: Final = 3
"""Maximum number of takes being saved, each in memory, before a new one is refused."""
MAX_TAKES: Final = 100
"""Maximum number of takes per show; each may use some megabytes on disk."""
_NICENESS: Final = 10
RESULTS: Final = Path("results")
TRAJECTORY_FILE: Final = "joint_states.csv"
VIDEO_FILE: Final = "video.mp4"


@dataclass
class Take:
    """The recorded samples of one robot."""

    title: str
    samples: list[ViewedTrace]
    """One or more"""
    follows_command: bool = True
    """False if the velocity command had no effect"""
    motion: bool = True
    """False if velocity and contacts are unknown"""

    @property
    def seconds(self) -> float:
        """Time from the first to the last sample, s."""
        return (len(self.samples) - 1) * self.samples[0].timestep

    def clip(self) -> Clip:
        """The take as a clip of a film, which shows the command if the robot follows it."""
        trace: Trace = ViewedTrace.stack(self.samples)
        unknown = (() if self.follows_command else ("command",)) + (() if self.motion else ("velocity", "contact"))
        if unknown:
            known = {name: getattr(trace, name) for name in Trace.quantities() if name not in unknown}
            trace = Trace(robot=trace.robot, timestep=trace.timestep, terrain=trace.terrain, **known)
        return Clip(self.title, trace)


class TakeSaver:
    """Saves takes one after the other in a thread, next to the running simulation.

    Args:
        results: parent of the takes' directories.
        tell: called from the saver's thread with a message for each saved or failed file.
    """

    def __init__(self, results: Path, tell: Callable[[str], None]) -> None:
        self._results = results
        self._tell = tell
        self._takes: queue.Queue[Take | None] = queue.Queue()
        self._count = 0
        # A daemon thread, so that the process can end without waiting for a long film.
        self._thread = threading.Thread(target=self._run, name="take saver", daemon=True)
        self._thread.start()

    @property
    def busy(self) -> bool:
        """True while a take is being saved."""
        return self._takes.unfinished_tasks > 0

    def check_room(self) -> None:
        """Raise a QuadrupedError if no further take may be started."""
        if self._takes.unfinished_tasks >= MAX_WAITING:
            raise QuadrupedError(f"record: {MAX_WAITING} recordings are still being saved; record again after them")
        if self._count >= MAX_TAKES:
            raise QuadrupedError(f"record: {MAX_TAKES} recordings were made; start the viewer again to make more")

    def save(self, take: Take) -> None:
        """Queue a take to be saved."""
        self._count += 1
        self._takes.put(take)

    def close(self) -> None:
        """Wait until everything is saved."""
        self._takes.put(None)
        self._thread.join()

    def _run(self) -> None:
        if sys.platform == "linux":
            # On Linux each thread has its own niceness: films yield to the show.
            os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), _NICENESS)
        while (take := self._takes.get()) is not None:
            directory = free_path(self._results / time.strftime("view-%Y%m%d-%H%M%S"))
            clip = take.clip()
            try:
                clip.trace.joints.save(directory / TRAJECTORY_FILE)
                self._tell(f"{take.seconds:.1f} s recorded: {directory / TRAJECTORY_FILE}")
                self._film(clip, directory / VIDEO_FILE)
            except (QuadrupedError, MissingExtraError, OSError) as error:
                self._tell(f"Not saved: {error}")
            self._takes.task_done()
        self._takes.task_done()

    def _film(self, clip: Clip, path: Path) -> None:
        try:
            save_film(path, [clip])
        except (QuadrupedError, MissingExtraError) as error:
            self._tell(f"No video: {portable_message(error)}")
        else:
            self._tell(f"Video: {path}")
