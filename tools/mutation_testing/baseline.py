"""Run all tests once, and write which lines of some files each test reaches, and how long it takes.

Lines that run while a fixture of a module or session is set up count for all tests that use the fixture. A line that
runs only at import has an empty list of tests; one that never runs has none.

Arguments: file to write, JSON list of source files, JSON list of pytest's arguments. It is a program of its own,
because the package must not have been imported when the measurement begins.
"""

import json
import os
import sys
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[2] / ".cosmic-ray"))  # last: what .venv has is used from there

import pytest
from coverage import Coverage


class Recorder:
    """Pytest plugin that tells coverage which test or fixture runs."""

    def __init__(self, coverage: Coverage) -> None:
        self._coverage = coverage
        self._contexts = [""]
        self.seconds: dict[str, float] = {}
        self.failed: list[str] = []
        self.users: dict[str, set[str]] = defaultdict(set)
        """Context -> the tests that it counts for"""

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: Any) -> Iterator[None]:
        """Switch to the context of a test."""
        self.users[item.nodeid].add(item.nodeid)
        for definitions in item._fixtureinfo.name2fixturedefs.values():
            for definition in definitions:
                self.users[_context(definition)].add(item.nodeid)
        return (yield from self._within(item.nodeid))

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: Any) -> Iterator[None]:
        """Switch to the context of a fixture that several tests share."""
        return (yield from self._within(self._contexts[-1] if fixturedef.scope == "function" else _context(fixturedef)))

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Add up the durations of setup, call and teardown."""
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration
        if report.failed:
            self.failed.append(report.nodeid)

    def _within(self, context: str) -> Iterator[Any]:
        self._contexts.append(context)
        self._coverage.switch_context(context)
        try:
            return (yield)
        finally:
            self._contexts.pop()
            self._coverage.switch_context(self._contexts[-1])


def main() -> int:
    """Run the program; the status is pytest's."""
    output, sources, arguments = Path(sys.argv[1]), json.loads(sys.argv[2]), json.loads(sys.argv[3])
    coverage = Coverage(data_file=None, config_file=False, include=[os.path.abspath(path) for path in sources])
    recorder = Recorder(coverage)
    coverage.start()
    status = pytest.main([*arguments, "-q", "-p", "no:cacheprovider", "--rootdir=."], plugins=[recorder])
    coverage.stop()
    if status:
        print(f"mutation: error: tests fail without a planted bug: {' '.join(recorder.failed)}", file=sys.stderr)
        return int(status)
    tests = sorted(recorder.seconds)
    number = {test: i for i, test in enumerate(tests)}
    lines = {}
    for path in sources:
        by_line = coverage.get_data().contexts_by_lineno(os.path.abspath(path))
        lines[path] = {
            line: sorted({number[test] for context in contexts for test in recorder.users[context]})
            for line, contexts in sorted(by_line.items())
        }
    output.write_text(
        json.dumps({"tests": {test: recorder.seconds[test] for test in tests}, "lines": lines}), encoding="utf-8"
    )
    return 0


def _context(fixturedef: Any) -> str:
    return f"fixture {fixturedef.baseid}::{fixturedef.argname}"


if __name__ == "__main__":
    sys.exit(main())
