"""The trot of other robots: feet on their path, targets that lead the servos, and speeds on the ground."""

import dataclasses
import math

import gymnasium
import numpy as np
import pytest
import second_robot
import twelve_joints

from quadruped_env import CommandedGait, SinusoidalGait
from quadruped_env.gait import LEG_PHASES, PRESETS, joint_phases
from quadruped_env.gait.gait_presets import TROTS
from quadruped_env.gait.waves import joint_waves, reachable_lift, trot_waves
from quadruped_env.robot import JointMotor, MotorConfig, QuadrupedDesign
from quadruped_env.robot.units import scale_of

TWELVE = twelve_joints.robot()
ROBOTS = pytest.mark.parametrize("robot", [second_robot.ROBOT, TWELVE], ids=["two joints", "three joints"])
FREQUENCY, LIFT = 2.5, 0.1


def feet(robot, velocity, frequency=FREQUENCY, lift=LIFT, samples=48):
    """Paths of the feet (samples, L, 3) relative to the stance, m, by the angle of each leg's own cycle."""
    angles = math.tau * (np.arange(samples) + 0.5) / samples
    sine, cosine, offset = joint_waves(robot, frequency, np.array([velocity], dtype=float), lift, 1.0)
    joints = sine * np.sin(angles)[:, None] + cosine * np.cos(angles)[:, None] + offset
    return angles, robot.skeleton.foot_centres(joints) - robot.skeleton.foot_centres(robot.stance)


@ROBOTS
@pytest.mark.parametrize("speed", [0.3, -0.3])
def test_feet_move_back_on_the_ground_at_the_speed_and_rise_in_their_swing(robot, speed):
    angles, path = feet(robot, (speed, 0.0, 0.0))
    ground = np.abs(angles - 1.5 * math.pi) < 0.3
    slope = np.polyfit(angles[ground] / (math.tau * FREQUENCY), path[ground, :, 0], 1)[0]
    # A sinusoid through the path of a quarter of the stride per quarter of the cycle: fastest in the middle.
    stride = 0.5 * (1.0 + 8.0 / math.pi**2)
    np.testing.assert_allclose(slope, -speed * stride * math.pi / 2.0, rtol=0.06)
    height = robot.stance_height
    np.testing.assert_allclose(np.ptp(path[..., 2], axis=0), LIFT * height, rtol=0.1)
    assert (path[angles < math.pi][6:-6, :, 2] > path[angles > math.pi][6:-6, :, 2].max()).all()
    np.testing.assert_allclose(path[..., 1], 0.0, atol=1e-3 * height)


def test_feet_of_three_joints_step_to_the_side_and_about_the_middle():
    _, aside = feet(TWELVE, (0.0, 0.0, 0.2))
    assert (np.ptp(aside[..., 1], axis=0) > 1.5 * 0.2 / (4.0 * FREQUENCY)).all()
    np.testing.assert_allclose(aside[..., 0], 0.0, atol=2e-3)
    _, turning = feet(TWELVE, (0.0, 0.5, 0.0))
    x, y = TWELVE.stance_feet[:, 0], TWELVE.stance_feet[:, 1]
    motion = turning[12] - turning[36]  # from the middle of the swing to the middle of the time on the ground
    start = turning[0] - turning[23]
    assert np.abs(motion[:, :2]).max() < 4e-3
    np.testing.assert_allclose(start[:, 0] * x + start[:, 1] * y, 0.0, atol=3e-4)
    assert (start[:, 0] * y > 0.0).all(), "turning left, the left feet swing backward"
    assert (start[:, 1] * x < 0.0).all()


@ROBOTS
def test_gait_of_a_command_is_its_mirror_image_turning_the_other_way(robot):
    gait = CommandedGait.preset("sinusoid", robot, 2.9)
    phase = np.linspace(0.0, math.tau, 20)
    commands = np.array([[0.2, 0.4, 0.1], [0.2, -0.4, -0.1]])[:, : 3 if robot is TWELVE else 2]
    left, right = (
        gait.positions(phase + shift, np.tile(c, (20, 1))) for c, shift in zip(commands, (0, math.pi), strict=True)
    )
    mirrored = (robot.joint_signs * left)[:, np.argsort(robot.joint_mirror)]
    np.testing.assert_allclose(mirrored, right, atol=1e-5)
    assert np.abs(left - right).max() > 0.05


