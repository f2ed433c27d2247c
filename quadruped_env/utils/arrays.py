"""Read-only arrays."""

from typing import Any

from numpy.typing import NDArray


def frozen(values: NDArray[Any]) -> NDArray[Any]:
    """The same array, read-only from now on: a constant, which a GPU receives only once."""
    values.setflags(write=False)
    return values
