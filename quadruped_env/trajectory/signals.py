"""Numbers over time: between rows, and their rate of change."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

NANOSECONDS: Final = 1e9
"""in a second"""

_DEGREE: Final = 2
_ROWS_A_BLOCK: Final = 65536


def interpolate(
    stamps: NDArray[np.float64], values: NDArray[np.float64], times: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Values (..., J) at times (...) on straight lines between rows (T, J) at rising stamps (T,), all in one unit.

    Before the first row and after the last it holds their values. At a row's own time it gives that row's values to the
    last bit.
    """
    times = times.clip(stamps[0], stamps[-1])
    before = np.searchsorted(stamps, times, side="right") - 1
    after = np.minimum(before + 1, len(stamps) - 1)
    share = ((times - stamps[before]) / np.maximum(stamps[after] - stamps[before], 1.0))[..., None]
    # Where the time is a row's own, the next row does not matter, even if it is NaN.
    return np.where(share == 0.0, values[before], values[before] + share * (values[after] - values[before]))


def derivative(seconds: NDArray[np.float64], values: NDArray[np.float64], rows: int) -> NDArray[np.float64]:
    """Rate of change (T, J) of values (T, J) at rising times (T,), filtered and not delayed.

    A parabola is fitted by least squares to each row and its neighbours, `rows` in all, and its slope taken at the row;
    near an end the window stops at the end. On evenly spaced rows that is the filter of Savitzky and Golay (1964),
    https://doi.org/10.1021/ac60214a047; here rows may be spaced unevenly. It is exact for parabolas.
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
    for first in range(0, count, _ROWS_A_BLOCK):
        block = slice(first, first + _ROWS_A_BLOCK)
        offsets = windows[starts[block]] - seconds[block, None]
        # In units of the window's own length, so that the powers are of one size.
        length = np.ptp(offsets, axis=1, keepdims=True)
        powers = (offsets / length)[..., None] ** np.arange(degree + 1)
        slope = np.linalg.pinv(powers)[:, 1, :] / length
        result[block] = np.einsum("tr,tjr->tj", slope, neighbours[starts[block]])
    return result


@dataclass(frozen=True)
class Gap:
    """A time without rows."""

    row: int
    """The last one before it"""
    start: float
    """s from the first stamp"""
    seconds: float


def find_gaps(stamps: NDArray[np.int64], factor: float = 3.0) -> tuple[Gap, ...]:
    """The gaps between rising stamps (T,) in ns: times longer than `factor` times the usual (the median)."""
    steps = np.diff(stamps)
    if not len(steps):
        return ()
    return tuple(
        Gap(int(i), float(stamps[i] - stamps[0]) / NANOSECONDS, float(steps[i]) / NANOSECONDS)
        for i in np.flatnonzero(steps > factor * np.median(steps))
    )
