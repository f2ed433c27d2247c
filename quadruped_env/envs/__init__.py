"""Gymnasium environment, native vector environment, and `VecEnv` for Stable-Baselines3."""

from typing import TYPE_CHECKING, Any

from quadruped_env.envs import arguments
from quadruped_env.envs.arguments import ROUGH_CONFIG
from quadruped_env.envs.single import MiniQuadrupedEnv, MiniQuadrupedRoughEnv
from quadruped_env.envs.vector import MiniQuadrupedRoughVectorEnv, MiniQuadrupedVectorEnv
from quadruped_env.task.randomization.tile_assignment import EPISODE_SECONDS
from quadruped_env.utils.registration import ENV_ID, MAX_EPISODE_STEPS, ROUGH_ENV_ID

if TYPE_CHECKING:
    from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv

__all__ = [
    "ENV_ID",
    "EPISODE_SECONDS",
    "MAX_EPISODE_STEPS",
    "ROUGH_CONFIG",
    "ROUGH_ENV_ID",
    "MiniQuadrupedEnv",
    "MiniQuadrupedRoughEnv",
    "MiniQuadrupedRoughVectorEnv",
    "MiniQuadrupedVectorEnv",
    "make_sb3_vec_env",
]


def make_sb3_vec_env(
    num_envs: int,
    seed: int | None = None,
    max_episode_steps: int = MAX_EPISODE_STEPS,
    privileged: bool = False,
    random_first_length: bool = False,
    **env_kwargs: Any,
) -> "MiniQuadrupedSB3VecEnv":
    """Create a Stable-Baselines3 `VecEnv` on the native vector environment.

    Args:
        num_envs: number of robots.
        seed: seed of env 0; env i has seed + i.
        max_episode_steps: control steps after which an episode is truncated.
        privileged: append the task's privileged readings to the observations, for the value function of a training.
        random_first_length: end the first episode of each env at a random step, by its time limit, as a training needs
            it: envs that do not fall would otherwise all begin again in the same step, every `max_episode_steps`.
        env_kwargs: arguments of `gymnasium.make_vec("MiniQuadruped-v0", ...)`.

    Raises:
        MissingExtraError: if stable-baselines3 is not installed.
        QuadrupedError: if an argument is not valid; the message says what is valid.
    """
    from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv

    seed = arguments.seed(seed)
    vector = MiniQuadrupedVectorEnv(num_envs, max_episode_steps=max_episode_steps, **env_kwargs)
    env = MiniQuadrupedSB3VecEnv(vector, privileged, random_first_length)
    env.seed(seed)
    return env
