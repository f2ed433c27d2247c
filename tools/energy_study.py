"""Search how little electrical energy a scripted gait can walk with.

Each row is a search at one frequency of the gait clock, from the gait `tuned`, with one of two scores: `energy` rewards
a gait that keeps its speed, does not fall and costs as little as possible; `steps` also rewards feet that clear the
ground in every stride and touch it once. The table shows the electrical cost of transport (energy over weight and
distance) and what the steps look like; docs/gaits.md holds it.

Takes three minutes per row on two idle cores.
"""

import argparse
import math
import sys
from pathlib import Path
from typing import Final

sys.path.append(str(Path(__file__).parents[1]))  # so that a Python without the package finds it, and prints a fix

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.metrics import cost_of_transport
from quadruped_env.gait import LEG_PHASES, CommandedGait
from quadruped_env.training.gait_styles import STYLES, Judge
from quadruped_env.training.gait_trial import ROBOT, Achieved
from quadruped_env.training.gait_tuning import Found, search
from quadruped_env.utils.files import write_json
from quadruped_env.utils.interpreter import pasteable
from quadruped_env.utils.program import run_program

_SPREADS: Final = (0.08, 0.05, 0.03)
"""Standard deviations with which the searches of a row begin, each from the result of the one before."""
_LEAST_SPEED: Final = 0.1
"""Forward velocity below which cost of transport is not what a gait is judged by, m/s."""


def transport(got: Achieved) -> NDArray[np.float64]:
    """Electrical cost of transport (N,) of gaits."""
    return cost_of_transport(got.electrical_power, np.maximum(got.forward_velocity, _LEAST_SPEED), ROBOT.total_mass)


def energy(got: Achieved, speed: float, yaw_rate: NDArray[np.float64]) -> NDArray[np.float64]:
    """Scores (N,) of gaits that only have to keep a speed and a course: see `Judge`."""
    score: NDArray[np.float64] = (
        -150.0 * np.abs(got.forward_velocity - speed)
        - 20.0 * np.abs(got.yaw_rate - yaw_rate)
        - 20.0 * np.abs(got.lateral_velocity)
        - 10.0 * got.fallen
        - 40.0 * transport(got)
    )
    return score


def steps(got: Achieved, speed: float, yaw_rate: NDArray[np.float64]) -> NDArray[np.float64]:
    """Scores (N,) of gaits whose steps matter as in the search of `tuned`, next to the energy: see `Judge`."""
    clean = STYLES["tuned"].straight.steps._replace(electrical_cost=0.0)
    score: NDArray[np.float64] = clean.judge(got, speed, yaw_rate) - 40.0 * transport(got)
    return score


JUDGES: Final[dict[str, Judge]] = {"energy": energy, "steps": steps}


def main() -> int:
    """Parse the arguments and search."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--speed", type=float, default=0.4, help="forward velocity, m/s (default: %(default)s)")
    parser.add_argument(
        "--frequencies", type=float, nargs="+", default=[2.6, 3.0, 3.4], metavar="HZ", help="default: 2.6 3.0 3.4"
    )
    parser.add_argument(
        "--generations", type=int, default=24, metavar="N", help="of each of the three searches (default: %(default)s)"
    )
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        default=Path("results/energy.json"),
        help="where to write JSON (default: %(default)s)",
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the searches, print the table, and write the legs' columns."""
    print("| score | Hz | forward m/s | electrical cost of transport | least lift mm | touchdown error | fell |")
    print("|---|---|---|---|---|---|---|")
    results = []
    for name, judge in JUDGES.items():
        for frequency in arguments.frequencies:
            found = cheapest(arguments.speed, frequency, arguments.generations, judge)
            print(_row(name, frequency, found.achieved), flush=True)
            results.append(
                {
                    "score": name,
                    "frequency": frequency,
                    "electrical_cost_of_transport": float(transport(found.achieved)[0]),
                    "legs": found.candidate[0].tolist(),
                }
            )
    write_json(arguments.output, {"speed": arguments.speed, "results": results})
    print(f"\nwritten to {arguments.output}")
    return 0


def cheapest(speed: float, frequency: float, generations: int, judge: Judge) -> Found:
    """The best straight gait for a speed (m/s) at a frequency (Hz), from the gait `tuned`."""
    gait = CommandedGait.tuned(ROBOT)
    start = np.zeros((3, 2, 6))
    start[0] = legs_of(gait, speed)
    for seed, spread in enumerate(_SPREADS):
        found = search(
            speed, math.tau * frequency, LEG_PHASES["trot"], start, spread, generations, seed=seed, judge=judge
        )
        start = found.candidate
    return found


def legs_of(gait: CommandedGait, speed: float) -> NDArray[np.float64]:
    """Columns of the fore and the hind leg (2, 6) of a gait straight ahead, rad."""
    sine, cosine, offset = (wave[0].reshape(4, 2) for wave in gait.waves(np.array([[speed, 0.0]])))
    columns = [sine[:, 0], offset[:, 0], cosine[:, 1], sine[:, 1], offset[:, 1], cosine[:, 0]]
    return np.stack(columns, axis=1)[[0, 2]]


def _row(name: str, frequency: float, got: Achieved) -> str:
    return (
        f"| {name} | {frequency:g} | {got.forward_velocity[0]:.3f} | {transport(got)[0]:.2f} | "
        f"{1e3 * got.clearance[0]:.0f} | {got.touchdown_error[0]:.2f} | {'yes' if got.fallen[0] else 'no'} |"
    )


if __name__ == "__main__":
    sys.exit(main())
