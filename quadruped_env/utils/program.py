"""Errors and warnings of this package as a program prints them, and its exit status."""

import argparse
import os
import signal
import sys
import textwrap
import threading
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from types import FrameType
from typing import Any, Final, TextIO

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning, cut, did_you_mean, escaped

ERROR_STATUS: Final = 2
"""Exit status after an error in the input, as of argparse."""
SYSTEM_ERROR_STATUS: Final = 1
"""Exit status after the system refused something that is no input, such as to print."""
CLEAR_LINE: Final = "\r\x1b[K"
"""Control sequence that clears the terminal line of the cursor, the only one that programs print."""
EXTRAS_STATUS: Final = 3
"""Exit status after the results were written, and a report, page or film was not."""
STOPPING: Final = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Signals that ask a program to end."""


class Stopped(KeyboardInterrupt):
    """A signal ended the program.

    Args:
        number: of the signal.
    """

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


def stopped_status(number: int = signal.SIGINT) -> int:
    """Exit status after a signal, as shells have it: 130 after Ctrl-C, 143 after SIGTERM."""
    return 128 + number


_SYNONYMS: Final = {
    "--lr": "--learning-rate",
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

    def in_options(self, message: str) -> str:
        """A message with the option in place of the field's name with which it begins, if it begins with one."""
        name = message.partition(":")[0]
        option = f"--{name.replace('_', '-')}"
        return f"{option}{message.removeprefix(name)}" if option in self._option_string_actions else message

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


@contextmanager
def on_stop(handler: Callable[[int], None]) -> Iterator[Callable[[], None]]:
    """Within it, a handler receives the signals of `STOPPING`; outside the main thread, none arrives.

    SIGHUP, which a closed terminal sends, counts as SIGTERM, and stays ignored under nohup.

    Args:
        handler: called with the number of the signal.

    Yields:
        A function that ends the handling before the context does.
    """
    previous: dict[int, Any] = {}

    def receive(number: int, frame: FrameType | None) -> None:
        handler(signal.SIGTERM if number == signal.SIGHUP else number)

    def restore() -> None:
        while previous:
            signal.signal(*previous.popitem())

    if threading.current_thread() is threading.main_thread():
        for number in STOPPING:
            if number != signal.SIGHUP or signal.getsignal(number) != signal.SIG_IGN:
                previous[number] = signal.signal(number, receive)
    try:
        yield restore
    finally:
        restore()


class _Output:
    """Standard output or error of a program, which says whatever a name from a file holds, and outlives its reader.

    Control characters are escaped, and characters that the terminal's encoding lacks. After the stream cannot be
    written (a closed pipe, a full disk), the rest is dropped and the program goes on.

    Args:
        stream: the stream.
        needed: True if the program is of no use without it; then it ends.
    """

    def __init__(self, stream: TextIO, needed: bool = False) -> None:
        self._stream, self.needed = stream, needed
        self.error: OSError | None = None
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        safe = CLEAR_LINE.join(escaped(part, keep="\n\r\t") for part in text.split(CLEAR_LINE))
        self._try(lambda: self._stream.write(safe))
        return len(text)

    def flush(self) -> None:
        self._try(self._stream.flush)

    def _try(self, use: Callable[[], object]) -> None:
        if self.error is not None:
            return
        try:
            use()
        except OSError as error:
            self.error = error
            # Python would raise this again when it flushes at exit.
            os.dup2(os.open(os.devnull, os.O_WRONLY), self._stream.fileno())
            if self.needed:
                raise SystemExit(0) from error


@contextmanager
def outputs(needed: bool = False) -> Iterator[Callable[[], OSError | None]]:
    """Within it, names from files cannot control the terminal, and a program outlives the reader of its output.

    Args:
        needed: True if the program is of no use without its standard output; see `_Output`.

    Yields:
        A function that returns the error of standard output, if it cannot be written for another reason than that its
        reader ended.
    """
    out, err = _Output(sys.stdout, needed), _Output(sys.stderr)

    def failure() -> OSError | None:
        out.needed = False
        out.flush()
        return None if isinstance(out.error, BrokenPipeError) else out.error

    with redirect_stdout(out), redirect_stderr(err):
        yield failure


def run_program(prog: str, run: Callable[[], int], needs_output: bool = False) -> int:
    """Run a program: errors and warnings of this package become one line on stderr, `<prog>: error: ...`.

    A signal of `STOPPING` ends it as Ctrl-C does, so that no incomplete file stays.

    Args:
        prog: name of the program, as argparse shows it in its own errors.
        run: does the work, and returns the exit status.
        needs_output: True if the program ends when the reader of its output does, since it only prints.

    Returns:
        The exit status: that of `run`; 2 after an error of this package, 1 after another one of the system, 130 or 143
        after a signal.

    Raises:
        SystemExit: as `run`.
    """

    def stop(number: int) -> None:
        raise Stopped(number)

    with outputs(needs_output) as failure, on_stop(stop), warnings.catch_warnings():
        usual = warnings.showwarning

        def show(message: Warning | str, category: type[Warning], *rest: Any) -> None:
            if issubclass(category, QuadrupedWarning):
                print(f"{prog}: warning: {message}", file=sys.stderr)
            else:
                usual(message, category, *rest)

        warnings.showwarning = show  # type: ignore[assignment]
        try:
            status = _status(prog, run)
        except SystemExit as end:  # argparse, after it has printed the help
            status = end.code if isinstance(end.code, int) else 0
            if failure() is None:
                raise
        error = failure()
        if error is not None:
            print(f"{prog}: error: standard output cannot be written ({error.strerror})", file=sys.stderr)
        return status or (SYSTEM_ERROR_STATUS if error else 0)


class Extras:
    """The parts of a result beyond its numbers, such as a report or a film: each fails alone, with a line."""

    status = 0
    """Exit status: `EXTRAS_STATUS` after one has failed."""

    @contextmanager
    def part(self, name: str, of_some_only: bool = False) -> Iterator[None]:
        """Within it, an error means only that this part is missing.

        Args:
            name: of the part, for the line.
            of_some_only: True if a `QuadrupedError` says that it cannot be made of this input, which is no failure.
        """
        try:
            yield
        except Exception as error:  # whatever a library for plots, films or files raises
            known = isinstance(error, QuadrupedError | MissingExtraError)
            if not (of_some_only and isinstance(error, QuadrupedError)):
                self.status = EXTRAS_STATUS
            print(f"no {name}: {'' if known else f'{type(error).__name__}: '}{error}", file=sys.stderr)


def _has_directory() -> bool:
    """True unless the working directory was deleted."""
    try:
        os.getcwd()
    except FileNotFoundError:
        return False
    return True


def _status(prog: str, run: Callable[[], int]) -> int:
    try:
        return run()
    except (QuadrupedError, MissingExtraError) as error:
        print(f"{prog}: error: {error}", file=sys.stderr)
        return ERROR_STATUS
    except OSError as error:
        if error.filename is not None:
            print(f"{prog}: error: {cut(f'{error.filename}: {error.strerror}')}", file=sys.stderr)
            return ERROR_STATUS
        reason = error.strerror or error if _has_directory() else "the working directory was deleted; change to another"
        print(f"{prog}: error: {reason}", file=sys.stderr)
        return SYSTEM_ERROR_STATUS
    except KeyboardInterrupt as error:
        return stopped_status(error.number if isinstance(error, Stopped) else signal.SIGINT)
