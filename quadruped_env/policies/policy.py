"""A trained policy together with the task that it was trained for."""

import functools
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Self

import gymnasium
import numpy as np
from numpy.typing import NDArray

from quadruped_env.control import by_name
from quadruped_env.control import policy as control_policy
from quadruped_env.control.by_name import ControllerSpec
from quadruped_env.control.controllers import Controller, PolicyController
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.policy import kept_file, policy_directory
from quadruped_env.control.task_file import TASK_FILE, recorded_file
from quadruped_env.envs import ENV_ID
from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.robot.robot import Robot, check_same_robot
from quadruped_env.task import BUILT_IN, Task, TaskConfig, TaskDefinition, load_task_file
from quadruped_env.task.task_config import config_differences, for_definition
from quadruped_env.utils.files import shown_path
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile


class Policy(control_policy.Policy):
    """A deterministic policy that can make the environment that it was trained for.

    Args:
        weights: one matrix per layer (in, out), float32.
        biases: one vector per layer (out,), float32.
        activation: activation function between layers, a key of `ACTIVATIONS`.
        config: task that it was trained for.
        card: provenance: command, seed, steps, versions, metrics.
        output: function of the last layer's values, `clip` or `tanh`.
        task: plain values of the task that it was trained for, if `config` differs from them: with another version of
            the user's file, or without it.
    """

    def __init__(
        self,
        weights: Sequence[NDArray[np.float32]],
        biases: Sequence[NDArray[np.float32]],
        activation: str,
        config: TaskConfig,
        card: dict[str, Any],
        output: str = "clip",
        task: dict[str, Any] | None = None,
    ) -> None:
        super().__init__(
            tuple(weights),
            tuple(biases),
            activation,
            config.control,
            config.definition.observations,
            config.to_dict() if task is None else task,
            card,
            config.robot,
            output,
        )
        object.__setattr__(self, "config", config)

    config: TaskConfig
    """Task that it was trained for, with the terms that are known here."""

    def with_card(self, card: dict[str, Any]) -> Self:
        """The same policy with another card."""
        return type(self)(self.weights, self.biases, self.activation, self.config, card, self.output, self.task)

    def make_env(self, **kwargs: Any) -> gymnasium.Env[NDArray[np.float32], NDArray[np.float32]]:
        """The environment that the policy was trained for: its task, action mode and control rate.

        Args:
            **kwargs: arguments of `gymnasium.make`, such as `render_mode`, or `terrain` for another ground.

        Raises:
            QuadrupedError: if `kwargs` name another task than the policy's.
        """
        return gymnasium.make(ENV_ID, **self._task_arguments(kwargs), **kwargs)

    def make_vec_env(self, num_envs: int, **kwargs: Any) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
        """A native vector environment of the task that the policy was trained for.

        Args:
            num_envs: number of robots.
            **kwargs: arguments of `gymnasium.make_vec`, such as `max_episode_steps`.

        Raises:
            QuadrupedError: if `kwargs` name another task than the policy's.
        """
        return gymnasium.make_vec(ENV_ID, num_envs=num_envs, **self._task_arguments(kwargs), **kwargs)

    def check_env(self, env: Any) -> None:
        """Check that actions and observations have the same meaning in an environment as in training.

        Args:
            env: an environment of this package, with or without wrappers, or a vector environment with a list of such
                environments (`gymnasium.vector.SyncVectorEnv`, SB3's `DummyVecEnv`).

        Raises:
            QuadrupedError: if its robot, action mode, action scale, control rate, gait clock or observations differ
                from the policy's.
        """
        inner = getattr(env, "unwrapped", env)
        task = getattr(inner, "task", None)
        members = getattr(inner, "envs", None)
        if task is None and isinstance(members, (list, tuple)) and members:
            for member in members:
                self.check_env(member)
            return
        if not isinstance(task, Task):
            raise QuadrupedError(
                f"policy: {env!r} is not an environment of this package; make one with policy.make_env()"
            )
        self.check_task(task.config)

    def check_task(self, config: TaskConfig) -> None:
        """As `check_env`, for the config of a task. Fields that do not change these meanings may differ.

        Raises:
            QuadrupedError: if the robot, action mode, action scale, control rate, gait clock or observations differ
                from the policy's.
        """
        check_same_robot(self.robot.identity, config.robot)
        self.check_control(config.control)
        self.check_observations(ObservationLayout(config.robot, config.definition.observations))

    def _task_arguments(self, kwargs: dict[str, Any]) -> dict[str, Any]:
        for name in ("action_mode", "config", "task_file", "robot"):
            if name in kwargs:
                raise QuadrupedError(
                    f"policy.make_env: {name} is given by the policy; for another task: gymnasium.make({ENV_ID!r}, ...)"
                )
        if self.config.definition.added_terrains:
            # Plain values and a task file cannot give these terrains again.
            return {"config": self.config}
        arguments = {"config": self.config.to_dict(), "task_file": self.config.definition.path}
        return arguments if self.config.robot == BUILT_IN.robot else {**arguments, "robot": self.config.robot}


