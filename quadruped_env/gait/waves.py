"""Joint positions as waves, and the trot of any robot, from the path of its feet.

A joint's wave at its leg's angle a is sine * sin(a) + cosine * cos(a) + offset.
"""

import math
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gait_presets import LEG_PHASES, Trot
from quadruped_env.robot.corners import corners, postures_with_feet_at
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

Waves = tuple[Floats, Floats, Floats]
"""Sine part, cosine part and offset of joint positions (..., J), rad."""

_SAMPLES: Final = 24
"""Samples of a cycle."""
_ARC: Final = 0.3
"""Largest height of a stride's arc, as a part of the lift."""
_GRAVITY: Final = 9.81
_LIFTS: Final = 4
_LEAST_RISE: Final = 0.2
"""Least rise of a foot, as a part of the lift."""
_SPEED: Final = 0.6
"""Speed of a joint for the lift alone, as a part of its limit."""
_SLIDING: Final = 1.7
"""Difference of the sides in a turn, relative to the balance of the friction on feet that slide."""
_DRAG: Final = 0.5
"""Part by which strides grow where feet do not rise."""


def joint_phases(robot: Robot, gait: str = "trot") -> Floats:
    """Return the phase of each joint's leg in a gait of `LEG_PHASES` (J,), rad."""
    phases = np.empty(robot.num_joints)
    for joints, phase in zip(robot.leg_joints, leg_phases(robot, gait), strict=True):
        phases[list(joints)] = phase
    return phases


def leg_phases(robot: Robot, gait: str = "trot") -> Floats:
    """Return the phase of each leg in a gait of `LEG_PHASES` (L,), rad."""
    return np.array([LEG_PHASES[gait][corner] for corner in corners(robot)]) * math.tau


def trot_waves(robot: Robot, frequency: float, velocities: Floats, trot: Trot) -> Waves:
    """Return the waves (K, J) of joint targets with which a robot's feet walk at velocities (K, 3).

    The velocities are forward in m/s, the yaw rate in rad/s, and to the left in m/s.

    Of each cycle of a leg's angle a, its foot is in the air while sin(a) > 0, swings forward and rises; then it moves
    backward on the ground, at the velocity commanded. Inverse kinematics gives the joint positions, projection their
    waves. The targets lead these by what the servos need to follow: the torque that holds the weight on two legs, by
    the feet's Jacobians, and the torques of damping and inertia, divided by the gain, and their delay.

    Joints that are too slow for the whole lift get a smaller one, and longer strides, since feet drag.

    Raises:
        QuadrupedError: if the robot has not one leg of two or three joints in each corner, or its feet cannot rise.
    """
    corners(robot)
    lift = reachable_lift(robot, frequency, trot)
    gain = 1.0 + _DRAG * (1.0 - lift / trot.lift)
    waves = joint_waves(robot, frequency, gain * velocities, lift, trot.height)
    return _leading(robot, math.tau * frequency, *waves)


def reachable_lift(robot: Robot, frequency: float, trot: Trot) -> float:
    """Return the lift of a trot, or a smaller one if the joints are too slow for it; as in `Trot`.

    Raises:
        QuadrupedError: if the legs cannot lift their feet, or a motor has no gain.
    """
    if not all(motor.kp for motor in robot.motors.of_joints(robot.joint_kinds)):
        raise QuadrupedError(f"gait: a motor of {robot.name!r} has kp 0 N m/rad, so its joint follows no gait")
    still, lift = np.zeros((1, 3)), trot.lift
    for _ in range(_LIFTS):
        sine, cosine, offset = joint_waves(robot, frequency, still, lift, trot.height)
        _check_lift(robot, lift, sine, cosine, offset)
        amplitude = np.hypot(sine, cosine)[0]
        share = float((_SPEED * robot.velocity_limit / (math.tau * frequency * amplitude + 1e-9)).min())
        if share >= 1.0:
            break
        lift *= share
    return lift


