"""The programs: one module a node, each with SUMMARY, `add_arguments(parser)` and `run(session, arguments)`."""

from types import ModuleType
from typing import Final

MODULES: Final = {
    "sim": "sim",
    "state": "state",
    "controller": "controller",
}
"""Name of a node -> its module, in the order in which --help lists them"""


def node_module(name: str) -> ModuleType:
    """The module of a node of `MODULES`."""
    import importlib

    return importlib.import_module(f"{__name__}.{MODULES[name]}")
