"""Calculations on rows over time: interpolation, even timestamps, filtered derivatives, gaps."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.arrays import Floats

_DEGREE: Final = 2
"""Degree of the polynomial that `derivative` fits."""
_ROWS_PER_FIT: Final = 65536


def interpolate(stamps: Floats, values: Floats, times: Floats) -> Floats:
    """Return the linear interpolation, constant before the first row and after the last.

    At the time of a row the result is bit-identical to the values of the row.

    Args:
        stamps: increasing times of the rows (T,).
        values: of the rows (T, J).
        times: to interpolate at (...), in the unit of `stamps`.

    Returns:
        Values (..., J).
    """
    times = times.clip(stamps[0], stamps[-1])
    before = np.searchsorted(stamps, times, side="right") - 1
    after = np.minimum(before + 1, len(stamps) - 1)
    fraction = ((times - stamps[before]) / np.maximum(stamps[after] - stamps[before], 1.0))[..., None]
    # At the time of a row, the next row has no influence, even if it is NaN.
    return np.where(fraction == 0.0, values[before], values[before] + fraction * (values[after] - values[before]))


def nanoseconds_of(seconds: Floats, last: float) -> Floats:
    """Return times (...,) in s as ns, within a recording from 0 to `last` ns.

    In floating point, k times a period in s is rarely a whole number of ns, but is meant to be: such times are rounded.
    """
    times = (seconds * NS_PER_SECOND).clip(0.0, last)
    whole = np.rint(times)
    return np.where(np.abs(times - whole) <= 1e-15 * whole, whole, times)


def even_stamps(stamps: NDArray[np.int64], rate: float) -> NDArray[np.int64]:
    """Return timestamps in ns at a rate in Hz, from the first of increasing timestamps (T,) on and up to the last."""
    count = int(float(stamps[-1] - stamps[0]) * rate / NS_PER_SECOND + 1e-6) + 1
    nanoseconds = np.rint(np.arange(count) * (NS_PER_SECOND / rate)).astype(np.int64)
    return np.minimum(stamps[0] + nanoseconds, stamps[-1])


def derivative(seconds: Floats, values: Floats, window: float) -> Floats:
    """Return the rate of change, filtered without delay; exact for parabolas.

    A parabola is fitted by least squares to the rows of a window around each row, and its slope taken at the row; near
    an end the window stops at the end. A window has the same odd number of rows everywhere, three or more: as many as
    fit at the median spacing. On evenly spaced rows this is the filter of Savitzky and Golay (1964),
    https://doi.org/10.1021/ac60214a047; here rows may be spaced unevenly.

    Args:
        seconds: increasing times (T,), two or more.
        values: (T, J).
        window: length of the window, s.

    Returns:
        Rates of change (T, J).
    """
    count = len(seconds)
    rows = min(max(3, 2 * round(window / (2.0 * float(np.median(np.diff(seconds))))) + 1), count)
    degree = min(_DEGREE, rows - 1)
    result = np.empty_like(values)
    starts = np.clip(np.arange(count) - rows // 2, 0, count - rows)
    windows = sliding_window_view(seconds, rows)
    neighbours = sliding_window_view(values, rows, axis=0)
    for first in range(0, count, _ROWS_PER_FIT):
        part = slice(first, first + _ROWS_PER_FIT)
        offsets = windows[starts[part]] - seconds[part, None]
        # In units of the window's own length, so that all powers have the same magnitude.
        length = np.ptp(offsets, axis=1, keepdims=True)
        powers = (offsets / length)[..., None] ** np.arange(degree + 1)
        slope = np.linalg.pinv(powers)[:, 1, :] / length
        result[part] = np.einsum("tr,tjr->tj", slope, neighbours[starts[part]])
    return result


@dataclass(frozen=True)
class Gap:
    """A time without rows."""

    row: int
    """The last row before the gap"""
    start: float
    """Time of the last row before the gap, from the first timestamp, s"""
    seconds: float
    """Duration of the gap, s"""


def find_gaps(stamps: NDArray[np.int64], factor: float = 3.0) -> tuple[Gap, ...]:
    """Return the gaps between increasing timestamps (T,) in ns: steps longer than `factor` times the median step."""
    steps = np.diff(stamps)
    if not len(steps):
        return ()
    return tuple(
        Gap(int(i), float(stamps[i] - stamps[0]) / NS_PER_SECOND, float(steps[i]) / NS_PER_SECOND)
        for i in np.flatnonzero(steps > factor * np.median(steps))
    )
