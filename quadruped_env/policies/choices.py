"""The controllers that a viewer offers: those that the user named, the latest runs, shipped policies and gaits."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

from quadruped_env.control.controllers import PolicyController, ZeroController
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import PRESETS
from quadruped_env.policies.by_name import ControllerSpec, find_controller, policy_spec
from quadruped_env.policies.files import SHIPPED
from quadruped_env.policies.policy import Agent, Policy, as_policy, load_policy, own_copy, task_definition
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.robot.robot import Robot

RUNS: Final = Path("runs")
MAX_RUNS: Final = 12
"""Maximum number of runs that are offered, the latest first."""
STANDING: Final = "stand still"


def find_controllers(
    names: Sequence[str | Agent] = (),
    runs: Path = RUNS,
    task_file: str | Path | None = None,
    trust_task: bool = False,
    robot: Robot | None = None,
) -> tuple[dict[str, ControllerSpec], tuple[str, ...]]:
    """Return all available controllers by name, and the names of those to start with.

    Args:
        names: controllers to start with, each as in `find_controller`, or an agent, of which each robot gets a copy;
            if empty, the latest run that fits this robot, or else the shipped `DEFAULT`.
        runs: directory of the training runs.
        task_file: the user's file of the policies' terms or robot, which is executed.
        trust_task: execute the files that the named runs keep, but no files of other runs.
        robot: robot that is controlled. None: the file's, or the built-in one.

    Raises:
        QuadrupedError: if one of `names` cannot be used.
    """
    robot = robot or task_definition("", task_file).robot

    def load(source: str | Path) -> Policy:
        return load_policy(source, task_file, trust_task=trust_task and str(source) in names)

    keys = [name if isinstance(name, str) else id(name) for name in names]
    wanted: dict[str | int, ControllerSpec] = {}
    for key, name in zip(keys, names, strict=True):
        spec = find_controller(name, load, robot) if isinstance(name, str) else _of_agent(name)
        taken = {other.name for one, other in wanted.items() if one != key}
        distinct = (spec.name, *(f"{spec.name} ({number})" for number in range(2, len(names) + 1)))
        wanted[key] = replace(spec, name=next(one for one in distinct if one not in taken))
        spec.make()
    # Names of runs begin with the time. `latest` is a link to one of them.
    finished = [path for path in runs.glob("*") if (path / CARD_FILE).is_file() and not path.is_symlink()]
    offered = [
        *(policy_spec(f"run {path.name}", path, load) for path in sorted(finished, reverse=True)[:MAX_RUNS]),
        *(find_controller(name, load, robot) for name in (*SHIPPED, *reversed(PRESETS))),
        ControllerSpec(STANDING, ZeroController),
    ]
    specs: dict[str, ControllerSpec] = {}
    for spec in (*wanted.values(), *offered):
        specs.setdefault(spec.name, spec)
    return specs, tuple(wanted[key].name for key in keys) or (_first_that_fits(offered),)


def _of_agent(agent: Agent) -> ControllerSpec:
    name = f"policy {type(agent).__name__}"
    return ControllerSpec(name, lambda: PolicyController(as_policy(own_copy(agent, name), name), name))


def _first_that_fits(specs: Sequence[ControllerSpec]) -> str:
    for spec in specs:
        try:
            spec.make()
        except QuadrupedError:
            # A damaged run, or one of another version: the user sees this error when selecting it.
            continue
        return spec.name
    raise AssertionError("a scripted gait always fits")
