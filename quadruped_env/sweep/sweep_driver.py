"""The process that runs a sweep: Ray Tune starts, stops and repeats the trials; their files say what has been done."""

import logging
import os
import shutil
import time
from collections.abc import Callable, Mapping
from dataclasses import asdict
from datetime import timedelta
from types import SimpleNamespace
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.sweep.ray_connection import connected
from quadruped_env.sweep.search import Proposals
from quadruped_env.sweep.search_space import of_json, shown
from quadruped_env.sweep.sweep_definition import MakeConfig, known
from quadruped_env.sweep.sweep_records import TUNE_FOLDER, SweepFolder
from quadruped_env.sweep.sweep_results import score_of_setting
from quadruped_env.sweep.trial import RUNG, SCORE, run_in_ray
from quadruped_env.utils.plain import plain

MAX_LOSSES: Final = 10
"""Number of times that a trial may lose its process or its node before it counts as failed."""
Say = Callable[[str], None]


def run_sweep(folder: SweepFolder, make: MakeConfig, address: str | None, cores: int, say: Say = print) -> bool:
    """Run the trials of a sweep that have no result.

    Args:
        folder: the sweep.
        make: makes the settings of a training from fields of `TrainConfig`.
        address: `host:port` of a running Ray cluster that answers; None starts Ray on this machine.
        cores: cores of this machine to use without an address.
        say: prints a line.

    Returns:
        True if every trial has a result; False if the sweep was interrupted.

    Raises:
        MissingExtraError: if Ray is not installed, or Optuna where it is needed.
        QuadrupedError: if Ray does not start, the cluster is too small or ends, or a file is damaged or cannot be
            written.
    """
    with folder.locked():
        book = TrialBook(folder, make, Proposals(folder.config), say)
        if not book.missing():
            return True
        with connected(address, cores) as ray:
            from ray import tune

            # Lost trials are reported in a line, without the traceback of Ray Tune.
            logging.getLogger("ray.tune").setLevel(logging.CRITICAL)
            tune_folder = folder.path / TUNE_FOLDER
            shutil.rmtree(tune_folder, ignore_errors=True)
            try:
                _fit(folder, book, ray, tune, address)
            except (ray.exceptions.RayError, tune.TuneError, ConnectionError) as error:
                reason = (str(error).strip().splitlines() or [type(error).__name__])[-1]
                raise QuadrupedError(
                    f"{folder.path}: Ray ended in mid-sweep ({reason[:200]}); what is finished is kept: go on with "
                    f"--resume {folder.path}"
                ) from error
            finally:
                shutil.rmtree(tune_folder, ignore_errors=True)
        return not book.missing()


def _fit(folder: SweepFolder, book: "TrialBook", ray: Any, tune: Any, address: str | None) -> None:
    config = folder.config
    stopped: set[str] = set()
    cores = [node["Resources"].get("CPU", 0.0) for node in ray.nodes() if node["Alive"]]
    if max(cores, default=0.0) < config.cores_per_trial:
        # Ray would wait for a larger node without end.
        where = "this machine" if address is None else f"the largest node of the cluster at {address}"
        raise QuadrupedError(
            f"--cores-per-trial: found {config.cores_per_trial}; {where} has {max(cores, default=0.0):g}; lower it, or "
            f"add a node"
        )
    book.say(
        f"Ray {ray.__version__}: {sum(cores):g} cores, {config.cores_per_trial} per trial; {len(book.missing())} of "
        f"{len(config)} trials to run"
    )
    # One proposal ahead, so that Optuna's know the results before them.
    os.environ["TUNE_MAX_PENDING_TRIALS_PG"] = "1"
    resources = tune.PlacementGroupFactory([{"CPU": config.cores_per_trial}])
    tuner = tune.Tuner(
        tune.with_resources(run_in_ray, resources),
        tune_config=tune.TuneConfig(
            search_alg=_searcher(tune, book),
            scheduler=_asha(tune, book, stopped) if config.scheduler == "asha" else None,
            num_samples=len(book.missing()),
        ),
        run_config=tune.RunConfig(
            name="trials",
            storage_path=str((folder.path / TUNE_FOLDER).resolve()),
            failure_config=tune.FailureConfig(max_failures=MAX_LOSSES),
            callbacks=[_watcher(tune, book, stopped)],
            verbose=0,
        ),
    )
    tuner.fit()


