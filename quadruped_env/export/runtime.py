"""The graph of a policy on ONNX Runtime, compared with the policy that it was made from."""

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control import observations
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.onnx_interface import Input, PolicyInterface

Arrays = dict[str, NDArray[np.float32]]

SAMPLES: Final = 10_000
TOLERANCE: Final = 1e-4
"""Difference between the graph and the policy above which the export is refused; measured ones are below 1e-5."""

_REACH: Final = 1.25
"""Readings are drawn from this multiple of the range that is not clipped."""


def session_of(content: bytes) -> Any:
    """Return ONNX Runtime with a graph, on one thread of the processor; a MissingExtraError if it is not installed."""
    try:
        import onnxruntime
    except ImportError as error:
        raise MissingExtraError("Export to ONNX", "export") from error
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    return onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])


def run(session: Any, inputs: Arrays) -> Arrays:
    """Return the outputs of a graph by name."""
    names = [output.name for output in session.get_outputs()]
    return dict(zip(names, session.run(names, inputs), strict=True))


def random_inputs(interface: PolicyInterface, samples: int, seed: int = 0) -> Arrays:
    """Return random inputs (N, width): readings within and beyond the range that is clipped, commands, and phases.

    A tenth of the commands stand still, and a tenth of the histories is empty.
    """
    random = np.random.default_rng(seed)
    policy, layout = interface.policy, interface.layout

    def draw(entry: Input) -> NDArray[np.float64]:
        if entry.name == graph_io.GAIT_PHASE:
            return random.uniform(0.0, math.tau, (samples, 1))
        if entry.name == graph_io.COMMAND:
            low, high = np.array([command.range for command in policy.control.commands[: entry.width]]).T
            command = random.uniform(low, high, (samples, entry.width))
            command[::10] = 0.0
            return command
        if entry.name == graph_io.HISTORY:
            low, high = (np.tile(bound, layout.history - 1) for bound in (layout.low, layout.high))
            past = random.uniform(low, high, (samples, entry.width))
            past[::10] = np.nan
            return past
        columns = layout.slices[entry.name]
        reach = _REACH * layout.high[columns] / np.abs(layout.scale[columns])
        return interface.offsets[columns] + random.uniform(-reach, reach, (samples, entry.width))

    return {entry.name: draw(entry).astype(np.float32) for entry in interface.inputs}


def expected_outputs(interface: PolicyInterface, inputs: Arrays) -> Arrays:
    """Return the outputs and the observation of one step, by this package's scaling, network and action interface."""
    policy, layout = interface.policy, interface.layout
    samples = len(next(iter(inputs.values())))
    everything = np.arange(samples)
    control = ControlInterface(policy.robot, policy.control, samples, policy.fields)
    phase = inputs[graph_io.GAIT_PHASE][:, 0].astype(np.float64) if interface.has_clock else 0.0
    command = inputs[graph_io.COMMAND].astype(np.float64) if graph_io.COMMAND in inputs else None
    control.reset(everything, phase, command)
    readings = np.concatenate(
        [
            control.clock.copy() if entry is observations.gait_clock else inputs[entry.name].astype(np.float64)
            for entry in policy.fields
        ],
        axis=1,
    )
    observation = np.clip((readings - interface.offsets) * layout.scale, layout.low, layout.high).astype(np.float32)
    present = observation
    if graph_io.HISTORY in inputs:
        past = inputs[graph_io.HISTORY]
        past = np.where(np.isnan(past), np.tile(observation, layout.history - 1), past)
        observation = np.concatenate([observation, past], axis=1)
    action = policy.predict(observation)
    control.advance()
    found: dict[str, NDArray[Any]] = {
        graph_io.ACTION: action,
        graph_io.JOINT_TARGET: control.joint_target(action),
        graph_io.NEXT_GAIT_PHASE: control.phase[:, None],
        graph_io.NEXT_HISTORY: observation[:, : interface.history_width],
    }
    outputs = {entry.name: found[entry.name].astype(np.float32) for entry in interface.outputs}
    return {graph_io.OBSERVATION: present, **outputs}


def difference(name: str, found: NDArray[Any], expected: NDArray[Any]) -> NDArray[np.float64]:
    """Return the absolute differences between values of an input or output; a phase near a whole turn is next to 0."""
    size = np.abs(found.astype(np.float64) - expected)
    return (
        np.minimum(size, np.abs(math.tau - size)) if name in (graph_io.GAIT_PHASE, graph_io.NEXT_GAIT_PHASE) else size
    )


def largest_difference(interface: PolicyInterface, content: bytes, samples: int = SAMPLES) -> float:
    """Return the largest difference between a graph on ONNX Runtime and the policy, over random inputs.

    It is the difference of any action or joint target, in their units, or of the clock's phase, rad.

    Raises:
        MissingExtraError: if ONNX Runtime is not installed.
        QuadrupedError: if the difference is above `TOLERANCE`.
    """
    inputs = random_inputs(interface, samples)
    found, expected = run(session_of(content), inputs), expected_outputs(interface, inputs)
    largest = max(float(difference(name, value, expected[name]).max()) for name, value in found.items())
    if not largest <= TOLERANCE:
        raise QuadrupedError(
            f"export: ONNX Runtime differs from the policy by {largest:.2g} on random inputs, and {TOLERANCE:g} is "
            f"tolerated; nothing was written. Report the policy's files as a bug"
        )
    return largest
