"""The named readings of a simulation: the only thing that a task's terms may read."""

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import JOINT_NAMES, LEG_NAMES

_JOINTS = tuple(name.removesuffix("_joint") for name in JOINT_NAMES)
_FEET = tuple(f"{leg}_foot" for leg in LEG_NAMES)

SENSORS: dict[str, tuple[str, ...]] = {
    "joint_position": tuple(f"{joint}_position" for joint in _JOINTS),
    "joint_velocity": tuple(f"{joint}_velocity" for joint in _JOINTS),
    "joint_torque": tuple(f"{joint}_torque" for joint in _JOINTS),
    "orientation": ("imu_orientation",),
    "angular_velocity_b": ("imu_angular_velocity",),
    "linear_acceleration_b": ("imu_linear_acceleration",),
    "foot_force": tuple(f"{foot}_force" for foot in _FEET),
    "trunk_force": ("base_contact_force", *(f"{leg}_hip_contact_force" for leg in LEG_NAMES)),
    "base_position": ("base_position",),
    "up_b": ("world_up",),
    "linear_velocity_b": ("base_linear_velocity",),
    "foot_position": tuple(f"{foot}_position" for foot in _FEET),
    "foot_velocity": tuple(f"{foot}_velocity" for foot in _FEET),
    "foot_angular_velocity": tuple(f"{foot}_angular_velocity" for foot in _FEET),
}
"""Field of `State` -> the model's sensors that make it up, in order."""

_FOOT_VECTORS = ("foot_position", "foot_velocity", "foot_angular_velocity")


@dataclass(frozen=True, slots=True)
class State:
    """Readings of N simulations at the end of a control step; live views of the sensors, never copies.

    `_b` is the body frame of the base, everything else the world frame. Positions and velocities are current.
    Torques, forces and accelerations belong to the last physics substep: MuJoCo knows them only after it has
    solved that substep's contacts.

    Arrays are NumPy in this package; terms also take a State of torch tensors.
    """

    joint_position: Any
    """rad, (N, 8)"""
    joint_velocity: Any
    """rad/s, (N, 8)"""
    joint_torque: Any
    """Motor torque, N m, (N, 8)"""
    orientation: Any
    """Quaternion wxyz of the base, (N, 4)"""
    angular_velocity_b: Any
    """rad/s, (N, 3)"""
    linear_acceleration_b: Any
    """Specific force as an accelerometer measures it, m/s^2, (N, 3)"""
    foot_force: Any
    """Normal force on each foot, N, (N, 4)"""
    trunk_force: Any
    """Normal force on the base and on each hip, N, (N, 5)"""
    base_position: Any
    """m, (N, 3)"""
    up_b: Any
    """The world's up direction seen from the base, (N, 3); projected gravity is its negative"""
    linear_velocity_b: Any
    """m/s, (N, 3)"""
    foot_position: Any
    """Centre of each foot's ball, m, (N, 4, 3)"""
    foot_velocity: Any
    """Velocity of that centre, m/s, (N, 4, 3)"""
    foot_angular_velocity: Any
    """Angular velocity of the leg, rad/s, (N, 4, 3)"""

    @classmethod
    def from_sensordata(cls, model: mujoco.MjModel, sensordata: NDArray[np.float64]) -> "State":
        """Views into sensordata (N, model.nsensordata), named as the model names its sensors."""
        views = {}
        address, width = model.sensor_adr.tolist(), model.sensor_dim.tolist()
        for field, sensors in SENSORS.items():
            ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, sensor) for sensor in sensors]
            start = stop = address[ids[0]]
            for sensor, i in zip(sensors, ids, strict=True):
                # A view needs one contiguous run; the model lists each group together and in joint or leg order.
                assert i >= 0, f"the model has no sensor {sensor!r}"
                assert address[i] == stop, f"sensor {sensor!r} does not follow its group"
                stop += width[i]
            view = sensordata[:, start:stop]
            views[field] = view.reshape(len(view), len(LEG_NAMES), 3) if field in _FOOT_VECTORS else view
        return cls(**views)
