"""Search for the parameters of the scripted gaits (CMA-ES), with many candidates in parallel.

A candidate is the sinusoids of a fore and of a hind leg: of each, hip amplitude and offset, the knee's cosine and sine
parts and its offset; and what turning changes in them, on both sides and between the sides. It is scored on flat
ground, from several starts: difference from the commanded velocities, feet that clear the ground in every stride and
touch it once per stride, sideways drift, tilt, motor power and sliding feet; joint limits and the 5 rad/s limit are
hard bounds of the search. The straight gait is searched first, and what turning changes on top of it. Method:
Hansen 2016, https://arxiv.org/abs/1604.00772, of the package cmaes.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError
from quadruped_env.gait import LEG_PHASES, CommandedGait, LegTable, turn_size
from quadruped_env.training.gait_styles import HIGH_STEPS, STYLES, Course, Judge, Style
from quadruped_env.training.gait_trial import ROBOT, Achieved, Start, measure, trials
from quadruped_env.utils.seeds import check_training_seeds

CANDIDATES: Final = 32
"""Of each generation, next to its mean."""

Log = Callable[[str], None]
"""Called with one line of text."""

# A candidate is an array (3, 2, 6): the straight gait, what a turn of size 1 rad/s adds on both sides, and what it adds
# on the right and subtracts on the left; of each for the fore and the hind legs; hip amplitude, hip offset, knee
# cosine, knee sine, knee offset.
_LOW: Final = np.array([-0.5, 0.1, -0.5, -0.5, -1.6, -0.5])
_HIGH: Final = np.array([0.5, 1.2, 0.5, 0.5, -0.4, 0.5])
_LARGEST_HIP: Final = 1.35
"""Largest hip angle that a leg asks for, rad: joints overshoot their targets, and the limit is 1.5."""
_STRAIGHT: Final = slice(0, 1)
"""Part of a candidate that the search of a straight gait varies."""
_TURN: Final = slice(1, 3)
"""Part of a candidate that the search of a turn varies."""
_STANCE_LEG: Final = (0.0, float(ROBOT.stance[0]), 0.0, 0.0, float(ROBOT.stance[1]), 0.0)
_STEPPING: Final = (0.1, 0.0, 0.15, -0.1, 0.0, 0.0)
"""A small step, added to the stance: the leg folds in its swing, and the shank swings forwards"""
_NO_TURN: Final = np.zeros((2, 2, 6))
_FASTER: Final = np.array([[-0.1, 0.0, 0.1, 0.0, 0.0, 0.35], [-0.35, 0.0, -0.3, 0.0, 0.0, 0.8]])
"""About what 1 m/s more changes"""
_SIDES: Final = np.array([-1.0, 1.0, -1.0, 1.0])


def _legs(candidates: NDArray[np.float64], size: NDArray[np.float64]) -> NDArray[np.float64]:
    """Columns of all legs (N, 4, 6) of candidates (N, 3, 2, 6) in turns of sizes (N,) in rad/s."""
    straight, turn, side = np.repeat(candidates, 2, axis=2).transpose(1, 0, 2, 3)
    size = size[:, None, None]
    found: NDArray[np.float64] = straight + np.abs(size) * turn + size * _SIDES[:, None] * side
    return found


def gait_targets(
    candidates: NDArray[np.float64],
    size: NDArray[np.float64],
    turns: tuple[float, ...],
) -> Callable[[float], NDArray[np.float64]]:
    """Joint targets over the gait clock in rad, for candidates (N, 3, 2, 6) in turns of sizes (N,), see `turn_size`.

    The fore legs of one side differ from those of the other only in phase and by the yaw rate, as do the hind legs.
    """
    phases = np.array(turns) * 2.0 * np.pi
    hip_sine, hip_offset, knee_cosine, knee_sine, knee_offset, hip_cosine = _legs(candidates, size).transpose(2, 0, 1)

    def targets(clock: float) -> NDArray[np.float64]:
        angle = clock + phases
        sine, cosine = np.sin(angle), np.cos(angle)
        target = np.empty((len(candidates), 8))
        target[:, 0::2] = hip_cosine * cosine + hip_sine * sine + hip_offset
        target[:, 1::2] = knee_cosine * cosine + knee_sine * sine + knee_offset
        return target

    return targets


def _limited(legs: NDArray[np.float64], angular_frequency: float) -> NDArray[np.float64]:
    """Columns of legs (..., 6) within their ranges, shrunk until no joint asks for more than its speed limit."""
    legs = np.clip(legs, _LOW, _HIGH)
    largest = 0.999 * ROBOT.velocity_limit.min() / angular_frequency
    for parts in ((0, 5), (2, 3)):
        amplitude = np.hypot(*(legs[..., part] for part in parts))
        legs[..., parts] *= np.minimum(1.0, largest / np.maximum(amplitude, 1e-9))[..., None]
    legs[..., 1] = np.minimum(legs[..., 1], _LARGEST_HIP - np.hypot(legs[..., 0], legs[..., 5]))
    return legs


def _within_limits(
    candidates: NDArray[np.float64], angular_frequency: float, largest_yaw_rate: float
) -> NDArray[np.float64]:
    """Candidates whose legs are within their limits straight ahead and, on both sides, at the largest yaw rate.

    They are so between the two as well: limits of ranges and amplitudes are convex.
    """
    straight = _limited(candidates[:, 0], angular_frequency)
    if largest_yaw_rate == 0.0:
        return np.concatenate([straight[:, None], candidates[:, 1:]], axis=1)
    turn, side = largest_yaw_rate * candidates[:, 1], largest_yaw_rate * candidates[:, 2]
    left = _limited(straight + turn - side, angular_frequency) - straight
    right = _limited(straight + turn + side, angular_frequency) - straight
    return np.stack([straight, (left + right) / (2.0 * largest_yaw_rate), (right - left) / (2.0 * largest_yaw_rate)], 1)


class Found(NamedTuple):
    """The best candidate of a search."""

    candidate: NDArray[np.float64]
    """(3, 2, 6)"""
    achieved: Achieved
    """Its results, one value per yaw rate of the search."""
    score: float
    """Larger is better"""


def search(
    speed: float,
    angular_frequency: float,
    turns: tuple[float, ...],
    start: NDArray[np.float64],
    spread: float,
    generations: int,
    seed: int = 0,
    yaw_rates: tuple[float, ...] = (0.0,),
    judge: Judge = HIGH_STEPS.judge,
    starts: Callable[[int], tuple[Start, ...]] | None = None,
) -> Found:
    """The best candidate for a forward speed (m/s): its straight gait, or what turning changes in the one of `start`.

    Scores from different starts do not compare. With new ones in each generation it is the mean of the last.

    Args:
        speed: target, m/s.
        angular_frequency: rad/s.
        turns: phase of each leg in cycles.
        start: initial candidate (3, 2, 6).
        spread: standard deviation of the first generation, as a share of each column's range; of what turning changes,
            at the largest yaw rate.
        generations: number of generations.
        seed: of the search.
        yaw_rates: targets, rad/s: 0 alone for the straight gait, or positive and increasing; turns to the right are
            their mirror images.
        judge: scores each trial.
        starts: of the trials, by the number of the generation: as many in each, with the same frictions and softness;
            None: always `STARTS`.

    Raises:
        MissingExtraError: if cmaes is not installed.
        QuadrupedError: if the seed is reserved for evaluation.
    """
    check_training_seeds("seed", seed)
    try:
        from cmaes import CMA
    except ImportError as error:
        raise MissingExtraError("The search of a gait", "train") from error
    count = CANDIDATES + 1
    simulation = trials(count * len(yaw_rates), starts(0) if starts else None)
    # All candidates at the first yaw rate, then all at the second.
    wanted, largest = np.repeat(yaw_rates, count), max(yaw_rates)
    sizes = turn_size(wanted, largest)
    varied = _TURN if largest else _STRAIGHT
    scale = np.broadcast_to((_HIGH - _LOW) / (largest or 1.0), start[varied].shape)
    strategy = CMA((start[varied] / scale).ravel(), spread, seed=seed, population_size=CANDIDATES)
    best = None
    for generation in range(generations):
        drawn = [strategy.ask() for _ in range(CANDIDATES)]
        candidates = np.tile(start, (count, 1, 1, 1))
        candidates[:, varied] = np.reshape([strategy.mean, *drawn], (count, *scale.shape)) * scale
        candidates = np.round(_within_limits(candidates, angular_frequency, largest), 4)
        targets = gait_targets(np.tile(candidates, (len(yaw_rates), 1, 1, 1)), sizes, turns)
        got = measure(targets, simulation, angular_frequency, turns, starts(generation) if starts else None)
        score = judge(got, speed, wanted).reshape(len(yaw_rates), count).mean(axis=0)
        strategy.tell([(values, -value) for values, value in zip(drawn, score[1:].tolist(), strict=True)])
        first = 0 if starts else int(np.argmax(score))
        if best is None or starts or score[first] > best.score:
            achieved = Achieved(**{name: part[first::count] for name, part in vars(got).items()})
            best = Found(candidates[first], achieved, float(score[first]))
    assert best is not None
    return best


def tune_commanded_gait(
    angular_frequency: float,
    yaw_rates: tuple[float, ...],
    generations: int,
    say: Log,
    style: Style = STYLES["tuned"],
    refined: CommandedGait | None = None,
) -> CommandedGait:
    """The tables of `CommandedGait` for the given yaw rates, rad/s, and the speeds of a style.

    Each search starts from the result of its neighbour, so that the tables are smooth: first the straight gaits of all
    speeds, then what turning changes in those for turning. The neighbour is the nearest of the speeds that were
    searched before, and of those in the tables of a gait that is to be refined. The other speeds turn as their nearest
    ones do.
    """
    known = {} if refined is None else candidates_of(refined)
    straight, reached = _straight_gaits(angular_frequency, generations, say, style.straight, known)
    turning = _turning_gaits(straight, reached, angular_frequency, yaw_rates, generations, say, style.turns, known)
    largest, table = max(yaw_rates), {}
    for speed, legs in straight.items():
        near = _nearest(speed, turning)
        whole = np.concatenate([[legs], turning[near]])
        # The turn of another speed, on top of this one's straight gait, may be beyond the limits.
        limited = _within_limits(whole[None], angular_frequency, largest)[0]
        table[reached[speed]] = whole if near == speed else limited
    return commanded_gait(table, angular_frequency, largest)


def _straight_gaits(
    angular_frequency: float,
    generations: int,
    say: Log,
    course: Course,
    known: Mapping[float, NDArray[np.float64]],
) -> tuple[dict[float, NDArray[np.float64]], dict[float, float]]:
    """The straight gaits (2, 6) of a course by its speeds, and the speeds that they reach, m/s."""
    straight: dict[float, NDArray[np.float64]] = {}
    reached: dict[float, float] = {}
    for speed in course.speeds:
        neighbours = {near: candidate[0] for near, candidate in known.items()} | straight
        near = _nearest(speed, neighbours) if neighbours else speed
        legs = neighbours.get(near, course.start) + (speed - near) * _FASTER
        found = search(
            speed,
            angular_frequency,
            LEG_PHASES["trot"],
            np.concatenate([[legs], _NO_TURN]),
            course.spread,
            generations + course.more_generations,
            judge=course.steps.judge,
            starts=course.starts,
        )
        say(_line(f"{speed:+.2f} m/s", found, (0.0,)))
        straight[speed] = found.candidate[0]
        # A few mm/s are missing after the search: the table has the speed that the gait reaches.
        reached[speed] = round(float(found.achieved.forward_velocity[0]), 3) if speed else 0.0
    return straight, reached


def _turning_gaits(
    straight: Mapping[float, NDArray[np.float64]],
    reached: Mapping[float, float],
    angular_frequency: float,
    yaw_rates: tuple[float, ...],
    generations: int,
    say: Log,
    course: Course,
    known: Mapping[float, NDArray[np.float64]],
) -> dict[float, NDArray[np.float64]]:
    """Changes (2, 2, 6) of the straight gaits in turns, by the speeds of a course."""
    turning: dict[float, NDArray[np.float64]] = {}
    for speed in course.speeds:
        neighbours = {near: candidate[1:] for near, candidate in known.items()} | turning
        changes = neighbours[_nearest(speed, neighbours)] if neighbours else course.start
        found = search(
            reached[speed],
            angular_frequency,
            LEG_PHASES["trot"],
            np.concatenate([[straight[speed]], changes]),
            course.spread,
            generations + course.more_generations,
            yaw_rates=yaw_rates,
            judge=course.steps.judge,
            starts=course.starts,
        )
        say(_line(f"{speed:+.2f} m/s in turns", found, yaw_rates))
        turning[speed] = found.candidate[1:]
    return turning


def _nearest(speed: float, others: Iterable[float]) -> float:
    """The nearest of other speeds, the first of several."""
    return min(others, key=lambda other: abs(other - speed))


def commanded_gait(
    table: Mapping[float, NDArray[np.float64]], angular_frequency: float, largest_yaw_rate: float
) -> CommandedGait:
    """The gait whose tables have a candidate (3, 2, 6) at each speed."""
    speeds = tuple(sorted(table))
    # Part, leg, column, speed.
    columns = np.round([table[speed] for speed in speeds], 4).transpose(1, 2, 3, 0)
    (fore, hind), (fore_turn, hind_turn), (fore_side, hind_side) = (
        [LegTable(*(tuple(column) for column in leg)) for leg in part] for part in columns.tolist()
    )
    return CommandedGait(
        angular_frequency, speeds, largest_yaw_rate, fore, hind, fore_turn, hind_turn, fore_side, hind_side
    )


def candidates_of(gait: CommandedGait) -> dict[float, NDArray[np.float64]]:
    """The candidates (3, 2, 6) in the tables of a gait, by speed in m/s: the inverse of `commanded_gait`."""
    parts = ((gait.fore, gait.hind), (gait.fore_turn, gait.hind_turn), (gait.fore_side, gait.hind_side))
    columns = np.array([[[getattr(leg, field.name) for field in fields(LegTable)] for leg in part] for part in parts])
    return dict(zip(gait.speeds, columns.transpose(3, 0, 1, 2), strict=True))


def _line(what: str, found: Found, yaw_rates: tuple[float, ...]) -> str:
    got = found.achieved
    results = (
        f"{speed:+.3f} m/s and {yaw_rate:+.2f} of {wanted:g} rad/s, every foot lifted by {1e3 * clearance:.0f} mm"
        for speed, yaw_rate, wanted, clearance in zip(
            got.forward_velocity, got.yaw_rate, yaw_rates, got.clearance, strict=True
        )
    )
    return f"{what}: reached {'; '.join(results)}"


def measure_commands(gait: CommandedGait, commands: NDArray[np.float64]) -> Achieved:
    """Results of the gait for commands (N, 2) in m/s and rad/s."""
    return measure(
        lambda clock: gait.positions(np.full(len(commands), clock), commands),
        trials(len(commands)),
        gait.angular_frequency,
        LEG_PHASES["trot"],
    )


def achieved_table(gait: CommandedGait) -> str:
    """A Markdown table of commanded and achieved velocities."""
    forward = [(v, 0.0) for v in (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5)]
    turning = [(v, w) for v in (0.0, 0.3) for w in (-0.6, -0.3, 0.3, 0.6)]
    commands = np.array(forward + turning)
    got = measure_commands(gait, commands)
    lines = [
        "| command m/s, rad/s | forward m/s | yaw rate rad/s | sideways m/s | mechanical power W | least lift mm | "
        "touchdown error | fell |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for i, (v, w) in enumerate(commands):
        lines.append(
            f"| {v:+.1f}, {w:+.1f} | {got.forward_velocity[i]:+.3f} | {got.yaw_rate[i]:+.3f} | "
            f"{got.lateral_velocity[i]:+.3f} | {got.power[i]:.1f} | {1e3 * got.clearance[i]:.0f} | "
            f"{got.touchdown_error[i]:.2f} | {'yes' if got.fallen[i] else 'no'} |"
        )
    return "\n".join(lines)


def tune_presets(generations: int, say: Log) -> dict[str, list[float]]:
    """Columns of fore and hind leg (10,) of each tuned preset, at the highest speed that it holds steadily."""
    tuned = {}
    leg = np.add(_STANCE_LEG, _STEPPING)
    start = np.concatenate([np.array([[leg, leg]]), _NO_TURN])
    for name, angular_frequency, speed in PRESET_SPEEDS:
        found = search(speed, angular_frequency, LEG_PHASES[name], start, 0.15, generations)
        say(_line(f"{name} at {angular_frequency} rad/s", found, (0.0,)))
        tuned[name] = np.round(found.candidate[0].ravel(), 3).tolist()
    return tuned


PRESET_SPEEDS: Final = (("trot", 14.0, 0.4), ("walk", 12.0, 0.25), ("bound", 14.0, 0.35), ("pace", 14.0, 0.3))
"""Name, angular frequency (rad/s) and wanted speed (m/s) of the presets."""
