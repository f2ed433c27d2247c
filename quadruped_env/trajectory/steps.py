"""Steps between the rows of a recording: those that wrap, jump, go away and come back, freeze, or are gaps.

A step is compared with what a joint can do, whatever the steps around it are.
"""

from collections.abc import Sequence
from typing import Final

import numpy as np

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.arrays import Bools, Floats

MAX_SPEED: Final = 30.0
"""Speed that no joint of a leg keeps up from row to row, rad/s; logs of real robots reach 25."""
MAX_SHARE: Final = 0.05
"""Share of a joint's steps up to which impossible ones are single events."""
_MIN_STEP: Final = 0.1
"""Smallest step that is not noise, rad."""
_MAX_REST: Final = 0.15
"""Maximum difference between a wrap and whole periods, in periods."""
MAX_AWAY: Final = 5
"""Maximum rows of a spike."""
_MIN_FROZEN: Final = 5
"""Equal rows from which on a position is frozen."""
_MIN_TOLD: Final = 0.3
"""Mean speed from which on a velocity says that the joint moves, rad/s."""


class Steps:
    """The steps between rows: n rows have n - 1.

    Args:
        rows: two or more.
        periods: angles after which an encoder may begin again, rad.
    """

    def __init__(self, rows: Rows, periods: Sequence[float]) -> None:
        self.change = np.diff(rows.values["position"], axis=0)
        """Steps of the positions, rad (n - 1, J)"""
        self.duration = np.diff(rows.stamps) / NS_PER_SECOND
        """Durations of the steps, s (n - 1,)"""
        self.period = float(np.median(self.duration))
        self.gap = self.duration > 3.0 * self.period
        # Timestamps of a burst are too close to each other; positions are not.
        self.time = np.maximum(self.duration, self.period)
        self.held = _held(self.change)
        """Rows for which a joint's value is held (J,)."""
        size = np.abs(self.change)
        bound = np.maximum(_MIN_STEP, MAX_SPEED * self.time[:, None] * self.held)
        measured = ~self.gap[:, None]
        self.wrapped = np.zeros_like(size)
        """Whole periods in the steps, rad (n - 1, J)"""
        usual = np.array([np.quantile(one[one > 0.0], 0.75) if one.any() else 0.0 for one in size.T])
        for period in periods:
            whole = np.rint(self.change / period) * period
            # The joint goes on after the wrap as it does elsewhere.
            smooth = np.abs(self.change - whole) <= np.minimum(4.0 * usual + 0.02, _MAX_REST * period)
            self.wrapped = np.where(measured & smooth & (size > 0.5 * bound) & (whole != 0.0), whole, self.wrapped)
        too_fast = measured & (size > bound) & (self.wrapped == 0.0)
        often = too_fast.mean(axis=0) > MAX_SHARE
        self.spikes = self._spikes(too_fast & ~often)
        """Positions where the joint stays for a few rows only (n, J)"""
        self.away = self.spikes[1:] & ~self.spikes[:-1]
        """Steps to spikes (n - 1, J)"""
        beside = self.spikes[1:] | self.spikes[:-1]
        self.jumps = too_fast & ~beside & ~often
        """Single steps that no joint makes (n - 1, J)"""
        self.impossible = too_fast & often
        """Steps that no joint makes, of joints that make many of them (n - 1, J)"""
        self.bad = too_fast | beside | self.gap[:, None]
        """Steps that say nothing about the motion (n - 1, J)"""
        self.speeds = np.abs(rows.values["velocity"][:-1]) if "velocity" in rows.values else np.zeros_like(size)
        """Magnitudes of the velocities of the first rows of steps, rad/s (n - 1, J); 0 if they were not recorded."""
        moved = np.where(self.bad, np.inf, np.abs(self.change - self.wrapped)) / self.time[:, None]
        padded = np.pad(moved, ((2, 2), (0, 0)), mode="edge")
        fastest = np.max([padded[k : k + len(moved)] for k in range(5)], axis=0)
        false = self.speeds - fastest > MAX_SPEED
        self.false_speeds = false & (false.mean(axis=0) <= MAX_SHARE)
        """Single velocities far beyond the rates of the positions around them, of the first rows of steps (n - 1, J)"""

    def _spikes(self, too_fast: Bools) -> Bools:
        """Return the mask (n, J) of positions after an impossible step, from which the joint comes back soon."""
        size = np.abs(self.change)
        spikes = np.zeros((len(size) + 1, size.shape[1]), dtype=np.bool_)
        for count in range(1, min(MAX_AWAY, len(size) - 1) + 1):
            first, last = slice(None, -count), slice(count, None)
            moves = [self.change[k : k + len(size) - count] for k in range(count + 1)]
            stays = np.abs(moves[1:-1]).max(axis=0, initial=0.0) < 0.25 * size[first]
            returns = np.abs(np.sum(moves, axis=0)) < 0.5 * size[first]
            found = too_fast[first] & stays & returns & ~spikes[:-1][first] & ~self.gap[last, None]
            for k in range(1, count + 1):
                spikes[k : k + len(found)] |= found
        return spikes


def _held(change: Floats) -> Floats:
    """Return the rows (J,) for which a value is held, as in a log faster than the measurements; 1 where it is not."""
    changes = np.count_nonzero(change, axis=0)
    return np.where(
        (2 * changes < len(change)) & (40 * changes >= len(change)), len(change) / np.maximum(changes, 1), 1.0
    )


def frozen(rows: Rows, steps: Steps) -> tuple[Bools, Floats]:
    """Return where positions freeze while the velocity says that the joint moves.

    The first result is the mask (n - 1, J) of the first steps of such runs of equal positions, the second the duration
    of each run at its first step, s (n - 1, J).
    """
    found, length = np.zeros(steps.change.shape, dtype=np.bool_), np.zeros(steps.change.shape)
    for j, speed in enumerate(np.abs(rows.values["velocity"]).T if "velocity" in rows.values else ()):
        still = np.concatenate([[False], (steps.change[:, j] == 0.0) & ~steps.gap, [False]])
        starts, ends = np.flatnonzero(np.diff(still.astype(np.int8))).reshape(-1, 2).T
        runs = ends - starts >= _MIN_FROZEN * steps.held[j]
        for start, end in zip(starts[runs], ends[runs], strict=True):
            length[start, j] = steps.duration[start:end].sum()
            told = speed[start:end].mean()
            found[start, j] = told > _MIN_TOLD and told * length[start, j] > 0.1
    return found, length


def clock_jumps(steps: Steps) -> tuple[Bools, Floats]:
    """Return the mask (n - 1, 1) of steps that are too long for what the joints do in them, and all durations, s."""
    found = np.zeros((len(steps.gap), 1), dtype=np.bool_)
    for i in np.flatnonzero((steps.duration > 10.0 * steps.period) & (steps.duration > 0.2)):
        near = np.abs(np.concatenate([steps.change[max(i - 3, 0) : i], steps.change[i + 1 : i + 4]]))
        if len(near) < 6:
            continue
        ahead = (steps.change[i - 1] + steps.change[i + 1]) / 2.0
        moving = near.min(axis=0) > 0.005
        off = np.abs(steps.change[i] - ahead)
        found[i] = moving.sum() >= 2 and bool((off[moving] < 0.5 * near.mean(axis=0)[moving]).all())
    return found, steps.duration[:, None]
