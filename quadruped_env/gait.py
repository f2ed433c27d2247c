"""The scripted gait: eight sinusoids, from time or phase to joint positions.

For every leg, with phase p of the joint and angular frequency w:

    hip  = hip_amplitude  * sin(w t + p) + hip_offset
    knee = knee_amplitude * cos(w t + p) + knee_offset

The shape is the ROS 2 tutorial's; its numbers are the preset `article`. `CommandedGait` bends the same shape to a
commanded forward velocity and yaw rate. Units: rad, rad/s, s.
"""

import math
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import JOINT_NAMES, JOINT_POSITION_HIGH, JOINT_POSITION_LOW, LEG_NAMES, VELOCITY_LIMIT

PRESETS: Final = ("article", "trot", "walk", "bound", "pace", "tuned")

_HIPS: Final = slice(0, None, 2)
_KNEES: Final = slice(1, None, 2)

TURNS: Final = {
    "trot": (0.0, 0.5, 0.5, 0.0),
    "walk": (0.0, 0.5, 0.75, 0.25),
    "bound": (0.0, 0.0, 0.5, 0.5),
    "pace": (0.0, 0.5, 0.0, 0.5),
}
"""Phase of each leg's cycle, in cycles, in the order LF, RF, LH, RH."""


@dataclass(frozen=True)
class SinusoidalGait:
    """An open-loop gait of one sinusoid a joint.

    Args:
        hip_amplitude, knee_amplitude: rad, one number or one a leg.
        hip_offset, knee_offset: rad, one number or one a leg.
        angular_frequency: rad/s.
        phases: rad, one a joint (8,), in the order of `JOINT_NAMES`.
    """

    hip_amplitude: float | tuple[float, ...]
    hip_offset: float | tuple[float, ...]
    knee_amplitude: float | tuple[float, ...]
    knee_offset: float | tuple[float, ...]
    angular_frequency: float
    phases: tuple[float, ...]
    _amplitude: NDArray[np.float64] = field(init=False, repr=False, compare=False)
    _offset: NDArray[np.float64] = field(init=False, repr=False, compare=False)
    _phases: NDArray[np.float64] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        if len(self.phases) != len(JOINT_NAMES):
            raise QuadrupedError(
                f"SinusoidalGait: phases must have {len(JOINT_NAMES)} values, one a joint; found {len(self.phases)}"
            )
        for name in ("hip_amplitude", "hip_offset", "knee_amplitude", "knee_offset"):
            if np.shape(getattr(self, name)) not in ((), (len(LEG_NAMES),)):
                raise QuadrupedError(f"SinusoidalGait: {name} must be one number or {len(LEG_NAMES)}, one a leg")
        amplitude, offset = np.empty(8), np.empty(8)
        amplitude[_HIPS], amplitude[_KNEES] = self.hip_amplitude, self.knee_amplitude
        offset[_HIPS], offset[_KNEES] = self.hip_offset, self.knee_offset
        values = np.concatenate([amplitude, offset, self.phases, [self.angular_frequency]])
        if not np.isfinite(values).all():
            raise QuadrupedError("SinusoidalGait: every parameter must be finite; found NaN or infinity")
        object.__setattr__(self, "_amplitude", amplitude)
        object.__setattr__(self, "_offset", offset)
        object.__setattr__(self, "_phases", np.array(self.phases, dtype=np.float64))

    @classmethod
    def preset(cls, name: str) -> "SinusoidalGait":
        """A gait by name: `article` as published, or one tuned to walk on this robot.

        `tuned` is `CommandedGait` at 0.4 m/s straight ahead.

        Raises:
            QuadrupedError: if there is no such preset.
        """
        if name == "tuned":
            return CommandedGait.tuned().at((0.4, 0.0))
        if name not in _PRESETS:
            raise QuadrupedError(
                f"SinusoidalGait.preset: unknown preset {name!r}; valid names are {', '.join(PRESETS)}"
            )
        return _PRESETS[name]

    def positions(self, t: ArrayLike) -> NDArray[np.float64]:
        """Joint positions (..., 8) in rad at times t (...,) in s."""
        angle = self._angle(t)
        wave = np.empty_like(angle)
        wave[..., _HIPS] = np.sin(angle[..., _HIPS])
        wave[..., _KNEES] = np.cos(angle[..., _KNEES])
        return self._amplitude * wave + self._offset

    def velocities(self, t: ArrayLike) -> NDArray[np.float64]:
        """Joint velocities (..., 8) in rad/s at times t (...,) in s: the derivative of `positions`."""
        angle = self._angle(t)
        wave = np.empty_like(angle)
        wave[..., _HIPS] = np.cos(angle[..., _HIPS])
        wave[..., _KNEES] = -np.sin(angle[..., _KNEES])
        return self.angular_frequency * self._amplitude * wave

    def _angle(self, t: ArrayLike) -> NDArray[np.float64]:
        time = np.asarray(t, dtype=np.float64)
        return self.angular_frequency * time[..., None] + self._phases

    @property
    def period(self) -> float:
        """Duration of one cycle, s."""
        return math.tau / abs(self.angular_frequency) if self.angular_frequency else math.inf

    def violations(self) -> list[str]:
        """What the gait asks for beyond the robot's position and velocity limits; empty for a gait within them."""
        amplitude, offset = np.abs(self._amplitude), self._offset
        low, high = offset - amplitude, offset + amplitude
        speed = abs(self.angular_frequency) * amplitude
        found = []
        tolerance = 1e-9
        for i, joint in enumerate(JOINT_NAMES):
            if low[i] < JOINT_POSITION_LOW[i] - tolerance or high[i] > JOINT_POSITION_HIGH[i] + tolerance:
                found.append(
                    f"{joint}: {low[i]:.3f} to {high[i]:.3f} rad is outside "
                    f"{JOINT_POSITION_LOW[i]:g} to {JOINT_POSITION_HIGH[i]:g} rad"
                )
            if speed[i] > VELOCITY_LIMIT + tolerance:
                found.append(f"{joint}: {speed[i]:.3f} rad/s is over {VELOCITY_LIMIT:g} rad/s")
        return found


