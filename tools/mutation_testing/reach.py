"""Tests that reach a planted bug, from one run of all tests."""

import ast
from collections import defaultdict
from functools import cache
from pathlib import Path
from typing import Any, Final, NamedTuple, TypeAlias

from mutation_testing.places import Mutant

FAST: Final = 0.3
"""s"""
_TESTS: Final = {
    "gait": ("tests/gait/", "tests/control/test_directions.py", "tests/robot/test_second_robot.py::TestGait"),
    "policies": ("tests/control/test_policy",),
}
"""Beginnings of the names of a package's tests, if they are not only those in the folder of the same name."""

Statement: TypeAlias = ast.stmt | ast.ExceptHandler


class Place(NamedTuple):
    """Where a line is."""

    lines: range
    """Lines of the innermost statement around it; its header, if it holds others"""
    once: bool
    """True if it runs when the module is imported, or in a function that remembers its results"""


def tests_of(mutant: Mutant, baseline: dict[str, Any]) -> list[str]:
    """Tests that reach a bug: its package's first, and tests of other packages that take less than `FAST`.

    A bug in what runs a single time, such as a default, a decorator or a cached function, is reached by all tests of
    its package, and by those that reach any function of the file.
    """
    seconds: dict[str, float] = baseline["tests"]
    names = list(seconds)
    own = {name for name in names if name.startswith(_folders(mutant.path))}
    lines = {int(line): tests for line, tests in baseline["lines"][mutant.path].items()}
    place = place_of(mutant.path, mutant.line)
    runs = [lines[line] for line in place.lines if line in lines]
    once = place.once or (bool(runs) and not any(runs))
    if once:
        runs = [tests for line, tests in lines.items() if not place_of(mutant.path, line).once]
    reached = {names[i] for tests in runs for i in tests} | (own if once else set())
    found = [name for name in names if name in reached and (name in own or seconds[name] < FAST)]
    of_file: dict[str, float] = defaultdict(float)
    for name in found:
        of_file[_file(name)] += seconds[name]
    # Tests of one file stay together, so that fixtures that they share are set up once.
    return sorted(found, key=lambda name: (name not in own, of_file[_file(name)], _file(name), seconds[name]))


def place_of(path: str, line: int) -> Place:
    """The statement around a line of a file."""
    around = [node for node in _statements(path) if _first_line(node) <= line <= (node.end_lineno or 0)]
    if not around:
        return Place(range(line, line + 1), True)
    inner = around[-1]
    body: list[Statement] = getattr(inner, "body", [])
    end = max(inner.lineno, body[0].lineno - 1) if body else inner.end_lineno or 0
    functions = [node for node in around[:-1] if isinstance(node, ast.FunctionDef)]
    cached = any("cache" in ast.unparse(decorator) for node in functions for decorator in node.decorator_list)
    return Place(range(inner.lineno, end + 1), cached or not functions)


@cache
def _statements(path: str) -> list[Statement]:
    """Statements of a file, outer ones before those in them."""
    tree = ast.parse(Path(path).read_text(encoding="utf-8"))
    found = [node for node in ast.walk(tree) if isinstance(node, ast.stmt | ast.ExceptHandler)]
    return sorted(found, key=lambda node: (_first_line(node), -(node.end_lineno or 0)))


def _first_line(node: Statement) -> int:
    return min([node.lineno, *(decorator.lineno for decorator in getattr(node, "decorator_list", []))])


def _folders(path: str) -> tuple[str, ...]:
    package = Path(path).parts[1:-1]
    return _TESTS.get("/".join(package), ("/".join(["tests", *package, ""]),))


def _file(test: str) -> str:
    return test.partition("::")[0]
