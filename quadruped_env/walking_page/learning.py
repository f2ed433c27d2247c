"""Numbers for learning on the page: the robot, a gait that marches on the spot, and the task's reward.

The programs that read them are in `tools/page/src/learn`.
"""

import math
from typing import Any, Final

import numpy as np

from quadruped_env.control.control_config import clock_frequency
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import CommandedGait, joint_phases
from quadruped_env.robot.units import scale_of
from quadruped_env.task import TaskConfig

TERMS: Final = (
    "track_forward_velocity",
    "track_yaw_rate",
    "forward_progress",
    "turn_progress",
    "gait_clock",
    "contact_clock",
    "upright",
    "base_motion",
    "action_rate",
    "fall",
)
"""Reward terms that the page has: those that need the readings of a control step, not of each physics step."""
_SPEED: Final = 0.8
"""Forward velocity to learn, as a part of the largest command."""


def learning_document(config: TaskConfig) -> dict[str, Any] | None:
    """Return plain values for learning with the robot of a config; None if the scripted gaits do not fit the robot.

    Reward, observations and gait clock are the defaults of the robot's task, whatever the config has.
    """
    robot, step = config.robot, config.control_timestep
    task = TaskConfig().for_robot(robot)
    frequency = clock_frequency(robot)
    try:
        gait = CommandedGait.preset("sinusoid", robot, frequency)
    except QuadrupedError:
        return None
    # Without a stride: the mean of one forwards and one backwards.
    speed = gait.whole_steps[0]
    sine, cosine, offset = (waves.mean(axis=0) for waves in gait.waves(np.array([[speed, 0.0], [-speed, 0.0]])))
    reward, action = task.reward, task.action
    return {
        "observations": ObservationLayout(robot).document(),
        "stance": robot.stance.tolist(),
        "low": robot.joint_position_low.tolist(),
        "high": robot.joint_position_high.tolist(),
        "phases": (phases := joint_phases(robot)).tolist(),
        "leg_phases": [phases[joints[0]] for joints in robot.leg_joints],
        "phase_step": math.tau * frequency * step,
        "sine": sine.tolist(),
        "cosine": cosine.tolist(),
        "offset": offset.tolist(),
        "scale": action.residual_scale,
        "unit": [scale_of(unit, robot) for unit in ("m/s", "rad/s")],
        "command": [round(_SPEED * config.commands[0].range[1], 1), 0.0],
        "smoothing": 1.0 - math.exp(-step / reward.velocity_time_constant),
        "std": [reward["forward_velocity_std"], reward["yaw_rate_std"]],
        "foot_radius": robot.foot_radius,
        "foot_lift": reward["foot_lift"],
        "contact_threshold": reward.contact_threshold,
        "base_arm": reward["base_arm"],
        "weights": {name: reward.weights[name] for name in TERMS},
    }
