"""The errors this package raises for bad input."""

from quadruped_env._python import install_command


class QuadrupedError(ValueError):
    """Bad input: the message names what was wrong, where, and how to mend it."""


class MissingExtraError(ImportError):
    """A program needs a library that an optional extra of this package brings."""

    def __init__(self, purpose: str, extra: str) -> None:
        super().__init__(f"{purpose} needs the '{extra}' extra: {install_command(extra)}")


class QuadrupedWarning(UserWarning):
    """Input that can be used, though something about it may not be as meant."""
