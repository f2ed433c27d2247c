"""The native vectorized environment: many robots, no loop over them."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from quadruped_env.envs import spaces
from quadruped_env.envs.rendering import SceneRenderer
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import load_model
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import Task, TaskConfig


class MiniQuadrupedVectorEnv(gymnasium.vector.VectorEnv[NDArray[np.float32], NDArray[np.float32], NDArray[Any]]):
    """`MiniQuadrupedEnv` many times over, bit for bit, on a thread pool.

    `gymnasium.make_vec("MiniQuadruped-v0", num_envs=N)` makes it. Finished rows are reset within the step
    (`AutoresetMode.SAME_STEP`): `final_obs` and `final_info` hold how they ended.

    Args:
        num_envs: number of robots.
        action_mode, config, render_mode, width, height: as for `MiniQuadrupedEnv`.
        max_episode_steps: control steps after which an episode is truncated; None never truncates.
        num_threads: threads for the physics; 0 takes every core. The numbers do not depend on it.
    """

    def __init__(
        self,
        num_envs: int = 1,
        action_mode: str | None = None,
        config: dict[str, Any] | TaskConfig | None = None,
        render_mode: str | None = None,
        width: int = 640,
        height: int = 480,
        max_episode_steps: int | None = None,
        num_threads: int = 0,
    ) -> None:
        if num_envs < 1:
            raise QuadrupedError(f"num_envs: expected 1 or more; found {num_envs}")
        spaces.check_render_mode(render_mode)
        if render_mode == "human":
            raise QuadrupedError("render_mode: 'human' shows one robot; use 'rgb_array' here, or gymnasium.make")
        task_config = spaces.task_config(action_mode, config)
        self.num_envs = num_envs
        self.render_mode = render_mode
        self.metadata = {**spaces.metadata(task_config), "autoreset_mode": AutoresetMode.SAME_STEP}
        self.single_action_space = spaces.action_space()
        self.single_observation_space = spaces.observation_space()
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        model = load_model(task_config.physics_timestep, task_config.motor)
        self._simulation = BatchSimulation(model, num_envs, num_threads)
        self.task = Task(self._simulation, task_config, max_episode_steps)
        self._frame_size = (width, height)
        self._renderer: SceneRenderer | None = None

    def reset(
        self,
        *,
        seed: int | list[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[NDArray[np.float32], dict[str, Any]]:
        """Begin new episodes in every row, or where `options["reset_mask"]` (N,) is true."""
        options = dict(options or {})
        mask = _checked_mask(options.pop("reset_mask", None), self.num_envs)
        command = spaces.reset_command(options, self.task.config)
        rows = np.flatnonzero(mask)
        self.task.reset(rows, [self._seeds(seed)[row] for row in rows], command)
        return self.task.observe(), _masked(spaces.readings(self.task), mask)

    def step(
        self, actions: NDArray[np.float32]
    ) -> tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], dict[str, Any]]:
        """Advance every row by one control step, and reset those that finished."""
        transition = self.task.step(actions)
        info = spaces.step_info(self.task, transition)
        done = transition.terminated | transition.truncated
        if not done.any():
            everywhere = np.ones(self.num_envs, dtype=np.bool_)
            info.update({f"_{name}": everywhere for name in tuple(info)})
            return transition.observation, transition.reward, transition.terminated, transition.truncated, info

        final_obs = np.full(self.num_envs, None, dtype=object)
        for row in np.flatnonzero(done):
            final_obs[row] = transition.observation[row]
        self.task.reset(np.flatnonzero(done))
        # The finished rows' info is that of their reset, as in SyncVectorEnv, and their last step's is in final_info.
        merged = {} if done.all() else _masked(info, ~done)
        for name, value in spaces.readings(self.task).items():
            merged[name], merged[f"_{name}"] = value, np.ones(self.num_envs, dtype=np.bool_)
        merged["final_obs"], merged["_final_obs"] = final_obs, done
        merged["final_info"], merged["_final_info"] = _masked(info, done), done
        return self.task.observe(), transition.reward, transition.terminated, transition.truncated, merged

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """One picture (height, width, 3) a row."""
        if self.render_mode is None:
            return None
        frames = []
        for row in range(self.num_envs):
            data = self._simulation.row_data(row)
            if self._renderer is None:
                self._renderer = SceneRenderer(self._simulation.model, data, self.render_mode, *self._frame_size)
            frame = self._renderer.render(data)
            assert frame is not None
            frames.append(frame)
        return tuple(frames)

    def get_state(self) -> list[dict[str, Any]]:
        """Everything that the future depends on, a dict a row."""
        return [self.task.get_state(row) for row in range(self.num_envs)]

    def set_state(self, state: list[dict[str, Any]]) -> None:
        """Go on from what `get_state` gave."""
        for row, values in enumerate(state):
            self.task.set_state(row, values)

    def close_extras(self, **kwargs: Any) -> None:
        """Free the renderer, if there is one."""
        if self._renderer is not None:
            self._renderer.close()
            self._renderer = None

    def _seeds(self, seed: int | list[int | None] | None) -> list[int | None]:
        if seed is None:
            return [None] * self.num_envs
        if isinstance(seed, (int, np.integer)):
            return [int(seed) + row for row in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise QuadrupedError(f"seed: expected one number, or {self.num_envs}, one a row; found {len(seed)}")
        return list(seed)


def _checked_mask(mask: Any, num_envs: int) -> NDArray[np.bool_]:
    if mask is None:
        return np.ones(num_envs, dtype=np.bool_)
    if not isinstance(mask, np.ndarray) or mask.shape != (num_envs,) or mask.dtype != np.bool_ or not mask.any():
        raise QuadrupedError(
            f"options['reset_mask']: expected a bool array of shape ({num_envs},) with one True or more; found {mask!r}"
        )
    return mask


def _masked(info: dict[str, NDArray[Any]], mask: NDArray[np.bool_]) -> dict[str, Any]:
    """Info in Gymnasium's vector form: zero where the mask is false, and the mask beside it under `_name`."""
    if mask.all():
        return {**info, **{f"_{name}": mask for name in info}}
    masked: dict[str, Any] = {}
    for name, value in info.items():
        kept = np.zeros_like(value)
        kept[mask] = value[mask]
        masked[name], masked[f"_{name}"] = kept, mask
    return masked
