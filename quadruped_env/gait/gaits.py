"""Scripted gaits: joint positions as sinusoids of time or phase.

For each leg, with phase p of the joint and angular frequency w:

    hip  = hip_amplitude  * sin(w t + p) + hip_offset
    knee = knee_amplitude * cos(w t + p) + knee_offset

The ROS 2 tutorial has this form; its parameters are the preset `article`. `CommandedGait` adapts it to a
commanded forward velocity and yaw rate. Units: rad, rad/s, s.

A hip is every joint of a leg but the last one, which is a knee.

The other presets were found or derived for the built-in robot. Another robot with two or three joints per leg gets the
trot of `quadruped_env.gait.waves` in their place, with the frequency, lift, height and leg phases in `TROTS`.
"""

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gait_presets import (
    ARTICLE,
    COMMANDED,
    PRESETS,
    TROTS,
    TUNED_FOR_ONE_SPEED,
    TUNED_ON,
    LegTable,
    Trot,
    sinusoid,
)
from quadruped_env.gait.waves import Waves, joint_phases, trot_waves, wave_positions
from quadruped_env.robot.corners import corners
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.utils.arrays import Floats, frozen
from quadruped_env.utils.fields import check, check_names, one_of
from quadruped_env.utils.plain import plain

LEG_TABLES: Final = ("fore", "hind", "fore_turn", "hind_turn", "fore_side", "hind_side")
"""Tables of a gait of two joints per leg; see `CommandedGait.of_legs`."""
_WAVES: Final = ("straight", "turn", "side", "lateral")

_SAME_SHAPE: Final = 1e-3
"""Distance of the feet of two robots of the same shape, as a part of the height of the stance."""
_WHOLE_STEPS: Final = (0.05, 0.15, 0.05)
"""Forward velocity (m/s), yaw rate (rad/s) and lateral velocity (m/s) from which on the tuned robot takes whole
steps."""
_TROT_SPEEDS: Final = (-1.0, -0.5, 0.0, 0.5, 1.0)
"""Forward velocities of the tables of a trot, m/s, of a robot as tall as the built-in one."""
_LATERAL: Final = 0.3
"""Lateral velocity at which a trot's steps to the side are computed, m/s, of a robot as tall as the built-in one."""


