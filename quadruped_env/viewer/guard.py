"""Checks in front of viser's server: the origin of requests, and the messages of browsers.

viser accepts every websocket, lets messages change any field of a control, and keeps uploads in memory. The page of
this package needs three kinds of messages: camera pose, control value, and key or command. Only these pass, with values
that are valid for the control.
"""

import asyncio
import gzip
import logging
import math
import threading
import time
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager
from functools import partial
from http import HTTPStatus
from typing import Any, Final

import msgspec
import viser
import websockets.asyncio.server
from viser import _messages
from websockets.asyncio.server import ServerConnection
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.interpreter import pip_command
from quadruped_env.viewer.access import LOG, AccessRules, Refusal, RefusalLog, page_address

MAX_MESSAGE: Final = 16 * 1024
"""Maximum message size, bytes; camera messages, the longest, have about 300."""
MAX_CLIENTS: Final = 32
MAX_RATE: Final = 500.0
"""Maximum messages per second and client; further ones wait in the client."""
_BURST: Final = 1.0
"""Burst allowance of a client over `MAX_RATE`, s."""
_CLOSE_TIMEOUT: Final = 1.0
"""Time for a refused client to answer the close frame, s."""
_POLICY_VIOLATION, _PROTOCOL_ERROR, _TOO_BIG = 1008, 1002, 1009
_VISER_SERVER_MODULE: Final = "viser.infra._infra"
_PATCHING: Final = threading.Lock()
_TITLE: Final = "MiniQuadruped"
_HEADERS: Final = {
    # Prevents clickjacking: pages of other servers cannot embed this one in a frame.
    "Content-Security-Policy": "frame-ancestors 'self'",
    "X-Frame-Options": "SAMEORIGIN",
    "Cross-Origin-Resource-Policy": "same-origin",
    "X-Content-Type-Options": "nosniff",
}

_Handler = Callable[[ServerConnection], Awaitable[None]]
_ProcessRequest = Callable[[ServerConnection, Request], Response | None]


class InvalidMessageError(Exception):
    """A client sent a message that this server's page never sends."""


class MessageFilter:
    """Passes only the messages that the page needs. `gui` is set once the server has started."""

    def __init__(self) -> None:
        self.gui: viser.GuiApi | None = None

    def unwanted(self, raw: object) -> str:
        """The reason to drop a message; empty if it passes.

        Raises:
            InvalidMessageError: if it is not a message of viser's page.
        """
        if not isinstance(raw, bytes):
            raise InvalidMessageError("a text message; expected binary ones")
        try:
            kind = msgspec.msgpack.decode(raw, type=_Kind).type
            message_type = _ACCEPTED.get(kind)
            if message_type is None:
                return f"{kind[:40]!r} is not a message that this page sends"
            message = msgspec.msgpack.decode(raw, type=message_type)
            # Decode it as viser does, to catch everything else that viser would fail on.
            _messages.Message.deserialize(raw)
        except Exception as error:
            # Untrusted bytes may make a decoder raise any exception.
            raise InvalidMessageError(f"a message that cannot be read ({type(error).__name__})") from error
        if isinstance(message, _messages.ViewerCameraMessage):
            return "" if _is_finite(message) else "a camera that is not finite"
        if isinstance(message, _messages.GuiUpdateMessage):
            return self._unwanted_update(message)
        return ""

    def _unwanted_update(self, message: _messages.GuiUpdateMessage) -> str:
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


_ACCEPTED: Final[dict[str, Any]] = {
    kind.__name__: kind
    for kind in (_messages.ViewerCameraMessage, _messages.GuiUpdateMessage, _messages.CommandTriggerMessage)
}


