"""The built-in robot's numbers, held against its URDF, its MJCF and the tutorial."""

import itertools

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tutorial import (
    EFFORT,
    JOINTS,
    LEGS,
    LIMITS,
    LINKS,
    MASSES,
    SHAPES,
    VELOCITY,
    geoms,
    kind,
    random_positions,
)

from quadruped_env import JOINT_NAMES, LEG_NAMES, QuadrupedError, asset_path
from quadruped_env.robot import MINI_QUADRUPED, JointMotor, MotorConfig, QuadrupedDesign
from quadruped_env.simulation import build_model

DESIGN = QuadrupedDesign()


class TestNamesAndOrder:
    def test_package(self):
        assert JOINT_NAMES == MINI_QUADRUPED.joint_names == JOINTS
        assert MINI_QUADRUPED.link_names == LINKS
        assert LEG_NAMES == MINI_QUADRUPED.leg_names == tuple(LEGS)

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
    def test_package(self):
        assert SHAPES["base_link"][1] == DESIGN.base_size
        assert SHAPES["hip"][1] == (DESIGN.hip_radius,)
        assert SHAPES["leg"][1] == (DESIGN.leg_radius, DESIGN.leg_length)
        assert DESIGN.hip_to_knee == 0.03
        assert {leg: DESIGN.hip_position(leg) for leg in LEGS} == LEGS
        assert MINI_QUADRUPED.foot_radius == 0.02


class TestJoints:
    def test_package(self):
        robot = MINI_QUADRUPED
        np.testing.assert_array_equal(robot.effort_limit, [EFFORT] * 8)
        np.testing.assert_array_equal(robot.velocity_limit, [VELOCITY] * 8)
        np.testing.assert_array_equal(robot.joint_position_low, [-1.5, -2.0] * 4)
        np.testing.assert_array_equal(robot.joint_position_high, [1.5, 0.0] * 4)
        for array in (robot.joint_position_low, robot.effort_limit, robot.velocity_limit, robot.stance):
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
        assert MINI_QUADRUPED.total_mass == pytest.approx(4.0, abs=1e-12)
        assert tuple(MASSES.values()) == (DESIGN.base_mass, DESIGN.hip_mass, DESIGN.leg_mass)
        for link, inertia in {
            "base_link": DESIGN.base_inertia,
            "LF_hip": DESIGN.hip_inertia,
            "LF_leg": DESIGN.leg_inertia,
        }.items():
            np.testing.assert_allclose(inertia, self.principal(link), rtol=1e-14)

    @pytest.mark.parametrize("source", ["urdf_model", "mjcf"])
    @pytest.mark.parametrize("link", LINKS)
    def test_compiled(self, request, source, link):
        model = request.getfixturevalue(source)
        body = model.body(link)
        assert body.mass == pytest.approx(MASSES[kind(link)], rel=1e-9)
        np.testing.assert_allclose(body.ipos, SHAPES[kind(link)][3], rtol=0, atol=1e-15)
        axes = Rotation.from_quat(body.iquat, scalar_first=True).as_matrix()
        tensor = axes @ np.diag(body.inertia) @ axes.T
        np.testing.assert_allclose(tensor, np.diag(self.principal(link)), rtol=1e-9, atol=1e-14)

    def test_inertia_matrix_agrees(self, urdf_model, mjcf):
        """Joint-space inertia of both, in random positions, without the rotors: MuJoCo reads none from a URDF."""

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
    def test_only_legs_of_one_side_can_reach_each_other(self, mjcf):
        """Why no other pair of the robot's own links is tested for contact."""
        collision = {link: geoms(mjcf, link, 3)[0] for link in LINKS}
        joined = {("base_link", f"{leg}_hip") for leg in LEGS} | {(f"{leg}_hip", f"{leg}_leg") for leg in LEGS}
        corners = list(itertools.product(*([LIMITS["hip"], LIMITS["knee"]] * 4)))
        positions = np.concatenate([corners, random_positions(np.random.default_rng(0), 50)])
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
        assert pairs == {("LF_leg_collision", "LH_leg_collision"), ("RF_leg_collision", "RH_leg_collision")}

    @pytest.mark.parametrize("link", LINKS)
    def test_every_link_meets_the_ground(self, model, link):
        (geom,) = geoms(model, link, 3)
        ground = model.geom("ground").id
        assert model.geom_contype[geom] & model.geom_conaffinity[ground]


class TestAssets:
    @pytest.mark.parametrize("name", ["mini_quadruped.urdf", "mini_quadruped.xml", "scene.xml"])
    def test_path(self, name):
        assert asset_path(name).is_file()
        assert asset_path(name).name == name

    def test_the_shipped_files_are_those_of_the_design(self):
        for name, text in (("mini_quadruped.xml", MINI_QUADRUPED.mjcf), ("mini_quadruped.urdf", MINI_QUADRUPED.urdf)):
            assert asset_path(name).read_text() == text, f"{name} differs: run python tools/robot_files.py"

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
        assert build_model(0.001).opt.timestep == 0.001
        assert build_model().opt.timestep == model.opt.timestep == 0.005

    def test_build_model_gives_every_caller_a_model_of_its_own(self):
        one, other = build_model(0.002), build_model(0.002)
        one.body_mass[1] = 99.0
        one.vis.global_.offwidth = 5000
        again = build_model(0.002)
        assert other.body_mass[1] == again.body_mass[1] < 10.0
        assert again.vis.global_.offwidth < 5000
        assert build_model(motors=MotorConfig(hip=JointMotor(armature=0.02))).dof_armature[6] == 0.02
        assert build_model().dof_armature[6] == 0.01
