"""Measure how much the policies of a recipe differ from one training seed to the next.

tools/recipe_seeds.py runs/<one> runs/<other> ...
tools/recipe_seeds.py --only envelope runs/<one>
tools/recipe_seeds.py --only curves --picture assets/pictures/rough.svg flat rough runs/<other> ...

Runs are grouped by their recipe, and must not differ in anything but the seed. Each recipe gets a table for each
measure, with a row for each seed and one of the medians. `learning`: the policy and its zero action in its own task, as
at the end of a training. `commands`: share of the suite's commands that are met, of the policy and of its zero action,
and falls per hour of the suite's joystick commands, undisturbed and with `moderate`. `joystick`: the same falls in ten
hours of each. `regulation`: episodes that keep their velocities within 20 % under each disturbance of the suite.
`errors`: signed errors of the mean velocities, 8 episodes of 20 s per command. `env`: falls in 300 episodes of 20 s in
the env of the policy's training, with its random commands and its randomization, and the 95 % interval of their share.
`falls`: 1000 episodes of 20 s with the preset `hard`, and the share of time in which a robot sits or leans, tilted by
more than 0.3 rad. `gait`: clearance, bounces per stride and duty factors of the feet in the suite's steady walking,
over the commands forwards, backwards and on turns. `terrain`: the suite's crossings. `envelope`: the largest mean
forward velocity and yaw rate over the commands at which none of 100 episodes of 10 s falls. `curves`: a figure of all
runs.
"""

import argparse
import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
import numpy as np

from benchmarks.recipe_plots import recipe_curves
from benchmarks.shipping import disturbed
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.confidence import proportion
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy, find_policy
from quadruped_env.evaluation.learning_gain import learning_gain
from quadruped_env.evaluation.measures import mean_velocities
from quadruped_env.evaluation.rollout import FIRST_SEED, Rollout
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.changing import run_joystick
from quadruped_env.evaluation.suite.steady import run_command_map, run_gait, run_regulation, run_terrain
from quadruped_env.evaluation.suite.suite_definition import Joystick, full_suite
from quadruped_env.policies import ZeroController
from quadruped_env.report.plots.learning_plots import read_progress
from quadruped_env.simulation.built_in_terrains import HIGHEST, STEEPEST
from quadruped_env.utils.files import write_whole
from quadruped_env.utils.program import run_program
from quadruped_env.utils.progress import Progress, ProgressLine, part_of

STRAIGHT_COMMANDS: Final = ((-0.2, 0.0), (0.0, 0.0), (0.1, 0.0), (0.2, 0.0), (0.3, 0.0), (0.4, 0.0), (0.5, 0.0))
TURN_COMMANDS: Final = ((0.0, 0.5), (0.0, -0.5), (0.3, 0.5), (0.3, -0.5))
"""Forward velocity in m/s and yaw rate in rad/s."""
FASTEST: Final = tuple((round(0.4 + 0.05 * i, 2), 0.0) for i in range(13))
TIGHTEST: Final = tuple((0.0, round(0.4 + 0.1 * i, 1)) for i in range(17))

TEN_HOURS: Final = replace(full_suite().joystick, num_seeds=600)
"""A minute with each seed."""

_NEW_COMMAND: Final = 0.8
"""Time after a new command in which a fall is due to it, s."""
_SAME_STEPS: Final = 0.75
"""Smallest ratio of the steps of two trainings that count as the same."""

Row = dict[str, float]
"""Column -> value."""


def learning(measured: Candidate, progress: Progress) -> Row:
    """Policy and zero action in the policy's own task."""
    gain = learning_gain(measured.controller.policy, progress=progress, motion_seeds=0)  # type: ignore[attr-defined]
    policy, zero = gain.policy, gain.zero
    return {
        "return per second": policy.return_per_second.mean,
        "zero action": zero.return_per_second.mean,
        "gain, 95 % from": gain.difference.low,
        "own commands met, %": 100.0 * policy.own_commands_met.mean,
        "zero action, %": 100.0 * zero.own_commands_met.mean,
        "falls, %": 100.0 * policy.falls.mean,
        "power, W": policy.electrical_power.mean,
    }


def commands(measured: Candidate, progress: Progress) -> Row:
    """Commands of the suite that are met, and falls per hour of its joystick commands."""
    suite = full_suite()
    met = [run_command_map(suite.commands, one, None)["met"]["mean"] for one in (measured, measured.zero_action())]
    row = {"commands met, %": 100.0 * met[0], "zero action, %": 100.0 * met[1]}
    return row | joystick_hours(measured, progress, suite.joystick)


def joystick_hours(measured: Candidate, progress: Progress, part: Joystick = TEN_HOURS) -> Row:
    """Falls per hour of joystick commands, and the upper end of their 95 % interval."""
    row: Row = {}
    for name, law in run_joystick(part, measured, progress)["laws"].items():
        share = law["falls_per_hour"]
        row |= {f"falls per hour, {name}": share["mean"], f"95 % to, {name}": share["high"]}
    return row


