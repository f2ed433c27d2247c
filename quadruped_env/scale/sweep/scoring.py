"""Scores of policies on the evaluation suite: at the end of a trial, and in between for ASHA."""

from pathlib import Path
from typing import Any, Final

from quadruped_env.evaluation.subject import find_subject
from quadruped_env.evaluation.suite import command_map, gait_measures, pushes, transients
from quadruped_env.evaluation.suite.measured_controller import Contender
from quadruped_env.evaluation.suite.suite import run_suite
from quadruped_env.evaluation.suite.suite_definition import full_suite, quick_suite
from quadruped_env.policies import Policy
from quadruped_env.reporting.pages.suite_section import write_results

RUNG_PARTS: Final = ("commands", "gait", "transients", "pushes")
"""Parts of the quick suite whose mean is the score at a rung: those on flat ground with the task's own controller."""


def rung_score(policy: Policy) -> float:
    """Score in [0, 1] of a policy during its training: mean of the parts `RUNG_PARTS` of the quick suite."""
    suite, contender = quick_suite(), Contender.of_policy(policy, "trial")
    scores = (
        command_map.score(command_map.run(suite.commands, contender)),
        gait_measures.score(gait_measures.run(suite.gait, contender), suite.gait),
        transients.score(transients.run(suite.transients, contender)),
        pushes.score(pushes.run(suite.pushes, contender)),
    )
    return sum(scores) / len(scores)


def final_score(run: Path, measure: str, command: str, task_file: Path | None = None) -> dict[str, Any] | None:
    """Score of a complete run: `total` and `components`; its whole results are in `<run>/evaluation/suite.json`.

    Args:
        run: run directory.
        measure: `quick` or `suite`; `none` gives None.
        command: command line for the record.
        task_file: the user's file of terms.

    Raises:
        QuadrupedError: if the suite cannot run the policy, or the results cannot be written.
    """
    if measure == "none":
        return None
    subject = find_subject(str(run), None, task_file)
    suite = quick_suite() if measure == "quick" else full_suite()
    result = run_suite(Contender.of_policy(subject.policy, subject.name), suite)
    write_results(subject, result, command)
    score: dict[str, Any] = result["score"]
    return score
