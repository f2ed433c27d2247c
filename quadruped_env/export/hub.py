"""Files and results for a model hub, in addition to an exported policy."""

from collections.abc import Iterable, Mapping
from typing import Any, Final

from quadruped_env.envs import ENV_ID

RESULTS_FILE: Final = "results.json"
PAGE_FILE: Final = "walk.html"
"""The page that walks; `quadruped_env.walking_page` writes it, also next to a report."""


def model_index(name: str, results: Mapping[str, Mapping[str, Any]], metrics: Iterable[str]) -> list[dict[str, Any]]:
    """Results as a hub lists them with a model.

    Args:
        name: of the model.
        results: motion -> metric -> number, or its estimate with a field `mean`; None where it was not measured.
        metrics: those to list.
    """
    values = [(metric, motion, mean_of(found.get(metric))) for motion, found in results.items() for metric in metrics]
    listed = [
        {"type": metric, "name": f"{metric.replace('_', ' ')}, {motion}", "value": value}
        for metric, motion, value in values
        if value is not None
    ]
    task = {"type": "reinforcement-learning", "name": "walking as commanded"}
    return [{"name": name, "results": [{"task": task, "dataset": {"name": ENV_ID, "type": ENV_ID}, "metrics": listed}]}]


def mean_of(value: Any) -> float | None:
    """A metric's number: itself, or the mean of an estimate; None where it was not measured."""
    return value["mean"] if isinstance(value, Mapping) else value
