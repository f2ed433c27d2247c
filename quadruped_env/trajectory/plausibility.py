"""Plausibility of recordings: positions, velocities, efforts and timestamps against each other.

A finding says what cannot be, where, how much, and which option repairs it. Nothing is changed here. The bounds are far
from what legs do, so that a motion is never called impossible: real logs reach 25 rad/s.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.rows import Rows
from quadruped_env.trajectory.steps import MAX_AWAY, MAX_SPEED, Steps, clock_jumps, frozen
from quadruped_env.utils.arrays import Bools, Floats

TURN: Final = 2.0 * np.pi

_MIN_ROWS: Final = 20
"""Fewer rows show nothing."""
_PERIODS: Final = (5e-5, 1.0)
"""Shortest and longest time between rows of a robot's log, s."""
_MIN_MOTION: Final = 0.02
"""Root mean square motion within 0.1 s from which on a joint counts as moving, rad."""
_MAX_TORQUE: Final = 500.0
"""N m; no leg that fits this package has more."""
_FACTORS: Final = {
    "velocities in degrees/s": 180.0 / np.pi,
    "velocities in rpm": 30.0 / np.pi,
    "velocities in turns/s": 1.0 / TURN,
    "positions in degrees and velocities in rad/s": np.pi / 180.0,
    "positions in turns": TURN,
    "timestamps in another unit": 1e3,
    "timestamps in another unit, or velocities in 1/ms": 1e-3,
}
"""Usual cause -> velocity over rate of change of the position."""
_KINDS: Final = {"spike": "jump", "impossible": "jump", "speed": "velocity"}
"""Kind of place -> kind of finding, where they differ."""
_IGNORE_VELOCITY: Final = "leave them out (--ignore velocity), or compute them (convert --differentiate)"
_PERIOD: Final = "give the time from row to row in s (--stamps 0.01)"
_CUT: Final = "cut there (convert --start, --stop), or leave the joint out"


@dataclass(frozen=True)
class Finding:
    """Something in a recording that cannot be."""

    kind: str
    """`timestamps`, `wrap`, `jump`, `frozen`, `velocity` or `effort`"""
    text: str
    """Description with place, magnitude and repair"""
    joints: tuple[str, ...]
    """Joints concerned; all of them if the timestamps are"""


class _Events:
    """Steps at which one kind of thing happens, of which there is one or more."""

    def __init__(self, mask: Bools, sizes: Floats, rows: Rows, steps: Steps, after: int) -> None:
        found, self.columns = np.nonzero(mask)
        first, size = found[0] + after, sizes[mask]
        largest = int(size.argmax())
        self.count = len(found)
        self.row = int(rows.numbers[first])
        """Number of the first row in the file: of the row before its step, or after it."""
        self.time = float(rows.stamps[first] - rows.stamps[0]) / NS_PER_SECOND
        """Time of the first row, s."""
        self.largest, self.step = float(size[largest]), float(steps.time[found[largest]])
        """Magnitude of the largest one, and the time over which it happens, s."""
        self.smallest = float(size.min())


def findings(rows: Rows, row_name: str = "row", periods: Sequence[float] = (TURN,)) -> tuple[Finding, ...]:
    """Return the findings in rows whose timestamps increase.

    Args:
        rows: of a recording.
        row_name: a row in words.
        periods: angles after which an encoder may begin again, rad.
    """
    if len(rows) < _MIN_ROWS:
        return ()
    with np.errstate(all="ignore"):
        return tuple(_Check(rows, row_name, periods).findings())


