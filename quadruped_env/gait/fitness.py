"""Check of a robot's numbers against what a trot needs of them, before a training."""

import dataclasses
import math
from collections.abc import Iterator
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gait_presets import SINUSOID, TROTS
from quadruped_env.gait.gaits import CommandedGait, has_tuned_shape
from quadruped_env.gait.waves import joint_waves, reachable_lift, weight_torque
from quadruped_env.robot.corners import corners
from quadruped_env.robot.motors import MotorConfig
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.utils.arrays import Floats

_SAG: Final = 0.4
"""Largest sag under the weight in a trot, as a part of the feet's rise."""
_TORQUE: Final = 2.0
"""Least stall torque, as a multiple of the torque that holds the weight on two legs."""
_RISE: Final = 0.4
"""Least rise of the feet of slow joints, as a part of the whole rise."""
_OVER: Final = 1.2
"""Largest speed of a joint's path, as a multiple of its no-load speed."""
_ERROR: Final = 0.4
"""Largest error of a foot's height by the servos' errors, as a part of the feet's rise."""
_FASTEST: Final = 0.6
"""Fastest forward command, m/s, of a robot as tall as the built-in one."""


def fitness(robot: Robot, frequency: float | None = None, motors: MotorConfig | None = None) -> list[str]:
    """Return what keeps a robot from a trot, one line each with the number that would do; empty if nothing does.

    A robot of the built-in one's shape has its gaits, so its joints' speeds are not checked. `frequency` is its gait
    clock's in Hz, `motors` are its task's (`TaskConfig.motor`); None: the defaults, and the robot's own.
    """
    if motors not in (None, robot.motors):
        by_motors: Any = None
        robot = dataclasses.replace(robot, motors=motors, velocity_limit=by_motors, effort_limit=by_motors)
    if frequency is None:
        frequency = TROTS[SINUSOID].frequency / scale_of("m/s", robot)
    try:
        corners(robot)
        if has_tuned_shape(robot):
            return [*_carrying(robot, _closed_form_rise(robot, frequency)), *_balance(robot)]
        lift = reachable_lift(robot, frequency, TROTS[SINUSOID])
    except QuadrupedError as error:
        return [str(error)]
    slow, rise = _speed(robot, frequency, lift * robot.stance_height)
    # Feet that slow joints do not lift are no reason for a higher gain.
    return [*slow, *_carrying(robot, rise, "then " if slow else ""), *_balance(robot)]


def _closed_form_rise(robot: Robot, frequency: float) -> float:
    """Return the height to which the trot in closed form lifts the feet on the spot, m."""
    sine, _, offset = (values.mean(axis=0) for values in CommandedGait.preset(SINUSOID, robot, frequency).straight)
    top, bottom = robot.skeleton.foot_centres(np.array([offset + sine, offset - sine]))[..., 2]
    return float((top - bottom).min())


def _carrying(robot: Robot, rise: float, then: str = "") -> Iterator[str]:
    """Check gains, stall torques and servo errors in the stance on two legs, for feet that rise by a height in m."""
    motors = robot.motors.of_joints(robot.joint_kinds)
    heights, torque = robot.skeleton.foot_jacobians(robot.stance)[:, 2], weight_torque(robot)
    kp = np.array([motor.kp for motor in motors])
    # The legs bend under the weight by J^T f / kp at each joint.
    sag, softest = float((heights * -torque / kp).sum(axis=1).max()), float(kp.min())
    if sag > _SAG * rise:
        yield (
            f"kp {softest:.3g} N m/rad: in a trot the robot sinks by {1e3 * sag:.0f} mm, and its feet {then}rise by "
            f"{1e3 * rise:.0f}; {_up(softest * sag / (_SAG * rise))} N m/rad or more"
        )
    joint = int((np.abs(torque) / robot.effort_limit).argmax())
    stall, carried = robot.effort_limit[joint], float(np.abs(torque[joint]))
    if _TORQUE * carried > stall:
        yield (
            f"stall torque {stall:.3g} N m: on two legs {robot.joint_names[joint]} carries {carried:.3g} N m; "
            f"{_up(_TORQUE * carried)} N m or more"
        )
    step, backlash, dead_band = robot.motors.servo_errors(robot.joint_kinds)
    errors = 0.5 * step + 0.5 * backlash + dead_band
    height = float((np.abs(heights) * errors).sum(axis=1).max())
    if height > _ERROR * rise:
        yield (
            f"servo step, backlash and dead band: a foot's height is off by up to {1e3 * height:.0f} mm, and its rise "
            f"{then}is {1e3 * rise:.0f}; half of step and backlash and the dead band together "
            f"{math.degrees(errors.max() * _ERROR * rise / height):.2g} degrees or less"
        )


def _speed(robot: Robot, frequency: float, rise: float) -> tuple[list[str], float]:
    """Check the joints' speeds, which limit how far the feet rise, at the fastest forward command.

    Returns:
        The finding, if there is one, and the height in m to which the feet rise with the speed that would do.
    """
    wanted = _RISE * TROTS[SINUSOID].lift
    height, fastest = wanted * robot.stance_height, _FASTEST * scale_of("m/s", robot)
    sine, cosine, _ = joint_waves(robot, frequency, np.array([[fastest, 0.0, 0.0]]), wanted, 1.0)
    needed: Floats = math.tau * frequency * np.hypot(sine, cosine)[0]
    joint = int((needed / robot.velocity_limit).argmax())
    limit, least = float(robot.velocity_limit[joint]), float(needed[joint]) / _OVER
    if least <= limit and rise >= height:
        return [], rise
    enough = max(least, limit * height / rise)
    line = (
        f"no-load speed {limit:.3g} rad/s: the feet rise by {1e3 * rise:.0f} mm; for {1e3 * height:.0f} mm at "
        f"{fastest:.2g} m/s {robot.joint_names[joint]} turns at {needed[joint]:.3g} rad/s; {_up(enough)} rad/s or more"
    )
    return [line], min(rise * enough / limit, TROTS[SINUSOID].lift * robot.stance_height)


def _balance(robot: Robot) -> Iterator[str]:
    """Check that the centre of mass is above the area between the feet in the stance."""
    around = [robot.corners.index(corner) for corner in (0, 2, 3, 1)]  # to the left
    feet, centre = robot.stance_feet[around, :2], robot.skeleton.centre_of_mass(robot.stance)[:2]
    edges = np.roll(feet, -1, axis=0) - feet
    outward = np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.linalg.norm(edges, axis=1)[:, None]
    outside = ((centre - feet) * outward).sum(axis=1)
    side = int(outside.argmax())
    where, distance = ("to the left of", "behind", "to the right of", "before")[side], 1e3 * outside[side]
    if distance > 0.0:
        yield (
            f"stance: the centre of mass is {distance:.0f} mm {where} its feet, so it tips; move the feet by "
            f"{distance:.0f} mm or more"
        )


def _up(value: float) -> str:
    """Return a number with two digits, rounded up."""
    digits = 1 - math.floor(math.log10(value))
    return f"{math.ceil(value * 10**digits - 1e-9) / 10**digits:.{max(digits, 0)}f}"
