"""Definition of the suite `mq-eval`: its parts as data, its version, and its hash. docs/suite.md explains the measures.

All numbers are in SI units, angles of directions and tilts in degrees. A change of a number changes the hash. A change
of a formula must change `VERSION`.
"""

import dataclasses
import functools
import hashlib
import json
from dataclasses import dataclass, field, replace
from typing import Any, Final

from quadruped_env.simulation.built_in_terrains import HIGHEST, STEEPEST, TERRAINS
from quadruped_env.simulation.terrain import TILE
from quadruped_env.task import PRESETS
from quadruped_env.utils.plain import plain
from quadruped_env.utils.seeds import EVALUATION_SEEDS

NAME: Final = "mq-eval"
VERSION: Final = 1

Command = tuple[float, float]
"""Forward velocity in m/s and yaw rate in rad/s."""

_FIRST_SEED: Final = EVALUATION_SEEDS.start + 500_000
"""First seed of the suite; the seeds before it are those of the other evaluations."""
_SEEDS_PER_PART: Final = 10_000


def _steps(first: int, last: int, step: int, unit: float) -> tuple[float, ...]:
    """Multiples of `unit`: `first`, `first` + `step`, ... up to `last`, rounded to their decimal values."""
    return tuple(round(i * unit, 6) for i in range(first, last + 1, step))


@dataclass(frozen=True)
class Part:
    """Episodes of a part of the suite."""

    num_seeds: int
    """Episodes per condition."""
    first_seed: int
    """Seed of the first episode of every condition; each further episode has the next one."""

    @property
    def seeds(self) -> range:
        """Seeds of the episodes of every condition."""
        return range(self.first_seed, self.first_seed + self.num_seeds)


@dataclass(frozen=True)
class CommandMap(Part):
    """Every command of a rectangle."""

    forward_velocity: tuple[float, ...] = _steps(-6, 12, 1, 0.05)
    """Forward velocities, m/s."""
    yaw_rate: tuple[float, ...] = _steps(-8, 8, 1, 0.1)
    """Yaw rates, rad/s."""
    seconds: float = 10.0
    tolerance: tuple[float, float] = (0.05, 0.1)
    """Errors of the mean velocities up to which an episode meets its command, m/s and rad/s."""
    dead_share: float = 0.5
    """Share of a command below which it is in the dead zone."""

    @property
    def commands(self) -> tuple[Command, ...]:
        """All commands, the yaw rates of the first forward velocity first."""
        return tuple((v, w) for v in self.forward_velocity for w in self.yaw_rate)


@dataclass(frozen=True)
class GaitPart(Part):
    """Steady walking, for the measures of the gait."""

    commands: tuple[Command, ...] = (
        (0.1, 0.0),
        (0.2, 0.0),
        (0.3, 0.0),
        (0.4, 0.0),
        (0.5, 0.0),
        (-0.2, 0.0),
        (0.0, 0.5),
        (0.0, -0.5),
        (0.3, 0.5),
        (0.3, -0.5),
    )
    seconds: float = 20.0
    shortest_swing: float = 0.05
    """Time in the air from which a foot has swung; shorter times are bounces, s."""
    full_clearance: float = 0.01
    """Clearance from which the score is full, m."""
    speed_share: float = 0.95
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
    )
    before: float = 4.0
    """Time until the change, s."""
    after: float = 5.0
    """Time from the change to the end, s."""
    window: float = 0.5
    """Length of the centred moving mean over the velocities, s."""
    final: float = 1.0
    """Time at the end whose mean is the final value, s."""
    band: float = 0.1
    """Half width of the band around the final value, relative to the commanded change."""
    narrowest: tuple[float, float] = (0.05, 0.1)
    """Least half width of the band, m/s and rad/s."""
    followed_share: float = 0.5
    """Share of the commanded change from which it was followed."""


@dataclass(frozen=True)
class Pushes(Part):
    """One push per episode: a velocity that is added to the base of a walking robot."""

    sizes: tuple[float, ...] = _steps(0, 10, 1, 0.2)
    """Velocities, m/s."""
    directions: tuple[float, ...] = _steps(0, 315, 45, 1.0)
    """Directions relative to the heading, degrees: 0 forwards, 90 to the left."""
    command: Command = (0.3, 0.0)
    before: float = 3.0
    """Time until the push, s."""
    after: float = 4.0
    """Time from the push to the end, s."""


@dataclass(frozen=True)
class Factor:
    """One disturbance: values of the config's section `randomization`."""

    name: str
    randomization: dict[str, Any]


def _factors() -> tuple[Factor, ...]:
    """Each quantity of the preset `hard` alone, at the ends of its range if it has two that count."""
    hard = PRESETS["hard"]

    def at(name: str, value: float, **others: Any) -> Factor:
        return Factor(name, {name.removesuffix("_low").removesuffix("_high"): (value, value), **others})

    def alone(name: str) -> Factor:
        return Factor(name, {name: hard[name]})

    ends = ("friction", "payload", "supply_voltage", "motor_strength", "position_gain", "velocity_gain")
    return (
        *(at(f"{name}_{end}", hard[name][i]) for name in ends for i, end in enumerate(("low", "high"))),
        *(at(name, hard[name][1]) for name in ("joint_damping", "rotor_inertia")),
        *(at(name, hard[name][1]) for name in ("action_latency", "observation_latency")),
        *(alone(name) for name in ("link_mass", "link_inertia", "base_com", "encoder_offset", "imu_mounting")),
        alone("observation_noise"),
        alone("push_force"),
        Factor("push_speed", {name: hard[name] for name in ("push_speed", "push_interval")}),
    )


