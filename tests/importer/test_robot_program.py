"""`mini-quadruped robot FILE`: the files that it writes, and what it prints."""

import re

import gymnasium
import numpy as np
import pytest
from urdf_robots import MASS, imported, robot

from quadruped_env.cli.main import main
from quadruped_env.control.task_file import load_robot
from quadruped_env.envs.rendering import opengl_failure
from quadruped_env.errors import QuadrupedError
from quadruped_env.importer import import_robot, picture
from quadruped_env.importer.picture import write_picture


@pytest.fixture(autouse=True)
def _in_folder_without_opengl(tmp_path, monkeypatch):
    def fail(*_):
        raise QuadrupedError("no OpenGL here")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(picture, "write_picture", fail)


def test_program_writes_a_task_file_that_trains_and_says_what_it_assumed(tmp_path, capsys):
    (tmp_path / "dog.urdf").write_text(robot(name="my dog"), encoding="utf-8")
    assert main(["robot", "dog.urdf"]) == 0
    out = capsys.readouterr().out
    assert f"my_dog: {MASS:.4g} kg, four legs of 3 joints (roll, pitch, pitch)" in out
    assert re.search(r"^LF   LF_roll, LF_hip, LF_knee +\+\+\+ +behind$", out, re.MULTILINE)
    assert "assumed  stance   each foot under its hip, at 0.85 of the leg's length" in out
    assert "written: dog.py, dog.xml; no picture: no OpenGL here" in out
    assert "mini-quadruped train --task dog.py" in out
    lines = (tmp_path / "dog.py").read_text(encoding="utf-8").splitlines()
    assert 10 <= len(lines) <= 20
    assert all("#" in line for line in lines if line.startswith("    k"))
    made = load_robot(tmp_path / "dog.py")
    assert made == import_robot(tmp_path / "dog.urdf").robot()
    assert made.leg_names == ("RH", "LF", "RF", "LH")
    assert made.motors.hip.stall_torque == 20.0
    env = gymnasium.make("MiniQuadruped-v0", robot=made, action_mode="position")
    env.reset(seed=0)
    env.step(env.action_space.sample())
    env.close()


def test_assumed_number_is_overridden_by_editing_it(tmp_path):
    (tmp_path / "dog.urdf").write_text(robot(2), encoding="utf-8")
    assert main(["robot", "dog.urdf", "-o", "spot"]) == 0
    task = tmp_path / "spot.py"
    before = load_robot(task).motors.knee.kp
    task.write_text(task.read_text().replace(f"kp={before!r}", "kp=12.5"))
    assert load_robot(task).motors.knee.kp == 12.5


def test_file_that_is_read_is_never_replaced(tmp_path, capsys):
    (tmp_path / "dog.urdf").write_text(robot(2), encoding="utf-8")
    assert main(["robot", "dog.urdf"]) == 0
    written = (tmp_path / "dog.xml").read_bytes()
    assert main(["robot", "dog.urdf"]) == 2
    assert "exists already" in capsys.readouterr().err
    assert main(["robot", "dog.urdf", "--overwrite"]) == 0
    assert main(["robot", "dog.xml"]) == 0
    assert (tmp_path / "dog.xml").read_bytes() == written
    assert load_robot(tmp_path / "dog_robot.py").total_mass == pytest.approx(MASS - 1.2, rel=1e-6)
    assert main(["robot", "dog.xml", "-o", "dog"]) == 2
    assert "dog.xml is the file that is read; give another name" in capsys.readouterr().err


def test_refused_file_leaves_nothing_behind(tmp_path, capsys):
    (tmp_path / "dog.urdf").write_text("<robot/>", encoding="utf-8")
    assert main(["robot", "dog.urdf"]) == 2
    assert "must have 1 to 2000 links; found 0" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["dog.urdf"]


def test_link_to_itself_is_refused_on_one_line(tmp_path, capsys):
    (tmp_path / "dog.urdf").symlink_to("dog.urdf")
    assert main(["robot", "dog.urdf"]) == 2
    assert capsys.readouterr().err.startswith("mini-quadruped robot: error: dog.urdf: ")


def test_chinese_names_of_files_stay_readable(tmp_path):
    (tmp_path / "小狗.urdf").write_text(robot(2), encoding="utf-8")
    assert main(["robot", "小狗.urdf", "-o", "my dogs/我的狗"]) == 0
    task = tmp_path / "my dogs" / "我的狗.py"
    assert "read from 小狗.urdf" in task.read_text(encoding="utf-8")
    assert 'with_name("我的狗.xml")' in task.read_text(encoding="utf-8")
    assert load_robot(task).name == "made"


@pytest.mark.parametrize("place", [".", "..", "/"])
def test_output_without_a_name_is_refused(tmp_path, capsys, place):
    (tmp_path / "dog.urdf").write_text(robot(2), encoding="utf-8")
    assert main(["robot", "dog.urdf", "-o", place]) == 2
    assert f"error: --output: {place} has no name" in capsys.readouterr().err


@pytest.mark.parametrize("option", [["--forward", "-x"], ["--forward=-x"], ["-x"]])
def test_forward_takes_an_axis_with_a_sign(tmp_path, option):
    (tmp_path / "dog.urdf").write_text(robot(2), encoding="utf-8")
    assert main(["robot", "dog.urdf", *option]) == 0
    made = load_robot(tmp_path / "dog.py")
    assert made.leg_names == ("LF", "RH", "LH", "RF")


def test_picture_shows_the_standing_robot(tmp_path):
    image_module = pytest.importorskip("PIL.Image")
    if opengl_failure():
        pytest.skip(opengl_failure())
    write_picture(imported(robot(2), tmp_path).robot(), tmp_path / "dog.png")
    image = np.asarray(image_module.open(tmp_path / "dog.png")).astype(int)
    assert image.shape == (480, 640, 3)
    blue = (image[..., 2] > 100) & (image[..., 0] < 60)  # the thighs
    assert 0.002 < blue.mean() < 0.2
    assert abs(np.argwhere(blue).mean(axis=0) - [240, 320]).max() < 80


@pytest.mark.parametrize("knee", [20, 30])
def test_robot_in_python_is_the_task_files(tmp_path, knee):
    read = imported(robot(knee=f'lower="-2.6" upper="-0.2" effort="{knee}" velocity="15"'), tmp_path)
    (tmp_path / "made.xml").write_text(read.mjcf, encoding="utf-8")
    (tmp_path / "made.py").write_text(read.task_file("made.xml"), encoding="utf-8")
    assert load_robot(tmp_path / "made.py") == read.robot()
