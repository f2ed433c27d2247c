"""Settings of a training."""

import math
import numbers
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final, Literal, get_args

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.training.algorithms import ALGORITHMS
from quadruped_env.utils.seeds import check_training_seeds

_OPEN: Final = math.nextafter(0.0, 1.0)
"""Lowest value of a number that must be more than 0."""
BOUNDS: Final[Mapping[str, tuple[float, float]]] = MappingProxyType(
    {
        "timesteps": (1, 10**12),
        "seconds": (_OPEN, 1e9),
        "seed": (0, 2**32 - 1),
        "num_envs": (1, 10**6),
        "checkpoint_seconds": (_OPEN, 1e9),
        "n_steps": (1, 10**6),
        # Advantages are normalized over a batch.
        "batch_size": (2, 10**9),
        "n_epochs": (1, 1000),
        "learning_rate": (_OPEN, 1.0),
        "gamma": (_OPEN, 1.0),
        "gae_lambda": (0.0, 1.0),
        "clip_range": (_OPEN, 10.0),
        "ent_coef": (0.0, 1000.0),
        "max_grad_norm": (_OPEN, 1e6),
        "buffer_size": (1, 10**9),
        "learning_starts": (0, 10**9),
        "gradient_steps": (1, 10**6),
        "tau": (_OPEN, 1.0),
        "action_noise": (0.0, 10.0),
        # As Stable-Baselines3 clips it: exp(2) is 7 times the range of an action.
        "log_std_init": (-20.0, 2.0),
        "final_log_std": (-20.0, 2.0),
    }
)
"""Lowest and highest value of every number in `TrainConfig`. Beyond them a training overflows, or never ends."""
_MAX_WIDTH: Final = 16_384
"""Maximum width of a hidden layer."""
_MAX_LAYERS: Final = 16
OWN_ALGORITHM: Final = (
    "one of your own trains in your own script, and Policy.from_sb3 or an agent file brings its policy back "
    "(docs/training.md#your-own-algorithm)"
)
"""The way of an algorithm that is not built in."""


@dataclass(frozen=True)
class TrainConfig:
    """Settings of a training; an algorithm's have Stable-Baselines3's names.

    The defaults are those of PPO with the recipe `flat`: `settings.train_config` has those of the others.

    Raises:
        QuadrupedError: if a value is not valid; the message begins with the field's name.
    """

    recipe: Literal["flat", "rough"] = "flat"
    """Named settings of the training and its task, which other options change"""
    algo: Literal["ppo", "a2c", "trpo", "sac", "td3", "ddpg", "tqc", "crossq"] = "ppo"
    """Algorithm: ppo, a2c, sac, td3 or ddpg of Stable-Baselines3; trpo, tqc or crossq of sb3-contrib"""
    action_mode: Literal["position", "residual"] = "residual"
    """`position`: learn from scratch; `residual`: learn on top of the scripted gait"""
    timesteps: int = 1_500_000
    """Budget in environment steps, summed over all envs; the same kind of processor repeats the run bit for bit"""
    seconds: float | None = None
    """Budget in seconds of wall-clock time instead; such a run cannot be repeated bit for bit"""
    seed: int = 0
    """Seed of the envs (each further env has the next one), the network and the exploration"""
    num_envs: int = 256
    """Number of parallel envs"""
    name: str = "ppo"
    """Last part of the run directory's name"""
    checkpoint_seconds: float = 10.0
    """Seconds of wall-clock time between checkpoints"""
    task: dict[str, Any] = field(default_factory=dict)
    """Changes to the task's config, as nested values"""
    n_steps: int = 24
    """Steps of each env between updates"""
    batch_size: int = 1536
    """Samples in a gradient step"""
    n_epochs: int = 6
    """Passes over the samples of an update"""
    learning_rate: float = 1e-3
    """Adam's initial step size; it decreases linearly to a tenth"""
    gamma: float = 0.985
    """Discount per step of 0.02 s"""
    gae_lambda: float = 0.95
    """Decay of the advantage estimate"""
    clip_range: float = 0.2
    """Clip range of PPO's probability ratio"""
    ent_coef: float = 0.0
    """Weight of the entropy bonus"""
    max_grad_norm: float = 1.0
    """Maximum norm of the gradient"""
    buffer_size: int = 500_000
    """Environment steps in the replay buffer of sac, td3, ddpg, tqc and crossq"""
    learning_starts: int = 10_000
    """Environment steps of random actions with which the replay buffer begins"""
    gradient_steps: int = 16
    """Gradient steps in an update from the replay buffer"""
    tau: float = 0.005
    """Share of the networks that their slow copies take over in each gradient step of sac, td3, ddpg and tqc"""
    action_noise: float = 0.1
    """Standard deviation of the exploration of td3 and ddpg, which are deterministic"""
    hidden: tuple[int, ...] = (128, 128)
    """Widths of the hidden layers of the policy and of the value function"""
    activation: Literal["elu", "relu", "tanh", "leaky_relu", "silu", "gelu", "softplus", "selu", "sigmoid", "mish"] = (
        "elu"
    )
    """Activation function of the hidden layers"""
    symmetric: bool = True
    """Make the policy left/right symmetric by construction, as the robot is"""
    asymmetric_critic: bool = True
    """Let the value function see privileged readings that only the simulation knows; the policy never sees them"""
    log_std_init: float = -1.0
    """Logarithm of the exploration's initial standard deviation"""
    final_log_std: float = -2.5
    """Upper bound of that logarithm at the end, reached linearly. Noise slows the robot down, and a policy that
    learned with it overshoots its commands without it"""

    def __post_init__(self) -> None:
        check_fields(vars(self))
        algorithm = ALGORITHMS[self.algo]
        if self.symmetric and algorithm.on_policy and any(width % 2 for width in self.hidden):
            raise QuadrupedError(
                f"hidden: expected even widths, since a symmetric network has pairs of units; found "
                f"{short(self.hidden)}; change them, or set symmetric to false"
            )
        check_training_seeds("seed", self.seed, self.num_envs)
        if "/" in self.name or self.name in {"", ".", ".."} or not self.name.isprintable():
            raise QuadrupedError(f"name: {short(self.name)} cannot be part of a directory's name")
        samples = self.num_envs * self.n_steps
        if algorithm.on_policy and "batch_size" in algorithm.settings and samples < self.batch_size:
            raise QuadrupedError(
                f"batch_size: {self.batch_size} is more than the {samples} samples of an update (num_envs * n_steps); "
                f"lower it or use more envs"
            )


