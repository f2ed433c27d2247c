"""A trained policy as data, evaluated with NumPy alone."""

import functools
import hashlib
import importlib
import json
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, Final, Protocol, Self

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from quadruped_env.control.activations import ACTIVATIONS, OUTPUTS
from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.observations import ObservationField, ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot, check_same_robot
from quadruped_env.utils.files import unwritable, write_whole

if TYPE_CHECKING:
    from gymnasium import Env
    from gymnasium.vector import VectorEnv

    from quadruped_env.task import TaskConfig

FORMAT_VERSION: Final = 1
TENSORS_FILE: Final = "policy.safetensors"
CARD_FILE: Final = "policy.json"
_LARGEST: Final = 1e38
"""Bound of the values between layers: a third of float32's largest, for the rounding of sums in any order."""


class Agent(Protocol):
    """A policy that is code: recurrent, convolutional, of another library, or written by hand.

    An agent may also have the attribute `env_kwargs`: arguments of `gymnasium.make` (action_mode, config, task_file,
    robot, terrain) for the env that it was made for, in place of the default one.
    """

    def reset(self, begun: NDArray[np.bool_]) -> None:
        """Forget the envs in which an episode begins, before `predict` is called with their first observations.

        Args:
            begun: mask (N,) of these envs. N changes only when all begin.
        """
        ...

    def predict(self, observation: NDArray[np.float32]) -> NDArray[np.floating[Any]]:
        """Actions (N, J) for the observations (N, width) of one control step; they are clipped to [-1, 1]."""
        ...


