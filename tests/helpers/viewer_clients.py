"""Clients of the viewer's server: websockets and HTTP, under any name and origin."""

import contextlib
import http.client
import socket

import pytest
from waiting import wait_until

viser = pytest.importorskip("viser")
pytest.importorskip("mjviser")

import msgspec  # noqa: E402
from websockets.exceptions import ConnectionClosed  # noqa: E402
from websockets.sync.client import connect  # noqa: E402

PROTOCOL = f"viser-v{viser.__version__}"
CAMERA = {
    "type": "ViewerCameraMessage",
    "wxyz": (1.0, 0.0, 0.0, 0.0),
    "position": (1.0, 0.0, 1.0),
    "fov": 0.9,
    "near": 0.1,
    "far": 100,
    "image_height": 480,
    "image_width": 640,
    "look_at": (0.0, 0.0, 0.0),
    "up_direction": (0.0, 0.0, 1.0),
}


def client(show, host="127.0.0.1", port=None, origin="http://{host}:{port}", protocol=PROTOCOL):
    """A websocket to a show under any host name, as a browser connects under the control of a malicious DNS server."""
    origin = origin and origin.format(host=host, port=port or show.port)
    there = socket.create_connection(("127.0.0.1", show.port))
    # Without a limit on the queue, the client receives messages that it does not read.
    return connect(
        f"ws://{host}:{port or show.port}", sock=there, origin=origin, subprotocols=[protocol], max_queue=None
    )


def connected_browser(show):
    """A websocket that has sent its camera and received the whole scene."""
    before = {client.client_id for client in show.clients()}
    socket = client(show)
    send(socket, **CAMERA)
    wait_until(lambda: {client.client_id for client in show.clients()} - before)
    return socket


def packed(message):
    """Bytes of a message as the page sends it."""
    return msgspec.msgpack.encode(message)


def send(socket, **message):
    socket.send(packed(message))


def get(show, path="/", **headers):
    with contextlib.closing(http.client.HTTPConnection("127.0.0.1", show.port)) as connection:
        connection.request("GET", path, headers=headers)
        response = connection.getresponse()
        return response, response.read()


def close_of(socket):
    """Read until the server closes; the code of its closing frame."""
    with contextlib.suppress(ConnectionClosed):
        for _ in socket:
            pass
    return socket.close_code
