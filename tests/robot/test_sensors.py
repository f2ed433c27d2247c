"""Sensors of the simulated robot: touch against the list of contacts, the others against closed forms."""

import mujoco
import numpy as np
import pytest
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, LINK_NAMES, STANCE, TOTAL_MASS
from scipy.spatial.transform import Rotation
from sensing import GRAVITY, random_pose, reading


def feet(data, what="force"):
    return reading(data, *(f"{leg}_foot_{what}" for leg in ("LF", "RF", "LH", "RH")))


def trunk(data):
    names = ["base_contact_force", *(f"{leg}_hip_contact_force" for leg in ("LF", "RF", "LH", "RH"))]
    return reading(data, *names)


class TestSensors:
    def test_touch_tells_feet_from_trunk(self, model):
        """Against the contact list: each sensor sums the normal forces on its part, of a leg the foot's ball only."""
        rng = np.random.default_rng(0)
        data = mujoco.MjData(model)
        ground = model.geom("ground").id
        seen = np.zeros(9, dtype=bool)
        knee_contacts = 0
        for _ in range(20):
            mujoco.mj_resetData(model, data)
            random_pose(rng, data, 0.25)
            for _ in range(60):
                data.ctrl = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
                mujoco.mj_step(model, data, 4)
                mujoco.mj_forward(model, data)
                expected = dict.fromkeys(LINK_NAMES, 0.0)
                for i, contact in enumerate(data.contact):
                    force = np.zeros(6)
                    mujoco.mj_contactForce(model, data, i, force)
                    for geom in contact.geom[contact.geom != ground]:
                        link = model.body(model.geom_bodyid[geom]).name
                        if link.endswith("_leg"):
                            ball = data.site(f"{link.removesuffix('_leg')}_foot").xpos
                            if np.linalg.norm(contact.pos - ball) > 0.025:
                                knee_contacts += force[0] > 0.0
                                continue
                        expected[link] += force[0]
                on_feet = [expected[link] for link in LINK_NAMES if link.endswith("_leg")]
                on_trunk = [expected[link] for link in LINK_NAMES if not link.endswith("_leg")]
                np.testing.assert_allclose(feet(data), on_feet, rtol=1e-9, atol=1e-9)
                np.testing.assert_allclose(trunk(data), on_trunk, rtol=1e-9, atol=1e-9)
                seen |= np.concatenate([feet(data), trunk(data)]) > 0.0
        assert seen.all()
        assert knee_contacts > 0

    def test_foot_sensors_of_a_robot_on_its_back_read_zero(self, model):
        data = mujoco.MjData(model)
        data.qpos[:] = [0, 0, 0.05, 0, 1, 0, 0, *STANCE]
        data.ctrl = STANCE
        mujoco.mj_step(model, data, 200)
        np.testing.assert_array_equal(feet(data), 0.0)
        assert trunk(data).sum() == pytest.approx(TOTAL_MASS * GRAVITY, rel=0.01)

    def test_readings_in_closed_form_at_random_attitudes(self, model):
        rng = np.random.default_rng(0)
        data = mujoco.MjData(model)
        for _ in range(100):
            random_pose(rng, data, 1.0)
            data.qvel[:] = rng.standard_normal(14)
            mujoco.mj_forward(model, data)
            attitude = Rotation.from_quat(data.qpos[3:7], scalar_first=True)
            w, x, y, z = data.qpos[3:7]
            up = [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]
            np.testing.assert_allclose(reading(data, "world_up"), up, rtol=0, atol=1e-12)
            velocity = attitude.inv().apply(data.qvel[:3])
            np.testing.assert_allclose(reading(data, "base_linear_velocity"), velocity, rtol=0, atol=1e-12)
            # MuJoCo states a free joint's angular velocity in the body frame, as a gyro does.
            np.testing.assert_allclose(reading(data, "imu_angular_velocity"), data.qvel[3:6], rtol=0, atol=1e-12)
            np.testing.assert_allclose(reading(data, "imu_orientation"), data.qpos[3:7], rtol=0, atol=1e-12)
            np.testing.assert_allclose(reading(data, "base_position"), data.qpos[:3], rtol=0, atol=1e-12)

    def test_joint_readings(self, model):
        rng = np.random.default_rng(0)
        data = mujoco.MjData(model)
        random_pose(rng, data, 1.0)
        data.qvel[:], data.ctrl[:] = rng.standard_normal(14), STANCE
        mujoco.mj_forward(model, data)
        joints = [name.removesuffix("_joint") for name in (model.joint(i).name for i in range(1, 9))]
        np.testing.assert_array_equal(reading(data, *(f"{joint}_position" for joint in joints)), data.qpos[7:])
        np.testing.assert_array_equal(reading(data, *(f"{joint}_velocity" for joint in joints)), data.qvel[6:])
        np.testing.assert_array_equal(reading(data, *(f"{joint}_torque" for joint in joints)), data.actuator_force)

    def test_foot_readings(self, model):
        """Velocity is the derivative of position; angular velocity adds both joints to the base's."""
        rng = np.random.default_rng(0)
        data, later = mujoco.MjData(model), mujoco.MjData(model)
        step = 1e-7
        for _ in range(20):
            random_pose(rng, data, 1.0)
            data.qvel[:] = rng.standard_normal(14)
            mujoco.mj_forward(model, data)
            later.qpos = data.qpos
            mujoco.mj_integratePos(model, later.qpos, data.qvel, step)
            mujoco.mj_forward(model, later)
            numeric = (feet(later, "position") - feet(data, "position")) / step
            np.testing.assert_allclose(feet(data, "velocity"), numeric, rtol=0, atol=1e-5)
            attitude = Rotation.from_quat(data.qpos[3:7], scalar_first=True)
            pitching = data.qvel[6::2] + data.qvel[7::2]
            expected = attitude.apply(data.qvel[3:6] + pitching[:, None] * [0, 1, 0])
            np.testing.assert_allclose(feet(data, "angular_velocity"), expected.ravel(), rtol=0, atol=1e-12)
