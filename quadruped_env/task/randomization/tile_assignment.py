"""Assignment of envs to the tiles of a terrain, and the curriculum that changes their levels.

The curriculum follows Rudin et al. 2021, "Learning to Walk in Minutes Using Massively Parallel Deep Reinforcement
Learning", https://arxiv.org/abs/2109.11978, section 2.3. It depends only on an env's own seed and history.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.errors import QuadrupedError
from quadruped_env.task.context import TaskContext
from quadruped_env.task.randomization.draws import Draws, Purposes
from quadruped_env.task.terrain_section import TilesSection
from quadruped_env.utils.arrays import Bools, EnvIds, Floats
from quadruped_env.utils.fields import check

EPISODE_SECONDS: Final = 20.0
"""Length of an episode without a fall, s. The distance that a fallen robot was commanded to walk counts up to it."""
SHORTEST: Final = 0.5
"""Commanded distance below which an episode does not change the level, for the built-in robot, m."""

_PURPOSES: Final = Purposes({"terrain/kind": 1, "terrain/level": 1})


class TileAssignment:
    """Kind and level of the tile on which each of N envs starts its episodes.

    Without the curriculum, every episode starts on a random tile. With it, an env keeps the kind that its seed gives,
    and a level that begins at random between 1 and `start_levels`. At the end of an episode the env is promoted by one
    level if the robot left its tile, or walked at least `promote_share` of the commanded distance. Otherwise it is
    demoted by one level if the robot walked less than `demote_share` of it. After the last level it gets a random one.

    Distances are integrals over time: of the commanded forward speed, and of the forward velocity in the commanded
    direction. The commanded distance of a robot that fell includes the rest of the episode, at the last command.
    """

    def __init__(self, section: TilesSection, num_envs: int) -> None:
        tiles = section.ground
        self.kinds = tuple(kind.name for kind in tiles.kinds)
        self._centres = tiles.centres()
        self._section = section
        self._tile_size, self._shortest = tiles.tile_size, SHORTEST * tiles.scale
        # Not cleared at a reset: the level outlasts the episode. The rest is cleared in `begin_episodes`.
        self.memory = EpisodeMemory(num_envs)
        self.kind: NDArray[np.int64] = self.memory.zeros("kind", dtype=np.int64)
        """Index of each env's kind in `kinds`, (N,)."""
        self.level: NDArray[np.int64] = self.memory.zeros("level", dtype=np.int64)
        """Level of each env, from 1 on, (N,); 0 before its first episode."""
        self._commanded: Floats = self.memory.zeros("commanded_distance")
        self._walked: Floats = self.memory.zeros("walked_distance")
        self._seconds: Floats = self.memory.zeros("seconds")
        self._speed: Floats = self.memory.zeros("commanded_speed")
        self._left: Bools = self.memory.zeros("left_tile", dtype=np.bool_)
        self._fallen: Bools = self.memory.zeros("fallen", dtype=np.bool_)
        self._of_episode = (self._commanded, self._walked, self._seconds, self._speed, self._left, self._fallen)

    def check(self, tiles: NDArray[np.intp], count: int) -> None:
        """Check the tiles of `count` episodes, as `begin_episodes` takes them.

        Raises:
            QuadrupedError: if there are no such tiles, or not one per episode.
        """
        kinds, levels = self._centres.shape[:2]
        check(tiles.shape == (count, 2), "reset: tiles", tiles.shape, f"of shape ({count}, 2), kind and level")
        kind, level = tiles.T
        wrong = np.flatnonzero((kind < 0) | (kind >= kinds) | (level < 1) | (level > levels))
        if len(wrong):
            raise QuadrupedError(
                f"reset: tiles have kinds 0 to {kinds - 1} and levels 1 to {levels}; found "
                f"{tiles[wrong[0]].tolist()} for episode {wrong[0]}"
            )

    def begin_episodes(
        self, env_ids: EnvIds, first: Bools, draws: Draws, tiles: NDArray[np.intp] | None = None
    ) -> Floats:
        """Choose the tiles of new episodes in some envs (R,), and return the middles of the tiles (R, 2), m.

        The mask `first` (R,) is true where the episode is the first of a seed. Without `tiles`, the index of the kind
        and level of each (R, 2), they are as drawn, or as the curriculum says.
        """
        kind, level = draws.uniform(_PURPOSES, env_ids, np.zeros(len(env_ids), dtype=np.int64)).T
        levels, section = self._centres.shape[1], self._section
        random_kind = np.floor(kind * len(self.kinds)).astype(np.int64)
        random_level = 1 + np.floor(level * levels).astype(np.int64)
        if tiles is not None:
            self.kind[env_ids], self.level[env_ids] = tiles.T
        elif section.curriculum:
            start_level = 1 + np.floor(level * min(section.start_levels, levels)).astype(np.int64)
            next_level = np.maximum(self.level[env_ids] + self._change(env_ids), 1)
            next_level = np.where(next_level > levels, random_level, next_level)
            self.kind[env_ids] = np.where(first, random_kind, self.kind[env_ids])
            self.level[env_ids] = np.where(first, start_level, next_level)
        else:
            self.kind[env_ids], self.level[env_ids] = random_kind, random_level
        for array in self._of_episode:
            array[env_ids] = 0
        return self._centre_of(env_ids)

    def update(self, context: TaskContext, terminated: Bools, diverged: Bools, running: EnvIds | None) -> None:
        """Account for a control step, in all envs or some (R,), before their commands change."""
        env_ids = slice(None) if running is None else running
        valid = ~diverged[env_ids]
        # Forward and, if there is one, lateral velocity.
        command, velocity = context.command[env_ids, ::2], context.velocity[env_ids, ::2]
        speed = np.sqrt(np.add.reduce(command**2, axis=-1))
        along = np.add.reduce(command * velocity, axis=-1) / np.maximum(speed, np.finfo(np.float64).tiny)
        # A simulation that diverged was reset, or holds NaN.
        walked = np.where(valid, along, 0.0) * context.timestep
        away = np.abs(context.readings.base_position[env_ids, :2] - self._centre_of(env_ids))
        self._walked[env_ids] += walked
        self._speed[env_ids] = speed
        self._commanded[env_ids] += self._speed[env_ids] * context.timestep
        self._seconds[env_ids] += context.timestep
        self._left[env_ids] |= valid & np.logical_or.reduce(away > 0.5 * self._tile_size, -1)
        self._fallen[env_ids] = terminated[env_ids]

    def mean_levels(self) -> dict[str, float]:
        """Return the mean level of all envs, `mean_level`, and per kind that has envs, `level_<kind>`."""
        of_kinds = {name: self.level[self.kind == kind] for kind, name in enumerate(self.kinds)}
        levels = {"mean_level": self.level} | {f"level_{name}": own for name, own in of_kinds.items() if own.size}
        return {name: float(own.mean()) for name, own in levels.items()}

    def _change(self, env_ids: EnvIds) -> NDArray[np.int64]:
        """Return 1 for promoted envs, -1 for demoted ones, else 0, (R,)."""
        rest = np.maximum(EPISODE_SECONDS - self._seconds[env_ids], 0.0) * self._speed[env_ids]
        commanded = self._commanded[env_ids] + np.where(self._fallen[env_ids], rest, 0.0)
        walked, counts = self._walked[env_ids], commanded >= self._shortest
        promoted = self._left[env_ids] | (counts & (walked >= self._section.promote_share * commanded))
        demoted = ~promoted & counts & (walked < self._section.demote_share * commanded)
        return promoted.astype(np.int64) - demoted.astype(np.int64)

    def _centre_of(self, env_ids: EnvIds | slice) -> Floats:
        # Before the first episode the level is 0.
        return self._centres[self.kind[env_ids], np.maximum(self.level[env_ids] - 1, 0)]
