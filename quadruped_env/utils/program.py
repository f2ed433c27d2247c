"""Errors and warnings of this package as a program prints them, and its exit status."""

import argparse
import os
import re
import signal
import sys
import textwrap
import threading
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from types import FrameType
from typing import Any, Final, TextIO

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning, cut, did_you_mean, escaped

ERROR_STATUS: Final = 2
"""Exit status after an error in the input, as of argparse."""
CLEAR_LINE: Final = "\r\x1b[K"
"""Control sequence that clears the terminal line of the cursor, the only one that programs print."""
EXTRAS_STATUS: Final = 3
"""Exit status after the results were written, and a report, page or film was not."""
STOPPING: Final = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Signals that ask a program to end."""


def stopped_status(number: int = signal.SIGINT) -> int:
    """Return the exit status after a signal, as shells have it: 130 after Ctrl-C, 143 after SIGTERM."""
    return 128 + number


class ArgumentParser(argparse.ArgumentParser):
    """A parser whose errors about a mistyped word name the one that was probably meant."""

    def parse_known_args(  # type: ignore[override]
        self, args: Sequence[str] | None = None, namespace: argparse.Namespace | None = None
    ) -> tuple[argparse.Namespace, list[str]]:
        """See `argparse`; unknown arguments are an error here, so that a subcommand's are an error of its parser."""
        found, unknown = super().parse_known_args(args, namespace)
        if unknown:
            hint = did_you_mean(unknown[0].partition("=")[0], self._option_string_actions)
            self.error(f"unrecognized arguments: {' '.join(unknown)}{hint}")
        return found, unknown

    def in_options(self, message: str) -> str:
        """Return a message in which an option stands for the field of a training or a sweep that it begins with."""
        begin = re.match(r"(?:training|sweep)\.(\w+)", message)
        option = f"--{begin[1].replace('_', '-')}" if begin else ""
        return f"{option}{message[begin.end() :]}" if begin and option in self._option_string_actions else message

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        try:
            super()._check_value(action, value)
        except argparse.ArgumentError as error:
            error.message += did_you_mean(value, map(str, action.choices or ()))
            raise


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Help with a description as written, names of options in one piece, and subcommands' summaries in one column."""

    def add_argument(self, action: argparse.Action) -> None:
        """See `argparse.HelpFormatter`, which forgets that subcommands are indented further."""
        super().add_argument(action)
        if isinstance(action, argparse._SubParsersAction):
            self._action_max_length += self._indent_increment

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


class _EscapedOutput:
    """A stream on which names from files cannot control the terminal.

    Control characters are escaped, and so are characters that the terminal's encoding lacks.
    """

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        self._stream.write(CLEAR_LINE.join(escaped(part, keep="\n\r\t") for part in text.split(CLEAR_LINE)))
        return len(text)


def run_program(prog: str, run: Callable[[], int]) -> int:
    """Run a program: errors and warnings of this package become one line on stderr, `<prog>: error: ...`.

    A signal of `STOPPING` ends it as Ctrl-C does, so that no incomplete file stays.

    Args:
        prog: name of the program, as argparse shows it in its own errors.
        run: does the work, and returns the exit status.

    Returns:
        The exit status that `run` returns; 2 after an error of this package, 1 after another one of the system, 130,
        143 or 141 after a signal or when the reader of the output has ended.

    Raises:
        SystemExit: as `run`.
    """

    def stop(number: int) -> None:
        raise KeyboardInterrupt(number)

    out, err = _EscapedOutput(sys.stdout), _EscapedOutput(sys.stderr)
    with redirect_stdout(out), redirect_stderr(err), on_stop(stop), warnings.catch_warnings():
        usual = warnings.showwarning

        def show(message: Warning | str, category: type[Warning], *rest: Any) -> None:
            if issubclass(category, QuadrupedWarning):
                print(f"{prog}: warning: {message}", file=sys.stderr)
            else:
                usual(message, category, *rest)

        warnings.showwarning = show  # type: ignore[assignment]
        return _status(prog, run)


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


def _status(prog: str, run: Callable[[], int]) -> int:
    try:
        try:
            return run()
        finally:
            sys.stdout.flush()
    except (QuadrupedError, MissingExtraError) as error:
        print(f"{prog}: error: {error}", file=sys.stderr)
        return ERROR_STATUS
    except BrokenPipeError:
        _discard_output()
        return stopped_status(signal.SIGPIPE)
    except OSError as error:
        if error.filename is not None:
            print(f"{prog}: error: {cut(f'{error.filename}: {error.strerror}')}", file=sys.stderr)
            return ERROR_STATUS
        _discard_output()
        print(f"{prog}: error: {error.strerror or error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt as error:
        return stopped_status(*error.args)


def _discard_output() -> None:
    """Discard the text that standard output still holds: Python would raise its error again at exit."""
    with suppress(OSError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
