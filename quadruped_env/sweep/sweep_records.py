"""The files of a sweep: its definition, and a folder per trial with its settings, its run directory and its result.

    sweep.json                definition
    trials/0003/trial.json    settings
    trials/0003/scores.csv    scores during the training, with --scheduler asha
    trials/0003/<time>-ppo/   run directory, as of a training by itself
    trials/0003/result.json   result; a trial that has none is trained again when the sweep is resumed

The files are all that a sweep goes on from: nothing is unpickled.
"""

import contextlib
import csv
import fcntl
import io
import json
import os
import time
import uuid
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, cast

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.evaluation.results import RESULTS_FILE as SUITE_FILE
from quadruped_env.evaluation.results import read_results
from quadruped_env.sweep.sweep_definition import FORMAT_VERSION, SweepConfig, known
from quadruped_env.training import TrainConfig
from quadruped_env.training.run_directory import CONFIG_FILE
from quadruped_env.training.train_config import check_fields
from quadruped_env.utils.documents import check_regular, read_json
from quadruped_env.utils.files import free_path, unwritable, whole, write_json, write_whole
from quadruped_env.utils.parameters import is_quantity
from quadruped_env.utils.provenance import git_commit, machine, versions

SWEEP_FILE: Final = "sweep.json"
TRIALS: Final = "trials"
TUNE_FOLDER: Final = ".tune"
"""Directory of Ray Tune's own files; it is removed at the end."""
TRIAL_FILE: Final = "trial.json"
RESULT_FILE: Final = "result.json"
SCORES_FILE: Final = "scores.csv"
ERROR_FILE: Final = "error.txt"
STATES: Final = ("finished", "stopped", "failed")
"""States of a result: the whole budget was used; ASHA stopped the trial; it ended with an error."""
SCORE_COLUMNS: Final = ("rung", "timesteps", "seconds", "score")
_LOCK_FILE: Final = ".lock"
_AMOUNTS: Final = ("timesteps", "training_seconds", "scoring_seconds", "peak_memory_mb")
"""Numbers in a result."""
_AGAIN: Final = "resume the sweep, which puts this trial aside and trains it again"


@dataclass(frozen=True)
class SweepFolder:
    """The directory of a sweep. Damaged files, and those that cannot be written, are a `QuadrupedError`."""

    path: Path
    identity: str
    """Random name of the sweep, which each of its trials has."""
    config: SweepConfig
    ignored: tuple[str, ...] = ()
    """Fields of its trainings that this version of the package does not have."""

    @classmethod
    def create(cls, parent: Path, name: str, config: SweepConfig, command: str) -> "SweepFolder":
        """Make `<parent>/<time>-<name>/` with its definition."""
        path = free_path(parent / f"{time.strftime('%Y%m%d-%H%M%S')}-{name}")
        try:
            (path / TRIALS).mkdir(parents=True)
        except OSError as error:
            raise QuadrupedError(f"--output: cannot create {path} ({error.strerror}); name another place") from error
        identity = uuid.uuid4().hex
        document = {
            "format_version": FORMAT_VERSION,
            "sweep": identity,
            **config.to_dict(),
            "command": command,
            "git_commit": git_commit(),
            "versions": versions(),
            "machine": machine(),
        }
        write_json(path / SWEEP_FILE, document)
        return cls(path, identity, config)

    @classmethod
    def open(cls, path: Path) -> "SweepFolder":
        """The sweep in a directory."""
        file = path / SWEEP_FILE
        if not os.path.isfile(file):  # Path.is_file raises for a name that is too long
            what = "there is no such directory"
            if os.path.isfile(path / CONFIG_FILE):
                what = "this is the run directory of one training: continue it with 'train --resume'"
            elif os.path.isdir(path):
                what = f"it has no {SWEEP_FILE}, so no sweep is in it"
            raise QuadrupedError(f"--resume: {path}: {what}; name the directory that 'sweep' printed")
        document = read_json(file, "start a new sweep")
        if not isinstance(document, dict) or not isinstance(document.get("sweep"), str):
            raise QuadrupedError(f"{file}: not the definition of a sweep; start a new one")
        if document.get("format_version") != FORMAT_VERSION:
            raise QuadrupedError(
                f"{file}: format_version: expected {FORMAT_VERSION}; found {short(document.get('format_version'))}; "
                f"resume it with the version of this package that wrote it"
            )
        names = SweepConfig.__dataclass_fields__
        values = {name: document[name] for name in names if name in document}
        config = SweepConfig.from_dict(values, str(file))
        training = document["training"]
        return cls(path, document["sweep"], config, tuple(sorted(training.keys() - known(training))))

    def trial(self, number: int) -> "TrialFolder":
        """The folder of a trial."""
        return TrialFolder(self.path / TRIALS / f"{number:04d}", self.identity, number, self.config)

    def put_aside(self, number: int) -> Path:
        """Give the folder of a damaged trial another name, so that the trial begins again; the new path."""
        path = self.trial(number).path
        aside = free_path(path.with_name(f"{path.name}.damaged"))
        try:
            return path.rename(aside)
        except OSError as error:
            raise unwritable(aside, error) from error

    @contextlib.contextmanager
    def locked(self) -> Iterator[None]:
        """Within it, no other process runs this sweep; the lock ends with the process."""
        path = self.path / _LOCK_FILE
        try:
            file = path.open("a", encoding="utf-8")
        except OSError as error:
            raise unwritable(path, error) from error
        with file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                raise QuadrupedError(
                    f"--resume: another process runs the sweep in {self.path}; wait for its end, or stop it"
                ) from error
            yield


