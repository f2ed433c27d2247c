"""Choice of a sweep's settings by Optuna, in a study that the workers share.

The sampler is its tree-structured Parzen estimator: Bergstra et al. 2011,
https://papers.nips.cc/paper/4443-algorithms-for-hyper-parameter-optimization.
"""

import json
import os
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.sweep.folder import STORAGE, Sweep
from quadruped_env.sweep.report import score_of
from quadruped_env.sweep.space import optuna_module

JOURNAL: Final = "optuna.log"
"""File of the study, if it is in no database; `optuna-dashboard` shows it."""
_SETTING: Final = "setting"
"""Attribute of a trial of Optuna: number of the sweep's setting."""


def setting_values(sweep: Sweep, setting: int) -> dict[str, Any]:
    """Return field -> value of a setting: a proposal of Optuna's, which the setting keeps and no other setting has.

    The study is first told the scores of all settings that are complete.

    Raises:
        QuadrupedError: if the study cannot be read or written.
        MissingExtraError: if Optuna is not installed.
    """
    if not sweep.space:
        return {}
    optuna = optuna_module()
    states = optuna.trial.TrialState
    with sweep.locked("search"):
        try:
            study = _study(sweep, setting)
            known = {}
            for trial in study.get_trials(deepcopy=False, states=(states.RUNNING, states.COMPLETE)):
                number = trial.user_attrs.get(_SETTING)
                if number is None:  # asked for by a worker that was lost before it noted the setting
                    study.tell(trial.number, state=states.FAIL)
                    continue
                known[number] = _values(trial)
                mean = score_of([sweep.result(number * sweep.seeds + seed) for seed in range(sweep.seeds)])
                if trial.state == states.RUNNING and mean is not None:
                    study.tell(trial.number, mean["score"]["mean"])
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


def _study(sweep: Sweep, setting: int) -> Any:
    """Return the sweep's study, with a sampler for the proposal of a setting."""
    optuna = optuna_module()
    if sweep.in_database:
        storage = os.environ[STORAGE]
    else:
        journal = sweep.path / JOURNAL
        # Only the holder of the sweep's own lock writes. A worker that was lost may leave Optuna's lock, and part of
        # a line.
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
    """Return field -> value of one of Optuna's trials."""
    return {
        name: json.loads(trial.params[name]) if hasattr(found, "choices") else trial.params[name]
        for name, found in trial.distributions.items()
    }
