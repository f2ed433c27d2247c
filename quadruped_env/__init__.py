"""MiniQuadruped: a Gymnasium environment around a MuJoCo model of an eight-joint quadruped.

import gymnasium
import quadruped_env

env = gymnasium.make("MiniQuadruped-v0")
"""

from quadruped_env.utils.interpreter import check_python

check_python()  # before anything is imported that the wrong Python does not have

from quadruped_env.utils.opengl import choose_opengl, import_mujoco  # noqa: E402

choose_opengl()  # before anything imports MuJoCo, which reads the choice when it is imported
import_mujoco()

from quadruped_env import envs, policies  # noqa: E402
from quadruped_env._version import __version__  # noqa: E402
from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning  # noqa: E402
from quadruped_env.gait import CommandedGait, SinusoidalGait  # noqa: E402
from quadruped_env.robot import JOINT_NAMES, LEG_NAMES, asset_path, forward_kinematics  # noqa: E402
from quadruped_env.simulation import build_model  # noqa: E402
from quadruped_env.trajectory import JointState, JointTrajectory  # noqa: E402
from quadruped_env.utils.mujoco_log import log_to_console_only  # noqa: E402

__all__ = [
    "JOINT_NAMES",
    "LEG_NAMES",
    "CommandedGait",
    "JointState",
    "JointTrajectory",
    "MissingExtraError",
    "QuadrupedError",
    "QuadrupedWarning",
    "SinusoidalGait",
    "__version__",
    "asset_path",
    "build_model",
    "envs",
    "forward_kinematics",
    "policies",
]

log_to_console_only()
envs.register()