def joint_waves(robot: Robot, frequency: float, velocities: Floats, lift: float, height: float) -> Waves:
    """Return the waves of the joints (K, J) with the feet on the path of a trot."""
    angle = math.tau * np.arange(_SAMPLES) / _SAMPLES
    along = np.where(angle < math.pi, -np.cos(angle), 3.0 - 2.0 / math.pi * angle)  # from -1 to 1 and back
    home = robot.skeleton.foot_centres(robot.stance)
    forward, yaw_rate, lateral = velocities.T[:, :, None]
    speed = np.zeros((len(velocities), *home.shape))
    if robot.moves_sideways:
        speed[..., 0], speed[..., 1] = forward - yaw_rate * home[:, 1], lateral + yaw_rate * home[:, 0]
    else:
        # Feet at (x, y) that slide sideways by w x balance those that slide along x by (k - 1) w y at 1 + (x / y)^2.
        x, y = np.abs(home[:, :2]).mean(axis=0)
        speed[..., 0] = forward - _SLIDING * (1.0 + (x / y) ** 2) * yaw_rate * home[:, 1]
    away, leg = speed[:, None] * along[:, None, None] / (4.0 * frequency), robot.stance_height
    # On an arc, so that a stride turns a leg about its hip and leaves its knee for the lift. A foot must pass over it.
    arc = leg - np.sqrt(np.maximum(0.0, leg * leg - (away * away).sum(axis=-1)))
    arc = np.minimum(arc, _ARC * lift * leg)
    up = lift * np.maximum(0.0, np.sin(angle)) + 1.0 - height
    feet = home + away
    feet[..., 2] += arc + leg * up[:, None]
    joints = postures_with_feet_at(robot, feet.reshape(-1, *home.shape)).reshape(*feet.shape[:2], -1)
    wave = 2.0 / _SAMPLES
    sine = wave * (joints * np.sin(angle)[:, None]).sum(axis=1)
    cosine = wave * (joints * np.cos(angle)[:, None]).sum(axis=1)
    return sine, cosine, joints.mean(axis=1)


def _check_lift(robot: Robot, lift: float, sine: Floats, cosine: Floats, offset: Floats) -> None:
    """Check that the feet of a robot that marches on the spot rise by a part of the stance's height."""
    middle = np.concatenate([offset + sine, offset - sine])  # of the swing, and of the time on the ground
    top, bottom = robot.skeleton.foot_centres(middle)[..., 2]
    leg = int((top - bottom).argmin())
    rise, wanted = (top - bottom)[leg], lift * robot.stance_height
    if rise < _LEAST_RISE * wanted:
        raise QuadrupedError(
            f"gait: leg {robot.leg_names[leg]} of {robot.name!r} can lift its foot by {1e3 * rise:.0f} mm of the "
            f"{1e3 * wanted:.0f} mm of a trot: bend the knees of its stance, or widen the ranges of its joints"
        )


def _leading(robot: Robot, rate: float, sine: Floats, cosine: Floats, offset: Floats) -> Waves:
    """Return the waves of the targets with which the joints follow their own, at an angular frequency in rad/s."""
    motors = robot.motors.of_joints(robot.joint_kinds)
    kp = np.array([motor.kp for motor in motors])
    damping = np.array([motor.kd + motor.damping for motor in motors])
    inertia = np.array([motor.armature for motor in motors])
    held = weight_torque(robot) / kp
    # As cosine - i sine times e^(i a). A foot carries while sin(a) < 0: by half of the time, and -2/pi sin(a).
    wave = (cosine - 1j * sine) * (1.0 + (1j * rate * damping - rate * rate * inertia) / kp) + 2j / math.pi * held
    wave = wave * np.exp(1j * rate * robot.motors.delay)
    return -wave.imag, wave.real, offset + 0.5 * held


def weight_torque(robot: Robot) -> Floats:
    """Return the torque of each joint (J,) in N m with which its leg carries half of the robot's weight."""
    jacobians = robot.skeleton.foot_jacobians(robot.stance)
    return -0.5 * robot.total_mass * _GRAVITY * jacobians[:, 2].sum(axis=0)


def wave_positions(phase: Floats, phases: Floats, sine: Floats, cosine: Floats, offset: Floats) -> Floats:
    """Return joint positions (N, J) in rad at gait phases (N,) in rad.

    `phases` is the result of `joint_phases` (J,), and the other three are from `CommandedGait.waves` (N, J).
    """
    angle = phase[:, None] + phases
    return sine * np.sin(angle) + cosine * np.cos(angle) + offset
