"""Metrics of a training for a service that tracks experiments, through Stable-Baselines3's logger."""

import importlib
import warnings
from collections.abc import Callable, Mapping
from numbers import Real
from typing import Any, Final

from stable_baselines3.common.logger import KVWriter

from quadruped_env.errors import QuadrupedError, QuadrupedWarning, cut, escaped

SERVICES: Final = ("wandb", "mlflow", "trackio")


def service_module(service: str) -> Any:
    """Import the Python package of a service, one of `SERVICES`.

    Raises:
        QuadrupedError: if it is not installed.
    """
    try:
        return importlib.import_module(service)
    except ImportError as error:
        raise QuadrupedError(f"--track: {service} is not installed: pip install {service}") from error


class ServiceWriter(KVWriter):
    """Writer of what the logger records to a run of Weights & Biases, MLflow or trackio.

    Where the run goes, and who may see it, is set as each service has it, such as by WANDB_MODE or MLFLOW_TRACKING_URI.
    A service that fails in the middle of a training does not end it.

    Args:
        service: one of `SERVICES`.
        name: name of the run.
        settings: settings of the training.

    Raises:
        QuadrupedError: if the service is not installed, or cannot begin a run.

    Warns:
        QuadrupedWarning: when the service fails later; no more metrics are sent.
    """

    def __init__(self, service: str, name: str, settings: Mapping[str, Any]) -> None:
        self._service, self._failed, module = service, False, service_module(service)
        try:
            if service == "mlflow":
                module.start_run(run_name=name)
                module.log_params(settings)
                self._log, self._end = module.log_metrics, module.end_run
            else:
                module.init(project="mini-quadruped", name=name, config=dict(settings))
                self._log, self._end = module.log, module.finish
        except Exception as error:  # each service has its own
            raise QuadrupedError(
                f"--track: {service} cannot begin a run ({_in_a_line(error)}); check its settings, or leave --track out"
            ) from error

    def write(self, key_values: dict[str, Any], key_excluded: dict[str, tuple[str, ...]], step: int = 0) -> None:
        """See `KVWriter`."""
        metrics = {name: float(value) for name, value in key_values.items() if isinstance(value, Real)}
        self._call(self._log, metrics, step=step)

    def close(self) -> None:
        """See `KVWriter`."""
        self._call(self._end)

    def _call(self, function: Callable[..., Any], *arguments: Any, **named: Any) -> None:
        """Call a function of the service, unless one has failed before."""
        if self._failed:
            return
        try:
            function(*arguments, **named)
        except Exception as error:  # each service has its own
            self._failed = True
            message = f"--track: {self._service} failed ({_in_a_line(error)}); no more metrics are sent"
            warnings.warn(message, QuadrupedWarning, stacklevel=2)


def _in_a_line(error: Exception) -> str:
    """Return the type of an error and its message."""
    return cut(escaped(f"{type(error).__name__}: {' '.join(str(error).split())}"))