class _Check:
    """Checks of rows, their steps, and their motion within windows of 0.1 s."""

    def __init__(self, rows: Rows, row_name: str, periods: Sequence[float]) -> None:
        self._rows, self._row_name, self._names = rows, row_name, rows.names
        self._steps = steps = Steps(rows, periods)
        change = np.where(steps.bad | steps.false_speeds, np.nan, steps.change - steps.wrapped)
        change[1:][steps.false_speeds[:-1]] = np.nan
        width = max(4, round(0.1 / steps.period)) if steps.period > 0.0 else 4
        self._edges = np.arange(0, len(change), min(width, len(change) // 4))
        motion = self._windows(change)
        self._whole: Bools = np.isfinite(motion)
        """Windows without a bad step (W, J)."""
        self._motion = np.where(self._whole, motion, 0.0)
        """Motion within the windows, rad (W, J)."""
        known = np.nan_to_num(change)
        self._sampled = (known[1:] * known[:-1]).sum(axis=0) > 0.5 * (known**2).sum(axis=0)
        """True for joints whose motion goes on from row to row (J,)."""

    def _windows(self, values: Floats) -> Floats:
        return np.add.reduceat(values[: self._edges[-1]], self._edges[:-1], axis=0)

    def _rms(self, sums: Floats) -> Floats:
        """Return the root mean square (J,) of sums within the windows (W, J)."""
        return np.sqrt((sums**2).sum(axis=0) / np.maximum(self._whole.sum(axis=0), 1))

    def findings(self) -> Iterator[Finding]:
        """Yield the findings, by kind."""
        velocities = list(self._of_velocities())
        said = {name for finding in velocities for name in finding.joints}
        if _PERIODS[0] <= self._steps.period <= _PERIODS[1]:
            yield from (*self._of_timestamps(), *self._of_places(np.array([name not in said for name in self._names])))
        else:
            yield self._finding(
                "timestamps",
                f"timestamps: the usual time between {self._row_name}s is {self._steps.period:.4g} s, which no robot's "
                f"log has: they are probably in another unit; name it (stamp_unit in a map), or {_PERIOD}",
            )
        yield from (*velocities, *self._of_efforts(), *self._of_copies())

    def _finding(self, kind: str, text: str, joints: Iterable[int] | None = None) -> Finding:
        return Finding(kind, text, self._names if joints is None else tuple(self._names[int(i)] for i in joints))

    def _of_timestamps(self) -> Iterator[Finding]:
        row, steps = self._row_name, self._steps
        mask, durations = clock_jumps(steps)
        if mask.any():
            clock = _Events(mask, durations, self._rows, steps, after=0)
            yield self._finding(
                "timestamps",
                f"timestamps jump by {clock.largest:.4g} s {self._at(clock)} while the joints move on as from one "
                f"row to the next: the clock was set, or rows are from two recordings; {_PERIOD}, or cut "
                f"(convert --start, --stop)",
            )
        duration, motion = steps.duration, np.abs(steps.change).max(axis=1)
        short = duration < 0.2 * np.sort(duration)[: len(duration) * 99 // 100].mean()
        count, near, far = np.count_nonzero(short), motion[short].sum(), motion[~short].mean()
        # After a gap, the joints have moved farther than within a burst.
        if count >= 10 and count > 0.02 * len(duration) and near > 0.0 and far < 3.0 * near / count:
            yield self._finding(
                "timestamps",
                f"timestamps come in bursts: {count} of {len(self._rows)} {row}s follow the one before within a fifth "
                f"of the mean time, as if they were taken when messages arrived in batches; use the header's, or "
                f"{_PERIOD}",
            )

    def _of_places(self, unsaid: Bools) -> Iterator[Finding]:
        """Yield the findings at single rows; velocities only of the joints `unsaid` (J,)."""
        rows, steps = self._rows, self._steps
        size = np.abs(steps.change)
        masks = {
            "wrap": (steps.wrapped != 0.0, np.abs(steps.wrapped), 1),
            "spike": (steps.away, size, 1),
            "jump": (steps.jumps, size, 1),
            "impossible": (steps.impossible, size, 1),
            "frozen": (*frozen(rows, steps), 0),
            "speed": (
                steps.false_speeds & unsaid,
                np.abs(rows.values.get("velocity", rows.values["position"])[:-1]),
                0,
            ),
        }
        places = {
            kind: _Events(mask, sizes, rows, steps, after) for kind, (mask, sizes, after) in masks.items() if mask.any()
        }
        jump, wrapped = places.get("jump"), places.get("wrap")
        again = jump is not None and jump.count > 2 and 1.0 < jump.largest < 1.2 * jump.smallest
        wrap = "if an encoder begins again there, unwrap it (--unwrap {size:.3g}); " if again else ""
        option = "" if wrapped is None or np.isclose(wrapped.largest, TURN) else " {size:.6g}"
        texts = {
            "wrap": f"positions wrap by {{size:.4g}} rad between two {self._row_name}s in {{joints}}, {{at}}; unwrap "
            f"them (--unwrap{option})",
            "spike": f"positions jump away and back within {MAX_AWAY} {self._row_name}s, which no joint can do: by "
            "{size:.3g} rad in {step:.3g} s in {joints}, {at}; leave such rows out (--repair despike)",
            "jump": "positions jump faster than a joint can turn (joint targets may): by "
            f"{{size:.3g}} rad in {{step:.3g}} s, {{speed:.0f}} rad/s, in {{joints}}, {{at}}; {wrap}{_CUT}, or mark "
            "the value as missing in a map (missing, with --repair drop)",
            "impossible": "positions jump in {share:.0f} % of the steps of {joints}, as no joint can (joint targets "
            f"may): faster than {MAX_SPEED:g} rad/s, by up to {{size:.3g}} rad in {{step:.3g}} s, {{speed:.0f}} rad/s, "
            "{at}; two publishers on one topic, swapped columns or an overflow do this: record one robot alone, or map "
            "its own columns; if the unit is another one, name it (--unit deg; unit, stamp_unit in a map)",
            "frozen": f"positions freeze while the joint moves (joint targets may): for up to {{size:.3g}} s in "
            f"{{joints}}, {{at}}; {_CUT}",
            "speed": "velocities that the positions do not have: up to {size:.3g} rad/s in {joints}, {at}; "
            f"{_IGNORE_VELOCITY}",
        }
        for kind, events in places.items():
            columns = list(dict.fromkeys([events.columns[0], *np.unique(events.columns)]))
            text = texts[kind].format(
                joints=self._some(columns),
                at=self._at(events),
                size=events.largest,
                step=events.step,
                speed=events.largest / events.step,
                share=100.0 * events.count / (len(columns) * len(rows)),
            )
            yield self._finding(_KINDS.get(kind, kind), text, columns)

    def _of_velocities(self) -> Iterator[Finding]:
        if "velocity" not in self._rows.values:
            return
        velocity = self._rows.values["velocity"]
        integral = (velocity[1:] + velocity[:-1]) / 2.0 * self._steps.duration[:, None]
        speeds = np.where(self._whole, self._windows(integral), 0.0)
        motion, speed = self._rms(self._motion), self._rms(speeds)
        counts = self._whole.sum(axis=0)
        correlation = self._motion.T @ speeds / np.outer(motion, speed) / np.sqrt(np.outer(counts, counts))
        own = np.diag(correlation)
        groups: dict[str, list[int]] = {}
        factors: dict[str, list[float]] = {}
        swapped = ""
        known = (counts >= 8) & (motion >= _MIN_MOTION) & ~self._steps.impossible.any(axis=0)
        for i in np.flatnonzero(known):
            factor = speed[i] / motion[i]
            sampled = self._sampled[i]
            others = np.where(np.arange(len(own)) == i, -1.0, np.nan_to_num(correlation[i], nan=-1.0))
            best = int(others.argmax())
            if speed[i] == 0.0:
                problem = "are 0 while the positions change, so they were not measured"
            elif own[i] > 0.8 and not (0.6 if sampled else 0.3) < factor < (1.7 if sampled else 3.0):
                causes = ", or ".join(cause for cause, one in _FACTORS.items() if abs(np.log(factor / one)) < 0.12)
                problem = "are {} times the rate at which the positions change" + f" ({causes}?)" * bool(causes)
                factors.setdefault(problem, []).append(float(factor))
            elif own[i] < -0.8:
                problem = "have the opposite sign of the rate at which the positions change"
            elif own[i] < 0.8 and others[best] > 0.95:
                swapped = swapped or f"{self._names[best]} for {self._names[i]}"
                problem = f"fit the positions of other joints and not their own ({swapped}): swapped or copied"
            elif own[i] < 0.3 and sampled:
                problem = "have nothing to do with the rate at which the positions change"
            else:
                continue
            groups.setdefault(problem, []).append(int(i))
        for problem, joints in groups.items():
            fix = "fix the unit (velocity_unit or stamp_unit in a map, --stamps), or " if problem in factors else ""
            span = dict.fromkeys(f"{end(factors.get(problem, [0.0])):.3g}" for end in (min, max))
            text = f"velocities of {self._some(joints)} {problem.format(' to '.join(span))}; {fix}{_IGNORE_VELOCITY}"
            yield self._finding("velocity", text, joints)

    def _of_efforts(self) -> Iterator[Finding]:
        if "effort" not in self._rows.values:
            return
        effort = self._rows.values["effort"]
        least, most = np.fmin.reduce(effort), np.fmax.reduce(effort)
        constant = np.flatnonzero((self._rms(self._motion) > _MIN_MOTION) & (least == most))
        size = np.fmax(most, -least)
        large = np.flatnonzero(size > _MAX_TORQUE)
        if len(constant):
            problem = (
                f"are {least[constant[0]] + 0.0:.4g} in every {self._row_name} while the joints move, so they were not "
                f"measured; "
            )
            yield self._effort(constant, problem)
        if len(large):
            factor = "which are no N m of a leg; give their factor (effort_scale in a map), or "
            yield self._effort(large, f"reach {np.nanmax(size):.4g}, {factor}")

    def _effort(self, joints: NDArray[np.intp], problem: str) -> Finding:
        text = f"efforts of {self._some(joints)} {problem}leave them out (--ignore effort)"
        return self._finding("effort", text, joints)

    def _of_copies(self) -> Iterator[Finding]:
        moving = [i for i, size in enumerate(self._rms(self._motion)) if size >= _MIN_MOTION]
        values, same = self._rows.values, f"in every {self._row_name}: "
        # Joints may have the same targets, but never exactly the same measurements.
        for one, other in combinations(moving if "effort" in values else [], 2):
            if np.array_equal(values["position"][:, one], values["position"][:, other]):
                names = self._some([one, other]).replace(",", " and")
                text = f"{names} have the same positions {same}one of the two is a copy; map its own column"
                yield self._finding("jump", text, [one, other])
        for kind, copy in combinations(values, 2):
            if moving and np.array_equal(values[kind], values[copy]):
                text = f"{copy} and {kind} are the same numbers {same}a column was copied; leave it out"
                yield self._finding(copy, f"{text} (--ignore {copy})")

    def _at(self, events: _Events) -> str:
        place = f"at {events.time:.3f} s ({self._row_name} {events.row})"
        return place if events.count == 1 else f"first {place}, {events.count} times"

    def _some(self, columns: Iterable[int]) -> str:
        """Return names of a few joints, and how many more there are."""
        names = [self._names[int(i)] for i in columns]
        return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
