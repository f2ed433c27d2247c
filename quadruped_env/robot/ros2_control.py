"""Parameters of ros2_control's standard controllers, as `mini-quadruped live controller --arrays` needs them."""

import json
from collections.abc import Sequence

from quadruped_env.robot.quadruped_files import filled


def controllers_yaml(joint_names: Sequence[str], base_name: str) -> str:
    """Return the parameter file of the controller manager.

    Args:
        joint_names: joints in the order of the commands of `controller --arrays`.
        base_name: link in whose frame the IMU measures.
    """
    joints = "".join(f"\n      - {json.dumps(name)}" for name in joint_names)
    return filled("controllers.yaml", {"joints": joints, "base": json.dumps(base_name)})
