"""The scripted gait: the tutorial's formula, the presets within its limits, and the searched gait by command."""

import math

import numpy as np
import pytest
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, VELOCITY_LIMIT

from quadruped_env import CommandedGait, QuadrupedError, SinusoidalGait
from quadruped_env.gait import LEG_PHASES, PRESETS, turn_size
from quadruped_env.robot import JOINT_NAMES
from quadruped_env.task import TaskConfig

TUNED = CommandedGait.preset("tuned")


def gait(**changes):
    """A gait well within the limits, but for the changes."""
    values = {
        "hip_amplitude": 0.2,
        "hip_offset": 0.6,
        "knee_amplitude": 0.2,
        "knee_offset": -0.7,
        "angular_frequency": 10.0,
        "phases": (0.0,) * 8,
    }
    return SinusoidalGait(**values | changes)


def draw_commands(count):
    """Commands (N, 2) over slightly more than the task's ranges, the corners included."""
    config = TaskConfig().command
    low, high = np.array([config.forward_velocity, config.yaw_rate]).T
    rng = np.random.default_rng(0)
    corners = [[x, y] for x in (low[0], 0.0, high[0]) for y in (low[1], 0.0, high[1])]
    return np.concatenate([corners, rng.uniform(low - 0.1, high + 0.1, (count, 2))])


# --- plain gaits ---


def test_article_preset_is_the_tutorials_formula():
    phases = [0.0, 0.5, 3.14, 3.64, 1.57, 2.07, 4.71, 5.21]
    article = SinusoidalGait.preset("article")
    for t in (0.0, 0.05, 1.0, 123.45):
        expected = [
            0.4 * np.sin(2.0 * t + p) if i % 2 == 0 else 0.3 * np.cos(2.0 * t + p) - 0.3 for i, p in enumerate(phases)
        ]
        np.testing.assert_allclose(article.positions(t), expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", PRESETS)
def test_velocities_are_the_derivative_of_positions(name):
    preset = SinusoidalGait.preset(name)
    t = np.linspace(0, 3, 50)
    h = 1e-6
    numeric = (preset.positions(t + h) - preset.positions(t - h)) / (2 * h)
    np.testing.assert_allclose(preset.velocities(t), numeric, atol=1e-7)


# The targets of `sinusoid` are larger than the motion at its preset's 0.4 m/s: the servos do not follow that fast.
@pytest.mark.parametrize("name", [name for name in PRESETS if name != "sinusoid"])
def test_every_preset_stays_within_the_robots_limits(name):
    preset = SinusoidalGait.preset(name)
    assert preset.violations() == []
    t = np.linspace(0, preset.period, 2001)
    positions, velocities = preset.positions(t), preset.velocities(t)
    assert (positions >= JOINT_POSITION_LOW - 1e-9).all()
    assert (positions <= JOINT_POSITION_HIGH + 1e-9).all()
    assert (abs(velocities) <= VELOCITY_LIMIT + 1e-9).all()
    assert (np.ptp(positions, axis=0) > 0).all(), "every joint moves"


def test_times_of_any_shape_give_that_many_positions():
    trot = SinusoidalGait.preset("trot")
    t = np.linspace(0, 1, 6).reshape(2, 3)
    assert trot.positions(0.5).shape == (8,)
    assert trot.velocities(t).shape == trot.positions(t).shape == (2, 3, 8)
    np.testing.assert_array_equal(trot.positions(t)[1, 2], trot.positions(t[1, 2]))
    np.testing.assert_array_equal(trot.positions([0.0, 1.0])[1], trot.positions(1))


@pytest.mark.parametrize(
    ("changes", "found"),
    [
        ({}, []),
        ({"hip_amplitude": 0.6, "angular_frequency": 10.0}, [(j, "6.000 rad/s is over 5") for j in JOINT_NAMES[::2]]),
        ({"angular_frequency": -40.0}, [(j, "8.000 rad/s is over 5") for j in JOINT_NAMES]),
        (
            {"knee_offset": (-0.7, -0.1, -0.7, -1.9)},
            [
                ("RF_knee_joint", "-0.300 to 0.100 rad is outside -2 to 0"),
                ("RH_knee_joint", "-2.100 to -1.700 rad is outside -2 to 0"),
            ],
        ),
        ({"hip_offset": 1.4}, [(j, "1.200 to 1.600 rad is outside -1.5 to 1.5") for j in JOINT_NAMES[::2]]),
        (
            {"hip_amplitude": (-2.0, 0.1, 0.1, 0.1), "hip_offset": 0.0},
            [("LF_hip_joint", "-2.000 to 2.000 rad is outside"), ("LF_hip_joint", "20.000 rad/s is over 5")],
        ),
        ({"knee_amplitude": 0.5, "knee_offset": -0.5}, []),  # just at both limits
    ],
)
def test_violations_name_the_joint_its_value_and_the_limit(changes, found):
    violations = gait(**changes).violations()
    assert len(violations) == len(found)
    for text, (joint, part) in zip(violations, found, strict=True):
        assert text.startswith(f"{joint}: ")
        assert part in text


def test_unknown_preset_names_the_valid_ones():
    with pytest.raises(QuadrupedError, match=r"article, sinusoid, trot, .*, low, fast; found 'gallop'"):
        SinusoidalGait.preset("gallop")
    with pytest.raises(QuadrupedError, match=r"must be one of sinusoid, tuned, crouched, low, fast; found 'trot'"):
        CommandedGait.preset("trot")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"phases": (0.0,) * 7}, r"phases must be 8 numbers, one per joint"),
        ({"hip_amplitude": (0.1, 0.2)}, r"hip_amplitude must be one number or 4, one per hip"),
        ({"knee_offset": ((0.1,) * 4,)}, r"knee_offset must be one number or 4"),
        ({"knee_amplitude": math.nan}, r"every parameter must be finite"),
        ({"angular_frequency": math.inf}, r"every parameter must be finite"),
        ({"phases": (0.0,) * 7 + (math.nan,)}, r"every parameter must be finite"),
    ],
)
def test_bad_parameters_are_refused_by_name(changes, message):
    with pytest.raises(QuadrupedError, match=message):
        gait(**changes)


