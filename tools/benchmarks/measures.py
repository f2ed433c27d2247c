"""Measures of the benchmarks: a value with its target, as a row of a table and as JSON."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

from quadruped_env.utils.files import write_json

Say = Callable[[str], None]


@dataclass(frozen=True)
class Measure:
    """One measurement, a row of the table."""

    name: str
    value: float
    unit: str
    reach: str
    """Target value, as text"""
    reached: bool
    detail: str


def seconds_of(work: Callable[[], object]) -> float:
    """Time that a function takes, s."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


# Without this package, whose import is measured.
_END_WITH_PARENT: Final = """
import os, threading
threading.Thread(target=lambda: (os.read(0, 1), os._exit(1)), daemon=True).start()
"""
"""Ends a program with the one that started it and holds its standard input open."""


def run_python(program: str, *arguments: str) -> dict[str, Any]:
    """The JSON that a program prints as its last line, run in a process of its own that can import this package."""
    paths = str(Path(__file__).parents[1]), os.environ.get("PYTHONPATH")
    with subprocess.Popen(  # noqa: S603
        [sys.executable, "-c", _END_WITH_PARENT + program, *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        encoding="utf-8",
        env={**os.environ, "PYTHONWARNINGS": "ignore", "PYTHONPATH": os.pathsep.join(filter(None, paths))},
    ) as process:
        assert process.stdout is not None
        output = process.stdout.read()
    if process.returncode:
        raise RuntimeError(f"a measurement ended with status {process.returncode}")
    return json.loads(output.strip().splitlines()[-1])


HEADER: Final = "| measure | value | reach | | detail |\n|---|---|---|---|---|"


def row(measure: Measure) -> str:
    """Return a row of the Markdown table."""
    value = f"{measure.value:.3g} {measure.unit}".strip()
    return f"| {measure.name} | {value} | {measure.reach} | {'yes' if measure.reached else 'NO'} | {measure.detail} |"


def write(measures: list[Measure], machine: str, versions: dict[str, str], path: Path) -> None:
    """Write the measures as JSON."""
    measured = [asdict(measure) for measure in measures]
    write_json(path, {"machine": machine, "versions": versions, "measures": measured})
