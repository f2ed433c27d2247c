"""Joint target messages: writing and reading."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.messages.joint_messages import Joints
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, JOINT_POSITIONS
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import cdr
from quadruped_env.ros.robot_messages import joint_state


def command_message(robot: Robot, stamp: int, target: Target) -> bytes:
    """The CDR bytes of a `/joint_commands` message.

    Args:
        robot: robot that is commanded.
        stamp: timestamp of the state that the target was computed from, ns.
        target: joint targets in rad (J,), or `LIMP`.
    """
    if target is LIMP:
        return joint_state(stamp, robot.joint_names, effort=np.zeros(robot.num_joints))
    return joint_state(stamp, robot.joint_names, target)


def read_target(joints: Joints) -> Target:
    """The target of a `/joint_commands` message.

    Raises:
        QuadrupedError: if the message holds neither positions nor efforts of zero alone.
    """
    if joints.positions is not None:
        return joints.positions
    if joints.efforts is not None and not joints.efforts.any() and joints.velocities is None:
        return LIMP
    raise QuadrupedError(
        f"{JOINT_COMMANDS.name}: has no positions; send positions in rad, or only efforts of 0 to let the robot go limp"
    )


def positions_message(target: NDArray[np.float64]) -> Any:
    """A `/forward_position_controller/commands` message.

    Args:
        target: joint targets, rad (J,).
    """
    return cdr.message(JOINT_POSITIONS.type_name, data=target)


def read_positions(message: Any, robot: Robot) -> NDArray[np.float64]:
    """The joint targets of a `/forward_position_controller/commands` message, rad (J,).

    Raises:
        QuadrupedError: if it does not hold a finite number for each joint.
    """
    positions = np.array(message.data, dtype=np.float64)
    if positions.shape != (robot.num_joints,) or not np.isfinite(positions).all():
        found = positions.tolist() if positions.size <= robot.num_joints else f"{positions.size} numbers"
        raise QuadrupedError(
            f"{JOINT_POSITIONS.name}: holds {found}; send a finite number of rad for each of "
            f"{', '.join(robot.joint_names)}"
        )
    return positions
