"""What the policy sees: only what the real robot could measure, in one layout table."""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, VELOCITY_LIMIT
from quadruped_env.simulation import State


@dataclass(frozen=True)
class ObservationField:
    """One group of columns: observation = clip((reading - offset) * scale, low, high)."""

    name: str
    width: int
    unit: str
    scale: float
    low: float
    high: float
    """Bounds of the scaled value; a reading beyond them is clipped"""
    noise: float = 0.0
    """Amplitude of uniform noise on the reading, in its unit, at `observation_noise` 1"""
    offset: tuple[float, ...] | None = None
    """Subtracted from the reading, in its unit"""


_POSITION_BOUND = float(np.max(np.abs(np.concatenate([JOINT_POSITION_LOW - STANCE, JOINT_POSITION_HIGH - STANCE]))))

OBSERVATION_LAYOUT: Final = (
    ObservationField("projected_gravity", 3, "1", 1.0, -1.0, 1.0, noise=0.02),
    ObservationField("angular_velocity", 3, "rad/s", 0.25, -4.0, 4.0, noise=0.1),
    ObservationField(
        "joint_position", 8, "rad", 1.0, -_POSITION_BOUND, _POSITION_BOUND, noise=0.01, offset=tuple(STANCE.tolist())
    ),
    # Impacts can drive a joint faster than its motor can.
    ObservationField("joint_velocity", 8, "rad/s", 1.0 / VELOCITY_LIMIT, -3.0, 3.0, noise=0.3),
    ObservationField("last_action", 8, "1", 1.0, -1.0, 1.0),
    ObservationField("command", 2, "m/s, rad/s", 4.0, -4.0, 4.0),
    ObservationField("gait_clock", 2, "1", 1.0, -1.0, 1.0),
)
"""The columns of an observation, in order. The gait clock is (sin, cos) of the phase, and 0 at a zero command."""

OBSERVATION_WIDTH: Final = sum(field.width for field in OBSERVATION_LAYOUT)


def _columns(attribute: str) -> NDArray[np.float64]:
    return np.concatenate([np.full(field.width, getattr(field, attribute)) for field in OBSERVATION_LAYOUT])


OBSERVATION_LOW: Final = _columns("low")
OBSERVATION_HIGH: Final = _columns("high")
OBSERVATION_SCALE: Final = _columns("scale")
OBSERVATION_NOISE: Final = _columns("noise")
OBSERVATION_OFFSET: Final = np.concatenate(
    [np.zeros(field.width) if field.offset is None else np.array(field.offset) for field in OBSERVATION_LAYOUT]
)


def raw_observation(state: State, last_action: Any, command: Any, clock: Any, out: NDArray[np.float64]) -> None:
    """Write the unscaled readings, in the order of the layout, to out (N, OBSERVATION_WIDTH)."""
    np.concatenate(
        (
            -state.up_b,
            state.angular_velocity_b,
            state.joint_position,
            state.joint_velocity,
            last_action,
            command,
            clock,
        ),
        axis=1,
        out=out,
    )


def scale_observation(raw: NDArray[np.float64]) -> NDArray[np.float32]:
    """The observation (N, OBSERVATION_WIDTH) from unscaled readings: offset, scaled, clipped, in float32."""
    scaled = (raw - OBSERVATION_OFFSET) * OBSERVATION_SCALE
    np.maximum(scaled, OBSERVATION_LOW, out=scaled)
    np.minimum(scaled, OBSERVATION_HIGH, out=scaled)
    return scaled.astype(np.float32)
