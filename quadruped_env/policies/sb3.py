"""Actors of Stable-Baselines3 and sb3-contrib as layers of a policy.

Modules are recognized by the names of their classes, so that nothing here imports torch or Stable-Baselines3.
"""

import warnings
from collections.abc import Iterable
from types import MappingProxyType
from typing import Any, Final

import gymnasium
import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.policies.activations import ACTIVATIONS, BY_CLASS
from quadruped_env.policies.layers import Actor, Layer, Network, affine_before, samples
from quadruped_env.task import Task, TaskConfig
from quadruped_env.utils.arrays import Floats

_ARGUMENTS: Final = MappingProxyType(
    {"alpha": 1.0, "negative_slope": 0.01, "beta": 1.0, "threshold": 20.0, "approximate": "none"}
)
"""Arguments of these classes that a policy's file has no place for, with their defaults."""
_TRANSPARENT: Final = frozenset({"Flatten", "Identity", "Dropout"})
"""Modules that change nothing when a policy acts."""
_REWRITING: Final = (gymnasium.ObservationWrapper, gymnasium.ActionWrapper)
"""Base classes of wrappers that change observations or actions."""
_LIBRARIES: Final = frozenset({"gymnasium", "stable_baselines3"})
"""Packages whose other wrappers leave observations as they are, or change their number of columns."""
PROTOCOL: Final = (
    "evaluate, compare, view and film it as it is with the protocol of two methods, reset and predict "
    "(docs/training.md#your-own-algorithm)"
)

NORMALIZED_ENV: Final = "env=VecNormalize.load(FILE, make_sb3_vec_env(1)), where FILE was written by VecNormalize.save"


def refused(reason: str) -> QuadrupedError:
    """Return the error for a model that a policy's file cannot hold."""
    return QuadrupedError(
        f"Policy.from_sb3: {reason}; a policy's file holds linear layers with one activation function between them "
        f"({', '.join(ACTIVATIONS)}, each with its default arguments), for the export and for a robot's controller: "
        f"{PROTOCOL}"
    )


def actor_of(model: Any) -> Actor:
    """Return the actor of a model; see `Policy.from_sb3`."""
    if not hasattr(model, "get_env"):
        raise QuadrupedError(f"Policy.from_sb3: expected a model of Stable-Baselines3; found {type(model).__name__}")
    kind, venv, normalize = type(model).__name__, model.get_env(), model.get_vec_normalize_env()
    if was_normalized(model) and normalize is None:
        raise QuadrupedError(
            f"Policy.from_sb3: this {kind} was trained in a VecNormalize, whose statistics are not in its zip, and "
            f"its env has none, so its actions would be others; load it with {NORMALIZED_ENV}"
        )
    if venv is None:
        raise QuadrupedError(
            f"Policy.from_sb3: this {kind} has no env; if it was trained in a VecNormalize, load it with "
            f"{NORMALIZED_ENV}; if it was not, with env=make_sb3_vec_env(1). Both take the action_mode of the "
            f"training"
        )
    config = _task_of(venv)
    network = actor_network(model.policy)
    layout = ObservationLayout(config.robot, config.definition.observations, config.control.observation_history)
    inputs, found = layout.history * layout.width, len(network.layers[0][0])
    if found != inputs:
        raise refused(f"its actor sees {found} columns, and the env's observation has {inputs}")
    raw = seen = samples(inputs)
    if normalize is not None and normalize.norm_obs:
        mean, variance = normalize.obs_rms.mean[:inputs], normalize.obs_rms.var[:inputs]
        deviation = np.sqrt(variance + normalize.epsilon)
        first, *others = network.layers
        network = network._replace(layers=[affine_before(first, 1.0 / deviation, -mean / deviation), *others])
        raw = (seen * deviation + mean).astype(np.float32)
        _check_clip(mean, deviation, float(normalize.clip_obs), venv.observation_space)
    # With the privileged readings, which the actor does not see.
    wide = np.zeros((len(seen), model.policy.observation_space.shape[0]), np.float32)
    wide[:, :inputs] = seen
    actions, _ = model.predict(wide, deterministic=True)
    return Actor(network, config, raw, actions, type(model.policy).__name__, refused)


def was_normalized(model: Any) -> bool:
    """Return True if a model is known to have been trained in a `VecNormalize`, which its zip does not hold.

    The on-policy algorithms of Stable-Baselines3 keep an observation before its normalization, and in other envs none.
    Those with a replay buffer keep one in any env.
    """
    return not hasattr(model, "replay_buffer_class") and getattr(model, "_last_original_obs", None) is not None


def _task_of(venv: Any) -> TaskConfig:
    """Return the config of the task of SB3's vector env, whose wrappers may change neither observations nor actions."""
    inner, wrappers = venv, []
    while hasattr(inner, "venv"):
        wrappers.append(inner)
        inner = inner.venv
    for base in _REWRITING:
        if any(inner.env_is_wrapped(base)):
            raise refused(f"its env has an {base.__name__}, which changes observations or actions")
    for member in getattr(inner, "envs", ()):
        env = member
        while isinstance(env, gymnasium.Wrapper):
            wrappers.append(env)
            env = env.env
    for wrapper in wrappers:
        kind = type(wrapper)
        if kind.__module__.partition(".")[0] not in _LIBRARIES and not issubclass(kind, gymnasium.RewardWrapper):
            warnings.warn(
                f"Policy.from_sb3: the env has the wrapper {kind.__name__}, which the policy leaves out; what it "
                f"changes in observations or actions is missing",
                QuadrupedWarning,
                stacklevel=4,
            )
    try:
        task = inner.get_attr("task", 0)[0]
    except AttributeError:
        task = None
    if not isinstance(task, Task):
        raise QuadrupedError(
            f"Policy.from_sb3: {type(inner).__name__} is not an env of this package; train in make_sb3_vec_env(...), "
            f"or in SB3's vector env of gymnasium.make('MiniQuadruped-v0')"
        )
    return task.config


