"""The golden trace of an exported policy: readings and what its loop makes of them, step by step, as a CSV file."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.onnx_interface import FEEDBACK, OBSERVATION, REQUESTED, Input, PolicyInterface
from quadruped_env.export.runtime import TOLERANCE, Arrays, expected_outputs, random_inputs
from quadruped_env.simulation import SingleSimulation, build_model

TRACE_FILE: Final = "golden_trace.csv"
STEPS: Final = 200
RANDOM_STEPS: Final = 40
"""Steps at the end whose readings are random, within 1.25 times the range that is not clipped."""
STEP: Final = "step"
GIVEN: Final = "given"
STATE: Final = "state"
RESULT: Final = "result"
"""Parts of a field in the loop: given from outside, kept from step to step, computed in this step."""

_REQUESTS: Final = ((0.0, 0.0, 0.0), (0.8, 0.0, 0.0), (0.5, 0.7, 0.3), (-0.7, -0.5, -0.8), (0.3, -0.7, 0.6))
"""Requested velocities, one after another, relative to the ends of their ranges."""
_ROW: Final = np.zeros(1, dtype=np.intp)


@dataclass(frozen=True)
class TraceField:
    """Columns of the trace: `<name>_0` to `<name>_<width - 1>`."""

    name: str
    part: str
    width: int
    unit: str
    tolerance: float
    description: str

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return [f"{self.name}_{i}" for i in range(self.width)]


def trace_fields(interface: PolicyInterface) -> list[TraceField]:
    """Return the fields of a policy's trace in the order in which a loop computes them."""
    given = [entry for entry in interface.inputs if entry.name not in (graph_io.COMMAND, *FEEDBACK)]
    state = [entry for entry in interface.inputs if entry not in given]
    for entry in state:
        if entry.name == graph_io.COMMAND:
            given.append(replace(entry, name=REQUESTED, description="Command that the loop's own one approaches."))
    text = "Scaled and clipped observation of this step alone."
    results = [Input(OBSERVATION, interface.layout.width, "1", text)]
    results += [entry for entry in interface.outputs if entry.name in (graph_io.ACTION, graph_io.JOINT_TARGET)]
    return [
        TraceField(entry.name, part, entry.width, entry.unit, TOLERANCE, entry.description)
        for part, entries in ((GIVEN, given), (STATE, state), (RESULT, results))
        for entry in entries
    ]


class Loop:
    """State that the loop around a policy's graph keeps from step to step.

    Args:
        widths: columns of the state by name.
        rates: largest rates of the velocity command, m/s^2 and rad/s^2.
        timestep: control step, s.
    """

    def __init__(self, widths: Mapping[str, int], rates: Sequence[float], timestep: float) -> None:
        self._change = (np.array(rates) * timestep).astype(np.float32)
        self._state: Arrays = {
            name: np.full((1, width), np.nan if name == graph_io.HISTORY else 0.0, np.float32)
            for name, width in widths.items()
        }

    def begin(self, requested: NDArray[np.float32]) -> Arrays:
        """Return the state (1, width) of the next step, whose command is nearer to the requested one (1, 2)."""
        if graph_io.COMMAND in self._state:
            command = self._state[graph_io.COMMAND]
            self._state[graph_io.COMMAND] = command + np.clip(requested - command, -self._change, self._change)
        return dict(self._state)

    def end(self, outputs: Arrays) -> None:
        """Keep what the graph returns for the next step."""
        self._state |= {name: outputs[output] for name, output in FEEDBACK.items() if name in self._state}


def golden_trace(interface: PolicyInterface) -> Arrays:
    """Return the values of all fields of a policy's trace by name (STEPS, width), by this package's own arithmetic.

    The readings come from the simulation of the policy's task, on level ground and without randomization. It
    stands, walks, turns and walks backwards. Readings of the last `RANDOM_STEPS` are random and reach the bounds to
    which observations are clipped.
    """
    policy, robot = interface.policy, interface.policy.robot
    config = policy.config
    simulation = SingleSimulation(build_model(config.physics_timestep, config.motor, robot=robot), robot)
    start = np.concatenate([[0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0], robot.stance])[None]
    at_rest = np.zeros((1, robot.num_velocities))
    simulation.reset(_ROW, start, at_rest)
    control = ControlInterface(robot, policy.control, 1, policy.fields)
    random = random_inputs(interface, RANDOM_STEPS)
    widths = {entry.name: entry.width for entry in interface.inputs if entry.name in FEEDBACK}
    velocities = len(interface.velocities)
    loop = Loop({**widths, graph_io.COMMAND: velocities}, policy.control.command_rate, policy.control.timestep)
    others = np.array([[entry.default for entry in policy.control.commands[velocities:]]])
    rows: dict[str, list[NDArray[np.float32]]] = {field.name: [] for field in trace_fields(interface)}
    for step, requested in enumerate(_requests(interface)):
        state = loop.begin(requested[None])
        phase = state[graph_io.GAIT_PHASE][:, 0].astype(float) if interface.has_clock else 0.0
        control.reset(_ROW, phase, np.concatenate([state[graph_io.COMMAND], others], axis=1))
        control.action[:] = state.get(graph_io.LAST_ACTION, 0.0)
        number = step - STEPS + RANDOM_STEPS
        given = {
            field.name: random[field.name][number : number + 1]
            if number >= 0
            else (field.read(simulation.readings, control) + interface.offset(field)).astype(np.float32)
            for field in policy.fields
            if field.name in random and field.name not in state
        }
        results = expected_outputs(interface, {**given, **state})
        loop.end(results)
        for name, values in {REQUESTED: requested[None], **given, **state, **results}.items():
            if name in rows:
                rows[name].append(values[0])
        simulation.step(results[graph_io.JOINT_TARGET].astype(float), config.decimation)
        if simulation.diverged()[0]:
            simulation.reset(_ROW, start, at_rest)
    return {name: np.array(values) for name, values in rows.items()}


def _requests(interface: PolicyInterface) -> NDArray[np.float32]:
    """Return the requested velocities of every step (STEPS, V)."""
    low, high = np.array([entry.range for entry in interface.velocities]).T
    shares = np.array(_REQUESTS)[:, : len(low)]
    parts = np.where(shares < 0.0, -low, high) * shares
    return np.repeat(parts, STEPS // len(parts), axis=0).astype(np.float32)


def trace_document(interface: PolicyInterface) -> dict[str, Any]:
    """Return the trace's part of the manifest."""
    return {
        "file": TRACE_FILE,
        "steps": STEPS,
        "meaning": "One line per control step, a header with the columns' names first. Feed the given fields to your "
        "loop, step by step, and let it keep the state itself: before the first step the command is idle, and the "
        "other fields of the state are as in the first line. Then every field of the state and every result has to "
        f"equal the line. Readings of the last {RANDOM_STEPS} steps are random and reach the bounds",
        "columns": f"{STEP}, then the fields in their order: <name>_0 to <name>_<width - 1>",
        "largest_rates": list(interface.policy.control.command_rate),
        "timestep_s": interface.policy.control.timestep,
        "fields": [asdict(field) for field in trace_fields(interface)],
    }


def csv_text(fields: Iterable[TraceField], values: Mapping[str, NDArray[np.float32]]) -> str:
    """Return the trace as CSV: `step`, then the columns of the fields, float32 in the fewest digits that restore it."""
    names = [column for field in fields for column in field.columns]
    table = np.concatenate([values[field.name] for field in fields], axis=1)
    lines = [",".join([STEP, *names])]
    lines += [",".join([str(step), *map(str, row)]) for step, row in enumerate(table)]
    return "\n".join(lines) + "\n"
