"""Environment of this policy for LeRobot, whose `make_env("OWNER/NAME", trust_remote_code=True)` calls this.

It needs `pip install mini-quadruped`. Observations are LeRobot's `agent_pos`; actions are in [-1, 1].
"""

from typing import Any

import gymnasium
from gymnasium import spaces, vector


class LeRobotEnv(gymnasium.ObservationWrapper):
    """One env, whose observation is a dictionary, with the task in words."""

    task = "walk"
    task_description = "Follow the commanded forward velocity and yaw rate."

    def __init__(self) -> None:
        super().__init__(gymnasium.make("quadruped_env:MiniQuadruped-v0", config=CONFIG, render_mode="rgb_array"))
        self.observation_space = spaces.Dict({"agent_pos": self.env.observation_space})

    def observation(self, observation: Any) -> dict[str, Any]:
        """The observation as LeRobot names it."""
        return {"agent_pos": observation}


def make_env(n_envs: int = 1, use_async_envs: bool = False) -> dict[str, dict[int, vector.VectorEnv]]:
    """Envs by suite and number of the task, as LeRobot expects them."""
    kind = vector.AsyncVectorEnv if use_async_envs else vector.SyncVectorEnv
    return {"mini_quadruped": {0: kind([LeRobotEnv] * n_envs)}}


CONFIG: dict[str, Any] = {}
