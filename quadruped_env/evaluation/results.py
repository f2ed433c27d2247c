"""Stored results: their forms on cards and in files of evaluations, and results of the suite.

Fields that a form lacks are left out when a file is read (`utils.documents.fitted`), so that files of other versions
can be read as long as they have these.
"""

import math
import warnings
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Final, NotRequired, TypedDict

import numpy as np

from quadruped_env.errors import QuadrupedError, QuadrupedWarning, short
from quadruped_env.evaluation.confidence import Estimate, student_mean
from quadruped_env.utils.documents import fitted, read_json
from quadruped_env.utils.text_table import text_table

RESULTS_FILE: Final = "suite.json"
REFERENCE_FILE: Final = Path(__file__).parent / "suite" / "references.json"
"""Written by `tools/suite_references.py`; a package without it has no reference rows."""
COMPONENTS: Final = {
    "commands": "accuracy under commands drawn over the rectangle; less a fifth if it never stands still",
    "joystick": "accuracy over 5 s of changing commands, over 1 + falls per hour / 10",
    "gait": "clearance, one soft touchdown per stride and little slip, times the accuracy",
    "transients": "1 - settling time / 5 s after steps of the command, times the accuracy at the end",
    "pushes": "accuracy after pushes; less a fifth if it never stands still",
    "regulation": "share of the episodes that keep their speed under one disturbance, and accuracy under all",
    "terrain": "share of the ten levels that are crossed, mean over the kinds",
}
"""Component of the suite's score, which is a part of the suite -> meaning."""
ACCURACY: Final = (
    "The accuracy is 1 for a command that is met closely, within 10 % of it or 0.02 m/s and 0.05 rad/s, and from there "
    "falls to 0 for errors of 0.1 m/s or 0.2 rad/s"
)
"""What the components have in common."""
SECOND_ENGINE: Final = "second_engine"
"""Field of a policy's suite results that holds `Transfer.to_dict` of `tools/sim2sim.py`; None: not measured."""
ZERO_ACTION: Final = "zero_action"
"""Field of a policy's suite results that holds the results of the zero action in the same task."""
_AGAIN: Final = "evaluate the policy with --suite"


class StoredEstimate(TypedDict):
    """A mean with its interval; None where there was no data."""

    mean: float | None
    low: float | None
    high: float | None
    count: NotRequired[int]


class StoredMotion(TypedDict):
    """Results under the commands of one motion: metric -> mean."""

    motion: str
    result: str
    policy: dict[str, float | None]
    zero: dict[str, float | None]


class StoredMeasure(TypedDict):
    """A measure of the policy and of the zero action."""

    name: str
    metric: str
    policy: float | None
    zero: float | None
    difference: StoredEstimate


class StoredGain(TypedDict):
    """`LearningGain.to_dict`."""

    verdict: str
    episodes: int
    seconds: float
    difference: StoredEstimate
    condition: NotRequired[str | None]
    policy: dict[str, StoredEstimate]
    zero: dict[str, StoredEstimate]
    commands: NotRequired[dict[str, dict[str, StoredEstimate]] | None]
    motions: NotRequired[list[StoredMotion]]
    measures: NotRequired[list[StoredMeasure]]


class StoredSuiteName(TypedDict):
    """Name, version and definition of the suite."""

    name: str
    version: int
    quick: bool
    sha256: str


class StoredSuite(TypedDict):
    """Results of the suite on a card."""

    suite: StoredSuiteName
    seed: NotRequired[int]
    score: NotRequired[Any]
    met: NotRequired[Any]
    met_closely: NotRequired[Any]
    envelope: NotRequired[Any]
    falls_per_hour: NotRequired[Any]
    terrain: NotRequired[Any]
    zero_action: NotRequired[Any]


class CardResults(TypedDict, total=False):
    """Results on the card of a policy."""

    metrics: dict[str, dict[str, float | None]]
    acceptance: dict[str, Any]
    disturbed: dict[str, Any]
    suite: StoredSuite
    verdict: str
    learning: StoredGain


class StoredController(TypedDict):
    """Results of one controller: all, and motion -> metric -> value."""

    all: dict[str, StoredEstimate]
    by_motion: dict[str, dict[str, StoredEstimate]]


class StoredEvaluation(TypedDict):
    """`metrics.json` of an evaluation."""

    format_version: int
    command_line: str
    policy: dict[str, Any]
    verdict: dict[str, str]
    suite: dict[str, Any] | None
    commands: list[dict[str, Any]]
    seeds: list[int]
    seconds: float
    metrics: dict[str, dict[str, Any]]
    controllers: dict[str, StoredController]


def card_results(card: Mapping[str, Any], source: str) -> CardResults:
    """Return the results on a card; `source` names its file.

    Warns:
        QuadrupedWarning: for each of them that has another form, which is left out.
    """
    found = CardResults()
    for name in sorted(CardResults.__optional_keys__ & card.keys()):
        try:
            found.update(fitted({name: card[name]}, CardResults, f"{source}: card", "it is left out"))
        except QuadrupedError as error:
            warnings.warn(str(error), QuadrupedWarning, stacklevel=3)
    return found


