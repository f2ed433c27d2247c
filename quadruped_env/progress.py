"""Progress of a long computation."""

from collections.abc import Callable

Progress = Callable[[float], None]
"""Called with the fraction done, in [0, 1]."""
