"""The worst episodes of a controller."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.evaluation.comparison import ERRORS, Comparison
from quadruped_env.evaluation.conditions import Command
from quadruped_env.evaluation.measures import METRICS, window_means, without_fall_in_words
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.verdict import tolerance
from quadruped_env.utils.rotations import tilt

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
    moment: float
    """Time of the fall, or the middle of the window with the largest error, s"""
    badness: float
    """Larger of the two velocity errors, relative to its tolerance; infinite for a fall"""
    story: str
    """Fall or tilt, and mean velocities, in words"""


def worst_episodes(comparison: Comparison, controller: str = "policy", count: int = SHOWN) -> list[Failure]:
    """Worst episodes, at most one per command: falls first, the earliest first, then the largest velocity errors.

    One per command, because episodes of one command mostly fail in the same way.
    """
    rollout = comparison.rollouts[controller]
    allowed = np.array([tolerance(metric, comparison.robot) for metric in ERRORS])
    worst = []
    for i, command in enumerate(comparison.commands):
        rows = comparison.rows(i)
        errors = np.stack([comparison.values[controller][metric][i] for metric in ERRORS])
        badness = np.where(rollout.fallen[rows], np.inf, np.nan_to_num(np.max(errors / allowed[:, None], axis=0)))
        alive = rollout.valid[:, rows].sum(axis=0)
        # If several episodes fall, the earliest fall.
        j = int(np.lexsort((alive, -badness))[0])
        worst.append((-float(badness[j]), int(alive[j]), int(rows[j]), command))
    return [_failure(rollout, row, command, -badness, allowed) for badness, _, row, command in sorted(worst)[:count]]


def _failure(
    rollout: Rollout, row: int, command: Command, badness: float, allowed: np.ndarray[tuple[int], np.dtype[np.float64]]
) -> Failure:
    one = rollout.select([row])
    alive = int(one.valid[:, 0].sum())
    if one.fallen[0]:
        moment = fell_at = (alive + 1) * one.timestep
        angle = np.degrees(tilt(one.orientation[min(alive, len(one) - 1), 0]))
        fate = f"fell at {fell_at:.1f} s, at {angle:.0f}° of tilt"
    else:
        fell_at = None
        means, whole = window_means(one.velocity, one.valid, one.timestep)
        off = np.where(whole[:, 0, None], np.abs(means[:, 0] - command) / allowed, 0.0)
        start = int(off.max(axis=-1).argmax()) if len(off) else 0
        moment = (start + (alive - len(means)) / 2) * one.timestep
        fate = without_fall_in_words(one.orientation[:, 0], one.timestep)
    forward, yaw_rate = one.velocity[: max(alive, 1), 0].mean(axis=0)
    shown = METRICS["forward_velocity"].show(float(forward)), METRICS["yaw_rate"].show(float(yaw_rate))
    story = f"It {fate}. Mean velocities: {shown[0]} m/s and {shown[1]} rad/s."
    return Failure(row, command, int(one.seeds[0]), fell_at, moment, badness, story)