@dataclass(frozen=True)
class SinusoidalGait:
    """An open-loop gait of one sinusoid per joint.

    Args:
        hip_amplitude, knee_amplitude: amplitudes, one number or one per hip or knee, rad.
        hip_offset, knee_offset: offsets, one number or one per hip or knee, rad.
        angular_frequency: angular frequency, rad/s.
        phases: phase of each joint (J,), rad.
        robot: robot whose limits apply.
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
    _knees: NDArray[np.bool_] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        phases, knees = np.array(self.phases, dtype=np.float64), _knees(self.robot)
        rule = f"{len(knees)} numbers, one per joint"
        check(phases.shape == knees.shape, "SinusoidalGait: phases", self.phases, rule)
        amplitude, offset = np.empty((2, len(knees)))
        for kind, joints in (("hip", ~knees), ("knee", knees)):
            for part, values in (("amplitude", amplitude), ("offset", offset)):
                given, count = getattr(self, f"{kind}_{part}"), int(joints.sum())
                rule = f"one number or {count}, one per {kind}"
                check(np.shape(given) in ((), (count,)), f"SinusoidalGait: {kind}_{part}", given, rule)
                values[joints] = given
        if not np.isfinite([*amplitude, *offset, *phases, self.angular_frequency]).all():
            raise QuadrupedError("SinusoidalGait: every parameter must be finite; found NaN or infinity")
        for name, found in {"_amplitude": amplitude, "_offset": offset, "_phases": phases, "_knees": knees}.items():
            object.__setattr__(self, name, found)

    @classmethod
    def preset(cls, name: str, robot: Robot = MINI_QUADRUPED) -> "SinusoidalGait":
        """Return a gait by name: `article` as published, one found for the built-in robot, or one of `TROTS`.

        `sinusoid`, `tuned`, `crouched`, `low` and `fast` are the gaits of `CommandedGait` at 0.4 m/s straight ahead.

        Raises:
            QuadrupedError: if there is no such preset, or the scripted gaits do not fit the robot.
        """
        if name in COMMANDED:
            return CommandedGait.preset(name, robot).straight_ahead
        if one_of(name, PRESETS, "SinusoidalGait.preset") == "article":
            return SinusoidalGait(**ARTICLE, robot=robot) if robot == TUNED_ON else _published(robot)
        root, trot = scale_of("m/s", robot), TROTS[name]
        if has_tuned_shape(robot):
            angular_frequency, fore, hind = TUNED_FOR_ONE_SPEED[name]
            waves = (values[0] for values in _waves_of({"fore": fore, "hind": hind}, "", robot))
            return _sinusoids(robot, angular_frequency / root, joint_phases(robot, name), *waves)
        return _trot(robot, trot, trot.frequency / root).at((trot.speed * root, 0.0), trot.phases)

    def parameters(self) -> dict[str, Any]:
        """Return the numbers of the gait as plain values for JSON."""
        names = ("hip_amplitude", "hip_offset", "knee_amplitude", "knee_offset", "angular_frequency", "phases")
        return {name: plain(getattr(self, name)) for name in names}

    def positions(self, t: ArrayLike) -> Floats:
        """Return joint positions (..., J) in rad at times t (...,) in s."""
        angle = self._angle(t)
        return self._amplitude * np.where(self._knees, np.cos(angle), np.sin(angle)) + self._offset

    def velocities(self, t: ArrayLike) -> Floats:
        """Return joint velocities (..., J) in rad/s at times t (...,) in s: the derivative of `positions`."""
        angle = self._angle(t)
        wave = np.where(self._knees, -np.sin(angle), np.cos(angle))
        return self.angular_frequency * self._amplitude * wave

    def _angle(self, t: ArrayLike) -> Floats:
        time = np.asarray(t, dtype=np.float64)
        return self.angular_frequency * time[..., None] + self._phases

    @property
    def period(self) -> float:
        """Duration of one cycle, s."""
        return math.tau / abs(self.angular_frequency) if self.angular_frequency else math.inf

    def violations(self) -> list[str]:
        """Return messages about position and velocity limits that the gait exceeds; empty if there are none."""
        amplitude, offset = np.abs(self._amplitude), self._offset
        speed = abs(self.angular_frequency) * amplitude
        return limit_violations(self.robot, offset - amplitude, offset + amplitude, speed)


def limit_violations(robot: Robot, low: Floats, high: Floats, speed: Floats, tolerance: float = 1e-9) -> list[str]:
    """Return messages about the limits that a motion of the joints exceeds by more than a tolerance.

    `low` and `high` are the ends of the joints' positions (J,) in rad, `speed` their highest speeds (J,) in rad/s.
    """
    found = []
    for i, joint in enumerate(robot.joint_names):
        lower, upper = robot.joint_position_low[i], robot.joint_position_high[i]
        if low[i] < lower - tolerance or high[i] > upper + tolerance:
            found.append(f"{joint}: {low[i]:.3f} to {high[i]:.3f} rad is outside {lower:g} to {upper:g} rad")
        if speed[i] > robot.velocity_limit[i] + tolerance:
            found.append(f"{joint}: {speed[i]:.3f} rad/s is over {robot.velocity_limit[i]:g} rad/s")
    return found


def _knees(robot: Robot) -> NDArray[np.bool_]:
    """Return True for the last joint of each leg (J,)."""
    return np.isin(np.arange(robot.num_joints), [joints[-1] for joints in robot.leg_joints])


def _published(robot: Robot) -> SinusoidalGait:
    """Return the gait `article` on another robot: hips and knees have the angles and phases of their corner.

    The first of three joints of a leg stays as in the stance.
    """
    sine, cosine, phases = np.zeros((3, robot.num_joints))
    offset = robot.stance.copy()
    for joints, corner in zip(robot.leg_joints, corners(robot), strict=True):
        hip, knee = joints[-2:]
        sine[hip], cosine[knee] = ARTICLE["hip_amplitude"], ARTICLE["knee_amplitude"]
        offset[hip], offset[knee] = ARTICLE["hip_offset"], ARTICLE["knee_offset"]
        phases[hip], phases[knee] = ARTICLE["phases"][2 * corner : 2 * corner + 2]
    return _sinusoids(robot, ARTICLE["angular_frequency"], phases, sine, cosine, offset)


def _sinusoids(
    robot: Robot, angular_frequency: float, phases: Floats, sine: Floats, cosine: Floats, offset: Floats
) -> SinusoidalGait:
    """Return a gait from sine and cosine parts and offsets of all joints (J,) at the phases of their legs (J,)."""
    knees = _knees(robot)
    plain = ~knees & (cosine == 0.0)
    shift = np.where(knees, np.arctan2(-sine, cosine), np.arctan2(cosine, sine))
    amplitude = np.where(plain, sine, np.hypot(sine, cosine))
    return SinusoidalGait(
        hip_amplitude=tuple(amplitude[~knees].tolist()),
        hip_offset=tuple(offset[~knees].tolist()),
        knee_amplitude=tuple(amplitude[knees].tolist()),
        knee_offset=tuple(offset[knees].tolist()),
        angular_frequency=angular_frequency,
        phases=tuple((phases + np.where(plain, 0.0, shift)).tolist()),
        robot=robot,
    )


def turn_size(yaw_rate: Floats, largest: float) -> Floats:
    """Return the size of a turn for yaw rates of any shape: sign(w) sqrt(|w| largest), at most the largest, rad/s.

    The yaw rate that the robot reaches grows with the square of the difference between its sides: small differences
    are lost in the feet's sliding.
    """
    return np.copysign(np.sqrt(np.minimum(np.abs(yaw_rate), largest) * largest), yaw_rate)


@dataclass(frozen=True, eq=False)
class CommandedGait:
    """The sinusoidal trot as a function of a command: forward velocity, yaw rate and, on some robots, lateral velocity.

    The waves of all joints are interpolated in tables over forward velocity. To the straight gait's waves a yaw rate
    adds |r| times `turn` and r times `side`; r is the yaw rate's `turn_size`. A lateral velocity adds `lateral` times
    itself. Towards a command of zero the gait fades into the stance.

    Args:
        angular_frequency: angular frequency, rad/s.
        speeds: forward velocities of the tables (K,), increasing, m/s.
        largest_yaw_rate: yaw rate up to which the tables for turning hold, rad/s; for a larger one it is used.
        straight: waves of the joints without a yaw rate: sine part, cosine part and offset (3, K, J), rad.
        turn: what a turn of either sign adds, per rad/s of its size (3, K, J).
        side: what a turn to the left adds and one to the right subtracts, per rad/s of its size (3, K, J).
        robot: robot that walks.
        lateral: what motion to the left adds and to the right subtracts, per m/s (3, K, J); only of a robot whose
            legs can move their feet sideways.
        legs: the tables of a fore and a hind leg from which the waves were made, if they were.
    """

    angular_frequency: float
    speeds: Sequence[float]
    largest_yaw_rate: float
    straight: Floats
    turn: Floats
    side: Floats
    robot: Robot = MINI_QUADRUPED
    lateral: Floats | None = None
    legs: Mapping[str, LegTable] | None = None
    _phases: Floats = field(init=False, repr=False)
    _tables: Floats = field(init=False, repr=False)
    """The waves side by side, (K, 9 J) or (K, 12 J)."""

    def __post_init__(self) -> None:
        tables = np.concatenate(
            [*self.straight, *self.turn, *self.side, *([] if self.lateral is None else self.lateral)], axis=1
        )
        if len(tables) != len(self.speeds):
            raise QuadrupedError(f"gait: the tables have {len(tables)} rows for {len(self.speeds)} speeds")
        object.__setattr__(self, "_tables", frozen(tables))
        object.__setattr__(self, "_phases", joint_phases(self.robot))

    @classmethod
    def of_legs(cls, numbers: Mapping[str, Any], robot: Robot) -> "CommandedGait":
        """Return a gait of a robot with two joints per leg from the tables of a fore and a hind leg, as in `COMMANDED`.

        `fore` and `hind` are the straight gait, `fore_turn` and `hind_turn` what a turn of either sign adds, and
        `fore_side` and `hind_side` what a turn adds on the right and subtracts on the left.
        """
        legs = {name: LegTable(**numbers[name]) for name in LEG_TABLES}
        others = {name: value for name, value in numbers.items() if name not in LEG_TABLES}
        straight, turn, side = (_waves_of(legs, part, robot) for part in ("", "_turn", "_side"))
        return cls(**others, straight=straight, turn=turn, side=side, robot=robot, legs=legs)

    @classmethod
    @functools.cache
    def preset(cls, name: str, robot: Robot = MINI_QUADRUPED, frequency: float | None = None) -> "CommandedGait":
        """Return a gait by name: the robot's own of `Robot.gaits`, or else the preset.

        On the built-in robot, and on others of its shape in any size, `sinusoid` is the trot in closed form, and
        `tuned`, `crouched`, `low` and `fast` were found by searches. Another robot has the gaits of `TROTS`. With a
        frequency in Hz the preset `sinusoid` has the strides of a gait clock with it.

        Raises:
            QuadrupedError: if there is no such preset, the robot's own is not valid, or the scripted gaits do not fit
                the robot.
        """
        gaits, root = robot.gaits or {}, scale_of("m/s", robot)
        check_names(gaits, COMMANDED, f"robot {robot.name!r}: gaits")
        if one_of(name, COMMANDED, "CommandedGait.preset") in gaits:
            check_two_joints(robot, f"gaits[{name!r}] is")
            try:
                return cls.of_legs(gaits[name], robot)
            except (TypeError, KeyError, ValueError) as error:
                raise QuadrupedError(
                    f"robot {robot.name!r}: gaits[{name!r}] must be what tools/tune_gait.py writes under {name!r} "
                    f"({error})"
                ) from error
        if has_tuned_shape(robot):
            return _scaled_to(robot, COMMANDED[name] if frequency is None else sinusoid(frequency * root))
        return _trot(robot, TROTS[name], TROTS[name].frequency / root if frequency is None else frequency)

    def parameters(self) -> dict[str, Any]:
        """Return the numbers of the gait as plain values for JSON."""
        waves = {name: getattr(self, name) for name in _WAVES if getattr(self, name) is not None}
        return {
            "angular_frequency": self.angular_frequency,
            "speeds": plain(self.speeds),
            "largest_yaw_rate": self.largest_yaw_rate,
            **{name: plain(values) for name, values in (self.legs or waves).items()},
        }

    def waves(self, command: Floats) -> Waves:
        """Return sine part, cosine part and offset of every joint (N, J) in rad, for commands (N, 2 or 3)."""
        size = self.turn_size(command[:, 1])[:, None]
        row = np.interp(command[:, 0], self.speeds, np.arange(len(self.speeds)))
        below = np.minimum(row.astype(np.int64), len(self.speeds) - 2)[:, None]
        low, high = (np.take_along_axis(self._tables, index, axis=0) for index in (below, below + 1))
        straight, turn, side, *lateral = np.split(
            low + (row[:, None] - below) * (high - low), 3 + (self.lateral is not None), axis=1
        )
        whole = straight + np.abs(size) * turn + size * side
        if lateral and command.shape[1] > 2:
            whole += command[:, 2:3] * lateral[0]
        sine, cosine, offset = np.split(whole, 3, axis=1)
        fade, stance = self.fade(command)[:, None], self.robot.stance
        return fade * sine, fade * cosine, stance + fade * (offset - stance)

    def turn_size(self, yaw_rate: Floats) -> Floats:
        """Return the size of turns (N,) in rad/s, for yaw rates (N,) in rad/s.

        It is the yaw rate of a robot with `lateral`, whose feet do not slide, up to the largest; else see `turn_size`.
        """
        largest = self.largest_yaw_rate
        return turn_size(yaw_rate, largest) if self.lateral is None else np.clip(yaw_rate, -largest, largest)

    @property
    def whole_steps(self) -> tuple[float, ...]:
        """Velocities from which on a command is followed with whole steps, in its order; (2,) or (3,)."""
        root = scale_of("m/s", self.robot)
        forward, turning, sideways = _WHOLE_STEPS
        steps = (forward * root, turning / root, sideways * root)
        return steps[:2] if self.lateral is None else steps

    def fade(self, command: Floats) -> Floats:
        """Return the size of the steps (N,), 0 for a command of zero and 1 for one that is worth whole steps."""
        shares = np.abs(command[:, : len(self.whole_steps)]) / self.whole_steps[: command.shape[1]]
        return np.minimum(1.0, shares.max(axis=1))

    def positions(self, phase: ArrayLike, command: ArrayLike) -> Floats:
        """Return joint positions (N, J) in rad at gait phases (N,) in rad, for commands (N, 2 or 3)."""
        waves = self.waves(np.asarray(command, dtype=np.float64))
        return wave_positions(np.asarray(phase, dtype=np.float64), self._phases, *waves)

    @property
    def straight_ahead(self) -> SinusoidalGait:
        """The sinusoidal gait straight ahead at 0.4 m/s, in proportion to the robot's size."""
        return self.at((0.4 * scale_of("m/s", self.robot), 0.0))

    def at(self, command: Sequence[float], phases: str = "trot") -> SinusoidalGait:
        """Return the sinusoidal gait for one command (2,) or (3,), with the phases of a gait of `LEG_PHASES`."""
        waves = (values[0] for values in self.waves(np.array([command])))
        return _sinusoids(self.robot, self.angular_frequency, joint_phases(self.robot, phases), *waves)


