"""The ONNX graph of a policy: from sensor readings to joint targets, without any code of this package."""

import functools
import math
from collections.abc import Mapping
from typing import Any, Final, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env._version import __version__
from quadruped_env.control import observations
from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.errors import MissingExtraError
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.onnx_interface import Input, PolicyInterface

OPSET: Final = 18
"""Version of ONNX's operators: ONNX Runtime runs it from 1.14 on."""
SWING: Final = "gait_swing"
"""Name of an inner value: joint positions (N, J) of the scripted gait relative to the middle of its swing, rad."""
BATCH: Final = "batch"
"""Name of the first axis of all inputs and outputs, of any length."""

_FLOAT: Final = 1
"""ONNX's number of the type float32."""
_OPERATORS: Final = {
    "elu": "Elu",
    "tanh": "Tanh",
    "relu": "Relu",
    "leaky_relu": "LeakyRelu",
    "softplus": "Softplus",
    "selu": "Selu",
    "sigmoid": "Sigmoid",
}
"""Activation function of a policy -> ONNX operator, whose attributes have the same defaults; see `_activation`."""


def policy_graph(interface: PolicyInterface, name: str, metadata: Mapping[str, str] | None = None) -> bytes:
    """Return the graph of a policy as an ONNX file.

    It takes every input of `PolicyInterface.inputs`, computes the observation from them (offset, scale, clipping, gait
    clock), the network's action, and the joint targets, to which in `residual` mode the scripted gait belongs.

    Args:
        interface: inputs and outputs of the policy.
        name: name of the graph.
        metadata: entries of the file's `metadata_props`.

    Raises:
        MissingExtraError: if onnx is not installed.
    """
    return Graph.of(interface).onnx(name, interface.inputs, interface.outputs, metadata or {})


def _clock(graph: "Graph", interface: PolicyInterface) -> tuple[str, str]:
    """Return sine and cosine of the phase, 0 where standing is commanded (N, 2), and the next phase (N, 1)."""
    if not interface.has_clock:
        return "", ""
    threshold = graph.constant(moving_threshold(interface.policy.robot))
    fast = graph.add("Cast", graph.add("Greater", graph.add("Abs", graph_io.COMMAND), threshold), to=_FLOAT)
    count = graph.add("MatMul", fast, graph.constant(np.ones((interface.policy.control.num_velocities, 1))))
    moving = graph.add("Min", count, graph.constant(1.0))
    both = graph.add("Concat", graph.add("Sin", graph_io.GAIT_PHASE), graph.add("Cos", graph_io.GAIT_PHASE), axis=1)
    later = graph.add("Add", graph_io.GAIT_PHASE, graph.constant(interface.phase_step))
    phase = graph.add("Mod", later, graph.constant(math.tau), fmod=1, output=graph_io.NEXT_GAIT_PHASE)
    return graph.add("Mul", both, moving), phase


def _observation(graph: "Graph", interface: PolicyInterface, clock: str) -> str:
    """Return the observation (N, width): each input minus its offset, scaled and clipped."""
    layout = interface.layout
    columns = [clock if entry is observations.gait_clock else entry.name for entry in interface.policy.fields]
    readings = graph.add("Concat", *columns, axis=1)
    relative = graph.add("Sub", readings, graph.constant(interface.offsets))
    scaled = graph.add("Mul", relative, graph.constant(layout.scale))
    return graph.clipped(scaled, layout.low, layout.high)


def _with_history(graph: "Graph", interface: PolicyInterface, present: str) -> str:
    """Return the observation of this step and of those before (N, history * width)."""
    width = interface.history_width
    if not width:
        return present
    repeated = graph.add("Concat", *[present] * (interface.layout.history - 1), axis=1)
    past = graph.add("Where", graph.add("IsNaN", graph_io.HISTORY), repeated, graph_io.HISTORY)
    stacked = graph.add("Concat", present, past, axis=1)
    start, end, axis = (graph.integers([value]) for value in (0, width, 1))
    graph.add("Slice", stacked, start, end, axis, output=graph_io.NEXT_HISTORY)
    return stacked