@pytest.mark.parametrize("robot", [second_robot.ROBOT, TWELVE], ids=["two joints", "three joints"])
def test_targets_lead_a_servo_so_that_its_joint_is_on_the_path(robot):
    """The differential equation of each joint with its motor, in the air and under half of the weight on two legs."""
    frequency, rate = 2.5, math.tau * 2.5
    velocity, trot = np.zeros((1, 3)), TROTS["sinusoid"]
    lift = reachable_lift(robot, frequency, trot)
    wanted = joint_waves(robot, frequency, velocity, lift, 1.0)
    sine, cosine, offset = (values[0] for values in trot_waves(robot, frequency, velocity, trot))
    t = np.arange(400) / 400 / frequency
    motors = robot.motors.of_joints(robot.joint_kinds)
    jacobian = robot.skeleton.foot_jacobians(robot.stance)[:, 2].sum(axis=0)
    for joint, motor in enumerate(motors):
        s, c, mean = (values[0, joint] for values in wanted)
        position = s * np.sin(rate * t) + c * np.cos(rate * t) + mean
        speed = rate * (s * np.cos(rate * t) - c * np.sin(rate * t))
        acceleration = -rate * rate * (position - mean)
        # The first harmonic of a force that is there in the second half of the cycle.
        carried = 0.5 * robot.total_mass * 9.81 * (0.5 - 2.0 / math.pi * np.sin(rate * t))
        target = sine[joint] * np.sin(rate * t) + cosine[joint] * np.cos(rate * t) + offset[joint]
        torque = motor.kp * (target - position) - (motor.kd + motor.damping) * speed
        np.testing.assert_allclose(
            torque, motor.armature * acceleration - jacobian[joint] * carried, atol=1e-4 * motor.kp
        )


def test_delay_of_the_motors_is_made_up_by_an_earlier_phase():
    robot, velocity = second_robot.ROBOT, np.array([[0.2, 0.0, 0.0]])
    late = dataclasses.replace(robot, motors=dataclasses.replace(robot.motors, delay=0.03))
    sine, cosine, offset = trot_waves(robot, FREQUENCY, velocity, TROTS["sinusoid"])
    earlier = math.tau * FREQUENCY * 0.03
    expected = (
        sine * math.cos(earlier) - cosine * math.sin(earlier),
        sine * math.sin(earlier) + cosine * math.cos(earlier),
        offset,
    )
    for found, value in zip(trot_waves(late, FREQUENCY, velocity, TROTS["sinusoid"]), expected, strict=True):
        np.testing.assert_allclose(found, value, atol=1e-12)


def test_slow_joints_lift_their_feet_by_less():
    def with_speed(speed):
        motor = JointMotor(no_load_speed=speed)
        return QuadrupedDesign(name="slow", hip_to_knee=0.05, motors=MotorConfig(motor, motor)).robot()

    lifts = [reachable_lift(with_speed(speed), 3.4, TROTS["sinusoid"]) for speed in (40.0, 5.0, 3.0)]
    assert lifts[0] == TROTS["sinusoid"].lift > lifts[1] > lifts[2] > 0.0
    sine, cosine, _ = joint_waves(with_speed(5.0), 3.4, np.zeros((1, 3)), lifts[1], 1.0)
    assert math.tau * 3.4 * np.hypot(sine, cosine).max() == pytest.approx(0.6 * 5.0, rel=0.05)


