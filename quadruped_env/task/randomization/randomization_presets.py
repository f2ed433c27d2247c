"""Presets of the config's section `randomization`."""

from collections.abc import Mapping
from typing import Final

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scaled_values
from quadruped_env.task.randomization.built_in_randomizations import RANDOMIZATIONS
from quadruped_env.utils.fields import check
from quadruped_env.utils.plain import Plain, plain

PRESET: Final = "preset"
"""Field of the section that names a preset, next to the fields that change it."""

_RANGES: Final[Mapping[str, tuple[Plain, Plain]]] = {
    "friction": ((0.5, 1.1), (0.3, 1.2)),
    "link_mass": ((0.9, 1.1), (0.8, 1.2)),
    "link_inertia": ((0.9, 1.1), (0.8, 1.2)),
    "base_com": (0.01, 0.02),
    "payload_position": (0.03, 0.05),
    "payload": ((-0.2, 0.5), (-0.5, 1.0)),
    "motor_strength": ((0.9, 1.1), (0.8, 1.2)),
    "supply_voltage": ((0.95, 1.05), (0.85, 1.05)),
    "position_gain": ((0.9, 1.1), (0.8, 1.2)),
    "velocity_gain": ((0.9, 1.1), (0.8, 1.2)),
    "joint_damping": ((0.7, 1.5), (0.5, 2.0)),
    "rotor_inertia": ((0.8, 1.25), (0.67, 1.5)),
    "encoder_offset": (0.01, 0.02),
    "imu_mounting": (0.01, 0.03),
    "action_latency": ((0.0, 0.02), (0.0, 0.06)),
    "observation_latency": ((0.0, 0.005), (0.0, 0.01)),
    "push_speed": (None, (0.75, 0.75)),
    "push_velocity": (0.5, None),
    "push_rotation": (0.8, None),
    "push_interval": ((2.0, 4.0), (3.0, 3.0)),
    "push_force": ((0.0, 3.0), (0.0, 6.0)),
    "observation_noise": (1.0, 1.5),
}
"""Ranges of the presets `moderate` and `hard` for the built-in robot; None: the default."""

PRESETS: Final[Mapping[str, Mapping[str, Plain]]] = {
    "none": {},
    "moderate": {name: moderate for name, (moderate, _) in _RANGES.items() if moderate is not None},
    "hard": {name: hard for name, (_, hard) in _RANGES.items() if hard is not None},
}
"""Changes to the default randomization, by name of the preset, for the built-in robot. In all of them the start of an
episode is random; with `none`, nothing else is."""


def preset_values(name: object, robot: Robot = MINI_QUADRUPED) -> dict[str, Plain]:
    """Return the values of a preset as plain values, in the units of the robot.

    Raises:
        QuadrupedError: if there is no such preset.
    """
    rule = f"one of {', '.join(PRESETS)}, or ranges such as {{'friction': [0.5, 1.0]}}"
    check(isinstance(name, str) and name in PRESETS, "config.randomization", name, rule)
    units: dict[str, Plain] = {entry.name: entry.scale(robot) for entry in RANDOMIZATIONS}
    units |= {times[0]: "s" for entry in RANDOMIZATIONS for times in (entry.interval, entry.duration) if times}
    values: dict[str, Plain] = plain(scaled_values(PRESETS[str(name)], units, robot))
    return values


def with_preset(values: Plain, robot: Robot) -> Plain:
    """Return the values of the section with the preset in place that they name, by itself or in the field `preset`.

    Raises:
        QuadrupedError: if there is no such preset.
    """
    if isinstance(values, str):
        return preset_values(values, robot)
    if isinstance(values, Mapping) and PRESET in values:
        changes = {field: value for field, value in values.items() if field != PRESET}
        return {**preset_values(values[PRESET], robot), **changes}
    return values
