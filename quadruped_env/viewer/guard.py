"""Changes of viser's server, for which it has no parameters: checks of requests and messages, and queues for threads.

viser accepts every websocket, lets messages change any field of a control, and keeps uploads in memory. The page of
this package needs three kinds of messages: camera pose, control value, and key or command. Only these pass, with values
that are valid for the control.
"""

import asyncio
import logging
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from http import HTTPStatus
from typing import Any, Final

import msgspec
import viser
import websockets.asyncio.server
from viser import _messages
from viser.infra import _infra
from websockets.asyncio.server import ServerConnection
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.interpreter import pip_command
from quadruped_env.viewer.access import AccessRules, page_address

MAX_MESSAGE: Final = 16 * 1024
"""Maximum message size, bytes; camera messages, the longest, have about 300."""
LOG_PERIOD: Final = 10.0
"""Minimum time between log lines about refusals of the same kind, s."""
_POLICY_VIOLATION, _TOO_BIG = 1008, 1009
_PATCHING: Final = threading.Lock()
_HEADERS: Final = {
    # Prevents clickjacking: pages of other servers cannot embed this one in a frame.
    "Content-Security-Policy": "frame-ancestors 'self'",
    "X-Frame-Options": "SAMEORIGIN",
    "Cross-Origin-Resource-Policy": "same-origin",
    "X-Content-Type-Options": "nosniff",
}
_ACCEPTED: Final[dict[str, Any]] = {
    kind.__name__: kind
    for kind in (_messages.ViewerCameraMessage, _messages.GuiUpdateMessage, _messages.CommandTriggerMessage)
}


class Guard:
    """All checks in front of viser's server.

    Args:
        host: the address that the server listens on.
        allowed: further hosts under which browsers reach it, see `AccessRules`.
    """

    def __init__(self, host: str, allowed: Sequence[str] = ()) -> None:
        self.gui: viser.GuiApi | None = None
        """Controls of the page, set once the server has started."""
        self._host = host
        self._rules = AccessRules(host, allowed)
        self._next_log: dict[str, float] = {}

    @contextmanager
    def installed(self) -> Iterator[None]:
        """A context in which a server that viser starts is guarded.

        Raises:
            QuadrupedError: if viser did not start its server through `websockets.asyncio.server.serve`.
        """
        module: Any = websockets.asyncio.server
        _infra.AsyncMessageBuffer = _MessageBuffer
        calls = 0
        with _PATCHING:
            original = module.serve

            def serve(handler: Callable[..., Any], *args: Any, **options: Any) -> Any:
                nonlocal calls
                if handler.__module__ != _infra.__name__:
                    return original(handler, *args, **options)
                calls += 1
                return original(partial(self._handle, handler), *args, **self._options(options))

            module.serve = serve
            try:
                yield
            finally:
                module.serve = original
        if not calls:
            raise QuadrupedError(
                f"viser {viser.__version__} starts its server in another way than viser 1.1, so foreign pages "
                f"cannot be refused; {pip_command()} 'viser~=1.1.1'"
            )

    def refuse(self, kind: str, reason: str, connection: ServerConnection) -> None:
        """Log a refusal, the first of its kind at once and further ones once per `LOG_PERIOD`."""
        now = time.monotonic()
        if now >= self._next_log.get(kind, 0.0):
            self._next_log[kind] = now + LOG_PERIOD
            host, port = (connection.remote_address or ("a client that has gone", 0))[:2]
            logging.getLogger("quadruped_env.viewer").warning("viewer: refused %s:%s: %s", host, port, reason)

    def _options(self, options: dict[str, Any]) -> dict[str, Any]:
        # websockets would print a traceback for every client that does not speak HTTP.
        silent = logging.Logger("quadruped_env.viewer.websockets", logging.CRITICAL)
        return {
            **options,
            "max_size": MAX_MESSAGE,
            "close_timeout": 1.0,
            "process_request": partial(self._process_request, options["process_request"]),
            "create_connection": partial(GuardedConnection, self),
            "logger": silent,
        }

    def _process_request(
        self, then: Callable[..., Response | None], connection: ServerConnection, request: Request
    ) -> Response | None:
        port = connection.local_address[1]
        reason = self._rules.refusal(port, request.headers.get_all("Host"), request.headers.get_all("Origin"))
        if reason is not None:
            self.refuse("request", reason, connection)
            body = f"{reason}.\nOpen {page_address(self._host, port)}\n".encode(errors="replace")
            headers = Headers({"Content-Type": "text/plain; charset=utf-8", "Content-Length": str(len(body))})
            headers.update({**_HEADERS, "Connection": "close"})
            return Response(HTTPStatus.FORBIDDEN, HTTPStatus.FORBIDDEN.phrase, headers, body)
        response = then(connection, request)
        if response is not None:
            response.headers.update(_HEADERS)
        return response

    async def _handle(self, then: Callable[..., Any], connection: ServerConnection) -> None:
        try:
            await then(connection)
        except Exception as error:
            self.refuse("error", f"its connection failed with {error!r:.200}", connection)
        sent = connection.protocol.close_sent
        if sent is not None and sent.code == _TOO_BIG:
            self.refuse("size", f"a message of over {MAX_MESSAGE} bytes; the connection is closed", connection)

    def problem(self, raw: object) -> str:
        """The reason to drop a message; empty if it passes.

        Raises:
            ValueError: if it is not a message of viser's page.
        """
        if not isinstance(raw, bytes):
            raise ValueError("a text message; expected binary ones")
        try:
            kind = msgspec.msgpack.decode(raw, type=_Kind).type
            if kind not in _ACCEPTED:
                return f"{kind[:40]!r} is not a message that this page sends"
            message = msgspec.msgpack.decode(raw, type=_ACCEPTED[kind])
            # Decode it as viser does, to catch everything else that viser would fail on.
            _messages.Message.deserialize(raw)
        except Exception as error:
            # Untrusted bytes may make a decoder raise any exception.
            raise ValueError(f"a message that cannot be read ({type(error).__name__})") from error
        if not isinstance(message, _messages.GuiUpdateMessage):
            return ""
        handle = None if self.gui is None else self.gui._gui_input_handle_from_uuid.get(message.uuid)
        if handle is None:
            # The control was removed in the meantime; viser ignores the message too.
            return ""
        if list(message.updates) != ["value"]:
            return "an update of more than a control's value"
        value = message.updates["value"]
        return "" if _can_have(handle, value) else f"{repr(value)[:40]} is not a valid value of that control"


