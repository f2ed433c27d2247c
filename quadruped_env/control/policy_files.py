"""Files of trained policies, read with NumPy alone: those in the package, and those in the directories of runs."""

import hashlib
import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load

from quadruped_env.control.activations import ACTIVATIONS, OUTPUTS
from quadruped_env.control.control_config import COMMANDS, Command, ControlConfig
from quadruped_env.control.hub_policies import hub_directory, is_on_hub
from quadruped_env.control.kept_task_file import code_changes
from quadruped_env.control.observations import OBSERVATIONS, ObservationField, ObservationLayout
from quadruped_env.control.policy import CARD_FILE, FORMAT_VERSION, TENSORS_FILE, Policy, config_hash, gait_document
from quadruped_env.control.policy_argument import not_a_policy
from quadruped_env.control.task_file import (
    TASK_FILE,
    TaskFileError,
    execute,
    kept,
    merged,
    needs_file,
    recorded_file,
    recorded_terms,
    robot_in,
)
from quadruped_env.errors import QuadrupedError, QuadrupedWarning, did_you_mean, short
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot, check_same_robot
from quadruped_env.utils.documents import check_regular, read_json
from quadruped_env.utils.interpreter import program_command
from quadruped_env.utils.provenance import TaskFile

CHECKPOINTS: Final = "checkpoints"
"""Directory of a run's checkpoints, each with the files of a policy."""
SHIPPED: Final = ("flat", "rough")
"""Names of the policies that the package has."""
DEFAULT: Final = SHIPPED[0]
"""The one that programs take."""
SHOWN: Final = SHIPPED[1]
"""The one that pages show: it crosses all their terrains, where `DEFAULT` marches on the spot at the first stair."""


def is_code(source: str | Path) -> bool:
    """True for the name of a Python file, which defines a policy as code; a run's directory may have such a name."""
    return str(source).endswith(".py") and not os.path.isdir(source)


def training_advice() -> str:
    """The command that trains a policy, as the end of an error message."""
    return f"train one with '{program_command('train')}'"


def shipped_directory(name: str) -> Path:
    """Directory of a shipped policy."""
    return Path(__file__).parent / "shipped" / name


def finished_directory(run: Path) -> Path:
    """Directory of a run's policy: that of the run, or that of its last checkpoint if it was killed or still trains.

    Warns:
        QuadrupedWarning: if a checkpoint is used.
    """
    # Not Path's methods, which raise for names that are too long and for directories without rights.
    if os.path.exists(run / CARD_FILE) or not os.path.isdir(run / CHECKPOINTS):
        return run
    checkpoints = [path for path in (run / CHECKPOINTS).iterdir() if (path / CARD_FILE).is_file()]
    if not checkpoints:
        return run
    # Checkpoints are named by seconds, and later names may have more digits.
    last = max(checkpoints, key=lambda path: (len(path.name), path.name))
    warnings.warn(
        f"{run}: the training was killed or is still running; its last checkpoint is used: {last.relative_to(run)}",
        QuadrupedWarning,
        stacklevel=3,
    )
    return last


@dataclass(frozen=True)
class Terms:
    """Parts of a policy that are not stored in its file: its robot, fields of the observation, commands."""

    observations: tuple[ObservationField, ...] = OBSERVATIONS
    commands: tuple[Command, ...] = COMMANDS
    robot: Robot = MINI_QUADRUPED
    file: TaskFile | None = None
    """File that defines what is not built in."""


def load_terms(path: str | os.PathLike[str], expected: TaskFile | None = None) -> Terms:
    """The built-in robot, observations and commands, with those of a user's file added to them or replacing them.

    An observation whose name the file sets to None is left out.

    Raises:
        QuadrupedError: as `execute` and `robot_in`.
    """
    file, module = execute(path, expected)
    values = list(vars(module).values())
    return Terms(
        merged(kept(OBSERVATIONS, module), [value for value in values if isinstance(value, ObservationField)]),
        merged(COMMANDS, [value for value in values if isinstance(value, Command)]),
        robot_in(module) or MINI_QUADRUPED,
        file,
    )


