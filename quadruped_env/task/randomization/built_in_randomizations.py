"""Built-in randomizations: what is drawn, by which law, in which unit, and what the ranges of the presets rest on."""

import math
from functools import partial
from operator import attrgetter
from typing import Final

import numpy as np

from quadruped_env.robot.motors import MAX_DELAY
from quadruped_env.robot.robot import Robot
from quadruped_env.task.randomization.model_fields import ModelField, MotorField, Payload
from quadruped_env.task.randomization.randomization import Event, Randomization, SensorError
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.parameters import Parameter

_FACTOR: Final = Parameter.positive()
_NOT_NEGATIVE: Final = 0.0
_SMALL_ANGLE: Final = Parameter("rad", 0.0, 0.2)

_MINITAUR: Final = "Tan et al. 2018, arXiv:1804.10332"
_ANYMAL: Final = "Hwangbo et al. 2019, arXiv:1901.08652"
_RMA: Final = "Kumar et al. 2021, arXiv:2107.04034"
_MINUTES: Final = "Rudin et al. 2021, arXiv:2109.11978"
_PENG: Final = "Peng et al. 2018, arXiv:1710.06537"

# Columns of `actuator_gainprm` of MuJoCo's dcmotor.
_RESISTANCE: Final = 0
_POSITION_GAIN: Final = 4
_VELOCITY_GAIN: Final = 6
_VOLTAGE: Final = 7


def _add(array: str, columns: slice, event: Event, values: Floats) -> None:
    getattr(event, array)[:, columns] += values


def _payload_position(event: Event, values: Floats) -> None:
    event.payload_position = values


def _push(width: int, columns: slice, event: Event, values: Floats) -> None:
    velocity = np.zeros((len(values), width))
    velocity[:, columns] = values
    event.simulation.push(event.env_ids, velocity)


def _force(event: Event, values: Floats) -> None:
    force = np.zeros((len(values), 3))
    force[:, :2] = values
    event.simulation.set_force(event.env_ids, force)


def _worsen_servos(quantity: str, event: Event, values: Floats) -> None:
    assert event.servos is not None
    event.servos.add(quantity, event.env_ids, values)


def _base(robot: Robot) -> tuple[str, ...]:
    return (robot.base_name,)


_links = attrgetter("link_names")
_joints = attrgetter("joint_names")