def _searcher(tune: Any, book: "TrialBook") -> Any:
    """The trials without a result, as a searcher of Ray Tune."""

    class TrialSearcher(tune.search.Searcher):
        def suggest(self, trial_id: str) -> Any:
            number = book.begin()
            if number is None:
                return tune.search.Searcher.FINISHED
            return {"sweep": str(book.folder.path.resolve()), "identity": book.folder.identity, "number": number}

        def on_trial_complete(self, trial_id: str, result: Any = None, error: bool = False) -> None:
            pass  # the book reads the trial's own file

        def save_to_dir(self, checkpoint_dir: str, session_str: str = "default") -> None:
            pass  # nothing goes on from Ray Tune's files

    return TrialSearcher(metric=SCORE, mode="max")


def _asha(tune: Any, book: "TrialBook", stopped: set[str]) -> Any:
    """ASHA with the rungs that earlier processes have filled.

    Li et al. 2020, A System for Massively Parallel Hyperparameter Tuning, https://arxiv.org/abs/1810.05934.
    """

    class Asha(tune.schedulers.ASHAScheduler):
        def on_trial_result(self, tune_controller: Any, trial: Any, result: Any) -> str:
            decision: str = super().on_trial_result(tune_controller, trial, result)
            if decision == self.STOP:
                stopped.add(trial.trial_id)
            return decision

    config = book.folder.config
    scheduler = Asha(
        time_attr=RUNG,
        metric=SCORE,
        mode="max",
        max_t=config.reduction**config.rungs,
        grace_period=1,
        reduction_factor=config.reduction,
    )
    for number, _, _ in config.trials():
        trial = book.folder.trial(number)
        if trial.result() is None:
            continue
        earlier = SimpleNamespace(trial_id=f"earlier-{number}")
        scheduler.on_trial_add(None, earlier)
        for row in trial.scores():
            scheduler.on_trial_result(None, earlier, {RUNG: int(row["rung"]), SCORE: row["score"]})
    stopped.clear()
    return scheduler


def _watcher(tune: Any, book: "TrialBook", stopped: set[str]) -> Any:
    """A callback of Ray Tune that keeps the book."""

    class Watcher(tune.Callback):
        def on_trial_start(self, iteration: int, trials: Any, trial: Any, **info: Any) -> None:
            book.say(f"{book.name(trial.config['number'])}: training")

        def on_trial_result(self, iteration: int, trials: Any, trial: Any, result: Any, **info: Any) -> None:
            book.reported(trial.config["number"], result)

        def on_trial_recover(self, iteration: int, trials: Any, trial: Any, **info: Any) -> None:
            number = trial.config["number"]
            if book.folder.trial(number).result() is None:
                book.say(f"{book.name(number)}: its process or node was lost; it begins again")

        def on_trial_complete(self, iteration: int, trials: Any, trial: Any, **info: Any) -> None:
            book.ended(trial.config["number"], stopped=trial.trial_id in stopped)

        def on_trial_error(self, iteration: int, trials: Any, trial: Any, **info: Any) -> None:
            error = str(trial.get_error() or "its process or node was lost").strip().splitlines()
            book.ended(trial.config["number"], error=error[-1][:500])

    return Watcher()


