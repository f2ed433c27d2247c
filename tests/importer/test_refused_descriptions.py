"""What is no four-legged robot of two or three joints, and files that are damaged or hostile: one clear line each."""

import os
import re

import numpy as np
import pytest
from mutations import mutated_xml
from paths import ROBOTS
from urdf_robots import FOOT, THIGH, collision, findings, imported, joint, leg, link, robot

from quadruped_env.errors import QuadrupedError
from quadruped_env.importer import files as importer_files
from quadruped_env.importer import import_robot, mjcf
from quadruped_env.robot import asset_path


def refused(text, folder, name="made.urdf", **options):
    """The message with which a text is refused."""
    with pytest.raises(QuadrupedError) as caught:
        imported(text, folder, name, **options)
    message = str(caught.value)
    assert name in message
    assert "\n" not in message
    return message


def with_legs(*corners, extra="", **parts):
    legs = "".join(leg(corner, **parts) for corner in corners)
    return f'<robot name="x">{link("base", 4.0)}{legs}{extra}</robot>'


def more_legs():
    text = "".join(leg(corner, 2).replace(corner, f"M{corner}") for corner in ("LF", "RF"))
    return robot(2, extra=text.replace('xyz="0.2 ', 'xyz="0.0 '))


def ankles(axis="1 0 0"):
    parts = "".join(
        link(f"{c}_ankle", 0.05, FOOT) + joint(f"{c}_ankle", f"{c}_shank", f"{c}_ankle", "0 0 -0.1", axis)
        for c in ("LF", "RF", "LH", "RH")
    )
    return robot(extra=parts)


def five_bar():
    text = ""
    for c, (x, y) in {"LF": (1, 1), "RF": (1, -1), "LH": (-1, 1), "RH": (-1, -1)}.items():
        for side in (1, -1):
            a, b = f"{c}{side}_upper", f"{c}{side}_lower"
            text += link(a, 0.1) + joint(a, "base", a, f"{0.2 * x + 0.02 * side} {0.1 * y} 0")
            text += link(b, 0.1, FOOT) + joint(b, a, b, f"0 0 {-THIGH}")
    return f'<robot name="x">{link("base", 4.0)}{text}</robot>'


def hand():
    """A torso of two joints with a light hand of four fingers."""
    fingers = with_legs("LF", "RF", "LH", "RH").replace('value="4.0"', 'value="0.1"').replace("</robot>", "")
    return fingers + link("torso", 40.0) + joint("wrist", "torso", "base", "0 0 1") + "</robot>"


def coupled():
    return robot(2).replace('<limit lower="-2.6"', '<mimic joint="LF_hip"/><limit lower="-2.6"', 1)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (with_legs("LF", "RF"), "found 'base' with chains of 3, 3 joints"),
        (hand(), "no link carries four chains of two or more joints"),
        (more_legs(), "'base' carries 6 chains, of 2, 2, 2, 2, 2, 2 joints, and 6 of these are alike"),
        (ankles(), "a wheel, an ankle or a passive joint ('RH_ankle') makes 4 a leg"),
        (five_bar(), "five-bar legs, which are closed chains"),
        (coupled(), "the leg's joint 'RH_knee' follows 'LF_hip'"),
        (robot(2).replace("-0.2 0.16 0", "0.1 0.3 0"), "expected a leg in each corner; found RH_hip"),
        (robot(2).replace("0 0 -0.2", "0 0 0"), "thigh and shank of the legs are LF 0 and 0.18 m"),
        (robot(foot=collision('<sphere radius="0.05"/>')), "(a wheel is none)"),
        (
            robot(2, axis="1 0 0"),
            "the axes of the legs' joints are RH_hip, RH_knee: [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]",
        ),
        (robot().replace('<axis xyz="1 0 0"/>', '<axis xyz="0 0 1"/>'), "turn about the vertical (yaw hips)"),
        (robot().replace('type="revolute"', 'type="prismatic"', 3), "'RH_roll' in a leg is a slide joint"),
        (f'<robot name="x">{link("base", 1.0)}</robot>', "found no joints"),
    ],
)
def test_other_robot_is_refused_with_what_was_found_and_what_is_supported(tmp_path, text, found):
    message = refused(text, tmp_path)
    assert found in message
    assert "supported are" in message or "expected" in message or "must be" in message


