"""Measure the reference rows of the suite, and put them into the package: standing, scripted gaits, shipped policies.

tools/suite_references.py
tools/suite_references.py --only rough              the other rows stay as they are
tools/suite_references.py --only flat --result results/<name>/suite.json    of `mini-quadruped evaluate flat --suite`
tools/suite_references.py --policy mine=runs/<name>

The row of a policy is followed by the row of the zero action in its task. The results of a shipped policy also go onto
its card.
"""

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from benchmarks.shipping import note_suite, reference_row, without_suite
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.results import (
    REFERENCE_FILE,
    check_comparable,
    read_references,
    read_results,
    score_table,
    with_zero_action,
)
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import run_suite
from quadruped_env.evaluation.suite.suite_definition import Suite, draw_seed, full_suite, quick_suite
from quadruped_env.gait import CommandedGait, SinusoidalGait
from quadruped_env.policies import (
    GaitController,
    Policy,
    PolicyController,
    ZeroController,
    load_policy,
)
from quadruped_env.policies.files import SHIPPED
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program
from quadruped_env.utils.progress import ProgressLine
from quadruped_env.utils.provenance import git_commit, versions


def main() -> int:
    """Parse the arguments, measure, and write the file."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--policy", action="append", default=[], metavar="NAME=RUN", help="a run as a further row, under a name"
    )
    parser.add_argument(
        "--only",
        nargs="+",
        action="extend",
        metavar="NAME",
        help="measure these rows, and keep the others that the file has",
    )
    parser.add_argument(
        "--result",
        type=Path,
        nargs="+",
        action="extend",
        default=[],
        metavar="FILE",
        help="results of shipped policies that an evaluation wrote, instead of running the suite",
    )
    parser.add_argument(
        "--seed",
        type=int,
        metavar="N",
        help="seed of the suite (default: the seed of the rows that stay, or a drawn one)",
    )
    parser.add_argument("--quick", action="store_true", help="the quick suite, to try this program")
    parser.add_argument("-o", "--output", type=Path, default=REFERENCE_FILE, help="the file (%(default)s)")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def named_policies(entries: list[str]) -> dict[str, Policy]:
    """Return the shipped policies and those that the options name."""
    policies = {name: load_policy(name) for name in SHIPPED}
    for entry in entries:
        name, separator, source = entry.partition("=")
        if not separator or not name or not source:
            raise QuadrupedError(f"--policy: expected NAME=RUN; found {entry!r}")
        policies[name] = load_policy(source)
    return policies


def finished_results(files: list[Path], suite: Suite, wanted: set[str]) -> dict[str, Mapping[str, Any]]:
    """Return results of shipped policies from `suite.json` of their evaluations, by name.

    Args:
        files: the files.
        suite: suite that they must be of.
        wanted: shipped policies whose rows are measured.

    Raises:
        QuadrupedError: if a file is damaged, of another suite, of a policy that is not the shipped one, or of one
            whose row is not measured.
    """
    found = {}
    for path in files:
        result = read_results(path)
        if result["suite"] != suite.identity:
            raise QuadrupedError(f"{path}: expected the suite {suite.identity}; found {result['suite']}")
        name = result["name"]
        if name not in SHIPPED or result.get("policy", {}).get("card") != without_suite(load_policy(name).card):
            raise QuadrupedError(f"{path}: expected results of a shipped policy, as it is now; found {name!r}")
        if name not in wanted:
            raise QuadrupedError(
                f"{path}: the row {name!r} is not measured from the shipped policy; add it to --only, or leave out "
                f"--policy {name}=..."
            )
        found[name] = result
    return found


def reference_controllers(policies: Mapping[str, Policy]) -> list[Candidate]:
    """Controllers of the reference rows: standing, three scripted gaits, and policies by name."""
    config = TaskConfig().for_robot(MINI_QUADRUPED)
    return [
        Candidate("standing", ZeroController(), config),
        Candidate("article", GaitController(SinusoidalGait.preset("article", MINI_QUADRUPED), "article"), config),
        Candidate("sinusoid", GaitController(CommandedGait.preset("sinusoid"), "sinusoid"), config),
        Candidate("tuned", GaitController(), config),
        *(Candidate.of_policy(policy, name) for name, policy in policies.items()),
    ]


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print the scores."""
    measured_controllers = reference_controllers(named_policies(arguments.policy))
    names = [measured.name for measured in measured_controllers]
    wanted = arguments.only or names
    if not set(wanted) <= set(names):
        raise QuadrupedError(f"--only: expected some of {', '.join(names)}; found {', '.join(wanted)}")
    rows = {row["name"]: row for row in read_references(arguments.output)} if arguments.only else {}
    seeds = [arguments.seed, *(row["seed"] for name, row in rows.items() if name not in wanted), draw_seed()]
    seed = next(seed for seed in seeds if seed is not None)
    suite = quick_suite(seed) if arguments.quick else full_suite(seed)
    shipped = set(wanted) & set(SHIPPED) - {entry.partition("=")[0] for entry in arguments.policy}
    known = finished_results(arguments.result, suite, shipped)
    origin = {"versions": versions(), "commit": git_commit()}
    results = {}
    for measured in measured_controllers:
        if measured.name in wanted:
            is_policy = isinstance(measured.controller, PolicyController)
            progress = ProgressLine(measured.name)
            result = known.get(measured.name) or run_suite(measured, suite, progress, zero_action=is_policy)
            for row in with_zero_action(result):
                rows[row["name"]] = {**reference_row(row), "origin": origin}
            results[measured.name] = result
    check_comparable(rows)
    if arguments.output == REFERENCE_FILE:
        for name in shipped:
            note_suite(name, results[name])
    listed = [row for measured in measured_controllers for row in (measured.name, measured.zero_action().name)]
    ordered: list[Mapping[str, Any]] = [rows[name] for name in listed if name in rows]
    write_json(arguments.output, {"rows": ordered})
    print(
        f"{score_table(ordered)}\nwritten: {arguments.output}\nseed {seed}; these rows are the table of mq-eval in "
        f"docs/measurements.md, and the figures of commands met there and in the READMEs are `met` on the cards"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
