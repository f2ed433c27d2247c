"""Aggregation over training seeds: interquartile mean of the score's components, with stratified bootstrap.

Agarwal et al. 2021, Deep Reinforcement Learning at the Edge of the Statistical Precipice,
https://arxiv.org/abs/2108.13264: the components of the score are the tasks, the training seeds the runs.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.evaluation.confidence import Estimate, percentile_interval
from quadruped_env.evaluation.suite.suite import COMPONENTS, check_comparable

Floats = NDArray[np.float64]

RESAMPLES: Final = 10_000
_SEED: Final = 0
_TRIMMED: Final = 0.25
"""Share of the values that is left out at each end."""


def interquartile_mean(values: ArrayLike) -> Floats:
    """Mean of the middle half of the values along the last axis (..., K).

    A quarter of the values, rounded down, is left out at each end, as by `scipy.stats.trim_mean` and in rliable.
    """
    ordered = np.sort(np.asarray(values, dtype=np.float64), axis=-1)
    out = int(_TRIMMED * ordered.shape[-1])
    return np.asarray(ordered[..., out : ordered.shape[-1] - out].mean(axis=-1))


def stratified_interquartile_mean(scores: ArrayLike) -> Estimate:
    """Interquartile mean of scores (runs, tasks), with its percentile bootstrap interval.

    Each resample draws the runs of every task with replacement, independently of the other tasks. The interval is NaN
    for a single run, which says nothing about the others.
    """
    values = np.asarray(scores, dtype=np.float64)
    runs, tasks = values.shape
    middle = float(interquartile_mean(values.ravel()))
    if runs == 1:
        return Estimate(middle, math.nan, math.nan, 1)
    chosen = np.random.default_rng(_SEED).integers(0, runs, (RESAMPLES, runs, tasks))
    resampled = interquartile_mean(values[chosen, np.arange(tasks)].reshape(RESAMPLES, runs * tasks))
    return Estimate(middle, *percentile_interval(resampled), runs)


def aggregate(documents: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Aggregate of the results of one recipe over its training seeds, as plain values.

    Returns:
        `runs`, the name, total score and components of each run; `score`, the interquartile mean over runs and
        components; `components`, the interquartile mean of each over the runs; and `terrain`, the highest level of each
        kind that all runs pass.

    Raises:
        QuadrupedError: if the results cannot be compared.
    """
    check_comparable({f"{document['name']} ({i + 1})": document for i, document in enumerate(documents)})
    scores = np.array([[document["score"]["components"][name] for name in COMPONENTS] for document in documents])
    return {
        "runs": [{"name": document["name"], **document["score"]} for document in documents],
        "score": stratified_interquartile_mean(scores).to_dict(),
        "components": {
            name: stratified_interquartile_mean(scores[:, [i]]).to_dict() for i, name in enumerate(COMPONENTS)
        },
        "terrain": {
            kind: min(document["terrain"][kind]["highest_level"] for document in documents)
            for kind in documents[0]["terrain"]
        },
    }
