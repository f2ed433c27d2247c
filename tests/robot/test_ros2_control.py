"""ros2_control: the URDF offers what its standard controllers need, and its sensors are no part of the identity."""

import dataclasses
import re
from xml.etree import ElementTree

import pytest
import yaml
from paths import ROOT
from renamed_robot import ROBOT as RENAMED
from twelve_joints import ROBOT as TWELVE

from quadruped_env.live.middleware.topics import JOINT_POSITIONS
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.ros2_control import controllers_yaml

ROBOTS = {"built-in": MINI_QUADRUPED, "renamed": RENAMED, "three joints": TWELVE}
# The state interfaces of semantic_components::IMUSensor, without the sensor's name.
IMU_INTERFACES = {
    *(f"orientation.{axis}" for axis in "xyzw"),
    *(f"{quantity}.{axis}" for quantity in ("angular_velocity", "linear_acceleration") for axis in "xyz"),
}


@pytest.mark.parametrize("name", ROBOTS)
def test_urdf_offers_the_interfaces_that_the_controllers_need(name):
    robot = ROBOTS[name]
    (system,) = ElementTree.fromstring(robot.description).findall("ros2_control")  # noqa: S314
    offered = {
        kind: {
            f"{part.get('name')}/{entry.get('name')}"
            for part in (*system.findall("joint"), *system.findall("sensor"))
            for entry in part.findall(f"{kind}_interface")
        }
        for kind in ("command", "state")
    }
    parameters = yaml.safe_load(controllers_yaml(robot.joint_names, robot.base_name))
    forward, imu = (
        parameters[controller]["ros__parameters"]
        for controller in ("forward_position_controller", "imu_sensor_broadcaster")
    )
    assert forward["joints"] == list(robot.joint_names), "the order of the arrays"
    assert offered["command"] == {f"{joint}/{forward['interface_name']}" for joint in forward["joints"]}
    assert {f"{joint}/{state}" for joint in robot.joint_names for state in ("position", "velocity")} < offered["state"]
    assert {f"{imu['sensor_name']}/{interface}" for interface in IMU_INTERFACES} < offered["state"]
    assert imu["frame_id"] == robot.base_name
    manager = parameters["controller_manager"]["ros__parameters"]
    assert {controller for controller in manager if controller != "update_rate"} == {
        "joint_state_broadcaster", "imu_sensor_broadcaster", "forward_position_controller",
    }  # fmt: skip
    assert JOINT_POSITIONS.name == "/forward_position_controller/commands"


def test_files_of_the_built_in_robot_are_those_of_the_package_for_colcon():
    path = ROOT / "assets" / "ros2" / "mini_quadruped_sim" / "config" / "controllers.yaml"
    expected = controllers_yaml(MINI_QUADRUPED.joint_names, MINI_QUADRUPED.base_name)
    assert path.read_text() == expected, "run python tools/robot_files.py"


def test_sensors_of_the_urdf_are_no_part_of_the_identity_but_those_of_the_mjcf_are():
    bare = re.sub(r"<sensor name=.*?</sensor>", "", MINI_QUADRUPED.urdf, flags=re.DOTALL)
    assert bare != MINI_QUADRUPED.urdf
    assert dataclasses.replace(MINI_QUADRUPED, urdf=bare) == MINI_QUADRUPED
    other = MINI_QUADRUPED.urdf.replace("<mechanical_reduction>100<", "<mechanical_reduction>50<")
    assert dataclasses.replace(MINI_QUADRUPED, urdf=other) != MINI_QUADRUPED
    noisy = MINI_QUADRUPED.mjcf.replace(
        '<gyro name="imu_angular_velocity"', '<gyro noise="1" name="imu_angular_velocity"'
    )
    assert dataclasses.replace(MINI_QUADRUPED, mjcf=noisy) != MINI_QUADRUPED
