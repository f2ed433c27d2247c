"""Forms of results that one program stores and another one reads: cards of policies, and files of evaluations.

Fields that a form lacks are left out when a file is read (`utils.documents.fitted`), so that files of other versions
can be read as long as they have these.
"""

import warnings
from collections.abc import Mapping
from typing import Any, NotRequired, TypedDict

from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.utils.documents import fitted


class StoredEstimate(TypedDict):
    """A mean with its interval; None where there was no data."""

    mean: float | None
    low: float | None
    high: float | None
    count: NotRequired[int]


class StoredPerformance(TypedDict):
    """Results of the policy, or of the zero action."""

    return_per_second: StoredEstimate
    commands_met: StoredEstimate
    falls: StoredEstimate
    electrical_power: StoredEstimate
    own_action: NotRequired[float]


class StoredMotion(TypedDict):
    """Results under one command, and its mirror image: metric -> mean."""

    motion: str
    result: str
    policy: dict[str, float | None]
    zero: dict[str, float | None]


class StoredGain(TypedDict):
    """`LearningGain.to_dict`."""

    verdict: str
    episodes: int
    seconds: float
    difference: StoredEstimate
    standard_errors: NotRequired[float | None]
    condition: NotRequired[str | None]
    policy: StoredPerformance
    zero: StoredPerformance
    motions: NotRequired[list[StoredMotion]]


class StoredSuiteName(TypedDict):
    """Name, version and definition of the suite."""

    name: str
    version: int
    quick: bool
    sha256: str


class StoredSuite(TypedDict):
    """Results of the suite on a card."""

    suite: StoredSuiteName
    findings: NotRequired[dict[str, str]]
    score: NotRequired[Any]
    met: NotRequired[Any]
    envelope: NotRequired[Any]
    falls_per_hour: NotRequired[Any]
    terrain: NotRequired[Any]
    zero_action: NotRequired[Any]


class StoredVerdict(TypedDict):
    """The verdict in words."""

    level: str
    headline: str
    findings: NotRequired[dict[str, str]]


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


class StoredControllers(TypedDict):
    """Results of the evaluated policy; those of the scripted controllers are left out."""

    policy: StoredController


class StoredPolicy(TypedDict):
    """The policy that was evaluated."""

    card: dict[str, Any]


class StoredEvaluation(TypedDict):
    """`metrics.json` of an evaluation."""

    format_version: int
    command_line: str
    policy: StoredPolicy
    verdict: StoredVerdict
    suite: dict[str, Any] | None
    commands: list[dict[str, Any]]
    seeds: list[int]
    seconds: float
    metrics: dict[str, dict[str, Any]]
    controllers: StoredControllers


def card_results(card: Mapping[str, Any], source: str) -> CardResults:
    """Results on a card; `source` names its file.

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
