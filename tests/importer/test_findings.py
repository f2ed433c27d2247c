"""What files do: each is found with a number and a default, and said."""

import math
import re

import numpy as np
import pytest
from urdf_robots import FOOT, MASS, RADIUS, SHANK, SIDE, THIGH, collision, findings, imported, joint, link, robot

from quadruped_env.errors import QuadrupedError
from quadruped_env.importer import import_robot

G = 9.81


def stance_height(read):
    """Height of the hips by the joint positions of a leg, whose links are straight down at 0."""
    hip, knee = (read.stance.positions[name] for name in read.anatomy.legs[0].names[-2:])
    return THIGH * math.cos(hip) + SHANK * math.cos(hip + knee) + RADIUS


@pytest.mark.parametrize("joints", [2, 3])
def test_clean_robot_is_read_with_hand_computed_numbers(tmp_path, joints):
    read = imported(robot(joints), tmp_path)
    parts = ("roll", "hip", "knee")[-joints:]
    assert {leg.corner: leg.names for leg in read.anatomy.legs} == {
        corner: tuple(f"{corner}_{part}" for part in parts) for corner in ("LF", "RF", "LH", "RH")
    }
    assert read.anatomy.kinds == ("roll", "pitch", "pitch")[-joints:]
    assert (read.stance.thigh, read.stance.shank) == pytest.approx((THIGH, SHANK), abs=1e-12)
    assert (read.anatomy.foot_radius, read.mass) == pytest.approx((RADIUS, MASS - 1.2 * (joints == 2)), rel=1e-12)
    assert all(plane.signs == (1,) * joints for plane in read.stance.planes)
    assert read.stance.knees == "<<<<"
    assert read.stance.height == pytest.approx(0.85 * (THIGH + SHANK) + RADIUS, abs=1e-5)
    assert stance_height(read) == pytest.approx(read.stance.height, abs=1e-5)
    hip, knee = (read.stance.positions[name] for name in read.anatomy.legs[0].names[-2:])
    assert THIGH * math.sin(hip) + SHANK * math.sin(hip + knee) == pytest.approx(0.0, abs=1e-5)  # under the hip
    assert {finding.status for finding in read.findings} == {"assumed"}
    assert {finding.subject for finding in read.findings} == {"forward", "stance", "motors"}


def test_motors_are_the_files_and_the_rest_is_in_proportion_to_the_robot(tmp_path):
    read = imported(robot(), tmp_path)
    value = {name: number for name, (number, _) in read.motors[0].values.items()}
    weight = read.mass * G * read.stance.height
    assert (value["stall_torque"], value["no_load_speed"]) == (20.0, 15.0)
    assert value["kp"] == pytest.approx(6.0 * weight, rel=0.01)
    assert value["armature"] == pytest.approx(0.074 * read.mass * read.stance.height**2, rel=0.01)
    # Inertia of the straight leg about its roll axis: cubes of 0.1 m, 0.01 m below their frames.
    points = [(0.3, 0.0, 0.01), (0.4, SIDE, 0.01), (0.2, SIDE, THIGH + 0.01)]
    swung = sum(mass * (y * y + z * z + 0.01 / 6.0) for mass, y, z in points)
    assert value["kd"] == pytest.approx(1.6 * math.sqrt(value["kp"] * (value["armature"] + swung)), rel=0.01)
    assert all("assumed" in comment for name, (_, comment) in read.motors[0].values.items() if name in ("kp", "kd"))


def test_shapes_without_inertial_get_no_mass(tmp_path):
    camera = link("camera", shapes=collision('<box size="1 1 1"/>')) + joint("c", "base", "camera", "0 0 0.1", "")
    read = imported(robot(extra=camera), tmp_path)
    assert read.mass == pytest.approx(MASS, rel=1e-12)
    assert findings(read, "found", "mass") == [
        "camera: shapes without <inertial> get no mass (MuJoCo would give 1000 kg/m^3)"
    ]


def test_file_without_any_inertial_gets_the_density_of_water(tmp_path):
    bare = imported(re.sub(r"<inertial>.*?</inertial>", "", robot(2)), tmp_path)
    assert bare.mass == pytest.approx(8.0 + 4 * 1000.0 * 4 / 3 * math.pi * RADIUS**3, rel=1e-4)
    assert "1000 kg/m^3" in findings(bare, "assumed", "mass")[0]


