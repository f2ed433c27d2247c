"""Layers of networks that other libraries trained, as a policy's file holds them."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.task import TaskConfig

Layer = tuple[NDArray[np.float32], NDArray[np.float32]]
"""Weights (in, out) and biases (out,)"""
_SAMPLES: Final = 64
_TOLERANCE: Final = 1e-3
"""Largest difference of an action; more is not rounding."""


class Network(NamedTuple):
    """A multilayer perceptron."""

    layers: list[Layer]
    activation: str
    """Activation function between the layers, a key of `ACTIVATIONS`"""
    output: str
    """Function of the last layer's values, a key of `OUTPUTS`"""


class Actor(NamedTuple):
    """The network of another program's model, with what the model does."""

    network: Network
    config: TaskConfig
    """Config of its task."""
    observations: NDArray[np.float32]
    """Some observations (N, width)."""
    actions: NDArray[np.floating]
    """The model's own actions for them (N, J)."""
    kind: str
    """The model's class or form, for errors."""
    refused: Callable[[str], QuadrupedError]
    """Makes the error from its reason."""

    def check(self, actions: NDArray[np.float32]) -> None:
        """Refuse a policy whose actions differ from the model's by more than rounding.

        NaN passes, and is refused where a policy is saved.
        """
        difference = float(np.abs(actions - self.actions).max())
        if difference > _TOLERANCE:
            raise self.refused(
                f"{self.kind} computes its action in a way of its own: it differs from its layers by up to "
                f"{difference:.2g}"
            )


def samples(width: int) -> NDArray[np.float32]:
    """Return observations (N, width) on which a policy is compared with its origin."""
    return np.random.default_rng(0).uniform(-2.0, 2.0, (_SAMPLES, width)).astype(np.float32)


def affine_before(layer: Layer, scale: NDArray[Any], shift: NDArray[Any]) -> Layer:
    """Return the layer for inputs x (in,) where `layer` gets scale * x + shift, computed in float64."""
    weight, bias = (part.astype(np.float64) for part in layer)
    folded = scale[:, None] * weight, bias + shift @ weight
    return folded[0].astype(np.float32), folded[1].astype(np.float32)


def check_fits(source: Path, observation: object, action: object, config: TaskConfig) -> None:
    """Raise a QuadrupedError for a file whose shapes (columns,) and (joints,) do not fit the task."""
    history, fields = config.control.observation_history, config.definition.observations
    width = history * ObservationLayout(config.robot, fields).width
    columns = f"{history} x ({', '.join(entry.name for entry in fields)})"
    for what, found, expected, meaning, fix in (
        ("observations", observation, (width,), columns, "task"),
        ("actions", action, (config.robot.num_joints,), "one per joint", "robot"),
    ):
        if found != expected:
            raise QuadrupedError(
                f"{source}: its {what} have the shape {found}, and this task's have {expected}: {meaning}; give the "
                f"{fix} of its training with --task (config=... or task_file=... in Python). A policy of another env "
                f"cannot walk here"
            )
