"""Scripted gaits: joint positions as sinusoids of time or phase.

For each leg, with phase p of the joint and angular frequency w:

    hip  = hip_amplitude  * sin(w t + p) + hip_offset
    knee = knee_amplitude * cos(w t + p) + knee_offset

The ROS 2 tutorial has this form; its parameters are the preset `article`. `CommandedGait` adapts it to a
commanded forward velocity and yaw rate. Units: rad, rad/s, s.

The other presets are for the built-in robot. On another robot with a hip and a knee per leg, the feet make the same
motions about its stance, as nearly as sinusoids can, in proportion to the height of its stance; times and speeds are in
proportion to the square root of it.
"""

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gait_presets import (
    ARTICLE,
    COMMANDED,
    LEG_PHASES,
    PRESETS,
    SINUSOID,
    TUNED_FOR_ONE_SPEED,
    TUNED_ON,
    LegTable,
    sinusoid,
)
from quadruped_env.gait.waves import Waves, joint_phases, map_waves, wave_positions
from quadruped_env.robot.corners import corners, half_track
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.utils.arrays import Floats, frozen
from quadruped_env.utils.plain import plain

_HIPS: Final = slice(0, None, 2)
_KNEES: Final = slice(1, None, 2)

_TABLES: Final = ("fore", "hind", "fore_turn", "hind_turn", "fore_side", "hind_side")

_WHOLE_STEPS: Final = (0.05, 0.15)
"""Forward velocity (m/s) and yaw rate (rad/s) from which on the tuned robot takes whole steps."""


@dataclass(frozen=True)
class SinusoidalGait:
    """An open-loop gait of one sinusoid per joint.

    Args:
        hip_amplitude, knee_amplitude: amplitudes, one number or one per leg, rad.
        hip_offset, knee_offset: offsets, one number or one per leg, rad.
        angular_frequency: angular frequency, rad/s.
        phases: phase of each joint (J,), rad.
        robot: robot with a hip and a knee per leg, whose limits apply.
    """

    hip_amplitude: float | tuple[float, ...]
    hip_offset: float | tuple[float, ...]
    knee_amplitude: float | tuple[float, ...]
    knee_offset: float | tuple[float, ...]
    angular_frequency: float
    phases: tuple[float, ...]
    robot: Robot = MINI_QUADRUPED
    _amplitude: Floats = field(init=False, repr=False, compare=False)
    _offset: Floats = field(init=False, repr=False, compare=False)
    _phases: Floats = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        num_joints, num_legs = self.robot.num_joints, self.robot.num_legs
        if len(self.phases) != num_joints:
            raise QuadrupedError(
                f"SinusoidalGait: phases must have {num_joints} values, one per joint; found {len(self.phases)}"
            )
        for name in ("hip_amplitude", "hip_offset", "knee_amplitude", "knee_offset"):
            if np.shape(getattr(self, name)) not in ((), (num_legs,)):
                raise QuadrupedError(f"SinusoidalGait: {name} must be one number or {num_legs}, one per leg")
        amplitude, offset = np.empty(num_joints), np.empty(num_joints)
        amplitude[_HIPS], amplitude[_KNEES] = self.hip_amplitude, self.knee_amplitude
        offset[_HIPS], offset[_KNEES] = self.hip_offset, self.knee_offset
        values = np.concatenate([amplitude, offset, self.phases, [self.angular_frequency]])
        if not np.isfinite(values).all():
            raise QuadrupedError("SinusoidalGait: every parameter must be finite; found NaN or infinity")
        object.__setattr__(self, "_amplitude", amplitude)
        object.__setattr__(self, "_offset", offset)
        object.__setattr__(self, "_phases", np.array(self.phases, dtype=np.float64))

    @classmethod
    def preset(cls, name: str, robot: Robot = MINI_QUADRUPED) -> "SinusoidalGait":
        """A gait by name: `article` as published, or one tuned for the built-in robot and mapped to another.

        `sinusoid`, `tuned`, `crouched`, `low` and `fast` are the gaits of `CommandedGait` at 0.4 m/s straight ahead.

        Raises:
            QuadrupedError: if there is no such preset, or the scripted gaits do not fit the robot.
        """
        if name in COMMANDED:
            return CommandedGait.preset(name, robot).straight_ahead
        if name not in _PRESETS:
            raise QuadrupedError(
                f"SinusoidalGait.preset: unknown preset {name!r}; valid names are {', '.join(PRESETS)}"
            )
        if robot == TUNED_ON:
            return _PRESETS[name]
        return _published(robot) if name == "article" else _mapped(_PRESETS[name], robot)

    def parameters(self) -> dict[str, Any]:
        """The numbers of the gait as plain values for JSON."""
        names = ("hip_amplitude", "hip_offset", "knee_amplitude", "knee_offset", "angular_frequency", "phases")
        return {name: plain(getattr(self, name)) for name in names}

    def positions(self, t: ArrayLike) -> Floats:
        """Joint positions (..., J) in rad at times t (...,) in s."""
        angle = self._angle(t)
        wave = np.empty_like(angle)
        wave[..., _HIPS] = np.sin(angle[..., _HIPS])
        wave[..., _KNEES] = np.cos(angle[..., _KNEES])
        return self._amplitude * wave + self._offset

    def velocities(self, t: ArrayLike) -> Floats:
        """Joint velocities (..., J) in rad/s at times t (...,) in s: the derivative of `positions`."""
        angle = self._angle(t)
        wave = np.empty_like(angle)
        wave[..., _HIPS] = np.cos(angle[..., _HIPS])
        wave[..., _KNEES] = -np.sin(angle[..., _KNEES])
        return self.angular_frequency * self._amplitude * wave

    def _angle(self, t: ArrayLike) -> Floats:
        time = np.asarray(t, dtype=np.float64)
        return self.angular_frequency * time[..., None] + self._phases

    @property
    def period(self) -> float:
        """Duration of one cycle, s."""
        return math.tau / abs(self.angular_frequency) if self.angular_frequency else math.inf

    def violations(self) -> list[str]:
        """Messages about position and velocity limits that the gait exceeds; empty if there are none."""
        amplitude, offset = np.abs(self._amplitude), self._offset
        speed = abs(self.angular_frequency) * amplitude
        return limit_violations(self.robot, offset - amplitude, offset + amplitude, speed)


