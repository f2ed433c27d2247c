"""Train many policies at once on Ray Tune: seeds of one config, or a search over its settings.

mini-quadruped sweep --seeds 8                       eight seeds of one config, side by side on all cores
mini-quadruped sweep --seeds 8 --recipe rough        with any option of 'train'
mini-quadruped sweep --vary learning_rate=1e-4..1e-2:log --vary hidden=64x64,128x128 --trials 20
mini-quadruped sweep --vary task.reward.weights.foot_slip=-1..0 --trials 20 --seeds 3
mini-quadruped sweep --space space.toml --trials 40 --search optuna --scheduler asha
mini-quadruped sweep --seeds 8 --address 10.0.0.5:6379     on a running Ray cluster, in a trusted network
mini-quadruped sweep --resume sweeps/<name>          go on after an interruption

Each trial is one training, as of 'train', with its run directory in sweeps/<name>/trials/. docs/scaling.md says more.
"""

import argparse
import math
import os
import signal
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, Final

from quadruped_env.cli.common_options import add_output
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.train import add_settings, typed_settings
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.sweep.search_space import Dimension, parse_dimension, read_space
from quadruped_env.sweep.sweep_definition import SCHEDULERS, SCORES, SEARCHES, MakeConfig, SweepConfig, sha256_of
from quadruped_env.sweep.sweep_records import SweepFolder
from quadruped_env.training import TrainConfig
from quadruped_env.training.recipes import check_used, with_recipe
from quadruped_env.utils.interpreter import program_command
from quadruped_env.utils.plain import plain
from quadruped_env.utils.program import Extras, on_stop, stopped_status

