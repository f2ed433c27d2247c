"""One trial: the training of `mini-quadruped train`, unchanged, in a process of Ray, and its score."""

import resource
import socket
import sys
import time
import traceback
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import PARTS, run_suite
from quadruped_env.evaluation.suite.suite_definition import for_robot, full_suite, quick_suite
from quadruped_env.policies import Policy, load_policy
from quadruped_env.report.pages.suite_section import write_results
from quadruped_env.sweep.sweep_definition import SweepConfig, known, sha256_of
from quadruped_env.sweep.sweep_records import SWEEP_FILE, SweepFolder, TrialFolder
from quadruped_env.training import TrainConfig

Report = Callable[[dict[str, Any]], None]
"""Called with intermediate results; it returns when the training may go on."""
SCORE: Final = "score"
RUNG: Final = "rung"


def run_in_ray(settings: dict[str, Any]) -> None:
    """Run a trial as a trainable of Ray Tune.

    Args:
        settings: `sweep`, the sweep's directory; `identity`, the sweep's; and `number`, the trial's.
    """
    from ray import tune

    run(Path(settings["sweep"]), settings["identity"], settings["number"], tune.report)


def run(sweep: Path, identity: str, number: int, report: Report) -> dict[str, Any]:
    """Train a trial and write its result, unless it has one.

    A trial that was interrupted begins again, so that its policy has the bits of an uninterrupted training.

    Args:
        sweep: the sweep's directory, which all nodes share.
        identity: of the sweep.
        number: of the trial.
        report: see `Report`; its last call has the final score.

    Raises:
        QuadrupedError: if this machine does not see the sweep's files.
    """
    if not (sweep / SWEEP_FILE).is_file():
        raise QuadrupedError(
            f"{sweep}: {socket.gethostname()} does not see this directory; put sweeps into a directory that all nodes "
            f"share under the same name, with --output"
        )
    folder = SweepFolder.open(sweep)
    trial = replace(folder.trial(number), sweep=identity)
    result = trial.result()
    if result is None:
        result = trial.finish(_attempt(folder, trial, report))
    final, score = folder.config.reduction**folder.config.rungs, result.get("score")
    # Without a score, less than any.
    report({RUNG: final, SCORE: -1.0 if score is None else score["total"], "state": result["state"], "number": number})
    return result


def _attempt(folder: SweepFolder, trial: TrialFolder, report: Report) -> dict[str, Any]:
    """Train and score; errors of the training are the trial's result."""
    began = time.time()
    try:
        outcome = _train(folder, trial, report)
    except Exception as error:  # every library fails in its own way, and a sweep goes on without the trial
        trial.write_error(traceback.format_exc())
        outcome = {"state": "failed", "error": f"{type(error).__name__}: {error}"[:500]}
    facts = {"node": socket.gethostname(), "began": round(began, 3), "ended": round(time.time(), 3)}
    # The largest resident memory of this process, MB.
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (1e6 if sys.platform == "darwin" else 1e3)
    return {**facts, **outcome, "peak_memory_mb": round(peak, 1)}


def _train(folder: SweepFolder, trial: TrialFolder, report: Report) -> dict[str, Any]:
    from quadruped_env.training.train import train

    config, settings = folder.config, trial.settings()
    if settings is None:
        raise QuadrupedError(f"{trial.path}: has no settings; resume the sweep to write them")
    task_file = _task_file(config)
    fields = known(settings["training"])
    if "hidden" in fields:
        fields["hidden"] = tuple(fields["hidden"])
    training = TrainConfig(**fields)
    observer = RungObserver(trial, config, training.timesteps, report) if config.milestones() else None
    command = f"mini-quadruped sweep: trial {settings['number']} of {folder.path.name}"
    began = time.perf_counter()
    threads = config.cores_per_trial
    directory, whole = train(training, trial.path, command, task_file=task_file, observer=observer, threads=threads)
    trained = time.perf_counter() - began - (0.0 if observer is None else observer.seconds)
    if not whole:
        raise KeyboardInterrupt  # no result: the trial is trained again when the sweep is resumed
    began = time.perf_counter()
    score = final_score(directory, config.score, command, task_file)
    return {
        "state": "finished",
        "run": directory.name,
        "timesteps": load_policy(directory, task_file).card["timesteps"],
        "training_seconds": round(trained, 3),
        "scoring_seconds": round(time.perf_counter() - began + (0.0 if observer is None else observer.seconds), 3),
        "score": score,
    }


def _task_file(config: SweepConfig) -> Path | None:
    if config.task_file is None:
        return None
    path = Path(config.task_file)
    if sha256_of(path) != config.task_sha256:
        raise QuadrupedError(
            f"--task: {path} has changed since the sweep began; restore it, or start a new sweep with the changed file"
        )
    return path


class RungObserver:
    """Scores the policy at each rung of ASHA, and waits for the decision to go on.

    Args:
        trial: its folder.
        config: the sweep.
        timesteps: budget of the training.
        report: see `Report`.
    """

    def __init__(self, trial: TrialFolder, config: SweepConfig, timesteps: int, report: Report) -> None:
        self._trial, self._report = trial, report
        unit = timesteps / config.reduction**config.rungs
        self._left = [(rung, rung * unit) for rung in config.milestones()]
        self._rows: list[dict[str, Any]] = []
        self._began = time.perf_counter()
        self.seconds = 0.0
        """Time of the scores, s."""

    def __call__(self, timesteps: int, policy: Callable[[], Any]) -> None:
        """See `quadruped_env.training.train.Observer`."""
        if not self._left or timesteps < self._left[0][1]:
            return
        began = time.perf_counter()
        # A long rollout may pass several rungs: the policy is scored once, at the last of them.
        while self._left and timesteps >= self._left[0][1]:
            rung, _ = self._left.pop(0)
        score = rung_score(policy())
        seconds = began - self._began - self.seconds
        self._rows.append({"rung": rung, "timesteps": timesteps, "seconds": round(seconds, 3), "score": score})
        self._trial.write_scores(self._rows)
        self._report({RUNG: rung, SCORE: score, "timesteps": timesteps})
        self.seconds += time.perf_counter() - began


def rung_score(policy: Policy) -> float:
    """Score in [0, 1] of a policy during its training: mean of four parts of the quick suite, on level ground."""
    candidate = Candidate.of_policy(policy, "trial")
    suite = for_robot(quick_suite(), candidate.robot)
    scores = []
    for name in ("commands", "gait", "transients", "pushes"):
        (run, score), part = PARTS[name], getattr(suite, name)
        scores.append(score(run(part, candidate, None), part))
    return sum(scores) / len(scores)


def final_score(run: Path, measure: str, command: str, task_file: Path | None = None) -> Mapping[str, Any] | None:
    """Score of a complete run: `total` and `components`; its whole results are in `<run>/evaluation/suite.json`.

    Args:
        run: run directory.
        measure: `quick` or `suite`; `none` gives None.
        command: command line for the record.
        task_file: the user's file of terms.

    Raises:
        QuadrupedError: if the suite cannot run the policy, or the results cannot be written.
    """
    if measure == "none":
        return None
    evaluated = find_policy(str(run), None, task_file)
    result = run_suite(
        Candidate.of_policy(evaluated.policy, evaluated.name),
        quick_suite() if measure == "quick" else full_suite(),
    )
    write_results(evaluated, result, command)
    score: Mapping[str, Any] = result["score"]
    return score
