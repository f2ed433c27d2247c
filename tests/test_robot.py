"""The robot's facts, held against its URDF, its MJCF and the package's own numbers."""

import itertools
import math

import mujoco
import numpy as np
import pytest
import yourdfpy
from scipy.spatial.transform import Rotation

from quadruped_env import QuadrupedError, asset_path, forward_kinematics
from quadruped_env.robot import (
    JOINT_NAMES,
    LINK_NAMES,
    STANCE,
    STANCE_HEIGHT,
    TOTAL_MASS,
    facts,
    fixed_transforms,
    joint_transforms,
    load_model,
    resting_pose,
    sole_heights,
)

# Written out here, not imported: these are the facts of the tutorial that the files and the package have to repeat.
LEGS = {"LF": (0.15, 0.10), "RF": (0.15, -0.10), "LH": (-0.15, 0.10), "RH": (-0.15, -0.10)}
JOINTS = (
    "LF_hip_joint",
    "LF_knee_joint",
    "RF_hip_joint",
    "RF_knee_joint",
    "LH_hip_joint",
    "LH_knee_joint",
    "RH_hip_joint",
    "RH_knee_joint",
)
LIMITS = {"hip": (-1.5, 1.5), "knee": (-2.0, 0.0)}
EFFORT, VELOCITY = 10.0, 5.0
GRAY, BLUE, BLACK = (0.5, 0.5, 0.5, 1.0), (0.2, 0.3, 0.8, 1.0), (0.1, 0.1, 0.1, 1.0)
LINKS = ("base_link", "LF_hip", "LF_leg", "RF_hip", "RF_leg", "LH_hip", "LH_leg", "RH_hip", "RH_leg")
VISUALS = {
    "base_link": ("box", (0.30, 0.15, 0.08), GRAY, (0.0, 0.0, 0.0)),
    "hip": ("sphere", (0.03,), BLUE, (0.0, 0.0, 0.0)),
    "leg": ("cylinder", (0.02, 0.16), BLACK, (0.0, 0.0, -0.08)),
}
MASSES = {"base_link": 2.2, "hip": 0.25, "leg": 0.20}


def kind(name):
    """`hip`, `leg` or `knee` of a link or joint; `base_link` for itself."""
    return name if name == "base_link" else name.split("_")[1]


@pytest.fixture(scope="module")
def urdf():
    return yourdfpy.URDF.load(str(asset_path("mini_quadruped.urdf")), load_meshes=False)


@pytest.fixture(scope="module")
def urdf_model():
    """The URDF as MuJoCo reads it; unfused, or the base would vanish into the world."""
    spec = mujoco.MjSpec.from_file(str(asset_path("mini_quadruped.urdf")))
    spec.compiler.fusestatic = False
    return spec.compile()


@pytest.fixture(scope="module")
def mjcf():
    """The robot alone, without its ground."""
    return mujoco.MjModel.from_xml_path(str(asset_path("mini_quadruped.xml")))


def geoms(model, link, group):
    """Ids of a body's geoms in a group: 2 is for the eye, 3 for collision."""
    body = model.body(link).id
    return [i for i in range(model.ngeom) if model.geom_bodyid[i] == body and model.geom_group[i] == group]


def random_positions(rng, *shape):
    return rng.uniform(
        [LIMITS["hip"][0], LIMITS["knee"][0]] * 4, [LIMITS["hip"][1], LIMITS["knee"][1]] * 4, (*shape, 8)
    )


class TestNamesAndOrder:
    def test_package(self):
        assert JOINT_NAMES == JOINTS
        assert LINK_NAMES == LINKS
        assert tuple(LEGS) == facts.LEG_NAMES

    def test_urdf(self, urdf):
        assert urdf.robot.name == "mini_quadruped"
        assert tuple(urdf.link_map) == LINKS
        assert tuple(urdf.actuated_joint_names) == JOINTS == tuple(urdf.joint_map)

    def test_mjcf(self, mjcf):
        assert mujoco.MjSpec.from_file(str(asset_path("mini_quadruped.xml"))).modelname == "mini_quadruped"
        assert tuple(mjcf.body(i).name for i in range(mjcf.nbody)) == ("world", *LINKS)
        assert tuple(mjcf.joint(i).name for i in range(mjcf.njnt)) == ("floating_base", *JOINTS)
        assert tuple(mjcf.actuator(i).name for i in range(mjcf.nu)) == JOINTS
        assert mjcf.jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE
        np.testing.assert_array_equal(mjcf.actuator_trnid[:, 0], 1 + np.arange(8))


