"""The single environment."""

from typing import Any

import gymnasium
import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs import spaces
from quadruped_env.envs.rendering import SceneRenderer
from quadruped_env.robot import load_model
from quadruped_env.simulation import SingleSimulation
from quadruped_env.task import Task, TaskConfig

_ROW = np.zeros(1, dtype=np.intp)


class MiniQuadrupedEnv(gymnasium.Env[NDArray[np.float32], NDArray[np.float32]]):
    """The robot, its commands, and how well it follows them."""

    # gymnasium.make looks at the class for render modes; an instance has its own frame rate.
    metadata = spaces.metadata(TaskConfig())

    def __init__(
        self,
        action_mode: str | None = None,
        config: dict[str, Any] | TaskConfig | None = None,
        render_mode: str | None = None,
        width: int = 640,
        height: int = 480,
    ) -> None:
        spaces.check_render_mode(render_mode)
        task_config = spaces.task_config(action_mode, config)
        self.render_mode = render_mode
        self.metadata = spaces.metadata(task_config)
        self.action_space = spaces.action_space()
        self.observation_space = spaces.observation_space()
        self._simulation = SingleSimulation(load_model(task_config.physics_timestep))
        self.task = Task(self._simulation, task_config)
        self._frame_size = (width, height)
        self._renderer: SceneRenderer | None = None
        if render_mode == "human":
            self._renderer = self._make_renderer()

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo's model."""
        return self._simulation.model

    @property
    def data(self) -> mujoco.MjData:
        """MuJoCo's data: the state of the robot."""
        return self._simulation.data

    @property
    def dt(self) -> float:
        """Time between actions, s."""
        return self.task.config.control_timestep

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.float32], dict[str, Any]]:
        """Begin an episode; see the class for `options`."""
        command = spaces.reset_command(options, self.task.config)
        super().reset(seed=seed)
        self.task.generators[0] = self.np_random
        self.task.reset(_ROW, command=command)
        if self.render_mode == "human":
            self.render()
        return self.task.observe()[0], self._readings()

    def step(self, action: NDArray[np.float32]) -> tuple[NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Advance by one control step; see the class."""
        transition = self.task.step(np.asarray(action)[None])
        info = self._readings()
        info["diverged"] = bool(transition.diverged[0])
        info.update(zip(self.task.reward_keys, transition.terms[0].tolist(), strict=True))
        if self.render_mode == "human":
            self.render()
        terminated = bool(transition.terminated[0])
        return transition.observation[0], float(transition.reward[0]), terminated, False, info

    def render(self) -> NDArray[np.uint8] | None:
        """A picture (height, width, 3) in `rgb_array` mode; updates the window in `human` mode."""
        if self.render_mode is None:
            gymnasium.logger.warn(
                "render() was called without a render mode; use gymnasium.make(..., render_mode='rgb_array')"
            )
            return None
        if self._renderer is None:
            self._renderer = self._make_renderer()
        return self._renderer.render(self.data)

    def _readings(self) -> dict[str, Any]:
        return {name: value[0] for name, value in spaces.readings(self.task).items()}

    def _make_renderer(self) -> SceneRenderer:
        assert self.render_mode is not None
        return SceneRenderer(self.model, self.data, self.render_mode, *self._frame_size)

    def get_state(self) -> dict[str, Any]:
        """Everything that the future of the episode depends on, the random generator included."""
        return self.task.get_state(0)

    def set_state(self, state: dict[str, Any]) -> None:
        """Go on from what `get_state` gave."""
        self.task.generators[0] = self.np_random  # the next reset goes on with it
        self.task.set_state(0, state)

    def close(self) -> None:
        """Close the window or the renderer, if there is one."""
        if self._renderer is not None:
            self._renderer.close()
            self._renderer = None

    def __getstate__(self) -> dict[str, Any]:
        # A renderer holds OpenGL contexts: the copy makes its own.
        return {**self.__dict__, "_renderer": None}