def _preset(
    turns: tuple[float, ...],
    angular_frequency: float,
    hip: tuple[float, float],
    knee: tuple[float, float, float],
) -> SinusoidalGait:
    """A gait with every leg alike: hip (amplitude, offset), knee (cosine part, sine part, offset)."""
    cosine, sine, offset = knee
    lag = math.atan2(-sine, cosine)
    phases = tuple(math.tau * turn + joint for turn in turns for joint in (0.0, lag))
    return SinusoidalGait(hip[0], hip[1], math.hypot(cosine, sine), offset, angular_frequency, phases)


_PRESETS: Final = {
    "article": SinusoidalGait(0.4, 0.0, 0.3, -0.3, 2.0, (0.0, 0.5, 3.14, 3.64, 1.57, 2.07, 4.71, 5.21)),
    # The others: train/tune_gait.py.
    "trot": _preset(TURNS["trot"], 14.0, (0.091, 0.613), (0.241, -0.24, -0.621)),
    "walk": _preset(TURNS["walk"], 12.0, (0.127, 0.648), (0.269, -0.185, -0.658)),
    "bound": _preset(TURNS["bound"], 14.0, (0.033, 0.492), (0.257, -0.161, -0.732)),
    "pace": _preset(TURNS["pace"], 14.0, (0.167, 0.447), (0.247, -0.257, -0.814)),
}