class TestShapes:
    @pytest.mark.parametrize("link", LINKS)
    def test_urdf_visual(self, urdf, link):
        shape, size, color, origin = VISUALS[kind(link)]
        (visual,) = urdf.link_map[link].visuals
        geometry = getattr(visual.geometry, shape)
        found = {
            "box": lambda g: tuple(g.size),
            "sphere": lambda g: (g.radius,),
            "cylinder": lambda g: (g.radius, g.length),
        }
        assert found[shape](geometry) == size
        materials = {material.name: material.color.rgba for material in urdf.robot.materials}
        np.testing.assert_array_equal(materials[visual.material.name], color)
        pose = np.eye(4) if visual.origin is None else visual.origin
        np.testing.assert_array_equal(pose[:3, 3], origin)
        np.testing.assert_array_equal(pose[:3, :3], np.eye(3))

    @pytest.mark.parametrize("link", LINKS)
    def test_mjcf_visual(self, mjcf, link):
        shape, size, color, origin = VISUALS[kind(link)]
        (geom,) = geoms(mjcf, link, 2)
        assert mjcf.geom_type[geom] == getattr(mujoco.mjtGeom, f"mjGEOM_{shape.upper()}")
        # MuJoCo states half lengths; a cylinder's radius is whole.
        halves = {"box": [s / 2 for s in size], "sphere": size, "cylinder": [size[0], size[-1] / 2]}[shape]
        np.testing.assert_allclose(mjcf.geom_size[geom, : len(halves)], halves, rtol=0, atol=1e-15)
        np.testing.assert_allclose(mjcf.mat_rgba[mjcf.geom_matid[geom]], color, rtol=0, atol=1e-7)  # float32
        np.testing.assert_array_equal(mjcf.geom_pos[geom], origin)
        np.testing.assert_array_equal(mjcf.geom_quat[geom], [1, 0, 0, 0])
        assert mjcf.geom_contype[geom] == mjcf.geom_conaffinity[geom] == 0

    def test_package(self):
        assert VISUALS["base_link"][1] == facts.BASE_SIZE
        assert VISUALS["hip"][1] == (facts.HIP_RADIUS,)
        assert VISUALS["leg"][1] == (facts.LEG_RADIUS, facts.LEG_LENGTH)
        assert facts.HIP_TO_KNEE == 0.03
        assert facts.HIP_POSITIONS == LEGS


