"""A robot from a model that others made: whatever its actuators, with derived fields, sensors and meshes."""

import dataclasses
import json
import pickle
import re
import struct

import gymnasium
import mujoco
import numpy as np
import pytest
from paths import ROOT

from quadruped_env import QuadrupedError, build_model
from quadruped_env.robot import MINI_QUADRUPED, JointMotor, MotorConfig, QuadrupedDesign, Robot
from quadruped_env.robot.readings import Readings

RESTATED = (
    "link_names",
    "joint_position_low",
    "joint_position_high",
    "velocity_limit",
    "effort_limit",
    "stance_height",
    "foot_radius",
)
DERIVED = dict.fromkeys(RESTATED)
ACTUATOR = r'<dcmotor name="(\w+)" joint="(\w+)" class="\w+"/>'
BARE = re.sub(r"<sensor>.*?</sensor>|<keyframe>.*?</keyframe>", "", MINI_QUADRUPED.mjcf, flags=re.S)


def with_actuators(element, mjcf=MINI_QUADRUPED.mjcf):
    return re.sub(ACTUATOR, element, mjcf)


def changed(**fields):
    return dataclasses.replace(MINI_QUADRUPED, name="other", **fields)


def rollout(robot, steps=120):
    """Observation, reward and readings of random actions, at which the robot falls on its trunk."""
    env = gymnasium.make("MiniQuadruped-v0", robot=robot)
    env.reset(seed=5)
    actions = np.random.default_rng(0).uniform(-1.0, 1.0, (steps, 8)).astype(np.float32)
    found = []
    for action in actions:
        observation, reward, terminated, *_ = env.step(action)
        readings = env.unwrapped.task.simulation.readings
        found.append(
            np.concatenate(
                [observation, [reward], *(getattr(readings, x.name).ravel() for x in dataclasses.fields(Readings))]
            )
        )
        if terminated:
            return np.array(found)
    return np.array(found)


def test_robot_of_the_docs_needs_only_what_its_model_does_not_say(tmp_path):
    example = re.search(r"```python\n((?:(?!```).)*dog\.xml.*?)```", (ROOT / "docs" / "robots.md").read_text(), re.S)
    text = with_actuators(r'<position joint="\2" kp="40"/>', BARE)
    for old, new in {"LF": "FL", "RF": "FR", "LH": "HL", "RH": "HR"}.items():
        text = text.replace(f"{old}_", f"{new}_")
    (tmp_path / "dog.xml").write_text(text.replace("_hip_joint", "_HFE").replace("_knee_joint", "_KFE"))
    (tmp_path / "my_robot.py").write_text(example[1])
    env = gymnasium.make("MiniQuadruped-v0", task_file=tmp_path / "my_robot.py")
    env.reset(seed=0)
    _, _, terminated, *_ = env.step(np.zeros(8, np.float32))
    assert not terminated
    robot = env.unwrapped.task.control.robot
    assert robot.joint_names[1] == "FL_KFE"
    assert robot.effort_limit.tolist() == [2.7] * 8
    assert 5.0 in env.unwrapped.model.actuator_gainprm[0]  # kp, instead of the file's 40
    assert 40.0 not in env.unwrapped.model.actuator_gainprm[0]


@pytest.mark.parametrize(
    "element",
    [
        r'<motor name="\1" joint="\2" gear="9" ctrlrange="-1 1" forcerange="-0.1 0.1"/>',
        r'<position name="\1" joint="\2" kp="5" kv="1" timeconst="0.1" inheritrange="0.5"/>',
        r'<velocity name="\1" jointinparent="\2" kv="3"/>',
        r'<position joint="\2" kp="40"/>',
        "",
    ],
    ids=["motor", "position", "velocity", "no names", "none"],
)
def test_motors_are_written_whatever_the_models_actuators(element):
    mjcf = with_actuators(element, BARE).replace('damping="0.05"', 'damping="0.7" actuatorfrcrange="-1 1"')
    robot = changed(mjcf=mjcf, sensors=None)
    expected = build_model()
    for model in (robot.model, build_model(robot=robot)):
        for name in dir(model):
            if (
                name.startswith(("actuator_", "dof_", "jnt_actfrc"))
                and "adr" not in name
                and name != "actuator_trntype"
            ):
                np.testing.assert_array_equal(getattr(model, name), getattr(expected, name), err_msg=name)


def test_delay_of_a_robot_does_not_stay_with_motors_of_a_task():
    robot = changed(motors=MotorConfig(delay=0.02))
    assert build_model(robot=robot).actuator_delay[0] == 0.02
    assert not build_model(robot=robot, motors=MotorConfig()).actuator_delay.any()
    assert not robot.model.actuator_delay.any()


