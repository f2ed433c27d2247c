"""The worst episodes of a controller, each with a short description of the failure."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.comparison import Command, Comparison
from quadruped_env.evaluation.measures import METRICS, window_means, without_fall_in_words
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.verdict import tolerance
from quadruped_env.robot import Robot
from quadruped_env.utils.rotations import tilt, up_in_body, yaw

SHOWN: Final = 3
_ERRORS: Final = ("forward_velocity_error", "yaw_rate_error")
_LEANING: Final = 0.3
"""Component of the world's up direction along a base axis above which the robot leans to that side."""
_DRIFT: Final = 0.3
"""Sideways displacement from which the description mentions drift, m."""


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
    """Description in a few sentences"""


def worst_episodes(comparison: Comparison, controller: str = "policy", count: int = SHOWN) -> list[Failure]:
    """Worst episodes, at most one per command: falls first, the earliest first, then the largest velocity errors.

    One per command, because episodes of one command mostly fail in the same way.
    """
    rollout = comparison.rollouts[controller]
    worst = []
    for i, command in enumerate(comparison.commands):
        rows = comparison.rows(i)
        errors = np.stack([comparison.values[controller][m][i] for m in _ERRORS])
        off = np.max(errors / _tolerances(comparison.robot)[:, None], axis=0)
        fell = rollout.fallen[rows]
        alive = rollout.valid[:, rows].sum(axis=0)
        badness = np.where(fell, np.inf, np.nan_to_num(off))
        # If several episodes fall, the earliest fall.
        j = int(np.lexsort((alive, -badness))[0])
        worst.append((-float(badness[j]), int(alive[j]), int(rows[j]), command))
    return [_failure(rollout, row, command, -badness) for badness, _, row, command in sorted(worst)[:count]]


def _tolerances(robot: Robot) -> NDArray[np.float64]:
    """Errors of forward velocity, m/s, and yaw rate, rad/s, that count as 1 (2,)."""
    return np.array([tolerance(metric, robot) for metric in _ERRORS])


def _failure(rollout: Rollout, row: int, command: Command, badness: float) -> Failure:
    one = rollout.select([row])
    alive = int(one.valid[:, 0].sum())
    fell_at = (alive + 1) * one.timestep if one.fallen[0] else None
    means, whole = window_means(one.velocity, one.valid, one.timestep)
    off = np.abs(means[:, 0] - command) / _tolerances(one.robot)
    off[~whole[:, 0]] = 0.0
    moment = fell_at
    if moment is None:
        start = int(off.max(axis=-1).argmax()) if len(off) else 0
        moment = (start + (alive - len(means)) / 2) * one.timestep
    done = one.velocity[: max(alive, 1), 0].mean(axis=0)
    if fell_at is None:
        parts = [f"It {without_fall_in_words(one.orientation[:, 0], one.timestep)}."]
    else:
        parts = [_fall(one, alive, fell_at)]
    parts.append(_velocities(command, done, one.robot))
    if fell_at is None:
        parts.append(_drift(one, command))
    return Failure(row, command, int(one.seeds[0]), fell_at, moment, badness, " ".join(filter(None, parts)))


def _fall(one: Rollout, alive: int, fell_at: float) -> str:
    last = min(alive, len(one.valid) - 1)
    up = up_in_body(one.orientation[last, 0])
    directions = [
        (abs(up[0]), "forwards, over its nose" if up[0] < 0 else "backwards, over its tail"),
        (abs(up[1]), "over its left side" if up[1] < 0 else "over its right side"),
    ]
    lean, direction = max(directions)
    angle = np.degrees(tilt(one.orientation[last, 0]))
    if lean < _LEANING:
        return f"It fell at {fell_at:.1f} s: its trunk hit the ground while nearly level ({angle:.0f}° of tilt)."
    return f"It fell at {fell_at:.1f} s, {direction}, at {angle:.0f}° of tilt."


def _velocities(command: Command, done: NDArray[np.float64], robot: Robot) -> str:
    """Mean velocities and their commands, the one with the larger relative error first."""
    names = ("forward_velocity", "yaw_rate")
    off = np.abs(done - command) / _tolerances(robot)
    worse, other = (names[i] for i in np.argsort(-off))
    shown = {
        name: f"mean {METRICS[name].label.lower()} {METRICS[name].show(got)} {METRICS[name].unit} (command {target:g})"
        for name, got, target in zip(names, done, command, strict=True)
    }
    return f"Largest error: {shown[worse]}; {shown[other]}."


def _drift(one: Rollout, command: Command) -> str:
    """Sideways displacement of a robot whose command is to go straight; empty if it is small."""
    if command[1]:
        return ""
    heading = yaw(one.orientation[0, 0])
    x, y = one.base_position[-1, 0, :2] - one.base_position[0, 0, :2]
    across = float(y * np.cos(heading) - x * np.sin(heading))
    if abs(across) < _DRIFT:
        return ""
    return f"It ended {abs(across):.1f} m to the {'left' if across > 0 else 'right'} of a straight line."