class TestJoints:
    @pytest.mark.parametrize("leg", LEGS)
    def test_urdf(self, urdf, leg):
        x, y = LEGS[leg]
        expected = {
            "hip": ("base_link", f"{leg}_hip", (x, y, 0.0)),
            "knee": (f"{leg}_hip", f"{leg}_leg", (0.0, 0.0, -0.03)),
        }
        for name, (parent, child, origin) in expected.items():
            joint = urdf.joint_map[f"{leg}_{name}_joint"]
            assert (joint.type, joint.parent, joint.child) == ("revolute", parent, child)
            np.testing.assert_array_equal(joint.origin[:3, 3], origin)
            np.testing.assert_array_equal(joint.origin[:3, :3], np.eye(3))
            np.testing.assert_array_equal(joint.axis, [0, 1, 0])
            limit = joint.limit
            assert (limit.lower, limit.upper) == LIMITS[name]
            assert (limit.effort, limit.velocity) == (EFFORT, VELOCITY)

    @pytest.mark.parametrize("leg", LEGS)
    def test_mjcf(self, mjcf, leg):
        x, y = LEGS[leg]
        np.testing.assert_array_equal(mjcf.body(f"{leg}_hip").pos, [x, y, 0.0])
        np.testing.assert_array_equal(mjcf.body(f"{leg}_leg").pos, [0.0, 0.0, -0.03])
        assert mjcf.body(f"{leg}_hip").parentid == mjcf.body("base_link").id
        assert mjcf.body(f"{leg}_leg").parentid == mjcf.body(f"{leg}_hip").id
        for name, link in (("hip", f"{leg}_hip"), ("knee", f"{leg}_leg")):
            joint, motor = mjcf.joint(f"{leg}_{name}_joint"), mjcf.actuator(f"{leg}_{name}_joint")
            assert joint.type == mujoco.mjtJoint.mjJNT_HINGE
            assert joint.bodyid == mjcf.body(link).id
            np.testing.assert_array_equal(joint.axis, [0, 1, 0])
            np.testing.assert_array_equal(joint.pos, [0, 0, 0])
            assert joint.limited == 1
            np.testing.assert_array_equal(joint.range, LIMITS[name])
            np.testing.assert_array_equal(motor.ctrlrange, LIMITS[name])
            np.testing.assert_array_equal(motor.forcerange, [-EFFORT, EFFORT])
            resistance, constant = motor.gainprm[:2]
            voltage = motor.gainprm[7]
            assert constant * voltage / resistance == pytest.approx(EFFORT, rel=1e-12)
            assert voltage / constant == pytest.approx(VELOCITY, rel=1e-12)

    def test_package(self):
        assert (LIMITS["hip"], LIMITS["knee"]) == (facts.HIP_RANGE, facts.KNEE_RANGE)
        assert (facts.EFFORT_LIMIT, facts.VELOCITY_LIMIT) == (EFFORT, VELOCITY)
        np.testing.assert_array_equal(facts.JOINT_POSITION_LOW, [-1.5, -2.0] * 4)
        np.testing.assert_array_equal(facts.JOINT_POSITION_HIGH, [1.5, 0.0] * 4)
        for array in (facts.JOINT_POSITION_LOW, facts.JOINT_POSITION_HIGH, facts.STANCE):
            with pytest.raises(ValueError, match="read-only"):
                array[0] = 1.0

    def test_urdf_and_mjcf_share_the_passive_damping(self, urdf_model, mjcf):
        np.testing.assert_array_equal(urdf_model.dof_damping, mjcf.dof_damping[6:])


