"""The shipped gaits on simulated robots, from several starts: what their tables promise."""

import functools

import mujoco
import numpy as np
import pytest

from gait_search.search import ONE_SPEED, measure_commands
from gait_search.trial import draw_starts, measure
from quadruped_env import CommandedGait, SinusoidalGait
from quadruped_env.gait import COMMANDED, LEG_PHASES
from quadruped_env.robot import MINI_QUADRUPED

pytestmark = pytest.mark.skipif(
    mujoco.__version__ < "4", reason="the gaits are tuned on MuJoCo 4; on 3.17 some miss their tables by a little"
)
GAITS = {name: CommandedGait.preset(name) for name in COMMANDED}


def table(gait):
    """Commands at the speeds of a gait's table; at zero the gait stands."""
    return np.array([(speed, 0.0) for speed in gait.speeds if speed != 0.0])


@functools.cache
def walked(name):
    """Results of a gait that follows a command, at the speeds of its table."""
    return measure_commands(GAITS[name], table(GAITS[name]))


# A walking robot is chaotic: on another processor some starts lead to another stride, a few of them to feet that drag.


@pytest.mark.parametrize(
    ("name", "least", "agreement", "error"),
    [
        ("tuned", 0.008, 0.4, 0.04),
        pytest.param("crouched", 0.008, 0.45, 0.05, marks=pytest.mark.slow),
        pytest.param("low", 0.004, 0.3, 0.05, marks=pytest.mark.slow),
        pytest.param("fast", 0.006, 0.3, 0.1, marks=pytest.mark.slow),
    ],
)
def test_gaits_walk_at_the_speeds_of_their_tables_and_lift_every_foot(name, least, agreement, error):
    got = walked(name)
    difference = np.abs(got.forward_velocity - table(GAITS[name])[:, 0])
    assert np.median(difference) < 0.005
    assert difference.max() < 0.04
    assert abs(got.lateral_velocity).max() < 0.01
    assert abs(got.yaw_rate).max() < 0.02  # nothing holds the heading
    assert not got.fallen.any()
    assert np.quantile(got.clearance, 0.25) > least
    assert got.clock.min() > agreement
    assert np.median(got.touchdown_error) < error
    assert got.touchdown_error.max() < 6.0 * error


@pytest.mark.slow
def test_gaits_differ_as_their_names_say():
    """Power is motors' work and heat, which only the search of `tuned` charged."""
    assert walked("low").highest.max() < 0.008
    assert walked("tuned").highest.min() > 0.010
    assert GAITS["fast"].speeds[-1] > 1.25 * GAITS["tuned"].speeds[-1]
    power = {
        name: np.interp((-0.2, 0.1, 0.2, 0.3, 0.4), table(gait)[:, 0], walked(name).electrical_power)
        for name, gait in GAITS.items()
    }
    assert (power["tuned"] < power["crouched"]).all()
    assert np.median(power["tuned"] / power["crouched"]) < 0.85
    assert (power["tuned"] < 0.9 * power["low"])[[0, 4]].all()
    assert power["tuned"][0] < 0.9 * power["fast"][0]


def test_gaits_turn_at_the_commanded_rate():
    commands = np.array([(v, side * w) for v in (0.0, 0.2, -0.2) for w in (0.25, 0.5) for side in (1, -1)])
    got = measure_commands(GAITS["tuned"], commands)
    error = np.abs(got.yaw_rate - commands[:, 1])
    assert np.median(error) < 0.05
    assert error.max() < 0.2
    np.testing.assert_allclose(got.forward_velocity, commands[:, 0], atol=0.08)
    assert got.mean_apex.min(axis=2).mean() > 0.008
    assert np.median(got.touchdown_error) < 0.25


def test_no_hip_is_sent_near_its_limit():
    """A hip overshoots its target by up to a tenth of a radian; its limit is 1.5 rad."""
    speeds, yaw_rates = np.linspace(-0.4, 0.7, 45), np.linspace(-1.0, 1.0, 21)
    commands = np.stack(np.meshgrid(speeds, yaw_rates), axis=-1).reshape(-1, 2)
    sine, cosine, offset = GAITS["tuned"].waves(commands)
    assert (offset + np.hypot(sine, cosine))[:, 0::2].max() < 1.355


@pytest.mark.parametrize("name", ONE_SPEED)
def test_presets_walk_as_fast_as_they_were_tuned_for(name):
    preset, robot = SinusoidalGait.preset(name), MINI_QUADRUPED
    assert preset.violations() == []
    frequency = preset.angular_frequency

    def targets(clock):
        return preset.positions(np.array([clock / frequency]))

    got = measure(robot, targets, 1, frequency, LEG_PHASES[name], draw_starts(robot, 0))
    assert got.forward_velocity[0] == pytest.approx(ONE_SPEED[name], abs=0.05)
    assert not got.fallen[0]
    assert got.highest[0] > 0.01
    assert got.touchdown_error[0] < 0.4