@pytest.mark.parametrize(("limits", "knees", "said"), [
    ('lower="-2.6" upper="2.6"', "<<<<", True),
    ('lower="0.2" upper="2.6"', ">>>>", False),
    ('lower="-2.6" upper="0.3"', "<<<<", False),
])  # fmt: skip
def test_knees_point_where_their_ranges_let_them(tmp_path, limits, knees, said):
    read = imported(robot(knee=f'{limits} effort="20" velocity="15"'), tmp_path)
    assert read.stance.knees == knees
    assert bool(findings(read, "assumed", "knees")) == said


def test_trunk_that_is_fixed_to_a_root_without_mass_is_fused(tmp_path):
    base = link("footprint") + link("base", 4.0) + joint("f", "footprint", "base", "0 0 0.05", "")
    read = imported(robot(base=base), tmp_path)
    assert read.bodies[0].name == "footprint"
    assert read.bodies[0].mass == pytest.approx(4.0)
    np.testing.assert_allclose(read.bodies[0].centre, [0.0, 0.0, 0.04], atol=1e-12)


@pytest.mark.parametrize(("moments", "cause"), [
    ("0 0 0", "zero"),
    ("0.001 0.001 0.1", "against the triangle inequality"),
])  # fmt: skip
def test_impossible_inertia_becomes_that_of_a_box_of_the_links_mass(tmp_path, moments, cause):
    xx, yy, zz = moments.split()
    inertia = f'<inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="0" ixz="0" iyz="0"/>'
    shank = f'<link name="{{}}_shank"><inertial><mass value="0.2"/>{inertia}</inertial>{FOOT}</link>'
    text = robot(2, shank="")
    text = text.replace("</robot>", "".join(shank.format(c) for c in ("LF", "RF", "LH", "RH")) + "</robot>")
    read = imported(text, tmp_path)
    assert findings(read, "repaired", "inertia") == [
        f"RH_shank, LF_shank, RF_shank, LH_shank: {cause}; now a box of the link's size and mass"
    ]
    last = next(body for body in read.bodies if body.name == "LF_shank")
    np.testing.assert_allclose(last.inertia, 0.2 / 12 * 2 * (2 * RADIUS) ** 2 * np.eye(3), rtol=1e-9)


@pytest.mark.parametrize(("moment", "repaired"), [(0.05, False), (0.07, True)])
def test_inertia_larger_than_that_of_a_link_of_the_robots_size_becomes_that_of_a_box(tmp_path, moment, repaired):
    # The frames are 0.4, 0.32 and 0.2 m apart, so 0.2 kg have no more than 0.0605 kg m^2.
    text = robot(2)
    at = text.index('<link name="LF_shank">')
    inertia = re.compile('<inertia ixx="[^"]*" iyy="[^"]*" izz="[^"]*"')
    text = text[:at] + inertia.sub(f'<inertia ixx="{moment}" iyy="{moment}" izz="{moment}"', text[at:], count=1)
    read = imported(text, tmp_path)
    if not repaired:
        assert not findings(read, "repaired")
        return
    (found,) = findings(read, "repaired", "inertia")
    assert found.startswith("LF_shank: larger than that of a link of the robot's size; now a box")
    last = next(body for body in read.bodies if body.name == "LF_shank")
    np.testing.assert_allclose(last.inertia, 0.2 / 12 * 2 * (2 * RADIUS) ** 2 * np.eye(3), rtol=1e-9)


def test_inertia_with_a_negative_eigenvalue_is_refused_with_the_box_that_would_do(tmp_path):
    text = robot(2).replace('ixy="0"', 'ixy="1"', 1)
    with pytest.raises(
        QuadrupedError, match=r"the inertia of 'base' has the eigenvalue -0\.99.*box of its mass: ixx 0"
    ):
        imported(text, tmp_path)


@pytest.mark.parametrize(("limit", "torque", "speed"), [
    ('effort="0" velocity="0"', None, None),
    ('effort="1000" velocity="100"', None, None),
    ("", None, None),
    ('effort="999" velocity="99"', 999.0, 99.0),
])  # fmt: skip
def test_torque_and_speed_that_no_motor_has_are_assumed(tmp_path, limit, torque, speed):
    limits = f'lower="-1.5" upper="1.5" {limit}'
    read = imported(robot(2, hip=limits), tmp_path)
    value = {name: number for name, (number, _) in read.motors[0].values.items()}
    weight = read.mass * G * read.stance.height
    assert value["stall_torque"] == pytest.approx(torque or 1.4 * weight, rel=0.01)
    assert value["no_load_speed"] == pytest.approx(speed or 4.0 * math.sqrt(G / read.stance.height), rel=0.01)
    assert len(findings(read, "assumed", "motors")) == (1 if torque else 3)
    assert read.motors[1].values["stall_torque"][0] == 20.0


