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
from quadruped_env.robot import JOINT_NAMES, JOINT_POSITION_HIGH, JOINT_POSITION_LOW, LEG_NAMES, STANCE, VELOCITY_LIMIT

PRESETS: Final = ("article", "trot", "walk", "bound", "pace", "tuned")

_HIPS: Final = slice(0, None, 2)
_KNEES: Final = slice(1, None, 2)

# Phase of each leg's cycle, in turns, in the order LF, RF, LH, RH.
_TROT: Final = (0.0, 0.5, 0.5, 0.0)
_WALK: Final = (0.0, 0.5, 0.75, 0.25)
_BOUND: Final = (0.0, 0.0, 0.5, 0.5)
_PACE: Final = (0.0, 0.5, 0.0, 0.5)


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


def _leg_phases(turns: tuple[float, ...], knee_lag: float) -> tuple[float, ...]:
    return tuple(math.tau * turn + lag for turn in turns for lag in (0.0, knee_lag))


def _preset(
    turns: tuple[float, ...],
    frequency: float,
    hip: tuple[float, float],
    knee: tuple[float, float],
    knee_lag: float = 0.0,
) -> SinusoidalGait:
    return SinusoidalGait(hip[0], hip[1], knee[0], knee[1], frequency, _leg_phases(turns, knee_lag))


_PRESETS: Final = {
    "article": SinusoidalGait(0.4, 0.0, 0.3, -0.3, 2.0, (0.0, 0.5, 3.14, 3.64, 1.57, 2.07, 4.71, 5.21)),
    # Amplitude times frequency stays under 5 rad/s for both joints.
    "trot": _preset(_TROT, 14.0, (0.3, 0.5), (0.3, -0.72)),
    "walk": _preset(_WALK, 10.0, (0.35, 0.5), (0.35, -0.72)),
    "bound": _preset(_BOUND, 14.0, (0.3, 0.5), (0.3, -0.72)),
    "pace": _preset(_PACE, 14.0, (0.3, 0.5), (0.3, -0.72)),
}


@dataclass(frozen=True)
class CommandedGait:
    """The sinusoidal trot as a function of a commanded forward velocity and yaw rate.

    Each side of the robot has a ground speed, v -+ w * half_track (left slower than right when it turns left), and
    each parameter of that side's legs is interpolated in a table over that speed.

    Args:
        angular_frequency: rad/s.
        knee_lag: phase of each knee ahead of its hip, rad.
        half_track: m; half the track for a robot that did not slip, tuned for one that does.
        speeds: the table's ground speeds, m/s, rising (K,).
        hip_amplitude, hip_offset, knee_amplitude, knee_offset: the table's columns, rad (K,).
        turns: phase of each leg in cycles.
    """

    angular_frequency: float
    knee_lag: float
    half_track: float
    speeds: tuple[float, ...]
    hip_amplitude: tuple[float, ...]
    hip_offset: tuple[float, ...]
    knee_amplitude: tuple[float, ...]
    knee_offset: tuple[float, ...]
    turns: tuple[float, ...] = _TROT

    @classmethod
    def tuned(cls) -> "CommandedGait":
        """The table that `train/tune_gait.py` found."""
        return _TUNED

    def parameters(self, command: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Amplitude and offset of every joint, rad (N, 8) each, for commands (N, 2) in m/s and rad/s."""
        command = np.asarray(command, dtype=np.float64)
        turn = command[:, 1] * self.half_track
        amplitude = np.empty((len(command), len(JOINT_NAMES)))
        offset = np.empty_like(amplitude)
        for side, speed in enumerate((command[:, 0] - turn, command[:, 0] + turn)):
            # Joints of one side: hips at `side` legs apart by two legs, knees next to them.
            hips, knees = slice(2 * side, None, 4), slice(2 * side + 1, None, 4)
            amplitude[:, hips] = np.interp(speed, self.speeds, self.hip_amplitude)[:, None]
            amplitude[:, knees] = np.interp(speed, self.speeds, self.knee_amplitude)[:, None]
            offset[:, hips] = np.interp(speed, self.speeds, self.hip_offset)[:, None]
            offset[:, knees] = np.interp(speed, self.speeds, self.knee_offset)[:, None]
        return amplitude, offset

    def joint_phases(self) -> NDArray[np.float64]:
        """Phase (8,) in rad to add to the gait's phase so that a sine gives every joint's wave."""
        phases = np.array(_leg_phases(self.turns, self.knee_lag))
        phases[_KNEES] += math.pi / 2
        return phases

    def positions(self, phase: ArrayLike, command: ArrayLike) -> NDArray[np.float64]:
        """Joint positions (N, 8) in rad at gait phases (N,) in rad, for commands (N, 2)."""
        amplitude, offset = self.parameters(command)
        return amplitude * np.sin(np.asarray(phase)[:, None] + self.joint_phases()) + offset

    def at(self, command: tuple[float, float]) -> SinusoidalGait:
        """The plain gait for one command."""
        amplitude, offset = (values[0] for values in self.parameters([command]))
        return SinusoidalGait(
            hip_amplitude=tuple(amplitude[_HIPS]),
            hip_offset=tuple(offset[_HIPS]),
            knee_amplitude=tuple(amplitude[_KNEES]),
            knee_offset=tuple(offset[_KNEES]),
            angular_frequency=self.angular_frequency,
            phases=_leg_phases(self.turns, self.knee_lag),
        )


_TUNED: Final = CommandedGait(
    angular_frequency=14.0,
    knee_lag=0.0,
    half_track=0.1,
    speeds=(-0.4, 0.0, 0.5),
    hip_amplitude=(-0.3, 0.0, 0.35),
    hip_offset=(0.6, STANCE[0], 0.6),
    knee_amplitude=(0.3, 0.0, 0.35),
    knee_offset=(-0.72, STANCE[1], -0.72),
)
