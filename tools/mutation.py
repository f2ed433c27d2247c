"""Test the tests: plant one bug at a time, and count those that the tests find.

    python tools/mutation.py --sample 600
    python tools/mutation.py --only quadruped_env.task.rewards

It goes on where it was stopped. Killed are bugs with which a test fails, or the tests run for too long, or the type
checker objects after all tests have passed. The tests are those that reach the changed line. Processes that a test
starts run without the bug.
"""

import argparse
import hashlib
import json
import os
import random
import subprocess
import sys
import threading
import time
from collections import defaultdict
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed
sys.path.append(str(Path(__file__).parents[1] / ".cosmic-ray"))  # last: what .venv has is used from there

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.confidence import proportion
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program

if TYPE_CHECKING:
    from mutation_testing.places import Mutant

CONTROL = ("control_config", "control_interface", "controllers", "episode_memory", "observations", "symmetry")
FILES = (
    *(f"quadruped_env/{package}/**/*.py" for package in ("task", "training", "policies", "gait")),
    *(f"quadruped_env/control/{module}.py" for module in CONTROL),
)
TESTS = (
    *("tests/task", "tests/control", "tests/policies", "tests/gait", "tests/training"),
    *(f"tests/envs/test_{name}.py" for name in ("envs", "env_copies", "env_input", "sb3")),
    *("tests/evaluation/test_without_randomization.py", "tests/robot/test_second_robot.py"),
)
MUTANTS = Path("mutants")
PROGRAMS = Path(__file__).parent / "mutation_testing"
KILLED = {"killed", "timeout", "types"}
TIMEOUT = (60.0, 5.0)
"""A constant in s, and a factor on the duration of the tests without a bug."""

Result = dict[str, Any]


def main() -> int:
    """Run the program."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, metavar="N", help="try N bugs, drawn at random")
    parser.add_argument("--seed", type=int, default=0, help="of the draw")
    parser.add_argument("--only", default="", metavar="NAME", help="try bugs whose name begins so")
    parser.add_argument("--retry", action="store_true", help="try those again that survived before")
    parser.add_argument("--jobs", type=int, default=2, help="bugs tried at the same time")
    parser.add_argument("--no-types", action="store_true", help="do not run the type checker on survivors")
    parser.add_argument("--files", nargs="+", default=FILES, metavar="GLOB", help="source files")
    parser.add_argument("--tests", nargs="+", default=TESTS, metavar="PATH", help="tests to run")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Try the bugs, and print the score."""
    try:
        from mutation_testing.places import mutants_of
    except ModuleNotFoundError as error:
        raise QuadrupedError(f"no module {error.name}; 'make mutate' installs it in .cosmic-ray") from error

    sources = sorted({path.as_posix() for pattern in arguments.files for path in Path().glob(pattern)})
    mutants = {mutant.name: mutant for path in sources for mutant in mutants_of(path)}
    names = [name for name in mutants if name.startswith(arguments.only)]
    if arguments.sample is not None:
        names = chosen(names, arguments.sample, arguments.seed)
    MUTANTS.mkdir(exist_ok=True)
    baseline = measured_baseline(sources, arguments.tests)
    results = try_all([mutants[name] for name in names], baseline, arguments)
    print(*score(results), sep="\n")
    return 0


def chosen(names: Iterable[str], number: int, seed: int) -> list[str]:
    """A random sample of names; the same for the same names and seed.

    Raises:
        QuadrupedError: if there are fewer names.
    """
    ordered = sorted(names)
    if not 1 <= number <= len(ordered):
        raise QuadrupedError(f"number: expected 1 to {len(ordered)}; found {number}")
    return random.Random(seed).sample(ordered, number)  # noqa: S311  no secret


def measured_baseline(sources: list[str], tests: Iterable[str]) -> dict[str, Any]:
    """Tests with their durations, and which lines they reach; measured again if a source or a test has changed."""
    path, digest = MUTANTS / "baseline.json", hashlib.sha256(json.dumps([sources, *tests]).encode())
    for file in sorted({Path(source) for source in sources} | set(Path("tests").rglob("*.py"))):
        digest.update(file.read_bytes())
    if not path.exists() or json.loads(path.read_text(encoding="utf-8"))["digest"] != digest.hexdigest():
        print("running all tests without a bug", flush=True)
        measured = MUTANTS / "measured.json"
        command = [
            sys.executable,
            str(PROGRAMS / "baseline.py"),
            str(measured),
            json.dumps(sources),
            json.dumps([*tests]),
        ]
        if subprocess.run(command, check=False, env=_environment(), stdout=subprocess.DEVNULL).returncode:  # noqa: S603
            raise QuadrupedError("tests fail without a planted bug; fix them first")
        write_json(path, {"digest": digest.hexdigest(), **json.loads(measured.read_text(encoding="utf-8"))})
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def try_all(mutants: list["Mutant"], baseline: dict[str, Any], arguments: argparse.Namespace) -> list[Result]:
    """Results of some bugs, read from `results.jsonl` or added to it."""
    path = MUTANTS / "results.jsonl"
    known = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []
    by_key = {(result["name"], result["digest"]): result for result in known}
    results = {m.name: by_key.get((m.name, _digest(m))) for m in mutants}
    open_ = [m for m in mutants if (r := results[m.name]) is None or (arguments.retry and r["outcome"] not in KILLED)]
    lock, began, done = threading.Lock(), time.monotonic(), 0
    runners = threading.local()

    def attempt(mutant: "Mutant") -> None:
        nonlocal done
        if not hasattr(runners, "one"):
            runners.one = Runner()
        result = tried(mutant, baseline, runners.one, not arguments.no_types)
        with lock, path.open("a", encoding="utf-8") as file:
            results[mutant.name] = result
            file.write(json.dumps(result) + "\n")
            done += 1
            killed = sum(r is not None and r["outcome"] in KILLED for r in results.values())
            left = (time.monotonic() - began) / done * (len(open_) - done)
            print(f"{done}/{len(open_)}  killed {killed}  {left / 60:.0f} min left  {result['outcome']}: {mutant.name}")
            sys.stdout.flush()

    pool = ThreadPoolExecutor(arguments.jobs)
    try:
        list(pool.map(attempt, open_))
    finally:
        pool.shutdown(cancel_futures=True)
    return [result for result in results.values() if result]