CYLINDER = collision('<cylinder radius="0.02" length="0.2"/>', "0 0 -0.1")
BOX = collision('<box size="0.03 0.04 0.2"/>', "0 0 -0.1")


@pytest.mark.parametrize("foot", [CYLINDER, BOX])
def test_foot_that_is_no_ball_becomes_one_at_its_end(tmp_path, foot):
    read = imported(robot(foot=foot), tmp_path)
    assert read.anatomy.foot_radius == pytest.approx(0.02, abs=1e-3)
    for leg in read.anatomy.legs:
        # On the axis of the leg, with its lowest point at the end.
        assert leg.foot_in_link[2] - read.anatomy.foot_radius == pytest.approx(-0.2, abs=1e-9)
        np.testing.assert_allclose(leg.foot_in_link[:2], 0.0, atol=1e-9)
    assert findings(read, "assumed", "feet")


def test_foot_without_shapes_is_the_last_frame(tmp_path):
    mesh = collision('<mesh filename="package://gone/foot.dae"/>')
    feet = "".join(
        link(f"{c}_foot", shapes=mesh) + joint(f"{c}_end", f"{c}_shank", f"{c}_foot", f"0 0 {-SHANK}", "")
        for c in ("LF", "RF", "LH", "RH")
    )
    read = imported(robot(foot="", extra=feet), tmp_path)
    assert read.stance.shank == pytest.approx(SHANK, abs=1e-12)
    assert "foot.dae' is not found; name its folder with --folder" in findings(read, "left out", "collision")[0]
    assert "the last frame of the leg" in findings(read, "assumed", "feet")[0]


def test_axes_that_differ_between_legs_have_their_own_signs(tmp_path):
    legs = robot(order=("LF", "RF")).rpartition("</robot>")[0]
    other = robot(order=("RH", "LH"), axis="0 -1 0", knee='lower="0.2" upper="2.6" effort="20" velocity="15"')
    text = legs + other.partition("</link>\n")[2]
    read = imported(text, tmp_path)
    assert [plane.signs for plane in read.stance.planes] == [(1, 1, 1)] * 2 + [(1, 1, -1)] * 2
    assert read.stance.knees == "<<<<"
    value = read.stance.positions
    assert value["LF_knee"] == pytest.approx(-value["LH_knee"])


@pytest.mark.parametrize("limits", ["", 'lower="0" upper="0" effort="20" velocity="15"'])
def test_joint_without_limits_gets_a_range_about_the_stance(tmp_path, limits):
    read = imported(robot(2, knee=limits), tmp_path)
    low, high = read.anatomy.legs[0].joints[-1].low, read.anatomy.legs[0].joints[-1].high
    assert (low, high) == pytest.approx((-2.6, -0.1), abs=1e-3)
    assert "the file has none" in findings(read, "assumed", "ranges")[0]
    assert low < read.stance.positions["LF_knee"] < high


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_base_joint_under_world_is_removed(tmp_path, kind):
    world = link("world") + joint("root", "world", "base", "0 0 0.3", "0 0 1", "", kind)
    read = imported(robot(extra=world), tmp_path)
    assert read.bodies[0].name == "base"
    assert not read.anatomy.locked
    assert findings(read, "left out", "base") == ["root: joints above it; the robot floats by itself"]


def test_foot_on_a_floating_joint_is_fixed(tmp_path):
    feet = "".join(
        link(f"{c}_foot", 0.01, collision(f'<sphere radius="{RADIUS}"/>'))
        + joint(f"{c}_end", f"{c}_shank", f"{c}_foot", f"0 0 {-SHANK}", kind="floating")
        for c in ("LF", "RF", "LH", "RH")
    )
    read = imported(robot(foot="", extra=feet), tmp_path)
    assert (read.stance.shank, read.anatomy.foot_radius) == pytest.approx((SHANK, RADIUS), abs=1e-12)
    assert read.mass == pytest.approx(MASS + 0.04, rel=1e-12)
    ends = "RH_end, LF_end, RF_end, LH_end"
    assert findings(read, "repaired", "joints") == [f"{ends}: floating, with nothing that moves below; fixed"]