def limit_violations(robot: Robot, low: Floats, high: Floats, speed: Floats, tolerance: float = 1e-9) -> list[str]:
    """Messages about the limits that a motion of the joints exceeds.

    Args:
        robot: the robot.
        low: lowest position of each joint, rad (J,).
        high: highest position of each joint, rad (J,).
        speed: highest speed of each joint, rad/s (J,).
        tolerance: excess that counts as none, rad and rad/s.
    """
    found = []
    for i, joint in enumerate(robot.joint_names):
        lower, upper = robot.joint_position_low[i], robot.joint_position_high[i]
        if low[i] < lower - tolerance or high[i] > upper + tolerance:
            found.append(f"{joint}: {low[i]:.3f} to {high[i]:.3f} rad is outside {lower:g} to {upper:g} rad")
        if speed[i] > robot.velocity_limit[i] + tolerance:
            found.append(f"{joint}: {speed[i]:.3f} rad/s is over {robot.velocity_limit[i]:g} rad/s")
    return found


def _published(robot: Robot) -> SinusoidalGait:
    """The gait `article` on another robot: each corner's leg keeps its angles and phases."""
    article = _PRESETS["article"]
    phases = np.array(article.phases).reshape(4, 2)[list(corners(robot))]
    return replace(article, phases=tuple(phases.ravel().tolist()), robot=robot)


def _mapped(gait: SinusoidalGait, robot: Robot) -> SinusoidalGait:
    """A gait of the tuned robot on another one, with the same motions of the feet."""
    legs = list(corners(robot))
    hip_amplitude, hip_offset, knee_amplitude, knee_offset = (
        np.broadcast_to(value, 4)[legs]
        for value in (gait.hip_amplitude, gait.hip_offset, gait.knee_amplitude, gait.knee_offset)
    )
    phases = np.array(gait.phases).reshape(4, 2)[legs]
    lag = phases[:, 1] - phases[:, 0]
    waves = (
        np.stack([hip_amplitude, -knee_amplitude * np.sin(lag)], axis=1).ravel(),
        np.stack([np.zeros(4), knee_amplitude * np.cos(lag)], axis=1).ravel(),
        np.stack([hip_offset, knee_offset], axis=1).ravel(),
    )
    mapped = map_waves(robot, *waves)
    frequency = gait.angular_frequency / scale_of("m/s", robot)
    return _sinusoids(robot, frequency, np.repeat(phases[:, 0], 2), *mapped)


