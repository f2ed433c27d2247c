"""Errors and warnings of this package as a program prints them, and its exit status."""

import argparse
import os
import sys
import threading
import warnings
from collections.abc import Callable
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning

ERROR_STATUS: Final = 2
"""Exit status after an error in the input, as of argparse."""
INTERRUPTED_STATUS: Final = 130
"""Exit status after Ctrl-C, as shells have it."""


class CommandFormatter(argparse.RawDescriptionHelpFormatter):
    """Help of a program with subcommands: their summaries stand in one column."""

    def add_argument(self, action: argparse.Action) -> None:
        """See `argparse.HelpFormatter`, which forgets that subcommands are indented further."""
        super().add_argument(action)
        if isinstance(action, argparse._SubParsersAction):
            self._action_max_length += self._indent_increment


def end_with_parent() -> None:
    """Let this process end with the one that started it, in whatever way that ends.

    Its standard input must be a pipe that the parent holds open.
    """
    threading.Thread(target=_exit_at_end_of_input, daemon=True).start()


def _exit_at_end_of_input() -> None:
    while os.read(sys.stdin.fileno(), 1):
        pass
    os._exit(1)


def run_program(prog: str, run: Callable[[], int]) -> int:
    """Run a program: errors and warnings of this package become one line on stderr, `<prog>: error: ...`.

    Args:
        prog: name of the program, as argparse shows it in its own errors.
        run: does the work, and returns the exit status.

    Returns:
        The exit status: that of `run`, or 2 after an error of this package.
    """
    with warnings.catch_warnings():
        usual = warnings.showwarning

        def show(message: Warning | str, category: type[Warning], *rest: Any) -> None:
            if issubclass(category, QuadrupedWarning):
                print(f"{prog}: warning: {message}", file=sys.stderr)
            else:
                usual(message, category, *rest)

        warnings.showwarning = show  # type: ignore[assignment]
        try:
            return run()
        except (QuadrupedError, MissingExtraError) as error:
            print(f"{prog}: error: {error}", file=sys.stderr)
            return ERROR_STATUS
        except BrokenPipeError:
            # The reader of the output has ended. Python would raise this again when it flushes at exit.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return 0
        except KeyboardInterrupt:
            return INTERRUPTED_STATUS
