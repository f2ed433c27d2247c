"""Plausibility of recordings: positions, velocities, efforts and timestamps against each other.

A finding says what cannot be, where, how much, and which option repairs it. Nothing is changed here. The bounds are far
from what legs do, so that a motion is never called impossible: real logs reach 25 rad/s.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.rows import Rows, joined
from quadruped_env.trajectory.steps import MAX_AWAY, Steps, clock_jumps, frozen, within_reach

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
_MIN_DEAD: Final = 0.3
"""Time in which a position does not change and its velocity is not 0 from which on it is reported, s."""
_MAX_DELAY: Final = 0.1
"""Largest delay of velocities that is looked for, s."""
_COARSE: Final = 0.005
"""Resolution from which on it is reported, rad."""
_MAX_TORQUE: Final = 500.0
"""N m; no leg that fits this package has more."""
_FACTORS: Final = (
    (180.0 / np.pi, "velocities in degrees/s"),
    (np.pi / 180.0, "positions in degrees and velocities in rad/s"),
    (30.0 / np.pi, "velocities in rpm"),
    (1.0 / 6.0, "velocities in rpm, positions in degrees"),
    (1.0 / TURN, "velocities in turns/s"),
    (10.0, "timestamps in another unit, by 10"),
    (0.1, "timestamps in another unit, by 10"),
    (TURN, "positions in turns"),
    (1e3, "timestamps in another unit, by 1000"),
    (1e-3, "timestamps in another unit, by 1000, or velocities in 1/ms"),
    (1e6, "timestamps in another unit, by 1e6"),
    (1e-6, "timestamps in another unit, by 1e6"),
)
"""Velocity over rate of change of the position, and its usual cause."""
_IGNORE_VELOCITY: Final = "leave them out (--ignore velocity), or compute them (convert --differentiate)"


@dataclass(frozen=True)
class Finding:
    """Something in a recording that cannot be."""

    kind: str
    """`timestamps`, `wrap`, `spike`, `jump`, `frozen`, `speed`, `velocity`, `effort`, `copy`, `repeats` or
    `resolution`"""
    text: str
    """Description with place, magnitude and repair"""
    joints: tuple[str, ...]
    """Joints concerned; all of them if the timestamps are"""

    @property
    def spoils(self) -> bool:
        """True if a fit to the recording would be wrong."""
        return self.kind not in {"repeats", "resolution"}


@dataclass
class _Events:
    """Places at which one kind of thing happens."""

    counts: Counter[int] = field(default_factory=Counter)
    """Column -> number of places"""
    first: tuple[int, float, int] | None = None
    """Number of the row in the file, time in s, column"""
    largest: tuple[float, float] = (0.0, 0.0)
    """Magnitude of the largest one, and the time over which it happens, s"""
    smallest: float = np.inf

    def add(self, rows: Any, columns: Any, sizes: Any, steps: Any, numbers: Any, times: Any) -> None:
        """Add places: their rows and columns, magnitudes and durations."""
        for i, column, size, step in zip(rows, columns, sizes, steps, strict=True):
            self.counts[int(column)] += 1
            place = int(numbers[i]), float(times[i]), int(column)
            if self.first is None or place[1] < self.first[1]:
                self.first = place
            self.largest = max(self.largest, (float(size), float(step)))
            self.smallest = min(self.smallest, float(size))

    @property
    def total(self) -> int:
        """Number of places."""
        return sum(self.counts.values())


def findings(rows: Rows, row_name: str = "row", periods: Sequence[float] = (TURN,)) -> tuple[Finding, ...]:
    """The findings in rows that are all in memory."""
    check = Plausibility(periods)
    for _ in check.watch([rows]):
        pass
    return check.findings(row_name)


def spikes(rows: Rows, periods: Sequence[float] = (TURN,)) -> NDArray[np.bool_]:
    """Mask (n, J) of positions that are elsewhere for a few rows, of two rows or more."""
    return Steps(rows, periods).spikes


class Plausibility:
    """Collects what is implausible in the pieces of a recording; memory does not grow with its length.

    Args:
        periods: angles after which an encoder may begin again, rad.
    """

    def __init__(self, periods: Sequence[float] = (TURN,)) -> None:
        self._row_name = "row"
        self._periods = tuple(periods)
        self._names: tuple[str, ...] = ()
        self._kinds: tuple[str, ...] = ()
        self._first_stamp = 0
        self._period = 0.0
        self._count = 0
        self._places = {name: _Events() for name in ("wrap", "spike", "jump", "speed", "frozen", "clock")}
        self._wrapped: Counter[float] = Counter()
        self._short, self._long = np.zeros(3), np.zeros(3)
        """Number, durations and motions of the steps that are far shorter than the mean, and of the others"""
        self._moving = self._repeated = 0
        self._sums: dict[str, Any] = {}
        self._values: list[NDArray[np.float64]] = []
        """Different positions of each joint, up to a number"""
        self._equal: dict[tuple[str, str], bool] = {}
        """Pair of kinds or of joints -> whether their numbers are equal in all rows"""

    def watch(self, pieces: Iterable[Rows]) -> Iterator[Rows]:
        """The same pieces, each checked after it was used."""
        buffer: Rows | None = None
        begin = 0
        for piece in pieces:
            yield piece
            for start in range(0, len(piece), _BLOCK):
                part = piece.take(np.s_[start : start + _BLOCK])
                buffer = part if buffer is None else joined([buffer, part])
                if len(buffer) >= _BLOCK:
                    end = len(buffer) - _MARGIN
                    self._add(buffer, begin, end)
                    buffer, begin = buffer.take(np.s_[end - _MARGIN :]), _MARGIN
        if buffer is not None:
            self._add(buffer, begin, len(buffer))

    def _add(self, rows: Rows, begin: int, end: int) -> None:
        """Check the rows from `begin` on and before `end`; the others are their context."""
        if not self._names:
            self._names, self._kinds = rows.names, tuple(rows.values)
            self._first_stamp = int(rows.stamps[0])
            self._period = float(np.median(np.diff(rows.stamps))) / NS_PER_SECOND if len(rows) > 1 else 0.0
            self._values = [np.empty(0)] * len(rows.names)
        self._count += end - begin
        if len(rows) < _MIN_ROWS:
            return
        with np.errstate(all="ignore"):
            steps = Steps(rows, self._periods)
            if _PERIODS[0] <= self._period <= _PERIODS[1]:
                self._add_places(rows, steps, begin, end)
            self._add_sums(rows, steps, begin, end)
            self._add_values(rows, begin, end)

    def _add_places(self, rows: Rows, steps: Steps, begin: int, end: int) -> None:
        times = (rows.stamps - self._first_stamp) / NS_PER_SECOND

        def add(name: str, mask: NDArray[np.bool_], sizes: NDArray[np.float64], after: int) -> None:
            found, columns = np.nonzero(mask)
            inside = (found + after >= begin) & (found + after < end)
            found, columns = found[inside], columns[inside]
            self._places[name].add(
                found + after, columns, sizes[found, columns], steps.time[found], rows.numbers, times
            )

        size = np.abs(steps.change)
        add("wrap", steps.wrapped != 0.0, np.abs(steps.wrapped), 1)
        for period in np.unique(np.abs(steps.wrapped[steps.wrapped != 0.0])):
            self._wrapped[float(period)] += 1
        add("spike", steps.away, size, 1)
        add("jump", steps.jumps, size, 1)
        add("frozen", *frozen(rows, steps), 0)
        if "velocity" in rows.values:
            add("speed", steps.false_speeds, np.abs(rows.values["velocity"])[:-1], 0)
        add("clock", *clock_jumps(steps), 0)
        inside = slice(max(begin - 1, 0), end - 1)
        duration, motion = steps.duration[inside], size[inside].max(axis=1, initial=0.0)
        short = duration < 0.2 * np.sort(duration)[: len(duration) * 99 // 100].mean()
        for total, mask in ((self._short, short), (self._long, ~short)):
            total += [mask.sum(), duration[mask].sum(), motion[mask].sum()]
        repeats = np.logical_and.reduce([(np.diff(array, axis=0) == 0.0).all(axis=1) for array in rows.values.values()])
        moving = within_reach(size.max(axis=1) > 0.01, 10)
        self._moving += int(moving[inside].sum())
        self._repeated += int((moving & repeats)[inside].sum())

    def _add_sums(self, rows: Rows, steps: Steps, begin: int, end: int) -> None:
        """Sums over windows of 0.1 s: motion, integrated velocity, and their products; work of the efforts."""
        add = self._sums

        def plus(name: str, value: Any) -> None:
            add[name] = add.get(name, 0.0) + value

        change = np.where(steps.bad | steps.false_speeds, np.nan, steps.change - steps.wrapped)
        change[1:][steps.false_speeds[:-1]] = np.nan
        inside = slice(begin, end - 1)
        width = max(4, round(0.1 / self._period)) if self._period > 0.0 else 4
        edges = np.arange(begin, end, min(width, max((end - begin) // 4, 1)))
        if len(edges) < 2:
            return
        motion = np.add.reduceat(change[: edges[-1]], edges[:-1], axis=0)
        whole = np.isfinite(motion)
        plus("windows", whole.sum(axis=0))
        motion = np.where(whole, motion, 0.0)
        plus("motion", (motion**2).sum(axis=0))
        known = np.nan_to_num(change)
        plus("steps", (known[inside] ** 2).sum(axis=0))
        plus("smooth", (known[inside][1:] * known[inside][:-1]).sum(axis=0))
        if "velocity" in rows.values:
            velocity = rows.values["velocity"]
            integral = (velocity[1:] + velocity[:-1]) / 2.0 * steps.duration[:, None]
            speed = np.where(whole, np.add.reduceat(integral[: edges[-1]], edges[:-1], axis=0), 0.0)
            plus("speed", (speed**2).sum(axis=0))
            plus("product", motion.T @ speed)
            path = np.add.reduceat(np.abs(integral[: edges[-1]]), edges[:-1], axis=0)
            still = np.add.reduceat(np.abs(change[: edges[-1]]), edges[:-1], axis=0) == 0.0
            lengths = np.add.reduceat(steps.duration[: edges[-1]], edges[:-1])[:, None]
            plus("dead", np.where(still & (path > 0.05), lengths, 0.0).sum(axis=0))
            for shift in range(1, min(_MARGIN, int(_MAX_DELAY / max(self._period, 1e-3))) + 1):
                late = np.add.reduceat(np.roll(integral, -shift, axis=0)[: edges[-1]], edges[:-1], axis=0)
                plus(f"late {shift}", np.where(whole, motion * late, 0.0).sum(axis=0))
        if "effort" in rows.values:
            effort = rows.values["effort"][:-1][inside]
            add["least"] = np.fmin(add.get("least", np.inf), np.nan_to_num(effort, nan=np.inf).min(axis=0))
            add["most"] = np.fmax(add.get("most", -np.inf), np.nan_to_num(effort, nan=-np.inf).max(axis=0))

    def _add_values(self, rows: Rows, begin: int, end: int) -> None:
        """Different values of each joint, and whether kinds or joints have the same numbers."""
        part = rows.take(np.s_[begin:end])
        position = part.values["position"]
        for i, values in enumerate(self._values):
            if len(values) < _BLOCK:
                self._values[i] = np.union1d(values, position[:, i])
        pairs = {(a, b): (part.values[a], part.values[b]) for a in part.values for b in part.values if a < b}
        if "effort" in part.values:
            columns = dict(zip(self._names, position.T, strict=True))
            pairs |= {(a, b): (columns[a], columns[b]) for a in columns for b in columns if a < b}
        for pair, (one, other) in pairs.items():
            if self._equal.get(pair, True):
                self._equal[pair] = bool(np.array_equal(one, other))

    def findings(self, row_name: str) -> tuple[Finding, ...]:
        """The findings in everything that was watched, those that spoil a fit first; `row_name` is a row in words."""
        self._row_name = row_name
        if self._count < _MIN_ROWS:
            return ()
        with np.errstate(all="ignore"):
            velocities = list(self._of_velocities())
            for name in (name for finding in velocities for name in finding.joints):
                self._places["speed"].counts.pop(self._names.index(name), None)
            found = [*self._of_timestamps(), *self._of_places(), *velocities, *self._of_efforts()]
            found += [*self._of_dead_positions(), *self._of_copies(), *self._of_resolution()]
        return tuple(sorted(found, key=lambda one: not one.spoils))

    def _of_timestamps(self) -> Iterator[Finding]:
        if not _PERIODS[0] <= self._period <= _PERIODS[1]:
            yield Finding(
                "timestamps",
                f"timestamps: the usual time between {self._row_name}s is {_time(self._period)}, which no robot's log "
                f"has: they are probably in another unit; name it (stamp_unit in a map), or give the time from row to "
                f"row in s (--stamps 0.01)",
                self._names,
            )
        clock = self._places["clock"]
        if clock.first is not None:
            yield Finding(
                "timestamps",
                f"timestamps jump by {_time(clock.largest[1])} {self._at(clock)} while the joints move on as from one "
                f"row to the next: the clock was set, or rows are from two recordings; give the time from row to row "
                f"in s (--stamps {self._period:.4g}), or cut (convert --start, --stop)",
                self._names,
            )
        (short, _, near), (long, _, far) = self._short, self._long
        # After a gap, the joints have moved farther than within a burst.
        if short >= 10 and short > 0.02 * self._count and near > 0.0 and far / long < 3.0 * near / short:
            yield Finding(
                "timestamps",
                f"timestamps come in bursts: {short:.0f} of {self._count} {self._row_name}s follow the one before "
                f"within a fifth of the mean time, as if they were taken when messages arrived in batches; use the "
                f"header's, or give the time from row to row in s (--stamps)",
                self._names,
            )
        if self._repeated >= 10 and self._repeated > 0.1 * self._moving:
            rate = (1.0 - self._repeated / self._moving) / self._period
            yield Finding(
                "repeats",
                f"{self._repeated} of the {self._moving} {self._row_name}s in motion repeat the one before in every "
                f"number: the joints have new values at about {rate:.3g} Hz only; differentiate over a longer time "
                f"(convert --differentiate 0.1)",
                self._names,
            )

    def _of_places(self) -> Iterator[Finding]:
        places = self._places
        if places["wrap"].first is not None:
            period = max(self._wrapped, key=lambda one: self._wrapped[one])
            option = "--unwrap" if np.isclose(period, TURN) else f"--unwrap {period:.6g}"
            yield self._finding(
                "wrap",
                f"positions wrap by {period:.4g} rad between two {self._row_name}s in {{joints}}, {{at}}; unwrap them "
                f"({option})",
            )
        if places["spike"].first is not None:
            yield self._finding(
                "spike",
                f"positions jump away and back within {MAX_AWAY} {self._row_name}s, which no joint can do: by "
                "{size:.3g} rad in {step} in {joints}, {at}; leave such rows out (--despike)",
            )
        jump = places["jump"]
        if jump.first is not None:
            again = jump.total > 2 and jump.largest[0] < 1.2 * jump.smallest and jump.largest[0] > 1.0
            wrap = f"; if an encoder begins again there, unwrap it (--unwrap {jump.largest[0]:.3g})" if again else ""
            yield self._finding(
                "jump",
                "positions jump faster than a joint can turn, or than its velocity (joint targets may): by {size:.3g} "
                f"rad in {{step}}, {{speed:.0f}} rad/s, in {{joints}}, {{at}}{wrap}; cut there (convert --start, "
                "--stop), leave the joint out, or mark the value as missing in a map (missing, with --drop)",
            )
        if places["frozen"].first is not None:
            yield self._finding(
                "frozen",
                "positions freeze in the middle of the motion (joint targets may): for up to {size:.3g} s in {joints}, "
                "{at}; cut there (convert --start, --stop)",
            )
        if places["speed"].total:
            yield self._finding(
                "speed",
                f"velocities that the positions do not have: up to {{size:.3g}} rad/s in {{joints}}, {{at}}; "
                f"{_IGNORE_VELOCITY}",
            )

    def _of_velocities(self) -> Iterator[Finding]:
        sums = self._sums
        if "speed" not in sums:
            return
        motion, speed = (np.sqrt(sums[name] / np.maximum(sums["windows"], 1)) for name in ("motion", "speed"))
        correlation = sums["product"] / np.sqrt(np.outer(sums["motion"], sums["speed"]))
        own = np.diag(correlation)
        shifted = [sums[name] for name in sums if name.startswith("late")]
        late = np.array([own, *(total / np.sqrt(sums["motion"] * sums["speed"]) for total in shifted)])
        groups: dict[str, list[int]] = {}
        factors: dict[str, list[float]] = {}
        swapped = ""
        for i in np.flatnonzero(sums["windows"] >= 8):
            factor = speed[i] / motion[i]
            if motion[i] < _MIN_MOTION:
                if motion[i] < 0.1 * _MIN_MOTION < _MIN_MOTION < speed[i]:
                    groups.setdefault("say that they move, and the positions do not change", []).append(int(i))
                continue
            sampled = sums["smooth"][i] > 0.5 * sums["steps"][i]
            delay = int(np.nan_to_num(late[:, i]).argmax())
            others = np.where(np.arange(len(own)) == i, -1.0, np.nan_to_num(correlation[i], nan=-1.0))
            best = int(others.argmax())
            if speed[i] == 0.0:
                problem = "are 0 while the positions change, so they were not measured"
            elif own[i] > 0.8 and not (0.6 if sampled else 0.3) < factor < (1.7 if sampled else 3.0):
                known = sorted((abs(np.log(factor / one)), cause) for one, cause in _FACTORS)
                causes = ", or ".join(cause for distance, cause in known if distance < 0.12)
                problem = "are {} times the rate at which the positions change" + f" ({causes}?)" * bool(causes)
                factors.setdefault(problem, []).append(float(factor))
            elif own[i] < -0.8:
                problem = "have the opposite sign of the rate at which the positions change"
            elif own[i] < 0.8 and late[delay, i] > max(0.95, others[best]):
                problem = f"come {_time(delay * self._period)} after the positions, as if filtered"
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
            yield Finding(
                "velocity",
                f"velocities of {self._some(joints)} {problem.format(' to '.join(span))}; {fix}{_IGNORE_VELOCITY}",
                tuple(self._names[i] for i in joints),
            )

    def _of_dead_positions(self) -> Iterator[Finding]:
        sums = self._sums
        if "dead" not in sums or self._places["frozen"].first is not None:
            return
        moving = np.sqrt(sums["motion"] / np.maximum(sums["windows"], 1)) >= _MIN_MOTION
        dead = np.flatnonzero((sums["dead"] > _MIN_DEAD) & moving)
        if len(dead):
            yield Finding(
                "frozen",
                f"positions of {self._some(dead)} do not change for {sums['dead'].max():.3g} s in all, while their "
                f"velocities say that they move; cut there (convert --start, --stop)",
                tuple(self._names[int(i)] for i in dead),
            )

    def _of_efforts(self) -> Iterator[Finding]:
        sums = self._sums
        if "least" not in sums:
            return
        motion = np.sqrt(sums["motion"] / np.maximum(sums["windows"], 1)) > _MIN_MOTION
        constant = np.flatnonzero(motion & (sums["least"] == sums["most"]))
        ignore = "leave them out (--ignore effort)"
        if len(constant):
            value = sums["least"][constant[0]] + 0.0
            yield Finding(
                "effort",
                f"efforts of {self._some(constant)} are {value:.4g} in every {self._row_name} while the joints "
                f"move, so they were not measured; {ignore}",
                tuple(self._names[i] for i in constant),
            )
        size = np.fmax(sums["most"], -sums["least"])
        large = np.flatnonzero(size > _MAX_TORQUE)
        if len(large):
            yield Finding(
                "effort",
                f"efforts of {self._some(large)} reach {size.max():.4g}, which are no N m of a leg; give their factor "
                f"(effort_scale in a map), or {ignore}",
                tuple(self._names[i] for i in large),
            )

    def _of_copies(self) -> Iterator[Finding]:
        moving = {name for name, values in zip(self._names, self._values, strict=True) if len(values) >= _MIN_ROWS}
        for (one, other), equal in self._equal.items():
            if not equal or not moving:
                continue
            if one in self._kinds and other in self._kinds:
                kind = min((one, other), key=lambda kind: kind == "position")
                text = f"{one} and {other} are the same numbers in every {self._row_name}: a column was copied; leave"
                yield Finding("copy", f"{text} one out (--ignore {kind})", self._names)
            elif {one, other} <= moving:
                yield Finding(
                    "copy",
                    f"{one} and {other} have the same positions in every {self._row_name}: of two measured joints one "
                    f"is a copy; leave it out, or map its own column",
                    (one, other),
                )

    def _of_resolution(self) -> Iterator[Finding]:
        coarse: dict[str, list[int]] = {}
        for i, values in enumerate(self._values):
            if not 8 <= len(values) < _BLOCK:
                continue
            multiples = np.diff(values) / (unit := float(np.diff(values).min()))
            if unit > _COARSE and (np.abs(multiples - np.rint(multiples)) < 1e-3).all():
                coarse.setdefault(f"{unit:.3g} rad ({np.degrees(unit):.3g} degrees)", []).append(i)
        for size, joints in coarse.items():
            yield Finding(
                "resolution",
                f"positions of {self._some(joints)} have steps of {size}: velocities differentiated from them are "
                f"coarse, and friction and delay of motors do not show",
                tuple(self._names[i] for i in joints),
            )

    def _finding(self, kind: str, text: str) -> Finding:
        """The finding of a kind of events, whose text names their first place and largest size."""
        events = self._places[kind]
        size, step = events.largest
        place = {"size": size, "step": _time(step), "speed": size / max(step, 1e-9)}
        first = sorted(events.counts, key=lambda column: column != (events.first or (0, 0, 0))[2])
        filled = text.format(joints=self._some(first), at=self._at(events), **place)
        return Finding(kind, filled, tuple(self._names[i] for i in events.counts))

    def _at(self, events: _Events) -> str:
        assert events.first is not None
        place = f"at {events.first[1]:.3f} s ({self._row_name} {events.first[0]})"
        return place if events.total == 1 else f"first {place}, {events.total} times"

    def _some(self, columns: Iterable[int]) -> str:
        """Names of a few joints, and how many more there are."""
        names = [self._names[int(i)] for i in columns]
        return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")


def _time(seconds: float) -> str:
    """A time with the unit in which it is read most easily."""
    for unit, length in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= length:
            return f"{seconds / length:.4g} {unit}"
    return f"{seconds * 1e9:.3g} ns"
