"""Motors, mirror signs and corners of robots whose names say nothing: they follow from the structure, or are given."""

import dataclasses
import json
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from paths import ROBOTS

from quadruped_env import QuadrupedError
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.robot import MINI_QUADRUPED, JointMotor, MotorConfig, Robot
from quadruped_env.robot.corners import corners
from quadruped_env.simulation import build_model

SOLO8 = ROBOTS / "solo_description" / "robots" / "solo8.urdf"
MOTORS = MotorConfig(hip=JointMotor(stall_torque=3.0), knee=JointMotor(stall_torque=2.0))
IDENTITY = "c2dfd2cc28fc92faed8fd3f8ea9208b98e9a7720e37a57f5d5639061565feba5"


def robot_of(spec, legs, stance, **fields):
    """Robot of a specification with a site `<leg>_foot` in each leg."""
    spec.compile()
    joints = tuple(joint.name for joint in spec.joints[1:])
    counterpart = {"L": "R", "R": "L"}
    mirror = lambda names: tuple(names.index(name[0] + counterpart[name[1]] + name[2:]) for name in names)  # noqa: E731
    return Robot(
        name="odd",
        leg_names=legs,
        joint_names=joints,
        stance=np.array(stance),
        foot_radius=0.02,
        foot_sites=tuple(f"{leg}_foot" for leg in legs),
        joint_mirror=mirror(joints),
        foot_mirror=mirror(legs),
        sensors={},
        motors=MOTORS,
        mjcf=spec.to_xml(),
        urdf="<robot/>",
        **fields,
    )


