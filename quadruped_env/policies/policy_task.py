"""The task of a trained policy, and its environments."""

from dataclasses import replace
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.policy import Policy
from quadruped_env.control.policy_files import unusable
from quadruped_env.control.task_file import TASK_FILE
from quadruped_env.envs import ENV_ID
from quadruped_env.errors import QuadrupedError
from quadruped_env.task import BUILT_IN, TaskConfig, TaskDefinition
from quadruped_env.task.task_config import for_definition
from quadruped_env.utils.provenance import TERRAIN_FILE


def config_of(policy: Policy, definition: TaskDefinition = BUILT_IN) -> TaskConfig:
    """Config of a policy's task, with the terms and the robot of a definition.

    Raises:
        QuadrupedError: if it is not valid.
    """
    try:
        # A policy that needs nothing of a user's file is not affected by one.
        own = definition if {TASK_FILE, TERRAIN_FILE} & policy.task.keys() else BUILT_IN.with_robot(policy.robot)
        task = for_definition(policy.task, own) if own.file is None and TASK_FILE in policy.task else policy.task
        return TaskConfig.from_dict(task, own)
    except QuadrupedError as error:
        raise unusable(policy.source, error) from error


def with_task(policy: Policy, definition: TaskDefinition = BUILT_IN) -> Policy:
    """A loaded policy together with its task: see `config_of`."""
    config = config_of(policy, definition)
    return replace(
        policy, control=config.control, fields=config.definition.observations, robot=config.robot, task_config=config
    )


def make_env(policy: Policy, **kwargs: Any) -> gymnasium.Env[NDArray[np.float32], NDArray[np.float32]]:
    """See `Policy.make_env`."""
    return gymnasium.make(ENV_ID, **_task_arguments(policy.config, kwargs), **kwargs)


def make_vec_env(policy: Policy, num_envs: int, **kwargs: Any) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
    """See `Policy.make_vec_env`."""
    return gymnasium.make_vec(ENV_ID, num_envs=num_envs, **_task_arguments(policy.config, kwargs), **kwargs)


def _task_arguments(config: TaskConfig, kwargs: dict[str, Any]) -> dict[str, Any]:
    for name in ("action_mode", "config", "task_file", "robot"):
        if name in kwargs:
            raise QuadrupedError(
                f"policy.make_env: {name} is given by the policy; for another task: gymnasium.make({ENV_ID!r}, ...)"
            )
    if config.definition.added_terrains:
        # Plain values and a task file cannot give these terrains again.
        return {"config": config}
    arguments = {"config": config.to_dict(), "task_file": config.definition.path}
    return arguments if config.robot == BUILT_IN.robot else {**arguments, "robot": config.robot}
