"""The viewer's server against foreign pages, foreign names and clients that send what its own page does not."""

import contextlib
import functools
import gzip
import http.client
import http.server
import re
import socket
import threading
from types import SimpleNamespace

import pytest
from viewing import showing
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.viewer.access import LOG_PERIOD, AccessRules, Refusal, RefusalLog, page_address

viser = pytest.importorskip("viser")
pytest.importorskip("mjviser")

import msgspec  # noqa: E402
from websockets.exceptions import ConnectionClosed, InvalidStatus  # noqa: E402
from websockets.sync.client import connect  # noqa: E402

from quadruped_env.viewer.guard import MAX_CLIENTS, MAX_MESSAGE, Guard  # noqa: E402

EVERYWHERE = "0.0.0.0"  # noqa: S104
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


@pytest.fixture(scope="module")
def show(tmp_path_factory):
    with showing(tmp_path_factory.mktemp("access"), "gait trot") as show:
        yield show


@pytest.fixture
def refusals(show, caplog, monkeypatch):
    """Lines of the log about refused clients."""
    monkeypatch.setattr("quadruped_env.viewer.access.LOG_PERIOD", 0.0)
    caplog.set_level("WARNING", logger="quadruped_env.viewer")
    return lambda: [record.getMessage() for record in caplog.records if record.name == "quadruped_env.viewer"]


def client(show, host="127.0.0.1", port=None, origin=None, protocol=PROTOCOL):
    """A websocket to a show under any host name, as a browser connects under the control of a malicious DNS server."""
    there = socket.create_connection(("127.0.0.1", show.port))
    # Without a limit on the queue, the client receives messages that it does not read.
    return connect(
        f"ws://{host}:{port or show.port}", sock=there, origin=origin, subprotocols=[protocol], max_queue=None
    )


def connected_browser(show):
    """A websocket that has sent its camera and received the whole scene."""
    before = {client.client_id for client in show.clients()}
    socket = client(show, origin=f"http://127.0.0.1:{show.port}")
    send(socket, **CAMERA)
    wait_until(lambda: {client.client_id for client in show.clients()} - before)
    return socket


def send(socket, **message):
    socket.send(msgspec.msgpack.encode(message))


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


# --- origin of requests


@pytest.mark.parametrize(
    ("listening", "host", "origin", "kind"),
    [
        ("127.0.0.1", "127.0.0.1:8080", [], None),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8080"], None),
        ("127.0.0.1", "LocalHost:8080", ["http://localhost:8080"], None),
        ("127.0.0.1", "[::1]:8080", ["http://[::1]:8080"], None),
        ("localhost", "127.0.0.1:8080", ["http://127.0.0.1:8080"], None),
        ("127.0.0.1", "127.0.0.1:8080", ["http://localhost:8080"], "origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8081"], "origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1"], "origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["https://127.0.0.1:8080"], "origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["null"], "origin"),
        ("127.0.0.1", "127.0.0.1:8080", [""], "origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8080", "http://evil.example"], "origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8080.evil.example"], "origin"),
        ("127.0.0.1", "evil.example:8080", ["http://evil.example:8080"], "host"),
        ("127.0.0.1", "localhost.evil.example:8080", [], "host"),
        ("127.0.0.1", "127.0.0.1", [], "host"),
        ("127.0.0.1", "127.0.0.1:8081", [], "host"),
        ("127.0.0.1", "192.168.1.2:8080", [], "host"),
        ("127.0.0.1", "user@127.0.0.1:8080", [], "host"),
        ("127.0.0.1", "", [], "host"),
        (EVERYWHERE, "192.168.1.2:8080", ["http://192.168.1.2:8080"], None),
        (EVERYWHERE, f"{socket.gethostname()}:8080", [], None),
        (EVERYWHERE, "evil.example:8080", ["http://evil.example:8080"], "host"),
        ("::", "[fe80::1]:8080", ["http://[fe80::1]:8080"], None),
        ("robot.lan", "robot.lan:8080", ["http://robot.lan:8080"], None),
        ("robot.lan", "robot.lan:8080", ["http://192.168.1.2:8080"], "origin"),
        ("robot.lan", "evil.example:8080", [], "host"),
    ],
)
def test_access_rules_accept_this_servers_names_and_its_own_page(listening, host, origin, kind):
    refusal = AccessRules(listening).refusal(8080, [host], origin)
    assert (refusal and refusal.kind) == kind


def test_access_rules_on_the_port_of_http_accept_hosts_without_one():
    assert AccessRules("127.0.0.1").refusal(80, ["localhost"], ["http://localhost"]) is None


@pytest.mark.parametrize("hosts", [[], ["127.0.0.1:8080", "127.0.0.1:8080"]])
def test_access_rules_demand_one_host(hosts):
    assert AccessRules("127.0.0.1").refusal(8080, hosts, []).kind == "host"


