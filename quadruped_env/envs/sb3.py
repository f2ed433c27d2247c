"""Stable-Baselines3's `VecEnv` on the native vector environment, without a loop over envs."""

import time
from collections.abc import Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode
from numpy.typing import NDArray

from quadruped_env.envs.spaces_and_info import observation_space
from quadruped_env.envs.vector import MiniQuadrupedVectorEnv
from quadruped_env.errors import MissingExtraError
from quadruped_env.utils.fields import check

try:
    from stable_baselines3.common.monitor import Monitor
    from stable_baselines3.common.vec_env import VecEnv
    from stable_baselines3.common.vec_env.base_vec_env import VecEnvIndices
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("training", "train") from error


class MiniQuadrupedSB3VecEnv(VecEnv):
    """The native vector environment with the interface of Stable-Baselines3.

    `infos` has entries only for envs whose episode has ended: `terminal_observation`; `TimeLimit.truncated`, which is
    true if the time limit ended the episode, so that PPO bootstraps; and `episode` in the format of SB3's Monitor, with
    return `r`, length `l`, time since this object was created `t` in s, and the summed reward terms. Therefore
    `env_is_wrapped(Monitor)` is true. The data of all envs is in the arrays of `self.task`. Supports pickling and
    `copy.deepcopy`.

    Args:
        env: the native vector environment.
        privileged: append the task's privileged readings to the observations, for the value function of a training.
        random_first_length: end the first episode of each env at a random step, by its time limit.

    Raises:
        QuadrupedError: if the environment's autoreset mode is not `SAME_STEP`, or a privileged reading is not valid.
    """

    def __init__(
        self, env: MiniQuadrupedVectorEnv, privileged: bool = False, random_first_length: bool = False
    ) -> None:
        mode, same_step = env.autoreset_mode, AutoresetMode.SAME_STEP
        rule = f"{same_step.value!r} for Stable-Baselines3, which resets finished envs within the step"
        check(mode is same_step, "autoreset_mode", mode.value, rule)
        self.env = env
        self.task = env.task
        self.render_mode = env.render_mode
        self.metadata = env.metadata
        self.privileged = env.task.privileged_readings() if privileged else None
        """The privileged readings in the last columns of the observations; None without them."""
        self._random_first_length = random_first_length
        super().__init__(env.num_envs, self._space(), env.single_action_space)
        self._actions = np.zeros((env.num_envs, env.task.control.robot.num_joints), dtype=np.float32)
        self.last_terms = np.zeros((env.num_envs, len(self.task.term_names)))
        self._episode_terms = np.zeros((env.num_envs, len(self.task.term_names)))
        self._start_time = time.time()

    def _space(self) -> gymnasium.Space[NDArray[np.float32]]:
        if self.privileged is None:
            return self.env.single_observation_space
        spaces = self.env.single_observation_space, observation_space(self.privileged.layout)
        low, high = (np.concatenate([getattr(space, end) for space in spaces]) for end in ("low", "high"))
        return gymnasium.spaces.Box(low, high)

    def observe(self) -> NDArray[np.float32]:
        """Observations (N, width) of the present state, as `step` returns them."""
        return self._with_privileged(self.task.observe())

    def _with_privileged(self, observations: NDArray[np.float32]) -> NDArray[np.float32]:
        """Observations (N, width) of the present state, with the privileged readings."""
        if self.privileged is None:
            return observations
        return np.concatenate([observations, self.privileged.values()], axis=1)

    def reset(self) -> NDArray[np.float32]:
        """Begin new episodes in all envs, with the seeds and options from `seed` and `set_options`."""
        options = self._options[0]
        if any(other != options for other in self._options):
            raise NotImplementedError(
                f"set_options: all envs are reset together, with the same options; found {self._options}"
            )
        observations, _ = self.env.reset(seed=self._seeds, options=options)
        if self._random_first_length:
            self.task.shorten_episodes()
        self._episode_terms[:] = 0.0
        self._reset_seeds()
        self._reset_options()
        return self._with_privileged(observations)

    def step_async(self, actions: NDArray[np.float32]) -> None:
        """Store the actions for `step_wait`."""
        self._actions = actions

    def step_wait(self) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.bool_], list[dict[str, Any]]]:
        """Advance every env by one control step, and reset those whose episode has ended."""
        transition = self.task.step(self._actions)
        self.last_terms = transition.terms
        self._episode_terms += transition.terms
        done = transition.terminated | transition.truncated
        observations = self._with_privileged(transition.observation)
        # New dicts at every step: a wrapper may write into them.
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        if done.any():
            env_ids = np.flatnonzero(done)
            elapsed = round(time.time() - self._start_time, 6)
            for env_id in env_ids:
                terms = self._episode_terms[env_id]
                infos[env_id] = {
                    "terminal_observation": observations[env_id],
                    "TimeLimit.truncated": bool(transition.truncated[env_id] and not transition.terminated[env_id]),
                    "episode": {
                        "r": float(np.add.accumulate(terms)[-1]),
                        "l": int(self.task.control.steps[env_id]),
                        "t": elapsed,
                        "terms": terms.copy(),
                    },
                }
            self._episode_terms[env_ids] = 0.0
            self.task.reset(env_ids)
            observations = self.observe()
        return observations, transition.reward.astype(np.float32), done, infos

    def close(self) -> None:
        """Free the resources of the environment."""
        self.env.close()

    def get_images(self) -> Sequence[NDArray[np.uint8] | None]:
        """One image per env."""
        return self.env.render() or [None] * self.num_envs

    def get_attr(self, attr_name: str, indices: VecEnvIndices = None) -> list[Any]:
        """An attribute of the vector environment, which all envs share, once per env."""
        return [getattr(self.env, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: VecEnvIndices = None) -> None:
        """Not supported: the envs are not separate objects."""
        raise NotImplementedError(
            f"set_attr({attr_name!r}): the envs of a native vector environment share their attributes"
        )

    def env_method(self, method_name: str, *args: Any, indices: VecEnvIndices = None, **kwargs: Any) -> list[Any]:
        """Not supported: the envs are not separate objects."""
        raise NotImplementedError(
            f"env_method({method_name!r}): the envs of a native vector environment have no methods"
        )

    def env_is_wrapped(self, wrapper_class: type[Any], indices: VecEnvIndices = None) -> list[bool]:
        """True for Monitor, because this object reports episodes like a Monitor; False for all other wrappers."""
        return [wrapper_class is Monitor] * len(list(self._get_indices(indices)))
