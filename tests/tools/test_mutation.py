"""tools/mutation.py: planted bugs, the tests that find them, the sample and the score."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from paths import ROOT

import mutation
from quadruped_env.errors import QuadrupedError

TOOLS = Path(mutation.__file__).parent
SUMS = """
import functools


def doubled(function):
    @functools.wraps(function)
    def call(x: int | None) -> int | None:
        return 2 * function(x)

    return call


@doubled
def raised(x, step=1):
    return x + step


def lowered(x):
    if x < 0:
        raise ValueError(f"{x + 1} is below {0}")
    return x - 1


@functools.cache
def remembered():
    return 5


def never_called(x):
    return x * x
"""
TESTS = """
from tiny.core.sums import lowered, raised, remembered


def test_raised():
    assert raised(3) == 8


def test_lowered():
    lowered(3)


def test_first_call():
    remembered()


def test_later_call():
    assert remembered() == 5
"""


@pytest.fixture
def tiny(tmp_path):
    """A package of one module, with tests."""
    for path, text in {
        "tiny/__init__.py": "",
        "tiny/core/__init__.py": "",
        "tiny/core/sums.py": SUMS,
        "tests/core/test_sums.py": TESTS,
    }.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    return tmp_path


def test_all_named_files_and_tests_exist():
    assert [pattern for pattern in (*mutation.FILES, *mutation.TESTS) if not list(ROOT.glob(pattern))] == []


@pytest.mark.slow
def test_runner_runs_the_given_code_in_place_of_the_file(tiny):
    names = ["tests/core/test_sums.py::test_lowered", "tests/core/test_sums.py::test_raised"]
    codes = [
        SUMS,
        SUMS.replace("x + step", "x - step"),  # of a decorated function
        SUMS.replace("return x - 1", "while True: pass"),
        SUMS,
    ]
    requests = [
        {"path": "tiny/core/sums.py", "module": "tiny.core.sums", "code": code, "tests": names, "timeout": timeout}
        for code, timeout in zip(codes, (300, 300, 1, 300), strict=True)
    ]
    run = subprocess.run(
        [sys.executable, str(TOOLS / "mutation_testing" / "runner.py")],
        input="".join(json.dumps(request) + "\n" for request in requests),
        cwd=tiny,
        capture_output=True,
        text=True,
        check=True,
    )
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    assert [answer["outcome"] for answer in answers] == ["survived", "killed", "timeout", "survived"]
    assert answers[1]["by"] == names[1]
    assert (tiny / "tiny" / "core" / "sums.py").read_text() == SUMS


def test_bugs_are_tried_in_all_functions_and_a_second_run_tries_none_again(tiny):
    pytest.importorskip("cosmic_ray", reason="'make mutate' installs Cosmic Ray")
    options = ["--no-types", "--jobs", "1", "--files", "tiny/**/*.py", "--tests", "tests"]
    command = [sys.executable, str(TOOLS / "mutation.py"), *options]
    run = subprocess.run(command, cwd=tiny, capture_output=True, text=True, check=True)
    results = [json.loads(line) for line in (tiny / "mutants" / "results.jsonl").read_text().splitlines()]
    assert {result["diff"].replace("\n", " ").replace("  ", " "): result["outcome"] for result in results} == {
        "- return 2 * function(x) + return 2 / function(x)": "killed",
        "- return 2 * function(x) + return 3 * function(x)": "killed",
        "- def raised(x, step=1): + def raised(x, step= 2):": "killed",
        "- return x + step + return x - step": "killed",
        "- if x < 0: + if x <= 0:": "survived",
        "- if x < 0: + if x >= 0:": "killed",
        "- if x < 0: + if x < 1:": "survived",
        "- return x - 1 + return x + 1": "survived",
        "- return x - 1 + return x - 2": "survived",
        "- return 5 + return 6": "killed",
        "- return x * x + return x / x": "not reached",
    }
    assert "| all | 11 | 6 | 54.5% | 28.0% to 78.7% |" in run.stdout
    again = subprocess.run(command, cwd=tiny, capture_output=True, text=True, check=True)
    assert again.stdout == run.stdout[run.stdout.index("| package") :]


def test_score_counts_what_was_tried_and_names_the_survivors():
    outcomes = {"task.a:1": "killed", "task.a:2": "survived", "task.b:3": "types", "task.b:4": "not reached"}
    results = [
        {"name": f"quadruped_env.{name}", "outcome": outcome, "at": f"{name}.py", "diff": "- a\n+ b"}
        for name, outcome in {**outcomes, "gait.c:5": "timeout"}.items()
    ]
    assert mutation.score(results) == [
        "| package | tried | killed | score | 95 % interval |",
        "|---|---|---|---|---|",
        # Wilson's interval of 1 in 1, 2 in 4 and 3 in 5.
        "| gait | 1 | 1 | 100.0% | 20.7% to 100.0% |",
        "| task | 4 | 2 | 50.0% | 15.0% to 85.0% |",
        "| all | 5 | 3 | 60.0% | 23.1% to 88.2% |",
        "",
        "Of the killed, 1 by the timeout and 1 by the type checker.",
        "",
        "task.a:2.py: survived: quadruped_env.task.a:2",
        "- a\n+ b",
        "task.b:4.py: not reached: quadruped_env.task.b:4",
        "- a\n+ b",
    ]
    with pytest.raises(QuadrupedError, match="no bug has been tried"):
        mutation.score([])


def test_sample_has_every_bug_with_the_same_chance():
    names = [f"bug {i}" for i in range(6)]
    assert sorted(mutation.chosen(names, 6, 3)) == names
    assert mutation.chosen(names, 2, 3) == mutation.chosen(reversed(names), 2, 3)
    counts = {name: sum(name in mutation.chosen(names, 2, seed) for seed in range(600)) for name in names}
    # Binomial with p = 1/3: 200 with a standard deviation of 11.5.
    assert all(abs(count - 200) < 5 * 11.5 for count in counts.values())
    for number in (0, 7):
        with pytest.raises(QuadrupedError, match=f"expected 1 to 6; found {number}"):
            mutation.chosen(names, number, 0)