def wave_positions(
    phase: NDArray[np.float64],
    sine: NDArray[np.float64],
    cosine: NDArray[np.float64],
    offset: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Joint positions (N, 8) in rad at gait phases (N,) in rad, from what `CommandedGait.waves` gives."""
    angle = phase[:, None] + JOINT_PHASES
    return sine * np.sin(angle) + cosine * np.cos(angle) + offset


@dataclass(frozen=True)
class CommandedGait:
    """The sinusoidal trot as a function of a commanded forward velocity and yaw rate.

    Each side of the robot has a ground speed, v - w * half_track on the left and v + w * half_track on the right, and
    each parameter of that side's legs is interpolated in a table over that speed. The knee's wave is kept as a cosine
    and a sine part, knee_cosine * cos(w t + p) + knee_sine * sin(w t + p), because walking backwards is walking
    forwards with time reversed: only the sine part changes its sign, and the table stays smooth through zero.

    Args:
        angular_frequency: rad/s.
        half_track: m; half the track for a robot that did not slip, tuned for one that does.
        speeds: the table's ground speeds, m/s, rising (K,).
        hip_amplitude, hip_offset, knee_cosine, knee_sine, knee_offset: the table's columns, rad (K,).
    """

    angular_frequency: float
    half_track: float
    speeds: tuple[float, ...]
    hip_amplitude: tuple[float, ...]
    hip_offset: tuple[float, ...]
    knee_cosine: tuple[float, ...]
    knee_sine: tuple[float, ...]
    knee_offset: tuple[float, ...]

    @classmethod
    def tuned(cls) -> "CommandedGait":
        """The table that `train/tune_gait.py` found."""
        return _TUNED

    def waves(self, command: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Sine part, cosine part and offset of every joint, rad (N, 8) each, for commands (N, 2) in m/s and rad/s."""
        command = np.asarray(command, dtype=np.float64)
        turn = command[:, 1] * self.half_track
        sine, cosine, offset = (np.zeros((len(command), len(JOINT_NAMES))) for _ in range(3))
        for side, speed in enumerate((command[:, 0] - turn, command[:, 0] + turn)):
            # Joints go LF, RF, LH, RH with a hip and a knee each: a side's hips are four columns apart.
            hips, knees = slice(2 * side, None, 4), slice(2 * side + 1, None, 4)
            for target, columns, values in (
                (sine, hips, self.hip_amplitude),
                (offset, hips, self.hip_offset),
                (cosine, knees, self.knee_cosine),
                (sine, knees, self.knee_sine),
                (offset, knees, self.knee_offset),
            ):
                target[:, columns] = np.interp(speed, self.speeds, values)[:, None]
        return sine, cosine, offset

    def positions(self, phase: ArrayLike, command: ArrayLike) -> NDArray[np.float64]:
        """Joint positions (N, 8) in rad at gait phases (N,) in rad, for commands (N, 2)."""
        return wave_positions(np.asarray(phase, dtype=np.float64), *self.waves(command))

    def at(self, command: tuple[float, float]) -> SinusoidalGait:
        """The plain gait for one command."""
        sine, cosine, offset = (values[0] for values in self.waves([command]))
        lag = np.arctan2(-sine[_KNEES], cosine[_KNEES])
        phases = JOINT_PHASES.copy()
        phases[_KNEES] += lag
        return SinusoidalGait(
            hip_amplitude=tuple(sine[_HIPS].tolist()),
            hip_offset=tuple(offset[_HIPS].tolist()),
            knee_amplitude=tuple(np.hypot(cosine, sine)[_KNEES].tolist()),
            knee_offset=tuple(offset[_KNEES].tolist()),
            angular_frequency=self.angular_frequency,
            phases=tuple(phases.tolist()),
        )


JOINT_PHASES: Final = np.repeat(np.array(TURNS["trot"]) * math.tau, 2)
"""Phase (8,) of each joint's leg in the trot, rad."""

_TUNED: Final = CommandedGait(
    angular_frequency=math.tau * 2.2,
    half_track=0.58,
    speeds=(-0.444, -0.35, -0.2, -0.1, 0.0, 0.1, 0.2, 0.35, 0.431),
    hip_amplitude=(0.3614, 0.2518, 0.1717, 0.1429, 0.0, 0.0933, 0.078, 0.1011, 0.056),
    hip_offset=(0.4895, 0.4981, 0.513, 0.55, 0.6, 0.5769, 0.5804, 0.6267, 0.6377),
    knee_cosine=(-0.0569, -0.0884, -0.0806, -0.072, 0.0, 0.049, 0.1238, 0.2231, 0.2735),
    knee_sine=(-0.0434, -0.0586, -0.0969, -0.1371, 0.0, -0.1318, -0.1149, -0.1956, -0.2348),
    knee_offset=(-0.5671, -0.5713, -0.5945, -0.6127, -0.72, -0.5857, -0.5886, -0.6088, -0.662),
)
