"""Check of an exported policy by its golden trace: on ONNX Runtime, or in a program of one's own."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, Self, TypedDict

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
    """The golden trace in the manifest."""

    file: str
    fields: list[TraceField]
    largest_rates: list[float]
    timestep_s: float


class StoredManifest(TypedDict):
    """Fields of the manifest that a check needs."""

    golden_trace: StoredTrace


@dataclass(frozen=True)
class ExportedTrace:
    """The golden trace of an export's folder."""

    fields: tuple[TraceField, ...]
    values: Arrays
    """Values of every field (steps, width)."""
    rates: tuple[float, ...]
    """Largest rates of the velocity command, m/s^2 and rad/s^2."""
    timestep: float
    """Control step, s."""

    @classmethod
    def load(cls, folder: Path) -> Self:
        """Return the trace of an export.

        Raises:
            QuadrupedError: if the folder holds no export, or its manifest or trace is damaged.
        """
        path = folder / MANIFEST_FILE
        document = read_json(path, "name the folder of an exported policy")
        if not isinstance(document, dict) or document.get("format") != FORMAT:
            raise QuadrupedError(f"{path}: is not the manifest of an exported policy; name the folder of one")
        trace = fitted(document, StoredManifest, str(path), _AGAIN)["golden_trace"]
        for field in trace["fields"]:
            if not (0 < field.width < _MAX_WIDTH and field.tolerance > 0.0):
                raise QuadrupedError(
                    f"{path}: golden_trace: {short(field.name)}: expected a positive width and tolerance; found "
                    f"{field.width} and {field.tolerance:g}; {_AGAIN}"
                )
        fields = tuple(trace["fields"])
        table = read_columns(folder / Path(trace["file"]).name, [name for field in fields for name in field.columns])
        return cls(fields, _arrays(fields, table), tuple(trace["largest_rates"]), trace["timestep_s"])

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

    def of_file(self, path: Path) -> TraceResult:
        """Compare a file with columns of the trace, written by a program of one's own.

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
    """Return the columns of a CSV file of numbers by name.

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


def check_export(folder: Path) -> TraceResult:
    """Compare the graph of an export on ONNX Runtime with its golden trace.

    Raises:
        MissingExtraError: if ONNX Runtime is not installed.
        QuadrupedError: if the export is damaged.
    """
    trace, graph = ExportedTrace.load(folder), folder / GRAPH_FILE
    check_regular(graph, _AGAIN)
    try:
        session = session_of(graph.read_bytes())
        return trace.in_runtime("ONNX Runtime", lambda inputs: run(session, inputs))
    except MissingExtraError:
        raise
    except Exception as error:  # ONNX Runtime has errors of its own
        return TraceResult("ONNX Runtime", f"does not run the graph: {cut(str(error) or repr(error))}", False)