def _network(graph: "Graph", interface: PolicyInterface, observation: str) -> str:
    """Return the action (N, J) in [-1, 1]."""
    policy = interface.policy
    *inner, last = zip(policy.weights, policy.biases, strict=True)
    x = observation
    for weight, bias in inner:
        x = _activation(graph, policy.activation, graph.add("Gemm", x, graph.constant(weight), graph.constant(bias)))
    x = graph.add("Gemm", x, graph.constant(last[0]), graph.constant(last[1]))
    if policy.output == "tanh":
        return graph.add("Tanh", x, output=graph_io.ACTION)
    return graph.clipped(x, -1.0, 1.0, output=graph_io.ACTION)


def _activation(graph: "Graph", name: str, x: str) -> str:
    """Return an activation function, made of operators of `OPSET`: Gelu came with 20."""
    if name == "silu":
        return graph.add("Mul", x, graph.add("Sigmoid", x))
    if name == "mish":
        return graph.add("Mul", x, graph.add("Tanh", graph.add("Softplus", x)))
    if name == "gelu":
        share = graph.add("Erf", graph.add("Mul", x, graph.constant(math.sqrt(0.5))))
        half = graph.add("Mul", x, graph.constant(0.5))
        return graph.add("Mul", half, graph.add("Add", share, graph.constant(1.0)))
    return graph.add(_OPERATORS[name], x)


def _joint_target(graph: "Graph", interface: PolicyInterface, action: str, phase: str) -> None:
    """Return the joint targets (N, J): stance or scripted gait plus the scaled action, within the joints' ranges."""
    policy, robot = interface.policy, interface.policy.robot
    change = graph.add("Mul", action, graph.constant(policy.control.action.scale))
    nominal = graph.constant(robot.stance) if interface.gait is None else _gait(graph, interface, phase)
    target = graph.add("Add", change, nominal)
    graph.clipped(target, robot.joint_position_low, robot.joint_position_high, output=graph_io.JOINT_TARGET)


def _gait(graph: "Graph", interface: PolicyInterface, phase: str) -> str:
    """Return the joint positions (N, J) of the scripted gait; see `CommandedGait.waves`."""
    gait = interface.gait
    assert gait is not None
    knots = np.array(gait.speeds)
    widths = np.diff(knots)
    columns = np.eye(len(interface.velocities))[:, :, None]
    velocities = [graph.add("MatMul", graph_io.COMMAND, graph.constant(column)) for column in columns]
    speed, yaw_rate, *lateral = velocities
    shares = [
        graph.add("Div", graph.add("Abs", value), graph.constant(whole))
        for value, whole in zip(velocities, gait.whole_steps, strict=False)
    ]
    fade = graph.add("Min", functools.reduce(functools.partial(graph.add, "Max"), shares), graph.constant(1.0))
    # See `CommandedGait.turn_size`.
    rate = graph.add("Min", graph.add("Abs", yaw_rate), graph.constant(gait.largest_yaw_rate))
    turning = rate
    if gait.lateral is None:
        turning = graph.add("Sqrt", graph.add("Mul", rate, graph.constant(gait.largest_yaw_rate)))
    size = graph.add("Mul", graph.add("Sign", yaw_rate), turning)
    # Part of the speed within each interval of the table (N, K - 1).
    parts = graph.clipped(graph.add("Sub", speed, graph.constant(knots[:-1])), 0.0, widths)

    def interpolated(table: NDArray[np.float64]) -> str:
        change = graph.add("MatMul", parts, graph.constant(np.diff(table, axis=0) / widths[:, None]))
        return graph.add("Add", change, graph.constant(table[0]))

    waves = []
    at_rest = (np.zeros(1), np.zeros(1), interface.policy.robot.stance)
    for part, resting in enumerate(at_rest):
        straight = interpolated(gait.straight[part])
        whole = graph.add("Add", straight, graph.add("Mul", turning, interpolated(gait.turn[part])))
        whole = graph.add("Add", whole, graph.add("Mul", size, interpolated(gait.side[part])))
        if gait.lateral is not None:
            whole = graph.add("Add", whole, graph.add("Mul", *lateral, interpolated(gait.lateral[part])))
        rest = graph.constant(resting)
        waves.append(graph.add("Add", rest, graph.add("Mul", fade, graph.add("Sub", whole, rest))))
    sine, cosine, offset = waves
    angle = graph.add("Add", phase, graph.constant(interface.joint_phases))
    swing = graph.add(
        "Add",
        graph.add("Mul", sine, graph.add("Sin", angle)),
        graph.add("Mul", cosine, graph.add("Cos", angle)),
        output=SWING,
    )
    return graph.add("Add", swing, offset)


