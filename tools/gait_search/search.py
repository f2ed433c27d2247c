"""Search for the parameters of the scripted gaits (CMA-ES), with many candidates in parallel.

A candidate is an array (3, 2, 6) in rad: the straight gait; what a turn of size 1 rad/s adds on both sides; what it
adds on the right and subtracts on the left. Of each the columns of `LegTable` for the fore and for the hind legs. The
straight gait is searched first, then what turning changes on top of it. Limits of the joints are hard bounds. Method:
Hansen 2016, https://arxiv.org/abs/1604.00772, of the package cmaes.
"""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import astuple
from typing import Final, NamedTuple

import numpy as np

from gait_search.styles import HIGH_STEPS, STYLES, Steps
from gait_search.trial import Achieved, Scale, Targets, draw_starts, measure, new_starts
from quadruped_env.errors import MissingExtraError
from quadruped_env.gait import LEG_PHASES, CommandedGait, LegTable, turn_size
from quadruped_env.gait.gait_presets import TUNED_FOR_ONE_SPEED, TUNED_ON
from quadruped_env.gait.gaits import LEG_TABLES
from quadruped_env.robot import Robot
from quadruped_env.robot.corners import corners
from quadruped_env.utils.arrays import Floats

CANDIDATES: Final = 32
"""Of each generation, next to its mean."""
ONE_SPEED: Final = {"trot": 0.4, "walk": 0.25, "bound": 0.35, "pace": 0.3}
"""Preset -> forward velocity for which it is searched, m/s."""

_TROT: Final = LEG_PHASES["trot"]
_OVERSHOOT: Final = 0.05
"""Share of a joint's range that no target enters at either end: joints overshoot their targets."""
_HIP: Final = (0, 5, 1)
_KNEE: Final = (2, 3, 4)
"""Columns of a joint's two parts of the amplitude, and of its offset."""


