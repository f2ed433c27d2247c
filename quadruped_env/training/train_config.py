"""Settings of a training."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, Final, Literal

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.training.algorithms import ALGORITHMS
from quadruped_env.utils.fields import Fields, check, check_names, converted, hints_of
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.plain import Plain
from quadruped_env.utils.seeds import check_training_seeds

_MAX_WIDTH: Final = 16_384
"""Maximum width of a hidden layer."""
_MAX_LAYERS: Final = 16
_LOG_STD: Final = Parameter("1", -20.0, 2.0)
"""As Stable-Baselines3 clips it: exp(2) is 7 times the range of an action."""


def _count(high: float, low: float = 1) -> Parameter:
    """Whole numbers beyond `high` would overflow, or make a training that never ends."""
    return Parameter("1", low, high)


def _share(high: float) -> Parameter:
    return Parameter("1", 0.0, high, exclusive=True)


def _widths(value: Plain, path: str) -> tuple[int, ...]:
    rule = f"up to {_MAX_LAYERS} whole numbers, each from 1 to {_MAX_WIDTH}"
    check(isinstance(value, (list, tuple)) and len(value) <= _MAX_LAYERS, path, value, rule)
    check(all(type(width) is int and 1 <= width <= _MAX_WIDTH for width in value), path, value, rule)
    return tuple(value)


def _changes(value: Plain, path: str) -> dict[str, Any]:
    check(isinstance(value, dict), path, value, "a table of fields")
    return dict(value)


def _name(value: Plain, path: str) -> str:
    valid = isinstance(value, str) and "/" not in value and value not in {"", ".", ".."} and value.isprintable()
    check(valid, path, value, "a part of a directory's name")
    return str(value)


@dataclass(frozen=True)
class TrainConfig(Fields, path="training"):
    """Settings of a training; an algorithm's have Stable-Baselines3's names.

    The defaults are PPO's with the recipe `flat`; `with_recipe` knows the others'.

    Raises:
        QuadrupedError: if a value is not valid; the message begins with the field.
    """

    recipe: Literal["flat", "walker"] = "flat"
    """Named settings of the training and its task, which other options change"""
    algo: Literal["ppo", "a2c", "trpo", "sac", "td3", "ddpg", "tqc", "crossq"] = "ppo"
    """Algorithm: ppo, a2c, sac, td3 or ddpg of Stable-Baselines3; trpo, tqc or crossq of sb3-contrib"""
    action_mode: Literal["position", "residual"] = "residual"
    """`position`: learn from scratch; `residual`: learn on top of the scripted gait"""
    timesteps: Annotated[int, _count(10**12)] = 1_500_000
    """Budget in environment steps, summed over all envs; the same kind of processor repeats the run bit for bit"""
    seconds: Annotated[float | None, Parameter.positive("s")] = None
    """Budget in seconds of wall-clock time instead; such a run cannot be repeated bit for bit"""
    seed: Annotated[int, _count(2**32 - 1, low=0)] = 0
    """Seed of the envs (each further env has the next one), the network and the exploration"""
    num_envs: Annotated[int, _count(10**6)] = 256
    """Number of parallel envs"""
    name: Annotated[str, _name] = "ppo"
    """Last part of the run directory's name"""
    checkpoint_seconds: Annotated[float, Parameter.positive("s")] = 10.0
    """Seconds of wall-clock time between checkpoints"""
    task: Annotated[dict[str, Any], _changes] = field(default_factory=dict)
    """Changes to the task's config, as nested values"""
    n_steps: Annotated[int, _count(10**6)] = 24
    """Steps of each env between updates"""
    batch_size: Annotated[int, _count(10**9, low=2)] = 1536
    """Samples in a gradient step"""
    n_epochs: Annotated[int, _count(1000)] = 6
    """Passes over the samples of an update"""
    learning_rate: Annotated[float, _share(1.0)] = 1e-3
    """Adam's initial step size; it decreases linearly to a tenth"""
    desired_kl: Annotated[float | None, Parameter.positive("1")] = None
    """Divergence of the policies before and after an update to which the learning rate adapts; null: it does not"""
    gamma: Annotated[float, _share(1.0)] = 0.985
    """Discount per step of 0.02 s"""
    gae_lambda: Annotated[float, Parameter("1", 0.0, 1.0)] = 0.95
    """Decay of the advantage estimate"""
    clip_range: Annotated[float, _share(10.0)] = 0.2
    """Clip range of PPO's probability ratio"""
    ent_coef: Annotated[float, Parameter("1", 0.0, 1000.0)] = 0.0
    """Weight of the entropy bonus"""
    max_grad_norm: Annotated[float, _share(1e6)] = 1.0
    """Maximum norm of the gradient"""
    buffer_size: Annotated[int, _count(10**9)] = 500_000
    """Environment steps in the replay buffer of sac, td3, ddpg, tqc and crossq"""
    learning_starts: Annotated[int, _count(10**9, low=0)] = 10_000
    """Environment steps of random actions with which the replay buffer begins"""
    gradient_steps: Annotated[int, _count(10**6)] = 16
    """Gradient steps in an update from the replay buffer"""
    tau: Annotated[float, _share(1.0)] = 0.005
    """Share of the networks that their slow copies take over in each gradient step of sac, td3, ddpg and tqc"""
    action_noise: Annotated[float, Parameter("1", 0.0, 10.0)] = 0.1
    """Standard deviation of the exploration of td3 and ddpg, which are deterministic"""
    hidden: Annotated[tuple[int, ...], _widths] = (128, 128)
    """Widths of the hidden layers of the policy and of the value function"""
    activation: Literal["elu", "relu", "tanh", "leaky_relu", "silu", "gelu", "softplus", "selu", "sigmoid", "mish"] = (
        "elu"
    )
    """Activation function of the hidden layers"""
    symmetric: bool = True
    """Make the policy left/right symmetric by construction, as the robot is"""
    asymmetric_critic: bool = True
    """Let the value function see privileged readings that only the simulation knows; the policy never sees them"""
    log_std_init: Annotated[float, _LOG_STD] = -1.0
    """Logarithm of the exploration's initial standard deviation"""
    final_log_std: Annotated[float, _LOG_STD] = -2.5
    """Upper bound of that logarithm at the end, reached linearly. Noise slows the robot down, and a policy that
    learned with it overshoots its commands without it"""

    def __post_init__(self) -> None:
        super().__post_init__()
        algorithm = ALGORITHMS[self.algo]
        if self.symmetric and algorithm.on_policy and any(width % 2 for width in self.hidden):
            raise QuadrupedError(
                f"training.hidden: expected even widths, since a symmetric network has pairs of units; found "
                f"{short(self.hidden)}; change them, or set symmetric to false"
            )
        check_training_seeds("training.seed", self.seed, self.num_envs)
        samples = self.num_envs * self.n_steps
        if algorithm.on_policy and "batch_size" in algorithm.settings and samples < self.batch_size:
            raise QuadrupedError(
                f"training.batch_size: {self.batch_size} is more than the {samples} samples of an update (num_envs * "
                f"n_steps); lower it or use more envs"
            )


def check_fields(values: Mapping[str, Any]) -> None:
    """Check some fields of `TrainConfig`, each by itself.

    Raises:
        QuadrupedError: if a value is not valid, or there is no such field.
    """
    hints = hints_of(TrainConfig)
    check_names(values, hints, "training")
    for name, value in values.items():
        converted(value, hints[name], f"training.{name}")