def test_foot_that_only_a_missing_mesh_shows_is_refused_with_the_mesh(tmp_path):
    gone = collision('<mesh filename="package://dog/shank.stl"/>')
    message = refused(re.sub("<inertial>.*?</inertial>", "", robot(2, foot=gone)), tmp_path)
    assert "LF 0.2 and 0 m" in message
    assert "(1 mesh is not read: 'package://dog/shank.stl' is not found; name its folder with --folder" in message


def test_robot_without_any_mass_is_refused(tmp_path):
    text = re.sub("<inertial>.*?</inertial>|<collision>.*?</collision>", "", robot(2, foot=""))
    ends = "".join(
        link(f"{c}_foot") + joint(f"{c}_end", f"{c}_shank", f"{c}_foot", "0 0 -0.2", "")
        for c in ("LF", "RF", "LH", "RH")
    )
    message = refused(text.replace("</robot>", f"{ends}</robot>"), tmp_path)
    assert "no link has a mass, or a shape to assume one from" in message
    text = re.sub("<inertial[^>]*>", "", imported(robot(2), tmp_path).mjcf)  # MuJoCo gives 1e-9 kg
    assert "no link has a mass" in refused(text, tmp_path, "light.xml")


def test_loop_of_an_mjcf_is_refused(tmp_path):
    text = imported(robot(2), tmp_path).mjcf
    loop = '<equality><connect body1="LF_shank" body2="base" anchor="0 0 0"/></equality></mujoco>'
    assert "'LF_shank' and 'base' close a chain in a leg" in refused(text.replace("</mujoco>", loop), tmp_path, "x.xml")


def test_ant_is_refused_for_its_yaw_hips():
    path = ROBOTS / "gymnasium" / "ant.xml"
    if not path.is_file():
        pytest.skip("Gymnasium's Ant is not here")
    with pytest.raises(QuadrupedError, match=r"hip_1.*supported are four legs"):
        import_robot(path)


AXIS = '<axis xyz="0 1 0"/>'
BOMB = '<!DOCTYPE r [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]><robot name="&b;"/>'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is not XML (no element found: line 1"),
        ("not XML", "is not XML (syntax error: line 1, column 0)"),
        ("<robot><link name='a'></robot>", "is not XML (mismatched tag: line 1"),
        ("\x00\x01", "is not XML"),
        ('<?xml version="1.0" encoding="no-such"?><robot/>', "is not XML (unknown encoding"),
        ("<html/>", "its root element is <html>; expected <robot> (URDF) or <mujoco> (MJCF)"),
        ("<robot/>", "line 1: <robot> must have 1 to 2000 links; found 0"),
        (BOMB, "line 1: declares the entity 'a'"),
        ('<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="&x;"/>', "declares the entity 'x'"),
        ("<a>" * 300 + "</a>" * 300, "elements are nested over 200 deep"),
        (robot(2).replace('xyz="0 1 0"', 'xyz="0 1 0 0"', 1), "<axis> in 'RH_hip': xyz: expected 3 numbers"),
        (robot(2).replace(AXIS, AXIS * 2, 1), "in 'RH_hip': expected one <axis>; found 2"),
        (robot(2).replace(' -0.2"', ' -0.2" rpy="0 0 0 1"', 1), "<origin> in 'RH_knee': rpy: expected 3 numbers"),
        (robot(2).replace('value="4.0"', 'value="nan"'), "<mass> in 'base': value: expected a number; found 'nan'"),
        (robot(2).replace('value="4.0"', 'value="-4"'), "<mass> in 'base': value: expected 0 or more; found -4"),
        (robot(2).replace('lower="-2.6" upper="-0.2"', 'lower="1" upper="-1"'), "lower 1 is above upper -1; swap them"),
        (robot(2).replace('xyz="0 1 0"', 'xyz="0 0 0"', 1), "<axis> in 'RH_hip': xyz: expected a direction"),
        (robot(2).replace('type="revolute"', 'type="screw"', 1), "type: expected one of revolute"),
        (robot(2).replace('<child link="RH_shank"', '<child link="gone"'), "its child 'gone' is no link of the file"),
        (robot(2).replace('child link="RH_shank"', 'child link="LF_shank"'), "the link 'LF_shank' a second parent"),
        (robot(2).replace('<link name="RH_shank"', '<link name="LF_shank"'), "'LF_shank' repeats the name of line"),
        (robot(2, extra=joint("j", "RH_shank", "base", "0 0 0")), "the joints form a circle"),
        (
            robot(2, extra=link("p") + link("q") + joint("j", "p", "q", "0 0 0") + joint("k", "q", "p", "0 0 0")),
            "the links q, p form a circle",
        ),
        (robot(2, extra=link("p") + link("q") + joint("j", "p", "q", "0 0 0")), "roots are base, p"),
        (f'<robot name="x"><link name="{"n" * 200}"/></robot>', "needs a name of up to 100 characters"),
    ],
)  # fmt: skip
def test_damaged_file_is_refused_with_the_place(tmp_path, text, message):
    assert message in refused(text, tmp_path)


