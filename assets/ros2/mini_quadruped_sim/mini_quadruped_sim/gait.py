"""The tutorial's gait: one sinusoid per joint.

    hip  = hip_amplitude  * sin(angular_frequency * t + phase)
    knee = knee_amplitude * cos(angular_frequency * t + phase) + knee_offset

The defaults are the tutorial's numbers. This module needs only the standard library, so that it runs in the Python of
any ROS 2 installation.
"""

import math
from dataclasses import dataclass

JOINT_NAMES = (
    "LF_hip_joint",
    "LF_knee_joint",
    "RF_hip_joint",
    "RF_knee_joint",
    "LH_hip_joint",
    "LH_knee_joint",
    "RH_hip_joint",
    "RH_knee_joint",
)


@dataclass(frozen=True)
class Gait:
    """Positions and velocities of the eight joints over time.

    Args:
        hip_amplitude: rad.
        knee_amplitude: rad.
        knee_offset: rad.
        angular_frequency: rad/s.
        phases: rad, one per joint, in the order of `JOINT_NAMES`.

    Raises:
        ValueError: if there are not eight phases, or a number is not finite.
    """

    hip_amplitude: float = 0.4
    knee_amplitude: float = 0.3
    knee_offset: float = -0.3
    angular_frequency: float = 2.0
    phases: tuple[float, ...] = (0.0, 0.5, 3.14, 3.64, 1.57, 2.07, 4.71, 5.21)

    def __post_init__(self) -> None:
        if len(self.phases) != len(JOINT_NAMES):
            raise ValueError(f"phases: expected {len(JOINT_NAMES)} numbers, one per joint; found {len(self.phases)}")
        for name in ("hip_amplitude", "knee_amplitude", "knee_offset", "angular_frequency"):
            if not math.isfinite(getattr(self, name)):
                raise ValueError(f"{name}: expected a finite number; found {getattr(self, name)}")
        if not all(math.isfinite(phase) for phase in self.phases):
            raise ValueError(f"phases: expected finite numbers; found {list(self.phases)}")

    def positions(self, t: float) -> list[float]:
        """Joint positions in rad, one per joint, at time t in s."""
        return [
            self.knee_amplitude * math.cos(angle) + self.knee_offset if knee else self.hip_amplitude * math.sin(angle)
            for angle, knee in self._angles(t)
        ]

    def velocities(self, t: float) -> list[float]:
        """Joint velocities in rad/s, one per joint, at time t in s: the derivative of `positions`."""
        return [
            self.angular_frequency
            * (-self.knee_amplitude * math.sin(angle) if knee else self.hip_amplitude * math.cos(angle))
            for angle, knee in self._angles(t)
        ]

    def _angles(self, t: float) -> list[tuple[float, bool]]:
        # Hips have even indices, knees odd ones.
        return [(self.angular_frequency * t + phase, i % 2 == 1) for i, phase in enumerate(self.phases)]