class _Kind(msgspec.Struct):
    type: str


def _can_have(handle: Any, value: Any) -> bool:
    """True if the value is valid for the control."""
    match handle:
        case viser.GuiSliderHandle():
            # The browser accumulates steps with rounding errors.
            slack = 1e-6 * (handle.max - handle.min)
            number = isinstance(value, (int, float)) and not isinstance(value, bool)
            return number and handle.min - slack <= value <= handle.max + slack
        case viser.GuiCheckboxHandle():
            return isinstance(value, bool)
        case viser.GuiButtonHandle():
            return value is True
        case viser.GuiDropdownHandle() | viser.GuiButtonGroupHandle():
            return isinstance(value, str) and value in handle.options
    return False


class GuardedConnection(ServerConnection):
    """A websocket that hands only messages to viser that pass a guard; it logs the first of the others."""

    def __init__(self, guard: Guard, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._guard = guard
        self._has_refused = False

    async def recv(self, decode: bool | None = None) -> Any:
        """The next message that passes. After one that cannot be read the connection is closed."""
        while True:
            raw = await super().recv(decode)
            try:
                problem = self._guard.problem(raw)
            except ValueError as error:
                self._refuse(f"{error}; the connection is closed")
                await self.close(_POLICY_VIOLATION, "not a message of this page")
                continue  # recv then raises the exception that viser expects from a closed connection
            if not problem:
                return raw
            self._refuse(f"{problem}; dropped")

    def _refuse(self, reason: str) -> None:
        if not self._has_refused:
            self._guard.refuse("message", reason, self)
        self._has_refused = True


class ThreadSafeEvent(asyncio.Event):
    """An event that any thread may set.

    viser wakes its connections through an `asyncio.Event`, and also sets it in the thread that queues a message. If a
    browser leaves at that moment, drawing fails, or the other browsers are no longer woken.

    Args:
        loop: event loop of the tasks that wait for it.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        super().__init__()
        self._of_loop = loop

    def set(self) -> None:
        """Set it: at once in the thread of the loop, else as soon as the loop gets to it."""
        if asyncio._get_running_loop() is self._of_loop:
            super().set()
            return
        try:
            self._of_loop.call_soon_threadsafe(super().set)
        except RuntimeError:
            # The loop is closed, and nothing waits any more. Queuing a message to a stopped server is no error.
            if not self._of_loop.is_closed():
                raise


class _MessageBuffer(_infra.AsyncMessageBuffer):
    """A queue of viser's messages to which any thread may add."""

    def __init__(self, event_loop: asyncio.AbstractEventLoop, *args: Any, **kwargs: Any) -> None:
        super().__init__(event_loop, *args, message_event=ThreadSafeEvent(event_loop), **kwargs)
