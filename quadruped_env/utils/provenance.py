"""Where numbers come from: the machine, the libraries' versions, the commit of the checkout, a user's files."""

import datetime
import hashlib
import os
import platform
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import metadata
from pathlib import Path
from typing import Any, Final

_LIBRARIES: Final = ("mini-quadruped", "mujoco", "gymnasium", "numpy", "stable-baselines3", "sb3-contrib", "torch")
TERRAIN_FILE: Final = "terrain_file"
"""Field of configs and results that names the user's file that defines the terrain."""


@dataclass(frozen=True)
class TaskFile:
    """A user's Python file of terms, terrains or a robot: its name and the SHA-256 of its content."""

    name: str
    sha256: str
    content: bytes = field(default=b"", repr=False, compare=False)
    """The file's bytes, which a run keeps; empty if only its name and hash are known."""
    beside: Mapping[str, bytes] = field(default_factory=dict, repr=False, compare=False)
    """Files of the robot's model that it reads in its own folder, by their paths in it, which a run keeps, too."""

    def to_dict(self) -> dict[str, str]:
        """Return plain values, as stored in configs and results."""
        return {"name": self.name, "sha256": self.sha256}


def circumstances(command_line: str) -> dict[str, Any]:
    """Return where a document comes from: command line, time, machine, versions and commit."""
    return {
        "command_line": command_line,
        "time": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "machine": machine(),
        "versions": versions(),
        "commit": git_commit(),
    }


def versions() -> dict[str, str]:
    """Return versions of Python and of the libraries that the numbers depend on, or 'not installed'."""
    found = {"python": platform.python_version()}
    for library in _LIBRARIES:
        try:
            found[library] = metadata.version(library)
        except metadata.PackageNotFoundError:
            found[library] = "not installed"
    return found


def package_hash(*files: Path) -> str:
    """Hash of this package's code, and of further files, on which numbers depend between versions."""
    found = hashlib.sha256()
    for file in (*sorted(Path(__file__).parents[1].rglob("*.py")), *files):
        found.update(file.name.encode() + file.read_bytes())
    return found.hexdigest()[:16]


def machine() -> str:
    """Return the processor, the number of cores that this process may use, and the operating system."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        lines = []
    models = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    processor = models[0] if models else platform.processor() or "unknown processor"
    return f"{processor}, {platform.machine()}, {cores()} cores, {platform.system()}"


def cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def git_commit() -> str:
    """Return the checkout's commit, marked `-dirty` where files differ from it; 'unknown' outside a checkout.

    An installed package may lie within another repository, whose commit says nothing about it.
    """
    try:
        _git("ls-files", "--error-unmatch", Path(__file__).name)
        return _git("describe", "--always", "--dirty", "--abbrev=12", "--exclude=*")
    except (OSError, subprocess.SubprocessError):
        return "unknown"


def _git(*arguments: str) -> str:
    command = ["git", "-C", str(Path(__file__).parent), *arguments]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=True, timeout=10)  # noqa: S603
    return done.stdout.strip()
