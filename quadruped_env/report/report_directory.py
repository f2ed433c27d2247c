"""Output directory of a report."""

import importlib.util
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError

REPORT_FILE: Final = "report.html"


def prepare_output(output: Path) -> None:
    """Create the directory of a report and check that the report can be written, before any long computation.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if the directory cannot be created.
    """
    if any(importlib.util.find_spec(name) is None for name in ("matplotlib", "jinja2", "av", "PIL")):
        raise MissingExtraError("The report", "report")
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise QuadrupedError(f"{output}: cannot be created ({error.strerror}); choose another directory") from error


def print_report(report: Path, missing: Sequence[str]) -> None:
    """Print where the report is, and what it lacks."""
    for message in missing:
        print(message, file=sys.stderr)
    print(f"report:  {report}")