# fmt: off
RANDOMIZATIONS: Final[tuple[Randomization, ...]] = (
    Randomization("start_joint_position", partial(_add, "qpos", slice(7, None)), 0.1, "rad", "joints",
        description="offset of each joint from the stance at the start",
        source="part of the task"),
    Randomization("start_joint_velocity", partial(_add, "qvel", slice(6, None)), 0.5, "rad/s", "joints",
        description="velocity of each joint at the start",
        source="part of the task"),
    Randomization("start_base_velocity", partial(_add, "qvel", slice(0, 3)), 0.2, "m/s", 3,
        description="velocity of the base along each axis at the start",
        source="part of the task"),
    Randomization("start_base_rotation", partial(_add, "qvel", slice(3, 6)), 0.2, "rad/s", 3,
        description="angular velocity of the base about each of its axes at the start",
        source="part of the task"),
    Randomization("start_tilt", partial(_add, "tilt", slice(0, 2)), 0.05, "rad", 2,
        description="roll and pitch of the base at the start",
        source="part of the task"),
    Randomization("start_heading", partial(_add, "tilt", slice(2, 3)), math.pi, "rad",
        description="heading at the start",
        source="part of the task"),
    # MuJoCo uses the larger friction of the two geoms in contact, so all geoms are set.
    Randomization("friction", ModelField("geom_friction", column=0, mode="set"), None, valid=Parameter.positive(),
        description="coefficient of sliding friction of the ground and the robot",
        source=f"0.5 to 1.25: {_MINITAUR}; rubber on wet tiles to rubber on dry concrete: 0.3 to 1.2"),
    Randomization("contact_time_constant", ModelField("geom_solref", column=0, mode="set"), None, "s",
        valid=Parameter("s", 0.001, 0.1),
        description="time constant with which a contact gives way; the model file has 0.01 s",
        source="twice the physics time step is the shortest; 0.02 s is MuJoCo's default; soft rubber, carpet"),
    Randomization("contact_damping_ratio", ModelField("geom_solref", column=1, mode="set"), None, valid=_FACTOR,
        description="damping ratio of a contact; below 1 it rebounds",
        source="1 in the model file; a solid rubber ball returns half of its speed at 0.2"),
    Randomization("link_mass", ModelField("body_mass", _links), None, width="links", valid=_FACTOR,
        description="factor on the mass of each link, whose inertia follows",
        source=f"0.8 to 1.2: {_MINITAUR}"),
    Randomization("link_inertia", ModelField("body_inertia", _links), None, width="links", valid=_FACTOR,
        description="factor on the inertia of each link, beyond the factor on its mass",
        source=f"0.5 to 1.5: {_MINITAUR}; less here, because the mass changes the inertia, too"),
    Randomization("base_com", ModelField("body_ipos", _base, mode="add"), 0.0, "m", 3,
        valid=Parameter("m", -0.2, 0.2),
        description="offset of the base's own centre of mass along each axis",
        source=f"+-0.02 m: {_ANYMAL}"),
    Randomization("payload_position", _payload_position, 0.0, "m", 3, valid=Parameter("m", -0.5, 0.5),
        description="position of a payload relative to the base's centre of mass along each axis",
        source="two thirds of the way from the base's centre to its sides"),
    Randomization("payload", Payload(), None, "kg", valid=Parameter("kg", -1.0, exclusive=True),
        description="mass added to the base, of the base's shape; a negative one is missing in the base as a whole",
        source=f"from a battery less to half of the base more; up to half of the robot: {_RMA}"),
    Randomization("motor_strength",
        (MotorField("actuator_gainprm", column=_RESISTANCE, mode="divide"), MotorField("actuator_forcerange")),
        None, width="joints", valid=_FACTOR,
        description="factor on the stall torque of each motor; the no-load speed stays",
        source=f"0.8 to 1.2: {_MINITAUR}"),
    Randomization("supply_voltage",
        (MotorField("actuator_gainprm", column=_VOLTAGE), MotorField("actuator_forcerange")), None,
        valid=_FACTOR,
        description="factor on the supply voltage: on stall torque and no-load speed of all motors",
        source=f"six lithium cells of 3.4 to 4.2 V give 0.85 to 1.05 of 24 V; 14 to 16.8 V: {_MINITAUR}"),
    Randomization("position_gain", MotorField("actuator_gainprm", column=_POSITION_GAIN), None, width="joints",
        valid=_FACTOR,
        description="factor on the position gain of each motor",
        source=f"no data sheet states the tolerance of a gain; 0.5 to 2: {_PENG}; 0.9 to 1.1: {_RMA}"),
    Randomization("velocity_gain", MotorField("actuator_gainprm", column=_VELOCITY_GAIN), None, width="joints",
        valid=_FACTOR,
        description="factor on the velocity gain of each motor",
        source="as the position gain"),
    Randomization("joint_friction", ModelField("dof_frictionloss", _joints, mode="add"), None, "N m", "joints",
        valid=Parameter("N m", _NOT_NEGATIVE),
        description="dry friction added to each joint",
        source=f"0 to 0.05 N m: {_MINITAUR}; 1 % of the stall torque is 0.1 N m here"),
    Randomization("joint_damping", ModelField("dof_damping", _joints), None, width="joints", law="log_uniform",
        valid=_FACTOR,
        description="factor on the viscous damping of each joint",
        source=f"0.2 to 20: {_PENG}; dry friction of 0.1 N m takes as much power at 4 rad/s as 0.03 N m s/rad more"),
    Randomization("rotor_inertia", ModelField("dof_armature", _joints), None, width="joints", law="log_uniform",
        valid=_FACTOR,
        description="factor on the rotor inertia of each motor, at its joint",
        source="the gear ratio counts squared, and data sheets leave out the gears' own inertia"),
    Randomization("encoder_offset", SensorError("encoder_offset"), 0.0, "rad", "joints",
        valid=Parameter("rad", -0.5, 0.5),
        description="reading of each encoder minus the joint's position; it shifts the joint target, too",
        source="a stance that was set by eye or with a simple jig is right to 1 or 2 degrees"),
    Randomization("imu_mounting", SensorError("imu_mounting"), 0.0, "rad", 3, valid=Parameter("rad", -0.5, 0.5),
        description="roll, pitch and yaw of the IMU in the base; it turns gravity and gyroscope readings",
        source="1 mm under one end of a board of 40 mm is 0.025 rad"),
    Randomization("target_step", partial(_worsen_servos, "target_step"), None, "rad", valid=_SMALL_ANGLE,
        description="step to which servos round the joint target, added to the motors' own",
        source="whole degrees of Arduino's `Servo.write`: 0.017 rad; a PCA9685 at 50 Hz: 0.009 rad"),
    Randomization("backlash", partial(_worsen_servos, "backlash"), None, "rad", "joints", valid=_SMALL_ANGLE,
        description="play of each joint's gears, added to the motors' own",
        source="1 degree in a bus servo for hobbyists: Open Duck Mini; more in a worn one"),
    Randomization("dead_band", partial(_worsen_servos, "dead_band"), None, "rad", "joints", valid=_SMALL_ANGLE,
        description="error up to which each servo does not pull, added to the motors' own",
        source="2 to 10 us in data sheets of hobby servos, which turn by 0.1 degrees in 1 us: 0.003 to 0.017 rad"),
    Randomization("action_latency", ModelField("actuator_delay", mode="add"), None, "s",
        valid=Parameter("s", _NOT_NEGATIVE, MAX_DELAY),
        description="delay from joint target to motor, added to the motors' own",
        source=f"0 to 0.04 s: {_MINITAUR}; a target that arrives three control steps late: 0.06 s"),
    Randomization("observation_latency", SensorError("latency"), None, "s",
        valid=Parameter("s", _NOT_NEGATIVE, MAX_DELAY),
        description="age of the readings when the policy receives them",
        source="a bus at 100 Hz or more delivers a reading that is up to 0.01 s old"),
    Randomization("push_velocity", partial(_push, 3, slice(0, 3)), 0.0, "m/s", 3,
        interval=("push_interval", (4.0, 8.0)),
        tips=True,
        description="velocity that a push adds to the base along each axis of the world",
        source=f"+-1 m/s: {_MINUTES}"),
    Randomization("push_rotation", partial(_push, 6, slice(3, 6)), 0.0, "rad/s", 3,
        interval=("push_interval", (4.0, 8.0)),
        tips=True,
        description="angular velocity that a push adds to the base about each of its axes",
        source="+-0.5 rad/s in roll and pitch, +-0.8 rad/s in yaw: mjlab's velocity task"),
    Randomization("push_speed", partial(_push, 3, slice(0, 2)), None, "m/s", 2, law="direction",
        valid=Parameter("m/s", _NOT_NEGATIVE), interval=("push_interval", (4.0, 8.0)),
        tips=True,
        description="velocity that a push in a random horizontal direction adds to the base",
        source="0.74 m/s sideways tips a rigid robot over its feet"),
    Randomization("push_force", _force, None, "N", 2, law="direction", valid=Parameter("N", _NOT_NEGATIVE),
        interval=("push_force_interval", (4.0, 8.0)), duration=("push_force_duration", (0.2, 1.0)),
        tips=True,
        description="force on the base's centre of mass in a random horizontal direction, for a time",
        source="15 % of the weight: a hand that leads the robot, or a wind of 15 m/s on 0.03 m^2"),
)
# fmt: on
"""Randomizations of the built-in task, in the order in which they apply at the start of an episode."""
