"""Networks in ONNX files: a chain of linear layers and activation functions, such as rsl_rl's and mjlab's export."""

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

import numpy as np

from quadruped_env.errors import MissingExtraError, QuadrupedError, short
from quadruped_env.policies.activations import ACTIVATIONS, BY_CLASS
from quadruped_env.policies.layers import Actor, Network, check_fits, samples
from quadruped_env.task import TaskConfig
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.documents import check_regular

_TRANSPARENT: Final = ("Identity", "Flatten", "Dropout", "Cast")
"""Operators that change nothing in float32."""


_AFFINE: Final[Mapping[str, Callable[[Floats, float], tuple[Floats, Floats]]]] = MappingProxyType(
    {
        "Add": lambda c, _: (np.ones(1), c),
        "Sub": lambda c, sign: (np.full(1, sign), -sign * c),
        "Mul": lambda c, _: (c, np.zeros(1)),
        "Div": lambda c, _: (1.0 / c, np.zeros(1)),
    }
)
"""Operator with a constant c -> scale and shift of the value; the sign is -1 for c - x."""


def actor_of(path: Path, config: TaskConfig) -> Actor:
    """Return the actor of a file that fits a task's observations and actions; see `Policy.from_onnx`."""
    try:
        import onnx
        from onnx.reference import ReferenceEvaluator
    except ImportError as error:
        raise MissingExtraError("A policy from ONNX", "export") from error
    check_regular(path, "name an ONNX file")
    try:
        model = onnx.load(path)  # with the weights next to it, where torch writes them for large networks
        onnx.checker.check_model(model)
        network = _network(path, model.graph, onnx)
    except QuadrupedError:
        raise
    except Exception as error:  # of protobuf, of the checker, and of missing files of weights
        raise QuadrupedError(
            f"{path}: cannot be read as ONNX ({type(error).__name__}: {short(str(error))}); export it again"
        ) from error
    width = len(network.layers[0][0])
    check_fits(path, (width,), (len(network.layers[-1][1]),), config)
    seen, evaluator, (given,) = samples(width), ReferenceEvaluator(model), _inputs(model.graph)
    # One by one: the graph may be of one env.
    actions = np.concatenate([evaluator.run(None, {given.name: row[None]})[0].reshape(1, -1) for row in seen])
    return Actor(network, config, seen, np.clip(actions, -1.0, 1.0), "the graph", _refused(path))


def _refused(path: Path) -> Callable[[str], QuadrupedError]:
    def refused(reason: str) -> QuadrupedError:
        return QuadrupedError(
            f"{path}: {reason}; a policy can be a chain of linear layers (Gemm, MatMul and Add) with one activation "
            f"function between them ({', '.join(ACTIVATIONS)}, x * Sigmoid(x)), with or without a normalization "
            f"before it; export its actor alone, or use the protocol of two methods, reset and predict "
            f"(docs/training.md#your-own-algorithm)"
        )

    return refused


def _inputs(graph: Any) -> list[Any]:
    """Return the inputs of a graph that are not weights."""
    weights = {entry.name for entry in graph.initializer}
    return [entry for entry in graph.input if entry.name not in weights]


def _network(path: Path, graph: Any, onnx: Any) -> Network:
    """Return the network of a graph in which each node reads the value of the one before."""
    refused = _refused(path)
    if len(_inputs(graph)) != 1 or len(graph.output) != 1:
        raise refused(f"the graph has {len(_inputs(graph))} inputs and {len(graph.output)} outputs, not one of each")
    constants = {entry.name: onnx.numpy_helper.to_array(entry).astype(np.float64) for entry in graph.initializer}
    chain = _Chain(refused)
    value = before = _inputs(graph)[0].name
    for node in graph.node:
        kind = node.op_type
        attributes = {entry.name: onnx.helper.get_attribute_value(entry) for entry in node.attribute}
        if kind == "Constant":
            constants[node.output[0]] = onnx.numpy_helper.to_array(attributes["value"]).astype(np.float64)
            continue
        given = [constants[name] for name in node.input if name in constants]
        read = [name for name in node.input if name and name not in constants]
        if kind == "Mul" and sorted(read) == sorted((value, before)) and chain.activations[-1:] == ["sigmoid"]:
            chain.activations[-1] = "silu"  # x * sigmoid(x)
        elif read == [value]:
            chain.add(kind, given, attributes, node.input[0] == value)
        else:
            raise refused(f"its operator {kind} does not read the value before it alone")
        before, value = value, node.output[0]
    return chain.network()


class _Chain:
    """The layers of a chain of operators, in float64; `refused` makes the error from a reason."""

    def __init__(self, refused: Callable[[str], QuadrupedError]) -> None:
        self._refused = refused
        self._layers: list[tuple[Floats, Floats]] = []
        self.activations: list[str] = []
        self._before: tuple[Floats, Floats] = np.ones(1), np.zeros(1)
        """Scale and shift of the values that the next layer reads."""
        self._clipped = False

    def add(self, kind: str, given: list[Floats], attributes: dict[str, Any], value_first: bool) -> None:
        """Add an operator with its constants; `value_first`: its first input is the value, not a constant."""
        linear = len(self._layers) > len(self.activations)  # the last operator that counts was a layer
        if kind in _TRANSPARENT:
            return
        if self._clipped:
            raise self._refused(f"it has the operator {kind} after its Clip")
        if kind in ("Gemm", "MatMul") and value_first and not linear and not attributes.get("transA"):
            weight = attributes.get("alpha", 1.0) * (given[0].T if attributes.get("transB") else given[0])
            bias = np.zeros(weight.shape[1]) + (attributes.get("beta", 1.0) * given[1] if len(given) > 1 else 0.0)
            scale, shift = (np.broadcast_to(part, len(weight)) for part in self._before)
            self._layers.append((scale[:, None] * weight, bias + shift @ weight))
            self._before = np.ones(1), np.zeros(1)
        elif kind in _AFFINE and len(given) == 1 and (value_first or kind != "Div"):
            factor, offset = _AFFINE[kind](given[0].reshape(-1), 1.0 if value_first else -1.0)
            if linear:
                weight, bias = self._layers[-1]
                self._layers[-1] = weight * factor, bias * factor + offset
            else:
                scale, shift = self._before
                self._before = scale * factor, shift * factor + offset
        elif kind.lower() in BY_CLASS and linear:
            self.activations.append(BY_CLASS[kind.lower()])
        elif kind == "Clip" and [*given, attributes.get("min"), attributes.get("max")][:2] == [-1.0, 1.0]:
            self._clipped = True
        else:
            raise self._refused(f"it has the operator {kind} here")

    def network(self) -> Network:
        """Return the network, which has to end with a layer, or with Tanh behind it."""
        activations, output = list(self.activations), "clip"
        if activations[-1:] == ["tanh"] and len(activations) == len(self._layers):
            output = activations.pop()
        scale, shift = self._before
        if len(activations) != len(self._layers) - 1 or (scale != 1.0).any() or shift.any():
            raise self._refused("it does not end with a linear layer, or with Tanh behind one")
        if len(set(activations)) > 1:
            raise self._refused(f"it has the activation functions {', '.join(dict.fromkeys(activations))}")
        layers = [(weight.astype(np.float32), bias.astype(np.float32)) for weight, bias in self._layers]
        return Network(layers, activations[0] if activations else "tanh", output)
