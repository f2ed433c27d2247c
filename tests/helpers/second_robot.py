"""Another robot than the built-in one, in the file of a user: other dimensions, masses, motors, and order of legs."""

from quadruped_env.robot import JointMotor, MotorConfig, QuadrupedDesign

DESIGN = QuadrupedDesign(
    name="tall",
    leg_names=("RH", "LF", "LH", "RF"),
    base_size=(0.36, 0.18, 0.08),
    hip_offset=(0.18, 0.12),
    hip_to_knee=0.05,
    leg_radius=0.025,
    leg_length=0.2,
    base_mass=3.0,
    hip_mass=0.3,
    leg_mass=0.3,
    hip_range=(-1.4, 1.4),
    knee_range=(-2.1, -0.05),
    stance_angles=(0.7, -0.885),
    motors=MotorConfig(
        JointMotor(stall_torque=14.0, no_load_speed=7.0, kp=70.0, kd=1.5),
        JointMotor(stall_torque=14.0, no_load_speed=7.0, kp=60.0, kd=1.5),
    ),
)
ROBOT = DESIGN.robot()
