"""The motor law that an engine without motors runs: the formula of the robot's page, and MuJoCo's own motors."""

import dataclasses

import mujoco
import numpy as np
import pytest

from quadruped_env.robot import MINI_QUADRUPED, JointMotor, MotorConfig
from quadruped_env.simulation import build_model
from second_engine.servos import Servos

HIP = JointMotor(stall_torque=8.0, no_load_speed=4.0, kp=30.0, kd=0.5, friction_loss=0.2, armature=0.02)
MOTORS = MotorConfig(hip=HIP, knee=JointMotor())
KINDS = ("hip", "knee")


def torque(error, speed, motors=MOTORS):
    servos = Servos(motors, KINDS, 0.002)
    return servos.torque(np.array([error]), np.zeros((1, 2)), np.array([speed]))[0]


@pytest.mark.parametrize(
    ("error", "speed", "expected"),
    [
        ((0.1, 0.1), (0.0, 0.0), (3.0, 4.0)),  # kp times the error
        ((0.1, 0.1), (1.0, 1.0), (2.5, 3.0)),  # minus kd times the speed
        ((1.0, 1.0), (0.0, 0.0), (8.0, 10.0)),  # the stall torques
        ((1.0, 1.0), (2.0, 2.0), (4.0, 6.0)),  # stall - slope * speed: 8 - 2 * 2, 10 - 2 * 2
        ((1.0, 1.0), (4.0, 5.0), (0.0, 0.0)),  # the no-load speeds
        ((-1.0, -1.0), (2.0, 2.0), (-8.0, -10.0)),  # braking: the stall torques, not -12 and -14
        ((1.0, 1.0), (5.0, 6.0), (-2.0, -2.0)),  # faster than without load: the back EMF brakes
    ],
)
def test_torque_is_that_of_the_torque_speed_line(error, speed, expected):
    np.testing.assert_allclose(torque(error, speed), expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("motors", [MINI_QUADRUPED.motors, MOTORS], ids=["built-in", "other"])
def test_torque_equals_that_of_mujocos_motors_in_random_states(motors):
    rng, robot = np.random.default_rng(0), MINI_QUADRUPED
    model = build_model(motors=motors)
    data = mujoco.MjData(model)
    servos = Servos(motors, robot.joint_kinds, 0.002)
    saturated = 0
    for _ in range(300):
        low, high = robot.joint_position_low, robot.joint_position_high
        target, position = rng.uniform(low, high), rng.uniform(low, high)
        position += rng.choice([0.0, 0.9]) * (target - position)
        data.qpos[2], data.qpos[7:], data.qvel[6:] = 1.0, position, rng.normal(0.0, 4.0, 8)
        data.ctrl[:] = target
        mujoco.mj_forward(model, data)
        found = servos.torque(target[None], data.qpos[None, 7:], data.qvel[None, 6:])[0]
        np.testing.assert_allclose(found, data.actuator_force, rtol=0, atol=1e-9)
        saturated += np.count_nonzero(np.abs(data.actuator_force) > 7.999)
    assert 100 < saturated < 2000, "both within the limits and at them"


def test_delayed_target_is_interpolated_between_steps():
    motors = dataclasses.replace(MINI_QUADRUPED.motors, delay=0.003)
    servos = Servos(motors, KINDS, 0.002, num_robots=2)
    servos.reset(np.array([0, 1]), np.array([[0.0, 0.0], [0.1, 0.1]]))
    zeros, sent = np.zeros((2, 2)), [0.02, 0.04, 0.08, 0.08]
    found = [servos.torque(np.full((2, 2), target), zeros, zeros)[:, 0] / 40.0 for target in sent]
    # The means of the targets of one step and of two steps ago.
    np.testing.assert_allclose(found, [[0.0, 0.1], [0.01, 0.06], [0.03, 0.03], [0.06, 0.06]], atol=1e-15)


def test_friction_opposes_the_motion_and_stops_a_slow_rotor_within_a_step():
    servos = Servos(MOTORS, KINDS, 0.002)
    assert servos.has_friction
    assert not Servos(MINI_QUADRUPED.motors, KINDS, 0.002).has_friction
    for speed, expected in ((1.0, -0.2), (-1.0, 0.2), (0.01, -0.02 * 0.01 / 0.002), (0.0, 0.0)):
        np.testing.assert_allclose(servos.friction(np.array([[speed, speed]]))[0], [expected, 0.0], atol=1e-15)
