"""The named readings of a robot, simulated or measured: the only thing that observations and rewards may read of it."""

from dataclasses import dataclass, fields
from typing import Final, Self

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.robot import Robot

Floats = NDArray[np.float64]

_FOOT_VECTORS: Final = ("foot_position", "foot_velocity", "foot_angular_velocity")


def sensor_names(robot: Robot) -> dict[str, tuple[str, ...]]:
    """Field of `Readings` -> the model's sensors that make it up, in order."""
    joints = [name.removesuffix("_joint") for name in robot.joint_names]
    feet = [f"{leg}_foot" for leg in robot.leg_names]
    return {
        "joint_position": tuple(f"{joint}_position" for joint in joints),
        "joint_velocity": tuple(f"{joint}_velocity" for joint in joints),
        "joint_torque": tuple(f"{joint}_torque" for joint in joints),
        "orientation": ("imu_orientation",),
        "angular_velocity_b": ("imu_angular_velocity",),
        "linear_acceleration_b": ("imu_linear_acceleration",),
        "foot_force": tuple(f"{foot}_force" for foot in feet),
        "trunk_force": ("base_contact_force", *(f"{leg}_hip_contact_force" for leg in robot.leg_names)),
        "base_position": ("base_position",),
        "up_b": ("world_up",),
        "linear_velocity_b": ("base_linear_velocity",),
        "foot_position": tuple(f"{foot}_position" for foot in feet),
        "foot_velocity": tuple(f"{foot}_velocity" for foot in feet),
        "foot_angular_velocity": tuple(f"{foot}_angular_velocity" for foot in feet),
    }


def sensor_columns(model: mujoco.MjModel, robot: Robot) -> dict[str, slice]:
    """Field of `Readings` -> its columns of the model's sensor data."""
    columns = {}
    address, width = model.sensor_adr.tolist(), model.sensor_dim.tolist()
    for field, sensors in sensor_names(robot).items():
        ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, sensor) for sensor in sensors]
        start = stop = address[ids[0]]
        for sensor, i in zip(sensors, ids, strict=True):
            # A view needs one contiguous run; the model lists each group together and in joint or leg order.
            assert i >= 0, f"the model has no sensor {sensor!r}"
            assert address[i] == stop, f"sensor {sensor!r} does not follow its group"
            stop += width[i]
        columns[field] = slice(start, stop)
    return columns


@dataclass(frozen=True, slots=True)
class Readings:
    """Readings of N robots with J joints and L legs, at the end of a control step.

    A simulation's are live views of its sensors, never copies. `_b` is the body frame of the base, everything else the
    world frame. Positions and velocities are current. Torques, forces and accelerations belong to the last physics
    substep: MuJoCo knows them only after it has solved that substep's contacts.
    """

    joint_position: Floats
    """rad, (N, J)"""
    joint_velocity: Floats
    """rad/s, (N, J)"""
    joint_torque: Floats
    """Motor torque, N m, (N, J)"""
    orientation: Floats
    """Quaternion wxyz of the base, (N, 4)"""
    angular_velocity_b: Floats
    """rad/s, (N, 3)"""
    linear_acceleration_b: Floats
    """Specific force as an accelerometer measures it, m/s^2, (N, 3)"""
    foot_force: Floats
    """Normal force on each foot, N, (N, L)"""
    trunk_force: Floats
    """Normal force on the base and on each hip, N, (N, 1 + L)"""
    base_position: Floats
    """m, (N, 3)"""
    up_b: Floats
    """The world's up direction seen from the base, (N, 3); projected gravity is its negative"""
    linear_velocity_b: Floats
    """m/s, (N, 3)"""
    foot_position: Floats
    """Centre of each foot's ball, m, (N, L, 3)"""
    foot_velocity: Floats
    """Velocity of that centre, m/s, (N, L, 3)"""
    foot_angular_velocity: Floats
    """Angular velocity of the leg, rad/s, (N, L, 3)"""

    @classmethod
    def from_sensordata(cls, model: mujoco.MjModel, sensordata: Floats, robot: Robot) -> Self:
        """Views into sensordata (N, model.nsensordata), named as the model names its sensors."""
        views = {}
        for field, columns in sensor_columns(model, robot).items():
            view = sensordata[:, columns]
            views[field] = view.reshape(len(view), robot.num_legs, 3) if field in _FOOT_VECTORS else view
        return cls(**views)

    @classmethod
    def of_a_real_robot(cls, robot: Robot) -> Self:
        """Readings of one robot at rest in its stance, to be overwritten by what it measures.

        Joints, attitude and angular velocity are measured; everything else is NaN, so that nothing is computed from it
        unnoticed.
        """
        shapes = {
            "orientation": (4,),
            "foot_force": (robot.num_legs,),
            "trunk_force": (1 + robot.num_legs,),
            **dict.fromkeys(_FOOT_VECTORS, (robot.num_legs, 3)),
        }
        views = {}
        for field in fields(cls):
            shape = (robot.num_joints,) if field.name.startswith("joint") else shapes.get(field.name, (3,))
            views[field.name] = np.full((1, *shape), np.nan)
        views["joint_position"][:] = robot.stance
        views["joint_velocity"][:] = 0.0
        views["orientation"][:] = (1.0, 0.0, 0.0, 0.0)
        views["up_b"][:] = (0.0, 0.0, 1.0)
        views["angular_velocity_b"][:] = 0.0
        return cls(**views)
