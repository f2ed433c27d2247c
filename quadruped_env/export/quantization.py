"""Weights of 8 bits for the C form of a policy, and what they cost."""

import dataclasses
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.onnx_interface import PolicyInterface
from quadruped_env.export.runtime import SAMPLES, expected_outputs, random_inputs
from quadruped_env.policies import Policy

_LARGEST: Final = 127


def as_int8(weight: NDArray[np.float32]) -> tuple[NDArray[np.int8], NDArray[np.float32]]:
    """Weights (in, out) as integers in [-127, 127], and the step of each output (out,): weight = integer * step."""
    step = np.abs(weight).max(axis=0) / np.float32(_LARGEST)
    step = np.where(step > 0.0, step, np.float32(1.0))
    return np.rint(weight / step).astype(np.int8), step


def quantized(policy: Policy) -> Policy:
    """The policy whose weights are what the integers stand for."""
    weights = (integers * step for integers, step in map(as_int8, policy.weights))
    return dataclasses.replace(policy, weights=tuple(weight.astype(np.float32) for weight in weights))


def int8_loss(policy: Policy) -> dict[str, float]:
    """Differences of the policy with weights of 8 bits, on the readings that the ONNX graph is compared on.

    Those are farther from the stance than the readings of a walk.
    """
    interface = PolicyInterface(policy)
    inputs = random_inputs(interface, SAMPLES)
    one, two = expected_outputs(interface, inputs), expected_outputs(PolicyInterface(quantized(policy)), inputs)
    loss = {}
    for name, unit in ((graph_io.ACTION, ""), (graph_io.JOINT_TARGET, "_rad")):
        difference = two[name].astype(np.float64) - one[name]
        loss[f"{name}_rms{unit}"] = float(np.sqrt(np.square(difference).mean()))
        loss[f"{name}_largest{unit}"] = float(np.abs(difference).max())
    return loss