class TestMass:
    def principal(self, link):
        """Closed forms for homogeneous solids, kg m^2."""
        mass = MASSES[kind(link)]
        if link == "base_link":
            return mass / 12 * np.array([0.15**2 + 0.08**2, 0.30**2 + 0.08**2, 0.30**2 + 0.15**2])
        if kind(link) == "hip":
            return np.full(3, 2 / 5 * mass * 0.03**2)
        across = mass * (0.02**2 / 4 + 0.16**2 / 12)
        return np.array([across, across, mass * 0.02**2 / 2])

    def test_package(self):
        assert pytest.approx(4.0, abs=1e-12) == TOTAL_MASS
        assert tuple(MASSES.values()) == (facts.BASE_MASS, facts.HIP_MASS, facts.LEG_MASS)
        for link, inertia in {
            "base_link": facts.solid_box_inertia(facts.BASE_MASS, facts.BASE_SIZE),
            "LF_hip": facts.solid_sphere_inertia(facts.HIP_MASS, facts.HIP_RADIUS),
            "LF_leg": facts.solid_cylinder_inertia(facts.LEG_MASS, facts.LEG_RADIUS, facts.LEG_LENGTH),
        }.items():
            np.testing.assert_allclose(inertia, self.principal(link), rtol=1e-14)

    @pytest.mark.parametrize("link", LINKS)
    def test_urdf(self, urdf, link):
        inertial = urdf.link_map[link].inertial
        assert inertial.mass == MASSES[kind(link)]
        np.testing.assert_allclose(inertial.inertia, np.diag(self.principal(link)), rtol=1e-9, atol=0)
        pose = np.eye(4) if inertial.origin is None else inertial.origin
        np.testing.assert_array_equal(pose[:3, 3], VISUALS[kind(link)][3])
        np.testing.assert_array_equal(pose[:3, :3], np.eye(3))

    @pytest.mark.parametrize("source", ["urdf_model", "mjcf"])
    @pytest.mark.parametrize("link", LINKS)
    def test_compiled(self, request, source, link):
        model = request.getfixturevalue(source)
        body = model.body(link)
        assert body.mass == pytest.approx(MASSES[kind(link)], rel=1e-9)
        np.testing.assert_allclose(body.ipos, VISUALS[kind(link)][3], rtol=0, atol=1e-15)
        axes = Rotation.from_quat(body.iquat, scalar_first=True).as_matrix()
        tensor = axes @ np.diag(body.inertia) @ axes.T
        np.testing.assert_allclose(tensor, np.diag(self.principal(link)), rtol=1e-9, atol=1e-14)

    def test_inertia_matrix_agrees(self, urdf_model, mjcf):
        """Joint-space inertia of both, in random positions, without the rotors that a URDF cannot state."""

        def joint_inertia(model, positions):
            data = mujoco.MjData(model)
            data.qpos[-8:] = positions
            mujoco.mj_forward(model, data)
            full = np.zeros((model.nv, model.nv))
            mujoco.mj_fullM(model, data, full)
            return full[-8:, -8:] - np.diag(model.dof_armature[-8:])

        for positions in random_positions(np.random.default_rng(0), 20):
            np.testing.assert_allclose(
                joint_inertia(mjcf, positions), joint_inertia(urdf_model, positions), rtol=1e-9, atol=1e-12
            )

    def test_geoms_add_no_mass(self, model):
        assert model.body_mass.sum() == pytest.approx(4.0, abs=1e-9)


class TestCollision:
    @pytest.mark.parametrize("link", LINKS)
    def test_every_link_has_it(self, urdf, mjcf, link):
        assert urdf.link_map[link].collisions
        assert geoms(mjcf, link, 3)

    @pytest.mark.parametrize("leg", LEGS)
    def test_urdf_foot_is_round_and_ends_at_the_legs_end(self, urdf, leg):
        shank, foot = urdf.link_map[f"{leg}_leg"].collisions
        assert (shank.geometry.cylinder.radius, foot.geometry.sphere.radius) == (0.02, 0.02)
        assert foot.origin[2, 3] - foot.geometry.sphere.radius == pytest.approx(-0.16, abs=1e-15)
        # The cylinder ends where the ball's equator is: its edge does not reach beyond the rounded foot.
        assert shank.origin[2, 3] - shank.geometry.cylinder.length / 2 == pytest.approx(foot.origin[2, 3], abs=1e-15)

    @pytest.mark.parametrize("leg", LEGS)
    def test_mjcf_foot_is_round_and_ends_at_the_legs_end(self, mjcf, leg):
        (capsule,) = geoms(mjcf, f"{leg}_leg", 3)
        assert mjcf.geom_type[capsule] == mujoco.mjtGeom.mjGEOM_CAPSULE
        radius, half = mjcf.geom_size[capsule, :2]
        assert radius == 0.02
        assert mjcf.geom_pos[capsule, 2] - half - radius == pytest.approx(-0.16, abs=1e-15)
        assert mjcf.geom_pos[capsule, 2] + half + radius == pytest.approx(0.0, abs=1e-15)
        site = mjcf.site(f"{leg}_foot")
        np.testing.assert_allclose(site.pos, [0, 0, -0.14], rtol=0, atol=1e-15)

    @pytest.mark.parametrize("link", ["base_link", *(f"{leg}_hip" for leg in LEGS)])
    def test_trunk_collides_in_its_visible_shape(self, urdf, mjcf, link):
        (collision,) = urdf.link_map[link].collisions
        (visual,) = urdf.link_map[link].visuals
        assert repr(collision.geometry) == repr(visual.geometry)
        (seen,), (felt,) = geoms(mjcf, link, 2), geoms(mjcf, link, 3)
        assert mjcf.geom_type[seen] == mjcf.geom_type[felt]
        np.testing.assert_array_equal(mjcf.geom_size[seen], mjcf.geom_size[felt])

    def test_only_legs_of_one_side_can_reach_each_other(self, mjcf):
        """Why no other pair of the robot's own links is tested for contact."""
        collision = {link: geoms(mjcf, link, 3)[0] for link in LINKS}
        joined = {("base_link", f"{leg}_hip") for leg in LEGS} | {(f"{leg}_hip", f"{leg}_leg") for leg in LEGS}
        corners = list(itertools.product(*([LIMITS["hip"], LIMITS["knee"]] * 4)))
        positions = np.concatenate([corners, random_positions(np.random.default_rng(0), 200)])
        data = mujoco.MjData(mjcf)
        touching = set()
        for row in positions:
            data.qpos[7:] = row
            mujoco.mj_kinematics(mjcf, data)
            for one, other in itertools.combinations(LINKS, 2):
                if (one, other) not in joined and (
                    mujoco.mj_geomDistance(mjcf, data, collision[one], collision[other], 0.01, None) < 0.0
                ):
                    touching.add((one, other))
        assert touching == {("LF_leg", "LH_leg"), ("RF_leg", "RH_leg")}

    def test_legs_of_one_side_do_collide(self, model):
        data = mujoco.MjData(model)
        data.qpos[2] = 1.0
        data.qpos[7:] = [1.2, -0.1, 1.2, -0.1, -1.2, -0.1, -1.2, -0.1]
        mujoco.mj_forward(model, data)
        pairs = {tuple(sorted(model.geom(i).name for i in contact.geom)) for contact in data.contact}
        assert pairs == {
            ("LF_leg_collision", "LH_leg_collision"),
            ("RF_leg_collision", "RH_leg_collision"),
        }

    @pytest.mark.parametrize("link", LINKS)
    def test_every_link_meets_the_ground(self, model, link):
        (geom,) = geoms(model, link, 3)
        ground = model.geom("ground").id
        assert model.geom_contype[geom] & model.geom_conaffinity[ground]


