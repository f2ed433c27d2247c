"""Models of Stable-Baselines3 and sb3-contrib on the native vector environment: networks and settings.

PPO: Schulman et al. 2017, https://arxiv.org/abs/1707.06347; the massively parallel setting follows Rudin et al. 2021,
https://arxiv.org/abs/2109.11978.
"""

import importlib
import os
import zipfile
from collections.abc import Mapping
from typing import Any, Final

# Torch's idle threads would spin on the cores that the physics needs. Read once, when torch is loaded.
os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.policies.activations import BY_CLASS
from quadruped_env.training.algorithms import ALGORITHMS
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import RESUME_FILE
from quadruped_env.training.train_config import TrainConfig

try:
    import numpy as np
    import torch
    from stable_baselines3.common.noise import NormalActionNoise
    from stable_baselines3.common.save_util import load_from_zip_file

    from quadruped_env.training.actor_critic import ActorCritic, mirrors
    from quadruped_env.training.schedules import Schedule
    from quadruped_env.training.squashed import squashed_policy
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("training", "train") from error

_ACTIVATIONS = {BY_CLASS[name.lower()]: getattr(torch.nn, name) for name in dir(torch.nn) if name.lower() in BY_CLASS}
_OTHERWISE: Final = frozenset(
    {"learning_rate", "desired_kl", "log_std_init", "final_log_std", "symmetric", "action_noise"}
)
"""Settings that are not arguments of an algorithm's class as they are."""


def go_on_from(model: Any, parent: Parent) -> None:
    """Take over a run's network, optimizer, step count and place in the schedules.

    A replay buffer is not saved with a run: it fills again.

    Raises:
        QuadrupedError: if its file cannot be read.
    """
    path = parent.directory / RESUME_FILE
    # The zip reader, torch and SB3 each fail in their own way on a damaged file. Their texts are left out: torch
    # advises to unpickle the file.
    try:
        with zipfile.ZipFile(path) as archive:
            # Few bytes could stand for more than any memory holds.
            if any(entry.compress_type != zipfile.ZIP_STORED for entry in archive.infolist()):
                raise _UnusableError("compressed")
        _, tensors, variables = load_from_zip_file(str(path), load_data=False, device="cpu")
        _check_finite({**tensors, **(variables or {})})
        model.set_parameters(tensors, device="cpu")
        # Such as the weight of the entropy, which the line above leaves out.
        for name, value in (variables or {}).items():
            getattr(model, name).data.copy_(value.data)
    except Exception as error:
        reason = str(error) if isinstance(error, _UnusableError) else type(error).__name__
        raise QuadrupedError(
            f"{path}: cannot be resumed ({reason}); resume another checkpoint or run, or start a new training"
        ) from None
    model.num_timesteps = parent.timesteps
    model.learning_rate.go_on(parent.timesteps, parent.budget_left)


class _UnusableError(Exception):
    """A defect of a file that is found here, in words."""


def _check_finite(value: Any, place: str = "") -> None:
    """Check that all numbers in nested dictionaries and lists of tensors are finite."""
    if isinstance(value, (Mapping, list, tuple)):
        for name, entry in value.items() if isinstance(value, Mapping) else enumerate(value):
            _check_finite(entry, f"{place}.{name}".lstrip("."))
    elif isinstance(value, (torch.Tensor, float)) and not torch.isfinite(torch.as_tensor(value)).all():
        raise _UnusableError(f"{place} holds NaN or infinity")


def algorithm_class(name: str) -> Any:
    """Return the class of an algorithm of `ALGORITHMS`.

    Raises:
        MissingExtraError: if it is in sb3-contrib, which is not installed.
    """
    entry = ALGORITHMS[name]
    try:
        return getattr(importlib.import_module(entry.module), entry.class_name)
    except ImportError as error:
        raise MissingExtraError(f"the algorithm {name}", "contrib") from error


def make_model(config: TrainConfig, env: Any) -> Any:
    """A fresh model for a training, whose `learning_rate` is a `Schedule`; `learn` needs the callback `Scheduled`.

    Args:
        config: settings of the training.
        env: its Stable-Baselines3 env.

    Raises:
        MissingExtraError: if the algorithm is in sb3-contrib, which is not installed.
    """
    torch.distributions.Distribution.set_default_validate_args(False)
    # The bits of the first weights and of every update depend on the number of threads, by default as
    # many as cores. Two are no faster, in batches up to 1024 samples a third slower.
    torch.set_num_threads(1)
    entry, kind = ALGORITHMS[config.algo], algorithm_class(config.algo)
    layout = env.task.control.layout
    hidden = list(config.hidden)
    arguments = {name: getattr(config, name) for name in sorted(entry.settings - _OTHERWISE)}
    own: dict[str, Any] = {
        "actor_width": layout.history * layout.width,
        "activation_fn": _ACTIVATIONS[config.activation],
    }
    if config.symmetric:
        own["mirror"], critic_mirror = mirrors(env)
    if entry.on_policy:
        policy: Any = ActorCritic
        own |= {"net_arch": {"pi": hidden, "vf": hidden}, "log_std_init": config.log_std_init}
        own["optimizer_kwargs"] = {"fused": True, "eps": 1e-5}
        if config.symmetric:
            own["critic_mirror"] = critic_mirror
    else:
        policy = squashed_policy(importlib.import_module(entry.policies), entry.policy)
        own["net_arch"] = {"pi": hidden, "qf": hidden}
        # SB3's own `n_steps` of these algorithms is another setting.
        arguments["train_freq"] = (arguments.pop("n_steps"), "step")
        if "action_noise" in entry.settings:
            joints = env.action_space.shape[0]
            arguments["action_noise"] = NormalActionNoise(np.zeros(joints), np.full(joints, config.action_noise))
    arguments |= {"seed": config.seed, "device": "cpu", "verbose": 0, "policy_kwargs": own}
    return kind(policy, env, **arguments, learning_rate=Schedule(config))
