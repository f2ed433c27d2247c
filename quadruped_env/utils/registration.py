"""Ids of the environments for `gymnasium.make`."""

from typing import Final

import gymnasium

ENV_ID: Final = "MiniQuadruped-v0"
ROUGH_ENV_ID: Final = "MiniQuadrupedRough-v0"
MAX_EPISODE_STEPS: Final = 1000
"""Number of control steps in `EPISODE_SECONDS` at 50 Hz."""


def register_envs() -> None:
    """Register the environments with Gymnasium."""
    for env_id, name in ((ENV_ID, "MiniQuadruped"), (ROUGH_ENV_ID, "MiniQuadrupedRough")):
        gymnasium.register(
            id=env_id,
            entry_point=f"quadruped_env.envs.single:{name}Env",
            vector_entry_point=f"quadruped_env.envs.vector:{name}VectorEnv",
            max_episode_steps=MAX_EPISODE_STEPS,
        )
