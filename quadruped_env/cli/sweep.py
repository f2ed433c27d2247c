"""Train many policies at once: seeds of one config, or a search over its settings.

mini-quadruped sweep --seeds 8                       eight seeds of one config, side by side on all cores
mini-quadruped sweep --seeds 8 --recipe walker       with any option of 'train'
mini-quadruped sweep --vary learning_rate=1e-4..1e-2:log --vary hidden=64x64,128x128 --trials 20
mini-quadruped sweep --vary task.reward.weights.foot_slip=-1..0 --trials 20 --seeds 3
mini-quadruped sweep --work sweeps/<name>            do its trials until none is left, on any machine that sees it
mini-quadruped sweep --ray auto sweeps/<name>        workers on a running Ray cluster
mini-quadruped sweep --report sweeps/<name>          its results so far

Each trial is one training, as 'train' does it, with its run directory in sweeps/<name>/trials/. A worker that is
stopped or lost leaves its trial to the next one, which goes on from the trial's last checkpoint. docs/scaling.md has
Slurm, Ray and Kubernetes.
"""

import argparse
import math
import sys
from dataclasses import replace
from pathlib import Path
from typing import Final

from quadruped_env.cli.common_options import add_output, add_trust_task
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.train import add_settings, typed_settings
from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.sweep.folder import Sweep
from quadruped_env.sweep.space import parse_dimension
from quadruped_env.training import TrainConfig
from quadruped_env.training.run_directory import new_directory
from quadruped_env.utils.interpreter import program_command
from quadruped_env.utils.program import CLEAR_LINE, Extras
from quadruped_env.utils.progress import ProgressLine
from quadruped_env.utils.provenance import cores

