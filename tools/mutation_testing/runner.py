"""Run tests on planted bugs, each in a process of its own.

It reads one JSON object per line, {"path", "module", "code", "tests", "timeout"}, and answers each with one:
{"outcome": "survived" | "killed" | "timeout", "by": the first test that failed}. It has loaded the libraries that the
tests need, but not the package, so that a process for a bug starts in a moment and imports the package with the bug.
"""

import contextlib
import importlib
import json
import os
import resource
import signal
import sys
import time
import warnings
from collections.abc import Sequence
from importlib.machinery import ModuleSpec, SourceFileLoader
from importlib.util import spec_from_file_location
from types import CodeType, ModuleType
from typing import Any

import pytest

LIBRARIES = (
    *("gymnasium", "mujoco", "mujoco.batch", "numpy", "safetensors.numpy", "scipy.spatial.transform"),
    *("scipy.stats", "stable_baselines3", "tensorboard", "torch", "torch.utils.tensorboard"),
)
_MEMORY = 6 << 30
"""Bytes that a process may allocate: a bug may ask for any number of envs."""


class Planted(SourceFileLoader):
    """Import hook: one module is loaded from other source than its file."""

    def __init__(self, module: str, path: str, code: str) -> None:
        super().__init__(module, os.path.abspath(path))
        self._code = code

    def find_spec(self, name: str, path: Sequence[str] | None, target: ModuleType | None = None) -> ModuleSpec | None:
        """The module itself; None for all others."""
        return spec_from_file_location(name, self.path, loader=self) if name == self.name else None

    def get_code(self, fullname: str) -> CodeType:
        """The module's code, with the bug."""
        with warnings.catch_warnings(action="ignore"):  # of syntax, such as `1 is 2`
            return compile(self._code, self.path, "exec", dont_inherit=True)


class Selected:
    """Pytest plugin that runs some tests in their order, and writes the name of the first that fails."""

    def __init__(self, tests: list[str], failed: int) -> None:
        self._order = {test: i for i, test in enumerate(tests)}
        self._failed = failed

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[Any]) -> None:
        """Leave out the others. A bug may change the parameters in a test's name; then all of its function run."""
        found = {item.nodeid for item in items}
        renamed = {_function(test): place for test, place in self._order.items() if test not in found}
        order = {n: self._order.get(n, renamed.get(_function(n))) for n in found}
        items[:] = sorted((i for i in items if order[i.nodeid] is not None), key=lambda i: order[i.nodeid] or 0)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Write the name of a test that fails."""
        if report.failed:
            os.write(self._failed, report.nodeid.encode() + b"\n")


def main() -> int:
    """Answer requests until there are no more."""
    sys.path.insert(0, os.getcwd())
    for library in LIBRARIES:
        with contextlib.suppress(ImportError):
            importlib.import_module(library)
    with contextlib.suppress(KeyboardInterrupt):
        for line in sys.stdin:
            print(json.dumps(_tried(**json.loads(line))), flush=True)
    return 0


def _tried(path: str, module: str, code: str, tests: list[str], timeout: float) -> dict[str, str]:
    read, write = os.pipe()
    child = os.fork()
    if not child:
        _run(Planted(module, path, code), tests, write)
    os.close(write)
    os.set_blocking(read, False)  # A process that a test has left behind may hold the other end open.
    status = _ended(child, timeout)
    outcome = "timeout" if status is None else "killed" if status else "survived"
    with os.fdopen(read, "rb") as file:
        return {"outcome": outcome, "by": (file.read() or b"").decode().partition("\n")[0]}


def _run(planted: Planted, tests: list[str], failed: int) -> None:
    """Run the tests, and end this process with pytest's exit status."""
    status = 1
    try:
        os.setpgid(0, 0)
        silent = os.open(os.devnull, os.O_RDWR)
        for stream in range(3):
            os.dup2(silent, stream)
        resource.setrlimit(resource.RLIMIT_DATA, (_MEMORY, _MEMORY))
        sys.meta_path.insert(0, planted)
        files = list(dict.fromkeys(test.partition("::")[0] for test in tests))
        options = ["-x", "-q", "-p", "no:cacheprovider", "--rootdir=."]
        status = int(pytest.main([*options, *files], plugins=[Selected(tests, failed)]))
    finally:
        os._exit(status)


def _function(test: str) -> str:
    return test.partition("[")[0]


def _ended(child: int, timeout: float) -> int | None:
    """Wait for a process and end what it has started; None if time is up."""
    until = time.monotonic() + timeout
    status = None
    try:
        while status is None and time.monotonic() < until:
            time.sleep(0.02)
            ended, code = os.waitpid(child, os.WNOHANG)
            status = code if ended else None
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)
    if status is None:
        os.waitpid(child, 0)
    return status


if __name__ == "__main__":
    sys.exit(main())
