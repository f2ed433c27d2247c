"""Named readings of a simulated or real robot: the only source of robot data for observations and rewards."""

import math
from dataclasses import dataclass, fields
from typing import Final, Self

import mujoco
import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import check, check_names

_FOOT_VECTORS: Final = ("foot_position", "foot_velocity", "foot_angular_velocity")


def sensor_columns(model: mujoco.MjModel, robot: Robot) -> dict[str, slice]:
    """Return the columns of the model's sensor data for each field of `Readings`.

    Raises:
        QuadrupedError: if the robot names no sensors for a field, or for an unknown one, or the model lacks a sensor,
            or has them in another order, or they have more or fewer values than the field.
    """
    shapes = _shapes(robot)
    columns, of = {}, f"robot {robot.name!r}: sensors"
    if missing := [field for field in shapes if not robot.sensor_names.get(field)]:
        raise QuadrupedError(f"{of}: missing {', '.join(missing)}; name the sensors of the model for each")
    check_names(robot.sensor_names, shapes, of)
    address, width = model.sensor_adr.tolist(), model.sensor_dim.tolist()
    for field, sensors in robot.sensor_names.items():
        ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, sensor) for sensor in sensors]
        start = stop = address[max(ids[0], 0)]
        for sensor, i in zip(sensors, ids, strict=True):
            # A view must be contiguous: the model lists the sensors of a group together, in joint or leg order.
            if i < 0 or address[i] != stop:
                raise QuadrupedError(
                    f"robot {robot.name!r}: sensor {sensor!r} of {field} "
                    f"{'is missing in the model' if i < 0 else 'must follow the one before it in the model'}"
                )
            stop += width[i]
        size = math.prod(shapes[field])
        check(stop - start == size, f"{of} of {field}", sensors, f"sensors with {size} values, not {stop - start}")
        columns[field] = slice(start, stop)
    return columns


@dataclass(frozen=True, slots=True)
class Readings:
    """Readings of N robots with J joints and L legs, at the end of a control step.

    The readings of a simulation are live views of its sensor data, not copies. Names with `_b` are in the body frame of
    the base, all others in the world frame. Positions and velocities are current. Torques, forces and accelerations are
    taken in the last physics substep, because MuJoCo computes them when it solves the contacts of a substep.
    """

    joint_position: Floats
    """Joint positions, (N, J), rad."""
    joint_velocity: Floats
    """Joint velocities, (N, J), rad/s."""
    joint_torque: Floats
    """Motor torques, (N, J), N m."""
    orientation: Floats
    """Quaternion wxyz of the base, (N, 4)."""
    angular_velocity_b: Floats
    """Angular velocity of the base, (N, 3), rad/s."""
    linear_acceleration_b: Floats
    """Specific force, as measured by an accelerometer, (N, 3), m/s^2."""
    foot_force: Floats
    """Normal force on each foot, (N, L), N."""
    trunk_force: Floats
    """Normal forces on the base and on each hip, (N, 1 + L), N."""
    base_position: Floats
    """Position of the base's centre, (N, 3), m."""
    up_b: Floats
    """Unit vector of the world's up axis in the body frame, (N, 3); projected gravity is its negative."""
    linear_velocity_b: Floats
    """Linear velocity of the base, (N, 3), m/s."""
    foot_position: Floats
    """Position of the centre of each foot's ball, (N, L, 3), m."""
    foot_velocity: Floats
    """Velocity of the centre of each foot's ball, (N, L, 3), m/s."""
    foot_angular_velocity: Floats
    """Angular velocity of each leg, (N, L, 3), rad/s."""

    @classmethod
    def from_sensordata(cls, model: mujoco.MjModel, sensordata: Floats, robot: Robot) -> Self:
        """Return readings as views of sensordata (..., model.nsensordata), with its leading axes instead of N."""
        views = {}
        for field, columns in sensor_columns(model, robot).items():
            view = sensordata[..., columns]
            views[field] = view.reshape(*view.shape[:-1], robot.num_legs, 3) if field in _FOOT_VECTORS else view
        return cls(**views)

    @classmethod
    def of_a_real_robot(cls, robot: Robot) -> Self:
        """Return readings of one robot at rest in its stance, to be overwritten with its measurements.

        A real robot measures joint positions, joint velocities, attitude and angular velocity. All other readings are
        NaN, so that a value computed from them is noticed.
        """
        views = {field: np.full((1, *shape), np.nan) for field, shape in _shapes(robot).items()}
        views["joint_position"][:] = robot.stance
        views["joint_velocity"][:] = 0.0
        views["orientation"][:] = (1.0, 0.0, 0.0, 0.0)
        views["up_b"][:] = (0.0, 0.0, 1.0)
        views["angular_velocity_b"][:] = 0.0
        return cls(**views)


def _shapes(robot: Robot) -> dict[str, tuple[int, ...]]:
    """Return the shape of each reading of one robot, by its field of `Readings`."""
    shapes = {
        "orientation": (4,),
        "foot_force": (robot.num_legs,),
        "trunk_force": (1 + robot.num_legs,),
        **dict.fromkeys(_FOOT_VECTORS, (robot.num_legs, 3)),
    }
    joints = (robot.num_joints,)
    names = [entry.name for entry in fields(Readings)]
    return {name: joints if name.startswith("joint") else shapes.get(name, (3,)) for name in names}
