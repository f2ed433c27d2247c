"""Trained policies with their tasks: loaded by name or run, and made of models and of code."""

import copy
import hashlib
import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Final, Protocol, Self

import gymnasium
import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_interface import Controller
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.task_file import KEPT_FILE, TASK_FILE, execute, recorded_terms
from quadruped_env.envs import ENV_ID
from quadruped_env.envs.arguments import arguments_of, task_config
from quadruped_env.errors import QuadrupedError, QuadrupedWarning, short
from quadruped_env.policies import onnx_file, sb3
from quadruped_env.policies.files import is_code, kept_file, policy_directory, read_policy, trained_with, unusable
from quadruped_env.policies.layers import Actor
from quadruped_env.policies.policy_data import PolicyData
from quadruped_env.robot.robot import Robot
from quadruped_env.task import BUILT_IN, Task, TaskConfig, TaskDefinition, load_task_file
from quadruped_env.task.task_config import known_values
from quadruped_env.utils.files import shown_path

_ENV_ARGUMENTS: Final = ("action_mode", "config", "task_file", "robot", "terrain")
_IN_FILES: Final = "policy"
"""Name of the agent, or of its class, at the top level of a user's file."""


class Agent(Protocol):
    """A policy that is code: recurrent, convolutional, of another library, or written by hand.

    An agent may also have the attribute `env_kwargs`: arguments of `gymnasium.make` (action_mode, config, task_file,
    robot, terrain) for the env that it was made for, instead of the default one.
    """

    def reset(self, begun: NDArray[np.bool_]) -> None:
        """Forget the envs in which an episode begins, before `predict` is called with their first observations.

        Args:
            begun: mask (N,) of these envs. N changes only when all begin.
        """
        ...

    def predict(self, observation: NDArray[np.float32]) -> NDArray[np.floating[Any]]:
        """Return actions (N, J) for the observations (N, width) of one control step; they are clipped to [-1, 1]."""
        ...