@dataclass(frozen=True)
class Disturbances(Part):
    """Disturbances, one at a time, and then all of the preset `hard` together."""

    factors: tuple[Factor, ...] = field(default_factory=_factors)
    together: Factor = field(default_factory=lambda: Factor("hard", dict(PRESETS["hard"])))
    commands: tuple[Command, ...] = ((0.3, 0.0), (0.5, 0.0), (-0.2, 0.0), (0.0, 0.5))
    seconds: float = 10.0
    together_seeds: int = 64
    """Episodes per command with all disturbances together."""
    together_seconds: float = 20.0
    tolerance: tuple[float, float] = (0.1, 0.2)
    """Errors of the mean velocities up to which an episode holds its command, m/s and rad/s."""


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
    terrain_seed: int = _FIRST_SEED
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
class Release:
    """A start of a recovery: a limp robot that is released above the ground."""

    name: str
    height: float
    """Height of the centre of the base over the ground, m; in the stance of the built-in robot it is 0.184 m."""
    tilt: float
    """Angle between the base's up axis and the world's, about a random horizontal axis, degrees."""
    random_joints: bool
    """True for joint positions uniform in their ranges; False for the stance."""


@dataclass(frozen=True)
class Recovery(Part):
    """Limp robots that are released, fall, and are stood up by the live controller."""

    releases: tuple[Release, ...] = (
        Release("drop_10cm", 0.284, 0.0, False),
        Release("drop_30cm", 0.484, 0.0, False),
        Release("collapse", 0.3, 0.0, True),
        Release("tilt_30", 0.3, 30.0, True),
        Release("tilt_60", 0.3, 60.0, True),
        Release("side", 0.3, 90.0, True),
        Release("back", 0.3, 180.0, True),
    )
    limp_seconds: float = 2.0
    """Time until the live controller is started, s."""
    seconds: float = 20.0
    """Time from then on, s."""
    command: Command = (0.3, 0.0)
    """Command from the moment when the controller stands, m/s and rad/s."""
    walk_seconds: float = 3.0
    """Time on its feet under the command after which the robot has recovered, s."""


@dataclass(frozen=True)
class Suite:
    """The suite: `full_suite` is the one to compare with, `quick_suite` shows whether a policy works.

    Two results are comparable only if name, version and hash are the same.
    """

    quick: bool = False
    commands: CommandMap = CommandMap(4, _FIRST_SEED)
    gait: GaitPart = GaitPart(8, _FIRST_SEED + _SEEDS_PER_PART)
    transients: Transients = Transients(32, _FIRST_SEED + 2 * _SEEDS_PER_PART)
    pushes: Pushes = Pushes(16, _FIRST_SEED + 3 * _SEEDS_PER_PART)
    disturbances: Disturbances = Disturbances(12, _FIRST_SEED + 4 * _SEEDS_PER_PART)
    terrain: TerrainPart = TerrainPart(100, _FIRST_SEED + 5 * _SEEDS_PER_PART)
    recovery: Recovery = Recovery(12, _FIRST_SEED + 6 * _SEEDS_PER_PART)

    def to_dict(self) -> dict[str, Any]:
        """The definition as plain values."""
        return {"name": NAME, "version": VERSION, **plain(dataclasses.asdict(self))}

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


@functools.cache
def full_suite() -> Suite:
    """Version `VERSION` of the suite."""
    return Suite()


@functools.cache
def quick_suite() -> Suite:
    """The quick version: few conditions and episodes of every part, never comparable with the full one."""
    full = full_suite()
    factors = {factor.name: factor for factor in full.disturbances.factors}
    return Suite(
        quick=True,
        commands=replace(full.commands, num_seeds=1, forward_velocity=(-0.3, 0.0, 0.3, 0.6), yaw_rate=(-0.8, 0.0, 0.8)),
        gait=replace(full.gait, num_seeds=1, seconds=6.0, commands=((0.3, 0.0), (0.0, 0.5))),
        transients=replace(full.transients, num_seeds=2),
        pushes=replace(full.pushes, num_seeds=2, sizes=(0.0, 0.6, 1.2), directions=(0.0, 90.0, 180.0, 270.0)),
        disturbances=replace(
            full.disturbances,
            num_seeds=2,
            commands=((0.3, 0.0),),
            factors=(factors["friction_low"], factors["action_latency"]),
            seconds=6.0,
            together_seeds=2,
            together_seconds=6.0,
        ),
        terrain=replace(full.terrain, num_seeds=2, kinds=("rough", "steps"), levels=2),
        recovery=replace(full.recovery, num_seeds=1, releases=(full.recovery.releases[0],)),
    )
