"""The second robot with other names, and with other motors in its knees than in its hips."""

import dataclasses

import second_robot

from quadruped_env.robot import JointMotor, MotorConfig, Robot

LEGS = {"RH": "back_right", "LH": "back_left", "RF": "front_right", "LF": "front_left"}
MOTORS = MotorConfig(
    hip=JointMotor(stall_torque=14.0, no_load_speed=7.0, kp=70.0, kd=1.5),
    knee=JointMotor(stall_torque=12.0, no_load_speed=6.0, kp=60.0, kd=1.5),
)


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


ROBOT = renamed(dataclasses.replace(second_robot.DESIGN, name="renamed", motors=MOTORS).robot(), LEGS)
