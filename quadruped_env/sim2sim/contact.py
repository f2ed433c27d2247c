"""Contact model of a robot in Drake."""

from typing import Literal, NamedTuple

Approximation = Literal["sap", "lagged", "similar"]


class Contact(NamedTuple):
    """Contact between points, on every link and the ground."""

    approximation: Approximation
    """Discrete contact approximation."""
    friction: float
    """Coefficient of static and dynamic friction."""
    relaxation_time: float
    """Time constant of the dissipation with `sap`, s."""