def gait_targets(robot: Robot, candidates: Floats, size: Floats, turns: tuple[float, ...]) -> Targets:
    """Targets of candidates (N, 3, 2, 6) in turns of sizes (N,) in rad/s, with leg phases by corner in cycles."""
    of_legs = list(corners(robot))
    straight, turn, side = np.moveaxis(candidates[:, :, [corner // 2 for corner in of_legs]], 1, 0)
    right = np.array([(-1.0, 1.0)[corner % 2] for corner in of_legs])[:, None]
    size = size[:, None, None]
    columns = np.moveaxis(straight + np.abs(size) * turn + size * right * side, 2, 0)
    hip_sine, hip_offset, knee_cosine, knee_sine, knee_offset, hip_cosine = columns
    phases = math.tau * np.array(turns)[of_legs]

    def targets(clock: float) -> Floats:
        sine, cosine = np.sin(clock + phases), np.cos(clock + phases)
        hip = hip_cosine * cosine + hip_sine * sine + hip_offset
        knee = knee_cosine * cosine + knee_sine * sine + knee_offset
        return np.stack([hip, knee], axis=-1).reshape(len(candidates), -1)

    return targets


def limited(robot: Robot, legs: Floats, angular_frequency: float) -> Floats:
    """Columns of a fore and a hind leg (..., 2, 6) within the joints' ranges and speeds."""
    legs = legs.copy()
    own = [corners(robot).index(corner) for corner in (1, 3)]
    for joint, (sine, cosine, offset) in enumerate((_HIP, _KNEE)):
        low, high, speed = (
            values.reshape(-1, 2)[own, joint]
            for values in (robot.joint_position_low, robot.joint_position_high, robot.velocity_limit)
        )
        margin = _OVERSHOOT * (high - low)
        low, high = low + margin, high - margin
        largest = np.minimum(0.999 * speed / angular_frequency, 0.5 * (high - low))
        amplitude = np.hypot(legs[..., sine], legs[..., cosine])
        for part in (sine, cosine):
            legs[..., part] *= np.minimum(1.0, largest / np.maximum(amplitude, 1e-9))
        amplitude = np.minimum(amplitude, largest)
        legs[..., offset] = np.clip(legs[..., offset], low + amplitude, high - amplitude)
    return legs


def within_limits(robot: Robot, candidates: Floats, angular_frequency: float, largest_yaw_rate: float) -> Floats:
    """Candidates (N, 3, 2, 6) within the limits straight ahead and, on both sides, at the largest yaw rate in rad/s.

    They are so between the two as well, since the limits are convex.
    """
    straight = limited(robot, candidates[:, 0], angular_frequency)
    if largest_yaw_rate == 0.0:
        return np.concatenate([straight[:, None], candidates[:, 1:]], axis=1)
    turn, side = largest_yaw_rate * candidates[:, 1], largest_yaw_rate * candidates[:, 2]
    left = limited(robot, straight + turn - side, angular_frequency) - straight
    right = limited(robot, straight + turn + side, angular_frequency) - straight
    return np.stack([straight, (left + right) / (2.0 * largest_yaw_rate), (right - left) / (2.0 * largest_yaw_rate)], 1)


class Found(NamedTuple):
    """The best candidate of a search."""

    candidate: Floats
    """(3, 2, 6)"""
    achieved: Achieved
    """Its results, one value per yaw rate of the search."""
    score: float
    """Larger is better."""


def search(
    robot: Robot,
    speed: float,
    angular_frequency: float,
    turns: tuple[float, ...],
    start: Floats,
    steps: Steps,
    generations: int,
    yaw_rates: tuple[float, ...] = (0.0,),
) -> Found:
    """The best candidate for a forward speed (m/s): its straight gait, or what turning changes in the one of `start`.

    Scores from different starts do not compare. With new ones in each generation it is the mean of the last.

    Args:
        robot: the robot.
        speed: target, m/s.
        angular_frequency: rad/s.
        turns: phase of the leg of each corner, cycles.
        start: initial candidate (3, 2, 6).
        steps: steps that are searched, and how.
        generations: number of generations, next to the steps'.
        yaw_rates: targets, rad/s: 0 alone for the straight gait, or positive and increasing; turns to the right are
            their mirror images.

    Raises:
        MissingExtraError: if cmaes is not installed.
        QuadrupedError: if the robot has not one leg with hip and knee in each corner.
    """
    try:
        from cmaes import CMA
    except ImportError as error:
        raise MissingExtraError("The search of a gait", "test") from error
    count, scale, largest = CANDIDATES + 1, Scale(robot), max(yaw_rates)
    # All candidates at the first yaw rate, then all at the second.
    wanted = np.repeat(yaw_rates, count)
    varied, unit = (slice(1, 3), 1.0 / largest) if largest else (slice(0, 1), 1.0)
    strategy = CMA((start[varied] / unit).ravel(), steps.spread, seed=0, population_size=CANDIDATES)
    best = None
    for generation in range(generations + steps.more_generations):
        drawn = [strategy.ask() for _ in range(CANDIDATES)]
        candidates = np.tile(start, (count, 1, 1, 1))
        candidates[:, varied] = unit * np.reshape([strategy.mean, *drawn], (count, *start[varied].shape))
        candidates = np.round(within_limits(robot, candidates, angular_frequency, largest), 4)
        targets = gait_targets(robot, np.tile(candidates, (len(yaw_rates), 1, 1, 1)), turn_size(wanted, largest), turns)
        starts = new_starts(robot, generation, steps.draws) if steps.draws else draw_starts(robot, 0)
        got = measure(robot, targets, len(wanted), angular_frequency, turns, starts)
        score = steps.score(got.like_the_tuned_robot(robot), speed / scale.velocity, wanted / scale.rate)
        score = score.reshape(len(yaw_rates), count).mean(axis=0)
        strategy.tell([(values, -value) for values, value in zip(drawn, score[1:].tolist(), strict=True)])
        first = 0 if steps.draws else int(np.argmax(score))
        if best is None or steps.draws or score[first] > best.score:
            achieved = Achieved(**{name: part[first::count] for name, part in vars(got).items()})
            best = Found(candidates[first], achieved, float(score[first]))
    assert best is not None
    return best


def tune_commanded_gait(
    robot: Robot, name: str, angular_frequency: float, generations: int, say: Callable[[str], None]
) -> CommandedGait:
    """Return the tables of a `CommandedGait` in one of `STYLES`, at a frequency in rad/s.

    Each search starts from the robot's preset of that name, at the nearest speed of its tables. Speeds
    that are not searched in turns turn as their nearest ones do.
    """
    style, scale, known = STYLES[name], Scale(robot), candidates_of(CommandedGait.preset(name, robot))
    yaw_rates = tuple(scale.rate * yaw_rate for yaw_rate in style.yaw_rates)
    straight, turning = {}, {}
    for speed in (scale.velocity * speed for speed in style.speeds):
        start = known[_nearest(speed, known)]
        found = search(robot, speed, angular_frequency, _TROT, start, style.straight, generations)
        say(_line(f"{speed:+.2f} m/s", found, (0.0,)))
        # A few mm/s are missing after the search: the table has the speed that the gait reaches.
        reached = round(float(found.achieved.forward_velocity[0]), 3) if speed else 0.0
        straight[reached] = found.candidate[0]
    for speed in (scale.velocity * speed for speed in style.turning_speeds):
        reached = _nearest(speed, straight)
        start = np.concatenate([[straight[reached]], known[_nearest(reached, known)][1:]])
        found = search(robot, reached, angular_frequency, _TROT, start, style.turns, generations, yaw_rates=yaw_rates)
        say(_line(f"{reached:+.2f} m/s in turns", found, yaw_rates))
        turning[reached] = found.candidate[1:]
    whole = {
        speed: np.concatenate([[legs], turning[_nearest(speed, turning)]]) for speed, legs in sorted(straight.items())
    }
    # The turn of another speed, on top of this one's straight gait, may be beyond the limits.
    table = within_limits(robot, np.array(list(whole.values())), angular_frequency, max(yaw_rates))
    return commanded_gait(robot, dict(zip(whole, table, strict=True)), angular_frequency, max(yaw_rates))


def tune_preset(name: str, generations: int, say: Callable[[str], None]) -> Floats:
    """Columns of the fore and the hind leg (2, 6) of a preset for one speed, on the robot that the presets are for."""
    angular_frequency, fore, hind = TUNED_FOR_ONE_SPEED[name]
    start = np.zeros((3, 2, 6))
    start[0] = [astuple(leg) for leg in (fore, hind)]
    found = search(TUNED_ON, ONE_SPEED[name], angular_frequency, LEG_PHASES[name], start, HIGH_STEPS, generations)
    say(_line(f"{name} at {angular_frequency} rad/s", found, (0.0,)))
    return found.candidate[0].round(3)


def _nearest(speed: float, others: Iterable[float]) -> float:
    return min(others, key=lambda other: abs(other - speed))


def commanded_gait(
    robot: Robot, table: Mapping[float, Floats], angular_frequency: float, largest_yaw_rate: float
) -> CommandedGait:
    """Return the robot's own gait whose tables have a candidate (3, 2, 6) at each speed in m/s, increasing."""
    # Part, leg, column, speed.
    columns = np.round(list(table.values()), 4).transpose(1, 2, 3, 0)
    legs = dict(zip(LEG_TABLES, (leg for part in columns.tolist() for leg in part), strict=True))
    numbers = {
        "angular_frequency": angular_frequency,
        "speeds": tuple(table),
        "largest_yaw_rate": largest_yaw_rate,
        **{name: dict(zip(LegTable.__dataclass_fields__, leg, strict=True)) for name, leg in legs.items()},
    }
    return CommandedGait.of_legs(numbers, robot)


def candidates_of(gait: CommandedGait) -> dict[float, Floats]:
    """Return the candidates (3, 2, 6) of a gait on its robot, by speed in m/s: the inverse of `commanded_gait`."""
    own = [corners(gait.robot).index(corner) for corner in (1, 3)]
    parts = []
    for waves in (gait.straight, gait.turn, gait.side):
        (hip_sine, knee_sine), (hip_cosine, knee_cosine), (hip_offset, knee_offset) = (
            np.moveaxis(wave.reshape(len(gait.speeds), -1, 2)[:, own], 2, 0) for wave in waves
        )
        parts.append(np.stack([hip_sine, hip_offset, knee_cosine, knee_sine, knee_offset, hip_cosine], axis=-1))
    return dict(zip(gait.speeds, np.stack(parts, axis=1), strict=True))


def _line(what: str, found: Found, yaw_rates: tuple[float, ...]) -> str:
    got = found.achieved
    columns = got.forward_velocity, got.yaw_rate, yaw_rates, 1e3 * got.clearance
    results = (
        f"{speed:+.3f} m/s and {yaw_rate:+.2f} of {wanted:.2g} rad/s, every foot lifted by {clearance:.0f} mm"
        for speed, yaw_rate, wanted, clearance in zip(*columns, strict=True)
    )
    return f"{what}: reached {'; '.join(results)}"


def measure_commands(gait: CommandedGait, commands: Floats) -> Achieved:
    """Return results of the gait for commands (N, 2 or 3) in m/s, rad/s and m/s to the left."""
    targets = lambda clock: gait.positions(np.full(len(commands), clock), commands)  # noqa: E731
    return measure(gait.robot, targets, len(commands), gait.angular_frequency, _TROT, draw_starts(gait.robot, 0))


def achieved_table(gait: CommandedGait) -> str:
    """Return a Markdown table of commanded and achieved velocities."""
    straight = [(speed, 0.0) for speed in (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5)]
    turning = [(speed, rate) for speed in (0.0, 0.3) for rate in (-0.6, -0.3, 0.3, 0.6)]
    moves_sideways = gait.lateral is not None
    sideways = [(0.0, 0.0, speed) for speed in (-0.15, 0.15)] if moves_sideways else []
    scale = Scale(gait.robot)
    wanted = np.array([(*command, 0.0) for command in straight + turning] + sideways)
    commands = np.round(wanted * [scale.velocity, scale.rate, scale.velocity], 2)
    commands = commands if moves_sideways else commands[:, :2]
    got = measure_commands(gait, commands)
    lines = [
        f"| command m/s, rad/s{', m/s to the left' if moves_sideways else ''} | forward m/s | yaw rate rad/s | "
        "sideways m/s | mechanical power W | least lift mm | touchdown error | fell |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for i, command in enumerate(commands.tolist()):
        lines.append(
            f"| {', '.join(f'{value:+}' for value in command)} | {got.forward_velocity[i]:+.3f} | "
            f"{got.yaw_rate[i]:+.3f} | {got.lateral_velocity[i]:+.3f} | {got.power[i]:.1f} | "
            f"{1e3 * got.clearance[i]:.0f} | {got.touchdown_error[i]:.2f} | {'yes' if got.fallen[i] else 'no'} |"
        )
    return "\n".join(lines)
