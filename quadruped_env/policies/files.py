"""Files of trained policies, read with NumPy alone: those in the package, and those in the directories of runs."""

import hashlib
import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.task_file import (
    KEPT_FILE,
    TASK_FILE,
    TaskFileError,
    Terms,
    needs_file,
    recorded_file,
    recorded_terms,
)
from quadruped_env.errors import QuadrupedError, QuadrupedWarning, did_you_mean, short
from quadruped_env.policies.activations import ACTIVATIONS, OUTPUTS
from quadruped_env.policies.hub import hub_directory, is_on_hub
from quadruped_env.policies.not_a_policy import not_a_policy
from quadruped_env.policies.policy_data import (
    CARD_FILE,
    FORMAT_VERSION,
    TENSORS_FILE,
    PolicyData,
    config_hash,
    gait_document,
)
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import check_same_robot
from quadruped_env.utils.documents import check_regular, read_bytes, read_json
from quadruped_env.utils.interpreter import program_command
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile

_ROUNDING: Final = 1e-5
"""Largest difference of a gait's numbers that is due to rounding, since processors sum in other orders; rad."""
CHECKPOINTS: Final = "checkpoints"
"""Directory of a run's checkpoints, each with the files of a policy."""
SHIPPED: Final = ("flat", "rough")
"""Names of the policies that the package has."""
DEFAULT: Final = SHIPPED[0]
"""The one that programs take."""
SHOWN: Final = SHIPPED[1]
"""The one that pages show: it crosses all their terrains, where `DEFAULT` marches on the spot at the first stair."""


def is_code(source: str | Path) -> bool:
    """Return True for the name of a Python file, which defines a policy as code, but not for a directory."""
    return str(source).endswith(".py") and not os.path.isdir(source)


def training_advice() -> str:
    """Return the command that trains a policy, as the end of an error message."""
    return f"train one with '{program_command('train')}'"


def shipped_directory(name: str) -> Path:
    """Return the directory of a shipped policy."""
    return Path(__file__).parent / "shipped" / name


def finished_directory(run: Path) -> Path:
    """Return the directory of a run's policy: the run, or its last checkpoint if it was killed or still trains.

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


def policy_directory(source: str | Path) -> Path:
    """Return the directory of the policy that a name, a directory or an address of the hub means.

    For a run that was killed, it is its last checkpoint; for a policy of the hub, a directory of the client's cache.

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


def trained_with(task: Mapping[str, Any]) -> TaskFile | None:
    """Return the user's file of terms or of the terrain that a config's plain values name; None if they name none."""
    return recorded_file(task.get(TASK_FILE)) or recorded_file(task.get(TERRAIN_FILE), TERRAIN_FILE)


def kept_file(source: str | Path) -> tuple[Path, TaskFile] | None:
    """Return the copy of the user's file that a run keeps, with its name and hash; None for a run without a file.

    Raises:
        QuadrupedError: if there is no such policy, a file is damaged, or the run keeps no copy.
    """
    directory = policy_directory(source)
    document = read_json(directory / CARD_FILE, "the file is damaged, train again")
    task = document.get("config") if isinstance(document, dict) else None
    file = trained_with(task) if isinstance(task, dict) else None
    if file is None:
        return None
    path = directory / KEPT_FILE
    if not os.path.exists(path):
        raise QuadrupedError(
            f"{path}: missing, so there is no copy of {short(file.name)} to trust; name the file with --task FILE"
        )
    check_regular(path, "name the file with --task FILE")
    return path, file


def kept_content(directory: Path, recorded: TaskFile) -> bytes:
    """Return content of the copy that a run keeps of its task file; empty without one, or if it is not as recorded."""
    path = directory / KEPT_FILE
    content = path.read_bytes() if path.is_file() else b""
    return content if hashlib.sha256(content).hexdigest() == recorded.sha256 else b""


def read_policy(source: str | Path, terms: Terms | None = None) -> PolicyData:
    """Load a shipped policy by name (`flat`, `rough`), that in the directory of a training run, or one of the hub.

    For a run that was killed, this is the policy of its last checkpoint. Nothing is unpickled or executed. The user's
    file that a run names is needed only if it defines the policy's observations or robot; pass them in `terms`.

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
    path = directory / CARD_FILE
    document = _document(path)
    tensors = _tensors(directory / TENSORS_FILE, document, path)
    task, terms = document["config"], terms or Terms()
    try:
        file = recorded_file(task.get(TASK_FILE)) if isinstance(task, dict) else None
        if file is None:
            terms = Terms(robot=terms.robot)
        elif terms.file is None:
            _check_built_in(document, terms, file)
        # Files without the field are of the built-in robot.
        check_same_robot(document.get("robot", MINI_QUADRUPED.identity), terms.robot)
        control = ControlConfig.of_task(task, terms.robot, terms.commands)
    except QuadrupedError as error:
        raise unusable(path, error) from error
    robot, layout = terms.robot, ObservationLayout(terms.robot, terms.observations)
    for field, found, what, tolerance in (
        ("observation_layout", layout.document(), "so the policy would get other columns than it was trained on", 0.0),
        ("scripted_gait", gait_document(control, robot), "to which the policy's actions would be added", _ROUNDING),
    ):
        if not _alike(document.get(field), found, tolerance):
            raise QuadrupedError(
                f"{path}: {field} differs from this version's, {what}; train again, or install the version that made it"
            )
    weights, biases = _layers(
        document["layers"],
        tensors,
        directory / TENSORS_FILE,
        control.observation_history * layout.width,
        robot.num_joints,
    )
    policy = PolicyData(
        weights,
        biases,
        document["activation"],
        control,
        terms.observations,
        task,
        document["card"],
        robot,
        document.get("output", "clip"),
        str(path),
    )
    policy.check_is_data(str(directory / TENSORS_FILE))
    return policy


def unusable(path: Path | str, error: QuadrupedError) -> QuadrupedError:
    """Return the error for a policy's file whose task cannot be used here."""
    fix = "" if isinstance(error, TaskFileError) else "; train again, or install the version that made it"
    return QuadrupedError(f"{path}: {error}{fix}")


