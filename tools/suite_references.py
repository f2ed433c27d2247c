"""Measure the reference rows of the suite, and put them into the package: standing, scripted gaits, shipped policies.

tools/suite_references.py
tools/suite_references.py --policy robust=runs/<name>
"""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # so that a Python without the package finds it, and prints a fix

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env._python import pasteable
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.control.policy import SHIPPED
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.suite.contender import reference_contenders
from quadruped_env.evaluation.suite.definition import full_suite, quick_suite
from quadruped_env.evaluation.suite.references import REFERENCE_FILE, reference_row, score_table
from quadruped_env.evaluation.suite.suite import run_suite
from quadruped_env.files import write_json
from quadruped_env.policies import Policy, load_policy
from quadruped_env.program import run_program
from quadruped_env.provenance import git_commit, versions
from quadruped_env.robot import MINI_QUADRUPED


def main() -> int:
    """Parse the arguments, measure, and write the file."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--policy", action="append", default=[], metavar="NAME=RUN", help="a run as a further row, under a name"
    )
    parser.add_argument("--quick", action="store_true", help="the quick suite, to try this program")
    parser.add_argument("-o", "--output", type=Path, default=REFERENCE_FILE, help="the file (%(default)s)")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def named_policies(entries: list[str]) -> dict[str, Policy]:
    """The shipped policies and those that the options name."""
    policies = {name: load_policy(name) for name in SHIPPED}
    for entry in entries:
        name, separator, source = entry.partition("=")
        if not separator or not name or not source:
            raise QuadrupedError(f"--policy: expected NAME=RUN; found {entry!r}")
        policies[name] = load_policy(source)
    return policies


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print the scores."""
    suite = quick_suite() if arguments.quick else full_suite()
    rows = []
    for contender in reference_contenders(named_policies(arguments.policy), MINI_QUADRUPED):
        rows.append(reference_row(run_suite(contender, suite, ProgressLine(contender.name))))
    write_json(arguments.output, {"rows": rows, "versions": versions(), "commit": git_commit()})
    print(f"{score_table(rows)}\nwritten: {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
