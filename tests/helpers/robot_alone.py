"""A control step of the robot by MuJoCo alone, without the package's simulation and readings."""

import mujoco
import numpy as np

LEGS = ("LF", "RF", "LH", "RH")
FOOT = np.array([0.0, 0.0, -0.14])
"""Centre of the foot's ball in the frame of its leg, m."""
FOOT_SITE = 0.025
"""Distance from that centre within which contacts press on the foot's sensor, m."""


class RobotAlone:
    """A copy of an env's robot, which MuJoCo steps alone."""

    def __init__(self, model):
        self.model, self.data = model, mujoco.MjData(model)
        self._geoms = {model.geom(i).name: i for i in range(model.ngeom)}
        self._feet = [model.body(f"{leg}_leg").id for leg in LEGS]

    def step(self, before, target):
        """One control step with joint targets (8,), from the data before it.

        `substeps` has torques, joint velocities, foot forces and motions of the feet at the beginning of each physics
        step.
        """
        data = self.data
        mujoco.mj_copyData(data, self.model, before)
        data.ctrl = target
        self.substeps = []
        for _ in range(4):
            speeds = data.qvel[6:].copy()
            mujoco.mj_step(self.model, data)
            # Of the beginning of the physics step, as all but positions and velocities of the joints.
            self.torque = data.actuator_force.copy()
            self._forces = self._normal_forces()
            motion = [self.foot(leg)[1:] for leg in range(4)]
            self.substeps.append((self.torque, speeds, self.foot_force(), motion))
        mujoco.mj_kinematics(self.model, data)
        mujoco.mj_comPos(self.model, data)
        mujoco.mj_comVel(self.model, data)
        self.turn = rotation(data.qpos[3:7])
        self.up = self.turn[2]
        self.velocity, self.rates = self.turn.T @ data.qvel[:3], data.qvel[3:6].copy()
        self.position, self.joints, self.speeds = data.qpos[:3].copy(), data.qpos[7:].copy(), data.qvel[6:].copy()

    def _normal_forces(self):
        """Geom -> normal force on the ground, N; of a leg, from contacts near its foot only."""
        forces, wrench = {}, np.zeros(6)
        ground = self._geoms["ground"]
        for i, contact in enumerate(self.data.contact):
            if ground not in contact.geom:
                continue
            other = self.model.geom(contact.geom[contact.geom != ground][0])
            if other.name.endswith("_leg_collision"):
                leg = self.data.body(other.name.removesuffix("_collision"))
                if np.linalg.norm(contact.pos - leg.xpos - leg.xmat.reshape(3, 3) @ FOOT) > FOOT_SITE:
                    continue
            mujoco.mj_contactForce(self.model, self.data, i, wrench)
            forces[other.name] = forces.get(other.name, 0.0) + wrench[0]
        return forces

    def foot_force(self):
        return np.array([self._forces.get(f"{leg}_leg_collision", 0.0) for leg in LEGS])

    def trunk_force(self):
        return [self._forces.get(name, 0.0) for name in ("base_collision", *(f"{leg}_hip_collision" for leg in LEGS))]

    def foot(self, leg):
        """Centre of a foot's ball, its velocity and its leg's angular velocity, in the world."""
        body, motion = self._feet[leg], np.zeros(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_XBODY, body, motion, 0)
        arm = self.data.xmat[body].reshape(3, 3) @ FOOT
        return self.data.xpos[body] + arm, motion[3:] + np.cross(motion[:3], arm), motion[:3]


def rotation(quaternion):
    """Matrix (3, 3) from the base's frame to the world's."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
