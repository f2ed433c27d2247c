"""Lets other threads than the server's queue messages for viser's connections.

viser wakes its connections through an `asyncio.Event`, which only the thread of its event loop may set. It sets it in
the thread that queues a message too: if a browser leaves at that moment, drawing fails, or the other browsers are no
longer woken.
"""

import asyncio
from typing import Any

from viser.infra import _infra


class WakeUp(asyncio.Event):
    """An event that any thread may set.

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


class MessageBuffer(_infra.AsyncMessageBuffer):
    """A queue of viser's messages to which any thread may add."""

    def __init__(self, event_loop: asyncio.AbstractEventLoop, *args: Any, **kwargs: Any) -> None:
        super().__init__(event_loop, *args, message_event=WakeUp(event_loop), **kwargs)


def install() -> None:
    """Make every server that viser starts in this process use such queues; viser has no parameter for this."""
    _infra.AsyncMessageBuffer = MessageBuffer
