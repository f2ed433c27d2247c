"""Policies of the Hugging Face Hub, by its own client from a local server that answers as the hub does."""

import fnmatch
import os
import socket
import struct
import subprocess
import sys
import threading
from hashlib import sha256
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import ClassVar

import numpy as np
import pytest
from policies import make_policy, observations

from quadruped_env import MissingExtraError
from quadruped_env.policies import load_policy

COMMIT = "0123456789abcdef0123456789abcdef01234567"
LOAD = """
import sys
import warnings
import numpy as np
from quadruped_env import QuadrupedError
from quadruped_env.policies import hub
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.policies import find_controllers, load_policy

warnings.simplefilter("always")
for address in sys.argv[2:]:
    hub.TIMEOUT = 0.5 if "hangs" in address else 10.0
    try:
        policy = load_policy(address)
    except QuadrupedError as error:
        print(error)
    else:
        actions = policy.predict(np.load(sys.argv[1]))
        _, (name,) = find_controllers([address])
        evaluated = find_policy(address)
        print(name, evaluated.name, evaluated.source, evaluated.evaluation, evaluated.output)
        np.save(sys.argv[1], actions)
assert "torch" not in sys.modules
"""


class Hub(BaseHTTPRequestHandler):
    """Files of `me/walker` at the revisions main and v1, a repository `me/empty`, and `BROKEN`; it records requests."""

    files: ClassVar = {}
    requests: ClassVar = []

    def do_HEAD(self):
        self.do_GET()

    def do_GET(self):
        self.requests.append((self.command, self.path))
        if any(self.path.startswith(f"/{name}/") for name in BROKEN):
            return BROKEN["/".join(self.path.split("/")[1:3])](self)
        parts = self.path.strip("/").split("/")
        owner, name, _, revision, file = parts if len(parts) == 5 else ("", "", "", "", "")
        code, content = "", b""
        if (owner, name) not in (("me", "walker"), ("me", "empty"), ("me", "damaged")):
            code = "RepoNotFound"
        elif revision not in ("main", "v1", COMMIT):
            code = "RevisionNotFound"
        elif name == "empty" or file not in self.files:
            code = "EntryNotFound"
        else:
            content = self.files[file][: -1 if (name, file) == ("damaged", "policy.safetensors") else None]
        self.send_response(404 if code else 200)
        self.send_header("X-Repo-Commit", COMMIT)
        self.send_header("ETag", f'"{sha256(content).hexdigest()}"')
        self.send_header("Content-Length", str(len(content)))
        if code:
            self.send_header("X-Error-Code", code)
        self.end_headers()
        if self.command == "GET":
            self.wfile.write(content)
        return None

    def log_message(self, *_):
        pass


def reset(request):
    """Reset the connection, as a firewall does."""
    request.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    request.connection.close()


def answer(request, status, *headers, length=0):
    """An answer without content."""
    request.send_response(status)
    for name, value in (*headers, ("Content-Length", str(length))):
        request.send_header(name, value)
    request.end_headers()


def garbage(request):
    """Bytes that are not HTTP."""
    request.wfile.write(b"\x00\xff\x1b]0;x\r\n\r\n")
    request.close_connection = True


def reset_download(request):
    """The file's metadata, but not the file."""
    if request.command == "GET":
        return reset(request)
    return answer(request, 200, ("X-Repo-Commit", COMMIT), ("ETag", '"a"'), length=10)


RELEASED = threading.Event()
"""Set when a server that hangs may end."""
BROKEN = {
    "me/reset": reset,
    "me/garbage": garbage,
    "me/loop": lambda request: answer(request, 302, ("Location", request.path)),
    "me/hangs": lambda request: RELEASED.wait() and None,
    "me/portal": lambda request: answer(request, 200),
    "me/down": lambda request: answer(request, 500),
    "me/cut": reset_download,
}