@dataclass(frozen=True)
class TrialFolder:
    """The directory of a trial; all of its files appear when they are whole. Errors as of `SweepFolder`."""

    path: Path
    sweep: str
    """Identity of the sweep."""
    number: int
    config: SweepConfig

    def write_settings(self, settings: Mapping[str, Any]) -> None:
        """Write trial.json."""
        write_json(self.path / TRIAL_FILE, {"sweep": self.sweep, **settings})

    def settings(self) -> dict[str, Any] | None:
        """Content of trial.json; None if the trial has not begun."""
        seeds, first = self.config.seeds, self.config.training.get("seed", TrainConfig.seed)
        place = {"number": self.number, "setting": self.number // seeds, "seed": first + self.number % seeds}
        space = {dimension.field: dimension for dimension in self.config.space}

        def sound(found: dict[str, Any]) -> bool:
            check_fields(known(found["training"]))
            return (
                {name: found[name] for name in place} == place
                and found["values"].keys() == space.keys()
                and all(space[name].holds(value) for name, value in found["values"].items())
            )

        return self._read(TRIAL_FILE, sound)

    def result(self) -> dict[str, Any] | None:
        """Content of result.json; None if the trial has not ended."""

        def sound(found: dict[str, Any]) -> bool:
            score, run = found.get("score"), found.get("run", "run")
            numbers = [] if score is None else [score["total"], *score["components"].values()]
            numbers += [found[name] for name in _AMOUNTS if name in found]
            return (
                found["state"] in STATES
                and all(is_quantity(number, 0.0, 1e15) for number in numbers)
                and (run == Path(run).name and run not in ("", ".."))
                and all(isinstance(found.get(name, ""), str) for name in ("node", "error"))
            )

        return self._read(RESULT_FILE, sound)

    def check(self) -> None:
        """Check all that a sweep goes on from, also the results of the suite."""
        # Through a link, the training would write elsewhere.
        if self.path.is_symlink() or (os.path.lexists(self.path) and not self.path.is_dir()):
            raise QuadrupedError(f"{self.path}: is {'a link' if self.path.is_symlink() else 'no directory'}; {_AGAIN}")
        settings, result = self.settings(), self.result()
        self.scores()
        if result is None:
            return
        if settings is None:
            raise QuadrupedError(f"{self.path / TRIAL_FILE}: missing next to a result; {_AGAIN}")
        if result.get("score") is not None and result.get("run") is not None:
            read_results(self.path / result["run"] / "evaluation" / SUITE_FILE)

    def _read(self, name: str, sound: Callable[[dict[str, Any]], bool]) -> dict[str, Any] | None:
        """Content of a file of this trial, for which a function is true."""
        path = self.path / name
        if not os.path.lexists(path):
            return None
        document = read_json(path, _AGAIN)
        try:
            if document["sweep"] != self.sweep:
                raise QuadrupedError(
                    f"{path}: this is a trial of another sweep ({short(document['sweep'])} in place of "
                    f"{short(self.sweep)}); {_AGAIN}"
                )
            valid = sound(document)
        except (KeyError, TypeError, AttributeError):
            valid = False
        if not valid:
            raise QuadrupedError(f"{path}: a field is missing or not valid; {_AGAIN}")
        return cast(dict[str, Any], document)

    def finish(self, result: Mapping[str, Any]) -> dict[str, Any]:
        """Write result.json if there is none; the result that stands.

        Two processes may train a trial if a node was cut off from the cluster: the first result counts.
        """
        path = self.path / RESULT_FILE
        content = json.dumps({"sweep": self.sweep, **result}, indent=2, allow_nan=False) + "\n"
        part = path.with_name(f".{RESULT_FILE}.{uuid.uuid4().hex}")
        write_whole({part: content.encode()})
        try:
            with contextlib.suppress(FileExistsError):
                os.link(part, path)
        except OSError as error:
            raise unwritable(path, error) from error
        finally:
            part.unlink()
        found = self.result()
        assert found is not None
        return found

    def write_scores(self, rows: list[dict[str, Any]]) -> None:
        """Write scores.csv."""
        text = io.StringIO()
        writer = csv.DictWriter(text, SCORE_COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
        write_whole({self.path / SCORES_FILE: text.getvalue().encode()})

    def scores(self) -> list[dict[str, float]]:
        """Rows of scores.csv; none if the file does not exist."""
        path = self.path / SCORES_FILE
        if not os.path.lexists(path):
            return []
        check_regular(path, _AGAIN)
        try:
            with path.open(newline="", encoding="utf-8") as file:
                rows = [{name: float(row[name]) for name in SCORE_COLUMNS} for row in csv.DictReader(file)]
        except (OSError, ValueError, KeyError, TypeError, csv.Error) as error:
            raise QuadrupedError(f"{path}: damaged ({short(str(error))}); {_AGAIN}") from error
        if not all(is_quantity(value, -1e15, 1e15) for row in rows for value in row.values()):
            raise QuadrupedError(f"{path}: a value is not finite; {_AGAIN}")
        return rows

    def write_error(self, text: str) -> None:
        """Write the traceback of a failed trial."""
        with whole(self.path / ERROR_FILE) as part:
            part.write_text(text, encoding="utf-8")
