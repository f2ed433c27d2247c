"""Measure a training on two ranks against one, with the same number of envs in total.

    python tools/ranks.py --only speed       steps per second, and the parts of which an update consists
    python tools/ranks.py --only walk        time until a policy walks, from scratch, for several seeds: 8 episodes of
                                             10 s without a fall, within 0.1 m/s of a commanded 0.5 m/s

The runs with one and with two ranks take turns. Let nothing else run meanwhile. Results are added to the file of
`--output`: seeds that it already has are not trained again.
"""

import argparse
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
import numpy as np

from quadruped_env.utils.documents import read_json
from quadruped_env.utils.files import write_json
from quadruped_env.utils.interpreter import pasteable
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions


def main() -> int:
    """Parse the arguments, measure, and print what was found."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--only", choices=("speed", "walk"), help="one part instead of both")
    parser.add_argument("--rounds", type=int, default=20, help="rounds for the speed (default: %(default)s)")
    parser.add_argument(
        "--seeds", type=int, nargs="+", default=[0, 1, 2, 3, 4], help="seeds to train (default: 0 1 2 3 4)"
    )
    parser.add_argument(
        "--timesteps",
        type=int,
        default=200_000,
        help="budget with which the schedules end, and after which a seed has failed to walk (default: %(default)s)",
    )
    parser.add_argument(
        "--every",
        type=int,
        default=4_096,
        help="environment steps between two tests of walking (default: %(default)s)",
    )
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("results/ranks.json"), help="JSON file (default: %(default)s)"
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    import quadruped_env.training.train  # noqa: F401  (it names the extra that is missing)

    document: dict[str, Any] = read_json(arguments.output, "remove it") if arguments.output.is_file() else {}
    document |= {"machine": machine(), "versions": versions()}
    if arguments.only in (None, "speed"):
        measure_speed(arguments, document)
    if arguments.only in (None, "walk"):
        measure_walk(arguments, document)
    print(f"measured on {machine()}; written to {arguments.output}")
    return 0


def measure_speed(arguments: argparse.Namespace, document: dict[str, Any]) -> None:
    """Speed of pairs of runs, and the parts of an update."""
    from benchmarks.ranks import as_dict, exchange, speeds

    print(f"{arguments.rounds} rounds of the default training on one rank and on two, in turns ...", flush=True)
    pairs = speeds(2, arguments.rounds)
    parts = exchange(2, 300)
    document["speed"] = [[as_dict(one), as_dict(two)] for one, two in pairs]
    document["exchange"] = as_dict(parts)
    write_json(arguments.output, document)
    ratio = np.median([two.steps_per_second / one.steps_per_second for one, two in pairs])
    spread = np.percentile([two.steps_per_second / one.steps_per_second for one, two in pairs], [25, 75])
    rates = [np.median([pair[index].steps_per_second for pair in pairs]) for index in range(2)]
    print(f"steps/s: {rates[0]:,.0f} on one rank, {rates[1]:,.0f} on two")
    print(
        f"two ranks over one: {ratio:.3f} (median of {len(pairs)} rounds; quartiles {spread[0]:.3f}, {spread[1]:.3f})"
    )
    for name, index in (("one rank", 0), ("two ranks", 1)):
        rollout = np.median([pair[index].rollout_seconds for pair in pairs])
        update = np.median([pair[index].update_seconds for pair in pairs])
        print(f"{name}: rollout {1e3 * rollout:.0f} ms, update {1e3 * update:.0f} ms, for {parts.samples:,} steps")
    print(f"{parts.parameters:,} parameters: {4 * parts.parameters:,} bytes in each of {parts.gradient_steps} sums")
    for size, time in parts.all_reduce_microseconds.items():
        print(f"sum of {4 * int(size):,} bytes over two ranks: {time:,.0f} us")


def measure_walk(arguments: argparse.Namespace, document: dict[str, Any]) -> None:
    """Time to walk of each seed, on one and on two ranks."""
    from benchmarks.ranks import as_dict, time_to_walk

    budget = {"timesteps": arguments.timesteps, "every": arguments.every}
    walk = document.get("walk", {})
    results = walk["results"] if walk.get("budget") == budget else []
    for seed in arguments.seeds:
        for ranks in (1, 2):
            if any((known["seed"], known["ranks"]) == (seed, ranks) for known in results):
                continue
            found = as_dict(time_to_walk(ranks, seed, **budget))
            results.append(found)
            document["walk"] = {"budget": budget, "results": results}
            write_json(arguments.output, document)
            print(f"seed {seed}, {ranks} rank{'s' * (ranks > 1)}: {_walked(found)}", flush=True)
    asked = [found for found in results if found["seed"] in arguments.seeds]
    one, two = ([found for found in asked if found["ranks"] == ranks] for ranks in (1, 2))
    for name in ("timesteps", "seconds"):
        print(
            f"median {name} to walk: {_median(one, name):,.4g} on one rank, {_median(two, name):,.4g} on two: "
            f"{_median(two, name) / _median(one, name):.3f}"
        )


def _walked(found: dict[str, Any]) -> str:
    if found["seconds"] is None:
        return "does not walk within the budget"
    return f"walks after {found['timesteps']:,} steps, {found['seconds']:.1f} s"


def _median(results: Iterable[dict[str, Any]], name: str) -> float:
    values = [result[name] for result in results]
    return float(np.median([np.inf if value is None else value for value in values]))


if __name__ == "__main__":
    sys.exit(main())