def load_policy(
    source: str | Path, task_file: str | Path | None = None, robot: Robot | None = None, trust_task: bool = False
) -> Policy:
    """Load a shipped policy by name (`flat`, `robust`, `rough`), or the policy in the directory of a training run.

    For a run that was killed, this is the policy of its last checkpoint. Nothing is unpickled, and neither torch nor
    stable-baselines3 is needed.

    Args:
        source: name or directory.
        task_file: the user's file of terms or robot that the policy was trained with, or another version of it; it is
            executed. Without it, the task has the built-in terms alone.
        robot: robot that the policy was trained for. None: that of the file, or the built-in one.
        trust_task: execute the copy of the user's file that the run keeps, if it was trained with one. Without
            `task_file` and this, no code is executed.

    Raises:
        QuadrupedError: if there is no such policy, a file is missing or damaged, or it was made for another scripted
            gait, robot, terrain or other observations, also if these need the user's file; the message names the
            file and the fix.

    Warns:
        QuadrupedWarning: if `source` is a run without a final policy, so that a checkpoint is used, or if the policy's
            task differs from the one in training, because the user's file is not given or is another version.
    """
    if trust_task and task_file is not None:
        raise QuadrupedError("load_policy: found task_file and trust_task; give one of them")
    source = policy_directory(source)
    definition = kept_definition(source) if trust_task else BUILT_IN if task_file is None else load_task_file(task_file)
    if robot is not None:
        definition = definition.with_robot(robot)
    policy = with_task(control_policy.load_policy(source, _terms(definition)), definition)
    differences = task_differences(policy)
    if differences:
        warnings.warn(f"{shown_path(Path(source))}: {differences}", QuadrupedWarning, stacklevel=2)
    return policy


def kept_definition(source: str | Path) -> TaskDefinition:
    """The definition from the copy of the user's file that a run keeps, which is executed; the built-in one without.

    Raises:
        QuadrupedError: as `kept_file` and `load_task_file`.
    """
    kept = kept_file(source)
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
    code = control_policy.code_changes(Path(policy.source).parent, recorded, file)
    if code is None:
        found.append("its code is not compared, as the run keeps no copy that can be")
    elif code:
        found.append(f"other code in {', '.join(code)}")
    return f"the task of {file.name} differs from the run's: {'; '.join(found)}" if found else ""


def with_task(policy: control_policy.Policy, definition: TaskDefinition = BUILT_IN) -> Policy:
    """A loaded policy together with its task.

    Raises:
        QuadrupedError: if the task's config is not valid.
    """
    try:
        # A policy that needs nothing of a user's file is not affected by one.
        own = definition if {TASK_FILE, TERRAIN_FILE} & policy.task.keys() else BUILT_IN.with_robot(policy.robot)
        task = for_definition(policy.task, own) if own.file is None and TASK_FILE in policy.task else policy.task
        config = TaskConfig.from_dict(task, own)
    except QuadrupedError as error:
        raise control_policy.unusable(policy.source, error) from error
    made = Policy(policy.weights, policy.biases, policy.activation, config, policy.card, policy.output, policy.task)
    object.__setattr__(made, "source", policy.source)
    return made


def find_controller(text: str, task_file: str | Path | None = None) -> ControllerSpec:
    """As `quadruped_env.control.by_name.find_controller`, for policies with their task."""
    return by_name.find_controller(text, functools.partial(load_policy, task_file=task_file), _robot(task_file))


def find_controllers(
    names: Sequence[str] = (),
    runs: Path = by_name.RUNS,
    task_file: str | Path | None = None,
    trust_task: bool = False,
    robot: Robot | None = None,
) -> tuple[dict[str, ControllerSpec], tuple[str, ...]]:
    """As `quadruped_env.control.by_name.find_controllers`, for policies with their task.

    `trust_task` executes the files of the named runs only, not of those that are offered besides.
    """

    def load(source: str | Path) -> Policy:
        return load_policy(source, task_file, trust_task=trust_task and str(source) in names)

    return by_name.find_controllers(names, runs, load, robot or _robot(task_file))


def task_of(controller: Controller, definition: TaskDefinition = BUILT_IN) -> TaskConfig:
    """Task for a controller: that of its policy, or for other controllers the default task with the definition's robot.

    Raises:
        QuadrupedError: as `with_task`.
    """
    if not isinstance(controller, PolicyController):
        return TaskConfig(definition=BUILT_IN.with_robot(definition.robot))
    policy = controller.policy
    return policy.config if isinstance(policy, Policy) else with_task(policy, definition).config


def _terms(definition: TaskDefinition) -> control_policy.Terms:
    return control_policy.Terms(definition.observations, definition.commands, definition.robot, definition.file)


def _robot(task_file: str | Path | None) -> Robot:
    return BUILT_IN.robot if task_file is None else load_task_file(task_file).robot
