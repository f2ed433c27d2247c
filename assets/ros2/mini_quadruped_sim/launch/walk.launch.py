"""The robot walking in simulation: MiniQuadruped's `sim` and `controller`, with robot_state_publisher and RViz.

    ros2 launch mini_quadruped_sim walk.launch.py python:=/path/to/MiniQuadruped/.venv/bin/python
    ros2 topic pub -r 10 /cmd_vel geometry_msgs/msg/Twist "{linear: {x: 0.3}}"

`sim` and `controller` run in MiniQuadruped's own Python, which needs no ROS. The environment variable
MINI_QUADRUPED_PYTHON may name it instead of the argument `python`.
"""

import os

from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument,
    ExecuteProcess,
    IncludeLaunchDescription,
    SetEnvironmentVariable,
    Shutdown,
)
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import EnvironmentVariable, LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir

DISCOVERY_RANGE = "ROS_AUTOMATIC_DISCOVERY_RANGE"


def generate_launch_description() -> LaunchDescription:
    """Build the launch description; `ros2 launch` calls it."""
    node = [LaunchConfiguration("python"), "-m", "quadruped_env.live"]
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "python",
                # Without a value the argument is required: the Python that ROS runs in has no quadruped_env.
                default_value=os.environ.get("MINI_QUADRUPED_PYTHON"),
                description="The Python that MiniQuadruped is installed in, such as MiniQuadruped/.venv/bin/python.",
            ),
            DeclareLaunchArgument(
                "policy", default_value="flat", description="What 'controller' runs: a policy, a run directory, a gait."
            ),
            DeclareLaunchArgument(
                "terrain", default_value="flat", description="Ground of 'sim': a name that 'sim --help' lists."
            ),
            DeclareLaunchArgument("rviz", default_value="true", choices=["true", "false"], description="Run RViz."),
            # 'sim' and 'controller' stay on this machine, and a ROS node may need this setting to discover them.
            SetEnvironmentVariable(DISCOVERY_RANGE, EnvironmentVariable(DISCOVERY_RANGE, default_value="LOCALHOST")),
            ExecuteProcess(
                cmd=[*node, "sim", "--terrain", LaunchConfiguration("terrain"), "--pick-up", "3"],
                name="sim",
                output="screen",
                on_exit=Shutdown(reason="sim ended"),
            ),
            ExecuteProcess(
                cmd=[*node, "controller", LaunchConfiguration("policy")],
                name="controller",
                output="screen",
                on_exit=Shutdown(reason="controller ended"),
            ),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(PathJoinSubstitution([ThisLaunchFileDir(), "display.launch.py"])),
                launch_arguments={
                    "publisher": "false",
                    "rviz": LaunchConfiguration("rviz"),
                    "fixed_frame": "odom",
                }.items(),
            ),
        ]
    )
