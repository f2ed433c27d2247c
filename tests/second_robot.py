"""A second robot for tests: other names, order of legs, lengths, masses, limits and motors than the built-in one."""

import dataclasses

from quadruped_env.robot import JointMotor, MotorConfig, QuadrupedDesign, Robot

DESIGN = QuadrupedDesign(
    name="second",
    leg_names=("RH", "LH", "RF", "LF"),
    leg_length=0.19,
    hip_offset=(0.17, 0.11),
    base_mass=2.8,
    leg_mass=0.24,
    leg_radius=0.022,
    hip_range=(-1.4, 1.3),
    knee_range=(-2.1, 0.1),
    stance_angles=(0.55, -0.68),
    motors=MotorConfig(
        hip=JointMotor(stall_torque=14.0, no_load_speed=7.0, kp=50.0, kd=1.2),
        knee=JointMotor(stall_torque=12.0, no_load_speed=6.0, kp=45.0),
    ),
)
LEGS = {"RH": "back_right", "LH": "back_left", "RF": "front_right", "LF": "front_left"}


def renamed(robot: Robot, names: dict[str, str]) -> Robot:
    """The robot with other names of its legs, and so of their joints, links, sites and sensors."""

    def other(text: str) -> str:
        for old, new in names.items():
            text = new if text == old else text.replace(f"{old}_", f"{new}_")
        return text

    def others(texts: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(map(other, texts))

    return dataclasses.replace(
        robot,
        **{name: others(getattr(robot, name)) for name in ("leg_names", "joint_names", "link_names", "foot_sites")},
        **{name: other(getattr(robot, name)) for name in ("mjcf", "urdf")},
        sensors={field: others(sensors) for field, sensors in robot.sensors.items()},
    )


ROBOT = renamed(DESIGN.robot(), LEGS)
