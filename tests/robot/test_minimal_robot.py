"""A robot of which only name, model, stance and motors are given: the rest follows from the model."""

import itertools
import json
import pickle
import re
from xml.etree import ElementTree
from xml.sax.saxutils import escape

import mujoco
import numpy as np
import pytest
from test_joint_structure import three_joints
from test_urdf_drives import drives_of

from quadruped_env import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED, JointMotor, QuadrupedDesign, Robot
from quadruped_env.robot.skeleton import Skeleton
from quadruped_env.robot.written_urdf import _pose, written_urdf
from quadruped_env.utils.rotations import from_roll_pitch_yaw

BARE = re.sub(r"<sensor>.*?</sensor>|<keyframe>.*?</keyframe>", "", MINI_QUADRUPED.mjcf, flags=re.S)
NO_SITES = re.sub(r"<site [^>]*/>", "", BARE)
ONE_KNEE_LESS = re.sub('<(joint|dcmotor) name="LF_knee_joint"[^>]*/>', "", BARE)
STRUCTURE = (
    "leg_names",
    "joint_names",
    "link_names",
    "foot_sites",
    "joint_mirror",
    "foot_mirror",
    "corners",
    "leg_joints",
)
FEET = {f"{leg}_leg": (0.0, 0.0, -0.14) for leg in MINI_QUADRUPED.leg_names}


def minimal(mjcf=BARE, **fields):
    return Robot(
        **{"name": "dog", "stance": MINI_QUADRUPED.stance, "motors": MINI_QUADRUPED.motors, **fields}, mjcf=mjcf
    )


def with_balls(**attributes):
    """MJCF without sites, in which a ball ends each leg."""
    shape = " ".join(f'{key}="{value}"' for key, value in attributes.items())
    ball = f'<geom class="collision" type="sphere" size="0.02" pos="0 0 -0.14" {shape}/>'
    return re.sub(r'(<geom name="\w\w_leg_collision")', rf"{ball}\1", NO_SITES)


def test_structure_follows_from_the_model():
    robot = minimal()
    for name in STRUCTURE:
        assert getattr(robot, name) == getattr(MINI_QUADRUPED, name), name
    assert (robot.foot_radius, robot.stance_height) == pytest.approx((0.02, MINI_QUADRUPED.stance_height), abs=1e-7)
    assert robot.foot_radius == 0.02
    assert robot.stance_height == round(robot.stance_height, 9), "the same on every processor"
    assert robot.urdf is None
    assert "urdf" not in robot.to_dict()
    for again in (Robot.from_dict(json.loads(json.dumps(robot.to_dict()))), pickle.loads(pickle.dumps(robot))):  # noqa: S301
        assert again == robot


@pytest.mark.parametrize("legs", [("RH", "LF", "LH", "RF"), ("LH", "RH", "RF", "LF")])
def test_legs_are_named_and_paired_by_their_corners(legs):
    design = QuadrupedDesign(name="dog", leg_names=legs).robot()
    robot = minimal(re.sub(r"<keyframe>.*?</keyframe>", "", design.mjcf, flags=re.S))
    for name in STRUCTURE:
        assert getattr(robot, name) == getattr(design, name), name
    # A base whose frame is turned by half a turn: its fore legs are the hind ones.
    assert minimal(leg_corners=(3, 2, 1, 0)).leg_names == ("RH", "LH", "RF", "LF")


def test_three_joints_per_leg_are_paired_by_their_place():
    given = three_joints()
    robot = Robot(name="odd", mjcf=given.mjcf, stance=given.stance, motors=given.motors, foot_radius=0.02)
    assert robot.leg_names == ("RH", "LF", "RF", "LH")
    for name in ("joint_names", "link_names", "foot_sites", "joint_mirror", "foot_mirror", "corners"):
        assert getattr(robot, name) == getattr(given, name), name
    np.testing.assert_array_equal(robot.joint_signs, given.joint_signs)


def test_stance_by_joint_is_put_in_order():
    by_name = dict(zip(MINI_QUADRUPED.joint_names, MINI_QUADRUPED.stance.tolist(), strict=True))
    assert minimal(stance=dict(reversed(by_name.items()))) == minimal()
    with pytest.raises(
        QuadrupedError, match=r"robot 'dog': stance must name the joints LF_hip_joint, .*; found LF_hip_"
    ):
        minimal(stance={**by_name, "tail": 0.0})