@ROBOTS
def test_tables_are_the_waves_at_their_commands(robot):
    """At the speeds of the table, with the largest turn to either side, and a step to the side."""
    frequency, root = 2.9, scale_of("m/s", robot)
    gait = CommandedGait.preset("sinusoid", robot, frequency)
    largest = gait.largest_yaw_rate
    commands = [(0.5 * root, 0.0, 0.0), (-0.5 * root, largest, 0.0), (0.5 * root, -largest, 0.0)]
    if gait.lateral is not None:
        commands.append((0.5 * root, 0.0, 0.3 * root))
    for command in commands:
        expected = trot_waves(robot, frequency, np.array([command]), TROTS["sinusoid"])
        found = gait.waves(np.array([command[: 2 if gait.lateral is None else 3]]))
        for one, other in zip(found, expected, strict=True):
            # The mean of a step to the left and of one to the right, so to the square of the step.
            np.testing.assert_allclose(one, other, atol=0.02 if command[2] else 3e-6)


def test_turn_of_feet_that_do_not_slide_is_in_proportion_to_the_yaw_rate():
    gait = CommandedGait.preset("sinusoid", TWELVE, 2.9)
    yaw_rates = np.array([-2.0, -0.2, 0.0, 0.1, 9.0])
    limit = gait.largest_yaw_rate
    np.testing.assert_array_equal(gait.turn_size(yaw_rates), [-limit, -0.2, 0.0, 0.1, limit])
    two = CommandedGait.preset("sinusoid", second_robot.ROBOT, 2.9)
    assert two.lateral is None
    assert two.turn_size(np.array([0.1]))[0] > 0.2


def test_lateral_velocity_fades_the_steps_in_and_two_commands_do():
    gait = CommandedGait.preset("sinusoid", TWELVE, 2.9)
    whole = gait.whole_steps
    assert len(whole) == 3
    np.testing.assert_allclose(gait.fade(np.array([[0.0, 0.0, 0.5 * whole[2]], [0.0, 0.0, -9.0]])), [0.5, 1.0])
    three, two = np.array([[0.3, 0.2, 0.0]]), np.array([[0.3, 0.2]])
    for one, other in zip(gait.waves(three), gait.waves(two), strict=True):
        np.testing.assert_array_equal(one, other)
    np.testing.assert_array_equal(gait.positions(np.zeros(1), np.zeros((1, 3)))[0], TWELVE.stance)


@ROBOTS
@pytest.mark.parametrize("name", PRESETS)
def test_every_preset_is_a_gait_of_every_robot(robot, name):
    gait = SinusoidalGait.preset(name, robot)
    positions = gait.positions(np.linspace(0.0, gait.period, 40))
    assert (np.ptp(positions, axis=0)[[joints[-1] for joints in robot.leg_joints]] > 0.01).all()
    if name == "article":
        return
    # The feet rise in the swing of their leg's phase.
    t = np.linspace(0.0, gait.period, 40)
    phases = LEG_PHASES[TROTS[name].phases]
    heights = robot.skeleton.foot_centres(gait.positions(t))[..., 2]
    for leg, corner in enumerate(robot.corners):
        cycle = gait.angular_frequency * t + math.tau * phases[corner]
        lag = np.angle(np.exp(-1j * cycle) @ (heights[:, leg] - heights[:, leg].mean()))
        assert -2.6 < lag < -0.2, "a quarter of a cycle later than a cosine, but for the lead"


def test_presets_differ_as_their_names_say():
    highest = {}
    for name in ("tuned", "low", "crouched"):
        gait = CommandedGait.preset(name, TWELVE)
        angles = np.linspace(0.0, math.tau, 40)
        joints = gait.positions(angles, np.tile([0.3, 0.0, 0.0], (40, 1)))
        heights = TWELVE.skeleton.foot_centres(joints)[..., 2] - TWELVE.skeleton.foot_centres(TWELVE.stance)[:, 2]
        highest[name] = np.ptp(heights), heights.mean()
    assert highest["low"][0] < 0.7 * highest["tuned"][0]
    assert highest["crouched"][1] > highest["tuned"][1] + 0.05 * TWELVE.stance_height
    assert (
        CommandedGait.preset("fast", TWELVE).largest_yaw_rate > CommandedGait.preset("tuned", TWELVE).largest_yaw_rate
    )