def test_file_without_inertial_and_collision_weighs_what_its_visual_shapes_do(tmp_path):
    text = re.sub("<inertial>.*?</inertial>", "", robot(2)).replace("collision>", "visual>")
    read = imported(text, tmp_path)
    balls = 4 * 4.0 / 3.0 * math.pi * RADIUS**3
    assert read.mass == pytest.approx(1000.0 * (0.4 * 0.2 * 0.1 + balls), rel=1e-5)
    assert "because no link has an <inertial>" in findings(read, "assumed", "mass")[0]


def test_mesh_of_a_windows_path_is_found(tmp_path):
    (tmp_path / "meshes").mkdir()
    corners = np.array([[x, y, z] for x in (-0.01, 0.01) for y in (-0.01, 0.01) for z in (-SHANK, 0.0)])
    lines = "".join(f"v {x} {y} {z}\n" for x, y, z in corners)
    (tmp_path / "meshes" / "shank.obj").write_text(lines, encoding="utf-8")
    for name in (r"meshes\shank.obj", r"file://C:\robots\meshes\shank.obj"):
        read = imported(robot(2, foot=collision(f'<mesh filename="{name}"/>')), tmp_path)
        assert not findings(read, "left out")
        assert read.stance.shank == pytest.approx(SHANK - read.anatomy.foot_radius, rel=1e-3)


def test_site_is_the_foot_of_an_mjcf_whose_meshes_are_missing(tmp_path):
    first = imported(robot(2), tmp_path)
    text = re.sub('<geom [^>]*name="(.._foot)_ball"[^>]*>', '<geom type="mesh" mesh="gone"/>', first.mjcf)
    text = re.sub('<geom (class="[a-z]*" )?type="capsule"[^>]*>', "", text)
    assert text.count('mesh="gone"') == 4
    text = text.replace("<asset>", '<asset><mesh name="gone" file="gone.stl"/>')
    shown = '<site name="LF_mark" pos="0 0 0.01" material="gray"/>'
    text = text.replace("<site", shown + "<site", 1).replace('<body name="base"', '<body name="base" quat="1 1 0 0"')
    rope = '<tendon><spatial material="gray"><site site="LF_foot"/><site site="RF_foot"/></spatial></tendon>'
    read = imported(text.replace("</mujoco>", f"{rope}</mujoco>"), tmp_path, "gone.xml")
    assert read.stance.shank == pytest.approx(first.stance.shank, rel=1e-6)
    assert "the last frame of the leg" in findings(read, "assumed", "feet")[0]


def test_floating_joint_above_a_fixed_one_carries_the_base(tmp_path):
    root = link("world") + joint("root", "world", "footprint", "0 0 0.3", "0 0 1", "", "floating")
    footprint = link("footprint") + joint("trunk", "footprint", "base", "0 0 0", "")
    read = imported(robot(extra=root + footprint), tmp_path)
    assert findings(read, "left out", "base") == ["root: joints above it; the robot floats by itself"]
    assert not findings(read, "repaired")


def test_joints_that_are_no_part_of_a_leg_are_locked_and_named(tmp_path):
    neck = link("head", 0.5) + joint("neck", "base", "head", "0.2 0 0.1", "0 0 1", 'lower="0.2" upper="1"')
    read = imported(robot(extra=neck), tmp_path)
    assert read.anatomy.locked == ("neck",)
    assert read.mass == pytest.approx(MASS + 0.5)
    assert findings(read, "left out", "joints") == ["neck: no part of a leg; locked at 0, or at the nearest limit"]


def test_arm_of_as_many_joints_as_the_legs_is_no_leg(tmp_path):
    arm = (
        link("a1", 0.1) + link("a2", 0.1) + joint("j1", "base", "a1", "0.2 0 0.1") + joint("j2", "a1", "a2", "0 0 0.5")
    )
    read = imported(robot(2, extra=arm), tmp_path)
    assert read.anatomy.locked == ("j1", "j2")


