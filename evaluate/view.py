"""Watch the robot walk, in a browser.

python evaluate/view.py                              the latest run's policy, or the shipped one
python evaluate/view.py flat trot runs/<name>        up to three robots side by side: policies, scripted gaits, runs
python evaluate/view.py walk.csv                     a recording of joint states (or a bag), played through the motors

Command it with the sliders or the arrow keys, push it, change its gait, watch its joints, record it. The page is at
the address that this program prints, for browsers on this machine only unless --host says otherwise. Ctrl-C ends it.
"""

import argparse
import signal
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.options import plain_warnings
from quadruped_env.viewer import LOOPBACK, PORT, RESULTS, Show, open_show


def main() -> int:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "sources", nargs="*", metavar="SOURCE", help="a run, 'flat', a gait's name, or a recording of joint states"
    )
    parser.add_argument(
        "--command",
        nargs=2,
        type=float,
        default=(0.4, 0.0),
        metavar=("M/S", "RAD/S"),
        help="forward velocity and yaw rate to begin with (0.4 0)",
    )
    parser.add_argument("--port", type=int, default=PORT, help="the next free one is taken (%(default)s)")
    parser.add_argument(
        "--host", default=LOOPBACK, help="address to listen on (%(default)s); others let other machines in"
    )
    parser.add_argument(
        "--results", type=Path, default=RESULTS, metavar="DIR", help="where recordings go (%(default)s)"
    )
    parser.add_argument(
        "--measure", type=float, metavar="SECONDS", help="end after this time and report the speed reached"
    )
    args = parser.parse_args()
    try:
        with plain_warnings("view.py"):
            show = open_show(args.sources, tuple(args.command), args.host, args.port, args.results)
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return play(show, args.host, args.port, args.measure)


def play(show: Show, host: str, port: int, seconds: float | None) -> int:
    """Say where the show is, and run it until Ctrl-C."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: show.stop())
    if port not in (0, show.port):
        print(f"port {port} is taken: {show.port} is the next free one")
    if host != LOOPBACK:
        print(f"listening on {host}: every machine that reaches it can steer this show")
    print(f"{', '.join(show.controller.robots)}: {show.address}   (Ctrl-C ends)", flush=True)
    pace = show.run(seconds)
    print("ending; what was recorded is being saved (Ctrl-C: without it)" if show.controller.saving else "ending")
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)
    show.close()
    for message in show.controller.messages():
        print(message)
    if seconds is not None:
        print(pace)
    return 0


if __name__ == "__main__":
    sys.exit(main())
