"""The ament_python package, as far as it can be checked without ROS 2 and without building it."""

import ast
import runpy
import sys
from xml.etree import ElementTree

import launch_files
import numpy as np
import pytest
import setuptools
from paths import ROOT

import quadruped_env
from quadruped_env import JOINT_NAMES, SinusoidalGait, asset_path
from quadruped_env.live.__main__ import make_parser

NAME = "mini_quadruped_sim"
PACKAGE = ROOT / "assets" / "ros2" / NAME
PYTHON = "/somewhere/.venv/bin/python"


@pytest.fixture
def package_gait(monkeypatch):
    monkeypatch.syspath_prepend(PACKAGE)
    from mini_quadruped_sim import gait

    return gait


@pytest.fixture
def setup_arguments(monkeypatch):
    """The arguments that setup.py gives to `setup`."""
    given = {}
    monkeypatch.setattr(setuptools, "setup", lambda **arguments: given.update(arguments))
    monkeypatch.chdir(PACKAGE)
    runpy.run_path("setup.py")
    return given


@pytest.fixture
def manifest():
    return ElementTree.parse(PACKAGE / "package.xml").getroot()  # noqa: S314


def launched(name, **arguments):
    return launch_files.started(PACKAGE / "launch" / name, PACKAGE, **arguments)


def imports(path):
    """Top-level names of the modules that a file imports."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module.split(".")[0]


def test_package_urdf_is_the_robots_byte_by_byte():
    assert (PACKAGE / "urdf" / "mini_quadruped.urdf").read_bytes() == asset_path("mini_quadruped.urdf").read_bytes()


def test_package_gait_with_its_defaults_is_the_preset_article(package_gait):
    gait, article = package_gait.Gait(), SinusoidalGait.preset("article")
    times = np.concatenate([np.arange(0, 3600, 7) * 0.05, np.linspace(0, 100, 500)])
    assert package_gait.JOINT_NAMES == JOINT_NAMES
    np.testing.assert_allclose([gait.positions(t) for t in times], article.positions(times), rtol=0, atol=1e-12)
    np.testing.assert_allclose([gait.velocities(t) for t in times], article.velocities(times), rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("values", "name"),
    [({"phases": (0.0,) * 7}, "phases"), ({"phases": (np.nan,) * 8}, "phases"), ({"hip_amplitude": np.inf}, "hip_amp")],
)
def test_package_gait_with_invalid_values_names_the_parameter(package_gait, values, name):
    with pytest.raises(ValueError, match=f"^{name}.*: expected .*; found"):
        package_gait.Gait(**values)


def test_manifest_and_setup_agree(manifest, setup_arguments):
    assert manifest.get("format") == "3"
    assert manifest.find("export/build_type").text == "ament_python"
    assert manifest.find("name").text == setup_arguments["name"] == NAME
    assert manifest.find("version").text == setup_arguments["version"] == quadruped_env.__version__
    assert manifest.find("license").text == setup_arguments["license"]
    assert manifest.find("maintainer").text == setup_arguments["maintainer"]
    assert manifest.find("maintainer").get("email") == setup_arguments["maintainer_email"]
    assert manifest.find("description").text.rstrip(".") == setup_arguments["description"]


def test_setup_installs_every_file_where_ros_looks_for_it(setup_arguments):
    installed = dict(setup_arguments["data_files"])
    assert installed.pop("share/ament_index/resource_index/packages") == [f"resource/{NAME}"]
    assert installed.pop(f"share/{NAME}") == ["package.xml"]
    folders = {"config", "launch", "rviz", "urdf"}
    assert installed == {
        f"share/{NAME}/{folder}": sorted(
            f"{folder}/{path.name}" for path in (PACKAGE / folder).iterdir() if path.is_file()
        )
        for folder in folders
    }
    (entry_point,) = setup_arguments["entry_points"]["console_scripts"]
    module, _, function = entry_point.split(" = ")[1].partition(":")
    tree = ast.parse((PACKAGE / f"{module.replace('.', '/')}.py").read_text())
    assert function in {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}


def test_manifest_names_every_package_that_is_imported_or_started(manifest):
    named = {element.text for element in manifest.iter("exec_depend")}
    files = [*(PACKAGE / NAME).glob("*.py"), *(PACKAGE / "launch").glob("*.py")]
    imported = {name for path in files for name in imports(path)} - set(sys.stdlib_module_names)
    nodes = {node.executable.split("/")[0] for node in launched("display.launch.py")}
    assert (imported | nodes) - {NAME} <= named
    assert named - {"ros2launch"} <= imported | nodes


def test_display_launch_starts_publisher_transforms_and_rviz():
    state, publisher, rviz = launched("display.launch.py")
    assert state.executable == "robot_state_publisher/robot_state_publisher"
    assert state.parameters["robot_description"] == asset_path("mini_quadruped.urdf").read_text()
    assert state.parameters["publish_frequency"] > 20
    assert publisher.executable == f"{NAME}/joint_state_publisher_node"
    assert rviz.executable == "rviz2/rviz2"
    assert rviz.arguments == ["-d", str(PACKAGE / "rviz" / "display.rviz"), "-f", "base_link"]


def test_walk_launch_starts_sim_and_controller_with_the_given_python(monkeypatch):
    monkeypatch.delenv("MINI_QUADRUPED_PYTHON", raising=False)
    monkeypatch.delenv("ROS_AUTOMATIC_DISCOVERY_RANGE", raising=False)
    arguments = {"python": PYTHON, "policy": "trot", "terrain": "rough"}
    sim, controller, state, rviz = launched("walk.launch.py", **arguments)
    for process in (sim, controller):
        assert process.executable == PYTHON
        assert process.arguments[:2] == ["-m", "quadruped_env.live"]
    # The real programs' parsers accept what they are started with.
    parsed = [make_parser().parse_args(process.arguments[2:]) for process in (sim, controller)]
    assert [one.node for one in parsed] == ["sim", "controller"]
    assert parsed[0].terrain == "rough"
    assert parsed[1].policy == "trot"
    assert state.executable.startswith("robot_state_publisher/")
    assert rviz.arguments[-2:] == ["-f", "odom"]
    assert all(
        one.environment == {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"} for one in (sim, controller, state, rviz)
    )


def test_walk_launch_keeps_the_users_discovery_range(monkeypatch):
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET")
    sim, *_ = launched("walk.launch.py", python=PYTHON, rviz="false")
    assert sim.environment == {"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"}


def test_walk_launch_without_a_python_says_which_one_it_needs(monkeypatch):
    monkeypatch.delenv("MINI_QUADRUPED_PYTHON", raising=False)
    with pytest.raises(RuntimeError, match=r"'python'.*MiniQuadruped/\.venv/bin/python"):
        launched("walk.launch.py")


def test_walk_launch_with_the_variable_takes_its_python(monkeypatch):
    monkeypatch.setenv("MINI_QUADRUPED_PYTHON", PYTHON)
    sim, *_ = launched("walk.launch.py", rviz="false")
    assert sim.executable == PYTHON
