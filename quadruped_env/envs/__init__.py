"""Gymnasium environment, native vector environment, and `VecEnv` for Stable-Baselines3."""

from typing import TYPE_CHECKING, Any

import gymnasium

from quadruped_env.envs import arguments
from quadruped_env.envs.rough_envs import ROUGH_CONFIG, MiniQuadrupedRoughEnv, MiniQuadrupedRoughVectorEnv
from quadruped_env.envs.single import MiniQuadrupedEnv
from quadruped_env.envs.vector import MiniQuadrupedVectorEnv
from quadruped_env.task.randomization.tile_assignment import EPISODE_SECONDS

if TYPE_CHECKING:
    from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv

__all__ = [
    "ENV_ID",
    "EPISODE_SECONDS",
    "ROUGH_CONFIG",
    "ROUGH_ENV_ID",
    "MiniQuadrupedEnv",
    "MiniQuadrupedRoughEnv",
    "MiniQuadrupedRoughVectorEnv",
    "MiniQuadrupedVectorEnv",
    "make_sb3_vec_env",
    "register",
]

ENV_ID = "MiniQuadruped-v0"
ROUGH_ENV_ID = "MiniQuadrupedRough-v0"
MAX_EPISODE_STEPS = 1000
"""Number of control steps in `EPISODE_SECONDS` at 50 Hz."""


def register() -> None:
    """Register the environments for `gymnasium.make` and `make_vec`; `import quadruped_env` calls this."""
    for env_id, single, vector in (
        (ENV_ID, "single:MiniQuadrupedEnv", "vector:MiniQuadrupedVectorEnv"),
        (ROUGH_ENV_ID, "rough_envs:MiniQuadrupedRoughEnv", "rough_envs:MiniQuadrupedRoughVectorEnv"),
    ):
        if env_id not in gymnasium.registry:
            gymnasium.register(
                id=env_id,
                entry_point=f"quadruped_env.envs.{single}",
                vector_entry_point=f"quadruped_env.envs.{vector}",
                max_episode_steps=MAX_EPISODE_STEPS,
            )


def make_sb3_vec_env(
    num_envs: int,
    seed: int | None = None,
    max_episode_steps: int = MAX_EPISODE_STEPS,
    privileged: bool = False,
    **env_kwargs: Any,
) -> "MiniQuadrupedSB3VecEnv":
    """Create a Stable-Baselines3 `VecEnv` on the native vector environment.

    Args:
        num_envs: number of robots.
        seed: seed of env 0; env i has seed + i.
        max_episode_steps: control steps after which an episode is truncated.
        privileged: append the task's privileged readings to the observations, for the value function of a training.
        env_kwargs: arguments of `gymnasium.make_vec("MiniQuadruped-v0", ...)`.

    Raises:
        MissingExtraError: if stable-baselines3 is not installed.
        QuadrupedError: if an argument is not valid; the message says what is valid.
    """
    from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv

    seed = arguments.seed(seed)
    vector = MiniQuadrupedVectorEnv(num_envs, max_episode_steps=max_episode_steps, **env_kwargs)
    env = MiniQuadrupedSB3VecEnv(vector, privileged)
    env.seed(seed)
    return env
