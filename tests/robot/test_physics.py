"""The simulated robot against physics: weight, symmetry, momentum, energy."""

import mujoco
import numpy as np
import pytest
from built_in import EFFORT_LIMIT, JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, STANCE_HEIGHT, TOTAL_MASS
from mirroring import mirrored
from sensing import GRAVITY, random_pose

from quadruped_env.simulation import SingleSimulation, build_model

ROW = np.array([0])


@pytest.fixture(scope="module")
def standing(model):
    """Three seconds in the stance."""
    simulation = SingleSimulation(model)
    simulation.reset(ROW, model.key("home").qpos[None], np.zeros((1, 14)))
    for _ in range(150):
        simulation.step(STANCE[None], 4)
    return simulation


class TestStanding:
    def test_the_feet_carry_the_weight(self, standing):
        force = standing.readings.foot_force[0]
        assert force.sum() == pytest.approx(TOTAL_MASS * GRAVITY, rel=0.01)
        # The left-right mirror image of the stance is the stance.
        np.testing.assert_allclose(force[[0, 2]], force[[1, 3]], rtol=1e-6)
        np.testing.assert_array_equal(standing.readings.trunk_force, 0.0)

    def test_it_stands_still_and_upright(self, standing):
        state = standing.readings
        assert state.base_position[0, 2] == pytest.approx(STANCE_HEIGHT, abs=1e-3)
        np.testing.assert_allclose(state.up_b[0], [0, 0, 1], rtol=0, atol=2e-3)
        np.testing.assert_allclose(state.joint_position[0], STANCE, rtol=0, atol=0.01)
        np.testing.assert_allclose(state.joint_velocity[0], 0.0, rtol=0, atol=1e-4)
        assert abs(state.joint_torque).max() < 0.05 * EFFORT_LIMIT

    def test_accelerometer_reads_gravity(self, standing):
        expected = GRAVITY * standing.readings.up_b[0]
        np.testing.assert_allclose(standing.readings.linear_acceleration_b[0], expected, rtol=0, atol=0.01)


class TestDynamics:
    @pytest.mark.parametrize("seed", range(2))
    def test_random_control_gives_no_warnings(self, model, seed):
        rng = np.random.default_rng(seed)
        simulation = SingleSimulation(model)
        simulation.reset(ROW, model.key("home").qpos[None], np.zeros((1, 14)))
        for _ in range(500):
            simulation.step(rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)[None], 4)
        assert simulation.data.time == pytest.approx(10.0)
        assert [warning.number for warning in simulation.data.warning] == [0] * len(simulation.data.warning)
        assert np.isfinite(simulation.data.qpos).all()

    def test_the_models_memory_is_enough_for_every_contact(self, model):
        """Sunk into the ground in any attitude, with the legs of each side crossed."""
        rng = np.random.default_rng(0)
        data = mujoco.MjData(model)
        used = 0
        for _ in range(300):
            mujoco.mj_resetData(model, data)
            random_pose(rng, data, rng.uniform(-0.2, 0.1))
            mujoco.mj_step(model, data)
            used = max(used, data.maxuse_arena)
            assert [warning.number for warning in data.warning] == [0] * len(data.warning)
        assert used < 0.5 * data.narena

    @pytest.mark.parametrize("seed", range(2))
    def test_left_and_right_are_mirror_images(self, model, seed):
        rng = np.random.default_rng(seed)
        data, mirror = mujoco.MjData(model), mujoco.MjData(model)
        qpos = np.array([0.1, 0.2, STANCE_HEIGHT + 0.01, 1, *(0.1 * rng.standard_normal(3)), *STANCE])
        qpos[3:7] /= np.linalg.norm(qpos[3:7])
        qpos[7:] += 0.1 * rng.standard_normal(8)
        data.qpos, data.qvel = qpos, 0.3 * rng.standard_normal(14)
        mirror.qpos, mirror.qvel, _ = mirrored(data.qpos, data.qvel, data.ctrl)
        touched = False
        for _ in range(20):
            data.ctrl = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
            _, _, mirror.ctrl = mirrored(data.qpos, data.qvel, data.ctrl)
            mujoco.mj_step(model, data, 2)
            mujoco.mj_step(model, mirror, 2)
            touched |= bool(data.ncon)
            expected_qpos, expected_qvel, _ = mirrored(data.qpos, data.qvel, data.ctrl)
            np.testing.assert_allclose(mirror.qpos, expected_qpos, rtol=0, atol=1e-9)
            np.testing.assert_allclose(mirror.qvel, expected_qvel, rtol=0, atol=1e-7)
        assert touched

    def momentum_drift(self, timestep):
        """Change of momentum (kg m/s) and of angular momentum (kg m^2/s) in 0.4 s of flailing in free flight."""
        model = build_model(timestep)
        data = mujoco.MjData(model)
        rng = np.random.default_rng(0)
        random_pose(rng, data, 10.0)
        data.qvel[:6] = rng.standard_normal(6)
        values = []
        for _ in range(20):
            data.ctrl = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
            mujoco.mj_step(model, data, round(0.02 / timestep))
            mujoco.mj_forward(model, data)
            mujoco.mj_subtreeVel(model, data)
            base = model.body("base_link").id
            linear = TOTAL_MASS * (data.subtree_linvel[base] + [0, 0, GRAVITY * data.time])
            values.append([linear, data.subtree_angmom[base].copy()])
        values = np.array(values)
        assert data.ncon == 0
        return abs(values - values[0]).max(axis=(0, 2)), abs(values).max(axis=(0, 2))

    def test_motors_conserve_momentum_in_the_air(self):
        """Up to the integrator's error, which decreases with the time step."""
        coarse, size = self.momentum_drift(0.005)
        fine, _ = self.momentum_drift(0.0005)
        assert (coarse < [0.01, 0.1] * size).all()
        assert (fine < 0.2 * coarse).all()
