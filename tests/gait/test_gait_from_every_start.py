"""The gaits that follow a command settle into the same strides wherever they start."""

import mujoco
import numpy as np
import pytest

from quadruped_env import CommandedGait
from quadruped_env.evaluation.measures import gait_measures
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import GaitController

pytestmark = pytest.mark.skipif(
    mujoco.__version__ < "4", reason="the gaits are tuned on MuJoCo 4; on 3.17 some miss their tables by a little"
)

SPEEDS = (-0.3, -0.2, -0.1, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5)
STARTS = 16


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "clearance", "dragging", "bounces", "settled"),
    [
        ("tuned", 0.006, 0.05, 0.1, 0.75),
        ("crouched", 0.006, 0.05, 0.1, 0.75),
        ("low", 0.003, 0.05, 0.1, 0.75),
        # Drags a foot in 7 % of the episodes: 41 of 576, with MuJoCo 3.17.0 and 4.0.0. At 0.25 m/s, six of 16 starts
        # lead into another, slower stride.
        ("fast", 0.005, 0.1, 0.3, 0.5),
    ],
)
def test_gait_lifts_every_foot_once_per_stride_from_every_start(name, clearance, dragging, bounces, settled):
    """At 2.6 Hz, two feet dragged in one episode of eight, and some touched down 1.6 times per stride."""
    controller = GaitController(CommandedGait.preset(name))
    seeds = range(FIRST_SEED, FIRST_SEED + STARTS)
    rollout = roll_out(controller, [(speed, 0.0) for speed in SPEEDS], seeds, 8.0, physics=True)
    got = gait_measures(rollout)
    assert not rollout.fallen.any()
    lowest = got["clearance"].min(axis=1)
    # A walking robot is chaotic: on another processor a start may lead to another stride.
    assert np.quantile(lowest, dragging) > clearance
    assert np.quantile(got["bounces_per_stride"], 0.95) < bounces
    velocity = rollout.velocity[50:, :, 0].mean(axis=0).reshape(len(SPEEDS), STARTS)
    np.testing.assert_allclose(np.median(velocity, axis=1), SPEEDS, atol=0.015)
    assert np.quantile(np.ptp(velocity, axis=1), settled) < 0.04