SWEEPS: Final = Path("sweeps")
"""Default directory of the sweeps."""
DEFAULT_TRIALS: Final = 20
"""Settings of a search without --trials."""
_OPTIONS: Final = {
    "seeds": "--seeds",
    "trials": "--trials",
    "search": "--search",
    "scheduler": "--scheduler",
    "reduction": "--reduction",
    "rungs": "--rungs",
    "score": "--score",
    "cores_per_trial": "--cores-per-trial",
}
"""Options of the definition, which a resumed sweep keeps."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of a training, and those of the sweep."""
    group = parser.add_argument_group("sweep")
    default = SweepConfig()
    group.add_argument(
        "--seeds",
        type=int,
        metavar="N",
        help="seeds of each setting, --seed and those after it (default: 1)",
    )
    group.add_argument(
        "--vary",
        action="append",
        default=[],
        metavar="FIELD=VALUES",
        help="a field that varies: FIELD=LOW..HIGH, FIELD=LOW..HIGH:log or FIELD=CHOICE,CHOICE; a field of the "
        "training as its option without dashes in front and with _ for -, or a field of the task's config such as "
        "task.reward.weights.foot_slip; may be given again",
    )
    group.add_argument("--space", type=Path, metavar="FILE", help="TOML or JSON file of fields that vary")
    group.add_argument(
        "--trials",
        type=int,
        metavar="N",
        help=f"settings to try, each with every seed (default: {DEFAULT_TRIALS}; all of a grid)",
    )
    group.add_argument(
        "--search", choices=SEARCHES, help=f"choice of the settings (default: {default.search}; optuna: TPE)"
    )
    group.add_argument(
        "--scheduler",
        choices=SCHEDULERS,
        help="asha: stop the worse trials early, by the suite's score (default: none)",
    )
    group.add_argument(
        "--reduction", type=int, metavar="N", help=f"asha goes on with one in N (default: {default.reduction})"
    )
    group.add_argument(
        "--rungs", type=int, metavar="N", help=f"times at which asha compares the trials (default: {default.rungs})"
    )
    group.add_argument(
        "--score",
        choices=SCORES,
        help=f"score of a finished trial: the quick suite, the full one (minutes), or none (default: {default.score})",
    )
    group.add_argument(
        "--cores-per-trial",
        type=int,
        metavar="N",
        help="cores and threads of each trial; more trials run side by side with fewer (default: 1)",
    )
    group.add_argument("--cores", type=int, metavar="N", help="cores of this machine to use (default: all)")
    group.add_argument(
        "--address",
        metavar="HOST:PORT",
        help="running Ray cluster, of which this machine is a node (default: Ray starts here, on loopback)",
    )
    group.add_argument(
        "--resume", type=Path, metavar="SWEEP", help="directory of a sweep to go on with; finished trials stay"
    )
    add_output(group, "DIR", f"directory of the sweeps, which all nodes share (default: {SWEEPS})", SWEEPS)  # type: ignore[arg-type]
    add_settings(parser)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Run the sweep, write its results and its report, and print where they are."""
    from quadruped_env.sweep.ray_connection import check_answers, check_installed
    from quadruped_env.sweep.sweep_results import collect, table, write

    here = _cores() if arguments.cores is None else arguments.cores
    if here < 1:
        raise QuadrupedError(f"--cores: expected 1 or more; found {here}")
    if arguments.address is not None and arguments.cores is not None:
        raise QuadrupedError("--cores: found with --address; the cluster's nodes have their own number of cores")
    config, make = definition(arguments)
    if arguments.address is None and config.cores_per_trial > here:
        raise QuadrupedError(f"--cores-per-trial: found {config.cores_per_trial}; this machine has {here}; lower it")
    check_installed("A sweep")
    if arguments.address is not None:
        check_answers(arguments.address)
    if arguments.resume is None:
        config.check(make)
        name = config.training.get("name", config.training.get("algo", TrainConfig.name))
        folder = SweepFolder.create(arguments.output, name, config, invocation.line)
    else:
        folder = SweepFolder.open(arguments.resume)
    print(f"{describe(config)} -> {folder.path}", flush=True)

    from quadruped_env.sweep.sweep_driver import run_sweep

    received: list[int] = []
    with on_stop(partial(_stop, received)):
        complete = run_sweep(folder, make, arguments.address, here, lambda line: print(line, flush=True))
    results = collect(folder, invocation.line)
    numbers, rows = write(folder, results)
    scores = table(results)
    heading = "score: mean over the seeds [95 % interval]\n"
    print(f"\n{heading + scores if scores else 'no trial has a score'}\n")
    extras = _write_report(folder, results)
    print(f"results: {rows} and {numbers}")
    best = results["best"]
    task = [] if config.task_file is None else ["--task", config.task_file]
    if best is not None:
        print(f"best:    trial {best['trial']}, score {best['score']:.3f} -> {folder.path / best['run']}")
        print(f"see it walk:  {program_command('view', folder.path / best['run'], *task)}")
    if not complete:
        print(f"interrupted; go on with:  {program_command('sweep', '--resume', folder.path, *task)}")
        return stopped_status(*received[:1])
    failed = results["states"].get("failed", 0)
    if failed:
        print(f"{failed} of {len(config)} trials failed; {rows} has their errors")
    return extras.status if failed < len(config) else 1


def definition(arguments: argparse.Namespace) -> tuple[SweepConfig, MakeConfig]:
    """The requested sweep, or the one that is resumed, and the function that makes its trainings' settings.

    Raises:
        QuadrupedError: if an option is not valid, or not that of the resumed sweep.
    """
    from quadruped_env.envs.arguments import task_config

    typed, task_file, terms, whole = typed_settings(arguments)
    stored = None if arguments.resume is None else SweepFolder.open(arguments.resume).config
    if stored is not None and stored.task_file is not None and task_file is None:
        raise QuadrupedError(
            f"--resume: this sweep has terms from {short(Path(stored.task_file).name)}, which is not executed "
            f"automatically: check the file, then name it with --task FILE"
        )

    def make(fields: Mapping[str, Any]) -> TrainConfig:
        sections = whole if stored is None else stored.whole
        return with_recipe(fields, terms.robot, sections)

    # All fields that vary are those of the task as it is without them.
    base = make(typed if stored is None else stored.training)
    if not (stored is not None and arguments.vary == [] and arguments.space is None):
        task = task_config(base.action_mode, base.task, task_file).to_dict()
        space = [parse_dimension(text, task) for text in arguments.vary]
        space += [] if arguments.space is None else read_space(arguments.space, task)
    else:
        space = []
    check_used(base.algo, {**typed, **{d.field: None for d in space if not d.field.startswith("task.")}})
    if stored is not None:
        _check_kept(arguments, typed, space, task_file, stored)
        return stored, make
    asked = {name: value for name in _OPTIONS if (value := getattr(arguments, name)) is not None}
    settings = asked.pop("trials", None)
    if settings is None:
        grid = math.prod(max(1, len(dimension.choices)) for dimension in space)
        settings = grid if asked.get("search") == "grid" else DEFAULT_TRIALS if space else 1
    return (
        SweepConfig(
            training=typed,
            space=tuple(space),
            settings=settings,
            whole=tuple(sorted(whole)),
            task_file=None if task_file is None else str(task_file.resolve()),
            task_sha256=None if task_file is None else sha256_of(task_file),
            **asked,
        ),
        make,
    )


def _check_kept(
    arguments: argparse.Namespace,
    typed: Mapping[str, Any],
    space: list[Dimension],
    task_file: Path | None,
    stored: SweepConfig,
) -> None:
    """Refuse options that differ from the definition of the sweep that is resumed."""
    found: list[tuple[str, Any, Any]] = []
    for name, option in _OPTIONS.items():
        value = getattr(arguments, name)
        found.append((option, value, getattr(stored, "settings" if name == "trials" else name)))
    for name, value in typed.items():
        default = getattr(TrainConfig(), name)
        found.append((f"--{name.replace('_', '-')}", value, stored.training.get(name, default)))
    if space:
        found.append(("--vary", [str(d) for d in space], [str(d) for d in stored.space]))
    if task_file is not None:
        found.append((f"--task {task_file}: SHA-256", sha256_of(task_file), stored.task_sha256))
    for option, value, kept in found:
        if value is not None and plain(value) != plain(kept):
            raise QuadrupedError(
                f"{option}: found {short(value)}; the sweep in {arguments.resume} has {short(kept)}, and a resumed "
                f"sweep keeps its definition: leave the option out, or start a new sweep without --resume"
            )


def _cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def describe(config: SweepConfig) -> str:
    """A sweep in words."""
    seeds = f"{config.seeds} seed{'s' if config.seeds > 1 else ''}"
    if not config.space:
        return f"{seeds} of one config"
    fields = ", ".join(map(str, config.space))
    asha = f", stopped early by ASHA at {config.rungs} rungs" if config.scheduler == "asha" else ""
    return f"{config.settings} settings ({config.search}) of {fields}, each with {seeds}{asha}"


def _stop(received: list[int], number: int) -> None:
    """Remember a signal, and end the sweep as Ctrl-C does, the one signal that Ray Tune handles."""
    received.append(number)
    if number == signal.SIGINT:
        raise KeyboardInterrupt
    signal.raise_signal(signal.SIGINT)


def _write_report(folder: SweepFolder, results: Mapping[str, Any]) -> Extras:
    extras = Extras()
    with extras.part("report.html"):
        from quadruped_env.report.pages.sweep_report import write_sweep_report

        print(f"report:  {write_sweep_report(folder.path, results)}")
    return extras
