"""The golden trace of an exported policy: readings and what its loop makes of them, step by step, as a CSV file."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.velocity_command import VELOCITY
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

_REQUESTS: Final = ((0.0, 0.0), (0.8, 0.0), (0.5, 0.7), (-0.7, -0.5), (0.3, -0.7))
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
    """Fields of a policy's trace in the order in which a loop computes them."""
    found: dict[str, list[TraceField]] = {GIVEN: [], STATE: [], RESULT: []}

    def add(part: str, entry: Input) -> None:
        found[part].append(TraceField(entry.name, part, entry.width, entry.unit, TOLERANCE, entry.description))

    for entry in interface.inputs:
        if entry.name == graph_io.COMMAND:
            text = "Requested command, which the loop's own command approaches."
            add(GIVEN, replace(entry, name=REQUESTED, description=text))
        add(STATE if entry.name == graph_io.COMMAND or entry.name in FEEDBACK else GIVEN, entry)
    text = "Scaled and clipped observation of this step alone."
    add(RESULT, Input(OBSERVATION, interface.layout.width, "1", text))
    for entry in interface.outputs:
        if entry.name not in FEEDBACK.values() or entry.name == graph_io.ACTION:
            add(RESULT, entry)
    return [field for fields in found.values() for field in fields]


def golden_trace(interface: PolicyInterface) -> Arrays:
    """Values of all fields of a policy's trace by name (STEPS, width), by this package's own arithmetic.

    The readings are those of the robot in the simulation of its task, on level ground and without randomization. It
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
    readings = {entry.name: entry for entry in policy.fields}
    random = random_inputs(interface, RANDOM_STEPS)
    requested, command = _requests(policy.control.commands), np.zeros((1, VELOCITY), np.float32)
    change = largest_change(policy.control.command_rate, policy.control.timestep)
    state = {entry.name: np.zeros((1, entry.width), np.float32) for entry in interface.inputs}
    if graph_io.HISTORY in state:
        state[graph_io.HISTORY][:] = np.nan
    others = np.array([[entry.default for entry in policy.control.commands[VELOCITY:]]])
    rows: dict[str, list[NDArray[np.float32]]] = {field.name: [] for field in trace_fields(interface)}
    for step in range(STEPS):
        command = approached(command, requested[step : step + 1], change)
        phase = state[graph_io.GAIT_PHASE][:, 0].astype(float) if interface.has_clock else 0.0
        control.reset(_ROW, phase, np.concatenate([command, others], axis=1))
        control.action[:] = state.get(graph_io.LAST_ACTION, 0.0)
        inputs = {}
        for name, kept in state.items():
            if name == graph_io.COMMAND:
                inputs[name] = command
            elif name in FEEDBACK:
                inputs[name] = kept
            elif step < STEPS - RANDOM_STEPS:
                field = readings[name]
                read = field.read(simulation.readings, control) + interface.offset(field)
                inputs[name] = read.astype(np.float32)
            else:
                number = step - STEPS + RANDOM_STEPS
                inputs[name] = random[name][number : number + 1]
        results = expected_outputs(interface, inputs)
        for name, values in {REQUESTED: requested[step : step + 1], **inputs, **results}.items():
            if name in rows:
                rows[name].append(values[0])
        state |= {name: results[output] for name, output in FEEDBACK.items() if name in state}
        simulation.step(results[graph_io.JOINT_TARGET].astype(float), config.decimation)
        if simulation.diverged()[0]:
            simulation.reset(_ROW, start, at_rest)
    return {name: np.array(values) for name, values in rows.items()}


def largest_change(rate: Sequence[float], timestep: float) -> NDArray[np.float32]:
    """Largest change of the velocity command in a control step (2,), m/s and rad/s, for rates in m/s^2 and rad/s^2."""
    return (np.array(rate) * timestep).astype(np.float32)


def approached(
    command: NDArray[np.float32], requested: NDArray[np.float32], change: NDArray[np.float32]
) -> NDArray[np.float32]:
    """The command of the next control step, on its way to the requested one."""
    return command + np.clip(requested - command, -change, change)


def _requests(commands: Sequence[Any]) -> NDArray[np.float32]:
    """Requested forward velocity and yaw rate of every step (STEPS, 2)."""
    low, high = np.array([entry.range for entry in commands[:VELOCITY]]).T
    parts = np.array([np.where(np.array(part) < 0.0, -low, high) * part for part in _REQUESTS])
    return np.repeat(parts, STEPS // len(parts), axis=0).astype(np.float32)


def trace_document(interface: PolicyInterface) -> dict[str, Any]:
    """The trace's part of the manifest."""
    return {
        "file": TRACE_FILE,
        "steps": STEPS,
        "meaning": "One line per control step, a header with the columns' names first. Feed the given fields to your "
        "loop, step by step, and let it keep the state itself: before the first step the command is idle, and the "
        "other fields of the state are as in the first line. Then every field of the state and every result has to be "
        f"that of the line. Readings of the last {RANDOM_STEPS} steps are random and reach the bounds",
        "columns": f"{STEP}, then the fields in their order: <name>_0 to <name>_<width - 1>",
        "fields": [asdict(field) for field in trace_fields(interface)],
    }


def csv_text(fields: Iterable[TraceField], values: Mapping[str, NDArray[np.float32]]) -> str:
    """The trace as CSV: `step`, then the columns of the fields, float32 in the fewest digits that restore it."""
    names = [column for field in fields for column in field.columns]
    table = np.concatenate([values[field.name] for field in fields], axis=1)
    lines = [",".join([STEP, *names])]
    lines += [",".join([str(step), *map(str, row)]) for step, row in enumerate(table)]
    return "\n".join(lines) + "\n"
