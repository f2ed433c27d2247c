"""Limit of the pushes that users give a simulated robot."""

import math
from collections import deque
from collections.abc import Iterable
from typing import Final

from quadruped_env.errors import QuadrupedError

MAX_PUSH: Final = 5.0
"""Maximum sum of the pushes within `PERIOD`, m/s. At 10 m/s, one simulation in five diverges; at 5 m/s none."""
PERIOD: Final = 1.0
"""Simulated time over which pushes add up, s."""


class PushLimit:
    """Refuses pushes that add up to more than `MAX_PUSH`; `name` names the input in the error."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._recent: deque[tuple[float, float]] = deque()
        """Time (s) and velocity (m/s) of each push of the last period."""

    def check(self, velocity: Iterable[float], time: float) -> None:
        """Count a push of a velocity in m/s at a simulated time in s, not before an earlier push.

        Raises:
            QuadrupedError: if it is not finite, or too large together with the others; it is not counted then.
        """
        velocity = [float(value) for value in velocity]
        while self._recent and time >= self._recent[0][0] + PERIOD:
            self._recent.popleft()
        speed = math.hypot(*velocity)
        total = speed + sum(earlier for _, earlier in self._recent)
        if not total <= MAX_PUSH:
            within = f" and the pushes of the last {PERIOD:g} s add up to {total:.3g} m/s" if self._recent else ""
            raise QuadrupedError(
                f"{self._name}: {velocity} m/s{within}; expected finite numbers and at most {MAX_PUSH:g} m/s within "
                f"{PERIOD:g} s; push less, or wait"
            )
        self._recent.append((time, speed))
