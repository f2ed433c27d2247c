"""The viewer's server against clients that send what its own page does not."""

import pytest
from viewer_clients import CAMERA, client, close_of, connected_browser, packed, send
from waiting import wait_until
from websockets.exceptions import ConnectionClosed

from quadruped_env.viewer.guard import MAX_MESSAGE

NONSENSE = {
    "bytes": b"\xff\xfe nonsense",
    "text": "hello",
    "no type": packed({"uuid": "x"}),
    "deep": b"\x91" * 10_000 + b"\x90",
    "an unknown field": packed({**CAMERA, "owner": "x"}),
    "too long": bytes(MAX_MESSAGE + 1),
}


@pytest.mark.parametrize("nonsense", NONSENSE.values(), ids=NONSENSE)
def test_client_that_sends_nonsense_is_closed_without_a_traceback_and_others_continue(show, capfd, nonsense):
    with connected_browser(show) as other, client(show) as socket:
        try:
            for _ in range(10):
                socket.send(nonsense)
        except ConnectionClosed:
            pass
        assert close_of(socket) == (1009 if len(nonsense) > MAX_MESSAGE else 1011)
        time = show.controller.view().time
        wait_until(lambda: show.controller.view().time > time + 0.1)
        send(other, type="GuiUpdateMessage", uuid=show.panel._velocities[0]._impl.uuid, updates={"value": 0.25})
        wait_until(lambda: show.controller.command[0] == 0.25)
        show.controller.set_command(0.0, 0.0)
        wait_until(lambda: show.panel._velocities[0].value == 0.0)
    assert "Traceback" not in "".join(capfd.readouterr())