@pytest.mark.parametrize(
    ("mjcf", "message"),
    [
        (BARE.replace('name="base_link" ', ""), "the body of its free joint has no name"),
        (BARE.replace('joint="RF_knee_joint" class', 'joint="RF_hip_joint" class'), "the motors of its"),
        (
            with_actuators("", BARE).replace(
                "<actuator>",
                '<tendon><fixed name="t"><joint joint="LF_hip_joint" coef="1"/></fixed></tendon><actuator>'
                '<motor name="pull" tendon="t"/>',
            ),
            "the actuator 'pull' of its model does not act on a joint",
        ),
        (
            MINI_QUADRUPED.mjcf.replace('range="-1.5 1.5" armature', "armature"),
            "'LF_hip_joint' of its model has no range",
        ),
        (MINI_QUADRUPED.mjcf.replace('type="sphere"', 'type="mesh" mesh="q"', 1), r"MuJoCo cannot compile its MJCF \("),
        (MINI_QUADRUPED.mjcf.replace("<worldbody>", "<worldboy/><worldbody>", 1), r"MuJoCo cannot read its MJCF \("),
    ],
)
def test_model_without_such_joints_and_actuators_is_refused(mjcf, message):
    with pytest.raises(QuadrupedError, match=f"robot 'other': .*{message}"):
        changed(mjcf=mjcf, sensors=None)


def test_fields_that_restate_the_model_follow_from_it():
    robot = changed(**DERIVED)
    for name in RESTATED:
        found, expected = getattr(robot, name), getattr(MINI_QUADRUPED, name)
        if name == "link_names":
            assert found == expected
        else:
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-7, err_msg=name)
    motors = MotorConfig(JointMotor(stall_torque=7.0), JointMotor(no_load_speed=8.0))
    other = changed(**DERIVED, motors=motors)
    np.testing.assert_array_equal(other.effort_limit, [7.0, 10.0] * 4)
    np.testing.assert_array_equal(other.velocity_limit, [5.0, 8.0] * 4)
    assert not other.effort_limit.flags.writeable
    for again in (Robot.from_dict(json.loads(json.dumps(robot.to_dict()))), pickle.loads(pickle.dumps(robot))):  # noqa: S301
        assert again == robot


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"stance_height": 0.3}, "stance_height is 0.3, but 0.183753 in its model; .* stance_height=None"),
        ({"stance_height": 0.0}, "stance_height must be a positive number"),
        ({"stance_height": "0.18"}, "stance_height must be a positive number .*found '0.18'"),
        ({"foot_radius": 0.021}, "foot_radius is 0.021, but 0.02 in its model"),
        ({"effort_limit": [9.0] * 8}, "effort_limit of LF_hip_joint is 9, but 10 in its motors"),
        ({"velocity_limit": [5.0] * 7 + [6.0]}, "velocity_limit of RH_knee_joint is 6, but 5 in its motors"),
        (
            {"joint_position_low": [-1.5, -1.99] * 4},
            "joint_position_low of LF_knee_joint is -1.99, but -2 in its model;",
        ),
        (
            {"motors": MotorConfig(JointMotor(stall_torque=3.0))},
            "effort_limit of LF_hip_joint is 10, but 3 in its motors;",
        ),
    ],
)
def test_value_that_contradicts_the_model_is_refused(change, message):
    with pytest.raises(QuadrupedError, match=f"robot 'other': {message}"):
        gymnasium.make("MiniQuadruped-v0", robot=changed(**change))


def test_values_agree_to_the_six_digits_that_mujoco_writes():
    spec = changed(stance_height=0.183753).spec()
    spec.compile()
    written = changed(mjcf=spec.to_xml(), joint_position_high=[1.5 + 4e-6, 0.0] * 4)
    assert written.model.nu == 8
    with pytest.raises(QuadrupedError, match=r"joint_position_high of LF_hip_joint is 1\.50002"):
        changed(joint_position_high=[1.50002, 0.0] * 4)


def test_ranges_in_degrees_limit_the_targets_in_radians():
    mjcf = BARE.replace('angle="radian"', 'angle="degree"').replace('range="-1.5 1.5"', 'range="-80 80"')
    robot = changed(mjcf=mjcf.replace('range="-2 0"', 'range="-110 0"'), sensors=None, **DERIVED)
    np.testing.assert_allclose(robot.joint_position_low[:2], np.radians([-80.0, -110.0]))
    np.testing.assert_array_equal(robot.model.actuator_ctrlrange, robot.model.jnt_range[1:])


def test_sensors_that_the_model_gets_read_as_the_built_in_ones():
    own = rollout(dataclasses.replace(MINI_QUADRUPED, mjcf=BARE, sensors=None))
    np.testing.assert_array_equal(own, rollout(MINI_QUADRUPED))
    robot = changed(mjcf=MINI_QUADRUPED.mjcf, sensors=None)  # next to sensors of its own
    np.testing.assert_array_equal(rollout(robot), own)
    assert Robot.from_dict(robot.to_dict()).model.nsensor == robot.model.nsensor


