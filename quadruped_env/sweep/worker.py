"""A worker takes an open trial, trains it from where it was left, scores it, writes its result, and takes the next."""

import contextlib
import signal
import socket
import time
import traceback
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

from quadruped_env.control.task_file import KEPT_FILE
from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import run_suite
from quadruped_env.evaluation.suite.suite_definition import quick_suite
from quadruped_env.policies import ZeroController
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.report.pages.suite_section import write_results
from quadruped_env.report.plots.learning_plots import read_progress
from quadruped_env.sweep.folder import Sweep
from quadruped_env.sweep.report import write_report
from quadruped_env.sweep.search import setting_values
from quadruped_env.sweep.space import in_words
from quadruped_env.task import TaskDefinition
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_FILE
from quadruped_env.utils.documents import read_json

Say = Callable[[str], None]
_TRAINING_SHARE: Final = 0.9
"""Maximum share of a trial that is done before it is scored."""
_ROUNDING: Final = 0.1
"""Rounding of the time on a policy's card, s."""


def work(sweep: Sweep, trusted: bool, say: Say) -> None:
    """Do trials of a sweep until none is open.

    Args:
        sweep: the sweep.
        trusted: True to execute the sweep's copy of the user's task file.
        say: prints a line.

    Raises:
        QuadrupedError, OSError, MemoryError, ImportError: if this worker cannot go on; its trial stays open.
        KeyboardInterrupt: after a signal; its trial stays open, with a checkpoint.
    """
    sweep.join()
    definition = sweep.definition(trusted)
    with contextlib.closing(sweep.take_trials()) as numbers:
        for number in numbers:
            values = setting_values(sweep, sweep.setting(number))
            result = _attempt(sweep, number, values, definition, say)
            sweep.finish(number, result)
            say(result_in_words(number, result))
    with contextlib.suppress(MissingExtraError):
        write_report(sweep)


def result_in_words(number: int, result: Mapping[str, Any]) -> str:
    """Return a trial and its result in a line."""
    name = f"trial {number}{', ' * bool(result['values'])}{in_words(result['values'])}"
    if result["state"] == "failed":
        return f"{name}: failed: {result['error']}"
    score = f"no score ({result['error']})" if result["score"] is None else f"score {result['score']['total']:.3f}"
    starts = f" and {result['starts']} starts" if result["starts"] > 1 else ""
    return f"{name}: finished after {result['seconds']:.0f} s{starts}, {score}"


def _attempt(
    sweep: Sweep, number: int, values: Mapping[str, Any], definition: TaskDefinition, say: Say
) -> dict[str, Any]:
    """Do a trial, and return its result. Only errors of the training are a result; all others are raised."""
    directory, seed = sweep.trial(number), sweep.seed(number)
    task_file = None if sweep.task_file is None else sweep.path / KEPT_FILE
    began, before, config = time.monotonic(), 0.0, None
    directory.mkdir(parents=True, exist_ok=True)
    try:
        config = sweep.config(values, seed, definition)
        parent = _checkpoint(directory, definition)
        before = 0.0 if parent is None else parent.seconds
        if parent is not None:
            say(f"trial {number}: goes on from its checkpoint at {parent.timesteps:,} steps")
        run = _train(config, directory, f"mini-quadruped sweep: trial {number}", parent, task_file)
        timesteps = read_json(run / CARD_FILE)["card"]["timesteps"]
        result = {"state": "finished", "run": str(run.relative_to(sweep.path)), "timesteps": timesteps}
        result |= score_of_run(run, task_file)
    except Exception as error:  # every library fails in its own way, and a sweep goes on without the trial
        _raise_if_of_the_machine(error)
        message = str(error) if isinstance(error, QuadrupedError) else f"{type(error).__name__}: {error}"
        base = sweep.config({}, seed, definition)
        score = score_of_zero_action(config, base, task_file)
        result = {"state": "failed", "error": message[:500], "traceback": traceback.format_exc(), "score": score}
    seconds = round(before + time.monotonic() - began, 1)
    facts = {"starts": len(runs_of(directory)), "seconds": seconds, "node": socket.gethostname()}
    return {"values": dict(values), **result, **facts}


