"""Trajectories for tests."""

import numpy as np
from built_in import STANCE

from quadruped_env import JOINT_NAMES, JointTrajectory

STAMPS = [1_763_500_000_000_000_001, 1_763_500_000_020_000_003, 1_763_500_000_050_000_000, 1_763_500_001_000_000_000]
"""Timestamps, ns: over 2^53, where a float no longer holds every whole number, and unevenly spaced."""


def random_trajectory(rows=4, names=JOINT_NAMES, **changes):
    rng = np.random.default_rng(rows)
    efforts = rng.normal(size=(rows, len(names)))
    efforts[0, 1] = np.nan
    arguments = {
        "stamps": STAMPS if rows == 4 else STAMPS[0] + 20_000_000 * np.arange(rows),
        "names": names,
        "positions": rng.uniform(-1.0, 0.0, (rows, len(names))),
        "velocities": rng.normal(size=(rows, len(names))) * 10.0 ** rng.integers(-300, 300, (rows, len(names))),
        "efforts": efforts,
    }
    return JointTrajectory(**(arguments | changes))


def assert_same(a, b):
    """Assert equality to the last bit."""
    assert a.names == b.names
    for name in ("stamps", "positions", "velocities", "efforts"):
        x, y = getattr(a, name), getattr(b, name)
        assert (x is None) == (y is None), name
        assert x is None or (x.dtype == y.dtype and x.shape == y.shape and x.tobytes() == y.tobytes()), name


def assert_same_numbers(a, b):
    """Assert that two trajectories have the same timestamps, positions, velocities and efforts."""
    for name in ("stamps", "positions", "velocities", "efforts"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name))


def standing(seconds=1.0, **changes):
    """A recording of a robot that stands in its stance."""
    stamps = np.array([0, round(seconds * 1e9)])
    return JointTrajectory(**({"stamps": stamps, "names": JOINT_NAMES, "positions": np.tile(STANCE, (2, 1))} | changes))
