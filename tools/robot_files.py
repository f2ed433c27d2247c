"""Write the model files of the built-in robot, after a change of its design."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.ros2_control import controllers_yaml

ROOT = Path(__file__).parents[1]

FILES = {
    "assets/mini_quadruped/mini_quadruped.xml": MINI_QUADRUPED.mjcf,
    "assets/mini_quadruped/mini_quadruped.urdf": MINI_QUADRUPED.urdf,
    "assets/ros2/mini_quadruped_sim/urdf/mini_quadruped.urdf": MINI_QUADRUPED.urdf,
    "assets/ros2/mini_quadruped_sim/config/controllers.yaml": controllers_yaml(
        MINI_QUADRUPED.joint_names, MINI_QUADRUPED.base_name
    ),
}


def main() -> None:
    """Write the files, and print their names."""
    for name, text in FILES.items():
        (ROOT / name).parent.mkdir(exist_ok=True)
        (ROOT / name).write_text(text, encoding="utf-8")
        print(f"written: {name}")


if __name__ == "__main__":
    main()
