"""Definition of the suite `mq-eval`: its parts as data, its version, and its hash. docs/suite.md explains the measures.

All numbers are in SI units and for the built-in robot, slopes in degrees; `for_robot` scales them to another one. A
change of a number changes the hash. A change of a formula must change `VERSION`. Seeds are not part of the definition:
each run draws them, so that no policy can know the episodes that will be measured.
"""

import dataclasses
import functools
import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Final, Self

import numpy as np

from quadruped_env.control.control_config import VELOCITIES
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import COMMANDS, SIDEWAYS, Command, full_command
from quadruped_env.evaluation.measures import BOUNCE, SPEED_SHARE, SWING_SHARE, Tolerance
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of, scaled, steadiness
from quadruped_env.simulation.built_in_terrains import HIGHEST, STEEPEST, TERRAINS
from quadruped_env.simulation.terrain import TILE
from quadruped_env.task import PRESETS
from quadruped_env.utils.plain import plain
from quadruped_env.utils.seeds import EVALUATION_SEEDS

NAME: Final = "mq-eval"
VERSION: Final = 3

_SEEDS_PER_PART: Final = 10_000
SEEDS: Final = range(EVALUATION_SEEDS.start + 500_000, EVALUATION_SEEDS.stop - 10 * _SEEDS_PER_PART)
"""Seeds of the suite; the seeds before them belong to the other evaluations."""

RECTANGLE: Final[tuple[Command, Command]] = ((-0.3, -0.8), (0.6, 0.8))
"""Ranges of the commands that are drawn, as in the task; not in the hash."""
_STEPS: Final = {
    2: np.array([0.7548776662466927, 0.5698402909980532]),
    3: np.array([0.8191725133961644, 0.6710436067037892, 0.5497004779019702]),
}
"""Dimensions d -> steps of the sequence R_d: 1 / g, 1 / g^2, ... 1 / g^d, where g^(d + 1) = g + 1."""


def _steps(first: int, last: int, step: int, unit: float) -> tuple[float, ...]:
    """Return the multiples of `unit`: `first`, `first` + `step`, ... up to `last`, rounded to their decimal values."""
    return tuple(round(i * unit, 6) for i in range(first, last + 1, step))


@dataclass(frozen=True)
class Part:
    """Episodes of a part of the suite."""

    num_seeds: int
    """Episodes per condition."""
    first_seed: int = SEEDS.start
    """Seed of the first episode of every condition; each further episode has the next one. Not in the hash."""
    tolerance: Tolerance = field(default_factory=Tolerance)
    """Errors of the mean velocities, from which the accuracy of every part follows."""

    @property
    def seeds(self) -> range:
        """Seeds of the episodes of every condition."""
        return range(self.first_seed, self.first_seed + self.num_seeds)


@dataclass(frozen=True)
class CommandMap(Part):
    """Commands drawn over a rectangle, standing, and each direction alone up to beyond what the robot can do."""

    rectangle: tuple[Command, Command] = RECTANGLE
    points: int = 248
    """Commands that are drawn."""
    standing: int = 8
    """Commands to stand, besides."""
    smallest: Command = (0.1, 0.2)
    """A command below all of these is not drawn, m/s and rad/s."""
    axes: dict[str, tuple[Command, ...]] = field(
        default_factory=lambda: {
            "forwards": tuple((v, 0.0) for v in _steps(2, 18, 1, 0.05)),
            "backwards": tuple((-v, 0.0) for v in _steps(2, 10, 1, 0.05)),
            "left": tuple((0.0, w) for w in _steps(2, 16, 1, 0.1)),
            "right": tuple((0.0, -w) for w in _steps(2, 16, 1, 0.1)),
        }
    )
    """Commands in one direction alone, the smallest first, for the envelope."""
    seconds: float = 10.0

    @property
    def drawn(self) -> tuple[Command, ...]:
        """The commands that are drawn, and those to stand.

        Points of an additive sequence, which covers the rectangle evenly (Roberts 2018, The Unreasonable Effectiveness
        of Quasirandom Sequences), from a start that the seed gives.
        """
        low, high = np.array(self.rectangle)
        at = np.random.default_rng(self.first_seed).random(len(low))
        points: list[Command] = []
        while len(points) < self.points:
            at = (at + _STEPS[len(low)]) % 1.0
            command = tuple(round(float(value), 4) for value in low + at * (high - low))
            if (np.abs(command) >= self.smallest).any():
                points.append(command)
        return (*points, *((0.0,) * len(low),) * self.standing)


