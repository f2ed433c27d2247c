"""Errors and warnings of this package as a program prints them, and its exit status."""

import argparse
import os
import sys
import textwrap
import threading
import warnings
from collections.abc import Callable, Sequence
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning, did_you_mean

ERROR_STATUS: Final = 2
"""Exit status after an error in the input, as of argparse."""
INTERRUPTED_STATUS: Final = 130
"""Exit status after Ctrl-C, as shells have it."""


_SYNONYMS: Final = {
    "--lr": "--learning-rate",
    "--gpu": "--device cuda",
    "--cuda": "--device cuda",
    "--steps": "--timesteps",
    "--envs": "--num-envs",
    "--epochs": "--n-epochs",
    "--episodes": "--seeds",
    "--out": "--output",
}
"""Options that other programs have -> their names here, which are not spelled like them."""


class ArgumentParser(argparse.ArgumentParser):
    """A parser whose errors about a mistyped word name the one that was probably meant."""

    def parse_known_args(  # type: ignore[override]
        self, args: Sequence[str] | None = None, namespace: argparse.Namespace | None = None
    ) -> tuple[argparse.Namespace, list[str]]:
        """See `argparse`; unknown arguments are an error here, so that a subcommand's are an error of its parser."""
        found, unknown = super().parse_known_args(args, namespace)
        if unknown:
            option = unknown[0].partition("=")[0]
            meant = _SYNONYMS.get(option, "")
            known = meant.split(" ")[0] in self._option_string_actions
            hint = f"; did you mean {meant}?" if known else did_you_mean(option, self._option_string_actions)
            self.error(f"unrecognized arguments: {' '.join(unknown)}{hint}")
        return found, unknown

    def _get_value(self, action: argparse.Action, arg_string: str) -> Any:
        """See `argparse`; the case of a choice does not count."""
        value = super()._get_value(action, arg_string)
        if action.choices is None or value in action.choices or not isinstance(value, str):
            return value
        return value.lower() if value.lower() in action.choices else value

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        try:
            super()._check_value(action, value)
        except argparse.ArgumentError as error:
            error.message += did_you_mean(value, map(str, action.choices or ()))
            raise


class HelpAll(argparse._HelpAction):
    """The option `--help-all`, which also describes what `--help` leaves out."""

    hidden: dict[argparse.Action, str | None]
    """Options that `--help` leaves out, with their help."""

    def __call__(self, parser: argparse.ArgumentParser, *rest: Any, **options: Any) -> None:
        """See `argparse`."""
        for action, text in self.hidden.items():
            action.help = text
        super().__call__(parser, *rest, **options)


def shorten_help(parser: argparse.ArgumentParser, *shown: str) -> None:
    """Let `--help` describe some options only, and `--help-all` all of them.

    Args:
        parser: with its options.
        shown: options that most users need.
    """
    hidden = {
        action: action.help
        for action in parser._actions
        if action.option_strings and action.help != argparse.SUPPRESS and not {"-h", *shown} & {*action.option_strings}
    }
    names = " ".join(action.option_strings[0] for action in hidden)
    option = parser.add_argument("--help-all", action=HelpAll, help=f"describe all options, these too: {names}")
    option.hidden = hidden  # type: ignore[attr-defined]
    for action in hidden:
        action.help = argparse.SUPPRESS


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Help with a description as written, names of options in one piece, and subcommands' summaries in one column."""

    def add_argument(self, action: argparse.Action) -> None:
        """See `argparse.HelpFormatter`, which forgets that subcommands are indented further."""
        super().add_argument(action)
        if isinstance(action, argparse._SubParsersAction):
            self._action_max_length += self._indent_increment

    def add_usage(self, usage: str | None, actions: Any, groups: Any, prefix: str | None = None) -> None:
        """See `argparse`, which fails on a group of options that are all hidden (before Python 3.13)."""
        shown = [one for one in groups if any(action.help != argparse.SUPPRESS for action in one._group_actions)]
        super().add_usage(usage, actions, shown, prefix)

    def _split_lines(self, text: str, width: int) -> list[str]:
        return textwrap.wrap(" ".join(text.split()), width, break_on_hyphens=False)


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