def _is_finite(camera: _messages.ViewerCameraMessage) -> bool:
    vectors = (camera.wxyz, camera.position, camera.look_at, camera.up_direction)
    return all(map(math.isfinite, (*sum(vectors, ()), camera.fov, camera.near, camera.far)))


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
    """A websocket that hands only filtered messages to viser.

    Args:
        messages: the filter.
        refusals: log of dropped messages, one line per connection.
    """

    def __init__(self, messages: MessageFilter, refusals: RefusalLog, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._messages, self._refusals = messages, refusals
        self._has_refused = False
        self._due = 0.0

    async def recv(self, decode: bool | None = None) -> Any:
        """The next message that passes the filter. After one that cannot be read the connection is closed."""
        while True:
            raw = await super().recv(decode)
            await self._keep_rate()
            try:
                problem = self._messages.unwanted(raw)
            except InvalidMessageError as error:
                self._refuse(Refusal("invalid", f"{error}; the connection is closed"))
                await self.close(_POLICY_VIOLATION, "not a message of this page")
                continue  # recv then raises the exception that viser expects from a closed connection
            if not problem:
                return raw
            self._refuse(Refusal("message", f"{problem}; dropped"))

    def _refuse(self, refusal: Refusal) -> None:
        if not self._has_refused:
            self._refusals.add(refusal, _client(self))
        self._has_refused = True

    async def _keep_rate(self) -> None:
        now = time.monotonic()
        self._due = max(self._due, now - _BURST) + 1.0 / MAX_RATE
        if self._due > now:
            await asyncio.sleep(self._due - now)


class Guard:
    """All checks in front of viser's server.

    Args:
        host: the address that the server listens on.
    """

    def __init__(self, host: str) -> None:
        self.messages = MessageFilter()
        self._host = host
        self._rules = AccessRules(host)
        self._refusals = RefusalLog()
        self._pages: dict[bool, bytes] = {}

    @contextmanager
    def installed(self) -> Iterator[None]:
        """A context in which a server that viser starts is guarded.

        viser has no parameter for this, so `websockets.asyncio.server.serve` is patched while viser starts.

        Raises:
            QuadrupedError: if viser did not start its server through `serve`.
        """
        module: Any = websockets.asyncio.server
        calls = 0
        with _PATCHING:
            original = module.serve

            def serve(handler: _Handler, *args: Any, **options: Any) -> Any:
                nonlocal calls
                if handler.__module__ != _VISER_SERVER_MODULE:
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

    def _options(self, options: dict[str, Any]) -> dict[str, Any]:
        """Options of `serve`; called in the server's event loop."""
        asyncio.get_running_loop().set_exception_handler(_log_error)
        return {
            **options,
            "max_size": MAX_MESSAGE,
            "close_timeout": _CLOSE_TIMEOUT,
            "process_request": partial(self._process_request, options["process_request"]),
            "create_connection": partial(GuardedConnection, self.messages, self._refusals),
            "logger": self._logger(),
        }

    def _process_request(
        self, then: _ProcessRequest, connection: ServerConnection, request: Request
    ) -> Response | None:
        headers = request.headers
        port = connection.local_address[1]
        refusal = self._rules.refusal(port, headers.get_all("Host"), headers.get_all("Origin"))
        if refusal is not None:
            self._refusals.add(refusal, _client(connection))
            return _answer(HTTPStatus.FORBIDDEN, f"{refusal.reason}.\nOpen {page_address(self._host, port)}\n")
        response = then(connection, request)
        if response is not None:
            return self._page(response)
        if len(connection.server.connections) >= MAX_CLIENTS:
            self._refusals.add(Refusal("clients", f"{MAX_CLIENTS} browsers are connected already"), _client(connection))
            return _answer(
                HTTPStatus.SERVICE_UNAVAILABLE, f"{MAX_CLIENTS} browsers are connected already; close one.\n"
            )
        return None

    def _page(self, response: Response) -> Response:
        """Page of viser with this project's title and security headers."""
        for name, value in _HEADERS.items():
            response.headers[name] = value
        if not response.headers.get("Content-Type", "").startswith("text/html") or response.body is None:
            return response
        packed = response.headers["Content-Encoding"] == "gzip"
        if packed not in self._pages:
            page = gzip.decompress(response.body) if packed else bytes(response.body)
            page = page.replace(b"<title>Viser</title>", b"<title>%s</title>" % _TITLE.encode())
            self._pages[packed] = gzip.compress(page) if packed else page
        response.body = self._pages[packed]
        del response.headers["Content-Length"]
        response.headers["Content-Length"] = str(len(response.body))
        return response

    async def _handle(self, then: _Handler, connection: ServerConnection) -> None:
        version = (connection.subprotocol or "viser-vunknown").removeprefix("viser-v")
        if version != viser.__version__:
            # viser would print one line per connection.
            reason = f"the page is of viser {version[:20]}, the server of viser {viser.__version__}; reload the page"
            self._refusals.add(Refusal("version", reason), _client(connection))
            await connection.close(
                _PROTOCOL_ERROR, f"Version mismatch. Client: {version[:20]}, Server: {viser.__version__}"
            )
            return
        try:
            await then(connection)
        except Exception as error:
            self._refusals.add(Refusal("error", f"its connection failed with {error!r:.200}"), _client(connection))
            await connection.close(1011)
        sent = connection.protocol.close_sent
        if sent is not None and sent.code == _TOO_BIG:
            reason = f"a message of over {MAX_MESSAGE} bytes; the connection is closed"
            self._refusals.add(Refusal("size", reason), _client(connection))

    def _logger(self) -> logging.Logger:
        """Logger for websockets, which would print a traceback for every client that does not speak HTTP."""
        logger = logging.Logger("quadruped_env.viewer.websockets", logging.ERROR)
        logger.addHandler(_Refuser(self._refusals))
        return logger


class _Refuser(logging.Handler):
    """Turns the errors that websockets logs into refusals."""

    def __init__(self, refusals: RefusalLog) -> None:
        super().__init__(logging.ERROR)
        self._refusals = refusals

    def emit(self, record: logging.LogRecord) -> None:
        error = record.exc_info[1] if record.exc_info else None
        reason = f"{record.getMessage()} ({type(error).__name__})" if error else record.getMessage()
        connection = getattr(record, "websocket", None)
        self._refusals.add(Refusal("websockets", reason[:200]), _client(connection) if connection else "a client")


def _client(connection: ServerConnection) -> str:
    address = connection.remote_address
    return f"{address[0]}:{address[1]}" if address else "a client that has gone"


def _answer(status: HTTPStatus, text: str) -> Response:
    body = text.encode(errors="replace")
    headers = Headers({"Content-Type": "text/plain; charset=utf-8", "Content-Length": str(len(body)), **_HEADERS})
    headers["Connection"] = "close"
    return Response(status, status.phrase, headers, body)


def _log_error(_: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    """Replaces asyncio's handler, which prints a traceback for each message that viser fails on."""
    LOG.warning("viewer: %.200s", context.get("exception") or context["message"])
