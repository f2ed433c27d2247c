"""Means over episodes, with confidence intervals.

Implemented in NumPy so that a report does not need SciPy; the tests compare it with `scipy.stats.bootstrap`.
"""

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from quadruped_env.utils.arrays import Floats

CONFIDENCE: Final = 0.95
RESAMPLES: Final = 10_000
_NORMAL_QUANTILE: Final = 1.959963984540054
"""Quantile of the standard normal distribution at (1 + CONFIDENCE) / 2."""

_STUDENT_QUANTILES: Final = (
    *(12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228),
    *(2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086),
    *(2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042),
)
"""Quantiles of Student's t distribution at (1 + CONFIDENCE) / 2, for 1 to 30 degrees of freedom; the last one, which is
too wide, stands for more. https://www.itl.nist.gov/div898/handbook/eda/section3/eda3672.htm"""


@dataclass(frozen=True, slots=True)
class Estimate:
    """A mean and the ends of its 95 % confidence interval; NaN without data."""

    mean: float
    low: float
    high: float
    count: int
    """Number of values that are not NaN"""

    def to_dict(self) -> dict[str, float | int | None]:
        """Return the estimate as plain values; NaN becomes None."""
        return {"mean": number(self.mean), "low": number(self.low), "high": number(self.high), "count": self.count}


def number(value: float) -> float | None:
    """Return a number, or None for NaN and infinities, which JSON cannot represent."""
    return float(value) if math.isfinite(value) else None


def mean_of(values: ArrayLike) -> Any:
    """Return the mean over the first axis without NaN: a number, or a list of numbers; None without values."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # the mean of nothing
        means = np.nanmean(np.asarray(values, dtype=np.float64), axis=0)
    return number(float(means)) if means.ndim == 0 else [number(value) for value in means.tolist()]


def bootstrap_mean(values: ArrayLike) -> Estimate:
    """Return the mean of the values that are not NaN, with its percentile bootstrap interval.

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
    low, high = np.quantile(means, [0.5 - 0.5 * CONFIDENCE, 0.5 + 0.5 * CONFIDENCE])
    return Estimate(float(np.nanmean(strata)), float(low), float(high), count)


@cache
def _resample_counts(conditions: int, size: int) -> Floats:
    """Return the number of times that each value is drawn in each resample, (RESAMPLES, conditions * size)."""
    generator = np.random.default_rng(0)
    counts = generator.multinomial(size, np.full(size, 1.0 / size), (RESAMPLES, conditions))
    return counts.reshape(RESAMPLES, conditions * size).astype(np.float64)


def student_mean(values: Sequence[float]) -> Estimate:
    """Return the mean of a few normally distributed values, with Student's interval; a single value has none.

    The bootstrap's interval is too narrow for few values.
    """
    count, mean = len(values), float(np.mean(values))
    if count < 2:
        return Estimate(mean, math.nan, math.nan, count)
    quantile = _STUDENT_QUANTILES[min(count - 1, len(_STUDENT_QUANTILES)) - 1]
    half = quantile * float(np.std(values, ddof=1)) / math.sqrt(count)
    return Estimate(mean, mean - half, mean + half, count)


def proportion(events: ArrayLike) -> Estimate:
    """Return the share of True among events of any shape, with its Wilson score interval.

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


def poisson_rate(events: int, exposure: float) -> Estimate:
    """Return events per unit of exposure, with the exact interval of a Poisson count (Garwood 1936).

    The upper end is the rate at which so few events have a probability of 2.5 %, the lower end that at which so many
    do; 0 for no event. `count` is the number of events.
    """
    if not exposure > 0.0:
        return Estimate(math.nan, math.nan, math.nan, events)
    tail = 0.5 - 0.5 * CONFIDENCE
    low = _poisson_mean(events - 1, 1.0 - tail) if events else 0.0
    return Estimate(events / exposure, low / exposure, _poisson_mean(events, tail) / exposure, events)


def _poisson_mean(events: int, probability: float) -> float:
    """Return the mean of the Poisson distribution that gives `events` or fewer with a probability, by bisection."""
    numbers = np.arange(events + 1)
    log_factorial = np.array([math.lgamma(k + 1.0) for k in numbers])
    low, high = 0.0, events + 10.0 * math.sqrt(events + 1.0) + 10.0
    for _ in range(100):
        mean = 0.5 * (low + high)
        below = np.exp(numbers * math.log(mean) - mean - log_factorial).sum()
        low, high = (mean, high) if below > probability else (low, mean)
    return 0.5 * (low + high)