@pytest.mark.parametrize(
    "text", ["<mujoco><worldbody><body/></worldbody></mujoco>", "<mujoco><x/></mujoco>", "<mujoco/>"]
)
def test_damaged_mjcf_is_refused(tmp_path, text):
    refused(text, tmp_path, "x.xml")


@pytest.mark.parametrize(
    ("inside", "message"),
    [
        ('<asset><hfield nrow="9" ncol="100000"/></asset>', "line 1: <hfield> ncol: expected .* found '100000'"),
        ('<worldbody><replicate count="10000000"/></worldbody>', "line 1: <replicate> count: expected numbers below"),
        ('<worldbody><replicate count="9"><body><replicate count="9"/></body></replicate></worldbody>', "another"),
    ],
)
def test_mjcf_that_would_fill_the_memory_is_refused_before_mujoco_reads_it(tmp_path, monkeypatch, inside, message):
    monkeypatch.delattr(mjcf.mujoco, "MjSpec")
    assert re.search(message, refused(f"<mujoco>{inside}</mujoco>", tmp_path, "x.xml"))


def test_missing_file_folder_and_pipe_are_refused(tmp_path):
    os.mkfifo(tmp_path / "pipe.urdf")
    for path, message in (
        (tmp_path / "gone.urdf", "no such file"),
        (tmp_path, "a directory"),
        (tmp_path / "pipe.urdf", "a pipe"),
    ):
        with pytest.raises(QuadrupedError, match=message):
            import_robot(path)


def test_description_that_is_too_large_is_not_read(tmp_path):
    path = tmp_path / "big.urdf"
    with path.open("wb") as file:
        file.truncate(500_000_000)
    with pytest.raises(QuadrupedError, match=r"big\.urdf: has 500 MB; the maximum is 20 MB"):
        import_robot(path)


def mesh_robot(name):
    return robot(2, base=link("base", 4.0, collision(f'<mesh filename="{name}"/>')))


def test_mesh_that_is_too_large_is_not_read_and_said(tmp_path, monkeypatch):
    with (tmp_path / "big.stl").open("wb") as file:
        file.truncate(500_000_000)
    monkeypatch.setattr(importer_files, "_text_vertices", None)  # nothing of it is parsed
    read = imported(mesh_robot("big.stl"), tmp_path)
    assert "big.stl: has 500 MB; the maximum is 60 MB" in findings(read, "left out", "collision")[0]


@pytest.mark.parametrize(
    "content", [b"", b"solid x\nendsolid", b"\0" * 84, b"\xff" * 500, b"v 1 2", b"v nan 0 0\nv 1 2 3\n"]
)
@pytest.mark.parametrize("name", ["m.stl", "m.obj"])
def test_damaged_mesh_is_left_out_and_said(tmp_path, content, name):
    (tmp_path / name).write_bytes(content)
    read = imported(mesh_robot(name), tmp_path)
    assert f"1 mesh is not read: {name}: has fewer than four vertices" in findings(read, "left out", "collision")[0]


