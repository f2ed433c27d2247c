"""Check of an exported policy by its golden trace: in every runtime that is installed, or in a program of one's own."""

import csv
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError, QuadrupedError, cut, short
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.golden_trace import GIVEN, STATE, STEP, TraceField, approached, largest_change
from quadruped_env.export.manifest import FORMAT, GRAPH_FILE, MANIFEST_FILE
from quadruped_env.export.onnx_interface import FEEDBACK, OBSERVATION, REQUESTED
from quadruped_env.export.runtime import Arrays, run, session_of
from quadruped_env.utils.documents import check_regular, read_json

Run = Callable[[Arrays], Arrays]
"""Outputs of the graph by name for inputs by name, (1, width) each."""

_AGAIN: Final = "export the policy again"
_MAX_WIDTH: Final = 100_000


@dataclass(frozen=True)
class TraceDifference:
    """The first value that differs by more than its field's tolerance."""

    step: int
    field: str
    column: int
    expected: float
    found: float
    tolerance: float

    def __str__(self) -> str:
        return (
            f"step {self.step} on: {self.field}_{self.column} is {self.found:.7g}; the trace has {self.expected:.7g} "
            f"and tolerates {self.tolerance:g}"
        )


@dataclass(frozen=True)
class TraceResult:
    """Comparison with the golden trace."""

    name: str
    """Runtime or file that is compared."""
    compared: tuple[str, ...]
    """Fields, in the order of the loop."""
    first: TraceDifference | None
    largest: float
    """Largest difference of any field, in its unit; infinite where only one of the values is a number."""
    hides_nan_in: tuple[str, ...] = ()
    """Readings whose NaN does not make all joint targets NaN."""
    refusal: str = ""
    """Reason for which the runtime does not run the graph."""

    @property
    def passed(self) -> bool:
        """True if no difference is above its tolerance."""
        return self.first is None and not self.refusal


@dataclass(frozen=True)
class ExportedTrace:
    """The golden trace of an export's folder with what the loop needs from the manifest.

    Raises:
        QuadrupedError: if the folder holds no export, or its manifest or trace is damaged.
    """

    folder: Path
    fields: tuple[TraceField, ...]
    values: Arrays
    """Values of every field (steps, width)."""
    largest_change: NDArray[np.float32]
    """Of the velocity command in a control step (2,)."""

    @classmethod
    def load(cls, folder: Path) -> "ExportedTrace":
        """The trace of an export."""
        path = folder / MANIFEST_FILE
        document = read_json(path, "name the folder of an exported policy")
        if not isinstance(document, dict) or document.get("format") != FORMAT:
            raise QuadrupedError(f"{path}: is not the manifest of an exported policy; name the folder of one")
        try:
            trace = document["golden_trace"]
            fields = tuple(TraceField(**field) for field in trace["fields"])
            rates = [
                float(part["largest_rate"]) for part in document["command"]["components"] if "largest_rate" in part
            ]
            with np.errstate(over="raise"):
                change = largest_change(rates, float(document["control"]["timestep_s"]))
            if not all(0 < field.width < _MAX_WIDTH and field.tolerance > 0.0 for field in fields):
                raise ValueError("expected a positive width and tolerance of each field")
            file = folder / Path(trace["file"]).name
            columns = [name for field in fields for name in field.columns]
        except (KeyError, TypeError, ValueError, AttributeError, ArithmeticError) as error:
            raise QuadrupedError(f"{path}: golden_trace: is missing or damaged ({error!r}); {_AGAIN}") from error
        return cls(folder, fields, _arrays(fields, read_columns(file, columns)), change)

    def in_runtime(self, name: str, graph: Run) -> TraceResult:
        """Run the loop of the policy in a runtime on the trace's readings, and compare it with the trace."""
        state = {field.name: self.values[field.name][:1] for field in self.fields if field.part == STATE}
        given = [field.name for field in self.fields if field.part == GIVEN]
        if graph_io.COMMAND in state:
            state[graph_io.COMMAND] = np.zeros_like(state[graph_io.COMMAND])
        rows: list[Arrays] = []
        steps = len(next(iter(self.values.values())))
        for step in range(steps):
            inputs = {field: self.values[field][step : step + 1] for field in given}
            if graph_io.COMMAND in state:
                requested = inputs.pop(REQUESTED)
                state[graph_io.COMMAND] = approached(state[graph_io.COMMAND], requested, self.largest_change)
            outputs = graph({**inputs, **state})
            row = {**state, **{field: outputs[field] for field in (graph_io.ACTION, graph_io.JOINT_TARGET)}}
            if graph_io.NEXT_HISTORY in outputs:
                width = self.values[OBSERVATION].shape[1]
                row[OBSERVATION] = outputs[graph_io.NEXT_HISTORY][:, :width]
            rows.append(row)
            state |= {field: outputs[output] for field, output in FEEDBACK.items() if field in state}
        hidden = []
        for field in inputs:
            targets = graph({**inputs, **state, field: np.full_like(inputs[field], np.nan)})[graph_io.JOINT_TARGET]
            if not np.isnan(targets).all():
                hidden.append(field)
        found = {field: np.concatenate([row[field] for row in rows]) for field in rows[0]}
        return replace(self.compare(name, found), hides_nan_in=tuple(hidden))

    def compare(self, name: str, found: Mapping[str, NDArray[Any]]) -> TraceResult:
        """Compare values of some fields (steps, width) with the trace."""
        first, largest = None, 0.0
        compared = [field for field in self.fields if field.name in found]
        for field in compared:
            expected = self.values[field.name].astype(np.float64)
            values = np.asarray(found[field.name], np.float64)
            difference = np.abs(values - expected)
            if field.name == graph_io.GAIT_PHASE:
                # Just below a whole turn is next to just above 0.
                difference = np.minimum(difference, np.abs(math.tau - difference))
            difference[np.isnan(values) & np.isnan(expected)] = 0.0
            difference[np.isnan(difference)] = math.inf
            largest = max(largest, float(difference.max()))
            steps = np.flatnonzero((difference > field.tolerance).any(axis=1))
            if len(steps) and (first is None or steps[0] < first.step):
                step, column = int(steps[0]), int(difference[steps[0]].argmax())
                first = TraceDifference(
                    step, field.name, column, expected[step, column], values[step, column], field.tolerance
                )
        return TraceResult(name, tuple(field.name for field in compared), first, largest)

    def of_file(self, path: Path) -> TraceResult:
        """Compare a file with columns of the trace, written by a program of one's own, with the trace.

        Raises:
            QuadrupedError: if the file cannot be read, has no field of the state or of the results, only some columns
                of a field, or another number of lines.
        """
        table = read_columns(path)
        known = [field for field in self.fields if set(field.columns) & table.keys() and field.part != GIVEN]
        for field in known:
            if missing := [name for name in field.columns if name not in table]:
                raise QuadrupedError(f"{path}: has no column {missing[0]!r}; write all {field.width} of {field.name}")
        if not known:
            names = ", ".join(field.name for field in self.fields if field.part != GIVEN)
            raise QuadrupedError(f"{path}: has no column to compare; write one or more of the fields {names}")
        steps, found = len(self.values[known[0].name]), len(table[known[0].columns[0]])
        if found != steps:
            raise QuadrupedError(f"{path}: has {found} lines under its header; write one for each of {steps} steps")
        return self.compare(path.name, _arrays(known, table))


