"""Layers of networks that other libraries trained, as a policy's file holds them."""

from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.task import TaskConfig

Layer = tuple[NDArray[np.float32], NDArray[np.float32]]
"""Weights (in, out) and biases (out,)"""
SAMPLES: Final = 64
"""Observations on which a policy is compared with its origin."""
_TOLERANCE: Final = 1e-3
"""Largest difference of an action; more is not rounding."""


class Network(NamedTuple):
    """A multilayer perceptron."""

    layers: list[Layer]
    activation: str
    """Activation function between the layers, a key of `ACTIVATIONS`"""
    output: str
    """Function of the last layer's values, a key of `OUTPUTS`"""


def affine_before(layer: Layer, scale: NDArray[Any], shift: NDArray[Any]) -> Layer:
    """Return the layer for inputs x (in,) where `layer` gets scale * x + shift, computed in float64."""
    weight, bias = (part.astype(np.float64) for part in layer)
    folded = scale[:, None] * weight, bias + shift @ weight
    return folded[0].astype(np.float32), folded[1].astype(np.float32)


def check_fits(source: Path, observation: object, action: object, config: TaskConfig) -> None:
    """Refuse a network for another env.

    Args:
        source: the file that holds it.
        observation: shape of its observations; the task's is (columns,).
        action: shape of its actions, (joints,).
        config: config of the task.

    Raises:
        QuadrupedError: if a shape is not the task's.
    """
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


def check_same_actions(found: NDArray[Any], expected: NDArray[Any], refuse: Any, what: str) -> None:
    """Raise an error if actions differ by more than rounding; NaN passes, and is refused where a policy is saved.

    Args:
        found: actions of the policy.
        expected: actions of the model that it was made from.
        refuse: makes the error from its reason.
        what: the model's class or file.
    """
    difference = float(np.abs(found - expected).max())
    if difference > _TOLERANCE:
        error: QuadrupedError = refuse(
            f"{what} computes its action in a way of its own: it differs from its layers by up to {difference:.2g}"
        )
        raise error
