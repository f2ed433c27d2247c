"""A recording made in the viewer, and the thread that saves it."""

import queue
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.evaluation.trace import Trace
from quadruped_env.report.films.film import Clip
from quadruped_env.report.films.video import save_film
from quadruped_env.utils.files import free_path
from quadruped_env.viewer.viewed_robot import ViewedTrace

MAX_SECONDS: Final = 300.0
"""Maximum duration of a recording, s; a longer one ends automatically."""
RESULTS: Final = Path("results")
TRAJECTORY_FILE: Final = "joint_states.csv"
VIDEO_FILE: Final = "video.mp4"


@dataclass
class ViewerRecording:
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
        """Return the recording as a clip of a film, which shows the command if the robot follows it."""
        trace: Trace = ViewedTrace.stack(self.samples)
        unknown = (() if self.follows_command else ("command",)) + (() if self.motion else ("velocity", "contact"))
        if unknown:
            known = {one.name: getattr(trace, one.name) for one in fields(Trace) if one.name not in unknown}
            trace = Trace(**known)
        return Clip(self.title, trace)


class RecordingSaver:
    """Saves recordings one after the other in a thread, below a directory, and tells what was saved or failed."""

    def __init__(self, results: Path, tell: Callable[[str], None]) -> None:
        self._results = results
        self._tell = tell
        self._queue: queue.Queue[ViewerRecording | None] = queue.Queue()
        # A daemon thread, so that the process can end without waiting for a long film.
        self._thread = threading.Thread(target=self._run, name="recording saver", daemon=True)
        self._thread.start()

    @property
    def busy(self) -> bool:
        """True while a recording is being saved."""
        return self._queue.unfinished_tasks > 0

    def save(self, recording: ViewerRecording) -> None:
        """Queue a recording to be saved."""
        self._queue.put(recording)

    def close(self) -> None:
        """Wait until everything is saved."""
        self._queue.put(None)
        self._thread.join()

    def _run(self) -> None:
        while (recording := self._queue.get()) is not None:
            directory = free_path(self._results / time.strftime("view-%Y%m%d-%H%M%S"))
            clip = recording.clip()
            try:
                clip.trace.joints.save(directory / TRAJECTORY_FILE)
                self._tell(f"{recording.seconds:.1f} s recorded: {directory / TRAJECTORY_FILE}")
                save_film(directory / VIDEO_FILE, [clip])
                self._tell(f"Video: {directory / VIDEO_FILE}")
            except (QuadrupedError, MissingExtraError, OSError) as error:
                what = "No video" if (directory / TRAJECTORY_FILE).exists() else "Not saved"
                self._tell(f"{what}: {error}")
            self._queue.task_done()
        self._queue.task_done()
