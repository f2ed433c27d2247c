"""The viewer's server against foreign pages and foreign names."""

import functools
import http.server
import re
import threading
from types import SimpleNamespace

import pytest
from viewer_clients import PROTOCOL, client, get
from waiting import wait_until
from websockets.exceptions import InvalidStatus

from quadruped_env import QuadrupedError
from quadruped_env.viewer.guard import guarded


def test_a_websocket_of_this_servers_page_is_accepted(show):
    for host in ("127.0.0.1", "localhost"):
        with client(show, host) as socket:
            assert len(socket.recv()) > 1000


@pytest.mark.parametrize(
    ("host", "port", "origin", "word"),
    [
        ("127.0.0.1", None, "http://evil.example", "Origin is 'http://evil.example': a foreign page"),
        ("127.0.0.1", None, "null", "Origin is 'null'"),
        ("127.0.0.1", None, None, "Origin is missing"),
        ("evil.example", None, "http://evil.example:{port}", "Host is 'evil.example:{port}'"),
        ("127.0.0.1", 1, None, "Host is '127.0.0.1:1'"),
    ],
)
def test_a_websocket_of_a_foreign_page_or_name_is_refused_with_one_line(show, refusals, host, port, origin, word):
    with pytest.raises(InvalidStatus) as refused:
        client(show, host, port, origin)
    assert refused.value.response.status_code == 403
    (line,) = refusals()
    assert word.format(port=show.port) in line
    with client(show) as socket:
        assert socket.recv()


def test_a_page_under_a_foreign_name_is_refused(show):
    response, body = get(show, Host=f"evil.example:{show.port}")
    assert response.status == 403
    assert f"Open {show.address}".encode() in body
    assert get(show, Origin="http://evil.example")[0].status == 403


def test_the_page_may_not_be_framed(show):
    response, _ = get(show)
    assert response.status == 200
    assert response.headers["Content-Security-Policy"] == "frame-ancestors 'self'"


def test_viser_with_an_unknown_server_is_refused():
    with (
        pytest.raises(QuadrupedError, match=r"foreign pages cannot be refused; .*pip install"),
        guarded("localhost"),
    ):
        pass


# --- in a browser


@pytest.fixture
def foreign_address(tmp_path):
    """A web server on another port of this machine: another origin."""
    (tmp_path / "index.html").write_text("<title>foreign</title>")
    handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=tmp_path)
    handler.log_message = lambda *_: None
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    thread.join()
    server.server_close()


TRY_SOCKET = """([port, protocol]) => new Promise(resolve => {
  const socket = new WebSocket(`ws://127.0.0.1:${port}`, [protocol]);
  socket.onmessage = () => { socket.close(); resolve("reads"); };
  socket.onerror = () => resolve("refused");
})"""


@pytest.mark.slow
def test_in_a_browser_only_the_viewers_own_page_reads_from_it(show, page, foreign_address):
    page.goto(f"{foreign_address}/index.html")
    assert page.evaluate(TRY_SOCKET, [show.port, PROTOCOL]) == "refused"
    page.goto(f"http://127.0.0.1:{show.port}")
    page.get_by_text("Feet on the ground").wait_for()
    assert page.evaluate(TRY_SOCKET, [show.port, PROTOCOL]) == "reads"
    assert page.title() == "MiniQuadruped"


# --- the live view


@pytest.mark.slow
def test_the_live_view_refuses_a_foreign_page_with_a_line(start):
    pytest.importorskip("cyclonedds")
    view = start("view", "--port", "0")
    pattern = r"the live robot: http://127\.0\.0\.1:(\d+)"
    (port,) = wait_until(lambda: re.search(pattern, view.said), lambda: view.said, view.process).groups()
    show = SimpleNamespace(port=int(port))
    with pytest.raises(InvalidStatus):
        client(show, origin="http://evil.example")
    with client(show) as socket:
        assert socket.recv()
    assert view.interrupt() == 0
    assert view.said.count("Origin is 'http://evil.example': a foreign page") == 1
