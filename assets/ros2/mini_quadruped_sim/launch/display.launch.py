"""The robot in RViz: robot_state_publisher, the joint state publisher, RViz with a saved configuration.

ros2 launch mini_quadruped_sim display.launch.py
ros2 launch mini_quadruped_sim display.launch.py rviz:=false
"""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

PACKAGE = "mini_quadruped_sim"
# robot_state_publisher skips messages that follow one another faster than this. Its default is 20 Hz, exactly the
# publisher's rate; a value above it loses no message to rounding.
TRANSFORM_RATE = 50.0  # Hz


def generate_launch_description() -> LaunchDescription:
    """Build the launch description; `ros2 launch` calls it."""
    share = Path(get_package_share_directory(PACKAGE))
    urdf = (share / "urdf" / "mini_quadruped.urdf").read_text(encoding="utf-8")
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "publisher",
                default_value="true",
                choices=["true", "false"],
                description="Run the joint state publisher; false where something else publishes /joint_states.",
            ),
            DeclareLaunchArgument("rviz", default_value="true", choices=["true", "false"], description="Run RViz."),
            DeclareLaunchArgument("fixed_frame", default_value="base_link", description="Fixed Frame of RViz."),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                output="screen",
                # A string without a type would be parsed as YAML, which a URDF with a colon in a comment is not.
                parameters=[
                    {
                        "robot_description": ParameterValue(urdf, value_type=str),
                        "publish_frequency": TRANSFORM_RATE,
                    }
                ],
            ),
            Node(
                package=PACKAGE,
                executable="joint_state_publisher_node",
                output="screen",
                condition=IfCondition(LaunchConfiguration("publisher")),
            ),
            Node(
                package="rviz2",
                executable="rviz2",
                arguments=["-d", str(share / "rviz" / "display.rviz"), "-f", LaunchConfiguration("fixed_frame")],
                condition=IfCondition(LaunchConfiguration("rviz")),
            ),
        ]
    )
