"""The type of progress callbacks."""

from collections.abc import Callable

Progress = Callable[[float], None]
"""Progress callback: called with the fraction done, in [0, 1]."""