def read_policy(source: str | Path, terms: Terms | None = None) -> Policy:
    """Load a shipped policy by name (`flat`, `rough`), that in the directory of a training run, or one of the hub.

    For a run that was killed, this is the policy of its last checkpoint. Nothing is unpickled, and neither torch nor
    stable-baselines3 is needed. A file of terms that a run names is not executed. It is needed only if it defines the
    policy's observations or robot; pass them in `terms`.

    Args:
        source: name, directory, or `hf://OWNER/NAME[@REVISION]`.
        terms: robot and terms of a user's file, for a policy that was trained with one.

    Raises:
        QuadrupedError: if there is no such policy, a file is missing or damaged, or it was made for another
            robot, observations or scripted gait; the message names the file and the fix.

    Warns:
        QuadrupedWarning: if `source` is a run without a final policy, so that a checkpoint is used.
    """
    if is_code(source):
        raise QuadrupedError(
            f"{source}: is Python code, and a robot's controller runs policies of files: the directory of a run, or of "
            f"Policy.from_sb3(model).save(DIR)"
        )
    directory = policy_directory(source)
    tensors_path, card_path = directory / TENSORS_FILE, directory / CARD_FILE
    document = read_json(card_path, "the file is damaged, train again")
    check_regular(tensors_path, "name the directory of a finished run")
    try:
        content = tensors_path.read_bytes()
    except OSError as error:
        raise QuadrupedError(f"{tensors_path}: cannot be read ({error.strerror})") from error
    _check_hash(document, "weights_sha256", hashlib.sha256(content).hexdigest(), card_path, tensors_path)
    try:
        tensors = load(content)
    # Number types that NumPy lacks raise various errors.
    except (SafetensorError, TypeError, AttributeError, ValueError) as error:
        raise QuadrupedError(f"{tensors_path}: not a safetensors file ({error}); it is damaged, train again") from error
    return _from_document(document, tensors, (card_path, tensors_path), terms or Terms())


def policy_directory(source: str | Path) -> Path:
    """Directory of the policy that a name, a directory or an address of the hub means.

    For a run that was killed, it is that of its last checkpoint; for a policy of the hub, one of the client's cache.

    Raises:
        MissingExtraError: for an address without the hub's client.
        QuadrupedError: if there is no such policy, or one of its files is missing.
    """
    if is_on_hub(source):
        return hub_directory(str(source))
    directory = shipped_directory(str(source)) if str(source) in SHIPPED else finished_directory(Path(source))
    # Not Path.is_dir, which raises for names that are too long and for directories without rights.
    found = str(directory) if os.path.isdir(directory) else str(source)
    if problem := not_a_policy(found):
        raise QuadrupedError(problem)
    if not os.path.isdir(directory):
        raise QuadrupedError(
            f"{short(str(source))} is neither a directory nor a shipped policy ({', '.join(SHIPPED)}); "
            f"{training_advice()}{did_you_mean(Path(source).name, SHIPPED)}"
        )
    for path in (directory / CARD_FILE, directory / TENSORS_FILE):
        if not os.path.exists(path):
            if run := max(directory.glob(f"*/{CARD_FILE}"), default=None):
                raise QuadrupedError(f"{directory}: is not a run, and holds runs; name one, such as {run.parent}")
            raise QuadrupedError(
                f"{path}: missing, so the run is incomplete; name a finished run, or one of its checkpoints"
            )
    return directory


def _check_terms(document: dict[str, Any], terms: Terms, file: TaskFile, directory: Path) -> None:
    """Refuse terms with which a policy that was trained with a user's file would get wrong observations."""
    robot, defined = document.get("robot"), recorded_terms(document["config"][TASK_FILE])
    if terms.file is None:
        if isinstance(robot, dict) and robot != terms.robot.identity:
            raise needs_file(f"this policy has the robot {short(robot.get('name'))}", file)
        if defined is None:
            raise needs_file("this policy was trained by an earlier version with terms", file)
        if defined.get("observations"):
            raise needs_file(f"this policy has the observation {', '.join(defined['observations'])}", file)
        return
    if terms.file.sha256 == file.sha256:
        return
    here = [entry.name for entry in terms.observations if not any(entry is other for other in OBSERVATIONS)]
    own = here if defined is None else {*here, *defined.get("observations", ())}
    changed = code_changes(directory, file, terms.file)
    other = [name for name in own if changed is None or name in changed]
    if other and document["observation_layout"] == ObservationLayout(terms.robot, terms.observations).document():
        found = "may compute" if changed is None else "computes"
        raise TaskFileError(
            f"{terms.file.name} {found} the observation {', '.join(sorted(other))} differently from the version of "
            f"{short(file.name)} with which the policy was trained (SHA-256 {short(file.sha256)[:13]}...), so the "
            f"policy would read other values; use that version, or the run's copy of it with --trust-task "
            f"(trust_task=True in Python)"
        )


def unusable(path: Path | str, error: QuadrupedError) -> QuadrupedError:
    """The error for a policy's file whose task cannot be used here."""
    fix = "" if isinstance(error, TaskFileError) else "; train again, or install the version that made it"
    return QuadrupedError(f"{path}: {error}{fix}")


def _damaged(path: Path, problem: str) -> QuadrupedError:
    return QuadrupedError(f"{path}: {problem}; the file is damaged, train again")


