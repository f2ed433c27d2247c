"""A URDF, an MJCF or a xacro file in the place of a robot: the error says what it is and how a robot is given."""

import gymnasium
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.robot import MINI_QUADRUPED, asset_path
from quadruped_env.robot.description import description_problem

XACRO = '<robot xmlns:xacro="http://ros.org/wiki/xacro" name="dog"><xacro:include filename="leg.xacro"/></robot>'
HOW = "'mini-quadruped robot FILE' reads it and writes a Python file for --task FILE or task_file=... (docs/robots.md)"


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (asset_path("mini_quadruped.urdf").read_bytes(), "a URDF"),
        (asset_path("mini_quadruped.xml").read_bytes(), "an MJCF"),
        (b'\xef\xbb\xbf\n<?xml version="1.0"?>\n<!-- <mujoco> -->\n<robot name="dog"><link na', "a URDF"),
        (b"<robot name='dog'>\xff not XML", "a URDF"),
        (XACRO.encode(), "a xacro file"),
        (b'<sdf version="1.9"/>', "an SDF"),
        (b"<mujocoinclude/>", "an MJCF"),
        (b"<html><robot/></html>", ""),
        (b"<mujoco", ""),
        (b"< 3", ""),
        (b"", ""),
        (b"robot = QuadrupedDesign()", ""),
    ],
)
def test_description_is_recognised_by_its_content(content, kind):
    problem = description_problem(content)
    assert problem.startswith(f"this is {kind}") if kind else not problem
    assert ("cannot be imported" in problem) == (kind == "an SDF")


@pytest.mark.parametrize(
    "command",
    [
        ("convert", "dog.txt", "out.csv"),
        ("evaluate", "--task", "dog.txt"),
        ("evaluate", "dog.txt"),
        ("train", "--task", "dog.txt"),
    ],
    ids=" ".join,
)
def test_program_says_that_a_file_is_a_urdf_and_how_a_robot_is_given(command, domain_id, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "dog.txt").write_text(MINI_QUADRUPED.urdf)
    try:
        status = main(command)
    except SystemExit as end:  # argparse
        status = end.code
    error = capsys.readouterr().err
    assert status == 2
    assert "dog.txt: this is a URDF, not a Python file; " in error
    assert HOW in error


def test_env_says_that_its_robot_is_an_mjcf(tmp_path):
    for path in (asset_path("mini_quadruped.xml"), str(asset_path("mini_quadruped.xml"))):
        with pytest.raises(QuadrupedError, match=r"mini_quadruped\.xml: this is an MJCF, not a Python file"):
            gymnasium.make("MiniQuadruped-v0", robot=path)
    with pytest.raises(QuadrupedError, match=r"robot: expected a Robot.*found 'go1'"):
        gymnasium.make("MiniQuadruped-v0", robot="go1")
