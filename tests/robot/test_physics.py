"""The simulated robot against physics: weight, motors, symmetry, momentum, energy, and what the sensors read."""

import copy
import itertools

import mujoco
import numpy as np
import pytest
from built_in import (
    EFFORT_LIMIT,
    JOINT_POSITION_HIGH,
    JOINT_POSITION_LOW,
    LINK_NAMES,
    STANCE,
    STANCE_HEIGHT,
    TOTAL_MASS,
    VELOCITY_LIMIT,
)
from mirroring import mirrored
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from quadruped_env import asset_path
from quadruped_env.simulation import SingleSimulation, build_model

GRAVITY = 9.81
STIFFNESS, DAMPING, PASSIVE_DAMPING = 40.0, 1.0, 0.05
ROW = np.array([0])
CORNERS = tuple(itertools.product((-1.5, 1.5), (-2.0, 0.0)))
"""Every combination of a hip limit and a knee limit."""


def hanging_robot(timestep=0.005):
    """The robot with its base held in the air."""
    spec = mujoco.MjSpec.from_file(str(asset_path("scene.xml")))
    spec.delete(spec.joint("floating_base"))
    spec.delete(spec.key("home"))
    spec.body("base_link").pos = [0, 0, 1]
    spec.option.timestep = timestep
    return spec.compile()


@pytest.fixture(scope="module")
def hanging():
    return hanging_robot()


def random_pose(rng, data, height):
    """A random attitude and random joints, at a height in m."""
    data.qpos[:3] = [0, 0, height]
    data.qpos[3:7] = Rotation.random(rng=rng).as_quat(scalar_first=True)
    data.qpos[7:] = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)


def reading(data, *names):
    return np.concatenate([data.sensor(name).data for name in names])


def feet(data, what="force"):
    return reading(data, *(f"{leg}_foot_{what}" for leg in ("LF", "RF", "LH", "RH")))


def trunk(data):
    names = ["base_contact_force", *(f"{leg}_hip_contact_force" for leg in ("LF", "RF", "LH", "RH"))]
    return reading(data, *names)


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


def motor_torque(error, speed):
    """Torque of a motor, and torque that its controller requests, N m, from position error (rad) and speed (rad/s).

    The law of the README: PD torque, within what 24 V give at this speed, within the effort limit.
    """
    wanted = STIFFNESS * error - DAMPING * speed
    slope = EFFORT_LIMIT / VELOCITY_LIMIT * speed
    available = np.clip(wanted, -EFFORT_LIMIT - slope, EFFORT_LIMIT - slope)
    return np.clip(available, -EFFORT_LIMIT, EFFORT_LIMIT), wanted