def _sinusoids(
    robot: Robot, angular_frequency: float, phases: Floats, sine: Floats, cosine: Floats, offset: Floats
) -> SinusoidalGait:
    """A gait from sine and cosine parts and offsets of all joints (J,) at the phases of their legs (J,)."""
    hip_sine, hip_cosine, knee_sine, knee_cosine = sine[_HIPS], cosine[_HIPS], sine[_KNEES], cosine[_KNEES]
    plain = hip_cosine == 0.0
    phases = phases.copy()
    phases[_HIPS] += np.where(plain, 0.0, np.arctan2(hip_cosine, hip_sine))
    phases[_KNEES] += np.arctan2(-knee_sine, knee_cosine)
    return SinusoidalGait(
        hip_amplitude=tuple(np.where(plain, hip_sine, np.hypot(hip_sine, hip_cosine)).tolist()),
        hip_offset=tuple(offset[_HIPS].tolist()),
        knee_amplitude=tuple(np.hypot(cosine, sine)[_KNEES].tolist()),
        knee_offset=tuple(offset[_KNEES].tolist()),
        angular_frequency=angular_frequency,
        phases=tuple(phases.tolist()),
        robot=robot,
    )


def _tuned_for_one_speed(name: str) -> SinusoidalGait:
    """A preset on the robot for which it was tuned."""
    angular_frequency, fore, hind = TUNED_FOR_ONE_SPEED[name]
    legs = (fore, fore, hind, hind)
    sine = np.array([part for leg in legs for part in (leg.hip_sine, leg.knee_sine)])
    cosine = np.array([part for leg in legs for part in (leg.hip_cosine, leg.knee_cosine)])
    offset = np.array([part for leg in legs for part in (leg.hip_offset, leg.knee_offset)])
    phases = math.tau * np.repeat(LEG_PHASES[name], 2)
    return _sinusoids(TUNED_ON, angular_frequency, phases, sine, cosine, offset)


_PRESETS: Final = {
    "article": SinusoidalGait(**ARTICLE, robot=TUNED_ON),
    **{name: _tuned_for_one_speed(name) for name in TUNED_FOR_ONE_SPEED},
}


def turn_size(yaw_rate: Floats, largest: float) -> Floats:
    """Size of a turn for yaw rates of any shape: sign(w) sqrt(|w| largest), at most the largest, rad/s.

    The yaw rate that the robot reaches grows with the square of the difference between its sides: small differences
    are lost in the feet's sliding.
    """
    return np.copysign(np.sqrt(np.minimum(np.abs(yaw_rate), largest) * largest), yaw_rate)