def turned(text):
    """A robot whose base has y ahead: x to the right."""
    swap = {
        "0.2 0.1 0": "-0.1 0.2 0",
        "0.2 -0.1 0": "0.1 0.2 0",
        "-0.2 0.1 0": "-0.1 -0.2 0",
        "-0.2 -0.1 0": "0.1 -0.2 0",
    }
    for old, new in swap.items():
        text = text.replace(
            f'<origin xyz="{old}"/><axis xyz="1 0 0"/>',
            f'<origin xyz="{new}" rpy="0 0 1.5707963267948966"/><axis xyz="1 0 0"/>',
        )
    return text


def test_base_whose_y_is_forward_is_turned_and_its_sign_can_be_chosen(tmp_path):
    text = turned(robot())
    read = imported(text, tmp_path)
    assert {leg.corner: leg.names[0] for leg in read.anatomy.legs} == {c: f"{c}_roll" for c in ("LF", "RF", "LH", "RH")}
    assert "or --forward -y" in findings(read, "assumed", "forward")[0]
    other = imported(text, tmp_path, forward="-y")
    assert {leg.corner: leg.names[0] for leg in other.anatomy.legs} == {
        "LF": "RH_roll", "RF": "LH_roll", "LH": "RF_roll", "RH": "LF_roll",
    }  # fmt: skip
    assert not findings(other, "assumed", "forward")
    assert all(plane.signs == (-1, -1, -1) for plane in other.stance.planes)
    assert read.mjcf != other.mjcf
    with pytest.raises(QuadrupedError, match=r"--forward: expected y or -y, along the body; found x"):
        imported(text, tmp_path, forward="x")


def test_front_at_the_other_end_of_x_is_a_choice_that_is_said(tmp_path):
    read = imported(robot(2), tmp_path)
    assert findings(read, "assumed", "forward") == [
        "x of 'base', along the body; the sign is a convention: or --forward -x"
    ]
    other = imported(robot(2), tmp_path, forward="-x")
    assert {leg.corner: leg.names[0] for leg in other.anatomy.legs} == {
        "LF": "RH_hip", "RF": "LH_hip", "LH": "RF_hip", "RH": "LF_hip",
    }  # fmt: skip


def test_home_keyframe_that_stands_is_the_stance(tmp_path):
    text = imported(robot(2), tmp_path).mjcf
    home = "0 0 0.3 1 0 0 0 " + "0.5 -0.9 " * 4
    keyed = text.replace("</mujoco>", f'<keyframe><key name="home" qpos="{home}"/></keyframe></mujoco>')
    read = imported(keyed, tmp_path, "keyed.xml")
    assert set(read.stance.positions.values()) == {0.5, -0.9}
    lying = keyed.replace("0.5 -0.9", "1.4 -0.3")
    assert set(imported(lying, tmp_path, "lying.xml").stance.positions.values()) != {1.4, -0.3}


def test_actuators_sensors_and_ground_of_the_file_are_left_out(tmp_path):
    text = imported(robot(2), tmp_path).mjcf
    own = '<actuator><motor joint="LF_knee" ctrlrange="-7 7"/></actuator><sensor><jointpos joint="LF_knee"/></sensor>'
    ground = '<worldbody><geom type="plane" size="1 1 1"/></worldbody>'
    read = imported(text.replace("</mujoco>", f"{own}{ground}</mujoco>"), tmp_path, "own.xml")
    assert [finding.subject for finding in read.findings if finding.status == "left out"] == [
        "ground",
        "actuators",
        "sensors",
    ]
    assert "plane" not in read.mjcf
    assert read.anatomy.legs[0].joints[-1].effort == 7.0


def test_written_mjcf_is_read_as_the_same_robot(tmp_path):
    first = imported(robot(), tmp_path)
    again = imported(first.mjcf, tmp_path, "again.xml")
    assert again.joint_names == first.joint_names
    assert again.mass == pytest.approx(first.mass, rel=1e-9)
    assert again.stance.positions == pytest.approx(first.stance.positions, abs=1e-4)
    assert again.anatomy.foot_radius == first.anatomy.foot_radius


def test_folder_must_exist(tmp_path):
    with pytest.raises(QuadrupedError, match=r"--folder: .*nowhere is no folder"):
        import_robot(tmp_path / "x.urdf", [tmp_path / "nowhere"])


