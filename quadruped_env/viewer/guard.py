"""Changes of viser's server, for which it has no parameters: checks of requests, a size limit, queues for threads.

viser accepts every websocket; this package's server accepts its own page only, see `access`.
"""

import asyncio
import logging
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from http import HTTPStatus
from typing import Any, Final

import viser
import websockets.asyncio.server
from viser.infra import _infra
from websockets.asyncio.server import ServerConnection
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from quadruped_env.errors import QuadrupedError
from quadruped_env.viewer.access import AccessRules, page_address

MAX_MESSAGE: Final = 16 * 1024
"""Maximum message size, bytes; camera messages, the longest, have about 300. viser keeps uploads in memory."""
_PATCHING: Final = threading.Lock()
_HEADERS: Final = {
    # Prevents clickjacking: pages of other servers cannot embed this one in a frame.
    "Content-Security-Policy": "frame-ancestors 'self'",
    "X-Frame-Options": "SAMEORIGIN",
    "Cross-Origin-Resource-Policy": "same-origin",
    "X-Content-Type-Options": "nosniff",
}


@contextmanager
def guarded(host: str, allowed: Sequence[str] = ()) -> Iterator[None]:
    """Return a context in which a server that viser starts on a host is guarded; arguments as of `AccessRules`.

    Raises:
        QuadrupedError: if viser did not start its server through `websockets.asyncio.server.serve`.
    """
    rules, module = AccessRules(host, allowed), websockets.asyncio.server
    _infra.AsyncMessageBuffer = _MessageBuffer
    calls = 0

    def process_request(
        then: Callable[..., Response | None], connection: ServerConnection, request: Request
    ) -> Response | None:
        client, port = connection.remote_address, connection.local_address[1]
        headers, websocket = request.headers, "Upgrade" in request.headers
        reason = rules.refusal(port, headers.get_all("Host"), headers.get_all("Origin"), websocket)
        if reason is None:
            response = then(connection, request)
        else:
            logging.getLogger("quadruped_env.viewer").warning("viewer: refused %s:%s: %s", *client[:2], reason)
            body = f"{reason}.\nOpen {page_address(host, port)}\n".encode(errors="replace")
            headers = Headers({"Content-Type": "text/plain; charset=utf-8", "Content-Length": str(len(body))})
            headers["Connection"] = "close"
            response = Response(HTTPStatus.FORBIDDEN, HTTPStatus.FORBIDDEN.phrase, headers, body)
        if response is not None:
            response.headers.update(_HEADERS)
        return response

    with _PATCHING:
        original = module.serve

        def serve(handler: Callable[..., Any], *args: Any, **options: Any) -> Any:
            nonlocal calls
            if handler.__module__ != _infra.__name__:
                return original(handler, *args, **options)
            calls += 1
            options |= {
                "max_size": MAX_MESSAGE,
                "close_timeout": 1.0,
                "process_request": partial(process_request, options["process_request"]),
                # websockets would print a traceback for every client that sends nonsense.
                "logger": logging.Logger("quadruped_env.viewer.websockets", logging.CRITICAL),
            }
            return original(handler, *args, **options)

        setattr(module, "serve", serve)  # noqa: B010  (its type differs)
        try:
            yield
        finally:
            setattr(module, "serve", original)  # noqa: B010
    if not calls:
        raise QuadrupedError(
            f"viser {viser.__version__} starts its server in another way than viser 1.1, so foreign pages "
            f"cannot be refused; pip install 'viser~=1.1.1'"
        )


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
