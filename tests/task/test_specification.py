"""The environment MiniQuadruped-v0 as numbers. Another number is another environment, and needs a new version."""

import json
import math

import pytest
from settings import CLOCK_FREQUENCY, REWARD_PARAMETERS, REWARD_WEIGHTS
from tasks import LAYOUT, NOISE

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig

CONFIG = {
    "decimation": 4,
    "physics_timestep": 0.005,
    "clock_frequency": CLOCK_FREQUENCY,
    "observation_history": 3,
    "action": {"mode": "position", "position_scale": 0.6, "residual_scale": 0.4, "gait": "sinusoid"},
    "command": {
        "forward_velocity": [-0.3, 0.6],
        "yaw_rate": [-0.8, 0.8],
        "standing_fraction": 0.1,
        "straight_fraction": 0.25,
        "turning_fraction": 0.15,
        "resample_interval": [1.0, 5.0],
        "forward_acceleration": 1.0,
        "yaw_acceleration": 4.0,
    },
    "reward": {"weights": REWARD_WEIGHTS, **REWARD_PARAMETERS},
    "termination": {"max_tilt": 1.0, "max_trunk_force": 1.0},
    "randomization": {
        "start_joint_position": 0.1,
        "start_joint_velocity": 0.5,
        "start_base_velocity": 0.2,
        "start_base_rotation": 0.2,
        "start_tilt": 0.05,
        "start_heading": math.pi,
        "friction": None,
        "contact_time_constant": None,
        "contact_damping_ratio": None,
        "link_mass": None,
        "link_inertia": None,
        "base_com": 0.0,
        "payload_position": 0.0,
        "payload": None,
        "motor_strength": None,
        "supply_voltage": None,
        "position_gain": None,
        "velocity_gain": None,
        "joint_friction": None,
        "joint_damping": None,
        "rotor_inertia": None,
        "encoder_offset": 0.0,
        "imu_mounting": 0.0,
        "target_step": None,
        "backlash": None,
        "dead_band": None,
        "action_latency": None,
        "observation_latency": None,
        "push_velocity": 0.0,
        "push_rotation": 0.0,
        "push_interval": [4.0, 8.0],
        "push_speed": None,
        "push_force": None,
        "push_force_interval": [4.0, 8.0],
        "push_force_duration": [0.2, 1.0],
        "observation_noise": 0.0,
        "noise_amplitude": {
            "projected_gravity": 0.02,
            "angular_velocity": 0.1,
            "joint_position": 0.01,
            "joint_velocity": 0.3,
            "last_action": 0.0,
            "command": 0.0,
            "gait_clock": 0.0,
        },
    },
    "terrain": {"name": "flat", "seed": 0, "level": None},
}
FIELDS = [
    # Name, columns, scale, bound, amplitude of the noise in the reading's unit
    ("projected_gravity", 3, 1.0, 1.0, 0.02),
    ("angular_velocity", 3, 0.25, 4.0, 0.1),
    ("joint_position", 8, 1.0, 2.1, 0.01),
    ("joint_velocity", 8, 0.2, 3.0, 0.3),
    ("last_action", 8, 1.0, 1.0, 0.0),
    ("command", 2, 4.0, 4.0, 0.0),
    ("gait_clock", 2, 1.0, 1.0, 0.0),
]


def test_default_config_is_version_0():
    values = json.loads(json.dumps(TaskConfig().to_dict()))
    del values["motor"]  # of the robot's design
    assert values == CONFIG


def test_observation_is_that_of_version_0():
    assert [field.name for field in LAYOUT.fields] == [name for name, *_ in FIELDS]
    columns = [values for _, width, *values in FIELDS for _ in range(width)]
    for found, expected in zip((LAYOUT.scale, LAYOUT.high, NOISE), zip(*columns, strict=True), strict=True):
        assert found.tolist() == pytest.approx(expected, rel=1e-6)
    assert (LAYOUT.low == -LAYOUT.high).all()


def test_config_of_a_controller_without_fields_has_those_of_version_0():
    config = ControlConfig.of_task({}, MINI_QUADRUPED)
    assert config.timestep == pytest.approx(0.02)
    assert config.clock_frequency == CLOCK_FREQUENCY
    assert ControlConfig.of_task({"decimation": 1, "physics_timestep": 0.002}, MINI_QUADRUPED).timestep == 0.002