@dataclass(frozen=True)
class Disturbance:
    """Values of the config's section `randomization`, and an incline of the ground."""

    name: str
    randomization: dict[str, Any] = field(default_factory=dict)
    slope: float = 0.0
    """Angle of the ground, uphill at the start, degrees."""


@dataclass(frozen=True)
class Joystick(Part):
    """Commands that change at any time, as a person gives them."""

    rectangle: tuple[Command, Command] = RECTANGLE
    laws: tuple[Disturbance, ...] = field(
        default_factory=lambda: (Disturbance("undisturbed"), Disturbance("moderate", dict(PRESETS["moderate"])))
    )
    """Disturbances under which the episodes run."""
    seconds: float = 60.0
    held: tuple[float, float] = (0.5, 4.0)
    """Range of the time that a command is held, s."""
    shares: tuple[float, float, float] = (0.15, 0.15, 0.2)
    """Shares of the new commands that stand, reverse the one before, or are at the ends of the rectangle."""
    allowance: float = 0.5
    """Time after a change that does not count, s."""
    shortest: float = 0.25
    """Time after the allowance from which a held command counts, s: a stride."""
    window: float = 5.0
    """Length of the windows of the score, s."""
    halving: float = 10.0
    """Falls per hour that halve the score. In the hour of a law one fall costs a tenth, about the noise of the rest."""


@dataclass(frozen=True)
class GaitPart(Part):
    """Steady walking, for the measures of the gait."""

    commands: tuple[Command, ...] = tuple(command for command in COMMANDS if any(command))
    seconds: float = 15.0
    swing_share: float = SWING_SHARE
    """Share of a stride from which a time in the air is a swing; shorter ones are within a stance."""
    bounce: float = BOUNCE
    """Height over the ground from which a shorter time in the air is a bounce, m."""
    full_clearance: float = 0.01
    """Clearance from which the score is full, m."""
    soft_landing: float = 0.2
    """Speed of the soles at touchdown up to which the score is full, m/s."""
    little_slip: float = 0.05
    """Slip up to which the score is full, m/s."""
    speed_share: float = SPEED_SHARE
    """Share of a joint's velocity limit from which it counts as being at the limit."""


@dataclass(frozen=True)
class Change:
    """A step of the command."""

    name: str
    first: Command
    then: Command


@dataclass(frozen=True)
class Transients(Part):
    """Steps of the command."""

    changes: tuple[Change, ...] = (
        Change("step_up", (0.0, 0.0), (0.5, 0.0)),
        Change("emergency_stop", (0.5, 0.0), (0.0, 0.0)),
        Change("reversal", (0.3, 0.0), (-0.3, 0.0)),
        Change("diagonal", (0.1, 0.5), (0.5, -0.5)),
        Change("stand_to_turn", (0.0, 0.0), (0.0, 0.5)),
        Change("turn_reversal", (0.0, 0.5), (0.0, -0.5)),
        Change("stand_to_backward_curve", (0.0, 0.0), (-0.2, 0.5)),
        Change("walk_to_backward_curve", (0.5, 0.0), (-0.2, -0.5)),
        Change("turn_to_backward_curve", (0.0, 0.8), (-0.2, -0.5)),
        Change("curve_stop", (0.3, 0.5), (0.0, 0.0)),
    )
    before: float = 4.0
    """Time until the change, s."""
    after: float = 5.0
    """Time from the change to the end, s."""
    window: float = 0.6
    """Length of the centred moving mean over the velocities, about two strides, s."""
    final: float = 1.0
    """Time at the end whose mean is the final value, s."""
    band: float = 0.1
    """Half width of the band around the final value, relative to the commanded change; at least `tolerance.met`."""
    followed_share: float = 0.5
    """Share of the commanded change from which it was followed."""


