"""Kinematics, transforms and resting poses, against yourdfpy, SciPy and MuJoCo."""

import math

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tutorial import JOINTS, LEGS, LINKS, random_positions

from quadruped_env import QuadrupedError, forward_kinematics
from quadruped_env.robot import MINI_QUADRUPED

STANCE, STANCE_HEIGHT = MINI_QUADRUPED.stance, MINI_QUADRUPED.stance_height


class TestKinematics:
    def test_urdf_mjcf_and_package_agree(self, urdf, urdf_model):
        """MuJoCo on both files, and yourdfpy, which shares no code with it."""
        positions = random_positions(np.random.default_rng(0), 100)
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

    def test_stance(self, mjcf):
        """Feet under their hips, soles on the ground, in the package and in the home keyframe."""
        poses = forward_kinematics(STANCE, [0, 0, STANCE_HEIGHT, 1, 0, 0, 0])
        for leg, (x, y) in LEGS.items():
            position, quaternion = poses[f"{leg}_leg"]
            ball = position + Rotation.from_quat(quaternion, scalar_first=True).apply([0, 0, -0.14])
            np.testing.assert_allclose(ball[:2], [x, y], rtol=0, atol=3e-4)
            assert ball[2] - MINI_QUADRUPED.foot_radius == pytest.approx(0.0, abs=1e-7)
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

    def test_many_poses_are_each_those_of_mujoco(self, mjcf):
        """To the last bit, also across the boundary between blocks of 4096 poses."""
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
        """One per moving joint, parent to child, as yourdfpy reads the file that robot_state_publisher would read."""
        positions = random_positions(np.random.default_rng(0), 20)
        transforms = MINI_QUADRUPED.skeleton.joint_transforms(positions)
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

    def test_no_link_is_without_a_joint(self, urdf):
        assert MINI_QUADRUPED.skeleton.fixed_transforms() == ()
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
            MINI_QUADRUPED.skeleton.joint_transforms(positions, base_pose)


class TestResting:
    def test_in_the_stance_on_all_fours_and_level(self):
        pose = MINI_QUADRUPED.skeleton.resting_pose(STANCE)
        np.testing.assert_allclose(pose, [0, 0, STANCE_HEIGHT, 1, 0, 0, 0], rtol=0, atol=1e-7)
        np.testing.assert_allclose(MINI_QUADRUPED.sole_heights(STANCE, pose), 0.0, rtol=0, atol=1e-12)

    def test_bent_front_legs_lower_the_front(self):
        """The pitch follows from the two heights of the feet and the distance between them."""
        positions = STANCE.copy()
        positions[:4] = [1.2, -1.9] * 2
        front, hind = (-0.03 * np.cos(h) - 0.14 * np.cos(h + k) for h, k in ((1.2, -1.9), (0.6, -0.72)))
        reach = 0.15 - 0.03 * np.sin(1.2) - 0.14 * np.sin(1.2 - 1.9), -0.15 - 0.03 * np.sin(0.6) - 0.14 * np.sin(-0.12)
        pose = MINI_QUADRUPED.skeleton.resting_pose(positions)
        pitch = np.arctan2(front - hind, reach[0] - reach[1])
        np.testing.assert_allclose(pose[3:], [np.cos(pitch / 2), 0, np.sin(pitch / 2), 0], rtol=0, atol=1e-9)
        np.testing.assert_allclose(MINI_QUADRUPED.sole_heights(positions, pose), 0.0, rtol=0, atol=1e-9)

    def test_nothing_is_below_the_ground_and_the_robot_is_carried(self, model):
        data, scratch = mujoco.MjData(model), np.zeros(6)
        ground = model.geom("ground").id
        robot = [i for i in range(model.ngeom) if model.geom_group[i] == 3]
        rng = np.random.default_rng(0)
        on_feet = 0
        for _ in range(50):
            positions = rng.uniform([-1.5, -2.0] * 4, [1.5, 0.0] * 4)
            data.qpos = [*MINI_QUADRUPED.skeleton.resting_pose(positions), *positions]
            mujoco.mj_forward(model, data)
            lowest = min(mujoco.mj_geomDistance(model, data, ground, geom, 1.0, scratch) for geom in robot)
            assert lowest == pytest.approx(0.0, abs=1e-9)
            on_feet += (MINI_QUADRUPED.sole_heights(positions, data.qpos[:7]) < 1e-9).sum() >= 3
        assert on_feet > 0