def regulation(measured: Candidate, progress: Progress) -> Row:
    """Episodes that keep both velocities under each disturbance of the suite, of the policy and its zero action, %."""
    part = full_suite().regulation
    policy = run_regulation(part, measured, part_of(progress, 0.0, 0.5))
    zero = run_regulation(part, measured.zero_action(), part_of(progress, 0.5, 1.0))
    return {
        f"{name}{whose}": 100.0 * entry["kept"]["mean"]
        for whose, result in (("", policy), (", zero action", zero))
        for name, entry in result["disturbances"].items()
    }


def errors(measured: Candidate, progress: Progress, episodes: int = 8) -> Row:
    """Signed error of the mean velocity at every command, m/s or, on turns, rad/s."""
    commands = (*STRAIGHT_COMMANDS, *TURN_COMMANDS)
    rollout = measured.run(commands, range(FIRST_SEED, FIRST_SEED + episodes), 20.0, progress)
    means = np.nanmean(mean_velocities(rollout).reshape(len(commands), episodes, 2), axis=1)
    row = {}
    for (forward, turn), (reached_forward, reached_turn) in zip(commands, means, strict=True):
        on_turn = turn != 0.0
        name = f"{forward:g} m/s, {turn:g} rad/s" if on_turn else f"{forward:g} m/s"
        row[name] = float(reached_turn - turn if on_turn else reached_forward - forward)
    return row


def own_env(measured: Candidate, progress: Progress, episodes: int = 300, seconds: float = 20.0) -> Row:
    """Episodes of the env of the policy's training, with random commands, that end in a fall, and their share in %."""
    policy = measured.controller.policy  # type: ignore[attr-defined]
    env = policy.make_vec_env(episodes)
    task, dt = env.unwrapped.task, policy.config.control_timestep
    steps = round(seconds / dt)
    observation, _ = env.reset(seed=FIRST_SEED)
    fallen, after_command, age = np.zeros(episodes, bool), np.zeros(episodes, bool), np.zeros(episodes)
    command = task.command.copy()
    for step in range(steps):
        age = np.where((task.command != command).any(axis=1), 0.0, age) + dt
        command = task.command.copy()
        observation, _, terminated, _, _ = env.step(policy.predict(observation))
        # An env restarts after a fall, and its second episode does not count.
        after_command |= terminated & ~fallen & (age <= _NEW_COMMAND + 1e-9)
        fallen |= terminated
        progress((step + 1) / steps)
    env.close()
    share = proportion(fallen)
    return {
        "episodes": episodes,
        "falls": int(fallen.sum()),
        "falls, %": 100.0 * share.mean,
        "95 % from": 100.0 * share.low,
        "95 % to": 100.0 * share.high,
        f"falls within {_NEW_COMMAND:g} s of a new command": int(after_command.sum()),
    }


def falls(measured: Candidate, progress: Progress, episodes: int = 200) -> Row:
    """Share of episodes that end in a fall with the preset `hard`, and of time tilted by more than 0.3 rad, %."""
    policy = measured.controller.policy  # type: ignore[attr-defined]
    result = disturbed(policy, episodes, part_of(progress, 0.0, 0.5))
    zero = disturbed(policy, episodes, part_of(progress, 0.5, 1.0), ZeroController(policy.action_mode))
    shares = {"all": result["fall_rate"], **result["fall_rate_by_command"], "tilted": result["tilted_share"]}
    shares["zero action"] = zero["fall_rate"]
    return {name: 100.0 * share for name, share in shares.items()}


def gait(measured: Candidate, progress: Progress) -> Row:
    """Least clearance (mm), most bounces, largest difference of duty factors, and the electrical cost of transport."""
    commands = run_gait(full_suite().gait, measured, progress)["commands"]
    groups = {
        "forwards": [entry for entry in commands if entry["command"][1] == 0.0 and entry["command"][0] > 0.0],
        "backwards": [entry for entry in commands if entry["command"][1] == 0.0 and entry["command"][0] < 0.0],
        "turning": [entry for entry in commands if entry["command"][1] != 0.0],
    }
    row = {f"clearance {name}, mm": 1e3 * float(np.min(_of_feet("clearance", group))) for name, group in groups.items()}
    row |= {f"bounces {name}": float(np.max(_of_feet("bounces_per_stride", group))) for name, group in groups.items()}
    for name in ("forwards", "backwards"):
        duty = np.array([entry["duty_factor"] for entry in groups[name]], dtype=float)
        row[f"duty factors apart {name}"] = float(np.max(np.ptp(duty, axis=1)))
    costs = {tuple(entry["command"]): entry["electrical_cost_of_transport"] for entry in commands}
    return {**row, "electrical cost of transport": costs[0.4, 0.0] or math.nan}


def _of_feet(measure: str, entries: Sequence[dict[str, Any]]) -> list[float]:
    """Return values of every foot at every command; NaN where a robot does not stride."""
    return [math.nan if value is None else value for entry in entries for value in entry[measure]]


