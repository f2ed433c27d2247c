"""The results of an identification: motors for the environment, numbers, and a page with pictures."""

import importlib.util
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.errors import MissingExtraError
from quadruped_env.identification.dataset import UNITS
from quadruped_env.identification.identify import Identification
from quadruped_env.report.pages.page import figure, provenance, write_html
from quadruped_env.report.palette import BLUE, INK, ORANGE
from quadruped_env.report.plots.joint_plots import Line, joint_panels
from quadruped_env.report.report_directory import REPORT_FILE
from quadruped_env.utils.files import check_free, write_json
from quadruped_env.utils.text_table import Table

MOTORS_FILE: Final = "motors.json"
NUMBERS_FILE: Final = "identification.json"


def identification_files(directory: Path) -> list[Path]:
    """Return files that are written into a directory."""
    return [directory / name for name in (MOTORS_FILE, NUMBERS_FILE, REPORT_FILE)]


def check_report_extra() -> None:
    """Raise a MissingExtraError if a library that the report needs is not installed."""
    if any(importlib.util.find_spec(name) is None for name in ("matplotlib", "jinja2")):
        raise MissingExtraError("The report", "report")


def save_numbers(found: Identification, directory: Path, command_line: str, overwrite: bool = False) -> dict[str, Any]:
    """Write motors and numbers, and return the document of these.

    Raises:
        QuadrupedError: if one of the files is there already and is not to be overwritten, or cannot be written.
    """
    check_free(identification_files(directory), overwrite)
    document = {**found.report(), **provenance(command_line)}
    write_json(directory / MOTORS_FILE, found.config())
    write_json(directory / NUMBERS_FILE, document)
    return document


def write_report(found: Identification, directory: Path, document: dict[str, Any]) -> Path:
    """Write the report, and return its path."""
    context = {
        "title": f"Motors identified from {Path(found.source).name}",
        "headline": found.verdict(),
        "level": "good" if found.helps else "poor",
        "remarks": found.remarks,
        "tables": [*found.tables(), _joints_table(found)],
        "figures": _figures(found),
        "document": document,
        "motors": found.config(),
    }
    write_html(directory / REPORT_FILE, "motion.html", context)
    return directory / REPORT_FILE


def _joints_table(found: Identification) -> Table:
    before, after = found.errors(after=False)["position"], found.errors(after=True)["position"]
    rows = [
        [name, *(f"{value:.4f}" if np.isfinite(value) else "left out" for value in (before[i], after[i]))]
        for i, name in enumerate(found.recorded.robot.joint_names)
    ]
    return Table("Position error of each joint on held-out time", ["", "before (rad)", "after (rad)"], rows)


def _figures(found: Identification) -> list[dict[str, str]]:
    recorded, robot = found.recorded, found.recorded.robot
    mark = float(recorded.times[recorded.train][-1])
    steps = np.arange(len(recorded.control), dtype=np.float64) * recorded.timestep
    figures = []
    for name in recorded.signals:
        part = recorded.columns(name)
        lines = {
            "measured": Line(recorded.times, recorded.measured[:, part], INK),
            "before": Line(recorded.times, found.predicted_before[:, part], ORANGE),
            "after": Line(recorded.times, found.predicted_after[:, part], BLUE),
        }
        if name == "position":
            lines = {"commanded": Line(steps, recorded.control, "#AAAAAA"), **lines}
        limits = (robot.joint_position_low, robot.joint_position_high) if name == "position" else None
        figures.append(
            figure(
                f"{name.capitalize()}s",
                joint_panels(robot, lines, f"{UNITS[name]}", limits, mark),
                "Measured, and simulated with the motors before and after. The time after the grey line is held out.",
            )
        )
    return figures
