import math

import numpy as np
import pytest
from scipy import stats

from quadruped_env.evaluation.confidence import (
    Estimate,
    bootstrap_mean,
    poisson_rate,
    proportion,
)


@pytest.fixture
def sample():
    return np.random.default_rng(3).gamma(2.0, size=30)


def test_bootstrap_agrees_with_scipy(sample):
    ours = bootstrap_mean(sample)
    scipy = stats.bootstrap((sample,), np.mean, n_resamples=20_000, method="percentile", rng=1).confidence_interval
    width = scipy.high - scipy.low
    assert ours.mean == pytest.approx(sample.mean())
    assert ours.count == 30
    assert ours.low == pytest.approx(scipy.low, abs=0.03 * width)
    assert ours.high == pytest.approx(scipy.high, abs=0.03 * width)


def test_the_same_values_give_the_same_interval(sample):
    assert bootstrap_mean(sample) == bootstrap_mean(sample)


def test_difference_between_conditions_is_not_uncertainty(sample):
    conditions = np.stack([sample, sample + 100.0])
    estimate = bootstrap_mean(conditions)
    alone = bootstrap_mean(sample)
    assert estimate.mean == pytest.approx(sample.mean() + 50.0)
    # Two independent samples of this size: narrower than one, by the square root of two.
    assert estimate.high - estimate.low == pytest.approx((alone.high - alone.low) / math.sqrt(2), rel=0.1)


def test_nan_is_not_counted_as_a_value(sample):
    holed = np.concatenate([sample, [math.nan] * 3])
    assert bootstrap_mean(holed).mean == pytest.approx(sample.mean())
    assert bootstrap_mean(holed).count == 30
    assert bootstrap_mean([math.nan, math.nan, 1.0]) == Estimate(1.0, 1.0, 1.0, 1)
    for nothing in ([], [math.nan]):
        assert bootstrap_mean(nothing).count == 0
        assert math.isnan(bootstrap_mean(nothing).mean)


@pytest.mark.parametrize(("events", "trials"), [(0, 50), (3, 50), (50, 50)])
def test_proportion_agrees_with_scipy(events, trials):
    estimate = proportion([True] * events + [False] * (trials - events))
    expected = stats.binomtest(events, trials).proportion_ci(method="wilson")
    assert (estimate.mean, estimate.low, estimate.high) == pytest.approx(
        (events / trials, expected.low, expected.high), abs=1e-12
    )


def test_proportion_of_nothing_is_nan():
    assert math.isnan(proportion([]).mean)


@pytest.mark.parametrize("events", [0, 1, 3, 18, 400])
def test_poisson_interval_is_that_of_the_chi_squared_quantiles(events):
    """Garwood's interval, and for 0 events the rule of three and a bit: 3.69 per exposure."""
    found = poisson_rate(events, 2.0)
    low = 0.5 * stats.chi2.ppf(0.025, 2 * events) if events else 0.0
    np.testing.assert_allclose(
        [found.mean, found.low, found.high], np.array([events, low, 0.5 * stats.chi2.ppf(0.975, 2 * events + 2)]) / 2.0
    )
    assert found.count == events
    assert math.isnan(poisson_rate(events, 0.0).high)
