"""Motor parameters: those of the model file, or those identified on a robot."""

import math
from dataclasses import dataclass, field, fields
from typing import Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env._plain import PlainFields, is_finite_number
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.facts import EFFORT_LIMIT, JOINT_NAMES, VELOCITY_LIMIT

VOLTAGE: Final = 24.0
"""Supply voltage, V; only torque and speed at this voltage matter (assets/mini_quadruped/README.md)."""

MAX_DELAY: Final = 0.5
"""Maximum delay, s."""

JOINT_KINDS: Final = ("hip", "knee")

_LINEAR: Final = 1
"""MuJoCo's mode of interpolation between stored commands."""
_POSITIVE: Final = ("stall_torque", "no_load_speed", "armature")


@dataclass(frozen=True)
class JointMotor(PlainFields):
    """A motor and the joint that it turns. The defaults repeat the model file."""

    stall_torque: float = EFFORT_LIMIT
    """Torque at full voltage and zero speed, N m."""
    no_load_speed: float = VELOCITY_LIMIT
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


@dataclass(frozen=True)
class MotorConfig(PlainFields):
    """All motors of the robot: one set of parameters for the hips, one for the knees."""

    hip: JointMotor = field(default_factory=JointMotor)
    knee: JointMotor = field(default_factory=JointMotor)
    delay: float = 0.0
    """Delay from joint target to motor, s; interpolated between physics steps."""

    def __post_init__(self) -> None:
        super().__post_init__()
        _check("delay", self.delay)
        if self.delay > MAX_DELAY:
            raise QuadrupedError(f"motor: delay must be at most {MAX_DELAY:g} s; found {self.delay!r}; give it in s")

    def of_joint(self, name: str) -> JointMotor:
        """The motor of a joint."""
        return self.hip if "hip" in name else self.knee

    def write(self, spec: mujoco.MjSpec, max_delay: float | None = None) -> None:
        """Set these motors in a robot's specification.

        Args:
            spec: specification that `build_model` compiles; its time step must already be set.
            max_delay: maximum delay to allocate a buffer for, s. None: the delay of this config.
        """
        longest = self.delay if max_delay is None else max_delay
        for name in JOINT_NAMES:
            motor, joint, actuator = self.of_joint(name), spec.joint(name), spec.actuator(name)
            joint.damping[0] = motor.damping
            joint.frictionloss = motor.friction_loss
            joint.armature = motor.armature
            actuator.set_to_dcmotor(
                motorconst=[0.0, 0.0],
                resistance=0.0,
                nominal=[VOLTAGE, motor.stall_torque, motor.no_load_speed],
                saturation=[motor.stall_torque, 0.0, 0.0],
                controller=[motor.kp, 0.0, motor.kd, 0.0, 0.0, VOLTAGE],
                ctrlspec=actuator.ctrlspec,
            )
            if longest > 0.0:
                actuator.delay, actuator.interp = self.delay, _LINEAR
                actuator.nsample = math.ceil(longest / spec.option.timestep - 1e-9) + 1


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
    if not is_finite_number(value) or value < 0 or (positive and value == 0):
        rule = "positive" if positive else "0 or more"
        raise QuadrupedError(f"motor: {name} must be a finite number, {rule}; found {short(value)}")
