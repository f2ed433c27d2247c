"""Simulation of robots in Drake, behind the interface of the simulations here."""

from typing import Final, NoReturn

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.readings import Readings, sensor_columns
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.simulation.simulation_interface import SimulationState
from quadruped_env.task import TaskConfig
from quadruped_env.utils import rotations
from quadruped_env.utils.arrays import EnvIds, Floats
from second_engine.drake_model import DrakeModel
from second_engine.drake_robot import DrakeRobot
from second_engine.engines import Contact
from second_engine.servos import Servos
from second_engine.sites import Site

_GRAVITY: Final = np.array([0.0, 0.0, -9.81])


class DrakeSimulation:
    """`Simulation` of N robots in Drake, on level ground; all share one diagram, and each has its context.

    The motors are `Servos`. The readings mean what they mean in the simulations here: positions, velocities and the
    accelerometer belong to the sensors' sites, and a touch sensor adds up the normal forces on its link within its
    zone.

    Raises:
        QuadrupedError: if the task's ground is not level, or the URDF describes another robot than the task's.
    """

    height_field: HeightField | None = None

    def __init__(self, config: TaskConfig, num_envs: int, timestep: float, contact: Contact) -> None:
        if config.ground.heights().any():
            raise QuadrupedError(
                f"Drake: the ground is level in Drake; found a task on the terrain {config.terrain['name']!r}: "
                f"put it on level ground with config.on_terrain('flat')"
            )
        self.robot = robot = config.robot
        self.model = model = config.compiled_model()
        self.num_envs = num_envs
        self.timestep = timestep
        self._substep = config.physics_timestep
        self._drake = DrakeModel.build(robot, config.motor, timestep, contact)
        self.robots = [DrakeRobot(self._drake) for _ in range(num_envs)]
        self._servos = Servos(config.motor, robot.joint_kinds, timestep, num_envs)
        self._joint_position = np.zeros((num_envs, robot.num_joints))
        self._joint_velocity = np.zeros((num_envs, robot.num_joints))
        self._torque = np.zeros((num_envs, robot.num_joints))
        self._failed = np.zeros(num_envs, dtype=np.bool_)
        self.sensordata = np.zeros((num_envs, model.nsensordata))
        self.sensor_columns = sensor_columns(model, robot)
        self.readings = Readings.from_sensordata(model, self.sensordata, robot)
        self._record(1)
        self._imu = Site.of_sensor(model, robot.sensor_names["base_position"][0])
        self._feet, self._foot_zones, self._trunk_zones = (
            [Site.of_sensor(model, name) for name in robot.sensor_names[field]]
            for field in ("foot_position", "foot_force", "trunk_force")
        )

    def step(self, joint_target: Floats, substeps: int, env_ids: EnvIds | None = None) -> None:
        """See `Simulation.step`."""
        running = np.arange(self.num_envs) if env_ids is None else env_ids
        steps = self._steps_in(substeps)
        if substeps != len(self._recorded):
            self._record(substeps)
        # Drake's step in which each physics step of the task begins; it may be the same one for several.
        begins = np.arange(substeps) * steps // substeps
        for step in range(steps):
            running = running[~self._failed[running]]
            begun = np.flatnonzero(begins == step)
            if len(begun):
                for i in running if step else ():
                    self._read(i)
                self._recorded[np.ix_(begun, running)] = self.sensordata[running]
            torque = self._servos.torque(joint_target, self._joint_position, self._joint_velocity)
            friction = self._servos.friction(self._joint_velocity) if self._servos.has_friction else None
            for i in running:
                try:
                    self.robots[i].step(torque[i], None if friction is None else friction[i])
                except RuntimeError:  # Drake's solver has not converged, or its result is NaN
                    self._failed[i] = True
                    continue
                self._torque[i] = torque[i]
                self._joint_position[i], self._joint_velocity[i] = self.robots[i].joints()
        for i in running[~self._failed[running]]:
            self._read(i)

    def _record(self, substeps: int) -> None:
        """Make room for the readings of a number of physics steps."""
        self._recorded = np.zeros((substeps, *self.sensordata.shape))
        self.substeps = Readings.from_sensordata(self.model, self._recorded, self.robot)

    def _steps_in(self, substeps: int) -> int:
        """Return the steps of Drake in a number of physics steps of the task."""
        exact = substeps * self._substep / self.timestep
        steps = round(exact)
        if abs(steps - exact) > 1e-6:
            raise QuadrupedError(
                f"Drake: {substeps} physics steps of {self._substep:g} s are not a whole number of Drake's steps of "
                f"{self.timestep:g} s; step by whole control steps"
            )
        return steps

    def reset(self, env_ids: EnvIds, qpos: Floats, qvel: Floats) -> None:
        """See `Simulation.reset`."""
        self._failed[env_ids] = False
        self._torque[env_ids] = 0.0
        self._joint_position[env_ids], self._joint_velocity[env_ids] = qpos[:, 7:], qvel[:, 6:]
        self._servos.reset(env_ids, qpos[:, 7:])
        for i, pose, velocity in zip(env_ids, qpos, qvel, strict=True):
            # MuJoCo's angular velocity is in the body frame.
            base_velocity = np.concatenate([velocity[:3], rotations.rotate(pose[3:7], velocity[3:6])])
            # A new one, because the old one's contacts of its last step would be read again.
            self.robots[i] = DrakeRobot(self._drake)
            self.robots[i].set_state(pose[:7], base_velocity, pose[7:], velocity[6:])
            self._read(i)

    def _read(self, env_id: int) -> None:
        """Write the readings of a robot."""
        robot, readings = self.robots[env_id], self.readings
        imu = self._imu.motion(robot)
        orientation = rotations.multiply(robot.orientation(), self._imu.quaternion)
        readings.joint_position[env_id], readings.joint_velocity[env_id] = robot.joints()
        readings.joint_torque[env_id] = self._torque[env_id]
        readings.orientation[env_id] = orientation
        readings.up_b[env_id] = rotations.up_in_body(orientation)
        readings.base_position[env_id] = imu.position
        readings.linear_velocity_b[env_id] = rotations.rotate_inverse(orientation, imu.linear_velocity)
        readings.angular_velocity_b[env_id] = rotations.rotate_inverse(orientation, imu.angular_velocity)
        readings.linear_acceleration_b[env_id] = rotations.rotate_inverse(
            orientation, self._imu.acceleration(robot) - _GRAVITY
        )
        for leg, site in enumerate(self._feet):
            foot = site.motion(robot)
            readings.foot_position[env_id, leg] = foot.position
            readings.foot_velocity[env_id, leg] = foot.linear_velocity
            readings.foot_angular_velocity[env_id, leg] = foot.angular_velocity
        touches = robot.touches()
        for zones, forces in ((self._foot_zones, readings.foot_force), (self._trunk_zones, readings.trunk_force)):
            forces[env_id] = [
                sum(touch.normal_force for touch in touches if zone.holds(robot, touch.link, touch.point))
                for zone in zones
            ]

    def diverged(self) -> NDArray[np.bool_]:
        """See `Simulation.diverged`."""
        return self._failed | ~np.isfinite(self.sensordata).all(axis=1)

    def push(self, env_ids: EnvIds, velocity: Floats) -> None:
        """See `Simulation.push`."""
        for i, added in zip(env_ids, velocity, strict=True):
            self.robots[i].push(added)

    def set_force(self, env_ids: EnvIds, force: Floats) -> None:
        """See `Simulation.set_force`."""
        for i, applied in zip(env_ids, force, strict=True):
            self.robots[i].set_force(applied)

    def restore_model_fields(self, env_ids: EnvIds) -> None:
        """See `Simulation.restore_model_fields`; no field is ever changed."""

    def model_field(self, name: str) -> Floats:
        """Refused with a QuadrupedError: the robot in Drake does not follow MuJoCo's model."""
        raise QuadrupedError(
            f"Drake: a randomization of MuJoCo's {name!r} does not reach the robot in Drake; run the task without "
            f"it, as config.randomized('none') does"
        )

    def compiled_field(self, name: str) -> Floats:
        """See `Simulation.compiled_field`."""
        values: Floats = getattr(self.model, name)
        return values

    def field_values(self, name: str) -> Floats:
        """See `Simulation.field_values`."""
        return self.compiled_field(name)[None]

    def get_state(self, env_id: int) -> SimulationState:
        """Refused: see `model_field`."""
        self._refuse_state()

    def set_state(self, env_id: int, state: SimulationState) -> None:
        """Refused: see `model_field`."""
        self._refuse_state()

    def _refuse_state(self) -> NoReturn:
        raise QuadrupedError("Drake: states of robots in Drake are not saved; run the episode from its start")
