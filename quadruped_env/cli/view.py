"""Watch the robot walk, in a browser.

    mini-quadruped view                         the latest run's policy, or the shipped flat
    mini-quadruped view flat trot runs/<name>   up to three robots side by side: policies, scripted gaits, runs
    mini-quadruped view walk.csv                a recording of joint states (or a bag), played through the motors

Steer it with the sliders or the arrow keys, push it, choose its terrain, change its gait, plot its joints, record it.
The page is at the address that this program prints, for browsers on this machine only unless --host says otherwise.
Ctrl-C ends it.
"""

import argparse

from quadruped_env.cli import common_options as options
from quadruped_env.cli.invocation import Invocation
from quadruped_env.utils.program import on_stop
from quadruped_env.viewer import LOOPBACK, PORT, RESULTS, Show, open_show
from quadruped_env.viewer.server import add_allow_host


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the robots, the page and the output."""
    parser.add_argument(
        "sources",
        nargs="*",
        metavar="SOURCE",
        help=f"a run, {options.SHIPPED_POLICIES}, a Python file of a policy, a gait's name, or a recording of joint "
        f"states",
    )
    parser.add_argument(
        "--port", type=int, default=PORT, metavar="N", help="port, or the next free one (default: %(default)s)"
    )
    parser.add_argument(
        "--host",
        default=LOOPBACK,
        metavar="ADDRESS",
        help="address to listen on; other addresses allow access from other machines (default: %(default)s)",
    )
    add_allow_host(parser)
    options.add_task_file(parser)
    options.add_terrain(parser, "the ground of the first robot's task")
    options.add_output(parser, "DIR", "directory of the recordings (default: %(default)s)", RESULTS)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Open the viewer, and run it until Ctrl-C."""
    show = open_show(
        arguments.sources,
        host=arguments.host,
        port=arguments.port,
        results=arguments.output,
        task_file=arguments.task,
        terrain=options.named_terrain(arguments),
        trust_task=arguments.trust_task,
        allowed_hosts=arguments.allow_host,
    )
    return run_show(show, arguments.host, arguments.port)


def run_show(show: Show, host: str, port: int) -> int:
    """Print the address of a show, and run it until Ctrl-C."""
    with on_stop(lambda _: show.stop()):
        if port not in (0, show.port):
            print(f"port {port} is taken: {show.port} is the next free one")
        if host != LOOPBACK:
            print(f"listening on {host}: every machine that reaches it can steer this show")
        print(f"{', '.join(show.controller.robots)}: {show.address}   (Ctrl-C ends)", flush=True)
        show.run()
        print("ending; what was recorded is being saved (Ctrl-C: without it)" if show.controller.saving else "ending")
    show.close()
    for message in show.controller.messages():
        print(message)
    return 0