def read_columns(path: Path, expected: Sequence[str] = ()) -> dict[str, NDArray[np.float64]]:
    """Columns of a CSV file of numbers by name.

    Args:
        path: the file.
        expected: columns that it has to have, each once, next to others.

    Raises:
        QuadrupedError: if it cannot be read or lacks a column, or a value is not a number.
    """
    check_regular(path, "name a CSV file")
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            lines = list(csv.reader(file))
    except (OSError, ValueError, csv.Error) as error:
        raise QuadrupedError(f"{path}: cannot be read as CSV ({error}); {_AGAIN}") from error
    header = [name.strip() for name in lines[0]] if lines else []
    if missing := [name for name in [STEP, *expected] if header.count(name) != 1]:
        raise QuadrupedError(
            f"{path}: line 1: expected one column {short(missing[0])}; found {header.count(missing[0])}"
        )
    table = np.empty((len(lines) - 1, len(header)))
    for number, line in enumerate(lines[1:]):
        if len(line) != len(header):
            raise QuadrupedError(f"{path}: line {number + 2}: expected {len(header)} values; found {len(line)}")
        for column, text in enumerate(line):
            try:
                table[number, column] = float(text)
            except ValueError as error:
                raise QuadrupedError(
                    f"{path}: line {number + 2}: {short(header[column])}: expected a number; found {short(text)}"
                ) from error
    steps = table[:, header.index(STEP)]
    if not len(steps) or (steps != np.arange(len(steps))).any():
        raise QuadrupedError(f"{path}: {STEP}: expected 0, 1, 2, ...; write one line for each step")
    return dict(zip(header, table.T, strict=True))


def _arrays(fields: Sequence[TraceField], table: Mapping[str, NDArray[np.float64]]) -> Arrays:
    return {field.name: np.stack([table[n] for n in field.columns], axis=1).astype(np.float32) for field in fields}


def _onnx_runtime(path: Path) -> tuple[str, Run]:
    import onnxruntime

    session = session_of(path.read_bytes())
    return f"onnxruntime {onnxruntime.__version__}", lambda inputs: run(session, inputs)


def _onnx_reference(path: Path) -> tuple[str, Run]:
    import onnx
    from onnx.reference import ReferenceEvaluator

    evaluator = ReferenceEvaluator(onnx.load_from_string(path.read_bytes()))
    names = evaluator.output_names
    return f"onnx.reference {onnx.__version__}", lambda x: dict(zip(names, evaluator.run(None, x), strict=True))


def _openvino(path: Path) -> tuple[str, Run]:
    import openvino

    model = openvino.Core().compile_model(str(path), "CPU")

    def run(inputs: Arrays) -> Arrays:
        return {output.get_any_name(): value.copy() for output, value in model(inputs).items()}

    return f"openvino {openvino.__version__.partition('-')[0]}", run


RUNTIMES: Final[dict[str, Callable[[Path], tuple[str, Run]]]] = {
    "onnxruntime": _onnx_runtime,
    "onnx": _onnx_reference,
    "openvino": _openvino,
}
"""Library -> function that loads a graph's file; it returns name and version of the runtime, and the graph."""


def check_export(folder: Path) -> list[TraceResult]:
    """Compare every runtime that is installed with the golden trace of an export.

    Raises:
        MissingExtraError: if no runtime is installed.
        QuadrupedError: if the export is damaged.
    """
    trace, graph = ExportedTrace.load(folder), folder / GRAPH_FILE
    check_regular(graph, _AGAIN)
    results = []
    for library, load in RUNTIMES.items():
        try:
            results.append(trace.in_runtime(*load(graph)))
        except ImportError:
            continue
        except Exception as error:  # each runtime has errors of its own
            results.append(TraceResult(library, (), None, math.inf, refusal=cut(str(error) or repr(error))))
    if not results:
        raise MissingExtraError("check-export", "export")
    return results
