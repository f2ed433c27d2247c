"""The worst episodes of a policy."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.evaluation.comparison import ERRORS, Comparison
from quadruped_env.evaluation.conditions import Command
from quadruped_env.evaluation.measures import METRICS
from quadruped_env.evaluation.verdict import tolerance

SHOWN: Final = 3


@dataclass(frozen=True)
class Failure:
    """A bad episode."""

    row: int
    """Index of the episode in the comparison's rollouts"""
    command: Command
    seed: int
    fell_at: float | None
    """Time of the fall, s; None without a fall"""
    badness: float
    """Larger of the two velocity errors, relative to its tolerance; infinite for a fall"""
    story: str
    """Time of the fall, or velocity errors, in words"""


def worst_episodes(comparison: Comparison) -> list[Failure]:
    """Worst episodes of the policy: falls first, the earliest first, then the largest velocity errors.

    One per command, because episodes of one command mostly fail in the same way.
    """
    rollout = comparison.rollouts["policy"]
    alive = rollout.valid.sum(axis=0)
    worst = []
    for i, command in enumerate(comparison.commands):
        rows = comparison.rows(i)
        errors = {metric: comparison.values["policy"][metric][i] for metric in ERRORS}
        relative = [error / tolerance(metric, comparison.robot) for metric, error in errors.items()]
        badness = np.where(rollout.fallen[rows], np.inf, np.nan_to_num(np.max(relative, axis=0)))
        j = int(np.lexsort((alive[rows], -badness))[0])
        row, fell_at, story = int(rows[j]), None, "It did not fall. Errors: "
        if rollout.fallen[row]:
            fell_at = float(alive[row] + 1) * rollout.timestep
            story = f"It fell at {fell_at:.1f} s. Errors before: "
        story += " and ".join(f"{METRICS[m].show(error[j])} {METRICS[m].unit}" for m, error in errors.items()) + "."
        worst.append(Failure(row, command, comparison.seeds[j], fell_at, float(badness[j]), story))
    return sorted(worst, key=lambda failure: (-failure.badness, alive[failure.row]))[:SHOWN]
