"""When an episode is lost. Pure batched functions; True ends the row's episode."""

import math
from typing import Any

from quadruped_env.task.arrays import any_of


def tilted(up_b: Any, max_tilt: float) -> Any:
    """Whether the base leans further than max_tilt (rad), shape (N,)."""
    return up_b[:, 2] < math.cos(max_tilt)


def trunk_contact(trunk_force: Any, max_trunk_force: float) -> Any:
    """Whether the base or a hip presses on the ground with more than max_trunk_force (N), shape (N,)."""
    return any_of(trunk_force > max_trunk_force)