@dataclass(frozen=True)
class Pushes(Part):
    """One push per episode: a velocity that is added to the base."""

    commands: tuple[Command, ...] = ((0.3, 0.0), (0.3, 0.5), (0.0, 0.5), (-0.2, 0.0), (0.0, 0.0))
    """Commands of the scored pushes."""
    sizes: tuple[float, ...] = (1.0, 2.0, 3.0)
    """Sizes of the scored pushes: factors on `unit`."""
    unit: tuple[float, ...] = (1.0, 1.0, 0.5, 2.0, 2.0, 2.0)
    """Factors on a direction drawn on the sphere in six dimensions: m/s in the world frame, rad/s in the body frame."""
    final: float = 2.0
    """Time at the end whose mean velocities count, s."""
    before: tuple[float, float] = (3.0, 4.0)
    """Range of the time until the push, s: it is drawn, so that it comes anywhere in a stride."""
    after: float = 4.0
    """Time from the latest push to the end, s."""


def _factors() -> tuple[Disturbance, ...]:
    """List the disturbances: friction, payload, encoder offsets, latencies and slopes, one at a time."""
    return (
        Disturbance("nominal"),
        *(Disturbance(f"friction_{mu:g}", {"friction": (mu, mu)}) for mu in (0.2, 0.3, 0.5, 0.8, 1.2)),
        *(Disturbance(f"payload_{kg:+g}_kg", {"payload": (kg, kg)}) for kg in (-0.5, 0.5, 1.0, 2.0)),
        *(Disturbance(f"encoder_offset_{offset:g}", {"encoder_offset": offset}) for offset in (0.02, 0.04)),
        *(Disturbance(f"latency_{ms:g}_ms", {"action_latency": (1e-3 * ms, 1e-3 * ms)}) for ms in (20, 40, 60, 80)),
        *(
            Disturbance(f"{way}_{angle:g}_degrees", {"start_heading": 0.0}, sign * angle)
            for angle in (4.0, 8.0, 12.0, 16.0)
            for way, sign in (("up", 1.0), ("down", -1.0))
        ),
    )


@dataclass(frozen=True)
class Regulation(Part):
    """Speed and yaw rate kept under one disturbance at a time, and under all of the preset `hard` together."""

    factors: tuple[Disturbance, ...] = field(default_factory=_factors)
    commands: tuple[Command, ...] = ((0.3, 0.0), (0.5, 0.0), (-0.2, 0.0), (0.0, 0.5), (0.3, 0.5))
    seconds: float = 8.0
    standing: float = 0.5
    """Time from the start until the command, s."""
    share: float = 0.2
    """Error up to which an episode keeps a velocity, relative to its command; `tolerance.met` where that is 0."""
    together: Disturbance = field(default_factory=lambda: Disturbance("hard", dict(PRESETS["hard"])))
    together_seeds: int = 32
    """Episodes per command with all disturbances together."""
    together_seconds: float = 20.0


@dataclass(frozen=True)
class TerrainPart(Part):
    """Crossings of tiles, level by level."""

    kinds: tuple[str, ...] = ("rough", "slope", "steps", "stairs", "gaps", "wave")
    levels: int = 10
    command: Command = (0.4, 0.0)
    seconds: float = 12.0
    """Time to leave the tile, s."""
    pass_share: float = 0.9
    """Share of crossings from which a level is passed."""
    worlds: int = 3
    """Number of worlds on each of which every crossing is tried; their seeds are `seeds`' first ones."""
    tile: float = TILE
    """Side length of a tile, m."""
    shapes: dict[str, Any] = field(
        default_factory=lambda: {
            "highest": HIGHEST,
            "steepest": STEEPEST,
            **{
                entry.name: {name: default for name, (_, default) in entry.parameters.items()}
                for entry in TERRAINS
                if entry.hardest
            },
        }
    )
    """Height in m and angle in rad of the hardest level, and the defaults of the terrains' parameters."""