SWEEPS: Final = Path("sweeps")
"""Default directory of the sweeps."""
_BESIDE_A_SWEEP: Final = (
    *("work", "ray", "report", "workers", "output", "retry_failed", "trust_task"),
    *("command", "in_options"),  # of the parser
)
"""Arguments that may stand next to the directory of a sweep. All others define a sweep, and are None if not typed."""
UNFINISHED_STATUS: Final = 1
"""Exit status while a trial has failed, or is open."""
DEFAULT_TRIALS: Final = 20
"""Number of settings of a search without --trials over a space with a range."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of the sweep, and the settings of a training."""
    group = parser.add_argument_group("sweep")
    group.add_argument("--seeds", type=int, metavar="N", help="seeds of each setting, from --seed on (default: 1)")
    group.add_argument(
        "--vary",
        action="append",
        metavar="FIELD=VALUES",
        help="a field that varies: FIELD=LOW..HIGH, FIELD=LOW..HIGH:log or FIELD=CHOICE,CHOICE; a field of the "
        "training as its option without dashes in front and with _ for -, or a field of the task's config such as "
        "task.reward.weights.foot_slip; may be given again",
    )
    group.add_argument(
        "--trials",
        type=int,
        metavar="N",
        help=f"settings to try, each with every seed (default: all, of ranges {DEFAULT_TRIALS}). Optuna chooses them",
    )
    add_output(group, "DIR", f"directory of the sweeps (default: {SWEEPS})", SWEEPS)  # type: ignore[arg-type]
    group.add_argument(
        "--workers", type=int, metavar="N", help="worker processes (default: one per core; with --work: 1); 0: none yet"
    )
    place = group.add_mutually_exclusive_group()
    place.add_argument("--work", type=Path, metavar="SWEEP", help="do trials of a sweep until none is left")
    place.add_argument(
        "--ray", nargs=2, metavar=("ADDRESS", "SWEEP"), help="do them on a running Ray cluster; ADDRESS may be 'auto'"
    )
    place.add_argument("--report", type=Path, metavar="SWEEP", help="write the report of a sweep as it is now")
    group.add_argument(
        "--retry-failed", action="store_true", help="with --work or --ray: also train the failed trials again"
    )
    add_trust_task(group, "with --work or --ray: execute the sweep's copy of its task file")
    add_settings(parser)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Make a sweep, or go on with one, and print its results."""
    place = arguments.report or arguments.work or (arguments.ray and Path(arguments.ray[1]))
    if (arguments.workers or 0) < 0:
        raise QuadrupedError(f"--workers: expected 0 or more; found {arguments.workers}")
    if place is None:
        sweep = make(arguments, invocation.line)
        print(f"{sweep} -> {sweep.path}", flush=True)
    else:
        sweep = Sweep.open(place)
        check_no_definition(arguments)
    again = program_command("sweep", "--work", sweep.path, *["--trust-task"] * (sweep.task_file is not None))
    if arguments.workers == 0:
        print(f"a worker, on any machine that sees this directory:  {again}")
        return 0
    if arguments.report is None:
        if arguments.retry_failed:
            sweep.retry_failed()
        whole = True
        try:
            errors = do_trials(sweep, arguments, arguments.trust_task or place is None)
        except (QuadrupedError, OSError, MemoryError, ImportError) as error:
            whole, errors = False, [f"mini-quadruped sweep: error: {error}"]
        except KeyboardInterrupt:
            print(f"stopped; go on with:  {again}", flush=True)
            raise
        for line in errors:
            print(line, file=sys.stderr)
        if left := sweep.open_trials():
            print(f"open trials: {len(left)} of {len(sweep)}; go on with:  {again}")
        if left or not whole:
            return UNFINISHED_STATUS
    return print_results(sweep)


def do_trials(sweep: Sweep, arguments: argparse.Namespace, trusted: bool) -> list[str]:
    """Do the open trials of a sweep, here or by workers, and return the errors that ended workers."""
    # Torch takes seconds to import.
    from quadruped_env.sweep.worker import work
    from quadruped_env.sweep.workers import run_here, run_on_ray

    if arguments.ray is not None:
        return run_on_ray(sweep, arguments.workers, trusted, arguments.ray[0], Progress(sweep))
    if arguments.work is not None and arguments.workers in (None, 1):
        work(sweep, trusted, lambda line: print(line, flush=True))
        return []
    return run_here(sweep, min(arguments.workers or cores(), len(sweep)), trusted, Progress(sweep))


def make(arguments: argparse.Namespace, command: str) -> Sweep:
    """Make the sweep that the options define.

    Raises:
        QuadrupedError: if an option is not valid.
    """
    if arguments.retry_failed or arguments.trust_task:
        raise QuadrupedError("--retry-failed, --trust-task: only with --work or --ray")
    typed, task_file, definition, whole = typed_settings(arguments)
    sections, name = tuple(sorted(whole)), typed.get("name", typed.get("algo", TrainConfig.name))
    base = Sweep(Path(), typed, sections).config({}, 0, definition)
    task = task_config(base.action_mode, base.task, task_file).to_dict()
    space = [parse_dimension(text, task) for text in arguments.vary or ()]
    if len(dict(space)) < len(space):
        raise QuadrupedError(f"--vary: found {', '.join(field for field, _ in space)}; give each field once")
    sweep = Sweep(Path(), typed, sections, dict(space), seeds=1 if arguments.seeds is None else arguments.seeds)
    settings = DEFAULT_TRIALS if math.isinf(sweep.size) else int(sweep.size)
    sweep = replace(sweep, settings=settings if arguments.trials is None else arguments.trials)
    sweep.check(definition)
    return replace(sweep, path=new_directory(arguments.output, name)).create(command, definition)


def check_no_definition(arguments: argparse.Namespace) -> None:
    """Refuse options that define a sweep when the directory of a sweep is given."""
    for name, value in vars(arguments).items():
        if value is not None and name not in _BESIDE_A_SWEEP:
            raise QuadrupedError(f"--{name.replace('_', '-')}: a sweep keeps its own definition; leave the option out")


def print_results(sweep: Sweep) -> int:
    """Print the results of a sweep, write its report, and return the exit status: 1 if a trial failed."""
    from quadruped_env.sweep.report import collect, headline, table, write_report

    found, extras = collect(sweep), Extras()
    print(f"\n{table(found, sweep.seeds).text()}\n\n{headline(found)}")
    with extras.part("report.html"):
        print(f"report:  {write_report(sweep)}")
    if found["best"] is not None:
        task = ["--trust-task"] * (sweep.task_file is not None)
        print(f"see it walk:  {program_command('view', sweep.path / found['best']['run'], *task)}")
    return UNFINISHED_STATUS if found["states"]["failed"] else extras.status


class Progress:
    """Printer of each new result of a sweep and of the progress of the whole."""

    def __init__(self, sweep: Sweep) -> None:
        self._sweep, self._open, self._line = sweep, sweep.open_trials(), ProgressLine("sweep")

    def __call__(self) -> None:
        """Read the files, and print what is new."""
        from quadruped_env.sweep.worker import result_in_words, share_done

        before, self._open = self._open, self._sweep.open_trials()
        for number in before:
            if (result := self._sweep.result(number)) is not None:
                print(f"{CLEAR_LINE * sys.stderr.isatty()}{result_in_words(number, result)}", flush=True)
        count, done = len(self._sweep), len(self._sweep) - len(self._open)
        begun = sum(share_done(self._sweep.trial(number)) for number in self._open)
        self._line((done + begun) / count, f", {done} of {count} trials done")