# --- the searched gait ---


@pytest.mark.parametrize("name", ["tuned", "crouched", "low", "fast"])
def test_presets_that_follow_a_command_have_that_of_0_4_m_s_straight_ahead(name):
    t, gait = np.linspace(0, 1, 20), CommandedGait.preset(name)
    expected = gait.positions(gait.angular_frequency * t, np.tile([0.4, 0.0], (20, 1)))
    np.testing.assert_allclose(SinusoidalGait.preset(name).positions(t), expected, atol=1e-12)


def test_the_plain_gait_for_a_command_is_the_commanded_one():
    t = np.linspace(0, 1.5, 40)
    for command in draw_commands(20):
        expected = TUNED.positions(TUNED.angular_frequency * t, np.tile(command, (40, 1)))
        np.testing.assert_allclose(TUNED.at(tuple(command)).positions(t), expected, atol=1e-12)


def test_positions_are_the_waves_at_a_phase():
    commands = draw_commands(30)
    phase = np.random.default_rng(1).uniform(0, math.tau, len(commands))
    sine, cosine, offset = TUNED.waves(commands)
    legs = np.repeat(np.array(LEG_PHASES["trot"]) * math.tau, 2)
    angle = phase[:, None] + legs
    expected = sine * np.sin(angle) + cosine * np.cos(angle) + offset
    np.testing.assert_allclose(TUNED.positions(phase, commands), expected, atol=1e-12)
    for row in range(len(commands)):
        one = TUNED.positions(phase[[row]], commands[[row]])[0]
        np.testing.assert_array_equal(one, TUNED.positions(phase, commands)[row], "whatever the other commands are")


def test_at_a_zero_command_the_tuned_gait_is_the_stance():
    phase = np.linspace(0, math.tau, 20)
    np.testing.assert_array_equal(TUNED.positions(phase, np.zeros((20, 2))), np.tile(STANCE, (20, 1)))


def test_the_tuned_gait_stays_within_the_robots_limits_at_every_command():
    for command in draw_commands(300):
        assert TUNED.at(tuple(command)).violations() == [], command


def test_the_tuned_gait_changes_smoothly_with_the_command():
    """In the forward velocity and in the size of the turn, whose slope over the yaw rate is infinite at zero."""
    phase, largest = np.linspace(0, math.tau, 50), TUNED.largest_yaw_rate
    for start in draw_commands(20):
        size = turn_size(start[1], largest) - 1e-4
        end = [start[0] + 1e-4, size * abs(size) / largest]
        before, after = (TUNED.positions(phase, np.tile(c, (50, 1))) for c in (start, end))
        assert abs(after - before).max() < 0.003


def test_size_of_a_turn_is_the_root_of_the_yaw_rate_times_the_largest():
    np.testing.assert_allclose(turn_size(np.array([0.0, 0.2, 0.45, 0.8]), 0.8), [0.0, 0.4, 0.6, 0.8], rtol=1e-15)
    np.testing.assert_allclose(turn_size(np.array([0.25, 0.5, 1.0]), 1.0), [0.5, math.sqrt(0.5), 1.0], rtol=1e-15)
    yaw_rates = np.random.default_rng(0).uniform(-0.7, 0.7, (50, 3))
    np.testing.assert_allclose(turn_size(yaw_rates, 0.7) ** 2 / 0.7, abs(yaw_rates), rtol=1e-14)
    np.testing.assert_array_equal(turn_size(-yaw_rates, 0.7), -turn_size(yaw_rates, 0.7))
    np.testing.assert_array_equal(np.sign(turn_size(yaw_rates, 0.7)), np.sign(yaw_rates))


@pytest.mark.parametrize("speed", [-0.25, 0.1, 0.3])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_tuned_gait_turns_by_the_size_of_the_turn(speed, sign):
    """A quarter of the largest yaw rate is half of its turn, and a larger one is no more than that."""
    largest = sign * TUNED.largest_yaw_rate
    commands = np.array([[speed, yaw_rate] for yaw_rate in (0.0, largest / 4, largest, 1.5 * largest)])
    for straight, quarter, full, beyond in TUNED.waves(commands):
        np.testing.assert_allclose(quarter - straight, 0.5 * (full - straight), atol=1e-14)
        np.testing.assert_array_equal(beyond, full)
        assert abs(full - straight).max() > 0.03


def test_tuned_gait_turning_the_other_way_swaps_left_and_right():
    phase = np.linspace(0, math.tau, 30)
    left, right = (TUNED.positions(phase, np.tile([0.1, w], (30, 1))) for w in (0.5, -0.5))
    # The mirror image of a trot's leg is the other side's, half a cycle on.
    sine, cosine, offset = TUNED.waves(np.array([[0.1, 0.5]]))
    mirrored = [values[0].reshape(2, 2, 2)[:, ::-1].reshape(8) for values in (sine, cosine, offset)]
    for values, expected in zip(TUNED.waves(np.array([[0.1, -0.5]])), mirrored, strict=True):
        np.testing.assert_allclose(values[0], expected, atol=1e-12)
    assert abs(left - right).max() > 0.01


def test_clock_frequency_of_the_task_is_the_tuned_gaits():
    assert TUNED.angular_frequency == pytest.approx(math.tau * TaskConfig().clock_frequency)
