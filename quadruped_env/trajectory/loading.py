"""From a file of any known format to validated rows, in rad and on the joints of this robot."""

from contextlib import ExitStack
from dataclasses import replace
from typing import Final

import numpy as np

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.formats import recognition
from quadruped_env.trajectory.joint_map import JointMap
from quadruped_env.trajectory.plausibility import TURN, findings
from quadruped_env.trajectory.reading import Reading
from quadruped_env.trajectory.rows import TORQUE_ONLY, Rows, Source, invalid, validate
from quadruped_env.trajectory.steps import Steps
from quadruped_env.utils.arrays import Bools

MAX_PLAUSIBLE: Final = 4.0 * np.pi
"""Two turns, rad. No joint of a leg reaches it, and a log in degrees nearly always does."""


def read(reading: Reading) -> tuple[Rows, Source]:
    """Return the rows of a recording, validated and converted as the options say, and their origin with all remarks.

    Raises:
        QuadrupedError: if the file is missing or something in it is wrong.
        MissingExtraError: if the format needs libraries that are not installed.
    """
    with ExitStack() as stack:
        rows = recognition.read(reading, stack)
    options = reading.options
    if rows is not None:
        rows = replace(rows, values={kind: array for kind, array in rows.values.items() if kind not in options.ignore})
        if reading.repairs("sort"):
            rows = rows.take(np.argsort(rows.stamps, kind="stable"))
        if options.period is not None:
            times = np.rint(np.arange(len(rows)) * (options.period * NS_PER_SECOND)).astype(np.int64)
            rows = replace(rows, stamps=max(int(rows.stamps[0]), 0) + times)
        rows = _usable(rows, reading)
    if rows is None or not len(rows):
        raise reading.error(None, f"no row is left; {'; '.join(reading.remarks()) or 'record again'}")
    validate(rows, Source(reading.name, reading.row_name, rows.numbers))
    rows = _repaired(_converted(rows, reading), reading)
    efforts = rows.values.get("effort")
    if efforts is not None and np.isnan(efforts).all():
        reading.note(f"efforts are NaN in every {reading.row_name}: they were not recorded")
        del rows.values["effort"]
    periods = options.joint_map.periods if isinstance(options.joint_map, JointMap) else (TURN,)
    for finding in findings(rows, reading.row_name, periods):
        reading.note(finding.text)
    reading.report_progress(1.0)
    return rows, Source(reading.name, reading.row_name, rows.numbers, reading.remarks())


def _usable(rows: Rows, reading: Reading) -> Rows:
    """Return the rows, or without those that cannot be used if the options ask to drop them.

    Raises:
        QuadrupedError: if a row has efforts and no position, and is not to be dropped.
    """
    position, effort = rows.values["position"], rows.values.get("effort")
    known = np.zeros(len(rows), np.bool_) if effort is None else np.isfinite(effort).any(axis=1)
    torque_only: Bools = np.logical_and(np.isnan(position).all(axis=1), known, dtype=np.bool_)
    if not reading.repairs("drop"):
        if torque_only.any():
            row = int(rows.numbers[torque_only.argmax()])
            raise reading.error(row, f"{TORQUE_ONLY}, or leave such {reading.row_name}s out (--repair drop)")
        return rows

    def kept(keep: Bools, reason: str) -> Rows:
        reading.left_out[reason] += int((~keep).sum())
        return rows.take(keep)

    rows = kept(~torque_only, TORQUE_ONLY)
    valid = rows.stamps >= 0
    for kind, values in rows.values.items():
        valid &= ~invalid(kind, values).any(axis=1)
    rows = kept(valid, "a number is not finite, or a timestamp is negative")
    latest = np.maximum.accumulate(np.concatenate([[-1], rows.stamps]))[:-1]
    return kept(rows.stamps > latest, "the timestamp is not later than those before")


def _converted(rows: Rows, reading: Reading) -> Rows:
    """Return the rows in rad, on the joints of the map if there is one.

    Raises:
        QuadrupedError: if the recording lacks a source of the map, or if the positions look like degrees and the
            options do not say what they are.
    """
    options = reading.options
    if options.unit == "deg":
        values = {kind: array if kind == "effort" else np.radians(array) for kind, array in rows.values.items()}
        rows = replace(rows, values=values)
    if isinstance(options.joint_map, JointMap):
        rows = options.joint_map.retarget(rows, reading.name)
    beyond = np.argwhere(np.abs(rows.values["position"]) > MAX_PLAUSIBLE)
    if options.unit is None and len(beyond):
        row, column = beyond[0]
        value = rows.values["position"][row, column]
        mark = f"; if it marks a missing value, add it to the map (missing = {value:g})" if options.columns else ""
        raise reading.error(
            None,
            f"{reading.row_name} {rows.numbers[row]}, position.{rows.names[column]}: {value:g} rad is more than two "
            f'turns: these may be degrees. Say so (--unit deg, or unit = "deg" in a map) to have them converted, or '
            f'that they are rad (--unit rad); turns and counts of an encoder have the unit "turn" or "ticks" in a '
            f"map{mark}",
        )
    return rows


def _repaired(rows: Rows, reading: Reading) -> Rows:
    """Return the rows without spikes and without wraps, as the options say."""
    period = reading.options.unwrap
    if reading.repairs("despike") and len(rows) > 2:
        bad = Steps(rows, (period or TURN,)).spikes.any(axis=1)
        reading.left_out["a joint is elsewhere for a few rows"] += int(bad.sum())
        rows = rows.take(~bad)
    if period:
        position = rows.values["position"]
        whole = np.rint(np.diff(position, axis=0) / period)
        reading.counted[f"steps of about {period:.4g} rad, undone"] += int(np.count_nonzero(whole))
        position = np.concatenate([position[:1], position[1:] - period * np.cumsum(whole, axis=0)])
        rows = replace(rows, values=rows.values | {"position": position})
    return rows