def test_a_websocket_of_this_servers_page_is_accepted(show):
    for host in ("127.0.0.1", "localhost"):
        with client(show, host, origin=f"http://{host}:{show.port}") as socket:
            assert len(socket.recv()) > 1000


def test_a_websocket_of_a_program_without_an_origin_is_accepted(show):
    with client(show) as socket:
        assert len(socket.recv()) > 1000


@pytest.mark.parametrize(
    ("host", "port", "origin", "word"),
    [
        ("127.0.0.1", None, "http://evil.example", "Origin is 'http://evil.example': a foreign page"),
        ("127.0.0.1", None, "null", "Origin is 'null'"),
        ("evil.example", None, "http://evil.example:{port}", "Host is 'evil.example:{port}'"),
        ("127.0.0.1", 1, None, "Host is '127.0.0.1:1'"),
    ],
)
def test_a_websocket_of_a_foreign_page_or_name_is_refused_with_one_line(show, refusals, host, port, origin, word):
    with pytest.raises(InvalidStatus) as refused:
        client(show, host, port, origin and origin.format(port=show.port))
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


def test_the_page_has_this_projects_title_and_may_not_be_framed(show):
    for encoding in ("identity", "gzip"):
        response, body = get(show, **{"Accept-Encoding": encoding})
        assert response.status == 200
        assert response.headers["Content-Security-Policy"] == "frame-ancestors 'self'"
        page = gzip.decompress(body) if encoding == "gzip" else body
        assert re.findall(rb"<title>(.*?)</title>", page) == [b"MiniQuadruped"]


def test_more_clients_than_the_limit_are_refused(show, monkeypatch):
    monkeypatch.setattr("quadruped_env.viewer.guard.MAX_CLIENTS", 2)
    assert MAX_CLIENTS > 2
    with client(show), client(show):
        with pytest.raises(InvalidStatus) as refused:
            client(show)
        assert refused.value.response.status_code == 503
        assert get(show)[0].status == 200


def test_viser_with_an_unknown_server_is_refused():
    with (
        pytest.raises(QuadrupedError, match=r"foreign pages cannot be refused; .*pip install"),
        Guard("localhost").installed(),
    ):
        pass


@pytest.mark.parametrize(
    ("host", "address"),
    [
        ("127.0.0.1", "http://127.0.0.1:8080"),
        ("robot.lan", "http://robot.lan:8080"),
        (EVERYWHERE, "http://127.0.0.1:8080"),
        ("::", "http://[::1]:8080"),
        ("fe80::1", "http://[fe80::1]:8080"),
    ],
)
def test_the_page_address_can_be_opened_and_is_accepted(host, address):
    assert page_address(host, 8080) == address
    assert AccessRules(host).refusal(8080, [address.removeprefix("http://")], [address]) is None


# --- messages of clients


NONSENSE = {
    "bytes": b"\xff\xfe nonsense",
    "empty": b"",
    "text": "hello",
    "no type": msgspec.msgpack.encode({"uuid": "x"}),
    "a list": msgspec.msgpack.encode([1, 2]),
    "deep": b"\x91" * 10_000 + b"\x90",
    "a camera of text": msgspec.msgpack.encode({**CAMERA, "wxyz": ["a"] * 4}),
    "a camera with an axis too few": msgspec.msgpack.encode({**CAMERA, "position": (0.0, 0.0)}),
    "an unknown field": msgspec.msgpack.encode({**CAMERA, "owner": "x"}),
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


def test_repeated_refusals_are_counted_in_one_line(caplog, monkeypatch):
    clock = [100.0]
    monkeypatch.setattr("quadruped_env.viewer.access.time", SimpleNamespace(monotonic=lambda: clock[0]))
    log = RefusalLog()
    for _ in range(5):
        log.add(Refusal("origin", "foreign"), "127.0.0.1:1")
    log.add(Refusal("host", "no name"), "127.0.0.1:1")
    clock[0] += LOG_PERIOD
    log.add(Refusal("origin", "foreign"), "127.0.0.1:2")
    assert [record.getMessage() for record in caplog.records] == [
        "viewer: refused 127.0.0.1:1: foreign",
        "viewer: refused 127.0.0.1:1: no name",
        "viewer: refused 127.0.0.1:2: foreign (and 4 more since the last line)",
    ]


def test_a_long_header_is_cut_in_the_log():
    refusal = AccessRules("127.0.0.1").refusal(8080, ["x" * 10_000], [])
    assert len(refusal.reason) < 200


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
    with client(show, origin=f"http://127.0.0.1:{port}") as socket:
        assert socket.recv()
    assert view.interrupt() == 0
    assert view.said.count("Origin is 'http://evil.example': a foreign page") == 1