@pytest.fixture
def load(tmp_path, monkeypatch):
    """Load addresses in a process of their own; what it prints, line by line, and the actions."""
    pytest.importorskip("huggingface_hub", reason="the hub's client is not installed: pip install -e '.[hub]'")
    monkeypatch.setattr(Hub, "files", make_policy().files() | {"env.py": b"raise SystemExit('executed')"})
    monkeypatch.setattr(Hub, "requests", [])
    server = ThreadingHTTPServer(("127.0.0.1", 0), Hub)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    variables = {"HF_ENDPOINT": f"http://127.0.0.1:{server.server_port}", "HF_HOME": str(tmp_path / "cache")}
    data = tmp_path / "data.npy"

    def run(*addresses, **more):
        np.save(data, observations((3,)))
        done = subprocess.run(
            [sys.executable, "-c", LOAD, data, *addresses],
            env=os.environ | variables | more,
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        run.warned = [line for line in done.stderr.splitlines() if "QuadrupedWarning: " in line]
        return done.stdout.splitlines(), np.load(data)

    yield run
    RELEASED.set()
    server.shutdown()
    server.server_close()


def test_policy_of_the_hub_acts_as_the_uploaded_one_and_only_two_files_are_downloaded(load):
    (line,), actions = load("hf://me/walker@v1")
    assert line == "policy walker@v1 walker hf://me/walker@v1 results/walker results/walker"
    np.testing.assert_array_equal(actions, make_policy().predict(observations((3,))))
    downloaded = {path.rsplit("/")[-1] for _, path in Hub.requests if "/resolve/" in path}
    assert downloaded == {"policy.json", "policy.safetensors"}


UNREACHABLE = "the hub cannot be reached ({}), and its policy is not in the cache; connect, or name a directory"
PROBLEMS = {
    **dict.fromkeys(("reset", "garbage", "loop", "hangs"), UNREACHABLE.format("*")),
    "portal": UNREACHABLE.format("the answer does not come from a hub"),
    "down": UNREACHABLE.format("*500*"),
    "cut": "cannot be downloaded (*); check the name, and try again",
}


ADDRESSES = {
    "me/nothing": "there is no such repository, or it is private*",
    "me/walker@v2": "the repository has no revision 'v2'; leave it out",
    "me/empty": "has no policy.json with policy.safetensors*",
    "me/a b": "cannot be downloaded (Repo id must use*",
    **{f"me/{name}": problem for name, problem in PROBLEMS.items()},
}


def test_errors_name_the_address_and_the_fix_after_a_single_try(load):
    lines, _ = load("hf://walker", "hf://me/damaged", *(f"hf://{address}" for address in ADDRESSES))
    assert lines[0] == "'hf://walker': expected hf://OWNER/NAME or hf://OWNER/NAME@REVISION"
    assert "policy.safetensors: its SHA-256 differs from weights_sha256 in policy.json" in lines[1]
    for line, (address, problem) in zip(lines[2:], ADDRESSES.items(), strict=True):
        assert fnmatch.fnmatchcase(line, f"hf://{address}: {problem}".replace("[", "[[]"))
        tries = [command for command, path in Hub.requests if path.startswith(f"/{address}/")]
        assert address == "me/loop" or len(tries) <= 3
    (offline,), _ = load("hf://me/walker", HF_HUB_OFFLINE="1")
    assert offline == f"hf://me/walker: {UNREACHABLE.format('the client is offline')}"


def test_policy_in_the_cache_is_used_if_the_hub_no_longer_answers(load, monkeypatch):
    load("hf://me/walker")
    monkeypatch.setitem(BROKEN, "me/walker", reset)
    _, actions = load("hf://me/walker")
    np.testing.assert_array_equal(actions, make_policy().predict(observations((3,))))
    assert len(load.warned) == 3, "one for each load"
    assert all(line.endswith("its policy in the cache is used") for line in load.warned)


def test_without_the_client_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "huggingface_hub", None)
    with pytest.raises(MissingExtraError, match=r"needs the 'hub' extra: .*mini-quadruped\[hub\]"):
        load_policy("hf://me/walker")
