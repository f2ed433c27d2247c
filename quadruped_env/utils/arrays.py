"""Read-only arrays."""

from typing import Any

from numpy.typing import NDArray


def frozen(values: NDArray[Any]) -> NDArray[Any]:
    """The same array, read-only from now on: shared by those who read it."""
    values.setflags(write=False)
    return values
