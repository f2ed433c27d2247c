"""Choice of the settings of a sweep: one config, a grid, random draws, or Optuna's proposals."""

import itertools
import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, Protocol

import numpy as np

from quadruped_env.errors import MissingExtraError
from quadruped_env.scale.sweep.search_space import Dimension
from quadruped_env.scale.sweep.sweep_definition import SweepConfig
from quadruped_env.utils.plain import plain

EXTRA: Final = "sweep"


class Proposals(Protocol):
    """Source of settings."""

    def values(self, setting: int) -> dict[str, Any]:
        """Values of the fields that vary, of a setting that has not begun."""

    def tell(self, setting: int, values: Mapping[str, Any], score: float | None) -> None:
        """Score of a setting that is complete; None if all of its trials failed."""


class Drawn:
    """Settings that depend on their number alone."""

    def __init__(self, values: Callable[[int], dict[str, Any]]) -> None:
        self.values = values

    def tell(self, setting: int, values: Mapping[str, Any], score: float | None) -> None:
        """See `Proposals`: no later setting depends on it."""


class Optuna:
    """Settings proposed by Optuna's tree-structured Parzen estimator.

    Bergstra et al. 2011, https://papers.nips.cc/paper/4443-algorithms-for-hyper-parameter-optimization.

    Args:
        space: the fields that vary.
        seed: seed of the proposals.
    """

    def __init__(self, space: Sequence[Dimension], seed: int) -> None:
        optuna = optuna_module()
        self._optuna, self._space, self._seed = optuna, space, seed
        self._distributions = {dimension.field: distribution(dimension) for dimension in space}
        self._study = optuna.create_study(direction="maximize")
        self._asked: dict[int, Any] = {}

    def values(self, setting: int) -> dict[str, Any]:
        """See `Proposals`."""
        # A sampler of its own for each setting: a resumed sweep does not repeat the proposals of the first process.
        self._study.sampler = self._optuna.samplers.TPESampler(seed=self._seed + 1000 * setting, constant_liar=True)
        trial = self._asked[setting] = self._study.ask(self._distributions)
        return {dimension.field: chosen(dimension, trial.params[dimension.field]) for dimension in self._space}

    def tell(self, setting: int, values: Mapping[str, Any], score: float | None) -> None:
        """See `Proposals`."""
        state = self._optuna.trial.TrialState.FAIL if score is None else self._optuna.trial.TrialState.COMPLETE
        if setting in self._asked:
            self._study.tell(self._asked.pop(setting), score, state)
            return
        # Proposed by a process that has ended.
        self._study.add_trial(
            self._optuna.trial.create_trial(
                state=state,
                params={dimension.field: parameter(dimension, values[dimension.field]) for dimension in self._space},
                distributions=self._distributions,
                value=score,
            )
        )


def proposals(config: SweepConfig) -> Proposals:
    """The source of a sweep's settings.

    Raises:
        MissingExtraError: if it is Optuna, which is not installed.
    """
    seed = int(config.training.get("seed", 0))
    if config.search == "optuna":
        return Optuna(config.space, seed)
    if config.search == "grid":
        names = [dimension.field for dimension in config.space]
        grid = list(itertools.product(*(dimension.choices for dimension in config.space)))
        return Drawn(lambda setting: dict(zip(names, grid[setting], strict=True)))

    def draw(setting: int) -> dict[str, Any]:
        generator = np.random.default_rng([seed, setting])
        return {dimension.field: dimension.draw(generator) for dimension in config.space}

    return Drawn(draw)


def optuna_module() -> Any:
    """Optuna, without its messages about each trial.

    Raises:
        MissingExtraError: if it is not installed.
    """
    try:
        import optuna
    except ImportError as error:
        raise MissingExtraError("--search optuna", EXTRA) from error
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    return optuna


def distribution(dimension: Dimension) -> Any:
    """Optuna's distribution of a field."""
    distributions = optuna_module().distributions
    if dimension.choices:
        return distributions.CategoricalDistribution([json.dumps(plain(choice)) for choice in dimension.choices])
    kind = distributions.IntDistribution if dimension.whole else distributions.FloatDistribution
    return kind(dimension.low, dimension.high, log=dimension.log)


def parameter(dimension: Dimension, value: Any) -> Any:
    """A value as Optuna's parameter: choices, which may be lists, as JSON."""
    return json.dumps(plain(value)) if dimension.choices else value


def chosen(dimension: Dimension, found: Any) -> Any:
    """The value that a parameter of Optuna stands for."""
    if not dimension.choices:
        return found
    return next(choice for choice in dimension.choices if json.dumps(plain(choice)) == found)
