"""From a file of any known format to validated rows, in rad and on the joints of this robot."""

from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.formats import recognition
from quadruped_env.trajectory.plausibility import TURN, Plausibility
from quadruped_env.trajectory.read_options import ReadOptions
from quadruped_env.trajectory.row_conversion import from_degrees, retarget
from quadruped_env.trajectory.rows import TORQUE_ONLY, Rows, joined
from quadruped_env.trajectory.steps import Steps
from quadruped_env.trajectory.validation import Source, check_finite, invalid, not_increasing, read_only, validate
from quadruped_env.utils.progress import Progress

MAX_PLAUSIBLE: Final = 4.0 * np.pi
"""Two turns, rad. No joint of a leg reaches it, and a log in degrees nearly always does."""

_DEFAULTS: Final = ReadOptions()


class Stream:
    """Iterates over a recording in pieces: memory does not grow with its length, unless it is to be sorted.

    Rows are validated and converted as the options say. Timestamps increase, also from piece to piece.

    Args:
        path: of the file or bag.
        options: for reading it.
        progress: called with the fraction read.

    Raises:
        QuadrupedError: while it is read, if the file is missing or something in it is wrong.
        MissingExtraError: while it is read, if the format needs libraries that are not installed.
    """

    def __init__(self, path: str | Path, options: ReadOptions = _DEFAULTS, progress: Progress | None = None) -> None:
        self.reading = Reading(Path(path), options, progress)
        """State of the file; its remarks are complete once the last piece was read."""
        self._first: int | None = None
        """Number of the first row in the file"""
        self.without_efforts = False
        """True if efforts were recorded and all of them are NaN; known once the last piece was read"""

    @property
    def source(self) -> Source:
        """The source of all rows. Complete once the last piece was read."""
        reading = self.reading
        source = Source(reading.name, "kept row", 0, notes=reading.remarks())
        if self._first is None or reading.left_out or reading.options.sort:
            return source
        return replace(source, row_name=reading.row_name, first_row=self._first)

    def __iter__(self) -> Iterator[Rows]:
        reading = self.reading
        with ExitStack() as stack:
            pieces = recognition.read(reading, stack)
            if reading.options.sort:
                pieces = _sorted(pieces)
            if reading.options.period is not None:
                pieces = _evenly_spaced(pieces, reading.options.period)
            joint_map = reading.options.joint_map
            periods = (TURN,) if joint_map is None else joint_map.periods
            pieces = (_converted(rows, reading) for rows in _validated(pieces, reading))
            if reading.options.despike or reading.options.unwrap:
                pieces = _repaired(pieces, reading)
            check = Plausibility(periods)
            for rows in check.watch(pieces):
                efforts = rows.values.get("effort")
                unknown = efforts is not None and bool(np.isnan(efforts).all())
                if self._first is None:
                    self._first, self.without_efforts = int(rows.numbers[0]), unknown
                self.without_efforts &= unknown
                yield rows
            if self.without_efforts:
                reading.note(f"efforts are NaN in every {reading.row_name}: they were not recorded")
            for finding in check.findings(reading.row_name):
                reading.note(finding.text)
        if self._first is None:
            raise reading.error(None, f"no row is left; {'; '.join(reading.remarks()) or 'record again'}")
        reading.report_progress(1.0)

    def collect(self) -> Rows:
        """All rows, read-only: trajectories share such arrays instead of copying them."""
        rows = joined(self)
        if self.without_efforts:
            rows = rows.without(["effort"])
        for array in (rows.stamps, *rows.values.values()):
            read_only(array)
        return rows


def _sorted(pieces: Iterator[Rows]) -> Iterator[Rows]:
    """All rows in the order of their timestamps; rows with equal timestamps stay in the order of the file."""
    for rows in _together(pieces):
        yield rows.take(np.argsort(rows.stamps, kind="stable"))


def _together(pieces: Iterator[Rows]) -> Iterator[Rows]:
    """All rows in one piece, or nothing."""
    first = next(pieces, None)
    if first is not None:
        yield joined(chain([first], pieces))


def _evenly_spaced(pieces: Iterator[Rows], period: float) -> Iterator[Rows]:
    """The rows, this time in s apart, from the timestamp of the first one on."""
    start, count = None, 0
    for piece in pieces:
        start = max(int(piece.stamps[0]), 0) if start is None else start
        times = np.rint(np.arange(count, count + len(piece)) * (period * NS_PER_SECOND)).astype(np.int64)
        count += len(piece)
        yield replace(piece, stamps=start + times)


