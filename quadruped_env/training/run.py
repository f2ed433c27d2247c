"""The directory that a training leaves: what it was asked for, how it went, and the policy."""

import csv
import json
import os
import platform
import subprocess
import time
from dataclasses import asdict, replace
from importlib import metadata
from pathlib import Path
from typing import Any, Final

from quadruped_env.documents import read_json
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.policies.policy import ACTIVATIONS, CARD_FILE, TENSORS_FILE
from quadruped_env.task import TaskConfig
from quadruped_env.training.config import TrainConfig

CONFIG_FILE: Final = "config.json"
PROGRESS_FILE: Final = "progress.csv"
RESUME_FILE: Final = "sb3_model.zip"
PROGRESS_COLUMNS: Final = (
    "timesteps",
    "seconds",
    "return",
    "fall_rate",
    "forward_velocity_error",
    "yaw_rate_error",
)
"""Of progress.csv, each since the row before: s; reward of a whole episode at the present rate; falls in the time of a
whole episode; velocity errors in m/s and rad/s, root mean square, with the exploration's noise"""

_RESUMED_FIELDS: Final = {"training": ("hidden", "activation", "symmetric"), "task": ("action",)}
"""What a run's config.json must have for the run to be resumed"""
_LIBRARIES: Final = ("mini-quadruped", "mujoco", "gymnasium", "numpy", "stable-baselines3", "torch")


class Run:
    """A run directory `<parent>/<time>-<name>/`, and `<parent>/latest` that points to it."""

    def __init__(self, parent: Path, config: TrainConfig, task: dict[str, Any], command: str) -> None:
        stamp = time.strftime("%Y%m%d-%H%M%S")
        self.directory = _new_directory(parent, f"{stamp}-{config.name}")
        self.facts = {"command": command, "git_commit": git_commit(), "versions": versions(), "machine": machine()}
        document = {"training": asdict(config), "task": task, **self.facts}
        (self.directory / CONFIG_FILE).write_text(json.dumps(document, indent=2) + "\n")
        self._progress = (self.directory / PROGRESS_FILE).open("w", newline="")
        self._writer = csv.DictWriter(self._progress, PROGRESS_COLUMNS)
        self._writer.writeheader()
        _point_latest(parent / "latest", self.directory)

    def log(self, row: dict[str, float]) -> None:
        """Add a row to progress.csv."""
        self._writer.writerow(row)
        self._progress.flush()

    def close(self) -> None:
        """Finish the files."""
        self._progress.close()


def resumed_config(directory: Path, config: TrainConfig) -> TrainConfig:
    """The training that goes on from a run: a config with the task and the network of that run.

    Raises:
        QuadrupedError: if the directory is not a complete run; the message names the file, the field and the cure.
    """
    if not os.path.isdir(directory):  # Path.is_dir raises for a name that is too long
        raise QuadrupedError(f"--resume: {directory} is not a directory; name a run such as runs/latest")
    for name in (CONFIG_FILE, CARD_FILE, TENSORS_FILE, RESUME_FILE):
        if not (directory / name).is_file():
            raise QuadrupedError(
                f"--resume: {directory / name} is missing, so the run is incomplete; resume one of its checkpoints/, "
                f"or train anew"
            )
    path = directory / CONFIG_FILE
    document = read_json(path, "train anew")
    for section, fields in _RESUMED_FIELDS.items():
        part = document.get(section) if isinstance(document, dict) else None
        for field in fields:
            if not isinstance(part, dict) or field not in part:
                raise QuadrupedError(f"{path}: field '{section}.{field}' is missing; train anew")
    training = document["training"]
    for field, valid, rule in (
        ("hidden", _is_hidden(training["hidden"]), "a list of whole numbers, 1 or more each"),
        ("activation", training["activation"] in tuple(ACTIVATIONS), f"one of {', '.join(ACTIVATIONS)}"),
        ("symmetric", isinstance(training["symmetric"], bool), "true or false"),
    ):
        if not valid:
            raise QuadrupedError(
                f"{path}: training.{field}: expected {rule}; found {short(training[field])}; train anew"
            )
    try:
        task = TaskConfig.from_dict(document["task"])
    except QuadrupedError as error:
        raise QuadrupedError(f"{path}: task: {error}; train anew") from error
    return replace(
        config,
        task=task.to_dict(),
        action_mode=task.action.mode,
        hidden=tuple(training["hidden"]),
        activation=training["activation"],
        symmetric=training["symmetric"],
    )


def _is_hidden(value: Any) -> bool:
    """Whether a value is the widths of a network's hidden layers."""
    return isinstance(value, list) and all(type(width) is int and width >= 1 for width in value)


def _new_directory(parent: Path, name: str) -> Path:
    # Two runs that start within one second must not share a directory.
    for suffix in ("", *(f"-{i}" for i in range(2, 1000))):
        directory = parent / f"{name}{suffix}"
        try:
            directory.mkdir(parents=True)
        except FileExistsError:
            continue
        except OSError as error:
            raise QuadrupedError(f"--runs: cannot make {directory} ({error.strerror}); name another place") from error
        return directory
    raise QuadrupedError(f"{parent / name}: exists a thousand times; clear {parent}")


def _point_latest(link: Path, directory: Path) -> None:
    temporary = link.with_name(f".latest-{os.getpid()}")
    temporary.symlink_to(directory.name)
    temporary.replace(link)


def versions() -> dict[str, str]:
    """Versions of Python and of the libraries that the numbers depend on."""
    found = {"python": platform.python_version()}
    for library in _LIBRARIES:
        try:
            found[library] = metadata.version(library)
        except metadata.PackageNotFoundError:
            found[library] = "not installed"
    return found


def machine() -> str:
    """The processor, and how many cores this process may use."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        lines = []
    models = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    processor = models[0] if models else platform.processor() or "unknown processor"
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{processor}, {platform.machine()}, {cores} cores, {platform.system()}"


def git_commit() -> str:
    """The checkout's commit, with a mark where files differ from it, or 'unknown' outside a checkout."""
    here = Path(__file__).parent
    try:
        commit = subprocess.run(  # noqa: S603
            ["git", "-C", str(here), "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"],  # noqa: S607
            capture_output=True,
            text=True,
            check=True,
            timeout=10,
        )
    except (OSError, subprocess.SubprocessError):
        return "unknown"
    return commit.stdout.strip()
