"""Controllers by name: trained policies, scripted gaits, recordings of joint states."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from quadruped_env.control.control_interface import Controller
from quadruped_env.control.controllers import GaitController, PolicyController, TrajectoryController
from quadruped_env.errors import QuadrupedError, did_you_mean, short
from quadruped_env.gait import COMMANDED, PRESETS, CommandedGait, SinusoidalGait
from quadruped_env.policies.files import SHIPPED, is_code, read_policy, training_advice
from quadruped_env.policies.hub import is_on_hub
from quadruped_env.policies.not_a_policy import BAG_FILE, not_a_policy
from quadruped_env.policies.policy_data import PolicyData
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.files import shown_path

Load = Callable[[str | Path], PolicyData]
"""Reads a policy by its name or the directory of its run."""


@dataclass(frozen=True)
class ControllerSpec:
    """A controller by name."""

    name: str
    make: Callable[[], Controller]
    """Loads the controller; raises a QuadrupedError if it does not fit this robot."""


def policy_spec(name: str, where: str | Path, load: Load) -> ControllerSpec:
    """Return a policy by name. It is read at every `make`, because training may still be writing it."""
    return ControllerSpec(name, lambda: PolicyController(load(where), name))


def _recording(path: Path, robot: Robot) -> ControllerSpec:
    def make() -> Controller:
        from quadruped_env.trajectory import JointTrajectory

        return TrajectoryController(JointTrajectory.load(path).in_joint_order(robot), path.name, loop=True)

    return ControllerSpec(f"recording {path.name}", make)


def _gait(preset: str, robot: Robot) -> SinusoidalGait | CommandedGait:
    return CommandedGait.preset(preset, robot) if preset in COMMANDED else SinusoidalGait.preset(preset, robot)


def find_controller(text: str, load: Load = read_policy, robot: Robot = MINI_QUADRUPED) -> ControllerSpec:
    """Return the controller that a user names.

    Args:
        text: a shipped policy, a scripted gait, a run's directory, an address of the hub, a Python file that defines a
            policy, or a recording of joint states (a file or a bag).
        load: reads policies.
        robot: robot that is controlled.

    Raises:
        QuadrupedError: if the text names nothing of this kind. A run or recording is not read yet.
    """
    if text in SHIPPED:
        return policy_spec(f"policy {text}", text, load)
    if text in PRESETS:
        return ControllerSpec(f"gait {text}", lambda: GaitController(_gait(text, robot), text))
    path = Path(text)
    if is_code(text) or is_on_hub(text):
        return policy_spec(f"policy {path.name}", text, load)
    if problem := not_a_policy(text, recordings=False):
        raise QuadrupedError(problem)
    if os.path.isdir(path) and not os.path.isfile(path / BAG_FILE):
        return policy_spec(f"run {shown_path(path)}", text, load)
    if path.suffix or os.path.isdir(path):
        return _recording(path, robot)
    raise QuadrupedError(
        f"{short(text)} is neither a shipped policy ({', '.join(SHIPPED)}), nor a scripted gait "
        f"({', '.join(PRESETS)}), nor the directory of a run, nor a recording; name one of these, "
        f"or {training_advice()}{did_you_mean(text, [*SHIPPED, *PRESETS])}"
    )
