"""What the single and the vectorized environment share: spaces, configuration, and the contents of `info`."""

from typing import Any, Final

import gymnasium
import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.task import ACTION_WIDTH, Task, TaskConfig, Transition
from quadruped_env.task.commands import check_command
from quadruped_env.task.observations import OBSERVATION_HIGH, OBSERVATION_LOW

RENDER_MODES: Final = ("human", "rgb_array")


def action_space() -> gymnasium.Space[NDArray[np.float32]]:
    """Joint-position targets, one a joint, in [-1, 1]."""
    return gymnasium.spaces.Box[np.float32](-1.0, 1.0, (ACTION_WIDTH,), np.float32)


def observation_space() -> gymnasium.Space[NDArray[np.float32]]:
    """The bounds of the observation layout."""
    return gymnasium.spaces.Box[np.float32](OBSERVATION_LOW.astype(np.float32), OBSERVATION_HIGH.astype(np.float32))


def task_config(action_mode: str | None, config: dict[str, Any] | TaskConfig | None) -> TaskConfig:
    """The task's config from an environment's arguments.

    Raises:
        QuadrupedError: if the mode or a field of the config is not valid.
    """
    task = config if isinstance(config, TaskConfig) else TaskConfig.from_dict({} if config is None else config)
    values = task.to_dict()
    if action_mode is not None:
        values["action"]["mode"] = action_mode
    return TaskConfig.from_dict(values)


def metadata(config: TaskConfig) -> dict[str, Any]:
    """An environment's metadata for its own control rate."""
    return {"render_modes": list(RENDER_MODES), "render_fps": round(1.0 / config.control_timestep)}


def check_render_mode(render_mode: str | None) -> None:
    """Raise a QuadrupedError if there is no such render mode."""
    if render_mode is not None and render_mode not in RENDER_MODES:
        raise QuadrupedError(
            f"render_mode: {render_mode!r} is unknown; valid modes are None, {', '.join(RENDER_MODES)}"
        )


def reset_command(options: dict[str, Any] | None, config: TaskConfig) -> NDArray[np.float64] | None:
    """The command (2,) that `reset(options=...)` fixes, or None.

    Raises:
        QuadrupedError: if there is an unknown option, or the command is not one of the task's.
    """
    unknown = set(options or ()) - {"command"}
    if unknown:
        raise QuadrupedError(f"options: unknown option {sorted(unknown)[0]!r}; valid options are 'command'")
    command = (options or {}).get("command")
    return None if command is None else check_command(command, config.command)


def readings(task: Task) -> dict[str, NDArray[Any]]:
    """The part of `info` that describes the current state, copied, shape (N, ...) each."""
    state = task.simulation.state
    return {
        "command": task.command.copy(),
        "base_position": state.base_position.copy(),
        "base_linear_velocity": state.linear_velocity_b.copy(),
        "base_angular_velocity": state.angular_velocity_b.copy(),
        "joint_position": state.joint_position.copy(),
        "joint_velocity": state.joint_velocity.copy(),
        "joint_torque": state.joint_torque.copy(),
        "foot_force": state.foot_force.copy(),
        "foot_contact": state.foot_force > task.config.reward.contact_threshold,
    }


def step_info(task: Task, transition: Transition) -> dict[str, NDArray[Any]]:
    """The whole `info` of a step, shape (N, ...) each."""
    info = readings(task)
    info["diverged"] = transition.diverged
    info.update(zip(task.reward_keys, transition.terms.T, strict=True))
    return info
