"""Counter-based random numbers: uniform, independent, a function of key, episode, step, purpose and column alone."""

import math

import numpy as np
import pytest

from quadruped_env.task.randomization.draws import Draws, Purposes

FIRST = Purposes({"first": 30, "second": 4})


def draws(num_envs, seed=0):
    made = Draws(num_envs)
    for env_id in range(num_envs):
        made.set_key(env_id, np.random.default_rng([seed, env_id]))
    made.begin_episode(np.arange(num_envs))
    return made


def test_draws_are_uniform_and_white():
    made, everywhere = draws(200), np.arange(200)
    numbers = np.array([made.uniform(FIRST, everywhere, np.full(200, step)) for step in range(50)])
    assert numbers.shape == (50, 200, 34)
    assert numbers.min() >= 0.0
    assert numbers.max() < 1.0
    count = numbers.size
    assert abs(numbers.mean() - 0.5) < 4 * math.sqrt(1 / 12 / count)
    assert numbers.var() == pytest.approx(1 / 12, rel=0.01)
    assert len(np.unique(numbers)) == count, "no number twice"
    centred = numbers - 0.5
    for axis in range(3):
        correlation = (centred * np.roll(centred, 1, axis=axis)).mean() * 12
        assert abs(correlation) < 4 / math.sqrt(count), f"correlated along axis {axis}"
    histogram = np.histogram(numbers, bins=20, range=(0, 1))[0]
    assert (abs(histogram - count / 20) < 5 * math.sqrt(count / 20)).all()


def test_draws_of_neighbouring_keys_and_episodes_are_independent():
    made = Draws(64)

    class Counting:
        """A generator that gives 0, 1, 2, ...: the worst keys there are."""

        def __init__(self, value):
            self.value = value

        def integers(self, *args, **kwargs):
            return np.uint64(self.value)

    for env_id in range(64):
        made.set_key(env_id, Counting(env_id))
    episodes = []
    for _ in range(64):
        made.begin_episode(np.arange(64))
        episodes.append(made.uniform(FIRST, np.arange(64), np.zeros(64, dtype=np.int64)))
    numbers = np.array(episodes) - 0.5
    assert len(np.unique(numbers)) == numbers.size
    for axis in range(3):
        for shift in (1, 2, 8):
            correlation = (numbers * np.roll(numbers, shift, axis=axis)).mean() * 12
            assert abs(correlation) < 4 / math.sqrt(numbers.size), (axis, shift)


def test_added_purpose_shifts_no_other():
    made, ids, step = draws(5), np.arange(5), np.arange(5)
    alone = made.uniform(Purposes({"second": 4}), ids, step)
    more = Purposes({"new": 7, **FIRST.widths})
    np.testing.assert_array_equal(made.uniform(more, ids, step)[:, more.slices["second"]], alone)
    wider = made.uniform(Purposes({"second": 9}), ids, step)
    np.testing.assert_array_equal(wider[:, :4], alone)
    assert not np.isin(made.uniform(Purposes({"third": 4}), ids, step), alone).any()
