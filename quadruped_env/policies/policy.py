"""A trained policy as data: tensors and JSON, run on NumPy alone."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

import gymnasium
import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file

from quadruped_env._python import has_programs, program_command
from quadruped_env.envs import ENV_ID
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import CommandedGait
from quadruped_env.task import ACTION_WIDTH, OBSERVATION_LAYOUT, OBSERVATION_WIDTH, Task, TaskConfig

FORMAT_VERSION: Final = 1
TENSORS_FILE: Final = "policy.safetensors"
CARD_FILE: Final = "policy.json"
SHIPPED: Final = ("flat",)

_SHIPPED_DIRECTORY: Final = Path(__file__).parent / "shipped"


def _elu(x: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.maximum(x, 0.0) + np.expm1(np.minimum(x, 0.0))


_Activation = Callable[[NDArray[np.float32]], NDArray[np.float32]]
ACTIVATIONS: Final[dict[str, _Activation]] = {"tanh": np.tanh, "elu": _elu, "relu": lambda x: np.maximum(x, 0.0)}


@dataclass(frozen=True)
class Policy:
    """A deterministic policy: a small multilayer perceptron.

    Args:
        weights: one matrix a layer (in, out), float32.
        biases: one vector a layer (out,), float32.
        activation: between layers: a key of `ACTIVATIONS`.
        config: the task that it was trained for.
        card: how it was made: command, seed, steps, versions, metrics.
    """

    weights: tuple[NDArray[np.float32], ...]
    biases: tuple[NDArray[np.float32], ...]
    activation: str
    config: TaskConfig
    card: dict[str, Any]

    @property
    def action_mode(self) -> str:
        """`position` or `residual`: the mode of the task that the policy runs on."""
        return self.config.action.mode

    def predict(self, observation: NDArray[np.float32]) -> NDArray[np.float32]:
        """Actions (..., 8) in [-1, 1] for observations (..., obs).

        Raises:
            QuadrupedError: if the last axis is not an observation's.
        """
        x = np.asarray(observation, dtype=np.float32)
        if x.shape[-1:] != self.weights[0].shape[:1]:
            raise QuadrupedError(
                f"policy: expected observations of shape (..., {self.weights[0].shape[0]}); found {x.shape}"
            )
        activate = ACTIVATIONS[self.activation]
        for weight, bias in zip(self.weights[:-1], self.biases[:-1], strict=True):
            x = activate(x @ weight + bias)
        x = x @ self.weights[-1] + self.biases[-1]
        return np.minimum(np.maximum(x, -1.0), 1.0)

    def make_env(self, **kwargs: Any) -> gymnasium.Env[NDArray[np.float32], NDArray[np.float32]]:
        """The environment that the policy was trained for: its task, action mode and control rate.

        Args:
            **kwargs: of `gymnasium.make`, such as `render_mode`.

        Raises:
            QuadrupedError: if `kwargs` name another task than the policy's.
        """
        return gymnasium.make(ENV_ID, config=self._env_config(kwargs), **kwargs)

    def make_vec_env(self, num_envs: int, **kwargs: Any) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
        """Many of the environments that the policy was trained for, vectorized natively.

        Args:
            num_envs: number of robots.
            **kwargs: of `gymnasium.make_vec`, such as `max_episode_steps`.

        Raises:
            QuadrupedError: if `kwargs` name another task than the policy's.
        """
        return gymnasium.make_vec(ENV_ID, num_envs=num_envs, config=self._env_config(kwargs), **kwargs)

    def check_env(self, env: Any) -> None:
        """Make sure that actions mean in an environment what they meant in training.

        Args:
            env: any of this package's environments, in wrappers or not.

        Raises:
            QuadrupedError: if its action mode or scale, control rate or gait clock is another than the policy's.
        """
        task = getattr(getattr(env, "unwrapped", env), "task", None)
        if not isinstance(task, Task):
            raise QuadrupedError(f"policy: {env!r} is no environment of this package; make one with policy.make_env()")
        self.check_task(task.config)

    def check_task(self, config: TaskConfig) -> None:
        """As `check_env`, for the config of a task. What does not change an action's meaning may differ.

        Raises:
            QuadrupedError: if the action mode or scale, control rate or gait clock is another than the policy's.
        """
        scale = f"{self.action_mode}_scale"
        for name, own, found in (
            ("action.mode", self.action_mode, config.action.mode),
            (f"action.{scale}", getattr(self.config.action, scale), getattr(config.action, scale)),
            ("control_timestep", self.config.control_timestep, config.control_timestep),
            ("clock_frequency", self.config.clock_frequency, config.clock_frequency),
        ):
            if own != found:
                raise QuadrupedError(
                    f"policy: it was trained with {name} {own!r}, and this environment has {found!r}; "
                    f"make its own with policy.make_env()"
                )

    def _env_config(self, kwargs: dict[str, Any]) -> dict[str, Any]:
        for name in ("action_mode", "config"):
            if name in kwargs:
                raise QuadrupedError(
                    f"policy.make_env: {name} is the policy's own; for another task: gymnasium.make({ENV_ID!r}, ...)"
                )
        return self.config.to_dict()

    def save(self, directory: Path) -> None:
        """Write the policy's two files into a directory."""
        directory.mkdir(parents=True, exist_ok=True)
        tensors = {}
        for i, (weight, bias) in enumerate(zip(self.weights, self.biases, strict=True)):
            tensors[f"layer{i}.weight"], tensors[f"layer{i}.bias"] = np.ascontiguousarray(weight), bias
        save_file(tensors, directory / TENSORS_FILE)
        document = {
            "format_version": FORMAT_VERSION,
            "activation": self.activation,
            "layers": len(self.weights),
            "observation_layout": _layout_document(),
            "action_mode": self.action_mode,
            "scripted_gait": _gait_document(self.action_mode),
            "control_rate_hz": 1.0 / self.config.control_timestep,
            "config": self.config.to_dict(),
            "card": self.card,
        }
        (directory / CARD_FILE).write_text(json.dumps(document, indent=2) + "\n")


