"""The web server of the viewer: on this machine only by default, and never shared through viser's public relay."""

import argparse
import contextlib
import errno
import io
import socket
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError

if TYPE_CHECKING:
    import viser

LOOPBACK: Final = "127.0.0.1"
PORT: Final = 8080
_PORTS_TRIED: Final = 100


def start_server(host: str = LOOPBACK, port: int = PORT, allowed: Sequence[str] = ()) -> "viser.ViserServer":
    """Start a server on the first free port from `port` on, for this project's page only (see `access` and `guard`).

    Any address other than loopback lets other machines control the viewer. Port 0 is any free port. `allowed` are
    further hosts under which browsers reach it, see `AccessRules`.

    Raises:
        MissingExtraError: if viser is not installed.
        QuadrupedError: if there is no such address here, or no port is free.
    """
    module = import_viser()
    # Imported here because it needs viser.
    from quadruped_env.viewer.guard import guarded

    port = _free_port(host, port)
    # viser prints its own banner.
    with contextlib.redirect_stdout(io.StringIO()), guarded(host, allowed):
        server: viser.ViserServer = module.ViserServer(host, port, label="MiniQuadruped", verbose=False)
    server.gui.configure_theme(show_logo=False, show_share_button=False, brand_color=(0, 114, 178))
    return server


def add_allow_host(parser: argparse.ArgumentParser) -> None:
    """Add `--allow-host`."""
    parser.add_argument(
        "--allow-host",
        action="append",
        default=[],
        metavar="NAME[:PORT]",
        help="accept browsers that address the page by this name too, as through a forwarded port or a proxy",
    )


def stop_server(server: "viser.ViserServer") -> None:
    """Stop the server without printing."""
    with contextlib.redirect_stdout(io.StringIO()):
        server.stop()


def import_viser() -> Any:
    """Return the module `viser`; a MissingExtraError if it, or mjviser, is not installed."""
    try:
        import mjviser  # noqa: F401
        import viser
    except ImportError as error:
        raise MissingExtraError("The viewer", "viewer") from error
    return viser


def _free_port(host: str, port: int) -> int:
    if not 0 <= port <= 65535 - _PORTS_TRIED:
        raise QuadrupedError(f"--port: expected 0 to {65535 - _PORTS_TRIED}; found {port}")
    for candidate in range(port, port + _PORTS_TRIED):
        try:
            family = socket.getaddrinfo(host, candidate, type=socket.SOCK_STREAM)[0][0]
            with socket.socket(family, socket.SOCK_STREAM) as probe:
                probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
                probe.bind((host, candidate))
                return int(probe.getsockname()[1])
        except OSError as error:
            if error.errno not in (errno.EADDRINUSE, errno.EACCES):
                raise QuadrupedError(
                    f"--host: cannot listen on {host!r} ({error.strerror}); leave it out for {LOOPBACK}"
                ) from error
    raise QuadrupedError(f"--port: none of {port} to {port + _PORTS_TRIED - 1} is free; name another one")