@dataclass(frozen=True, kw_only=True)
class Policy(PolicyData):
    """A deterministic policy with its task: a small multilayer perceptron, or code.

    A policy that is code has an `Agent` instead of weights. It can be evaluated, viewed and filmed, but has no file.

    Args:
        config: config of the task that it was trained for, with the terms that are known here.
        agent: object that acts instead of the weights, of which there are none then.
    """

    config: TaskConfig = field(repr=False, compare=False)
    agent: Agent | None = None

    @classmethod
    def for_task(
        cls,
        weights: Sequence[NDArray[np.float32]],
        biases: Sequence[NDArray[np.float32]],
        activation: str,
        config: TaskConfig,
        card: dict[str, Any],
        output: str = "clip",
        agent: Agent | None = None,
    ) -> Self:
        """Make a policy from the config of its task; the other arguments are as for the class."""
        return cls(
            weights=tuple(weights),
            biases=tuple(biases),
            activation=activation,
            control=config.control,
            fields=config.definition.observations,
            task=config.to_dict(),
            card=card,
            robot=config.robot,
            output=output,
            config=config,
            agent=agent,
        )

    @classmethod
    def from_sb3(cls, model: Any, card: dict[str, Any] | None = None) -> Self:
        """Return the deterministic part of a model of Stable-Baselines3 or sb3-contrib that was trained on this env.

        Every multilayer perceptron with one activation function of `ACTIVATIONS` fits: the actors of PPO, A2C, TRPO,
        SAC, TD3, DDPG, TQC, CrossQ and ARS with their MLP policies. Observations that `VecNormalize` normalizes are
        folded into the first layer, without its clipping.

        Args:
            model: the model, with its env.
            card: provenance; None: algorithm, seed and number of steps.

        Raises:
            QuadrupedError: if the model has no env of this package, or a policy's file cannot hold its actor; the
                message names the reason, and the protocol for such policies.

        Warns:
            QuadrupedWarning: if `VecNormalize` clips observations that the env can give.
        """
        actor = sb3.actor_of(model)
        facts = {"algo": type(model).__name__.lower(), "seed": model.seed, "timesteps": int(model.num_timesteps)}
        return cls._of_actor(actor, facts if card is None else card)

    @classmethod
    def from_onnx(cls, path: str | os.PathLike[str], card: dict[str, Any] | None = None, **env_kwargs: Any) -> Self:
        """Return the policy of an ONNX file from observations to actions, such as rsl_rl's and mjlab's export.

        The graph is a multilayer perceptron as in `from_sb3`: linear layers, one activation function between them,
        with or without a normalization of the observations. Its actions are clipped to [-1, 1].

        Args:
            path: the file.
            card: provenance; None: the file's name and SHA-256.
            env_kwargs: arguments of `gymnasium.make` for the env in which it acts: action_mode, config, task_file,
                robot, terrain. Its observations, action scale and control rate have to be as in the training.

        Raises:
            MissingExtraError: if onnx is not installed.
            QuadrupedError: if the file is no such graph, or its observations or actions do not fit the env.
        """
        file, config = Path(path), task_config(**env_kwargs)
        actor = onnx_file.actor_of(file, config)
        facts = {"imported_from": {"name": file.name, "sha256": hashlib.sha256(file.read_bytes()).hexdigest()}}
        return cls._of_actor(actor, facts if card is None else card)

    @classmethod
    def _of_actor(cls, actor: Actor, card: dict[str, Any]) -> Self:
        network = actor.network
        weights, biases = zip(*network.layers, strict=True)
        policy = cls.for_task(weights, biases, network.activation, actor.config, card, network.output)
        actor.check(policy.predict(actor.observations))
        return policy

    def make_env(self, **kwargs: Any) -> gymnasium.Env[NDArray[np.float32], NDArray[np.float32]]:
        """Return the environment that the policy was trained for: its task, action mode and control rate.

        `kwargs` are arguments of `gymnasium.make`, such as `render_mode`, or `terrain` for another ground.

        Raises:
            QuadrupedError: if `kwargs` name another task than the policy's.
        """
        return gymnasium.make(ENV_ID, **self._task_arguments(kwargs), **kwargs)

    def make_vec_env(self, num_envs: int, **kwargs: Any) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
        """Return a native vector environment of the task, by arguments of `gymnasium.make_vec`; see `make_env`."""
        return gymnasium.make_vec(ENV_ID, num_envs=num_envs, **self._task_arguments(kwargs), **kwargs)

    def _task_arguments(self, kwargs: dict[str, Any]) -> dict[str, Any]:
        for name in ("action_mode", "config", "task_file", "robot"):
            if name in kwargs:
                raise QuadrupedError(
                    f"policy.make_env: {name} is given by the policy; for another task: gymnasium.make({ENV_ID!r}, ...)"
                )
        definition = self.config.definition
        if definition.added_terrains:
            # Plain values and a task file cannot give these terrains again.
            return {"config": self.config}
        return {"config": self.config.to_dict(), **arguments_of(definition)}

    def begin(self, begun: NDArray[np.bool_]) -> None:
        """See `PolicyData.begin`."""
        if self.agent is not None:
            self.agent.reset(begun)

    def predict(self, observation: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return the actions (..., J) in [-1, 1] for observations (..., obs).

        Raises:
            QuadrupedError: if the observations have another width, or an agent's actions another shape or type, or
                they are not finite.
        """
        if self.agent is None:
            return super().predict(observation)
        seen = np.asarray(observation, dtype=np.float32)
        actions = np.asarray(self.agent.predict(seen))
        expected = (*seen.shape[:-1], self.robot.num_joints)
        if actions.shape != expected or not np.issubdtype(actions.dtype, np.floating):
            raise QuadrupedError(
                f"{self.source}: predict: expected an array of numbers of shape {expected}; found {actions.dtype} of "
                f"shape {actions.shape}"
            )
        if not np.isfinite(actions).all():
            raise QuadrupedError(f"{self.source}: predict: an action is not finite; return numbers in [-1, 1]")
        return np.clip(actions, -1.0, 1.0).astype(np.float32)

    def check_is_data(self, where: str) -> None:
        """See `PolicyData.check_is_data`."""
        if self.agent is not None:
            raise QuadrupedError(
                f"{where}: {self.source} is a policy of Python code, and this takes policies of files: the directory "
                f"of a run, or of Policy.from_sb3(model).save(DIR), which holds any MLP of Stable-Baselines3"
            )
        super().check_is_data(where)

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
        task, members = getattr(inner, "task", None), getattr(inner, "envs", None)
        if isinstance(task, Task):
            self.check_fits(task.config.robot, task.config.control, task.control.layout)
        elif isinstance(members, (list, tuple)) and members:
            for member in members:
                self.check_env(member)
        else:
            raise QuadrupedError(
                f"policy: {env!r} is not an environment of this package; make one with policy.make_env()"
            )


def load_policy(
    source: str | Path, task_file: str | Path | None = None, robot: Robot | None = None, trust_task: bool = False
) -> Policy:
    """Load a shipped policy by name (`flat`, `rough`), that in the directory of a training run, or one of the hub.

    The name of a Python file means the policy that it defines as code; see `load_agent`. The file is executed.

    For a run that was killed, this is the policy of its last checkpoint. Nothing is unpickled, and neither torch nor
    stable-baselines3 is needed. The numbers of its task always come from the run's config.

    Args:
        source: name, directory, or `hf://OWNER/NAME[@REVISION]` (extra `hub`): only its JSON and safetensors are read.
        task_file: the user's file of terms or robot that the policy was trained with, which is executed. Without it,
            the task has the built-in terms alone.
        robot: robot that the policy was trained for. None: the file's, or the built-in one.
        trust_task: execute the copy of the user's file that the run keeps, if it was trained with one. Without
            `task_file` and this, no code is executed.

    Raises:
        QuadrupedError: if there is no such policy, a file is missing or damaged, or it was made for another scripted
            gait, robot, terrain or other observations, also if these need the user's file; the message names the
            file and the fix.
        MissingExtraError: for an address of the hub without its client.

    Warns:
        QuadrupedWarning: if `source` is a run without a final policy, so that a checkpoint is used, or if the user's
            file is not given or is another version.
    """
    if trust_task and task_file is not None:
        raise QuadrupedError("task_file: found together with trust_task; give one of them")
    if is_code(source):
        if trust_task:
            raise QuadrupedError(f"{source}: is code, with which no task file is kept; leave trust_task out")
        return load_agent(source, task_file=task_file, robot=robot)
    directory = policy_directory(source)
    definition = task_definition(directory, task_file, trust_task)
    if robot is not None:
        definition = definition.with_robot(robot)
    policy = _with_task(directory, definition)
    if note := task_note(policy):
        warnings.warn(f"{shown_path(directory)}: {note}", QuadrupedWarning, stacklevel=2)
    return policy


def task_definition(
    source: str | Path, task_file: str | Path | None = None, trust_task: bool = False
) -> TaskDefinition:
    """Return the definition from a user's file, or with `trust_task` from the copy that a run keeps; it is executed.

    Raises:
        QuadrupedError: as `kept_file` and `load_task_file`.
    """
    if trust_task:
        kept = kept_file(source)
        return BUILT_IN if kept is None else load_task_file(*kept)
    return BUILT_IN if task_file is None else load_task_file(task_file)


def at_checkpoint(policy: Policy, checkpoint: Path) -> Policy:
    """Return a loaded policy as it was at a checkpoint of its training, in the same task.

    Raises:
        QuadrupedError: if the checkpoint cannot be read.
    """
    return _with_task(checkpoint, policy.config.definition)


def _with_task(directory: Path, definition: TaskDefinition) -> Policy:
    """Return the policy of a directory with its task: the terms of a definition, the numbers of the policy's config."""
    data = read_policy(directory, definition)
    try:
        # A policy that needs nothing of a user's file is not affected by one.
        own = definition if trained_with(data.task) is not None else BUILT_IN.with_robot(data.robot)
        config = TaskConfig.from_dict(known_values(data.task, own), own)
    except QuadrupedError as error:
        raise unusable(data.source, error) from error
    return Policy(**{entry.name: getattr(data, entry.name) for entry in fields(data)}, config=config)


def task_note(policy: Policy) -> str:
    """Return a note if a policy is used without the user's file of its training, or with another version of it."""
    recorded, file = trained_with(policy.task), policy.config.file
    if recorded is None or (file is not None and file.sha256 == recorded.sha256):
        return ""
    if file is not None:
        return (
            f"{file.name} is not the version of the training, which the run keeps as {KEPT_FILE}: the code of the "
            f"terms is your file's, their weights and parameters are the run's"
        )
    terms = recorded_terms(policy.task.get(TASK_FILE, {}))
    left_out = "; ".join(f"{kind} {', '.join(names)}" for kind, names in terms.items() if names)
    return (
        f"its task is used without {recorded.name}, which is not executed automatically: without its {left_out}. "
        f"--trust-task (trust_task=True in Python) executes the run's copy, and --task FILE your file"
    )


def task_of(controller: Controller, robot: Robot = BUILT_IN.robot) -> TaskConfig:
    """Return the task of a controller's policy, or for other controllers the default task of a robot."""
    if isinstance(controller, PolicyController) and isinstance(controller.policy, Policy):
        return controller.policy.config
    return TaskConfig(definition=BUILT_IN.with_robot(robot))


def as_policy(policy: Policy | Agent, source: str = "policy", **env_kwargs: Any) -> Policy:
    """Return a policy, or the policy of an agent, which acts for one set of envs at a time.

    `source` is its name in error messages, and `env_kwargs` arguments of the env that an agent does not name.

    Raises:
        QuadrupedError: if the object lacks one of the two methods, or its `env_kwargs` are not valid.
    """
    if isinstance(policy, Policy):
        return policy
    kind = type(policy).__name__
    for method in ("reset", "predict"):
        if not callable(getattr(policy, method, None)):
            raise QuadrupedError(
                f"{source}: {kind} has no method {method}; a policy has reset(begun) and predict(observation) "
                f"(docs/training.md#your-own-algorithm)"
            )
    own = getattr(policy, "env_kwargs", {})
    if not isinstance(own, dict) or not set(own) <= set(_ENV_ARGUMENTS):
        raise QuadrupedError(
            f"{source}: env_kwargs: expected a dict with {', '.join(_ENV_ARGUMENTS)}; found {short(own)}"
        )
    try:
        config = task_config(**{**env_kwargs, **own})
    except QuadrupedError as error:
        raise QuadrupedError(f"{source}: env_kwargs: {error}" if own else str(error)) from error
    return replace(Policy.for_task((), (), "", config, {"agent": kind}, agent=policy), source=source)


def load_agent(path: str | Path, **env_kwargs: Any) -> Policy:
    """Return the policy that a user's file defines, with memory of its own; the file is executed.

    The file has an agent, or its class, under the name `policy`; for `env_kwargs` see `as_policy`.

    Raises:
        QuadrupedError: if the file cannot be executed, defines no agent, or its agent is not valid.
    """
    file, module = execute(path)
    agent = getattr(module, _IN_FILES, None)
    if agent is None:
        raise QuadrupedError(
            f"{path}: defines no {_IN_FILES!r}; name an object with reset(begun) and predict(observation), or its "
            f"class, {_IN_FILES!r} (docs/training.md#your-own-algorithm)"
        )
    policy = as_policy(own_copy(agent, str(path)), str(path), **env_kwargs)
    return policy.with_card({**policy.card, **file.to_dict()})


def own_copy(agent: Agent | type[Agent], source: str) -> Agent:
    """Return an agent of a class, or a copy of one: two robots do not share a memory.

    Raises:
        QuadrupedError: if it cannot be made.
    """
    try:
        return agent() if isinstance(agent, type) else copy.deepcopy(agent)
    except Exception as error:
        raise QuadrupedError(
            f"{source}: {_IN_FILES} cannot be made or copied ({type(error).__name__}: {error}); define it as a class "
            f"that needs no arguments"
        ) from error