def check_two_joints(robot: Robot, what: str) -> None:
    """Refuse a robot for whose legs there is no `LegTable`; `what` begins the sentence that says what is for others.

    Raises:
        QuadrupedError: if a leg has not two joints.
    """
    counts = {len(joints) for joints in robot.leg_joints}
    if counts != {2}:
        raise QuadrupedError(
            f"robot {robot.name!r}: {what} for legs of two joints, and its legs have {max(counts)}; leave it out: the "
            f"robot has the trot that follows from its kinematics (docs/gaits.md)"
        )


def _waves_of(legs: Mapping[str, LegTable], part: str, robot: Robot) -> Floats:
    """Return the waves of all joints (3, K, J) from the tables of a fore and a hind leg; `_side` is for the right."""
    waves = np.zeros((3, np.size(legs["fore" + part].hip_sine), robot.num_joints))
    for joints, corner in zip(robot.leg_joints, corners(robot), strict=True):
        hip, knee = joints
        table = legs[("fore", "hind")[corner // 2] + part]
        sign = -1.0 if part == "_side" and corner % 2 == 0 else 1.0
        waves[:, :, hip] = sign * np.array((table.hip_sine, table.hip_cosine, table.hip_offset)).reshape(3, -1)
        waves[:, :, knee] = sign * np.array((table.knee_sine, table.knee_cosine, table.knee_offset)).reshape(3, -1)
    return waves


def has_tuned_shape(robot: Robot) -> bool:
    """Return True for a robot whose feet move like those of the built-in one, in proportion to its height."""
    if robot == TUNED_ON:
        return True
    if robot.num_joints != TUNED_ON.num_joints:
        return False
    order = np.argsort(corners(robot))  # The built-in robot's legs are in the order of the corners.
    joints = np.array(robot.leg_joints)[order].ravel()
    postures = TUNED_ON.stance + np.outer([0.0, 0.3, -0.3], np.tile([1.0, -0.5], 4))
    own = np.empty_like(postures)
    own[:, joints] = postures
    feet = robot.skeleton.foot_centres(own)[:, order] / robot.stance_height
    tuned = TUNED_ON.skeleton.foot_centres(postures) / TUNED_ON.stance_height
    return np.allclose(robot.stance[joints], TUNED_ON.stance) and np.allclose(feet, tuned, atol=_SAME_SHAPE)


def _scaled_to(robot: Robot, numbers: Mapping[str, Any]) -> CommandedGait:
    """Return a gait of the built-in robot, in the form of `COMMANDED`, on a robot of its shape."""
    root = scale_of("m/s", robot)
    turns = [name for name in LEG_TABLES if "_" in name]  # per rad/s
    return CommandedGait.of_legs(
        {
            **numbers,
            **{name: {part: np.multiply(root, row) for part, row in numbers[name].items()} for name in turns},
            "angular_frequency": numbers["angular_frequency"] / root,
            "speeds": tuple(root * speed for speed in numbers["speeds"]),
            "largest_yaw_rate": numbers["largest_yaw_rate"] / root,
        },
        robot,
    )


def _trot(robot: Robot, trot: Trot, frequency: float) -> CommandedGait:
    """Return the trot of a robot other than the built-in one, at a frequency in Hz."""
    root = scale_of("m/s", robot)
    largest, speeds = trot.largest_yaw_rate / root, tuple(speed * root for speed in _TROT_SPEEDS)
    lateral = _LATERAL * root if robot.moves_sideways else 0.0
    aside = ((0.0, 0.0), (largest, 0.0), (-largest, 0.0), (0.0, lateral), (0.0, -lateral))
    velocities = np.array([(speed, *other) for other in aside for speed in speeds])
    found = np.stack(trot_waves(robot, frequency, velocities, trot)).reshape(3, len(aside), len(speeds), -1)
    straight, left, right, to_left, to_right = np.moveaxis(found, 1, 0)
    turn, side = 0.5 * (left + right) - straight, 0.5 * (left - right)
    # To 1e-6 rad, so that a policy's gait does not depend on the last bits of a processor's sums.
    return CommandedGait(
        math.tau * frequency,
        speeds,
        largest,
        straight=straight.round(6),
        turn=(turn / largest).round(6),
        side=(side / largest).round(6),
        robot=robot,
        lateral=(0.5 * (to_left - to_right) / lateral).round(6) if lateral else None,
    )
