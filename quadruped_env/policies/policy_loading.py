"""Trained policies with their tasks: loaded by name or run, compared with their task files, and as controllers."""

import functools
import warnings
from collections.abc import Sequence
from pathlib import Path

from quadruped_env.control import by_name
from quadruped_env.control.by_name import ControllerSpec
from quadruped_env.control.control_interface import Controller
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.kept_task_file import code_changes, kept_file
from quadruped_env.control.policy import Agent, Policy
from quadruped_env.control.policy_files import Terms, is_code, policy_directory, read_policy
from quadruped_env.control.task_file import TASK_FILE, recorded_file
from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.policies.code_policies import as_policy, load_agent, own_copy
from quadruped_env.policies.policy_task import with_task
from quadruped_env.robot.robot import Robot
from quadruped_env.task import BUILT_IN, TaskConfig, TaskDefinition, load_task_file
from quadruped_env.task.task_config import config_differences
from quadruped_env.utils.files import shown_path
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile


def load_policy(
    source: str | Path, task_file: str | Path | None = None, robot: Robot | None = None, trust_task: bool = False
) -> Policy:
    """Load a shipped policy by name (`flat`, `rough`), that in the directory of a training run, or one of the hub.

    The name of a Python file means the policy that it defines as code; see `load_agent`. The file is executed.

    For a run that was killed, this is the policy of its last checkpoint. Nothing is unpickled, and neither torch nor
    stable-baselines3 is needed.

    Args:
        source: name, directory, or `hf://OWNER/NAME[@REVISION]` (extra `hub`): only its JSON and safetensors are read.
        task_file: the user's file of terms or robot that the policy was trained with, or another version of it; it is
            executed. Without it, the task has the built-in terms alone.
        robot: robot that the policy was trained for. None: that of the file, or the built-in one.
        trust_task: execute the copy of the user's file that the run keeps, if it was trained with one. Without
            `task_file` and this, no code is executed.

    Raises:
        QuadrupedError: if there is no such policy, a file is missing or damaged, or it was made for another scripted
            gait, robot, terrain or other observations, also if these need the user's file; the message names the
            file and the fix.
        MissingExtraError: for an address of the hub without its client.

    Warns:
        QuadrupedWarning: if `source` is a run without a final policy, so that a checkpoint is used, or if the policy's
            task differs from the one in training, because the user's file is not given or is another version.
    """
    if trust_task and task_file is not None:
        raise QuadrupedError("task_file: found together with trust_task; give one of them")
    if is_code(source):
        if trust_task:
            raise QuadrupedError(f"{source}: is code, with which no task file is kept; leave trust_task out")
        return load_agent(source, task_file=task_file, robot=robot)
    source = policy_directory(source)
    definition = kept_definition(source) if trust_task else BUILT_IN if task_file is None else load_task_file(task_file)
    if robot is not None:
        definition = definition.with_robot(robot)
    policy = with_task(read_policy(source, _terms(definition)), definition)
    differences = task_differences(policy)
    if differences:
        warnings.warn(f"{shown_path(Path(source))}: {differences}", QuadrupedWarning, stacklevel=2)
    return policy


def kept_definition(source: str | Path) -> TaskDefinition:
    """The definition from the copy of the user's file that a run keeps, which is executed; the built-in one without.

    Raises:
        QuadrupedError: as `policy_directory`, `kept_file` and `load_task_file`.
    """
    kept = kept_file(policy_directory(source))
    return BUILT_IN if kept is None else load_task_file(*kept)


def trained_with(policy: Policy) -> TaskFile | None:
    """The user's file that a policy was trained with, without its content; None for the built-in task."""
    return recorded_file(policy.task.get(TASK_FILE)) or recorded_file(policy.task.get(TERRAIN_FILE), TERRAIN_FILE)


def task_differences(policy: Policy) -> str:
    """Differences of a policy's task here from the one in training, in a sentence; empty without differences."""
    recorded, file = trained_with(policy), policy.config.file
    if recorded is None or (file is not None and file.sha256 == recorded.sha256):
        return ""
    found = config_differences(policy.task, policy.config)
    if file is None:
        return (
            f"its task is used without {recorded.name}, which is not executed automatically: {'; '.join(found)}. "
            f"--trust-task (trust_task=True in Python) executes the run's copy, and --task FILE your file"
            if found
            else ""
        )
    code = code_changes(Path(policy.source).parent, recorded, file)
    if code is None:
        found.append("its code is not compared, as the run keeps no copy that can be")
    elif code:
        found.append(f"other code in {', '.join(code)}")
    return f"the task of {file.name} differs from the run's: {'; '.join(found)}" if found else ""


def find_controller(text: str, task_file: str | Path | None = None) -> ControllerSpec:
    """As `quadruped_env.control.by_name.find_controller`, for policies with their task."""
    return by_name.find_controller(text, functools.partial(load_policy, task_file=task_file), _robot(task_file))


def find_controllers(
    names: Sequence[str | Agent] = (),
    runs: Path = by_name.RUNS,
    task_file: str | Path | None = None,
    trust_task: bool = False,
    robot: Robot | None = None,
) -> tuple[dict[str, ControllerSpec], tuple[str, ...]]:
    """As `quadruped_env.control.by_name.find_controllers`, for policies with their task, and for agents.

    `trust_task` executes the files of the named runs only, not of those that are offered besides.
    """

    def load(source: str | Path) -> Policy:
        return load_policy(source, task_file, trust_task=trust_task and str(source) in names)

    named = [name if isinstance(name, str) else controller_of(name) for name in names]
    return by_name.find_controllers(named, runs, load, robot or _robot(task_file))


def controller_of(agent: Agent) -> ControllerSpec:
    """An agent as a controller by its class's name; each robot gets a copy."""
    name = f"policy {type(agent).__name__}"
    return ControllerSpec(name, lambda: PolicyController(as_policy(own_copy(agent, name), name), name))


def task_of(controller: Controller, definition: TaskDefinition = BUILT_IN) -> TaskConfig:
    """Task for a controller: that of its policy, or for other controllers the default task with the definition's robot.

    Raises:
        QuadrupedError: as `with_task`.
    """
    if not isinstance(controller, PolicyController):
        return TaskConfig(definition=BUILT_IN.with_robot(definition.robot))
    policy = controller.policy
    return policy.task_config or with_task(policy, definition).config


def at_checkpoint(policy: Policy, checkpoint: Path) -> Policy:
    """A loaded policy as it was at a checkpoint of its training, in the same task.

    Raises:
        QuadrupedError: if the checkpoint cannot be read.
    """
    definition = policy.config.definition
    return with_task(read_policy(checkpoint, _terms(definition)), definition)


def _terms(definition: TaskDefinition) -> Terms:
    return Terms(definition.observations, definition.commands, definition.robot, definition.file)


def _robot(task_file: str | Path | None) -> Robot:
    return BUILT_IN.robot if task_file is None else load_task_file(task_file).robot
