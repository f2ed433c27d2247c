"""Robots as values: equality, copies, files, and the check of a model against its robot."""

import copy
import dataclasses
import itertools
import json
import pickle

import mujoco
import numpy as np
import pytest
from tutorial import random_positions

from quadruped_env import QuadrupedError, forward_kinematics
from quadruped_env.robot import MINI_QUADRUPED, QuadrupedDesign, Robot
from quadruped_env.robot.readings import sensor_columns

OTHER = QuadrupedDesign(name="other", leg_names=("RH", "LH", "RF", "LF"), leg_length=0.2, base_mass=3.0)


class TestContent:
    def test_robots_of_equal_content_are_equal(self):
        again = QuadrupedDesign().robot()
        assert again is not MINI_QUADRUPED
        assert again == MINI_QUADRUPED
        assert hash(again) == hash(MINI_QUADRUPED)
        assert len({again, MINI_QUADRUPED, OTHER.robot()}) == 2

    def test_comments_and_layout_of_the_files_do_not_count(self):
        text = MINI_QUADRUPED.mjcf.replace("\n  ", "\n\n     ").replace("-->", "and more -->")
        assert text != MINI_QUADRUPED.mjcf
        assert dataclasses.replace(MINI_QUADRUPED, mjcf=text) == MINI_QUADRUPED

    def test_copies_are_equal(self):
        robot = OTHER.robot()
        assert robot.total_mass == pytest.approx(3.0 + 4 * 0.45)  # compiles the model
        pickled = pickle.dumps(robot)
        assert len(pickled) < 50_000  # without the compiled model
        for found in (pickle.loads(pickled), copy.copy(robot), copy.deepcopy(robot)):  # noqa: S301
            assert found == robot
            assert not found.stance.flags.writeable

    def test_json_round_trip(self):
        robot = OTHER.robot()
        assert Robot.from_dict(json.loads(json.dumps(robot.to_dict()))) == robot
        with pytest.raises(QuadrupedError, match="expected the fields"):
            Robot.from_dict({"name": "robot"})


class TestModel:
    def test_kinematics_of_another_design_in_closed_form(self):
        robot = OTHER.robot()
        positions = random_positions(np.random.default_rng(0), 50)
        poses = forward_kinematics(positions, robot=robot)
        feet = robot.skeleton.foot_centres(positions)
        assert robot.joint_names[:2] == ("RH_hip_joint", "RH_knee_joint")
        for leg, name in enumerate(robot.leg_names):
            hip, knee = positions[:, 2 * leg], positions[:, 2 * leg + 1]
            x, y = (0.15 if name[1] == "F" else -0.15), (0.10 if name[0] == "L" else -0.10)
            foot = [x - 0.03 * np.sin(hip) - 0.18 * np.sin(hip + knee), np.full(50, y)]
            foot.append(-0.03 * np.cos(hip) - 0.18 * np.cos(hip + knee))
            np.testing.assert_allclose(feet[:, leg], np.stack(foot, axis=-1), rtol=0, atol=1e-12)
            np.testing.assert_allclose(poses[f"{name}_hip"][0], np.tile([x, y, 0.0], (50, 1)), rtol=0, atol=1e-12)

    def test_masses_inferred_from_geoms_stay_in_the_skeleton(self):
        text = MINI_QUADRUPED.mjcf.replace('mass="0"', 'density="500"')
        kept = "\n".join(line for line in text.splitlines() if "<inertial" not in line)
        robot = dataclasses.replace(MINI_QUADRUPED, mjcf=kept)
        whole = robot.spec().compile()
        assert robot.total_mass == pytest.approx(whole.body_mass.sum(), rel=1e-12)
        data = mujoco.MjData(whole)
        data.qpos[7:] = robot.stance
        mujoco.mj_forward(whole, data)
        np.testing.assert_allclose(
            robot.skeleton.centre_of_mass(robot.stance), data.subtree_com[1] - data.xpos[1], rtol=0, atol=1e-12
        )

    @pytest.mark.parametrize(
        ("shape", "depth"),
        [
            ('type="sphere" size="0.05"', 0.05),
            ('type="cylinder" size="0.03 0.05"', 0.05),
            ('type="box" size="0.05 0.05 0.05"', 0.05),
        ],
    )
    def test_resting_pose_lies_on_any_collision_shape(self, shape, depth):
        text = MINI_QUADRUPED.mjcf.replace(
            '<site name="imu"', f'<geom class="collision" pos="0 0 -0.3" {shape}/>\n      <site name="imu"'
        )
        robot = dataclasses.replace(MINI_QUADRUPED, mjcf=text)
        assert robot.skeleton.resting_pose(robot.stance)[2] == pytest.approx(0.3 + depth, abs=1e-9)

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            (
                {"joint_names": MINI_QUADRUPED.joint_names[::-1]},
                "the joints of its model are in the order LF_hip_joint",
            ),
            ({"foot_sites": ("LF_foot", "RF_foot", "LH_foot", "toe")}, "no site 'toe'"),
            ({"link_names": (*MINI_QUADRUPED.link_names[:-1], "tail")}, "no body 'tail'"),
            ({"sensors": {"orientation": ("compass",)}}, "no sensor 'compass'"),
            (
                {"joint_position_high": MINI_QUADRUPED.joint_position_high + 0.1},
                "joint_position_high of LF_hip_joint is 1.6, but 1.5 in its model; correct it, or give joint",
            ),
            ({"mjcf": "<mujoco><worldbody/></mujoco>"}, "one free joint"),
            ({"mjcf": "no XML"}, "cannot read its MJCF"),
        ],
    )
    def test_model_that_is_not_the_robots_is_refused(self, change, message):
        with pytest.raises(QuadrupedError, match=f"robot 'mini_quadruped': .*{message}"):
            dataclasses.replace(MINI_QUADRUPED, **change)

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"stance": np.zeros(7)}, "stance must be 8 finite numbers"),
            ({"stance": np.full(8, 2.5)}, "the stance must be within the joint limits; LF_hip_joint is not"),
            ({"stance": np.full(8, -1.9)}, "the stance must be within the joint limits; LF_hip_joint is not"),
            ({"effort_limit": np.full(8, np.nan)}, "effort_limit must be 8 finite numbers"),
            ({"foot_mirror": (0, 1)}, "foot_mirror must be 4 of 0, 1, 2, 3; found"),
            ({"leg_names": ("LF", "LF", "LH", "RH")}, "must be different names"),
        ],
    )
    def test_fields_that_contradict_each_other_are_refused(self, change, message):
        with pytest.raises(QuadrupedError, match=message):
            dataclasses.replace(MINI_QUADRUPED, **change)


