"""Crossings of tiles: the highest level of each kind of terrain that a robot passes."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import proportion
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite_definition import TerrainPart
from quadruped_env.simulation import TERRAINS, Tiles, find_terrain
from quadruped_env.utils.progress import Progress, part_of


def run_terrain(part: TerrainPart, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure the share of crossings by kind and level, as plain values.

    Levels are tried in their order. A kind is not tried any further after the first level that is not passed.
    """
    passed: dict[str, list[dict[str, Any]]] = {kind: [] for kind in part.kinds}
    left = list(part.kinds)
    for level in range(1, part.levels + 1):
        done = part_of(progress, (level - 1) / part.levels, level / part.levels)
        crossed = crossings(part, candidate, left, level, done)
        for kind in tuple(left):
            passed[kind].append(proportion(crossed[kind]).to_dict())
            if crossed[kind].mean() < part.pass_share:
                left.remove(kind)
        if not left:
            break
    if progress is not None:
        progress(1.0)
    return {kind: {"highest_level": highest(levels, part), "crossed": levels} for kind, levels in passed.items()}


def crossings(
    part: TerrainPart, candidate: Candidate, kinds: Sequence[str], level: int, progress: Progress | None = None
) -> dict[str, NDArray[np.bool_]]:
    """True for each episode that leaves its tile on its feet and in time: kind -> (worlds, S).

    Episodes start in the middle of the tile with a random heading, and walk straight ahead.
    """
    worlds = []
    tiles = find_terrain("tiles", TERRAINS)
    assert isinstance(tiles, Tiles)
    on = np.repeat([[part.kinds.index(kind), level] for kind in kinds], part.num_seeds, axis=0)
    for i, seed in enumerate(part.terrain_seeds):
        done = part_of(progress, i / len(part.terrain_seeds), (i + 1) / len(part.terrain_seeds))
        world = tiles.of([find_terrain(kind) for kind in part.kinds], part.levels, seed)
        rollout = candidate.run([part.command] * len(kinds), part.seeds, part.seconds, done, terrain=world, tiles=on)
        ground = rollout.terrain  # in the units of the robot
        assert isinstance(ground, Tiles)
        centre = ground.centres()[on[:, 0], on[:, 1] - 1]
        away = np.abs(rollout.base_position[..., :2] - centre).max(axis=-1)
        crossed = (rollout.valid & (away > 0.5 * ground.tile_size)).any(axis=0)
        worlds.append(crossed.reshape(len(kinds), part.num_seeds))
    return dict(zip(kinds, np.stack(worlds, axis=1), strict=True))


def highest(levels: Sequence[Mapping[str, Any]], part: TerrainPart) -> int:
    """Highest level up to which every level is passed; 0 if the first one is not."""
    passed = [entry["mean"] >= part.pass_share for entry in levels]
    return passed.index(False) if False in passed else len(passed)