def with_zero_action(result: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Return the results, and the results of the zero action that they hold, as rows of a table."""
    return [result, result[ZERO_ACTION]] if ZERO_ACTION in result else [result]


def read_results(path: Path) -> dict[str, Any]:
    """Return results of the suite from a file, with all parts; a QuadrupedError if it cannot be read or lacks one."""
    document: dict[str, Any] = read_json(path, _AGAIN)
    if not isinstance(document, dict):
        raise QuadrupedError(f"{path}: expected a table; found {short(document)}; {_AGAIN}")
    for name in ("suite", "conditions", "name", "score", *COMPONENTS):
        if name not in document:
            raise QuadrupedError(f"{path}: {name} is missing; {_AGAIN}")
    components = document["score"].get("components") if isinstance(document["score"], dict) else None
    if not isinstance(components, dict) or not components.keys() >= COMPONENTS.keys():
        raise QuadrupedError(f"{path}: score lacks a component of {', '.join(COMPONENTS)}; {_AGAIN}")
    return document


def check_comparable(documents: Mapping[str, Mapping[str, Any]]) -> None:
    """Raise a QuadrupedError if results (by name) differ in suite, version, definition, robot or physics."""
    (one, a), *others = documents.items()
    fixes = {
        "quick": "a quick result is never comparable with a full one; evaluate without --quick",
        "sha256": "the definitions of the suite differ; evaluate both with the same version of the package",
    }
    for other, b in others:
        for section, same in (("suite", ""), ("conditions", ", and on the same robot")):
            for field in sorted(a[section].keys() | b[section].keys()):
                x, y = a[section].get(field), b[section].get(field)
                if x != y:
                    fix = fixes.get(field, f"evaluate both with the same version of the package{same}")
                    raise QuadrupedError(
                        f"{one} and {other} cannot be compared: {section}.{field} is {short(x)} in one and {short(y)} "
                        f"in the other; {fix}"
                    )


def paired_differences(one: Mapping[str, Any], other: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return the difference of the scores of two results, first minus second, over pairs of episodes: plain values.

    Returns:
        `score`, whose components are taken as independent, and `components`, with 95 % intervals; None for results of
        different seeds, whose episodes are not paired.
    """
    if one["seed"] != other["seed"]:
        return None
    components = {
        name: student_mean(np.subtract(one[name]["contributions"], other[name]["contributions"]).tolist())
        for name in COMPONENTS
    }
    mean = one["score"]["total"] - other["score"]["total"]
    half = math.hypot(*(found.high - found.mean for found in components.values())) / len(components)
    count = sum(found.count for found in components.values())
    total = Estimate(mean, mean - half, mean + half, count)
    return {"score": total.to_dict(), "components": {name: found.to_dict() for name, found in components.items()}}


def ranked(documents: Iterable[tuple[str, Mapping[str, Any]]]) -> list[tuple[str, Mapping[str, Any]]]:
    """Return the results by their score, the best first; equal scores keep their order."""
    return sorted(documents, key=lambda entry: -entry[1]["score"]["total"])


def read_references(path: Path = REFERENCE_FILE) -> list[dict[str, Any]]:
    """Return all reference rows; none if the file does not exist, a QuadrupedError if it is damaged."""
    if not path.exists():
        return []
    rows: list[dict[str, Any]] = read_json(path, "write it again with tools/suite_references.py")["rows"]
    return rows


def references_for(result: Mapping[str, Any], rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the reference rows that may be compared with a result: the same suite, robot and physics."""
    return [row for row in rows if row["suite"] == result["suite"] and row["conditions"] == result["conditions"]]


def score_table(results: list[Mapping[str, Any]]) -> str:
    """Return the scores and their components of several results as plain text, in the given order."""
    scores = (result["score"] for result in results)
    numbers = [[f"{score['total']:.3f}", *(f"{score['components'][c]:.2f}" for c in COMPONENTS)] for score in scores]
    rows = [[result["name"], *cells] for result, cells in zip(results, numbers, strict=True)]
    return text_table([["", "score", *COMPONENTS], *rows])


def seed_means(scores: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return the mean scores of one recipe over its training seeds, as plain values.

    Args:
        scores: `total` and `components` of each seed.

    Returns:
        `score` and `components`, with Student's intervals, which a single seed does not have.
    """
    return {
        "score": student_mean([score["total"] for score in scores]).to_dict(),
        "components": {
            name: student_mean([score["components"][name] for score in scores]).to_dict() for name in COMPONENTS
        },
    }


def aggregate(documents: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return the aggregate of the results of one recipe over its training seeds, as plain values.

    Returns:
        `runs`, the name, total score and components of each run; the `seed_means`; and `terrain`, the highest level of
        each kind that all runs pass.

    Raises:
        QuadrupedError: if the results cannot be compared.
    """
    check_comparable({f"{document['name']} ({i + 1})": document for i, document in enumerate(documents)})
    return {
        "runs": [{"name": document["name"], **document["score"]} for document in documents],
        **seed_means([document["score"] for document in documents]),
        "terrain": {
            kind: min(document["terrain"]["kinds"][kind]["highest_level"] for document in documents)
            for kind in documents[0]["terrain"]["kinds"]
        },
    }
