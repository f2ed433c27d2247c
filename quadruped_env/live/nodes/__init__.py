"""The programs: one module a node, each with SUMMARY, `add_arguments(parser)` and `run(session, arguments)`.

One that starts other nodes has `start(arguments)` in place of `run`.
"""

from types import ModuleType
from typing import Final

MODULES: Final = {
    "display": "display",
    "walk": "walk",
    "sim": "sim",
    "gait": "gait",
    "state": "state",
    "controller": "controller",
    "view": "view",
    "teleop": "teleop",
    "echo": "echo",
    "list": "list",
    "hz": "hz",
    "record": "record",
}
"""Name of a node -> its module, in the order in which --help lists them"""


def node_module(name: str) -> ModuleType:
    """The module of a node of `MODULES`."""
    import importlib

    return importlib.import_module(f"{__name__}.{MODULES[name]}")