def test_fitted_feet_that_differ_a_little_are_made_alike_and_others_are_not(tmp_path):
    def with_left_longer(by):
        bar = collision('<box size="0.02 0.02 0.2"/>', "0 0 -0.1")
        text = robot(2, foot=bar)
        begin, found, rest = text.partition('<link name="LF_shank">')
        return imported(begin + found + rest.replace('0.02 0.2"', f'0.02 {0.2 + 2 * by}"', 1), tmp_path)

    near, far = (with_left_longer(by) for by in (0.002, 0.05))
    assert len({leg.foot_in_link[2].round(9) for leg in near.anatomy.legs}) == 1
    assert len({leg.foot_in_link[2].round(9) for leg in far.anatomy.legs}) == 2


def test_limits_that_are_no_limits_count_as_none(tmp_path):
    read = imported(robot(2, knee='lower="-1e16" upper="1e16" effort="inf" velocity="5"'), tmp_path)
    assert "the file has none" in findings(read, "assumed", "ranges")[0]
    assert "the file: inf" in findings(read, "assumed", "motors")[0]


def test_weakest_motor_of_a_kind_counts(tmp_path):
    text = robot(2).replace('effort="20"', 'effort="12"', 1)
    assert imported(text, tmp_path).motors[0].values["stall_torque"][0] == 12.0


def test_impossible_inertia_of_an_mjcf_is_repaired(tmp_path):
    text = re.sub(
        r'mass="0.2(0*)" diaginertia="[^"]*"', 'mass="0.2" diaginertia="0 0 0"', imported(robot(2), tmp_path).mjcf
    )
    assert text.count('diaginertia="0 0 0"') == 4
    read = imported(text, tmp_path, "zero.xml")
    assert "RH_shank, LF_shank, RF_shank, LH_shank: zero" in findings(read, "repaired", "inertia")[0]
    assert all(np.linalg.eigvalsh(body.inertia)[0] > 1e-6 for body in read.bodies)


def test_base_frame_far_from_the_hips_is_moved_between_them(tmp_path):
    trunk = link("base") + link("root", 4.0) + joint("f", "root", "base", "0.5 0 0.4", "")
    read = imported(robot(base=trunk), tmp_path)
    assert "is 0.64 m off" in findings(read, "assumed", "base")[0]
    np.testing.assert_allclose(read.bodies[0].centre, [-0.5, 0.0, -0.41], atol=1e-12)
    box = re.search(r'<geom class="visual" type="box" size="[^"]*" pos="([^"]*)"', read.mjcf)
    np.testing.assert_allclose([float(x) for x in box[1].split()], 0.0, atol=1e-12)  # between the hips
    assert read.robot().stance_height == pytest.approx(read.stance.height, abs=1e-4)


def test_joints_between_the_world_and_the_base_are_removed(tmp_path):
    carriage = link("world") + link("cart", 0.1) + joint("rail", "world", "cart", "0 0 0", "0 0 1", "", "prismatic")
    read = imported(robot(extra=carriage + joint("root", "cart", "base", "0 0 0.3", "0 0 1", "", "floating")), tmp_path)
    assert not read.anatomy.locked
    assert findings(read, "left out", "base") == ["rail, root: joints above it; the robot floats by itself"]
    assert findings(read, "left out", "mass") == ["0.1 kg of links that are not part of the robot"]
    assert read.mass == pytest.approx(MASS)


def test_stance_leaves_room_to_lift_the_feet(tmp_path):
    # A knee that bends by 60 degrees holds the leg at 0.866 of its length or more: there it could not be lifted.
    read = imported(robot(2, knee='lower="-1.0472" upper="0" effort="20" velocity="15"'), tmp_path)
    height = (read.stance.height - RADIUS) / (THIGH + SHANK)
    assert 0.92 < height < 0.97


def test_stance_leaves_the_thighs_room_to_swing(tmp_path):
    """Its foot lifted by a tenth of the leg, a thigh can still turn by 0.1 rad, if a straighter leg allows it."""
    read = imported(robot(hip='lower="-1.5" upper="0.65" effort="20" velocity="15"'), tmp_path)
    lifted = read.stance.height - RADIUS - 0.1 * (THIGH + SHANK)
    thigh = math.acos((THIGH**2 + lifted**2 - SHANK**2) / (2.0 * THIGH * lifted))
    assert 0.5 < thigh < 0.65 - 0.1
    # Where no leg can be that straight the stance has less room.
    near = imported(robot(hip='lower="-1.5" upper="0.5" effort="20" velocity="15"'), tmp_path)
    assert near.stance.positions["LF_hip"] < 0.4
