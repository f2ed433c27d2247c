"""Reference rows that ship with the package: results of the suite for standing, the scripted gaits and policies."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.evaluation.suite.suite import COMPONENTS, check_results
from quadruped_env.utils.documents import read_json

REFERENCE_FILE: Final = Path(__file__).with_name("references.json")
"""Written by `tools/suite_references.py`; a package without it has no reference rows."""


def reference_row(result: Mapping[str, Any]) -> dict[str, Any]:
    """The part of a controller's results that ships: what identifies them, the score, and the main measures."""
    terrain = {kind: entry["highest_level"] for kind, entry in result["terrain"].items()}
    return {
        **{field: result[field] for field in ("suite", "conditions", "name", "score")},
        "met": result["commands"]["met"],
        "dead_zone": result["commands"]["dead_zone"],
        "half_survival": result["pushes"]["half_survival"],
        "terrain": terrain,
        "recovery": {name: entry["recovered"] for name, entry in result["recovery"].items()},
    }


def read_references(path: Path = REFERENCE_FILE) -> list[dict[str, Any]]:
    """All reference rows; none if the file does not exist.

    Raises:
        QuadrupedError: if the file is damaged.
    """
    if not os.path.lexists(path):
        return []
    fix = "write it again with tools/suite_references.py"
    document = read_json(path, fix)
    rows = document.get("rows") if isinstance(document, dict) else None
    if not isinstance(rows, list):
        raise QuadrupedError(f"{path}: expected a list 'rows'; found {short(rows)}; {fix}")
    for i, row in enumerate(rows):
        check_results(row, f"{path.name}: row {i + 1}")
    return rows


def references_for(result: Mapping[str, Any], rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Reference rows that may be compared with a result: the same suite, robot and physics."""
    return [row for row in rows if row["suite"] == result["suite"] and row["conditions"] == result["conditions"]]


def score_table(results: list[Mapping[str, Any]]) -> str:
    """Scores and their components of several results as plain text, in the given order."""
    head = ["", "score", *COMPONENTS]
    lines = [
        [row["name"], f"{row['score']['total']:.3f}", *(f"{row['score']['components'][c]:.2f}" for c in COMPONENTS)]
        for row in results
    ]
    widths = [max(len(line[i]) for line in [head, *lines]) for i in range(len(head))]
    return "\n".join(
        "  ".join(
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(line, widths, strict=True))
        ).rstrip()
        for line in [head, *lines]
    )
