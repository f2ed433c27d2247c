import math

import numpy as np
import pytest
from scipy import stats

from quadruped_env.evaluation.confidence import Estimate, bootstrap_mean, mean_interval, proportion, standard_error


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


def test_interval_covers_the_true_mean_at_its_nominal_rate():
    rng = np.random.default_rng(0)
    estimates = [bootstrap_mean(rng.normal(size=40)) for _ in range(200)]
    assert 0.9 <= np.mean([e.low <= 0.0 <= e.high for e in estimates]) <= 0.99


def test_nan_is_not_counted_as_a_value(sample):
    holed = np.concatenate([sample, [math.nan] * 3])
    assert bootstrap_mean(holed).mean == pytest.approx(sample.mean())
    assert bootstrap_mean(holed).count == 30
    assert bootstrap_mean([math.nan, math.nan, 1.0]) == Estimate(1.0, 1.0, 1.0, 1)
    for nothing in ([], [math.nan]):
        assert bootstrap_mean(nothing).count == 0
        assert math.isnan(bootstrap_mean(nothing).mean)


@pytest.mark.parametrize("count", [2, 3, 4, 9, 128])
def test_t_interval_agrees_with_scipy(count):
    values = np.random.default_rng(count).normal(1.0, size=count)
    scipy = stats.ttest_1samp(values, 0.0).confidence_interval()
    estimate = mean_interval(values)
    assert (estimate.mean, estimate.count) == (pytest.approx(values.mean()), count)
    assert (estimate.low, estimate.high) == pytest.approx((scipy.low, scipy.high), rel=1e-9)
    assert standard_error(values) == pytest.approx(stats.sem(values))


@pytest.mark.parametrize(("events", "trials"), [(0, 50), (3, 50), (50, 50)])
def test_proportion_agrees_with_scipy(events, trials):
    estimate = proportion([True] * events + [False] * (trials - events))
    expected = stats.binomtest(events, trials).proportion_ci(method="wilson")
    assert (estimate.mean, estimate.low, estimate.high) == pytest.approx(
        (events / trials, expected.low, expected.high), abs=1e-12
    )


def test_proportion_of_nothing_is_nan():
    assert math.isnan(proportion([]).mean)
