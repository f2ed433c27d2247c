"""A robot in Drake, built from its URDF alone."""

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray
from pydrake.geometry import HalfSpace, ProximityProperties, RoleAssign
from pydrake.math import RigidTransform
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlant, CoulombFriction, MultibodyPlantConfig
from pydrake.systems.framework import DiagramBuilder

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.motors import MotorConfig
from quadruped_env.robot.robot import Robot
from second_engine.engines import Contact


@dataclass(frozen=True)
class DrakeModel:
    """A robot on level ground, with the places of its joints in Drake's vectors."""

    diagram: Any
    plant: Any
    bodies: dict[str, Any]
    """Body of each link"""
    base_name: str
    base_position: slice
    """Quaternion wxyz and position of the base, in the plant's positions"""
    base_velocity: slice
    """Angular and linear velocity of the base in the world frame, in the plant's velocities"""
    joint_position: NDArray[np.intp]
    """Place of each joint (J,) in the plant's positions"""
    joint_velocity: NDArray[np.intp]
    """Place of each joint (J,) in the plant's velocities"""
    actuator: NDArray[np.intp]
    """Place of each joint (J,) in the plant's actuation"""

    @classmethod
    def build(cls, robot: Robot, motors: MotorConfig, timestep: float, contact: Contact) -> Self:
        """Build a robot from its URDF, on a half space.

        Motors that differ from the robot's replace the URDF's passive joint torques and rotors. The time step is in s;
        all links and the ground have the same contact model.

        Raises:
            QuadrupedError: if Drake cannot read the URDF, or it lacks a link, a joint or an actuator of the robot.
        """
        builder = DiagramBuilder()
        plant, scene = AddMultibodyPlant(
            MultibodyPlantConfig(
                time_step=timestep, contact_model="point", discrete_contact_approximation=contact.approximation
            ),
            builder,
        )
        with errors_only():
            try:
                Parser(plant).AddModelsFromString(robot.description, "urdf")
            except RuntimeError as error:
                raise QuadrupedError(
                    f"robot {robot.name!r}: Drake cannot read its URDF ({short(str(error))}); give one that a ROS "
                    f"program can read, too"
                ) from error
            _check_names(plant, robot)
            ground = _with_contact(ProximityProperties(), contact)
            plant.RegisterCollisionGeometry(plant.world_body(), RigidTransform(), HalfSpace(), "ground", ground)
            _set_contact(plant, scene, robot, contact)
            if motors != robot.motors:
                _write(plant, robot, motors)
            plant.Finalize()
            diagram = builder.Build()
        bodies = {name: plant.GetBodyByName(name) for name in robot.link_names}
        joints = [plant.GetJointByName(name) for name in robot.joint_names]
        actuators = {actuator.joint().name(): actuator for actuator in _actuators(plant)}
        base = bodies[robot.base_name]
        position, velocity = base.floating_positions_start(), base.floating_velocities_start_in_v()
        return cls(
            diagram,
            plant,
            bodies,
            robot.base_name,
            slice(position, position + 7),
            slice(velocity, velocity + 6),
            np.array([joint.position_start() for joint in joints]),
            np.array([joint.velocity_start() for joint in joints]),
            np.array([actuators[name].input_start() for name in robot.joint_names]),
        )


def _actuators(plant: Any) -> list[Any]:
    return [plant.get_joint_actuator(index) for index in plant.GetJointActuatorIndices()]


def _check_names(plant: Any, robot: Robot) -> None:
    actuated = {actuator.joint().name() for actuator in _actuators(plant)}
    for names, present, what, where in (
        (robot.link_names, plant.HasBodyNamed, "link", "<link>"),
        (robot.joint_names, plant.HasJointNamed, "joint", "<joint>"),
        (robot.joint_names, actuated.__contains__, "actuator for the joint", "<transmission>"),
    ):
        for name in names:
            if not present(name):
                raise QuadrupedError(
                    f"robot {robot.name!r}: its URDF has no {what} {name!r}, which the robot has; add it as a {where}"
                )


def _set_contact(plant: Any, scene: Any, robot: Robot, contact: Contact) -> None:
    """Set the contact model of every link. Drake's parser gives a friction of 1 to links without one."""
    inspector, source = scene.model_inspector(), plant.get_source_id()
    for link in robot.link_names:
        for geometry in plant.GetCollisionGeometriesForBody(plant.GetBodyByName(link)):
            properties = _with_contact(ProximityProperties(inspector.GetProximityProperties(geometry)), contact)
            scene.AssignRole(source, geometry, properties, RoleAssign.kReplace)


def _with_contact(properties: Any, contact: Contact) -> Any:
    coefficients = CoulombFriction(contact.friction, contact.friction)
    properties.UpdateProperty("material", "coulomb_friction", coefficients)
    properties.UpdateProperty("material", "relaxation_time", contact.relaxation_time)
    return properties


def _write(plant: Any, robot: Robot, motors: MotorConfig) -> None:
    """Put the passive joint torques and rotors of motors into a robot; dry friction has no place in Drake's joints."""
    of_joints = dict(zip(robot.joint_names, motors.of_joints(robot.joint_kinds), strict=True))
    for actuator in _actuators(plant):
        motor = of_joints[actuator.joint().name()]
        actuator.joint().set_default_damping(motor.damping)
        actuator.set_default_rotor_inertia(motor.armature / actuator.default_gear_ratio() ** 2)


@contextmanager
def errors_only() -> Iterator[None]:
    """Without Drake's warning that half spaces do not touch deformable bodies, of which there are none."""
    log = logging.getLogger("drake")
    level = log.level
    log.setLevel(logging.ERROR)
    try:
        yield
    finally:
        log.setLevel(level)
