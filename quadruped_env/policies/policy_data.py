"""A trained policy as data: weights and the meaning of its observations and actions, evaluated with NumPy alone.

A robot's controller needs no more; `quadruped_env.policies.policy` adds the task.
"""

import hashlib
import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.observations import ObservationField, ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.policies.activations import ACTIVATIONS, OUTPUTS
from quadruped_env.robot.robot import Robot, check_same_robot
from quadruped_env.utils.files import unwritable, write_whole

FORMAT_VERSION: Final = 1
TENSORS_FILE: Final = "policy.safetensors"
CARD_FILE: Final = "policy.json"
_LARGEST: Final = 1e38
"""Bound of the values between layers: a third of float32's largest, for the rounding of sums in any order."""
_ONE_THREAD: Final = 2**18
"""Multiplications of a matrix product that OpenBLAS does not share out among threads."""
_FEWEST_ROWS: Final = 8
"""Rows of a matrix product from which on it is worth a call of its own."""


@dataclass(frozen=True)
class PolicyData:
    """A deterministic policy: a small multilayer perceptron with the meaning of its observations and actions.

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
    """

    weights: tuple[NDArray[np.float32], ...]
    biases: tuple[NDArray[np.float32], ...]
    activation: str
    control: ControlConfig
    fields: tuple[ObservationField, ...]
    task: dict[str, Any]
    card: dict[str, Any]
    robot: Robot
    output: str = "clip"
    source: str = CARD_FILE

    def with_card(self, card: dict[str, Any]) -> Self:
        """Return the same policy with another card."""
        return replace(self, card=card)

    @property
    def action_mode(self) -> str:
        """`position` or `residual`: the mode of the task that the policy runs on."""
        return self.control.action.mode

    @property
    def layout(self) -> ObservationLayout:
        """Columns of its observation, with the history."""
        return ObservationLayout(self.robot, self.fields, self.control.observation_history)

    def begin(self, begun: NDArray[np.bool_]) -> None:
        """Called before `predict` where an episode begins in some envs, a mask (N,); a network has no memory."""

    def predict(self, observation: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return the actions (..., J) in [-1, 1] for observations (..., obs).

        Raises:
            QuadrupedError: if the last axis has another length than an observation.
        """
        x = np.asarray(observation, dtype=np.float32)
        if x.shape[-1:] != self.weights[0].shape[:1]:
            raise QuadrupedError(
                f"policy: expected observations of shape (..., {self.weights[0].shape[0]}); found {x.shape}"
            )
        activate = ACTIVATIONS[self.activation]
        for weight, bias in zip(self.weights[:-1], self.biases[:-1], strict=True):
            x = activate(_product(x, weight) + bias)
        return OUTPUTS[self.output](_product(x, self.weights[-1]) + self.biases[-1])

    def check_is_data(self, where: str) -> None:
        """Check that the policy can be used where its file is needed.

        It has weights, and its actions are finite for every observation within its bounds, in float32.
        A bound on the absolute values after each layer is computed from that before it, by interval arithmetic. It is
        sound: what passes cannot overflow, in whatever order a library or a microcontroller sums. `where`, such as the
        file, begins the error message.

        Raises:
            QuadrupedError: if the policy is code, a weight is not finite, or the bound exceeds what float32 can hold.
        """
        activate = ACTIVATIONS[self.activation]
        bound = np.tile(self.layout.high, self.layout.history)
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

    def check_fits(self, robot: Robot, control: ControlConfig, layout: ObservationLayout | None = None) -> None:
        """Check that actions and observations have the same meaning in a task as in training.

        Without a layout the task's observations are the policy's own.

        Raises:
            QuadrupedError: if the robot, action mode, action scale, scripted gait, control rate, gait clock, length of
                the history, or a field of the observations or its width, unit, scale or bounds is another one.
        """
        check_same_robot(self.robot.identity, robot)
        own, fields = self.control, self.layout.document()
        other = fields if layout is None else layout.document()
        for name, expected, found in (
            ("action.mode", own.action.mode, control.action.mode),
            (f"action.{own.action.mode}_scale", own.action.scale, control.action.scale),
            *([("action.gait", own.action.gait, control.action.gait)] if own.action.mode == "residual" else []),
            ("control_timestep", own.timestep, control.timestep),
            ("clock_frequency", own.clock_frequency, control.clock_frequency),
            ("observation_history", own.observation_history, control.observation_history),
            ("the observations", *(", ".join(entry["name"] for entry in each) for each in (fields, other))),
            *((f"the observation {mine['name']}", mine, theirs) for mine, theirs in zip(fields, other, strict=False)),
        ):
            if expected != found:
                raise QuadrupedError(
                    f"policy: it was trained with {name} {expected!r}, and this environment has {found!r}; "
                    f"make its own with policy.make_env()"
                )

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
        """Return the contents of the files that `save` writes, by name; the card is last.

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
            "observation_layout": self.layout.document(),
            "action_mode": self.action_mode,
            "scripted_gait": gait_document(self.control, self.robot),
            "control_rate_hz": 1.0 / self.control.timestep,
            "config": self.task,
            "card": self.card,
        }
        return {TENSORS_FILE: content, CARD_FILE: (json.dumps(document, indent=2) + "\n").encode()}


def config_hash(config: Any) -> str:
    """Return the SHA-256 of a task's config, independent of the layout of the JSON."""
    return hashlib.sha256(json.dumps(config, sort_keys=True).encode()).hexdigest()


def gait_document(control: ControlConfig, robot: Robot) -> dict[str, Any] | None:
    """Return the scripted gait of a residual policy as JSON values; None for other policies."""
    gait = control.action.scripted_gait(robot, control.clock_frequency)
    return None if gait is None else gait.parameters()


def _product(x: NDArray[np.float32], weight: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the matrix product, in blocks of rows that are too small for threads.

    After such a product the threads of a BLAS wait for the next one on the cores that the physics needs.
    """
    rows = _ONE_THREAD // weight.size
    if x.ndim != 2 or not _FEWEST_ROWS <= rows < len(x):
        return x @ weight
    return np.concatenate([block @ weight for block in np.array_split(x, -(-len(x) // rows))])
