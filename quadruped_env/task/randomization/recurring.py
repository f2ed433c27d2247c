"""Randomizations that repeat within an episode, such as pushes."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.simulation import Simulation
from quadruped_env.task.randomization.draws import Draws, Purposes
from quadruped_env.task.randomization.event import Event
from quadruped_env.task.randomization.randomization import Active, between, in_steps
from quadruped_env.utils.fields import Range

EnvIds = NDArray[np.intp]
Steps = NDArray[np.int64]


class Recurring:
    """A randomization that repeats within the episodes of N envs.

    Args:
        active: the randomization.
        simulation: simulation of the N robots.
        interval: range of the time between two applications, s.
        duration: range of the time after which zeros are applied, s; None: what was applied lasts.
        timestep: control step, s.
        draws: source of random numbers.
        memory: memory that gets the steps at which something is due.
    """

    def __init__(
        self,
        active: Active,
        simulation: Simulation,
        interval: Range,
        duration: Range | None,
        timestep: float,
        draws: Draws,
        memory: EpisodeMemory,
    ) -> None:
        self.name, self.interval = active.name, interval
        self._active, self._duration, self._timestep, self._draws = active, duration, timestep, draws
        robot = simulation.robot
        self._columns = active.randomization.columns(robot)
        lasting = {} if duration is None else {f"{self.name}/duration": 1}
        self._purposes = Purposes({self.name: active.randomization.draws(robot), f"{self.name}/interval": 1, **lasting})
        self.due: Steps = memory.zeros(f"{self.name}_due", dtype=np.int64)
        """Control step at which it applies next, (N,)."""
        self._until: Steps = memory.zeros(f"{self.name}_until", dtype=np.int64)
        """Control step at which what was applied ends; 0 if nothing lasts, (N,)."""

    def apply(self, steps: Steps, running: EnvIds | None, event: Callable[[EnvIds], Event]) -> None:
        """Apply what is due, and end what has lasted.

        Args:
            steps: control steps since each env's reset, (N,).
            running: indices of the envs to which it may be applied; None: all.
            event: function that returns an event for some envs (R,).
        """
        if self._duration is not None:
            env_ids = _among(np.flatnonzero((self._until > 0) & (steps >= self._until)), running)
            if len(env_ids):
                self._until[env_ids] = 0
                self._active.apply(event(env_ids), np.zeros((len(env_ids), self._columns)))
        env_ids = _among(np.flatnonzero(steps >= self.due), running)
        if len(env_ids):
            now, columns = steps[env_ids], self._purposes.slices
            draws = self._draws.uniform(self._purposes, env_ids, now)
            wait = between(self.interval, draws[:, columns[f"{self.name}/interval"].start])
            self.due[env_ids] += in_steps(wait, self._timestep)
            if self._duration is not None:
                lasting = between(self._duration, draws[:, columns[f"{self.name}/duration"].start])
                self._until[env_ids] = now + in_steps(lasting, self._timestep)
            self._active.apply(event(env_ids), self._active.values(draws[:, columns[self.name]]))


def _among(env_ids: EnvIds, running: EnvIds | None) -> EnvIds:
    return env_ids if running is None else np.intersect1d(env_ids, running)
