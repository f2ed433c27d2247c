"""Motor parameters: those of the model file, or those identified on a robot."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.parameters import LARGEST, SMALLEST, is_quantity
from quadruped_env.utils.plain import PlainFields

VOLTAGE: Final = 24.0
"""Supply voltage, V; only torque and speed at this voltage matter (assets/mini_quadruped/README.md)."""

GEAR_RATIO: Final = 100.0
"""Turns of a rotor per turn of its joint; only the rotor's inertia at the joint matters
(assets/mini_quadruped/README.md)."""

MAX_DELAY: Final = 0.5
"""Maximum delay, s."""

JOINT_KINDS: Final = ("hip", "knee")
"""Fields of `MotorConfig`, of which each joint of a robot has one as its motor."""

_POSITION: Final = 1
"""MuJoCo's mode of a DC motor whose control is a joint position."""
_LINEAR: Final = 1
"""MuJoCo's mode of interpolation between stored commands."""
_POSITIVE: Final = ("stall_torque", "no_load_speed", "armature")


@dataclass(frozen=True)
class JointMotor(PlainFields):
    """A motor and the joint that it turns. The defaults are the built-in robot's."""

    stall_torque: float = 10.0
    """Torque at full voltage and zero speed, N m."""
    no_load_speed: float = 5.0
    """Speed at full voltage and zero torque, rad/s."""
    kp: float = 40.0
    """Position gain, N m/rad, within the motor's torque-speed line."""
    kd: float = 1.0
    """Velocity gain, N m s/rad."""
    damping: float = 0.05
    """Viscous damping of bearings and gears, N m s/rad."""
    friction_loss: float = 0.0
    """Dry friction, N m."""
    armature: float = 0.01
    """Rotor inertia reflected to the joint, kg m^2."""

    def __post_init__(self) -> None:
        super().__post_init__()
        for entry in fields(self):
            _check(entry.name, getattr(self, entry.name), positive=entry.name in _POSITIVE)

    @property
    def torque_constant(self) -> float:
        """Torque per current, and voltage per speed, at the joint: K in N m/A = V s/rad."""
        return VOLTAGE / self.no_load_speed

    @property
    def resistance(self) -> float:
        """Resistance of the winding, R in Ohm: at rest the supply drives the stall torque's current through it."""
        return self.torque_constant * VOLTAGE / self.stall_torque

    @property
    def joule_coefficient(self) -> float:
        """Heat in the winding per squared torque, R / K^2 in W/(N m)^2; it does not depend on the supply voltage."""
        return self.resistance / self.torque_constant**2

    @property
    def rotor_inertia(self) -> float:
        """Inertia of the rotor about its own axis, before the gear, kg m^2."""
        return self.armature / GEAR_RATIO**2


@dataclass(frozen=True)
class MotorConfig(PlainFields):
    """All motors of a robot, of two kinds; the robot says which joint has which (`Robot.joint_kinds`)."""

    hip: JointMotor = field(default_factory=JointMotor)
    """Motor of the hips: by default of all joints but the knees."""
    knee: JointMotor = field(default_factory=JointMotor)
    """Motor of the knees: by default of each leg's last joint, if it is not the only one."""
    delay: float = 0.0
    """Delay from joint target to motor, s; interpolated between physics steps."""

    def __post_init__(self) -> None:
        super().__post_init__()
        _check("delay", self.delay)
        if self.delay > MAX_DELAY:
            raise QuadrupedError(f"motor: delay must be at most {MAX_DELAY:g} s; found {self.delay!r}; give it in s")

    def of_joints(self, kinds: Sequence[str]) -> list[JointMotor]:
        """The motor of each joint, for the kinds of the joints (`Robot.joint_kinds`)."""
        return [getattr(self, kind) for kind in kinds]

    def joule_coefficients(self, kinds: Sequence[str]) -> NDArray[np.float64]:
        """Heat in each joint's winding per squared torque (J,), W/(N m)^2; `kinds` as in `of_joints`."""
        return np.array([motor.joule_coefficient for motor in self.of_joints(kinds)])

    def write(self, spec: mujoco.MjSpec, kinds: Sequence[str], max_delay: float | None = None) -> None:
        """Set these motors in a robot's specification.

        Args:
            spec: specification of a robot; its time step must already be set.
            kinds: kinds of the robot's joints, which are in the order of the actuators.
            max_delay: maximum delay to allocate a buffer for, s. None: the delay of this config.
        """
        for actuator, motor in zip(spec.actuators, self.of_joints(kinds), strict=True):
            joint = spec.joint(actuator.target)
            joint.damping[0] = motor.damping
            joint.frictionloss = motor.friction_loss
            joint.armature = motor.armature
            actuator.set_to_dcmotor(
                motorconst=[0.0, 0.0],
                resistance=0.0,
                nominal=[VOLTAGE, motor.stall_torque, motor.no_load_speed],
                saturation=[motor.stall_torque, 0.0, 0.0],
                controller=[motor.kp, 0.0, motor.kd, 0.0, 0.0, VOLTAGE],
                ctrlspec=_POSITION,
            )
        self.write_delay(spec, self.delay if max_delay is None else max_delay)

    def write_delay(self, spec: mujoco.MjSpec, max_delay: float) -> None:
        """Set the delay in a robot's specification, with a buffer for delays up to `max_delay` in s."""
        if max_delay > 0.0:
            for actuator in spec.actuators:
                actuator.delay, actuator.interp = self.delay, _LINEAR
                actuator.nsample = math.ceil(max_delay / spec.option.timestep - 1e-9) + 1


def fill_command_history(
    model: mujoco.MjModel, history: NDArray[np.float64], joint_target: NDArray[np.float64]
) -> None:
    """Initialize the buffers of delayed motors as if the targets (N, 8) in rad had been constant before.

    Args:
        model: the robot.
        history: MuJoCo's history buffers (N, model.nhistory), written in place.
        joint_target: joint targets (N, 8), rad.
    """
    for actuator in range(model.nu):
        start, samples = model.actuator_historyadr[actuator], model.actuator_history[actuator, 0]
        if start >= 0:
            # A buffer has two internal numbers of MuJoCo, then the times, then the values.
            values = slice(start + 2 + samples, start + 2 + 2 * samples)
            history[:, values] = joint_target[:, actuator, None]


def _check(name: str, value: Any, positive: bool = False) -> None:
    if not is_quantity(value, SMALLEST if positive else 0.0):
        rule = f"positive, {SMALLEST:g} or more" if positive else "0 or more"
        raise QuadrupedError(f"motor: {name} must be a number, {rule}, at most {LARGEST:g}; found {short(value)}")
