"""Results of a policy's evaluation, for its manifest and card."""

import warnings
from pathlib import Path
from typing import Any

from quadruped_env.errors import QuadrupedWarning
from quadruped_env.evaluation.subject import Subject
from quadruped_env.export.manifest import RESULTS
from quadruped_env.reporting.pages.page import METRICS_FILE, without_nan
from quadruped_env.utils.documents import read_json


def evaluation_of(subject: Subject) -> dict[str, Any] | None:
    """Results of the evaluation in the subject's output directory, or those on a shipped policy's card, or None.

    Raises:
        QuadrupedError: if the file of the metrics is damaged.

    Warns:
        QuadrupedWarning: if the metrics are those of another policy; they are left out.
    """
    path = subject.output / METRICS_FILE
    if path.is_file():
        document = read_json(path, "evaluate the policy again")
        found = _summary(document, subject, path)
        if found is not None:
            return found
    results = {name: subject.policy.card[name] for name in RESULTS if name in subject.policy.card}
    return without_nan(results) or None


def _summary(document: Any, subject: Subject, path: Path) -> dict[str, Any] | None:
    """The policy's own part of a file of metrics; None if it is another policy's."""
    try:
        if document["policy"]["card"] != without_nan(subject.policy.card):
            warnings.warn(
                f"{path}: is the evaluation of another policy, so it is left out; evaluate this one to export its "
                f"results",
                QuadrupedWarning,
                stacklevel=4,
            )
            return None
        own = document["controllers"]["policy"]
        return {
            "command_line": document["command_line"],
            "format_version": document["format_version"],
            "verdict": document["verdict"],
            "suite": document["suite"],
            "commands": document["commands"],
            "seeds": document["seeds"],
            "seconds": document["seconds"],
            "metrics": document["metrics"],
            "all": own["all"],
            "by_motion": own["by_motion"],
        }
    except (KeyError, TypeError):
        warnings.warn(
            f"{path}: lacks the fields of an evaluation, so it is left out; evaluate the policy again",
            QuadrupedWarning,
            stacklevel=4,
        )
        return None