class Graph:
    """A graph of ONNX's operators, whose values are named in the order in which they are added.

    It is data, and needs no library until `onnx` makes a file of it.
    """

    def __init__(self) -> None:
        self.nodes: list[tuple[str, tuple[str, ...], str, dict[str, Any]]] = []
        """Operator, names of the inputs, name of the output, and attributes of each node, in order."""
        self.constants: dict[str, NDArray[Any]] = {}
        """Constants by name, float32 or int64."""

    @classmethod
    def of(cls, interface: PolicyInterface) -> Self:
        """Return the graph of a policy; see `policy_graph`."""
        graph = cls()
        clock, phase = _clock(graph, interface)
        observation = _with_history(graph, interface, _observation(graph, interface, clock))
        _joint_target(graph, interface, _network(graph, interface, observation), phase)
        return graph

    @classmethod
    def of_gait(cls, interface: PolicyInterface) -> Self:
        """Return the graph of a `residual` policy without its actions: the joint targets of the scripted gait alone."""
        graph = cls()
        _, phase = _clock(graph, interface)
        _joint_target(graph, interface, graph.constant(np.zeros(interface.policy.robot.num_joints)), phase)
        return graph

    def add(self, operator: str, *inputs: str, output: str = "", **attributes: Any) -> str:
        """Add a node; returns the name of its result."""
        output = output or f"{operator.lower()}_{len(self.nodes)}"
        self.nodes.append((operator, inputs, output, attributes))
        return output

    def clipped(self, value: str, low: ArrayLike, high: ArrayLike, output: str = "") -> str:
        """Return a value within bounds, which broadcast; NaN stays NaN."""
        return self.add("Min", self.add("Max", value, self.constant(low)), self.constant(high), output=output)

    def constant(self, values: ArrayLike) -> str:
        """Name of a constant, float32."""
        return self._constant(np.asarray(values, dtype=np.float32))

    def integers(self, values: ArrayLike) -> str:
        """Name of a constant, int64."""
        return self._constant(np.asarray(values, dtype=np.int64))

    def _constant(self, values: NDArray[Any]) -> str:
        name = f"constant_{len(self.constants)}"
        self.constants[name] = np.ascontiguousarray(values)
        return name

    def onnx(
        self, name: str, inputs: tuple[Input, ...], outputs: tuple[Input, ...], metadata: Mapping[str, str]
    ) -> bytes:
        """Return the checked graph as a file. Raises a MissingExtraError if onnx is not installed."""
        try:
            import onnx
        except ImportError as error:
            raise MissingExtraError("Export to ONNX", "export") from error
        helper: Any = onnx.helper

        def value(entry: Input) -> Any:
            text = f"{entry.description} Unit: {entry.unit}."
            return helper.make_tensor_value_info(entry.name, _FLOAT, [BATCH, entry.width], text)

        graph = helper.make_graph(
            [helper.make_node(node, read, [output], **attributes) for node, read, output, attributes in self.nodes],
            name,
            [value(entry) for entry in inputs],
            [value(entry) for entry in outputs],
            [onnx.numpy_helper.from_array(values, name) for name, values in self.constants.items()],
        )
        opsets = [helper.make_opsetid("", OPSET)]
        model = helper.make_model(
            graph,
            opset_imports=opsets,
            ir_version=helper.find_min_ir_version_for(opsets),
            producer_name="mini-quadruped",
            producer_version=__version__,
        )
        helper.set_model_props(model, metadata)
        onnx.checker.check_model(model, full_check=True)
        content: bytes = model.SerializeToString(deterministic=True)
        return content
