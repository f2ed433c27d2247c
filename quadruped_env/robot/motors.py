"""Motor parameters, of the model file or identified on a robot."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Annotated, Any, Final, Self

import mujoco
import numpy as np

from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import Fields, check, with_values
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.plain import Plain

VOLTAGE: Final = 24.0
"""Supply voltage, V; only torque and speed at this voltage matter (assets/mini_quadruped/README.md)."""

GEAR_RATIO: Final = 100.0
"""Turns of a rotor per turn of its joint; only the rotor's inertia at the joint matters
(assets/mini_quadruped/README.md)."""

MAX_DELAY: Final = 0.5
"""Maximum delay, s."""

JOINT_KINDS: Final = ("hip", "knee")
"""Kinds of the joints in a leg of two."""
MOTOR_KINDS: Final = (*JOINT_KINDS, "abduction")
"""Fields of `MotorConfig`, of which each joint of a robot has one as its motor."""

_POSITION: Final = 1
"""MuJoCo's mode of a DC motor whose control is a joint position."""
_LINEAR: Final = 1
"""MuJoCo's mode of interpolation between stored commands."""

SERVO_ERRORS: Final = ("target_step", "backlash", "dead_band")
"""Fields of `JointMotor` that keep a position servo from following its target exactly; see `servo_target`."""


class _MotorFields(Fields, path="motor"):
    """Fields in which a whole number stays one: the SHA-256 of robots that older versions stored tells 10 from 10.0."""

    def __post_init__(self) -> None:
        given = {**vars(self)}
        super().__post_init__()
        vars(self).update({name: value for name, value in given.items() if type(value) is int})


@dataclass(frozen=True)
class JointMotor(_MotorFields):
    """A motor and the joint that it turns. The defaults are the built-in robot's."""

    stall_torque: Annotated[float, Parameter.positive("N m")] = 10.0
    """Torque at full voltage and zero speed, N m."""
    no_load_speed: Annotated[float, Parameter.positive("rad/s")] = 5.0
    """Speed at full voltage and zero torque, rad/s."""
    kp: Annotated[float, Parameter("N m/rad", 0.0)] = 40.0
    """Position gain, N m/rad, within the motor's torque-speed line."""
    kd: Annotated[float, Parameter("N m s/rad", 0.0)] = 1.0
    """Velocity gain, N m s/rad."""
    damping: Annotated[float, Parameter("N m s/rad", 0.0)] = 0.05
    """Viscous damping of bearings and gears, N m s/rad."""
    friction_loss: Annotated[float, Parameter("N m", 0.0)] = 0.0
    """Dry friction, N m."""
    armature: Annotated[float, Parameter.positive("kg m^2")] = 0.01
    """Rotor inertia reflected to the joint, kg m^2."""
    target_step: Annotated[float, Parameter("rad", 0.0)] = 0.0
    """Step to which the servo's input rounds the joint target, rad; 0 for none."""
    backlash: Annotated[float, Parameter("rad", 0.0)] = 0.0
    """Play of the gears, rad: after a reversal the target moves this far before the joint follows."""
    dead_band: Annotated[float, Parameter("rad", 0.0)] = 0.0
    """Error of the position, to either side, up to which the servo does not pull, rad."""

    @classmethod
    def hobby_servo(
        cls,
        stall_torque: float,
        no_load_speed: float,
        dead_band: float = math.radians(0.5),
        backlash: float = math.radians(1.0),
        target_step: float = math.radians(1.0),
    ) -> Self:
        """Return a position-only servo from the numbers of its data sheet, in N m, rad/s and rad.

        A data sheet gives the dead band in microseconds; most servos turn by 0.1 degrees in one. Arduino's
        `Servo.write` takes whole degrees, and a PCA9685 at 50 Hz has steps of 4.9 us.

        No data sheet gives the rest. A Feetech STS3215 has it, in proportion to torque and speed: for a stall
        torque of 3.35 N m, kp = 17.8, armature = 0.028 and dry friction 0.052 N m (joints_properties.xml of
        https://github.com/apirrone/Open_Duck_Playground). The backlash of 1 degree is assumed. The motor is driven by a
        voltage in proportion to the error, less a back-EMF in proportion to the speed: kd = stall torque / no-load
        speed.
        """
        kd = stall_torque / no_load_speed
        return cls(
            stall_torque=stall_torque,
            no_load_speed=no_load_speed,
            kp=stall_torque * 17.8 / 3.35,
            kd=kd,
            damping=0.0,
            friction_loss=stall_torque * 0.052 / 3.35,
            armature=kd * 0.028 / 0.60,
            target_step=target_step,
            backlash=backlash,
            dead_band=dead_band,
        )

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


def _changes_or_motor(value: Plain, path: str) -> Plain:
    check(value is None or isinstance(value, Mapping | JointMotor), path, value, "fields of a motor, or None")
    return value