class TestMotors:
    def test_torque_speed_line_at_every_error_and_speed(self, hanging):
        data = mujoco.MjData(hanging)
        target = np.tile([0.0, -1.0], 4)
        data.ctrl[:] = target
        for error, speed in itertools.product(np.linspace(-1, 1, 21), np.linspace(-8, 8, 33)):
            data.qpos[:] = target - error
            data.qvel[:] = speed
            mujoco.mj_forward(hanging, data)
            np.testing.assert_allclose(data.actuator_force, motor_torque(error, speed)[0], rtol=0, atol=1e-9)

    @pytest.mark.parametrize(
        ("error", "speed", "torque"),
        [
            (1.0, 0.0, 10.0),  # stall
            (1.0, 2.5, 5.0),  # half way down the line
            (1.0, 5.0, 0.0),  # no load
            (1.0, 6.0, -2.0),  # driven beyond it, the motor brakes
            (-1.0, 3.0, -10.0),  # braking at full effort, where 24 V alone would give -16
            (0.1, 1.0, 3.0),  # within both limits: 40 * 0.1 - 1 * 1
        ],
    )
    def test_torque_speed_line_by_example(self, hanging, error, speed, torque):
        data = mujoco.MjData(hanging)
        data.qpos[:] = np.tile([0.0, -1.0], 4)
        data.ctrl[:] = data.qpos + error
        data.qvel[:] = speed
        mujoco.mj_forward(hanging, data)
        np.testing.assert_allclose(data.actuator_force, torque, rtol=0, atol=1e-9)

    @pytest.mark.parametrize(("begin", "end"), tuple(itertools.product(CORNERS, CORNERS)))
    def test_steps_from_limit_to_limit_stay_within_effort_and_speed(self, hanging, begin, end):
        data = mujoco.MjData(hanging)
        data.qpos[:], target = np.tile(begin, 4), np.tile(end, 4)
        data.ctrl[:] = target
        position, speed, torque = np.empty((3, 250, 8))
        for i in range(250):
            position[i], speed[i] = data.qpos, data.qvel
            mujoco.mj_step(hanging, data)
            torque[i] = data.actuator_force
        assert abs(torque).max() <= 1.02 * EFFORT_LIMIT
        assert abs(speed).max() <= 1.02 * VELOCITY_LIMIT
        np.testing.assert_allclose(data.qpos, target, rtol=0, atol=0.01)
        expected, wanted = motor_torque(target - position, speed)
        np.testing.assert_allclose(torque, expected, rtol=0, atol=1e-9)
        direction = np.sign(target - np.tile(begin, 4))
        moved = direction != 0.0
        if moved.any():
            # Stall torque at the start; on the way the no-load speed, less what damping and gravity take of it.
            np.testing.assert_allclose(torque[0, moved], EFFORT_LIMIT * direction[moved], rtol=1e-12)
            assert ((speed * direction).max(axis=0)[moved] > 0.94 * VELOCITY_LIMIT).all()
            on_the_line = (wanted * direction > torque * direction + 1.0) & (speed * direction > 1.0)
            assert on_the_line[:, moved].any(axis=0).all()

    def test_no_load_speed(self):
        model = hanging_robot()
        model.opt.gravity[:] = 0.0
        model.dof_damping[:] = 0.0
        data = mujoco.MjData(model)
        data.qpos[:], data.ctrl[:] = np.tile([-1.5, -1.0], 4), np.tile([1.5, -1.0], 4)
        fastest = 0.0
        for _ in range(100):
            mujoco.mj_step(model, data)
            fastest = max(fastest, data.qvel[::2].max())
        assert fastest == pytest.approx(VELOCITY_LIMIT, rel=1e-3)

    def test_small_steps_follow_the_designed_second_order_system(self):
        """Stiffness, damping and inertia of the README: M q'' + (kd + damping) q' + kp (q - target) = 0."""
        model = hanging_robot(timestep=1e-4)
        model.opt.gravity[:] = 0.0
        data = mujoco.MjData(model)
        step = np.tile([0.01, -0.02], 4)
        data.qpos[:], data.ctrl[:] = STANCE, STANCE + step
        mujoco.mj_forward(model, data)
        inertia = np.zeros((8, 8))
        mujoco.mj_fullM(model, data, inertia)
        inverse = np.linalg.inv(inertia)
        identity = np.eye(8)
        system = np.block(
            [
                [np.zeros((8, 8)), identity],
                [-STIFFNESS * inverse, -(DAMPING + PASSIVE_DAMPING) * inverse],
            ]
        )
        for _ in range(10):
            mujoco.mj_step(model, data, 100)
            expected = expm(system * data.time) @ np.concatenate([-step, np.zeros(8)])
            np.testing.assert_allclose(data.qpos - STANCE - step, expected[:8], rtol=0, atol=0.01 * abs(step).max())

    def test_reflected_inertia_dominates_the_leg(self, hanging):
        data = mujoco.MjData(hanging)
        mujoco.mj_forward(hanging, data)
        inertia = np.zeros((8, 8))
        mujoco.mj_fullM(hanging, data, inertia)
        np.testing.assert_array_equal(hanging.dof_armature, 0.01)
        about_knee = 0.2 / 12 * (3 * 0.02**2 + 0.16**2) + 0.2 * 0.08**2
        about_hip = 9e-5 + 0.2 / 12 * (3 * 0.02**2 + 0.16**2) + 0.2 * 0.11**2
        np.testing.assert_allclose(np.diag(inertia), np.tile([about_hip, about_knee], 4) + 0.01, rtol=1e-9)


class TestDynamics:
    @pytest.mark.parametrize("seed", range(5))
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

    @pytest.mark.parametrize("seed", range(5))
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

    def test_free_fall_in_closed_form(self, model):
        data = mujoco.MjData(model)
        data.qpos = model.key("home").qpos
        data.qpos[2] = 10.0
        data.ctrl = STANCE
        start, velocity = data.qpos[:3].copy(), np.array([1.0, -2.0, 3.0])
        data.qvel[:3] = velocity
        steps, dt = 200, model.opt.timestep
        mujoco.mj_step(model, data, steps)
        # Velocity first, then position: the integrator's sum of g dt is n (n + 1) / 2 where the integral has n^2 / 2.
        fallen = GRAVITY * dt**2 * steps * (steps + 1) / 2
        time = steps * dt
        np.testing.assert_allclose(data.qpos[:3], start + velocity * time - [0, 0, fallen], rtol=0, atol=1e-9)
        np.testing.assert_allclose(data.qvel[:3], velocity - [0, 0, GRAVITY * time], rtol=0, atol=1e-9)
        assert fallen == pytest.approx(GRAVITY * time**2 / 2, rel=0.01)
        np.testing.assert_allclose(reading(data, "imu_linear_acceleration"), 0.0, rtol=0, atol=1e-9)

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

    @pytest.mark.parametrize("seed", range(5))
    def test_a_passive_fall_gains_no_energy(self, model, seed):
        passive = copy.copy(model)
        passive.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_ACTUATION
        passive.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
        data = mujoco.MjData(passive)
        random_pose(np.random.default_rng(seed), data, 0.6)
        mujoco.mj_forward(passive, data)
        energy = [data.energy.sum()]
        for _ in range(400):
            mujoco.mj_step(passive, data)
            energy.append(data.energy.sum())
        energy = np.array(energy)
        lowest_so_far = np.minimum.accumulate(energy)
        assert (energy - lowest_so_far).max() < 0.02 * (energy[0] - energy[-1])
        assert energy[-1] < 0.5 * energy[0]


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
