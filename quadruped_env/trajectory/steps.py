"""Steps between the rows of a recording: those that wrap, jump, go away and come back, freeze, or are gaps.

A step is held against what a joint can do, and against the steps around it. Where most steps are wrong none stands out:
there the bound alone counts.
"""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.rows import Rows

_MAX_SPEED: Final = 20.0
"""Maximum speed from rest to rest within one step, rad/s."""
_MAX_ACCELERATION: Final = 5000.0
"""Maximum acceleration, rad/s^2: 20 N m accelerate a bare shank and its rotor by less."""
MAX_SPEED: Final = 30.0
"""Speed that no joint of a leg keeps up from row to row, rad/s; logs of real robots reach 25."""
_MAX_SHARE: Final = 0.05
"""Share of a joint's steps beyond `MAX_SPEED` from which on they need not stand out."""
_MIN_STEP: Final = 0.1
"""Smallest step that is no noise, rad."""
_PROMINENCE: Final = 8.0
"""Factor over the median of the steps around it from which on a step stands out."""
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
        position = rows.values["position"]
        self.change = np.diff(position, axis=0)
        """Steps of the positions, rad (n - 1, J)"""
        self.duration = np.diff(rows.stamps) / NS_PER_SECOND
        """Durations of the steps, s (n - 1,)"""
        self.period = float(np.median(self.duration))
        self.gap = self.duration > 3.0 * self.period
        # Timestamps of a burst are too close to each other; positions are not.
        self.time = np.maximum(self.duration, self.period)
        size = np.abs(self.change)
        self.held = _held(self.change)
        """Rows for which a joint's value is held (J,)"""
        time = self.time[:, None] * self.held
        bound = np.maximum(_MIN_STEP, np.maximum(_MAX_SPEED * time, _MAX_ACCELERATION / 4.0 * time**2))
        self.wrapped = np.zeros_like(self.change)
        """Whole periods in the steps, rad (n - 1, J)"""
        usual, _ = _around(size)
        large = (size > 0.5 * bound) & ~self.gap[:, None]
        for period in periods:
            whole = np.rint(self.change / period) * period
            rest = np.abs(self.change - whole)
            # The joint goes on after the wrap as before and after it.
            most = _around(rest)[1]
            smooth = (rest <= np.minimum(4.0 * most + 0.02, 0.15 * period)) & (size > 4.0 * most)
            self.wrapped = np.where(large & smooth & (whole != 0.0), whole, self.wrapped)
        stands_out = large & (self.wrapped == 0.0) & (size > _PROMINENCE * usual)
        self.spikes = self._spikes(stands_out, stands_out & (size > bound))
        """Positions where the joint stays for a few rows only (n, J)"""
        self.away = self.spikes[1:] & ~self.spikes[:-1]
        """Steps to spikes (n - 1, J)"""
        beside = self.spikes[1:] | self.spikes[:-1] | self.gap[:, None]
        too_fast = beyond(self.change, time) & ~beside & (self.wrapped == 0.0)
        self.impossible = too_fast & (too_fast.mean(axis=0) > _MAX_SHARE)
        """Steps that no joint makes, of joints that make many of them (n - 1, J)"""
        velocity = rows.values.get("velocity", np.zeros_like(position))
        self.jumps = stands_out & (size > bound) & ~beside & ~self.impossible
        self.bad = self.jumps | self.impossible | beside
        """Steps that say nothing about the motion (n - 1, J)"""
        speed = np.abs(velocity)[:-1]
        moved = np.where(self.bad, np.inf, np.abs(self.change - self.wrapped)) / self.time[:, None]
        padded = np.pad(moved, ((2, 2), (0, 0)), mode="edge")
        fastest = np.max([padded[k : k + len(moved)] for k in range(5)], axis=0)
        self.false_speeds = (speed - fastest > _MAX_SPEED) & (speed > _PROMINENCE * _around(speed)[0])
        """Single velocities far beyond those of the positions around them, of the first rows of steps (n - 1, J)"""

    def _spikes(self, stands_out: NDArray[np.bool_], far: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Mask (n, J) of positions to which a step leads that stands out, and from which another leads back."""
        size = np.abs(self.change)
        spikes = np.zeros((len(size) + 1, size.shape[1]), dtype=np.bool_)
        for count in range(1, min(MAX_AWAY, len(size) - 1) + 1):
            first, last = slice(None, -count), slice(count, None)
            moves = [self.change[k : k + len(size) - count] for k in range(count + 1)]
            # The joint goes away, stays there, and comes back near to where it was.
            stays = np.abs(moves[1:-1]).max(axis=0, initial=0.0) < 0.25 * size[first]
            returns = np.abs(np.sum(moves, axis=0)) < 0.5 * size[first]
            leaves = stands_out[first] & far[last] if count > 1 else stands_out[first]
            found = leaves & stays & returns & ~spikes[:-1][first] & ~self.gap[last, None]
            for k in range(1, count + 1):
                spikes[k : k + len(found)] |= found
        return spikes


def beyond(change: NDArray[np.float64], time: NDArray[np.float64], max_speed: float = MAX_SPEED) -> NDArray[np.bool_]:
    """Mask (n, J) of steps of positions, rad (n, J), within times, s (n, J) or (n, 1), that no joint makes."""
    return np.abs(change) > np.maximum(_MIN_STEP, max_speed * time)


def _around(sizes: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Median and upper quartile (n, J) of the five magnitudes before and the five after each one."""
    padded = np.pad(sizes, ((5, 5), (0, 0)), mode="edge")
    near = np.sort([padded[k : k + len(sizes)] for k in range(11) if k != 5], axis=0)
    return (near[4] + near[5]) / 2.0, near[6]


def _held(change: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rows (J,) for which a value is held, as in a log that is faster than the measurements; 1 where it is not."""
    changes = np.count_nonzero(change, axis=0)
    return np.where(
        (2 * changes < len(change)) & (40 * changes >= len(change)), len(change) / np.maximum(changes, 1), 1.0
    )


def frozen(rows: Rows, steps: Steps) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """Mask (n - 1, J) of the first steps of runs of equal positions while the joint moves, and the runs' lengths, s.

    It moves if its velocity says so, if it catches up at the end, or if all joints stop and go on at once.
    """
    found, length = np.zeros(steps.change.shape, dtype=np.bool_), np.zeros(steps.change.shape)
    velocity = rows.values.get("velocity", np.zeros(rows.values["position"].shape))
    size = np.abs(steps.change)
    for j in range(size.shape[1]):
        still = np.concatenate([[False], (size[:, j] == 0.0) & ~steps.gap, [False]])
        starts, ends = np.flatnonzero(np.diff(still.astype(np.int8))).reshape(-1, 2).T
        runs = ends - starts >= _MIN_FROZEN
        for start, end in zip(starts[runs], ends[runs], strict=True):
            length[start, j] = steps.duration[start:end].sum()
            told = float(np.abs(velocity[start:end, j]).mean())
            if told > _MIN_TOLD and told * length[start, j] > 0.1 and end - start >= _MIN_FROZEN * steps.held[j]:
                found[start, j] = True
                continue
            before, after = size[max(start - 3, 0) : start], size[end + 1 : end + 4]
            if len(before) < 3 or len(after) < 3 or before[:, j].min() == 0.0 or after[:, j].min() == 0.0:
                continue
            catches_up = size[end, j] > max(0.05, 5.0 * before[:, j].mean(), 5.0 * after[:, j].mean())
            fast = np.minimum(before.min(axis=0), after.min(axis=0)) > 0.01
            found[start, j] = catches_up or (fast[j] and fast.sum() > 1 and not size[start:end].any())
    return found, length


def clock_jumps(steps: Steps) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """Mask (n - 1, 1) of steps of time that are too long for what the joints do in them."""
    found = np.zeros((len(steps.gap), 1), dtype=np.bool_)
    for i in np.flatnonzero((steps.duration > 10.0 * steps.period) & (steps.duration > 0.2)):
        near = np.abs(np.concatenate([steps.change[max(i - 3, 0) : i], steps.change[i + 1 : i + 4]]))
        if len(near) < 6:
            continue
        ahead = (steps.change[i - 1] + steps.change[i + 1]) / 2.0
        moving = near.min(axis=0) > 0.005
        off = np.abs(steps.change[i] - ahead)
        found[i] = moving.sum() >= 2 and bool((off[moving] < 0.5 * near.mean(axis=0)[moving]).all())
    return found, np.broadcast_to(steps.duration[:, None], found.shape)
