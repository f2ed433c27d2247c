"""Policies that are code: an object with the two methods of `Agent`, from Python or from a file that a user names."""

import copy
from pathlib import Path
from typing import Any, Final

from quadruped_env.control.policy import Agent, Policy
from quadruped_env.control.task_file import execute
from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError, short

NAME: Final = "policy"
"""Name of the object, or of its class, at the top level of a user's file."""
_ENV_ARGUMENTS: Final = ("action_mode", "config", "task_file", "robot", "terrain")


def as_policy(policy: Policy | Agent, source: str = "policy", **env_kwargs: Any) -> Policy:
    """A policy, or the policy of an agent, which acts for one set of envs at a time.

    Args:
        policy: either of both.
        source: name in error messages.
        env_kwargs: arguments of the env that an agent does not name itself.

    Raises:
        QuadrupedError: if the object lacks one of the two methods, or its `env_kwargs` are not valid.
    """
    if isinstance(policy, Policy):
        return policy
    kind = type(policy).__name__
    for method in ("reset", "predict"):
        if not callable(getattr(policy, method, None)):
            raise QuadrupedError(
                f"{source}: {kind} has no method {method}; a policy has reset(begun) and predict(observation) "
                f"(docs/training.md#your-own-algorithm)"
            )
    own = getattr(policy, "env_kwargs", {})
    if not isinstance(own, dict) or not set(own) <= set(_ENV_ARGUMENTS):
        raise QuadrupedError(
            f"{source}: env_kwargs: expected a dict with {', '.join(_ENV_ARGUMENTS)}; found {short(own)}"
        )
    arguments = {"action_mode": None, "config": None, **env_kwargs, **own}
    try:
        config = task_config(**arguments)
    except QuadrupedError as error:
        raise QuadrupedError(f"{source}: env_kwargs: {error}" if own else str(error)) from error
    made = Policy.for_task((), (), "", config, {"agent": kind}, agent=policy)
    object.__setattr__(made, "source", source)
    return made


def load_agent(path: str | Path, **env_kwargs: Any) -> Policy:
    """The policy that a user's file defines, with memory of its own; the file is executed.

    Args:
        path: Python file with an agent, or its class, under the name `policy`.
        env_kwargs: arguments of the env that the agent does not name itself.

    Raises:
        QuadrupedError: if the file cannot be executed, defines no agent, or its agent is not valid.
    """
    file, module = execute(path)
    agent = getattr(module, NAME, None)
    if agent is None:
        raise QuadrupedError(
            f"{path}: defines no {NAME!r}; name an object with reset(begun) and predict(observation), or its class, "
            f"{NAME!r} (docs/training.md#your-own-algorithm)"
        )
    policy = as_policy(own_copy(agent, str(path)), str(path), **env_kwargs)
    return policy.with_card({**policy.card, **file.to_dict()})


def own_copy(agent: Agent | type[Agent], source: str) -> Agent:
    """An agent of a class, or a copy of one: two robots do not share a memory.

    Raises:
        QuadrupedError: if it cannot be made.
    """
    try:
        return agent() if isinstance(agent, type) else copy.deepcopy(agent)
    except Exception as error:
        raise QuadrupedError(
            f"{source}: {NAME} cannot be made or copied ({type(error).__name__}: {error}); define it as a class that "
            f"needs no arguments"
        ) from error
