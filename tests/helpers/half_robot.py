"""The built-in robot at half its size: every number without a dimension is the same."""

from math import sqrt

from quadruped_env.robot import JointMotor, MotorConfig, QuadrupedDesign

SIZE = 0.5
TIME = sqrt(SIZE)
"""Factor on times of similar motions."""
_FULL = QuadrupedDesign()


def _motor(motor: JointMotor) -> JointMotor:
    torque = SIZE**4
    return JointMotor(
        stall_torque=motor.stall_torque * torque,
        no_load_speed=motor.no_load_speed / TIME,
        kp=motor.kp * torque,
        kd=motor.kd * torque * TIME,
        damping=motor.damping * torque * TIME,
        friction_loss=motor.friction_loss * torque,
        armature=motor.armature * torque * TIME**2,
    )


DESIGN = QuadrupedDesign(
    name="half",
    base_size=tuple(SIZE * x for x in _FULL.base_size),
    hip_offset=tuple(SIZE * x for x in _FULL.hip_offset),
    hip_radius=SIZE * _FULL.hip_radius,
    hip_to_knee=SIZE * _FULL.hip_to_knee,
    leg_radius=SIZE * _FULL.leg_radius,
    leg_length=SIZE * _FULL.leg_length,
    base_mass=SIZE**3 * _FULL.base_mass,
    hip_mass=SIZE**3 * _FULL.hip_mass,
    leg_mass=SIZE**3 * _FULL.leg_mass,
    motors=MotorConfig(_motor(_FULL.motors.hip), _motor(_FULL.motors.knee)),
)
ROBOT = DESIGN.robot()