def runs_of(directory: Path) -> list[Path]:
    """Return the run directories of a trial, in no order: their times are from the clocks of several machines."""
    found = (path.parent for path in directory.glob(f"*/{CONFIG_FILE}"))
    return [path for path in found if not path.is_symlink()]


def share_done(directory: Path) -> float:
    """Return the share of its budget that an open trial has used, in [0, 1]."""
    used, budget = 0.0, 1.0
    for run in runs_of(directory):
        training = read_json(run / CONFIG_FILE)["training"]
        name = "timesteps" if training["seconds"] is None else "seconds"
        # A resumed run counts its steps on, and its budget is what was left.
        used = max([used, *read_progress(run / PROGRESS_FILE)[name]])
        budget = max(budget, training[name])
    return min(_TRAINING_SHARE, used / budget)


def _checkpoint(directory: Path, definition: TaskDefinition) -> Parent | None:
    """Return the run or checkpoint of a trial that has learned from most steps; None if there is none."""
    found = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", QuadrupedWarning)  # a checkpoint is used
        for run in runs_of(directory):
            with contextlib.suppress(QuadrupedError):
                found.append(Parent.load(run, definition))
    return max(found, key=lambda parent: parent.timesteps, default=None)


def _train(config: TrainConfig, directory: Path, command: str, parent: Parent | None, task_file: Path | None) -> Path:
    """Train to the end of the budget, from a checkpoint if there is one, and return the run directory.

    Raises:
        KeyboardInterrupt: after a signal; what was learned is saved.
    """
    from quadruped_env.training.train import train

    if parent is not None:
        budget = "timesteps" if config.seconds is None else "seconds"
        left = getattr(config, budget) - getattr(parent, budget)
        if left < _ROUNDING:
            return parent.directory
        config = parent.resumed({budget: left})
    run, whole = train(config, directory, command, parent, task_file, threads=1)
    if not whole:
        raise KeyboardInterrupt(signal.Signals[read_json(run / CARD_FILE)["card"]["interrupted"]])
    return run


def score_of_run(run: Path, task_file: Path | None) -> dict[str, Any]:
    """Score a policy in the quick suite, and write the results into the run's `evaluation/`.

    Returns:
        `score`, with `total` and `components`; or None, and the reason as `error`, if the suite cannot run the policy.
    """
    try:
        evaluated = find_policy(str(run), None, task_file)
        found = run_suite(Candidate.of_policy(evaluated.policy, evaluated.name), quick_suite())
        write_results(evaluated, found, "mini-quadruped sweep")
    except QuadrupedError as error:
        _raise_if_of_the_machine(error)
        return {"score": None, "error": str(error)}
    return {"score": found["score"]}


def score_of_zero_action(config: TrainConfig | None, base: TrainConfig, task_file: Path | None) -> Any:
    """Return the score of the zero action in a failed training's task, or in the sweep's if that is not possible."""
    for candidate in filter(None, (config, base)):
        with contextlib.suppress(QuadrupedError):
            task = task_config(candidate.action_mode, candidate.task, task_file)
            zero = Candidate("zero action", ZeroController(candidate.action_mode), task)
            return run_suite(zero, quick_suite())["score"]
    return None


def _raise_if_of_the_machine(error: BaseException) -> None:
    """Raise an error, or its cause, if that is a disk, the memory or the installation, and not what was trained."""
    cause: BaseException | None = error
    while cause is not None:
        # Torch's error of a failed allocation has no type of its own.
        if isinstance(cause, RuntimeError) and "allocate" in str(cause):
            raise MemoryError(str(cause).splitlines()[0]) from error
        if isinstance(cause, OSError | MemoryError | ImportError):
            # Other packages wrap it in types that the program does not expect.
            raise error if isinstance(error, QuadrupedError) else cause
        cause = cause.__cause__ or (None if cause.__suppress_context__ else cause.__context__)