class TrialBook:
    """Settings and results of a sweep's trials, and the lines that a sweep prints about them.

    Args:
        folder: the sweep.
        make: makes the settings of a training.
        source: source of the settings.
        say: prints a line.

    Raises:
        QuadrupedError: if a file cannot be written, or is damaged later; its methods do so, too.
    """

    def __init__(self, folder: SweepFolder, make: MakeConfig, source: Proposals, say: Say) -> None:
        self.folder, self.say = folder, say
        self._make, self._source = make, source
        self._numbers = {number: (setting, seed) for number, setting, seed in folder.config.trials()}
        self._waiting: list[int] = []
        self._values: dict[int, dict[str, Any]] = {}
        self._began = time.monotonic()
        self._done_here = 0
        ignored = set(folder.ignored)
        for number in self._numbers:
            trial = folder.trial(number)
            try:
                trial.check()
            except QuadrupedError as error:
                say(f"trial {number} begins again, and its files are in {folder.put_aside(number)}: {error}")
            settings = trial.settings()
            if settings is not None:
                self._values[settings["setting"]] = {name: of_json(value) for name, value in settings["values"].items()}
                ignored |= settings["training"].keys() - known(settings["training"])
            if trial.result() is None:
                self._waiting.append(number)
        if ignored:
            say(f"note: settings that this version does not have are left out: {', '.join(sorted(ignored))}")
        self._open = set(self._waiting)
        for setting in range(folder.config.settings):
            self._tell_if_complete(setting)

    def missing(self) -> set[int]:
        """Numbers of the trials without a result."""
        return set(self._open)

    def begin(self) -> int | None:
        """Write the settings of the next trial; its number, or None if all have begun."""
        number = next((number for number in self._waiting if number in self._open), None)
        if number is None:
            return None
        self._waiting.remove(number)
        trial = self.folder.trial(number)
        if trial.settings() is None:
            setting, seed = self._numbers[number]
            if setting not in self._values:
                self._values[setting] = self._source.values(setting)
            values = self._values[setting]
            settings = {"number": number, "setting": setting, "seed": seed, "values": plain(values)}
            trial.write_settings({**settings, "training": self._training(values, seed)})
        return number

    def _training(self, values: Mapping[str, Any], seed: int) -> Any:
        config = self.folder.config
        fields = config.fields_of(values, seed)
        try:
            return plain(asdict(self._make(fields)))
        except QuadrupedError:
            # Fields that do not fit together: the trial says so itself, and the sweep goes on.
            return plain({**asdict(self._make(config.fields_of({}, seed))), **fields})

    def reported(self, number: int, result: Mapping[str, Any]) -> None:
        """Print the score at a rung."""
        last = self.folder.config.reduction**self.folder.config.rungs
        if result.get(RUNG, last) < last:
            self.say(
                f"{self.name(number)}: score {result[SCORE]:.3f} after {result['timesteps']:,} steps (rung "
                f"{result[RUNG]}/{last})"
            )

    def ended(self, number: int, stopped: bool = False, error: str | None = None) -> None:
        """Take note of a trial's end.

        Args:
            number: of the trial.
            stopped: True if ASHA stopped it.
            error: Ray's error, if it gave the trial up.
        """
        trial = self.folder.trial(number)
        result = trial.result()
        if result is None and stopped:
            result = trial.finish({"state": "stopped", "score": None})
        elif result is None and error is not None:
            result = trial.finish({"state": "failed", "error": error})
        if result is None or number not in self._open:
            return
        self._open.discard(number)
        self._done_here += 1
        self.say(f"{self.name(number)}: {_outcome(result)}; {self._progress()}")
        self._tell_if_complete(self._numbers[number][0])

    def _tell_if_complete(self, setting: int) -> None:
        seeds = self.folder.config.seeds
        own = range(setting * seeds, (setting + 1) * seeds)
        if setting not in self._values or self._open.intersection(own):
            return
        scores = []
        for number in own:
            trial = self.folder.trial(number)
            result = trial.result() or {}
            if result.get("score") is not None:
                scores.append(float(result["score"]["total"]))
            elif result.get("state") == "stopped" and (rows := trial.scores()):
                scores.append(rows[-1]["score"])
        self._source.tell(setting, self._values[setting], score_of_setting(scores))

    def name(self, number: int) -> str:
        """A trial in words."""
        setting, seed = self._numbers[number]
        values = " ".join(f"{name}={shown(value)}" for name, value in self._values[setting].items())
        return f"trial {number}, seed {seed}{f', {values}' if values else ''}"

    def _progress(self) -> str:
        elapsed, left = time.monotonic() - self._began, len(self._open)
        done = f"{len(self._numbers) - left} of {len(self._numbers)} done, {_clock(elapsed)} elapsed"
        return f"{done}, about {_clock(elapsed / self._done_here * left)} left" if left else done


def _clock(seconds: float) -> str:
    return str(timedelta(seconds=round(seconds)))


def _outcome(result: Mapping[str, Any]) -> str:
    if result["state"] == "failed":
        return f"failed ({result.get('error', 'unknown error')})"
    if result["state"] == "stopped":
        return "stopped by ASHA"
    score = "" if result.get("score") is None else f", score {result['score']['total']:.3f}"
    seconds = sum(result.get(name, 0.0) for name in ("training_seconds", "scoring_seconds"))
    return f"finished after {seconds:.0f} s{score}"