@dataclass(frozen=True)
class Suite:
    """The suite: `full_suite` is the one to compare with, `quick_suite` shows whether a policy works.

    Two results are comparable only if name, version and hash are the same, and paired if the seed is, too.
    """

    quick: bool = False
    commands: CommandMap = CommandMap(2)
    joystick: Joystick = Joystick(64)
    gait: GaitPart = GaitPart(4)
    transients: Transients = Transients(16)
    pushes: Pushes = Pushes(16)
    regulation: Regulation = Regulation(4)
    terrain: TerrainPart = TerrainPart(16)

    @property
    def seed(self) -> int:
        """First seed of the first part: each further part begins 10,000 later."""
        return self.commands.first_seed

    def seeded(self, seed: int) -> Self:
        """Return the suite with other seeds.

        Raises:
            QuadrupedError: if the seed is not one of `SEEDS`.
        """
        if seed not in SEEDS:
            raise QuadrupedError(f"--seed: expected {SEEDS.start} to {SEEDS.stop - 1} for the suite; found {seed}")
        parts = [one.name for one in dataclasses.fields(self) if one.name != "quick"]
        first = {name: seed + i * _SEEDS_PER_PART for i, name in enumerate(parts)}
        return replace(self, **{name: replace(getattr(self, name), first_seed=first[name]) for name in parts})

    def to_dict(self) -> dict[str, Any]:
        """Return the definition as plain values, without the seeds."""
        values = dataclasses.asdict(self)
        del values["commands"]["rectangle"], values["joystick"]["rectangle"]
        for name in values.keys() - {"quick"}:
            del values[name]["first_seed"]
        return {"name": NAME, "version": VERSION, **plain(values)}

    @functools.cached_property
    def sha256(self) -> str:
        """SHA-256 of the definition as JSON with sorted keys and without spaces."""
        text = json.dumps(self.to_dict(), sort_keys=True, separators=(",", ":"), allow_nan=False)
        return hashlib.sha256(text.encode()).hexdigest()

    @property
    def identity(self) -> dict[str, Any]:
        """Name, version, whether it is the quick one, and hash, as stored in results."""
        return {"name": NAME, "version": VERSION, "quick": self.quick, "sha256": self.sha256}

    @property
    def label(self) -> str:
        """Name and version in words."""
        return f"{NAME} {VERSION}{' (quick)' if self.quick else ''}"


_COMMANDS: Final = ("rectangle", "axes", "command", "commands", "first", "then")
"""Fields that hold commands."""
_SIZES: Final = ("smallest", "met", "least", "missed")
"""Fields that hold a size of each velocity."""
_UNITS: Final[Mapping[str, str | tuple[str, ...]]] = {
    **dict.fromkeys((*_COMMANDS, *_SIZES), tuple(entry.unit for entry in VELOCITIES)),
    **dict.fromkeys(("soft_landing", "little_slip"), "m/s"),
    **dict.fromkeys(("bounce", "full_clearance"), "m"),
    "unit": ("m/s",) * 3 + ("rad/s",) * 3,
}
"""Units of the fields that follow the robot's size; pushes follow its steadiness, too. Disturbances and tiles do where
they are used; times are the same for all."""


def for_robot(suite: Suite, robot: Robot) -> Suite:
    """Scale the suite to a robot: commands, tolerances, pushes, and the heights and speeds of the scores."""

    def scale(field: str, value: Any) -> Any:
        unit, share = _UNITS.get(field), steadiness(robot) if field == "unit" else 1.0
        if isinstance(unit, tuple):
            return tuple(scaled(v, scale_of(u, robot) * share) for v, u in zip(value, unit, strict=False))
        return value if unit is None else scaled(value, scale_of(unit, robot))

    scaled_suite: Suite = _changed(suite, scale)
    return scaled_suite


