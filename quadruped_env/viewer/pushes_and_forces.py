"""Pushes and sustained forces that a user chooses, relative to the robot's heading."""

import math
from typing import Final

from quadruped_env.evaluation.metrics import GRAVITY
from quadruped_env.robot import Robot

MAX_PUSH: Final = 1.5
"""Maximum velocity change by a push, m/s."""
MAX_FORCE_SHARE: Final = 0.5
"""Maximum sustained force, relative to the robot's weight."""
MAX_FORCE_SECONDS: Final = 5.0
"""Maximum duration of a sustained force, s."""

Plane = tuple[float, float]
"""Vector (forwards, left)."""


def push_velocity(direction: float, strength: float) -> Plane:
    """Velocity that a push adds, m/s, for a direction (rad, positive to the left) and a strength (m/s), limited."""
    return _vector(direction, min(max(strength, 0.0), MAX_PUSH))


def sustained_force(robot: Robot, direction: float, force: float) -> Plane:
    """Force on a robot's base, N, for a direction (rad, positive to the left) and a force (N), limited."""
    return _vector(direction, min(max(force, 0.0), max_force(robot)))


def max_force(robot: Robot) -> float:
    """Maximum sustained force on a robot, N."""
    return MAX_FORCE_SHARE * robot.total_mass * GRAVITY


def _vector(direction: float, length: float) -> Plane:
    return length * math.cos(direction), length * math.sin(direction)
