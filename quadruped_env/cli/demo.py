"""See the robot walk, at once: the shipped policy rough in one page, which opens in your browser.

    mini-quadruped demo

Physics and policy run in the page. Steer with the arrow keys, click to push, choose stairs or blocks to cross. It needs
neither torch nor any extra, and no server: the page is one file, to keep or to send. 'mini-quadruped page' makes one of
another policy.
"""

import argparse
import webbrowser
from pathlib import Path
from typing import Final

from quadruped_env.cli.common_options import add_output
from quadruped_env.cli.invocation import Invocation

OUTPUT: Final = Path("mini-quadruped-demo.html")
"""In the working directory: browsers that are installed as snaps read no file of the system's temporary directory."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file."""
    add_output(parser, "FILE", "the page, which is replaced if it exists (default: %(default)s)", OUTPUT)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Write the page, and open it."""
    from quadruped_env.policies import load_policy
    from quadruped_env.policies.files import SHOWN
    from quadruped_env.walking_page import write_page

    write_page(load_policy(SHOWN), arguments.output, SHOWN)
    address = arguments.output.resolve().as_uri()
    print(f"the robot walks in {address}", flush=True)
    if not webbrowser.open(address):
        print("no browser could be opened: open this file in one, on any machine")
    return 0