@dataclass(frozen=True)
class Policy:
    """A deterministic policy: a small multilayer perceptron with the meaning of its observations and actions.

    A policy that is code has an `Agent` in place of weights. It can be evaluated, viewed and filmed, but has no file.

    Args:
        weights: one matrix per layer (in, out), float32.
        biases: one vector per layer (out,), float32.
        activation: activation function between layers, a key of `ACTIVATIONS`.
        control: time step, clock, action mode and commands that it was trained with.
        fields: fields of its observations.
        task: config of the task that it was trained for, as plain values.
        card: provenance: command, seed, steps, versions, metrics.
        robot: robot that it was trained on.
        output: function that brings the last layer's values into [-1, 1], a key of `OUTPUTS`.
        source: name of the policy's file in error messages.
        task_config: the config of that task with the terms that are known here; None: with the built-in ones, when it
            is needed. A robot's controller never needs it.
        agent: object that acts in place of the weights, of which there are none then.
    """

    weights: tuple[NDArray[np.float32], ...]
    biases: tuple[NDArray[np.float32], ...]
    activation: str
    control: ControlConfig
    fields: tuple[ObservationField, ...]
    task: dict[str, Any]
    card: dict[str, Any]
    robot: Robot = MINI_QUADRUPED
    output: str = "clip"
    source: str = CARD_FILE
    task_config: "TaskConfig | None" = field(default=None, repr=False, compare=False)
    agent: Agent | None = None

    @classmethod
    def for_task(
        cls,
        weights: Sequence[NDArray[np.float32]],
        biases: Sequence[NDArray[np.float32]],
        activation: str,
        config: "TaskConfig",
        card: dict[str, Any],
        output: str = "clip",
        agent: Agent | None = None,
    ) -> Self:
        """A policy of a task, from the task's config; the other arguments are those of the class."""
        return cls(
            tuple(weights),
            tuple(biases),
            activation,
            config.control,
            config.definition.observations,
            config.to_dict(),
            card,
            config.robot,
            output,
            task_config=config,
            agent=agent,
        )

    @classmethod
    def from_sb3(cls, model: Any, card: dict[str, Any] | None = None) -> "Policy":
        """The deterministic part of a Stable-Baselines3 (or sb3-contrib) model that was trained on this package's env.

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
        policy: Policy = _later("sb3_policies").from_sb3(model, card)
        return policy

    @functools.cached_property
    def config(self) -> "TaskConfig":
        """Config of the task that it was trained for, with the terms that are known here.

        Raises:
            QuadrupedError: if the task is not valid here.
        """
        config: TaskConfig = self.task_config or _later("policy_task").config_of(self)
        return config

    def with_card(self, card: dict[str, Any]) -> Self:
        """The same policy with another card."""
        return replace(self, card=card)

    def make_env(self, **kwargs: Any) -> "Env[NDArray[np.float32], NDArray[np.float32]]":
        """The environment that the policy was trained for: its task, action mode and control rate.

        Args:
            **kwargs: arguments of `gymnasium.make`, such as `render_mode`, or `terrain` for another ground.

        Raises:
            QuadrupedError: if `kwargs` name another task than the policy's.
        """
        env: Env[NDArray[np.float32], NDArray[np.float32]] = _later("policy_task").make_env(self, **kwargs)
        return env

    def make_vec_env(self, num_envs: int, **kwargs: Any) -> "VectorEnv[Any, Any, Any]":
        """A native vector environment of the task that the policy was trained for.

        Args:
            num_envs: number of robots.
            **kwargs: arguments of `gymnasium.make_vec`, such as `max_episode_steps`.

        Raises:
            QuadrupedError: if `kwargs` name another task than the policy's.
        """
        envs: VectorEnv[Any, Any, Any] = _later("policy_task").make_vec_env(self, num_envs, **kwargs)
        return envs

    @property
    def action_mode(self) -> str:
        """`position` or `residual`: the mode of the task that the policy runs on."""
        return self.control.action.mode

    def predict(self, observation: NDArray[np.float32]) -> NDArray[np.float32]:
        """Actions (..., 8) in [-1, 1] for observations (..., obs).

        Raises:
            QuadrupedError: if the last axis has another length than an observation.
        """
        x = np.asarray(observation, dtype=np.float32)
        if self.agent is not None:
            return self._ask(self.agent, x)
        if x.shape[-1:] != self.weights[0].shape[:1]:
            raise QuadrupedError(
                f"policy: expected observations of shape (..., {self.weights[0].shape[0]}); found {x.shape}"
            )
        activate = ACTIVATIONS[self.activation]
        for weight, bias in zip(self.weights[:-1], self.biases[:-1], strict=True):
            x = activate(x @ weight + bias)
        return OUTPUTS[self.output](x @ self.weights[-1] + self.biases[-1])

    def _ask(self, agent: Agent, observation: NDArray[np.float32]) -> NDArray[np.float32]:
        """Actions of an agent, clipped."""
        actions = np.asarray(agent.predict(observation))
        expected = (*observation.shape[:-1], self.robot.num_joints)
        if actions.shape != expected or not np.issubdtype(actions.dtype, np.floating):
            raise QuadrupedError(
                f"{self.source}: predict: expected an array of numbers of shape {expected}; found {actions.dtype} of "
                f"shape {actions.shape}"
            )
        if not np.isfinite(actions).all():
            raise QuadrupedError(f"{self.source}: predict: an action is not finite; return numbers in [-1, 1]")
        return np.clip(actions, -1.0, 1.0).astype(np.float32)

    def check_is_data(self, use: str) -> None:
        """Check that a policy has weights that give finite actions, for a use that needs its file.

        Raises:
            QuadrupedError: if it is code, or as `check_finite`.
        """
        if self.agent is not None:
            raise QuadrupedError(
                f"{use}: {self.source} is a policy of Python code, and this takes policies of files: the directory of "
                f"a run, or of Policy.from_sb3(model).save(DIR), which holds any MLP of Stable-Baselines3"
            )
        self.check_finite(use)

    def check_finite(self, where: str) -> None:
        """Check that the actions are finite for every observation within its bounds, in float32.

        A bound on the absolute values after each layer is computed from that before it, by interval arithmetic. It is
        sound: what passes cannot overflow, in whatever order a library or a microcontroller sums.

        Args:
            where: beginning of the error message, such as the file.

        Raises:
            QuadrupedError: if a weight is not finite, or the bound exceeds what float32 can hold.
        """
        activate = ACTIVATIONS[self.activation]
        bound = np.tile(ObservationLayout(self.robot, self.fields).high, self.control.observation_history)
        for i, (weight, bias) in enumerate(zip(self.weights, self.biases, strict=True)):
            finite = np.isfinite(weight).all() and np.isfinite(bias).all()
            with np.errstate(all="ignore"):
                bound = bound @ np.abs(weight.astype(np.float64)) + np.abs(bias)
                if not finite or not (bound <= _LARGEST).all():
                    problem = "can exceed float32" if finite else "holds NaN or infinity"
                    raise QuadrupedError(
                        f"{where}: layer{i} {problem}, so that joint targets become NaN; the training diverged, train "
                        f"again with a lower --learning-rate, or go on from an earlier checkpoint"
                    )
                largest = bound.astype(np.float32)
                bound = np.maximum(np.abs(activate(largest)), np.abs(activate(-largest))).astype(np.float64)

    def check_control(self, control: ControlConfig) -> None:
        """Check that actions have the same meaning in a task as in training.

        Raises:
            QuadrupedError: if the action mode, action scale, control rate, gait clock or length of the observation's
                history differs from the policy's.
        """
        own = self.control
        for name, expected, found in (
            ("action.mode", own.action.mode, control.action.mode),
            (f"action.{own.action.mode}_scale", own.action.scale, control.action.scale),
            *([("action.gait", own.action.gait, control.action.gait)] if own.action.mode == "residual" else []),
            ("control_timestep", own.timestep, control.timestep),
            ("clock_frequency", own.clock_frequency, control.clock_frequency),
            ("observation_history", own.observation_history, control.observation_history),
        ):
            if expected != found:
                raise QuadrupedError(
                    f"policy: it was trained with {name} {expected!r}, and this environment has {found!r}; "
                    f"make its own with policy.make_env()"
                )

    def check_observations(self, layout: ObservationLayout) -> None:
        """Check that a task's observations are those that the policy was trained on.

        Raises:
            QuadrupedError: if a field is missing or another one, or differs in its width, unit, scale or bounds.
        """
        expected, found = ObservationLayout(self.robot, self.fields).document(), layout.document()
        if expected != found:
            own, other = ([entry["name"] for entry in fields] for fields in (expected, found))
            differing = [a["name"] for a, b in zip(expected, found, strict=False) if a != b]
            what = f"has {', '.join(other)}" if own != other else f"differs in {', '.join(differing)}"
            raise QuadrupedError(
                f"policy: it was trained on the observations {', '.join(own)}, and this environment {what}; make its "
                f"own with policy.make_env()"
            )

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
        config: Any = getattr(getattr(inner, "task", None), "config", None)
        members = getattr(inner, "envs", None)
        if config is None and isinstance(members, (list, tuple)) and members:
            for member in members:
                self.check_env(member)
            return
        if not isinstance(getattr(config, "control", None), ControlConfig):
            raise QuadrupedError(
                f"policy: {env!r} is not an environment of this package; make one with policy.make_env()"
            )
        self.check_task(config)

    def check_task(self, config: "TaskConfig") -> None:
        """As `check_env`, for the config of a task. Fields that do not change these meanings may differ.

        Raises:
            QuadrupedError: if the robot, action mode, action scale, control rate, gait clock or observations differ
                from the policy's.
        """
        check_same_robot(self.robot.identity, config.robot)
        self.check_control(config.control)
        self.check_observations(ObservationLayout(config.robot, config.definition.observations))

    def save(self, directory: str | Path) -> None:
        """Write the policy's two files into a directory, which is created if it does not exist.

        Raises:
            QuadrupedError: as `check_is_data`, or if the files cannot be written; in both cases no file is written.
        """
        directory, files = Path(directory), self.files()
        try:
            directory.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise unwritable(directory, error) from error
        write_whole({directory / name: content for name, content in files.items()})

    def files(self) -> dict[str, bytes]:
        """Contents of the files that `save` writes, by name; the card is last.

        Raises:
            QuadrupedError: as `check_is_data`.
        """
        self.check_is_data("save")
        tensors = {}
        for i, (weight, bias) in enumerate(zip(self.weights, self.biases, strict=True)):
            tensors[f"layer{i}.weight"], tensors[f"layer{i}.bias"] = np.ascontiguousarray(weight), bias
        content = save(tensors)
        document = {
            "format_version": FORMAT_VERSION,
            "weights_sha256": hashlib.sha256(content).hexdigest(),
            "config_sha256": config_hash(self.task),
            "activation": self.activation,
            "output": self.output,
            "layers": len(self.weights),
            "robot": self.robot.identity,
            "observation_layout": ObservationLayout(self.robot, self.fields).document(),
            "action_mode": self.action_mode,
            "scripted_gait": gait_document(self.control, self.robot),
            "control_rate_hz": 1.0 / self.control.timestep,
            "config": self.task,
            "card": self.card,
        }
        return {TENSORS_FILE: content, CARD_FILE: (json.dumps(document, indent=2) + "\n").encode()}


def config_hash(config: Any) -> str:
    """SHA-256 of a task's config, independent of the layout of the JSON."""
    return hashlib.sha256(json.dumps(config, sort_keys=True).encode()).hexdigest()


def gait_document(control: ControlConfig, robot: Robot) -> dict[str, Any] | None:
    """Scripted gait of a residual policy as JSON values; None for other policies."""
    gait = control.action.scripted_gait(robot, control.clock_frequency)
    return None if gait is None else gait.parameters()


def _later(module: str) -> ModuleType:
    """A module of `policies`, which a robot's controller never loads: it needs neither the task nor the env."""
    return importlib.import_module(f"quadruped_env.policies.{module}")
