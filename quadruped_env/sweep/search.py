"""The space of a sweep, and the choice of its settings by Optuna, in a study that the workers share.

A field of the training is named as in `TrainConfig`, a field of the task's config by `task.` and its path, as in
`task.reward.weights.foot_slip`. Choices, which may be lists, are Optuna's as JSON. The sampler is its tree-structured
Parzen estimator: Bergstra et al. 2011, https://papers.nips.cc/paper/4443-algorithms-for-hyper-parameter-optimization.
"""

import contextlib
import json
import math
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, did_you_mean, short
from quadruped_env.task.task_config import flat
from quadruped_env.training import TrainConfig

if TYPE_CHECKING:
    from quadruped_env.sweep.folder import Sweep

FIXED: Final = ("seed", "name", "checkpoint_seconds", "seconds", "task")
"""Fields of `TrainConfig` that do not vary."""
TASK: Final = "task."
"""Beginning of the names of the task's fields."""
STORAGE: Final = "OPTUNA_STORAGE"
"""Environment variable of Optuna's: address of a database for studies, perhaps with a password, so in no file."""
JOURNAL: Final = "optuna.log"
"""The study, if it is in no database; `optuna-dashboard` shows it."""
_SETTING: Final = "setting"
"""Attribute of a trial of Optuna: number of the sweep's setting."""


def optuna_module() -> Any:
    """Optuna, without its messages about each trial."""
    try:
        import optuna
    except ImportError as error:
        raise MissingExtraError("A search over settings", "sweep") from error
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    return optuna


def parse_dimension(text: str, task: Mapping[str, Any]) -> tuple[str, Any]:
    """Field and distribution from the text of `--vary`: a range, or two or more choices.

    Args:
        text: `FIELD=LOW..HIGH`, `FIELD=LOW..HIGH:log` or `FIELD=CHOICE,CHOICE`.
        task: the task's whole config, whose fields can vary.

    Raises:
        QuadrupedError: naming the field, the value and the fix.
    """
    name, _, values = (part.strip() for part in text.partition("="))
    known = {field: entry.default for field, entry in TrainConfig.__dataclass_fields__.items() if field not in FIXED}
    known |= flat(task, TASK)
    if name not in known:
        hint = did_you_mean(name, known) or "; fields of the task begin with 'task.', seeds are set with --seeds"
        raise QuadrupedError(f"vary {short(name)}: not a field that can vary{hint}")
    try:
        return name, _distribution(values, known[name])
    except ValueError as error:  # also of Optuna
        raise QuadrupedError(
            f"vary {name}: expected LOW..HIGH, LOW..HIGH:log, or two or more choices with commas between them; found "
            f"{short(values)} ({error}); a single value is set with its option of 'train'"
        ) from error


def _distribution(values: str, default: Any) -> Any:
    """Distribution of a field with a default; a ValueError says what is wrong with the values."""
    distributions = optuna_module().distributions
    if ".." in values:
        ends, colon, scale = values.partition(":")
        low, high = map(float, ends.split(".."))
        if not low < high < math.inf or (colon and scale != "log"):
            raise ValueError("the lower end comes first")
        if type(default) is not int:
            return distributions.FloatDistribution(low, high, log=bool(colon))
        if not (low.is_integer() and high.is_integer()):
            raise ValueError("whole numbers are needed")
        return distributions.IntDistribution(int(low), int(high), log=bool(colon))
    choices: list[Any] = [part.strip() for part in values.split(",")]
    if not isinstance(default, str):
        with contextlib.suppress(ValueError):
            choices = json.loads(f"[{values}]")
    if isinstance(default, tuple) and isinstance(choices[0], str):  # widths of layers
        choices = [[int(width) for width in part.split("x")] for part in choices]
    listed = [json.dumps(choice) for choice in choices]
    if len(set(listed)) < max(2, len(listed)):
        raise ValueError("different choices are needed")
    return distributions.CategoricalDistribution(listed)