def field_rule(name: str, value: Any) -> str | None:
    """Description of the valid values of a field of `TrainConfig` if a value, perhaps from a file, is not one."""
    entry = TrainConfig.__dataclass_fields__[name]
    if name == "hidden":
        valid = isinstance(value, (list, tuple)) and len(value) <= _MAX_LAYERS
        if valid and all(type(width) is int and 1 <= width <= _MAX_WIDTH for width in value):
            return None
        return f"up to {_MAX_LAYERS} whole numbers, widths of 1 or more, and at most {_MAX_WIDTH}"
    if name in BOUNDS:
        return _number_rule(value, entry.default, *BOUNDS[name])
    if choices := get_args(entry.type) if isinstance(entry.default, str) else ():
        return None if isinstance(value, str) and value in choices else f"one of {', '.join(choices)}"
    kind, rule = {"task": (dict, "a table of fields"), "name": (str, "a text")}.get(name, (bool, "true or false"))
    return None if isinstance(value, kind) else rule


def _number_rule(value: Any, default: Any, low: float, high: float) -> str | None:
    if value is None and default is None:
        return None
    number = numbers.Integral if isinstance(default, int) else numbers.Real
    if isinstance(value, number) and not isinstance(value, bool) and bool(low <= value <= high):  # type: ignore[operator]
        return None
    kind_of_number = "a whole number, " if isinstance(default, int) and not isinstance(value, numbers.Integral) else ""
    from_low = "more than 0" if low == _OPEN else f"{low:g} or more"
    return f"{kind_of_number}{from_low}, and at most {high:.10g}{' (or null)' if default is None else ''}"


def check_fields(values: Mapping[str, Any]) -> None:
    """Check the type and the bounds of some fields of `TrainConfig`.

    Raises:
        QuadrupedError: naming the field, the bounds and the value; if there is no such field.
    """
    for name, value in values.items():
        if name not in TrainConfig.__dataclass_fields__:
            raise QuadrupedError(f"{short(name)}: unknown setting of a training; leave it out")
        rule = field_rule(name, value)
        if rule is not None:
            hint = f"; {OWN_ALGORITHM}" if name == "algo" else ""
            raise QuadrupedError(f"{name}: expected {rule}; found {short(value)}{hint}")
