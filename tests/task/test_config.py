"""The task's config: JSON, defaults, and refusal of bad values."""

import copy
import dataclasses
import json
import math
import pickle
from typing import Annotated

import numpy as np
import pytest
import second_robot

from quadruped_env import QuadrupedError
from quadruped_env.control.control_config import ControlConfig
from quadruped_env.robot import QuadrupedDesign
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.task import (
    BUILT_IN,
    ActionConfig,
    CommandConfig,
    Parameter,
    RandomizationConfig,
    RewardConfig,
    Task,
    TaskConfig,
    TerminationConfig,
    load_task_file,
)
from quadruped_env.utils.fields import Amplitude, converted

SMALLEST = 1e-9
CONFIG = TaskConfig(
    decimation=5,
    physics_timestep=0.002,
    clock_frequency=1.5,
    action=ActionConfig(mode="residual", residual_scale=0.3, gait="low"),
    command=CommandConfig(forward_velocity=(0.0, 1.0), standing_fraction=0.2),
    reward=RewardConfig(weights=RewardConfig().weights | {"upright": -3.0}, foot_lift=0.015),
    termination=TerminationConfig(max_tilt=0.7),
    randomization=RandomizationConfig(friction=(0.5, 1.0), payload=None, push_velocity=0.4),
)


def test_a_config_survives_json():
    document = json.loads(json.dumps(CONFIG.to_dict()))
    again = TaskConfig.from_dict(document)
    assert again == CONFIG
    assert again.to_dict() == CONFIG.to_dict()
    assert TaskConfig.from_dict({}) == TaskConfig()
    assert TaskConfig.from_dict(TaskConfig().to_dict()) == TaskConfig()


def test_numpy_scalars_and_arrays_in_a_config_become_plain_values():
    given = {
        "decimation": np.int64(5),
        "physics_timestep": np.float64(0.002),
        "clock_frequency": np.array(1.5),
        "command": {"forward_velocity": np.array([0.0, 1.0]), "yaw_rate": [np.float32(-0.5), np.float64(0.5)]},
        "reward": {"weights": {"upright": np.float32(-3.0)}},
        "randomization": {"friction": np.array([0.5, 1.0]), "push_velocity": np.float64(0.4)},
        "motor": {"hip": {"kp": np.float32(41.0)}, "delay": np.float64(0.01)},
    }
    config = TaskConfig.from_dict(given)
    document = json.loads(json.dumps(config.to_dict()))
    assert TaskConfig.from_dict(document) == config
    assert config.command.forward_velocity == (0.0, 1.0)
    assert (type(config.decimation), config.decimation) == (int, 5)
    assert (type(config.motor.hip.kp), config.motor.hip.kp) == (float, 41.0)
    assert given["command"]["forward_velocity"].shape == (2,), "the caller's values must not change"


@pytest.mark.parametrize(
    "value", [np.array([1.0]), np.array([[0.0, 1.0]]), np.array(["a", "b"]), np.array([0.0, np.nan])]
)
def test_arrays_of_the_wrong_kind_in_a_config_are_refused(value):
    with pytest.raises(QuadrupedError, match=r"config\.command\.forward_velocity"):
        TaskConfig.from_dict({"command": {"forward_velocity": value}})


def test_what_a_config_leaves_out_keeps_its_default():
    config = TaskConfig.from_dict({"decimation": 2, "reward": {"weights": {"upright": -7}}})
    default = TaskConfig()
    assert config.decimation == 2
    assert config.control_timestep == default.physics_timestep * 2
    assert config.reward.weights == default.reward.weights | {"upright": -7.0}
    assert tuple(config.reward.weights) == tuple(default.reward.weights), "the order in which terms are added"
    assert config.command == default.command


