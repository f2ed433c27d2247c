"""The errors this package raises for bad input."""

from quadruped_env._python import install_command


class QuadrupedError(ValueError):
    """Bad input: the message names what was wrong, where, and how to mend it."""


class MissingExtraError(ImportError):
    """A program needs a library that an optional extra of this package brings."""

    def __init__(self, purpose: str, extra: str) -> None:
        need = f"{purpose} needs the '{extra}' extra"
        super().__init__(f"{need}: {install_command(extra)}")
        self.portable = f"{need}: pip install 'mini-quadruped[{extra}]'"
        """The message without this machine's Python, for a page that is read elsewhere"""


def portable_message(error: Exception) -> str:
    """An error's message for a page that is read elsewhere."""
    return error.portable if isinstance(error, MissingExtraError) else str(error)


class QuadrupedWarning(UserWarning):
    """Input that can be used, though something about it may not be as meant."""