@pytest.mark.parametrize("how", ["absolute", "parents", "link"])
def test_file_outside_the_folders_is_not_read_and_said(tmp_path, how):
    inner, outer = tmp_path / "inner", tmp_path / "outer"
    inner.mkdir()
    outer.mkdir()
    (outer / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n")
    (inner / "linked.obj").symlink_to(outer / "m.obj")
    name = {"absolute": str(outer / "m.obj"), "parents": "../outer/m.obj", "link": "linked.obj"}[how]
    read = imported(mesh_robot(name), inner)
    assert "is outside the folders that are searched; name its folder with --folder" in findings(read, "left out")[0]
    assert not findings(imported(mesh_robot(name), inner, folders=[outer]), "left out")


def test_include_outside_the_folders_is_refused(tmp_path):
    inner = tmp_path / "inner"
    inner.mkdir()
    (tmp_path / "part.xml").write_text("<mujocoinclude/>")
    text = '<mujoco><include file="../part.xml"/></mujoco>'
    message = refused(text, inner, "x.xml")
    assert "line 1: <include> '../part.xml' is outside the folders" in message
    assert "'gone.xml' is not found" in refused(text.replace("../part.xml", "gone.xml"), inner, "x.xml")


def test_included_files_are_checked_as_deep_as_they_go(tmp_path):
    (tmp_path / "a.xml").write_text('<mujocoinclude>\n<include file="b.xml"/></mujocoinclude>')
    (tmp_path / "b.xml").write_text('<mujocoinclude>\n\n<replicate count="12345"/></mujocoinclude>')
    text = '<mujoco><include file="a.xml"/></mujoco>'
    assert "b.xml: line 3: <replicate> count: expected numbers" in refused(text, tmp_path, "x.xml")


def test_folder_with_the_name_of_a_mesh_is_passed_over(tmp_path):
    (tmp_path / "a" / "m.obj").mkdir(parents=True)
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n")
    assert not findings(imported(mesh_robot("package://gone/m.obj"), tmp_path), "left out")


def test_names_of_a_file_are_data_in_the_task_file(tmp_path):
    evil = "x&quot;&#10;raise SystemExit&#10;&quot;&quot;&quot;"
    text = robot(2, name=evil).replace('"LF_hip"', f'"{evil}"').replace('"LF_knee"', '"a\'b\\"')
    read = imported(text, tmp_path)
    task = read.task_file("x'\n.xml")
    names = {"__file__": "task.py"}
    exec(compile(task.replace("ROBOT = Robot(", "VALUES = dict("), "task", "exec"), names)  # noqa: S102
    assert names["VALUES"]["name"] == "x_raise_SystemExit"
    assert set(names) >= {"VALUES"}
    assert "SystemExit" not in task.replace("x_raise_SystemExit", "")


def bases(folder):
    """Ten descriptions, by file name."""
    three, two = imported(robot(3), folder), imported(robot(2), folder)
    knees = robot(2, knee='lower="0.2" upper="2.6"')
    camera = link("camera", shapes=collision('<box size="1 1 1"/>')) + joint("c", "base", "camera", "0 0 0.1", "")
    return {
        "three.urdf": robot(3),
        "two.urdf": robot(2),
        "knees.urdf": knees,
        "camera.urdf": robot(3, extra=camera),
        "mesh.urdf": mesh_robot("m.obj"),
        "built_in.urdf": asset_path("mini_quadruped.urdf").read_text(encoding="utf-8"),
        "built_in.xml": asset_path("mini_quadruped.xml").read_text(encoding="utf-8"),
        "three.xml": three.mjcf,
        "two.xml": two.mjcf,
        "ankles.urdf": ankles(),
    }


def check_mutations(folder, per_file, seed):
    folder = folder / "package"
    folder.mkdir()
    read = lines = 0
    for i, (name, text) in enumerate(bases(folder).items()):
        for k in range(per_file):
            rng = np.random.default_rng([seed, i, k])
            (folder / name).write_text(mutated_xml(text, rng), encoding="utf-8")
            try:
                import_robot(folder / name).robot().model  # noqa: B018
            except QuadrupedError as error:
                lines += str(error).count("\n")
                continue
            read += 1
    assert lines == 0
    return read


@pytest.mark.filterwarnings("error")
def test_damaged_descriptions_raise_no_foreign_error(tmp_path):
    assert check_mutations(tmp_path, 5, seed=1) > 5


@pytest.mark.slow
def test_many_damaged_descriptions_raise_no_foreign_error(tmp_path):
    assert check_mutations(tmp_path, 100, seed=2) > 100
