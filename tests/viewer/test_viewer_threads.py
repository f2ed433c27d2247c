"""Messages that other threads than the server's queue."""

import asyncio
import math
import threading

import numpy as np
from viewer_clients import connected_browser

from quadruped_env.viewer.guard import ThreadSafeEvent


def set_elsewhere(event):
    thread = threading.Thread(target=event.set)
    thread.start()
    thread.join()


def test_another_thread_leaves_the_waiting_tasks_to_the_event_loop():
    async def run():
        event = ThreadSafeEvent(asyncio.get_running_loop())
        first, second = (asyncio.create_task(event.wait()) for _ in range(2))
        await asyncio.sleep(0)
        set_elsewhere(event)
        # The loop has not run since: the other thread did not touch its tasks, of which one is cancelled just now.
        assert not event.is_set()
        first.cancel()
        assert await second
        assert first.cancelled()
        event.clear()
        event.set()
        assert event.is_set()

    asyncio.run(run())


def test_setting_it_after_the_loop_has_ended_is_no_error():
    loop = asyncio.new_event_loop()
    event = ThreadSafeEvent(loop)
    loop.close()
    set_elsewhere(event)
    event.set()
    assert not event.is_set(), "nothing waits for it any more"


def test_arrow_of_a_push_points_where_the_robot_is_pushed(show):
    show.controller.paused = True
    show.controller.reset()
    show._scene.show_push(math.pi / 2, 0.5)
    show._scene.update(show.controller.view())
    ((start, end),) = show._scene._pushes.points
    np.testing.assert_allclose(end - start, [0.0, 0.35 * 0.5, 0.0], atol=1e-6)
    show.controller.paused = False


def test_drawing_reaches_connected_browsers_through_such_events(show):
    with connected_browser(show):
        server = show._server._websock_server
        (client,) = server._client_state_from_id.values()
        for buffer in (server._broadcast_buffer, client.message_buffer):
            assert isinstance(buffer.message_event, ThreadSafeEvent)
