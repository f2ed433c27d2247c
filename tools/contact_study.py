"""Measure how a gait depends on the contact model: straight, in a curve and turning on the spot.

Each row is a contact model: MuJoCo's with one thing changed, MuJoCo's with a small step and stiff contacts, to which
the others should converge, and Drake's, if it is installed. The columns are what is reached of the commanded
velocities, means over several starts, and what the model costs: the time of a physics step relative to the first
row's, in turns.

docs/notes/contact-models.md holds the table that the choice rests on. Takes two minutes per policy, and as much again
for Drake.
"""

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final, NamedTuple

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
import numpy as np

from quadruped_env.control.control_interface import Controller
from quadruped_env.control.controllers import GaitController
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import evaluation_task
from quadruped_env.evaluation.measures import measure
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.gait import CommandedGait
from quadruped_env.policies import PolicyController, load_policy
from quadruped_env.task import TaskConfig
from quadruped_env.utils.program import run_program
from second_engine.engines import Drake, MuJoCo, check_drake

COMMANDS: Final = ((0.2, 0.0), (0.3, 0.0), (0.5, 0.0), (-0.2, 0.0), (0.0, 0.5), (0.3, 0.5))
"""Forward velocity in m/s and yaw rate in rad/s."""
_ROBOTS: Final = 256
_ROUNDS: Final = 8


class Case(NamedTuple):
    """A contact model."""

    name: str
    engine: MuJoCo | Drake
    timestep: float = 0.005


CASES: Final = (
    Case("pyramid, 20 ms", MuJoCo("pyramidal", 1.0, 0.02)),
    Case("ellipse, 20 ms (MuJoCo's default time constant)", MuJoCo("elliptic", 1.0, 0.02)),
    Case("ellipse, 20 ms, impratio 10", MuJoCo("elliptic", 10.0, 0.02)),
    Case("ellipse, 20 ms, noslip 3", MuJoCo("elliptic", 1.0, 0.02, 3)),
    Case("**ellipse, 10 ms (chosen)**", MuJoCo("elliptic", 1.0, 0.01)),
    Case("ellipse, 10 ms, impratio 10", MuJoCo("elliptic", 10.0, 0.01)),
    Case("ellipse, 8 ms, step 4 ms", MuJoCo("elliptic", 1.0, 0.008), 0.004),
    Case("ellipse, 5 ms, step 2.5 ms", MuJoCo("elliptic", 1.0, 0.005), 0.0025),
    Case("ellipse, 1 ms, step 0.5 ms (limit)", MuJoCo("elliptic", 1.0, 0.001), 0.0005),
    Case("Drake, sap, step 2 ms", Drake()),
    Case("Drake, similar, step 2 ms", Drake("similar")),
)


def main() -> int:
    """Run the program."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "sources", nargs="*", default=["flat"], metavar="SOURCE", help="policies, or tuned; default: flat"
    )
    parser.add_argument("--seeds", type=int, default=6, help="starts per command; default: 6")
    parser.add_argument("--seconds", type=float, default=8.0, help="length of an episode, s; default: 8")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Measure, and print the tables."""
    cases = [case for case in CASES if isinstance(case.engine, MuJoCo) or _has_drake()]
    costs = step_costs([case for case in cases if isinstance(case.engine, MuJoCo)])
    for source in arguments.sources:
        print(f"\n{source}\n")
        print("| contact model | " + " | ".join(f"{v:g} m/s, {w:g} rad/s" for v, w in COMMANDS) + " | fell | cost |")
        print("|---|" + "---|" * (len(COMMANDS) + 2))
        for number, case in enumerate(cases):
            cells, fallen = reached(source, case, arguments.seeds, arguments.seconds)
            cost = f"{costs[number]:.2f}" if number < len(costs) else ""
            print(f"| {case.name} | {' | '.join(cells)} | {fallen} | {cost} |", flush=True)
    return 0


def _has_drake() -> bool:
    try:
        check_drake()
    except QuadrupedError:
        return False
    return True


def with_timestep(config: TaskConfig, timestep: float) -> TaskConfig:
    """Return the same task at another physics step; the control step stays."""
    return replace(config, physics_timestep=timestep, decimation=round(config.control_timestep / timestep))


def reached(source: str, case: Case, seeds: int, seconds: float) -> tuple[list[str], int]:
    """Forward velocity and yaw rate reached at each command, as text, and the number of falls."""
    controller: Controller
    if source == "tuned":
        controller, config = GaitController(), TaskConfig()
    else:
        policy = load_policy(source)
        controller, config = PolicyController(policy), policy.config.on_terrain("flat")
    config = with_timestep(evaluation_task(config, COMMANDS, "none"), case.timestep)
    rollout = roll_out(controller, COMMANDS, range(FIRST_SEED, FIRST_SEED + seeds), seconds, config, engine=case.engine)
    metrics = measure(rollout)
    means = [np.nanmean(np.reshape(metrics[name], (-1, seeds)), axis=1) for name in ("forward_velocity", "yaw_rate")]
    cells = [f"{forward:+.3f}, {turn:+.2f}" for forward, turn in zip(*means, strict=True)]
    return cells, int(rollout.fallen.sum())


def step_costs(cases: Sequence[Case]) -> list[float]:
    """Time of a control step's physics relative to the first case, with walking robots: the best of several rounds."""
    config = TaskConfig()
    robot, gait = config.robot, CommandedGait.preset("tuned", config.robot)
    command = np.tile([0.3, 0.3], (_ROBOTS, 1))
    steps = np.arange(round(1.0 / config.control_timestep)) * config.control_timestep
    # The robots are at different phases, as in training.
    phases = gait.angular_frequency * steps[:, None] + np.linspace(0.0, 2.0 * np.pi, _ROBOTS)
    targets = [gait.positions(phase, command) for phase in phases]
    simulations = [case.engine(with_timestep(config, case.timestep), _ROBOTS) for case in cases]
    qpos = np.zeros((_ROBOTS, robot.num_positions))
    qpos[:, 2], qpos[:, 3], qpos[:, 7:] = robot.stance_height, 1.0, robot.stance
    for simulation in simulations:
        simulation.reset(np.arange(_ROBOTS), qpos, np.zeros((_ROBOTS, robot.num_velocities)))
    times: list[list[float]] = [[] for _ in cases]
    for _ in range(_ROUNDS):
        for case, simulation, spent in zip(cases, simulations, times, strict=True):
            start = time.perf_counter()
            for target in targets:
                simulation.step(target, round(config.control_timestep / case.timestep))
            spent.append(time.perf_counter() - start)
    best = [min(spent) for spent in times]
    return [value / best[0] for value in best]


if __name__ == "__main__":
    sys.exit(main())
