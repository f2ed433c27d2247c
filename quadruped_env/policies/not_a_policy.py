"""Recognition of files, folders and names that a user gives as a policy and that are something else, with the fix.

Nothing is unpickled or executed: a file is recognized by its first bytes, its name, and the names in a zip's directory.
"""

import os
import zipfile
from pathlib import Path
from typing import Final

from quadruped_env.errors import short
from quadruped_env.gait import PRESETS
from quadruped_env.policies.hub import SCHEME
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.robot.description import description_problem
from quadruped_env.utils.interpreter import program_command

BAG_FILE: Final = "metadata.yaml"
"""File that marks a directory as a ROS 2 bag."""
SB3_MEMBERS: Final = frozenset({"data", "policy.pth"})
"""Files in every zip of Stable-Baselines3."""
_HEAD: Final = 1 << 16
"""Bytes from which a file is recognized."""
_RECORDINGS: Final = (".csv", ".mcap", ".db3", ".bag", ".tsv", ".yaml", ".yml")


def not_a_policy(source: str, recordings: bool = True) -> str:
    """Return the message for a file, folder or name that is known to be no policy; else an empty string.

    With `recordings` a recording counts, too; viewer and controller play it.
    """
    path, is_file = Path(source), os.path.isfile(source)  # opening a named pipe would wait
    if not os.path.exists(path):
        problem, source = _kind_of_name(source), short(source)
    elif os.path.isfile(path / BAG_FILE) or (is_file and path.suffix.lower() in _RECORDINGS):
        problem = f"this looks like a recording; '{program_command('replay', source)}' plays it" if recordings else ""
    elif is_file and os.path.isfile(path.parent / CARD_FILE):
        problem = f"this is a file of a policy's folder; name the folder, {path.parent}"
    else:
        problem = _kind_of_file(path) if is_file else ""
    return f"{source}: {problem}" if problem else ""


def _kind_of_name(source: str) -> str:
    """Return the kind of a name that no file has."""
    if source in PRESETS:
        return (
            f"this is a scripted gait, which has no weights; '{program_command('baseline', '--preset', source)}' "
            f"measures it, and '{program_command('view', source)}' shows it"
        )
    address = source.rpartition("huggingface.co/")[2].strip("/")
    if address.count("/") == 1 and not os.path.exists(address.partition("/")[0]):
        return f"there is no such folder; a policy of the hub is {SCHEME}{address}"
    return ""


def _kind_of_file(path: Path) -> str:
    """Return the kind of a file that is in no policy's folder."""
    suffix = path.suffix.lower()
    try:
        with path.open("rb") as file:
            head = file.read(_HEAD)
    except OSError:
        return ""
    if problem := description_problem(head):
        return problem
    if _is_sb3(path):
        return f"this is a model of Stable-Baselines3; {import_advice(path)}"
    if suffix == ".onnx":
        return f"this is an ONNX graph; if it was exported from here, name its folder; otherwise {import_advice(path)}"
    if suffix in (".pkl", ".pt", ".pth"):
        return (
            f"this is a pickle, which is not opened; if it holds the statistics of a VecNormalize, "
            f"{import_advice('MODEL.zip', '--vecnormalize', path)}; a policy of another framework is code "
            f"(docs/training.md#a-policy-that-is-code)"
        )
    return ""


def import_advice(*arguments: str | Path) -> str:
    """Return the command that makes a policy of another program's model, as the end of a message."""
    return (
        f"'{program_command('import-policy', *arguments)}' makes a policy of it "
        f"(docs/training.md#a-model-of-another-trainer)"
    )


def _is_sb3(path: Path) -> bool:
    try:
        with zipfile.ZipFile(path) as archive:
            return set(archive.namelist()) >= SB3_MEMBERS
    except (OSError, zipfile.BadZipFile, ValueError, NotImplementedError):
        return False