def _check_built_in(document: dict[str, Any], terms: Terms, file: TaskFile) -> None:
    """Refuse the built-in terms for a policy whose robot or observations a user's file defines."""
    robot, defined = document.get("robot"), recorded_terms(document["config"][TASK_FILE])
    if isinstance(robot, dict) and robot != terms.robot.identity:
        raise needs_file(f"this policy has the robot {short(robot.get('name'))}", file)
    if not defined:
        raise needs_file("this policy was trained by an earlier version with terms", file)
    if own := defined.get("observations"):
        raise needs_file(f"this policy has the observation {', '.join(own)}", file)


def _document(path: Path) -> dict[str, Any]:
    """Return a policy's JSON, whose fields are checked one by one."""
    document = read_json(path, "the file is damaged, train again")
    version = document.get("format_version") if isinstance(document, dict) else None
    if version != FORMAT_VERSION:
        raise QuadrupedError(
            f"{path}: format_version is {short(version)}, and this version of the package reads {FORMAT_VERSION}; "
            f"train again, or install the version that made it"
        )
    for key in ("weights_sha256", "config_sha256", "activation", "layers", "observation_layout", "config", "card"):
        if key not in document:
            raise _damaged(path, f"field {key!r} is missing")
    _check_hash(document, "config_sha256", config_hash(document["config"]), path, path)
    layers, card = document["layers"], document["card"]
    for name, valid in (("activation", ACTIVATIONS), ("output", OUTPUTS)):
        if (value := document.get(name, "clip")) not in tuple(valid):
            raise _damaged(path, f"{name} {short(value)} is not one of {', '.join(valid)}")
    if not isinstance(card, dict):
        raise _damaged(path, f"card must be a table of facts; found {short(card)}")
    if not isinstance(layers, int) or layers < 1:
        raise _damaged(path, f"layers must be a whole number, 1 or more; found {short(layers)}")
    return document


def _tensors(path: Path, document: dict[str, Any], card_path: Path) -> dict[str, NDArray[Any]]:
    content = read_bytes(path, "name the directory of a finished run")
    _check_hash(document, "weights_sha256", hashlib.sha256(content).hexdigest(), card_path, path)
    try:
        return load(content)
    # Number types that NumPy lacks raise various errors.
    except (SafetensorError, TypeError, AttributeError, ValueError) as error:
        raise QuadrupedError(f"{path}: not a safetensors file ({error}); it is damaged, train again") from error


def _damaged(path: Path, problem: str) -> QuadrupedError:
    return QuadrupedError(f"{path}: {problem}; the file is damaged, train again")


def _check_hash(document: dict[str, Any], field: str, found: str, card_path: Path, path: Path) -> None:
    """Refuse a file whose SHA-256 is not the one in the card."""
    if document[field] != found:
        raise QuadrupedError(
            f"{path}: its SHA-256 differs from {field} in {card_path.name}; the file is damaged or of another policy: "
            f"train again, or use another checkpoint"
        )


def _alike(kept: Any, found: Any, tolerance: float) -> bool:
    """Return True for JSON values that are equal, their numbers to a tolerance."""
    if isinstance(found, dict):
        same = isinstance(kept, dict) and kept.keys() == found.keys()
        return same and all(_alike(kept[key], found[key], tolerance) for key in found)
    if isinstance(found, list):
        same = isinstance(kept, list) and len(kept) == len(found)
        return same and all(_alike(*pair, tolerance) for pair in zip(kept, found, strict=True))
    if isinstance(found, float) and isinstance(kept, float | int):
        return abs(kept - found) <= tolerance
    return bool(kept == found)


def _layers(
    count: int, tensors: dict[str, NDArray[Any]], tensors_path: Path, inputs: int, outputs: int
) -> tuple[tuple[NDArray[np.float32], ...], tuple[NDArray[np.float32], ...]]:
    """Return the weights and biases that fit together."""
    weights, biases = [], []
    width = inputs
    for i in range(count):
        weight, bias = tensors.get(f"layer{i}.weight"), tensors.get(f"layer{i}.bias")
        if weight is None or bias is None or bias.ndim != 1 or weight.shape != (width, len(bias)):
            found = " and ".join("none" if tensor is None else str(tensor.shape) for tensor in (weight, bias))
            rule = f"layer{i}.weight must have shape ({width}, outputs) and layer{i}.bias (outputs,); found {found}"
            raise _damaged(tensors_path, rule)
        if weight.dtype != np.float32 or bias.dtype != np.float32:
            raise _damaged(tensors_path, f"layer{i} must be float32; found {weight.dtype} and {bias.dtype}")
        weights.append(weight)
        biases.append(bias)
        width = len(bias)
    if width != outputs:
        raise _damaged(tensors_path, f"the last layer has {width} outputs; expected {outputs}, one per joint")
    return tuple(weights), tuple(biases)
