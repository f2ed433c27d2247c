"""Settings of a training."""

import math
import numbers
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final, Literal

from quadruped_env.control.control_config import ACTION_MODES
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.policies.activations import ACTIVATIONS
from quadruped_env.training.algorithms import algorithm
from quadruped_env.training.recipes import recipe
from quadruped_env.training.user_classes import is_user_class
from quadruped_env.utils.seeds import check_training_seeds

OPEN: Final = math.nextafter(0.0, 1.0)
"""Lowest value of a number that must be more than 0."""
BOUNDS: Final[Mapping[str, tuple[float, float]]] = MappingProxyType(
    {
        "timesteps": (1, 10**12),
        "seconds": (OPEN, 1e9),
        "seed": (0, 2**32 - 1),
        "num_envs": (1, 10**6),
        "checkpoint_seconds": (OPEN, 1e9),
        "n_steps": (1, 10**6),
        # Advantages are normalized over a batch.
        "batch_size": (2, 10**9),
        "n_epochs": (1, 1000),
        "learning_rate": (OPEN, 1.0),
        "gamma": (OPEN, 1.0),
        "gae_lambda": (0.0, 1.0),
        "clip_range": (OPEN, 10.0),
        "ent_coef": (0.0, 1000.0),
        "max_grad_norm": (OPEN, 1e6),
        "buffer_size": (1, 10**9),
        "learning_starts": (0, 10**9),
        "gradient_steps": (1, 10**6),
        "tau": (OPEN, 1.0),
        "action_noise": (0.0, 10.0),
        # As Stable-Baselines3 clips it: exp(2) is 7 times the range of an action.
        "log_std_init": (-20.0, 2.0),
        "final_log_std": (-20.0, 2.0),
    }
)
"""Lowest and highest value of every number in `TrainConfig`. Beyond them a training overflows, or never ends."""
MAX_WIDTH: Final = 16_384
"""Maximum width of a hidden layer."""
MAX_LAYERS: Final = 16


@dataclass(frozen=True)
class TrainConfig:
    """Settings of a training, the options of `mini-quadruped train`; an algorithm's have Stable-Baselines3's names.

    The defaults are those of PPO; `algorithms.ALGORITHMS` has those of the others.
    """

    recipe: Literal["flat", "rough"] = "flat"
    """Named settings of the training and its task, which other options change"""
    algo: str = "ppo"
    """Algorithm: ppo, a2c, sac, td3 or ddpg of Stable-Baselines3; trpo, tqc or crossq of sb3-contrib; or FILE.py:CLASS
    of your own, derived from one of them (docs/training.md#your-own-algorithm)"""
    policy: str = ""
    """Policy class FILE.py:CLASS of your own, derived from one of Stable-Baselines3's, in place of the symmetric one"""
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
        if self.action_mode not in ACTION_MODES:
            raise QuadrupedError(
                f"--action-mode: {self.action_mode!r} is unknown; valid modes are {', '.join(ACTION_MODES)}"
            )
        recipe(self.recipe)
        # A user's file is not executed because a config names it.
        entry = None if is_user_class(self.algo) else algorithm(self.algo)
        if self.policy and not is_user_class(self.policy):
            raise QuadrupedError(f"--policy: expected FILE.py:CLASS; found {short(self.policy)}")
        on_policy = entry is not None and entry.on_policy
        if self.symmetric and on_policy and not self.policy and any(width % 2 for width in self.hidden):
            raise QuadrupedError(
                f"--hidden: expected even widths, or --no-symmetric: a symmetric network has pairs of units; found "
                f"{short(self.hidden)}"
            )
        check_training_seeds("--seed", self.seed, self.num_envs)
        if "/" in self.name or self.name in {"", ".", ".."} or not self.name.isprintable():
            raise QuadrupedError(f"--name: {short(self.name)} cannot be part of a directory's name")
        minibatches = entry is not None and entry.on_policy and "batch_size" in entry.settings
        if minibatches and self.num_envs * self.n_steps < self.batch_size:
            raise QuadrupedError(
                f"--batch-size: {self.batch_size} is more than the {self.num_envs * self.n_steps} samples of an update "
                f"(num_envs * n_steps); lower it or use more envs"
            )


def field_rule(name: str, value: Any) -> str | None:
    """Description of the valid values of a field of `TrainConfig` if a value, perhaps from a file, is not one."""
    default = getattr(TrainConfig, name, None)
    if name == "hidden":
        valid = isinstance(value, (list, tuple)) and len(value) <= MAX_LAYERS
        if valid and all(type(width) is int and 1 <= width <= MAX_WIDTH for width in value):
            return None
        return f"up to {MAX_LAYERS} whole numbers, widths of 1 or more, and at most {MAX_WIDTH}"
    if name == "task":
        return None if isinstance(value, dict) else "a table of fields"
    if name == "activation":
        return None if isinstance(value, str) and value in ACTIVATIONS else f"one of {', '.join(ACTIVATIONS)}"
    if name not in BOUNDS:
        kind, rule = (bool, "true or false") if isinstance(default, bool) else (str, "a text")
        return None if isinstance(value, kind) else rule
    if value is None and default is None:
        return None
    number = numbers.Integral if isinstance(default, int) else numbers.Real
    low, high = BOUNDS[name]
    if isinstance(value, number) and not isinstance(value, bool) and bool(low <= value <= high):  # type: ignore[operator]
        return None
    kind_of_number = "a whole number, " if isinstance(default, int) and not isinstance(value, numbers.Integral) else ""
    from_low = "more than 0" if low == OPEN else f"{low:g} or more"
    return f"{kind_of_number}{from_low}, and at most {high:.10g}{' (or null)' if default is None else ''}"


def check_fields(values: Mapping[str, Any]) -> None:
    """Check the type and the bounds of some fields of `TrainConfig`.

    Raises:
        QuadrupedError: naming the option, the bounds and the value; if there is no such field.
    """
    for name, value in values.items():
        option = f"--{name.replace('_', '-')}"
        if name not in TrainConfig.__dataclass_fields__:
            raise QuadrupedError(f"{short(option)}: unknown setting of a training; leave it out")
        rule = field_rule(name, value)
        if rule is not None:
            raise QuadrupedError(f"{option}: expected {rule}; found {short(value)}")
