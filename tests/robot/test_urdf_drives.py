"""The drives of a URDF: a robot that is built from its text alone moves like the MJCF's."""

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


def urdf_steps(robot, begin, target):
    """Joint positions (T, J) of the robot that is built from the URDF alone, with rotors and motor torques added."""
    drives = drives_of(robot.urdf)
    spec = mujoco.MjSpec.from_string(robot.urdf)
    for joint, drive in zip(spec.joints, drives.values(), strict=True):
        joint.armature = drive["rotor_inertia"] * drive["gear_ratio"] ** 2
    effort, slope = column(drives, "effort"), column(drives, "effort") / column(drives, "velocity")

    def pull(data):
        wanted = column(drives, "kp") * (target - data.qpos) - column(drives, "kd") * data.qvel
        available = np.clip(wanted, -effort - slope * data.qvel, effort - slope * data.qvel)
        data.qfrc_applied[:] = np.clip(available, -effort, effort)

    return moved(spec.compile(), begin, pull)


def mjcf_steps(robot, begin, target):
    """Joint positions (T, J) of the robot of the MJCF with its base held in the air."""
    spec = robot.spec()
    spec.delete(spec.joint("floating_base"))
    spec.delete(spec.key("home"))

    def pull(data):
        data.ctrl[:] = target

    return moved(spec.compile(), begin, pull)


def moved(model, begin, pull):
    # The MJCF excludes contacts of the robot with itself, but for the lower legs.
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    model.opt.timestep, model.opt.integrator = 1e-4, mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    data = mujoco.MjData(model)
    data.qpos[:] = begin
    positions = []
    for _ in range(10000):
        pull(data)
        mujoco.mj_step(model, data)
        positions.append(data.qpos.copy())
    return np.array(positions)


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
def test_robot_built_from_the_urdf_alone_follows_a_step_as_the_mjcf_does(name):
    robot = ROBOTS[name]
    begin, target = robot.joint_position_low + 0.2, robot.joint_position_high - 0.2
    urdf, mjcf = urdf_steps(robot, begin, target), mjcf_steps(robot, begin, target)
    reach = abs(target - begin).max()
    assert abs(mjcf - begin).max() > 0.9 * reach, "the step was made"
    np.testing.assert_allclose(urdf, mjcf, rtol=0, atol=2e-3 * reach)
