"""Build script of the ROS 2 package; `colcon build` runs it."""

from glob import glob

from setuptools import setup

NAME = "mini_quadruped_sim"

setup(
    name=NAME,
    version="0.1.0",
    description="The quadruped of the ROS 2 tutorial: URDF, joint state publisher, RViz, and launch files",
    maintainer="The MiniQuadruped contributors",
    maintainer_email="maintainers@example.com",
    license="Apache-2.0",
    packages=[NAME],
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
        (f"share/{NAME}/config", sorted(glob("config/*.yaml"))),
        (f"share/{NAME}/launch", sorted(glob("launch/*.launch.py"))),
        (f"share/{NAME}/rviz", sorted(glob("rviz/*.rviz"))),
        (f"share/{NAME}/urdf", sorted(glob("urdf/*.urdf"))),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    entry_points={
        "console_scripts": [f"joint_state_publisher_node = {NAME}.joint_state_publisher_node:main"],
    },
)
