"""Choose planted bugs at random, and count those that the tests found.

'make mutate SAMPLE=600' tries 600 of the thousands of bugs that mutmut can plant, and prints the table of this program.
Killed are bugs that a test or the type checker finds, or that make a test run for too long. A bug that no test reaches
has survived.
"""

import argparse
import random
import sys
from collections import defaultdict
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # so that a Python without the package finds it, and prints a fix

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env._python import pasteable
from quadruped_env.documents import read_json
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.confidence import proportion
from quadruped_env.program import run_program

MUTANTS = Path("mutants")
KILLED = {1, 3, 24, -24, 36, 37, 152, 255, -9, -11}
"""Exit codes of mutmut: a test failed or pytest did, time was up, the type checker objected, the process crashed."""
SURVIVED = {0: "survived", 5: "not reached", 33: "not reached"}


def main() -> int:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    sample = commands.add_parser("sample", help="print the names of some bugs, for 'mutmut run'")
    sample.add_argument("number", type=int)
    sample.add_argument("--seed", type=int, default=0)
    commands.add_parser("score", help="print the score of the bugs that were tried, and those that survived")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Print the names or the score."""
    results = read_results(MUTANTS)
    lines = chosen(results, arguments.number, arguments.seed) if arguments.command == "sample" else score(results)
    print(*lines, sep="\n")
    return 0


def read_results(folder: Path) -> dict[str, int | None]:
    """Name -> exit code of every bug that mutmut has planted in a folder; None if it was not tried.

    Raises:
        QuadrupedError: if there is none.
    """
    results: dict[str, int | None] = {}
    for path in sorted(folder.rglob("*.meta")):
        results |= read_json(path)["exit_code_by_key"]
    if not results:
        raise QuadrupedError(f"{folder}: holds no planted bugs; run 'make mutate' first")
    return results


def chosen(results: dict[str, int | None], number: int, seed: int) -> list[str]:
    """Names of some bugs, each as likely as the others."""
    if not 1 <= number <= len(results):
        raise QuadrupedError(f"number: expected 1 to {len(results)}; found {number}")
    return sorted(random.Random(seed).sample(sorted(results), number))  # noqa: S311  no secret


def score(results: dict[str, int | None]) -> list[str]:
    """Lines of a Markdown table by package, and the survivors."""
    tried = {name: code for name, code in results.items() if code in KILLED or code in SURVIVED}
    if not tried:
        raise QuadrupedError(f"{MUTANTS}: no bug has been tried; run 'make mutate' first")
    killed: dict[str, list[bool]] = defaultdict(list)
    for name, code in tried.items():
        for row in (name.split(".")[1], "all"):
            killed[row].append(code in KILLED)
    lines = ["| package | tried | killed | score | 95 % interval |", "|---|---|---|---|---|"]
    for row in sorted(killed, key=lambda row: (row == "all", row)):
        share = proportion(killed[row])
        lines.append(
            f"| {row} | {share.count} | {sum(killed[row])} | {share.mean:.1%} | {share.low:.1%} to {share.high:.1%} |"
        )
    survivors = [f"{SURVIVED[code]}: {name}" for name, code in tried.items() if code in SURVIVED]
    return [*lines, "", *survivors]


if __name__ == "__main__":
    sys.exit(main())