def test_joint_phases_are_the_phases_of_their_legs():
    phases = joint_phases(TWELVE, "walk") / math.tau
    assert phases.reshape(4, 3).tolist() == [[LEG_PHASES["walk"][corner]] * 3 for corner in TWELVE.corners]


# --- on the ground ---


def walked(robot, commands, seconds=10.0, starts=8):
    """Mean forward velocity, yaw rate and lateral velocity (K, 3) in the robot's units, and falls (K,)."""
    units = np.array([scale_of(unit, robot) for unit in ("m/s", "rad/s", "m/s")])[: 3 if robot.moves_sideways else 2]
    found, falls = [], []
    for command in commands:
        env = gymnasium.make_vec("MiniQuadruped-v0", num_envs=starts, robot=robot, action_mode="residual")
        env.reset(seed=7, options={"command": (np.array(command)[: len(units)] * units).tolist()})
        velocities, fallen = [], 0
        for step in range(round(seconds / 0.02)):
            *_, terminated, _, info = env.step(np.zeros((starts, robot.num_joints), dtype=np.float32))
            fallen += int(terminated.sum())
            linear, angular = info["base_linear_velocity"], info["base_angular_velocity"]
            if step >= 100:
                velocities.append([linear[:, 0].mean(), angular[:, 2].mean(), linear[:, 1].mean()])
        env.close()
        found.append(np.mean(velocities, axis=0) / [*units, units[0]][:3])
        falls.append(fallen)
    return np.array(found), falls


def equal_links(**changes):
    """The built-in robot with thighs and shanks of similar lengths, at the same height."""
    numbers = {"hip_to_knee": 0.11, "leg_length": 0.13, "stance_angles": (0.7, -1.45), "knee_range": (-2.4, 0.0)}
    return QuadrupedDesign(name="equal", **numbers | changes).robot()


MOTOR = {"damping": 0.1, "friction_loss": 0.2}
A1 = QuadrupedDesign(
    name="a1",
    base_size=(0.27, 0.19, 0.114),
    hip_offset=(0.1805, 0.1308),
    hip_radius=0.04,
    hip_to_knee=0.2,
    leg_radius=0.02,
    leg_length=0.22,
    base_mass=8.78,
    hip_mass=1.013,
    leg_mass=0.226,
    hip_range=(-1.05, 4.19),
    knee_range=(-2.7, -0.916),
    stance_angles=(0.8, -1.6),
    motors=MotorConfig(*[JointMotor(stall_torque=33.5, no_load_speed=21.0, kp=224.0, kd=6.0, **MOTOR)] * 2),
).robot()
"""Unitree's A1 with its first joints locked: kp is 5.6 m g L."""


def test_gait_alone_walks_as_commanded():
    found, falls = walked(equal_links(), [(0.2, 0.0), (-0.2, 0.0)], 5.0, 3)
    assert falls == [0, 0]
    assert 0.15 < found[0, 0] < 0.27
    assert -0.27 < found[1, 0] < -0.15


@pytest.mark.slow
@pytest.mark.parametrize("robot", [equal_links(), A1, TWELVE], ids=["equal links", "a1", "twelve joints"])
def test_gait_alone_reaches_what_is_commanded_in_every_direction(robot):
    straight = [(speed, 0.0, 0.0) for speed in (0.2, 0.4, -0.2, -0.29)]
    commands = [*straight, (0.0, 0.5, 0.0), (0.0, 0.0, 0.15)]
    if not robot.moves_sideways:
        commands.pop()
    found, falls = walked(robot, commands)
    assert falls == [0] * len(commands)
    assert 0.15 < found[0, 0] < 0.26
    assert 0.3 < found[1, 0] < 0.5
    assert -0.26 < found[2, 0] < -0.15
    assert -0.4 < found[3, 0] < -0.22
    assert 0.35 < found[4, 1] < 0.7
    if robot.moves_sideways:
        assert 0.1 < found[5, 2] < 0.2
