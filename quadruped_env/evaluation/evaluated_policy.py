"""The policy to evaluate, and the directory of its results."""

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from quadruped_env.policies import Policy, load_policy
from quadruped_env.policies.files import (
    DEFAULT,
    SHIPPED,
    finished_directory,
    is_code,
    kept_content,
    policy_directory,
    shipped_directory,
    trained_with,
)
from quadruped_env.policies.hub import is_on_hub
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_FILE, run_name
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.provenance import TaskFile

LATEST_RUN: Final = Path("runs", "latest")
_OF_THE_RUN: Final = ("seed", "name", "checkpoint_seconds")
"""Settings of a training that do not belong to its recipe."""


@dataclass(frozen=True)
class EvaluatedPolicy:
    """A policy to evaluate, and the directory of its results."""

    name: str
    """Name of the run or of the shipped policy"""
    policy: Policy
    directory: Path
    """Directory of the training run, or of the shipped policy in the package; the Python file of one that is code"""
    output: Path
    """Directory of the results"""
    address: str = ""
    """Address of a policy on the hub"""

    @property
    def is_shipped(self) -> bool:
        """True for a policy of the package; a run may have the name of one."""
        return self.name in SHIPPED and self.directory == shipped_directory(self.name)

    @property
    def source(self) -> str:
        """Name of the policy on the command line; contains no path of this machine."""
        if self.policy.agent is not None:
            return self.directory.name
        return self.address or (self.name if self.is_shipped else f"runs/{self.name}")

    @property
    def evaluation(self) -> Path:
        """Default directory of the results."""
        own = not self.is_shipped and self.policy.agent is None and not self.address
        return self.directory / "evaluation" if own else Path("results", self.name)

    @property
    def recipe(self) -> str:
        """Text that is the same for runs that differ in the training seed only."""
        path = self.directory / CONFIG_FILE
        config = read_json(path, "remove it to compare the run by itself") if path.is_file() else None
        if not isinstance(config, dict) or not isinstance(config.get("training"), dict):
            return self.name
        training = {name: value for name, value in config["training"].items() if name not in _OF_THE_RUN}
        return json.dumps([training, config.get("task")], sort_keys=True)

    @property
    def task_file(self) -> TaskFile | None:
        """The user's file that the policy was trained with, with the content of the copy that the run keeps."""
        file = trained_with(self.policy.task)
        return None if file is None else replace(file, content=kept_content(self.directory, file))

    @property
    def progress_file(self) -> Path | None:
        """Log of the training, or None if the file does not exist."""
        path = self.directory / PROGRESS_FILE
        return path if path.is_file() else None


def find_policy(
    run: str | None,
    output: Path | None = None,
    task_file: Path | None = None,
    trust_task: bool = False,
    shipped: str = DEFAULT,
) -> EvaluatedPolicy:
    """Find a policy by name or directory. For a run that was killed, this is its last checkpoint.

    Without a name it is the latest run, or else the `shipped` policy; a Python file is a policy that is code, and
    `hf://OWNER/NAME[@REVISION]` one of the hub. Results go to `output`, or to `evaluation` in the run's directory, or
    to `results/<name>`. `task_file` is executed, or with `trust_task` the copy that the run keeps.

    Raises:
        QuadrupedError: if the policy does not exist or is damaged, or the results would be written through a link.

    Warns:
        QuadrupedWarning: if a run is given and its policy is a checkpoint.
    """
    if run is None:
        run = str(LATEST_RUN) if LATEST_RUN.exists() else shipped
    if run in SHIPPED:
        return EvaluatedPolicy(run, load_policy(run, task_file), shipped_directory(run), output or Path("results", run))
    if is_code(run):
        path = Path(run)
        policy = load_policy(path, task_file, trust_task=trust_task)
        return EvaluatedPolicy(path.stem, policy, path, output or Path("results", path.stem))
    if is_on_hub(run):
        directory, name = policy_directory(run), Path(run.partition("@")[0]).name
        policy = load_policy(directory, task_file, trust_task=trust_task)
        return EvaluatedPolicy(name, policy, directory, output or Path("results", name), run)
    directory = finished_directory(Path(run))
    # Its errors are this package's, also for names that no file can have.
    policy = load_policy(directory, task_file, trust_task=trust_task)
    directory, output = directory.resolve(), output or Path(run) / "evaluation"
    return EvaluatedPolicy(run_name(directory), policy, directory, output)
