"""Motor files: the `motor` part of the environment's config, as JSON."""

from pathlib import Path

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED, MotorConfig, Robot
from quadruped_env.task import BUILT_IN, TaskConfig
from quadruped_env.utils.documents import read_json


def read_motors(path: Path, robot: Robot = MINI_QUADRUPED) -> MotorConfig:
    """Read the motors of a robot from a file of `mini-quadruped identify`.

    Raises:
        QuadrupedError: if the file cannot be read, or does not contain motors.
    """
    document = read_json(path, "name a file of motors")
    if not isinstance(document, dict) or set(document) != {"motor"}:
        raise QuadrupedError(f'{path}: expected {{"motor": ...}}, as `mini-quadruped identify` writes it')
    try:
        return TaskConfig.from_dict(document, BUILT_IN.with_robot(robot)).motor
    except QuadrupedError as error:
        raise QuadrupedError(f"{path}: {error}") from error
