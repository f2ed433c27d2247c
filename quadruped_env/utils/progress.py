"""The type of progress callbacks."""

from collections.abc import Callable

Progress = Callable[[float], None]
"""Progress callback: called with the fraction done, in [0, 1]."""


def part_of(progress: Progress | None, begin: float, end: float) -> Progress | None:
    """Progress callback for a part of the work, from `begin` to `end` of the whole; None without one."""
    return None if progress is None else lambda share: progress(begin + share * (end - begin))
