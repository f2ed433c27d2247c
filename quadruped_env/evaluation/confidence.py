"""Means over episodes, with confidence intervals.

Implemented in NumPy so that a report does not need SciPy; the tests compare it with `scipy.stats.bootstrap`.
"""

import math
from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

CONFIDENCE: Final = 0.95
RESAMPLES: Final = 10_000
_SEED: Final = 0
_NORMAL_QUANTILE: Final = 1.959963984540054
"""Quantile of the standard normal distribution at (1 + CONFIDENCE) / 2."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """A mean and the ends of its 95 % confidence interval; NaN without data."""

    mean: float
    low: float
    high: float
    count: int
    """Number of values that are not NaN"""


def bootstrap_mean(values: ArrayLike) -> Estimate:
    """The mean of the values that are not NaN, with its percentile bootstrap interval.

    Efron & Tibshirani 1993, An Introduction to the Bootstrap, section 13.3. Seeded, so that a report is reproducible.

    Args:
        values: S random samples (S,), or S random samples under each of K fixed conditions (K, S). Each condition is
            resampled separately, because the conditions are not random.
    """
    strata = np.atleast_2d(np.asarray(values, dtype=np.float64))
    count = int(np.isfinite(strata).sum())
    if not count:
        return Estimate(math.nan, math.nan, math.nan, 0)
    finite = np.isfinite(strata).ravel()
    counts = _resample_counts(*strata.shape)
    totals, sizes = counts @ np.where(finite, strata.ravel(), 0.0), counts @ (finite * 1.0)
    # A resample may contain only NaN.
    means = totals[sizes > 0] / sizes[sizes > 0]
    low, high = np.quantile(means, [(1.0 - CONFIDENCE) / 2.0, (1.0 + CONFIDENCE) / 2.0])
    return Estimate(float(np.nanmean(strata)), float(low), float(high), count)


@cache
def _resample_counts(conditions: int, size: int) -> NDArray[np.float64]:
    """Number of times that each value is drawn in each resample, (RESAMPLES, conditions * size)."""
    generator = np.random.default_rng(_SEED)
    counts = generator.multinomial(size, np.full(size, 1.0 / size), (RESAMPLES, conditions))
    return counts.reshape(RESAMPLES, conditions * size).astype(np.float64)


def proportion(events: ArrayLike) -> Estimate:
    """The share of True among events of any shape, with its Wilson score interval.

    Unlike the bootstrap's, it has a width above 0 if no event was seen: 0 falls in 50 episodes do not prove that there
    are 0 in 1000 (Wilson 1927, https://doi.org/10.1080/01621459.1927.10502953).
    """
    flags = np.asarray(events, dtype=np.float64)
    n = flags.size
    if not n:
        return Estimate(math.nan, math.nan, math.nan, 0)
    share, z2 = float(flags.mean()), _NORMAL_QUANTILE**2
    centre = (share + z2 / (2.0 * n)) / (1.0 + z2 / n)
    half = _NORMAL_QUANTILE * math.sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n)) / (1.0 + z2 / n)
    return Estimate(share, max(0.0, centre - half), min(1.0, centre + half), n)