def _repaired(pieces: Iterator[Rows], reading: Reading) -> Iterator[Rows]:
    """All rows without spikes and without wraps, as the options say."""
    options = reading.options
    for rows in _together(pieces):
        if options.despike and len(rows) > 2:
            bad = Steps(rows, (options.unwrap or TURN,)).spikes.any(axis=1)
            reading.leave_out("a joint is elsewhere for a few rows", int(bad.sum()))
            rows = rows.take(~bad)  # noqa: PLW2901
        position = rows.values["position"]
        if options.unwrap:
            whole = np.rint(np.diff(position, axis=0) / options.unwrap)
            reading.count(f"steps of about {options.unwrap:.4g} rad, undone", int(np.count_nonzero(whole)))
            position = np.concatenate([position[:1], position[1:] - options.unwrap * np.cumsum(whole, axis=0)])
        yield replace(rows, values=rows.values | {"position": position})


def _validated(pieces: Iterator[Rows], reading: Reading) -> Iterator[Rows]:
    """The rows, validated, or without the invalid ones if the options ask to drop them."""
    last: int | None = None
    for piece in pieces:
        found = piece.without(reading.options.ignore)
        torque_only = _torque_only(found)
        if reading.options.drop:
            found = _without_bad_rows(found, torque_only, last, reading)
        elif torque_only.any():
            row = int(found.numbers[torque_only.argmax()])
            raise reading.error(row, f"{TORQUE_ONLY}, or leave such {reading.row_name}s out (--drop)")
        if not len(found):
            continue
        source = reading.source(found.numbers)
        if last is not None and found.stamps[0] <= last:
            raise not_increasing(source, 0, int(found.stamps[0]), last)
        validate(found, source)
        last = int(found.stamps[-1])
        yield found


def _without_bad_rows(rows: Rows, torque_only: NDArray[np.bool_], last: int | None, reading: Reading) -> Rows:
    """The rows with known positions and velocities, and with timestamps that increase from `last` on."""
    reading.leave_out(TORQUE_ONLY, int(torque_only.sum()))
    rows = rows.take(~torque_only)
    valid = rows.stamps >= 0
    for kind, values in rows.values.items():
        valid &= ~invalid(kind, values).any(axis=1)
    reading.leave_out("a number is not finite, or a timestamp is negative", int((~valid).sum()))
    rows = rows.take(valid)
    latest = np.maximum.accumulate(np.concatenate([[-1 if last is None else last], rows.stamps]))[:-1]
    later = rows.stamps > latest
    reading.leave_out("the timestamp is not later than those before", int((~later).sum()))
    return rows.take(later)


def _torque_only(rows: Rows) -> NDArray[np.bool_]:
    """Mask (n,) of the rows with efforts and without any position."""
    efforts = rows.values.get("effort")
    if efforts is None:
        return np.zeros(len(rows), dtype=np.bool_)
    return np.logical_and(
        np.isnan(rows.values["position"]).all(axis=1), np.isfinite(efforts).any(axis=1), dtype=np.bool_
    )


def _converted(rows: Rows, reading: Reading) -> Rows:
    """The rows in rad, on the joints of the map if there is one.

    Raises:
        QuadrupedError: if a converted value is not finite, or if the positions look like degrees and the options do not
            say what they are.
    """
    options, source = reading.options, reading.source(rows.numbers)
    if options.degrees:
        rows = from_degrees(rows)
    if options.joint_map is not None:
        rows = retarget(rows, options.joint_map, source.name)
        for kind, values in rows.values.items():
            check_finite(kind, values, rows.names, source)
    if options.degrees is None:
        positions = rows.values["position"]
        size = np.abs(positions)
        if size.max() > MAX_PLAUSIBLE:
            row, column = np.argwhere(size > MAX_PLAUSIBLE)[0]
            value = positions[row, column]
            mark = f"; if it marks a missing value, add it to the map (missing = {value:g})" if options.columns else ""
            raise QuadrupedError(
                f"{source.row(row)}, position.{rows.names[column]}: "
                f"{value:g} rad is more than two turns: these may be degrees. Say so (--degrees, or unit = "
                f'"deg" in a map) to have them converted, or that they are rad (--radians); turns and counts of an '
                f'encoder have the unit "turn" or "ticks" in a map{mark}'
            )
    return rows
