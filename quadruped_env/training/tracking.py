"""Metrics of a training for a service that tracks experiments, through Stable-Baselines3's logger."""

import importlib
from collections.abc import Mapping
from numbers import Real
from typing import Any, Final

from stable_baselines3.common.logger import KVWriter

from quadruped_env.errors import QuadrupedError

SERVICES: Final = ("wandb", "mlflow", "trackio")


class ServiceWriter(KVWriter):
    """Sends what the logger records to a run of Weights & Biases, MLflow or trackio, which have the same calls.

    Where it goes, and who may see it, is set as each service has it, such as by WANDB_MODE or MLFLOW_TRACKING_URI.

    Args:
        service: name of its Python package, one of `SERVICES`.
        name: of the run.
        settings: of the training.

    Raises:
        QuadrupedError: if the package is not installed.
    """

    def __init__(self, service: str, name: str, settings: Mapping[str, Any]) -> None:
        try:
            module = importlib.import_module(service)
        except ImportError as error:
            raise QuadrupedError(f"--track: {service} is not installed: pip install {service}") from error
        if service == "mlflow":
            module.start_run(run_name=name)
            module.log_params(settings)
            self._log, self._end = module.log_metrics, module.end_run
        else:
            module.init(project="mini-quadruped", name=name, config=dict(settings))
            self._log, self._end = module.log, module.finish

    def write(self, key_values: dict[str, Any], key_excluded: dict[str, tuple[str, ...]], step: int = 0) -> None:
        """See `KVWriter`."""
        self._log({name: float(value) for name, value in key_values.items() if isinstance(value, Real)}, step=step)

    def close(self) -> None:
        """See `KVWriter`."""
        self._end()
