"""Controllers by name: trained policies, scripted gaits, recordings of joint states."""

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from quadruped_env.control.control_interface import Controller
from quadruped_env.control.controllers import GaitController, PolicyController, TrajectoryController, ZeroController
from quadruped_env.control.hub_policies import is_on_hub
from quadruped_env.control.policy import CARD_FILE, Policy
from quadruped_env.control.policy_argument import BAG_FILE, not_a_policy
from quadruped_env.control.policy_files import SHIPPED, is_code, read_policy, training_advice
from quadruped_env.errors import QuadrupedError, did_you_mean, short
from quadruped_env.gait import COMMANDED, PRESETS, CommandedGait, SinusoidalGait
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.files import shown_path

RUNS: Final = Path("runs")
MAX_RUNS: Final = 12
"""Maximum number of runs that are offered, the latest first."""
STANDING: Final = "stand still"

Load = Callable[[str | Path], Policy]
"""Reads a policy by its name or the directory of its run."""


@dataclass(frozen=True)
class ControllerSpec:
    """A controller by name."""

    name: str
    make: Callable[[], Controller]
    """Loads the controller; raises a QuadrupedError if it does not fit this robot."""


def _policy(name: str, where: str | Path, load: Load) -> ControllerSpec:
    """A shipped policy, or that of a run. It is read at every `make`, because training may still be writing it."""
    return ControllerSpec(name, lambda: PolicyController(load(where), name))


def _recording(path: Path, robot: Robot) -> ControllerSpec:
    def make() -> Controller:
        from quadruped_env.trajectory import JointTrajectory

        return TrajectoryController(JointTrajectory.load(path).in_joint_order(robot), path.name, loop=True)

    return ControllerSpec(f"recording {path.name}", make)


def _gait(preset: str, robot: Robot) -> SinusoidalGait | CommandedGait:
    return CommandedGait.preset(preset, robot) if preset in COMMANDED else SinusoidalGait.preset(preset, robot)


def find_controller(text: str, load: Load = read_policy, robot: Robot = MINI_QUADRUPED) -> ControllerSpec:
    """The controller that a user names.

    Args:
        text: a shipped policy, a scripted gait, a run's directory, an address of the hub, a Python file that defines a
            policy, or a recording of joint states (a file or a bag).
        load: reads policies.
        robot: robot that is controlled.

    Raises:
        QuadrupedError: if the text names nothing of this kind. A run or recording is not read yet.
    """
    if text in SHIPPED:
        return _policy(f"policy {text}", text, load)
    if text in PRESETS:
        return ControllerSpec(f"gait {text}", lambda: GaitController(_gait(text, robot), text))
    path = Path(text)
    if is_code(text) or is_on_hub(text):
        return _policy(f"policy {path.name}", text, load)
    if problem := not_a_policy(text, recordings=False):
        raise QuadrupedError(problem)
    if os.path.isdir(path) and not os.path.isfile(path / BAG_FILE):
        return _policy(f"run {shown_path(path)}", text, load)
    if path.suffix or os.path.isdir(path):
        return _recording(path, robot)
    raise QuadrupedError(
        f"{short(text)} is neither a shipped policy ({', '.join(SHIPPED)}), nor a scripted gait "
        f"({', '.join(PRESETS)}), nor the directory of a run, nor a recording; name one of these, "
        f"or {training_advice()}{did_you_mean(text, [*SHIPPED, *PRESETS])}"
    )


def find_controllers(
    names: Sequence[str | ControllerSpec] = (),
    runs: Path = RUNS,
    load: Load = read_policy,
    robot: Robot = MINI_QUADRUPED,
) -> tuple[dict[str, ControllerSpec], tuple[str, ...]]:
    """All available controllers by name, and the names of those to start with.

    Args:
        names: controllers to start with, each as in `find_controller` or given itself; if empty, the latest run that
            fits this robot, or else the shipped `DEFAULT`.
        runs: directory of the training runs.
        load: reads policies.
        robot: robot that is controlled.

    Raises:
        QuadrupedError: if one of `names` cannot be used.
    """
    wanted = _distinct(names, load, robot)
    for spec in wanted:
        spec.make()
    offered = [
        *_latest_runs(runs, load),
        *(find_controller(name, load, robot) for name in (*SHIPPED, *reversed(PRESETS))),
        ControllerSpec(STANDING, ZeroController),
    ]
    specs: dict[str, ControllerSpec] = {}
    for spec in wanted + offered:
        specs.setdefault(spec.name, spec)
    return specs, tuple(spec.name for spec in wanted or [_first_that_fits(offered)])


def _distinct(texts: Sequence[str | ControllerSpec], load: Load, robot: Robot) -> list[ControllerSpec]:
    """Controllers whose names differ where the texts differ."""
    by_text: dict[str | ControllerSpec, ControllerSpec] = {}
    for text in texts:
        spec = text if isinstance(text, ControllerSpec) else find_controller(text, load, robot)
        taken = {other.name for name, other in by_text.items() if name != text}
        names = (spec.name, *(f"{spec.name} ({number})" for number in range(2, len(texts) + 1)))
        by_text[text] = replace(spec, name=next(name for name in names if name not in taken))
    return [by_text[text] for text in texts]


def _first_that_fits(specs: Sequence[ControllerSpec]) -> ControllerSpec:
    for spec in specs:
        try:
            spec.make()
        except QuadrupedError:
            # A damaged run, or one of another version: the user sees this error when selecting it.
            continue
        return spec
    raise AssertionError("a scripted gait always fits")


def _latest_runs(runs: Path, load: Load) -> list[ControllerSpec]:
    if not runs.is_dir():
        return []
    # Names begin with the time. `latest` is a link to one of them.
    finished = [path for path in runs.iterdir() if (path / CARD_FILE).is_file() and not path.is_symlink()]
    return [_policy(f"run {path.name}", path, load) for path in sorted(finished, reverse=True)[:MAX_RUNS]]