def _layout_document() -> list[dict[str, Any]]:
    return [
        {"name": f.name, "width": f.width, "unit": f.unit, "scale": f.scale, "low": f.low, "high": f.high}
        for f in OBSERVATION_LAYOUT
    ]


def _gait_document(action_mode: str) -> dict[str, Any] | None:
    """The gait under a residual policy, as JSON has it: lists for tuples."""
    return json.loads(json.dumps(asdict(CommandedGait.tuned()))) if action_mode == "residual" else None


def training_advice() -> str:
    """How a person gets a policy of their own."""
    return f"train one with '{program_command('train/ppo.py')}'" if has_programs() else "train one in a checkout"


def shipped_directory(name: str) -> Path:
    """Where the package keeps one of its own policies."""
    return _SHIPPED_DIRECTORY / name


def load_policy(source: str | Path) -> Policy:
    """A shipped policy by name (`flat`), or the policy of a training run's directory.

    Nothing is unpickled and neither torch nor stable-baselines3 is needed.

    Raises:
        QuadrupedError: if there is no such policy, a file is missing or damaged, or it was made for another
            observation layout or scripted gait; the message names the file and the cure.
    """
    directory = shipped_directory(str(source)) if str(source) in SHIPPED else Path(source)
    tensors_path, card_path = directory / TENSORS_FILE, directory / CARD_FILE
    if not directory.is_dir():
        raise QuadrupedError(
            f"load_policy: {str(source)!r} is neither a directory nor a shipped policy ({', '.join(SHIPPED)}); "
            f"{training_advice()}"
        )
    for path in (card_path, tensors_path):
        if not path.is_file():
            raise QuadrupedError(
                f"{path}: missing, so the run is incomplete; name a finished run, or one of its checkpoints"
            )
    try:
        document = json.loads(card_path.read_text())
        tensors = load_file(tensors_path)
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise QuadrupedError(f"{card_path}: not valid JSON ({error}); the file is damaged, train again") from error
    except SafetensorError as error:
        raise QuadrupedError(f"{tensors_path}: not a safetensors file ({error}); it is damaged, train again") from error
    return _from_document(document, tensors, card_path, tensors_path)


