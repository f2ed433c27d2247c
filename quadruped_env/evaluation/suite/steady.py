"""Parts of the suite with a fixed command: map of commands, gait, regulation under disturbances, and terrains."""

import math
from collections.abc import Mapping, Sequence
from typing import Annotated, Any, Final

import numpy as np
from numpy.typing import ArrayLike

from quadruped_env.control.control_config import VELOCITIES
from quadruped_env.evaluation.confidence import bootstrap_mean, mean_of, number, proportion
from quadruped_env.evaluation.measures import gait_measures, mean_velocities, measure, reached
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.changing import moving_and_standing
from quadruped_env.evaluation.suite.suite_definition import CommandMap, Disturbance, GaitPart, Regulation, TerrainPart
from quadruped_env.simulation import TERRAINS, Tiles, find_terrain, flat
from quadruped_env.simulation.terrain import Grid, terrain
from quadruped_env.task import Task
from quadruped_env.utils import rotations
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.progress import Progress, part_of

_GAIT_MEASURES: Final = (
    "joint_limit_share",
    "speed_limit_share",
    "sideways_drift",
    "heading_drift",
    "electrical_power",
    "electrical_cost_of_transport",
)
"""Measures of the gait that need no physics steps."""
_DROP: Final = 0.01
"""Distance of the stance's soles from an incline at the start, m: randomized legs do not penetrate it."""


