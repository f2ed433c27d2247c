"""Plausibility of recordings: positions, velocities, efforts and timestamps against each other.

A finding says what cannot be, where, how much, and which option repairs it. Nothing is changed here. The bounds are far
from what legs do, so that a motion is never called impossible: real logs reach 25 rad/s.
"""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.rows import Rows
from quadruped_env.trajectory.steps import MAX_AWAY, MAX_SPEED, Steps, clock_jumps, frozen

TURN: Final = 2.0 * np.pi

_MIN_ROWS: Final = 20
"""Fewer rows show nothing."""
_BLOCK: Final = 4096
_MARGIN: Final = 16
"""Rows of context on both sides of a row."""
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


@dataclass
class _Events:
    """Places at which one kind of thing happens."""

    counts: Counter[int] = field(default_factory=Counter)
    """Column -> number of places"""
    first: tuple[int, float, int] = (0, 0.0, 0)
    """Number of the row in the file, time in s, column"""
    largest: tuple[float, float] = (0.0, 0.0)
    """Magnitude of the largest one, and the time over which it happens, s"""
    smallest: float = np.inf


def findings(rows: Rows, row_name: str = "row", periods: Sequence[float] = (TURN,)) -> tuple[Finding, ...]:
    """The findings in rows whose timestamps increase.

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
    """Collects what is implausible, in blocks, since the checks take many times the memory of the rows."""

    def __init__(self, rows: Rows, row_name: str, periods: Sequence[float]) -> None:
        self._rows = rows
        self._row_name = row_name
        self._names = rows.names
        self._count = len(rows)
        self._period = float(np.median(np.diff(rows.stamps[: _BLOCK + 1]))) / NS_PER_SECOND
        self._places: defaultdict[str, _Events] = defaultdict(_Events)
        self._sums: defaultdict[str, Any] = defaultdict(float)
        self._sums |= {name: np.zeros(len(rows.names)) for name in ("windows", "motion")}
        begin = 0
        while begin < len(rows):
            # Not a few rows alone at the end, which show nothing.
            end = begin + _BLOCK if begin + _BLOCK + _MIN_ROWS <= len(rows) else len(rows)
            first = max(begin - _MARGIN, 0)
            part = rows.take(np.s_[first : end + _MARGIN])
            steps = Steps(part, periods)
            if self._has_time:
                self._add_places(part, steps, begin - first, end - first)
            self._add_sums(part, steps, begin - first, end - first)
            begin = end

    @property
    def _has_time(self) -> bool:
        return _PERIODS[0] <= self._period <= _PERIODS[1]

    def _add_places(self, rows: Rows, steps: Steps, begin: int, end: int) -> None:
        times = (rows.stamps - self._rows.stamps[0]) / NS_PER_SECOND

        def add(name: str, mask: NDArray[np.bool_], sizes: NDArray[np.float64], after: int = 1) -> None:
            """Add steps, each at the row before or after it."""
            found, columns = np.nonzero(mask)
            inside = (found + after >= begin) & (found + after < end)
            found, columns = found[inside], columns[inside]
            if len(found):
                first = int(rows.numbers[found[0] + after]), float(times[found[0] + after]), int(columns[0])
                events, size = self._places[name], sizes[found, columns]
                events.first = events.first if events.counts else first
                events.counts.update(columns.tolist())
                events.largest = max(events.largest, *zip(size.tolist(), steps.time[found].tolist(), strict=True))
                events.smallest = min(events.smallest, size.min())

        size = np.abs(steps.change)
        add("wrap", steps.wrapped != 0.0, np.abs(steps.wrapped))
        add("spike", steps.away, size)
        add("jump", steps.jumps, size)
        add("impossible", steps.impossible, size)
        add("frozen", *frozen(rows, steps), after=0)
        if "velocity" in rows.values:
            add("speed", steps.false_speeds, np.abs(rows.values["velocity"])[:-1], after=0)
        add("clock", *clock_jumps(steps), after=0)
        inside = slice(max(begin - 1, 0), end - 1)
        duration, motion = steps.duration[inside], size[inside].max(axis=1, initial=0.0)
        short = duration < 0.2 * np.sort(duration)[: len(duration) * 99 // 100].mean()
        for name, mask in (("short", short), ("long", ~short)):
            self._sums[name] += np.array([mask.sum(), motion[mask].sum()])

    def _add_sums(self, rows: Rows, steps: Steps, begin: int, end: int) -> None:
        """Sums over windows of 0.1 s: motion, integrated velocity, and their products; range of the efforts."""
        sums = self._sums
        change = np.where(steps.bad | steps.false_speeds, np.nan, steps.change - steps.wrapped)
        change[1:][steps.false_speeds[:-1]] = np.nan
        width = max(4, round(0.1 / self._period)) if self._period > 0.0 else 4
        edges = np.arange(begin, end, min(width, max((end - begin) // 4, 1)))
        if len(edges) < 2:
            return

        def windows(values: NDArray[np.float64]) -> NDArray[np.float64]:
            return np.add.reduceat(values[: edges[-1]], edges[:-1], axis=0)

        motion = windows(change)
        whole = np.isfinite(motion)
        motion = np.where(whole, motion, 0.0)
        sums["windows"] += whole.sum(axis=0)
        sums["motion"] += (motion**2).sum(axis=0)
        known = np.nan_to_num(change[begin : end - 1])
        sums["steps"] += (known**2).sum(axis=0)
        sums["smooth"] += (known[1:] * known[:-1]).sum(axis=0)
        if "velocity" in rows.values:
            velocity = rows.values["velocity"]
            integral = (velocity[1:] + velocity[:-1]) / 2.0 * steps.duration[:, None]
            speed = np.where(whole, windows(integral), 0.0)
            sums["speed"] += (speed**2).sum(axis=0)
            sums["product"] += motion.T @ speed
        if "effort" in rows.values:
            effort = rows.values["effort"][begin : end - 1]
            sums["least"] = np.fmin(sums.get("least", np.inf), np.nan_to_num(effort, nan=np.inf).min(axis=0))
            sums["most"] = np.fmax(sums.get("most", -np.inf), np.nan_to_num(effort, nan=-np.inf).max(axis=0))

    def findings(self) -> Iterator[Finding]:
        """The findings, by kind."""
        velocities = list(self._of_velocities())
        for name in (name for finding in velocities for name in finding.joints):
            self._places["speed"].counts.pop(self._names.index(name), None)
        yield from (*self._of_timestamps(), *self._of_places(), *velocities, *self._of_efforts(), *self._of_copies())

    def _finding(self, kind: str, text: str, joints: Iterable[int] | None = None) -> Finding:
        return Finding(kind, text, self._names if joints is None else tuple(self._names[int(i)] for i in joints))

    def _of_timestamps(self) -> Iterator[Finding]:
        row = self._row_name
        if not self._has_time:
            yield self._finding(
                "timestamps",
                f"timestamps: the usual time between {row}s is {self._period:.4g} s, which no robot's log has: they "
                f"are probably in another unit; name it (stamp_unit in a map), or {_PERIOD}",
            )
            return
        clock = self._places["clock"]
        if clock.counts:
            yield self._finding(
                "timestamps",
                f"timestamps jump by {clock.largest[0]:.4g} s {self._at(clock)} while the joints move on as from one "
                f"row to the next: the clock was set, or rows are from two recordings; {_PERIOD}, or cut "
                f"(convert --start, --stop)",
            )
        (short, near), (long, far) = self._sums["short"], self._sums["long"]
        # After a gap, the joints have moved farther than within a burst.
        if short >= 10 and short > 0.02 * self._count and near > 0.0 and far / long < 3.0 * near / short:
            yield self._finding(
                "timestamps",
                f"timestamps come in bursts: {short:.0f} of {self._count} {row}s follow the one before within a fifth "
                f"of the mean time, as if they were taken when messages arrived in batches; use the header's, or "
                f"{_PERIOD}",
            )

    def _of_places(self) -> Iterator[Finding]:
        jump = self._places["jump"]
        again = jump.counts.total() > 2 and 1.0 < jump.largest[0] < 1.2 * jump.smallest
        wrap = "if an encoder begins again there, unwrap it (--unwrap {size:.3g}); " if again else ""
        option = "" if np.isclose(self._places["wrap"].largest[0], TURN) else " {size:.6g}"
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
        for kind, text in texts.items():
            events = self._places[kind]
            if events.counts:
                size, step = events.largest
                joints = self._some(sorted(events.counts, key=lambda column: column != events.first[2]))
                share = 100.0 * events.counts.total() / (len(events.counts) * self._count)
                filled = text.format(
                    joints=joints, at=self._at(events), size=size, step=step, speed=size / step, share=share
                )
                yield self._finding(_KINDS.get(kind, kind), filled, events.counts)

    def _of_velocities(self) -> Iterator[Finding]:
        sums = self._sums
        if "speed" not in sums:
            return
        motion, speed = self._rms("motion"), self._rms("speed")
        correlation = sums["product"] / np.sqrt(np.outer(sums["motion"], sums["speed"]))
        own = np.diag(correlation)
        groups: dict[str, list[int]] = {}
        factors: dict[str, list[float]] = {}
        swapped = ""
        known = (sums["windows"] >= 8) & (motion >= _MIN_MOTION)
        known[list(self._places["impossible"].counts)] = False
        for i in np.flatnonzero(known):
            factor = speed[i] / motion[i]
            sampled = sums["smooth"][i] > 0.5 * sums["steps"][i]
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
                problem = f"do not fit their positions, and those of other joints do ({swapped}): swapped or copied"
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
        if "least" not in self._sums:
            return
        least, most = self._sums["least"], self._sums["most"]
        constant = np.flatnonzero((self._rms("motion") > _MIN_MOTION) & (least == most))
        size = np.fmax(most, -least)
        large = np.flatnonzero(size > _MAX_TORQUE)
        if len(constant):
            problem = (
                f"are {least[constant[0]] + 0.0:.4g} in every {self._row_name} while the joints move, so they were not "
                f"measured; "
            )
            yield self._effort(constant, problem)
        if len(large):
            problem = (
                f"reach {size.max():.4g}, which are no N m of a leg; give their factor (effort_scale in a map), or "
            )
            yield self._effort(large, problem)

    def _effort(self, joints: NDArray[np.intp], problem: str) -> Finding:
        text = f"efforts of {self._some(joints)} {problem}leave them out (--ignore effort)"
        return self._finding("effort", text, joints)

    def _of_copies(self) -> Iterator[Finding]:
        moving = [i for i, size in enumerate(self._rms("motion")) if size >= _MIN_MOTION]
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

    def _rms(self, name: str) -> NDArray[np.float64]:
        """Root mean square of the windows' sums (J,)."""
        return np.sqrt(self._sums[name] / np.maximum(self._sums["windows"], 1))

    def _at(self, events: _Events) -> str:
        place, count = f"at {events.first[1]:.3f} s ({self._row_name} {events.first[0]})", events.counts.total()
        return place if count == 1 else f"first {place}, {count} times"

    def _some(self, columns: Iterable[int]) -> str:
        """Names of a few joints, and how many more there are."""
        names = [self._names[int(i)] for i in columns]
        return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
