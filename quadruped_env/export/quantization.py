"""Weights of 8 bits for the C form of a policy, and what they cost."""

import dataclasses
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.comparison import Command, commands_for, evaluation_task
from quadruped_env.evaluation.metrics import measure
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.onnx_interface import PolicyInterface
from quadruped_env.export.runtime import SAMPLES, expected_outputs, random_inputs
from quadruped_env.policies import Policy, PolicyController

COMMANDS: Final[tuple[Command, ...]] = ((0.2, 0.0), (0.4, 0.0), (-0.2, 0.0), (0.0, 0.5), (0.3, -0.5), (0.0, 0.0))
"""Velocity commands of the walking test, m/s and rad/s, for the built-in robot."""
SECONDS: Final = 8.0
"""Length of each of its episodes, s."""

_LARGEST: Final = 127
_METRICS: Final = ("forward_velocity_error", "yaw_rate_error", "fall_rate")


def as_int8(weight: NDArray[np.float32]) -> tuple[NDArray[np.int8], NDArray[np.float32]]:
    """Weights (in, out) as integers in [-127, 127], and the step of each output (out,): weight = integer * step."""
    step = np.abs(weight).max(axis=0) / np.float32(_LARGEST)
    step = np.where(step > 0.0, step, np.float32(1.0))
    return np.rint(weight / step).astype(np.int8), step


def quantized(policy: Policy) -> Policy:
    """The policy whose weights are what the integers stand for."""
    weights = (integers * step for integers, step in map(as_int8, policy.weights))
    return dataclasses.replace(policy, weights=tuple(weight.astype(np.float32) for weight in weights))


def int8_loss(policy: Policy) -> dict[str, Any]:
    """Differences of the policy with weights of 8 bits, as plain values.

    Actions and joint targets are compared on the random readings that the ONNX graph is compared on, which are farther
    from the stance than those of a walk. Then both policies walk the same episodes of the task.
    """
    other = quantized(policy)
    interfaces = PolicyInterface(policy), PolicyInterface(other)
    inputs = random_inputs(interfaces[0], SAMPLES)
    one, two = (expected_outputs(interface, inputs) for interface in interfaces)
    loss: dict[str, Any] = {"readings": SAMPLES}
    for name, unit in ((graph_io.ACTION, ""), (graph_io.JOINT_TARGET, "_rad")):
        difference = two[name].astype(np.float64) - one[name]
        loss |= {
            f"{name}_rms{unit}": float(np.sqrt(np.square(difference).mean())),
            f"{name}_largest{unit}": float(np.abs(difference).max()),
        }
    return {**loss, "walking": {"float32": _walking(policy), "int8": _walking(other)}}


def _walking(policy: Policy) -> dict[str, float]:
    """Means of metrics over an episode per command."""
    commands = commands_for(policy.robot, COMMANDS)
    task = evaluation_task(policy.config, commands, "none")
    values = measure(roll_out(PolicyController(policy), commands, (FIRST_SEED,), SECONDS, task))
    return {name: float(np.mean(values[name])) for name in _METRICS}