def _check_robot(document: dict[str, Any], robot: Robot) -> None:
    """Refuse a policy of another robot. Those without the field are of the built-in robot."""
    if "robot" in document:
        check_same_robot(document["robot"], robot)
    elif robot.name != MINI_QUADRUPED.name:
        check_same_robot(MINI_QUADRUPED.identity, robot)


def _check_hash(document: Any, field: str, found: str, card_path: Path, path: Path) -> None:
    """Refuse a file whose SHA-256 is not the one in the card."""
    expected = document.get(field, found) if isinstance(document, dict) else found
    if expected != found:
        raise QuadrupedError(
            f"{path}: its SHA-256 differs from {field} in {card_path.name}; the file is damaged or of another policy: "
            f"train again, or use another checkpoint"
        )


def _from_document(document: Any, tensors: dict[str, NDArray[Any]], paths: tuple[Path, Path], terms: Terms) -> Policy:
    card_path, tensors_path = paths
    version = document.get("format_version") if isinstance(document, dict) else None
    if version != FORMAT_VERSION:
        raise QuadrupedError(
            f"{card_path}: format_version is {short(version)}, and this version of the package reads {FORMAT_VERSION}; "
            f"train again, or install the version that made it"
        )
    for key in ("weights_sha256", "config_sha256", "activation", "layers", "observation_layout", "config", "card"):
        if key not in document:
            raise _damaged(card_path, f"field {key!r} is missing")
    try:
        task = document["config"]
        file = recorded_file(task.get(TASK_FILE)) if isinstance(task, dict) else None
        if file is None:
            terms = Terms(robot=terms.robot)
        else:
            _check_terms(document, terms, file, card_path.parent)
        _check_robot(document, terms.robot)
        control = ControlConfig.of_task(task, terms.commands)
    except QuadrupedError as error:
        raise unusable(card_path, error) from error
    robot = terms.robot
    layout = ObservationLayout(robot, terms.observations)
    if document["observation_layout"] != layout.document():
        raise QuadrupedError(
            f"{card_path}: observation_layout differs from this version's, so the policy would get other columns than "
            f"it was trained on; train again, or install the version that made it"
        )
    output = document.get("output", "clip")
    for name, value, valid in (("activation", document["activation"], ACTIVATIONS), ("output", output, OUTPUTS)):
        if value not in tuple(valid):
            raise _damaged(card_path, f"{name} {short(value)} is not one of {', '.join(valid)}")
    card, layers = document["card"], document["layers"]
    if not isinstance(card, dict):
        raise _damaged(card_path, f"card must be a table of facts; found {short(card)}")
    if not isinstance(layers, int) or layers < 1:
        raise _damaged(card_path, f"layers must be a whole number, 1 or more; found {short(layers)}")
    _check_hash(document, "config_sha256", config_hash(document["config"]), card_path, card_path)
    if document.get("scripted_gait") != gait_document(control, robot):
        raise QuadrupedError(
            f"{card_path}: scripted_gait differs from this version's, to which the policy's actions would be added; "
            f"train again, or install the version that made it"
        )
    inputs = control.observation_history * layout.width
    weights, biases = _layers(layers, tensors, tensors_path, inputs, robot.num_joints)
    policy = Policy(
        weights, biases, document["activation"], control, terms.observations, task, card, robot, output, str(card_path)
    )
    policy.check_finite(str(tensors_path))
    return policy


def _layers(
    count: int, tensors: dict[str, NDArray[Any]], tensors_path: Path, inputs: int, outputs: int
) -> tuple[tuple[NDArray[np.float32], ...], tuple[NDArray[np.float32], ...]]:
    """Weights and biases that fit together."""
    weights, biases = [], []
    width = inputs
    for i in range(count):
        weight, bias = tensors.get(f"layer{i}.weight"), tensors.get(f"layer{i}.bias")
        if weight is None or bias is None or bias.ndim != 1 or weight.shape != (width, len(bias)):
            found = " and ".join("none" if tensor is None else str(tensor.shape) for tensor in (weight, bias))
            rule = f"layer{i}.weight must have shape ({width}, outputs) and layer{i}.bias (outputs,); found {found}"
            raise _damaged(tensors_path, rule)
        if weight.dtype != np.float32 or bias.dtype != np.float32:
            raise QuadrupedError(
                f"{tensors_path}: layer{i} must be float32; found {weight.dtype} and {bias.dtype}; train again"
            )
        weights.append(weight)
        biases.append(bias)
        width = len(bias)
    if width != outputs:
        raise QuadrupedError(
            f"{tensors_path}: the last layer has {width} outputs; expected {outputs}, one per joint; train again"
        )
    return tuple(weights), tuple(biases)