def size(distribution: Any) -> float:
    """Number of values; infinite for a range of real numbers."""
    if hasattr(distribution, "choices"):
        return len(distribution.choices)
    return distribution.high - distribution.low + 1 if isinstance(distribution.low, int) else math.inf


def ends(distribution: Any) -> list[Any]:
    """The choices, or both ends of the range."""
    if hasattr(distribution, "choices"):
        return [json.loads(choice) for choice in distribution.choices]
    return [distribution.low, distribution.high]


def shown(value: Any) -> str:
    """A value in words and tables: widths of layers as 64x64, other values as JSON."""
    if isinstance(value, list) and value and all(isinstance(entry, int) for entry in value):
        return "x".join(map(str, value))
    if isinstance(value, float):
        return f"{value:.4g}"
    return value if isinstance(value, str) else json.dumps(value)


def in_words(values: Mapping[str, Any]) -> str:
    """Values of a setting in messages; empty for seeds of one config."""
    return ", ".join(f"{name}={shown(value)}" for name, value in values.items())


def setting_values(sweep: "Sweep", setting: int) -> dict[str, Any]:
    """Field -> value of a setting: Optuna's proposal, which the setting keeps, and which no other one has.

    Before it asks, it tells the study the scores of all settings that are complete.

    Raises:
        QuadrupedError: if the study cannot be read or written.
        MissingExtraError: if Optuna is not installed.
    """
    if not sweep.space:
        return {}
    from quadruped_env.sweep.report import score_of

    optuna = optuna_module()
    states = optuna.trial.TrialState
    with sweep.locked("search"):
        try:
            study = _study(sweep, setting)
            known = {}
            for trial in study.get_trials(deepcopy=False, states=(states.RUNNING, states.COMPLETE)):
                number = trial.user_attrs.get(_SETTING)
                if number is None:  # of a worker that was lost in between
                    study.tell(trial.number, state=states.FAIL)
                    continue
                known[number] = _values(trial)
                score = score_of([sweep.result(number * sweep.seeds + seed) for seed in range(sweep.seeds)]).mean
                if trial.state == states.RUNNING and math.isfinite(score):
                    study.tell(trial.number, score)
            random = optuna.samplers.RandomSampler(seed=setting)
            while setting not in known:
                trial = study.ask(dict(sweep.space))
                values = _values(trial)
                if values in known.values():
                    study.tell(trial, state=states.FAIL)
                    study.sampler = random
                else:
                    trial.set_user_attr(_SETTING, setting)
                    known[setting] = values
        except Exception as error:  # of any database's client
            place = f"the database of {STORAGE}" if sweep.in_database else str(sweep.path / JOURNAL)
            raise QuadrupedError(f"{place}: cannot be used ({type(error).__name__}: {error})") from error
    return known[setting]


def _study(sweep: "Sweep", setting: int) -> Any:
    optuna = optuna_module()
    if sweep.in_database:
        storage = os.environ[STORAGE]
    else:
        journal = sweep.path / JOURNAL
        # Only the holder of the sweep's own lock writes. A lost one leaves Optuna's lock, and part of a line.
        journal.with_name(f"{JOURNAL}.lock").unlink(missing_ok=True)
        if journal.is_file():
            os.truncate(journal, journal.read_bytes().rfind(b"\n") + 1)
        storage = optuna.storages.JournalStorage(optuna.storages.journal.JournalFileBackend(str(journal)))
    # A seed for each setting, whichever process asks: with one seed for all, each new process repeats its proposals.
    sampler = optuna.samplers.TPESampler(seed=sweep.first_seed + 1000 * setting, constant_liar=True)
    return optuna.create_study(
        study_name=sweep.study, storage=storage, sampler=sampler, direction="maximize", load_if_exists=True
    )


def _values(trial: Any) -> dict[str, Any]:
    """Field -> value, of one of Optuna's trials."""
    return {
        name: json.loads(trial.params[name]) if hasattr(found, "choices") else trial.params[name]
        for name, found in trial.distributions.items()
    }