class Runner:
    """A process that tries bugs, one after the other."""

    def __init__(self) -> None:
        command = [sys.executable, str(PROGRAMS / "runner.py")]
        self._process = subprocess.Popen(  # noqa: S603
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8", env=_environment()
        )

    def __call__(self, **request: Any) -> Result:
        """The answer to one request."""
        assert self._process.stdin
        assert self._process.stdout
        self._process.stdin.write(json.dumps(request) + "\n")
        self._process.stdin.flush()
        line = self._process.stdout.readline()
        if not line:
            raise QuadrupedError("the process that tries the bugs has ended; start again to go on")
        answer: Result = json.loads(line)
        return answer


def tried(mutant: "Mutant", baseline: dict[str, Any], runner: Runner, types: bool) -> Result:
    """Outcome of one bug: killed, timeout, types, survived or not reached."""
    from mutation_testing.places import module_name
    from mutation_testing.reach import tests_of

    began, tests, code = time.monotonic(), tests_of(mutant, baseline), mutant.code()
    answer: Result = {"outcome": "not reached", "by": ""}
    if tests:
        timeout = TIMEOUT[0] + TIMEOUT[1] * sum(baseline["tests"][test] for test in tests)
        answer = runner(path=mutant.path, module=module_name(mutant.path), code=code, tests=tests, timeout=timeout)
    # Cosmic Ray replaces an exception by a name that no checker knows.
    types = types and answer["outcome"] not in KILLED and mutant.operator != "ExceptionReplacer"
    if types and (objection := type_error(mutant.path, code)):
        answer = {"outcome": "types", "by": objection}
    fixed = {
        "name": mutant.name,
        "digest": _digest(mutant),
        "at": f"{mutant.path}:{mutant.line}",
        "diff": mutant.diff(),
    }
    return {**fixed, **answer, "tests": len(tests), "seconds": round(time.monotonic() - began, 1)}


def type_error(path: str, code: str) -> str:
    """First error of mypy on the bug; empty if there is none."""
    folder = MUTANTS / f"types-{threading.get_ident()}"
    folder.mkdir(exist_ok=True)
    (folder / "code.py").write_text(code, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--no-error-summary", "--shadow-file", path, str(folder / "code.py")]
    checked = subprocess.run(  # noqa: S603
        [*command, "--cache-dir", str(folder)], check=False, capture_output=True, encoding="utf-8", env=_environment()
    )
    return checked.stdout.partition("\n")[0] if checked.returncode else ""


def score(results: Iterable[Result]) -> list[str]:
    """Lines of a Markdown table by package, and the survivors."""
    results = list(results)
    if not results:
        raise QuadrupedError("no bug has been tried")
    killed: dict[str, list[bool]] = defaultdict(list)
    for result in results:
        for row in (result["name"].partition(":")[0].split(".")[1], "all"):
            killed[row].append(result["outcome"] in KILLED)
    lines = ["| package | tried | killed | score | 95 % interval |", "|---|---|---|---|---|"]
    for row in sorted(killed, key=lambda row: (row == "all", row)):
        share = proportion(killed[row])
        lines.append(
            f"| {row} | {share.count} | {sum(killed[row])} | {share.mean:.1%} | {share.low:.1%} to {share.high:.1%} |"
        )
    counts = {outcome: sum(r["outcome"] == outcome for r in results) for outcome in ("timeout", "types")}
    lines += ["", f"Of the killed, {counts['timeout']} by the timeout and {counts['types']} by the type checker.", ""]
    survivors = sorted((r for r in results if r["outcome"] not in KILLED), key=lambda r: str(r["at"]))
    return lines + [line for r in survivors for line in (f"{r['at']}: {r['outcome']}: {r['name']}", r["diff"])]


def _digest(mutant: "Mutant") -> str:
    return hashlib.sha256(mutant.code().encode()).hexdigest()[:16]


def _environment() -> dict[str, str]:
    """One thread for each process: several bugs are tried at the same time."""
    return {**os.environ, "PYTHONPATH": os.getcwd(), "OMP_NUM_THREADS": "1"}


if __name__ == "__main__":
    sys.exit(main())