class TestDesign:
    @pytest.mark.parametrize("legs", list(itertools.permutations(["LF", "RF", "LH", "RH"]))[::5])
    def test_order_of_the_legs_is_the_order_of_the_model(self, legs):
        robot = QuadrupedDesign(leg_names=legs).robot()
        assert robot.leg_names == legs
        np.testing.assert_array_equal(robot.spec().compile().body_mass[1:].round(3), [2.2, *[0.25, 0.2] * 4])
        assert robot.total_mass == 4.0

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"name": "my robot"}, "name must be letters"),
            ({"leg_names": ("LF", "RF", "LH")}, "leg_names must be LF, RF, LH, RH in any order"),
            ({"leg_length": -0.1}, "leg_length must be positive"),
            ({"leg_length": 0.03}, "longer than twice leg_radius"),
            ({"base_size": (0.3, 0.15)}, "base_size must be 3 positive numbers"),
            ({"hip_offset": (0.15, 0.08)}, "clear the base"),
            ({"stance_angles": (0.6, 0.1)}, "stance_angles must be within knee_range"),
            ({"hip_range": (1.0, -1.0)}, "hip_range must be a pair"),
        ],
    )
    def test_dimensions_that_make_no_robot_are_refused(self, change, message):
        with pytest.raises(QuadrupedError, match=message):
            QuadrupedDesign(**change)


class TestGround:
    @pytest.mark.parametrize(
        ("element", "found"),
        [
            ('<geom name="floor" type="plane" size="5 5 0.1"/>', "a plane 'floor'"),
            ('<geom name="ground" type="plane" size="5 5 0.1" contype="0" conaffinity="0"/>', "a plane 'ground'"),
            ('<frame pos="1 0 0"><geom name="step" type="box" size="1 1 0.1"/></frame>', "a box 'step'"),
            ('<body><body><geom name="step" type="box" size="1 1 0.1"/></body></body>', "a box 'step'"),
        ],
        ids=["plane", "drawn plane", "frame", "fixed body"],
    )
    def test_model_with_a_ground_of_its_own_is_refused(self, element, found):
        # Two planes double every contact.
        mjcf = MINI_QUADRUPED.mjcf.replace("<worldbody>", f"<worldbody>{element}", 1)
        with pytest.raises(QuadrupedError, match=f"the robot alone.*found {found} fixed to the world: remove it"):
            dataclasses.replace(MINI_QUADRUPED, mjcf=mjcf)

    def test_lights_cameras_and_sites_of_the_world_are_accepted(self):
        elements = '<light name="sun"/><camera name="above"/><site name="origin"/><body mocap="true" name="goal"/>'
        mjcf = MINI_QUADRUPED.mjcf.replace("<worldbody>", f"<worldbody>{elements}", 1)
        assert dataclasses.replace(MINI_QUADRUPED, mjcf=mjcf).model.ngeom == MINI_QUADRUPED.model.ngeom


class TestSensors:
    @pytest.mark.parametrize(
        ("changes", "message"),
        [
            (dict.fromkeys(MINI_QUADRUPED.sensors, ()), "missing joint_position, .*, foot_angular_velocity; name"),
            ({"foot_force": ()}, "sensors: missing foot_force; name the sensors of the model"),
            ({"foot_forces": ("LF_foot_force",)}, "sensors: unknown field 'foot_forces'; valid fields are joint_pos"),
            ({"foot_force": ("LF_foot_force",)}, "sensors of foot_force must be sensors with 4 values, not 1"),
        ],
        ids=["none", "missing", "unknown", "too few"],
    )
    def test_sensors_that_do_not_fill_the_readings_are_refused_by_field(self, changes, message):
        robot = dataclasses.replace(MINI_QUADRUPED, sensors={**MINI_QUADRUPED.sensors, **changes})
        with pytest.raises(QuadrupedError, match=message):
            sensor_columns(robot.model, robot)

    @pytest.mark.parametrize("sensors", [3, [], {"foot_force": 3}])
    def test_sensors_that_are_no_names_by_field_are_refused(self, sensors):
        with pytest.raises(QuadrupedError, match="sensors must be a dict of field -> names"):
            dataclasses.replace(MINI_QUADRUPED, sensors=sensors)
