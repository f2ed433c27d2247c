"""Choice of the settings of a sweep: one config, a grid, random draws, or Optuna's proposals."""

import itertools
import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from quadruped_env.errors import MissingExtraError
from quadruped_env.sweep.search_space import Dimension
from quadruped_env.sweep.sweep_definition import SweepConfig
from quadruped_env.utils.plain import plain


class Proposals:
    """Source of a sweep's settings. Those of a grid and random ones depend on their number alone.

    Optuna's are those of its tree-structured Parzen estimator: Bergstra et al. 2011,
    https://papers.nips.cc/paper/4443-algorithms-for-hyper-parameter-optimization.

    Args:
        config: the sweep.

    Raises:
        MissingExtraError: if Optuna is needed and not installed.
    """

    def __init__(self, config: SweepConfig) -> None:
        self._search, self._space, self._seed = config.search, config.space, int(config.training.get("seed", 0))
        if self._search == "optuna":
            self._optuna = optuna_module()
            self._study = self._optuna.create_study(direction="maximize")
            self._asked: dict[int, Any] = {}

    def values(self, setting: int) -> dict[str, Any]:
        """Values of the fields that vary, of a setting that has not begun."""
        if self._search == "grid":
            grid = itertools.product(*(dimension.choices for dimension in self._space))
            choices = next(itertools.islice(grid, setting, None))
            return {dimension.field: choice for dimension, choice in zip(self._space, choices, strict=True)}
        if self._search == "random":
            generator = np.random.default_rng([self._seed, setting])
            return {dimension.field: dimension.draw(generator) for dimension in self._space}
        # A sampler of its own for each setting: a resumed sweep does not repeat the proposals of the first process.
        self._study.sampler = self._optuna.samplers.TPESampler(seed=self._seed + 1000 * setting, constant_liar=True)
        trial = self._asked[setting] = self._study.ask({d.field: distribution(d) for d in self._space})
        return {
            dimension.field: next(v for v in dimension.choices if parameter(dimension, v) == found)
            if dimension.choices
            else found
            for dimension in self._space
            for found in [trial.params[dimension.field]]
        }

    def tell(self, setting: int, values: Mapping[str, Any], score: float | None) -> None:
        """Take note of the score of a setting that is complete; None if all of its trials failed."""
        if self._search != "optuna":
            return
        state = self._optuna.trial.TrialState.FAIL if score is None else self._optuna.trial.TrialState.COMPLETE
        if setting in self._asked:
            self._study.tell(self._asked.pop(setting), score, state)
        else:  # proposed by a process that has ended
            add_trial(self._study, self._space, values, score, state)


def optuna_module() -> Any:
    """Optuna, without its messages about each trial.

    Raises:
        MissingExtraError: if it is not installed.
    """
    try:
        import optuna
    except ImportError as error:
        raise MissingExtraError("--search optuna", "sweep") from error
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    return optuna


def add_trial(study: Any, space: tuple[Dimension, ...], values: Mapping[str, Any], score: Any, state: Any) -> None:
    """Add a setting with its score to a study of Optuna."""
    study.add_trial(
        optuna_module().trial.create_trial(
            state=state,
            params={dimension.field: parameter(dimension, values[dimension.field]) for dimension in space},
            distributions={dimension.field: distribution(dimension) for dimension in space},
            value=score,
        )
    )


def distribution(dimension: Dimension) -> Any:
    """Optuna's distribution of a field."""
    distributions = optuna_module().distributions
    if dimension.choices:
        return distributions.CategoricalDistribution([parameter(dimension, choice) for choice in dimension.choices])
    kind = distributions.IntDistribution if dimension.whole else distributions.FloatDistribution
    return kind(dimension.low, dimension.high, log=dimension.log)


def parameter(dimension: Dimension, value: Any) -> Any:
    """A value as Optuna's parameter: choices, which may be lists, as JSON."""
    return json.dumps(plain(value)) if dimension.choices else value