@dataclass(frozen=True)
class CommandedGait:
    """The sinusoidal trot as a function of a commanded forward velocity and yaw rate.

    The parameters of a leg are interpolated in tables over forward velocity, one for the fore and one for the hind
    legs. To the straight gait's parameters a yaw rate adds |r| times the columns of `turn` on all legs, and r times the
    columns of `side` on the right, which it subtracts on the left; r is the yaw rate's `turn_size`. Towards a command
    of zero the gait fades into the stance.

    Args:
        angular_frequency: angular frequency, rad/s.
        speeds: forward velocities of the tables (K,), increasing, m/s.
        largest_yaw_rate: yaw rate up to which the columns for turning hold, rad/s; for a larger one it is used.
        fore, hind: tables of the straight gait, for the fore and the hind legs.
        fore_turn, hind_turn: what a turn of either sign adds, per rad/s of its size.
        fore_side, hind_side: what a turn adds on the right and subtracts on the left, per rad/s of its size.
        robot: robot that walks.
        native: True if the tables are joint angles of that robot; else they are of the robot on which the presets were
            tuned, and are mapped.
    """

    angular_frequency: float
    speeds: Sequence[float]
    largest_yaw_rate: float
    fore: LegTable
    hind: LegTable
    fore_turn: LegTable
    hind_turn: LegTable
    fore_side: LegTable
    hind_side: LegTable
    robot: Robot = MINI_QUADRUPED
    native: bool = False
    _phases: Floats = field(init=False, repr=False, compare=False)
    _tables: Floats = field(init=False, repr=False, compare=False)
    """The nine waves below side by side, (K, 9 J)."""
    straight: Waves = field(init=False, repr=False, compare=False)
    """Waves of all joints at the speeds without a yaw rate, (K, J) each."""
    turn: Waves = field(init=False, repr=False, compare=False)
    """Change of the waves in a turn of either sign, per rad/s of its size, (K, J) each."""
    side: Waves = field(init=False, repr=False, compare=False)
    """Change of the waves times the signed size of the turn, per rad/s, (K, J) each."""

    def __post_init__(self) -> None:
        legs = corners(self.robot)
        straight = self._waves_of(self.fore, self.hind, legs)
        turn = self._waves_of(self.fore_turn, self.hind_turn, legs)
        side = self._waves_of(self.fore_side, self.hind_side, legs)
        if not self.native and self.robot != TUNED_ON:
            straight, turn, side = self._mapped(straight, turn, side)
        right = np.repeat([(-1.0, 1.0)[corner % 2] for corner in legs], 2)
        for name, waves in (("straight", straight), ("turn", turn), ("side", side * right)):
            object.__setattr__(self, name, tuple(waves))
        tables = np.concatenate([*straight, *turn, *(side * right)], axis=1)
        object.__setattr__(self, "_tables", frozen(tables))
        object.__setattr__(self, "_phases", joint_phases(self.robot))

    def _mapped(self, straight: Floats, turn: Floats, side: Floats) -> tuple[Floats, Floats, Floats]:
        """Waves of the tuned robot (3, K, J), of the sides those on the right, mapped to the gait's robot.

        Every leg is mapped as one on the outer and as one on the inner side of the largest turn, so that a turn to the
        right is the mirror image of one to the left.
        """
        # A wider robot's feet are moved farther by the same yaw rate.
        width = half_track(self.robot) / half_track(TUNED_ON) / scale_of("m", self.robot)
        largest = self.largest_yaw_rate * scale_of("m/s", self.robot)  # of the tuned robot
        ahead, outer, inner = (
            np.array(map_waves(self.robot, *(straight + width * largest * change)))
            for change in (0.0 * turn, turn + side, turn - side)
        )
        return (
            ahead,
            (0.5 * (outer + inner) - ahead) / self.largest_yaw_rate,
            0.5 * (outer - inner) / self.largest_yaw_rate,
        )

    def _waves_of(self, fore: LegTable, hind: LegTable, legs: tuple[int, ...]) -> Floats:
        """Sine part, cosine part and offset of all joints at all speeds (3, K, J), rad, of the tuned robot."""
        waves = np.zeros((3, len(self.speeds), 2 * len(legs)))
        for leg, corner in enumerate(legs):
            table = fore if corner < 2 else hind
            waves[:, :, 2 * leg] = table.hip_sine, table.hip_cosine, table.hip_offset
            waves[:, :, 2 * leg + 1] = table.knee_sine, table.knee_cosine, table.knee_offset
        return waves

    @classmethod
    def preset(cls, name: str, robot: Robot = MINI_QUADRUPED) -> "CommandedGait":
        """A gait by name: the robot's own of `Robot.gaits`, or else the preset, mapped to it.

        `sinusoid` is the trot in closed form, `tuned`, `crouched`, `low` and `fast` were found by searches.

        Raises:
            QuadrupedError: if there is no such preset, the robot's own is not valid, or the scripted gaits do not fit
                the robot.
        """
        if name not in COMMANDED:
            raise QuadrupedError(
                f"CommandedGait.preset: {name!r} follows no command; those that do are {', '.join(COMMANDED)}"
            )
        return _commanded(name, robot)

    @classmethod
    def sinusoid(cls, robot: Robot, frequency: float) -> "CommandedGait":
        """The trot in closed form, with the strides of a gait clock.

        Args:
            robot: robot that walks.
            frequency: frequency of its clock, Hz.

        Raises:
            QuadrupedError: if the scripted gaits do not fit the robot.
        """
        return _sinusoid(robot, frequency)

    @classmethod
    def tuned(cls, robot: Robot = MINI_QUADRUPED) -> "CommandedGait":
        """The preset `tuned`, mapped to a robot.

        Raises:
            QuadrupedError: if the scripted gaits do not fit the robot.
        """
        return cls.preset("tuned", robot)

    def parameters(self) -> dict[str, Any]:
        """The numbers of the gait as plain values for JSON."""
        return {
            "angular_frequency": self.angular_frequency,
            "speeds": plain(self.speeds),
            "largest_yaw_rate": self.largest_yaw_rate,
            **{name: plain(getattr(self, name)) for name in _TABLES},
        }

    def waves(self, command: Floats) -> Waves:
        """Sine part, cosine part and offset of every joint (N, J) in rad, for commands (N, 2) in m/s and rad/s."""
        size = turn_size(command[:, 1], self.largest_yaw_rate)[:, None]
        row = np.interp(command[:, 0], self.speeds, np.arange(len(self.speeds)))
        below = np.minimum(row.astype(np.int64), len(self.speeds) - 2)[:, None]
        low, high = (np.take_along_axis(self._tables, index, axis=0) for index in (below, below + 1))
        straight, turn, side = np.split(low + (row[:, None] - below) * (high - low), 3, axis=1)
        sine, cosine, offset = np.split(straight + np.abs(size) * turn + size * side, 3, axis=1)
        fade, stance = self.fade(command)[:, None], self.robot.stance
        return fade * sine, fade * cosine, stance + fade * (offset - stance)

    @property
    def whole_steps(self) -> tuple[float, float]:
        """Forward velocity (m/s) and yaw rate (rad/s) from which on a command is followed with whole steps."""
        root = scale_of("m/s", self.robot)
        return _WHOLE_STEPS[0] * root, _WHOLE_STEPS[1] / root

    def fade(self, command: Floats) -> Floats:
        """Size of the steps (N,), 0 for a command of zero and 1 for one that is worth whole steps."""
        forward, turning = self.whole_steps
        return np.minimum(1.0, np.maximum(np.abs(command[:, 0]) / forward, np.abs(command[:, 1]) / turning))

    def positions(self, phase: ArrayLike, command: ArrayLike) -> Floats:
        """Joint positions (N, J) in rad at gait phases (N,) in rad, for commands (N, 2)."""
        waves = self.waves(np.asarray(command, dtype=np.float64))
        return wave_positions(np.asarray(phase, dtype=np.float64), self._phases, *waves)

    @property
    def straight_ahead(self) -> SinusoidalGait:
        """The sinusoidal gait straight ahead at 0.4 m/s, in proportion to the robot's size."""
        return self.at((0.4 * scale_of("m/s", self.robot), 0.0))

    def at(self, command: Sequence[float]) -> SinusoidalGait:
        """The sinusoidal gait for one command."""
        sine, cosine, offset = (values[0] for values in self.waves(np.array([command])))
        return _sinusoids(self.robot, self.angular_frequency, self._phases, sine, cosine, offset)


