"""Motors as a file: the part `motor` of the environment's config, as JSON."""

import json
from pathlib import Path

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MotorConfig
from quadruped_env.task import TaskConfig


def read_motors(path: Path) -> MotorConfig:
    """The motors in a file that `evaluate/identify.py` wrote.

    Raises:
        QuadrupedError: if there is no such file, or it is not one.
    """
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise QuadrupedError(f"{path}: cannot be read ({error.strerror}); name a file of motors") from error
    except ValueError as error:
        raise QuadrupedError(f"{path}: not JSON: {error}; name a file of motors") from error
    if not isinstance(document, dict) or set(document) != {"motor"}:
        raise QuadrupedError(f'{path}: expected {{"motor": ...}}, as evaluate/identify.py writes it')
    try:
        return TaskConfig.from_dict(document).motor
    except QuadrupedError as error:
        raise QuadrupedError(f"{path}: {error}") from error
