"""The viewer's server against clients that send what its own page does not."""

import pytest
from viewer_clients import CAMERA, client, close_of, connected_browser, packed, send
from waiting import wait_until
from websockets.exceptions import ConnectionClosed

from quadruped_env.viewer.guard import MAX_MESSAGE

NONSENSE = {
    "bytes": b"\xff\xfe nonsense",
    "empty": b"",
    "text": "hello",
    "no type": packed({"uuid": "x"}),
    "a list": packed([1, 2]),
    "deep": b"\x91" * 10_000 + b"\x90",
    "a camera of text": packed({**CAMERA, "wxyz": ["a"] * 4}),
    "a camera with an axis too few": packed({**CAMERA, "position": (0.0, 0.0)}),
    "an unknown field": packed({**CAMERA, "owner": "x"}),
}


@pytest.mark.parametrize("nonsense", NONSENSE.values(), ids=NONSENSE)
def test_client_that_sends_nonsense_is_closed_with_one_line_and_others_continue(
    show, refusals, capfd, recwarn, nonsense
):
    with connected_browser(show) as other, client(show) as socket:
        for _ in range(10):
            try:
                socket.send(nonsense)
            except ConnectionClosed:
                break
        assert close_of(socket) == 1008
        (line,) = refusals()
        assert "cannot be read" in line or "a text message" in line
        time = show.controller.view().time
        wait_until(lambda: show.controller.view().time > time + 0.1)
        send(other, type="GuiUpdateMessage", uuid=show.panel._velocity._impl.uuid, updates={"value": 0.25})
        wait_until(lambda: show.controller.command[0] == 0.25)
        show.controller.set_command(0.0, 0.0)
        wait_until(lambda: show.panel._velocity.value == 0.0)
    assert "Traceback" not in "".join(capfd.readouterr())
    assert [str(warning.message) for warning in recwarn if "viser" in str(warning.message)] == []


def test_a_message_over_the_limit_closes_the_connection_with_one_line(show, refusals):
    with client(show) as socket:
        socket.send(bytes(MAX_MESSAGE + 1))
        assert close_of(socket) == 1009
    (line,) = wait_until(refusals)
    assert f"over {MAX_MESSAGE} bytes" in line


def test_uploads_are_dropped_with_one_line_and_change_nothing(show, refusals):
    slider = show.panel._velocity
    gui = show._server.gui
    before = slider.value
    with connected_browser(show) as socket:
        for number in range(50):
            upload = {"source_component_uuid": slider._impl.uuid, "transfer_uuid": f"upload {number}"}
            send(
                socket,
                type="FileTransferStartUpload",
                filename="a",
                mime_type="text/plain",
                part_count=2,
                size_bytes=2000,
                **upload,
            )
            send(socket, type="FileTransferPart", part_index=0, content=bytes(1000), **upload)
        # A file of no bytes would be the slider's value at once.
        send(
            socket,
            type="FileTransferStartUpload",
            filename="a",
            mime_type="text/plain",
            part_count=0,
            size_bytes=0,
            source_component_uuid=slider._impl.uuid,
            transfer_uuid="empty",
        )
        after_all_messages(show, socket)
        assert gui._current_file_upload_states == {}
        assert slider.value == before
    (line,) = refusals()
    assert "'FileTransferStartUpload' is not a message that this page sends; dropped" in line


@pytest.mark.parametrize("kind", ["ShareUrlRequest", "ShareUrlDisconnect", "GetRenderResponseMessage", "Nothing"])
def test_messages_that_the_page_does_not_need_are_dropped(show, refusals, kind):
    with connected_browser(show) as socket:
        send(socket, type=kind)
        after_all_messages(show, socket)
    (line,) = refusals()
    assert f"{kind!r} is not a message that this page sends" in line


@pytest.mark.parametrize(
    ("control", "updates"),
    [
        ("_velocity", {"value": "fast"}),
        ("_velocity", {"value": 1e9}),
        ("_velocity", {"value": float("nan")}),
        ("_velocity", {"value": True}),
        ("_velocity", {"value": {"name": "a", "content": b""}}),
        ("_velocity", {"value": 0.1, "update_cb": []}),
        ("_velocity", {"sync_cb": None}),
        ("_velocity", {}),
        ("_clock_buttons", {"value": "Explode"}),
        ("_watched", {"value": "7"}),
        ("_watched", {"value": ["1"]}),
        ("_record", {"value": False}),
        ("_record", {"label": "x"}),
    ],
)
def test_values_that_a_control_cannot_have_are_dropped(show, refusals, control, updates):
    handle = getattr(show.panel, control)
    before = vars(handle._impl).copy()
    with connected_browser(show) as socket:
        send(socket, type="GuiUpdateMessage", uuid=handle._impl.uuid, updates=updates)
        after_all_messages(show, socket)
    assert vars(handle._impl) == before
    assert len(refusals()) == 1
    assert show.controller.view().recorded is None


def after_all_messages(show, socket):
    """Wait until everything that a client has sent is handled: one more message, which moves a slider."""
    strength = show.panel._strength
    value = 0.5 if strength.value != 0.5 else 0.6
    send(socket, type="GuiUpdateMessage", uuid=strength._impl.uuid, updates={"value": value})
    wait_until(lambda: strength.value == value)
