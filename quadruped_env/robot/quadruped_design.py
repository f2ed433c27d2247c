"""Builder of quadrupeds with two joints per leg: the built-in robot, and others with other numbers."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.robot import quadruped_files
from quadruped_env.robot.motors import JOINT_KINDS
from quadruped_env.robot.quadruped_dimensions import QuadrupedDimensions
from quadruped_env.robot.robot import Robot

_OTHER_SIDE: Final = {"L": "R", "R": "L"}


@dataclass(frozen=True)
class QuadrupedDesign(QuadrupedDimensions):
    """Dimensions of a quadruped, from which its robot is built.

    ROBOT = QuadrupedDesign(name="long_legs", leg_length=0.22, leg_mass=0.3).robot()
    """

    def robot(self) -> Robot:
        """The robot, with its MJCF and its URDF."""
        joints, legs = self.joint_names, self.leg_names
        motors = self.motors.of_joints(JOINT_KINDS * len(legs))
        return Robot(
            name=self.name,
            leg_names=legs,
            joint_names=joints,
            link_names=self.link_names,
            joint_position_low=np.array([self.hip_range[0], self.knee_range[0]] * len(legs)),
            joint_position_high=np.array([self.hip_range[1], self.knee_range[1]] * len(legs)),
            velocity_limit=np.array([motor.no_load_speed for motor in motors]),
            effort_limit=np.array([motor.stall_torque for motor in motors]),
            stance=np.array(self.stance_angles * len(legs)),
            stance_height=self.stance_height,
            foot_radius=self.leg_radius,
            foot_sites=tuple(f"{leg}_foot" for leg in legs),
            joint_mirror=_mirror(joints),
            foot_mirror=_mirror(legs),
            sensors=_sensors(joints, legs),
            motors=self.motors,
            mjcf=quadruped_files.mjcf(self),
            urdf=quadruped_files.urdf(self),
        )


def _mirror(names: tuple[str, ...]) -> tuple[int, ...]:
    return tuple(names.index(_OTHER_SIDE[name[0]] + name[1:]) for name in names)


def _sensors(joint_names: tuple[str, ...], legs: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    """Sensors of the MJCF for each field of `Readings`, in order."""
    joints = [name.removesuffix("_joint") for name in joint_names]
    return {
        "joint_position": tuple(f"{joint}_position" for joint in joints),
        "joint_velocity": tuple(f"{joint}_velocity" for joint in joints),
        "joint_torque": tuple(f"{joint}_torque" for joint in joints),
        "orientation": ("imu_orientation",),
        "angular_velocity_b": ("imu_angular_velocity",),
        "linear_acceleration_b": ("imu_linear_acceleration",),
        "foot_force": tuple(f"{leg}_foot_force" for leg in legs),
        "trunk_force": ("base_contact_force", *(f"{leg}_hip_contact_force" for leg in legs)),
        "base_position": ("base_position",),
        "up_b": ("world_up",),
        "linear_velocity_b": ("base_linear_velocity",),
        "foot_position": tuple(f"{leg}_foot_position" for leg in legs),
        "foot_velocity": tuple(f"{leg}_foot_velocity" for leg in legs),
        "foot_angular_velocity": tuple(f"{leg}_foot_angular_velocity" for leg in legs),
    }
