"""Check of an exported policy by its golden trace: in every runtime that is installed, or in a program of one's own."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final, NotRequired, TypedDict

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError, QuadrupedError, cut, short
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.golden_trace import GIVEN, STATE, STEP, Loop, TraceField
from quadruped_env.export.manifest import FORMAT, GRAPH_FILE, MANIFEST_FILE
from quadruped_env.export.onnx_interface import OBSERVATION, REQUESTED
from quadruped_env.export.runtime import Arrays, difference, run, session_of
from quadruped_env.utils.documents import check_regular, fitted, read_json

Run = Callable[[Arrays], Arrays]
"""Outputs of the graph by name for inputs by name, (1, width) each."""

_AGAIN: Final = "export the policy again"
_MAX_WIDTH: Final = 100_000


@dataclass(frozen=True)
class TraceResult:
    """Comparison of a runtime or file with the golden trace, in words."""

    name: str
    text: str
    passed: bool = True
    """True if no difference is above its tolerance."""


class StoredTrace(TypedDict):
    """A trace in the manifest."""

    file: str
    fields: list[TraceField]


class StoredComponent(TypedDict):
    """A command in the manifest."""

    largest_rate: NotRequired[float]


class StoredCommand(TypedDict):
    """The commands in the manifest."""

    components: list[StoredComponent]


class StoredControl(TypedDict):
    """The control loop in the manifest."""

    timestep_s: float


class StoredC(TypedDict, total=False):
    """The C form in the manifest."""

    golden_trace: StoredTrace


class StoredManifest(TypedDict):
    """Fields of the manifest that a check needs."""

    golden_trace: StoredTrace
    command: StoredCommand
    control: StoredControl
    c: NotRequired[StoredC]


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
    rates: tuple[float, ...]
    """Largest rates of the velocity command, m/s^2 and rad/s^2."""
    timestep: float
    """Control step, s."""

    int8: "ExportedTrace | None" = None
    """The trace of the C form with weights of 8 bits, if the folder has one."""

    @classmethod
    def load(cls, folder: Path) -> "ExportedTrace":
        """The trace of an export."""
        path = folder / MANIFEST_FILE
        document = read_json(path, "name the folder of an exported policy")
        if not isinstance(document, dict) or document.get("format") != FORMAT:
            raise QuadrupedError(f"{path}: is not the manifest of an exported policy; name the folder of one")
        manifest = fitted(document, StoredManifest, str(path), _AGAIN)
        int8 = manifest.get("c", StoredC()).get("golden_trace")
        other = None if int8 is None else cls._of(folder, manifest, int8)
        return replace(cls._of(folder, manifest, manifest["golden_trace"]), int8=other)

    @classmethod
    def _of(cls, folder: Path, manifest: "StoredManifest", trace: "StoredTrace") -> "ExportedTrace":
        rates = tuple(part["largest_rate"] for part in manifest["command"]["components"] if "largest_rate" in part)
        for field in trace["fields"]:
            if not (0 < field.width < _MAX_WIDTH and field.tolerance > 0.0):
                raise QuadrupedError(
                    f"{folder / MANIFEST_FILE}: golden_trace: {short(field.name)}: expected a positive width and "
                    f"tolerance; found {field.width} and {field.tolerance:g}; {_AGAIN}"
                )
        fields, file = tuple(trace["fields"]), folder / Path(trace["file"]).name
        columns = [name for field in fields for name in field.columns]
        values = _arrays(fields, read_columns(file, columns))
        return cls(folder, fields, values, rates, manifest["control"]["timestep_s"])

    def in_runtime(self, name: str, graph: Run) -> TraceResult:
        """Run the loop of the policy in a runtime on the trace's readings, and compare it with the trace."""
        loop = Loop(
            {field.name: field.width for field in self.fields if field.part == STATE}, self.rates, self.timestep
        )
        given = {field.name: self.values[field.name] for field in self.fields if field.part == GIVEN}
        requested = given.pop(REQUESTED, np.zeros((len(next(iter(given.values()))), 2), np.float32))
        rows: list[Arrays] = []
        for step in range(len(requested)):
            readings = {field: values[step : step + 1] for field, values in given.items()}
            state = loop.begin(requested[step : step + 1])
            outputs = graph({**readings, **state})
            loop.end(outputs)
            if graph_io.NEXT_HISTORY in outputs:
                outputs[OBSERVATION] = outputs[graph_io.NEXT_HISTORY][:, : self.values[OBSERVATION].shape[1]]
            rows.append({**state, **outputs})
        found = {field: np.concatenate([row[field] for row in rows]) for field in rows[0]}
        return self.compare(name, found)

    def compare(self, name: str, found: Mapping[str, NDArray[Any]]) -> TraceResult:
        """Compare values of some fields (steps, width) with the trace: the first step that differs, and its field."""
        first, text, largest = math.inf, "", 0.0
        compared = [field for field in self.fields if field.name in found]
        for field in compared:
            expected, values = self.values[field.name], found[field.name]
            size = difference(field.name, values, expected)
            size[np.isnan(values) & np.isnan(expected)] = 0.0
            size[np.isnan(size)] = math.inf
            largest = max(largest, float(size.max()))
            steps = np.flatnonzero((size > field.tolerance).any(axis=1))
            if len(steps) and steps[0] < first:
                first, column = int(steps[0]), int(size[steps[0]].argmax())
                text = (
                    f"differs from step {first} on: {field.name}_{column} is {values[first, column]:.7g}; the trace "
                    f"has {expected[first, column]:.7g} and tolerates {field.tolerance:g}"
                )
        names = ", ".join(field.name for field in compared)
        return TraceResult(name, text or f"equal; largest difference {largest:.1g} ({names})", not text)

    def of_file(self, path: Path) -> list[TraceResult]:
        """Compare a file with columns of the trace, written by a program of one's own, with each trace of the folder.

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
        if self.int8 is None:
            return [self.compare(path.name, _arrays(known, table))]
        traces = {"float32": self, "weights of 8 bits": self.int8}
        return [trace.compare(f"{path.name}, {name}", _arrays(known, table)) for name, trace in traces.items()]


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
        with path.open(encoding="utf-8-sig") as file:
            first, *lines = file.readlines() or [""]
        header = [name.strip() for name in first.split(",")]
        table = np.loadtxt(lines, delimiter=",", ndmin=2) if lines else np.empty((0, len(header)))
        for name in (STEP, *expected):
            if header.count(name) != 1:
                raise ValueError(f"line 1 has {header.count(name)} columns {short(name)}; expected one")
        columns = dict(zip(header, table.T, strict=True))
        if not len(table) or (columns[STEP] != np.arange(len(table))).any():
            raise ValueError(f"{STEP} must be 0, 1, 2, ...; write one line for each step")
    except (OSError, ValueError) as error:
        raise QuadrupedError(f"{path}: is no CSV file of the trace's columns: {error}") from error
    return columns


def _arrays(fields: Sequence[TraceField], table: Mapping[str, NDArray[np.float64]]) -> Arrays:
    return {field.name: np.stack([table[n] for n in field.columns], axis=1).astype(np.float32) for field in fields}


def _onnx_runtime(path: Path) -> tuple[str, Run]:
    import onnxruntime

    session = session_of(path.read_bytes())
    return f"onnxruntime {onnxruntime.__version__}", lambda inputs: run(session, inputs)


def _openvino(path: Path) -> tuple[str, Run]:
    import openvino

    model = openvino.Core().compile_model(str(path), "CPU")

    def run(inputs: Arrays) -> Arrays:
        return {output.get_any_name(): value.copy() for output, value in model(inputs).items()}

    return f"openvino {openvino.__version__.partition('-')[0]}", run


RUNTIMES: Final[dict[str, Callable[[Path], tuple[str, Run]]]] = {
    "onnxruntime": _onnx_runtime,
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
            results.append(TraceResult(library, f"does not run the graph: {cut(str(error) or repr(error))}", False))
    if not results:
        raise MissingExtraError("check-export", "export")
    return results
