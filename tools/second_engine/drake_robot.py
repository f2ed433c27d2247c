"""One robot in Drake: its state, its motors' torques, and what can be measured on it."""

from typing import Any, NamedTuple

import numpy as np
from pydrake.multibody.math import SpatialForce
from pydrake.multibody.plant import ExternallyAppliedSpatialForce
from pydrake.systems.analysis import Simulator

from quadruped_env.utils import rotations
from quadruped_env.utils.arrays import Floats
from second_engine.drake_model import DrakeModel, errors_only


class BodyState(NamedTuple):
    """Motion of a link in the world frame."""

    position: Floats
    """Origin of the link (3,), m."""
    rotation: Floats
    """Rotation matrix (3, 3) from the link's frame to the world's."""
    angular_velocity: Floats
    """Angular velocity (3,), rad/s."""
    linear_velocity: Floats
    """Velocity of the origin (3,), m/s."""


class Touch(NamedTuple):
    """A contact on a link."""

    link: str
    point: Floats
    """Point of contact in the world frame (3,), m."""
    normal_force: float
    """Normal force, N."""


class DrakeRobot:
    """A context of the robot's diagram.

    Args:
        model: diagram, which several robots share.
    """

    def __init__(self, model: DrakeModel) -> None:
        self._model = model
        self.plant = plant = model.plant
        """Drake's robot, common to all contexts"""
        with errors_only():
            self._simulator = Simulator(model.diagram, model.diagram.CreateDefaultContext())
            self._simulator.Initialize()
        self.context = plant.GetMyMutableContextFromRoot(self._simulator.get_mutable_context())
        """State and inputs of this robot"""
        self._actuation = plant.get_actuation_input_port().FixValue(self.context, np.zeros(plant.num_actuators()))
        self._generalized = plant.get_applied_generalized_force_input_port().FixValue(
            self.context, np.zeros(plant.num_velocities())
        )
        self._links = {body.index(): name for name, body in model.bodies.items()}
        self._timestep = float(plant.time_step())
        self._steps = 0

    def set_state(self, base_pose: Floats, base_velocity: Floats, position: Floats, velocity: Floats) -> None:
        """Set the state before the first step.

        Position and quaternion wxyz of the base (7,), its linear and angular velocity in the world frame (6,), and
        joint positions and velocities (J,).
        """
        model, plant = self._model, self.plant
        q, v = np.zeros(plant.num_positions()), np.zeros(plant.num_velocities())
        q[model.base_position] = np.concatenate([base_pose[3:], base_pose[:3]])
        v[model.base_velocity] = np.concatenate([base_velocity[3:], base_velocity[:3]])
        q[model.joint_position], v[model.joint_velocity] = position, velocity
        plant.SetPositions(self.context, q)
        plant.SetVelocities(self.context, v)

    def step(self, torque: Floats, friction: Floats | None = None) -> None:
        """Advance by one step of Drake, with torques of the motors (J,) and of dry friction (J,), N m.

        Raises:
            RuntimeError: if Drake's solver fails.
        """
        actuation = np.empty(len(torque))
        actuation[self._model.actuator] = torque
        self._actuation.GetMutableData().get_mutable_value().SetFromVector(actuation)
        if friction is not None:
            generalized = np.zeros(self.plant.num_velocities())
            generalized[self._model.joint_velocity] = friction
            self._generalized.GetMutableData().get_mutable_value().SetFromVector(generalized)
        self._steps += 1
        self._simulator.AdvanceTo(self._steps * self._timestep)

    def joints(self) -> tuple[Floats, Floats]:
        """Return the positions in rad and velocities in rad/s of the joints, (J,) each."""
        position = self.plant.GetPositions(self.context)[self._model.joint_position]
        return position, self.plant.GetVelocities(self.context)[self._model.joint_velocity]

    def orientation(self) -> Floats:
        """Return the unit quaternion wxyz of the base (4,)."""
        quaternion = self.plant.GetPositions(self.context)[self._model.base_position][:4]
        return quaternion / np.linalg.norm(quaternion)

    def body(self, link: str) -> BodyState:
        """Return the motion of a link."""
        body = self._model.bodies[link]
        pose = body.EvalPoseInWorld(self.context)
        velocity = body.EvalSpatialVelocityInWorld(self.context)
        return BodyState(pose.translation(), pose.rotation().matrix(), velocity.rotational(), velocity.translational())

    def acceleration(self, link: str) -> tuple[Floats, Floats]:
        """Return a link's angular and linear acceleration (3,) in the last step, world frame, rad/s^2 and m/s^2."""
        accelerations = self.plant.get_body_spatial_accelerations_output_port().Eval(self.context)
        found = accelerations[self._model.bodies[link].index()]
        return found.rotational(), found.translational()

    def touches(self) -> list[Touch]:
        """Return the contacts of the robot's links in the last step, one entry for each of the two links that touch."""
        results = self.plant.get_contact_results_output_port().Eval(self.context)
        found = []
        for i in range(results.num_point_pair_contacts()):
            contact = results.point_pair_contact_info(i)
            force = abs(float(contact.contact_force() @ contact.point_pair().nhat_BA_W))
            for index in (contact.bodyA_index(), contact.bodyB_index()):
                if index in self._links:
                    found.append(Touch(self._links[index], contact.contact_point(), force))
        return found

    def push(self, velocity: Floats) -> None:
        """Add a velocity to the base: in the world frame, m/s (3,), or with that about the body's axes, rad/s (6,)."""
        v = self.plant.GetVelocities(self.context)
        base = v[self._model.base_velocity]
        base[3:] += velocity[:3]
        if len(velocity) > 3:
            base[:3] += rotations.rotate(self.orientation(), velocity[3:])
        self.plant.SetVelocities(self.context, v)

    def set_force(self, force: Floats) -> None:
        """Apply a force (3,) in the world frame at the centre of mass of the base, in N, until the next call."""
        applied = ExternallyAppliedSpatialForce()
        base = self._model.bodies[self._model.base_name]
        applied.body_index = base.index()
        applied.p_BoBq_B = base.CalcCenterOfMassInBodyFrame(self.context)
        torque: Any = np.zeros(3)
        linear: Any = np.asarray(force, dtype=np.float64)
        applied.F_Bq_W = SpatialForce(torque, linear)
        self.plant.get_applied_spatial_force_input_port().FixValue(self.context, [applied])
