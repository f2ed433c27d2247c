"""The drives of a URDF: a robot that is built from its text alone moves as that of the MJCF does."""

import itertools
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest

from quadruped_env.robot import MINI_QUADRUPED, QuadrupedDesign
from quadruped_env.robot.motors import JointMotor, MotorConfig

DRAKE = "{http://drake.mit.edu}"
OTHER = QuadrupedDesign(
    name="other_drives",
    hip_range=(-1.4, 1.3),
    knee_range=(-1.9, -0.1),
    motors=MotorConfig(
        hip=JointMotor(stall_torque=7.0, kp=30.0, kd=0.6, damping=0.2, friction_loss=0.3, armature=0.02),
        knee=JointMotor(stall_torque=12.0, no_load_speed=8.0, kp=55.0, kd=1.4, friction_loss=0.1, armature=0.005),
    ),
).robot()
ROBOTS = {"built-in": MINI_QUADRUPED, "other": OTHER}
TIMESTEP = 1e-4
STEPS = 10000


def drives_of(urdf):
    """Numbers of each joint's drive in a URDF, by Drake's and ros2_control's tags: joint -> name -> value, SI units."""
    root = ElementTree.fromstring(urdf)  # noqa: S314
    system = root.find("ros2_control")
    found = {}
    for joint in root.findall("joint"):
        name, limit, dynamics = joint.get("name"), joint.find("limit"), joint.find("dynamics")
        (actuator,) = (
            entry.find("actuator") for entry in root.findall("transmission") if entry.find("joint").get("name") == name
        )
        (controlled,) = (entry for entry in system.findall("joint") if entry.get("name") == name)
        (reduced,) = (
            entry.find("joint/mechanical_reduction")
            for entry in system.findall("transmission")
            if entry.find("joint").get("name") == name
        )
        found[name] = {
            **{key: float(limit.get(key)) for key in ("lower", "upper", "effort", "velocity")},
            **{key: float(dynamics.get(key)) for key in ("damping", "friction")},
            "gear_ratio": float(actuator.find(f"{DRAKE}gear_ratio").get("value")),
            "rotor_inertia": float(actuator.find(f"{DRAKE}rotor_inertia").get("value")),
            "mechanical_reduction": float(reduced.text),
            **{param.get("name"): float(param.text) for param in controlled.findall("param")},
            **{
                param.get("name"): float(param.text)
                for param in controlled.findall("command_interface[@name='position']/param")
            },
        }
    return found


def column(drives, key):
    return np.array([drive[key] for drive in drives.values()])


def urdf_model(urdf, rotors=True):
    """The URDF's robot with its base held in the air, with the inertia of its rotors and its passive joint torques."""
    drives = drives_of(urdf)
    spec = mujoco.MjSpec.from_string(urdf)
    assert [joint.name for joint in spec.joints] == list(drives)
    for joint, drive in zip(spec.joints, drives.values(), strict=True):
        joint.armature = drive["rotor_inertia"] * drive["gear_ratio"] ** 2 if rotors else 0.0
    return spec.compile(), drives


def mjcf_model(robot):
    """The MJCF's robot with its base held in the air."""
    spec = robot.spec()
    spec.delete(spec.joint("floating_base"))
    spec.delete(spec.key("home"))
    return spec.compile()


def prepared(model):
    # The MJCF excludes contacts of the robot with itself, but for the lower legs.
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    model.opt.timestep = TIMESTEP
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    return model, mujoco.MjData(model)


def motor_torque(drives, error, speed):
    """Servo torque (J,) within the line from the effort limit at rest to zero at the velocity limit, N m."""
    effort, slope = column(drives, "effort"), column(drives, "effort") / column(drives, "velocity")
    wanted = column(drives, "kp") * error - column(drives, "kd") * speed
    available = np.clip(wanted, -effort - slope * speed, effort - slope * speed)
    return np.clip(available, -effort, effort)


def step_by_urdf(robot, begin, target, rotors=True):
    """Joint positions (STEPS, J) of the robot that is built from the URDF alone."""
    model, drives = urdf_model(robot.urdf, rotors)
    model, data = prepared(model)
    data.qpos[:] = begin
    positions = []
    for _ in range(STEPS):
        data.qfrc_applied[:] = motor_torque(drives, target - data.qpos, data.qvel)
        mujoco.mj_step(model, data)
        positions.append(data.qpos.copy())
    return np.array(positions)


def step_by_mjcf(robot, begin, target):
    model, data = prepared(mjcf_model(robot))
    data.qpos[:], data.ctrl[:] = begin, target
    positions = []
    for _ in range(STEPS):
        mujoco.mj_step(model, data)
        positions.append(data.qpos.copy())
    return np.array(positions)


def corner_steps(robot):
    """Steps of all joints from one corner of their ranges to another, inwards of the limits, and a small one."""
    low, high = robot.joint_position_low + 0.2, robot.joint_position_high - 0.2
    for there, back in itertools.product((True, False), repeat=2):
        hips = np.arange(robot.num_joints) % 2 == 0
        begin = np.where(hips, low if there else high, low if back else high)
        yield begin, np.where(hips, high if there else low, high if back else low)
    yield robot.stance, robot.stance + 0.02


@pytest.mark.parametrize("name", ROBOTS)
def test_robot_built_from_the_urdf_alone_follows_a_step_as_the_mjcf_does(name):
    robot = ROBOTS[name]
    for begin, target in corner_steps(robot):
        urdf, mjcf = step_by_urdf(robot, begin, target), step_by_mjcf(robot, begin, target)
        reach = abs(target - begin).max()
        assert abs(mjcf - begin).max() > 0.9 * reach, "the step was made"
        np.testing.assert_allclose(urdf, mjcf, rtol=0, atol=2e-3 * reach)


def test_step_without_the_rotors_differs_by_many_times_that_tolerance():
    begin, target = next(corner_steps(MINI_QUADRUPED))
    without, mjcf = (
        step_by_urdf(MINI_QUADRUPED, begin, target, rotors=False),
        step_by_mjcf(MINI_QUADRUPED, begin, target),
    )
    assert abs(without - mjcf).max() > 0.05 * abs(target - begin).max()


@pytest.mark.parametrize("name", ROBOTS)
def test_drives_in_the_urdf_are_those_of_the_mjcf(name):
    robot = ROBOTS[name]
    drives, mjcf = drives_of(robot.urdf), robot.model
    assert tuple(drives) == robot.joint_names
    inertia = column(drives, "rotor_inertia") * column(drives, "gear_ratio") ** 2
    np.testing.assert_allclose(inertia, mjcf.dof_armature[6:], rtol=1e-12)
    np.testing.assert_array_equal(column(drives, "damping"), mjcf.dof_damping[6:])
    np.testing.assert_array_equal(column(drives, "friction"), mjcf.dof_frictionloss[6:])
    np.testing.assert_array_equal(column(drives, "mechanical_reduction"), column(drives, "gear_ratio"))
    for limit, own, of_command in (("joint_position_low", "lower", "min"), ("joint_position_high", "upper", "max")):
        np.testing.assert_array_equal(column(drives, own), getattr(robot, limit))
        np.testing.assert_array_equal(column(drives, of_command), getattr(robot, limit))
    np.testing.assert_array_equal(column(drives, "effort"), robot.effort_limit)
    np.testing.assert_array_equal(column(drives, "velocity"), robot.velocity_limit)
    motors = robot.motors.of_joints(robot.joint_kinds)
    np.testing.assert_array_equal(column(drives, "kp"), [motor.kp for motor in motors])
    np.testing.assert_array_equal(column(drives, "kd"), [motor.kd for motor in motors])