def actor_network(policy: Any) -> Network:
    """Return the network of an SB3 policy's actor.

    Raises:
        QuadrupedError: if a policy's file cannot hold it.
    """
    kind = type(policy).__name__
    actor: Any = getattr(policy, "actor", None)
    if hasattr(policy, "lstm_actor"):
        raise refused(f"{kind} is recurrent")
    source = policy if actor is None else actor
    for name in ("features_extractor", "pi_features_extractor"):
        extractor = type(getattr(source, name, None)).__name__
        if extractor not in ("NoneType", "FlattenExtractor", "ObservationColumns"):
            raise refused(f"{kind} has the features extractor {extractor}")
    modules: Any = None
    clip_mean: float | None = None
    output = "tanh" if getattr(policy, "squash_output", False) else "clip"
    if actor is None and hasattr(policy, "action_net"):
        modules = [*getattr(getattr(policy, "mlp_extractor", None), "policy_net", ()), *_parts(policy.action_net)]
    elif hasattr(actor, "latent_pi"):
        modules, output = [*actor.latent_pi, *_parts(actor.mu)], "tanh"
        clip_mean = modules.pop().max_val if type(modules[-1]).__name__ == "Hardtanh" else None  # of gSDE
    elif hasattr(actor, "mu"):
        modules, output = _parts(actor.mu), "clip"
    if not modules:
        raise refused(f"{kind} has no actor that is known here")
    if type(modules[-1]).__name__ == "Tanh":
        modules, output = modules[:-1], "tanh"
    layers, activation = linear_layers(modules)
    if clip_mean is not None:
        layers = _clipped(layers, activation, clip_mean)
    mirror = getattr(policy, "mirror", None)
    return Network(layers if actor is None or mirror is None else symmetrized(layers, mirror), activation, output)


def _parts(module: Any) -> list[Any]:
    return list(module) if type(module).__name__ == "Sequential" else [module]


def linear_layers(modules: Iterable[Any]) -> tuple[list[Layer], str]:
    """Return the weights and biases of a perceptron's layers, and the activation function between them.

    A batch renormalization before a layer, which in use is an affine function of its inputs, becomes a part of it.

    Raises:
        QuadrupedError: if there is any other module, or another activation function.
    """
    layers: list[Layer] = []
    renorm: Layer | None = None
    activation, activated = "", True
    for module in modules:
        kind = type(module).__name__
        if kind in _TRANSPARENT:
            continue
        if kind == "Linear" and activated:
            weight = _array(module.weight).T.copy()
            bias = np.zeros(weight.shape[1], np.float32) if module.bias is None else _array(module.bias).copy()
            layers.append((weight, bias) if renorm is None else affine_before((weight, bias), *renorm))
            renorm, activated = None, False
        elif (found := BY_CLASS.get(kind.lower())) and found == (activation or found) and not activated:
            for name, default in _ARGUMENTS.items():
                if vars(module).get(name, default) != default:
                    raise refused(f"its actor has {kind}({name}={vars(module)[name]})")
            activation, activated = found, True
        elif kind == "BatchRenorm1d" and activated and renorm is None:
            factor = module.scale / (module.ra_var + module.eps).sqrt()
            renorm = _array(factor), _array(module.bias - module.ra_mean * factor)
        else:
            raise refused(f"its actor has the module {kind}")
    if not layers or activated:
        raise refused("its actor does not end with a linear layer")
    return layers, activation or "tanh"


def _clipped(layers: list[Layer], activation: str, limit: float) -> list[Layer]:
    """Return layers that give the values of `layers` clipped to +-limit: relu(x + limit) - relu(x - limit) - limit."""
    if activation != "relu":
        raise refused(f"its actor explores with gSDE and clips its mean (clip_mean={limit:g}), and is no ReLU network")
    *inner, (weight, bias) = layers
    both = np.eye(len(bias), dtype=np.float32)
    return [
        *inner,
        (np.tile(weight, 2), np.concatenate([bias + np.float32(limit), bias - np.float32(limit)])),
        (np.concatenate([both, -both]), np.full_like(bias, -limit)),
    ]


def _array(tensor: Any) -> NDArray[np.float32]:
    return tensor.detach().cpu().numpy()


def symmetrized(layers: list[Layer], mirror: MirrorMap) -> list[Layer]:
    """Return one network of twice the width that is symmetric: the average of a network and its mirror image."""
    (first, first_bias), *inner, (last, last_bias) = layers
    half = np.float32(0.5)
    mirrored = (first * mirror.observation_sign[:, None])[np.argsort(mirror.observation_order)]
    return [
        (np.concatenate([first, mirrored], axis=1), np.tile(first_bias, 2)),
        *((np.kron(np.eye(2, dtype=np.float32), weight), np.tile(bias, 2)) for weight, bias in inner),
        (half * np.concatenate([last, mirror.action(last)]), half * (last_bias + mirror.action(last_bias))),
    ]


def _check_clip(mean: Floats, deviation: Floats, clip: float, space: Any) -> None:
    """Warn if observations that the env can give are clipped by the normalization, which a policy's file cannot."""
    low, high = space.low[: len(mean)], space.high[: len(mean)]
    beyond = np.maximum(np.abs(low - mean), np.abs(high - mean)) > clip * deviation
    if beyond.any():
        warnings.warn(
            f"Policy.from_sb3: VecNormalize clips observations at {clip:g} standard deviations, which "
            f"{beyond.sum()} columns can exceed, and the policy does not clip there; train with a larger clip_obs",
            QuadrupedWarning,
            stacklevel=4,
        )