def test_feet_are_the_balls_that_end_the_legs():
    robot = minimal(with_balls())
    assert robot.foot_sites == tuple(f"foot_of_{leg}_leg" for leg in MINI_QUADRUPED.leg_names)
    np.testing.assert_allclose(robot.stance_feet, MINI_QUADRUPED.stance_feet, rtol=0, atol=1e-12)
    assert robot.foot_radius == pytest.approx(0.02)
    assert Robot.from_dict(robot.to_dict()) == robot
    rounded = minimal(with_balls().replace('pos="0 0 -0.14"', 'pos="0.00123456789 0 -0.14"'))
    assert rounded.skeleton.feet[0][1].tolist() == [0.001234568, 0.0, -0.14]
    assert minimal(NO_SITES, foot_sites=FEET).stance_feet == pytest.approx(robot.stance_feet)
    given = minimal(NO_SITES, foot_sites=dict.fromkeys(FEET, (0.0012345678, 0.0, -0.14)))
    assert given.skeleton.feet[0][1].tolist() == [0.0012345678, 0.0, -0.14]


def test_link_that_is_fixed_between_others_ends_no_leg():
    start = BARE.index('<body name="LF_leg"')
    end = BARE.index("</body>", start)
    robot = minimal(f'{BARE[:start]}<body name="plate">{BARE[start:end]}</body>{BARE[end:]}')
    assert robot.foot_sites == MINI_QUADRUPED.foot_sites
    assert robot.link_names[2] == "plate"


def test_site_in_a_ball_of_a_fixed_link_is_not_the_foot():
    """Touch sensors feel the contacts of their own link."""
    ball = '<body name="\\2" pos="0 0 -0.14"><geom class="collision" type="sphere" size="0.02"/></body></body>'
    mjcf = BARE
    for leg in MINI_QUADRUPED.leg_names:
        start = mjcf.index(f'<body name="{leg}_leg"')
        end = mjcf.index("</body>", start)
        mjcf = mjcf[:end] + ball.replace("\\2", f"{leg}_foot") + mjcf[end + len("</body>") :]
    robot = minimal(mjcf)
    assert robot.skeleton.feet[0][0] == "LF_foot"
    assert robot.joint_mirror == MINI_QUADRUPED.joint_mirror


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mjcf": NO_SITES}, r"'LF_leg', the last link of a leg, has 0 sites and 0 balls .*foot_sites=\{'LF_leg': \(x"),
        ({"mjcf": with_balls(contype=0, conaffinity=0)}, "'LF_leg', the last link of a leg, has 0 sites and 0 balls"),
        ({"mjcf": NO_SITES, "foot_sites": {"LF_shank": (0, 0, 0)}}, "foot_sites: its MJCF has no body 'LF_shank'"),
        ({"mjcf": NO_SITES, "foot_sites": {"LF_leg": (0, 0)}}, "foot_sites of 'LF_leg' must be three finite numbers"),
        ({"mjcf": NO_SITES, "foot_sites": dict([*FEET.items()][:3])}, "leg_names, joint_mirror, foot_mirror follow"),
        ({"mjcf": ONE_KNEE_LESS, "stance": [0.6, *MINI_QUADRUPED.stance[2:]]}, "with 1, 2, 2, 2 joints"),
        ({"leg_corners": (0, 1, 2, 2)}, r"one leg in each corner.*LH_foot LH, RH_foot LH with 2, 2, 2, 2 j"),
        ({"leg_names": ("a", "b", "c")}, r"leg_names must be 4 names, one per foot; found \('a', 'b', 'c'\)"),
        ({"mjcf": BARE.replace('name="LF_knee_joint" class', "class", 1)}, "joint of the body 'LF_leg' of its model"),
        ({"stance": [0.6, -0.72] * 3}, "stance must be 8 finite numbers"),
    ],
)  # fmt: skip
def test_what_does_not_follow_is_asked_for(change, message):
    with pytest.raises(QuadrupedError, match=f"robot 'dog': .*{message}"):
        minimal(**change)


def turned():
    """MJCF of a robot with three joints per leg, whose links, inertia and shapes have frames in every direction."""
    spec, rng = mujoco.MjSpec.from_string(three_joints().mjcf), np.random.default_rng(0)
    kinds = [getattr(mujoco.mjtGeom, f"mjGEOM_{name}") for name in ("BOX", "CAPSULE", "CYLINDER", "SPHERE")]
    spec.bodies[4].add_body(name="plate", mass=0.1, inertia=[1e-4, 2e-4, 2e-4], ipos=[0.01, 0.0, 0.0])
    for body in spec.bodies[2:]:
        for part in (body, body.add_geom(type=rng.choice(kinds), size=[0.01, 0.02, 0.03], pos=rng.normal(size=3) / 30)):
            part.quat = rng.normal(size=4)
        body.iquat, body.inertia = rng.normal(size=4), [1e-3, 2e-3, 2.5e-3]
    spec.bodies[2].add_geom(type=kinds[0], size=[0.01, 0.02, 0.03], quat=from_roll_pitch_yaw([0.4, np.pi / 2, 0.3]))
    corners = 0.02 * np.array(list(itertools.product([1, 4], [0, 2], [-3, 0])))
    spec.add_mesh(name="brick", uservert=corners.ravel())
    spec.bodies[3].add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="brick", quat=rng.normal(size=4))
    spec.compile()
    return spec.to_xml()


