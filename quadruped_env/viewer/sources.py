"""What can drive a robot in the viewer: policies, scripted gaits, recordings, each under a name."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import PRESETS
from quadruped_env.policies import (
    Controller,
    Policy,
    PolicyController,
    TrajectoryController,
    ZeroController,
    load_policy,
)
from quadruped_env.policies.policy import CARD_FILE, SHIPPED, training_advice
from quadruped_env.task import Task, TaskConfig, Transition
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.viewer.gaits import EditableGaitController
from quadruped_env.viewer.paths import shown_path

RUNS: Final = Path("runs")
MAX_RUNS: Final = 12
"""of the latest ones, that are offered without being asked for"""
BAG_FILE: Final = "metadata.yaml"
"""What makes a directory a ROS 2 bag"""
STANDING: Final = "stand still"


@dataclass(frozen=True)
class Source:
    """A controller by name, and the task that it runs on."""

    name: str
    make: Callable[[], tuple[Controller, TaskConfig]]
    """Raises a QuadrupedError where the controller does not fit this robot"""


def gait_source(preset: str) -> Source:
    """A scripted gait with its settings."""
    return Source(f"gait {preset}", lambda: (EditableGaitController(preset), TaskConfig()))


def policy_source(name: str, where: str | Path) -> Source:
    """A shipped policy, or a run's. It is read when it is first used, and again each time, as training may go on."""

    def make() -> tuple[Controller, TaskConfig]:
        policy: Policy = load_policy(where)
        return PolicyController(policy, name), policy.config

    return Source(name, make)


def recording_source(path: Path) -> Source:
    """A recorded trajectory, played through the motors over and over."""

    def make() -> tuple[Controller, TaskConfig]:
        return LoopController(JointTrajectory.load(path).in_joint_order(), path.name), TaskConfig()

    return Source(f"recording {path.name}", make)


def asked_source(text: str) -> Source:
    """What a person means: a shipped policy, a scripted gait, a recording of joint states, or a run's directory.

    Raises:
        QuadrupedError: if it is none of these.
    """
    if text in SHIPPED:
        return policy_source(f"policy {text}", text)
    if text in PRESETS:
        return gait_source(text)
    path = Path(text)
    if not path.suffix and not path.is_dir():
        raise QuadrupedError(
            f"{text!r} is no shipped policy ({', '.join(SHIPPED)}), no scripted gait ({', '.join(PRESETS)}), no run's "
            f"directory and no recording; name one of these, or {training_advice()}"
        )
    recorded = (path / BAG_FILE).is_file() if path.is_dir() else bool(path.suffix)
    return recording_source(path) if recorded else policy_source(f"run {shown_path(path)}", text)


def find_sources(asked: Sequence[str] = (), runs: Path = RUNS) -> tuple[dict[str, Source], tuple[str, ...]]:
    """Everything there is to show by name, and the names of what to begin with.

    Args:
        asked: what a person wants to see; with nothing it is the latest run that fits, or else what is shipped.
        runs: the directory of the training runs.

    Raises:
        QuadrupedError: if something that a person asked for cannot be used.
    """
    wanted = _distinct(asked)
    for source in wanted:
        source.make()
    offered = [
        *_latest_runs(runs),
        *(asked_source(name) for name in (*SHIPPED, *reversed(PRESETS))),
        Source(STANDING, lambda: (ZeroController(), TaskConfig())),
    ]
    sources: dict[str, Source] = {}
    for source in wanted + offered:
        sources.setdefault(source.name, source)
    return sources, tuple(source.name for source in wanted or [_first_that_fits(offered)])


def _distinct(asked: Sequence[str]) -> list[Source]:
    """Sources that have the same name only if they are the same."""
    by_text: dict[str, Source] = {}
    for text in asked:
        source = asked_source(text)
        taken = {other.name for name, other in by_text.items() if name != text}
        names = (source.name, *(f"{source.name} ({number})" for number in range(2, len(asked) + 1)))
        by_text[text] = replace(source, name=next(name for name in names if name not in taken))
    return [by_text[text] for text in asked]


def _first_that_fits(sources: Sequence[Source]) -> Source:
    for source in sources:
        try:
            source.make()
        except QuadrupedError:
            # A run that was damaged, or made for another version: whoever chooses it is told.
            continue
        return source
    raise AssertionError("a scripted gait always fits")


def _latest_runs(runs: Path) -> list[Source]:
    if not runs.is_dir():
        return []
    # The names begin with the time. `latest` is one of them under another name.
    finished = [path for path in runs.iterdir() if (path / CARD_FILE).is_file() and not path.is_symlink()]
    return [policy_source(f"run {path.name}", path) for path in sorted(finished, reverse=True)[:MAX_RUNS]]


class LoopController(TrajectoryController):
    """Plays a recording again from its beginning when it ends."""

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `quadruped_env.policies.Controller.step`."""
        time = task.steps * task.config.control_timestep
        # One more step lies between the last row and the first.
        return task.step_joint_target(
            self.trajectory.positions_at(time % (self.trajectory.duration + task.config.control_timestep))
        )


def pick(sources: dict[str, Source], name: str) -> Source:
    """A source by name.

    Raises:
        QuadrupedError: if there is none of that name.
    """
    if name not in sources:
        raise QuadrupedError(f"source: there is no {name!r}; there are {', '.join(sources)}")
    return sources[name]
