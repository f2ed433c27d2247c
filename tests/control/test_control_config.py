"""Config that training and a real robot share: the values that it takes, and those that it refuses."""

import math

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.control.control_config import ActionConfig, Command, ControlConfig
from quadruped_env.robot import MINI_QUADRUPED

SMALLEST = 1e-9


def test_scale_is_that_of_the_mode():
    assert ActionConfig("position", 0.5, 0.25).scale == 0.5
    assert ActionConfig("residual", 0.5, 0.25).scale == 0.25


@pytest.mark.parametrize("name", ["position_scale", "residual_scale"])
def test_scales_are_positive(name):
    assert getattr(ActionConfig(**{name: SMALLEST}), name) == SMALLEST
    for value in (0.0, -0.1):
        with pytest.raises(QuadrupedError, match=rf"action.{name} must be positive \(rad\)"):
            ActionConfig(**{name: value})


def test_a_component_of_the_command_has_a_range_and_is_zero_if_left_out():
    assert Command("height", "m", (0.2, 0.2)).default == 0.0
    for wrong in ((0.3, 0.2), (0.1,), (0.1, 0.2, 0.3)):
        with pytest.raises(QuadrupedError, match="height"):
            Command("height", "m", wrong)


@pytest.mark.parametrize(
    ("values", "timestep"),
    [
        ({}, 0.02),
        ({"decimation": 1}, 0.005),
        ({"physics_timestep": 0.001}, 0.004),
        ({"decimation": 8, "physics_timestep": 0.0025}, 0.02),
    ],
)
def test_time_between_actions_is_decimation_times_the_physics_timestep(values, timestep):
    assert ControlConfig.of_task(values, MINI_QUADRUPED).timestep == pytest.approx(timestep, rel=1e-12)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"decimation": 0}, "config.decimation must be a whole number from 1 to 1000; found 0"),
        ({"decimation": 2.0}, "config.decimation must be a whole number from 1 to 1000; found 2.0"),
        ({"physics_timestep": 0.0}, r"physics_timestep must be in \[1e-05, 1\] \(s\); found 0.0"),
        ({"clock_frequency": 0.0}, r"config\.clock_frequency must be positive \(Hz\), .*; found 0.0"),
        ({"clock_frequency": math.inf}, r"config\.clock_frequency: expected a number .*; found inf"),
        ({"action": {"speed": 1}}, "config.action: unknown field 'speed'; valid fields are mode"),
        (None, "expected a mapping of fields; found None"),
    ],
)
def test_values_of_a_policys_file_are_checked(values, message):
    with pytest.raises(QuadrupedError, match=message):
        ControlConfig.of_task(values, MINI_QUADRUPED)


def test_ranges_of_the_command_are_those_of_the_file():
    config = ControlConfig.of_task({"command": {"yaw_rate": [-0.1, 0.2]}, "clock_frequency": 0.5}, MINI_QUADRUPED)
    assert [command.range for command in config.commands] == [(-0.3, 0.6), (-0.1, 0.2)]
    assert config.clock_frequency == 0.5
