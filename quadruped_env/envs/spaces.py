"""What the single and the vectorized environment share: spaces, metadata, specification, and the contents of `info`."""

import copy
from typing import Any

import gymnasium
import numpy as np
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from quadruped_env._plain import plain
from quadruped_env.envs.arguments import RENDER_MODES
from quadruped_env.task import ACTION_WIDTH, Task, TaskConfig, Transition
from quadruped_env.task.observations import OBSERVATION_HIGH, OBSERVATION_LOW


def action_space() -> gymnasium.Space[NDArray[np.float32]]:
    """Joint-position targets, one a joint, in [-1, 1]."""
    return gymnasium.spaces.Box(-1.0, 1.0, (ACTION_WIDTH,), np.float32)


def observation_space() -> gymnasium.Space[NDArray[np.float32]]:
    """The bounds of the observation layout."""
    return gymnasium.spaces.Box(OBSERVATION_LOW.astype(np.float32), OBSERVATION_HIGH.astype(np.float32))


def metadata(config: TaskConfig) -> dict[str, Any]:
    """An environment's metadata for its own control rate."""
    return {"render_modes": list(RENDER_MODES), "render_fps": round(1.0 / config.control_timestep)}


class PlainSpec:
    """Base of envs whose specification goes through JSON: NumPy values, enums and `TaskConfig` become plain values."""

    _spec: EnvSpec | None = None

    @property
    def spec(self) -> EnvSpec | None:
        """The specification that makes this environment again, with plain arguments."""
        return self._spec

    @spec.setter
    def spec(self, value: EnvSpec | None) -> None:
        self._spec = copy.copy(value)
        if self._spec is not None:
            self._spec.kwargs = plain(self._spec.kwargs)


def readings(task: Task, at: int | slice = slice(None)) -> dict[str, NDArray[Any]]:
    """The part of `info` that describes the current state, copied.

    Args:
        task: the episodes of N environments.
        at: the index of one, whose readings have no leading axis, or the slice of all, shape (N, ...) each.
    """
    state = task.simulation.state
    return {
        "command": task.command[at].copy(),
        "base_position": state.base_position[at].copy(),
        "base_linear_velocity": state.linear_velocity_b[at].copy(),
        "base_angular_velocity": state.angular_velocity_b[at].copy(),
        "joint_position": state.joint_position[at].copy(),
        "joint_velocity": state.joint_velocity[at].copy(),
        "joint_torque": state.joint_torque[at].copy(),
        "foot_force": state.foot_force[at].copy(),
        "foot_contact": state.foot_force[at] > task.config.reward.contact_threshold,
    }


def step_results(task: Task, transition: Transition) -> dict[str, NDArray[Any]]:
    """The part of `info` that only a step has, shape (N,) each: `diverged` and the weighted reward terms."""
    return {"diverged": transition.diverged, **dict(zip(task.reward_keys, transition.terms.T, strict=True))}
