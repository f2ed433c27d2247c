"""Numbers of the suite's results: plain values, with None for what is not known."""

import math
import warnings
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from quadruped_env.evaluation.confidence import Estimate, bootstrap_mean, proportion


def number(value: float) -> float | None:
    """A number, or None for NaN and infinities."""
    return float(value) if math.isfinite(value) else None


def mean_of(values: ArrayLike) -> Any:
    """Mean over the first axis without NaN: a number, or a list of numbers; None without values."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # the mean of nothing
        means = np.nanmean(np.asarray(values, dtype=np.float64), axis=0)
    return number(float(means)) if means.ndim == 0 else [number(value) for value in means.tolist()]


def share(events: ArrayLike) -> dict[str, Any]:
    """Share of True among events, with its Wilson interval, as plain values."""
    return estimate(proportion(events))


def mean(values: ArrayLike) -> dict[str, Any]:
    """Mean of values (S,) or (K, S) that are not NaN, with its bootstrap interval, as plain values."""
    return estimate(bootstrap_mean(values))


def estimate(value: Estimate) -> dict[str, Any]:
    """An estimate as plain values."""
    return {
        "mean": number(value.mean),
        "low": number(value.low),
        "high": number(value.high),
        "count": value.count,
    }