class TestKinematics:
    def test_urdf_mjcf_and_package_agree(self, urdf, urdf_model):
        """MuJoCo on both files, with yourdfpy as a witness that shares no code with it."""
        positions = random_positions(np.random.default_rng(0), 1000)
        poses = forward_kinematics(positions)
        assert tuple(poses) == LINKS
        data = mujoco.MjData(urdf_model)
        bodies = [urdf_model.body(link).id for link in LINKS]
        witness = np.empty((len(positions), len(LINKS), 4, 4))
        place, turn = np.empty((len(positions), len(LINKS), 3)), np.empty((len(positions), len(LINKS), 9))
        for i, row in enumerate(positions):
            data.qpos[:] = row
            mujoco.mj_kinematics(urdf_model, data)
            place[i], turn[i] = data.xpos[bodies], data.xmat[bodies]
            urdf.update_cfg(row)
            witness[i] = [urdf.get_transform(link, "base_link") for link in LINKS]
        np.testing.assert_allclose(place, witness[..., :3, 3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(turn.reshape(witness[..., :3, :3].shape), witness[..., :3, :3], rtol=0, atol=1e-12)
        for i, link in enumerate(LINKS):
            position, quaternion = poses[link]
            np.testing.assert_allclose(position, witness[:, i, :3, 3], rtol=0, atol=1e-12)
            matrix = Rotation.from_quat(quaternion, scalar_first=True).as_matrix()
            np.testing.assert_allclose(matrix, witness[:, i, :3, :3], rtol=0, atol=1e-12)

    @pytest.mark.parametrize("leg", LEGS)
    def test_foot_in_closed_form(self, leg):
        rng = np.random.default_rng(0)
        positions = random_positions(rng, 100)
        hip = positions[:, JOINTS.index(f"{leg}_hip_joint")]
        leg_angle = hip + positions[:, JOINTS.index(f"{leg}_knee_joint")]
        x, y = LEGS[leg]
        expected = np.stack(
            [
                x - 0.03 * np.sin(hip) - 0.16 * np.sin(leg_angle),
                np.full(100, y),
                -0.03 * np.cos(hip) - 0.16 * np.cos(leg_angle),
            ],
            axis=-1,
        )
        position, quaternion = forward_kinematics(positions)[f"{leg}_leg"]
        end = position + Rotation.from_quat(quaternion, scalar_first=True).apply([0.0, 0.0, -0.16])
        np.testing.assert_allclose(end, expected, rtol=0, atol=1e-12)

    @pytest.mark.parametrize("leg", LEGS)
    def test_directions(self, leg):
        """A positive hip angle swings the foot backwards, a negative knee angle forwards."""

        def foot_x(hip, knee):
            positions = np.zeros(8)
            positions[JOINTS.index(f"{leg}_hip_joint")] = hip
            positions[JOINTS.index(f"{leg}_knee_joint")] = knee
            position, quaternion = forward_kinematics(positions)[f"{leg}_leg"]
            return (position + Rotation.from_quat(quaternion, scalar_first=True).apply([0, 0, -0.16]))[0]

        assert foot_x(0.0, 0.0) == pytest.approx(LEGS[leg][0], abs=1e-12)
        assert foot_x(0.3, 0.0) < LEGS[leg][0] - 0.03
        assert foot_x(0.0, -0.3) > LEGS[leg][0] + 0.03

    def test_stance(self, mjcf):
        """Feet under their hips, soles on the ground, in the package and in the home keyframe."""
        poses = forward_kinematics(STANCE, [0, 0, STANCE_HEIGHT, 1, 0, 0, 0])
        for leg, (x, y) in LEGS.items():
            position, quaternion = poses[f"{leg}_leg"]
            ball = position + Rotation.from_quat(quaternion, scalar_first=True).apply([0, 0, -0.14])
            np.testing.assert_allclose(ball[:2], [x, y], rtol=0, atol=3e-4)
            assert ball[2] - facts.FOOT_RADIUS == pytest.approx(0.0, abs=1e-7)
        np.testing.assert_array_equal(mjcf.key("home").qpos, [0, 0, STANCE_HEIGHT, 1, 0, 0, 0, *STANCE])
        np.testing.assert_array_equal(mjcf.key("home").ctrl, STANCE)
        assert mjcf.body("base_link").pos[2] == STANCE_HEIGHT

    def test_any_leading_axes(self):
        positions = random_positions(np.random.default_rng(0), 2, 3)
        poses = forward_kinematics(positions)
        for index in np.ndindex(2, 3):
            single = forward_kinematics(positions[index])
            for link in LINKS:
                assert single[link][0].shape == (3,)
                assert single[link][1].shape == (4,)
                np.testing.assert_array_equal(poses[link][0][index], single[link][0])
                np.testing.assert_array_equal(poses[link][1][index], single[link][1])
        assert forward_kinematics(np.zeros((0, 8)))["LF_leg"][0].shape == (0, 3)

    def test_base_pose_moves_every_link(self):
        rng = np.random.default_rng(0)
        positions = random_positions(rng, 3)
        turn = Rotation.random(rng=rng)
        shift = rng.standard_normal(3)
        base = np.concatenate([shift, turn.as_quat(scalar_first=True)])
        local, world = forward_kinematics(positions), forward_kinematics(positions, base)
        for link in LINKS:
            np.testing.assert_allclose(world[link][0], turn.apply(local[link][0]) + shift, rtol=0, atol=1e-12)
            expected = (turn * Rotation.from_quat(local[link][1], scalar_first=True)).as_matrix()
            found = Rotation.from_quat(world[link][1], scalar_first=True).as_matrix()
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)

    def test_base_poses_and_positions_broadcast(self):
        rng = np.random.default_rng(0)
        base = np.tile([0.0, 0, 0, 1, 0, 0, 0], (3, 1))
        base[:, 0] = [1.0, 2.0, 3.0]
        one = forward_kinematics(STANCE, base)["LF_leg"][0]
        assert one.shape == (3, 3)
        np.testing.assert_allclose(np.diff(one[:, 0]), 1.0, rtol=0, atol=1e-12)
        many = forward_kinematics(random_positions(rng, 2, 1), base)["LF_leg"][0]
        assert many.shape == (2, 3, 3)

    @pytest.mark.parametrize(
        ("positions", "base_pose", "message"),
        [
            (np.zeros(7), None, r"\(\.\.\., 8\).*found \(7,\)"),
            (0.0, None, r"\(\.\.\., 8\).*found \(\)"),
            (np.zeros((8, 2)), None, r"found \(8, 2\)"),
            (np.zeros(8), np.zeros(6), r"base_pose.*\(\.\.\., 7\).*found \(6,\)"),
            (np.zeros((2, 8)), np.ones((3, 7)), r"\(2, 8\).*\(3, 7\)"),
            (np.full(8, np.nan), None, "finite"),
            (np.zeros(8), [0, 0, math.inf, 1, 0, 0, 0], "finite"),
            (np.zeros(8), np.zeros(7), "zero quaternion"),
            (np.full(8, -1e11), None, r"within 1e\+10; found -1e\+11"),
        ],
    )
    def test_errors(self, positions, base_pose, message):
        with pytest.raises(QuadrupedError, match=message):
            forward_kinematics(positions, base_pose)

    def test_many_poses_are_each_the_whole_models(self, mjcf):
        """Across the edge of a block, and to the last bit."""
        rng = np.random.default_rng(0)
        positions, base = random_positions(rng, 5000), rng.standard_normal((5000, 7))
        poses = forward_kinematics(positions, base)
        data = mujoco.MjData(mjcf)
        for row in (0, 4095, 4096, 4999):
            data.qpos[:7], data.qpos[7:] = base[row], positions[row]
            mujoco.mj_kinematics(mjcf, data)
            for link in LINKS:
                np.testing.assert_array_equal(poses[link][0][row], data.body(link).xpos)
                np.testing.assert_array_equal(poses[link][1][row], data.body(link).xquat)


class TestTransforms:
    def test_are_those_of_the_urdf(self, urdf):
        """One a moving joint, parent to child, as yourdfpy reads the file that robot_state_publisher would read."""
        positions = random_positions(np.random.default_rng(0), 200)
        transforms = joint_transforms(positions)
        assert {(t.parent, t.child) for t in transforms} == {
            (joint.parent, joint.child) for joint in urdf.joint_map.values() if joint.type != "fixed"
        }
        assert len(transforms) == len(JOINTS)
        for row, configuration in enumerate(positions):
            urdf.update_cfg(dict(zip(JOINTS, configuration, strict=True)))
            for transform in transforms:
                expected = urdf.get_transform(transform.child, transform.parent)
                found = Rotation.from_quat(transform.rotation[row], scalar_first=True).as_matrix()
                np.testing.assert_allclose(transform.translation[row], expected[:3, 3], rtol=0, atol=1e-12)
                np.testing.assert_allclose(found, expected[:3, :3], rtol=0, atol=1e-12)

    def test_chained_they_are_forward_kinematics(self):
        rng = np.random.default_rng(1)
        positions, base = random_positions(rng, 2, 3), rng.standard_normal((2, 3, 7))
        base[..., 3:] /= np.linalg.norm(base[..., 3:], axis=-1, keepdims=True)
        transforms = joint_transforms(positions, base)
        assert (transforms[0].parent, transforms[0].child) == ("odom", "base_link")
        poses = forward_kinematics(positions, base)
        for index in np.ndindex(2, 3):
            place = {"odom": (np.zeros(3), Rotation.identity())}
            for transform in transforms:
                origin, turn = place[transform.parent]
                place[transform.child] = (
                    origin + turn.apply(transform.translation[index]),
                    turn * Rotation.from_quat(transform.rotation[index], scalar_first=True),
                )
            for link in LINKS:
                np.testing.assert_allclose(place[link][0], poses[link][0][index], rtol=0, atol=1e-12)
                expected = Rotation.from_quat(poses[link][1][index], scalar_first=True).as_matrix()
                np.testing.assert_allclose(place[link][1].as_matrix(), expected, rtol=0, atol=1e-12)

    def test_no_link_is_without_a_joint(self, urdf):
        assert fixed_transforms() == ()
        assert all(joint.type == "revolute" for joint in urdf.joint_map.values())

    @pytest.mark.parametrize(
        ("positions", "base_pose", "message"),
        [
            (np.zeros(7), None, r"\(\.\.\., 8\); found \(7,\)"),
            (np.full(8, np.nan), None, "finite"),
            (np.zeros((2, 8)), np.ones(7), r"\(2, 7\); found \(7,\)"),
        ],
    )
    def test_errors(self, positions, base_pose, message):
        with pytest.raises(QuadrupedError, match=message):
            joint_transforms(positions, base_pose)


class TestResting:
    def test_in_the_stance_on_all_fours_and_level(self):
        pose = resting_pose(STANCE)
        np.testing.assert_allclose(pose, [0, 0, STANCE_HEIGHT, 1, 0, 0, 0], rtol=0, atol=1e-7)
        np.testing.assert_allclose(sole_heights(STANCE, pose), 0.0, rtol=0, atol=1e-12)

    def test_bent_front_legs_lower_the_front(self):
        """The pitch follows from the two heights of the feet and the distance between them."""
        positions = STANCE.copy()
        positions[:4] = [1.2, -1.9] * 2
        front, hind = (-0.03 * np.cos(h) - 0.14 * np.cos(h + k) for h, k in ((1.2, -1.9), (0.6, -0.72)))
        reach = 0.15 - 0.03 * np.sin(1.2) - 0.14 * np.sin(1.2 - 1.9), -0.15 - 0.03 * np.sin(0.6) - 0.14 * np.sin(-0.12)
        pose = resting_pose(positions)
        pitch = np.arctan2(front - hind, reach[0] - reach[1])
        np.testing.assert_allclose(pose[3:], [np.cos(pitch / 2), 0, np.sin(pitch / 2), 0], rtol=0, atol=1e-9)
        np.testing.assert_allclose(sole_heights(positions, pose), 0.0, rtol=0, atol=1e-9)

    def test_nothing_is_below_the_ground_and_the_robot_is_carried(self, model):
        data, scratch = mujoco.MjData(model), np.zeros(6)
        ground = model.geom("ground").id
        robot = [i for i in range(model.ngeom) if model.geom_group[i] == 3]
        rng = np.random.default_rng(0)
        on_feet = 0
        for _ in range(200):
            positions = rng.uniform([-1.5, -2.0] * 4, [1.5, 0.0] * 4)
            data.qpos = [*resting_pose(positions), *positions]
            mujoco.mj_forward(model, data)
            lowest = min(mujoco.mj_geomDistance(model, data, ground, geom, 1.0, scratch) for geom in robot)
            assert lowest == pytest.approx(0.0, abs=1e-9)
            on_feet += (sole_heights(positions, data.qpos[:7]) < 1e-9).sum() >= 3
        assert on_feet > 50


class TestAssets:
    @pytest.mark.parametrize("name", ["mini_quadruped.urdf", "mini_quadruped.xml", "scene.xml"])
    def test_path(self, name):
        assert asset_path(name).is_file()
        assert asset_path(name).name == name

    @pytest.mark.parametrize("name", ["mini_quadruped.usd", "", "../scene.xml"])
    def test_unknown_name(self, name):
        with pytest.raises(QuadrupedError, match=r"mini_quadruped\.urdf, mini_quadruped\.xml, scene\.xml") as error:
            asset_path(name)
        assert repr(name) in str(error.value)

    def test_the_scene_is_the_robot_on_a_ground(self, model, mjcf):
        assert model.ngeom == mjcf.ngeom + 1
        assert model.geom_type[model.geom("ground").id] == mujoco.mjtGeom.mjGEOM_PLANE
        assert mjcf.opt.timestep == model.opt.timestep

    def test_timestep(self, model):
        assert load_model(0.001).opt.timestep == 0.001
        assert load_model().opt.timestep == model.opt.timestep == 0.005