def solo8():
    """The Solo8 without its meshes, whose joints are called HFE and KFE."""
    if not SOLO8.is_file():
        pytest.skip("no shared/data/robots/solo_description")
    tree = ElementTree.parse(SOLO8).getroot()  # noqa: S314  a published file
    for link in tree.iter("link"):
        for shape in [*link.iterfind("visual"), *link.iterfind("collision")]:
            link.remove(shape)
    ElementTree.SubElement(ElementTree.SubElement(tree, "mujoco"), "compiler", fusestatic="false")
    spec = mujoco.MjSpec.from_string(ElementTree.tostring(tree, encoding="unicode"))
    base = spec.body("base_link")
    base.add_freejoint(name="free")
    legs = ("FL", "FR", "HL", "HR")
    for leg in legs:
        spec.body(f"{leg}_FOOT").add_site(name=f"{leg}_foot")
    for joint in spec.joints[1:]:
        spec.add_actuator(name=joint.name, target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    return robot_of(spec, legs, [0.7, -1.4] * 4)


def three_joints(**fields):
    """A robot with three joints per leg; right legs bend their thighs and shanks about reversed axes."""
    spec = mujoco.MjSpec()
    spec.compiler.degree = False
    base = spec.worldbody.add_body(name="trunk", mass=3.0, inertia=[0.02] * 3, ipos=[0.0] * 3, explicitinertial=True)
    base.add_freejoint(name="free")
    legs = ("HR", "FL", "FR", "HL")
    for leg in legs:
        side, body = (1 if leg[1] == "L" else -1), base
        # The frame of the trunk is at its hind end.
        place = [0.3 if leg[0] == "F" else -0.05, 0.1 * side, 0.0]
        for part, axis in (("1", [1, 0, 0]), ("2", [0, side, 0]), ("3", [0, side, 0])):
            body = body.add_body(
                name=f"{leg}{part}", pos=place, mass=0.2, inertia=[1e-3] * 3, ipos=[0.0] * 3, explicitinertial=True
            )
            body.add_joint(name=f"{leg}_{part}", axis=axis, range=[-2.0, 2.0])
            place = [0.0, 0.03 * side, -0.15]
        body.add_site(name=f"{leg}_foot", pos=[0.0, 0.0, -0.15])
    for leg in legs:
        for part in "123":
            spec.add_actuator(name=f"{leg}{part}", target=f"{leg}_{part}", trntype=mujoco.mjtTrn.mjTRN_JOINT)
    side = np.repeat([-1.0, 1.0, -1.0, 1.0], 3)
    return robot_of(spec, legs, side * np.tile([0.0, 0.5, -1.0], 4), **fields)


def check_mirror(robot):
    """Mirrored joint positions put each foot at the mirror image of its counterpart."""
    positions = np.random.default_rng(0).uniform(robot.joint_position_low, robot.joint_position_high)
    mirrored = robot.joint_signs * positions[list(robot.joint_mirror)]
    feet = robot.skeleton.foot_centres(positions)[list(robot.foot_mirror)] * [1.0, -1.0, 1.0]
    np.testing.assert_allclose(robot.skeleton.foot_centres(mirrored), feet, atol=1e-6)


def test_solo8_has_hips_and_knees():
    robot = solo8()
    assert robot.joint_names[:2] == ("FL_HFE", "FL_KFE")
    assert robot.joint_kinds == ("hip", "knee") * 4
    assert corners(robot) == (0, 1, 2, 3)
    assert robot.joint_signs.tolist() == [1.0] * 8
    check_mirror(robot)
    motors = MotorConfig(hip=JointMotor(armature=0.02), knee=JointMotor(armature=0.03))
    np.testing.assert_array_equal(build_model(motors=motors, robot=robot).dof_armature[6:], [0.02, 0.03] * 4)


def test_structure_of_another_robot_follows_from_its_axes_and_its_legs():
    robot = three_joints()
    assert robot.joint_kinds == ("abduction", "hip", "knee") * 4
    assert robot.joints_by_kind == {"abduction": [0, 3, 6, 9], "hip": [1, 4, 7, 10], "knee": [2, 5, 8, 11]}
    assert robot.corners == (3, 0, 1, 2)
    assert robot.fore_legs.tolist() == [False, True, True, False]
    assert robot.left_legs.tolist() == [False, True, False, True]
    assert robot.joint_signs.tolist() == [-1.0] * 12
    check_mirror(robot)
    assert [motor.stall_torque for motor in robot.motors.of_joints(robot.joint_kinds)] == [3.0, 3.0, 2.0] * 4
    motors = dataclasses.replace(MOTORS, abduction=JointMotor(stall_torque=1.0))
    other = dataclasses.replace(robot, motors=motors, effort_limit=None)
    assert other.effort_limit.tolist() == [1.0, 3.0, 2.0] * 4
    assert Robot.from_dict(json.loads(json.dumps(other.to_dict()))) == other != robot
    mirror = MirrorMap.of(ObservationLayout(robot))
    seen = np.random.default_rng(0).normal(size=len(mirror.observation_order))
    np.testing.assert_array_equal(mirror.observation(mirror.observation(seen)), seen)
    action = np.arange(12.0)
    np.testing.assert_array_equal(mirror.action(action), -action[list(robot.joint_mirror)])


def test_structure_that_the_author_gives_counts():
    given = {"motor_kinds": ("knee", "hip", "hip") * 4, "mirror_signs": (1, -1, 1) * 4, "leg_corners": (0, 3, 2, 1)}
    robot = three_joints(**given)
    assert (robot.joint_kinds, tuple(robot.joint_signs), robot.corners) == tuple(given.values())
    assert robot.fore_legs.tolist() == [True, False, False, True]
    assert robot != three_joints()
    assert Robot.from_dict(json.loads(json.dumps(robot.to_dict()))) == robot


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"motor_kinds": ("hip", "ankle", "knee") * 4}, "motor_kinds must be 12 of hip, knee, abduction"),
        ({"mirror_signs": (1,) * 11}, "mirror_signs must be 12 of 1, -1"),
        ({"mirror_signs": 12}, "mirror_signs must be 12 of 1, -1"),
        ({"motor_kinds": [["hip"]] * 12}, "motor_kinds must be 12 of hip, knee, abduction"),
        ({"leg_corners": (0, 1, 2, 4)}, "leg_corners must be 4 of 0, 1, 2, 3"),
    ],
)
def test_structure_that_is_no_structure_is_refused(change, message):
    with pytest.raises(QuadrupedError, match=f"robot 'odd': {message}; found"):
        three_joints(**change)


def test_axis_without_mirror_image_is_refused_only_where_the_mirror_is_used():
    order = list(three_joints().joint_mirror)
    order[0], order[1] = order[1], order[0]
    robot = dataclasses.replace(three_joints(), joint_mirror=tuple(order))
    layout = ObservationLayout(robot)
    with pytest.raises(QuadrupedError, match=r"axis of HR_1 is not the mirror image of the axis of HL_2.*, or give"):
        MirrorMap.of(layout)


def test_built_in_robot_keeps_its_identity():
    """Policies and run folders name it."""
    assert MINI_QUADRUPED.sha256 == IDENTITY
    assert MINI_QUADRUPED.joint_kinds == ("hip", "knee") * 4
    assert MINI_QUADRUPED.joint_signs.tolist() == [1.0] * 8
    assert corners(MINI_QUADRUPED) == (0, 1, 2, 3)
    assert "motor_kinds" not in MINI_QUADRUPED.to_dict()
