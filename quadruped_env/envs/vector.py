"""Native vector environment: many robots without a loop over them."""

import functools
import os
from typing import Any

import gymnasium
import mujoco
import numpy as np
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from quadruped_env.envs import arguments
from quadruped_env.envs import spaces_and_info as spaces
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import QuadrupedDesign, Robot
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import Task, TaskConfig, Transition
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.plain import whole_number


class MiniQuadrupedVectorEnv(
    spaces.BaseEnv, gymnasium.vector.VectorEnv[NDArray[np.float32], NDArray[np.float32], NDArray[Any]]
):
    """N copies of `MiniQuadrupedEnv`, simulated on a thread pool, with bit-identical results.

    Created by `gymnasium.make_vec("MiniQuadruped-v0", num_envs=N)`. Supports pickling and `copy.deepcopy`, also within
    episodes.

    Args:
        num_envs: number of robots.
        action_mode, config, task_file, robot, terrain, render_mode, width, height: as in `MiniQuadrupedEnv`.
        max_episode_steps: control steps after which an episode is truncated; None never truncates.
        num_threads: number of threads for the physics; 0 uses every core. The results do not depend on it.
        autoreset_mode: time at which envs whose episode has ended are reset: one of Gymnasium's `AutoresetMode` or its
            value, as in `SyncVectorEnv`. `"SameStep"`: within the step; `final_obs` and `final_info` hold the last
            observation and info of the episode. `"NextStep"`: the next step resets them instead of moving them, with
            reward 0. `"Disabled"`: the caller resets them with `reset(options={"reset_mask": mask})`.

    Raises:
        QuadrupedError: if an argument is not valid; the message says what is valid.
    """

    def __init__(
        self,
        num_envs: int = 1,
        action_mode: str | None = None,
        config: dict[str, Any] | TaskConfig | None = None,
        task_file: str | os.PathLike[str] | None = None,
        robot: Robot | QuadrupedDesign | dict[str, Any] | None = None,
        terrain: str | None = None,
        render_mode: str | None = None,
        width: int = 640,
        height: int = 480,
        max_episode_steps: int | None = None,
        num_threads: int = 0,
        autoreset_mode: AutoresetMode | str = AutoresetMode.SAME_STEP,
    ) -> None:
        self.num_envs = whole_number("num_envs", num_envs, 1)
        num_threads = whole_number("num_threads", num_threads, 0)
        self.render_mode, self._frame_size = arguments.rendering(render_mode, width, height)
        if render_mode == "human":
            raise QuadrupedError("render_mode: 'human' shows one robot; use 'rgb_array' here, or gymnasium.make")
        self.autoreset_mode = arguments.autoreset_mode(autoreset_mode)
        task_config = arguments.task_config(action_mode, config, task_file, robot, terrain, self.default_config)
        self.metadata = {**spaces.metadata(task_config), "autoreset_mode": self.autoreset_mode}
        self._simulation = BatchSimulation(task_config.compiled_model(), self.num_envs, num_threads, task_config.robot)
        self.task = Task(self._simulation, task_config, max_episode_steps)
        self._info = spaces.Info(self.task)
        self.single_action_space = spaces.action_space(self.task.control.robot)
        self.single_observation_space = spaces.observation_space(self.task.control.layout)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)

    @property  # type: ignore[misc]  # read-only, and one per env, as in SyncVectorEnv
    def np_random(self) -> tuple[np.random.Generator, ...]:  # type: ignore[override]
        """Random generator of every env (N,)."""
        return tuple(self.task.generators)

    @property
    def np_random_seed(self) -> tuple[int, ...]:  # type: ignore[override]
        """Seed of every env's generator (N,); -1 for a generator that the user assigned."""
        return tuple(self.task.seeds)

    def reset(
        self, *, seed: int | list[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.float32], dict[str, Any]]:
        """Begin new episodes in every env, or in those where `options["reset_mask"]` (N,) is true."""
        command, mask = arguments.reset_options(options, self.task.config, self.num_envs)
        seeds = arguments.seeds(seed, self.num_envs)
        if mask is None:
            mask = np.ones(self.num_envs, dtype=np.bool_)
        env_ids = np.flatnonzero(mask)
        self.task.reset(env_ids, [seeds[env_id] for env_id in env_ids], command)
        return self.task.observe(), _with_mask(self._info.readings(only=mask), mask)

    def step(
        self, actions: NDArray[np.float32]
    ) -> tuple[NDArray[np.float32], Floats, NDArray[np.bool_], NDArray[np.bool_], dict[str, Any]]:
        """Advance every env by one control step, and reset finished ones according to `autoreset_mode`."""
        restart = None
        if self.autoreset_mode is not AutoresetMode.SAME_STEP and self.task.finished.any():
            if self.autoreset_mode is AutoresetMode.DISABLED:
                raise QuadrupedError(
                    f"step: the episode of env {np.argmax(self.task.finished)} has ended, and autoreset_mode is "
                    "'Disabled'; call reset(options={'reset_mask': terminations | truncations}) first"
                )
            restart = self.task.finished.copy()
        transition = self.task.step(actions, restart)
        if self.autoreset_mode is AutoresetMode.SAME_STEP and self.task.finished.any():
            observation, info = self._reset_finished(transition)
        else:
            observation = transition.observation
            info = self._step_info(transition, self._everywhere() if restart is None else ~restart)
        return observation, transition.reward, transition.terminated, transition.truncated, info

    def _everywhere(self) -> NDArray[np.bool_]:
        return np.ones(self.num_envs, dtype=np.bool_)

    def _step_info(self, transition: Transition, moved: NDArray[np.bool_]) -> dict[str, Any]:
        """Info after a step: the readings of all envs, and the results of those that moved (N,), not of those reset."""
        readings = self._info.readings()
        results = self._info.step_results(transition.diverged, transition.terms)
        if moved.all():
            return _with_mask(readings | results, moved)
        info = _with_mask(readings, self._everywhere())
        return info | _with_mask(results, moved) if moved.any() else info

    def _reset_finished(self, transition: Transition) -> tuple[NDArray[np.float32], dict[str, Any]]:
        """Reset the finished envs. Their last observation and info go to `final_obs` and `final_info`."""
        task, done = self.task, self.task.finished.copy()
        env_ids = np.flatnonzero(done)
        final_obs = np.empty(self.num_envs, dtype=object)  # full of None
        for env_id in env_ids:
            final_obs[env_id] = transition.observation[env_id]
        # Masked as whole arrays, before they are divided into entries: masking every entry takes several times longer.
        diverged, terms = transition.diverged, transition.terms
        final = self._info.readings(only=done)
        final |= self._info.step_results(_only(diverged, env_ids), _only(terms, env_ids))
        task.reset(env_ids)
        # A finished env has the info of its reset, as in SyncVectorEnv.
        diverged[env_ids], terms[env_ids] = False, 0.0
        info = self._step_info(transition, ~done)
        info["final_obs"], info["_final_obs"] = final_obs, done
        info["final_info"], info["_final_info"] = _with_mask(final, done), done
        return task.observe(), info

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """One image (height, width, 3) per env."""
        if self.render_mode is None:
            return None
        return tuple(self.render_one(env_id) for env_id in range(self.num_envs))

    def env_data(self, index: int) -> mujoco.MjData:
        """Copy of the MuJoCo data of one env."""
        return self._simulation.copy_data(index)

    def render_one(self, index: int) -> NDArray[np.uint8]:
        """Image (height, width, 3) of one env; the render mode must be `rgb_array`."""
        data = self.env_data(index)
        frame = self._make_renderer(self._simulation.model, data).render(data)
        assert frame is not None
        return frame

    def get_state(self) -> list[dict[str, Any]]:
        """Complete state of the environment, one dict per env."""
        return [self.task.get_state(env_id) for env_id in range(self.num_envs)]

    def set_state(self, state: list[dict[str, Any]]) -> None:
        """Restore a state from `get_state`."""
        for env_id, values in enumerate(state):
            self.task.set_state(env_id, values)

    def close_extras(self, **kwargs: Any) -> None:
        """Free the renderer, if there is one."""
        self._close_renderer()


class MiniQuadrupedRoughVectorEnv(MiniQuadrupedVectorEnv):
    """N copies of `MiniQuadrupedRoughEnv`; see `MiniQuadrupedVectorEnv`."""

    default_config = arguments.ROUGH_CONFIG


def _only(values: NDArray[Any], env_ids: NDArray[np.intp]) -> NDArray[Any]:
    """Values (N, ...) of some envs (R,), and zero for the others."""
    kept = np.zeros_like(values)
    kept[env_ids] = values[env_ids]
    return kept


def _with_mask(info: dict[str, NDArray[Any]], mask: NDArray[np.bool_]) -> dict[str, Any]:
    """Info in Gymnasium's vector format, which has the mask of the envs with an entry `name` under `_name`."""
    return info | dict.fromkeys(_mask_names(tuple(info)), mask)


@functools.cache
def _mask_names(names: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(f"_{name}" for name in names)