def run_command_map(part: CommandMap, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure the map of achieved over commanded velocities, its summary and the envelope."""
    drawn, on_axes = list(part.drawn), [command for axis in part.axes.values() for command in axis]
    rollout = candidate.run([*drawn, *on_axes], part.seeds, part.seconds, progress)
    shape = len(drawn) + len(on_axes), part.num_seeds
    found = reached(rollout, np.repeat([*drawn, *on_axes], part.num_seeds, axis=0), part.tolerance)
    velocity, fallen = found.velocity.reshape(*shape, -1), rollout.fallen.reshape(shape)
    met, closely = found.met.reshape(shape), found.closely.reshape(shape)
    accuracy = found.accuracy.reshape(shape)
    count, stand = len(drawn), np.array([not any(command) for command in drawn])
    return {
        "commands": [list(command) for command in drawn],
        "fall_share": fallen[:count].mean(axis=-1).tolist(),
        "met": proportion(met[:count]).to_dict(),
        "met_closely": proportion(closely[:count]).to_dict(),
        "falls": proportion(fallen[:count]).to_dict(),
        **signed_errors(drawn, velocity[:count]),
        "standing": proportion(met[:count][stand]).to_dict(),
        "envelope": envelope(part, met[count:]),
        "contributions": moving_and_standing(accuracy[:count][~stand], accuracy[:count][stand]),
    }


def signed_errors(commands: ArrayLike, velocity: Floats) -> dict[str, Any]:
    """Return the errors of each velocity under K commands, from mean velocities (K, S, V): name -> plain values."""
    error, result = velocity - np.asarray(commands, dtype=np.float64)[:, None], {}
    for entry, errors in zip(VELOCITIES, np.moveaxis(error, -1, 0), strict=False):
        signed = np.array([mean_of(episodes) for episodes in errors], dtype=np.float64)
        known = np.abs(signed[np.isfinite(signed)])
        result[f"{entry.name}_error"] = {
            "signed": [number(value) for value in signed.tolist()],
            "mean": number(float(known.mean())) if known.size else None,
            "largest": number(float(known.max())) if known.size else None,
        }
    return result


def envelope(part: CommandMap, met: Bools) -> dict[str, float]:
    """Return the largest command in each direction up to which every episode meets its command; 0 if none does.

    In m/s, left and right in rad/s. `met` (commands of all axes, S) is True for episodes that meet their command.
    """
    found, place = {}, 0
    for name, axis in part.axes.items():
        all_met = met[place : place + len(axis)].all(axis=-1)
        reached = int(np.argmin(np.append(all_met, False)))
        found[name] = float(np.abs(axis[reached - 1]).max()) if reached else 0.0
        place += len(axis)
    return found


def run_gait(part: GaitPart, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure the gait at each command: means over the episodes."""
    rollout = candidate.run(part.commands, part.seeds, part.seconds, progress, physics=True)
    every = measure(rollout)
    values = {**gait_measures(rollout), **{name: every[name] for name in _GAIT_MEASURES}}
    shape = len(part.commands), part.num_seeds
    commands = np.repeat(part.commands, part.num_seeds, axis=0)
    accuracy = reached(rollout, commands, part.tolerance).accuracy
    grouped = {name: value.reshape(*shape, *value.shape[1:]) for name, value in values.items()}
    return {
        "feet": list(candidate.robot.leg_names),
        "commands": [
            {
                "command": list(command),
                "accuracy": float(accuracy.reshape(shape)[i].mean()),
                **{name: mean_of(value[i]) for name, value in grouped.items()},
            }
            for i, command in enumerate(part.commands)
        ],
        "contributions": (accuracy * gait_scores(values, part)).tolist(),
    }


def gait_scores(values: Mapping[str, Floats], part: GaitPart) -> Floats:
    """Score the gait of each episode in [0, 1], (N,), from its measures: name -> (N, L).

    Mean of four numbers, 0 for a robot with a foot that does not step: the clearance of the foot that is lifted least,
    over `full_clearance`; x or 1 / x, the one below 1, of the foot with the worst number x of touchdowns per stride;
    `soft_landing` over the speed of the hardest landing; `little_slip` over the largest slip. Each is at most 1.
    """
    touchdowns = np.maximum(values["touchdowns_per_stride"], 1e-9)
    numbers = np.stack(
        [
            values["clearance"].min(axis=-1) / part.full_clearance,
            np.minimum(touchdowns, 1.0 / touchdowns).min(axis=-1),
            part.soft_landing / np.maximum(values["landing_speed"], 1e-9).max(axis=-1),
            part.little_slip / np.maximum(values["slip"], 1e-9).max(axis=-1),
        ]
    )
    # NaN for a foot that does not step.
    return np.nan_to_num(np.clip(numbers, 0.0, 1.0).mean(axis=0))


@terrain(size=24.0, cell=0.5)
def incline(grid: Grid, angle: Annotated[float, Parameter("rad", -0.5, 0.5)] = 0.0) -> Floats:
    """A plane that rises along x."""
    return math.tan(angle) * grid.x


def run_regulation(part: Regulation, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure how commands are kept under each disturbance, and under all together: name -> plain values."""
    together = range(part.first_seed, part.first_seed + part.together_seeds)
    runs = [(factor, part.seeds, part.seconds) for factor in part.factors]
    runs.append((part.together, together, part.together_seconds))
    costs = np.cumsum([0.0, *(len(seeds) * seconds for _, seeds, seconds in runs)])
    shares = costs / costs[-1]
    result, kept = {}, []
    for i, (factor, seeds, seconds) in enumerate(runs):
        rollout = regulated(part, candidate, factor, seeds, seconds, part_of(progress, shares[i], shares[i + 1]))
        episodes = keeps(part, mean_velocities(rollout), rollout.fallen)
        result[factor.name] = regulation_measures(rollout, episodes, part)
        kept.append(episodes)
    alone = np.concatenate(kept[:-1])
    all_of_them = reached(rollout, np.repeat(part.commands, part.together_seeds, axis=0), part.tolerance).accuracy
    result[part.together.name]["accuracy"] = bootstrap_mean(all_of_them).to_dict()
    # Each of the two counts half, whatever its number of episodes.
    half = 0.5 * (len(alone) + len(all_of_them))
    weighted = np.concatenate([half / len(alone) * alone, half / len(all_of_them) * all_of_them])
    return {"disturbances": result, "contributions": weighted.tolist()}


def regulated(
    part: Regulation,
    candidate: Candidate,
    factor: Disturbance,
    seeds: range,
    seconds: float,
    progress: Progress | None = None,
) -> Rollout:
    """Roll out every command with every seed under a disturbance; the robots stand before they get their commands."""
    angle = math.radians(factor.slope)
    commands = np.repeat(part.commands, len(seeds), axis=0)

    def begin(task: Task, step: int) -> None:
        if step == 0 and angle:
            _place(task, angle)
        if step == round(part.standing / task.control.config.timestep):
            task.control.set_command(np.arange(len(commands)), commands)

    return candidate.run(
        [(0.0, 0.0)] * len(part.commands),
        seeds,
        seconds,
        progress,
        factor.randomization,
        before_step=begin,
        reached=part.commands,
        terrain=incline.variant(angle=angle) if angle else flat,
    )


def _place(task: Task, angle: float) -> None:
    """Put the robots parallel to an incline (rad): level, their front or hind feet would be in the ground."""
    start, robot = task.simulation.readings, task.simulation.robot
    height = robot.stance_height + _DROP
    qpos = np.zeros((task.num_envs, robot.num_positions))
    qpos[:, :3] = height * np.array([-math.sin(angle), 0.0, math.cos(angle)])
    qpos[:, 3:7] = rotations.multiply(rotations.from_axis_angle([0.0, 1.0, 0.0], -angle), start.orientation)
    qpos[:, 7:] = start.joint_position
    task.place(np.arange(task.num_envs), qpos, np.zeros((task.num_envs, robot.num_velocities)))


def regulation_measures(rollout: Rollout, kept: Bools, part: Regulation) -> dict[str, Any]:
    """Return falls, and the signed share of each command that is kept, of episodes grouped by command."""
    achieved = mean_velocities(rollout).reshape(len(part.commands), -1, rollout.velocity.shape[-1])
    return {
        "falls": proportion(rollout.fallen).to_dict(),
        "kept": proportion(kept).to_dict(),
        "commands": [
            {
                "command": list(command),
                "velocity": mean_of(velocity),
                "share": [mean_of(velocity[:, i] / wanted) if wanted else None for i, wanted in enumerate(command)],
            }
            for command, velocity in zip(part.commands, achieved, strict=True)
        ],
    }


def keeps(part: Regulation, achieved: Floats, fallen: Bools) -> Bools:
    """Return True for each of N episodes, grouped by command, that keeps its velocities without a fall (N,).

    `achieved` are mean velocities (N, V), NaN if unknown.
    """
    command = np.repeat(part.commands, len(achieved) // len(part.commands), axis=0)
    allowed = np.where(command != 0.0, part.share * np.abs(command), part.tolerance.met)
    # Decimal commands are not exact in binary.
    return np.asarray((np.abs(achieved - command) <= allowed + 1e-9).all(axis=-1) & ~fallen)


def run_terrain(part: TerrainPart, candidate: Candidate, progress: Progress | None = None) -> dict[str, Any]:
    """Measure the share of crossings by kind and level, as plain values.

    Levels are tried in their order. A kind is not tried any further after the first level that is not passed. A start
    contributes the share of the levels that are crossed from it; those that are not tried are not crossed.
    """
    passed: dict[str, list[dict[str, Any]]] = {kind: [] for kind in part.kinds}
    starts = {kind: np.zeros((part.worlds, part.num_seeds)) for kind in part.kinds}
    left = list(part.kinds)
    for level in range(1, part.levels + 1):
        done = part_of(progress, (level - 1) / part.levels, level / part.levels)
        crossed = crossings(part, candidate, left, level, done)
        for kind in tuple(left):
            passed[kind].append(proportion(crossed[kind]).to_dict())
            starts[kind] += crossed[kind] / part.levels
            if crossed[kind].mean() < part.pass_share:
                left.remove(kind)
        if not left:
            break
    if progress is not None:
        progress(1.0)
    kinds = {kind: {"highest_level": highest(levels, part), "crossed": levels} for kind, levels in passed.items()}
    return {"kinds": kinds, "contributions": np.concatenate([one.ravel() for one in starts.values()]).tolist()}


def crossings(
    part: TerrainPart, candidate: Candidate, kinds: Sequence[str], level: int, progress: Progress | None = None
) -> dict[str, Bools]:
    """Return True for each episode that leaves its tile on its feet and in time: kind -> (worlds, S).

    Episodes start in the middle of the tile with a random heading, and walk straight ahead.
    """
    worlds = []
    tiles = find_terrain("tiles", TERRAINS)
    assert isinstance(tiles, Tiles)
    on = np.repeat([[part.kinds.index(kind), level] for kind in kinds], part.num_seeds, axis=0)
    for i in range(part.worlds):
        done = part_of(progress, i / part.worlds, (i + 1) / part.worlds)
        world = tiles.of([find_terrain(kind) for kind in part.kinds], part.levels, part.first_seed + i)
        rollout = candidate.run([part.command] * len(kinds), part.seeds, part.seconds, done, terrain=world, tiles=on)
        ground = rollout.terrain  # in the units of the robot
        assert isinstance(ground, Tiles)
        centre = ground.centres()[on[:, 0], on[:, 1] - 1]
        away = np.abs(rollout.base_position[..., :2] - centre).max(axis=-1)
        crossed = (rollout.valid & (away > 0.5 * ground.tile_size)).any(axis=0)
        worlds.append(crossed.reshape(len(kinds), part.num_seeds))
    return dict(zip(kinds, np.stack(worlds, axis=1), strict=True))


def highest(levels: Sequence[Mapping[str, Any]], part: TerrainPart) -> int:
    """Return the highest level up to which every level is passed; 0 if the first one is not."""
    passed = [entry["mean"] >= part.pass_share for entry in levels]
    return passed.index(False) if False in passed else len(passed)
