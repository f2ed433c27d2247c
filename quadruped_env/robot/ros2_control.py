"""Parameters of ros2_control's standard controllers, as `mini-quadruped live controller --arrays` needs them."""

import json
from collections.abc import Sequence

from quadruped_env.robot.quadruped_files import IMU


def controllers_yaml(joint_names: Sequence[str], base_name: str) -> str:
    """The parameter file of the controller manager.

    Args:
        joint_names: joints in the order of the commands of `controller --arrays`.
        base_name: link in whose frame the IMU measures.
    """
    joints = "".join(f"\n      - {json.dumps(name)}" for name in joint_names)
    return f"""\
# Parameters of ros2_control's controller_manager for "mini-quadruped live controller --arrays".
#
# When that controller goes limp, it stops publishing: an array of positions cannot say "motors off". ros2_control goes
# on: the forward_position_controller holds the last positions, and the hardware's write() gets them in every cycle, so
# that a watchdog in it does not notice. Something has to deactivate the hardware component after 1 s without a message
# on /forward_position_controller/commands, and the hardware has to switch the motors off when it is deactivated.

controller_manager:
  ros__parameters:
    update_rate: 100  # Hz
    joint_state_broadcaster:
      type: joint_state_broadcaster/JointStateBroadcaster
    imu_sensor_broadcaster:
      type: imu_sensor_broadcaster/IMUSensorBroadcaster
    forward_position_controller:
      type: forward_command_controller/ForwardCommandController

imu_sensor_broadcaster:  # remap ~/imu to /imu/data
  ros__parameters:
    sensor_name: {IMU}
    frame_id: {json.dumps(base_name)}

forward_position_controller:
  ros__parameters:
    interface_name: position
    joints:  # in the order of the arrays{joints}
"""
