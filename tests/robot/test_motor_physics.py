"""Motors of the simulated robot with its base held: torque-speed line, limits, no-load speed, inertia."""

import itertools

import mujoco
import numpy as np
import pytest
from built_in import EFFORT_LIMIT, STANCE, VELOCITY_LIMIT
from scipy.linalg import expm

from quadruped_env import asset_path

STIFFNESS, DAMPING, PASSIVE_DAMPING = 40.0, 1.0, 0.05
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

    @pytest.mark.parametrize(("begin", "end"), tuple(zip(CORNERS, CORNERS[::-1], strict=True)))
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
            [[np.zeros((8, 8)), identity], [-STIFFNESS * inverse, -(DAMPING + PASSIVE_DAMPING) * inverse]]
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
