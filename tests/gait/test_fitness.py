"""The check of a robot's numbers before a training: the formulas by hand, and one weakness at a time."""

import dataclasses
import math
import re

import pytest
import second_robot
import twelve_joints

from quadruped_env.gait import fitness
from quadruped_env.gait.gait_presets import TROTS
from quadruped_env.robot import MINI_QUADRUPED, JointMotor, MotorConfig, QuadrupedDesign

STRONG = {"stall_torque": 20.0, "no_load_speed": 20.0, "kp": 60.0}
THIGH, SHANK, BEND, RADIUS = 0.15, 0.15, 0.7, 0.015
"""Lengths, m, and angle between thigh and vertical, rad: thighs point back, and shanks forward by the same angle."""


def planar(motor=None, **changes):
    """A robot with equal links and its feet under its hips, and its weight in N."""
    motor = JointMotor(**{**STRONG, **(motor or {})})
    design = {
        "name": "planar",
        "hip_to_knee": THIGH,
        "leg_length": SHANK + RADIUS,
        "leg_radius": RADIUS,
        "knee_range": (-2.6, 0.0),
        "stance_angles": (BEND, -2.0 * BEND),
        "motors": MotorConfig(motor, motor),
    }
    robot = QuadrupedDesign(**design | changes).robot()
    return robot, 9.81 * robot.total_mass


ARM = SHANK * math.sin(BEND)
"""Distance of the feet from the knees along x, m; from the hips it is zero."""


def numbers(line):
    return [float(text) for text in re.findall(r"(?<![\w.])\d+(?:\.\d+)?", line)]


@pytest.mark.parametrize("robot", [MINI_QUADRUPED, second_robot.ROBOT, twelve_joints.robot(), planar()[0]])
def test_strong_robots_lack_nothing(robot):
    assert fitness(robot) == []


def test_gain_is_compared_with_the_sag_of_two_legs_that_carry_the_weight():
    robot, weight = planar({"kp": 4.0})
    rise = 1e3 * TROTS["sinusoid"].lift * robot.stance_height
    sag = 1e3 * ARM**2 / 4.0 * weight / 2.0
    assert sag > 0.4 * rise
    (line,) = fitness(robot)
    assert line.startswith("kp 4 N m/rad: in a trot the robot sinks by ")
    *_, found_sag, found_rise, enough = numbers(line)
    assert (found_sag, found_rise) == (round(sag), round(rise))
    assert fitness(planar({"kp": enough})[0]) == []
    assert fitness(planar({"kp": 0.9 * enough})[0]) != []


def test_torque_is_compared_with_two_legs_that_carry_the_weight():
    _, weight = planar()
    needed = 2.0 * ARM * weight / 2.0
    assert fitness(planar({"stall_torque": 1.01 * needed})[0]) == []
    (line,) = fitness(planar({"stall_torque": 0.9 * needed})[0])
    assert re.search(r"on two legs \w\w_knee_joint carries", line)
    assert numbers(line)[-1] == pytest.approx(needed, rel=0.1)
    assert numbers(line)[-1] >= needed


def test_speed_is_compared_with_the_fastest_command_and_the_rise():
    (line,) = fitness(planar({"no_load_speed": 2.5})[0])
    assert line.startswith("no-load speed 2.5 rad/s: the feet rise by ")
    assert fitness(planar({"no_load_speed": numbers(line)[-1]})[0]) == []
    # The same clock is slower for the joints of a robot that takes fewer steps, but its strides are longer.
    assert fitness(planar({"no_load_speed": 2.5})[0], frequency=1.0) != []


@pytest.mark.parametrize(("kp", "subjects"), [(25.0, ["no-load speed"]), (8.0, ["no-load speed", "kp"])])
def test_gain_is_not_blamed_for_feet_that_slow_joints_do_not_lift(kp, subjects):
    """What the lines name does together, and none of it is due to another one."""
    found = fitness(planar({"no_load_speed": 1.0, "kp": kp})[0])
    assert [re.split(r" \d", line)[0] for line in found] == subjects
    cure = {name: numbers(line)[-1] for name, line in zip(("no_load_speed", "kp"), found, strict=False)}
    assert fitness(planar({"kp": kp, **cure})[0]) == []


def test_motors_of_the_task_replace_the_robots():
    (robot, _), weak = planar(), JointMotor(**STRONG | {"kp": 4.0, "stall_torque": 1.0})
    assert fitness(robot, motors=robot.motors) == []
    found = fitness(robot, motors=MotorConfig(weak, weak))
    assert [line.split(":")[0] for line in found] == ["kp 4 N m/rad", "stall torque 1 N m"]
    assert found == fitness(planar({"kp": 4.0, "stall_torque": 1.0})[0])


def test_servo_errors_are_compared_with_the_rise():
    robot, _ = planar()
    allowed = 0.4 * TROTS["sinusoid"].lift * robot.stance_height / ARM
    for name, share in (("target_step", 0.5), ("backlash", 0.5), ("dead_band", 1.0)):
        assert fitness(planar({name: 0.98 * allowed / share})[0]) == []
        (line,) = fitness(planar({name: 1.02 * allowed / share})[0])
        assert line.startswith("servo step, backlash and dead band: a foot's height is off by up to ")
        assert numbers(line)[-1] == pytest.approx(math.degrees(allowed), rel=0.02)


@pytest.mark.parametrize(("hip", "where"), [(-0.9, "behind"), (1.45, "before")])
def test_stance_that_tips_is_named_with_its_distance(hip, where):
    """All feet are ahead of their hips, or behind them, by more than the distance of the hips from the middle."""
    robot, _ = planar(stance_angles=(hip, -0.3), hip_offset=(0.11, 0.10), base_size=(0.22, 0.15, 0.08))
    feet, centre = robot.stance_feet[:, 0], robot.skeleton.centre_of_mass(robot.stance)[0]
    outside = max(centre - feet.max(), feet.min() - centre)
    assert outside > 0.0
    (line,) = [line for line in fitness(robot) if line.startswith("stance: ")]
    assert line == (
        f"stance: the centre of mass is {1e3 * outside:.0f} mm {where} its feet, so it tips; move the feet by "
        f"{1e3 * outside:.0f} mm or more"
    )


def test_robot_that_cannot_walk_by_the_gait_is_one_line():
    straight = QuadrupedDesign(name="straight", knee_range=(-1.0, 1.0), stance_angles=(0.0, 0.0)).robot()
    (line,) = fitness(straight)
    assert "can lift its foot by 0 mm" in line
    (line,) = fitness(dataclasses.replace(second_robot.ROBOT, leg_corners=(0, 0, 2, 3)))
    assert "one leg in each corner" in line
    (line,) = fitness(planar({"kp": 0.0})[0])
    assert "a motor of 'planar' has kp 0 N m/rad" in line