def _from_document(document: Any, tensors: dict[str, NDArray[Any]], card_path: Path, tensors_path: Path) -> Policy:
    version = document.get("format_version") if isinstance(document, dict) else None
    if version != FORMAT_VERSION:
        raise QuadrupedError(
            f"{card_path}: format_version is {version!r}, and this version of the package reads {FORMAT_VERSION}; "
            f"train again, or install the version that made it"
        )
    for key in ("activation", "layers", "observation_layout", "config", "card"):
        if key not in document:
            raise QuadrupedError(f"{card_path}: field {key!r} is missing; the file is damaged, train again")
    if document["observation_layout"] != _layout_document():
        raise QuadrupedError(
            f"{card_path}: observation_layout differs from this version's, so the policy would see other columns than "
            f"it was trained on; train again, or install the version that made it"
        )
    if document["activation"] not in tuple(ACTIVATIONS):
        raise QuadrupedError(
            f"{card_path}: activation {document['activation']!r} is not one of {', '.join(ACTIVATIONS)}; "
            f"the file is damaged, train again"
        )
    if not isinstance(document["layers"], int) or document["layers"] < 1:
        raise QuadrupedError(
            f"{card_path}: layers must be a whole number, 1 or more; found {document['layers']!r}; "
            f"the file is damaged, train again"
        )
    try:
        config = TaskConfig.from_dict(document["config"])
    except QuadrupedError as error:
        raise QuadrupedError(f"{card_path}: {error}; train again, or install the version that made it") from error
    if document.get("scripted_gait") != _gait_document(config.action.mode):
        raise QuadrupedError(
            f"{card_path}: scripted_gait differs from this version's, to which the policy's actions would be added; "
            f"train again, or install the version that made it"
        )
    weights, biases = _layers(document["layers"], tensors, tensors_path)
    return Policy(weights, biases, document["activation"], config, document["card"])


def _layers(
    count: int, tensors: dict[str, NDArray[Any]], tensors_path: Path
) -> tuple[tuple[NDArray[np.float32], ...], tuple[NDArray[np.float32], ...]]:
    """Weights and biases that fit together."""
    weights, biases = [], []
    width = OBSERVATION_WIDTH
    for i in range(count):
        weight, bias = tensors.get(f"layer{i}.weight"), tensors.get(f"layer{i}.bias")
        if weight is None or bias is None or bias.ndim != 1 or weight.shape != (width, len(bias)):
            found = " and ".join("none" if tensor is None else str(tensor.shape) for tensor in (weight, bias))
            raise QuadrupedError(
                f"{tensors_path}: layer{i}.weight must have shape ({width}, outputs) and layer{i}.bias (outputs,); "
                f"found {found}; the file is damaged, train again"
            )
        if weight.dtype != np.float32 or bias.dtype != np.float32:
            raise QuadrupedError(
                f"{tensors_path}: layer{i} must be float32; found {weight.dtype} and {bias.dtype}; train again"
            )
        if not (np.isfinite(weight).all() and np.isfinite(bias).all()):
            raise QuadrupedError(f"{tensors_path}: layer{i} holds NaN or infinity; the training diverged, train again")
        weights.append(weight)
        biases.append(bias)
        width = len(bias)
    if width != ACTION_WIDTH:
        raise QuadrupedError(
            f"{tensors_path}: the last layer has {width} outputs; expected {ACTION_WIDTH}, one a joint; train again"
        )
    return tuple(weights), tuple(biases)