def skeletons(own):
    """Kinematics by a robot's specification, and by the URDF that is written from it."""
    for actuator in own.actuators:
        own.delete(actuator)
    model = own.compile()
    text = written_urdf("dog", model, [JointMotor()] * (model.njnt - 1))
    end = '<mujoco><compiler fusestatic="false" discardvisual="true"/></mujoco></robot>'
    urdf = mujoco.MjSpec.from_string(text.replace("</robot>", end))
    urdf.body(model.body(1).name).add_freejoint()
    links = tuple(model.body(i).name for i in range(1, model.nbody))
    joints = tuple(model.joint(i).name for i in range(1, model.njnt))
    return [Skeleton(spec, spec.compile(), joints, links, ()) for spec in (own, urdf)]


class TestWrittenUrdf:
    def test_has_the_drives_of_the_designs_urdf(self):
        assert drives_of(minimal().description) == drives_of(MINI_QUADRUPED.urdf)
        assert minimal(urdf="<robot/>").description == "<robot/>"

    def test_escapes_names(self):
        odd = 'LF "&<knee>'
        robot = minimal(BARE.replace("LF_knee_joint", escape(odd, {'"': "&quot;"})), name=odd)
        root = ElementTree.fromstring(robot.description)  # noqa: S314
        assert {part.get("name") for part in root.iter("joint")} >= {*robot.joint_names}
        assert (root.get("name"), root.find("ros2_control").get("name")) == (odd, odd)

    @pytest.mark.parametrize("mjcf", [BARE, turned()], ids=["two joints", "turned links"])
    def test_is_the_same_robot(self, mjcf):
        both = own, _ = skeletons(mujoco.MjSpec.from_string(mjcf))
        rng = np.random.default_rng(1)
        for positions in rng.uniform(*own.model.jnt_range[1:].T, (5, own.model.njnt - 1)):
            inertia = []
            for skeleton in both:
                data = mujoco.MjData(skeleton.model)
                data.qpos[3], data.qpos[7:] = 1.0, positions
                mujoco.mj_forward(skeleton.model, data)
                inertia.append(np.zeros((skeleton.model.nv, skeleton.model.nv)))
                mujoco.mj_fullM(skeleton.model, data, inertia[-1])
            armature = np.diag(own.model.dof_armature)
            np.testing.assert_allclose(inertia[1] + armature, inertia[0], rtol=0, atol=1e-12)
            up = rng.normal(size=3)
            up /= np.linalg.norm(up)
            assert both[1].lowest(positions, up) == pytest.approx(own.lowest(positions, up), abs=1e-9)

    @pytest.mark.parametrize("pitch", [np.pi / 2, -np.pi / 2, 1.2])
    def test_has_the_angles_of_any_pose(self, pitch):
        for roll, yaw in np.random.default_rng(0).uniform(-3.0, 3.0, (50, 2)):
            quaternion = from_roll_pitch_yaw([roll, pitch, yaw])
            angles = np.array(_pose(np.zeros(3), quaternion)["rpy"].split(), dtype=float)
            assert abs(from_roll_pitch_yaw(angles) @ quaternion) == pytest.approx(1.0, abs=1e-12)

    def test_mesh_is_within_its_box(self):
        spec = mujoco.MjSpec.from_string(BARE)
        spec.add_mesh(name="wedge", uservert=[0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0])
        spec.body("LF_hip").add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="wedge")
        own, urdf = skeletons(spec)
        for up in np.random.default_rng(0).uniform(-0.5, 0.5, (10, 3)):
            assert -2.0 < urdf.lowest(np.zeros(8), up) - own.lowest(np.zeros(8), up) < 1e-9

    @pytest.mark.parametrize(
        "joint",
        [
            '<joint name="LF_knee_joint" pos="0 0 0.01"',
            '<joint name="LF_knee_joint" type="slide"',
            '<joint name="LF_twist" class="knee" axis="0 0 1"/><joint name="LF_knee_joint"',
        ],
    )
    def test_needs_hinges_alone_at_the_origins_of_their_links(self, joint):
        mjcf = re.sub("<dcmotor.*/>", "", BARE).replace('<joint name="LF_knee_joint"', joint)
        stance = [0.6, *[0.0] * mjcf.count("LF_twist"), *MINI_QUADRUPED.stance[1:]]
        legs = {
            "foot_mirror": (1, 0, 3, 2),
            "joint_mirror": (*range(len(stance)),),
            "leg_names": MINI_QUADRUPED.leg_names,
        }
        robot = minimal(mjcf, stance=stance, foot_radius=0.02, **legs)
        with pytest.raises(QuadrupedError, match=r"robot 'dog': a URDF cannot have the joint 'LF_(knee_joint|twist)'"):
            _ = robot.description