@dataclass(frozen=True)
class MotorConfig(_MotorFields):
    """All motors of a robot, by kind; the robot says which joint has which (`Robot.joint_kinds`)."""

    hip: JointMotor = field(default_factory=JointMotor)
    """Motor of the hips: by default of all joints but the knees."""
    knee: JointMotor = field(default_factory=JointMotor)
    """Motor of the knees: by default of each leg's last joint, if it is not the only one."""
    delay: Annotated[float, Parameter("s", 0.0, MAX_DELAY)] = 0.0
    """Delay from joint target to motor, s; interpolated between physics steps."""
    abduction: Annotated[JointMotor | None, _changes_or_motor] = None
    """Motor of the joints that move the feet sideways, in legs of three joints or more. None: the hips'; a dict has
    the fields that differ from the hips'."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if isinstance(self.abduction, Mapping):
            changed = with_values(self.hip, self.abduction, "config.motor.abduction")
            object.__setattr__(self, "abduction", changed)

    def to_dict(self) -> dict[str, Plain]:
        """Return the nested plain values, without `abduction` where it is None."""
        return {name: value for name, value in super().to_dict().items() if value is not None}

    def of_joints(self, kinds: Sequence[str]) -> list[JointMotor]:
        """Return the motor of each joint, for the kinds of the joints (`Robot.joint_kinds`)."""
        return [getattr(self, kind) or self.hip for kind in kinds]

    def joule_coefficients(self, kinds: Sequence[str]) -> Floats:
        """Return the heat in each joint's winding per squared torque (J,), W/(N m)^2; `kinds` as in `of_joints`."""
        return np.array([motor.joule_coefficient for motor in self.of_joints(kinds)])

    def servo_errors(self, kinds: Sequence[str]) -> list[Floats]:
        """Return the `SERVO_ERRORS` of each joint, (J,) each, rad; `kinds` as in `of_joints`."""
        return [np.array([getattr(motor, name) for motor in self.of_joints(kinds)]) for name in SERVO_ERRORS]

    def content(self) -> dict[str, Any]:
        """Return plain values, with the `SERVO_ERRORS` only of servos that have them: a part of a robot's identity."""
        values = self.to_dict()
        for kind in MOTOR_KINDS & values.keys():
            values[kind] = {k: v for k, v in values[kind].items() if v or k not in SERVO_ERRORS}
        return values

    def write(self, spec: mujoco.MjSpec, kinds: Sequence[str]) -> None:
        """Set these motors in a robot's specification, but for their delay; `kinds` as in `of_joints`."""
        for actuator, motor in zip(spec.actuators, self.of_joints(kinds), strict=True):
            joint = spec.joint(actuator.target)
            joint.damping[:] = [motor.damping, 0.0, 0.0]
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

    def write_delay(self, spec: mujoco.MjSpec, max_delay: float) -> None:
        """Set the delay in a specification with a time step, with a buffer for delays up to `max_delay` in s."""
        if max_delay > 0.0:
            for actuator in spec.actuators:
                actuator.delay, actuator.interp = self.delay, _LINEAR
                actuator.nsample = math.ceil(max_delay / spec.option.timestep - 1e-9) + 1


def servo_target(
    target: Floats,
    position: Floats,
    play: Floats,
    target_step: Floats,
    backlash: Floats,
    dead_band: Floats,
) -> Floats:
    """Return the position that a servo's gains pull to, for a joint target; all arrays (N, J) or broadcastable, in rad.

    The target is rounded to a multiple of the step. The joint's end of the gears follows it as a play operator: pushed
    from either side of the backlash, and else at rest. Within the dead band the servo pulls to where the joint is, and
    beyond it by the error less the dead band, so that the joint comes to rest up to the dead band away.

    `position` is what the servo measures, and `play` the position of the joint's end of the gears, which begins at the
    joint's position and is updated in place.
    """
    step = np.where(target_step > 0.0, target_step, 1.0)
    rounded = np.where(target_step > 0.0, step * np.rint(target / step), target)
    play[:] = np.minimum(np.maximum(play, rounded - 0.5 * backlash), rounded + 0.5 * backlash)
    error = play - position
    return play - np.minimum(np.maximum(error, -dead_band), dead_band)


def fill_command_history(model: mujoco.MjModel, history: Floats, joint_target: Floats) -> None:
    """Fill MuJoCo's history buffers (N, model.nhistory) as if joint targets (N, J) in rad had been constant before."""
    for actuator in range(model.nu):
        start, samples = model.actuator_historyadr[actuator], model.actuator_history[actuator, 0]
        if start >= 0:
            # A buffer has two internal numbers of MuJoCo, then the times, then the values.
            values = slice(start + 2 + samples, start + 2 + 2 * samples)
            history[:, values] = joint_target[:, actuator, None]


_MG996R: Final = JointMotor.hobby_servo(stall_torque=1.08, no_load_speed=math.radians(60.0) / 0.14)
"""TowerPro's data sheet at 6 V: 11 kgf cm, 60 degrees in 0.14 s, a dead band of 5 us."""

MOTOR_PRESETS: Final[Mapping[str, MotorConfig]] = MappingProxyType(
    # A pulse every 20 ms, which comes up to so long after its target.
    {"mg996r": MotorConfig(_MG996R, _MG996R, delay=0.02)}
)
"""Motors by name, for `config["motor"]` and a robot's `motors`."""