def test_configs_share_nothing_and_do_not_change():
    one, other = TaskConfig(), TaskConfig()
    with pytest.raises(dataclasses.FrozenInstanceError):
        one.decimation = 3
    document = one.to_dict()
    document["reward"]["weights"]["upright"] = 9.0
    assert one == other


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"tempo": 1}, r"config: unknown field 'tempo'; valid fields are decimation, physics_timestep"),
        ({"command": {"speed": 1}}, r"config.command: unknown field 'speed'; valid fields are .*forward_velocity"),
        ({"command": {"yaw_rate": [0.3, 0.1]}}, r"command.yaw_rate must be a pair .* low <= high; found \(0.3, 0.1\)"),
        ({"command": {"resample_interval": None}}, r"resample_interval: expected a pair \(low, high\); found None"),
        ({"command": {"standing_fraction": 0.7, "straight_fraction": 0.7}}, r"must be at most 1; found 1.5"),
        ({"action": {"mode": "torque"}}, r"config.action.mode must be one of position, residual; found 'torque'"),
        ({"action": {"mode": []}}, r"config.action.mode must be one of position, residual; found \[\]"),
        (
            {"action": {"gait": "trot"}},
            r"action.gait must be one of sinusoid, tuned, crouched, low, fast; found 'trot'",
        ),
        ({"action": {"position_scale": 0}}, r"action.position_scale must be positive \(rad\), .*; found 0"),
        ({"decimation": True}, r"config.decimation must be a whole number from 1 to 1000; found True"),
        ({"decimation": 0}, r"config.decimation must be a whole number from 1 to 1000; found 0"),
        ({"motor": {"hip": 3}}, r"config.motor.hip: expected a mapping of fields; found 3"),
        ({"reward": {"weights": {"speed": 1}}}, r"config.reward.weights: unknown field 'speed'; valid fields are"),
        ({"reward": {"weights": {"upright": "much"}}}, r"config.reward.weights.upright: expected a number"),
        ({"termination": {"max_tilt": 4}}, r"termination.max_tilt must be in \(0, pi\] \(rad\); found 4"),
        ({"motor": {"hip": {"no_load_speed": 1e-300}}}, r"no_load_speed must be .*1e-09 or more"),
        ({"randomization": {"payload": [-3, 0]}}, r"randomization.payload must be over -1 \(kg\)"),
    ],
)
def test_a_bad_config_names_the_field_the_value_and_the_rule(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TaskConfig.from_dict(values)


@pytest.mark.parametrize(
    "values",
    [
        {"decimation": 1},
        {"physics_timestep": 1e-5},
        {"clock_frequency": 0.5},
        {"command": {"standing_fraction": 0.5, "straight_fraction": 0.25, "turning_fraction": 0.25}},
        {"command": {"yaw_rate": (0.2, 0.2), "standing_fraction": 0.0}},
        {"reward": {"foot_lift": SMALLEST, "contact_threshold": 0.0}},
        {"termination": {"max_tilt": math.pi, "max_trunk_force": 0.0}},
        {"randomization": {"start_tilt": 0.0, "push_interval": (SMALLEST, 1.0), "payload": (-0.999, 0.0)}},
        {"terrain": {"name": "flat", "seed": 1}},
    ],
)
def test_values_at_the_ends_of_their_ranges_are_taken(values):
    config = TaskConfig.from_dict(values).to_dict()
    for section, value in values.items():
        changes = value if isinstance(value, dict) else {section: value}
        found = config[section] if isinstance(value, dict) else config
        assert {name: found[name] for name in changes} == changes


def test_motors_of_a_config_go_to_another_robot_only_if_they_were_changed():
    default = TaskConfig()
    identified = dataclasses.replace(default.motor, delay=0.01)
    assert default.for_robot(second_robot.ROBOT).motor == second_robot.ROBOT.motors != default.motor
    assert TaskConfig(motor=identified).for_robot(second_robot.ROBOT).motor == identified


def test_the_weights_are_those_of_the_terms():
    with pytest.raises(
        QuadrupedError,
        match=r"reward.weights: unknown field 'uprigth'; valid fields are track_forward.*; did you mean upright",
    ):
        RewardConfig(weights=RewardConfig().weights | {"uprigth": 1.0})
    weights = RewardConfig(weights={"upright": -7.0}).weights
    assert weights == RewardConfig().weights | {"upright": -7.0}
    assert tuple(weights) == tuple(RewardConfig().weights), "the order in which terms are added"


def through_pickle(value):
    return pickle.loads(pickle.dumps(value))  # noqa: S301


@pytest.mark.parametrize("duplicate", [copy.deepcopy, through_pickle])
def test_a_copied_config_is_equal(duplicate):
    assert duplicate(CONFIG) == CONFIG
    assert duplicate(CONFIG.reward.weights) == CONFIG.reward.weights


def test_a_section_is_read_by_name_and_frozen():
    section = CONFIG.randomization
    assert section.friction == section["friction"] == (0.5, 1.0)
    with pytest.raises(dataclasses.FrozenInstanceError):
        section.friction = (1.0, 1.0)
    changed = section.replace(friction=(0.1, 0.2))
    assert (changed.friction, section.friction) == ((0.1, 0.2), (0.5, 1.0))
    assert repr(section) == "randomization(friction=(0.5, 1.0), push_velocity=0.4)"


def test_a_section_is_replaced_with_the_checks_of_its_constructor():
    section = CommandConfig(standing_fraction=0.2)
    assert section.replace(straight_fraction=0.6) == CommandConfig(standing_fraction=0.2, straight_fraction=0.6)
    with pytest.raises(QuadrupedError, match=r"straight_fraction \+ turning_fraction must be at most 1; found 1.2"):
        section.replace(standing_fraction=0.8)


def test_every_randomization_is_switched_off_by_none():
    config = TaskConfig.from_dict({"randomization": dict.fromkeys(name for name in ("start_heading", "friction"))})
    task = Task(BatchSimulation(build_model(), 3, 1), config)
    task.reset(np.arange(3), range(3))
    w, _, _, z = task.simulation.readings.orientation.T
    assert (abs(2.0 * np.arctan2(z, w)) < 0.06).all()


def test_the_defaults_of_control_are_those_of_the_task():
    assert ControlConfig() == TaskConfig().control


BOUNDS = r"at most|in [\[(]| to "
"""Words of errors that give bounds."""


def _numbers(values, path=()):
    """Paths of the fields of nested values that hold numbers, or None instead of a pair."""
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _numbers(value, (*path, name))
        elif not isinstance(value, str) and name != "level":
            yield (*path, name), value


def test_a_number_of_any_size_is_refused_and_the_message_gives_the_field_and_the_bounds():
    fields = list(_numbers(TaskConfig().to_dict()))
    assert len(fields) > 50
    for path, default in fields:
        paired = default is None or isinstance(default, tuple)
        for value in (1e300, -1e300, 2**32, 10**400, math.nan):
            values = (value, value) if paired else value
            for name in reversed(path):
                values = {name: values}
            with pytest.raises(QuadrupedError, match=rf"{path[-1]}\b.*({BOUNDS}|whole).*; found "):
                TaskConfig.from_dict(values)


@pytest.mark.parametrize(
    ("value", "limits", "valid"),
    [
        (0.2, Parameter(low=-0.2, high=0.2), True),
        (0.3, Parameter(low=-0.2, high=0.2), False),
        (-0.1, Parameter(), False),
        (0.1, Parameter(low=0.0), False),  # whose other end is -0.1
        ((0.1, 0.2), Parameter(low=0.0), True),
        ((-0.1, 0.2), Parameter(low=0.0), False),
        (None, Parameter(low=0.0), True),
    ],
)
def test_an_amplitude_stands_for_both_ends_of_its_range(value, limits, valid):
    if valid:
        assert converted(value, Annotated[Amplitude, limits], "config.x") == value
    else:
        with pytest.raises(QuadrupedError, match=r"config\.x must be"):
            converted(value, Annotated[Amplitude, limits], "config.x")


def test_limits_of_a_larger_robot_are_larger():
    large = BUILT_IN.with_robot(QuadrupedDesign(name="large", leg_length=0.5).robot())
    values = {"randomization": {"base_com": 0.25}}
    assert TaskConfig.from_dict(values, large).randomization.base_com == 0.25
    with pytest.raises(QuadrupedError, match=r"base_com must be"):
        TaskConfig.from_dict(values)


def test_name_that_a_section_needs_itself_is_refused_for_a_term(tmp_path):
    file = tmp_path / "own.py"
    file.write_text("from quadruped_env.task import Command\nc = Command('items', 'm', (0.0, 0.1))\n")
    with pytest.raises(QuadrupedError, match=r"config.command: 'items' cannot be the name of a field; choose another"):
        TaskConfig(definition=load_task_file(file))