@functools.cache
def _commanded(name: str, robot: Robot) -> CommandedGait:
    gaits = robot.gaits or {}
    if unknown := set(gaits) - set(COMMANDED):
        raise QuadrupedError(
            f"robot {robot.name!r}: gaits has {', '.join(map(repr, sorted(unknown)))}; it may replace "
            f"{', '.join(COMMANDED)}"
        )
    if name not in gaits:
        return _from_numbers(COMMANDED[name], robot)
    try:
        return _from_numbers(gaits[name], robot, native=True)
    except (TypeError, KeyError, ValueError) as error:
        raise QuadrupedError(
            f"robot {robot.name!r}: gaits[{name!r}] must be what tools/tune_gait.py writes under {name!r} ({error})"
        ) from error


@functools.cache
def _sinusoid(robot: Robot, frequency: float) -> CommandedGait:
    if SINUSOID in (robot.gaits or {}):
        return _commanded(SINUSOID, robot)
    return _from_numbers(sinusoid(frequency * scale_of("m/s", robot)), robot)


def _from_numbers(numbers: Mapping[str, Any], robot: Robot, native: bool = False) -> CommandedGait:
    tables = {table: LegTable(**numbers[table]) for table in _TABLES}
    if not native:
        root = scale_of("m/s", robot)
        numbers = {
            **numbers,
            "angular_frequency": numbers["angular_frequency"] / root,
            "speeds": tuple(speed * root for speed in numbers["speeds"]),
            "largest_yaw_rate": numbers["largest_yaw_rate"] / root,
        }
    return CommandedGait(**{**numbers, **tables}, robot=robot, native=native)
