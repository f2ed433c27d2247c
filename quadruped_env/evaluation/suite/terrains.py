"""Crossings of tiles: the highest level of each kind of terrain that a robot passes."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.evaluation.confidence import proportion
from quadruped_env.evaluation.rollout import run_episodes
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import TerrainPart
from quadruped_env.simulation import TERRAINS, Tiles, find_terrain
from quadruped_env.utils.progress import Progress, part_of


def run(part: TerrainPart, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Share of crossings by kind and level, as plain values.

    Levels are tried in their order. A kind is not tried any further after the first level that is not passed.
    """
    passed: dict[str, list[dict[str, Any]]] = {kind: [] for kind in part.kinds}
    left = list(part.kinds)
    for level in range(1, part.levels + 1):
        done = part_of(progress, (level - 1) / part.levels, level / part.levels)
        crossed = crossings(part, measured, left, level, done)
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
    part: TerrainPart, measured: MeasuredController, kinds: Sequence[str], level: int, progress: Progress | None = None
) -> dict[str, NDArray[np.bool_]]:
    """True for each episode that leaves its tile on its feet and in time: kind -> (S,).

    Episodes start in the middle of the tile with a random heading, and walk straight ahead.
    """
    tiles = find_terrain("tiles", TERRAINS)
    assert isinstance(tiles, Tiles)
    chosen = tiles.of([find_terrain(kind) for kind in part.kinds], part.levels, part.terrain_seed)
    config = task_config(measured.controller.action_mode, measured.task([part.command], terrain=chosen))
    seeds = np.tile(np.array(part.seeds), len(kinds))
    on = np.repeat([[part.kinds.index(kind), level] for kind in kinds], part.num_seeds, axis=0)
    ground = config.ground  # in the units of the robot
    assert isinstance(ground, Tiles)
    centre = ground.centres()[on[:, 0], on[:, 1] - 1]
    steps = round(part.seconds / config.control_timestep)
    crossed, fallen = np.zeros(len(seeds), dtype=np.bool_), np.zeros(len(seeds), dtype=np.bool_)
    command = np.tile(np.array(part.command), (len(seeds), 1))
    for step, (task, transition) in enumerate(
        run_episodes(measured.controller, command, seeds, steps, config, tiles=on)
    ):
        fallen |= transition.terminated & ~crossed
        away = np.abs(task.simulation.readings.base_position[:, :2] - centre).max(axis=1)
        crossed |= ~fallen & (away > 0.5 * ground.tile_size)
        if progress is not None:
            progress((step + 1) / steps)
        if (crossed | fallen).all():
            break
    return dict(zip(kinds, crossed.reshape(len(kinds), part.num_seeds), strict=True))


def highest(levels: Sequence[dict[str, Any]], part: TerrainPart) -> int:
    """Highest level up to which every level is passed; 0 if the first one is not."""
    passed = [entry["mean"] >= part.pass_share for entry in levels]
    return passed.index(False) if False in passed else len(passed)


def score(result: dict[str, Any], part: TerrainPart) -> float:
    """Score in [0, 1] of the part: mean over the kinds of the highest level over the number of levels."""
    return float(np.mean([kind["highest_level"] for kind in result.values()])) / part.levels
