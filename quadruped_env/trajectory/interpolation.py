"""Interpolation between rows, filtered derivatives, and gaps between timestamps."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from quadruped_env.timestamps import NS_PER_SECOND

_DEGREE: Final = 2
"""Degree of the polynomial that `derivative` fits."""
_ROWS_PER_FIT: Final = 65536


def interpolate(
    stamps: NDArray[np.float64], values: NDArray[np.float64], times: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Linear interpolation, constant before the first row and after the last.

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


def derivative(seconds: NDArray[np.float64], values: NDArray[np.float64], rows: int) -> NDArray[np.float64]:
    """Rate of change, filtered without delay; exact for parabolas.

    A parabola is fitted by least squares to each row and its neighbours, `rows` in all, and its slope taken at the row;
    near an end the window stops at the end. On evenly spaced rows this is the filter of Savitzky and Golay (1964),
    https://doi.org/10.1021/ac60214a047; here rows may be spaced unevenly.

    Args:
        seconds: increasing times (T,).
        values: (T, J).
        rows: length of the window.

    Returns:
        Rates of change (T, J).
    """
    count = len(seconds)
    rows = min(rows, count)
    if rows == 1:
        return np.zeros_like(values)
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
    """The gaps between increasing timestamps (T,) in ns: steps longer than `factor` times the median step."""
    steps = np.diff(stamps)
    if not len(steps):
        return ()
    return tuple(
        Gap(int(i), float(stamps[i] - stamps[0]) / NS_PER_SECOND, float(steps[i]) / NS_PER_SECOND)
        for i in np.flatnonzero(steps > factor * np.median(steps))
    )
