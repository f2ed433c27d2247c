"""Speed of the physics on tiles of all kinds and levels, with the searched gait and random commands."""

import time
from typing import Any, Final

import numpy as np

from quadruped_env.envs import MAX_EPISODE_STEPS
from quadruped_env.policies import GaitController
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.task import Task, TaskConfig

_STEPS: Final = 60
"""Control steps of a chunk."""


class Drive:
    """A task in which the searched gait walks, and a clock around its physics.

    Args:
        config: config of the task.
        num_envs: number of robots.
    """

    def __init__(self, config: TaskConfig, num_envs: int) -> None:
        simulation = BatchSimulation(build_model(config.physics_timestep, terrain=config.ground), num_envs)
        self._task = Task(simulation, config, MAX_EPISODE_STEPS)
        self._controller = GaitController()
        self._spent = 0.0
        self._task.reset(np.arange(num_envs), range(num_envs))
        step = simulation.step

        def timed(*arguments: Any) -> None:
            start = time.perf_counter()
            step(*arguments)
            self._spent += time.perf_counter() - start

        simulation.step = timed  # type: ignore[assignment, method-assign]

    def seconds(self) -> float:
        """Time that the physics of the next chunk takes, s; robots that fell begin again."""
        self._spent = 0.0
        for _ in range(_STEPS):
            transition = self._task.act(self._controller, self._task.observe())
            ended = np.flatnonzero(transition.terminated | transition.truncated)
            if len(ended):
                self._task.reset(ended)
        return self._spent


def ratios(num_envs: int, chunks: int) -> tuple[float, float]:
    """Physics on tiles over that on the plane, and the time of a step on the plane, us.

    Args:
        num_envs: number of robots.
        chunks: how often the grounds take turns; the first does not count.
    """
    config = TaskConfig.from_dict({"action": {"mode": "residual"}})
    drives = [Drive(config.on_terrain("tiles"), num_envs), Drive(config, num_envs)]
    tiles, plane = np.array([[drive.seconds() for drive in drives] for _ in range(chunks + 1)])[1:].T
    step = float(np.median(plane)) / (_STEPS * num_envs * config.decimation) * 1e6
    return float(np.median(tiles / plane)), step
