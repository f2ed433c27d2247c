"""Policies of zips of Stable-Baselines3: the only place that unpickles a file, and only where a user says so."""

import hashlib
import json
import zipfile
from pathlib import Path
from typing import Any, Final

from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.policies import Policy
from quadruped_env.policies.layers import check_fits
from quadruped_env.policies.not_a_policy import SB3_MEMBERS, not_a_policy
from quadruped_env.policies.sb3 import was_normalized
from quadruped_env.task import TaskConfig
from quadruped_env.training.sb3_models import algorithm_class
from quadruped_env.utils.documents import check_regular

_FIELDS: Final = {
    "n_epochs": "ppo",
    "cg_max_steps": "trpo",
    "top_quantiles_to_drop_per_net": "tqc",
    "target_update_interval": "sac",
    "target_entropy": "crossq",
    "target_noise_clip": "td3",
    "gae_lambda": "a2c",
}
"""Field of a zip's data -> algorithm; the first field that the data has counts. A DDPG is a TD3 in its zip."""
_NEVER_USED: Final[dict[str, Any]] = {
    "learning_rate": 0.0,
    "lr_schedule": 0.0,
    "clip_range": 0.2,
    "clip_range_vf": None,
    "action_noise": None,
    "buffer_size": 1,
    "ep_info_buffer": None,
    "ep_success_buffer": None,
    "tensorboard_log": None,
}
"""Fields that only a training needs, with the values that replace them: a replay buffer may need gigabytes, and a
pickled function often cannot be read by another version of Python."""


def import_policy(path: Path, config: TaskConfig, vecnormalize: Path | None = None) -> Policy:
    """Return the policy of a zip of Stable-Baselines3 or sb3-contrib.

    The zip and the statistics are unpickled: both can execute any code.

    Args:
        path: the zip that `model.save` wrote.
        config: config of the task in which the model was trained.
        vecnormalize: file that `VecNormalize.save` wrote, for a model that was trained in one.

    Raises:
        QuadrupedError: if a file cannot be read or loaded, the model was trained in a `VecNormalize` whose statistics
            are not given, its observations or actions do not fit the task, or a policy's file cannot hold its actor.
        MissingExtraError: if sb3-contrib is needed, and is not installed.
    """
    kind = algorithm_class(_algorithm_of(path))
    in_python = "load it in Python with its own class, and save Policy.from_sb3(model)"
    model = _unpickled(path, lambda: kind.load(path, device="cpu", custom_objects=_NEVER_USED), in_python)
    if vecnormalize is None and was_normalized(model):
        raise QuadrupedError(
            f"{path}: this {kind.__name__} was trained in a VecNormalize, whose statistics are not in the zip; name "
            f"their file (vecnormalize), which VecNormalize.save writes (vecnormalize.pkl of rl_zoo3)"
        )
    check_fits(path, model.observation_space.shape, model.action_space.shape, config)
    env: Any = make_sb3_vec_env(1, config=config)
    if vecnormalize is not None:
        from stable_baselines3.common.vec_env import VecNormalize

        check_regular(vecnormalize, "name the file that VecNormalize.save wrote")
        plain = env
        env = _unpickled(vecnormalize, lambda: VecNormalize.load(str(vecnormalize), plain), "name the model's file")
    model.n_envs = 1  # of the training, which may have had more
    model.set_env(env)
    policy = Policy.from_sb3(model)
    source = {"name": path.name, "sha256": hashlib.sha256(path.read_bytes()).hexdigest()}
    return policy.with_card({**policy.card, "imported_from": source})


def _algorithm_of(path: Path) -> str:
    """Return the name of the algorithm of a zip, from the names in its data, which is read as JSON."""
    check_regular(path, "name the zip that model.save wrote")
    try:
        with zipfile.ZipFile(path) as archive:
            data = json.loads(archive.read("data")) if set(archive.namelist()) >= SB3_MEMBERS else None
    except (OSError, zipfile.BadZipFile, ValueError) as error:
        problem = not_a_policy(str(path)) or f"{path}: cannot be read as a zip ({type(error).__name__})"
        raise QuadrupedError(f"{problem}; name the zip that model.save of Stable-Baselines3 wrote") from error
    if not isinstance(data, dict):
        raise QuadrupedError(f"{path}: not a zip that model.save of Stable-Baselines3 wrote; name one")
    found = next((name for field, name in _FIELDS.items() if field in data), None)
    if found is None:
        raise QuadrupedError(
            f"{path}: its algorithm is unknown; load it in Python with its own class, and save Policy.from_sb3(model)"
        )
    return found


def _unpickled(path: Path, load: Any, fix: str) -> Any:
    """Return the result of loading a pickled file, whose errors are of any kind."""
    try:
        return load()
    except Exception as error:
        raise QuadrupedError(
            f"{path}: cannot be loaded ({type(error).__name__}: {short(str(error))}); {fix}"
        ) from error