def terrain(measured: Candidate, progress: Progress) -> Row:
    """Height, depth (mm) or angle (degrees) of the highest level of each terrain that is passed; 0 for none."""
    part = full_suite().terrain
    results = run_terrain(part, measured, progress)
    row = {}
    for kind, result in results["kinds"].items():
        unit, hardest = ("degrees", math.degrees(STEEPEST)) if kind == "slope" else ("mm", HIGHEST * 1e3)
        row[f"{kind}, {unit}"] = hardest * result["highest_level"] / part.levels
    return row


def envelope(measured: Candidate, progress: Progress, episodes: int = 100) -> Row:
    """Largest mean forward velocity, m/s, and yaw rate in place, rad/s, at which no episode of 10 s falls."""
    commands = (*FASTEST, *TIGHTEST)
    rollout = measured.run(commands, range(FIRST_SEED, FIRST_SEED + episodes), 10.0, progress)
    return fastest(rollout, len(FASTEST), episodes)


def fastest(rollout: Rollout, straight: int, episodes: int) -> Row:
    """Largest mean velocities of the commands without a fall: the first `straight` are forwards, the rest turns."""
    held = ~rollout.fallen.reshape(-1, episodes).any(axis=1)
    means = mean_velocities(rollout).reshape(-1, episodes, 2).mean(axis=1)
    means[~held] = 0.0
    return {
        "forwards, m/s": float(means[:straight, 0].max(initial=0.0)),
        "turning in place, rad/s": float(means[straight:, 1].max(initial=0.0)),
    }


MEASURES: Final[dict[str, Callable[[Candidate, Progress], Row]]] = {
    "learning": learning,
    "commands": commands,
    "joystick": joystick_hours,
    "regulation": regulation,
    "errors": errors,
    "env": own_env,
    "falls": falls,
    "gait": gait,
    "terrain": terrain,
    "envelope": envelope,
}
CURVES: Final = "curves"


def main() -> int:
    """Parse the arguments and measure."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="RUN", help="a run's directory")
    parser.add_argument(
        "--only", action="append", choices=[*MEASURES, CURVES], help="may be given several times; default: all measures"
    )
    parser.add_argument(
        "--picture",
        type=Path,
        default=Path("results/recipes.svg"),
        help="file of the learning curves (default: %(default)s)",
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Measure every run, and print a table for each recipe and measure."""
    wanted = arguments.only or [*MEASURES, CURVES]
    recipes = by_recipe([find_policy(run, Path()) for run in arguments.runs])
    for recipe, policies in recipes.items():
        for measure in (measure for measure in wanted if measure in MEASURES):
            rows = []
            for evaluated in policies:
                progress = ProgressLine(f"{measure} of {evaluated.name}")
                rows.append(MEASURES[measure](Candidate.of_policy(evaluated.policy, evaluated.name), progress))
            print(f"\n{recipe}, {measure}\n\n{table(rows, [_seed(evaluated) for evaluated in policies])}", flush=True)
    if CURVES in wanted:
        curves = {
            recipe: [read_progress(evaluated.progress_file) for evaluated in policies if evaluated.progress_file]
            for recipe, policies in recipes.items()
        }
        arguments.picture.parent.mkdir(parents=True, exist_ok=True)
        write_whole({arguments.picture: recipe_curves(curves).encode()})
        print(f"\nlearning curves: {arguments.picture}")
    return 0


def by_recipe(policies: Sequence[EvaluatedPolicy]) -> dict[str, list[EvaluatedPolicy]]:
    """Policies by the recipe, and the algorithm unless it is PPO, that they were trained with.

    Raises:
        QuadrupedError: if two policies of a recipe differ in more than the seed, or do not say what they come from.
    """
    recipes: dict[str, list[EvaluatedPolicy]] = {}
    for evaluated in policies:
        card = evaluated.policy.card
        if not {"recipe", "algo", "seed", "timesteps"} <= set(card):
            raise QuadrupedError(f"{evaluated.name}: expected a trained policy; its card names no recipe or seed")
        name = card["recipe"] if card["algo"] == "ppo" else f"{card['recipe']}, {card['algo']}"
        same = recipes.setdefault(name, [])
        first = same[0].policy if same else evaluated.policy
        steps = first.card["timesteps"], card["timesteps"]
        # A budget in seconds does not give the same number of steps twice.
        if first.config != evaluated.policy.config or min(steps) < _SAME_STEPS * max(steps):
            raise QuadrupedError(f"{evaluated.name}: expected the settings of {same[0].name}, with another seed")
        same.append(evaluated)
    return recipes


def _seed(evaluated: EvaluatedPolicy) -> str:
    return str(evaluated.policy.card["seed"])


def table(rows: Sequence[Row], seeds: Sequence[str]) -> str:
    """Markdown table with a row for each seed, and one of the medians."""
    columns = list(rows[0])
    medians = {name: float(np.median([row[name] for row in rows])) for name in columns}
    lines = [f"| seed | {' | '.join(columns)} |", "|---|" + "---|" * len(columns)]
    for label, row in zip((*seeds, "median"), (*rows, medians), strict=True):
        lines.append(f"| {label} | {' | '.join(f'{row[name]:.3g}' for name in columns)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