@pytest.mark.parametrize("orientation", [(0.7, 0.0, 0.7, 0.0), (0.8, 0.6, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0)])
def test_trunk_that_lies_on_the_ground_is_felt_by_the_sensors_that_the_model_gets(orientation):
    found = []
    for robot in (MINI_QUADRUPED, dataclasses.replace(MINI_QUADRUPED, mjcf=BARE, sensors=None)):
        model = build_model(robot=robot)
        data = mujoco.MjData(model)
        data.qpos[2:7], data.qpos[7:] = [0.15, *orientation], [1.5, -2.0] * 4
        forces = []
        for _ in range(200):
            mujoco.mj_step(model, data)
            readings = Readings.from_sensordata(model, data.sensordata, robot)
            forces.append(np.concatenate([readings.trunk_force, readings.foot_force]))
        found.append(np.array(forces))
    np.testing.assert_allclose(found[1], found[0], rtol=0, atol=1e-9)
    assert found[0][:, :5].max() > 5.0  # N


def mesh():
    """A tetrahedron as STL."""
    points = [(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    rows = (struct.pack("<12fH", 0, 0, 0, *points[a], *points[b], *points[c], 0) for a, b, c in faces)
    return b"\0" * 80 + struct.pack("<I", len(faces)) + b"".join(rows)


@pytest.mark.parametrize("included", [False, True])
def test_meshes_are_searched_next_to_the_file(included, tmp_path, monkeypatch):
    folder = tmp_path / "dog"
    (folder / "meshes" / "legs").mkdir(parents=True)
    text = MINI_QUADRUPED.mjcf.replace('angle="radian"', 'angle="radian" meshdir="meshes"').replace(
        "<asset>", '<asset><mesh name="m" file="trunk.stl"/><mesh name="n" file="legs/leg.stl"/>'
    )
    geoms = '<geom class="visual" type="mesh" mesh="m"/><geom class="visual" type="mesh" mesh="n"/><site name="imu"'
    path = folder / "dog.xml"
    path.write_text(text.replace('<site name="imu"', geoms))
    with pytest.raises(QuadrupedError, match=r"opening file 'meshes/trunk.stl'.*next to a file: mjcf=Path"):
        changed(mjcf=path.read_text())
    with pytest.raises(QuadrupedError, match=r"meshes/trunk.stl: there is no such file"):
        changed(mjcf=path)
    for name in ("trunk.stl", "legs/leg.stl"):
        (folder / "meshes" / name).write_bytes(mesh())
    if included:
        path = folder / "scene.xml"
        path.write_text('<mujoco><include file="dog.xml"/></mujoco>')
    robot = changed(mjcf=path)
    monkeypatch.chdir(tmp_path)
    path.unlink()  # a robot is a value
    for one in (robot, Robot.from_dict(json.loads(json.dumps(robot.to_dict()))), pickle.loads(pickle.dumps(robot))):  # noqa: S301
        assert build_model(robot=one).nmesh == 2
        assert one == robot
    other = dataclasses.replace(robot, assets={**robot.assets, "trunk.stl": b"x" + mesh()[1:]})
    assert other != robot


def test_exported_model_has_the_motors():
    assert MINI_QUADRUPED.simulated_mjcf == MINI_QUADRUPED.mjcf
    written = changed(mjcf=with_actuators(r'<motor name="\1" joint="\2"/>')).simulated_mjcf
    found = dataclasses.replace(MINI_QUADRUPED, mjcf=written).spec().compile()
    np.testing.assert_allclose(found.actuator_gainprm, MINI_QUADRUPED.model.actuator_gainprm, rtol=1e-5)
    assert "<motor" not in written


@pytest.mark.parametrize(
    "change",
    [
        {},
        {"hip_to_knee": 0.05, "leg_length": 0.08},
        {"hip_to_knee": 0.2, "leg_length": 0.22},
    ],
)
def test_feet_of_a_design_are_under_its_hips(change):
    design = QuadrupedDesign(name="other", **change)
    feet = design.robot().stance_feet
    np.testing.assert_allclose(np.abs(feet[:, 0]), design.hip_offset[0], rtol=0, atol=1.2e-3)
    assert QuadrupedDesign().stance_angles == (0.6, -0.72)
    given = QuadrupedDesign(name="other", stance_angles=(0.5, -0.9), **change)
    assert given.stance_angles == (0.5, -0.9)


def test_design_whose_foot_cannot_be_under_its_hip_asks_for_the_angles():
    with pytest.raises(QuadrupedError, match=r"stance_angles must be given: with the hip at 0.6 rad the foot does not"):
        QuadrupedDesign(hip_to_knee=0.2, leg_length=0.06, leg_radius=0.01)
    with pytest.raises(
        QuadrupedError, match=r"stance_angles must be within knee_range .*follow from the links, so give"
    ):
        QuadrupedDesign(knee_range=(-0.5, 0.0))
