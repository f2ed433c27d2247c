"""Seeds that are reserved for evaluation: no training and no search may use them."""

from typing import Final

from quadruped_env.errors import QuadrupedError

EVALUATION_SEEDS: Final = range(1_000_000, 2_000_000)
"""Seeds of episodes and terrains that only evaluations use."""


def check_training_seeds(name: str, first: int, count: int = 1) -> None:
    """Check that consecutive seeds are not reserved for evaluations.

    Args:
        name: name of the setting in the error.
        first: first seed.
        count: number of seeds.

    Raises:
        QuadrupedError: if one of them is reserved for evaluation.
    """
    reserved = EVALUATION_SEEDS
    if first < reserved.stop and first + count > reserved.start:
        used = str(first) if count == 1 else f"{first} to {first + count - 1}"
        raise QuadrupedError(
            f"{name}: found {used}; {reserved.start} to {reserved.stop - 1} are reserved for evaluation, whose "
            f"episodes no training may see; choose a smaller seed"
        )
