"""Settings of a training."""

import math
import numbers
import re
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

GPU_DEFAULTS: Final[Mapping[str, Any]] = MappingProxyType(
    {"num_envs": 4096, "batch_size": 24_576, "timesteps": 50_000_000}
)
"""Defaults on a GPU, also in place of a recipe's: as many envs as keep it busy, and few steps of each (Rudin et al.
2021). Not tuned."""

WARP_DEVICES: Final[Mapping[str, str]] = MappingProxyType({"warp-cpu": "cpu"})
"""Warp's names of devices, where they differ from those of the option."""
_DEVICE: Final = re.compile(r"cpu|warp-cpu|cuda(:[0-9]{1,3})?")

OPEN: Final = math.nextafter(0.0, 1.0)
"""Lowest value of a number that must be more than 0."""
BOUNDS: Final[Mapping[str, tuple[float, float]]] = MappingProxyType(
    {
        "timesteps": (1, 10**12),
        "seconds": (OPEN, 1e9),
        "seed": (0, 2**32 - 1),
        "num_envs": (1, 10**6),
        "ranks": (1, 10_000),
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
    ranks: int = 1
    """Number of processes that share the envs and average their gradients, with `--device cuda` one on each GPU (ppo
    only; docs/scaling.md)"""
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
    device: str = "cpu"
    """Device of the physics and the networks: `cpu` (MuJoCo's batch and Stable-Baselines3); `cuda` or `cuda:N`, a GPU
    (MuJoCo Warp and rsl-rl, extra gpu); `warp-cpu`, the GPU's code on the CPU, for trying it"""
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
        if not _DEVICE.fullmatch(self.device):
            raise QuadrupedError(f"--device: {short(self.device)} is unknown; expected cpu, cuda, cuda:N or warp-cpu")
        if self.device != "cpu":
            self._check_device()
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
        if self.ranks > 1:
            self._check_ranks()

    def _check_device(self) -> None:
        """Check the settings for a device other than the CPU."""
        if self.algo != "ppo":
            raise QuadrupedError(
                f"--device: {self.device} trains with ppo alone; found --algo {self.algo}; leave one of both out"
            )
        if self.policy:
            raise QuadrupedError(f"--policy: found {self.policy} with --device {self.device}; leave one of both out")

    def _check_ranks(self) -> None:
        if self.algo != "ppo":
            raise QuadrupedError(
                f"--ranks: found {self.ranks} with --algo {self.algo}; only ppo averages gradients over ranks: leave "
                f"--ranks out, or choose --algo ppo"
            )
        if self.device.startswith("cuda:"):
            raise QuadrupedError(
                f"--device: found {self.device} with --ranks {self.ranks}, and each rank needs a GPU of its own; "
                f"choose --device cuda: rank i of a machine uses GPU i (CUDA_VISIBLE_DEVICES selects some)"
            )
        if self.ranks > self.num_envs:
            raise QuadrupedError(
                f"--ranks: found {self.ranks}, more than the {self.num_envs} envs that they share; lower it, or give "
                f"more --num-envs"
            )
        for name in ("num_envs", "batch_size"):
            value, option = getattr(self, name), f"--{name.replace('_', '-')}"
            if value % self.ranks:
                below, above = value - value % self.ranks, value + self.ranks - value % self.ranks
                fixes = " or ".join(f"{option} {fix}" for fix in (below, above) if fix)
                raise QuadrupedError(
                    f"--ranks: found {self.ranks}, which does not divide {option} {value} into equal shares; choose "
                    f"{fixes}, or another number of ranks"
                )
        if self.batch_size < 2 * self.ranks:
            raise QuadrupedError(
                f"--ranks: found {self.ranks} with --batch-size {self.batch_size}; expected 2 or more samples per "
                f"rank: lower --ranks, or choose --batch-size {2 * self.ranks} or more"
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


def on_gpu(device: str) -> bool:
    """True for a device that is a GPU, whose defaults differ."""
    return device.startswith("cuda")


def equal_batches(config: TrainConfig) -> int:
    """Number of batches in an update of rsl-rl, which need equal sizes: `--batch-size` is rounded."""
    return max(1, round(config.num_envs * config.n_steps / config.batch_size))