def with_velocities(suite: Suite, robot: Robot) -> Suite:
    """Return the suite with lateral velocities for a robot that moves sideways; for another robot it stays as it is.

    The suite's own commands get a lateral velocity of 0, and further commands follow them. Where commands are drawn,
    the lateral velocity is drawn, too. It has the tolerances of the forward velocity.
    """
    if not robot.moves_sideways:
        return suite

    def widen(field: str, value: Any) -> Any:
        if field in _SIZES:
            return *value, value[0]
        return full_command(value, robot) if field in _COMMANDS else value

    wide: Suite = _changed(suite, widen)
    (low, high), lateral = suite.commands.rectangle, VELOCITIES[-1].range
    rectangle = (*low, lateral[0]), (*high, lateral[1])
    ways = {"sideways_left": 1.0, "sideways_right": -1.0}
    steps = _steps(2, 10, 1, 0.05)[1:3] if suite.quick else _steps(2, 10, 1, 0.05)
    axes = {name: tuple((0.0, 0.0, sign * v) for v in steps) for name, sign in ways.items()}
    stand, left, right, *_ = (0.0, 0.0, 0.0), *SIDEWAYS
    changes = (
        Change("step_left", stand, left),
        Change("sideways_reversal", left, right),
        Change("walk_to_sideways", (0.3, 0.0, 0.0), left),
    )
    return replace(
        wide,
        commands=replace(wide.commands, rectangle=rectangle, axes={**wide.commands.axes, **axes}),
        joystick=replace(wide.joystick, rectangle=rectangle),
        gait=replace(wide.gait, commands=(*wide.gait.commands, *(SIDEWAYS[:1] if suite.quick else SIDEWAYS))),
        transients=replace(wide.transients, changes=(*wide.transients.changes, *changes)),
        pushes=replace(wide.pushes, commands=(*wide.pushes.commands, left)),
        regulation=replace(wide.regulation, commands=(*wide.regulation.commands, left)),
    )


def _changed(value: Any, change: Callable[[str, Any], Any], field: str = "") -> Any:
    """Return a value with `change(field, v)` of every number, and every tuple of numbers or names, in its fields."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        values = {f.name: getattr(value, f.name) for f in dataclasses.fields(value)}
        return replace(value, **{name: _changed(v, change, name) for name, v in values.items()})
    if isinstance(value, dict):
        return {name: _changed(v, change, field) for name, v in value.items()}
    if isinstance(value, tuple) and not isinstance(value[0], float | int | str):
        return tuple(_changed(v, change, field) for v in value)
    return change(field, value)


def draw_seed() -> int:
    """Return a seed of the suite that nobody knows before."""
    return int(np.random.default_rng().integers(SEEDS.start, SEEDS.stop))


@functools.cache
def full_suite(seed: int = SEEDS.start) -> Suite:
    """Return version `VERSION` of the suite, with its first seed."""
    return Suite().seeded(seed)


@functools.cache
def quick_suite(seed: int = SEEDS.start) -> Suite:
    """Return the quick version: few conditions and episodes of every part, never comparable with the full one."""
    full = full_suite(seed)
    factors = {factor.name: factor for factor in full.regulation.factors}
    axes = {name: commands[1:3] for name, commands in full.commands.axes.items()}
    return Suite(
        quick=True,
        commands=replace(full.commands, num_seeds=1, points=15, standing=1, axes=axes, seconds=6.0),
        joystick=replace(full.joystick, num_seeds=4, seconds=15.0),
        gait=replace(full.gait, num_seeds=1, seconds=6.0, commands=((0.3, 0.0), (0.0, 0.5))),
        transients=replace(full.transients, num_seeds=1),
        pushes=replace(full.pushes, num_seeds=2, sizes=(1.0,)),
        regulation=replace(
            full.regulation,
            num_seeds=1,
            factors=tuple(
                factors[name] for name in ("nominal", "friction_0.3", "payload_+1_kg", "latency_60_ms", "up_8_degrees")
            ),
            together_seeds=1,
            together_seconds=8.0,
        ),
        terrain=replace(full.terrain, num_seeds=2, kinds=("rough", "steps"), levels=2, worlds=1),
    )
